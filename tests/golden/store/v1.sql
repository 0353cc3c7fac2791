-- A study file of version 1 as SQL text: sqlite3 v1.tactus < v1.sql. Never edited; see README.md.
PRAGMA application_id = 0x54414353;
PRAGMA user_version = 1;
PRAGMA foreign_keys = ON;
BEGIN;

CREATE TABLE study (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  id BLOB NOT NULL CHECK (length(id) = 16),
  name TEXT NOT NULL,
  created_utc_ms INTEGER NOT NULL,
  program TEXT NOT NULL,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;

CREATE TABLE tombstone (
  person_id BLOB NOT NULL PRIMARY KEY CHECK (length(person_id) = 16),
  utc_ms INTEGER NOT NULL,
  -- Salted hashes of the codes of the participant who withdrew, 32 bytes each, tell a code when it comes back, and nothing else.
  code_salt BLOB CHECK (length(code_salt) = 16),
  code_hash BLOB CHECK (length(code_hash) > 0 AND length(code_hash) % 32 = 0),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;

CREATE TABLE person (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  code TEXT NOT NULL CHECK (code <> ''),
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;

CREATE INDEX person_by_code ON person (code);

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

CREATE TABLE person_code (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  person_id BLOB NOT NULL REFERENCES person (id),
  utc_ms INTEGER NOT NULL,
  code TEXT NOT NULL CHECK (code <> ''),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;

CREATE INDEX person_code_person ON person_code (person_id, utc_ms, id);

CREATE TABLE erasure (
  person_id BLOB NOT NULL PRIMARY KEY CHECK (length(person_id) = 16),
  utc_ms INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE opening (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  token BLOB NOT NULL CHECK (length(token) = 16),
  previous BLOB CHECK (length(previous) = 16),
  commits INTEGER NOT NULL CHECK (commits >= 0),
  is_open INTEGER NOT NULL CHECK (is_open IN (0, 1)),
  journal_bytes INTEGER NOT NULL CHECK (journal_bytes >= 0),
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;

CREATE TABLE incident (
  id BLOB NOT NULL PRIMARY KEY CHECK (length(id) = 16),
  utc_ms INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind <> ''),
  detail TEXT NOT NULL,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT, WITHOUT ROWID;

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

CREATE TABLE research_key (
  place INTEGER NOT NULL PRIMARY KEY CHECK (place >= 1),
  utc_ms INTEGER NOT NULL,
  hash TEXT NOT NULL,
  crc32 INTEGER NOT NULL DEFAULT 0
) STRICT;

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

INSERT INTO study VALUES (1, x'01010101010101010101010101010101', 'Fixture of version 1', 1770000000000, 'tactus 0.1.0', 3932430037);
INSERT INTO tombstone VALUES (x'0d0d0d0d0d0d0d0d0d0d0d0d0d0d0d0d', 1770000000900, NULL, NULL, 4017370444);
INSERT INTO tombstone VALUES
  (x'13131313131313131313131313131313', 1770000000980, x'000102030405060708090a0b0c0d0e0f', x'd885c09fcefb8d430bc55a3b6c473f31abc4d4ea76f7b66e5d7e18c8ba292d56', 3017884377);
INSERT INTO person VALUES (x'02020202020202020202020202020202', 'calm-fox', 1, 2117876184);
INSERT INTO protocol VALUES (x'16161616161616161616161616161616', 1, 1770000000050, 'north', '', '{"languages":["en"]}', 748468725);
INSERT INTO protocol VALUES
  (x'17171717171717171717171717171717', 1, 1770000000060, 'north', 'shorter', '{"languages":["en","zh-Hant"]}', 4272720382);
INSERT INTO session VALUES
  (x'03030303030303030303030303030303', x'02020202020202020202020202020202', 'elicitation', 1770000000100, 1, 'consent 2', '18446744073709551615', 'en', 'north', 'tactus 0.1.0', 'simulated', 0.26, '{"levels":["slow"]}', x'16161616161616161616161616161616', 1306044697);
INSERT INTO profile VALUES
  (x'04040404040404040404040404040404', x'03030303030303030303030303030303', 1, 1770000000101, 1000, 'researcher', NULL, '', 12.5, NULL, 'expert', 'left', 'nitrile', '14 Fr', 'none', NULL, 'good', 1962080479);
INSERT INTO event VALUES
  (x'0b0b0b0b0b0b0b0b0b0b0b0b0b0b0b0b', x'03030303030303030303030303030303', 8, 1770000000108, 8000, 'researcher', NULL, '', 'finished', '', 3451154675);
INSERT INTO stroke VALUES
  (x'05050505050505050505050505050505', x'03030303030303030303030303030303', 2, 1770000000102, 2000, 'researcher', NULL, '', 'slow', 1, 1, 0, 'accepted', 0, 2, 3830780710);
INSERT INTO recording VALUES
  (1, x'05050505050505050505050505050505', x'03030303030303030303030303030303', 1000.0, 2, 'depth mm', x'5452454301000100020000000000000000408f40056465707468026d6d000000000000f83f00000000000000c06b2ca8f8', 3746762095);
INSERT INTO judgement VALUES
  (x'06060606060606060606060606060606', x'03030303030303030303030303030303', 3, 1770000000103, 3000, 'researcher', NULL, '', 'ascending', 1, 1, 0.1, 0.36, 'term', 'very_small', 1, 0, 0, 8.0, 17.0, 2.5, 0.53, 879997733);
INSERT INTO answer VALUES
  (x'07070707070707070707070707070707', x'03030303030303030303030303030303', 4, 1770000000104, 4000, 'researcher', NULL, '', 'ngt_force', 1, 7, 1, 'answered', 'large', 2.0, 'plain', 763583349);
INSERT INTO answer VALUES
  (x'08080808080808080808080808080808', x'03030303030303030303030303030303', 5, 1770000000105, 5000, 'researcher', x'07070707070707070707070707070707', 'misheard', 'ngt_force', 1, 7, 1, 'answered', 'small', 2.0, 'published', 441128774);
INSERT INTO rating VALUES
  (x'09090909090909090909090909090909', x'03030303030303030303030303030303', 6, 1770000000106, 6000, 'researcher', NULL, '', 'force', 2, 6, 2969330901);
INSERT INTO rule VALUES
  (x'0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a', x'03030303030303030303030303030303', 7, 1770000000107, 7000, 'researcher', NULL, '', 'ngt_force', '[["speed","fast"],["depth","esophagus"]]', 'large', 0.5, 1251728083);
INSERT INTO model_version VALUES
  (1, x'0c0c0c0c0c0c0c0c0c0c0c0c0c0c0c0c', 1, NULL, 1770000000800, 'north', 'first', 'ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad', 'abc', NULL, 2878027361);
INSERT INTO import_log VALUES (x'0e0e0e0e0e0e0e0e0e0e0e0e0e0e0e0e', 1770000000950, 'merge', 'b.tactus', '', '', 1958222914);
INSERT INTO import_log VALUES
  (x'14141414141414141414141414141414', 1770000000990, 'tables', 'tables', '{"answers":2}', 'ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad', 2715883217);
INSERT INTO person_code VALUES
  (x'11111111111111111111111111111111', x'02020202020202020202020202020202', 1770000000960, 'calm-fox-2', 3776617784);
INSERT INTO opening VALUES (1, x'15151515151515151515151515151515', NULL, 0, 0, 0, 1540591269);
INSERT INTO incident VALUES
  (x'12121212121212121212121212121212', 1770000000970, 'journal_missing', 'the journal was missing when the study was opened', 889714916);
INSERT INTO research_key VALUES (1, 1770000000055, '$y$j9T$Zm9vYmFyYmF6cXV4$mCfFVdvAdSFZUWueyyR1ZFnKEWnB0j.Zwqo49CU0.b1', 1042878734);
INSERT INTO depth_measurement VALUES
  (x'18181818181818181818181818181818', 1770000000070, 'north', '{"mm_per_px":0.33}', NULL, x'89504e47', 4246004953);
INSERT INTO depth_measurement VALUES
  (x'19191919191919191919191919191919', 1770000000080, 'north', '{"mm_per_px":0.5}', x'18181818181818181818181818181818', NULL, 3662361930);

CREATE TRIGGER study_keep BEFORE UPDATE ON study
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'study: what was recorded is never changed'); END;
CREATE TRIGGER study_stay BEFORE DELETE ON study
BEGIN SELECT RAISE(ABORT, 'study: nothing is removed here'); END;
CREATE TRIGGER study_once BEFORE INSERT ON study
WHEN EXISTS (SELECT 1 FROM study WHERE one = NEW.one)
BEGIN SELECT RAISE(ABORT, 'study: this record is there already'); END;
CREATE TRIGGER tombstone_keep BEFORE UPDATE ON tombstone
WHEN NOT EXISTS (SELECT 1 FROM erasure) OR NEW.person_id <> OLD.person_id OR NEW.utc_ms > OLD.utc_ms
  OR coalesce(NEW.code_salt <> OLD.code_salt, OLD.code_salt IS NOT NULL)
  OR coalesce(length(NEW.code_hash), 0) < coalesce(length(OLD.code_hash), 0)
BEGIN SELECT RAISE(ABORT, 'tombstone: what was recorded is never changed'); END;
CREATE TRIGGER tombstone_stay BEFORE DELETE ON tombstone
BEGIN SELECT RAISE(ABORT, 'tombstone: nothing is removed here'); END;
CREATE TRIGGER tombstone_once BEFORE INSERT ON tombstone
WHEN EXISTS (SELECT 1 FROM tombstone WHERE person_id = NEW.person_id)
BEGIN SELECT RAISE(ABORT, 'tombstone: this record is there already'); END;
CREATE TRIGGER person_keep BEFORE UPDATE ON person
BEGIN SELECT RAISE(ABORT, 'person: what was recorded is never changed'); END;
CREATE TRIGGER person_stay BEFORE DELETE ON person
WHEN NOT EXISTS (SELECT 1 FROM tombstone WHERE person_id = OLD.id)
BEGIN SELECT RAISE(ABORT, 'person: only a withdrawal removes records'); END;
CREATE TRIGGER person_once BEFORE INSERT ON person
WHEN EXISTS (SELECT 1 FROM person WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'person: this record is there already'); END;
CREATE TRIGGER person_withdrawn BEFORE INSERT ON person
WHEN EXISTS (SELECT 1 FROM tombstone WHERE person_id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'person: this participant withdrew'); END;
CREATE TRIGGER session_keep BEFORE UPDATE ON session
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'session: what was recorded is never changed'); END;
CREATE TRIGGER session_stay BEFORE DELETE ON session
WHEN NOT EXISTS (SELECT 1 FROM tombstone WHERE person_id = OLD.person_id)
BEGIN SELECT RAISE(ABORT, 'session: only a withdrawal removes records'); END;
CREATE TRIGGER session_once BEFORE INSERT ON session
WHEN EXISTS (SELECT 1 FROM session WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'session: this record is there already'); END;
CREATE TRIGGER profile_keep BEFORE UPDATE ON profile
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'profile: what was recorded is never changed'); END;
CREATE TRIGGER profile_stay BEFORE DELETE ON profile
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'profile: only a withdrawal removes records'); END;
CREATE TRIGGER profile_once BEFORE INSERT ON profile
WHEN EXISTS (SELECT 1 FROM profile WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'profile: this record is there already'); END;
CREATE TRIGGER profile_same_person BEFORE INSERT ON profile
WHEN NEW.supersedes IS NOT NULL AND (SELECT person_id FROM session WHERE id = NEW.session_id) IS NOT
  (SELECT person_id FROM profile JOIN session ON session.id = session_id WHERE profile.id = NEW.supersedes)
BEGIN SELECT RAISE(ABORT, 'profile: a correction is of a record of the same person'); END;
CREATE TRIGGER event_keep BEFORE UPDATE ON event
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'event: what was recorded is never changed'); END;
CREATE TRIGGER event_stay BEFORE DELETE ON event
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'event: only a withdrawal removes records'); END;
CREATE TRIGGER event_once BEFORE INSERT ON event
WHEN EXISTS (SELECT 1 FROM event WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'event: this record is there already'); END;
CREATE TRIGGER event_same_person BEFORE INSERT ON event
WHEN NEW.supersedes IS NOT NULL AND (SELECT person_id FROM session WHERE id = NEW.session_id) IS NOT
  (SELECT person_id FROM event JOIN session ON session.id = session_id WHERE event.id = NEW.supersedes)
BEGIN SELECT RAISE(ABORT, 'event: a correction is of a record of the same person'); END;
CREATE TRIGGER stroke_keep BEFORE UPDATE ON stroke
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'stroke: what was recorded is never changed'); END;
CREATE TRIGGER stroke_stay BEFORE DELETE ON stroke
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'stroke: only a withdrawal removes records'); END;
CREATE TRIGGER stroke_once BEFORE INSERT ON stroke
WHEN EXISTS (SELECT 1 FROM stroke WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'stroke: this record is there already'); END;
CREATE TRIGGER stroke_same_person BEFORE INSERT ON stroke
WHEN NEW.supersedes IS NOT NULL AND (SELECT person_id FROM session WHERE id = NEW.session_id) IS NOT
  (SELECT person_id FROM stroke JOIN session ON session.id = session_id WHERE stroke.id = NEW.supersedes)
BEGIN SELECT RAISE(ABORT, 'stroke: a correction is of a record of the same person'); END;
CREATE TRIGGER recording_keep BEFORE UPDATE ON recording
BEGIN SELECT RAISE(ABORT, 'recording: what was recorded is never changed'); END;
CREATE TRIGGER recording_stay BEFORE DELETE ON recording
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'recording: only a withdrawal removes records'); END;
CREATE TRIGGER recording_once BEFORE INSERT ON recording
WHEN EXISTS (SELECT 1 FROM recording WHERE stroke_id = NEW.stroke_id OR place = NEW.place)
BEGIN SELECT RAISE(ABORT, 'recording: this record is there already'); END;
CREATE TRIGGER judgement_keep BEFORE UPDATE ON judgement
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'judgement: what was recorded is never changed'); END;
CREATE TRIGGER judgement_stay BEFORE DELETE ON judgement
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'judgement: only a withdrawal removes records'); END;
CREATE TRIGGER judgement_once BEFORE INSERT ON judgement
WHEN EXISTS (SELECT 1 FROM judgement WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'judgement: this record is there already'); END;
CREATE TRIGGER judgement_same_person BEFORE INSERT ON judgement
WHEN NEW.supersedes IS NOT NULL AND (SELECT person_id FROM session WHERE id = NEW.session_id) IS NOT
  (SELECT person_id FROM judgement JOIN session ON session.id = session_id WHERE judgement.id = NEW.supersedes)
BEGIN SELECT RAISE(ABORT, 'judgement: a correction is of a record of the same person'); END;
CREATE TRIGGER answer_keep BEFORE UPDATE ON answer
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'answer: what was recorded is never changed'); END;
CREATE TRIGGER answer_stay BEFORE DELETE ON answer
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'answer: only a withdrawal removes records'); END;
CREATE TRIGGER answer_once BEFORE INSERT ON answer
WHEN EXISTS (SELECT 1 FROM answer WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'answer: this record is there already'); END;
CREATE TRIGGER answer_same_person BEFORE INSERT ON answer
WHEN NEW.supersedes IS NOT NULL AND (SELECT person_id FROM session WHERE id = NEW.session_id) IS NOT
  (SELECT person_id FROM answer JOIN session ON session.id = session_id WHERE answer.id = NEW.supersedes)
BEGIN SELECT RAISE(ABORT, 'answer: a correction is of a record of the same person'); END;
CREATE TRIGGER rating_keep BEFORE UPDATE ON rating
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'rating: what was recorded is never changed'); END;
CREATE TRIGGER rating_stay BEFORE DELETE ON rating
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'rating: only a withdrawal removes records'); END;
CREATE TRIGGER rating_once BEFORE INSERT ON rating
WHEN EXISTS (SELECT 1 FROM rating WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'rating: this record is there already'); END;
CREATE TRIGGER rating_same_person BEFORE INSERT ON rating
WHEN NEW.supersedes IS NOT NULL AND (SELECT person_id FROM session WHERE id = NEW.session_id) IS NOT
  (SELECT person_id FROM rating JOIN session ON session.id = session_id WHERE rating.id = NEW.supersedes)
BEGIN SELECT RAISE(ABORT, 'rating: a correction is of a record of the same person'); END;
CREATE TRIGGER rule_keep BEFORE UPDATE ON rule
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'rule: what was recorded is never changed'); END;
CREATE TRIGGER rule_stay BEFORE DELETE ON rule
WHEN NOT EXISTS (SELECT 1 FROM session JOIN tombstone USING (person_id) WHERE session.id = OLD.session_id)
BEGIN SELECT RAISE(ABORT, 'rule: only a withdrawal removes records'); END;
CREATE TRIGGER rule_once BEFORE INSERT ON rule
WHEN EXISTS (SELECT 1 FROM rule WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'rule: this record is there already'); END;
CREATE TRIGGER rule_same_person BEFORE INSERT ON rule
WHEN NEW.supersedes IS NOT NULL AND (SELECT person_id FROM session WHERE id = NEW.session_id) IS NOT
  (SELECT person_id FROM rule JOIN session ON session.id = session_id WHERE rule.id = NEW.supersedes)
BEGIN SELECT RAISE(ABORT, 'rule: a correction is of a record of the same person'); END;
CREATE TRIGGER model_version_keep BEFORE UPDATE ON model_version
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'model_version: what was recorded is never changed'); END;
CREATE TRIGGER model_version_stay BEFORE DELETE ON model_version
BEGIN SELECT RAISE(ABORT, 'model_version: nothing is removed here'); END;
CREATE TRIGGER model_version_once BEFORE INSERT ON model_version
WHEN EXISTS (SELECT 1 FROM model_version WHERE id = NEW.id OR place = NEW.place)
BEGIN SELECT RAISE(ABORT, 'model_version: this record is there already'); END;
CREATE TRIGGER import_log_keep BEFORE UPDATE ON import_log
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'import_log: what was recorded is never changed'); END;
CREATE TRIGGER import_log_stay BEFORE DELETE ON import_log
BEGIN SELECT RAISE(ABORT, 'import_log: nothing is removed here'); END;
CREATE TRIGGER import_log_once BEFORE INSERT ON import_log
WHEN EXISTS (SELECT 1 FROM import_log WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'import_log: this record is there already'); END;
CREATE TRIGGER person_code_keep BEFORE UPDATE ON person_code
BEGIN SELECT RAISE(ABORT, 'person_code: what was recorded is never changed'); END;
CREATE TRIGGER person_code_stay BEFORE DELETE ON person_code
WHEN NOT EXISTS (SELECT 1 FROM tombstone WHERE person_id = OLD.person_id)
BEGIN SELECT RAISE(ABORT, 'person_code: only a withdrawal removes records'); END;
CREATE TRIGGER person_code_once BEFORE INSERT ON person_code
WHEN EXISTS (SELECT 1 FROM person_code WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'person_code: this record is there already'); END;
CREATE TRIGGER erasure_keep BEFORE UPDATE ON erasure
BEGIN SELECT RAISE(ABORT, 'erasure: what was recorded is never changed'); END;
CREATE TRIGGER erasure_once BEFORE INSERT ON erasure
WHEN EXISTS (SELECT 1 FROM erasure WHERE person_id = NEW.person_id)
BEGIN SELECT RAISE(ABORT, 'erasure: this record is there already'); END;
CREATE TRIGGER erasure_withdrawn BEFORE INSERT ON erasure
WHEN NOT EXISTS (SELECT 1 FROM tombstone WHERE person_id = NEW.person_id)
BEGIN SELECT RAISE(ABORT, 'erasure: only of a participant who withdrew'); END;
CREATE TRIGGER incident_keep BEFORE UPDATE ON incident
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'incident: what was recorded is never changed'); END;
CREATE TRIGGER incident_stay BEFORE DELETE ON incident
BEGIN SELECT RAISE(ABORT, 'incident: nothing is removed here'); END;
CREATE TRIGGER incident_once BEFORE INSERT ON incident
WHEN EXISTS (SELECT 1 FROM incident WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'incident: this record is there already'); END;
CREATE TRIGGER protocol_keep BEFORE UPDATE ON protocol
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'protocol: what was recorded is never changed'); END;
CREATE TRIGGER protocol_stay BEFORE DELETE ON protocol
BEGIN SELECT RAISE(ABORT, 'protocol: nothing is removed here'); END;
CREATE TRIGGER protocol_once BEFORE INSERT ON protocol
WHEN EXISTS (SELECT 1 FROM protocol WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'protocol: this record is there already'); END;
CREATE TRIGGER research_key_keep BEFORE UPDATE ON research_key
BEGIN SELECT RAISE(ABORT, 'research_key: what was recorded is never changed'); END;
CREATE TRIGGER research_key_stay BEFORE DELETE ON research_key
BEGIN SELECT RAISE(ABORT, 'research_key: nothing is removed here'); END;
CREATE TRIGGER research_key_once BEFORE INSERT ON research_key
WHEN EXISTS (SELECT 1 FROM research_key WHERE place = NEW.place)
BEGIN SELECT RAISE(ABORT, 'research_key: this record is there already'); END;
CREATE TRIGGER depth_measurement_keep BEFORE UPDATE ON depth_measurement
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'depth_measurement: what was recorded is never changed'); END;
CREATE TRIGGER depth_measurement_stay BEFORE DELETE ON depth_measurement
BEGIN SELECT RAISE(ABORT, 'depth_measurement: nothing is removed here'); END;
CREATE TRIGGER depth_measurement_once BEFORE INSERT ON depth_measurement
WHEN EXISTS (SELECT 1 FROM depth_measurement WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'depth_measurement: this record is there already'); END;

CREATE VIEW profile_current AS
SELECT * FROM profile AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM profile AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM profile AS c JOIN profile AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN profile AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN profile AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM profile AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW event_current AS
SELECT * FROM event AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM event AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM event AS c JOIN event AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN event AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN event AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM event AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW stroke_current AS
SELECT * FROM stroke AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM stroke AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM stroke AS c JOIN stroke AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN stroke AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN stroke AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM stroke AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW judgement_current AS
SELECT * FROM judgement AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM judgement AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM judgement AS c JOIN judgement AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN judgement AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN judgement AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM judgement AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW answer_current AS
SELECT * FROM answer AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM answer AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM answer AS c JOIN answer AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN answer AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN answer AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM answer AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW rating_current AS
SELECT * FROM rating AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM rating AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM rating AS c JOIN rating AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN rating AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN rating AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM rating AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW rule_current AS
SELECT * FROM rule AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM rule AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM rule AS c JOIN rule AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN rule AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN rule AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM rule AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW person_current AS
SELECT p.id, coalesce((SELECT c.code FROM person_code AS c WHERE c.person_id = p.id
                       ORDER BY c.utc_ms DESC, c.id DESC LIMIT 1), p.code) AS code, p.simulated
FROM person AS p;

CREATE VIEW session_record AS
SELECT 'profile' AS kind, id, session_id, sequence, utc_ms, supersedes FROM profile
UNION ALL SELECT 'event' AS kind, id, session_id, sequence, utc_ms, supersedes FROM event
UNION ALL SELECT 'stroke' AS kind, id, session_id, sequence, utc_ms, supersedes FROM stroke
UNION ALL SELECT 'judgement' AS kind, id, session_id, sequence, utc_ms, supersedes FROM judgement
UNION ALL SELECT 'answer' AS kind, id, session_id, sequence, utc_ms, supersedes FROM answer
UNION ALL SELECT 'rating' AS kind, id, session_id, sequence, utc_ms, supersedes FROM rating
UNION ALL SELECT 'rule' AS kind, id, session_id, sequence, utc_ms, supersedes FROM rule;
COMMIT;
