-- Version 5 of the study file, guards: that of version 2 again.

CREATE TRIGGER answer_keep BEFORE UPDATE ON answer
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'answer: what was recorded is never changed'); END;
