"""Vectors and planar faces, in integers."""


def times(v, factor):
    return tuple(int(x * factor) for x in v)


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1], p[2] - q[2])


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


# Faces: lists of loops of vertices; `at` has the place of each vertex


def edges(loops):
    return [(loop[k - 1], loop[k]) for loop in loops for k in range(len(loop))]


def area_vector(loop):
    """Twice the area of a loop of points, times the normal about which it turns to the left."""
    turns = [cross(loop[k - 1], loop[k]) for k in range(len(loop))]
    return tuple(sum(turn[i] for turn in turns) for i in range(3))


def normal_of(loops, at):
    """A normal of the plane of a face; None where its corners are on a line."""
    corners = [at[v] for loop in loops for v in loop]
    p = corners[0]
    q = next((x for x in corners if x != p), p)
    return next((n for x in corners if any(n := cross(minus(q, p), minus(x, p)))), None)


def is_planar(loops, at):
    normal, p = normal_of(loops, at), at[loops[0][0]]
    return normal is None or not any(dot(normal, minus(at[v], p)) for loop in loops for v in loop)


def is_between(p, q):
    """The origin is on the segment from p to q."""
    return not any(cross(p, q)) and dot(p, q) <= 0


def winding_about(sides, normal):
    """The winding number of edges in a plane through the origin about the origin, or None where the origin is on one.

    Projected along axis k, it is the number of edges that cross the half-axis i: upwards less downwards."""
    k = next(k for k in range(3) if normal[k])
    i, j = (k + 1) % 3, (k + 2) % 3
    count = 0
    for p, q in sides:
        if is_between(p, q):
            return None
        turn = p[i] * q[j] - p[j] * q[i]
        count += (p[j] <= 0 < q[j] and turn > 0) - (q[j] <= 0 < p[j] and turn < 0)
    return count if normal[k] > 0 else -count


def loops_hold(loops, at, x):
    """x is on an edge, or in the plane of the loops with a winding number other than 0."""
    sides = [(minus(at[p], x), minus(at[q], x)) for p, q in edges(loops)]
    normal = normal_of(loops, at)
    if normal is None:
        return any(is_between(p, q) for p, q in sides)
    return dot(normal, sides[0][0]) == 0 and winding_about(sides, normal) != 0


def crossing(loops, at, origin, way):
    """How often the loops wind about the point where the ray crosses their plane, seen along the ray.

    None where the ray is parallel to the plane, leads away from it or meets an edge."""
    normal = normal_of(loops, at)
    if normal is None or dot(normal, way) == 0:
        return None
    if dot(normal, way) < 0:
        normal = minus((0, 0, 0), normal)
    slope, height = dot(normal, way), dot(normal, minus(at[loops[0][0]], origin))
    if height <= 0:
        return None
    # The crossing is origin + height / slope * way. Corners are seen from it, times the slope.
    seen = {v: minus([slope * x for x in minus(at[v], origin)], [height * x for x in way]) for loop in loops for v in loop}
    return winding_about([(seen[p], seen[q]) for p, q in edges(loops)], normal)
