"""Figure 6: which stage is to blame, which relations are violated, which flags break which signs."""

import html
import textwrap
from collections import defaultdict

import matplotlib.pyplot as plt
import numpy as np

from campaign_data import is_exact
from report_data import distinct, share
from report_page import Source, again
from report_style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION, WIDTH, YELLOW

STAGES = (("pose", VERMILION), ("classification", GREEN), ("bounding sphere", SKY), ("bounding tetrahedron", ORANGE),
          ("regular hull", BLUE), ("bounding box", YELLOW), ("leaf sign", PURPLE), ("containment", GREY))


def blame(page, campaign):
    rows = campaign.tables["blame"]
    count, total = defaultdict(int), defaultdict(int)
    for r in rows:
        count[r["subject"], r["stage"]] += int(r["n"])
        total[r["subject"]] += int(r["n"])
    subjects = distinct(r["subject"] for r in rows)
    fig, axis = plt.subplots(figsize=(WIDTH, 0.95 + 0.2 * len(subjects)))
    for y, subject in enumerate(subjects):
        left = 0
        for stage, colour in STAGES:
            part = 100 * count[subject, stage] / total[subject]
            axis.barh(y, part, left=left, color=colour, height=0.75, label=stage if y == 0 else None)
            if part > 5:
                axis.text(left + part / 2, y, f"{part:.0f} %", ha="center", va="center", fontsize=6.3,
                          color="#ffffff" if colour == BLUE else "#000000")
            left += part
        axis.text(101, y, f"{total[subject]:,}", va="center", fontsize=6.5)
    axis.set_yticks(range(len(subjects)), subjects)
    axis.set_ylim(len(subjects) - 0.4, -0.6)
    axis.set_xlim(0, 109)
    axis.set_xticks([0, 25, 50, 75, 100], ["0", "25 %", "50 %", "75 %", "100 %"])
    axis.set_xlabel("share of the wrong answers that each stage made wrong; at the right, how many")
    handles, names = axis.get_legend_handles_labels()
    fig.tight_layout(rect=(0, 0, 1, 0.93))
    fig.legend(handles, names, ncol=len(names), fontsize=6.5, frameon=False, loc="upper center", columnspacing=1.0, handlelength=1.2)
    source = campaign.source("Which stage makes an answer wrong first?",
                             f"{sum(total.values()):,} wrong answers of {len(subjects)} subjects")
    lines = [[s, stage, count[s, stage], total[s]] for s in subjects for stage, _ in STAGES]
    data = page.table("blame", ["subject", "stage", "wrong", "wrong_of_subject"], lines, source)
    return page.figure("blame", fig, source, data) + blame_by_family(page, campaign, source)


def blame_by_family(page, campaign, source):
    """For the trees: the stage that most often is the first to go wrong, by family."""
    rows = [r for r in campaign.tables["blame"] if r["subject"].endswith((" tree", " tuned", " paper")) and not r["family"].startswith("sequence ")]
    subjects = [s for s in distinct(r["subject"] for r in rows)
                if s in ("float tree", "double tree", "double tuned", "double paper", "double-eps=1e-12 tree", "epick tree")]
    count, body = defaultdict(lambda: defaultdict(int)), []
    for r in rows:
        count[r["family"], r["subject"]][r["stage"]] += int(r["n"])
    for family in distinct(r["family"] for r in rows):
        cells = []
        for subject in subjects:
            stages = count.get((family, subject))
            if not stages:
                cells.append("–")
                continue
            stage, n = max(stages.items(), key=lambda s: s[1])
            cells.append(f"{stage} <small>{n} of {sum(stages.values())}</small>")
        body.append((False, [html.escape(family)] + cells))
    return ("<details><summary>By family: the stage that is most often the first to go wrong</summary>" +
            page.html_table(["family"] + [html.escape(s) for s in subjects], body,
                            source.about(asked="Which stage goes wrong first, by family?"), "tables/verify_blame.csv") + "</details>")


def heatmap(axis, rates, rows, columns):
    """Rates as percents, from light to dark on one scale; none has a colour of its own."""
    colours = np.zeros((len(rows), len(columns), 4))
    ramp = plt.get_cmap("cividis_r")
    for i in range(len(rows)):
        for j in range(len(columns)):
            rate = rates[i][j]
            colours[i, j] = (0, 0, 0, 0) if rate is None else (0, 0.62, 0.45, 0.25) if rate == 0 else ramp(0.1 + 0.9 * min(1, rate) ** 0.4)
    axis.imshow(colours, aspect="auto", interpolation="nearest")
    for i in range(len(rows)):
        for j in range(len(columns)):
            rate = rates[i][j]
            colour = INK if not rate else "#ffffff" if min(1, rate) ** 0.4 > 0.5 else "#000000"
            text = "–" if rate is None else f"{100 * rate:.0f}" if rate == 0 or rate >= 0.01 else f"{100 * rate:.1g}"
            axis.text(j, i, text, ha="center", va="center", fontsize=6, color=colour)
    axis.set_yticks(range(len(rows)), rows, fontsize=6.5)
    axis.set_xticks(range(len(columns)), [textwrap.fill(c, 48) for c in columns], fontsize=6, rotation=55, ha="left",
                    rotation_mode="anchor")
    axis.tick_params(length=0)
    axis.xaxis.tick_top()
    for spine in axis.spines.values():
        spine.set_visible(False)


def relations(page, campaign, rows):
    relations, lines = distinct(sorted(r["relation"] for r in rows)), []
    levels = [level for level in ("object", "predicate") if any(r["level"] == level for r in rows)]
    names = {level: sorted(distinct(r["subject"] for r in rows if r["level"] == level), key=lambda s: (is_exact(s), s)) for level in levels}
    columns = {level: [k for k in relations if any(r["level"] == level and r["relation"] == k for r in rows)] for level in levels}
    fig, axes = plt.subplots(1, len(levels), figsize=(WIDTH, 0.9 + 0.15 * max(len(n) for n in names.values())), squeeze=False,
                             gridspec_kw={"width_ratios": [2 + len(columns[level]) for level in levels]})
    for axis, level in zip(axes[0], levels):
        cell = {(r["subject"], r["relation"]): r for r in rows if r["level"] == level}
        present = columns[level]
        rates = [[None if (s, k) not in cell else float(cell[s, k]["rate"]) for k in present] for s in names[level]]
        heatmap(axis, rates, names[level], present)
        axis.set_title(f"{level}s, %" if level == "object" else f"{level}s: segment against triangle and others, %", fontsize=7, pad=4)
        lines += [[level, k, s, cell[s, k]["tried"], cell[s, k]["violated"], cell[s, k]["low"], cell[s, k]["high"]] for s in names[level]
                  for k in present if (s, k) in cell]
    fig.tight_layout(w_pad=1.5)
    source = campaign.source("How often does a subject contradict itself when what is asked is changed in a way that cannot matter?",
                             f"{sum(int(r['tried']) for r in rows):,} tries")
    data = page.table("relations", ["level", "relation", "subject", "tried", "violated", "low_95", "high_95"], lines, source)
    return page.figure("relations", fig, source, data)


def compiler_matrix(page, campaign):
    rows = [r for r in campaign.compilers if r["outcome"] == "ran"]
    tests, subjects = distinct(r["test"] for r in rows), distinct(r["subject"] for r in rows)
    cell = {(r["compiler"], r["flags"], r["subject"], r["test"]): int(r["wrong"]) / int(r["n"]) for r in rows}
    builds = distinct((r["compiler"], r["flags"]) for r in rows)
    fig, axes = plt.subplots(1, len(subjects), figsize=(WIDTH, 1.2 + 0.16 * len(builds)), sharey=True, squeeze=False)
    for axis, subject in zip(axes[0], subjects):
        rates = [[cell.get((*build, subject, test)) for test in tests] for build in builds]
        heatmap(axis, rates, [f"{c} {f}" for c, f in builds], [test.split(":")[0] for test in tests])
        axis.set_xlabel(f"{subject}, %", fontsize=7.5)
    fig.subplots_adjust(left=0.3, right=0.94, bottom=0.05, top=0.74, wspace=0.12)
    source = Source("Which compiler flags make which signs wrong?", f"{sum(int(r['n']) for r in rows):,} signs of four points",
                    "fixed in experiments/accuracy/compiler_probe.cpp",
                    again(campaign.compilers), "; ".join(distinct(r["version"] for r in rows)),
                    "; ".join(distinct(f"{r['compiler']} {r['compiler_version']}" for r in rows)),
                    "; ".join(distinct(r["processor"] for r in rows)))
    lines = [[c, f, r_subject, test, f"{cell[c, f, r_subject, test]:.6g}"] for c, f in builds for r_subject in subjects for test in tests
             if (c, f, r_subject, test) in cell]
    data = page.table("compilers", ["built_by", "flags", "subject", "test", "rate_wrong"], lines, source)
    refused = sorted({(r["compiler"], r["flags"]) for r in campaign.compilers if r["outcome"] == "refused to compile"})
    note = "<p>Refused at compile time, as they must be: " + "; ".join(f"{c} <code>{html.escape(f)}</code>"
                                                                       for c, f in refused) + ".</p>" if refused else ""
    return page.figure("compilers", fig, source, data) + note


def sections(page, study, campaign):
    if campaign and campaign.tables["blame"]:
        yield page.section("blame-stages", "Which stage is to blame",
                           "<p>The query is run with its first stages in the subject's arithmetic and the rest exact, with one rounded "
                           "stage more at a time: the stage with which the answer first differs from the truth is to blame.</p>",
                           blame(page, campaign))
    rows = [r for r in campaign.tables["relations"] if r["level"] in ("object", "predicate") and int(r["tried"])]
    if rows:
        mine = [r for r in rows if is_exact(r["subject"])]
        exact = sum(int(r["violated"]) for r in mine), sum(int(r["tried"]) for r in mine)
        yield page.section("metamorphic", "Metamorphic relations",
                           f"<p>Violations need no truth: the subject contradicts itself. Exact subjects: {share(*exact)}. Green: no "
                           f"violation.</p>", relations(page, campaign, rows))
    if campaign.compilers:
        yield page.section("flags", "Compilers and flags", "<p>Signs of four points by flags: contraction of products and sums alone "
                           "breaks signs. Green: none wrong.</p>", compiler_matrix(page, campaign))
