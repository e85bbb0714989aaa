"""The sections of the report that say what a campaign of `tetracone verify` found: OUT/tables/verify_*.csv and OUT/compilers.csv."""

import csv
import html
import math
import os
from collections import defaultdict

import matplotlib.pyplot as plt

EXACTLY, NOT_NEAR = -9999, 9999
# As far as the eye can follow: one line a kernel, brute force and so signs alone; and FCL.
CURVES = (("object", "float brute", "#E69F00", "float"), ("object", "double brute", "#D55E00", "double"),
          ("object", "double-eps=1e-12 brute", "#CC79A7", "double, 1e-12"), ("object", "epick brute", "#56B4E9", "EPICK"),
          ("object", "FCL OBBRSS", "#000000", "FCL"), ("object", "adaptive tree", "#009E73", "adaptive"))


def read(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Campaign_sections:
    """`report` gives the helpers for tables and figures."""

    def __init__(self, report):
        self.report = report
        self.tables = {name: read(os.path.join(report.out, "tables", f"verify_{name}.csv"))
                       for name in ("errors", "subjects", "distance", "stages", "relations", "flips", "truth", "runs")}
        self.compilers = read(os.path.join(report.out, "compilers.csv"))

    def is_there(self):
        return bool(self.tables["errors"])

    # --- helpers ------------------------------------------------------------------------------------------------------

    def share(self, wrong, n):
        return self.report.share(wrong, n)

    def made(self):
        runs = self.tables["runs"]
        return "; ".join(f"version {r['version']}, seed {r['seed']}, {html.escape(r['compiler'])}, {html.escape(r['processor'])}" for r in runs)

    def section(self, title, text, content, table, command="build/tetracone verify --db out/verify.db &amp;&amp; build/tetracone report out/verify.db --out out"):
        return (f"<section><h2>{title}</h2><p>{text}</p>{content}"
                f"<p class=source>Data: <a href='{table}'>{table}</a>. Again: <code>{command}</code></p></section>")

    def wrong(self, row):
        return int(row["false_positives"]) + int(row["false_negatives"]) + int(row["failures"])

    # --- sections -----------------------------------------------------------------------------------------------------

    def subjects(self, level):
        """A line a subject, a column a question."""
        rows = [r for r in self.tables["subjects"] if r["level"] == level]
        questions = list(dict.fromkeys(r["question"] for r in rows))
        cell = {(r["subject"], r["question"]): r for r in rows}
        body = []
        for subject in dict.fromkeys(r["subject"] for r in rows):
            cells = [html.escape(subject)]
            for question in questions:
                r = cell.get((subject, question))
                if r is None or int(r["n"]) == 0:
                    cells.append("–")
                    continue
                text = self.share(self.wrong(r), int(r["n"]))
                if self.wrong(r):
                    text += f"<br><small>missed {r['false_negatives']}, invented {r['false_positives']}" + (f", failed {r['failures']}" if int(r["failures"]) else "") + "</small>"
                cells.append(text)
            body.append((all(self.wrong(cell[subject, q]) == 0 for q in questions if (subject, q) in cell), cells))
        return self.report.html_table(["subject"] + questions, body)

    def families(self):
        """Object level: share of wrong answers by family, for one method of each kernel and the peers."""
        rows = [r for r in self.tables["errors"] if r["level"] == "object"]
        subjects = [s for s in dict.fromkeys(r["subject"] for r in rows) if s.endswith(" tree") or not s.endswith((" paper", " brute"))]
        count = defaultdict(lambda: [0, 0])
        for r in rows:
            count[r["family"], r["subject"]][0] += self.wrong(r)
            count[r["family"], r["subject"]][1] += int(r["n"])
        body = []
        for family in dict.fromkeys(r["family"] for r in rows):
            cells = [html.escape(family)]
            for subject in subjects:
                wrong, n = count[family, subject]
                cells.append("–" if n == 0 else "0" if wrong == 0 else f"<b>{self.report.percent(wrong / n)}</b>")
            body.append((False, cells))
        return self.report.html_table(["family"] + [html.escape(s) for s in subjects], body)

    def by_distance(self):
        fig, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
        rows = [r for r in self.tables["distance"] if r["question"] == "surface"]
        for axis, key, label in ((axes[0], "rho", "log2 of the relative determinant"), (axes[1], "ulps", "log2 of the distance in ulps")):
            low = -110 if key == "rho" else -20
            for level, subject, colour, name in CURVES:
                bins = defaultdict(lambda: [0, 0])
                for r in rows:
                    if (r["level"], r["subject"], r["axis"]) != (level, subject, key):
                        continue
                    b = int(r["bin"])
                    if b == NOT_NEAR:
                        continue
                    b = low - 8 if b == EXACTLY else max(low, 4 * math.floor(b / 4))
                    n = int(r["n"])
                    bins[b][0] += round(float(r["rate"]) * n)
                    bins[b][1] += n
                points = [(b, wrong / n) for b, (wrong, n) in sorted(bins.items()) if n >= 10]
                if points:
                    axis.plot([b for b, _ in points], [100 * rate for _, rate in points], "o-", ms=3, lw=1.2, color=colour, label=name)
            axis.set_xlabel(label)
            axis.grid(True, color="#dddddd", lw=0.6)
        axes[0].set_ylabel("wrong answers, %")
        handles, names = axes[0].get_legend_handles_labels()
        if handles:
            fig.legend(handles, names, ncol=len(names), fontsize=8, frameon=False, loc="lower center")
        fig.tight_layout(rect=(0, 0.06, 1, 1))
        return self.report.figure("errors_by_distance", fig)

    def stages(self):
        rows = self.tables["stages"]
        stages = ["pose", "classification", "bounding sphere", "bounding tetrahedron", "regular hull", "leaf sign", "containment"]
        count = defaultdict(int)
        for r in rows:
            count[r["subject"], r["stage"]] += int(r["n"])
        body = [(False, [html.escape(s)] + [str(count[s, stage]) if count[s, stage] else "0" for stage in stages]) for s in dict.fromkeys(r["subject"] for r in rows)]
        return self.report.html_table(["subject"] + stages, body)

    def relations(self):
        rows = self.tables["relations"]
        body = []
        subjects = list(dict.fromkeys((r["level"], r["subject"]) for r in rows))
        for level, subject in subjects:
            mine = [r for r in rows if (r["level"], r["subject"]) == (level, subject)]
            violated, tried = sum(int(r["violated"]) for r in mine), sum(int(r["tried"]) for r in mine)
            if tried == 0:
                continue
            worst = sorted((r for r in mine if int(r["violated"])), key=lambda r: -float(r["rate"]))[:3]
            names = "; ".join(f"{html.escape(r['relation'])} {self.report.percent(float(r['rate']))}" for r in worst)
            body.append((violated == 0, [level, html.escape(subject), self.share(violated, tried), names or "–"]))
        return self.report.html_table(["level", "subject", "violated", "most often"], body)

    def flips(self):
        rows = self.tables["flips"]
        count = defaultdict(lambda: [0, 0, 0, 0])
        for r in rows:
            c = count[r["subject"]]
            for k, key in enumerate(("frames", "wrong", "changes", "true_changes")):
                c[k] += int(r[key])
        body = []
        for subject, (frames, wrong, changes, true_changes) in count.items():
            per_thousand = 1000 * max(0, changes - true_changes) / frames
            body.append((wrong == 0, [html.escape(subject), f"{frames}", self.share(wrong, frames), f"{changes}", f"{true_changes}", f"{per_thousand:.3g}"]))
        return self.report.html_table(["subject", "frames", "wrong", "changes of the answer", "of the truth", "surplus per thousand frames"], body)

    def compiler_matrix(self):
        rows = [r for r in self.compilers if r["outcome"] == "ran"]
        tests = list(dict.fromkeys(r["test"] for r in rows))
        cell = {(r["compiler"], r["flags"], r["subject"], r["test"]): r for r in rows}
        body = []
        for compiler, flags, subject in dict.fromkeys((r["compiler"], r["flags"], r["subject"]) for r in rows):
            cells = [compiler, f"<code>{html.escape(flags)}</code>", subject]
            for test in tests:
                r = cell.get((compiler, flags, subject, test))
                cells.append("–" if r is None else "0" if r["wrong"] == "0" else f"<b>{self.report.percent(int(r['wrong']) / int(r['n']))}</b>")
            body.append((subject != "double", cells))
        refused = sorted({(r["compiler"], r["flags"]) for r in self.compilers if r["outcome"] == "refused to compile"})
        note = "<p>Refused at compile time, as they must be: " + "; ".join(f"{c} <code>{html.escape(f)}</code>" for c, f in refused) + ".</p>" if refused else ""
        return self.report.html_table(["compiler", "flags", "signs"] + tests, body) + note

    def html(self):
        truth = self.tables["truth"]
        cases = sum(int(r["n"]) for r in truth)
        known = sum(int(r["by_construction"]) for r in truth)
        parts = [
            self.section("The campaign: every subject on every family",
                         f"{cases:,} truths, each computed twice by formulations that share no code (CGAL's intersections over rationals; integers of GMP), {known:,} of them also known by "
                         "construction. 47 families of cases sweep from far from degenerate to exactly degenerate. Objects: two polyhedra under two poses.", self.subjects("object"), "tables/verify_subjects.csv"),
            self.section("Predicates", "The same families as seven points, by predicate. Answers higher than the truth are invented, lower ones missed. Other formulations of "
                         "segment against triangle are shown in the arithmetic they were published for.", self.subjects("predicate"), "tables/verify_subjects.csv"),
            self.section("Where each is wrong", "Share of wrong answers by family, both questions; peers answer the surface question, whatever is asked, unless they say otherwise.",
                         self.families(), "tables/verify_errors.csv"),
            self.section("How near is too near", "Wrong answers to the surface question against the distance of the nearest sign from degenerate, measured exactly. The leftmost point is exact degeneracy.", f"<figure>{self.by_distance()}</figure>", "tables/verify_distance.csv"),
            self.section("Which stage is to blame", "Wrong answers by the stage that made them wrong: the query is run with its first stages in the subject's arithmetic and the rest exact, "
                         "with one rounded stage more at a time.", self.stages(), "tables/verify_blame.csv"),
            self.section("Metamorphic relations", "Violations need no truth: the subject contradicts itself.", self.relations(), "tables/verify_relations.csv"),
            self.section("Stability", "Sequences of frames in exact contact: sliding, rolling, sweeping. How often the answer changes although the truth does not.", self.flips(), "tables/verify_flips.csv")]
        if self.compilers:
            parts.append(self.section("Compilers and flags", "Signs of four points by flags: contraction of products and sums alone breaks signs in double. Exact signs are shaded.",
                                      self.compiler_matrix(), "compilers.csv", "build/tetracone experiment compilers --out out"))
        return "".join(parts) + f"<p class=source>Campaign made by: {self.made()}.</p>"
