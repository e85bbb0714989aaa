#!/usr/bin/env python3
"""The checker proved in Coq: its theorems assume nothing, it proves true answers, and believes no lie. Skipped where Coq or OCaml is absent."""
import copy
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[4] / "experiments/certificates/coq"

CUBE_VERTICES = [[x, y, z] for x in "01" for y in "01" for z in "01"]
CUBE_FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
CUBE = {"vertices": CUBE_VERTICES, "faces": [[face] for face in CUBE_FACES], "groups": [0, 1, 2, 3, 4, 5]}
# Top and bottom have a hole, and its walls look inward; the bottom is cut into triangles.
FRAME_VERTICES = [[x, y, z] for z in "01" for x, y in ("00", "30", "33", "03", "11", "21", "22", "12")]
FRAME_FACES = [[[3, 2, 1, 0], [4, 5, 6, 7]], [[8, 9, 10, 11], [15, 14, 13, 12]], [[0, 1, 9, 8]], [[1, 2, 10, 9]], [[2, 3, 11, 10]], [[3, 0, 8, 11]],
               [[5, 4, 12, 13]], [[6, 5, 13, 14]], [[7, 6, 14, 15]], [[4, 7, 15, 12]]]
FRAME = {"vertices": FRAME_VERTICES, "faces": FRAME_FACES, "groups": [list(range(8)), 8, 9, 10, 11, 12, 13, 14, 15, 16],
         "cut": [[0, *t] for t in ((0, 4, 1), (1, 4, 5), (1, 5, 2), (2, 5, 6), (2, 6, 3), (3, 6, 7), (3, 7, 0), (0, 7, 4))]}


def at(x, y="0", z="0", scale="1"):
    return [scale, "0", "0", x, "0", scale, "0", y, "0", "0", scale, z]


def turned(x, z="0", w="1"):
    return [w, "0", "0", z, x, "0", "0"]


def axis(k, sign=1):
    return [str(sign) if i == k else "0" for i in range(3)]


def outside(holder, vertex, k, sign):
    """The vertex is outside, seen by a ray along an axis away from the body."""
    return {"in": holder, "vertex": vertex, "ray": axis(k, sign), "winding": 0, "directions": [axis(k, -sign)], "cover": 0}


def cube_ray(crossed):
    """From within the cube: pieces 0 to 5 are left, right, front, back, bottom, top; all others are behind or beside."""
    return {"ray": ["3", "1", "2"], "directions": [axis(0, -1), ["0", "3", "-2"], axis(1, -1), ["-1", "3", "0"], axis(2, -1), ["-2", "0", "3"]],
            "cover": ["b", 0, "crossed", 2, 3, 4, 5] if crossed else 0}


def of_pair(ask, answer, pose_b, **proof):
    question = {} if ask == "relation" else {"question": proof.pop("question", "solid")}
    return {"ask": ask, **question, "pose_a": at("0"), "pose_b": pose_b, "answer": answer, **proof}


APART = {"directions": [axis(0)], "cover": 0, "windings": [outside("b", 0, 0, -1), outside("a", 7, 0, 1)]}
OPENED = {"directions": [axis(0), ["2", "0", "1/7"]], "cover": ["a", 1, ["b", 0, 0, 0, 0, 0, 0], 0, 0, 0, 0], "windings": APART["windings"]}
TOUCH = {"points": [["1", "1/2", "1/3"], ["1", "1/2", "1/3"]], "faces": [1, 0]}
# B, a tenth of A's size, is inside: all its vertices are within the same rays' reach.
WITHIN = {"in": "a", "vertex": 0, "winding": 1, **cube_ray(True)}
SHELL = {"directions": [axis(k, s) for k in range(3) for s in (1, -1)], "cover": ["a", 0, 1, 2, 3, 4, 5]}
HELD = {**SHELL, "windings": [WITHIN, outside("b", 0, 0, -1)]}
MOVE = {"from_a": at("0"), "to_a": at("0")}


def side(holder, point, sign=0):
    """A point within the body, or outside, seen by a ray along x away from it."""
    ray = {"winding": 0, "ray": axis(0, sign), "directions": [axis(0, -sign)], "cover": 0} if sign else {"winding": 1, **cube_ray(True)}
    return {"in": holder, "point": point, **ray}


def approach(holder, point):
    """From within a cube to a point in the middle of a face, or between the planes of all faces."""
    return {"winding": side(holder, point), "directions": [axis(k, s) for k in range(3) for s in (-1, 1)], "cover": ["b", 0, 1, 2, 3, 4, 5]}


IN_A, IN_B, ON_BOTH = ["1/2", "9/20", "7/16"], ["3/2", "9/20", "7/16"], ["1", "9/20", "7/16"]
# B, half as large, in a corner of A, grows into its place.
GROWS = {"of": "b", "pose": at("1/8", "1/8", "1/8", "1/4"), **SHELL, "windings": [WITHIN, outside("b", 0, 0, -1)]}
CORNER = {"way": GROWS, "windings": [side("a", ["3/4"] * 3), side("b", ["3/4"] * 3, 1)],
          "border": {"face": 0, "point": ["0", "1/4", "1/4"], "outside": {"winding": side("a", ["-1", "1/4", "1/4"], -1), "directions": [axis(0)], "cover": 0}}}
# A leaves B along x; from 2 to 1 lengths of it.
GONE = {"until": "1", "directions": [axis(0, -1)], "cover": 0, "windings": [outside("b", 0, 0, 1), outside("a", 7, 0, -1)]}
BEFORE = {"point": ON_BOTH, "in_a": approach("a", IN_B), "in_b": approach("b", IN_A)}

PAIRS = {"certificate": "tetracone 1", "bodies": [CUBE, CUBE], "answers": [
    of_pair("collide", "apart", at("3/2"), **APART),
    of_pair("collide", "apart", at("1.0000000000000002"), **OPENED),
    of_pair("collide", "apart", at("2"), question="surface", directions=[axis(0)], cover=0),
    of_pair("collide", "surfaces", at("1"), witness=TOUCH),
    of_pair("collide", "surfaces", at("1", "1", "1"), witness={"points": [["1"] * 3] * 2, "faces": [5, 2]}),
    of_pair("collide", "b_in_a", at("1/2", "0.45", "0.4375", "1/10"), **SHELL, windings=[WITHIN]),
    of_pair("distance", "4", at("3"), witness={"points": [["1", "1/2", "1/3"], ["3", "1/2", "1/3"]], "faces": [1, 0]}, **APART),
    of_pair("distance", "0", at("1"), witness=TOUCH),
    of_pair("within", 0, at("3"), limit="1.9999999999999998", **APART),
    of_pair("within", 1, at("3"), limit="2", witness={"points": [["1", "1/2", "1/3"], ["3", "1/2", "1/3"]], "faces": [1, 0]}),
    of_pair("within", 1, at("1/2", "0.45", "0.4375", "1/10"), limit="0", windings=[WITHIN]),
    of_pair("relation", "disjoint", at("3/2"), **APART),
    of_pair("relation", "contains", at("1/2", "0.45", "0.4375", "1/10"), **HELD),
    of_pair("relation", "meet", at("1"), witness=TOUCH, plane=axis(0), windings=[side("a", IN_A), side("b", IN_A, -1), side("b", IN_B), side("a", IN_B, 1)]),
    of_pair("relation", "covers", at("0", scale="1/2"), **CORNER),
    of_pair("relation", "equal", at("0")),
    {"ask": "exit", "pose_a": at("0"), "pose_b": at("0"), "direction": axis(0), "answer": ["1", "1"], "plane": axis(0, -1), "gone": GONE, "before": [BEFORE] * 2,
     "windings": [side("a", IN_A), side("b", IN_A)]},
    {"ask": "exit", "pose_a": at("0"), "pose_b": at("1"), "direction": axis(0), "answer": ["0", "0"], "plane": axis(0)},
    {"ask": "depth", "pose_a": at("0"), "pose_b": at("0"), "answer": "1", "vector": axis(0), "plane": axis(0, -1)},
    {"ask": "motion", "question": "solid", **MOVE, "from_b": at("5"), "to_b": at("3/2"), "answer": None, **APART},
    {"ask": "motion", "question": "surface", **MOVE, "from_b": at("3", "-3"), "to_b": at("0", "-1.5"), "answer": None,
     "directions": [axis(0), axis(1, -1)], "cover": ["t", "1/2", 0, 1]},
    {"ask": "motion", "question": "solid", **MOVE, "from_b": at("5"), "to_b": at("-3"), "answer": ["0.5", "0.5"], **APART,
     "witness": {"time": "1/2", **TOUCH}},
    {"ask": "motion", "question": "solid", **MOVE, "from_b": turned("5"), "to_b": turned("3", "1"), "answer": None, **APART},
    {"ask": "motion", "question": "solid", "from_a": turned("0", "0", "3"), "to_a": turned("0"), "from_b": turned("5"), "to_b": turned("-3", "0", "2"),
     "answer": ["0.5", "0.5"], **APART, "witness": {"time": "1/2", **TOUCH}},
]}
CUBE_ALONE = {"certificate": "tetracone 1", "bodies": [CUBE], "answers": [
    {"ask": "inside", "point": ["0.5", "0.5", "0.5"], "answer": 1, "winding": 1, **cube_ray(True)},
    {"ask": "inside", "point": ["3", "0.5", "0.5"], "answer": -1, "winding": 0, "ray": axis(0), "directions": [axis(0, -1)], "cover": 0},
    {"ask": "inside", "point": ["0", "0.5", "1"], "answer": 0, "face": 5},
    {"ask": "ray", "origin": ["-1", "0.5", "0.25"], "direction": ["2", "0", "0"], "answer": {"face": 0, "t": "1/2"}, "directions": [axis(0)], "cover": 0},
    {"ask": "ray", "origin": ["0", "0", "0"], "direction": ["-1", "0", "0"], "answer": {"face": 0, "t": "0"}, "directions": [], "cover": "touched"},
    {"ask": "ray", "origin": ["-1", "0.5", "0.25"], "direction": ["2", "0", "0"], "end": "0.25", "answer": None, "directions": [axis(0)], "cover": 0},
    {"ask": "ray", "origin": ["-1", "0.5", "0.25"], "direction": ["-2", "0", "0"], "answer": None, "directions": [axis(0)], "cover": 0},
]}
FRAME_ALONE = {"certificate": "tetracone 1", "bodies": [FRAME], "answers": [
    {"ask": "inside", "point": ["0.5", "1.5", "0.5"], "answer": 1, "ray": ["0", "0", "1"], "winding": 1,
     "directions": [axis(2, -1), axis(0), axis(0, -1), axis(1), axis(1, -1)], "cover": ["b", 0, "crossed", 4, 1, 3, 2, 1, 1, 1, 1]},
    {"ask": "inside", "point": ["1.5", "1.5", "0.5"], "answer": -1, "ray": ["0", "0", "1"], "winding": 0,
     "directions": [axis(2, -1), axis(0), axis(0, -1), axis(1), axis(1, -1)], "cover": ["b", 0, "crossed", 4, 1, 3, 2, 4, 1, 3, 2]},
    {"ask": "inside", "point": ["1", "1.5", "0"], "answer": 0, "face": 0},
    {"ask": "inside", "point": ["0.5", "0.25", "1"], "answer": 0, "face": 1},
]}
TRUE_WRONG = {"collide": ["apart", "surfaces", "a_in_b", "b_in_a"], "distance": ["0", "1", "4", "5", "399/100"], "within": [0, 1], "inside": [-1, 0, 1],
              "relation": ["disjoint", "meet", "inside", "contains", "overlap", "equal", "covers", "covered_by"],
              "exit": [["0", "0"], ["1/2", "1"], ["1", "2"], ["2", "2"]], "depth": ["0", "1/4", "4"], "motion": [None, ["0", "0"], ["0.25", "0.25"], ["0", "1"]],
              "ray": [None, {"face": 0, "t": "1/3"}, {"face": 1, "t": "1"}, {"face": 3, "t": "1/2"}]}
GIVEN = ("ask", "question", "pose_a", "pose_b", "from_a", "to_a", "from_b", "to_b", "limit", "point", "origin", "direction", "end", "answer")


def places(entry, way=()):
    items = entry.items() if isinstance(entry, dict) else enumerate(entry) if isinstance(entry, list) else ()
    for key, below in items:
        yield (*way, key), below
        yield from places(below, (*way, key))


def changed(entry, way, value):
    spoiled = copy.deepcopy(entry)
    place = spoiled
    for key in way[:-1]:
        place = place[key]
    if value is None:
        del place[way[-1]]
    else:
        place[way[-1]] = value
    return spoiled


def others(value):
    if isinstance(value, int):
        return [value + 1, 0, "crossed"]
    if isinstance(value, str):
        return ["0", "-1", "7/2", 0]
    return [value[1:], value[:-1], value[::-1]] if isinstance(value, list) else [{}]


def lies(certificate):
    """False answers, each with all proofs of the same question and with each field of these changed; and proofs that lack something."""
    for k, answer in enumerate(certificate["answers"]):
        proofs = [{key: value for key, value in other.items() if key not in GIVEN} for other in certificate["answers"] if other["ask"] == answer["ask"]]
        facts = {key: value for key, value in answer.items() if key in GIVEN}
        if answer["ask"] == "exit" and answer["answer"] == ["1", "1"]:
            # All that is proved holds, but the cubes are apart at the start: their exits are 0.
            yield {**answer, "pose_a": at("-10"), "answer": ["11", "11"]}
        for wrong in TRUE_WRONG[answer["ask"]]:
            if wrong == answer["answer"] or answer["ask"] == "motion" and wrong == ["0", "1"] and answer["answer"]:
                continue
            for proof in proofs:
                lie = {**facts, "answer": wrong, **proof}
                yield lie
                for way, value in places(proof):
                    for other in others(value):
                        yield changed(lie, way, other)
        for way, value in places(answer):
            if isinstance(way[-1], str) and way[-1] not in ("question", "end"):
                yield changed(answer, way, None)
            if "cover" in way and isinstance(value, list):
                yield changed(answer, way, value[:-1])
            if len(way) > 1 and way[-2] == "directions":
                yield changed(answer, way, ["0", "0", "0"])
            if way[-1] == "winding" and type(value) is int:
                yield changed(answer, way, value + 1)


def model_texts():
    """The cube as each format has it."""
    vertices = [" ".join(v) for v in CUBE_VERTICES]
    faces = [" ".join(map(str, f)) for f in CUBE_FACES]
    yield "cube.off", "OFF # a cube\n8 6 0\n" + "\n".join(vertices) + "\n" + "".join(f"4 {f}\n" for f in faces)
    yield "without.off", "8 6 0\n" + "\n".join(vertices) + "\n" + "".join(f"4 {f}\n" for f in faces)
    yield "stuck.off", "CSTOFF8 6 0\n" + "\n".join(vertices) + "\n" + "".join(f"4 {f}\n" for f in faces)
    yield "cube.obj", "".join(f"v {v}\n" for v in vertices) + "".join("f " + " ".join(f"{v + 1}/1" for v in f) + "\n" for f in CUBE_FACES[:3]) + \
        "".join("f " + " ".join(str(v - 8) for v in f) + "\n" for f in CUBE_FACES[3:])
    yield "cube.poly", "8 3 0 0\n" + "".join(f"{k} {v}\n" for k, v in enumerate(vertices)) + "6 0\n" + "".join(f"1 0 -1\n4 {f}\n" for f in faces) + "0\n"


class Proved_checker(unittest.TestCase):
    def check(self, *words, certificates=None):
        said = None if certificates is None else "".join(json.dumps(c) + "\n" for c in certificates)
        run = subprocess.run([FOLDER / "check", *map(str, words)], input=said, capture_output=True, text=True)
        return run.returncode, run.stdout.splitlines(), run.stderr

    def file(self, certificate):
        path = FOLDER / "certificate.json"
        path.write_text(certificate if isinstance(certificate, str) else json.dumps(certificate))
        return path

    def test_the_theorems_assume_nothing(self):
        asked = (SOURCE / "Assumptions.v").read_text().count("Print Assumptions ")
        self.assertGreater(asked, 9)
        self.assertEqual((FOLDER / "assumptions").read_text().splitlines(), ["Closed under the global context"] * asked)
        for path in SOURCE.glob("*.v"):
            self.assertNotRegex(path.read_text(), r"\b(Admitted|admit|Axiom|Parameter|Conjecture)\b", path.name)

    def test_true_answers_are_proved(self):
        for certificate in (PAIRS, CUBE_ALONE, FRAME_ALONE):
            status, lines, error = self.check(self.file(certificate))
            self.assertEqual((status, error), (0, ""))
            self.assertEqual(len(lines), len(certificate["answers"]))
            for line in lines:
                self.assertRegex(line, " proved(, an upper bound|, only that .*|, up to .*)?$")

    def test_no_lie_is_believed(self):
        count = 0
        for certificate in (PAIRS, CUBE_ALONE, FRAME_ALONE):
            told = list(lies(certificate))
            count += len(told)
            _, lines, _ = self.check("-", certificates=[{**certificate, "answers": [lie]} for lie in told])
            self.assertEqual(len(lines), len(told))
            for lie, line in zip(told, lines):
                self.assertRegex(line, "^(refused|bad input): ", lie)
        self.assertGreater(count, 5000)

    def test_shells_are_joined_by_loops_and_vertices_not_by_faces_and_places(self):
        # A second cube of A shares a face of two loops with the first one. So nothing is said of the second one's shell.
        far = [["9", *v[1:]] if v[0] == "0" else ["10", *v[1:]] for v in CUBE["vertices"]]
        loops = [face[0] for face in CUBE["faces"]]
        second = [[[v + 8 for v in loop]] for loop in loops[:-1]]
        joined = {"vertices": CUBE["vertices"] + far, "faces": CUBE["faces"][:-1] + second + [[loops[-1], [v + 8 for v in loops[-1]]]],
                  "cut": [[10, *t] for loop in (loops[-1], [v + 8 for v in loops[-1]]) for t in ([loop[0], loop[1], loop[2]], [loop[0], loop[2], loop[3]])],
                  "groups": list(range(14))}
        loose = {"vertices": CUBE["vertices"] + [["9.5", "0.5", "0.5"]], "faces": CUBE["faces"], "groups": CUBE["groups"]}
        apart = {"ask": "collide", "question": "solid", "pose_a": at("0"), "pose_b": at("20"), "answer": "apart", "directions": [axis(0)], "cover": 0, "windings": [outside("b", 0, 0, -1), outside("a", 7, 0, 1)]}
        # B is about a vertex of no face.
        held = {"ask": "collide", "question": "solid", "pose_a": at("0"), "pose_b": at("8.5", "-1", "-1", "4"), "answer": "a_in_b", "directions": [axis(0)], "cover": 0,
                "windings": [{"in": "b", "vertex": 8, "winding": 1, "ray": axis(0, -1), "directions": [axis(0)], "cover": 0}]}
        for body, answer, reason in ((joined, apart, "a shell has no vertex"), (loose, held, "of no face")):
            status, _, error = self.check(self.file({"certificate": "tetracone 1", "bodies": [body, CUBE], "answers": [answer]}))
            self.assertEqual(status, 1)
            self.assertRegex(error, reason)
        # Faces that share places, but no vertex, bound nothing.
        soup = {"vertices": [CUBE["vertices"][v] for loop in loops for v in loop], "faces": [[[4 * f + k for k in range(4)]] for f in range(6)], "groups": CUBE["groups"]}
        status, _, error = self.check(self.file({**CUBE_ALONE, "bodies": [soup], "answers": CUBE_ALONE["answers"][:1]}))
        self.assertEqual(status, 1)
        self.assertRegex(error, "not closed")

    def test_bodies_that_are_spoiled_are_refused(self):
        short, twice, open_body = copy.deepcopy(CUBE), copy.deepcopy(CUBE), copy.deepcopy(CUBE)
        short["groups"].pop()
        twice["groups"][5] = 4
        open_body["faces"].pop(), open_body["groups"].pop()
        uncut, hole_filled = copy.deepcopy(FRAME), copy.deepcopy(FRAME)
        uncut["cut"][7] = uncut["cut"][6]
        hole_filled["cut"] += [[0, 4, 7, 6], [0, 4, 6, 5]]
        for body, certificate in ((short, CUBE_ALONE), (twice, CUBE_ALONE), (open_body, CUBE_ALONE), (uncut, FRAME_ALONE), (hole_filled, FRAME_ALONE)):
            self.assertEqual(self.check(self.file({**certificate, "bodies": [body]}))[0], 1)

    def test_faces_that_the_program_leaves_out_and_triangles_that_cancel_are_refused(self):
        bent = {"vertices": [["0", "0", "0"], ["2", "0", "0"], ["2", "2", "0.5"], ["0", "2", "0"], ["1", "1", "3"]],
                "faces": [[[3, 2, 1, 0]], [[0, 1, 4]], [[1, 2, 4]], [[2, 3, 4]], [[3, 0, 4]]], "cut": [[0, 3, 2, 1], [0, 3, 1, 0]], "groups": [0, 1, 2, 3, 4, 5]}
        corner = {"certificate": "tetracone 1", "bodies": [bent], "answers": [{"ask": "inside", "point": ["0", "0", "0"], "answer": 0, "face": 0}]}
        self.assertEqual(self.check(self.file(corner))[:2], (0, ["0 inside - 0 proved, of faces that are not planar as they are cut here"]))
        bent["cut"] += [[0, 3, 2, 1], [0, 1, 2, 3]]
        bent["groups"] += [6, 7]
        self.assertEqual(self.check(self.file(corner))[0], 1)
        text = "OFF\n6 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 5 5\n6 5 5\n2 4 5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
        path = FOLDER / "short.off"
        path.write_text(text)
        body = {"file": path.name, "sha256": hashlib.sha256(text.encode()).hexdigest()}
        between = {**corner, "bodies": [body], "answers": [{"ask": "inside", "point": ["5.5", "5", "5"], "answer": 0, "face": 0}]}
        status, _, error = self.check(self.file(between), path)
        self.assertEqual(status, 2)
        self.assertRegex(error, "less than three corners")

    def test_it_is_about_the_files_and_numbers_that_are_named(self):
        for name, text in model_texts():
            path = FOLDER / name
            path.write_text(text)
            body = {"file": name, "sha256": hashlib.sha256(text.encode()).hexdigest(), "groups": CUBE["groups"]}
            certificate = self.file({**PAIRS, "bodies": [body, body]})
            self.assertEqual(self.check(certificate, path, path)[0], 0, name)
            poses = FOLDER / "poses"
            poses.write_text("1 0 0 2 0 1 0 0 0 0 1 0\n")
            one = self.file({**PAIRS, "bodies": [body, body], "answers": PAIRS["answers"][2:3]})
            self.assertEqual(self.check(one, path, path, "--given", f"pose_b={poses}")[0], 0)
            self.assertEqual(self.check(one, path, path, "--given", f"pose_a={poses}")[0], 1)
            poses.write_text("1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n")
            self.assertEqual(self.check(one, path, path, "--given", f"pose_b={poses}")[0], 0)
            numbered = {**PAIRS, "bodies": [body, body], "answers": [{**PAIRS["answers"][2], "row": 1}], "asked": 2}
            poses.write_text("1 0 0 3 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n")
            for row, asked, status in ((1, 2, 0), (0, 2, 1), (2, 2, 2), (1, 3, 2)):
                numbered["answers"][0]["row"], numbered["asked"] = row, asked
                self.assertEqual(self.check(self.file(numbered), path, path, "--given", f"pose_b={poses}")[0], status)
            path.write_text(text + "\n")
            self.assertEqual(self.check(certificate, path, path)[0], 1, name)

    def test_bad_input_gives_one_line(self):
        for text in ("", "{", "[" * 100000, "null", "{}", "\0", '{"certificate":"tetracone 2","bodies":[],"answers":[]}', '{"a":1.5}', '{"a":1,"a":1}',
                     json.dumps({**CUBE_ALONE, "bodies": [{"vertices": [["nan", "0", "0"]], "faces": [[[0, 0, 0]]]}]}),
                     json.dumps({**CUBE_ALONE, "bodies": [{"file": "a.off", "sha256": ""}]})):
            status, _, error = self.check(self.file(text))
            self.assertEqual((status, error.count("\n")), (2, 1), error)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        FOLDER = pathlib.Path(temporary)
        built = subprocess.run([SOURCE / "build.sh", FOLDER], capture_output=True, text=True)
        if built.returncode:
            print(built.stdout + built.stderr)
            sys.exit(built.returncode)
        unittest.main()
