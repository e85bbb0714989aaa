#!/usr/bin/python3
"""A subject in Python: the edges of each body against the triangles of the other by signed volumes, in numpy's double; solids by winding
numbers. Faces with holes, and pairs that would not fit into memory, are declined."""

import json
import sys

import numpy as np


def volume(a, b, c, d):
    return np.einsum("...k,...k", np.cross(b - a, c - a), d - a)


def crosses(edges, triangles):
    """Whether an edge (n, 2, 3) goes through a triangle (m, 3, 3), an end or the rim included; edges within its plane are not seen."""
    p, q = edges[:, None, 0], edges[:, None, 1]
    a, b, c = (triangles[None, :, k] for k in range(3))
    ends = volume(a, b, c, p), volume(a, b, c, q)
    sides = np.stack([volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)])
    through = (ends[0] * ends[1] <= 0) & ((ends[0] != 0) | (ends[1] != 0))
    return bool(np.any(through & (np.all(sides >= 0, axis=0) | np.all(sides <= 0, axis=0))))


def winds(triangles, point):
    """Whether the point is within the closed surface: its solid angles add up to a multiple of 4 pi that is not 0."""
    a, b, c = (triangles[:, k] - point for k in range(3))
    x, y, z = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    dots = [np.einsum("ij,ij->i", u, v) for u, v in ((a, b), (b, c), (c, a))]
    angle = 2 * np.arctan2(np.einsum("ij,ij->i", a, np.cross(b, c)), x * y * z + dots[0] * z + dots[1] * x + dots[2] * y)
    return abs(angle.sum()) > 2 * np.pi


def number(entry):
    return float(entry) if not isinstance(entry, str) else int(entry.split("/")[0]) / int(entry.split("/")[1])


def answer(a, b, pose_a, pose_b, question):
    s, t = (body @ pose[:, :3].T + pose[:, 3] for body, pose in ((a, pose_a), (b, pose_b)))
    edges = [np.concatenate([x[:, [0, 1]], x[:, [1, 2]], x[:, [2, 0]]]) for x in (s, t)]
    return int(crosses(edges[0], t) or crosses(edges[1], s) or question == "solid" and (winds(s, t[0, 0]) or winds(t, s[0, 0])))


np.seterr(all="ignore")
bodies = {}
for line in sys.stdin:
    message = json.loads(line)
    if "model" in message:
        v = np.array(message["vertices"], dtype=float)
        fans = [[f[0][0], f[0][k - 1], f[0][k]] for f in message["faces"] for k in range(2, len(f[0]))]
        bodies[message["model"]] = None if any(len(f) > 1 for f in message["faces"]) else v[fans]
    bodies.pop(message.get("forget"), None)
    if "ask" in message:
        a, b = bodies[message["a"]], bodies[message["b"]]
        poses = [np.array([number(x) for x in message[key]]).reshape(3, 4) for key in ("pose_a", "pose_b")]
        taken = a is not None and b is not None and len(a) * len(b) <= 300_000
        print(json.dumps({"ask": message["ask"], "answer": answer(a, b, *poses, message["question"]) if taken else None}), flush=True)
