-- Version 3 of the study file, guards: those of version 2 again, and those of the new tables.

CREATE TRIGGER session_keep BEFORE UPDATE ON session
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'session: what was recorded is never changed'); END;
CREATE TRIGGER profile_keep BEFORE UPDATE ON profile
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'profile: what was recorded is never changed'); END;
CREATE TRIGGER judgement_keep BEFORE UPDATE ON judgement
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'judgement: what was recorded is never changed'); END;

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
