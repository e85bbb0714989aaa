#!/usr/bin/env python3
"""Proves the answers of a certificate that `tetracone ... --certificate FILE` has written. README.md says what is proved.

  check.py CERTIFICATE [A [B]] [--given KEY=FILE]...

A and B are the model files: OFF, OBJ or TetGen's .poly. `--given pose_b=poses.txt` demands that the answers are about the
file's numbers, in order; KEY is pose_a, pose_b, from_a, to_a, from_b, to_b, point or ray. Prints a line an answer.
Status 0: all are proved. 1: one is refused. 2: bad input.

Coordinates are integers here: those of all bodies are multiplied by one common denominator, the `scale`."""
import argparse
import hashlib
import json
import os
import re
import sys
from fractions import Fraction
from math import lcm

DECIMAL = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")
FRACTION = re.compile(r"[-+]?[0-9]+/[0-9]+")
EXACT = re.compile(r"-?[0-9]+(/[0-9]+)?")


class Bad(Exception):
    """The input has not the format."""


class Refused(Exception):
    """The input does not prove its answer."""


def need(holds, what):
    if not holds:
        raise Refused(what)


def need_form(holds, what):
    if not holds:
        raise Bad(what)


# Numbers and vectors


def given(text):
    """A number as the input has it: a fraction is exact, a decimal stands for the nearest double."""
    need_form(isinstance(text, str), "a number is not a string")
    if FRACTION.fullmatch(text):
        need_form(int(text.split("/")[1]) != 0, f"{text[:40]} divides by 0")
        return Fraction(text)
    need_form(DECIMAL.fullmatch(text), f"'{text[:40]}' is not a number")
    value = float(text)
    need_form(abs(value) < float("inf"), f"{text[:40]} is beyond the doubles")
    return Fraction(value)


def exact(text):
    need_form(isinstance(text, str) and EXACT.fullmatch(text), f"'{str(text)[:40]}' is not an integer or a fraction")
    need_form("/" not in text or int(text.split("/")[1]) != 0, f"{text[:40]} divides by 0")
    return Fraction(text)


def vector(texts, number=exact, size=3):
    need_form(isinstance(texts, list) and len(texts) == size, f"a list has not {size} numbers")
    return [number(text) for text in texts]


def whole(v):
    """The direction of v, by integers."""
    factor = lcm(*(x.denominator for x in v))
    need(any(v), "a direction is 0")
    return tuple(int(x * factor) for x in v)


def times(v, factor):
    """v times a multiple of its denominators, by integers."""
    return tuple(int(x * factor) for x in v)


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1], p[2] - q[2])


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def index(number, count, what):
    need_form(type(number) is int and 0 <= number < count, f"no such {what}")
    return number


# Faces


def edges(loops):
    return [(loop[k - 1], loop[k]) for loop in loops for k in range(len(loop))]


def normal_of(loops, at):
    """A normal of the plane of a face; None where its corners are on a line."""
    corners = [at[v] for loop in loops for v in loop]
    p = corners[0]
    q = next((x for x in corners if x != p), p)
    return next((n for x in corners if any(n := cross(minus(q, p), minus(x, p)))), None)


def is_planar(loops, at):
    normal, p = normal_of(loops, at), at[loops[0][0]]
    return normal is None or not any(dot(normal, minus(at[v], p)) for loop in loops for v in loop)


def is_on_edge(p, q):
    """The origin is on the segment from p to q."""
    return not any(cross(p, q)) and dot(p, q) <= 0


def winding_about(sides, normal):
    """The winding number of edges in a plane through the origin about the origin; None where the origin is on one.

    The plane is projected along an axis; edges that cross the positive half of the other plane's first axis count."""
    k = next(k for k in range(3) if normal[k])
    i, j = (k + 1) % 3, (k + 2) % 3
    count = 0
    for p, q in sides:
        if is_on_edge(p, q):
            return None
        turn = p[i] * q[j] - p[j] * q[i]
        count += (p[j] <= 0 < q[j] and turn > 0) - (q[j] <= 0 < p[j] and turn < 0)
    return count if normal[k] > 0 else -count


def loops_hold(loops, at, x):
    """x is on an edge, or in the plane of the loops with a winding number other than 0."""
    sides = [(minus(at[p], x), minus(at[q], x)) for p, q in edges(loops)]
    normal = normal_of(loops, at)
    if normal is None:
        return any(is_on_edge(p, q) for p, q in sides)
    return dot(normal, sides[0][0]) == 0 and winding_about(sides, normal) != 0


def crossing(loops, at, origin, direction):
    """How often the loops wind about the point where the ray crosses their plane, seen along the ray."""
    normal = normal_of(loops, at)
    need(normal is not None and dot(normal, direction) != 0, "a ray crosses a face along its plane")
    if dot(normal, direction) < 0:
        normal = minus((0, 0, 0), normal)
    slope, height = dot(normal, direction), dot(normal, minus(at[loops[0][0]], origin))
    need(height > 0, "a crossing is not on the ray")

    def from_crossing(v):  # the crossing is origin + height / slope * direction
        r = minus(at[v], origin)
        return tuple(slope * r[k] - height * direction[k] for k in range(3))

    count = winding_about([(from_crossing(p), from_crossing(q)) for p, q in edges(loops)], normal)
    need(count is not None, "a ray meets an edge")
    return count


# Bodies


class Group:
    """A tree of pieces. `members` is None where the group cannot be opened."""

    def __init__(self, members, pieces, corners, least_face):
        self.members, self.pieces, self.corners, self.least_face = members, pieces, corners, least_face


def balance(sides):
    """Directed edges that are not there as often as their reverses."""
    count = {}
    for p, q in sides:
        count[p, q] = count.get((p, q), 0) + 1
        count[q, p] = count.get((q, p), 0) - 1
    return {side: n for side, n in count.items() if n and side[0] != side[1]}


class Body:
    def __init__(self, entry, path):
        keys(entry, [], ["file", "sha256", "vertices", "faces", "turned", "cut", "groups"])
        if "vertices" in entry:
            keys(entry, ["vertices", "faces"], ["turned", "cut", "groups"])
            need_form(path is None, "the certificate has the body in itself, and names no file")
            self.vertices = [vector(v, given) for v in rows(entry["vertices"])]
            self.faces = [[list(rows(loop)) for loop in rows(loops)] for loops in rows(entry["faces"])]
        else:
            keys(entry, ["file", "sha256"], ["turned", "cut", "groups"])
            need_form(path is not None, "the certificate names a model file, which is not given")
            self.vertices, self.faces, digest = read_model(path)
            need(digest == entry["sha256"], f"{path} is not the file that the certificate is about")
        for loops in self.faces:
            need_form(loops and all(loops), "a face has no corner")
            for loop in loops:
                for v in loop:
                    index(v, len(self.vertices), "vertex")
        need_form(self.faces, "a body has no face")
        self.turned = rows(entry.get("turned", []))
        need_form(len({tuple(rows(turned)) for turned in self.turned}) == len(self.turned), "a loop is turned twice")
        for turned in self.turned:
            need_form(len(turned) == 2, "a turned loop has not two numbers")
            self.faces[index(turned[0], len(self.faces), "face")][index(turned[1], len(self.faces[turned[0]]), "loop")].reverse()
        self.scale = lcm(1, *(x.denominator for v in self.vertices for x in v))
        self.at = [times(v, self.scale) for v in self.vertices]
        self.cut_into_pieces(rows(entry.get("cut", [])))
        self.root = self.all_pieces() if "groups" not in entry else self.group(entry["groups"])
        need(len(self.root.pieces) == len(self.pieces), "a piece is in no group")
        self.shell = self.shells()
        self.is_closed = not balance(side for loops in self.faces for side in edges(loops))

    def cut_into_pieces(self, cut):
        """Pieces are pairs of a face and loops. `flat` tells the faces whose points their loops say."""
        triangles = {}
        for row in cut:
            need_form(len(rows(row)) == 4, "a row of a cut has not four numbers")
            triangles.setdefault(index(row[0], len(self.faces), "face"), []).append([index(v, len(self.vertices), "vertex") for v in row[1:]])
        self.pieces, self.flat = [], []
        for f, loops in enumerate(self.faces):
            self.flat.append(len({v for loop in loops for v in loop}) <= 3 or is_planar(loops, self.at))
            if f not in triangles:
                need(self.flat[f], f"face {f} is neither planar nor cut")
                self.pieces.append((f, loops))
                continue
            around = edges(triangles[f])
            need(balance(edges(loops)) == balance(around), f"the triangles of face {f} have another boundary")
            need({frozenset(side) for side in edges(loops)} <= {frozenset(side) for side in around}, f"face {f} has an edge without a triangle")
            self.pieces += [(f, [triangle]) for triangle in triangles[f]]

    def all_pieces(self):
        corners = {v for _, loops in self.pieces for loop in loops for v in loop}
        return Group(None, set(range(len(self.pieces))), corners, 0)

    def group(self, entry):
        if not isinstance(entry, list):
            f, loops = self.pieces[index(entry, len(self.pieces), "piece")]
            return Group(None, {entry}, {v for loop in loops for v in loop}, f)
        need_form(entry, "a group is empty")
        members = [self.group(member) for member in entry]
        pieces = set().union(*(member.pieces for member in members))
        corners = set().union(*(member.corners for member in members))
        return Group(members, pieces, corners, min(member.least_face for member in members))

    def shells(self):
        """A name of its shell for each vertex of a face: faces with a common vertex are of one shell."""
        name = {v: v for loops in self.faces for loop in loops for v in loop}

        def root(v):
            while name[v] != v:
                name[v] = v = name[name[v]]
            return v

        for loops in self.faces:
            for loop in loops:
                for v in loop:
                    name[root(v)] = root(loops[0][0])
        return {v: root(v) for v in name}


class Placed:
    """The corners of a placed body times `scale`, and the extent of its groups along directions."""

    def __init__(self, body, pose=None):
        self.body, self.at, self.scale, self.known = body, body.at, body.scale, {}
        if pose:
            factor = lcm(*(x.denominator for x in pose))
            r = [times(pose[4 * i:4 * i + 3], factor) for i in range(3)]
            need_form(dot(cross(r[0], r[1]), r[2]) != 0, "a pose is flat")
            t = [int(pose[4 * i + 3] * factor) * body.scale for i in range(3)]
            self.at = [(dot(r[0], v) + t[0], dot(r[1], v) + t[1], dot(r[2], v) + t[2]) for v in body.at]
            self.scale = factor * body.scale

    def rescale(self, scale):
        if scale != self.scale:
            factor, self.scale, self.known = scale // self.scale, scale, {}
            self.at = [(x * factor, y * factor, z * factor) for x, y, z in self.at]

    def extent(self, group, m):
        """The least and the largest m . x over the corners of the group."""
        key = id(group), m
        if key not in self.known:
            products = [m[0] * x + m[1] * y + m[2] * z for x, y, z in map(self.at.__getitem__, group.corners)]
            self.known[key] = min(products), max(products)
        return self.known[key]

    def holds(self, f, x):
        """Face f holds the point x, of fractions."""
        scale = lcm(self.scale, *(c.denominator for c in x))
        factor, point = scale // self.scale, times(x, scale)
        loops = self.body.faces[index(f, len(self.body.faces), "face")]
        shapes = [loops] if self.body.flat[f] else [piece for face, piece in self.body.pieces if face == f]
        at = {v: times(self.at[v], factor) for loop in loops for v in loop}
        return any(loops_hold(shape, at, point) for shape in shapes)


def on_one_scale(*placed, points=()):
    scale = lcm(*(p.scale for p in placed), *(x.denominator for point in points for x in point))
    for p in placed:
        p.rescale(scale)
    return scale


# Covers


def prove_cover(entry, a, b, apart, crossed=None, touched=None, span=None):
    """Every pair of a piece of a and one of b is in groups for which apart(m, group a, group b, span) does not refuse."""
    directions = [whole(vector(m)) for m in rows(entry["directions"])]

    def walk(node, a, b, span):
        if type(node) is int:
            apart(directions[index(node, len(directions), "direction")], a, b, span)
        elif node == "crossed" and crossed:
            need_form(len(b.pieces) == 1, "a group that is crossed has several pieces")
            crossed(next(iter(b.pieces)))
        elif node == "touched" and touched:
            touched(b)
        elif isinstance(node, list) and len(node) > 1 and node[0] in ("a", "b"):
            opened = a if node[0] == "a" else b
            need_form(opened and opened.members, "a group is opened that has no members")
            need(len(opened.members) == len(node) - 1, "a member of a group is missing in the cover")
            for member, below in zip(opened.members, node[1:]):
                walk(below, *((member, b) if node[0] == "a" else (a, member)), span)
        elif isinstance(node, list) and len(node) == 4 and node[0] == "t" and span:
            time = exact(node[1])
            need(span[0] < time < span[1], "an interval is not cut within it")
            walk(node[2], a, b, (span[0], time))
            walk(node[3], a, b, (time, span[1]))
        else:
            raise Bad("a node of a cover is none")

    walk(entry["cover"], a, b, span)


def prove_gap(entry, a, b, square=Fraction(0), or_equal=False):
    """The bodies are farther apart than the root of `square`, or as far."""
    scale = on_one_scale(a, b)

    def apart(m, of_a, of_b, _):
        gap = b.extent(of_b, m)[0] - a.extent(of_a, m)[1]
        excess = gap * gap * square.denominator - square.numerator * dot(m, m) * scale * scale
        need(gap > 0 and (excess > 0 or or_equal and excess == 0), "two groups are not as far apart")

    prove_cover(entry, a.body.root, b.body.root, apart)


def prove_winding(entry, x, body):
    """The winding number of the point x, of fractions, in the placed body."""
    scale = on_one_scale(body, points=[x])
    origin, direction = times(x, scale), whole(vector(entry["ray"]))
    counts = {}

    def apart(m, _, group, __):
        need(dot(m, direction) <= 0 and dot(m, origin) < body.extent(group, m)[0], "a ray is not apart from a group")

    def crossed(piece):
        counts[piece] = crossing(body.body.pieces[piece][1], body.at, origin, direction)

    prove_cover(entry, None, body.body.root, apart, crossed)
    need(type(entry["winding"]) is int and sum(counts.values()) == entry["winding"], "the crossings have another sum")
    return entry["winding"]


def prove_windings(entry, placed):
    """Rows (body whose vertex it is, the vertex; or None, the point), (the body that it is in), the winding number."""
    found = []
    for row in rows(entry.get("windings", [])):
        keys(row, ["in", "ray", "winding", "directions", "cover"], ["vertex", "point"])
        need_form(row["in"] in ("a", "b") and ("vertex" in row) != ("point" in row), "a winding number is of no point")
        holder = "ab".index(row["in"])
        if "point" in row:
            x, of = vector(row["point"]), (None, tuple(row["point"]))
        else:
            held = placed[1 - holder]
            v = index(row["vertex"], len(held.at), "vertex")
            need(v in held.body.shell, "a vertex is of no face")
            x, of = [Fraction(c, held.scale) for c in held.at[v]], (1 - holder, v)
        found.append((of, holder, prove_winding(row, x, placed[holder])))
    return found


def need_each_shell(found, placed, k, is_inside):
    """Each shell of body k has a vertex that is inside of the other one, or outside."""
    shell = placed[k].body.shell
    named = {shell[v] for (body, v), _, winding in found if body == k and (winding != 0) == is_inside}
    need(named == set(shell.values()), "a shell has no vertex that is known to be " + ("inside" if is_inside else "outside"))


def prove_witness(entry, placed):
    """The squared distance of the two points."""
    keys(entry, ["points", "faces"], ["time"])
    points = [vector(p) for p in rows(entry["points"])]
    need_form(len(points) == 2 and len(rows(entry["faces"])) == 2, "a witness has not two points and two faces")
    for body, f, point in zip(placed, entry["faces"], points):
        need(body.holds(f, point), f"face {f} does not hold its point")
    return dot(minus(*points), minus(*points))


# Answers


def rows(entry):
    need_form(isinstance(entry, list), "a list is none")
    return entry


def keys(entry, required, optional=()):
    need_form(isinstance(entry, dict), "an object is none")
    need_form(all(key in entry for key in required), f"one of the keys {', '.join(required)} is missing")
    for key in entry:
        need_form(key in required or key in optional, f"the key {key[:40]} is unknown here")


COVER = ["directions", "cover"]
PAIR = ["ask", "question", "pose_a", "pose_b", "answer"]


def pair(answer, bodies, names=("pose_a", "pose_b")):
    """The placed bodies, and whether the question is about solids."""
    need_form(len(bodies) == 2, "there are not two bodies")
    solid = answer.get("question", "solid")
    need_form(solid in ("solid", "surface"), "there is no such question")
    need(solid == "surface" or all(body.is_closed for body in bodies), "a body is not closed, and has no solid")
    placed = [Placed(body, vector(answer[name], given, 12)) for body, name in zip(bodies, names)]
    on_one_scale(*placed)
    return placed, solid == "solid"


def prove_apart(answer, placed, solid, square=Fraction(0), or_equal=False):
    keys(answer, [*PAIR, *COVER, *(["windings"] if solid else [])], ["witness", "limit"])
    prove_gap(answer, *placed, square, or_equal)
    found = prove_windings(answer, placed)
    for k in range(2) if solid else ():
        need_each_shell(found, placed, k, False)


def prove_together(answer, placed, solid, square=Fraction(0)):
    """Two points are at most so far apart; or one solid holds a vertex of the other. Returns the squared distance."""
    if "witness" in answer:
        keys(answer, [*PAIR, "witness"], ["limit"])
        distance = prove_witness(answer["witness"], placed)
        need(distance <= square, "the points are farther apart")
        return distance
    keys(answer, [*PAIR, "windings"], ["limit"])
    found = prove_windings(answer, placed)
    need(solid and any(of[0] is not None and winding != 0 for of, _, winding in found), "no vertex is inside of the other solid")
    return Fraction(0)


def prove_collide(answer, bodies):
    keys(answer, PAIR, ["witness", "windings", *COVER])
    placed, solid = pair(answer, bodies)
    said = answer["answer"]
    if said == "surfaces":
        keys(answer, [*PAIR, "witness"])
        prove_together(answer, placed, solid)
    elif said == "apart":
        prove_apart(answer, placed, solid)
    else:
        need_form(solid and said in ("a_in_b", "b_in_a"), "there is no such answer")
        keys(answer, [*PAIR, *COVER, "windings"])
        prove_gap(answer, *placed)
        held = 0 if said == "a_in_b" else 1
        need(any(of[0] == held and winding != 0 for of, _, winding in prove_windings(answer, placed)), "no shell is known to be inside")


def prove_distance(answer, bodies):
    keys(answer, PAIR, ["witness", "windings", *COVER])
    placed, solid = pair(answer, bodies)
    square = exact(answer["answer"])
    if square == 0:
        prove_together(answer, placed, solid)
        return
    need_form("witness" in answer, "the key witness is missing")
    need(prove_witness(answer["witness"], placed) == square, "the points are not so far apart")
    prove_apart(answer, placed, solid, square, True)


def prove_within(answer, bodies):
    keys(answer, [*PAIR, "limit"], ["witness", "windings", *COVER])
    placed, solid = pair(answer, bodies)
    limit = given(answer["limit"])
    need_form(answer["answer"] in (0, 1) and type(answer["answer"]) is int, "there is no such answer")
    if answer["answer"] == 1:
        need(limit >= 0, "a negative limit")
        prove_together(answer, placed, solid, limit * limit)
    elif limit >= 0:
        prove_apart(answer, placed, solid, limit * limit)


def prove_inside(answer, bodies):
    keys(answer, ["ask", "point", "answer"], ["face", "ray", "winding", *COVER])
    need_form(len(bodies) == 1, "there is not one body")
    need(bodies[0].is_closed, "the body is not closed, and has no solid")
    body, x = Placed(bodies[0]), vector(answer["point"], given)
    need_form(type(answer["answer"]) is int and answer["answer"] in (-1, 0, 1), "there is no such answer")
    if answer["answer"] == 0:
        keys(answer, ["ask", "point", "answer", "face"])
        need(body.holds(answer["face"], x), "the face does not hold the point")
        return
    keys(answer, ["ask", "point", "answer", "ray", "winding", *COVER])
    need((prove_winding(answer, x, body) != 0) == (answer["answer"] == 1), "the winding number says otherwise")


def prove_ray(answer, bodies):
    keys(answer, ["ask", "origin", "direction", "answer"], ["end", *COVER])
    need_form(len(bodies) == 1, "there is not one body")
    body = Placed(bodies[0])
    o, d = vector(answer["origin"], given), vector(answer["direction"], given)
    need_form(any(d), "a direction is 0")
    hit, end = answer["answer"], given(answer["end"]) if "end" in answer else None
    if hit is None and end is not None and end < 0:
        return
    keys(answer, ["ask", "origin", "direction", "answer", *COVER], ["end"])
    t = end
    if hit is not None:
        keys(hit, ["face", "t"])
        t = exact(hit["t"])
        need(t >= 0 and (end is None or t <= end), "the hit is not on the ray")
        need(body.holds(hit["face"], [o[k] + t * d[k] for k in range(3)]), "the face does not hold the hit")
    scale = on_one_scale(body, points=[o, d])
    origin, direction = times(o, scale), times(d, scale)

    def apart(m, _, group, __):
        start, slope, least = dot(m, origin), dot(m, direction), body.extent(group, m)[0]
        need(start < least, "the ray is not apart from a group")
        if t is None:
            need(slope <= 0, "the ray is not apart from a group")
        else:
            left = (least - start) * t.denominator - slope * t.numerator
            need(left > 0 or left == 0 and hit is not None and group.least_face >= hit["face"], "the ray is not apart from a group")

    def touched(group):
        need(hit is not None and t == 0 and group.least_face >= hit["face"], "a group is not touched first")

    prove_cover(answer, None, body.body.root, apart, touched=touched)


def prove_relation(answer, bodies):
    keys(answer, ["ask", "pose_a", "pose_b", "answer"], ["witness", "plane", "windings", *COVER])
    placed, _ = pair(answer, bodies)
    said = answer["answer"]
    need_form(said in ("disjoint", "inside", "contains", "overlap", "meet"), "there is no such answer")
    if said == "meet":
        keys(answer, ["ask", "pose_a", "pose_b", "answer", "witness", "plane"])
        need(prove_witness(answer["witness"], placed) == 0, "the points are not one")
        m, (a, b) = whole(vector(answer["plane"])), placed
        need(a.extent(a.body.root, m)[1] <= b.extent(b.body.root, m)[0], "the plane does not separate")
        return
    found = prove_windings(answer, placed)
    if said == "overlap":
        keys(answer, ["ask", "pose_a", "pose_b", "answer", "windings"])
        sides = {}
        for (_, x), holder, winding in found:
            sides.setdefault(x, [None, None])[holder] = winding != 0
        need(all(side in sides.values() for side in ([True, True], [True, False], [False, True])), "a part of an overlap has no point")
        return
    keys(answer, ["ask", "pose_a", "pose_b", "answer", "windings", *COVER])
    prove_gap(answer, *placed)
    need_each_shell(found, placed, 0, said == "inside")
    need_each_shell(found, placed, 1, said == "contains")


def prove_motion(answer, bodies):
    required = ["ask", "question", "from_a", "to_a", "from_b", "to_b", "answer"]
    keys(answer, required, ["witness", "windings", *COVER])
    start, solid = pair(answer, bodies, ("from_a", "from_b"))
    poses = [vector(answer[name], given, 12) for name in ("from_a", "to_a", "from_b", "to_b")]
    end = [Placed(body, pose) for body, pose in zip(bodies, poses[1::2])]
    on_one_scale(*start, *end)
    lo, hi = Fraction(1), None
    if answer["answer"] is not None:
        lo, hi = vector(answer["answer"], given, 2)
        need_form(0 <= lo <= hi <= 1, "the times are not in order")
    if hi is not None and (hi > 0 or "witness" in answer):
        need_form(isinstance(answer.get("witness"), dict) and "time" in answer["witness"], "the witness has no time")
        time = exact(answer["witness"]["time"])
        need(lo <= time <= hi, "the witness is not of its time")
        between = [[(1 - time) * x + time * y for x, y in zip(*ends)] for ends in (poses[:2], poses[2:])]
        need(prove_witness(answer["witness"], [Placed(body, pose) for body, pose in zip(bodies, between)]) == 0, "the points are not one")
        if hi == 0:
            return
    found = prove_windings(answer, start)
    if hi == 0:
        need(solid and any(of[0] is not None and winding != 0 for of, _, winding in found), "no vertex is inside of the other solid")
        return
    keys(answer, [*required, *COVER, *(["windings"] if solid else [])], ["witness"])

    def products(m, k, group, time):
        """m . x over the corners at that time, times its denominator."""
        n, d = time.numerator, time.denominator
        return [(d - n) * dot(m, start[k].at[v]) + n * dot(m, end[k].at[v]) for v in group.corners]

    def apart(m, of_a, of_b, span):
        for time in span:
            gap = min(products(m, 1, of_b, time)) - max(products(m, 0, of_a, time))
            need(gap > 0 or gap == 0 and time == lo == hi, "two groups are not apart all the time")

    prove_cover(answer, bodies[0].root, bodies[1].root, apart, span=(Fraction(0), lo))
    for k in range(2) if solid else ():
        need_each_shell(found, start, k, False)


PROVE = {"collide": prove_collide, "distance": prove_distance, "within": prove_within, "inside": prove_inside, "ray": prove_ray,
         "relation": prove_relation, "motion": prove_motion}


# Files


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def lines_of(data, path):
    """The words of each line that has some; '#' begins a comment."""
    text = data.decode("utf-8-sig", "replace").replace("\r\n", "\n").replace("\r", "\n")
    need_form(text.strip(), f"{path} is empty")
    return [words for line in text.split("\n") if (words := line.split("#")[0].split())]


def integer(word):
    need_form(re.fullmatch("[0-9]+", word), f"'{word[:40]}' is not a count or an index")
    return int(word)


def read_off(lines):
    need_form(re.fullmatch("(ST)?C?N?OFF", lines[0][0]), "the file does not begin with OFF")
    lines = ([lines[0][1:]] if len(lines[0]) > 1 else []) + lines[1:]
    vertices, faces = integer(lines[0][0]), integer(lines[0][1])
    need_form(len(lines) >= 1 + vertices + faces, "the file ends too early")
    at = [[given(x) for x in words[:3]] for words in lines[1:1 + vertices]]
    return at, [[[integer(x) for x in words[1:1 + integer(words[0])]]] for words in lines[1 + vertices:1 + vertices + faces]]


def read_obj(lines):
    vertices, faces, words = [], [], []
    for line in lines:
        words += line
        if words[-1].endswith("\\"):
            words[-1:] = [words[-1][:-1]] if len(words[-1]) > 1 else []
            continue
        if words[:1] == ["v"]:
            vertices.append([given(x) for x in words[1:4]])
        elif words[:1] == ["f"]:
            numbers = [word.split("/")[0] for word in words[1:]]
            faces.append([[len(vertices) - integer(n[1:]) if n.startswith("-") else integer(n) - 1 for n in numbers]])
        words = []
    return vertices, faces


def read_poly(lines, node_lines):
    """TetGen's facets of several polygons; the first is the outer one."""
    first_line = lines.pop(0)
    nodes = lines if integer(first_line[0]) else node_lines
    count = integer(first_line[0]) or integer(nodes.pop(0)[0])
    first = integer(nodes[0][0])
    vertices = [[given(x) for x in nodes.pop(0)[1:4]] for _ in range(count)]
    faces = []
    for _ in range(integer(lines.pop(0)[0])):
        head = [integer(x) for x in lines.pop(0)[:2]]
        loops = []
        for _ in range(head[0]):
            words = lines.pop(0)
            corners = integer(words[0])
            while len(words) <= corners:
                words += lines.pop(0)
            loops.append([integer(x) - first for x in words[1:]])
        del lines[:head[1] if len(head) > 1 else 0]
        faces.append(loops)
    return vertices, faces


def read_model(path):
    """Vertices, faces, and the hash of the file's bytes."""
    data, suffix = read_bytes(path), os.path.splitext(path)[1].lower()
    need_form(suffix in (".off", ".obj", ".poly"), f"{path} is no .off, .obj or .poly file")
    lines = lines_of(data, path)
    try:
        if suffix == ".poly":
            beside = read_bytes(os.path.splitext(path)[0] + ".node") if integer(lines[0][0]) == 0 else b""
            vertices, faces = read_poly(lines, lines_of(beside, path) if beside else [])
            data += beside
        else:
            vertices, faces = (read_off if suffix == ".off" else read_obj)(lines)
    except IndexError:
        raise Bad(f"{path} ends too early") from None
    need_form(all(len(v) == 3 for v in vertices), f"{path} has a vertex without three numbers")
    return vertices, faces, hashlib.sha256(data).hexdigest()


def need_given(answers, key, path):
    """The answers are about the numbers of the file, in order; one line serves all."""
    size = {"point": 3, "ray": 6}.get(key, 12)
    numbers = [given(word) for words in lines_of(read_bytes(path), path) for word in " ".join(words).replace(",", " ").split()]
    need_form(len(numbers) in (size, size * len(answers)), f"{path} has not {size} numbers for each answer")
    for k, answer in enumerate(answers):
        said = rows(answer.get("origin")) + rows(answer.get("direction")) if key == "ray" else answer.get(key)
        at = 0 if len(numbers) == size else k * size
        need(vector(said, given, size) == numbers[at:at + size], f"answer {k} is not about what {path} says")


def object_of(items):
    need_form(len(dict(items)) == len(items), "a key is there twice")
    return dict(items)


def no_float(text):
    raise Bad(f"{text[:40]} is a number with a point, not a string")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("certificate")
    parser.add_argument("models", nargs="*")
    parser.add_argument("--given", action="append", default=[], metavar="KEY=FILE")
    asked = parser.parse_args()
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)  # numbers of any length are exact
    where = asked.certificate
    try:
        certificate = json.loads(read_bytes(where), object_pairs_hook=object_of, parse_float=no_float, parse_constant=no_float)
        keys(certificate, ["certificate", "bodies", "answers"])
        need_form(certificate["certificate"] == "tetracone 1", "another version; expected tetracone 1")
        entries, answers = rows(certificate["bodies"]), rows(certificate["answers"])
        need_form(len(entries) in (1, 2) and len(asked.models) <= len(entries) and answers, "it has not one or two bodies, and answers")
        bodies = [Body(entry, asked.models[k] if k < len(asked.models) else None) for k, entry in enumerate(entries)]
        for answer in answers:
            need_form(isinstance(answer, dict) and answer.get("ask") in PROVE.keys(), "an answer is to no question")
        for key, _, path in (word.partition("=") for word in asked.given):
            need_form(key in ("pose_a", "pose_b", "from_a", "to_a", "from_b", "to_b", "point", "ray"), f"--given {key} is unknown")
            need_given(answers, key, path)
        for k, answer in enumerate(answers):
            where = f"{asked.certificate}: answer {k}"
            PROVE[answer["ask"]](answer, bodies)
            turned = "".join(f", with {len(body.turned)} loops turned" for body in bodies if body.turned)
            print(k, answer["ask"], answer.get("question", "-"), json.dumps(answer["answer"]), "proved" + turned)
    except Refused as reason:
        print(f"{where}: refused: {reason}", file=sys.stderr)
        return 1
    except (Bad, OSError, UnicodeDecodeError, json.JSONDecodeError, RecursionError, TypeError, MemoryError) as reason:
        print(f"{where}: bad input: {' '.join(str(reason).split())}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
