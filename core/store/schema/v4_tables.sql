-- Version 4 of the study file, tables. For people: docs/study-file.md.
-- Never edit this file once a study was recorded with it: the next change is the next numbered step.

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
