#!/usr/bin/env python3
"""A subject of triangle against triangle: the interval test of Moeller, Journal of Graphics Tools 2, 1997, in plain double. Two triangles
of one plane are parted by an edge, if at all. Triangles without a plane are not foreseen: the method is wrong there, as it is in rounding."""

import json
import sys
import time
from fractions import Fraction


def sub(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def normal(t):
    return cross(sub(t[1], t[0]), sub(t[2], t[0]))


def parted(s, t, n):
    """True when an edge of s has t strictly on its outer side, in the plane with the normal n of s."""
    edges = ((s[k], sub(s[(k + 1) % 3], s[k])) for k in range(3))
    return any(all(dot(cross(along, sub(p, start)), n) < 0 for p in t) for start, along in edges)


def interval(t, heights, line):
    """Where t meets the planes' common line; `heights` are those of its corners over the other plane."""
    at = [dot(p, line) for p in t]
    met = [x for x, h in zip(at, heights) if h == 0]
    for j, k in ((0, 1), (1, 2), (2, 0)):
        if heights[j] * heights[k] < 0:
            met.append(at[j] + (at[k] - at[j]) * heights[j] / (heights[j] - heights[k]))
    return min(met, default=0), max(met, default=0)


def meet(s, t):
    n, m = normal(s), normal(t)
    of_t, of_s = [dot(n, sub(p, s[0])) for p in t], [dot(m, sub(p, t[0])) for p in s]
    if any(all(h > 0 for h in side) or all(h < 0 for h in side) for side in (of_s, of_t)):
        return False
    if not any(of_s) or not any(of_t):
        return not parted(s, t, n) and not parted(t, s, m)
    line = cross(n, m)
    (low_s, high_s), (low_t, high_t) = interval(s, of_s, line), interval(t, of_t, line)
    return low_s <= high_t and low_t <= high_s


def points(triangle):
    return [tuple(float(Fraction(x)) for x in p) for p in triangle]


print(json.dumps({"hello": 1, "name": "Interval test", "version": "1", "precision": "float64", "questions": ["triangles"]}), flush=True)
for words in sys.stdin:
    message = json.loads(words)
    if "ask" not in message:
        continue
    told = {"answer": None}
    if message["question"] == "triangles":
        pair = points(message["triangle_a"]), points(message["triangle_b"])
        start = time.perf_counter_ns()
        told = {"answer": int(meet(*pair)), "ns": time.perf_counter_ns() - start}
    print(json.dumps({"ask": message["ask"], **told}), flush=True)
