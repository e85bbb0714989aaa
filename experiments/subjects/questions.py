#!/usr/bin/env python3
"""A subject that takes every kind of question: textbook formulas over all pairs of triangles, in double. Motions that turn are declined."""

import json
import math
import sys
import time
from fractions import Fraction


def sub(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def along(p, t, d):
    return p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]


def edges(t):
    return (t[0], t[1]), (t[1], t[2]), (t[2], t[0])


def ray_triangle(p, d, t):
    """Where p + s d meets the triangle; nothing beside it and in its plane."""
    u, v = sub(t[1], t[0]), sub(t[2], t[0])
    n = cross(d, v)
    volume = dot(u, n)
    if volume == 0:
        return None
    w = sub(p, t[0])
    x, y = dot(w, n) / volume, dot(d, cross(w, u)) / volume
    return dot(v, cross(w, u)) / volume if x >= 0 and y >= 0 and x + y <= 1 else None


def point_segment(p, a, b):
    d = sub(b, a)
    t = min(1, max(0, dot(sub(p, a), d) / (dot(d, d) or 1)))
    return math.dist(p, along(a, t, d))


def point_triangle(p, t):
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    if dot(n, n) > 0 and all(dot(cross(sub(b, a), sub(p, a)), n) >= 0 for a, b in edges(t)):
        return abs(dot(sub(p, t[0]), n)) / math.sqrt(dot(n, n))
    return min(point_segment(p, a, b) for a, b in edges(t))


def segment_segment(a, b, c, d):
    u, v, w = sub(b, a), sub(d, c), sub(a, c)
    n = cross(u, v)
    ends = min(point_segment(a, c, d), point_segment(b, c, d), point_segment(c, a, b), point_segment(d, a, b))
    if dot(n, n) == 0:
        return ends
    s, r = dot(cross(v, w), n) / dot(n, n), dot(cross(u, w), n) / dot(n, n)
    return abs(dot(w, n)) / math.sqrt(dot(n, n)) if 0 <= s <= 1 and 0 <= r <= 1 else ends


def crosses(a, b, t):
    s = ray_triangle(a, sub(b, a), t)
    return s is not None and 0 <= s <= 1


def triangle_distance(s, t):
    if any(crosses(*e, t) for e in edges(s)) or any(crosses(*e, s) for e in edges(t)):
        return 0
    return min(min(point_triangle(p, t) for p in s), min(point_triangle(p, s) for p in t),
               min(segment_segment(*e, *f) for e in edges(s) for f in edges(t)))


def inside(triangles, p):
    """1, 0 or -1, by the sum of the solid angles."""
    if min(point_triangle(p, t) for t in triangles) == 0:
        return 0
    angle = 0
    for t in triangles:
        a, b, c = (sub(v, p) for v in t)
        x, y, z = (math.sqrt(dot(v, v)) for v in (a, b, c))
        angle += math.atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y)
    return 1 if round(angle / (2 * math.pi)) else -1


def distance(a, b, of):
    if of == "solid" and (inside(a, b[0][0]) > 0 or inside(b, a[0][0]) > 0):
        return 0
    return min(triangle_distance(s, t) for s in a for t in b)


def boxes_apart(a, b):
    """True when the bodies' boxes share no point; large bodies are then not compared."""
    points = [[p for t in body for p in t] for body in (a, b)]
    low, high = ([[f(p[k] for p in body) for k in range(3)] for body in points] for f in (min, max))
    return any(low[0][k] > high[1][k] or low[1][k] > high[0][k] for k in range(3))


def relation(a, b):
    if boxes_apart(a, b):
        return "apart"
    if distance(a, b, "surface") == 0:
        return "surfaces"
    return "a_in_b" if inside(b, a[0][0]) > 0 else "b_in_a" if inside(a, b[0][0]) > 0 else "apart"


def edges_meet_at(a, b, c, d, way):
    """When the second edge, moving by `way`, meets the first one."""
    u, v, w = sub(b, a), sub(d, c), sub(a, c)
    n = cross(u, v)
    if dot(way, n) == 0:
        return None
    t = dot(w, n) / dot(way, n)
    w = sub(w, along((0, 0, 0), t, way))
    s, r = dot(cross(v, w), n) / dot(n, n), dot(cross(u, w), n) / dot(n, n)
    return t if 0 <= s <= 1 and 0 <= r <= 1 else None


def first_contact(a, b, of, way):
    """The first t in [0, 1] at which b, moved by t `way`, meets a."""
    if distance(a, b, of) == 0:
        return 0
    back = tuple(-x for x in way)
    times = [ray_triangle(p, way, s) for s in a for t in b for p in t] + [ray_triangle(p, back, t) for s in a for t in b for p in s]
    times += [edges_meet_at(*e, *f, way) for s in a for t in b for e in edges(s) for f in edges(t)]
    return min((t for t in times if t is not None and 0 <= t <= 1), default=None)


def numbers(pose):
    return [float(Fraction(x)) if isinstance(x, str) else x for x in pose]


def placed(body, pose):
    m = numbers(pose)
    image = [tuple(dot(m[4 * i:4 * i + 3], v) + m[4 * i + 3] for i in range(3)) for v in body["vertices"]]
    return [[image[k] for k in t] for t in body["triangles"]]


def answer(m):
    if m["question"] == "triangles":
        s, t = ([tuple(numbers(p)) for p in m[key]] for key in ("triangle_a", "triangle_b"))
        return {"answer": int(triangle_distance(s, t) == 0)}
    body, question = bodies[m["a"]], m["question"]
    if any("triangles" not in bodies[m[k]] for k in "ab" if k in m):
        return {"answer": None}
    if question == "inside":
        return {"answer": inside([[body["vertices"][k] for k in t] for t in body["triangles"]], m["point"])}
    if question == "ray":
        times = (ray_triangle(m["origin"], m["direction"], [body["vertices"][k] for k in t]) for t in body["triangles"])
        first = min((t for t in times if t is not None and t >= 0), default=None)
        return {"answer": 0} if first is None else {"answer": 1, "t": first}
    a, b = placed(body, m["pose_a"]), placed(bodies[m["b"]], m["pose_b"])
    if question == "relation":
        return {"answer": relation(a, b)}
    if question == "distance":
        return {"answer": distance(a, b, m["of"])}
    if question == "within":
        return {"answer": int(distance(a, b, m["of"]) <= numbers([m["limit"]])[0])}
    if question == "first contact":
        shift = []
        for key in "ab":
            start, end = numbers(m["pose_" + key]), numbers(m["end_" + key])
            if any(start[k] != end[k] for k in range(12) if k % 4 < 3):
                return {"answer": None}
            shift.append([end[k] - start[k] for k in (3, 7, 11)])
        t = first_contact(a, b, m["of"], sub(shift[1], shift[0]))
        return {"answer": 0} if t is None else {"answer": 1, "t": t}
    return {"answer": int(relation(a, b) != "apart" if question == "solid" else relation(a, b) == "surfaces")}


bodies = {}
print(json.dumps({"hello": 1, "name": "Questions", "version": "1", "precision": "float64", "bodies": "closed",
                  "questions": ["relation", "within", "distance", "inside", "ray", "first contact", "triangles"]}), flush=True)
for line in sys.stdin:
    message = json.loads(line)
    if "model" in message:
        bodies[message["model"]] = message
    bodies.pop(message.get("forget"), None)
    if "ask" in message:
        start = time.perf_counter_ns()
        told = answer(message)
        print(json.dumps({"ask": message["ask"], **told, "ns": time.perf_counter_ns() - start}), flush=True)
