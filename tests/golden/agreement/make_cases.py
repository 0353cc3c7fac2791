"""Makes questionnaires up and has other programs measure their agreement: writes cases.json.

Needs Debian's python3-statsmodels (Fleiss' kappa), python3-nltk (Krippendorff's alpha) and python3-scipy (Friedman's
statistic, from which Kendall's W follows). The tests read cases.json only; they need no Python.
"""
import json
import random
import sys

import nltk
import scipy
import statsmodels
from nltk.metrics import agreement
from scipy.stats import friedmanchisquare
from statsmodels.stats.inter_rater import fleiss_kappa


def answers(rng, units, raters, categories, noise, missing):
    """Units have a true place on the scale, raters a bias and noise; an answer may be missing."""
    bias = [rng.gauss(0, 0.4) for _ in range(raters)]
    table = []
    for _ in range(units):
        truth = rng.uniform(0, categories - 1)
        row = [min(categories - 1, max(0, round(truth + b + rng.gauss(0, noise)))) for b in bias]
        table.append([None if rng.random() < missing else answer for answer in row])
    return table


def kappa(table, categories):
    counts = [[row.count(c) for c in range(categories)] for row in table]
    return None if any(None in row for row in table) else float(fleiss_kappa(counts))


def alphas(table, categories):
    data = [(f"rater {r}", f"unit {u}", answer)
            for u, row in enumerate(table) for r, answer in enumerate(row) if answer is not None]
    paired = [answer for row in table if len(row) - row.count(None) > 1 for answer in row if answer is not None]
    n = [paired.count(c) for c in range(categories)]

    def nominal(a, b):
        return 0.0 if a == b else 1.0

    def ordinal(a, b):
        low, high = min(a, b), max(a, b)
        return (sum(n[low:high + 1]) - (n[low] + n[high]) / 2) ** 2

    def interval(a, b):
        return float(a - b) ** 2

    return {name: agreement.AnnotationTask(data=data, distance=distance).alpha()
            for name, distance in [("nominal", nominal), ("ordinal", ordinal), ("interval", interval)]}


def concordance(table):
    complete = [row for row in table if None not in row]
    if len(complete) < 3 or len(table[0]) < 3:
        return None
    friedman = friedmanchisquare(*complete)  # the units are its treatments, the raters its blocks
    w = friedman.statistic / (len(table[0]) * (len(complete) - 1))
    return {"w": float(w), "chi_square": float(friedman.statistic), "p": float(friedman.pvalue), "units": len(complete)}


# One split of the paper's Table 2 over four persons whose terms never fall; who is who is arbitrary. One string for each
# person, the categories at 0.1 to 1.1 N.
TABLE_2 = ["12344444444", "01223334444", "00112233344", "00012222334"]


def main():
    rng = random.Random(20261121)
    cases = []
    split = [[int(person[step]) for person in TABLE_2] for step in range(11)]
    cases.append({"name": "Table 2", "categories": 5, "ratings": split, "fleiss_kappa": kappa(split, 5),
                  "krippendorff_alpha": alphas(split, 5), "kendall": concordance(split)})
    for units, raters, categories, noise, missing in [
            (45, 4, 5, 0.6, 0.0), (45, 4, 5, 0.6, 0.1), (45, 4, 5, 1.5, 0.0), (45, 3, 5, 0.3, 0.3), (11, 4, 5, 0.4, 0.0),
            (11, 6, 5, 0.5, 0.25), (45, 20, 5, 0.8, 0.0), (45, 20, 5, 0.8, 0.02), (30, 3, 3, 0.5, 0.0),
            (30, 5, 2, 0.4, 0.15), (60, 8, 7, 1.0, 0.05), (9, 2, 5, 0.5, 0.0), (12, 3, 9, 4.0, 0.0), (20, 5, 5, 9.0, 0.4)]:
        table = answers(rng, units, raters, categories, noise, missing)
        cases.append({"categories": categories, "ratings": table, "fleiss_kappa": kappa(table, categories),
                      "krippendorff_alpha": alphas(table, categories), "kendall": concordance(table)})
    versions = {"python": sys.version.split()[0], "statsmodels": statsmodels.__version__, "nltk": nltk.__version__,
                "scipy": scipy.__version__}
    lines = ",\n".join("  " + json.dumps(case) for case in cases)
    with open("cases.json", "w", encoding="utf-8") as out:
        out.write('{"made_with": %s,\n "cases": [\n%s\n]}\n' % (json.dumps(versions), lines))


main()
