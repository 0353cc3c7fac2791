-- Version 2 of the study file, guards: those of version 1 against changes, and those of the new tables.
-- While an erasure is not finished, texts and models are cleaned of the code and the rules of the participant who withdrew.

CREATE TRIGGER study_keep BEFORE UPDATE ON study
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'study: what was recorded is never changed'); END;
-- Two stations may know of one withdrawal: the earlier time and all codes count.
CREATE TRIGGER tombstone_keep BEFORE UPDATE ON tombstone
WHEN NOT EXISTS (SELECT 1 FROM erasure) OR NEW.person_id <> OLD.person_id OR NEW.utc_ms > OLD.utc_ms
  OR coalesce(NEW.code_salt <> OLD.code_salt, OLD.code_salt IS NOT NULL)
  OR coalesce(length(NEW.code_hash), 0) < coalesce(length(OLD.code_hash), 0)
BEGIN SELECT RAISE(ABORT, 'tombstone: what was recorded is never changed'); END;
CREATE TRIGGER person_keep BEFORE UPDATE ON person
BEGIN SELECT RAISE(ABORT, 'person: what was recorded is never changed'); END;
CREATE TRIGGER session_keep BEFORE UPDATE ON session
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'session: what was recorded is never changed'); END;
CREATE TRIGGER profile_keep BEFORE UPDATE ON profile
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'profile: what was recorded is never changed'); END;
CREATE TRIGGER event_keep BEFORE UPDATE ON event
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'event: what was recorded is never changed'); END;
CREATE TRIGGER stroke_keep BEFORE UPDATE ON stroke
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'stroke: what was recorded is never changed'); END;
CREATE TRIGGER judgement_keep BEFORE UPDATE ON judgement
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'judgement: what was recorded is never changed'); END;
CREATE TRIGGER answer_keep BEFORE UPDATE ON answer
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'answer: what was recorded is never changed'); END;
CREATE TRIGGER rating_keep BEFORE UPDATE ON rating
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'rating: what was recorded is never changed'); END;
CREATE TRIGGER rule_keep BEFORE UPDATE ON rule
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'rule: what was recorded is never changed'); END;
CREATE TRIGGER recording_keep BEFORE UPDATE ON recording
BEGIN SELECT RAISE(ABORT, 'recording: what was recorded is never changed'); END;
CREATE TRIGGER model_version_keep BEFORE UPDATE ON model_version
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'model_version: what was recorded is never changed'); END;
CREATE TRIGGER import_log_keep BEFORE UPDATE ON import_log
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'import_log: what was recorded is never changed'); END;

CREATE TRIGGER person_code_keep BEFORE UPDATE ON person_code
BEGIN SELECT RAISE(ABORT, 'person_code: what was recorded is never changed'); END;
CREATE TRIGGER person_code_stay BEFORE DELETE ON person_code
WHEN NOT EXISTS (SELECT 1 FROM tombstone WHERE person_id = OLD.person_id)
BEGIN SELECT RAISE(ABORT, 'person_code: only a withdrawal removes records'); END;
CREATE TRIGGER person_code_once BEFORE INSERT ON person_code
WHEN EXISTS (SELECT 1 FROM person_code WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'person_code: this record is there already'); END;

-- Only beside the tombstone of its participant; it goes when the traces are erased.
CREATE TRIGGER erasure_keep BEFORE UPDATE ON erasure
BEGIN SELECT RAISE(ABORT, 'erasure: what was recorded is never changed'); END;
CREATE TRIGGER erasure_withdrawn BEFORE INSERT ON erasure
WHEN NOT EXISTS (SELECT 1 FROM tombstone WHERE person_id = NEW.person_id)
BEGIN SELECT RAISE(ABORT, 'erasure: only of a participant who withdrew'); END;
CREATE TRIGGER erasure_once BEFORE INSERT ON erasure
WHEN EXISTS (SELECT 1 FROM erasure WHERE person_id = NEW.person_id)
BEGIN SELECT RAISE(ABORT, 'erasure: this record is there already'); END;

CREATE TRIGGER incident_keep BEFORE UPDATE ON incident
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'incident: what was recorded is never changed'); END;
CREATE TRIGGER incident_stay BEFORE DELETE ON incident
BEGIN SELECT RAISE(ABORT, 'incident: nothing is removed here'); END;
CREATE TRIGGER incident_once BEFORE INSERT ON incident
WHEN EXISTS (SELECT 1 FROM incident WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'incident: this record is there already'); END;
