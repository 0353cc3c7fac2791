-- What version 2 lacks, for reading it as it is: views of this connection alone stand before its tables and give them the columns
-- and tables of version 3. A checksum that fits the columns of version 2 reads as none, and one that does not stays wrong.

CREATE TEMP VIEW session AS
SELECT id, person_id, kind, started_utc_ms, started_monotonic_ns, consent_version, seed, language, station, program, device,
  device_friction_n, settings,
  nullif(crc32, record_crc32('session', id, person_id, kind, started_utc_ms, started_monotonic_ns, consent_version, seed, language,
    station, program, device, device_friction_n, settings)) AS crc32, NULL AS protocol_id
FROM main.session;
CREATE TEMP VIEW profile AS
SELECT id, session_id, sequence, utc_ms, monotonic_ns, entered_by, supersedes, reason, years_experience, insertions_per_month,
  category, handedness, gloves, tube_size, haptic_experience, weight,
  nullif(crc32, record_crc32('profile', id, session_id, sequence, utc_ms, monotonic_ns, entered_by, supersedes, reason,
    years_experience, insertions_per_month, category, handedness, gloves, tube_size, haptic_experience, weight)) AS crc32,
  '' AS comfort
FROM main.profile;
CREATE TEMP VIEW judgement AS
SELECT id, session_id, sequence, utc_ms, monotonic_ns, entered_by, supersedes, reason, series, step, attempt, commanded_n, felt_n,
  kind, term, scored, catch_trial, feel_again, forward_mm, forward_speed_mm_s, response_s,
  nullif(crc32, record_crc32('judgement', id, session_id, sequence, utc_ms, monotonic_ns, entered_by, supersedes, reason, series,
    step, attempt, commanded_n, felt_n, kind, term, scored, catch_trial, feel_again, forward_mm, forward_speed_mm_s, response_s))
    AS crc32, NULL AS delivered_share
FROM main.judgement;
CREATE TEMP VIEW protocol AS
SELECT NULL AS id, NULL AS version, NULL AS utc_ms, NULL AS author, NULL AS reason, NULL AS text, NULL AS crc32 WHERE 0;
CREATE TEMP VIEW research_key AS SELECT NULL AS place, NULL AS utc_ms, NULL AS hash, NULL AS crc32 WHERE 0;
