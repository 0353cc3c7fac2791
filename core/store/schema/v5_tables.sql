-- Version 5 of the study file, tables. For people: docs/study-file.md.
-- Never edit this file once a study was recorded with it: the next change is the next numbered step.
-- The guard that refuses every change is taken down here and put up again by v5_guards.sql.

DROP TRIGGER answer_keep;

-- The id of the words in which the item was asked: plain, published; empty: not known.
ALTER TABLE answer ADD COLUMN wording TEXT NOT NULL DEFAULT '';

-- The participant's screens have asked in plain words from the first version on; how a table was asked that came from outside is
-- not known. A row that did not fit its checksum before does not fit it after.
UPDATE answer SET wording = 'plain'
WHERE form = 'ngt-force-v1' AND session_id IN (SELECT id FROM session WHERE kind <> 'import');
UPDATE answer SET crc32 = record_crc32('answer', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, form, form_version, item, position, status, value, response_s, wording)
WHERE crc32 = record_crc32('answer', id, session_id, sequence, utc_ms, monotonic_ns, entered_by,
  supersedes, reason, form, form_version, item, position, status, value, response_s);
