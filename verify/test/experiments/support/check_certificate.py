#!/usr/bin/env python3
"""The checker of certificates of distance proves what the program writes, and refuses what somebody has forged."""
import contextlib
import copy
import importlib.util
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[4]
PROGRAM = os.environ["TETRACONE_PROGRAM"]
spec = importlib.util.spec_from_file_location("check_certificate", SOURCE / "experiments/support/check_certificate.py")
checker = importlib.util.module_from_spec(spec)
spec.loader.exec_module(checker)

CUBE = ("OFF\n8 6 0\n0 0 0\n0 0 1\n0 1 0\n0 1 1\n1 0 0\n1 0 1\n1 1 0\n1 1 1\n"
        "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n")
POSES = "1 0 0 1.5 0 1 0 2.25 0 0 1 0.25\n3/5 -4/5 0 3 4/5 3/5 0 1/3 0 0 1 5\n0.25 0 0 0.5 0 0.25 0 0.5 0 0 0.25 0.5\n"
NO_NUMBERS = ["nan", "NaN", "inf", "-inf", "Infinity", "1e400", "1e-5", "0.5", "1/0", "", " 1", "1_0", "0x1", "+1", "\u0661", "1/-2", "--1", "1/2/3",
              None, True, 1.5, 10**400, [], ["1"], {}]


class Certificates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "cube.off").write_text(CUBE)
        (cls.folder / "poses").write_text(POSES)
        cls.solid, cls.surface = cls.made("solid"), cls.made("surface")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def made(cls, question, *words, a="cube.off", b="cube.off", poses="poses"):
        file = cls.folder / "made.json"
        subprocess.run([PROGRAM, "distance", cls.folder / a, cls.folder / b, "--pose-b", cls.folder / poses, "--question", question,
                        "--certificate", file, *words], check=True, stdout=subprocess.DEVNULL)
        return json.loads(file.read_text())

    def told(self, text, *words):
        """What the checker says: its lines, or nothing where it refuses."""
        file = self.folder / "certificate.json"
        file.write_text(text if isinstance(text, str) else json.dumps(text), encoding="utf-8")
        out = io.StringIO()
        before, sys.argv = sys.argv, ["check_certificate.py", str(file), *map(str, words)]
        try:
            with contextlib.redirect_stdout(out):
                checker.main()
        except SystemExit as refusal:
            self.assertRegex(str(refusal), "^check_certificate.py: not proved: ")
            return None
        finally:
            sys.argv = before
        return out.getvalue().split()

    def refused(self, good, what, forge):
        bad = copy.deepcopy(good)
        forge(bad)
        self.assertNotEqual(bad, good, what)
        self.assertIsNone(self.told(bad), what)

    def test_what_the_program_writes_is_proved(self):
        self.assertEqual(self.told(self.solid), ["29/16", "436/25", "0"])
        self.assertEqual(self.told(self.surface), ["29/16", "436/25", "1/16"])
        files = [self.folder / "cube.off"] * 2 + ["--pose-b", self.folder / "poses"]
        self.assertEqual(len(self.told(self.solid, *files)), 3)

    def test_numbers_may_be_long_or_of_any_size(self):
        (self.folder / "long").write_text("1 0 0 %d/%d 0 1 0 7 0 0 1 0.25\n" % (7**3000, 3**5000 + 1))
        self.assertEqual(len(self.told(self.made("solid", poses="long"))), 1)
        lines = CUBE.splitlines()
        tiny = [" ".join("2e-308" if x == "1" else x for x in line.split()) for line in lines[2:10]]
        (self.folder / "tiny.off").write_text("\n".join(lines[:2] + tiny + lines[10:]) + "\n")
        (self.folder / "wild").write_text("1e-300 0 0 1e300 0 1e300 0 1e-300 0 1e-300 1 3\n")
        self.assertEqual(len(self.told(self.made("surface", a="tiny.off", poses="wild"))), 1)

    def test_what_is_no_number_is_refused(self):
        for number in NO_NUMBERS:
            for what, place in (("square", lambda c: (c["answers"][0], "squared_distance")), ("point", lambda c: (c["answers"][0]["points"][1], 2)),
                                ("pose", lambda c: (c["answers"][0]["pose_a"], 0)), ("axis", lambda c: (c["answers"][0]["cover"][0]["axis"], 1)),
                                ("vertex", lambda c: (c["b"]["vertices"][0], 0))):
                def forge(c):
                    holder, key = place(c)
                    holder[key] = number
                self.refused(self.solid, (what, number), forge)
        for token in ("NaN", "Infinity", "-Infinity", "1e999", "1" * 5000):
            text = json.dumps(self.solid).replace('"29/16"', token)
            self.assertIsNone(self.told(text), token)

    def test_squares_that_are_others_are_refused(self):
        for square in ("-29/16", "0", "28/16", "30/16", "29/15", "29", "1" + "0" * 400, "29000000000000000000000000000001/16000000000000000000000000000000"):
            for good in (self.solid, self.surface):
                self.refused(good, square, lambda c: c["answers"][0].update(squared_distance=square))
        self.refused(self.solid, "0 and no cover", lambda c: c["answers"][0].update(squared_distance="0", cover=[]))

    def test_other_features_are_refused(self):
        answer = self.solid["answers"][0]
        self.assertEqual(answer["holders"], ["edge 6 7", "vertex 0"])
        wrong = ["", "edge", "edge 6", "edge 7 6 5", "edge 0 1", "edge 0 7", "edge 6 6", "edge 6 8", "edge -2 7", "edge a b", "vertex 6", "vertex 99",
                 "vertex -1", "vertex", "vertex 6.0", "Edge 6 7", "face 0", "face 6", "face -1", "interior", "edge 6 7 " * 2, None, 6, ["edge", 6, 7], {}]
        for holder in wrong:
            if holder in ("edge 7 6 5", "edge 6 7 " * 2):
                continue  # what follows the numbers says nothing
            self.refused(self.solid, holder, lambda c: c["answers"][0]["holders"].__setitem__(0, holder))
        self.refused(self.solid, "exchanged", lambda c: c["answers"][0]["holders"].reverse())
        self.refused(self.solid, "one holder", lambda c: c["answers"][0]["holders"].pop())
        self.refused(self.solid, "three points", lambda c: c["answers"][0]["points"].append(["0", "0", "0"]))
        # A vertex that no face has is no part of the body.
        def unused(c):
            c["b"]["vertices"].append(["-1/4", "0", "0"])
            point = ["5/4", "9/4", "1/4"]
            c["answers"][0].update(points=[["1", "1", "1/4"], point], squared_distance="13/8", holders=["edge 6 7", "vertex 8"])
        self.refused(self.solid, "unused vertex", unused)

    def test_pairs_that_are_farther_are_refused(self):
        """Two true points of the bodies that are not the nearest."""
        def farther(c):
            c["answers"][0].update(points=[["1", "1", "0"], ["3/2", "9/4", "1/4"]], squared_distance="15/8", holders=["vertex 6", "vertex 0"])
        self.refused(self.solid, "the cover of the nearest", farther)

        def without_cover(c):
            farther(c)
            c["answers"][0]["cover"] = []
        self.refused(self.solid, "no cover", without_cover)

        def without_near_pieces(c):
            farther(c)
            for part in c["answers"][0]["cover"]:
                part["b"] = part["b"][1:] or part["b"]
        self.refused(self.solid, "a cover of less", without_near_pieces)

    def test_covers_that_miss_a_pair_are_refused(self):
        for n, answer in enumerate(self.surface["answers"]):
            for k, part in enumerate(answer["cover"]):
                self.refused(self.surface, (n, k), lambda c: c["answers"][n]["cover"].pop(k))
                for side in "ab":
                    for piece in part[side]:
                        others = [p for p in answer["cover"] if p is not part]
                        if any(piece in p[side] and set(part["ab".replace(side, "")]) <= set(p["ab".replace(side, "")]) for p in others):
                            continue  # it is there twice
                        self.refused(self.surface, (n, k, side, piece), lambda c: c["answers"][n]["cover"][k][side].remove(piece))
        for number in (-1, 12, 10**9, "0", None, 0.0, True, [0]):
            self.refused(self.solid, number, lambda c: c["answers"][0]["cover"][0]["a"].append(number))

    def test_false_planes_are_refused(self):
        good = self.solid["answers"][0]["cover"][0]["axis"]
        for axis in (["0", "0", "0"], ["-" + x if x != "0" else x for x in good], ["0", "0", "1"], ["1", "0", "0"], good[:2], good + ["1"], [], "100",
                     ["1" + "0" * 300, "1", "0"], None):
            self.refused(self.solid, axis, lambda c: c["answers"][0]["cover"][0].update(axis=axis))

    def test_changed_bodies_are_refused(self):
        def without_piece(side, n):
            def forge(c):
                c[side]["pieces"].pop(n)
                for answer in c["answers"]:
                    for part in answer["cover"]:
                        part[side] = [k - (k > n) for k in part[side] if k != n]
            return forge
        for side in "ab":
            for n in (0, 5, 11):
                self.refused(self.surface, (side, n), without_piece(side, n))
                self.refused(self.surface, (side, n, "turned"), lambda c: c[side]["pieces"][n]["corners"].reverse())
                self.refused(self.surface, (side, n, "of another face"), lambda c: c[side]["pieces"][n].update(face=(c[side]["pieces"][n]["face"] + 1) % 6))

        def edges_alone(c):
            loop = c["b"]["faces"][0][0]
            c["b"]["pieces"][0]["corners"] = loop[:2]
        self.refused(self.surface, "edges without what is between", edges_alone)
        self.refused(self.surface, "a bent face", lambda c: c["a"]["vertices"][7].__setitem__(0, "2"))
        self.refused(self.surface, "a loop more", lambda c: c["b"]["faces"][1].append([0, 1, 2]))
        self.refused(self.surface, "an empty loop", lambda c: c["b"]["faces"][1].append([]))
        self.refused(self.surface, "a face less", lambda c: c["b"]["faces"].pop())
        self.refused(self.surface, "no faces", lambda c: c["b"].update(faces=[], pieces=[]))
        self.refused(self.surface, "a vertex beyond", lambda c: c["b"]["faces"][0][0].append(8))
        self.refused(self.surface, "a vertex before", lambda c: c["b"]["faces"][0][0].__setitem__(0, -8))
        for key in ("a", "b", "answers", "question"):
            self.refused(self.surface, key, lambda c: c.pop(key))
        for key in self.surface["answers"][0]:
            self.refused(self.surface, key, lambda c: c["answers"][0].pop(key))
        self.refused(self.surface, "poses exchanged", lambda c: c["answers"][0].update(pose_a=c["answers"][0]["pose_b"], pose_b=c["answers"][0]["pose_a"]))
        self.refused(self.surface, "a number less", lambda c: c["answers"][0]["pose_a"].pop())
        self.refused(self.surface, "a flat pose", lambda c: c["answers"][0]["pose_a"].__setitem__(0, "0"))

    def test_an_open_surface_has_no_solid(self):
        """The face that holds the nearest point is left out everywhere, and with it the nearness."""
        opened = CUBE.replace("8 6 0", "8 5 0").replace("4 0 4 5 1\n", "")
        (self.folder / "open.off").write_text(opened)
        honest = self.made("surface", b="open.off")
        self.assertEqual(len(self.told(honest)), 3)
        self.refused(honest, "as a solid", lambda c: c.update(question="solid"))
        self.assertIsNone(self.told(honest, self.folder / "cube.off", self.folder / "cube.off", "--pose-b", self.folder / "poses"))

    def test_one_solid_in_the_other_is_at_no_distance(self):
        self.assertEqual(self.told(self.surface)[2], "1/16")
        self.refused(self.surface, "solids", lambda c: c.update(question="solid"))

        def outside(c):
            c["question"] = "solid"
            c["answers"] = [c["answers"][2]]
            c["answers"][0]["holders"] = ["interior", "interior"]
        self.refused(self.surface, "interiors", outside)
        for question in ("Solid", "", None, ["solid"]):
            self.refused(self.surface, question, lambda c: c.update(question=question))

    def test_it_is_about_the_files_that_are_named(self):
        cube, poses = self.folder / "cube.off", self.folder / "poses"
        (self.folder / "other.off").write_text(CUBE.replace("1 1 1\n", "1 1 1.0000000000000002\n", 1))
        (self.folder / "fewer").write_text("".join(POSES.splitlines(True)[:2]))
        (self.folder / "others").write_text(POSES.replace("1.5", "1.25"))
        lines = CUBE.splitlines()[2:]
        (self.folder / "cube.obj").write_text("".join("v " + line + "\n" for line in lines[:8]) +
                                              "".join("f " + " ".join(str(int(v) + 1) for v in line.split()[1:]) + "\n" for line in lines[8:]))
        self.assertIsNotNone(self.told(self.solid, cube, self.folder / "cube.obj", "--pose-b", poses))
        for words in ([self.folder / "other.off", cube, "--pose-b", poses], [cube, self.folder / "other.off", "--pose-b", poses],
                      [cube, cube, "--pose-b", self.folder / "others"], [cube, cube, "--pose-b", self.folder / "fewer"], [cube, cube],
                      ["--pose-a", poses], [cube, cube, "--pose-a", poses, "--pose-b", poses], [cube, poses, "--pose-b", poses],
                      [cube, self.folder / "not-there.off", "--pose-b", poses]):
            self.assertIsNone(self.told(self.solid, *words), words)

    def test_what_is_no_certificate_is_refused(self):
        text = json.dumps(self.solid)
        for bad in ["", "{}", "[]", "null", "1", '"a"', "[" * 100000, text.replace('"question": "solid"', '"question": "surface", "question": "solid"')]:
            self.assertIsNone(self.told(bad), bad[:40])
        for part in range(1, 16):
            self.assertIsNone(self.told(text[:len(text) * part // 16]))
        self.refused(self.solid, "no answer", lambda c: c.update(answers=[]))
        self.refused(self.solid, "answers by name", lambda c: c.update(answers={"0": c["answers"][0]}))


if __name__ == "__main__":
    unittest.main()
