"""The lower bound of a depth, by boxes of translations of A, and that of a first exit. README.md has the format, and says why they are proofs.

Coordinates of bodies are integers: the true ones times `scale`. Translations are fractions."""
from fractions import Fraction

from bodies import on_one_scale
from covers import points_in, prove_cover, prove_lines, prove_windings
from geometry import cross, dot, edges, minus
from reading import exact, index, need, need_form, need_keys


def axes_of(f, g):
    """The normals of two triangles and the products of their edges, except those that are 0. Parallel triangles also have the normals of
    their edges in their plane. Some of them separate the triangles where any direction does."""
    ways = [[minus(t[k], t[k - 1]) for k in range(3)] for t in (f, g)]
    normals = [cross(e[0], e[1]) for e in ways]
    products = [cross(e, d) for e in ways[0] for d in ways[1]]
    found = [n for n in normals + products if any(n)]
    return found if any(cross(*normals)) else found + [m for e in ways[0] + ways[1] if any(m := cross(normals[0], e))]


def ends(axis, corners):
    products = [dot(axis, x) for x in corners]
    return min(products), max(products)


def is_clear(f, h):
    """No point of triangle h is inside of triangle f: a plane separates them and does not hold f, or does not touch it."""
    if any(max(x[k] for x in h) < min(x[k] for x in f) or max(x[k] for x in f) < min(x[k] for x in h) for k in range(3)):
        return True
    for axis in axes_of(f, h):
        (low, high), (least, most) = ends(axis, f), ends(axis, h)
        if most < low or high < least or low < high and (most <= low or high <= least):
            return True
    return False


class Crossings:
    """Pairs of triangles that go through one another, A moved by a translation. Then the interiors share a point. The winding number changes
    by 1 across each triangle, so each has a side on which it is not 0. Two such sides share points, since the planes cross."""

    def __init__(self, placed):
        self.placed, self.plain, self.scale = placed, set(), on_one_scale(*placed)

    def triangle(self, k, n):
        """The corners of a piece of body k that is a triangle with an inside, which no other piece of the body meets."""
        body = self.placed[k].body
        at = self.placed[k].at
        loops = body.pieces[index(n, body.pieces, "piece")][1]
        f = [at[v] for v in loops[0]]
        if (k, n) not in self.plain:
            need(len(loops) == 1 and len(f) == 3 and any(cross(minus(f[1], f[0]), minus(f[2], f[0]))), "a piece that crosses another is no triangle")
            for other, (_, loops) in enumerate(body.pieces):
                # The triangles of a fan over its edges hold all points of a piece.
                fan = ([at[v] for v in (loops[0][0], p, q)] for p, q in edges(loops))
                need(other == n or all(is_clear(f, t) for t in fan), "a piece that crosses another meets one of its own body")
            self.plain.add((k, n))
        return f

    def limits(self, f, g):
        """Pairs n, limit: the triangles go through one another where scale n . v < limit for the translation v and all pairs."""
        a, b = self.triangle(0, f), self.triangle(1, g)
        need(any(cross(*(cross(minus(t[1], t[0]), minus(t[2], t[0])) for t in (a, b)))), "two pieces are parallel")
        for axis in axes_of(a, b):
            (low, high), (least, most) = ends(axis, a), ends(axis, b)
            yield axis, most - low
            yield minus((0, 0, 0), axis), high - least

    def shifts(self, f, g, along):
        """The least and the largest s so that the triangles go through one another for each translation s `along` between them."""
        low = high = None
        for n, limit in self.limits(f, g):
            slope = dot(n, along) * self.scale
            if slope > 0:
                high = min(x for x in (Fraction(limit) / slope, high) if x is not None)
            elif slope < 0:
                low = max(x for x in (Fraction(limit) / slope, low) if x is not None)
            else:
                need(limit > 0, "two pieces do not cross along the direction")
        need(low < high, "two pieces do not cross along the direction")
        return low, high


class Boxes(Crossings):
    """The translations shorter than the root of `square`, box by box."""

    def __init__(self, placed, square, balls):
        super().__init__(placed)
        self.square, self.balls, self.cutting = square, balls, {}

    def prove_crossing(self, f, g, centre, half):
        """The triangles go through one another for each translation of the box that is shorter than the root of `square`."""
        f, g = (index(n, p.body.pieces, "piece") for n, p in zip((f, g), self.placed))
        if (f, g) not in self.cutting:
            # All shorter translations v have scale n . v < limit where the limit's plane does not cut their ball.
            self.cutting[f, g] = [(n, limit) for n, limit in self.limits(f, g)
                                  if limit <= 0 or limit * limit < self.square * dot(n, n) * self.scale * self.scale]
        for n, limit in self.cutting[f, g]:
            largest = dot(n, centre) + sum(abs(n[k]) * half[k] for k in range(3))
            need(largest * self.scale < limit, "two pieces do not cross for all translations of a box")

    def prove_balls(self, numbers, centre, half):
        """The balls overlap for each translation of the box."""
        need_form(len(numbers) == 2, "there are not two balls")
        (in_a, a, radius), (in_b, b, other) = (self.balls[index(n, self.balls, "ball")] for n in numbers)
        need((in_a, in_b) == (0, 1), "the balls are not of both bodies")
        farthest = [abs(a[k] + centre[k] - b[k]) + half[k] for k in range(3)]
        need(dot(farthest, farthest) < (radius + other) ** 2, "two balls do not overlap for all translations of a box")

    def prove_no_contact(self, node, centre, half):
        """The surfaces share no point for any translation of the box that is shorter than the root of `square`."""
        need_keys(node, "directions cover")
        a, b = self.placed

        def apart(m, of_a, of_b, _):
            gap = b.extent(of_b, m)[0] - a.extent(of_a, m)[1]
            reach = (dot(m, centre) + sum(abs(m[k]) * half[k] for k in range(3))) * self.scale
            is_long = gap > 0 and gap * gap >= self.square * dot(m, m) * self.scale * self.scale
            need(gap > reach or is_long, "two groups meet for a translation of a box")

        prove_cover(node, a.body.root, b.body.root, apart)

    def prove(self, node, centre, half):
        """No translation of the box that is shorter than the root of `square` is on the border. The border is that of the translations after
        which the interiors share a point."""
        if node == "long":
            least = [max(abs(centre[k]) - half[k], 0) for k in range(3)]
            need(dot(least, least) >= self.square, "a box has shorter translations")
        elif isinstance(node, dict) and "balls" in node:
            need_keys(node, "balls")
            self.prove_balls(node["balls"], centre, half)
        elif isinstance(node, dict):
            self.prove_no_contact(node, centre, half)
        elif node[0] in ("x", "y", "z"):
            need_form(len(node) == 3, "a box has not two halves")
            k = "xyz".index(node[0])
            smaller = [h / 2 if i == k else h for i, h in enumerate(half)]
            for side, below in zip((-1, 1), node[1:]):
                self.prove(below, [c + side * smaller[k] if i == k else c for i, c in enumerate(centre)], smaller)
        else:
            need_form(len(node) == 2, "a node of boxes is none")
            self.prove_crossing(*node, centre, half)


def prove_ball(row, placed):
    """The ball is inside the body: its centre is, and the surface is no nearer than its radius. Returns the body, the centre and the
    radius."""
    need_keys(row, "winding radius directions cover")
    ((of, centre), k, winding), = prove_windings({"windings": [row["winding"]]}, placed)
    need(of is None and winding != 0, "the centre of a ball is not inside")
    radius, body = exact(row["radius"]), placed[k]
    scale = on_one_scale(*placed, points=[centre])

    def apart(m, _, group, __):
        gap = body.extent(group, m)[0] - dot(m, centre) * scale
        need(gap > 0 and gap * gap >= radius * radius * dot(m, m) * scale * scale, "a ball is not apart from a group")

    need(radius > 0, "a ball has no inside")
    prove_cover(row, None, body.body.root, apart)
    return k, centre, radius


def prove_low(entry, placed):
    """No translation of A that is shorter than the root of a square parts the interiors. Returns the square."""
    need_keys(entry, "square half boxes balls windings")
    square, half = exact(entry["square"]), exact(entry["half"])
    need(half > 0 and 0 < square <= half * half, "the first box does not hold all shorter translations")
    found = prove_windings(entry, placed)
    need([True, True] in points_in(found), "no point is known to be inside of both")
    balls = [prove_ball(row, placed) for row in entry["balls"]]
    Boxes(placed, square, balls).prove(entry["boxes"], [half * 0] * 3, [half] * 3)
    return square


def prove_before(rows, placed_at, along, first):
    """The interiors share a point for all moves of A along the direction from 0 to before the first.

    No move below `reached` is on the border of such moves; `is_known` says so of `reached` itself."""
    crossings, reached, is_known, is_anchored = Crossings(placed_at(Fraction(0))), Fraction(0), False, False
    for row in rows:
        if "pieces" in row:
            need_keys(row, "pieces")
            need_form(len(row["pieces"]) == 2, "there are not two pieces")
            low, high = crossings.shifts(*row["pieces"], along)
            need(high > reached and (low < reached or low == reached and is_known), "a move is in no row")
            reached, is_known, is_anchored = high, False, True
        elif "at" in row:
            need_keys(row, "at windings")
            need(exact(row["at"]) == reached < first, "a point is about another move")
            need([True, True] in points_in(prove_windings(row, placed_at(reached))), "no point is known to be inside of both")
            is_known = is_anchored = True
        else:
            need_keys(row, "from to directions cover")
            start, end = exact(row["from"]), exact(row["to"])
            least, most = min(start, end), max(start, end)
            need(least < reached or least == reached and (is_known or least == start), "a move is in no row")
            prove_lines(row, placed_at(start), placed_at(end))
            if most > reached:
                reached, is_known = most, most == start
    need(is_anchored and reached >= first, "the rows do not lead to the first exit")
