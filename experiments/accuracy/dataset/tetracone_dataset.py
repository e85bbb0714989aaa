"""Reads the cases of the folder that this file is in, exactly. Needs Python's own library alone."""

import hashlib
import json
import os
from collections import namedtuple
from fractions import Fraction

FOLDER = os.path.dirname(os.path.abspath(__file__))

#: a, b: (vertices, triangles), tuples of three doubles and of three vertex numbers. pose_a, pose_b: three rows of four
#: fractions. surface, solid: the true answers.
Case = namedtuple("Case", "id family index parameter a b pose_a pose_b surface solid log2_rho log2_ulps")

#: points: seven tuples of three doubles, v0 v1 v2 v3 under pose a and p q r under pose b. truth: -1, 0 or 1.
Predicate = namedtuple("Predicate", "id family index parameter predicate points pose_a pose_b truth log2_rho log2_ulps")

#: s, t: the corners of a triangle each, three tuples of three fractions, exact. truth: 1 where they share a point, else 0.
Triangles = namedtuple("Triangles", "id family index parameter s t truth log2_rho log2_ulps")


class Error(Exception):
    """A file that is not as it was written: one line."""


def pose(row, body):
    """Exact: a number of JSON is a double, and a text is a fraction n/d."""
    return tuple(tuple(Fraction(row[f"{body}{i}{j}"]) for j in range(4)) for i in range(3))


def read_mesh(name, folder=FOLDER):
    """(vertices, triangles) of a file in meshes/."""
    with open(os.path.join(folder, "meshes", name), encoding="ascii") as file:
        words = iter(file.read().split())
    if next(words) != "OFF":
        raise Error(f"meshes/{name}: no OFF file; expected one")
    vertices, faces, _ = (int(next(words)) for _ in range(3))
    points = tuple(tuple(float(next(words)) for _ in range(3)) for _ in range(vertices))
    return points, tuple(tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(faces))


def rows(name, folder):
    """The rows of a file of JSON Lines, as dictionaries."""
    with open(os.path.join(folder, name), encoding="ascii") as file:
        yield from map(json.loads, file)


def cases(folder=FOLDER):
    """All cases of two polyhedra, in order. Cases that share a mesh share its tuples."""
    meshes = {}
    for row in rows("cases.jsonl", folder):
        for name in (row["mesh_a"], row["mesh_b"]):
            if name not in meshes:
                meshes[name] = read_mesh(name, folder)
        yield Case(row["id"], row["family"], row["index"], float(row["parameter"]), meshes[row["mesh_a"]], meshes[row["mesh_b"]],
                   pose(row, "a"), pose(row, "b"), row["surface"], row["solid"], float(row["log2_rho"]), float(row["log2_ulps"]))


def predicates(folder=FOLDER):
    """All cases of a predicate of seven points, in order."""
    for row in rows("predicates.jsonl", folder):
        points = tuple(tuple(row[name + axis] for axis in "xyz") for name in ("v0", "v1", "v2", "v3", "p", "q", "r"))
        yield Predicate(row["id"], row["family"], row["index"], float(row["parameter"]), row["predicate"], points, pose(row, "a"),
                        pose(row, "b"), row["truth"], float(row["log2_rho"]), float(row["log2_ulps"]))


def triangles(folder=FOLDER):
    """All pairs of triangles, in order."""
    for row in rows("triangles.jsonl", folder):
        s, t = (tuple(tuple(Fraction(row[f"{name}{k}{axis}"]) for axis in "xyz") for k in range(3)) for name in "st")
        yield Triangles(row["id"], row["family"], row["index"], float(row["parameter"]), s, t, row["truth"], float(row["log2_rho"]),
                        float(row["log2_ulps"]))


def about(folder=FOLDER):
    """What dataset.json says: version, seed, licence and size."""
    with open(os.path.join(folder, "dataset.json"), encoding="ascii") as file:
        return json.load(file)


def check(folder=FOLDER):
    """Raises Error when a file is not the one that SHA256SUMS names."""
    with open(os.path.join(folder, "SHA256SUMS"), encoding="ascii") as file:
        for line in file:
            sum_, name = line.rstrip("\n").split("  ", 1)
            try:
                with open(os.path.join(folder, name), "rb") as data:
                    found = hashlib.sha256(data.read()).hexdigest()
            except OSError as error:
                raise Error(f"{name}: {error.strerror}; expected the file of SHA256SUMS") from None
            if found != sum_:
                raise Error(f"{name}: its SHA-256 is {found}; expected {sum_}")
