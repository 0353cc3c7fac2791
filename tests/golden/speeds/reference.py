"""Reference values for the speed terms, their diagnostics and their bootstrap: prints reference.json.

Independent of the project's code and of its methods: the permutation test enumerates every arrangement, the clusters come
from Bezdek's plain iteration over all samples, the bootstrap concatenates the resampled strokes. Needs numpy.

    python3 reference.py > reference.json
"""
import itertools
import json
import pathlib

import numpy as np

HERE = pathlib.Path(__file__).parent
LEVELS = 3


def twice_j(groups):
    """Twice the Jonckheere-Terpstra statistic: a pair in order counts 2, a tie 1."""
    return sum(
        2 * (a < b) + (a == b)
        for low, high in itertools.combinations(groups, 2)
        for a in low
        for b in high
    )


def arrangements(values, sizes):
    """Every way to deal the places 0..n-1 out to groups of these sizes."""
    if not sizes:
        yield []
        return
    for chosen in itertools.combinations(values, sizes[0]):
        rest = [v for v in values if v not in chosen]
        for tail in arrangements(rest, sizes[1:]):
            yield [chosen] + tail


def trend(groups):
    flat = [x for group in groups for x in group]
    sizes = [len(group) for group in groups]
    observed = twice_j(groups)
    at_least = total = 0
    for dealt in arrangements(tuple(range(len(flat))), sizes):
        total += 1
        at_least += twice_j([[flat[i] for i in group] for group in dealt]) >= observed
    return {"j": observed / 2, "at_least": at_least, "arrangements": total, "p": at_least / total}


def trend_of_three(groups):
    """The same for three larger groups: the second and third are dealt out all at once."""
    flat = np.array([x for group in groups for x in group], dtype=float)
    sizes = [len(group) for group in groups]
    pair = 2 * (flat[:, None] < flat[None, :]) + (flat[:, None] == flat[None, :]).astype(int)
    chosen = list(itertools.combinations(range(sizes[1] + sizes[2]), sizes[1]))
    second = np.zeros((len(chosen), sizes[1] + sizes[2]), dtype=int)
    for row, places in enumerate(chosen):
        second[row, list(places)] = 1
    observed = twice_j(groups)
    at_least = total = 0
    for first in itertools.combinations(range(len(flat)), sizes[0]):
        rest = [i for i in range(len(flat)) if i not in first]
        fixed = pair[np.ix_(first, rest)].sum()
        inner = pair[np.ix_(rest, rest)]
        j = fixed + ((second @ inner) * (1 - second)).sum(axis=1)
        at_least += int((j >= observed).sum())
        total += len(chosen)
    return {"j": observed / 2, "at_least": at_least, "arrangements": total, "p": at_least / total}


def fcm(x, centres, m=2.0):
    v = np.array(centres, dtype=float)
    for _ in range(3000):
        q = (x[:, None] - v[None, :]) ** 2 + 1e-300
        r = q ** (-1 / (m - 1))
        u = (r / r.sum(axis=1, keepdims=True)) ** m
        new = (u * x[:, None]).sum(axis=0) / u.sum(axis=0)
        done = np.abs(new - v).max() < 1e-10
        v = new
        if done:
            break
    return np.sort(v)


def ramps(v, alpha):
    """p and q of each gap for m = 2, by bisection on the membership."""

    def membership(x, k):
        w = 1 / ((x - v) ** 2 + 1e-300)
        return w[k] / w.sum()

    def edge(inside, outside, k):
        for _ in range(200):
            middle = (inside + outside) / 2
            if membership(middle, k) >= alpha:
                inside = middle
            else:
                outside = middle
        return inside

    return [[edge(v[k], v[k + 1], k), edge(v[k + 1], v[k], k + 1)] for k in range(len(v) - 1)]


def pairs(n):
    return n * (n - 1) / 2


def confusion(x, level, v):
    cluster = np.abs(x[:, None] - v[None, :]).argmin(axis=1)
    table = np.array([[int(((level == r) & (cluster == c)).sum()) for c in range(LEVELS)] for r in range(LEVELS)])
    together = sum(pairs(n) for n in table.ravel())
    rows = sum(pairs(n) for n in table.sum(axis=1))
    columns = sum(pairs(n) for n in table.sum(axis=0))
    chance = rows * columns / pairs(len(x))
    return {
        "counts": table.tolist(),
        "adjusted_rand_index": (together - chance) / ((rows + columns) / 2 - chance),
        "accuracy": float(np.trace(table) / len(x)),
    }


def subject(name, start, replicates):
    data = np.loadtxt(HERE.parent / "fcm" / f"{name}.csv", delimiter=",")
    x, level, stroke = data[:, 0], data[:, 1].astype(int), data[:, 2].astype(int)
    groups = [[x[(level == k) & (stroke == s)] for s in np.unique(stroke[level == k])] for k in range(LEVELS)]
    v = fcm(x, start)
    means = [x[level == k].mean() for k in range(LEVELS)]
    sds = [x[level == k].std(ddof=1) for k in range(LEVELS)]
    sizes = [int((level == k).sum()) for k in range(LEVELS)]
    separations = []
    for a in range(LEVELS - 1):
        b = a + 1
        pooled = ((sizes[a] - 1) * sds[a] ** 2 + (sizes[b] - 1) * sds[b] ** 2) / (sizes[a] + sizes[b] - 2)
        separations.append(abs(means[a] - means[b]) / pooled**0.5)
    out = {
        "file": f"{name}.csv",
        "centres": v.tolist(),
        "ramps": {str(alpha): ramps(v, alpha) for alpha in (0.95, 0.9)},
        "level_means": means,
        "level_sds": sds,
        "separations": separations,
        "confusion": confusion(x, level, v),
        "trend": trend([[float(s.mean()) for s in strokes] for strokes in groups]),
    }
    random = np.random.default_rng(1)
    for unit in ("strokes", "samples"):
        drawn = []
        for _ in range(replicates):
            parts = []
            for strokes in groups:
                if unit == "strokes":
                    parts += [strokes[i] for i in random.integers(len(strokes), size=len(strokes))]
                else:
                    pooled = np.concatenate(strokes)
                    parts.append(random.choice(pooled, size=len(pooled)))
            centres = fcm(np.concatenate(parts), v)
            drawn.append(np.concatenate([centres, np.ravel(ramps(centres, 0.95))]))
        low, high = np.percentile(np.array(drawn), [2.5, 97.5], axis=0)
        out[f"interval_over_{unit}"] = {
            "replicates": replicates,
            "centres": [[a, b] for a, b in zip(low[:LEVELS], high[:LEVELS])],
            "ramps_0.95": [[a, b] for a, b in zip(low[LEVELS:], high[LEVELS:])],
        }
    return out


TRENDS = {
    "no ties, 3 x 4": [[3.1, 4.6, 2.2, 5.9], [4.9, 6.3, 5.1, 3.7], [5.5, 7.2, 8.1, 4.2]],
    "ties, 3 x 4": [[1, 2, 2, 3], [2, 3, 3, 4], [3, 4, 4, 5]],
    "all equal": [[7, 7, 7], [7, 7, 7]],
    "falling, unequal sizes": [[9, 8, 7, 6], [5, 5.5], [1, 2, 3]],
    "unequal sizes": [[1.5, 2.5, 0.5, 3.5, 2.0], [3.0, 4.5], [2.25, 5, 6]],
    "four groups": [[1, 4], [2, 3, 6], [5, 6], [7, 5.5]],
}

# Hollander and Wolfe 1999, example 6.2 (knowledge of performance).
KNOWLEDGE = [[40, 35, 38, 43, 44, 41], [38, 40, 47, 44, 40, 42], [48, 40, 45, 43, 46, 44]]

if __name__ == "__main__":
    result = {
        "trends": [{"name": name, "groups": groups, **trend(groups)} for name, groups in TRENDS.items()]
        + [{"name": "knowledge of performance", "groups": KNOWLEDGE, **trend_of_three(KNOWLEDGE)}],
        "subjects": [
            subject("S1_600", [45, 149, 306], 2000),
            subject("S3_600", [55, 112, 190], 200),
            subject("S4_600", [10, 35, 53], 200),
            subject("S1_24k", [46, 149, 311], 400),
        ],
    }
    print(json.dumps(result, indent=1))
