"""Figure 5, the paper's own study: its Figs. 16 and 17 on this machine, and what each stage that discards is worth."""

import html

import matplotlib.pyplot as plt

from report_data import distinct, duration, percent, times
from report_style import BLUE, GREY, INK, ORANGE, SKY, WIDTH, colour_of, label_ends, mark
from study_data import workload

STATED = 50           # frames per second: the paper, section 4
TRAJECTORIES = ("circular", "contour")
PAPER_HORSE = (3582, 7172)  # vertices and triangles that the paper gives


def fps(row):
    return 1e9 / max(row["mean_ns"], 1)


def rate(x):
    return f"{x:,.0f}" if x >= 100 else f"{x:.3g}"


def chosen(study, names):
    return [s for s in names if s in study.subjects]


def frames_per_second(page, study):
    subjects = chosen(study, ("adaptive tree", "adaptive paper", "double paper", "epick tree", "epeck tree", "FCL OBBRSS"))
    fig, axes = plt.subplots(1, 2, figsize=(WIDTH, 3.4), sharey=True, sharex=True)
    lines, used = [], []
    for axis, trajectory in zip(axes, TRAJECTORIES):
        rows = [r for r in study.rows if r["scenario"] == trajectory and r["ratio"] == 1]
        used += [r for r in rows if r["subject"] in subjects]
        pairs = distinct((r["a"], r["b"]) for r in rows)
        for y, pair in enumerate(pairs):
            for k, subject in enumerate(subjects):
                for r in rows:
                    if (r["a"], r["b"]) != pair or r["subject"] != subject:
                        continue
                    axis.plot(fps(r), y + 0.09 * (k - (len(subjects) - 1) / 2), label=subject if y == 0 else None,
                              **{**mark(r["kernel"], r["method"], r["exact"]), "ms": 4})
                    lines.append([trajectory, *pair, subject, f"{fps(r):.6g}", int(r["poses"]), int(r["collisions"]), int(r["wrong"])])
        axis.axvline(STATED, color=GREY, lw=0.9, ls="--")
        axis.text(STATED * 1.15, -0.78, "the paper: over 50", fontsize=6.5, color=INK)
        axis.set_xscale("log")
        axis.set_xlim(25, None)
        axis.set_ylim(len(pairs) - 0.4, -1.15)
        axis.set_yticks(range(len(pairs)), [f"{a} / {b}" for a, b in pairs])
        axis.set_title(trajectory)
        axis.set_xlabel("frames per second")
        axis.grid(True)
    handles, names = axes[0].get_legend_handles_labels()
    fig.legend(handles, names, ncol=len(names), fontsize=6.5, frameon=False, loc="lower center", handletextpad=0.1, columnspacing=1.0)
    fig.tight_layout(rect=(0, 0.05, 1, 1), w_pad=0.5)
    source = study.source("How many frames per second, for all pairs of the four objects (Fig. 16 again)?", used)
    data = page.table("frames_per_second", ["trajectory", "a", "b", "subject", "frames_per_second", "poses", "collisions", "wrong"], lines,
                      source)
    return page.figure("frames_per_second", fig, source, data)


def largest_pair(study):
    """The rows of the pair that is there at several relative sizes."""
    pairs = {(r["a"], r["b"]) for r in study.rows if r["regime"] == "trajectory" and r["ratio"] > 1}
    return [r for r in study.rows if r["regime"] == "trajectory" and (r["a"], r["b"]) in pairs]


def relative_sizes(page, study):
    subjects = chosen(study, ("adaptive tree", "adaptive paper", "double paper", "epick tree", "epeck tree", "FCL OBBRSS"))
    all_rows = [r for r in largest_pair(study) if r["subject"] in subjects]
    if not all_rows:
        return ""
    fig, axes = plt.subplots(1, 2, figsize=(WIDTH, 2.5), sharey=True)
    lines, ends = [], []
    for axis, trajectory in zip(axes, TRAJECTORIES):
        for subject in subjects:
            rows = sorted((r for r in all_rows if r["scenario"] == trajectory and r["subject"] == subject), key=lambda r: r["ratio"])
            if not rows:
                continue
            x, y = [r["ratio"] for r in rows], [fps(r) for r in rows]
            colour = colour_of(rows[0]["kernel"])
            axis.plot(x, y, **{**mark(rows[0]["kernel"], rows[0]["method"], rows[0]["exact"]), "ls": "-", "lw": 1.0, "ms": 4})
            if axis is axes[-1]:
                ends.append((x[-1], y[-1], subject, colour))
            lines += [[trajectory, subject, int(r["ratio"]), f"{fps(r):.6g}", int(r["wrong"])] for r in rows]
        axis.axhline(STATED, color=GREY, lw=0.9, ls="--")
        axis.set_xscale("log", base=2)
        axis.set_yscale("log")
        ratios = sorted({r["ratio"] for r in all_rows})
        axis.set_xticks(ratios, [f"1:{x:.0f}" for x in ratios])
        axis.minorticks_off()
        axis.set_title(trajectory)
        axis.set_xlabel("relative size of the largest mesh and itself")
        axis.grid(True)
    axes[0].set_ylabel("frames per second")
    fig.tight_layout(rect=(0, 0, 0.88, 1), w_pad=0.5)
    label_ends(axes[-1], ends)
    source = study.source("Do frames per second grow with the relative size (Fig. 17 again)?", all_rows)
    data = page.table("relative_sizes", ["trajectory", "subject", "ratio", "frames_per_second", "wrong"], lines, source)
    return page.figure("relative_sizes", fig, source, data)


def beside_the_paper(study):
    """What the paper states, and what this machine says to it, subject by subject."""
    body, large = [], largest_pair(study)
    for subject in chosen(study, ("double paper", "adaptive paper", "adaptive tree", "epick tree", "epeck tree", "FCL OBBRSS")):
        cells = [html.escape(subject)]
        mine = [r for r in study.rows if r["regime"] == "trajectory" and r["subject"] == subject]
        below = sum(fps(r) <= STATED for r in mine)
        slowest = min(mine, key=fps)
        cells.append(("holds" if below == 0 else f"<b>not</b> in {below} of {len(mine)}") + f"; slowest {rate(fps(slowest))} "
                     f"({slowest['scenario']}, {slowest['a']} / {slowest['b']})")
        for trajectory in TRAJECTORIES:
            rows = sorted((r for r in large if r["scenario"] == trajectory and r["subject"] == subject), key=lambda r: r["ratio"])
            if len(rows) < 2:
                cells.append("–")
                continue
            rates = [fps(r) for r in rows]
            grows = all(a < b for a, b in zip(rates, rates[1:]))
            cells.append(("holds" if grows else "<b>not</b> at every step") + f"; 1:{rows[-1]['ratio']:.0f} has "
                         f"{times(rates[-1] / rates[0])} times the frames of 1:1")
        body.append((slowest["exact"], cells))
    return body


def stages(page, study):
    """What each stage of the paper's method does, a query: of the pairs of nodes visited, which stage discards what share."""
    rows = [r for r in study.rows if r["regime"] == "trajectory" and r["ratio"] == 1 and r["a"] == r["b"]
            and r["subject"] in ("double paper", "adaptive paper", "adaptive tree")]
    if not rows:
        return ""
    peer = {workload(r): r["mean_ns"] for r in study.rows if r["method"] == "peer"}
    kinds = (("discarded_by_hull", "regular hull (Theorem 2)", BLUE), ("discarded_by_sphere", "bounding spheres", SKY),
             ("discarded_by_tetrahedron", "bounding tetrahedra", ORANGE))
    drawn = [r for r in rows if r["subject"] == "double paper"] or rows
    fig, axis = plt.subplots(figsize=(WIDTH, 0.9 + 0.24 * len(drawn)))
    lines, body = [], []
    for y, r in enumerate(drawn):
        left = 0
        for key, label, colour in kinds:
            part = r[key] / max(sum(r[k] for k, _, _ in kinds), 1e-9)
            axis.barh(y, 100 * part, left=left, color=colour, height=0.7, label=label if y == 0 else None)
            if part > 0.06:
                axis.text(left + 50 * part, y, percent(part), ha="center", va="center", fontsize=6.5,
                          color="#ffffff" if colour == BLUE else "#000000")
            left += 100 * part
        axis.text(left + 0.8, y, f"{r['pairs_visited']:,.0f} pairs, {r['primitive_tests']:,.0f} edge-face tests", va="center", fontsize=6.5)
    axis.set_yticks(range(len(drawn)), [f"{r['scenario']}, {r['a']}" for r in drawn])
    axis.set_ylim(len(drawn) - 0.4, -0.6)
    axis.set_xlim(0, 145)
    axis.set_xticks([0, 25, 50, 75, 100], ["0", "25 %", "50 %", "75 %", "100 %"])
    axis.set_xlabel(f"share of the discarded that each stage discards ({drawn[0]['subject']}); at the right, a query")
    handles, names = axis.get_legend_handles_labels()
    fig.tight_layout(rect=(0, 0, 1, 0.9))
    fig.legend(handles, names, ncol=3, fontsize=6.5, frameon=False, loc="upper center")
    for r in rows:
        against = r["mean_ns"] / peer[workload(r)] if workload(r) in peer else float("nan")
        numbers = [r[k] for k in ("pairs_visited", "discarded_by_hull", "discarded_by_sphere", "discarded_by_tetrahedron",
                                  "primitive_tests")]
        body.append((r["exact"], [r["scenario"], r["a"], r["subject"]] + [f"{x:,.0f}" for x in numbers] +
                     [duration(r["mean_ns"]), times(against) if against == against else "–"]))
        lines.append([r["scenario"], r["a"], r["subject"], *(f"{x:.6g}" for x in numbers), int(r["mean_ns"]),
                      f"{against:.4g}" if against == against else ""])
    source = study.source("What is each stage that discards pairs worth?", rows)
    data = page.table("stages", ["trajectory", "object", "subject", "pairs", "by_theorem_2", "by_sphere", "by_tetrahedron",
                                 "edge_face_tests", "mean_ns", "against_fcl"], lines, source)
    head = ["trajectory", "object", "subject", "pairs a query", "discarded: Theorem 2", "spheres", "tetrahedra", "edge-face tests", "time",
            "time / FCL"]
    return page.figure("stages", fig, source, data) + page.html_table(head, body)


def horse():
    """Euler's formula for the paper's horse."""
    vertices, triangles = PAPER_HORSE
    characteristic = vertices - triangles // 2
    genus = f" (one closed piece would have genus {(2 - characteristic) // 2})" if characteristic <= 2 else ""
    return (f"The paper's horse has {vertices} vertices and {triangles} triangles. Closed, with 3/2 of an edge a triangle, it has the "
            f"Euler characteristic V − F/2 = {characteristic}, where a closed mesh of genus 0 has 2: it cannot be a closed mesh of genus "
            f"0{genus}.")


def sections(page, study, campaign):
    if not study:
        return
    yield page.section("paper", "The paper's time study", f"<p>Jiménez and Segura state, on a Pentium IV of 1.6 GHz, over {STATED} frames "
                       f"per second for all pairs, and more as the relative size grows. {horse()} "
                       "Ours of that size is a closed mesh of another animal.</p>", frames_per_second(page, study),
                       relative_sizes(page, study))
    yield page.section("beside-the-paper", "What the paper states, beside what this machine says",
                       page.html_table(["subject", f"over {STATED} frames per second for all",
                                        *(f"faster as the relative size grows, {t}" for t in TRAJECTORIES)], beside_the_paper(study),
                                       study.source("Do the paper's two statements hold here?",
                                                    [r for r in study.rows if r["regime"] == "trajectory"]), "study.csv"))
    if drawn := stages(page, study):
        yield page.section("stages", "What each stage is worth", drawn)
