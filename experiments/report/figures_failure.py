"""Figure 2, where methods fail: against the distance to degeneracy, from the origin, between scales, and against a sliver's height."""

import html
import math
from collections import defaultdict

import matplotlib.pyplot as plt

from campaign_data import DOUBLES, EXACTLY, FRACTIONS, NOT_NEAR, PANEL, REGIME, is_exact
from report_data import by, distinct, method_of, percent, share, short, wilson, wrong_in
from report_style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION, WIDTH, label_ends

# (subject, name, colour, dashes). Brute force has no tree to lose a pair in: its errors are those of the signs alone.
OBJECTS = (("float brute", "float", ORANGE, ""), ("double brute", "double", VERMILION, ""),
           ("double-eps=1e-12 brute", "double, ε 1e-12", PURPLE, ""),
           ("double-eps=rel:1e-12 brute", "double, relative ε", "#8C4F76", "--"), ("epick brute", "EPICK", SKY, ""),
           ("FCL OBBRSS", "FCL", INK, "--"),
           ("CGAL RMCD EPICK", "CGAL, EPICK", GREY, "--"), ("adaptive tree", "adaptive", GREEN, ""))
KERNELS = (("float", "float", ORANGE, ""), ("double", "double", VERMILION, ""), ("double-eps=1e-12", "double, ε 1e-12", PURPLE, ""),
           ("double-eps=rel:1e-12", "double, relative ε", "#8C4F76", "--"), ("epick", "EPICK", SKY, ""),
           ("adaptive", "adaptive", GREEN, ""))
FORMULATIONS = (("double", "four signs", VERMILION, ""), ("double moeller-trumbore-eps-0", "Möller–Trumbore", ORANGE, ""),
                ("double moeller-trumbore-eps-1e-12", "Möller–Trumbore, ε", ORANGE, "--"), ("double segura-feito", "Segura–Feito", SKY, ""),
                ("double jimenez-segura-feito-eps-0", "Jiménez et al.", BLUE, ""),
                ("double jimenez-segura-feito-eps-1e-12", "Jiménez et al., ε", BLUE, "--"),
                ("double jimenez-segura-feito-sign-error", "Jiménez et al., sign as printed", PURPLE, "--"),
                ("adaptive", "four signs, exact", GREEN, ""))
ZERO = 0.05  # percent: where "none" stands; rates below 0.1 % would need more cases than a bin has
LOW, APART = {"rho": -72, "ulps": -12}, {"rho": 10, "ulps": 10}  # exact degeneracy stands so far left of the rest
STEP = {"rho": 4, "ulps": 2}
HIGH = {"rho": 0, "ulps": 56}


def rate_axis(axis):
    """Percents on a log axis, with a band of its own for none."""
    axis.set_yscale("log")
    axis.set_ylim(ZERO / 1.6, 130)
    axis.axhspan(ZERO / 1.6, ZERO * 1.6, color=GREEN, alpha=0.14, lw=0)
    axis.set_yticks([ZERO, 0.1, 1, 10, 100], ["none", "0.1 %", "1 %", "10 %", "100 %"])
    axis.minorticks_off()
    axis.grid(True)


def draw_curve(axis, points, colour, dashes, at_gap=None, widest=None):
    """points: (x, wrong, asked). The interval is a thin bar. A point at `at_gap` stands apart from the curve. Gives the curve's end."""
    heights = [(x, max(100 * wrong / n, ZERO)) for x, wrong, n in points]
    for (x, y), (_, wrong, n) in zip(heights, points):
        low, high = wilson(wrong, n)
        if wrong:
            axis.plot([x, x], [max(100 * low, ZERO), 100 * high], color=colour, lw=0.5, alpha=0.4)
    along = [p for p in heights if p[0] != at_gap]
    pieces = [[]]
    for k, p in enumerate(along):  # no line over bins that were left out
        if k and widest and p[0] - along[k - 1][0] > widest:
            pieces.append([])
        pieces[-1].append(p)
    for piece in pieces:
        axis.plot([x for x, _ in piece], [y for _, y in piece], color=colour, lw=1.1, ls=dashes or "-", marker="o", ms=1.8)
    for x, y in heights:
        if x == at_gap:
            axis.plot(x, y, marker="o", ms=3.5, color=colour, mec=colour, mfc=colour)
    return along[-1] if along else heights[-1]


def binned(rows, subject, key):
    """(x, wrong, asked) by distance; exact degeneracy apart from the rest."""
    low, step, bins = LOW[key], STEP[key], defaultdict(lambda: [0, 0])
    for r in rows:
        b = int(r["bin"])
        if r["subject"] != subject or r["axis"] != key or b == NOT_NEAR or r["poses"] != DOUBLES:
            continue
        b = low - APART[key] if b == EXACTLY else min(HIGH[key], max(low, step * math.floor(b / step)))
        bins[b][0] += round(float(r["rate"]) * int(r["n"]))
        bins[b][1] += int(r["n"])
    return [(b, wrong, n) for b, (wrong, n) in sorted(bins.items()) if n >= 10]


PANELS = (("object", "surface", OBJECTS, "two bodies"),
          ("predicate", "segment-triangle", KERNELS, "segment and triangle, by kernel"),
          ("predicate", "segment-triangle", FORMULATIONS, "segment and triangle in double, by formulation"))


def points_of(campaign, level, question, curves):
    """The points of each curve of a panel that has any, by its axis and subject."""
    rows = [r for r in campaign.tables["distance"] if (r["level"], r["question"]) == (level, question)]
    return {(key, subject): points for key in LOW for subject, *_ in curves if (points := binned(rows, subject, key))}


def by_distance(page, campaign):
    panels = [(*panel, points) for panel in PANELS if (points := points_of(campaign, *panel[:3]))]
    if not panels:
        return ""
    fig, axes = plt.subplots(len(panels), 2, figsize=(WIDTH, 2.15 * len(panels) + 0.25), sharey=True, squeeze=False)
    lines, asked = [], {}
    for k, (row, (level, question, curves, title, points_of_panel)) in enumerate(zip(axes, panels)):
        for axis, key, label in ((row[0], "rho", "log₂ of the relative determinant"), (row[1], "ulps", "log₂ of the distance in ulps")):
            rate_axis(axis)
            named = []
            for subject, name, colour, dashes in curves:
                if points := points_of_panel.get((key, subject)):
                    asked[level, question, subject] = sum(n for _, _, n in points)
                    draw_curve(axis, points, colour, dashes, at_gap=LOW[key] - APART[key], widest=2 * STEP[key])
                    named.append(plt.Line2D([], [], color=colour, ls=dashes or "-", lw=1.4, label=name))
                    lines += [[level, question, key, subject, "exact" if b == LOW[key] - APART[key] else b, wrong, n,
                               *(f"{x:.6g}" for x in wilson(wrong, n))] for b, wrong, n in points]
            ticks = range(LOW[key], HIGH[key] + 1, 4 * STEP[key])
            axis.set_xticks([LOW[key] - APART[key], *ticks], ["exact", *(f"≤{t}" if t == LOW[key] else str(t) for t in ticks)],
                            fontsize=6.5)
            axis.axvline(LOW[key] - APART[key] / 2, color=GREY, lw=0.6, ls=":")
            if axis is row[1]:
                axis.legend(handles=named, loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, fontsize=6.5,
                            labelcolor="linecolor", handlelength=1.8)
            if k == len(panels) - 1:
                axis.set_xlabel(label)
        row[0].set_title(title, loc="left")
        row[0].set_ylabel("wrong answers")
    fig.tight_layout()
    source = campaign.source("How does the share of wrong answers grow as the nearest sign comes near zero?",
                             f"{sum(asked.values()):,} answers")
    data = page.table("errors_by_distance", ["level", "question", "axis", "subject", "bin", "wrong", "asked", "low_95", "high_95"], lines,
                      source)
    return page.figure("errors_by_distance", fig, source, data)


ENDS_OF_RANGE = ("extreme-exponents", "exponent-gate", "wild")
FAR = -40  # log2 of rho: rounding errors of determinants in double end below it


def far_from_zero(campaign):
    """Why double is wrong far to the right of the left axis: counts among the wrong answers that are kept one by one."""
    far = [r for r in campaign.tables["wrong"] if (r["level"], r["subject"], r["question"]) == ("object", "double brute", "surface") and
           FAR <= float(r["log2_rho"]) < math.inf]
    at_ends = [r for r in far if r["family"] in ENDS_OF_RANGE]
    placed = [r for r in far if r["family"] not in ENDS_OF_RANGE and float(r["log2_ulps"]) < 1]
    rest = len(far) - len(at_ends) - len(placed)
    counts = f"Of {len(far):,} such answers of <i>double brute</i> above 2<sup>{FAR}</sup>, {len(placed):,} are nearer to contact than two " \
             f"ulps, {len(at_ends):,} are at the ends of the doubles' range, and {rest:,} neither." if far else ""
    return ("<p class=note><b>Why double is wrong far from zero.</b> The left axis measures how hard a sign is to compute from exactly placed "
            "points. It does not measure what placing loses: a kernel of doubles rounds each placed vertex by up to about an ulp. Bodies that are "
            "nearer to contact than that may be answered wrongly, however large their determinants are. The right axis, in ulps, has them at "
            "its left. Neither axis measures overflow and underflow, which occur at the ends of the doubles' range (families "
            + ", ".join(f"<i>{f}</i>" for f in ENDS_OF_RANGE) + "). A translation that cancels coordinates rounds by the ulps of the larger "
            "numbers that it cancels. The method <i>brute</i> also asks faces that lie in one plane far from each other, which are no near pair. "
            f"{counts} Only poses of doubles are drawn.</p>")


SWEEPS = (("far-from-origin", "translation from the origin", lambda x: f"2^{x:.0f}"),
          ("mixed-scales", "ratio of scales", lambda x: f"2^{x:.0f}"),
          ("sliver", "height of a sliver", lambda x: f"2^-{x:.0f}"))
CURVES = (("by kernel", KERNELS), ("in double, by formulation", FORMULATIONS))


def by_parameter(page, campaign):
    found = defaultdict(list)
    for r in campaign.tables["sweeps"]:
        if (r["level"], r["question"]) == ("predicate", "segment-triangle"):
            n = int(r["n"])
            found[r["family"], r["subject"]].append((float(r["parameter"]), round(float(r["rate"]) * n), n))

    def has_points(sweeps, curves):
        return any((family, subject) in found for family, *_ in sweeps for subject, *_ in curves)
    sweeps = [sweep for sweep in SWEEPS if has_points([sweep], KERNELS + FORMULATIONS)]
    groups = [group for group in CURVES if has_points(sweeps, group[1])]
    if not groups:
        return ""
    fig, axes = plt.subplots(len(groups), len(sweeps), figsize=(WIDTH, 0.3 + 2 * len(groups)), sharey=True,
                             squeeze=False)
    lines, ends, asked = [], [], 0
    for k, ((title, curves), row) in enumerate(zip(groups, axes)):
        row[0].set_title(title, loc="left")
        for axis, (family, label, text) in zip(row, sweeps):
            rate_axis(axis)
            named = []
            for subject, name, colour, dashes in curves:
                points = sorted(found.get((family, subject), ()))
                if not points:
                    continue
                x, y = draw_curve(axis, points, colour, dashes)
                named.append((x, y, name, colour))
                asked += sum(n for _, _, n in points)
                lines += [[family, p, subject, wrong, n, *(f"{v:.6g}" for v in wilson(wrong, n))] for p, wrong, n in points]
                axis.set_xticks([p for p, _, _ in points], [f"$\\mathdefault{{{text(p).replace('^', '^{')}}}}}$" for p, _, _ in points],
                                fontsize=6.5)
            if k == len(groups) - 1:
                axis.set_xlabel(label)
        row[0].set_ylabel("wrong answers")
        ends.append((row[-1], named))
    fig.tight_layout(rect=(0, 0, 0.84, 1), w_pad=0.4)
    for axis, named in ends:
        label_ends(axis, named)
    labels = ", ".join(label for _, label, _ in sweeps)
    source = campaign.source(f"How does segment against triangle fail, by {labels}?", f"{asked:,} answers")
    data = page.table("errors_by_parameter", ["family", "parameter", "subject", "wrong", "asked", "low_95", "high_95"], lines, source)
    return page.figure("errors_by_parameter", fig, source, data)


def share_with_kinds(rows):
    """The share of wrong answers of these rows, with what they are; a dash where nothing was asked."""
    total = {key: sum(int(r[key]) for r in rows) for key in ("n", "false_positives", "false_negatives", "failures")}
    if total["n"] == 0:
        return "–"
    wrong = total["n"] and sum(map(wrong_in, rows))
    text = share(wrong, total["n"])
    if wrong:
        failed = f", failed {total['failures']:,}" if total["failures"] else ""
        text += f"<br><small>missed {total['false_negatives']:,}, invented {total['false_positives']:,}{failed}</small>"
    return text


def subjects(page, campaign, level, poses):
    """A line a subject, a column a question, of families and of sequences; of poses of doubles, or of those with fractions."""
    columns = [(question, of_sequences, group) for of_sequences in (False, True)
               if (mine := [r for r in campaign.rows(level, poses, of_sequences) if int(r["n"])])
               for question, group in by(mine, "question").items()]
    rows = [r for *_, group in columns for r in group]
    if not rows:
        return ""
    notes, body = campaign.notes(level), []
    for subject in distinct(r["subject"] for r in rows):
        cells = [html.escape(subject)]
        for (question,), _, group in columns:
            mine = [r for r in group if r["subject"] == subject]
            text = share_with_kinds(mine)
            if mine and not campaign.is_known(mine[0]):
                text = f"<small>knows {campaign.knows(subject)}s alone:</small> {text}"
            cells.append(text)
        body.append((is_exact(subject), cells + ([f"<small class=what>{html.escape(notes.get(subject, ''))}</small>"] if notes else [])))
    source = campaign.source(f"How often is each subject wrong, by question ({level} level, poses of {poses})?", campaign.answers(rows))
    head = ["subject"] + [question + (", frames in exact contact" if of_sequences else "") for (question,), of_sequences, _ in columns]
    title = "Poses of doubles" if poses == DOUBLES else "Poses with fractions, which kernels of doubles round and libraries are not asked"
    return f"<h3>{title}</h3>" + page.html_table(head + (["what it answers"] if notes else []), body, source, "tables/verify_poses.csv")


def of_both_poses(page, campaign, level):
    return "".join(subjects(page, campaign, level, poses) for poses in (DOUBLES, FRACTIONS))


def families(page, campaign):
    """Object level: share of wrong answers by family, for one method of each kernel and the peers."""
    rows = [r for r in campaign.rows("object") if int(r["n"]) and campaign.is_known(r)]
    names = [s for s in distinct(r["subject"] for r in rows) if method_of(s) in ("tree", "peer")]
    if not names:
        return ""
    count, body = campaign.wrong_by(rows, "family", "poses", "subject"), []
    for family, poses in distinct((r["family"], r["poses"]) for r in rows):
        cells = [html.escape(family) + (" <small>with fractions</small>" if poses == FRACTIONS else "")]
        for subject in names:
            wrong, n = count[family, poses, subject]
            cells.append("–" if n == 0 else "0" if wrong == 0 else f"<b>{percent(wrong / n)}</b>")
        body.append((False, cells))
    source = campaign.source("Which families does each subject get wrong, the questions that it knows together?", campaign.answers(rows))
    return page.html_table(["family"] + [html.escape(short(s)) for s in names], body, source, "tables/verify_poses.csv")


def described_families(page, campaign):
    """What each family is, from the program's own list."""
    rows = campaign.tables["families"]
    body = [(False, [html.escape(r["family"]), html.escape(r["levels"]), html.escape(r["what"]), html.escape(r["parameter"]),
                     html.escape(r["sweep"]), PANEL.get(REGIME.get(r["family"]), REGIME.get(r["family"], "–")) if "object" in r["levels"].split() else ""]) for r in rows]
    source = campaign.source("What is each family of cases?", f"{len(rows)} families").about(command="build/tetracone verify --list")
    return page.html_table(["family", "levels that ask it", "what its cases have in common", "parameter", "its values", "panel"], body, source,
                           "tables/verify_families.csv")


def failures(page, campaign):
    """How subjects failed, over families and questions together, and what they said the first time; nothing where none did."""
    count, said = defaultdict(int), {}
    for r in campaign.tables["failures"]:
        key = r["level"], r["subject"], r["how"]
        count[key] += int(r["n"])
        said.setdefault(key, r["said"])
    if not count:
        return ""
    body = [(False, [*map(html.escape, key), f"{n:,}", f"<small>{html.escape(said[key])}</small>"]) for key, n in count.items()]
    source = campaign.source("How did subjects fail, and what did they say last?", f"{sum(count.values()):,} failures")
    return page.html_table(["level", "subject", "how", "failures", "last line of standard error"], body, source, "tables/verify_failures.csv")


# A section of each level that was asked: the level, its title and its words.
LEVELS = (
    ("object", "Objects: whether two bodies collide",
     "<i>surface</i> asks whether the surfaces share a point, <i>solid</i> whether the solids do."),
    ("predicate", "Predicates",
     "The same families as seven points, by predicate. Answers higher than the truth are invented, lower ones missed."),
    ("features", "Features: which faces and edges of two bodies meet",
     "An answer is a list of pairs. It is missed where a true pair is not in it, invented where one more is."),
    ("contacts", "Contacts: what two bodies share, piece by piece",
     "An answer is a list of points, segments and polygons. It is missed where a true one is not in it, invented "
     "where one more is."),
    ("distances", "Distances",
     "An answer makes several statements: the square, the nearest points, the rounded root, and limits beside it. It "
     "is missed where one is wrong. Of a subject that tells one double, the counts are of doubles that are too small "
     "and too large."),
    ("points", "Points: inside, outside or on the boundary",
     "Answers higher than the truth are invented, lower ones missed."),
    ("rays", "Rays: which faces they meet",
     "<i>first</i>: the first face with its place; <i>hits</i>: all faces with their places; <i>faces</i>: all faces. "
     "An answer is missed where a true one is not in it, invented where one more is."),
    ("scenes", "Scenes of many bodies: which pairs collide",
     "An answer is the list of pairs in a frame. It is missed where a true pair is not in it, invented where one more "
     "is."),
    ("motions", "Bodies in motion: who finds the first contact",
     "<i>surface</i>, <i>solid</i>: whether they meet. <i>time</i>: of those that meet and are said to, whether the "
     "first contact is told as it is. No tolerance is granted. The doubles about it are right, or one of them where a "
     "subject tells one time. Missed times are early ones, invented ones late."),
    ("relations", "Relations: how two solids lie to each other, and how much they overlap",
     "<i>relation</i>: which of the relations holds; <i>dimension</i>: that of their contact; <i>overlap</i>: volume, "
     "centroid, contact vector and contact area. An answer is missed where one of its statements is wrong."),
    ("exits", "Exits: how far one solid moves until it leaves the other, and how deep it is",
     "The first and the last exit along a direction, each as a fraction and a double, and the brackets of the depth. "
     "An answer is missed where one of its statements is wrong."))


def of_all_levels(page, campaign):
    """A line a level: what was asked of it, and how much of that was wrong."""
    every = [r for r in campaign.tables["poses"] if campaign.is_known(r)]
    truths, poses, body = by(campaign.tables["truth"], "level"), by(every, "level"), []
    for level, *_ in LEVELS:
        cases, rows = truths[level,], poses[level,]
        if cases:
            counts = [len({r["family"] for r in cases}), sum(int(r["n"]) for r in cases),
                      sum(int(r["by_construction"]) for r in cases), len({r["subject"] for r in rows})]
            wrong = [share_with_kinds([r for r in rows if is_exact(r["subject"]) == exact]) for exact in (True, False)]
            body.append((False, [level, *(f"{n:,}" for n in counts), *wrong]))
    count = len({r["family"] for r in campaign.tables["truth"]})
    source = campaign.source("How much was asked at each level, and how much was wrong?", campaign.answers(every))
    head = ["level", "families and sequences", "truths", "also known by construction", "subjects",
            "wrong: exact subjects", "wrong: the others"]
    return (f"<p>{count} families and sequences of frames sweep from far from degenerate to exactly degenerate. "
            "Each truth is computed twice. The two formulations share the polyhedron, the exact entries of poses and "
            "GMP alone.</p>"
            + page.html_table(head, body, source, "tables/verify_poses.csv"))


def contradictions(campaign, level):
    """How often the answers of exact subjects, and of the others, violate a relation at this level."""
    rows = [r for r in campaign.tables["relations"] if r["level"] == level and int(r["tried"])]
    shares = [f"{name} {share(sum(int(r['violated']) for r in mine), sum(int(r['tried']) for r in mine))}"
              for name, right in (("exact subjects", True), ("the others", False))
              if (mine := [r for r in rows if is_exact(r["subject"]) == right])]
    return f"<p>Relations between a subject's own answers are violated: {', '.join(shares)}.</p>" if shares else ""


def sections(page, study, campaign):
    if not campaign:
        return
    if drawn := by_distance(page, campaign):
        yield page.section("distance", "Where methods fail: near zero",
                           "<p>The distance is that of the nearest of the signs which decide a case, in exact "
                           "arithmetic; <i>exact</i> is exact degeneracy. Bars are 95 % intervals; bins of fewer than "
                           "ten cases are left out.</p>",
                           drawn, far_from_zero(campaign))
    if drawn := by_parameter(page, campaign):
        yield page.section("parameters", "Where methods fail: far out, across scales, on slivers", drawn)
    yield page.section("campaign", "The campaign: every subject on every family", of_all_levels(page, campaign),
                       failures(page, campaign))
    for level, title, words in LEVELS:
        if drawn := of_both_poses(page, campaign, level):
            yield page.section(f"level-{level}", title, f"<p>{words}</p>", drawn, contradictions(campaign, level))
    if drawn := families(page, campaign):
        yield page.section("families", "Which family breaks whom",
                           "<p>Each subject is counted by the questions that it knows: a library of surfaces by those "
                           "of surfaces. Cases whose poses have fractions are rows of their own.</p>", drawn)
    if campaign.tables["families"]:
        yield page.section("family-list", "What the families are",
                           "<p>The generators of cases. A family's parameter takes its values in turn; the panel is where the charts of the "
                           "campaign have it.</p>", described_families(page, campaign))
