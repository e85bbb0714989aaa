#!/usr/bin/env python3
"""Proves the distances of a certificate that `tetracone distance --certificate FILE` has written, in fractions.

  check_certificate.py FILE [A B] [--pose-a FILE] [--pose-b FILE]
      prints the squared distance of each answer; status 1 where something is not proved. A certificate has its bodies
      and poses in itself: with A and B, OFF or OBJ files of planar faces, and poses it must be about these.

Above: the two points are in the bodies, and so far apart. Below: each face is covered by its pieces, and every pair of
a piece of A and one of B is in a part of the cover whose axis separates it by the distance. Of solids also: where they
are apart, no vertex of one is inside the other."""
import argparse
import json
import re
import sys
from fractions import Fraction as F


def need(holds, what):
    if not holds:
        raise ValueError(what)


def number(text):
    """Integers and fractions alone: no NaN, no infinity, no decimal that was rounded, no exponent without end."""
    need(isinstance(text, str) and re.fullmatch("-?[0-9]+(/[0-9]+)?", text), "a number is no fraction")
    return F(text)


def vector(texts):
    need(isinstance(texts, list) and len(texts) == 3, "a point or an axis has not three numbers")
    return [number(x) for x in texts]


def need_indices(numbers, count, what):
    need(isinstance(numbers, list) and all(type(n) is int and 0 <= n < count for n in numbers), what)


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def minus(p, q):
    return [x - y for x, y in zip(p, q)]


def cross(p, q):
    return [p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2] for i in range(3)]


def edges(loops):
    return [(loop[k - 1], loop[k]) for loop in loops for k in range(len(loop))]


def normal_of(body, loops):
    """Of the plane of the face; None where its corners are on a line."""
    at = [body["at"][v] for loop in loops for v in loop]
    p, q = at[0], next((x for x in at if x != at[0]), at[0])
    normal = next((n for x in at if any(n := cross(minus(q, p), minus(x, p)))), None)
    need(normal is None or not any(dot(normal, minus(x, p)) for x in at), "a face is not planar")
    return normal


def check_pieces(body):
    """The pieces of a face are in its plane and have its loops as their boundary, so that they are where its winding number is not 0, and its edges."""
    need_indices([p["face"] for p in body["pieces"]], len(body["faces"]), "a piece is of no face")
    for f, loops in enumerate(body["faces"]):
        need(loops and all(loops), "a face has no vertex")
        for loop in loops:
            need_indices(loop, len(body["vertices"]), "a face has no such vertex")
        pieces = [p["corners"] for p in body["pieces"] if p["face"] == f]
        need(all(any(v in loop for loop in loops) for p in pieces for v in p), "a piece has a corner that its face has not")
        normal_of(body, loops)
        whole = edges(loops)
        sides = {frozenset(e) for p in pieces for e in edges([p])}
        need(all(frozenset(e) in sides for e in whole), f"face {f} has an edge without a piece")
        flat = [p for p in pieces if len(p) == 3]
        count = {}
        for sign, (x, y) in [(1, e) for e in whole] + [(-1, e) for p in flat for e in edges([p])]:
            if x != y:
                count[min(x, y), max(x, y)] = count.get((min(x, y), max(x, y)), 0) + (sign if x < y else -sign)
        on_line = all(not any(cross(minus(body["at"][y], body["at"][x]), minus(body["at"][z], body["at"][x]))) for x, y in whole for z, _ in whole)
        need(on_line or not any(count.values()), f"face {f} is not what its pieces cover")


def in_piece(x, corners):
    """In a segment's or a triangle's hull."""
    if len(corners) == 3 and any(normal := cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))):
        turns = [dot(normal, cross(minus(corners[k - 1], x), minus(corners[k], x))) for k in range(3)]
        return dot(normal, minus(x, corners[0])) == 0 and min(turns) >= 0
    return any(not any(cross(minus(q, p), minus(x, p))) and dot(minus(x, p), minus(x, q)) <= 0 for p in corners for q in corners)


def winding(x, body):
    """Of a point off the surface: signed crossings of a ray that meets no piece's border; one of (1, s, s^2) does not."""
    flat = [[body["at"][v] for v in p["corners"]] for p in body["pieces"] if len(p["corners"]) == 3]
    need(not any(in_piece(x, t) for t in flat), "a point is on the surface, which was said to be off it")
    s = F(1, 3)
    while True:
        s, total = s + F(5, 7), 0
        for t in ([minus(v, x) for v in t] for t in flat):
            turns = [dot([1, s, s * s], cross(t[k - 1], t[k])) for k in range(3)]
            if any(turns) and (min(turns) >= 0 or max(turns) <= 0):
                if 0 in turns:
                    break
                volume = dot(cross(t[0], t[1]), t[2])
                total += ((volume > 0) - (volume < 0)) * ((volume > 0) == (turns[0] > 0))
        else:
            return total


def is_closed(body):
    count = {}
    for loops in body["faces"]:
        for x, y in edges(loops):
            count[min(x, y), max(x, y)] = count.get((min(x, y), max(x, y)), 0) + ((x < y) - (x > y))
    return not any(count.values())


def in_face(body, loops, x):
    """On an edge, or in the plane with a winding number of the loops that is not 0."""
    ends = [(body["at"][p], body["at"][q]) for p, q in edges(loops)]
    if any(in_piece(x, pair) for pair in ends):
        return True
    normal = normal_of(body, loops)
    if normal is None or dot(normal, minus(x, ends[0][0])):
        return False
    axis = next(k for k in range(3) if normal[k])
    i, j = (axis + 1) % 3, (axis + 2) % 3
    total = 0
    for p, q in ends:
        turn = (q[i] - p[i]) * (x[j] - p[j]) - (q[j] - p[j]) * (x[i] - p[i])
        total += (p[j] <= x[j] < q[j] and turn > 0) - (q[j] <= x[j] < p[j] and turn < 0)
    return total != 0


def holds(body, holder, x):
    kind, *numbers = holder.split()
    if kind == "interior":
        return winding(x, body) != 0
    if kind == "vertex":
        v = int(numbers[0])
        return any(v in loop for loops in body["faces"] for loop in loops) and x == body["at"][v]
    if kind == "edge":
        pair = tuple(int(v) for v in numbers)
        return any(pair in edges(loops) for loops in body["faces"]) and in_piece(x, [body["at"][v] for v in pair])
    return kind == "face" and 0 <= int(numbers[0]) < len(body["faces"]) and in_face(body, body["faces"][int(numbers[0])], x)


def check_cover(bodies, answer, square):
    ends = [[p["corners"] for p in body["pieces"]] for body in bodies]
    seen, every = [0] * len(ends[0]), (1 << len(ends[1])) - 1
    for part in answer["cover"]:
        axis = vector(part["axis"])
        for k in range(2):
            need(part["ab"[k]], "a part of the cover is empty")
            need_indices(part["ab"[k]], len(ends[k]), "a part of the cover has no such piece")
        along = [{dot(axis, bodies[k]["at"][v]) for n in part["ab"[k]] for v in ends[k][n]} for k in range(2)]
        gap = min(along[1]) - max(along[0])
        need(gap > 0 and gap * gap >= square * dot(axis, axis), "a part of the cover is not as far apart")
        bits = sum(1 << n for n in set(part["b"]))
        for n in part["a"]:
            seen[n] |= bits
    need(all(bits == every for bits in seen), "a pair of pieces is in no part of the cover")


def check(certificate, answer):
    bodies = [certificate["a"], certificate["b"]]
    solid = {"solid": True, "surface": False}[certificate["question"]]
    for body, pose in zip(bodies, (answer["pose_a"], answer["pose_b"])):
        m = [number(x) for x in pose]
        need(len(m) == 12 and dot(cross(m[0:3], m[4:7]), m[8:11]) != 0, "a pose is flat")
        body["at"] = [[dot(m[4 * i:4 * i + 3], v) + m[4 * i + 3] for i in range(3)] for v in map(vector, body["vertices"])]
        check_pieces(body)
        need(not solid or is_closed(body), "a body is not closed")
    square, points = number(answer["squared_distance"]), [vector(p) for p in answer["points"]]
    need(len(points) == 2 and len(answer["holders"]) == 2, "there are not two points")
    need(dot(minus(*points), minus(*points)) == square, "the points are not that far apart")
    for body, holder, x in zip(bodies, answer["holders"], points):
        need(solid or holder != "interior", "a surface has no interior")
        need(holds(body, holder, x), f"{holder} does not hold its point")
    if square == 0:
        return square
    check_cover(bodies, answer, square)
    if solid:
        for body, other in (bodies, bodies[::-1]):
            used = {v for loops in body["faces"] for loop in loops for v in loop}
            shell = {v: v for v in used}

            def root(v):
                while shell[v] != v:
                    v = shell[v]
                return v

            for loops in body["faces"]:
                for p, q in edges(loops):
                    shell[root(p)] = root(q)
            need(all(winding(body["at"][v], other) == 0 for v in used if shell[v] == v), "one solid holds a part of the other")
    return square


def model(path):
    """The vertices and faces of an OFF or OBJ file, as a certificate has them."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split("#")[0].split() for line in file]
    exact = lambda words: [str(F(float(x))) for x in words]
    if path.lower().endswith(".obj"):
        vertices = [exact(words[1:4]) for words in lines if words[:1] == ["v"]]
        index = lambda word: int(word.split("/")[0]) - 1 if not word.startswith("-") else len(vertices) + int(word.split("/")[0])
        return vertices, [[[index(w) for w in words[1:]]] for words in lines if words[:1] == ["f"]]
    words = [word for line in lines for word in line]
    need(words and words.pop(0) == "OFF", f"{path} is no OFF or OBJ file")
    count, faces, at = int(words[0]), [], 3 + 3 * int(words[0])
    for _ in range(int(words[1])):
        n = int(words[at])
        faces.append([[int(w) for w in words[at + 1:at + 1 + n]]])
        at += 1 + n
    return [exact(words[3 + 3 * k:6 + 3 * k]) for k in range(count)], faces


def poses(path):
    if not path:
        return [[F(k % 5 == 0) for k in range(12)]]
    with open(path, encoding="utf-8") as file:
        lines = [line.split("#")[0].split() for line in file]
    return [[F(x) if "/" in x else F(float(x)) for x in words] for words in lines if words]


def need_asked(certificate, asked):
    """The certificate is about these files."""
    answers = certificate["answers"]
    for k in range(len(asked.models)):
        body = certificate["ab"[k]]
        need((body["vertices"], body["faces"]) == model(asked.models[k]), f"it is not about {asked.models[k]}")
    for name, path in (("pose_a", asked.pose_a), ("pose_b", asked.pose_b)):
        if not (asked.models or path):
            continue
        expected = poses(path)
        need(len(expected) in (1, len(answers)), "there are not as many answers as poses")
        for k, answer in enumerate(answers):
            need([number(x) for x in answer[name]] == expected[k % len(expected)], f"answer {k} is not of the {name} asked")


def of_one_meaning(pairs):
    need(len(dict(pairs)) == len(pairs), "a key is there twice")
    return dict(pairs)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    parser.add_argument("models", nargs="*")
    parser.add_argument("--pose-a")
    parser.add_argument("--pose-b")
    asked = parser.parse_args()
    if len(asked.models) not in (0, 2):
        parser.error("expected no model or two")
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)  # coordinates of any length are exact
    try:
        with open(asked.file, encoding="utf-8") as file:
            certificate = json.load(file, object_pairs_hook=of_one_meaning)
        need(isinstance(certificate["answers"], list) and certificate["answers"], "no answer")
        need_asked(certificate, asked)
        for answer in certificate["answers"]:
            print(check(certificate, answer))
    except (ValueError, KeyError, IndexError, TypeError, AttributeError, ArithmeticError, RecursionError, OSError) as error:
        sys.exit(f"check_certificate.py: not proved: {error}")


if __name__ == "__main__":
    main()
