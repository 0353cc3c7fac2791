-- Version 3 of the study file, tables. For people: docs/study-file.md.
-- Never edit this file once a study was recorded with it: the next change is the next numbered step.
-- The guards that refuse every change are taken down here and put up again by v3_guards.sql.

DROP TRIGGER judgement_keep;
DROP TRIGGER profile_keep;
DROP TRIGGER session_keep;

-- What each participant is asked: levels, steps, order, languages, consent texts, device; JSON. Rows of the same version are
-- drafts, of which the latest counts, until the first participant's session follows one.
CREATE TABLE protocol (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  version INTEGER NOT NULL CHECK (version >= 1),
  utc_ms INTEGER NOT NULL,
  author TEXT NOT NULL,
  reason TEXT NOT NULL,
  text TEXT NOT NULL CHECK (text LIKE '{%}'),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX protocol_order ON protocol (version, utc_ms, id);

-- The hash of the passphrase that leads from the participant's screens to the researcher's; empty: none. The latest row counts.
-- It belongs to this file: no export or merge takes it along.
CREATE TABLE research_key (
  place INTEGER NOT NULL PRIMARY KEY CHECK (place >= 1),
  utc_ms INTEGER NOT NULL,
  hash TEXT NOT NULL,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;

-- The least share of the force that reached the hand; NULL: not known.
ALTER TABLE judgement ADD COLUMN delivered_share REAL CHECK (delivered_share BETWEEN 0 AND 1);
-- How hand and arm felt before the session.
ALTER TABLE profile ADD COLUMN comfort TEXT NOT NULL DEFAULT '';
-- The protocol that the session follows; NULL: none.
ALTER TABLE session ADD COLUMN protocol_id BLOB REFERENCES protocol (id);
CREATE INDEX session_protocol ON session (protocol_id) WHERE protocol_id IS NOT NULL;

-- A row that did not fit its checksum before does not fit it after.
UPDATE session SET crc32 = record_crc32('session', id, person_id, kind, started_utc_ms, started_monotonic_ns,
  consent_version, seed, language, station, program, device, device_friction_n, settings, protocol_id)
WHERE crc32 = record_crc32('session', id, person_id, kind, started_utc_ms, started_monotonic_ns,
  consent_version, seed, language, station, program, device, device_friction_n, settings);
UPDATE profile SET crc32 = record_crc32('profile', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, years_experience, insertions_per_month, category, handedness, gloves, tube_size,
  haptic_experience, weight, comfort)
WHERE crc32 = record_crc32('profile', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, years_experience, insertions_per_month, category, handedness, gloves, tube_size,
  haptic_experience, weight);
UPDATE judgement SET crc32 = record_crc32('judgement', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, series, step, attempt, commanded_n, felt_n, kind, term, scored, catch_trial, feel_again,
  forward_mm, forward_speed_mm_s, response_s, delivered_share)
WHERE crc32 = record_crc32('judgement', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, series, step, attempt, commanded_n, felt_n, kind, term, scored, catch_trial, feel_again,
  forward_mm, forward_speed_mm_s, response_s);
