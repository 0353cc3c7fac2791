-- Version 1 of the study file, views: the records that count. Merges bring chains of corrections of both sides together, so of
-- each record that was given first the latest last correction counts, by time and then by id. UNION ends a ring of
-- corrections, which only a change by hand can make: nothing of it counts.

CREATE VIEW profile_current AS
SELECT * FROM profile AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM profile AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM profile AS c JOIN profile AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN profile AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN profile AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM profile AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW event_current AS
SELECT * FROM event AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM event AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM event AS c JOIN event AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN event AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN event AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM event AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW stroke_current AS
SELECT * FROM stroke AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM stroke AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM stroke AS c JOIN stroke AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN stroke AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN stroke AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM stroke AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW judgement_current AS
SELECT * FROM judgement AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM judgement AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM judgement AS c JOIN judgement AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN judgement AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN judgement AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM judgement AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW answer_current AS
SELECT * FROM answer AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM answer AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM answer AS c JOIN answer AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN answer AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN answer AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM answer AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW rating_current AS
SELECT * FROM rating AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM rating AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM rating AS c JOIN rating AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN rating AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN rating AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM rating AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

CREATE VIEW rule_current AS
SELECT * FROM rule AS a
WHERE (a.supersedes IS NULL AND NOT EXISTS (SELECT 1 FROM rule AS b WHERE b.supersedes = a.id))
   OR (a.supersedes IS NOT NULL AND a.id IN (
     WITH RECURSIVE chain (root, id) AS (
       SELECT DISTINCT r.id, r.id FROM rule AS c JOIN rule AS r ON r.id = c.supersedes
       WHERE c.supersedes IS NOT NULL AND r.supersedes IS NULL
       UNION
       SELECT chain.root, c.id FROM chain JOIN rule AS c ON c.supersedes = chain.id)
     SELECT id FROM (
       SELECT l.id, row_number() OVER (PARTITION BY chain.root ORDER BY l.utc_ms DESC, l.id DESC) AS place
       FROM chain JOIN rule AS l ON l.id = chain.id
       WHERE NOT EXISTS (SELECT 1 FROM rule AS b WHERE b.supersedes = l.id))
     WHERE place = 1));

-- Participants with the code that counts.
CREATE VIEW person_current AS
SELECT p.id, coalesce((SELECT c.code FROM person_code AS c WHERE c.person_id = p.id
                       ORDER BY c.utc_ms DESC, c.id DESC LIMIT 1), p.code) AS code, p.simulated
FROM person AS p;

-- All records of all sessions in their order.
CREATE VIEW session_record AS
SELECT 'profile' AS kind, id, session_id, sequence, utc_ms, supersedes FROM profile
UNION ALL SELECT 'event' AS kind, id, session_id, sequence, utc_ms, supersedes FROM event
UNION ALL SELECT 'stroke' AS kind, id, session_id, sequence, utc_ms, supersedes FROM stroke
UNION ALL SELECT 'judgement' AS kind, id, session_id, sequence, utc_ms, supersedes FROM judgement
UNION ALL SELECT 'answer' AS kind, id, session_id, sequence, utc_ms, supersedes FROM answer
UNION ALL SELECT 'rating' AS kind, id, session_id, sequence, utc_ms, supersedes FROM rating
UNION ALL SELECT 'rule' AS kind, id, session_id, sequence, utc_ms, supersedes FROM rule;
