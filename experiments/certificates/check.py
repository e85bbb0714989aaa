#!/usr/bin/env python3
"""Proves the answers of a certificate that `tetracone ... --certificate FILE` has written. README.md says what is proved.

  check.py CERTIFICATE [A [B]] [--given KEY=FILE]...
  check.py -        a certificate a line on standard input; a line each: proved, refused or bad input

A and B are the model files: OFF, OBJ or TetGen's .poly. A body that stands in the certificate has none. `--given pose_b=poses.txt` demands that the answers are about the
file's numbers, in order; KEY is pose_a, pose_b, from_a, to_a, from_b, to_b, point or ray. Prints a line an answer.
Status 0: all are proved. 1: one is refused. 2: bad input.

Coordinates are integers here: those of all bodies are multiplied by one common denominator, the `scale`."""
import argparse
import json
import sys
from fractions import Fraction
from math import lcm

from geometry import cross, crossing, dot, edges, is_planar, loops_hold, minus, times
from reading import Bad, Object, Refused, exact, given, index, need, need_form, need_given, need_keys, read_bytes, read_model, vector


def direction(texts):
    """A vector other than 0, multiplied by its denominators: integers."""
    v = vector(texts)
    need(any(v), "a direction is 0")
    return times(v, lcm(*(x.denominator for x in v)))


# Bodies


class Group:
    """Pieces of a body, by their numbers. `members` are smaller groups that together have all of them."""

    def __init__(self, pieces, corners, least_face, members=None):
        self.pieces, self.corners, self.least_face, self.members = pieces, corners, least_face, members


def balance(sides):
    """Directed edges that are not there as often as their reverses."""
    count = {}
    for p, q in sides:
        count[p, q] = count.get((p, q), 0) + 1
        count[q, p] = count.get((q, p), 0) - 1
    return {side: n for side, n in count.items() if n and side[0] != side[1]}


class Body:
    def __init__(self, entry, path):
        need_keys(entry, "vertices faces cut groups" if "vertices" in entry else "file sha256 cut groups")
        if "vertices" in entry:
            vertices, self.faces = [vector(v, given) for v in entry["vertices"]], entry["faces"]
        else:
            need_form(path is not None, "the certificate names a model file; expected it behind the certificate")
            vertices, self.faces, digest = read_model(path)
            need(digest == entry["sha256"], f"{path} is not the file that the certificate is about")
        need_form(self.faces and all(loops and all(loops) for loops in self.faces), "a body has no face, or a face has no corner")
        for loop in (loop for loops in self.faces for loop in loops):
            for v in loop:
                index(v, vertices, "vertex")
        self.scale = lcm(*(x.denominator for v in vertices for x in v))
        self.at = [times(v, self.scale) for v in vertices]
        self.cut_into_pieces(entry.get("cut", []))
        corners = {v for _, loops in self.pieces for loop in loops for v in loop}
        self.root = self.group(entry["groups"]) if "groups" in entry else Group(set(range(len(self.pieces))), corners, 0)
        need(len(self.root.pieces) == len(self.pieces), "a piece is in no group")
        self.find_shells()
        self.is_closed = not balance(side for loops in self.faces for side in edges(loops))

    def cut_into_pieces(self, cut):
        """Pieces are pairs of a face and loops. `is_flat` tells whether a face is what its loops say."""
        triangles = {}
        for face, *corners in cut:
            need_form(len(corners) == 3, "a row of a cut has not four numbers")
            triangles.setdefault(index(face, self.faces, "face"), []).append([index(v, self.at, "vertex") for v in corners])
        self.pieces, self.is_flat = [], [is_planar(loops, self.at) for loops in self.faces]
        for f, loops in enumerate(self.faces):
            parts = triangles.get(f)
            self.pieces += [(f, [triangle]) for triangle in parts] if parts else [(f, loops)]
            need(parts or self.is_flat[f], f"face {f} is neither planar nor cut")
            need(not parts or balance(edges(loops)) == balance(edges(parts)), f"the triangles of face {f} have another boundary")
            need(not parts or {frozenset(e) for e in edges(loops)} <= {frozenset(e) for e in edges(parts)}, f"face {f} has an edge without a triangle")

    def group(self, entry):
        if not isinstance(entry, list):
            f, loops = self.pieces[index(entry, self.pieces, "piece")]
            return Group({entry}, {v for loop in loops for v in loop}, f)
        need_form(entry, "a group is empty")
        members = [self.group(member) for member in entry]
        pieces, corners = (set().union(*(getattr(member, name) for member in members)) for name in ("pieces", "corners"))
        return Group(pieces, corners, min(member.least_face for member in members), members)

    def find_shells(self):
        """`shell` names for each vertex of a face its shell: loops with a common vertex are of one shell."""
        name = {v: v for loops in self.faces for loop in loops for v in loop}

        def root(v):
            while name[v] != v:
                name[v] = v = name[name[v]]
            return v

        for p, q in (side for loops in self.faces for side in edges(loops)):
            name[root(p)] = root(q)
        self.shell = {v: root(v) for v in name}


class Placed:
    """The corners of a placed body times `scale`, and the extent of its groups along directions."""

    def __init__(self, body, pose=None):
        self.body, self.at, self.scale, self.known = body, body.at, body.scale, {}
        if pose:
            factor = lcm(*(x.denominator for x in pose))
            rows = [times(pose[k:k + 3], factor) for k in (0, 4, 8)]
            need_form(dot(cross(rows[0], rows[1]), rows[2]) != 0, "a pose is flat")
            shift = times(pose[3::4], factor * body.scale)
            self.at = [tuple(dot(rows[i], v) + shift[i] for i in range(3)) for v in body.at]
            self.scale = factor * body.scale

    def extent(self, group, m):
        """The least and the largest m . x over the corners of the group."""
        key = id(group), m
        if key not in self.known:
            products = [m[0] * x + m[1] * y + m[2] * z for x, y, z in map(self.at.__getitem__, group.corners)]
            self.known[key] = min(products), max(products)
        return self.known[key]

    def holds(self, f, x):
        """Face f holds the point x, of fractions."""
        loops = self.body.faces[index(f, self.body.faces, "face")]
        shapes = [loops] if self.body.is_flat[f] else [piece for face, piece in self.body.pieces if face == f]
        scale = lcm(self.scale, *(c.denominator for c in x))
        at = {v: times(self.at[v], scale // self.scale) for loop in loops for v in loop}
        return any(loops_hold(shape, at, times(x, scale)) for shape in shapes)


def on_one_scale(*placed, points=()):
    scale = lcm(*(p.scale for p in placed), *(x.denominator for point in points for x in point))
    for p in placed:
        if p.scale != scale:
            p.at = [times(v, scale // p.scale) for v in p.at]
            p.scale, p.known = scale, {}
    return scale


# Covers


def prove_cover(entry, a, b, apart, span=None, crossed=None, touched=None):
    """Every pair of a piece of a and one of b is in groups for which apart(m, group a, group b, span) does not refuse."""
    directions = [direction(m) for m in entry["directions"]]

    def walk(node, a, b, span):
        if node == "crossed" and crossed:
            need_form(len(b.pieces) == 1, "a group that is crossed has several pieces")
            crossed(*b.pieces)
        elif node == "touched" and touched:
            touched(b)
        elif not isinstance(node, list):
            apart(directions[index(node, directions, "direction")], a, b, span)
        elif node[:1] == ["t"]:
            need_form(span and len(node) == 4, "a node of time has not four parts")
            time = exact(node[1])
            need(span[0] < time < span[1], "an interval is not cut within it")
            walk(node[2], a, b, (span[0], time))
            walk(node[3], a, b, (time, span[1]))
        else:
            need_form(node[:1] in (["a"], ["b"]), "a node of a cover is none")
            opened = a if node[0] == "a" else b
            need_form(opened and opened.members, "a group is opened that has no members")
            need(len(opened.members) == len(node) - 1, "a member of a group is missing in the cover")
            for member, below in zip(opened.members, node[1:]):
                walk(below, *((member, b) if node[0] == "a" else (a, member)), span)

    walk(entry["cover"], a, b, span)


def prove_gap(entry, a, b, square=Fraction(0), or_equal=False):
    """The surfaces are farther apart than the root of `square`, or as far."""
    scale = on_one_scale(a, b)

    def apart(m, of_a, of_b, _):
        gap = b.extent(of_b, m)[0] - a.extent(of_a, m)[1]
        excess = gap * gap * square.denominator - square.numerator * dot(m, m) * scale * scale
        need(gap > 0 and (excess > 0 or or_equal and excess == 0), "two groups are not as far apart")

    prove_cover(entry, a.body.root, b.body.root, apart)


def prove_winding(entry, x, body):
    """The winding number of the point x, of fractions, in the placed body."""
    scale = on_one_scale(body, points=[x])
    origin, way = times(x, scale), direction(entry["ray"])
    counts = {}

    def apart(m, _, group, __):
        need(dot(m, way) <= 0 and dot(m, origin) < body.extent(group, m)[0], "a ray is not apart from a group")

    def crossed(piece):
        counts[piece] = crossing(body.body.pieces[piece][1], body.at, origin, way)
        need(counts[piece] is not None, "a ray does not cross a face in its interior")

    prove_cover(entry, None, body.body.root, apart, crossed=crossed)
    need(type(entry["winding"]) is int and sum(counts.values()) == entry["winding"], "the crossings have another sum")
    return entry["winding"]


def prove_windings(entry, placed):
    """Triples: the body and its vertex, or None and a point; the body that it is in; the winding number."""
    found = []
    for row in entry.get("windings", []):
        need_keys(row, "in vertex ray winding directions cover" if "vertex" in row else "in point ray winding directions cover")
        need_form(row["in"] in ("a", "b"), "there is no such body")
        holder = "ab".index(row["in"])
        held = placed[1 - holder]
        if "vertex" in row:
            need(row["vertex"] in held.body.shell, "a vertex is of no face")
            x, of = [Fraction(c, held.scale) for c in held.at[row["vertex"]]], (1 - holder, row["vertex"])
        else:
            x = vector(row["point"])
            of = None, tuple(x)
        found.append((of, holder, prove_winding(row, x, placed[holder])))
    return found


def need_each_shell(found, placed, k, is_inside):
    """Each shell of body k has a vertex that is inside of the other one, or outside."""
    shell = placed[k].body.shell
    named = {shell[v] for (body, v), _, winding in found if body == k and (winding != 0) == is_inside}
    need(named == set(shell.values()), "a shell has no vertex that is known to be " + ("inside" if is_inside else "outside"))


def need_vertex_inside(found, bodies=(0, 1)):
    need(any(of[0] in bodies and winding != 0 for of, _, winding in found), "no vertex is known to be inside of the other solid")


def prove_witness(entry, placed):
    """The squared distance of the two points, each in its face."""
    need_keys(entry, "points faces time")
    points = [vector(p) for p in entry["points"]]
    need_form(len(points) == 2 and len(entry["faces"]) == 2, "a witness has not two points and two faces")
    for body, f, point in zip(placed, entry["faces"], points):
        need(body.holds(f, point), f"face {f} does not hold its point")
    return dot(minus(*points), minus(*points))


# Answers


def pair(answer, bodies, names=("pose_a", "pose_b")):
    """The placed bodies, and whether the question is about solids."""
    need_form(len(bodies) == 2, "there are not two bodies")
    question = answer["question"] if answer["ask"] != "relation" else "solid"
    need_form(question in ("solid", "surface"), "there is no such question")
    need(question == "surface" or all(body.is_closed for body in bodies), "a body is not closed, and has no solid")
    placed = [Placed(body, vector(answer[name], given, 12)) for body, name in zip(bodies, names)]
    on_one_scale(*placed)
    return placed, question == "solid"


def prove_apart(answer, placed, solid, square=Fraction(0), or_equal=False):
    prove_gap(answer, *placed, square, or_equal)
    found = prove_windings(answer, placed)
    for k in range(2) if solid else ():
        need_each_shell(found, placed, k, False)


def prove_together(answer, placed, solid, square=Fraction(0)):
    """Two points are at most so far apart, or one solid holds a vertex of the other."""
    if "witness" in answer:
        need(prove_witness(answer["witness"], placed) <= square, "the points are farther apart")
    else:
        need(solid, "there is no witness")
        need_vertex_inside(prove_windings(answer, placed))


def prove_collide(answer, bodies):
    placed, solid = pair(answer, bodies)
    said = answer["answer"]
    need_form(said in ("apart", "surfaces", "a_in_b", "b_in_a")[:4 if solid else 2], "there is no such answer")
    if said == "surfaces":
        need("witness" in answer, "there is no witness")
        prove_together(answer, placed, solid)
    elif said == "apart":
        prove_apart(answer, placed, solid)
    else:
        prove_gap(answer, *placed)
        need_vertex_inside(prove_windings(answer, placed), [0 if said == "a_in_b" else 1])


def prove_distance(answer, bodies):
    placed, solid = pair(answer, bodies)
    square = exact(answer["answer"])
    if square == 0:
        prove_together(answer, placed, solid)
    else:
        need(prove_witness(answer["witness"], placed) == square, "the points are not so far apart")
        prove_apart(answer, placed, solid, square, True)


def prove_within(answer, bodies):
    placed, solid = pair(answer, bodies)
    limit = given(answer["limit"])
    need_form(answer["answer"] in (0, 1) and type(answer["answer"]) is int, "there is no such answer")
    if answer["answer"] == 1:
        need(limit >= 0, "a distance is within a negative limit")
        prove_together(answer, placed, solid, limit * limit)
    elif limit >= 0:
        prove_apart(answer, placed, solid, limit * limit)


def prove_inside(answer, bodies):
    need_form(len(bodies) == 1, "there is not one body")
    need(bodies[0].is_closed, "the body is not closed, and has no solid")
    need_form(type(answer["answer"]) is int and answer["answer"] in (-1, 0, 1), "there is no such answer")
    body, x = Placed(bodies[0]), vector(answer["point"], given)
    if answer["answer"] == 0:
        need(body.holds(answer["face"], x), "the face does not hold the point")
    else:
        need((prove_winding(answer, x, body) != 0) == (answer["answer"] == 1), "the winding number says otherwise")


def prove_ray(answer, bodies):
    need_form(len(bodies) == 1, "there is not one body")
    body, o, d = Placed(bodies[0]), vector(answer["origin"], given), vector(answer["direction"], given)
    end, hit, first = given(answer["end"]) if "end" in answer else None, answer["answer"], None
    need_form(any(d) and (hit is None or isinstance(hit, dict)), "a direction is 0, or there is no such answer")
    t = end
    if hit is not None:
        need_keys(hit, "face t")
        t, first = exact(hit["t"]), hit["face"]
        need(t >= 0 and (end is None or t <= end), "the hit is not on the ray")
        need(body.holds(first, [o[k] + t * d[k] for k in range(3)]), "the face does not hold the hit")
    elif end is not None and end < 0:
        return
    scale = on_one_scale(body, points=[o, d])
    origin, way = times(o, scale), times(d, scale)

    def comes_after(group):
        return hit is not None and group.least_face >= first

    def apart(m, _, group, __):
        height, slope = body.extent(group, m)[0] - dot(m, origin), dot(m, way)
        left = -slope if t is None else height * t.denominator - slope * t.numerator
        need(height > 0 and (left > 0 or left == 0 and (t is None or comes_after(group))), "the ray is not apart from a group")

    def touched(group):
        need(t == 0 and comes_after(group), "a group is not touched first")

    prove_cover(answer, None, body.body.root, apart, touched=touched)


def prove_relation(answer, bodies):
    placed, _ = pair(answer, bodies)
    said = answer["answer"]
    need_form(said in ("disjoint", "inside", "contains", "overlap", "meet"), "there is no such answer")
    found = prove_windings(answer, placed)
    if said == "meet":
        need(prove_witness(answer["witness"], placed) == 0, "the points are not one")
        m, (a, b) = direction(answer["plane"]), placed
        need(a.extent(a.body.root, m)[1] <= b.extent(b.body.root, m)[0], "the plane does not separate")
    elif said == "overlap":
        sides = {}
        for (_, x), holder, winding in found:
            sides.setdefault(x, [None, None])[holder] = winding != 0
        need(all(side in sides.values() for side in ([True, True], [True, False], [False, True])), "a part of an overlap has no point")
    else:
        prove_gap(answer, *placed)
        need_each_shell(found, placed, 0, said == "inside")
        need_each_shell(found, placed, 1, said == "contains")


def prove_motion(answer, bodies):
    start, solid = pair(answer, bodies, ("from_a", "from_b"))
    poses = [vector(answer[name], given, 12) for name in ("from_a", "to_a", "from_b", "to_b")]
    end = [Placed(body, pose) for body, pose in zip(bodies, poses[1::2])]
    on_one_scale(*start, *end)
    lo, hi = (Fraction(1), None) if answer["answer"] is None else vector(answer["answer"], given, 2)
    need_form(0 <= lo <= 1 and (hi is None or lo <= hi <= 1), "the times are not in order")
    if "witness" in answer:
        time = exact(answer["witness"]["time"])
        need(hi is not None and lo <= time <= hi, "the witness is not of its time")
        between = [[(1 - time) * x + time * y for x, y in zip(*ends)] for ends in (poses[:2], poses[2:])]
        need(prove_witness(answer["witness"], [Placed(body, pose) for body, pose in zip(bodies, between)]) == 0, "the points are not one")
    elif hi is not None:
        need(solid and hi == 0, "there is no witness")
        need_vertex_inside(prove_windings(answer, start))
    if hi == 0:
        return

    def products(m, k, group, time):
        """m . x over the corners at that time, times its denominator."""
        n, d = time.numerator, time.denominator
        return [(d - n) * dot(m, start[k].at[v]) + n * dot(m, end[k].at[v]) for v in group.corners]

    def apart(m, of_a, of_b, span):
        for time in span:
            gap = min(products(m, 1, of_b, time)) - max(products(m, 0, of_a, time))
            need(gap > 0 or gap == 0 and time == lo == hi, "two groups are not apart all the time")

    prove_cover(answer, bodies[0].root, bodies[1].root, apart, span=(Fraction(0), lo))
    found = prove_windings(answer, start)
    for k in range(2) if solid else ():
        need_each_shell(found, start, k, False)


PLACED = "ask answer question pose_a pose_b witness windings directions cover"
QUESTIONS = {"collide": (prove_collide, PLACED), "distance": (prove_distance, PLACED), "within": (prove_within, PLACED + " limit"),
             "inside": (prove_inside, "ask answer point face ray winding directions cover"),
             "ray": (prove_ray, "ask answer origin direction end directions cover"),
             "relation": (prove_relation, "ask answer pose_a pose_b witness plane windings directions cover"),
             "motion": (prove_motion, "ask answer question from_a to_a from_b to_b witness windings directions cover")}


def prove(text, models=(), asked=()):
    """Yields a line for each answer. Raises Refused or Bad."""
    certificate = json.loads(text, object_pairs_hook=Object, parse_float=Fraction)
    need_keys(certificate, "certificate bodies answers")
    need_form(certificate["certificate"] == "tetracone 1", "another version; expected tetracone 1")
    entries, answers = certificate["bodies"], certificate["answers"]
    need_form(len(entries) in (1, 2) and answers, "there are not one or two bodies, and answers")
    files = iter(models)
    bodies = [Body(entry, None if "vertices" in entry else next(files, None)) for entry in entries]
    need_form(next(files, None) is None, "more model files than the certificate names")
    for key, path in asked:
        need_given(answers, key, path)
    for k, answer in enumerate(answers):
        proof, known = QUESTIONS.get(answer["ask"], (None, "ask"))
        need_keys(answer, known)
        proof(answer, bodies)
        yield f"{k} {answer['ask']} {answer.get('question', '-')} {json.dumps(answer['answer'])} proved"


BAD = (Bad, OSError, ValueError, TypeError, AttributeError, LookupError, RecursionError, OverflowError, MemoryError)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("certificate")
    parser.add_argument("models", nargs="*")
    parser.add_argument("--given", action="append", default=[], metavar="KEY=FILE")
    asked = parser.parse_args()
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)  # numbers of any length are exact
    status = 0
    for text in sys.stdin.buffer if asked.certificate == "-" else [None]:
        status, said = 0, "proved"
        try:
            for line in prove(text or read_bytes(asked.certificate), asked.models, [word.split("=", 1) for word in asked.given]):
                print(line) if text is None else None
        except Refused as reason:
            status, said = 1, f"refused: {reason}"
        except BAD as reason:
            status, said = 2, f"bad input: {' '.join(str(reason).split())}"
        if text is not None:
            print(said, flush=True)
        elif status:
            print(f"{asked.certificate}: {said}", file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
