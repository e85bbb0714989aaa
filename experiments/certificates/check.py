#!/usr/bin/env python3
"""Proves the answers of a certificate that `tetracone ... --certificate FILE` has written. README.md says what is proved.

  check.py CERTIFICATE [A [B]] [--given KEY=FILE]...
  check.py -        a certificate a line on standard input; a line each: proved, refused or bad input

A and B are the model files: OFF, OBJ or TetGen's .poly. A body that stands in the certificate has none. `--given pose_b=poses.txt` demands that each answer is about its
row of the file; KEY is pose_a, pose_b, from_a, to_a, from_b, to_b, point, ray, limit, end or direction. Prints a line an answer, which begins
with the answer's row.
Status 0: all are proved. 1: one is refused. 2: bad input.

A function prove_KIND proves an answer of that kind, by the row of README.md with its name. The other prove_X say in their text what they
prove. All raise Refused where the proof does not show that. `covers.py` proves what answers
of all kinds are made of, `depths.py` a lower bound of a depth."""
import argparse
import json
import math
import sys
from fractions import Fraction

from bodies import Body, Placed, given_pose, on_one_scale, shapes
from covers import (direction, need_each_shell, need_vertex_inside, points_in, prove_free, prove_gap, prove_lines, prove_moving, prove_winding, prove_windings,
                    prove_witness)
from depths import prove_before, prove_low
from geometry import cross, dot, minus
from motions import motion_of, pose_at
from reading import Bad, Object, Refused, exact, given, need, need_form, need_given, need_keys, read_bytes, vector


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
    if hit is not None or end is None or end >= 0:
        prove_free(answer, body, o, d, t, lambda group: hit is not None and group.least_face >= first)
    return f", up to {answer['end']}" if end is not None else None


def placed_at(answer, bodies, shift=None):
    """Both bodies at their poses, A moved by a vector."""
    poses = [given_pose(answer[name]) for name in ("pose_a", "pose_b")]
    if shift:
        poses[0] = [x + shift[k // 4] if k % 4 == 3 else x for k, x in enumerate(poses[0])]
    return [Placed(body, pose) for body, pose in zip(bodies, poses)]


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
    point, those of A ahead and those of B behind. When A is moved back, points of the one are within the other."""
    need_keys(entry, "point in_a in_b")
    x = vector(entry["point"])
    (in_a, of_a), (in_b, of_b) = (prove_approach(entry[key], placed, k, x) for k, key in enumerate(("in_a", "in_b")))
    need(of_a != 0 and of_b != 0, "a segment does not begin inside")
    # The direction is a sum of multiples of both ways, none of them negative.
    ahead, behind = minus(in_a, x), minus(x, in_b)
    if any(n := cross(ahead, behind)):
        between = dot(n, along) == 0 <= min(dot(cross(along, behind), n), dot(cross(ahead, along), n))
    else:
        between = any(dot(v, along) > 0 and not any(cross(v, along)) for v in (ahead, behind))
    need(between, "the segments do not lead along the direction")


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
    need([True, True] in points_in(prove_windings(answer, placed_at(answer, bodies))), "no point is known to be inside of both")
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
    if "overlap" in answer:
        prove_before(answer["overlap"], lambda s: placed_at(answer, bodies, [s * x for x in along]), along, first)
        return ", and no move before the first is an exit"
    return ", only that an exit begins at the first"


def prove_depth(answer, bodies):
    pair(answer, bodies)
    v = vector(answer["vector"])
    need(dot(v, v) == exact(answer["answer"]), "the translation has another length")
    prove_parted(answer, placed_at(answer, bodies, v))
    if "low" in answer:
        low = prove_low(answer["low"], placed_at(answer, bodies))
        need(low <= dot(v, v), "a shorter translation parts the solids")
        return f", and no less than {low}"
    return ", an upper bound" if any(v) else None


def prove_motion(answer, bodies):
    motions = [motion_of(answer["from_" + name], answer["to_" + name]) for name in "ab"]
    start, solid = pair(answer, bodies, [pose_at(motion, Fraction(0)) for motion in motions])
    lo, hi = (Fraction(1), None) if answer["answer"] is None else vector(answer["answer"], given, 2)
    need_form(0 <= lo <= 1 and (hi is None or lo <= hi <= 1), "the times are not in order")
    need(hi is None or hi == float(hi) <= math.nextafter(float(lo), 2) and lo == float(lo), "the times are not one double or neighbours")
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
             "exit": (prove_exit, "ask answer pose_a pose_b direction plane way windings gone before overlap"),
             "depth": (prove_depth, "ask answer pose_a pose_b vector plane way low"),
             "motion": (prove_motion, "ask answer question from_a to_a from_b to_b witness windings directions cover")}


def prove(text, models=(), demands=()):
    """Yields a line for each answer. Raises Refused or Bad."""
    certificate = json.loads(text, object_pairs_hook=Object, parse_float=Fraction)
    need_keys(certificate, "certificate bodies answers asked")
    need_form(certificate["certificate"] == "tetracone 1", "another version; expected tetracone 1")
    entries, answers = certificate["bodies"], certificate["answers"]
    need_form(len(entries) in (1, 2), "there are not one or two bodies")
    need_form(answers, "no answer is in it")
    is_each = "asked" not in certificate  # else some answers are left out, and each has its row
    rows = list(range(len(answers))) if is_each else [answer["row"] for answer in answers]
    asked = len(answers) if is_each else certificate["asked"]
    need_form(type(asked) is int and all(type(row) is int for row in rows), "a row is no integer")
    need_form(all(low < high for low, high in zip([-1, *rows], [*rows, asked])), f"rows do not ascend from 0 to below {asked}")
    files = iter(models)
    bodies = [Body(entry, None if "vertices" in entry else next(files, None)) for entry in entries]
    need_form(next(files, None) is None, "more model files than the certificate names")
    as_cut = "" if all(all(body.is_flat) for body in bodies) else ", of faces that are not planar as they are cut here"
    for key, path in demands:
        need_given(answers, rows, asked, key, path)
    for row, answer in zip(rows, answers):
        proof, known = QUESTIONS.get(answer["ask"], (None, "ask"))
        need_keys(answer, known if is_each else known + " row")
        more = (proof(answer, bodies) or "") + as_cut
        yield f"{row} {answer['ask']} {answer.get('question', '-')} {json.dumps(answer['answer'])} proved{more}"
    if len(rows) < asked:
        print(f"{asked - len(rows)} of {asked} questions have no proof in it", file=sys.stderr)


BAD = (Bad, OSError, ValueError, TypeError, AttributeError, LookupError, RecursionError, OverflowError, MemoryError)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("certificate")
    parser.add_argument("models", nargs="*")
    parser.add_argument("--given", action="append", default=[], metavar="KEY=FILE")
    asked = parser.parse_args()
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)  # numbers of any length are exact
    sys.setrecursionlimit(10000)  # covers open groups and halve times, one in the other
    status = 0
    for text in sys.stdin.buffer if asked.certificate == "-" else [None]:
        said = "proved"
        try:
            for line in prove(text or read_bytes(asked.certificate), asked.models, [word.split("=", 1) for word in asked.given]):
                print(line) if text is None else None
        except Refused as reason:
            status, said = max(status, 1), f"refused: {reason}"
        except BAD as reason:
            status, said = 2, f"bad input: {' '.join(str(reason).split())}"
        if text is not None:
            print(said, flush=True)
        elif said != "proved":
            print(f"{asked.certificate}: {said}", file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
