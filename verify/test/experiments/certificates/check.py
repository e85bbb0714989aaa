#!/usr/bin/env python3
"""The checker proves what the program writes, believes no lie, and answers any bytes with a line and a status."""
import copy
import hashlib
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[4]
FOLDER = SOURCE / "experiments/certificates"
PROGRAM = os.environ["TETRACONE_PROGRAM"]
sys.path.insert(0, str(FOLDER))
import bodies  # noqa: E402
import check  # noqa: E402
import depths  # noqa: E402
import lies  # noqa: E402
import reading  # noqa: E402

CUBE = ("OFF\n8 6 0\n0 0 0\n0 0 1\n0 1 0\n0 1 1\n1 0 0\n1 0 1\n1 1 0\n1 1 1\n"
        "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n")
# A square frame of triangles and of faces with a hole, one unit thick; the fifth vertex of a face bends it.
FRAME = """16 3 0 0
0 0 0 0\n1 3 0 0\n2 3 3 0\n3 0 3 0\n4 1 1 0\n5 2 1 0\n6 2 2 0\n7 1 2 0
8 0 0 1\n9 3 0 1\n10 3 3 1\n11 0 3 1\n12 1 1 1\n13 2 1 1\n14 2 2 1\n15 1 2 1
10 0
2 1\n4 3 2 1 0\n4 4 5 6 7\n1 1.5 1.5 0
2 1\n4 8 9 10 11\n4 15 14 13 12\n1 1.5 1.5 1
1 0\n4 0 1 9 8\n1 0\n4 1 2 10 9\n1 0\n4 2 3 11 10\n1 0\n4 3 0 8 11
1 0\n4 5 4 12 13\n1 0\n4 6 5 13 14\n1 0\n4 7 6 14 15\n1 0\n4 4 7 15 12
0\n"""
# Its face of four corners is not planar: the program replaces it by triangles.
BENT = "v 0 0 0\nv 2 0 0\nv 2 2 0.5\nv 0 2 0\nv 1 1 3\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"
PLACE = "1 0 0 {} 0 1 0 {} 0 0 1 {}\n"


def plate(size):
    """A square plate of unit cubes with a hole in the middle of each nine, as OFF. Each square of its surface is a face."""
    is_in = lambda cell: 0 <= cell[0] < size and 0 <= cell[1] < size and cell[2] == 0 and (cell[0] % 3 != 1 or cell[1] % 3 != 1)
    vertices, faces = {}, []
    for cell in filter(is_in, ((i, j, 0) for i in range(size) for j in range(size))):
        for axis in range(3):
            for side in (0, 1):
                if is_in(tuple(x + (2 * side - 1) * (k == axis) for k, x in enumerate(cell))):
                    continue
                steps = ((0, 0), (1, 0), (1, 1), (0, 1)) if side else ((0, 0), (0, 1), (1, 1), (1, 0))
                corners = [tuple(cell[k] + (side, *step)[(k - axis) % 3] for k in range(3)) for step in steps]
                faces.append([vertices.setdefault(corner, len(vertices)) for corner in corners])
    return "\n".join(["OFF", f"{len(vertices)} {len(faces)} 0", *("%d %d %d" % v for v in vertices), *("4 %d %d %d %d" % tuple(f) for f in faces), ""])


class Certificates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        for name, text in (("cube.off", CUBE), ("frame.poly", FRAME), ("bent.obj", BENT)):
            (cls.folder / name).write_text(text)
        cls.certificates = list(cls.made())

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def asked(cls, *words):
        """The certificate of a command, and the lines of its answers."""
        file = cls.folder / "made.json"
        run = subprocess.run([PROGRAM, *map(str, words), "--certificate", file], check=True, capture_output=True, text=True)
        return file.read_text(), run.stdout.split("\n")[:-1]

    @classmethod
    def made(cls):
        """Certificates of every kind, with the files that they are about."""
        poses = cls.folder / "poses"
        poses.write_text("".join(PLACE.format(*place.split()) for place in (
            "5 0 0", "1.25 1.25 0.125", "3 1 0", "1 1 -0.25", "0.875 1 0", "-20 7 1/3", "1.5 1.5 -4", "0 0 9", "2 2 1.0000000000000002")) +
            "3/5 -4/5 0 4 4/5 3/5 0 1/3 0 0 1 0.5\n0.5 0 0 1.25 0 0.5 0 1.25 0 0 0.5 0.25\n0.25 0 0 0.25 0 0.25 0 0.25 0 0 0.25 0.25\n20 0 0 -5 0 20 0 -5 0 0 20 -5\n")
        points = cls.folder / "points"
        points.write_text("0.5 0.5 0.5\n1.5 1.5 0.5\n1 1 0\n9 9 9\n1/3 1/3 1/3\n0 0 0\n3 3 1/7\n0.1 2.9999999999999996 0.5\n")
        rays = cls.folder / "rays"
        rays.write_text("-1 0.5 0.5 1 0 0\n1.5 1.5 -1 0 0 1\n0.5 0.5 -3 0 0 0.25\n-1 -1 0 1 1 0\n0 0 0 1 0 0\n5 5 5 1 2 3\n-1 0 0 2 0 0\n-3 1.25 0.3 3 1e-30 -1e-3\n")
        bodies = {name: cls.folder / name for name in ("cube.off", "frame.poly", "bent.obj")}
        for a, b in (("frame.poly", "cube.off"), ("bent.obj", "frame.poly"), ("cube.off", "bent.obj")):
            files = [bodies[a], bodies[b]]
            for words in (["collide"], ["collide", "--question", "surface"], ["distance"], ["distance", "--question", "surface"],
                          ["distance", "--within", "1.5"], ["distance", "--within", "1/3", "--question", "surface"]):
                yield (*cls.asked(words[0], *files, "--pose-b", poses, *words[1:]), files, "pose_b", poses)
        ends = cls.folder / "ends"
        ends.write_text("".join(PLACE.format(*place.split()) for place in ("-5 0 0.125", "1.25 1.25 0.125", "3 1 9", "1 1 -9", "0.875 1 0", "-20 7 1", "1.5 1.5 4", "0 0 -9", "2 2 1",
                                                                          "0 0 0", "1 1 1", "9 9 9", "0 1/3 0")))
        for a, b in (("frame.poly", "cube.off"), ("bent.obj", "bent.obj")):
            files = [bodies[a], bodies[b]]
            yield (*cls.asked("relation", *files, "--pose-b", poses), files, "pose_b", poses)
            same = cls.folder / "same"
            same.write_text(PLACE.format(0, 0, 0))
            yield (*cls.asked("motion", *files, "--pose-a0", same, "--pose-a1", same, "--pose-b0", poses, "--pose-b1", ends), files, "to_b", ends)
        turns = [cls.folder / "turn", cls.folder / "turned"]
        turns[0].write_text("1 0 0 0 5 0 0.125\n1 0 0 0 3.5 1 0\n1 1 0 0 -4 1 9\n2 0 0 1 1.25 1.25 0.125\n1 0 0 0 9 0 0\n1/3 1 0 0 0 0 5\n1 0 0 0 0 0 -3\n1 0 0 0 4 1.5 0.25\n")
        turns[1].write_text("1 0 1 0 1 1 0.125\n1 0 0 1 -9 0 1\n1 -1 1/7 0 -9 1 9\n1 0 0 0 5 5 5\n0 0 0 1 9 0 0\n1 0 0 0 0.5 0.5 1e-30\n2 0 0 0 0.25 0.25 3\n-1 0 0 3 -4 1.5 0.25\n")
        for a, b in (("frame.poly", "cube.off"), ("cube.off", "bent.obj")):
            files = [bodies[a], bodies[b]]
            yield (*cls.asked("motion", *files, "--motion", "rigid", "--pose-b0", turns[0], "--pose-b1", turns[1]), files, "from_b", turns[0])
        held = cls.folder / "held"  # places and sizes of B about the unit cube, one of each relation and more
        held.write_text("".join("{0} 0 0 {1} 0 {0} 0 {2} 0 0 {0} {3}\n".format(*words.split()) for words in (
            "1 0 0 0", "0.5 0 0 0.5", "0.5 0.25 1/3 0", "2 0 -0.5 -1", "2 -0.5 -0.5 0", "1 1 0.25 0", "1 0.5 0.25 1/3", "0.5 0.25 0.25 0.25", "3 -1 -1 -1", "1 3 0 0")))
        files = [bodies["cube.off"]] * 2
        for words in (["relation"], ["exit", "--along", "1", "0", "1/3"], ["depth", "--relative", "0.1"]):
            yield (*cls.asked(words[0], *files, "--pose-b", held, *words[1:]), files, "pose_b", held)
        turned = cls.folder / "turned_cubes"  # cubes with an edge, or a corner, towards an edge of the unit cube
        turned.write_text("0.8 -0.6 0 0.75 0.48 0.64 -0.6 0.5 0.36 0.48 0.8 0.25\n0.6 -0.8 0 1 0.8 0.6 0 0.25 0 0 1 0.5\n0.36 0.48 0.8 -0.25 -0.8 0.6 0 0.5 -0.48 -0.64 0.6 0.75\n")
        for along in (("1", "0.125", "0.0625"), ("1", "1", "0"), ("-1", "1/3", "2")):
            yield (*cls.asked("exit", *files, "--pose-b", turned, "--along", *along), files, "pose_b", turned)
        for name, file in bodies.items():
            yield (*cls.asked("inside", file, points), [file], "point", points)
            yield (*cls.asked("ray", file, rays), [file], "ray", rays)
            yield (*cls.asked("ray", file, rays, "--end", "1.75"), [file], "ray", rays)

    def test_relations_of_solids_whose_faces_lie_in_common_planes_are_proved(self):
        files = [self.folder / "plate.off"] * 2
        files[0].write_text(plate(12))
        places = self.folder / "places"
        places.write_text("".join(PLACE.format(*place.split()) for place in ("3 3 0", "0.5 0 0", "0.5 0.5 1", "0 0 0", "3 0 0.5")))
        text, said = self.asked("relation", *files, "--pose-b", places)
        self.assertEqual([line.split()[0] for line in said], ["overlap", "overlap", "meet", "equal", "overlap"])
        self.assertEqual(len(list(check.prove(text, files, [("pose_b", places)]))), len(said))

    def test_what_the_program_writes_is_proved(self):
        for text, said, files, key, given in self.certificates:
            with self.subTest(text=text[:300]):
                proved = list(check.prove(text, files, [(key, given)] if given else ()))
                certificate = json.loads(text)
                self.assertEqual(certificate.get("asked", len(proved)), len(said))  # relations and motions without a proof are left out
                self.assertGreater(len(proved), len(said) // 2)
                for k, answer in enumerate(certificate["answers"]):
                    value, line = answer["answer"], said[answer.get("row", k)]
                    self.assertEqual(proved[k].split()[0], str(answer.get("row", k)))
                    if answer["ask"] == "collide":
                        self.assertEqual(int(value != "apart"), int(line))
                    elif answer["ask"] == "distance":
                        self.assertAlmostEqual(float(reading.exact(value)) ** 0.5, float(line))
                    elif answer["ask"] in ("inside", "within"):
                        self.assertEqual(value, int(line))
                    elif answer["ask"] == "motion":
                        self.assertEqual(["1", *value] if value else ["0"], line.split())
                    elif answer["ask"] == "relation":
                        self.assertEqual(value, line.split()[0])
                    elif answer["ask"] == "exit":
                        self.assertEqual([float(reading.exact(x)) for x in value], [float(x) for x in line.split()])
                        self.assertTrue("overlap" in answer or value[0] == "0" or given.name == "held")
                    elif answer["ask"] == "depth":
                        self.assertLessEqual(float(reading.exact(value)) ** 0.5, float(line.split()[1]) * (1 + 1e-15))
                        if value != "0":
                            self.assertGreater(reading.exact(answer["low"]["square"]), 0.8 * reading.exact(value))
                    else:
                        self.assertEqual(value["face"] if value else "-", int(line.split()[0]) if line != "-" else "-")

    def test_solids_of_other_sizes_are_not_equal(self):
        """A point in one body, whatever its denominator, does not scale that body alone."""
        body = {"vertices": [line.split() for line in CUBE.split("\n")[2:10]], "faces": [[[int(v) for v in line.split()[1:]]] for line in CUBE.split("\n")[10:16]]}
        for size, holds in (("1/2", False), ("1", True)):
            beside = {"in": "b", "point": ["-1/4"] * 3, "ray": ["-1"] * 3, "winding": 0, "directions": [["1"] * 3], "cover": 0}
            poses = {f"pose_{k}": [s, "0", "0", "0", "0", s, "0", "0", "0", "0", s, "0"] for k, s in (("a", "1"), ("b", size))}
            certificate = {"certificate": "tetracone 1", "bodies": [body] * 2, "answers": [{"ask": "relation", **poses, "answer": "equal", "windings": [beside]}]}
            self.assertEqual(lies.believed(json.dumps(certificate)), holds)

    def test_all_relations_are_among_the_proved(self):
        said = {answer["answer"] for text, *_ in self.certificates for answer in json.loads(text)["answers"] if answer["ask"] == "relation"}
        self.assertEqual(said, set(lies.ANSWERS["relation"]))

    def test_a_way_must_leave_all_contact_and_a_border_lead_from_outside(self):
        text, files = next((text, files) for text, _, files, *_ in self.certificates if '"covers"' in text)
        answers = json.loads(text)["answers"]
        row = next(k for k, answer in enumerate(answers) if answer["answer"] == "covers")
        of = answers[row]["way"]["of"]
        for key, value in ((("way", "pose"), answers[row]["pose_" + of]), (("way", "of"), "b" if of == "a" else "a"), (("border", "outside", "winding"), answers[row]["windings"][0])):
            certificate = json.loads(text)
            spoiled = certificate["answers"][row]
            for part in key[:-1]:
                spoiled = spoiled[part]
            self.assertNotEqual(spoiled[key[-1]], value)
            spoiled[key[-1]] = value
            self.assertFalse(lies.believed(json.dumps(certificate), files))

    def test_pieces_that_cross_are_triangles_that_nothing_else_meets(self):
        corners = [["0", "0", "0"], ["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"], ["1/4", "1/4", "-1"], ["1/4", "1/4", "1"], ["1/2", "1/4", "1"]]
        tetrahedron = [[[0, 2, 1]], [[0, 1, 3]], [[1, 2, 3]], [[0, 3, 2]]]
        doubled, through, needle = [[[0, 1, 2]], [[0, 2, 1]]], [[[4, 5, 6]], [[4, 6, 5]]], [[[4, 5]]]
        for more, piece, reason in (([], 0, None), ([], 2, None), ([[[0], [1], [2]]], 4, "no triangle"), ([[[0, 1], [2]]], 4, "no triangle"),
                                    (doubled, 0, "meets one"), (through, 0, "meets one"), (through, 4, "meets one"), (needle, 0, "meets one")):
            entry = reading.Object([("vertices", corners), ("faces", tetrahedron + more)])
            placed = bodies.Placed(bodies.Body(entry, None))
            with self.subTest(more=more, piece=piece):
                if reason is None:
                    depths.Crossings([placed] * 2).triangle(0, piece)
                else:
                    with self.assertRaisesRegex(reading.Refused, reason):
                        depths.Crossings([placed] * 2).triangle(0, piece)

    def test_a_face_is_cut_by_its_own_corners(self):
        lines = CUBE.split("\n")
        vertices, faces = [line.split() for line in lines[2:10]], [[[int(v) for v in line.split()[1:]]] for line in lines[10:16]]
        for apex, is_legal in ((8, False), (None, True)):
            square = faces[1][0]
            cut = [[1, *square[:3]], [1, square[2], square[3], square[0]]] if is_legal else [[1, apex, square[k - 1], square[k]] for k in range(4)]
            entry = reading.Object([("vertices", vertices + [["9", "1/2", "1/2"]]), ("faces", faces), ("cut", cut)])
            if is_legal:
                self.assertTrue(bodies.Body(entry, None).is_closed)
            else:
                with self.assertRaisesRegex(reading.Refused, "none of the face's"):
                    bodies.Body(entry, None)

    def test_rows_of_an_exit_begin_with_a_common_point(self):
        text, files = next((text, files) for text, _, files, *_ in self.certificates if '"overlap":[' in text)
        certificate = json.loads(text)
        answer = next(answer for answer in certificate["answers"] if "overlap" in answer)
        certificate["answers"] = [answer]
        self.assertTrue(lies.believed(json.dumps(certificate), files))
        for rows in ([], answer["overlap"][1:], answer["overlap"][:-1], [{"at": "1", "windings": []}] + answer["overlap"]):
            answer["overlap"], kept = rows, answer["overlap"]
            self.assertFalse(lies.believed(json.dumps(certificate), files))
            answer["overlap"] = kept

    def test_a_flat_solid_in_a_face_does_not_meet_but_is_covered(self):
        flat = {"vertices": [["0", "0", "1"], ["1", "0", "1"], ["0", "1", "1"]], "faces": [[[0, 1, 2]], [[2, 1, 0]]]}
        lines = CUBE.split("\n")
        cube = {"vertices": [words.split() for words in lines[2:10]], "faces": [[[int(v) for v in words.split()[1:]]] for words in lines[10:16]]}
        pose = PLACE.format(0, 0, 0).split()
        touch = {"ask": "relation", "pose_a": pose, "pose_b": pose, "answer": "meet", "plane": ["0", "0", "1"], "windings": [],
                 "witness": {"points": [["1/4", "1/4", "1"]] * 2, "faces": [5, 0]}}
        with self.assertRaises(reading.Refused) as refusal:
            list(check.prove(json.dumps({"certificate": "tetracone 1", "bodies": [cube, flat], "answers": [touch]})))
        self.assertIn("a part of the solids has no point", str(refusal.exception))

    def test_a_model_in_the_certificate_needs_no_file(self):
        text, _ = self.asked("distance", self.folder / "cube.off", self.folder / "bent.obj", "--merge")
        self.assertIn("vertices", json.loads(text)["bodies"][0])
        self.assertEqual(len(list(check.prove(text))), 1)

    def test_a_model_that_is_not_as_its_file_stands_in_the_certificate(self):
        point = self.folder / "inner"
        point.write_text("1/8 1/8 1/8\n")
        short = CUBE.replace("8 6 0\n", "8 7 0\n") + "2 0 1\n"
        unused = CUBE.replace("8 6 0\n", "9 6 0\n").replace("1 1 1\n", "1 1 1\nnan 0 0\n")
        for name, data in (("short.off", short), ("unused.off", unused)):
            file = self.folder / name
            file.write_text(data)
            text, _ = self.asked("inside", file, point)
            self.assertEqual(len(list(check.prove(text, [], [("point", point)]))), 1, name)

    def test_files_are_for_the_bodies_that_name_one(self):
        turned, cube = SOURCE / "verify/test/models/frame.poly", self.folder / "cube.off"
        text, _ = self.asked("distance", turned, cube)
        self.assertEqual(["vertices" in body for body in json.loads(text)["bodies"]], [True, False])
        self.assertEqual(len(list(check.prove(text, [cube]))), 1)
        for files in ([cube, turned], []):
            with self.assertRaises(reading.Bad):
                list(check.prove(text, files))

    def test_it_is_about_the_files_and_numbers_that_are_named(self):
        text, _, files, key, given = self.certificates[0]
        self.assertTrue(lies.believed(text, files))
        self.assertFalse(lies.believed(text, files[::-1]))
        self.assertFalse(lies.believed(text))
        others = self.folder / "others"
        others.write_text(given.read_text().replace("1.25", "1.26"))
        with self.assertRaises(reading.Refused):
            list(check.prove(text, files, [(key, others)]))
        certificate = json.loads(text)
        del certificate["answers"][1:3]
        numbered = {**certificate, "asked": len(certificate["answers"]) + 2,
                    "answers": [{**answer, "row": row} for row, answer in zip((0, *range(3, 100)), certificate["answers"])]}
        said = list(check.prove(json.dumps(numbered), files, [(key, given)]))
        self.assertEqual([line.split()[0] for line in said[:3]], ["0", "3", "4"])
        shifted = copy.deepcopy(numbered)
        shifted["answers"][1]["row"] = 2
        with self.assertRaises(reading.Refused):
            list(check.prove(json.dumps(shifted), files, [(key, given)]))
        descending, uncounted, one_more = (copy.deepcopy(numbered) for _ in range(3))
        descending["answers"][1]["row"] = 0
        del uncounted["asked"]
        one_more["asked"] += 1
        for spoiled in (certificate, descending, uncounted, one_more):
            with self.assertRaises(reading.Bad):
                list(check.prove(json.dumps(spoiled), files, [(key, given)]))
        others.write_text("# none\n")
        with self.assertRaises(reading.Bad):
            list(check.prove(text, files, [(key, others)]))

    def test_it_reads_what_the_program_reads(self):
        point, four = self.folder / "inner", self.folder / "four_rows"
        point.write_text("1/8 1/8 1/8\n")
        four.write_text("1 0 0 1/2\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
        triangles = ("1 3 2", "1 2 4", "1 4 3", "2 3 4")
        for name, data in (("without.off", CUBE.removeprefix("OFF\n").encode()), ("stuck.off", CUBE.replace("OFF\n", "OFF").encode()), ("latin.off", b"OFF # \xe8\n" + CUBE.removeprefix("OFF\n").encode()),
                           ("marked.poly", ("4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n4 1\n" + "".join(
                               f"1 0 -1\n3 {corners}\n" for corners in triangles) + "0\n").encode())):
            file = self.folder / name
            file.write_bytes(data)
            text, _ = self.asked("inside", file, point)
            self.assertEqual(len(list(check.prove(text, [file], [("point", point)]))), 1, name)
        cube = self.folder / "cube.off"
        text, _ = self.asked("collide", cube, cube, "--pose-b", four)
        self.assertEqual(len(list(check.prove(text, [cube, cube], [("pose_b", four)]))), 1)

    def test_faces_that_the_program_leaves_out_and_triangles_that_cancel_are_refused(self):
        point = self.folder / "above"
        point.write_text("5.5 5 5\n")
        corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 5 5\n6 5 5\n"
        for name, data in (("short.off", f"OFF\n6 5 0\n{corners}2 4 5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"),
                           ("short.obj", "".join(f"v {line}\n" for line in corners.splitlines()) + "f 5 6\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")):
            file = self.folder / name
            file.write_text(data)
            certificate = json.loads(self.asked("inside", file, point)[0])
            self.assertEqual(certificate["answers"][0]["answer"], -1)
            certificate["bodies"] = [{"file": name, "sha256": hashlib.sha256(data.encode()).hexdigest()}]
            certificate["answers"] = [{"ask": "inside", "point": ["5.5", "5", "5"], "answer": 0, "face": 0}]
            with self.assertRaisesRegex(reading.Bad, "less than three corners"):
                list(check.prove(json.dumps(certificate), [file]))
        bent = self.folder / "bent.obj"
        certificate = json.loads(self.asked("inside", bent, point)[0])
        self.assertRegex(list(check.prove(json.dumps(certificate), [bent]))[0], "proved, of faces that are not planar as they are cut here$")
        cut = certificate["bodies"][0]["cut"]
        _, i, j, k = cut[0]
        cut += [[0, i, j, k], [0, k, j, i]]
        self.assertFalse(lies.believed(json.dumps(certificate), [bent]))

    def test_no_lie_is_believed(self):
        random.seed(48)
        count = 0
        for text, _, files, _, _ in self.certificates:
            certificate = json.loads(text)
            certificate["answers"] = random.sample(certificate["answers"], 2)  # lies grow with the square of the answers
            for kind in (lies.spoiled_proofs, lies.false_claims):
                told = [lie for lie in kind(certificate) if random.random() < 0.02]
                for name, spoiled in random.sample(told, min(len(told), 30)):
                    count += 1
                    self.assertFalse(lies.believed(json.dumps(spoiled), files), name)
        self.assertGreater(count, 500)

    def test_bytes_that_are_no_certificate_get_a_line(self):
        random.seed(49)
        text, _, files, _, _ = self.certificates[0]
        for _ in range(400):
            spoiled = bytearray(text.encode())
            for _ in range(random.choice((1, 1, 2, 50))):
                first = random.randrange(len(spoiled))
                spoiled[first:first + random.choice((0, 1, 1, 30))] = random.choice((b"", b"9", b"[", b'"', b"\xff", b"null", b"{}", b"-1", b"1e9"))
            try:
                list(check.prove(bytes(spoiled), files))
            except (check.Refused, *check.BAD):
                pass

    def test_status_and_line(self):
        text, _, files, _, _ = self.certificates[0]
        file = self.folder / "certificate.json"
        for content, status in ((text, 0), (text.replace('"answer":"apart"', '"answer":"surfaces"', 1), 1), ("{", 2), ("[" * 100000, 2),
                                ('{"certificate":"tetracone 2","bodies":[],"answers":[]}', 2), ("\0", 2), ("", 2)):
            file.write_text(content)
            run = subprocess.run([sys.executable, "-B", FOLDER / "check.py", file, *files], capture_output=True, text=True)
            self.assertEqual(run.returncode, status, run.stderr)
            self.assertEqual(run.stderr.count("\n"), int(status > 0), run.stderr)
        run = subprocess.run([sys.executable, "-B", FOLDER / "check.py", "-"], input="{}\n[]\n", capture_output=True, text=True)
        self.assertEqual([line.split(":")[0] for line in run.stdout.splitlines()], ["bad input"] * 2)


if __name__ == "__main__":
    unittest.main()
