"""What the sections of the report share: rows of CSV files, intervals, and numbers as text."""

import csv
import math
import os
import random
from collections import defaultdict


def read(path):
    """The rows of a CSV file; none where it is not there."""
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def by(rows, *keys):
    """The rows in groups of equal values of these columns, in the order of their first rows."""
    groups = defaultdict(list)
    for row in rows:
        groups[tuple(row[k] for k in keys)].append(row)
    return groups


def distinct(values):
    return list(dict.fromkeys(values))


def wilson(wrong, n, z=1.959964):
    """The 95 % interval of a rate of `wrong` in `n`."""
    if n == 0:
        return 0.0, 1.0
    p, zz = wrong / n, z * z
    centre, half = (p + zz / (2 * n)) / (1 + zz / n), z / (1 + zz / n) * math.sqrt(p * (1 - p) / n + zz / (4 * n * n))
    return (0.0 if wrong == 0 else max(0.0, centre - half)), (1.0 if wrong == n else min(1.0, centre + half))


def geometric_mean(values):
    """The geometric mean of positive numbers; NaN of none."""
    values = list(values)
    return math.exp(sum(map(math.log, values)) / len(values)) if values else math.nan


def interval(values, resamples=2000):
    """The 95 % interval of the geometric mean of positive numbers, by resampling them, always alike; (None, None) of fewer than two."""
    logs = [math.log(v) for v in values]
    if len(logs) < 2:
        return None, None
    chance = random.Random(1)
    means = sorted(sum(chance.choices(logs, k=len(logs))) / len(logs) for _ in range(resamples))
    return math.exp(means[resamples // 40]), math.exp(means[-1 - resamples // 40])


def percent(x):
    return "0" if x == 0 else f"{100 * x:.2g} %" if x < 0.1 else f"{100 * x:.0f} %"


def rounded(x, digits=3):
    """A number of so many digits, or a whole one: 0.0123, 1.3, 1,310."""
    return f"{x:.{digits}g}" if abs(x) < 10 ** digits - 0.5 else f"{x:,.0f}"


def times(x):
    """A ratio: 0.83, 5.2, 37."""
    return rounded(x, 2)


def duration(ns):
    for unit, size in (("ns", 1), ("µs", 1e3), ("ms", 1e6), ("s", 1e9)):
        if ns < 999.5 * size or unit == "s":
            return f"{rounded(ns / size)} {unit}"


def share(wrong, n):
    """A count of wrong answers as the statement that it is: none in n is a bound, not a zero."""
    low, high = wilson(wrong, n)
    return f"0 of {n:,.0f} (&lt; {percent(high)})" if wrong == 0 else f"{wrong:,.0f} of {n:,.0f} ({percent(wrong / n)})"


def wrong_in(row):
    """Wrong answers of a row of the campaign's tables: invented, missed, or none given."""
    return int(row["false_positives"]) + int(row["false_negatives"]) + int(row["failures"])


def kernel_of(subject):
    """"double" of "double-eps=1e-12 brute" is "double-eps=1e-12"; a peer is its own kernel."""
    words, method = subject.split(" "), method_of(subject)
    return subject if method == "peer" else " ".join(words[:words.index(method)])


def short(subject):
    """A subject's name where room is scarce."""
    return subject.replace("double-eps=rel:1e-12", "double rel. ε").replace("double-eps=1e-12", "double ε").replace("CGAL RMCD", "CGAL")


def method_of(subject):
    """"tree" of "adaptive tree" and of "adaptive tree remembering"."""
    return next((word for word in subject.split(" ") if word in ("tree", "tuned", "paper", "brute")), "peer")
