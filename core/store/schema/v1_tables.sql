-- Version 1 of the study file, tables. For people: docs/study-file.md.
-- Never edit this file once a study was recorded with it: the next change is a numbered step of its own.
-- Each record carries the CRC-32 of its own columns (core/store/record_checksum.h) as its last one, so that a changed byte is
-- noticed. Without a CHECK: the check of the file at each opening would read through every recording to come to it.
-- Ids are 16 random bytes, so that the records of several stations can stand in one file. `settings`, `detail` and
-- `conditions` are JSON, which the program checks: with `trusted_schema` off a CHECK may not use the JSON functions.

CREATE TABLE study (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  id BLOB NOT NULL CHECK (length(id) = 16),
  name TEXT NOT NULL,
  created_utc_ms INTEGER NOT NULL,
  program TEXT NOT NULL,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;

-- A participant who withdrew. Nothing else of them is left, and nothing of them can come back.
CREATE TABLE tombstone (
  person_id BLOB NOT NULL PRIMARY KEY CHECK (length(person_id) = 16),
  utc_ms INTEGER NOT NULL,
  -- Salted hashes of the codes of the participant who withdrew, 32 bytes each, tell a code when it comes back, and nothing else.
  code_salt BLOB CHECK (length(code_salt) = 16),
  code_hash BLOB CHECK (length(code_hash) > 0 AND length(code_hash) % 32 = 0),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;

-- `code` is unique in what one station writes; a merge keeps both persons and lists the conflict.
CREATE TABLE person (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  code TEXT NOT NULL CHECK (code <> ''),
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX person_by_code ON person (code);

-- `seed` is an unsigned 64-bit number, which an INTEGER cannot hold.
CREATE TABLE session (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  person_id BLOB NOT NULL REFERENCES person (id),
  kind TEXT NOT NULL CHECK (kind IN ('elicitation', 'usability', 'import')),
  started_utc_ms INTEGER NOT NULL,
  started_monotonic_ns INTEGER NOT NULL,
  consent_version TEXT NOT NULL,
  seed TEXT NOT NULL CHECK (seed <> '' AND seed NOT GLOB '*[^0-9]*'),
  language TEXT NOT NULL,
  station TEXT NOT NULL,
  program TEXT NOT NULL,
  device TEXT NOT NULL,
  device_friction_n REAL CHECK (device_friction_n BETWEEN 0 AND 1e6),
  settings TEXT NOT NULL,
  -- The protocol that the session follows; NULL: none.
  protocol_id BLOB REFERENCES protocol (id),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX session_person ON session (person_id);
CREATE INDEX session_protocol ON session (protocol_id) WHERE protocol_id IS NOT NULL;

-- The seven kinds of record of a session begin with the same eight columns. `sequence` counts 1, 2, 3, … through the
-- session over all kinds: a missing number would be a lost record. `supersedes` is the record that this one corrects.
CREATE TABLE profile (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  session_id BLOB NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  utc_ms INTEGER NOT NULL,
  monotonic_ns INTEGER NOT NULL,
  entered_by TEXT NOT NULL CHECK (entered_by IN ('participant', 'researcher', 'program')),
  supersedes BLOB REFERENCES profile (id) CHECK (supersedes <> id),
  reason TEXT NOT NULL,
  years_experience REAL CHECK (years_experience BETWEEN 0 AND 1e6),
  insertions_per_month REAL CHECK (insertions_per_month BETWEEN 0 AND 1e6),
  category TEXT NOT NULL,
  handedness TEXT NOT NULL,
  gloves TEXT NOT NULL,
  tube_size TEXT NOT NULL,
  haptic_experience TEXT NOT NULL,
  weight REAL CHECK (weight BETWEEN 0 AND 1e9),
  -- How hand and arm felt before the session.
  comfort TEXT NOT NULL DEFAULT '',
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX profile_session ON profile (session_id, sequence);
CREATE INDEX profile_supersedes ON profile (supersedes) WHERE supersedes IS NOT NULL;

CREATE TABLE event (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  session_id BLOB NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  utc_ms INTEGER NOT NULL,
  monotonic_ns INTEGER NOT NULL,
  entered_by TEXT NOT NULL CHECK (entered_by IN ('participant', 'researcher', 'program')),
  supersedes BLOB REFERENCES event (id) CHECK (supersedes <> id),
  reason TEXT NOT NULL,
  kind TEXT NOT NULL CHECK (kind <> ''),
  detail TEXT NOT NULL,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX event_session ON event (session_id, sequence);
CREATE INDEX event_supersedes ON event (supersedes) WHERE supersedes IS NOT NULL;

-- The samples of a stroke stand in `recording`, so that strokes are listed without reading them.
CREATE TABLE stroke (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  session_id BLOB NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  utc_ms INTEGER NOT NULL,
  monotonic_ns INTEGER NOT NULL,
  entered_by TEXT NOT NULL CHECK (entered_by IN ('participant', 'researcher', 'program')),
  supersedes BLOB REFERENCES stroke (id) CHECK (supersedes <> id),
  reason TEXT NOT NULL,
  level TEXT NOT NULL CHECK (level <> ''),
  number INTEGER NOT NULL CHECK (number >= 0),
  attempt INTEGER NOT NULL CHECK (attempt >= 1),
  practice INTEGER NOT NULL CHECK (practice IN (0, 1)),
  verdict TEXT NOT NULL,
  first_sample INTEGER NOT NULL CHECK (first_sample >= 0),
  end_sample INTEGER NOT NULL CHECK (end_sample >= first_sample),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX stroke_session ON stroke (session_id, sequence);
CREATE INDEX stroke_supersedes ON stroke (supersedes) WHERE supersedes IS NOT NULL;

-- One chunk per stroke; `data` is laid out as docs/study-file.md says. An ordinary row per sample would be 1000 a second.
CREATE TABLE recording (
  place INTEGER NOT NULL PRIMARY KEY CHECK (place >= 1),
  stroke_id BLOB NOT NULL UNIQUE REFERENCES stroke (id),
  session_id BLOB NOT NULL REFERENCES session (id),
  sample_rate_hz REAL NOT NULL CHECK (sample_rate_hz > 0 AND sample_rate_hz <= 1e9),
  samples INTEGER NOT NULL CHECK (samples >= 0),
  channels TEXT NOT NULL,
  data BLOB NOT NULL CHECK (length(data) >= 24),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE INDEX recording_session ON recording (session_id);

CREATE TABLE judgement (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  session_id BLOB NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  utc_ms INTEGER NOT NULL,
  monotonic_ns INTEGER NOT NULL,
  entered_by TEXT NOT NULL CHECK (entered_by IN ('participant', 'researcher', 'program')),
  supersedes BLOB REFERENCES judgement (id) CHECK (supersedes <> id),
  reason TEXT NOT NULL,
  series TEXT NOT NULL CHECK (series <> ''),
  step INTEGER NOT NULL CHECK (step >= 0),
  attempt INTEGER NOT NULL CHECK (attempt >= 1),
  commanded_n REAL NOT NULL CHECK (commanded_n BETWEEN 0 AND 1e6),
  felt_n REAL CHECK (felt_n BETWEEN -1e6 AND 1e6),
  kind TEXT NOT NULL CHECK (kind IN ('term', 'not_felt', 'beyond_practice', 'no_answer')),
  term TEXT NOT NULL CHECK ((kind = 'term') = (term <> '')),
  scored INTEGER NOT NULL CHECK (scored IN (0, 1)),
  catch_trial INTEGER NOT NULL CHECK (catch_trial IN (0, 1)),
  feel_again INTEGER NOT NULL CHECK (feel_again >= 0),
  forward_mm REAL NOT NULL CHECK (forward_mm BETWEEN -1e9 AND 1e9),
  forward_speed_mm_s REAL NOT NULL CHECK (forward_speed_mm_s BETWEEN -1e9 AND 1e9),
  response_s REAL NOT NULL CHECK (response_s BETWEEN 0 AND 1e9),
  -- The least share of the force that reached the hand; NULL: not known.
  delivered_share REAL CHECK (delivered_share BETWEEN 0 AND 1),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX judgement_session ON judgement (session_id, sequence);
CREATE INDEX judgement_supersedes ON judgement (supersedes) WHERE supersedes IS NOT NULL;

CREATE TABLE answer (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  session_id BLOB NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  utc_ms INTEGER NOT NULL,
  monotonic_ns INTEGER NOT NULL,
  entered_by TEXT NOT NULL CHECK (entered_by IN ('participant', 'researcher', 'program')),
  supersedes BLOB REFERENCES answer (id) CHECK (supersedes <> id),
  reason TEXT NOT NULL,
  form TEXT NOT NULL CHECK (form <> ''),
  form_version INTEGER NOT NULL CHECK (form_version >= 0),
  item INTEGER NOT NULL CHECK (item >= 0),
  position INTEGER NOT NULL CHECK (position >= 0),
  status TEXT NOT NULL CHECK (status IN ('answered', 'skipped', 'cant_tell', 'cleared')),
  value TEXT NOT NULL CHECK ((status = 'answered') = (value <> '')),
  response_s REAL NOT NULL CHECK (response_s BETWEEN 0 AND 1e9),
  -- The id of the words in which the item was asked: plain, published; empty: not known.
  wording TEXT NOT NULL DEFAULT '',
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX answer_session ON answer (session_id, sequence);
CREATE INDEX answer_supersedes ON answer (supersedes) WHERE supersedes IS NOT NULL;

CREATE TABLE rating (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  session_id BLOB NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  utc_ms INTEGER NOT NULL,
  monotonic_ns INTEGER NOT NULL,
  entered_by TEXT NOT NULL CHECK (entered_by IN ('participant', 'researcher', 'program')),
  supersedes BLOB REFERENCES rating (id) CHECK (supersedes <> id),
  reason TEXT NOT NULL,
  block TEXT NOT NULL CHECK (block <> ''),
  effort INTEGER NOT NULL CHECK (effort BETWEEN 1 AND 7),
  comfort INTEGER NOT NULL CHECK (comfort BETWEEN 1 AND 7),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX rating_session ON rating (session_id, sequence);
CREATE INDEX rating_supersedes ON rating (supersedes) WHERE supersedes IS NOT NULL;

-- `conditions` is a JSON array of [input, term].
CREATE TABLE rule (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  session_id BLOB NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  utc_ms INTEGER NOT NULL,
  monotonic_ns INTEGER NOT NULL,
  entered_by TEXT NOT NULL CHECK (entered_by IN ('participant', 'researcher', 'program')),
  supersedes BLOB REFERENCES rule (id) CHECK (supersedes <> id),
  reason TEXT NOT NULL,
  form TEXT NOT NULL,
  conditions TEXT NOT NULL CHECK (conditions LIKE '[%]'),
  then_term TEXT NOT NULL CHECK (then_term <> ''),
  weight REAL NOT NULL CHECK (weight BETWEEN 0 AND 1e9),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX rule_session ON rule (session_id, sequence);
CREATE INDEX rule_supersedes ON rule (supersedes) WHERE supersedes IS NOT NULL;

-- `sequence` orders the versions whatever the clock does; `place` only counts the rows of this file.
CREATE TABLE model_version (
  place INTEGER NOT NULL PRIMARY KEY CHECK (place >= 1),
  id BLOB NOT NULL UNIQUE CHECK (length(id) = 16),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  parent BLOB REFERENCES model_version (id) CHECK (parent <> id),
  utc_ms INTEGER NOT NULL,
  author TEXT NOT NULL,
  label TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64 AND sha256 NOT GLOB '*[^0-9a-f]*'),
  text TEXT NOT NULL,
  -- When a withdrawal took the participant's rules and code out of the text; NULL: the text is as it was stored.
  cleaned_utc_ms INTEGER,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE INDEX model_version_order ON model_version (sequence, utc_ms, id);

-- What was read into this file. `detail` is JSON and never names a participant other than by id.
CREATE TABLE import_log (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  utc_ms INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('merge', 'tables')),
  source TEXT NOT NULL,
  detail TEXT NOT NULL,
  -- Over what was read.
  sha256 TEXT NOT NULL DEFAULT '' CHECK (length(sha256) IN (0, 64) AND sha256 NOT GLOB '*[^0-9a-f]*'),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;

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

-- How the depths of the regions were measured on an image: scale, way of the tube, boundaries, overlaps; JSON. The latest row
-- counts. The image lies in the row with which it came; the rows after that one name it.
CREATE TABLE depth_measurement (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  utc_ms INTEGER NOT NULL,
  author TEXT NOT NULL,
  text TEXT NOT NULL CHECK (text LIKE '{%}'),
  image_id BLOB REFERENCES depth_measurement (id) CHECK (image_id <> id),
  image BLOB CHECK (image IS NULL OR (length(image) > 0 AND image_id IS NULL)),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;
CREATE INDEX depth_measurement_order ON depth_measurement (utc_ms, id);
CREATE INDEX depth_measurement_image ON depth_measurement (image_id) WHERE image_id IS NOT NULL;
