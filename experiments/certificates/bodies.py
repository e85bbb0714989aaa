"""Bodies of a certificate: their pieces, groups and shells, and where a pose places them. README.md has the format.

Coordinates are integers: those of all bodies are multiplied by one common denominator, the `scale`."""
from math import lcm

from geometry import cross, dot, edges, is_planar, loops_hold, times
from reading import given, index, need, need_form, need_keys, read_model, vector


class Group:
    """Pieces of a body, by their numbers. `members` are smaller groups that together have all of them."""

    def __init__(self, pieces, corners, least_face, members=None):
        self.pieces, self.corners, self.least_face, self.members = pieces, corners, least_face, members


def numbers(steps, size):
    """Ascending numbers below the size, from their steps; the first from -1. -n stands for n steps of 1."""
    found = [-1]
    for step in steps:
        need_form(type(step) is int and -size <= step <= size and step, "a step is none")
        found += range(found[-1] + 1, found[-1] + 1 - step) if step < 0 else [found[-1] + step]
        need_form(len(found) <= size + 1, "there are more steps than pieces")
    return found[1:]


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
            need_form(isinstance(entry["file"], str), "a file has no name")
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
            corners = {v for loop in loops for v in loop}
            need(not parts or all(v in corners for part in parts for v in part), f"a triangle of face {f} has a corner that is none of the face's")
            need(not parts or balance(edges(loops)) == balance(edges(parts)), f"the triangles of face {f} have another boundary")
            if not self.is_flat[f]:  # the triangles are the face
                need(len(parts) <= sum(map(len, loops)) + 2 * len(loops) - 4, f"face {f} has more triangles than it takes")
                need({cycle(part) for part in parts}.isdisjoint(cycle(part[::-1]) for part in parts), f"two triangles of face {f} cancel")
            held = {frozenset(e) for e in edges(parts or [])} | {frozenset([v]) for part in parts or [] for v in part}
            need(not parts or {frozenset(e) for e in edges(loops)} <= held, f"face {f} has an edge without a triangle")

    def group(self, entry):
        if isinstance(entry, dict):
            need_keys(entry, "steps")
            return self.group(numbers(entry["steps"], len(self.pieces)))
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


def cycle(triangle):
    """Its corners from the least on."""
    k = triangle.index(min(triangle))
    return tuple(triangle[k:] + triangle[:k])


def given_pose(texts):
    pose = vector(texts, given, 12)
    need_form(dot(cross(pose[0:3], pose[4:7]), pose[8:11]) != 0, "a pose is flat")
    return pose


class Placed:
    """The corners of a placed body times `scale`, and the extent of its groups along directions."""

    def __init__(self, body, pose=None):
        self.body, self.pose, self.at, self.scale, self.known = body, pose, body.at, body.scale, {}
        if pose:
            factor = lcm(*(x.denominator for x in pose))
            rows = [times(pose[k:k + 3], factor) for k in (0, 4, 8)]
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


def shapes(placed):
    """How often each face is there, as its loops by the places of corners. A face that is not planar is its triangles."""
    body, count = placed.body, {}
    for f, loops in enumerate(body.faces):
        for shape in [loops] if body.is_flat[f] else [piece for face, piece in body.pieces if face == f]:
            corners = [[placed.at[v] for v in loop] for loop in shape]
            key = tuple(sorted(min(tuple(loop[k:] + loop[:k]) for k in range(len(loop))) for loop in corners))
            count[key] = count.get(key, 0) + 1
    return count
