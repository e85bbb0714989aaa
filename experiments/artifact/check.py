#!/usr/bin/python3
"""Holds the numbers of README.md against the results in a folder.  usage: check.py OUT

Prints for each number what README.md says, what OUT has, and whether it is within its tolerance: a factor for times, nothing for counts.
Exit status 1 when a number is not. Results that OUT has not are left out, and named.
"""

import math
import os
import re
import sys

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(SOURCE, "experiments", "report"))

import tables_price  # noqa: E402
import race_data as race  # noqa: E402
from campaign_data import is_exact  # noqa: E402
from report_data import geometric_mean, read, wrong_in  # noqa: E402
from study_data import Study  # noqa: E402

# Factors by which times may differ on another processor: of a mean over courses, and of the least and the most of one course.
MEAN, EXTREME = 1.5, 2.5
SUBJECTS = {"tetracone, exact": race.OURS, "the same tree in double": race.IN_DOUBLE, "the paper's tree, tuned, in double": race.PAPER,
            "the paper's tree as published, in double": race.PUBLISHED, "FCL OBBRSS": race.FCL, "ODE trimesh": "ODE trimesh",
            "Bullet GImpact": "Bullet GImpact", "CGAL, EPICK": race.EPICK, "CGAL, EPECK": race.EPECK}
CONTACTS = {"motion": ("circular", "contour"), "shared face, edge, vertex": ("shared face", "shared edge", "shared vertex"),
            "the same, poses rounded": ("shared face (rounded poses)", "shared edge (rounded poses)", "shared vertex (rounded poses)"),
            "one ulp apart": ("gap of one ulp",)}


def spans(text):
    """The ranges of a text such as "0 to 34, 8 to 14": a number by itself is a range of one."""
    return [(float(found[0]), float(found[-1])) for part in text.split(",") if (found := re.findall(r"\d+(?:\.\d+)?", part))]


def span(values):
    values = [float(v) for v in values]
    return min(values), max(values)


def claims(readme, folder):
    """Yields what each number of the README is of, the factor by which it may differ, the ranges said, and those found. Numbers without a result in the
    folder are left out."""
    rows = {cells[0]: cells[1:] for cells in ([cell.strip() for cell in line.strip("|").split("|")] for line in readme.split("\n") if line.startswith("| "))}
    peers, study = race.rows_of(folder, "peers"), Study(folder)
    if peers:
        motion, near = race.in_motion(peers), [r for r in peers if race.is_near(r)]
        surface = [r for r in motion if r["question"] == "surface"]
        for label, subject in SUBJECTS.items():
            time, extremes, *counts = rows[label]
            ratios = list(race.against(surface, subject, race.OURS).values())
            yield f"time, {label}", MEAN, spans(time), [(geometric_mean(ratios),) * 2]
            if extremes:
                yield f"least .. most, {label}", EXTREME, spans(extremes), [span(ratios)]
            for where, mine, said in zip(("motion", "near contact"), (motion, near), counts):
                found = race.wrong(mine, subject), race.answers(mine, subject)
                yield f"wrong and asked, {label}, {where}", 1, spans(said.replace(" of ", ", ")), [(n, n) for n in found]
        prices = race.against(motion, race.OURS, race.IN_DOUBLE).values()
        yield "over double, motion", MEAN, spans(rows["motion"][0]), [(geometric_mean(prices),) * 2]
    if study:
        prices = {p["contact"]: p for p in tables_price.prices(study) if p["question"] == "surface"}
        for label, contacts in CONTACTS.items():
            mine = [prices[contact] for contact in contacts]
            if label != "motion":  # which the race says
                yield f"over double, {label}", EXTREME, spans(rows[label][0]), [span(p["over_double"] for p in mine)]
            yield f"over FCL, {label}", EXTREME, spans(rows[label][1]), [span(p["over_fcl"] for p in mine)]
            yield f"wrong, {label}: double, FCL", 1, spans(rows[label][2]), [span(p[key] for p in mine) for key in ("wrong_double", "wrong_fcl")]
    tables = os.path.join(folder, "tables")
    if families := read(os.path.join(tables, "verify_families.csv")):
        yield "families of cases", 1, spans(re.search(r"(\d+) families", readme)[1]), [(len(families),) * 2]
    if subjects := read(os.path.join(tables, "verify_subjects.csv")):
        yield "wrong answers of exact subjects", 1, [(0, 0)], [(sum(wrong_in(r) for r in subjects if is_exact(r["subject"])),) * 2]


def is_within(said, found, factor):
    """Whether the ends of the ranges differ by this factor at most; counts are equal."""
    return len(said) == len(found) and all(a == b or (factor > 1 and a > 0 and b > 0 and max(a / b, b / a) <= factor)
                                           for ours, theirs in zip(said, found) for a, b in zip(ours, theirs))


def text(ranges):
    return ", ".join(f"{low:.4g}" if low == high else f"{low:.5g} .. {high:.5g}" for low, high in ranges)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check.py OUT")
    folder, bad = sys.argv[1], 0
    with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
        readme = file.read()
    print(f"{'number':66} {'README.md':>20} {'here':>20}")
    for name, factor, said, found in claims(readme, folder):
        good = is_within(said, found, factor)
        bad += not good
        tolerance = "equal" if factor == 1 else f"within a factor of {factor}"
        print(f"{name:66} {text(said):>20} {text(found):>20}   {'' if good else 'NOT '}{tolerance}")
    for name in ("peers.csv", "study.csv", "tables/verify_families.csv", "tables/verify_subjects.csv"):
        if not os.path.exists(os.path.join(folder, name)):
            print(f"left out: {os.path.join(folder, name)} is not there")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
