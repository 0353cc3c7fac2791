-- What version 3 lacks, for reading it as it is: a view of this connection alone gives it the table of version 4.

CREATE TEMP VIEW depth_measurement AS
SELECT NULL AS id, NULL AS utc_ms, NULL AS author, NULL AS text, NULL AS image_id, NULL AS image, NULL AS crc32 WHERE 0;
