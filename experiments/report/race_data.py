"""What the figures of the speed experiments share: their rows, means, and how a figure is kept."""

import math
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from report_data import geometric_mean, interval
from report_data import read as read_csv
from report_style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION, box_of, set_style  # noqa: F401

OURS, FCL, PAPER, PUBLISHED = "tetracone", "FCL OBBRSS", "tetra-tree tuned in double", "tetra-tree as published in double"
LAST_FRAME, IN_DOUBLE, EPICK, EPECK = "tetracone with last frame", "tetracone in double", "CGAL RMCD EPICK", "CGAL RMCD EPECK"
COLOURS = {OURS: GREEN, LAST_FRAME: "#005a41", IN_DOUBLE: "#7fc4a4", FCL: INK, PAPER: VERMILION, PUBLISHED: "#8c3a00", EPICK: SKY, EPECK: BLUE, "Bullet GImpact": ORANGE, "ODE trimesh": PURPLE}
SHORT = {LAST_FRAME: "with last frame", IN_DOUBLE: "in double", FCL: "FCL", PAPER: "tetra-tree, double", EPICK: "EPICK"}
TEXT = {"scenario", "object", "question", "subject", "version", "compiler", "flags", "processor", "again", "fcl", "estimator"}


def rows_of(folder, name):
    """The rows of FOLDER/NAME.csv: numbers as numbers, None where a field is empty; no rows where there is no such file."""
    return [{k: v if k in TEXT else float(v) if v else None for k, v in row.items()} for row in read_csv(os.path.join(folder, name + ".csv"))]


def read(name):
    """The folder given on the command line and the rows of FOLDER/NAME.csv."""
    if len(sys.argv) != 2:
        sys.exit(f"usage: {os.path.basename(sys.argv[0])} OUT")
    rows = rows_of(sys.argv[1], name)
    if not rows:
        sys.exit(f"{os.path.join(sys.argv[1], name + '.csv')}: no such file; expected the results of tetracone experiment {name}")
    set_style()
    return sys.argv[1], rows


def is_near(row):
    """Near contact: a scenario of bodies that touch, or nearly, in each of its poses; else bodies move past one another."""
    return row["degenerate"] not in (0, "0")


def in_motion(rows):
    return [r for r in rows if not is_near(r)]


def contacts_of(rows):
    """What share of the courses in motion collides, and which of them never do: their times are of bodies apart alone."""
    courses = {}
    for r in in_motion(rows):
        poses, hits = (int(r.get(new) or r[old]) for new, old in (("course_poses", "poses"), ("course_collisions", "collisions")))
        courses.setdefault((*course(r)[:4], r["question"]), []).append((poses, hits))
    courses = {name: max(found) for name, found in courses.items()}
    parts = []
    for scenario in dict.fromkeys(name[0] for name in courses):
        mine = [found for name, found in courses.items() if name[0] == scenario]
        poses, hits = (sum(found[k] for found in mine) for k in (0, 1))
        parts.append(f"{scenario} {hits} of {poses} poses ({100 * hits / poses:.2g} %)")
    apart = [" ".join(f"{part:g}" if isinstance(part, float) else str(part) for part in name) for name, (_, hits) in courses.items() if hits == 0]
    return ("courses in motion that collide: " + ", ".join(parts), apart)


def fitness(rows):
    """A line or two: whether the ratios of these courses may be compared with those of longer ones."""
    shares, apart = contacts_of(rows)
    if not apart:
        return shares + "; all courses have contacts"
    return shares + f"; too small to be compared with longer runs, since no pose collides: {', '.join(apart)}"


def with_interval(values, digits=3):
    """The geometric mean over courses, (its 95 % interval), by resampling these."""
    values = list(values)
    low, high = interval(values)
    return f"{geometric_mean(values):.{digits}g}" + (f" ({low:.{digits}g} .. {high:.{digits}g})" if low else "")


def course(row):
    """What all subjects of a race share."""
    return row["scenario"], row["object"], row["triangles"], row["ratio"], row["question"]


def against(rows, subject, other, value="mean_ns"):
    """{course: value of subject / value of other} where both ran; times are compared on the poses that both were asked."""
    of = {(course(r), r["subject"]): r for r in rows}
    return {c: ratio(of[c, subject], of[c, other], value) for c, s in of if s == subject and (c, other) in of}


def ratio(row, other, value):
    if value != "mean_ns" or row["poses"] == other["poses"]:
        return row[value] / other[value]
    ruler = "tetracone_same_poses_ns" if other["subject"] == OURS else "fcl_same_poses_ns"
    over = row["same_poses_ns"] / row[ruler]
    return over if other["subject"] in (OURS, FCL) else over / (other["same_poses_ns"] / other[ruler])


def wrong(rows, subject):
    return sum(int(r["false_positives"] + r["false_negatives"]) for r in rows if r["subject"] == subject)


def answers(rows, subject):
    return sum(int(r["poses"]) for r in rows if r["subject"] == subject)


def exponent(xs, ys):
    """The slope of log y over log x, by least squares."""
    xs, ys = [math.log(x) for x in xs], [math.log(y) for y in ys]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    spread = sum((a - x) ** 2 for a in xs)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / spread if spread else math.nan


def judged(rows):
    """One line: how many answers were held against the truth."""
    n, asked = (sum(int(r.get(key) or 0) for r in rows) for key in ("judged_by_truth", "poses"))
    return f"answers: {n} of {asked} judged by the truth in rationals"


def save(figure, out, name):
    """Both files are whole or the old ones."""
    box = box_of(figure, 0.1)
    for ending in ("svg", "pdf"):
        file = os.path.join(out, f"{name}.{ending}")
        figure.savefig(file + ".part", format=ending, bbox_inches=box, metadata={"Date" if ending == "svg" else "CreationDate": None})
        os.replace(file + ".part", file)
    plt.close(figure)
