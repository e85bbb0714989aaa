"""Bodies in motion: how late a first contact is told and what that costs, and which contacts steps pass over."""

import matplotlib.pyplot as plt
from matplotlib.ticker import PercentFormatter

from report_data import by, distinct
from report_style import BLUE, GREEN, INK, ORANGE, PURPLE, SKY, VERMILION, WIDTH
from tables_queries import rows_and_source

SUBJECTS = (("tetracone", GREEN, "ours, exact"), ("static 10", VERMILION, "10 static poses"), ("static 100", ORANGE, "100 static poses"), ("static 1000", PURPLE, "1000 static poses"),
            ("fcl advancement", INK, "FCL, advancement"), ("fcl steps", SKY, "FCL, steps"))
MARKERS = ("o", "s", "^", "D", "v", "P")
ON_TIME = 1e-4  # what is never late stands there


def late_against_time(axis, rows, courses):
    for subject, colour, _ in SUBJECTS:
        for r in rows:
            if r["subject"] == subject and int(r["missed"]) < int(r["contacts"]):  # else there is no contact to be late
                us = float(r["contact_in_statics"]) * float(r["static_ns"]) / 1000
                axis.plot(us, max(float(r["latest"]), ON_TIME), ls="", marker=MARKERS[courses.index(r["course"])], color=colour, ms=4.5)
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_ylim(ON_TIME / 1.8, 1)
    axis.set_yticks([ON_TIME, 1e-3, 1e-2, 1e-1, 1], ["exact", "0.1 %", "1 %", "10 %", "100 %"])
    axis.minorticks_off()
    axis.set_xlabel("time of a motion with a contact, \u00b5s")
    axis.set_title("first contact told too late by at most, of the motion")
    axis.grid(True)


def missed_against_steps(axis, rows, courses):
    """A line a course over the numbers of steps; what asks at no steps beside them."""
    steps = sorted({int(r["subject"].split(" ")[1]) for r in rows if r["subject"].startswith("static ")})
    places = {f"static {n}": k for k, n in enumerate(steps)} | {"fcl steps": len(steps), "fcl advancement": len(steps) + 1, "tetracone": len(steps) + 2}
    for course in courses:
        mine = {places[r["subject"]]: 100 * int(r["missed"]) / max(1, int(r["contacts"])) for r in rows if r["course"] == course and r["subject"] in places}
        marker = MARKERS[courses.index(course)]
        static = [k for k in sorted(mine) if k < len(steps)]
        axis.plot(static, [mine[k] for k in static], color=BLUE, marker=marker, ms=4.5, lw=1)
        for subject, colour, _ in SUBJECTS:
            if (k := places.get(subject)) in mine and k >= len(steps):
                axis.plot(k, mine[k], ls="", color=colour, marker=marker, ms=4.5, clip_on=False)
    axis.set_xticks(range(len(places)), [str(n) for n in steps] + ["FCL,\nsteps", "FCL,\nadvance", "ours"])
    axis.set_xlim(-0.4, len(places) - 0.6)
    axis.set_ylim(-3, 103)
    axis.yaxis.set_major_formatter(PercentFormatter(decimals=0))
    axis.set_xlabel("static poses asked")
    axis.set_title("contacts missed")
    axis.grid(True)


def sections(page, study, campaign):
    """OUT/moving_bodies.csv, where it is there."""
    rows, source = rows_and_source(page, "moving_bodies", "How late is a first contact told, at what cost, and which contacts do steps pass over?")
    if not rows:
        return
    courses = distinct(r["course"] for r in rows)
    fig, axes = plt.subplots(1, 2, figsize=(WIDTH, 2.9), gridspec_kw={"width_ratios": [1.25, 1]})
    late_against_time(axes[0], rows, courses)
    missed_against_steps(axes[1], rows, courses)
    handles = [plt.Line2D([], [], ls="", marker="o", ms=4.5, color=colour, label=name) for subject, colour, name in SUBJECTS if any(r["subject"] == subject for r in rows)]
    handles += [plt.Line2D([], [], ls="", marker=MARKERS[k], ms=4.5, mfc="none", color=INK, label=course) for k, course in enumerate(courses)]
    fig.legend(handles=handles, ncol=5, fontsize=6.5, frameon=False, loc="lower center", handletextpad=0.1, columnspacing=1.0)
    fig.tight_layout(rect=(0, 0.11, 1, 1), w_pad=1.2)
    contacts = sum(int(next(iter(mine))["contacts"]) for mine in by(rows, "course").values())
    motions = sum(int(next(iter(mine))["motions"]) for mine in by(rows, "course").values())
    source = source.about(cases=f"{motions:,} motions, {contacts:,} of them with a contact")
    columns = ["course", "subject", "motions", "contacts", "missed", "invented", "latest", "static_ns", "contact_in_statics", "apart_in_statics"]
    data = page.table("first_contacts", columns, [[r[c] for c in columns] for r in rows], source)
    yield page.section(
        "first_contacts", "Bodies in motion: late, or not at all",
        "<p>Each motion is asked for its first contact. Poses at so many times tell it as late as the next of them, or pass over it; FCL's continuousCollide asks at ten poses, or advances by distances "
        "until it is within a ten-thousandth. A subject that misses every contact of a course has no point on the left. The exact first contact is our own, which campaigns judge by two truths.</p>",
        page.figure("first_contacts", fig, source, data))
