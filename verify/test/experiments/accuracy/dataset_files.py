#!/usr/bin/python3
"""Tests of the reader and the scorer that `tetracone experiment dataset` writes beside its cases."""

import csv
import hashlib
import io
import json
import os
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from fractions import Fraction

sys.dont_write_bytecode = True
PROGRAM = os.environ.get("TETRACONE_PROGRAM", "")
if not PROGRAM:
    print("skipped: no program")
    sys.exit(77)
WORK = tempfile.TemporaryDirectory()
subprocess.run([PROGRAM, "experiment", "dataset", "--cases", "2", "--out", WORK.name], check=True, capture_output=True)
FOLDER = os.path.join(WORK.name, "dataset")
sys.path.insert(0, FOLDER)
import score  # noqa: E402
import tetracone_dataset as dataset  # noqa: E402


class Files(unittest.TestCase):
    def answers(self, rows):
        name = os.path.join(WORK.name, "answers.csv")
        with open(name, "w", newline="") as file:
            out = csv.writer(file, lineterminator="\n")
            out.writerow(["id", "question", "answer"])
            out.writerows(rows)
        return name

    def scored(self, name):
        out, error = io.StringIO(), io.StringIO()
        with redirect_stdout(out), redirect_stderr(error):
            status = score.main([name])
        return status, list(csv.DictReader(io.StringIO(out.getvalue()))), error.getvalue()

    def table(self, name):
        with open(os.path.join(FOLDER, name), newline="") as file:
            return list(csv.DictReader(file))

    def test_the_csv_has_the_rows_of_the_json_lines(self):
        for name in ("cases", "predicates", "triangles"):
            rows = list(dataset.rows(f"{name}.jsonl", FOLDER))
            table = self.table(f"{name}.csv")
            self.assertEqual([list(row) for row in rows], [list(row) for row in table])
            for row, line in zip(rows, table):
                for column, value in row.items():
                    self.assertEqual(line[column] if isinstance(value, str) else float(line[column]), value, row["id"])

    def test_cases_are_exact_and_closed(self):
        rows = list(dataset.rows("cases.jsonl", FOLDER))
        cases = list(dataset.cases())
        self.assertEqual(len(cases), 2 * dataset.about()["families"])
        self.assertEqual(",".join(list(rows[0])[:12]), "id,family,index,parameter,seed,mesh_a,mesh_b,surface,solid,log2_rho,log2_ulps,a00")
        for row in rows:
            self.assertEqual([type(row[name]) for name in ("surface", "solid", "index", "seed")], [bool, bool, int, int])
        rational = 0
        for case, row in zip(cases, rows):
            for name, pose in (("a", case.pose_a), ("b", case.pose_b)):
                for i in range(3):
                    for j in range(4):
                        text = str(row[f"{name}{i}{j}"])
                        self.assertEqual(pose[i][j], Fraction(text) if "/" in text else Fraction(float(text)))
                        rational += "/" in text
            for vertices, triangles in (case.a, case.b):
                edges = [(t[k], t[k - 2]) for t in triangles for k in range(3)]
                self.assertEqual(sorted(edges), sorted((b, a) for a, b in edges))  # closed
                self.assertLess(max(map(max, triangles)), len(vertices))
        self.assertGreater(rational, 0)

    def test_croissant_describes_the_files_and_their_columns(self):
        with open(os.path.join(FOLDER, "croissant.json")) as file:
            croissant = json.load(file)
        with open(os.path.join(FOLDER, "README.md"), encoding="utf-8") as file:
            card = file.read().split("## Fields")[1].split("##")[0]
        self.assertEqual((croissant["@type"], croissant["conformsTo"]), ("sc:Dataset", "http://mlcommons.org/croissant/1.0"))
        self.assertEqual(croissant["version"], dataset.about()["version"])
        self.assertRegex(croissant["datePublished"], r"^20\d\d-\d\d-\d\d$")
        self.assertIn("publicdomain/zero/1.0", croissant["license"])
        for key in ("@context", "name", "description", "url", "creator", "citeAs"):
            self.assertTrue(croissant[key], key)
        files = [entry for entry in croissant["distribution"] if entry["@type"] == "cr:FileObject"]
        self.assertEqual({entry["contentUrl"] for entry in files}, {name for name in os.listdir(FOLDER) if name.endswith((".csv", ".jsonl"))})
        for entry in files:
            with open(os.path.join(FOLDER, entry["contentUrl"]), "rb") as file:
                content = file.read()
            self.assertEqual((entry["sha256"], entry["contentSize"]), (hashlib.sha256(content).hexdigest(), f"{len(content)} B"))
        for records in croissant["recordSet"]:
            for field, column in zip(records["field"], self.table(f'{records["@id"]}.csv')[0], strict=True):
                self.assertEqual((field["@id"], field["source"]["extract"]["column"]), (f'{records["@id"]}/{column}', column))
                self.assertEqual(field["source"]["fileObject"]["@id"], f'{records["@id"]}.csv')
                self.assertIn(f'| {field["description"]} |', card)

    def test_every_family_is_described(self):
        with open(os.path.join(FOLDER, "families.csv"), newline="") as file:
            families = {row["family"]: row for row in csv.DictReader(file)}
        with open(os.path.join(FOLDER, "README.md"), encoding="utf-8") as file:
            lines = file.read().split("## Families")[1].splitlines()
        self.assertEqual(set(families), {case.family for case in dataset.cases()})
        for name, row in families.items():
            self.assertGreater(len(row["what"]), 5, name)
            self.assertIn(f"| `{name}` | {row['what']} | {row['parameter']} | {row['values']} |", lines)

    def test_predicates_are_exact(self):
        seen = set()
        for case in dataset.predicates():
            if case.predicate != "orientation":
                continue
            v0, v1, v2, v3, p = (self.placed(point, case.pose_a if k < 4 else case.pose_b) for k, point in enumerate(case.points[:5]))
            rows = [[x - y for x, y in zip(v, p)] for v in (v1, v2, v3)]
            (a, b, c), (d, e, f), (g, h, i) = rows
            det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
            self.assertEqual(case.truth, (det > 0) - (det < 0), case.id)
            seen.add(case.truth)
        self.assertEqual(seen, {-1, 0, 1})

    def test_triangles_are_those_of_the_seven_points_placed(self):
        points = {case.id: case for case in dataset.predicates() if case.predicate == "orientation"}
        truths, fractions = set(), 0
        for pair in dataset.triangles():
            case = points.pop(pair.id)
            for corners, placed, pose in ((pair.s, case.points[1:4], case.pose_a), (pair.t, case.points[4:], case.pose_b)):
                self.assertEqual([list(p) for p in corners], [self.placed(p, pose) for p in placed], pair.id)
                fractions += any(x != Fraction(float(x)) for p in corners for x in p)
            boxes = [[(min(p[k] for p in corners), max(p[k] for p in corners)) for k in range(3)] for corners in (pair.s, pair.t)]
            if any(low > high for (low, _), (_, high) in [*zip(*boxes), *zip(*boxes[::-1])]):
                self.assertEqual(pair.truth, 0, pair.id)
            if set(pair.s) & set(pair.t):
                self.assertEqual(pair.truth, 1, pair.id)
            truths.add(pair.truth)
        self.assertEqual((points, truths), ({}, {0, 1}))
        self.assertGreater(fractions, 0)

    def placed(self, point, pose):
        return [sum(row[k] * Fraction(point[k]) for k in range(3)) + row[3] for row in pose]

    def test_what_was_changed_is_noticed(self):
        dataset.check()
        said = subprocess.run(["sha256sum", "--quiet", "-c", "SHA256SUMS"], cwd=FOLDER, capture_output=True, text=True)
        self.assertEqual((said.returncode, said.stdout), (0, ""))
        with open(os.path.join(FOLDER, "SHA256SUMS")) as file:
            named = {line.split()[1] for line in file}
        there = {os.path.relpath(os.path.join(where, name), FOLDER) for where, _, names in os.walk(FOLDER) for name in names}
        self.assertEqual(there - named, {"SHA256SUMS"})
        mesh = os.path.join(FOLDER, "meshes", "m0.off")
        with open(mesh) as file:
            text = file.read()
        try:
            with open(mesh, "w") as file:
                file.write(text + "\n")
            with self.assertRaisesRegex(dataset.Error, "^meshes/m0.off: its SHA-256 is .*; expected "):
                dataset.check()
            os.rename(mesh, mesh + ".away")
            with self.assertRaisesRegex(dataset.Error, "^meshes/m0.off: No such file or directory; expected "):
                dataset.check()
        finally:
            if os.path.exists(mesh + ".away"):
                os.remove(mesh + ".away")
            with open(mesh, "w") as file:
                file.write(text)
        dataset.check()

    def test_scores(self):
        truth = score.truths(FOLDER)
        right = [(*key, answer) for key, (_, answer) in truth.items()]
        status, table, _ = self.scored(self.answers(right))
        self.assertEqual(status, 0)
        for row in table:
            self.assertEqual({row[c] for c in score.COLUMNS[3:]}, {"0"})
        self.assertEqual(sum(int(row["n"]) for row in table if row["family"] == "all"), len(truth))

        solids = [(name, q, a) for name, q, a in right if q == "solid"]
        yes, no = ([k for k, row in enumerate(solids) if row[2] == a] for a in (1, 0))
        for k, answer in ((yes[0], 0), (yes[1], "failed"), (no[0], 1), (no[1], 1), (no[2], "declined")):
            solids[k] = (*solids[k][:2], answer)
        del solids[yes[2]]
        status, table, _ = self.scored(self.answers(solids))
        self.assertEqual({row["question"] for row in table}, {"solid"})
        total = table[-1]
        self.assertEqual([total[c] for c in score.COLUMNS],
                         ["all", "solid", str(len(solids) - 1), "2", "1", "1", "1", "1"])
        for column in score.COLUMNS[2:]:
            self.assertEqual(sum(int(row[column]) for row in table[:-1]), int(total[column]))

    def test_every_wrong_file_of_answers_has_its_line(self):
        case = next(dataset.cases()).id
        for rows, line in (([("none-0", "solid", 1)], ":2: no case 'none-0' with the question 'solid'; expected one of the dataset"),
                           ([(case, "solid", 1), (case, "solid", 1)], f":3: '{case}', 'solid' once more; expected one answer"),
                           ([(case, "solid", -1)], ":2: the answer '-1'; expected 0, 1, failed or declined"),
                           ([(case, "triangle-triangle", -1)], ":2: the answer '-1'; expected 0, 1, failed or declined"),
                           ([(case, "orientation", 2)], ":2: the answer '2'; expected -1, 0, 1, failed or declined"),
                           ([(case, "solid")], ":2: 2 fields; expected id,question,answer")):
            name = self.answers(rows)
            self.assertEqual(self.scored(name), (2, [], f"{name}{line}\n"))
        self.assertEqual(self.scored("none.csv")[2], "none.csv: No such file or directory; expected a file of answers\n")
        with open(name, "w") as file:
            file.write("id,answer\n")
        self.assertEqual(self.scored(name)[2], f"{name}:1: another header; expected id,question,answer\n")

    def test_the_code_of_the_readme_reads_every_case(self):
        with open(os.path.join(FOLDER, "README.md"), encoding="utf-8") as file:
            lines = file.read().split("## Read the cases")[1].split("##")[0].splitlines()
        read = {}
        exec("\n".join(line[4:] for line in lines if line.startswith("    ")), read)
        last = list(dataset.cases())[-1]
        self.assertEqual((read["case"].id, read["vertices"]), (last.id, last.a[0]))

    def test_the_example_is_scored(self):
        name = os.path.join(WORK.name, "toy.csv")
        subprocess.run([sys.executable, "-B", os.path.join(FOLDER, "example.py"), name], check=True)
        said = subprocess.run([sys.executable, "-B", os.path.join(FOLDER, "score.py"), name], capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        family, question, n, false_positives, *_ = said.stdout.splitlines()[-1].split(",")
        self.assertEqual((family, question, int(n)), ("all", "solid", 2 * dataset.about()["families"]))
        self.assertGreater(int(false_positives), 0)


if __name__ == "__main__":
    unittest.main()
