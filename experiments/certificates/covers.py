"""Covers, windings and witnesses of a certificate. README.md has the format.

Coordinates are integers here: those of all bodies are multiplied by one common denominator, the `scale`.
A function prove_X states in its text what it proves, and raises Refused where the proof does not show that."""
from fractions import Fraction
from math import lcm

from bodies import on_one_scale
from geometry import crossing, dot, minus, times
from motions import line, over, together
from reading import exact, index, need, need_form, need_keys, vector


def direction(texts):
    """A vector other than 0, multiplied by its denominators: integers."""
    v = vector(texts)
    need(any(v), "a direction is 0")
    return times(v, lcm(*(x.denominator for x in v)))


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


def prove_lines(entry, start, end):
    """Bodies whose corners move on lines share no point before the end."""
    prove_moving(entry, [p.body for p in start], [line(p.pose, q.pose) for p, q in zip(start, end)], Fraction(1), True)


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


def points_in(found):
    """For each point whether it is inside of A, and of B: pairs of True, False, or None where nothing is said."""
    sides = {}
    for (body, x), holder, winding in found:
        if body is None:
            sides.setdefault(x, [None, None])[holder] = winding != 0
    return sides.values()
