#!/usr/bin/python3
"""The report: OUT/study.csv and the tables of a campaign, OUT/tables/verify_*.csv -> OUT/report.html, OUT/figures/*.{svg,pdf}, OUT/tables/*.csv.

Every number in it is computed here from these rows; nothing is written by hand. Either may be missing, not both.
usage: report.py OUT
"""

import csv
import html
import io
import math
import os
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from campaign_sections import Campaign_sections

NUMBERS = ("ratio poses collisions false_positives false_negatives mean_ns median_ns p99_ns build_ms bytes nodes "
           "pairs_visited discarded_by_hull discarded_by_sphere discarded_by_tetrahedron bounding_tests primitive_tests "
           "exact_fallbacks").split()

# Okabe & Ito's palette, safe for colour-blind readers; one colour a kernel, one marker a method.
COLOURS = {"float": "#E69F00", "double": "#D55E00", "double-eps=1e-12": "#CC79A7", "epick": "#56B4E9", "epeck": "#0072B2",
           "rational": "#999999", "adaptive": "#009E73", "FCL": "#000000"}
MARKERS = {"tree": "o", "paper": "^", "brute": "s", "peer": "D"}
CONTAINMENT = ("nested", "in a cavity")
PANELS = (("trajectories", "surface", lambda r: r["regime"] == "trajectory"),
          ("exactly degenerate contact", "surface", lambda r: r["regime"] == "degenerate" and r["scenario"] not in CONTAINMENT),
          ("one inside the other", "solid", lambda r: r["scenario"] in CONTAINMENT))


def read_rows(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for key in NUMBERS:
            row[key] = float(row[key])
        row["exact"] = row["exact"] == "1"
        row["wrong"] = row["false_positives"] + row["false_negatives"]
    return rows


def wilson(wrong, n, z=1.959964):
    """The 95 % interval of a rate of `wrong` in `n`."""
    if n == 0:
        return 0.0, 1.0
    p, zz = wrong / n, z * z
    centre, half = (p + zz / (2 * n)) / (1 + zz / n), z / (1 + zz / n) * math.sqrt(p * (1 - p) / n + zz / (4 * n * n))
    return max(0.0, centre - half), min(1.0, centre + half)


def geometric_mean(values):
    values = [max(v, 1.0) for v in values]
    return math.exp(sum(math.log(v) for v in values) / len(values)) if values else math.nan


def percent(x):
    return "0" if x == 0 else f"{100 * x:.2g} %" if x < 0.1 else f"{100 * x:.0f} %"


def duration(ns):
    for unit, size in (("ns", 1), ("µs", 1e3), ("ms", 1e6), ("s", 1e9)):
        if ns < 1000 * size or unit == "s":
            return f"{ns / size:.3g} {unit}"


def share(wrong, n):
    """A count of wrong answers as the statement that it is."""
    low, high = wilson(wrong, n)
    return f"0 of {n:.0f} (&lt; {percent(high)})" if wrong == 0 else f"{wrong:.0f} of {n:.0f} ({percent(wrong / n)})"


def by(rows, *keys):
    groups = defaultdict(list)
    for row in rows:
        groups[tuple(row[k] for k in keys)].append(row)
    return groups


def workload(row):
    return row["regime"], row["scenario"], row["a"], row["b"], row["ratio"], row["question"]


class Report:
    def __init__(self, out):
        self.out = out
        study = os.path.join(out, "study.csv")
        self.rows = read_rows(study) if os.path.exists(study) else []
        self.share, self.percent = share, percent
        self.subjects = list(dict.fromkeys(r["subject"] for r in self.rows))
        for folder in ("figures", "tables"):
            os.makedirs(os.path.join(out, folder), exist_ok=True)
        self.campaign = Campaign_sections(self)

    # --- files --------------------------------------------------------------------------------------------------------

    def write(self, name, text):
        path = os.path.join(self.out, name)
        part = path + ".part"
        with open(part, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        os.replace(part, path)

    def figure(self, name, fig):
        """Saves the figure as SVG and PDF, and gives the SVG for the page."""
        fig.savefig(os.path.join(self.out, "figures", name + ".pdf"), metadata={"CreationDate": None})
        buffer = io.StringIO()
        fig.savefig(buffer, format="svg", metadata={"Date": None})
        plt.close(fig)
        svg = buffer.getvalue()
        self.write(f"figures/{name}.svg", svg)
        return svg[svg.index("<svg"):]

    def table(self, name, header, lines):
        buffer = io.StringIO()
        csv.writer(buffer, lineterminator="\n").writerows([header] + lines)
        self.write(f"tables/{name}.csv", buffer.getvalue())

    # --- figures ------------------------------------------------------------------------------------------------------

    def points(self, condition, question):
        """Of each subject: (subject, kernel, method, exact, time a query, wrong, asked)."""
        for (subject,), rows in by([r for r in self.rows if r["question"] == question and condition(r)], "subject").items():
            first = rows[0]
            yield (subject, first["kernel"], first["method"], first["exact"], geometric_mean(r["mean_ns"] for r in rows),
                   sum(r["wrong"] for r in rows), sum(r["poses"] for r in rows))

    def speed_against_accuracy(self):
        fig, axes = plt.subplots(1, len(PANELS), figsize=(10.5, 4.4), sharey=True)
        zero, lines, shown = 2e-4, [], {}
        for axis, (title, question, condition) in zip(axes, PANELS):
            points = sorted(self.points(condition, question), key=lambda p: p[4])
            axis.axhspan(zero / 2.2, zero * 2.2, color="#009E73", alpha=0.12, lw=0)
            for subject, kernel, method, exact, ns, wrong, n in points:
                rate = wrong / n if wrong else zero
                low, high = wilson(wrong, n)
                if wrong:
                    axis.plot([ns, ns], [max(low, zero * 2.3), high], color=COLOURS[kernel], lw=1, alpha=0.6, zorder=2)
                axis.plot(ns, rate, MARKERS[method], color=COLOURS[kernel], ms=7, zorder=3,
                          mfc=COLOURS[kernel] if exact else "white", mew=1.6)
                shown.setdefault(kernel, exact)
                if subject in ("adaptive tree", "FCL OBBRSS"):
                    axis.annotate(subject, (ns, rate), xytext=(0, 9), textcoords="offset points", fontsize=7.5, ha="center",
                                  color=COLOURS[kernel], weight="bold")
                lines.append([title, question, subject, kernel, method, int(exact), round(ns), int(wrong), int(n),
                              f"{low:.6g}", f"{high:.6g}"])
            axis.set_xscale("log")
            axis.set_yscale("log")
            axis.set_ylim(zero / 3, 3)
            axis.set_title(f"{title} ({question})", fontsize=10)
            axis.set_xlabel("time per query, ns")
            axis.grid(True, which="major", color="#dddddd", lw=0.6, zorder=0)
        ticks = [zero, 1e-3, 1e-2, 1e-1, 1]
        axes[0].set_yticks(ticks, ["none\nwrong", "0.1 %", "1 %", "10 %", "100 %"])
        axes[0].minorticks_off()
        axes[0].set_ylabel("wrong answers")
        handles = [plt.Line2D([], [], ls="", marker="o", ms=7, color=COLOURS[k], mfc=COLOURS[k] if exact else "white", mew=1.6, label=k)
                   for k, exact in shown.items()]
        handles += [plt.Line2D([], [], ls="", marker=m, ms=6, color="#777777", mfc="#777777", label=name) for name, m in MARKERS.items()]
        fig.legend(handles=handles, ncol=len(handles), fontsize=8, frameon=False, loc="lower center", handletextpad=0.1, columnspacing=1.1)
        fig.tight_layout(rect=(0, 0.07, 1, 1))
        self.table("speed_against_accuracy", ["panel", "question", "subject", "kernel", "method", "exact", "time_ns", "wrong",
                                              "asked", "low_95", "high_95"], lines)
        return self.figure("speed_against_accuracy", fig)

    def frames_per_second(self):
        subjects = [s for s in ("adaptive tree", "adaptive paper", "double paper", "epick tree", "epeck tree", "FCL OBBRSS") if s in self.subjects]
        fig, axes = plt.subplots(1, 2, figsize=(10, 4.4), sharey=True, sharex=True)
        lines = []
        for axis, trajectory in zip(axes, ("circular", "contour")):
            rows = [r for r in self.rows if r["scenario"] == trajectory and r["ratio"] == 1]
            pairs = list(dict.fromkeys((r["a"], r["b"]) for r in rows))
            for y, pair in enumerate(pairs):
                for subject in subjects:
                    for r in rows:
                        if (r["a"], r["b"]) != pair or r["subject"] != subject:
                            continue
                        fps = 1e9 / max(r["mean_ns"], 1)
                        axis.plot(fps, y, MARKERS[r["method"]], color=COLOURS[r["kernel"]], ms=6, label=subject if y == 0 else None,
                                  mfc=COLOURS[r["kernel"]] if r["exact"] else "white", mew=1.5)
                        lines.append([trajectory, *pair, subject, f"{fps:.6g}", int(r["poses"]), int(r["collisions"]), int(r["wrong"])])
            axis.axvline(50, color="#888888", lw=1, ls="--")
            axis.text(55, -0.72, "the paper: over 50 for all", fontsize=7.5, color="#555555")
            axis.set_xscale("log")
            axis.set_ylim(len(pairs) - 0.4, -1.1)
            axis.set_yticks(range(len(pairs)), [f"{a} / {b}" for a, b in pairs])
            axis.set_title(trajectory, fontsize=10)
            axis.set_xlabel("frames per second")
            axis.grid(True, color="#dddddd", lw=0.6)
        handles, names = axes[0].get_legend_handles_labels()
        fig.legend(handles, names, ncol=len(names), fontsize=8, frameon=False, loc="lower center")
        fig.tight_layout(rect=(0, 0.06, 1, 1))
        self.table("frames_per_second", ["trajectory", "a", "b", "subject", "frames_per_second", "poses", "collisions", "wrong"], lines)
        return self.figure("frames_per_second", fig)

    def relative_sizes(self):
        subjects = [s for s in ("adaptive tree", "adaptive paper", "double paper", "FCL OBBRSS") if s in self.subjects]
        fig, axes = plt.subplots(1, 2, figsize=(9, 3.6), sharey=True)
        lines = []
        for axis, trajectory in zip(axes, ("circular", "contour")):
            for subject in subjects:
                rows = sorted((r for r in self.rows if r["scenario"] == trajectory and r["subject"] == subject
                               and r["a"] == r["b"] == "horse-size"), key=lambda r: r["ratio"])
                if not rows:
                    continue
                x, y, kernel = [r["ratio"] for r in rows], [1e9 / max(r["mean_ns"], 1) for r in rows], rows[0]["kernel"]
                axis.plot(x, y, "-" + MARKERS[rows[0]["method"]], color=COLOURS[kernel], mfc=COLOURS[kernel] if rows[0]["exact"] else "white", lw=1.3)
                axis.annotate(subject, (x[-1], y[-1]), xytext=(6, 0), textcoords="offset points", fontsize=8, color=COLOURS[kernel], va="center")
                lines += [[trajectory, subject, int(r["ratio"]), f"{1e9 / max(r['mean_ns'], 1):.6g}", int(r["wrong"])] for r in rows]
            axis.set_xscale("log", base=2)
            axis.set_yscale("log")
            axis.set_xticks([1, 2, 4, 8, 16], ["1:1", "1:2", "1:4", "1:8", "1:16"])
            axis.set_xlim(0.9, 40)
            axis.set_title(trajectory, fontsize=10)
            axis.set_xlabel("relative size of the horse-sized mesh and itself")
            axis.grid(True, color="#dddddd", lw=0.6)
        axes[0].set_ylabel("frames per second")
        fig.tight_layout()
        self.table("relative_sizes", ["trajectory", "subject", "ratio", "frames_per_second", "wrong"], lines)
        return self.figure("relative_sizes", fig)

    # --- tables -------------------------------------------------------------------------------------------------------

    def summary(self):
        """A line a subject: wrong answers in each regime, time, and time against FCL on the same workloads."""
        peer = {workload(r): r["mean_ns"] for r in self.rows if r["method"] == "peer"}
        head = ["subject", "trajectories: wrong", "time", "time / FCL", "exact contact: wrong (missed, invented)", "containment: wrong"]
        lines, body = [], []
        for subject in self.subjects:
            mine = [r for r in self.rows if r["subject"] == subject]
            on = [[r for r in mine if condition(r) and r["question"] == question] for _, question, condition in PANELS]
            counts = [(sum(r["wrong"] for r in rows), sum(r["poses"] for r in rows)) for rows in on]
            ns = geometric_mean(r["mean_ns"] for r in on[0])
            against = geometric_mean(1e6 * r["mean_ns"] / peer[workload(r)] for r in on[0] if workload(r) in peer) / 1e6
            missed, invented = sum(r["false_negatives"] for r in on[1]), sum(r["false_positives"] for r in on[1])
            lines.append([subject, *(int(x) for pair in counts for x in pair), round(ns) if on[0] else "", f"{against:.4g}", int(missed), int(invented)])
            cells = [html.escape(subject), share(*counts[0]) if counts[0][1] else "–", duration(ns) if on[0] else "–",
                     f"{against:.2g}" if not math.isnan(against) else "–",
                     (share(*counts[1]) + (f": {missed:.0f}, {invented:.0f}" if counts[1][0] else "")) if counts[1][1] else "–",
                     share(*counts[2]) if counts[2][1] else "–"]
            body.append((mine[0]["exact"], cells))
        self.table("summary", ["subject", "trajectories_wrong", "trajectories_asked", "contact_wrong", "contact_asked", "containment_wrong",
                               "containment_asked", "trajectories_ns", "against_fcl", "contact_missed", "contact_invented"], lines)
        return self.html_table(head, body)

    def degenerate(self):
        rows = [r for r in self.rows if r["regime"] == "degenerate"]
        scenarios = list(dict.fromkeys((r["scenario"], r["question"]) for r in rows))
        subjects = list(dict.fromkeys(r["subject"] for r in rows))
        cell = {(r["scenario"], r["question"], r["subject"]): r for r in rows}
        body, lines = [], []
        for scenario, question in scenarios:
            cells = [f"{scenario}<br><small>{question}, {max(r['poses'] for r in rows if r['scenario'] == scenario):.0f} poses</small>"]
            for subject in subjects:
                r = cell.get((scenario, question, subject))
                cells.append("–" if r is None else "0" if r["wrong"] == 0 else
                             f"<b>{percent(r['wrong'] / r['poses'])}</b><br><small>{r['false_negatives']:.0f}, {r['false_positives']:.0f}</small>")
                if r is not None:
                    lines.append([scenario, question, subject, int(r["poses"]), int(r["collisions"]), int(r["false_positives"]), int(r["false_negatives"])])
            body.append((False, cells))
        self.table("degenerate", ["scenario", "question", "subject", "n", "collisions", "false_positives", "false_negatives"], lines)
        return self.html_table(["contact"] + [html.escape(s) for s in subjects], body)

    def stages(self):
        """What each stage of the paper's method does, a query."""
        head = ["trajectory", "objects", "subject", "pairs", "discarded: Theorem 2", "spheres", "tetrahedra", "edge-face tests", "time", "time / FCL"]
        peer = {workload(r): r["mean_ns"] for r in self.rows if r["method"] == "peer"}
        body, lines = [], []
        for r in self.rows:
            if r["regime"] != "trajectory" or r["ratio"] != 1 or r["a"] != r["b"] or r["subject"] not in ("double paper", "adaptive paper", "adaptive tree"):
                continue
            against = r["mean_ns"] / peer[workload(r)] if workload(r) in peer else math.nan
            numbers = [r["pairs_visited"], r["discarded_by_hull"], r["discarded_by_sphere"], r["discarded_by_tetrahedron"], r["primitive_tests"]]
            body.append((r["exact"], [r["scenario"], r["a"], r["subject"]] + [f"{x:,.0f}" for x in numbers] +
                         [duration(r["mean_ns"]), "–" if math.isnan(against) else f"{against:.2g}"]))
            lines.append([r["scenario"], r["a"], r["subject"], *(f"{x:.6g}" for x in numbers), int(r["mean_ns"]), f"{against:.4g}"])
        self.table("stages", ["trajectory", "object", "subject", "pairs", "by_theorem_2", "by_sphere", "by_tetrahedron", "edge_face_tests", "mean_ns", "against_fcl"], lines)
        return self.html_table(head, body)

    @staticmethod
    def html_table(head, body):
        rows = "".join("<tr%s>%s</tr>" % (' class="exact"' if exact else "", "".join(f"<td>{c}</td>" for c in cells)) for exact, cells in body)
        return f"<div class=scroll><table><thead><tr>{''.join(f'<th>{h}</th>' for h in head)}</tr></thead><tbody>{rows}</tbody></table></div>"

    # --- the page -----------------------------------------------------------------------------------------------------

    def claim(self):
        if not self.rows:
            return "What a campaign of tetracone verify found."
        exact = [r for r in self.rows if r["exact"]]
        wrong, asked = sum(r["wrong"] for r in exact), sum(r["poses"] for r in exact)
        verdict = f"The exact kernels (adaptive, EPECK, rational) gave <b>{wrong:.0f} wrong answers of {asked:,.0f}</b>."
        parts = []
        for name in ("float tree", "double tree", "epick tree", "FCL OBBRSS"):
            rows = [r for r in self.rows if r["subject"] == name and r["regime"] == "degenerate" and r["question"] == "surface" and r["scenario"] not in CONTAINMENT]
            if rows:
                parts.append(f"{name} {percent(sum(r['wrong'] for r in rows) / sum(r['poses'] for r in rows))}")
        return verdict + (f" In exactly degenerate contact, wrong were: {', '.join(parts)}." if parts else "")

    def study(self):
        if not self.rows:
            return ""
        first = self.rows[0]
        made = (f"version {first['version']}, seed {first['seed']}, {html.escape(first['compiler'])}, flags <code>{html.escape(first['flags'])}</code>, "
                f"{html.escape(first['processor'])}")
        command = "build/tetracone experiment study --out out"

        def section(title, text, content, table):
            return (f"<section><h2>{title}</h2><p>{text}</p>{content}"
                    f"<p class=source>Data: <a href='tables/{table}.csv'>tables/{table}.csv</a>. Again: <code>{command}</code></p></section>")

        return "".join((
            section("Speed against accuracy", "Each point is a way of answering. Across: mean time per query, geometric mean over the workloads. Up: share of "
                    "answers that differ from the truth, with 95 % intervals; the green band is zero. Colour: the kernel; shape: the method. Filled: exact by construction.",
                    f"<figure>{self.speed_against_accuracy()}</figure>", "speed_against_accuracy"),
            section("Every subject", "Wrong answers are counted against the truth; zero in n is stated with the upper end of its 95 % interval (Wilson). FCL answers the "
                    "surface question whatever is asked, so containment is not its fault but its limit. Exact subjects are shaded.", self.summary(), "summary"),
            section("Where rounding fails", "Exactly degenerate contacts, the bodies under random common rotations: of integer quaternions, exact in rationals, unless the "
                    "scenario says that both poses were rounded to doubles first. The truth is that of the poses as given. Below a share: missed, invented.", self.degenerate(), "degenerate"),
            section("The paper's time study", "Frames per second on the trajectories of section 4, relative size 1:1 (its Fig. 16). The paper states over 50 for all pairs, on a "
                    "Pentium IV of 1.6 GHz. Its horse of 3582 vertices and 7172 triangles cannot be a closed mesh of genus 0: V - F/2 would have to be 2.",
                    f"<figure>{self.frames_per_second()}</figure>", "frames_per_second"),
            section("Relative sizes", "The horse-sized mesh against itself at 1:1 to 1:16 (Fig. 17).", f"<figure>{self.relative_sizes()}</figure>", "relative_sizes"),
            section("What each stage is worth", "Per query, objects against themselves: pairs of nodes visited, discarded by each stage, and what was left for the edges and faces.",
                    self.stages(), "stages"))) + f"<p class=source>Study made by: {made}. All rows: <a href='study.csv'>study.csv</a>.</p>"

    def page(self):
        body = self.study() + (self.campaign.html() if self.campaign.is_there() else "")
        return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tetracone: speed against accuracy</title>
<style>
:root {{ color-scheme: light dark; --ink: #1b1b1b; --paper: #ffffff; --line: #d5d5d5; --shade: #e8f5f0; }}
@media (prefers-color-scheme: dark) {{ :root {{ --ink: #e8e8e8; --paper: #16181b; --line: #3a3f45; --shade: #17352c; }} }}
body {{ font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 70rem; margin: 0 auto; padding: 1rem; }}
figure {{ margin: 0; background: #fff; border-radius: 6px; overflow-x: auto; }} figure svg {{ width: 100%; min-width: 38rem; height: auto; display: block; }}
.scroll {{ overflow-x: auto; }} table {{ border-collapse: collapse; font-size: 0.85rem; }}
td:first-child {{ min-width: 10rem; }} td b {{ white-space: nowrap; }}
th, td {{ padding: 0.25rem 0.6rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }} tr.exact td {{ background: var(--shade); }}
.source {{ font-size: 0.8rem; opacity: 0.8; }} code {{ font-size: 0.9em; overflow-wrap: anywhere; }} .claim {{ font-size: 1.15rem; }}
@media print {{ body {{ max-width: none; }} section {{ break-inside: avoid; }} }}
</style></head><body>
<h1>Collision detection: speed against accuracy</h1>
<p class="claim">{self.claim()}</p>
{body}
<section><h2>Methods</h2>
<p>A pose is taken exactly: the placed polyhedron is the exact affine image. <i>surface</i> asks whether the two closed surfaces share a point, <i>solid</i> whether the two closed solids do.
The truth tests all pairs of faces whose outward-rounded boxes meet, by CGAL's exact intersections, and containment by signed ray crossings; it shares no code with what it judges.
Objects: two polyhedra of 32 vertices and 18 faces, and of 44 and 29, with flat non-convex faces and holes; meshes of 760 and 7172 triangles decimated from those of Debian's libcgal-demo.
<i>tree</i> is the tetra-tree tuned within its own parameters, with boxes in its leaves; <i>paper</i> has the choices of Jiménez and Segura 2008; <i>brute</i> tests every edge against every face.
The adaptive kernel's <i>tree</i> is the wide tree: oriented boxes, eight to a node.
Times are of one core, the fastest of up to five passes for each pose; compare them within this report only. The rational kernel is asked every fourth pose.</p>
</section>
</body></html>
"""


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: report.py OUT")
    plt.rcParams.update({"svg.hashsalt": "tetracone", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    report = Report(sys.argv[1])
    if not report.rows and not report.campaign.is_there():
        sys.exit(f"{sys.argv[1]}/study.csv: no such file; expected the results of tetracone experiment study, or of tetracone report DB")
    report.write("report.html", report.page())


if __name__ == "__main__":
    main()
