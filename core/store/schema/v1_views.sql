-- Version 1 of the study file, views: the records that count, without those that were corrected. Of two corrections of one
-- record, which only a merge can bring together, the later one counts.

CREATE VIEW profile_current AS
SELECT * FROM profile AS a
WHERE NOT EXISTS (SELECT 1 FROM profile AS b WHERE b.supersedes = a.id)
  AND NOT EXISTS (SELECT 1 FROM profile AS b WHERE b.supersedes = a.supersedes AND (b.utc_ms, b.id) > (a.utc_ms, a.id));

CREATE VIEW event_current AS
SELECT * FROM event AS a
WHERE NOT EXISTS (SELECT 1 FROM event AS b WHERE b.supersedes = a.id)
  AND NOT EXISTS (SELECT 1 FROM event AS b WHERE b.supersedes = a.supersedes AND (b.utc_ms, b.id) > (a.utc_ms, a.id));

CREATE VIEW stroke_current AS
SELECT * FROM stroke AS a
WHERE NOT EXISTS (SELECT 1 FROM stroke AS b WHERE b.supersedes = a.id)
  AND NOT EXISTS (SELECT 1 FROM stroke AS b WHERE b.supersedes = a.supersedes AND (b.utc_ms, b.id) > (a.utc_ms, a.id));

CREATE VIEW judgement_current AS
SELECT * FROM judgement AS a
WHERE NOT EXISTS (SELECT 1 FROM judgement AS b WHERE b.supersedes = a.id)
  AND NOT EXISTS (SELECT 1 FROM judgement AS b WHERE b.supersedes = a.supersedes AND (b.utc_ms, b.id) > (a.utc_ms, a.id));

CREATE VIEW answer_current AS
SELECT * FROM answer AS a
WHERE NOT EXISTS (SELECT 1 FROM answer AS b WHERE b.supersedes = a.id)
  AND NOT EXISTS (SELECT 1 FROM answer AS b WHERE b.supersedes = a.supersedes AND (b.utc_ms, b.id) > (a.utc_ms, a.id));

CREATE VIEW rating_current AS
SELECT * FROM rating AS a
WHERE NOT EXISTS (SELECT 1 FROM rating AS b WHERE b.supersedes = a.id)
  AND NOT EXISTS (SELECT 1 FROM rating AS b WHERE b.supersedes = a.supersedes AND (b.utc_ms, b.id) > (a.utc_ms, a.id));

CREATE VIEW rule_current AS
SELECT * FROM rule AS a
WHERE NOT EXISTS (SELECT 1 FROM rule AS b WHERE b.supersedes = a.id)
  AND NOT EXISTS (SELECT 1 FROM rule AS b WHERE b.supersedes = a.supersedes AND (b.utc_ms, b.id) > (a.utc_ms, a.id));

-- All records of all sessions in their order.
CREATE VIEW session_record AS
SELECT 'profile' AS kind, id, session_id, sequence, utc_ms, supersedes FROM profile
UNION ALL SELECT 'event' AS kind, id, session_id, sequence, utc_ms, supersedes FROM event
UNION ALL SELECT 'stroke' AS kind, id, session_id, sequence, utc_ms, supersedes FROM stroke
UNION ALL SELECT 'judgement' AS kind, id, session_id, sequence, utc_ms, supersedes FROM judgement
UNION ALL SELECT 'answer' AS kind, id, session_id, sequence, utc_ms, supersedes FROM answer
UNION ALL SELECT 'rating' AS kind, id, session_id, sequence, utc_ms, supersedes FROM rating
UNION ALL SELECT 'rule' AS kind, id, session_id, sequence, utc_ms, supersedes FROM rule;
