"""draw_method.py OUT: the pictures of JS08's method from OUT/method.json, as OUT/figures/method_*.svg and .pdf.

Polygons are projected along parallel lines and painted from back to front, so that every figure is made of vectors; a sphere is a circle.
"""

import json
import pathlib
import sys

import numpy as np
import report_style as style
from matplotlib.collections import PatchCollection, PolyCollection
from matplotlib.colors import to_rgb, to_rgba
from matplotlib.patches import Circle

plt = style.plt
LIGHT = np.array([-0.36, -0.48, 0.8])  # of length 1


def camera(azimuth=-55, elevation=24):
    """Rows: right, up, towards the viewer."""
    a, e = np.radians([azimuth, elevation])
    return np.array([[-np.sin(a), np.cos(a), 0], [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)],
                     [np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)]])


class Picture:
    """Collects polygons and paints them from back to front."""

    def __init__(self, axis, title="", **view):
        self.axis, self.view, self.polygons, self.colours, self.edges = axis, camera(**view), [], [], []
        axis.set_aspect("equal")
        axis.axis("off")
        axis.set_title(title)

    def flat(self, points):
        return (np.asarray(points) @ self.view.T)[..., :2]

    def add(self, polygons, colour, alpha=1.0, edge=style.INK, edge_alpha=0.25):
        """polygons: points of each, in one colour, shaded by their normals."""
        for polygon in polygons:
            polygon = np.asarray(polygon, float)
            normal = np.cross(polygon[1] - polygon[0], polygon[2] - polygon[0])
            length = np.linalg.norm(normal)
            lit = 0.65 + 0.35 * abs(normal @ LIGHT) / length if length > 0 else 1
            base = np.array(to_rgb(colour))
            self.polygons.append(polygon)
            self.colours.append((*(base * min(lit, 1)), alpha))
            self.edges.append(to_rgba(edge, edge_alpha))

    def tetrahedra(self, tetrahedra, colour, alpha=1.0, **words):
        """tetrahedra: n x 4 x 3; colour: one, or one each."""
        for i, t in enumerate(tetrahedra):
            each = colour if isinstance(colour, str) else colour[i]
            self.add([t[[0, 1, 2]], t[[0, 2, 3]], t[[0, 3, 1]], t[[1, 3, 2]]], each, alpha, **words)

    def spheres(self, spheres, colours, alpha):
        """Painted at once, over what is there, by the depth of their centres."""
        order = np.argsort([self.view[2] @ s[:3] for s in spheres])
        self.axis.add_collection(PatchCollection([Circle(self.flat(spheres[i][:3]), spheres[i][3]) for i in order], edgecolor=to_rgba(style.INK, 0.5), lw=0.25,
                                                 facecolor=[to_rgba(colours[i], alpha) for i in order]))

    def line(self, points, **words):
        self.axis.plot(*self.flat(points).T, **words)

    def text(self, point, words, **more):
        self.axis.annotate(words, self.flat(point), ha="center", va="center", annotation_clip=False, **more)

    def paint(self):
        order = np.argsort([self.view[2] @ p.mean(axis=0) for p in self.polygons])
        self.axis.add_collection(PolyCollection([self.flat(self.polygons[i]) for i in order], facecolors=[self.colours[i] for i in order],
                                                edgecolors=[self.edges[i] for i in order], lw=0.25, closed=True))
        self.axis.autoscale_view()


class Body:
    """A body of view_data.h as arrays, moved by a pose."""

    def __init__(self, data, pose=None):
        m = np.array(pose or [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], float).reshape(3, 4)
        self.move = lambda p: np.asarray(p, float) @ m[:, :3].T + m[:, 3]
        self.factor = abs(np.linalg.det(m[:, :3])) ** (1 / 3)
        self.vertices = self.move(np.reshape(data["vertices"], (-1, 3)))
        self.origin = self.move(data["covering"]["origin"])
        triangles = np.reshape(data["triangles"], (-1, 4))
        self.face_of, self.triangles = triangles[:, 0], self.vertices[triangles[:, 1:]]
        corners = np.reshape(data["covering"]["triangles"], (-1, 3))
        self.covering_corners, self.signs = corners, np.array(data["covering"]["signs"])
        self.covering = np.concatenate([np.broadcast_to(self.origin, (len(corners), 1, 3)), self.vertices[corners]], axis=1)
        nodes = data["nodes"]
        self.level, self.leaf, self.faces = np.array(nodes["level"]), np.array(nodes["leaf"], bool), nodes["faces"]
        far = self.move(np.reshape(nodes["tetrahedron"], (-1, 3, 3)))
        self.bounding = np.concatenate([np.broadcast_to(self.origin, (len(far), 1, 3)), far], axis=1)
        spheres = np.reshape(nodes["sphere"], (-1, 4))
        self.spheres = np.concatenate([self.move(spheres[:, :3]), spheres[:, 3:] * self.factor], axis=1)
        cones = cones_of(data["hull"]["level"])
        unit = cones / np.linalg.norm(cones, axis=2, keepdims=True)
        self.hull = self.move(np.array(data["covering"]["origin"]) + unit * data["hull"]["dmax"])

    def at(self, level):
        return (self.level == level) | ((self.level < level) & self.leaf)

    def reference(self, point):
        """The hull's triangle in whose cone the point lies (Definition 8)."""
        shares = np.linalg.solve(np.transpose(self.hull - self.origin, (0, 2, 1)), np.broadcast_to(point - self.origin, (len(self.hull), 3))[..., None])[..., 0]
        return self.hull[np.argmax(shares.min(axis=1))]


def cones_of(level):
    cones = np.array([[[0, 0, z], [x, 0, 0], [0, y, 0]] for x in (1, -1) for y in (1, -1) for z in (1, -1)], float)
    for _ in range(level - 1):
        a, b, c = cones[:, 0], cones[:, 1], cones[:, 2]
        ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
        cones = np.concatenate([np.stack(child, axis=1) for child in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return cones


def hues(count, base=style.SKY):
    """As many shades about a colour, neighbours apart."""
    base = np.array(to_rgb(base))
    return [tuple(np.clip(base + 0.22 * (np.array([(i * 0.618) % 1, (i * 0.382) % 1, (i * 0.271) % 1]) - 0.5), 0, 1)) for i in range(count)]


def shrunk(tetrahedra, share):
    centre = tetrahedra.mean(axis=1, keepdims=True)
    return centre + share * (tetrahedra - centre)


def row(count, height=2.2):
    figure, axes = plt.subplots(1, count, figsize=(style.WIDTH, height))
    return figure, np.atleast_1d(axes)


def covering(data, out):
    """Figure 1: a face's covering and its triangulation; the covering of a polyhedron."""
    body, faces = Body(data["faces"]["bodies"][0]), data["faces"]["bodies"][0]["faces"]
    face = max(range(len(faces)), key=lambda f: sum(map(len, faces[f])))
    of_face = [i for i, t in enumerate(body.triangles) if body.face_of[i] == face]
    normal = sum(np.cross(t[1] - t[0], t[2] - t[0]) for t in body.triangles[of_face])
    axes = np.linalg.svd(normal[None] / np.linalg.norm(normal))[2][1:]
    flat = lambda points: np.asarray(points) @ axes.T
    figure, (left, middle, right) = row(3)
    w, starts = faces[face][0][0], [(a, loop[(k + 1) % len(loop)]) for loop in faces[face] for k, a in enumerate(loop)]
    turn = np.sign(np.linalg.det(np.vstack([axes, normal])))
    for a, b in starts:
        p = flat(body.vertices[[w, a, b]])
        area = turn * ((p[1, 0] - p[0, 0]) * (p[2, 1] - p[0, 1]) - (p[1, 1] - p[0, 1]) * (p[2, 0] - p[0, 0]))
        if area:
            left.add_patch(plt.Polygon(p, fc=to_rgba(style.SKY if area > 0 else style.VERMILION, 0.35), ec=to_rgba(style.INK, 0.5), lw=0.5))
    left.plot(*flat(body.vertices[w]), "o", color=style.INK, ms=3)
    for t in body.triangles[of_face]:
        middle.add_patch(plt.Polygon(flat(t), fc=to_rgba(style.SKY, 0.5), ec=to_rgba(style.INK, 0.5), lw=0.5))
    for axis, title in ((left, "covering of a face: + blue, $-$ red"), (middle, "its triangulation")):
        axis.set_aspect("equal"), axis.axis("off"), axis.autoscale_view(), axis.set_title(title)
    picture = Picture(right, "covering of the polyhedron, shrunk")
    for sign, colour in ((1, style.SKY), (-1, style.VERMILION)):
        picture.tetrahedra(shrunk(body.covering[body.signs == sign], 0.75), colour)
    picture.paint()
    save(figure, out, "covering")


def cone(data, out):
    """Figures 2 and 3: a tetra-cone, and its four children."""
    figure, axes = row(2)
    parent = cones_of(1)[0]
    for axis, cones, title in ((axes[0], [parent], "a tetra-cone"), (axes[1], children(parent), "its four children")):
        picture = Picture(axis, title, azimuth=35, elevation=22)
        picture.tetrahedra([np.vstack([[0, 0, 0], 1.0 * c]) for c in cones], [style.SKY, style.GREEN, style.YELLOW, style.ORANGE][:len(cones)], 0.45, edge_alpha=0.8)
        picture.paint()
        for ray, name in zip(parent, ("$V_1$", "$V_2$", "$V_3$")):
            picture.line([ray, 1.35 * ray], color=style.INK, lw=0.7, ls="--")
            picture.text(1.45 * ray, name)
        picture.text([0.02, -0.02, -0.12], "$V_0$")
    for axis in axes:
        axis.title.set_y(1.12)
    save(figure, out, "cone")


def children(c):
    a, b, d = (c[0] + c[1]) / 2, (c[1] + c[2]) / 2, (c[2] + c[0]) / 2
    return [np.array(child) for child in ((c[0], a, d), (a, c[1], b), (d, b, c[2]), (a, b, d))]


def classification(data, out):
    """Figure 6: how a tetrahedron S stands to a tetra-cone T. Each kind is shown by the first random S that is clear to see."""
    def kind(s):
        if (s > 0).all(axis=1).any():
            return 0
        if (np.linalg.solve(s.T, np.eye(3)) > 0.05).all(axis=0).any():
            return 1
        along = np.linspace(0, 1, 60)[:, None, None]
        edges = (1 - along) * s + along * np.roll(s, -1, axis=0)
        # Clearly in or clearly out.
        depth = edges.min(axis=2).max()
        return 2 if depth > 0.12 else 3 if depth < -0.1 else None

    random, found = np.random.default_rng(7), {}
    while len(found) < 4:
        s = random.normal(size=(3, 3))
        s *= random.uniform(0.7, 1.1, (3, 1)) / np.linalg.norm(s, axis=1, keepdims=True)
        if abs(np.linalg.det(s)) > 0.25 and s.sum() > 0 and kind(s) is not None:
            found.setdefault(kind(s), s)
    figure, axes = row(4)
    titles = ("(a) a vertex of S in T", "(b) a ray of T in S", "(c) edges of S cross T", "(d) not classified")
    for k, (axis, title) in enumerate(zip(axes, titles)):
        picture = Picture(axis, title, azimuth=35, elevation=22)
        picture.tetrahedra([np.vstack([[0, 0, 0], cones_of(1)[0]])], style.SKY, 0.3, edge_alpha=0.9)
        picture.tetrahedra([np.vstack([[0, 0, 0], found[k]])], style.ORANGE, 0.45, edge_alpha=0.9)
        picture.paint()
    save(figure, out, "classification")


def levels(data, out):
    """Figure 5: the tetrahedra of a cone of levels 1, 2 and 3."""
    body, path = Body(data["pair"]["bodies"][0]), data["path"][:3]
    figure, axes = row(len(path))
    for axis, (level, step) in zip(axes, enumerate(path, 1)):
        picture = Picture(axis, f"level {level}: {len(step['tetrahedra'])} tetrahedra")
        picture.add(body.triangles, style.GREY, 0.06, edge_alpha=0.05)
        picture.tetrahedra(body.covering[step["tetrahedra"]], hues(len(step["tetrahedra"])), 0.8)
        picture.paint()
        rays = np.array(step["rays"], float)
        for ray in rays / np.linalg.norm(rays, axis=1, keepdims=True):
            picture.line([body.origin, body.origin + 1.1 * np.linalg.norm(body.vertices - body.origin, axis=1).max() * ray], color=style.VERMILION, lw=0.8)
    save(figure, out, "levels")


def bounding(data, out):
    """Figures 7 and 10: what one cone bounds; 9 and 11: bounding tetrahedra and spheres of the levels; 12: the regular hull."""
    body = Body(data["pair"]["bodies"][0])
    step = data["path"][min(1, len(data["path"]) - 1)]
    figure, axes = row(3)
    for axis, title in ((axes[0], "bounding tetrahedron of a cone"), (axes[1], "bounding sphere of a cone"), (axes[2], "regular hull")):
        picture = Picture(axis, title)
        if axis is axes[2]:
            picture.add(body.triangles, style.SKY)
            picture.add(body.hull, style.ORANGE, 0.08, edge=style.ORANGE, edge_alpha=0.5)
            picture.paint()
            continue
        picture.tetrahedra(body.covering[step["tetrahedra"]], style.SKY, 0.7)
        if axis is axes[0]:
            picture.tetrahedra(body.bounding[[step["node"]]], style.ORANGE, 0.2, edge=style.VERMILION, edge_alpha=1)
        picture.paint()
        if axis is axes[1]:
            picture.spheres(body.spheres[[step["node"]]], [style.ORANGE], 0.25)
            axis.autoscale_view()
    save(figure, out, "bounds")

    deepest = int(body.level.max())
    for name, chosen in (("tetrahedra", range(max(1, deepest - 3), deepest + 1)), ("spheres", range(max(1, deepest - 2), deepest + 1))):
        figure, axes = row(len(chosen))
        for axis, level in zip(axes, chosen):
            picture = Picture(axis, f"level {level}: {body.at(level).sum()} {name}")
            if name == "tetrahedra":
                picture.tetrahedra(body.bounding[body.at(level)], hues(body.at(level).sum()), 0.9)
                picture.paint()
            else:
                picture.spheres(body.spheres[body.at(level)], hues(body.at(level).sum(), style.ORANGE), 0.85)
                axis.autoscale_view()
        save(figure, out, name)


def theorem(data, out):
    """Figures 13 and 14: the reference bounding tetrahedra, what Theorem 2 discards, and what is left for the leaf tests."""
    pair = data["pair"]
    a, b = (Body(pair["bodies"][k], pair["poses"][k][0]) for k in (0, 1))
    leaves = [np.array(pair["left"][0][k], int) for k in (0, 1)]
    figure, axes = plt.subplots(1, 3, figsize=(style.WIDTH, 2.6))
    pictures = [Picture(axis, title, azimuth=view_across(a.origin, b.origin)) for axis, title in
                zip(axes, ("reference bounding tetrahedra", "Theorem 2: discarded in green", "leaves left to test"))]
    references, discarded = Picture(axes[0], azimuth=view_across(a.origin, b.origin)), 0  # within the bodies: painted over them
    for me, other, left, colour in ((a, b, leaves[0], style.SKY), (b, a, leaves[1], style.BLUE)):
        pictures[0].add(me.triangles, colour)
        pictures[0].add(me.hull, colour, 0.04, edge=colour, edge_alpha=0.3)
        references.tetrahedra([np.vstack([me.origin, me.reference(other.origin)])], style.VERMILION, 1, edge=style.VERMILION, edge_alpha=1)
        triangle = other.reference(me.origin)
        normal = np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
        normal *= np.sign(normal @ (triangle[0] - other.origin))
        beyond = ((me.bounding - triangle[0]) @ normal > 0).all(axis=1) & me.leaf
        discarded += beyond.sum()
        kept = me.leaf & ~beyond
        pictures[1].tetrahedra(me.bounding[beyond], style.GREEN, 0.35, edge_alpha=0.1)
        pictures[1].tetrahedra(me.bounding[kept], style.ORANGE, 0.9)
        pictures[2].add(me.triangles, colour, 0.25, edge_alpha=0.08)
        pictures[2].tetrahedra(me.bounding[left], style.ORANGE, 0.9)
    for picture in (*pictures, references):
        picture.paint()
    axes[0].set_title("reference bounding tetrahedra (red)")
    axes[1].set_title(f"Theorem 2 discards {discarded} of {a.leaf.sum() + b.leaf.sum()} leaves (green)")
    axes[2].set_title(f"left to test: {len(leaves[0])} and {len(leaves[1])} leaves")
    save(figure, out, "theorem_2")


def view_across(p, q):
    """The azimuth from which a line from p to q runs across the picture."""
    return float(np.degrees(np.arctan2(q[1] - p[1], q[0] - p[0]))) - 90


def save(figure, out, name):
    figure.tight_layout(pad=0.3)
    box = style.box_of(figure)
    for ending in ("svg", "pdf"):
        figure.savefig(out / f"method_{name}.{ending}", bbox_inches=box, metadata={"Date": None} if ending == "svg" else {"CreationDate": None})
    plt.close(figure)


def main():
    out = pathlib.Path(sys.argv[1])
    data = json.loads((out / "method.json").read_text())
    (out / "figures").mkdir(exist_ok=True)
    style.set_style()
    for draw in (covering, cone, classification, levels, bounding, theorem):
        draw(data, out / "figures")


if __name__ == "__main__":
    main()
