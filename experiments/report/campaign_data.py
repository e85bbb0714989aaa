"""The tables of a campaign, OUT/tables/verify_*.csv, as `tetracone report DB` writes them."""

import os
import re
from collections import defaultdict

from report_data import distinct, read, wrong_in
from report_page import Source, again

EXACTLY, NOT_NEAR = -9999, 9999
TABLES = ("errors", "poses", "subjects", "distance", "sweeps", "blame", "relations", "flips", "truth", "runs", "times", "needs", "notes",
          "families", "wrong", "failures")
DOUBLES, FRACTIONS = "doubles", "fractions"  # of poses
EXACT = ("adaptive", "epeck", "rational")

# Families by what they come near, for panels and scene types; a family's sweep may end in exact degeneracy.
REGIME = {family: regime for regime, families in {
    "random": "random",
    "near-degenerate": "decimal-grid float-widened rounded-on-plane ulps-off-plane perturbed-zero ulp-walk sliver needle nearly-collinear "
                                                  "near-parallel-edges nearly-singular drifted-rotation swept-contact non-planar-quads "
                                                  "far-from-origin distant-part mixed-scales cancelled-translation swept-primitives corpus metres",
    "exactly degenerate": "special-poses extreme-exponents exponent-gate coplanar-grid coplanar-parallelogram vertex-on-vertex "
                                                  "vertex-on-edge vertex-on-face edge-across-edge edge-along-edge edge-in-face-plane "
                                                  "face-on-face coplanar-sharing stacked degenerate-face duplicates true-rotation shear "
                                                  "t-junctions voxels tangent-fan many-faces tiny-fractions lego ladder",
    "nested": "nested nested-touching cavity-wall covering-elements covering-apex winding-axis"}.items() for family in families.split()}


PANEL = {"random": "random coordinates"}  # where "random" is said of the study, it is of its motions


def is_exact(subject):
    return subject.split(" ")[0] in EXACT and "sign-error" not in subject


class Campaign:
    def __init__(self, out):
        self.tables = {name: read(os.path.join(out, "tables", f"verify_{name}.csv")) for name in TABLES}
        self.compilers = read(os.path.join(out, "compilers.csv"))

    def rows(self, level, poses=None, of_sequences=False):
        """What was asked at a level, by family, subject, question and kind of poses; sequences of frames apart."""
        return [r for r in self.tables["poses"] if r["level"] == level and r["poses"] == (poses or r["poses"]) and
                r["family"].startswith("sequence ") == of_sequences]

    def knows(self, subject):
        """The only question that a library knows, surface or solid; nothing of one that knows both."""
        return next((r["knows"] for r in self.tables["notes"] if (r["level"], r["subject"]) == ("object", subject)), "")

    def is_known(self, row):
        """Whether its subject knows its question: an answer to the other one is no error of the subject's own."""
        return self.knows(row["subject"]) in ("", row["question"])

    def __bool__(self):
        return bool(self.tables["errors"])

    def families(self, level):
        """The families asked, sequences of frames apart, with their number of truths."""
        count = {}
        for r in self.tables["truth"]:
            if r["level"] == level and not r["family"].startswith("sequence "):
                count[r["family"]] = max(count.get(r["family"], 0), int(r["n"]))
        return count

    def command(self):
        """The words that ask all of the campaign again, and draw it."""
        words = again(self.tables["runs"])
        db = re.search(r"--db ('[^']*'|\S+)", words)
        return f"{words} && build/tetracone report {db[1] if db else 'out/verify.db'} --out out"

    def source(self, asked, cases):
        return Source.of(self.tables["runs"], asked, cases, self.command())

    def notes(self, level):
        """What each subject that is not ours really answers, by its name."""
        return {r["subject"]: r["note"] for r in self.tables["notes"] if r["level"] == level}

    def answers(self, rows):
        return f"{sum(int(r['n']) for r in rows):,} answers of {len({r['subject'] for r in rows})} subjects"

    def wrong_by(self, rows, *keys):
        """[wrong, asked] by the values of these columns."""
        count = defaultdict(lambda: [0, 0])
        for r in rows:
            c = count[tuple(r[k] for k in keys)]
            c[0] += wrong_in(r)
            c[1] += int(r["n"])
        return count
