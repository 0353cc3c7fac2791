-- Version 4 of the study file, guards of its table.

CREATE TRIGGER depth_measurement_keep BEFORE UPDATE ON depth_measurement
WHEN NOT EXISTS (SELECT 1 FROM erasure)
BEGIN SELECT RAISE(ABORT, 'depth_measurement: what was recorded is never changed'); END;
CREATE TRIGGER depth_measurement_stay BEFORE DELETE ON depth_measurement
BEGIN SELECT RAISE(ABORT, 'depth_measurement: nothing is removed here'); END;
CREATE TRIGGER depth_measurement_once BEFORE INSERT ON depth_measurement
WHEN EXISTS (SELECT 1 FROM depth_measurement WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'depth_measurement: this record is there already'); END;
