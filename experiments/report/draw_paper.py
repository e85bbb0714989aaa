#!/usr/bin/python3
"""OUT/paper.csv -> OUT/paper.svg, OUT/paper.pdf, and the tables on the terminal.  usage: draw_paper.py OUT

It puts four questions of JS08, sections 4 and 2.3.1, to the paper's own tree. What does adjusting bounding tetrahedra cost? Which depth suits a
relative size? How do tests go with that size? Does it matter that the moving body turns?
"""

import matplotlib.pyplot as plt

from race_data import BLUE, GREY, ORANGE, VERMILION, answers, fitness, judged, read, save, wrong
from report_data import geometric_mean

PUBLISHED = "published"
STILL = " not turning"
TRAJECTORIES = ("circular", "contour")
COLOURS = {"circular": BLUE, "contour": VERMILION}


def turning(rows):
    return [r for r in rows if not r["scenario"].endswith(STILL)]


def pick(rows, **only):
    return [r for r in rows if all(r[k] == v for k, v in only.items())]


def ratios_of(rows):
    return sorted({r["ratio"] for r in rows})


def sizes_of(rows):
    """The objects with their triangles, in order."""
    return list(dict.fromkeys((r["object"], r["triangles"]) for r in rows))


def mean(rows, value):
    return geometric_mean(r[value] for r in rows if r[value])


def adjustment(rows):
    """{way of adjusting: (build, time, primitive tests over those without a round)} over all trajectories and sizes."""
    rows = turning(rows)
    ways = [s for s in dict.fromkeys(r["subject"] for r in rows) if s.startswith("adjusted ")]
    none = {(r["scenario"], r["object"], r["ratio"]): r for r in rows if r["subject"] == ways[0]}
    over = {}
    for way in ways:
        mine = [(r, none[r["scenario"], r["object"], r["ratio"]]) for r in rows if r["subject"] == way]
        over[way.split(" ", 1)[1]] = [geometric_mean(r[v] / n[v] for r, n in mine if n[v] and r[v])
                                      for v in ("build_ms", "mean_ns", "primitive_tests")]
    return over


def depths(rows, object_, scenario):
    """{(depth of A, depth of B): {ratio: frames a second}}"""
    found = {}
    for r in pick(turning(rows), object=object_, scenario=scenario):
        if r["subject"].startswith("depth "):
            _, a, _, b = r["subject"].split()
            found.setdefault((int(a), int(b)), {})[r["ratio"]] = 1e9 / r["mean_ns"]
    return found


def best_depth(rows, object_, scenario, ratio):
    by_depth = {d: of[ratio] for d, of in depths(rows, object_, scenario).items()}
    return max(by_depth, key=by_depth.get)


def draw(out, rows):
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 5.2))
    figure.subplots_adjust(hspace=0.5, wspace=0.35)
    (object_, triangles), ratios = sizes_of(rows)[-1], ratios_of(rows)
    ways = adjustment(rows)
    for k, (name, colour) in enumerate((("build", BLUE), ("a query", VERMILION), ("edge-face tests", ORANGE))):
        axes[0, 0].barh([y + 0.25 * (k - 1) for y in range(len(ways))], [w[k] for w in ways.values()], height=0.22, color=colour, label=name)
    axes[0, 0].axvline(1, color=GREY, lw=0.8)
    axes[0, 0].set_yticks(range(len(ways)), list(ways))
    axes[0, 0].invert_yaxis()
    axes[0, 0].set_title("adjusted tetrahedra, over no round", loc="left")
    axes[0, 0].legend(fontsize=6.5, frameon=False)
    axis = axes[0, 1]
    for trajectory in TRAJECTORIES:
        of = depths(rows, object_, trajectory)
        for depth, rates in of.items():
            if depth[0] == depth[1]:
                axis.plot(ratios, [rates[x] for x in ratios], color=COLOURS[trajectory], lw=0.6 + 0.3 * (depth[0] - min(d[0] for d in of)), marker="o", ms=2.5)
        best = [best_depth(rows, object_, trajectory, x) for x in ratios]
        axis.plot(ratios, [of[d][x] for d, x in zip(best, ratios)], color=COLOURS[trajectory], ls=":", lw=1)
    axis.set_yscale("log")
    axis.set_title(f"frames a second by depth (deeper: thicker; dotted: the best), {object_}", loc="left", fontsize=7)
    for axis, value, title in ((axes[1, 0], ("bounding_tests", "primitive_tests"), "tests a query, as published"), (axes[1, 1], ("mean_ns",), "not turning: time over turning")):
        for trajectory in TRAJECTORIES:
            mine = {r["ratio"]: r for r in pick(rows, object=object_, scenario=trajectory, subject=PUBLISHED)}
            if axis is axes[1, 0]:
                for v, style in zip(value, ("-", "--")):
                    axis.plot(ratios, [max(mine[x][v], 0.1) for x in ratios], color=COLOURS[trajectory], ls=style, marker="o", ms=3, label=f"{trajectory}, {'bounding volumes' if v == value[0] else 'edges and faces'}")
            else:
                still = {r["ratio"]: r for r in pick(rows, object=object_, scenario=trajectory + STILL, subject=PUBLISHED)}
                axis.plot(ratios, [still[x]["mean_ns"] / mine[x]["mean_ns"] for x in ratios], color=COLOURS[trajectory], marker="o", ms=3, label=trajectory)
        axis.set_yscale("log")
        axis.set_title(title, loc="left")
        axis.legend(fontsize=6.5, frameon=False)
    axes[1, 1].axhline(1, color=GREY, lw=0.8)
    for axis in (axes[0, 1], axes[1, 0], axes[1, 1]):
        axis.set_xscale("log", base=2)
        axis.set_xticks(ratios, [f"1:{x:.0f}" for x in ratios])
        axis.minorticks_off()
        axis.set_xlabel("relative size")
        axis.grid()
    save(figure, out, "paper")


def summary(rows):
    print("adjusting bounding tetrahedra, over no round: build, time of a query, edge-face tests")
    for name, values in adjustment(rows).items():
        print(f"  {name:20}" + "".join(f"{v:8.3f}" for v in values))
    ratios = ratios_of(rows)
    print("\nthe depths of A and B with the most frames a second, and these over those of the depth by the number of vertices")
    print(" " * 30 + "".join(f"{f'1:{x:.0f}':>16}" for x in ratios))
    for object_, triangles in sizes_of(rows):
        for trajectory in TRAJECTORIES:
            cells = []
            for x in ratios:
                best = best_depth(rows, object_, trajectory, x)
                by_size = pick(rows, object=object_, scenario=trajectory, ratio=x, subject=PUBLISHED)[0]
                cells.append(f"{best[0]}, {best[1]}: {depths(rows, object_, trajectory)[best][x] * by_size['mean_ns'] / 1e9:.2f} x")
            print(f"  {object_:8}{triangles:6.0f} {trajectory:12}" + "".join(f"{c:>16}" for c in cells))
    print("\ntests a query as published: bounding volumes, edges against faces; frames a second")
    for object_, triangles in sizes_of(rows):
        for scenario in TRAJECTORIES + tuple(t + STILL for t in TRAJECTORIES):
            mine = {r["ratio"]: r for r in pick(rows, object=object_, scenario=scenario, subject=PUBLISHED)}
            cells = "".join(f"{mine[x]['bounding_tests']:8.0f}{mine[x]['primitive_tests']:9.0f}{1e9 / mine[x]['mean_ns']:9.0f}" for x in ratios)
            print(f"  {object_:8}{triangles:6.0f} {scenario:21}{cells}")
    still, moving = ([r for r in rows if r["subject"] == PUBLISHED and r["scenario"].endswith(STILL) == s] for s in (True, False))
    print(f"\nB not turning over B turning, as published: time {mean(still, 'mean_ns') / mean(moving, 'mean_ns'):.2f}, "
          f"bounding tests {mean(still, 'bounding_tests') / mean(moving, 'bounding_tests'):.2f}")
    bad = [f"{s} {wrong(rows, s)} of {answers(rows, s)}" for s in dict.fromkeys(r["subject"] for r in rows) if wrong(rows, s)]
    print("  wrong: " + (", ".join(bad) or "none"))
    print("  " + judged(rows))
    print("  " + fitness(rows))


def main():
    out, rows = read("paper")
    draw(out, rows)
    summary(rows)


if __name__ == "__main__":
    main()
