-- Version 2 of the study file, tables. For people: docs/study-file.md.
-- Never edit this file once a study was recorded with it: the next change is the next numbered step.
-- Each record carries the CRC-32 of its own columns (core/store/record_checksum.h), so that a changed byte is noticed.
-- The guards that refuse every change are taken down here and put up again by v2_guards.sql.

DROP TRIGGER study_keep;
DROP TRIGGER tombstone_keep;
DROP TRIGGER person_keep;
DROP TRIGGER session_keep;
DROP TRIGGER profile_keep;
DROP TRIGGER event_keep;
DROP TRIGGER stroke_keep;
DROP TRIGGER judgement_keep;
DROP TRIGGER answer_keep;
DROP TRIGGER rating_keep;
DROP TRIGGER rule_keep;
DROP TRIGGER recording_keep;
DROP TRIGGER model_version_keep;
DROP TRIGGER import_log_keep;
DROP VIEW profile_current;
DROP VIEW event_current;
DROP VIEW stroke_current;
DROP VIEW judgement_current;
DROP VIEW answer_current;
DROP VIEW rating_current;
DROP VIEW rule_current;

-- Salted hashes of the codes of the participant who withdrew, 32 bytes each, tell a code when it comes back, and nothing else.
ALTER TABLE tombstone ADD COLUMN code_salt BLOB CHECK (length(code_salt) = 16);
ALTER TABLE tombstone ADD COLUMN code_hash BLOB CHECK (length(code_hash) > 0 AND length(code_hash) % 32 = 0);
-- When a withdrawal took the participant's rules and code out of the text; NULL: the text is as it was stored.
ALTER TABLE model_version ADD COLUMN cleaned_utc_ms INTEGER;
-- Over what was read; empty where an older version did not note it.
ALTER TABLE import_log ADD COLUMN sha256 TEXT NOT NULL DEFAULT '' CHECK (length(sha256) IN (0, 64) AND sha256 NOT GLOB '*[^0-9a-f]*');

-- The name is that of a table from here on.
DROP INDEX person_code;
CREATE INDEX person_by_code ON person (code);

-- A later code of a person, where a merge brought two persons with one code together. The latest one counts.
CREATE TABLE person_code (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  person_id BLOB NOT NULL REFERENCES person (id),
  utc_ms INTEGER NOT NULL,
  code TEXT NOT NULL CHECK (code <> ''),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX person_code_person ON person_code (person_id, utc_ms, id);

-- A withdrawal whose traces in unused pages and in the journal are not erased yet.
CREATE TABLE erasure (
  person_id BLOB NOT NULL PRIMARY KEY CHECK (length(person_id) = 16),
  utc_ms INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

-- Which opening for writing the file and its journal belong to: what tells a journal of another file and a journal that
-- lost its end. The checksum tells a row that was half written when the machine crashed. Not a record: each commit changes it, and no export or merge takes it along.
CREATE TABLE opening (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  token BLOB NOT NULL CHECK (length(token) = 16),
  previous BLOB CHECK (length(previous) = 16),
  commits INTEGER NOT NULL CHECK (commits >= 0),
  is_open INTEGER NOT NULL CHECK (is_open IN (0, 1)),
  journal_bytes INTEGER NOT NULL CHECK (journal_bytes >= 0),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;
INSERT INTO opening (one, token, previous, commits, is_open, journal_bytes) VALUES (1, randomblob(16), NULL, 0, 0, 0);
UPDATE opening SET crc32 = record_crc32('opening', one, token, previous, commits, is_open, journal_bytes);

-- Records that were lost or may have been: a journal that was missing, cut or damaged when the file was opened.
CREATE TABLE incident (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  utc_ms INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind <> ''),
  detail TEXT NOT NULL,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;

-- As the last column of each table, and right for what is there already. Without a CHECK: the check of the file at each
-- opening would read through every recording to come to it.
ALTER TABLE study ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE tombstone ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE person ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE session ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE profile ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE event ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE stroke ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE judgement ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE answer ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE rating ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE rule ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE recording ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE model_version ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
ALTER TABLE import_log ADD COLUMN crc32 INTEGER NOT NULL DEFAULT 0;
UPDATE study SET crc32 = record_crc32('study', one, id, name, created_utc_ms, program);
UPDATE tombstone SET crc32 = record_crc32('tombstone', person_id, utc_ms, code_salt, code_hash);
UPDATE person SET crc32 = record_crc32('person', id, code, simulated);
UPDATE session SET crc32 = record_crc32('session', id, person_id, kind, started_utc_ms, started_monotonic_ns,
  consent_version, seed, language, station, program, device, device_friction_n, settings);
UPDATE profile SET crc32 = record_crc32('profile', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, years_experience, insertions_per_month, category, handedness, gloves, tube_size,
  haptic_experience, weight);
UPDATE event SET crc32 = record_crc32('event', id, session_id, sequence, utc_ms, monotonic_ns, entered_by, supersedes,
  reason, kind, detail);
UPDATE stroke SET crc32 = record_crc32('stroke', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, level, number, attempt, practice, verdict, first_sample, end_sample);
UPDATE judgement SET crc32 = record_crc32('judgement', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, series, step, attempt, commanded_n, felt_n, kind, term, scored, catch_trial, feel_again,
  forward_mm, forward_speed_mm_s, response_s);
UPDATE answer SET crc32 = record_crc32('answer', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, form, form_version, item, position, status, value, response_s);
UPDATE rating SET crc32 = record_crc32('rating', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, block, effort, comfort);
UPDATE rule SET crc32 = record_crc32('rule', id, session_id, sequence, utc_ms, monotonic_ns, entered_by, supersedes,
  reason, form, conditions, then_term, weight);
UPDATE recording SET crc32 = record_crc32('recording', place, stroke_id, session_id, sample_rate_hz, samples,
  channels, data);
UPDATE model_version SET crc32 = record_crc32('model_version', place, id, sequence, parent, utc_ms, author, label,
  sha256, text, cleaned_utc_ms);
UPDATE import_log SET crc32 = record_crc32('import_log', id, utc_ms, kind, source, detail, sha256);
