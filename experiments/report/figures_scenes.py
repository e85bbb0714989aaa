"""Scenes of many bodies: what a budget decides of a frame, and what frames ask for of all that could be made."""

import matplotlib.pyplot as plt
from matplotlib.ticker import PercentFormatter

from report_data import by, percent
from report_style import GREEN, GREY, ORANGE, VERMILION, WIDTH
from tables_queries import rows_and_source


def numbers(rows, column):
    return [float(r[column]) for r in rows]


def budget(page):
    rows, source = rows_and_source(page, "budget", "How many pairs of a frame does a budget of time decide, and how near are the others?")
    if not rows:
        return
    x = sorted(set(numbers(rows, "budget_of_a_frame")))
    fig, axes = plt.subplots(1, 3, figsize=(WIDTH, 2.2))
    for (kind,), mine in by(rows, "frames_asked").items():
        colour, name = (GREEN, "each frame alone") if kind == "alone" else (ORANGE, "frames in a row")
        left = [r for r in mine if int(r["undecided"])]
        for axis, some, column, unit in ((axes[0], mine, "share_decided", 100), (axes[1], mine, "frame_of_a_frame", 1), (axes[2], left, "mean_farthest_in_sizes", 1)):
            axis.plot(numbers(some, "budget_of_a_frame"), [unit * y for y in numbers(some, column)], "o-", color=colour, ms=2.5, lw=1, label=name)
    axes[0].set_ylim(0, 105)
    axes[0].yaxis.set_major_formatter(PercentFormatter(decimals=0))
    axes[0].set_title("pairs decided")
    axes[1].plot(x, x, color=GREY, lw=0.8, ls="--")
    axes[1].annotate("the budget", (x[-1], x[-1]), xytext=(-12, -1), textcoords="offset points", color=GREY, ha="right", fontsize=6.5)
    axes[1].set_yscale("log", base=2)
    axes[1].set_yticks([2.0 ** k for k in range(-7, 4, 2)], [f"1/{2 ** -k}" if k < 0 else str(2 ** k) for k in range(-7, 4, 2)])
    axes[1].set_title("time of a frame, of one without")
    axes[2].set_ylim(0, 5)
    axes[2].set_title("undecided: sizes apart at most")
    axes[2].legend(frameon=False, fontsize=6.5, loc="lower left")
    for axis in axes:
        axis.set_xscale("log", base=2)
        axis.set_xlim(x[0] / 1.2, x[-1] * 1.2)
        axis.set_xticks([2.0 ** k for k in range(-5, 3)], [f"1/{2 ** -k}" if k < 0 else str(2 ** k) for k in range(-5, 3)], fontsize=6.5)
        axis.minorticks_off()
        axis.set_xlabel("budget, of a frame without one")
        axis.grid(True)
    fig.tight_layout(w_pad=1.2)
    asked, wrong, farther = (sum(int(r[key]) for r in rows) for key in ("candidates", "wrong", "farther_than_said"))
    source = source.about(cases=f"{asked:,} pairs, {wrong} decided wrong, {farther} farther apart than said")
    columns = ["frames_asked", "budget_ns", "budget_of_a_frame", "frame_ns", "candidates", "decided", "undecided", "share_decided", "wrong", "farther_than_said",
               "mean_farthest_in_sizes"]
    data = page.table("budget", columns, [[r[c] for c in columns] for r in rows], source)
    yield page.section(
        "budget", "A budget for a frame",
        f"<p>A thousand bodies of {int(rows[0]['triangles'])} triangles wander. <i>Alone</i>: each frame is asked by a scene of its own; <i>in a row</i>: by one scene, "
        "which asks what a budget has left undecided again in the next frame, and keeps pairs that it has found apart. Times are of the median frame that is asked alone without a budget. Boxes are compared whatever the budget is: below their time it decides nothing. An undecided pair is said to be at "
        "most so far apart; the size is the longest side of a body's box.</p>", page.figure("budget", fig, source, data))


def demand(page):
    rows, source = rows_and_source(page, "demand", "How much of what could be made do the frames of a scene make, ask and spend?")
    if not rows:
        return
    frame, last = numbers(rows, "frame"), rows[-1]
    fig, axes = plt.subplots(2, 2, figsize=(WIDTH, 3.9), sharex=True)
    panels = (("nodes of trees, millions", "nodes", "nodes_of_whole_trees", "whole trees", 1e6),
              ("bytes of trees, millions", "bytes_of_trees", "bytes_of_whole_trees", "whole trees", 1e6),
              ("digits: signs decided so far", "signs_beyond_doubles", "signs", "all", 1),
              ("time so far, ms", "ns", "ns_made_first", "trees made first", 1e6))
    for axis, (title, part, whole, name, unit) in zip(axes.flat, panels):
        signs = part == "signs_beyond_doubles"
        for column, colour, text in ((whole, GREY, name), (part, VERMILION if signs else GREEN, "beyond doubles" if signs else "as asked")):
            axis.plot(frame, [y / unit for y in numbers(rows, column)], color=colour, lw=1.3, label=text)
        if signs:
            axis.set_yscale("symlog", linthresh=1)
        axis.set_ylim(0)
        axis.set_title(f"{title}; at the end {percent(float(last[part]) / max(1, float(last[whole])))}")
        axis.legend(frameon=False, fontsize=6.5, loc="best")
        axis.grid(True)
    for axis in axes[1]:
        axis.set_xlabel("frame")
    fig.tight_layout(w_pad=1.2)
    pairs, differ = int(last["pairs"]), sum(int(r["differ"]) for r in rows)
    source = source.about(cases=f"{len(rows)} frames, {differ} of them with another answer, {pairs:,} pairs colliding in the last")
    columns = ["frame", "pairs", "trees", "nodes", "nodes_of_whole_trees", "bytes_of_trees", "bytes_of_whole_trees", "bytes", "bytes_made_first",
               "signs", "signs_beyond_doubles", "ns", "ns_made_first"]
    data = page.table("demand", columns, [[r[c] for c in columns] for r in rows], source)
    yield page.section(
        "demand", "Only what is asked",
        f"<p>{int(last['bodies'])} bodies of {int(last['triangles'])} triangles, each of a model of its own, are drawn to the middle, so that more and more come near one "
        "another. What has been made, decided and spent up to a frame stands against a scene whose trees are all made before the first.</p>",
        page.figure("demand", fig, source, data))


def sections(page, study, campaign):
    """The sections of budget.csv and demand.csv, where these are in OUT."""
    for figure in (budget, demand):
        yield from figure(page)
