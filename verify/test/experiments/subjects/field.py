#!/usr/bin/python3
"""Tests of experiments/subjects/field.py: its tables are those of a campaign, and its reproductions have the answers they say. Its page shows the
table, and the packages of npm are fixed without a host."""

import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "..")
sys.path[:0] = [os.path.join(SOURCE, "experiments", "subjects"), os.path.join(SOURCE, "experiments", "report")]
PROGRAM = os.environ["TETRACONE_PROGRAM"]

import field  # noqa: E402
import field_cases  # noqa: E402
import field_page  # noqa: E402
import field_trial  # noqa: E402

# A subject of surfaces that calls all apart, and prints.
APART = """
import json, sys
print("Loaded.")
print(json.dumps({"hello": 1, "name": "Apart", "version": "1", "questions": ["surface"], "poses": "rigid", "precision": "float32"}), flush=True)
for line in sys.stdin:
    m = json.loads(line)
    if "ask" in m: print(json.dumps({"ask": m["ask"], "answer": 0, "ns": 5}), flush=True)
"""


class Field(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = cls.folder.name
        script = os.path.join(cls.out, "apart.py")
        with open(script, "w") as file:
            file.write(APART)
        cls.command = f"{sys.executable} {script}"
        cls.words = [PROGRAM, "verify", "--db", os.path.join(cls.out, "field.db"), "--level", "object", "--cases", "200", "--family", "ladder", "--subject",
                     "adaptive tree", "--subject", "float tree", "--subject-command", "Apart=" + cls.command]
        subprocess.run(cls.words, check=True, capture_output=True)
        cls.rows = []
        groups = {"adaptive tree": "exact", "float tree": "float", "Apart": "double"}
        cls.made = field.tables(os.path.join(cls.out, "field.db"), groups, cls.rows)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def of(self, table, **values):
        return [r for r in self.rows if r["table"] == table and all(r.get(k) == v for k, v in values.items())]

    def test_what_is_never_right_misses_every_contact_and_what_is_exact_none(self):
        (apart,) = self.of("regime", subject="Apart")
        self.assertEqual((apart["regime"], apart["question"], apart["n"], apart["invented"]), ("ladder", "surface", 200, 0))
        self.assertGreater(apart["missed"], 90)
        for row in self.of("regime", subject="adaptive tree") + self.of("common", subject="adaptive tree"):
            self.assertEqual(row["missed"] + row["invented"] + row["failed"], 0)
        (common,) = self.of("common", subject="Apart")
        self.assertEqual((common["n"], common["missed"]), (200, apart["missed"]))
        (flush,) = self.of("flush", subject="Apart")
        self.assertEqual(flush["n"], 8)
        self.assertEqual(self.of("declined", subject="Apart"), [{"table": "declined", "subject": "Apart", "regime": "not taken", "n": 200}])
        (engine,) = self.of("engine", subject="Apart")
        self.assertEqual(json.loads(engine["text"])["version"], "1")
        self.assertGreater(engine["n"], 0)  # lines that it prints

    def test_what_rounding_the_input_costs_stands_apart(self):
        (row,) = self.of("rounded")
        self.assertEqual((row["subject"], row["regime"], row["n"], row["invented"]), ("Apart", "ladder", 200, 0))
        (apart,) = self.of("regime", subject="Apart")
        self.assertEqual(row["wrong"], apart["missed"])
        self.assertGreater(row["changed"], 5)
        # The subject calls all cubes apart, so it misses overlaps of rounded cubes too. A wrong answer is excused where rounding parts them.
        self.assertLess(row["excused"], row["wrong"])
        self.assertEqual(row["missed"] - row["wrong"] + 2 * row["excused"], row["changed"])

    def test_rungs_are_read_as_the_family_makes_them(self):
        wide = [r for r in self.of("ladder", subject="Apart", regime="overlap") if r["value"] != ""]
        self.assertEqual({r["size"] for r in wide}, {-10, -7, -4, 0, 3, 7, 10, 13})
        self.assertEqual({r["value"] for r in wide}, {-1})  # it misses the overlap of half the size
        self.assertTrue(all(r["n"] == 12 for r in wide))
        for row in self.of("ladder", subject="adaptive tree"):
            self.assertEqual(row["value"], "")
        self.assertTrue(all(r["value"] == "" or r["value"] < -15 for r in self.of("ladder", subject="float tree")))

    def test_other_kinds_of_question_are_asked_of_those_that_name_them(self):
        script = os.path.join(self.out, "misses.py")
        with open(script, "w") as file:
            file.write(APART.replace('["surface"]', '["surface", "ray"]'))
        command, db = f"{sys.executable} {script}", os.path.join(self.out, "kinds.db")
        subprocess.run([PROGRAM, "verify", "--db", db, "--level", "object", "--cases", "1", "--family", "lego", "--subject", "Misses", "--subject", "Apart",
                        "--subject-command", "Misses=exec " + command, "--subject-command", "Apart=exec " + self.command], check=True, capture_output=True)
        rows = []
        field.other_kinds(db, PROGRAM, [("Misses", "double", command), ("Apart", "double", self.command)], 4, 10, rows)
        (row,) = rows  # no ray meets anything, it says: there is no t to judge
        self.assertEqual((row["subject"], row["regime"], row["question"], row["invented"], row["failed"]), ("Misses", "rays", "meets", 0, 0))
        self.assertTrue(0 < row["missed"] < row["n"])

    def test_an_edited_program_is_another_subject(self):
        script = self.command.split()[1]
        with open(script, "a") as file:
            file.write("# edited\n")
        again = subprocess.run(self.words, capture_output=True, text=True)
        with open(script, "w") as file:
            file.write(APART)
        self.assertEqual(again.returncode, 2)
        self.assertIn("the program of Apart has changed", again.stderr)
        self.assertEqual(subprocess.run(self.words, capture_output=True).returncode, 0)

    def test_reproductions_have_their_answers_and_their_protocol(self):
        together = {"copy", "half-diagonal", "half-side", "overlap-small", "overlap-cm", "flush", "corner", "overlap-micron", "far"}
        rows = []
        field.strip([("Apart", "double", self.command)], PROGRAM, self.out, rows)
        truth = {(r["regime"], r["question"]): r["value"] for r in rows if r["subject"] == "truth"}
        said = {(r["regime"], r["question"]) for r in rows if r["subject"] == "Apart"}
        for case in field_cases.CASES:
            name = case["name"]
            self.assertEqual(truth[name, "surface"], int(name in together), name)
            self.assertEqual(truth[name, "solid"], int(name in together or name == "inside"), name)
            self.assertIn((name, "surface"), said)

    def test_the_fields_own_cases_are_judged_and_gone_on_with(self):
        def talk():
            return field.Talk(self.command)
        rows = field_trial.rows([("Apart", "double", talk)], self.out, 8, 10)
        right = field_trial.truths(self.out, 8)
        by_regime = {r["regime"]: r for r in rows if r["table"] == "regime"}
        for regime, row in by_regime.items():
            mine = [right[n][0] for n, c in enumerate(field_trial.cases(8)) if c["regime"] == regime]
            self.assertEqual((row["n"], row["missed"], row["invented"], row["failed"], row["declined"]), (len(mine), sum(mine), 0, 0, 0), regime)
            self.assertTrue(0 < sum(mine) < len(mine), regime)
        # The answers that are there are not asked again: a program that would fail is not started.
        again = field_trial.rows([("Apart", "double", lambda: field.Talk("exit 3"))], self.out, 8, 10)
        self.assertEqual(rows, again)
        fails = field_trial.rows([("Fails", "double", lambda: field.Talk("sh -c 'exit 3'"))], self.out, 8, 10)
        (row,) = [r for r in fails if r["table"] == "failure"]
        self.assertEqual(row, {"table": "failure", "subject": "Fails", "regime": "status 3", "n": 2 * len(field_trial.cases(8))})

    def test_the_integers_agree_with_both_truths_of_the_program(self):
        script = os.path.join(SOURCE, "experiments", "subjects", "rounded.py")
        db = os.path.join(self.out, "rounded.db")
        subprocess.run([PROGRAM, "verify", "--db", db, "--level", "object", "--cases", "24", "--frames", "0", "--family", "lego",
                        "--family", "nested-touching", "--family", "metres", "--subject-command", f"fine={sys.executable} {script} 400"], check=True, capture_output=True)
        table = subprocess.run([PROGRAM, "report", db, "--table", "subjects"], check=True, capture_output=True, text=True).stdout
        (surface, solid) = [r for r in csv.DictReader(table.splitlines()) if r["subject"] == "fine"]
        for row in (surface, solid):
            self.assertGreater(int(row["n"]), 50)
            self.assertEqual((row["false_positives"], row["false_negatives"], row["failures"]), ("0", "0", "0"))

    def test_the_page_shows_the_table(self):
        table, page = os.path.join(self.out, "field.csv"), os.path.join(self.out, "field.html")
        origin = dict(zip(field.MADE_BY, (*self.made, 200, 0, "v0")))
        with open(table, "w", newline="") as file:
            writer = csv.DictWriter(file, field.COLUMNS + field.MADE_BY)
            writer.writeheader()
            speed = {"table": "speed", "subject": "Apart", "question": "surface", "regime": "meshes", "n": 9, "value": 2500, "text": "0 collide"}
            kind = {"table": "kind", "subject": "Apart", "question": "meets", "regime": "rays", "n": 77, "missed": 33}
            writer.writerows({"text": ""} | row | origin for row in [*self.rows, speed, kind])
        field_page.write(table, page)
        with open(page) as file:
            text = file.read()
        (apart,) = self.of("regime", subject="Apart")
        self.assertIn(f'{apart["missed"]}+0<small> /200</small>', text)
        self.assertIn(self.made[0], text)
        self.assertIn("33+0<small> /77</small>", text)
        self.assertIn(f'Apart: 2.5 microseconds, {apart["missed"]} wrong of 200', text)
        (rounded,) = self.of("rounded")
        self.assertIn(f'{rounded["missed"]}+0<small> /200</small>', text)

    def test_packages_are_of_one_version_and_of_no_host(self):
        folder = os.path.join(SOURCE, "experiments", "subjects", "npm")
        with open(os.path.join(folder, "package.json")) as file:
            for name, version in json.load(file)["dependencies"].items():
                self.assertRegex(version, r"^\d+\.\d+\.\d+$", name)
        with open(os.path.join(folder, "package-lock.json")) as file:
            text = file.read()
        self.assertNotRegex(text, "https?:|resolved")
        for package in list(json.loads(text)["packages"].items())[1:]:
            self.assertIn("integrity", package[1], package[0])
        named = {command.split("/")[-1].split()[0] for _, _, command in field.PROGRAMS if command.startswith("node ")}
        self.assertEqual(named, {name for name in os.listdir(folder) if re.fullmatch(r"\w+\.mjs", name)} - {"subject.mjs"})


if __name__ == "__main__":
    unittest.main()
