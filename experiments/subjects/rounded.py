#!/usr/bin/python3
"""Exact after rounding, as a subject: rounded.py BITS [vertices]. Placed vertices are rounded to a grid of 2^-BITS of the size; with the word `vertices`,
those of the bodies before they are placed. The result is decided in integers without error. So wrong answers are what rounding costs."""

import itertools
import json
import math
import random
import sys
from fractions import Fraction

MOST_FACES = 200  # all edges are compared with all triangles


def minus(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def cross(u, v):
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def side(a, b, c, d):
    """The sign of the volume of a tetrahedron."""
    volume = dot(cross(minus(b, a), minus(c, a)), minus(d, a))
    return (volume > 0) - (volume < 0)


def meets(p, q, triangle, normal):
    """Whether a segment and a triangle with an area share a point."""
    a, b, c = triangle
    up, down = dot(normal, minus(p, a)), dot(normal, minus(q, a))
    if up * down > 0 if up and down else False:
        return False
    if up == down == 0:
        axis = max(range(3), key=lambda k: abs(normal[k]))
        return meets_in_plane(*([x[:axis] + x[axis + 1:] for x in (p, q, a, b, c)]))
    sides = {side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)}
    return not {1, -1} <= sides


def meets_in_plane(p, q, a, b, c):
    def turn(x, y, z):
        return (y[0] - x[0]) * (z[1] - x[1]) - (y[1] - x[1]) * (z[0] - x[0])

    def cross_over(x, y, z, w):
        if any(max(x[k], y[k]) < min(z[k], w[k]) or max(z[k], w[k]) < min(x[k], y[k]) for k in (0, 1)):
            return False
        one, two, three, four = turn(x, y, z), turn(x, y, w), turn(z, w, x), turn(z, w, y)
        return not (one > 0 and two > 0 or one < 0 and two < 0 or three > 0 and four > 0 or three < 0 and four < 0)
    turns = [turn(a, b, p), turn(b, c, p), turn(c, a, p)]
    inside = all(t >= 0 for t in turns) or all(t <= 0 for t in turns)
    return inside or any(cross_over(p, q, x, y) for x, y in ((a, b), (b, c), (c, a)))


class Body:
    def __init__(self, vertices, triangles):
        self.triangles = [tuple(vertices[k] for k in t) for t in triangles]
        normals = [cross(minus(b, a), minus(c, a)) for a, b, c in self.triangles]
        self.faces = [(t, n, box(t)) for t, n in zip(self.triangles, normals) if any(n)]
        edges = {tuple(sorted((vertices[i], vertices[j]))) for t in triangles for i, j in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
        self.edges = [(e, box(e)) for e in edges if e[0] != e[1]]
        # One vertex of each part of the surface.
        part = {}

        def root(v):
            while part.setdefault(v, v) != v:
                v = part[v]
            return v
        for t in triangles:
            part[root(t[0])] = root(t[1])
            part[root(t[1])] = root(t[2])
        self.starts = [vertices[v] for v in part if part[v] == v]

    def winds(self, point):
        """Whether the point, which is not on the surface, has a winding number that is not 0."""
        draw = random.Random(1)
        while True:
            end = tuple(x + draw.randrange(-10**6, 10**6) for x in point)
            number = 0
            for (a, b, c), normal, _ in self.faces:
                along = dot(normal, minus(end, point))
                sides = [side(point, end, a, b), side(point, end, b, c), side(point, end, c, a)]
                if along == 0 and dot(normal, minus(a, point)) == 0 or (0 in sides and not {1, -1} <= set(sides)):
                    break  # through an edge, or along a plane: another ray
                if along and sides[0] == sides[1] == sides[2] and dot(normal, minus(a, point)) * along > 0:
                    number += 1 if along > 0 else -1
            else:
                return number != 0


def box(points):
    return [(min(x), max(x)) for x in zip(*points)]


def collide(a, b, solid):
    for one, other in ((a, b), (b, a)):
        for ((p, q), of_edge), (triangle, normal, of_face) in itertools.product(one.edges, other.faces):
            if all(u <= y and x <= v for (u, v), (x, y) in zip(of_edge, of_face)) and meets(p, q, triangle, normal):
                return True
    return solid and (any(b.winds(p) for p in a.starts) or any(a.winds(p) for p in b.starts))


def size_of(points):
    """The least power of two that is not below the extent along any axis."""
    extent = max(max(x) - min(x) for x in zip(*points))
    if extent == 0:
        return Fraction(1)
    size = Fraction(2) ** (extent.numerator.bit_length() - extent.denominator.bit_length() - 1)
    while size < extent:
        size *= 2
    return size


def on_grid(points, size, bits):
    grid = size / 2 ** bits
    return [tuple(round(x / grid) * grid for x in p) for p in points]


def placed(vertices, pose):
    m = [Fraction(x) for x in pose]
    return [tuple(m[4 * i] * v[0] + m[4 * i + 1] * v[1] + m[4 * i + 2] * v[2] + m[4 * i + 3] for i in range(3)) for v in vertices]


def decide(points, triangles, question):
    """Whether two bodies of placed rational points collide: 1 or 0, or nothing where one is flat."""
    common = math.lcm(*(x.denominator for p in points for v in p for x in v))
    a, b = (Body([tuple(int(x * common) for x in v) for v in p], t) for p, t in zip(points, triangles))
    return int(collide(a, b, question == "solid")) if a.faces and b.faces else None


class Rounding:
    """The subject: what is rounded, and how finely."""

    def __init__(self, bits, places):
        self.bits, self.places, self.bodies = bits, places, {}

    def keep(self, model):
        triangles = model.get("triangles")
        if triangles is None or len(triangles) > MOST_FACES:
            return None
        vertices = [tuple(map(Fraction, v)) for v in model["vertices"]]
        return vertices if self.places else on_grid(vertices, size_of(vertices), self.bits), triangles

    def answer(self, message):
        bodies = self.bodies[message["a"]], self.bodies[message["b"]]
        if None in bodies:
            return None
        points = [placed(body[0], message[key]) for body, key in zip(bodies, ("pose_a", "pose_b"))]
        if self.places:
            size = max(map(size_of, points))
            points = [on_grid(p, size, self.bits) for p in points]
        return decide(points, [body[1] for body in bodies], message["question"])


def main():
    subject = Rounding(int(sys.argv[1]), sys.argv[2:] != ["vertices"])
    name = f"{'placed' if subject.places else 'vertices'} on 2^-{subject.bits}"
    print(json.dumps({"hello": 1, "name": name, "version": "1", "precision": "exact", "bodies": "closed", "poses": "affine",
                      "questions": ["surface", "solid"], "touching": "closed"}), flush=True)
    for line in sys.stdin:
        message = json.loads(line)
        if "model" in message:
            subject.bodies[message["model"]] = subject.keep(message)
        subject.bodies.pop(message.get("forget"), None)
        if "ask" in message:
            print(json.dumps({"ask": message["ask"], "answer": subject.answer(message)}), flush=True)


if __name__ == "__main__":
    main()
