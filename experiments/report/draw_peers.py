#!/usr/bin/python3
"""OUT/peers.csv -> OUT/peers.svg, OUT/peers.pdf, and the means on the terminal.  usage: draw_peers.py OUT"""

import math

import matplotlib.pyplot as plt

from race_data import COLOURS, EPECK, EPICK, FCL, GREY, IN_DOUBLE, LAST_FRAME, OURS, PAPER, PUBLISHED, against, answers, course, fitness, in_motion, is_near, judged, read, save, with_interval, wrong
from report_data import geometric_mean


def label(row):
    if row["degenerate"]:
        return row["scenario"]
    return f'{row["scenario"]} {row["object"]} {row["triangles"] / 1000:.3g}k 1:{row["ratio"]:.0f}'


def draw(out, rows):
    rows = [r for r in rows if r["question"] == "surface" and r["mean_ns"]]  # a program may tell no time
    names = list(dict.fromkeys(label(r) for r in rows))
    place = {name: -k for k, name in enumerate(names)}
    figure, axis = plt.subplots(figsize=(7.2, 0.17 * len(names) + 1.1))
    for subject in dict.fromkeys(r["subject"] for r in rows):
        of = [r for r in rows if r["subject"] == subject]
        colour = COLOURS.get(subject, GREY)
        bad = [bool(r["false_positives"] + r["false_negatives"]) for r in of]
        axis.scatter([r["mean_ns"] / 1e3 for r in of], [place[label(r)] for r in of], s=18, marker="o" if of[0]["exact"] else "D",
                     facecolor=[colour if not b else "none" for b in bad], edgecolor=colour, linewidth=1.1, zorder=3)
    axis.set_yticks(list(place.values()), list(place))
    axis.set_ylim(min(place.values()) - 0.7, 0.7)
    axis.set_xscale("log")
    axis.set_xlabel("mean time of a query, µs (hollow: wrong answers)")
    axis.grid(axis="x")
    axis.tick_params(axis="y", length=0)
    handles = [plt.Line2D([], [], ls="", marker="o" if s in (OURS, LAST_FRAME) else "D", ms=4.5, color=c, label=s) for s, c in COLOURS.items()
               if any(r["subject"] == s for r in rows)]
    handles += [plt.Line2D([], [], ls="", marker="D", ms=4.5, color=GREY, label=f"{s}, by its own clock")
                for s in dict.fromkeys(r["subject"] for r in rows) if s not in COLOURS]
    axis.legend(handles=handles, ncol=4, fontsize=6.5, frameon=False, loc="lower center", bbox_to_anchor=(0.4, 1.0), handletextpad=0.1, columnspacing=1.2)
    save(figure, out, "peers")


def near_contact(rows):
    """The cost of a pair tested, boxes of a node or two elements, in units of the ordinary one; and EPICK's time over ours."""
    def per_pair(r):
        return r["mean_ns"] / (r["pairs_visited"] + r["leaf_pairs"])
    surface = [r for r in rows if r["question"] == "surface"]
    ordinary = geometric_mean(per_pair(r) for r in surface if r["subject"] == OURS and r["scenario"] == "contour")
    epick = {c[0]: v for c, v in against([r for r in surface if r["degenerate"]], EPICK, OURS).items()}
    print(f"\nnear contact: ns for each pair tested (eight boxes, or two elements), contour {ordinary:.0f}")
    for r in surface:
        if r["degenerate"] and r["subject"] == OURS:
            print(f'  {r["scenario"]:16} {per_pair(r):7.0f} = {per_pair(r) / ordinary:5.2f} ordinary ones; {r["exact_fallbacks"]:8.1f} exact signs a query; '
                  f'EPICK takes {epick.get(r["scenario"], math.nan):8.3g} times our {r["mean_ns"] / 1e3:.3g} µs')


def price_of_exactness(rows):
    """The adaptive kernel's time over double's on the same tree, a line a scenario. A line has the geometric mean over workloads, its interval of 95 % by
    their spread, and the range."""
    over = against(rows, OURS, IN_DOUBLE)
    if not over:
        return
    print("\nprice of exactness: time of the adaptive kernel over that of double, on the same tree, both questions")
    for scenario in dict.fromkeys(c[0] for c in over):
        logs = [math.log(v) for c, v in over.items() if c[0] == scenario]
        mean = sum(logs) / len(logs)
        half = 1.96 * math.sqrt(sum((x - mean) ** 2 for x in logs) / max(len(logs) - 1, 1) / len(logs))
        print(f"  {scenario:16} {math.exp(mean):6.3f} ({math.exp(mean - half):.3f} .. {math.exp(mean + half):.3f})"
              f"   [{math.exp(min(logs)):.3f}, {math.exp(max(logs)):.3f}] of {len(logs)}")


def cold(rows):
    """FCL's time over ours on the first query after making both bodies ready, that included or not, and with empty caches."""
    of = {(course(r), r["subject"]): r for r in rows if r["question"] == "surface" and not r["degenerate"]}
    both = [(of[c, OURS], of[c, FCL]) for c, s in of if s == OURS and (c, FCL) in of and of[c, OURS].get("cold_ns")]
    if not both:
        return
    print("\nmeans over poses spread over each trajectory, geometric means over these: tetracone, FCL, FCL over tetracone [least, most]")
    for name, value in (("caches empty, ns", lambda r: r["cold_ns"]),
                        ("the same poses with caches full, ns", lambda r: r["warm_ns"]),
                        ("first query of bodies just made, µs", lambda r: 1e3 * r["first_query_ms"]),
                        ("making them, with the first query, µs", lambda r: 1e3 * (r["first_build_ms"] + r["first_query_ms"]))):
        ratios = [value(f) / value(o) for o, f in both if value(o) > 0 and value(f) > 0]
        mine, its = (geometric_mean(value(r) for r in rs if value(r) > 0) for rs in zip(*both))
        print(f"  {name:40} {mine:9.4g} {its:9.4g} {geometric_mean(ratios):8.3g} [{min(ratios):.3g}, {max(ratios):.3g}]")


def summary(rows):
    ordinary = in_motion(rows)
    surface = [r for r in ordinary if r["question"] == "surface"]
    subjects = list(dict.fromkeys(r["subject"] for r in rows))
    print("mean time of a query over tetracone's in motion, geometric mean over courses (its 95 % interval, by resampling them) [least, most]; wrong answers")
    near = [r for r in rows if is_near(r)]
    for subject in subjects:
        ratios = against(surface, subject, OURS)
        if not ratios:
            continue
        print(f"  {subject:34} {with_interval(ratios.values()):22} [{min(ratios.values()):.3g}, {max(ratios.values()):.3g}]"
              f"   in motion {wrong(ordinary, subject)} of {answers(ordinary, subject)}, near contact {wrong(near, subject)} of {answers(near, subject)}")
    print("  " + judged(rows))
    print("  " + fitness(surface))
    for scenario in dict.fromkeys(r["scenario"] for r in near):
        mine = [r for r in near if r["scenario"] == scenario]
        bad = [f"{s} {wrong(mine, s)} of {answers(mine, s)}" for s in subjects if wrong(mine, s)]
        print(f"  wrong near contact, {scenario}: " + (", ".join(bad) or "none"))
    fcl = against(surface, FCL, OURS)
    if fcl:
        print("\nFCL's time over tetracone's by workload")
        for scenario in ("circular", "contour"):
            for ratio in (1, 8):
                some = {c: v for c, v in fcl.items() if c[0] == scenario and c[3] == ratio}
                print(f"  {scenario:9} 1:{ratio}  {geometric_mean(some.values()):5.2f}   " + ", ".join(f"{c[1]} {c[2] / 1000:.3g}k {v:.2f}" for c, v in some.items()))
    cold(rows)
    near_contact(rows)
    price_of_exactness(rows)
    print()
    if fcl:
        large = [r for r in surface if r["triangles"] > 2000]
        build = against(large, OURS, FCL, "build_ms")
        print(f"build over FCL's {geometric_mean(build.values()):.2f}; built on demand with the first hundred queries, over FCL's build alone "
              f"{geometric_mean(first_hundred(large).values()):.2f}")
    for subject in (OURS, FCL, EPICK, EPECK, PAPER, PUBLISHED):
        sizes = [r["bytes_per_triangle"] for r in surface if r["subject"] == subject and r["triangles"] > 2000]
        if sizes:
            print(f"  {subject:34} {geometric_mean(sizes):6.0f} bytes a triangle of the heap, the copy of the mesh included")
    sizes = [r["tree_bytes_per_triangle"] for r in surface if r["subject"] == OURS and r["triangles"] > 2000]
    if sizes:
        print(f"  {OURS:34} {geometric_mean(sizes):6.0f} bytes a triangle of tree and tables, the model excluded")
    solid, asked = [r for r in ordinary if r["question"] == "solid" and r["subject"] == OURS], {}
    for r in surface:
        if r["subject"] == OURS:
            asked[r["scenario"], r["object"], r["triangles"], r["ratio"]] = r["mean_ns"]
    over = [r["mean_ns"] / asked[r["scenario"], r["object"], r["triangles"], r["ratio"]] for r in solid]
    print(f"solid over surface, mean time: {geometric_mean(over):.3f}")


def first_hundred(rows):
    """Ours on demand with a hundred queries over FCL's build alone."""
    fcl = {(r["scenario"], r["object"], r["triangles"], r["ratio"]): r["build_ms"] for r in rows if r["subject"] == FCL}
    ours = {(r["scenario"], r["object"], r["triangles"], r["ratio"]): r["build_and_hundred_ms"] for r in rows if r["subject"] == OURS}
    return {c: ours[c] / fcl[c] for c in ours if c in fcl}


def main():
    out, rows = read("peers")
    draw(out, rows)
    summary(rows)


if __name__ == "__main__":
    main()
