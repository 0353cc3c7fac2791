-- What an older version lacks, for reading it as it is: views of this connection alone stand before the tables of
-- version 1 and give them the columns and tables of version 3, without checksums.

CREATE TEMP VIEW study AS SELECT *, NULL AS crc32 FROM main.study;
CREATE TEMP VIEW tombstone AS SELECT *, NULL AS code_salt, NULL AS code_hash, NULL AS crc32 FROM main.tombstone;
CREATE TEMP VIEW person AS SELECT *, NULL AS crc32 FROM main.person;
CREATE TEMP VIEW session AS SELECT *, NULL AS crc32, NULL AS protocol_id FROM main.session;
CREATE TEMP VIEW profile AS SELECT *, NULL AS crc32, '' AS comfort FROM main.profile;
CREATE TEMP VIEW event AS SELECT *, NULL AS crc32 FROM main.event;
CREATE TEMP VIEW stroke AS SELECT *, NULL AS crc32 FROM main.stroke;
CREATE TEMP VIEW judgement AS SELECT *, NULL AS crc32, NULL AS delivered_share FROM main.judgement;
CREATE TEMP VIEW answer AS
SELECT *, NULL AS crc32,
  CASE WHEN form = 'ngt-force-v1' AND session_id IN (SELECT s.id FROM main.session AS s WHERE s.kind <> 'import') THEN 'plain'
    ELSE '' END AS wording
FROM main.answer;
CREATE TEMP VIEW rating AS SELECT *, NULL AS crc32 FROM main.rating;
CREATE TEMP VIEW rule AS SELECT *, NULL AS crc32 FROM main.rule;
CREATE TEMP VIEW recording AS SELECT *, NULL AS crc32 FROM main.recording;
CREATE TEMP VIEW model_version AS SELECT *, NULL AS cleaned_utc_ms, NULL AS crc32 FROM main.model_version;
CREATE TEMP VIEW import_log AS SELECT *, '' AS sha256, NULL AS crc32 FROM main.import_log;
CREATE TEMP VIEW person_code AS
SELECT NULL AS id, NULL AS person_id, NULL AS utc_ms, NULL AS code, NULL AS crc32 WHERE 0;
CREATE TEMP VIEW erasure AS SELECT NULL AS person_id, NULL AS utc_ms WHERE 0;
CREATE TEMP VIEW incident AS
SELECT NULL AS id, NULL AS utc_ms, NULL AS kind, NULL AS detail, NULL AS crc32 WHERE 0;
CREATE TEMP VIEW protocol AS
SELECT NULL AS id, NULL AS version, NULL AS utc_ms, NULL AS author, NULL AS reason, NULL AS text, NULL AS crc32 WHERE 0;
CREATE TEMP VIEW research_key AS SELECT NULL AS place, NULL AS utc_ms, NULL AS hash, NULL AS crc32 WHERE 0;
