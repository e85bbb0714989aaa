"""The rows of the study, OUT/study.csv, and how they fall into regimes."""

import os

from report_data import by, distinct, geometric_mean, read
from report_page import Source

NUMBERS = ("faces_a faces_b ratio poses collisions false_positives false_negatives mean_ns median_ns p99_ns build_ms bytes nodes "
           "pairs_visited discarded_by_hull discarded_by_sphere discarded_by_tetrahedron bounding_tests primitive_tests "
           "exact_fallbacks").split()
CONTAINMENT = ("nested", "in a cavity")
REGIMES = ("random", "near-degenerate", "exactly degenerate", "nested")
QUESTION = {"random": "surface", "near-degenerate": "surface", "exactly degenerate": "surface", "nested": "solid"}


def regime_of(row):
    """Trajectories are random motion; gaps and contacts whose poses were rounded are near degenerate; containment is asked of solids."""
    if row["scenario"] in CONTAINMENT:
        return "nested"
    if row["regime"] == "trajectory":
        return "random"
    return "near-degenerate" if "gap" in row["scenario"] or "rounded" in row["scenario"] else "exactly degenerate"


def workload(row):
    return row["regime"], row["scenario"], row["a"], row["b"], row["ratio"], row["question"]


class Study:
    def __init__(self, out, name="study"):
        rows = read(os.path.join(out, name + ".csv"))
        self.rows = [r for r in rows if r["mean_ns"]]
        self.untimed = distinct(r["subject"] for r in rows if not r["mean_ns"])  # programs that do not tell their time
        for row in self.rows:
            for key in NUMBERS:
                row[key] = float(row[key] or "nan")  # a program makes its bodies in its own process
            row["mean_ns"] = max(row["mean_ns"], 1.0)  # whole nanoseconds
            row["exact"] = row["exact"] == "1"
            row["wrong"] = row["false_positives"] + row["false_negatives"]
            row["panel"] = regime_of(row)
        self.subjects = distinct(r["subject"] for r in self.rows)

    def __bool__(self):
        return bool(self.rows)

    def source(self, asked, rows=None):
        rows = self.rows if rows is None else rows
        places = len({workload(r) for r in rows})
        programs = distinct(r["subject"] for r in rows if r["method"] == "program")
        asked += f" {', '.join(programs)}: by the program's own clock, over the subject protocol." if programs else ""
        asked += f" {', '.join(self.untimed)}: not drawn, since the program does not tell its time." if self.untimed else ""
        return Source.of(rows, asked, f"{sum(r['poses'] for r in rows):,.0f} answers of {len({r['subject'] for r in rows})} subjects on "
                         f"{places} workloads")

    def asked_in(self, panel):
        """The rows of a panel's question; peers know surfaces alone."""
        return [r for r in self.rows if r["panel"] == panel and r["question"] == QUESTION[panel] and (r["method"] != "peer" or r["question"] == "surface")]

    def points(self, panel):
        """Yields for each subject in a regime: its first row, time a query, wrong answers, answers."""
        for (_,), rows in by(self.asked_in(panel), "subject").items():
            yield rows[0], geometric_mean(r["mean_ns"] for r in rows), sum(r["wrong"] for r in rows), sum(r["poses"] for r in rows)
