"""Figure 8, the model no more than needed: the share of the tree, of exact arithmetic and of digits that a scene really asks for."""

from collections import defaultdict

import matplotlib.pyplot as plt

from campaign_data import EXACTLY, NOT_NEAR, REGIME
from report_data import by, percent
from report_style import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION, WIDTH
from study_data import REGIMES

SUBJECT = "adaptive tree"
# By the bits that separate the nearest sign from zero: what arithmetic could have told it.
DIGITS = (("no sign near zero", GREY), ("within float's 24 bits", SKY), ("within double's 53", GREEN), ("within 106, two doubles", ORANGE),
          ("beyond", VERMILION), ("exactly zero", PURPLE))


def kind_of_digits(b):
    if b == NOT_NEAR:
        return 0
    return 5 if b == EXACTLY else 1 if b >= -24 else 2 if b >= -53 else 3 if b >= -106 else 4


def work(page, study):
    rows = [r for r in study.rows if r["subject"] == SUBJECT]
    if not rows:
        return ""
    scenes, lines = [], []
    for (panel, scenario), mine in sorted(by(rows, "panel", "scenario").items(), key=lambda s: REGIMES.index(s[0][0])):
        asked = sum(r["poses"] for r in mine)
        of_all_pairs = sum((r["bounding_tests"] + r["primitive_tests"]) / (r["faces_a"] * r["faces_b"]) * r["poses"] for r in mine) / asked
        tests = sum((r["bounding_tests"] + r["primitive_tests"]) * r["poses"] for r in mine)
        exact = sum(r["exact_fallbacks"] * r["poses"] for r in mine)
        scenes.append((scenario, of_all_pairs, exact / tests if tests else 0, tests > 0))
        lines.append([panel, scenario, int(asked), f"{of_all_pairs:.6g}", f"{tests / asked:.6g}", f"{exact / asked:.6g}"])
    fig, axes = plt.subplots(1, 2, figsize=(WIDTH, 0.75 + 0.19 * len(scenes)), sharey=True)
    for axis, index, colour, label in ((axes[0], 1, BLUE, "tests of boxes and elements, of all pairs of faces"),
                                       (axes[1], 2, VERMILION, "signs decided exactly, per test")):
        ticks = (1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1) if index == 1 else (1e-3, 1e-2, 1e-1, 1, 10)
        for y, scene in enumerate(scenes):
            value = scene[index]
            axis.barh(y, value, color=colour, height=0.7)
            text = (percent(value) if index == 1 else f"{value:.2g}") if value else "none" if scene[3] else "no tests"
            axis.text(max(value, ticks[0] / 2) * 1.12, y, text, va="center", fontsize=6.5)
        axis.set_xscale("symlog", linthresh=ticks[0], linscale=0.3)
        axis.set_xlim(0, ticks[-1] * 8)
        labels = [f"{100 * t:g} %" if index == 1 else f"{t:g}" for t in ticks[1:]]  # the first would stand on the 0
        axis.set_xticks([0, *ticks], ["0", "", *labels], fontsize=6)
        axis.minorticks_off()
        axis.set_xlabel(label)
        axis.grid(True, axis="x")
    axes[0].set_yticks(range(len(scenes)), [s[0] for s in scenes], fontsize=6.8)
    axes[0].set_ylim(len(scenes) - 0.4, -0.6)
    fig.tight_layout(w_pad=0.6)
    source = study.source(f"How much of the trees and of exact arithmetic does a scene ask for ({SUBJECT}, a query)?", rows)
    data = page.table("needs", ["regime", "scenario", "queries", "tests_of_all_pairs_of_faces", "tests_a_query", "exact_evaluations_a_query"],
                      lines, source)
    return page.figure("needs", fig, source, data)


def digits(page, campaign):
    rows = [r for r in campaign.tables["needs"] if r["level"] == "object" and r["question"] == "surface" and r["family"] in REGIME]
    if not rows:
        return ""
    count = defaultdict(lambda: [0] * len(DIGITS))
    for r in rows:
        count[REGIME[r["family"]]][kind_of_digits(int(r["bin"]))] += int(r["n"])
    regimes = [r for r in REGIMES if r in count]
    fig, axis = plt.subplots(figsize=(WIDTH, 0.85 + 0.3 * len(regimes)))
    for y, regime in enumerate(regimes):
        left, total = 0, sum(count[regime])
        for (name, colour), n in zip(DIGITS, count[regime]):
            part = 100 * n / total
            axis.barh(y, part, left=left, color=colour, height=0.75, label=name if y == 0 else None)
            if part > 4:
                axis.text(left + part / 2, y, f"{part:.0f} %", ha="center", va="center", fontsize=6.5, color="#000000")
            left += part
    axis.set_yticks(range(len(regimes)), [f"{r} ({sum(count[r]):,})" for r in regimes])
    axis.set_ylim(len(regimes) - 0.4, -0.6)
    axis.set_xlim(0, 100)
    axis.set_xticks([0, 25, 50, 75, 100], ["0", "25 %", "50 %", "75 %", "100 %"])
    axis.set_xlabel("share of the cases whose nearest sign needs so many bits")
    handles, names = axis.get_legend_handles_labels()
    fig.tight_layout(rect=(0, 0, 1, 0.88))
    fig.legend(handles, names, ncol=len(names), fontsize=6.3, frameon=False, loc="upper center", columnspacing=0.9, handlelength=1.1)
    source = campaign.source("How many bits does the nearest sign of a case ask for, by scene type?",
                             f"{sum(map(sum, count.values())):,} cases")
    data = page.table("digits", ["regime", *(name for name, _ in DIGITS)], [[r, *count[r]] for r in regimes], source)
    return page.figure("digits", fig, source, data)


def sections(page, study, campaign):
    drawn = (work(page, study) if study else "") + (digits(page, campaign) if campaign else "")
    if drawn:
        yield page.section("needs", "No more than needed", "<p>What a scene asks for, of what the model could give: of the tree, of exact "
                           "arithmetic, of digits.</p>", drawn)
