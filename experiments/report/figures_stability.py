"""Figure 3, stability: how often an answer flips although the truth does not, and how far from the exact threshold a kernel's own lies."""

import os

import matplotlib.pyplot as plt

from campaign_data import is_exact
from report_data import distinct, kernel_of, method_of, read, wilson
from report_page import Source
from report_style import GREEN, WIDTH, colour_of, mark

KINDS = (("rolling", ("rolling",)), ("sweeping into contact", ("down ", "passage")), ("sliding", ()))  # the rest slides


def kind_of(sequence):
    return next(kind for kind, words in KINDS if not words or any(w in sequence for w in words))


def flips(page, campaign):
    rows = [r for r in campaign.tables["flips"] if r["question"] == "surface"]
    subjects = [s for s in distinct(r["subject"] for r in rows) if method_of(s) in ("tree", "peer")
                and not all(int(r["wrong"]) == int(r["frames"]) for r in rows if r["subject"] == s)]
    subjects.sort(key=lambda s: (is_exact(s), method_of(s) == "tree", s))
    asked = {kind_of(r["sequence"]) for r in rows if r["subject"] in subjects and int(r["frames"]) > 1}
    kinds = [kind for kind in ("sliding", "rolling", "sweeping into contact") if kind in asked]
    if not kinds:
        return ""
    fig, (axes,) = plt.subplots(1, len(kinds), figsize=(WIDTH, 0.75 + 0.17 * len(subjects)), sharey=True, sharex=True,
                                squeeze=False)
    lines = []
    for axis, kind in zip(axes, kinds):
        for y, subject in enumerate(subjects):
            mine = [r for r in rows if r["subject"] == subject and kind_of(r["sequence"]) == kind]
            steps = sum(int(r["frames"]) - 1 for r in mine)
            surplus = sum(max(0, int(r["changes"]) - int(r["true_changes"])) for r in mine)
            if steps == 0:
                continue
            low, high = wilson(surplus, steps)
            colour = colour_of(kernel_of(subject))
            axis.plot([1000 * low, 1000 * high], [y, y], color=colour, lw=0.9, alpha=0.7)
            axis.plot(1000 * surplus / steps, y, **mark(kernel_of(subject), method_of(subject), is_exact(subject)))
            lines.append([kind, subject, steps, surplus, sum(int(r["true_changes"]) for r in mine), sum(int(r["wrong"]) for r in mine),
                          f"{1000 * low:.6g}", f"{1000 * high:.6g}"])
        axis.set_xscale("symlog", linthresh=1, linscale=0.5)
        axis.set_xlim(-0.25, 1100)
        axis.set_xticks([0, 1, 10, 100, 1000], ["0", "1", "10", "100", "1000"])
        axis.axvspan(-0.25, 0.12, color=GREEN, alpha=0.14, lw=0)
        axis.minorticks_off()
        axis.set_title(kind)
        axis.grid(True)
    axes[0].set_yticks(range(len(subjects)), subjects)
    axes[0].set_ylim(len(subjects) - 0.4, -0.6)
    axes[len(kinds) // 2].set_xlabel("flips of the answer per thousand frames, beyond those of the truth")
    fig.tight_layout(w_pad=0.5)
    source = campaign.source("How often does the answer flip from frame to frame in exact contact, although the truth does not?",
                             f"{sum(line[2] for line in lines):,} pairs of neighbouring frames")
    data = page.table("flips", ["motion", "subject", "pairs_of_frames", "surplus_flips", "true_changes", "wrong", "low_95_per_thousand",
                                "high_95_per_thousand"], lines, source)
    return page.figure("flips", fig, source, data)


def thresholds(page):
    """OUT/stability.csv: the exact threshold of a motion between doubles, and each kernel's own."""
    rows = read(os.path.join(page.out, "stability.csv"))
    if not rows:
        return ""
    subjects, motions = distinct(r["subject"] for r in rows), distinct(r["motion"] for r in rows)
    fig, axes = plt.subplots(1, len(motions), figsize=(WIDTH, 0.85 + 0.2 * len(subjects)), sharey=True, squeeze=False)
    lines = []
    for axis, motion in zip(axes[0], motions):
        for y, subject in enumerate(subjects):
            mine = sorted(float(r["error_ulps"]) for r in rows if r["motion"] == motion and r["subject"] == subject)
            if not mine:
                continue
            exact = mine[-1] == 0
            middle, worst = mine[len(mine) // 2], mine[-1]
            colour = colour_of(kernel_of(subject))
            axis.plot([middle, worst], [y, y], color=colour, lw=1)
            axis.plot(worst, y, "|", color=colour, ms=6, mew=1.2)
            axis.plot(middle, y, **mark(kernel_of(subject), method_of(subject), exact and is_exact(subject)))
            lines.append([motion, subject, len(mine), sum(x > 0 for x in mine), f"{middle:.6g}", f"{worst:.6g}"])
        axis.set_xscale("symlog", linthresh=1, linscale=1.2)
        axis.axvspan(-0.3, 0.15, color=GREEN, alpha=0.14, lw=0)
        axis.axvline(1, color="#8a8a8a", lw=0.7, ls="--")
        axis.set_xlim(-0.3, None)
        axis.set_xticks([0, 1, 1e2, 1e4, 1e6, 1e8, 1e10], ["0", "1", "10²", "10⁴", "10⁶", "10⁸", "10¹⁰"], fontsize=6.5)
        axis.minorticks_off()
        axis.set_title(motion)
        axis.grid(True)
    axes[0][0].set_yticks(range(len(subjects)), subjects)
    axes[0][0].set_ylim(len(subjects) - 0.4, -0.6)
    fig.supxlabel("distance of the subject's threshold from the exact one, ulps; dashed: the smallest change that changes the exact answer",
                  fontsize=7, y=0.01)
    fig.tight_layout(rect=(0, 0.04, 1, 1), w_pad=0.5)
    source = Source.of(rows, "How far from the place where the exact answer changes does each subject's answer change?",
                       f"{len(rows):,} thresholds, {len(rows) // max(1, len(subjects))} motions")
    data = page.table("thresholds", ["motion", "subject", "n", "displaced", "median_ulps", "largest_ulps"], lines, source)
    return page.figure("thresholds", fig, source, data)


def sections(page, study, campaign):
    if drawn := flips(page, campaign):
        yield page.section("stability", "Stability: flickering in contact",
                           "<p>Sequences of frames whose contact is exact: the truth stays, or changes once. An answer that comes and goes "
                           "between frames shows as flicker or tunnelling. Bars: 95 % intervals. Subjects that were wrong in every frame "
                           "are left out of the drawing.</p>", drawn)
    if drawn := thresholds(page):
        yield page.section("thresholds", "Stability: the smallest change that matters",
                           "<p>A body is moved towards another by single doubles: between two neighbours the exact answer changes. Each "
                           "subject's own answer changes elsewhere, by so many doubles. Point: the median; bar: the largest.</p>", drawn)
