#!/usr/bin/env python3
"""example.py [ANSWERS.csv]: answers every case by a toy, for score.py. Put your library in its place."""

import csv
import sys

from tetracone_dataset import cases


def placed(vertices, pose):
    """The images, rounded to doubles."""
    rows = [[float(x) for x in row] for row in pose]
    return [tuple(sum(r[k] * p[k] for k in range(3)) + r[3] for r in rows) for p in vertices]


def collide(a, b):
    """Whether the boxes of the two bodies meet."""
    return all(min(p[i] for p in a) <= max(p[i] for p in b) and min(p[i] for p in b) <= max(p[i] for p in a) for i in range(3))


with open(sys.argv[1] if len(sys.argv) > 1 else "answers.csv", "w", newline="") as file:
    out = csv.writer(file, lineterminator="\n")
    out.writerow(["id", "question", "answer"])
    for case in cases():
        answer = collide(placed(case.a[0], case.pose_a), placed(case.b[0], case.pose_b))
        out.writerow([case.id, "solid", int(answer)])
