#!/usr/bin/env python3
"""Proves the answers of a certificate that `tetracone ... --certificate FILE` has written. README.md says what is proved.

  check.py CERTIFICATE [A [B]] [--given KEY=FILE]...
  check.py -        a certificate a line on standard input; a line each: proved, refused or bad input

A and B are the model files: OFF, OBJ or TetGen's .poly. A body that stands in the certificate has none. `--given pose_b=poses.txt` demands that the answers are about the
file's numbers, in order; KEY is pose_a, pose_b, from_a, to_a, from_b, to_b, point or ray. Prints a line an answer.
Status 0: all are proved. 1: one is refused. 2: bad input.

Coordinates are integers here: those of all bodies are multiplied by one common denominator, the `scale`.
A function prove_X states in its text what it proves, and raises Refused where the proof does not show that."""
import argparse
import json
import sys
from fractions import Fraction
from math import lcm

from bodies import Body, Placed, given_pose, on_one_scale, shapes
from geometry import cross, crossing, dot, minus, times
from motions import line, motion_of, over, pose_at, together
from reading import Bad, Object, Refused, exact, given, index, need, need_form, need_given, need_keys, read_bytes, vector


def direction(texts):
    """A vector other than 0, multiplied by its denominators: integers."""
    v = vector(texts)
    need(any(v), "a direction is 0")
    return times(v, lcm(*(x.denominator for x in v)))


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


def prove_free(entry, body, o, d, t, may_touch):
    """No piece meets o + s d for s >= 0, or up to t where it is not None. Groups that may touch are met at t at the earliest."""
    scale = on_one_scale(body, points=[o, d])
    origin, way = times(o, scale), times(d, scale)

    def apart(m, _, group, __):
        height, slope = body.extent(group, m)[0] - dot(m, origin), dot(m, way)
        left = -slope if t is None else height * t.denominator - slope * t.numerator
        need(height > 0 and (left > 0 or left == 0 and (t is None or may_touch(group))), "the ray is not apart from a group")

    def touched(group):
        need(t == 0 and may_touch(group), "a group is not touched first")

    prove_cover(entry, None, body.body.root, apart, touched=touched)


def prove_moving(entry, bodies, motions, last, is_open):
    """Moving bodies share no point from time 0 to the last; at the last itself they may where that is open.

    What a direction says of two corners is a form in the time within an interval. It is positive where its coefficients are."""
    entries, known = together(motions), {}

    def maps(span):
        """For each coefficient the maps of both bodies, as columns, in integers of one scale."""
        if span not in known:
            parts = [[over(f, *span) for f in of_body] for of_body in entries]
            scale = lcm(*(body.scale for body in bodies)) * lcm(*(x.denominator for forms in parts for f in forms for x in f))
            known[span] = [[[times([f[k] for f in forms[i::4]], Fraction(scale, 1 if i == 3 else body.scale)) for i in range(4)]
                            for body, forms in zip(bodies, parts)] for k in range(len(parts[0][0]))]
        return known[span]

    def products(m, columns, body, group):
        row = [dot(m, column) for column in columns]
        return [dot(row, body.at[v]) + row[3] for v in group.corners]

    def apart(m, of_a, of_b, span):
        for k, (a, b) in enumerate(steps := maps(span)):
            gap = min(products(m, b, bodies[1], of_b)) - max(products(m, a, bodies[0], of_a))
            is_end = k + 1 == len(steps) and span[1] == last
            need(gap > 0 or gap == 0 and is_open and is_end, "two groups are not apart all the time")

    prove_cover(entry, bodies[0].root, bodies[1].root, apart, span=(Fraction(0), last))


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


def pair(answer, bodies, poses=None):
    """The placed bodies, and whether the question is about solids."""
    need_form(len(bodies) == 2, "there are not two bodies")
    question = answer["question"] if answer["ask"] not in ("relation", "exit", "depth") else "solid"
    need_form(question in ("solid", "surface"), "there is no such question")
    need(question == "surface" or all(body.is_closed for body in bodies), "a body is not closed, and has no solid")
    placed = [Placed(*of) for of in zip(bodies, poses or map(given_pose, (answer["pose_a"], answer["pose_b"])))]
    on_one_scale(*placed)
    return placed, question == "solid"


def prove_apart(answer, placed, solid, square=Fraction(0), or_equal=False):
    prove_gap(answer, *placed, square, or_equal)
    found = prove_windings(answer, placed)
    for k in range(2) if solid else ():
        need_each_shell(found, placed, k, False)


def prove_together(answer, placed, solid, square=Fraction(0)):
    """Two points are at most the root of `square` apart, or one solid holds a vertex of the other."""
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
    prove_free(answer, body, o, d, t, lambda group: hit is not None and group.least_face >= first)


def points_in(found):
    """For each point whether it is inside of A, and of B: pairs of True, False, or None where nothing is said."""
    sides = {}
    for (body, x), holder, winding in found:
        if body is None:
            sides.setdefault(x, [None, None])[holder] = winding != 0
    return sides.values()


def placed_at(answer, bodies, shift=None):
    """Both bodies at their poses, A moved by a vector."""
    poses = [given_pose(answer[name]) for name in ("pose_a", "pose_b")]
    if shift:
        poses[0] = [x + shift[k // 4] if k % 4 == 3 else x for k, x in enumerate(poses[0])]
    return [Placed(body, pose) for body, pose in zip(bodies, poses)]


def prove_lines(entry, start, end):
    """Bodies whose corners move on lines share no point before the end."""
    prove_moving(entry, [p.body for p in start], [line(p.pose, q.pose) for p, q in zip(start, end)], Fraction(1), True)


def prove_way(row, placed, inside=None):
    """A body comes on lines to its pose. Before, the surfaces share no point, and the solids none, or body `inside` is inside of the other one."""
    need_keys(row, "of pose directions cover windings")
    need_form(row["of"] in ("a", "b"), "there is no such body")
    k, start = "ab".index(row["of"]), list(placed)
    start[k] = Placed(placed[k].body, given_pose(row["pose"]))
    prove_lines(row, start, placed)
    found = prove_windings(row, start)
    for body in range(2):
        need_each_shell(found, start, body, inside == body)
    return row["of"]


def prove_plane(m, a, b):
    """No point of a is beyond a point of b along m."""
    on_one_scale(a, b)
    need(a.extent(a.body.root, m)[1] <= b.extent(b.body.root, m)[0], "the plane does not separate")


def prove_parted(answer, placed):
    """The interiors share no point."""
    if "plane" in answer:
        prove_plane(direction(answer["plane"]), *placed)
    else:
        prove_way(answer["way"], placed)


def prove_approach(entry, placed, k, x):
    """From a point to x no point of the surface of body k is met, but perhaps x. Returns the point, and its winding number in body k."""
    need_keys(entry, "winding directions cover")
    ((body, y), holder, winding), = prove_windings({"windings": [entry["winding"]]}, placed)
    need(body is None and holder == k, "the point is not about this body")
    prove_free(entry, placed[k], y, minus(x, y), Fraction(1), lambda group: True)
    return y, winding


def prove_border(entry, placed, inner):
    """A point of the inner body is not in the interior of the other one: points outside of that lead up to it."""
    need_keys(entry, "face point outside")
    x = vector(entry["point"])
    need(placed[inner].holds(entry["face"], x), "the face does not hold its point")
    need(prove_approach(entry["outside"], placed, 1 - inner, x)[1] == 0, "the segment does not begin outside")


def prove_just_before(entry, placed, along):
    """Whenever A has a little way to go along the direction, the interiors share a point. Points inside of both bodies lead up to a
    point: those of B against the direction, or those of A along it. When A is moved back, points of the one are within the other."""
    need_keys(entry, "point in_a in_b")
    x = vector(entry["point"])
    (in_a, of_a), (in_b, of_b) = (prove_approach(entry[key], placed, k, x) for k, key in enumerate(("in_a", "in_b")))
    need(of_a != 0 and of_b != 0, "a segment does not begin inside")
    ways = minus(in_a, x), minus(x, in_b)
    need(any(dot(v, along) > 0 and not any(cross(v, along)) for v in ways), "no segment is along the direction")


def prove_relation(answer, bodies):
    placed, _ = pair(answer, bodies)
    said = answer["answer"]
    need_form(said in ("disjoint", "meet", "overlap", "equal", "inside", "contains", "covered_by", "covers"), "there is no such answer")
    found = prove_windings(answer, placed)
    if said in ("disjoint", "inside", "contains"):
        prove_gap(answer, *placed)
        need_each_shell(found, placed, 0, said == "inside")
        need_each_shell(found, placed, 1, said == "contains")
    elif said == "equal" and "ways" in answer:
        need_form(len(answer["ways"]) == 2, "there are not two ways")
        for inside, row in enumerate(answer["ways"]):
            prove_way(row, placed, inside)
    elif said == "equal":
        on_one_scale(*placed)
        need(shapes(placed[0]) == shapes(placed[1]), "the faces are not the same")
    elif said == "meet":
        need(prove_witness(answer["witness"], placed) == 0, "the points are not one")
        prove_parted(answer, placed)
    elif said in ("covered_by", "covers"):
        inner = 0 if said == "covered_by" else 1
        prove_way(answer["way"], placed, inner)
        prove_border(answer["border"], placed, inner)
    parts = {"meet": ["a", "b"], "overlap": ["ab", "a", "b"], "covered_by": ["b"], "covers": ["a"]}.get(said, [])
    need(all([k in part for k in "ab"] in points_in(found) for part in parts), "a part of the solids has no point")


def prove_exit(answer, bodies):
    pair(answer, bodies)
    along = vector(answer["direction"], given)
    first, last = vector(answer["answer"], exact, 2)
    need_form(any(along) and 0 <= first <= last, "the exits are not in order, or the direction is 0")
    prove_parted(answer, placed_at(answer, bodies, [first * x for x in along]))
    if first == 0:
        return need(last == 0, "solids that overlap nowhere have no exit but 0")
    gone = answer["gone"]
    need_keys(gone, "until directions cover windings")
    until = exact(gone["until"])
    need(until > 0, "the bodies do not part for ever")
    ends = [placed_at(answer, bodies, [s * x for x in along]) for s in (last + until, last)]
    prove_lines(gone, *ends)
    found = prove_windings(gone, ends[0])
    for body in range(2):
        need_each_shell(found, ends[0], body, False)
    prove_plane(direction([str(x) for x in along]), *reversed(ends[0]))
    need_form(len(answer["before"]) == 2, "there are not two points")
    for s, row in zip((first, last), answer["before"]):
        prove_just_before(row, placed_at(answer, bodies, [s * x for x in along]), along)


def prove_depth(answer, bodies):
    pair(answer, bodies)
    v = vector(answer["vector"])
    need(dot(v, v) == exact(answer["answer"]), "the translation has another length")
    prove_parted(answer, placed_at(answer, bodies, v))


def prove_motion(answer, bodies):
    motions = [motion_of(answer["from_" + name], answer["to_" + name]) for name in "ab"]
    start, solid = pair(answer, bodies, [pose_at(motion, Fraction(0)) for motion in motions])
    lo, hi = (Fraction(1), None) if answer["answer"] is None else vector(answer["answer"], given, 2)
    need_form(0 <= lo <= 1 and (hi is None or lo <= hi <= 1), "the times are not in order")
    if "witness" in answer:
        time = exact(answer["witness"]["time"])
        need(hi is not None and lo <= time <= hi, "the witness is not of its time")
        placed = [Placed(body, pose_at(motion, time)) for body, motion in zip(bodies, motions)]
        need(prove_witness(answer["witness"], placed) == 0, "the points are not one")
    elif hi is not None:
        need(solid and hi == 0, "there is no witness")
        need_vertex_inside(prove_windings(answer, start))
    if hi == 0:
        return
    prove_moving(answer, bodies, motions, lo, lo == hi)
    found = prove_windings(answer, start)
    for k in range(2) if solid else ():
        need_each_shell(found, start, k, False)


PLACED = "ask answer question pose_a pose_b witness windings directions cover"
QUESTIONS = {"collide": (prove_collide, PLACED), "distance": (prove_distance, PLACED), "within": (prove_within, PLACED + " limit"),
             "inside": (prove_inside, "ask answer point face ray winding directions cover"),
             "ray": (prove_ray, "ask answer origin direction end directions cover"),
             "relation": (prove_relation, "ask answer pose_a pose_b witness plane way ways border windings directions cover"),
             "exit": (prove_exit, "ask answer pose_a pose_b direction plane way gone before"),
             "depth": (prove_depth, "ask answer pose_a pose_b vector plane way"),
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
