#!/usr/bin/python3
"""OUT/scaling.csv -> OUT/scaling.svg, OUT/scaling.pdf, and the fitted exponents on the terminal.  usage: draw_scaling.py OUT"""

import matplotlib.pyplot as plt

from race_data import COLOURS, GREEN, GREY, OURS, SHORT, answers, fitness, judged, exponent, read, save, wrong
from report_style import label_ends


def curve(rows, subject, value, **only):
    """Triangles and values, ascending."""
    some = sorted((r["triangles"], r[value]) for r in rows if r["subject"] == subject and all(r[k] == v for k, v in only.items()))
    return [x for x, _ in some], [y for _, y in some]


def panel(axis, rows, value, unit, title, **only):
    ends = []
    for subject in dict.fromkeys(r["subject"] for r in rows):
        x, y = curve(rows, subject, value, **only)
        if not x:
            continue
        colour = COLOURS.get(subject, GREY)
        axis.plot(x, [v * unit for v in y], color=colour, marker="o", ms=3, lw=1.2)
        ends.append((x[-1], y[-1] * unit, f"{SHORT.get(subject, subject)} {exponent(x, y):+.2f}", colour))
    axis.set(xscale="log", yscale="log", xlabel="triangles of a body")
    axis.set_title(title, loc="left")
    axis.grid()
    return ends


def shares(axis, rows):
    """How much of the tree queries made."""
    ends = []
    for name, value, style in (("one query", "nodes_after_one", ":"), ("a hundred", "nodes_after_hundred", "-")):
        for object_ in ("blob", "knot"):
            x, made = curve(rows, OURS, value, scenario="contour", object=object_)
            _, all_ = curve(rows, OURS, "nodes", scenario="contour", object=object_)
            y = [100 * m / a for m, a in zip(made, all_)]
            axis.plot(x, y, color=GREEN, ls=style, marker="o" if object_ == "blob" else "s", ms=3, lw=1.2)
            ends.append((x[-1], y[-1], f"{name}, {object_}", GREEN))
    axis.set(xscale="log", yscale="log", xlabel="triangles of a body")
    axis.set_title("nodes made on demand, % of the tree, contour", loc="left")
    axis.grid()
    return ends


def draw(out, rows):
    figure, axes = plt.subplots(3, 2, figsize=(7.2, 7.4))
    figure.subplots_adjust(wspace=0.8, hspace=0.45, right=0.86)
    ends = [(axis, panel(axis, rows, "mean_ns", 1e-3, f"µs a query, {scenario}, {object_}", scenario=scenario, object=object_))
            for axis, (scenario, object_) in zip(axes.flat, [(s, o) for s in ("circular", "contour") for o in ("blob", "knot")])]
    ends.append((axes[2, 0], panel(axes[2, 0], rows, "build_ms", 1, "ms to build both, blob", scenario="contour", object="blob")))
    ends.append((axes[2, 1], shares(axes[2, 1], rows)))
    for axis, names in ends:
        label_ends(axis, names)
    save(figure, out, "scaling")


def main():
    out, rows = read("scaling")
    draw(out, rows)
    print("exponents e of t ~ triangles^e, fitted; from the fewest to the most triangles")
    for subject in dict.fromkeys(r["subject"] for r in rows):
        queries = {}
        for scenario in ("circular", "contour"):
            for object_ in ("blob", "knot"):
                queries[f"{scenario} {object_}"] = curve(rows, subject, "mean_ns", scenario=scenario, object=object_)
        x, build = curve(rows, subject, "build_ms", scenario="contour", object="blob")
        _, memory = curve(rows, subject, "bytes_per_triangle", scenario="contour", object="blob")
        print(f"  {subject}: {x[0]:.0f} to {x[-1]:.0f} triangles, wrong {wrong(rows, subject)} of {answers(rows, subject)}")
        print("    query " + ", ".join(f"{name} {exponent(*xy):+.2f} ({xy[1][0] / 1e3:.3g} to {xy[1][-1] / 1e3:.3g} µs)" for name, xy in queries.items()))
        print(f"    build {exponent(x, build):+.2f} ({build[0]:.3g} to {build[-1]:.3g} ms), {memory[-1]:.0f} bytes a triangle of the heap")
    for object_ in ("blob", "knot"):
        _, one = curve(rows, OURS, "nodes_after_one", scenario="contour", object=object_)
        _, hundred = curve(rows, OURS, "nodes_after_hundred", scenario="contour", object=object_)
        x, all_ = curve(rows, OURS, "nodes", scenario="contour", object=object_)
        print(f"  on demand, {object_} of {x[-1]:.0f}, contour: {100 * one[-1] / all_[-1]:.2g} % of the nodes made by one query, {100 * hundred[-1] / all_[-1]:.2g} % by a hundred")
    print("  " + judged(rows))
    print("  " + fitness(rows))


if __name__ == "__main__":
    main()
