-- Version 1 of the study file, guards: what was recorded is never changed, and removed by a withdrawal only.
-- A tombstone is what permits a removal, so none happens without leaving its trace. The triggers before INSERT are needed
-- because INSERT OR REPLACE deletes rows without asking the triggers before DELETE. While an erasure is not finished, texts
-- and models are cleaned of the code and the rules of the participant who withdrew.

CREATE TRIGGER study_keep BEFORE UPDATE ON study
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'study: what was recorded is never changed'); END;
CREATE TRIGGER study_stay BEFORE DELETE ON study
BEGIN SELECT RAISE(ABORT, 'study: nothing is removed here'); END;
CREATE TRIGGER study_once BEFORE INSERT ON study
WHEN EXISTS (SELECT 1 FROM study WHERE one = NEW.one)
BEGIN SELECT RAISE(ABORT, 'study: this record is there already'); END;

-- Two stations may know of one withdrawal: the earlier time and all codes count.
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

-- Only beside the tombstone of its participant; it goes when the traces are erased.
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
