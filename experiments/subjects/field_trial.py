"""The field's own cases, made and judged here: no program of ours is needed. `rounded.py` decides them in integers, without rounding anything."""

import concurrent.futures
import functools
import json
import math
import os
import random
from fractions import Fraction

import field_cases
import rounded

SIZES, SHARES = (-10, -7, -4, 0, 3, 7, 10, 13), (1, 2, 4, 6, 8, 10, 12, 16, 20, 24, 32, 48)  # as in verify/families/ladder.h
STRAIGHT = field_cases.STRAIGHT
L_SHAPE = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]


def prism(outline, triangles, height):
    """A prism over a polygon, whose bottom is cut into these triangles, wound counter-clockwise from above."""
    n = len(outline)
    vertices = [[x, y, z] for z in (0, height) for x, y in outline]
    faces = [[a, c, b] for a, b, c in triangles] + [[n + k for k in t] for t in triangles]
    for k in range(n):
        j = (k + 1) % n
        faces += [[k, j, n + j], [k, n + j, n + k]]
    return vertices, faces


TETRAHEDRON = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]
SHAPES = [(field_cases.CUBE, field_cases.TRIANGLES), TETRAHEDRON, prism(L_SHAPE, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]], 1)]


def random_turn(rng):
    q = [rng.gauss(0, 1) for _ in range(4)]
    return [x / math.sqrt(sum(y * y for y in q)) for x in q]


def case(regime, parameter, bodies, turns, moves):
    """A case of two bodies, each with a unit quaternion and a translation."""
    made = {"regime": regime, "parameter": parameter}
    for key, (vertices, triangles), turn, move in zip("ab", bodies, turns, moves):
        rows = field_cases.rotation(turn)
        made[key] = {"vertices": vertices, "faces": [[t] for t in triangles], "triangles": triangles}
        made["rigid_" + key] = [*turn, *move]
        made["pose_" + key] = [x for i in range(3) for x in (*rows[i], move[i])]
    return made


def scaled(shape, size):
    return [[size * x for x in v] for v in shape[0]], shape[1]


def rungs(rng, again):
    """All rungs of the ladder: aligned, shifted sideways, and turned together by a rounded rotation."""
    for number in range(25 * len(SIZES)):
        size, step = 2.0 ** SIZES[number // 25], number % 25
        gap = 0 if step == 0 else (1 if step % 2 else -1) * 2.0 ** -SHARES[(step - 1) // 2]
        for kind in range(3 * again):
            side = [rng.randrange(-48, 49) / 64 * (kind % 3 > 0) for _ in range(2)]
            turn = random_turn(rng) if kind % 3 == 2 else STRAIGHT
            rows, beside = field_cases.rotation(turn), [size * (1 + gap), size * side[0], size * side[1]]
            move = [sum(rows[i][k] * beside[k] for k in range(3)) for i in range(3)] if kind % 3 == 2 else beside
            yield case("ladder", number, [scaled(SHAPES[0], size)] * 2, [turn] * 2, [[0.0] * 3, move])


def boxes(rng, count):
    """Boxes of whole numbers that overlap by a volume or are at least 1 apart, and copies; half of them are turned together."""
    for number in range(count):
        while True:
            s, t = ([sorted(rng.sample(range(7), 2)) for _ in range(3)] for _ in range(2))
            if max(max(u[0] - v[1], v[0] - u[1]) for u, v in zip(s, t)) != 0:
                break
        a, b = (([[float(sides[k][v[k]]) for k in range(3)] for v in field_cases.CUBE], field_cases.TRIANGLES) for sides in (s, t))
        shift = [0.0] * 3
        if number % 4 < 2:  # a copy, moved by half its sides or not at all
            b = a
            shift = [(low - high) / 2 * rng.randrange(2) for low, high in s]
        turn = random_turn(rng) if number % 2 else STRAIGHT
        rows = field_cases.rotation(turn)
        yield case("lego", number, [a, b], [turn] * 2, [[0.0] * 3, [sum(rows[i][k] * shift[k] for k in range(3)) for i in range(3)]])


def truth(c, question):
    """The exact answer: poses are taken as the doubles that they are."""
    points = [rounded.placed([tuple(map(Fraction, v)) for v in c[key]["vertices"]], c["pose_" + key]) for key in "ab"]
    return rounded.decide(points, [c[key]["triangles"] for key in "ab"], question)


def metres(rng, count):
    """Bodies of 0.1 to 10 m within 100 m, the one swept towards the other up to their contact, then 2^-k of the size before or beyond it."""
    for number in range(count):
        size = 10 ** rng.uniform(-1, 1)
        bodies = [scaled(SHAPES[rng.randrange(3)], size * x) for x in (1, rng.uniform(0.5, 1))]
        turns, where = [random_turn(rng), random_turn(rng)], [rng.uniform(-100, 100) for _ in range(3)]
        way = [rng.gauss(0, 1) for _ in range(3)]
        way = [x / math.hypot(*way) for x in way]

        def at(distance):
            return case("metres", number, bodies, turns, [where, [w + distance * d for w, d in zip(where, way)]])
        near, far = 0.0, 8 * size
        for _ in range(26):
            middle = (near + far) / 2
            near, far = (middle, far) if truth(at(middle), "surface") else (near, middle)
        yield at(near + (1 if number % 2 else -1) * size * 2.0 ** -rng.choice((3, 6, 10, 14, 18, 22)))


@functools.lru_cache
def cases(count):
    rng = random.Random(1)
    return [*rungs(rng, max(1, count // 200)), *boxes(rng, count), *metres(rng, count)]


def truths(out, count):
    """The exact answers, kept in a file: (surface, solid) by case."""
    path = os.path.join(out, f"trial-{count}.json")
    if not os.path.exists(path):
        known = [[truth(c, q) for q in ("surface", "solid")] for c in cases(count)]
        with open(path + ".part", "w") as file:
            json.dump(known, file)
        os.replace(path + ".part", path)
    with open(path) as file:
        return json.load(file)


def answers(talk_with, name, out, count, seconds):
    """What a subject says of each case, kept in a file as it comes: [surface, solid], each 1, 0, null for declined, or how it failed."""
    path = os.path.join(out, f"trial-{count}-{name}.jsonl")
    known = [json.loads(line) for line in open(path)] if os.path.exists(path) else []
    talk, slow = None, 0
    with open(path, "a") as file:
        for number in range(len(known), len(cases(count))):
            c, said = cases(count)[number], []
            for k, question in enumerate(("surface", "solid")):
                if slow >= 3:
                    said.append("too slow")
                    continue
                fresh = talk is None
                talk = talk or talk_with()
                try:
                    if fresh or k == 0:
                        talk.tell({"model": 0, **c["a"]})
                        talk.tell({"model": 1, **c["b"]})
                    talk.tell({"ask": k, "a": 0, "b": 1, "question": question, **{key: c[key] for key in ("pose_a", "pose_b", "rigid_a", "rigid_b")}})
                    answer = talk.hear(seconds + 30 * fresh)
                except OSError:
                    answer = None
                if answer is None:
                    how = talk.end()
                    slow += how == "silent"
                    said.append(how)
                    talk = None
                else:
                    said.append(answer["answer"])
            if talk:
                for model in (0, 1):
                    talk.tell({"forget": model})
            file.write(json.dumps(said) + "\n")
            file.flush()  # a run that is killed goes on from here
            known.append(said)
    if talk:
        talk.close()
    return known


def rows(subjects, out, count, seconds):
    """The table of the trial; `subjects` are (name, group, function that begins a talk)."""
    right, every, made = truths(out, count), cases(count), []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:  # the work is the subjects'
        asking = {name: pool.submit(answers, begin, name, out, count, seconds) for name, _, begin in subjects}
        said = {name: told.result() for name, told in asking.items()}
    for k, question in enumerate(("surface", "solid")):
        asked = {name: {n for n, a in enumerate(told) if a[k] is not None and a[k] != "too slow"} for name, told in said.items()}
        group = {name: g for name, g, _ in subjects}
        takers = [name for name in said if asked[name]]

        def counted(name, numbers, table, regime):
            told = [(said[name][n][k], right[n][k]) for n in numbers]
            return {"table": table, "subject": name, "question": question, "regime": regime, "n": len(told),
                    "invented": sum(a == 1 and t == 0 for a, t in told), "missed": sum(a == 0 and t == 1 for a, t in told),
                    "failed": sum(isinstance(a, str) for a, _ in told)}
        for name in takers:
            for regime in ("metres", "ladder", "lego"):
                mine = [n for n, c in enumerate(every) if c["regime"] == regime]
                made.append(counted(name, [n for n in mine if n in asked[name]], "regime", regime) |
                            {"declined": sum(n not in asked[name] for n in mine)})
            flush = [n for n, c in enumerate(every) if c["regime"] == "ladder" and c["parameter"] % 25 == 0 and right[n][k] and n in asked[name]]
            made.append({"table": "flush", "subject": name, "question": question, "n": len(flush), "missed": sum(said[name][n][k] == 0 for n in flush)})
            for index, size in enumerate(SIZES):
                for what, parity in (("gap", 1), ("overlap", 0)):
                    mine = [n for n, c in enumerate(every) if c["regime"] == "ladder" and c["parameter"] // 25 == index and c["parameter"] % 25 and
                            c["parameter"] % 25 % 2 == parity and n in asked[name]]
                    bad = [SHARES[(every[n]["parameter"] % 25 - 1) // 2] for n in mine if said[name][n][k] in (0, 1) and said[name][n][k] != right[n][k]]
                    if mine:
                        made.append({"table": "ladder", "subject": name, "question": question, "regime": what, "size": size, "n": len(mine),
                                     "value": -min(bad) if bad else ""})
        whole = [name for name in takers if group[name] != "rounded"]
        for who, members in (("meshes", [n for n in whole if group[n] != "convex"]), ("all", whole)):
            if (question, who) != ("surface", "all") and members:
                common = set.intersection(*(asked[name] for name in members))
                made += [counted(name, common, "common", who) for name in members]
        grid = {}
        for name in takers:
            if group[name] == "rounded":
                what, _, bits = name.rpartition("-")
                for n, c in enumerate(every):
                    step = c["parameter"] % 25
                    if c["regime"] == "ladder" and step and n in asked[name]:
                        key = what, ("overlap", "gap")[step % 2], int(bits) - SHARES[(step - 1) // 2]
                        count_of = grid.setdefault(key, [0, 0])
                        count_of[0] += 1
                        count_of[1] += said[name][n][k] != right[n][k]
        for (what, kind, steps), (n, bad) in sorted(grid.items()):
            made.append({"table": "grid", "subject": what, "question": question, "regime": kind, "size": steps, "n": n, "invented" if kind == "gap" else "missed": bad})
    for name, told in said.items():
        ways = {}
        for way in (a for answer in told for a in answer if isinstance(a, str)):
            ways[way] = ways.get(way, 0) + 1
        made += [{"table": "declined" if way == "too slow" else "failure", "subject": name, "regime": way, "n": n} for way, n in sorted(ways.items())]
    return made
