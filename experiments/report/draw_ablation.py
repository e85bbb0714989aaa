#!/usr/bin/python3
"""OUT/ablation.csv -> OUT/ablation.svg, OUT/ablation.pdf, and the table of steps on the terminal.  usage: draw_ablation.py OUT"""

import matplotlib.pyplot as plt

from race_data import BLUE, FCL, GREEN, GREY, LAST_FRAME, OURS, VERMILION, against, answers, fitness, judged, read, save, wrong
from report_data import geometric_mean

LIMIT = 3  # what the paper's tree may take, of FCL's time
AS_PUBLISHED = "step 2 larger node first"
FASTEST = "step 13 eight a node"


def cuts(rows):
    """How many of the cuts of the fast tree are planes through the origin, of every object."""
    print("cuts of the fast tree by planes through the origin, the sides of cones (parts of more than 64 elements try them):")
    seen = {}
    for r in rows:
        if r["subject"] == FASTEST:
            seen[r["object"], r["triangles"]] = r
    for (object_, triangles), r in seen.items():
        print(f'  {object_:8}{triangles:6.0f} triangles: {r["cuts_into_cones"]:.0f} of {r["cuts"]:.0f} cuts, {r["cuts_into_cones"] / r["cuts"]:.1%}; '
              f'of the {r["cuts_that_tried_cones"]:.0f} that tried them {r["cuts_into_cones"] / max(r["cuts_that_tried_cones"], 1):.1%}')


def over(rows, subject, other, large, object_=None):
    """The geometric mean over the trajectories of an object, or of those of a size."""
    return geometric_mean(v for c, v in against(rows, subject, other).items() if (c[2] > 2000) == large and object_ in (None, c[1]))


def best_tuned(rows, large):
    tuned = [s for s in dict.fromkeys(r["subject"] for r in rows) if s.startswith("tuned")]
    return min(tuned, key=lambda s: over(rows, s, FCL, large))


def bars(axis, rows, subjects, other, large, title):
    values = [over(rows, s, other, large) for s in subjects]
    colours = [GREEN if s in (OURS, LAST_FRAME) or s.startswith("fast ") else BLUE if s.startswith("tuned") else VERMILION for s in subjects]
    axis.hlines(range(len(subjects)), 1, values, color=colours, lw=1.4)
    axis.scatter(values, range(len(subjects)), color=colours, s=14, zorder=3)
    for k, v in enumerate(values):
        axis.annotate(f"{v:.3g}", (v, k), xytext=(5 if v >= 1 else -5, 0), textcoords="offset points", va="center", ha="left" if v >= 1 else "right", fontsize=6.5)
    axis.axvline(1, color=GREY, lw=0.8)
    axis.set_xscale("log")
    low, high = axis.get_xlim()
    axis.set_xlim(low / (high / low) ** 0.12 / 1.5, high * (high / low) ** 0.12 * 1.5)
    axis.set_ylim(len(subjects) - 0.4, -0.6)
    axis.set_title(title, loc="left")
    axis.grid(axis="x")


def name(subject):
    if subject.startswith("step"):
        return subject.split(" ", 2)[2]
    return "the fast tree" if subject == OURS else "the fast tree, last frame" if subject == LAST_FRAME else subject


def draw(out, rows, steps, changes, fast):
    figure, axes = plt.subplots(3, 2, figsize=(7.2, 8), sharey="row", height_ratios=[len(steps), len(changes), len(fast)])
    figure.subplots_adjust(hspace=0.45, wspace=0.08)
    for column, large in enumerate([False, True]):
        what = " and ".join(dict.fromkeys(f'{r["object"]} {r["triangles"]:.0f}' for r in rows if (r["triangles"] > 2000) == large))
        some = [s for s in steps if not s.startswith("tuned")]
        bars(axes[0, column], rows, some, FCL, large, f"time over FCL's, {what}")
        bars(axes[1, column], rows, changes, AS_PUBLISHED, large, f"time over the published, {what}")
        bars(axes[2, column], rows, fast, FASTEST, large, f"time over the fast tree's, {what}")
    axes[2, 0].set_yticks(range(len(fast)), [f.split(" ", 1)[1] for f in fast])
    axes[0, 0].set_yticks(range(len(some)), [name(s) for s in some])
    axes[1, 0].set_yticks(range(len(changes)), changes)
    for axis in axes.flat:
        axis.tick_params(axis="y", length=0)
    save(figure, out, "ablation")


def summary(rows, steps, changes, fast):
    objects = list(dict.fromkeys((r["object"], r["triangles"]) for r in rows))
    of = {(r["subject"], r["object"], r["scenario"]): r for r in rows}

    def line(subject, other):
        values = "".join(f'{over(rows, subject, other, t > 2000, o):11.3g}' for o, t in objects)
        contours = [of[subject, o, "contour"] for o, _ in objects if (subject, o, "contour") in of]
        copies = " ".join(f'{r["copies"]:5.1f}' for r in contours if r["copies"] is not None)
        print(f"  {name(subject):28}{values}   {copies:24} {wrong(rows, subject):4d} of {answers(rows, subject)}")

    print(f'{"time over FCL (both trajectories)":30}' + "".join(f"{o[:6]:>6} {t / 1000:.2g}k" for o, t in objects) + "   copies of a triangle     wrong")
    for subject in steps:
        line(subject, FCL)
    print("one choice changed: time over the published method's")
    for subject in changes:
        line(subject, AS_PUBLISHED)
    print("one choice of the fast tree's changed: time over its own")
    for subject in fast:
        line(subject, FASTEST)
    cuts(rows)
    best = best_tuned(rows, False)
    small = {r["object"]: r["star_share"] for r in rows if r["triangles"] < 2000}
    print(f"paper's tree in double within its own parameters, {best}, on 760 triangles, at most {LIMIT} times FCL where star-shaped:")
    for object_, share in small.items():
        value = over(rows, best, FCL, False, object_)
        verdict = ("kept" if value <= LIMIT else "NOT kept") if share == 1 else f"not asked: {100 * share:.0f} % of its faces are turned away from its centroid"
        print(f"  {object_:8}{value:5.2f} times FCL: {verdict}")
    print("  " + judged(rows))
    print("  " + fitness(rows))


def main():
    out, rows = read("ablation")
    subjects = list(dict.fromkeys(r["subject"] for r in rows))
    if FCL not in subjects:
        raise SystemExit("ablation.csv has no row of FCL; expected a program built with libfcl-dev")
    steps = [s for s in subjects if s.startswith("step")]
    steps = steps[:3] + [best_tuned(rows, False)] + steps[3:] + [s for s in (OURS, LAST_FRAME) if s in subjects]
    changes = [s for s in subjects if s.startswith("with")]
    fast = [s for s in subjects if s.startswith("fast ")]
    draw(out, rows, steps, changes, fast)
    summary(rows, steps, changes, fast)


if __name__ == "__main__":
    main()
