"""The reproductions of the field's page: two cubes each, as case files that `tetracone collide` replays and every subject can be asked."""

import json
import math

CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
FACES = [[[0, 1, 3, 2]], [[4, 6, 7, 5]], [[0, 4, 5, 1]], [[2, 3, 7, 6]], [[0, 2, 6, 4]], [[1, 5, 7, 3]]]
TRIANGLES = [[f[0], f[k - 1], f[k]] for f, in FACES for k in (2, 3)]
# A unit quaternion w, x, y, z of doubles: a turn that is parallel to no axis.
TURN = (0.8, 0.36, 0.48, 0.0)
STRAIGHT = (1.0, 0.0, 0.0, 0.0)


def cube(size, low=(0, 0, 0)):
    return [[size * v[k] + low[k] for k in range(3)] for v in CUBE]


def rotation(q):
    w, x, y, z = q
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def pair(name, what, size, shift, turn=STRAIGHT, b=None):
    """Body A is a cube of this size and its copy B is moved by `shift` in their common frame; then both are turned."""
    rows = rotation(turn)
    moved = [sum(rows[i][k] * shift[k] for k in range(3)) for i in range(3)]
    return {"name": name, "what": what, "a": cube(size), "b": b or cube(size),
            "rigid_a": [*turn, 0.0, 0.0, 0.0], "rigid_b": [*turn, *moved],
            "pose_a": [x for i in range(3) for x in (*rows[i], 0.0)], "pose_b": [x for i in range(3) for x in (*rows[i], moved[i])]}


CASES = [
    pair("copy", "a unit cube and its copy in one place, turned", 1, (0, 0, 0), TURN),
    pair("half-diagonal", "a unit cube and its copy, half a side away along each axis, turned", 1, (0.5, 0.5, 0.5), TURN),
    pair("half-side", "a unit cube and its copy, half a side away along one axis, turned", 1, (0.5, 0, 0), TURN),
    pair("gap-3mm", "cubes of 1 cm, 3 mm apart and shifted sideways", 0.01, (0.013, 0.001, 0.002)),
    pair("gap-1mm", "unit cubes, 1 mm apart and shifted sideways", 1, (1.001, 0.3, 0.2)),
    pair("gap-0.3mm", "cubes of 1 mm, 0.3 mm apart", 0.001, (0.0013, 0, 0)),
    pair("overlap-small", "cubes of 1 mm, half inside each other", 0.001, (0.0005, 0, 0)),
    pair("overlap-cm", "cubes of 1 cm, 0.2 mm inside each other", 0.01, (0.0098, 0, 0)),
    pair("flush", "unit cubes side by side, flush: closed sets share a face", 1, (1, 0, 0)),
    pair("corner", "unit cubes that share one corner", 1, (1, 1, 1)),
    pair("gap-micron", "unit cubes, 10 micrometres apart", 1, (1.00001, 0, 0)),
    pair("overlap-micron", "unit cubes, 10 micrometres inside each other", 1, (0.99999, 0.25, 0.25)),
    pair("far", "unit cubes at 100 m, 1 mm inside each other", 1, (0.999, 0.25, 0.25)),
    pair("large", "cubes of 1 km, 1 m apart", 1000, (1001, 10, 20)),
    pair("inside", "a cube of 0.25 within a unit cube: solids collide, surfaces do not", 1, (0, 0, 0), STRAIGHT, cube(0.25, (0.375, 0.375, 0.375))),
]
for _c in CASES:
    if _c["name"] == "far":
        for _key in ("a", "b"):
            for _k in range(3):
                _c[f"pose_{_key}"][4 * _k + 3] += 100
                _c[f"rigid_{_key}"][4 + _k] += 100


def numbers(rows, indent):
    return ",\n".join(" " * indent + json.dumps(row) for row in rows)


def case_file(case, truth, version):
    """The text of the case file, in the form of tetracone's own; `truth` is by question, 1 or 0."""
    def body(key):
        return (f'  "{key}": {{\n    "vertices": [\n{numbers(case[key], 6)}\n    ],\n    "faces": [\n{numbers(FACES, 6)}\n    ]\n  }},\n'
                f'  "pose_{key}": [\n{numbers([case["pose_" + key][4 * k:4 * k + 4] for k in range(3)], 4)}\n  ]')
    return (f'{{\n  "format": 1,\n  "version": "{version}",\n  "level": "object",\n  "cause": {json.dumps(case["what"])},\n'
            f'  "origin": {{"family": "", "seed": 0, "index": 0, "parameter": 0}},\n  "question": "solid",\n'
            f'  "truth": {json.dumps(truth)},\n  "wrong": [],\n{body("a")},\n{body("b")}\n}}\n')


def lines(case, number):
    """The lines of the protocol that ask the case: two bodies, two questions."""
    told = [{"model": 2 * number + k, "vertices": case[key], "faces": FACES, "triangles": TRIANGLES} for k, key in enumerate("ab")]
    for k, question in enumerate(("surface", "solid")):
        told.append({"ask": 2 * number + k, "a": 2 * number, "b": 2 * number + 1, "pose_a": case["pose_a"], "pose_b": case["pose_b"],
                     "rigid_a": case["rigid_a"], "rigid_b": case["rigid_b"], "question": question})
    return told


assert math.isclose(sum(x * x for x in TURN), 1, abs_tol=1e-15)
