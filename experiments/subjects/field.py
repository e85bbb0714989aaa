#!/usr/bin/python3
"""The field on trial: field.py [PROGRAM] [--out DIR] [--cases N] [--frames N] [--limit S] [--csv FILE].

It asks the campaign's questions of the engines of npm and of Debian that are here, the peers and our own kernels. It writes DIR/field.csv and
DIR/field.html. Started again with the same words, it goes on where it was. `./reproduce field` calls it. Without PROGRAM it asks the cases of
field_trial.py, and no kernel of ours and no peer."""

import argparse
import csv
import functools
import json
import math
import os
import random
import re
import select
import shutil
import sqlite3
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), "report")]

import field_cases  # noqa: E402
import field_trial  # noqa: E402
import field_page  # noqa: E402

# Name in the campaign, group, command; {npm} and {bin} are folders under --out. The groups are the page's.
PROGRAMS = [
    ("GTS", "double", "{bin}/gts"),
    ("VTK", "double", f"{HERE}/vtk_collision.py"),
    ("Simbody", "double", "{bin}/simbody"),
    ("three-mesh-bvh", "double", "node {npm}/three_mesh_bvh.mjs"),
    ("Rapier-mesh", "float", "node {npm}/rapier.mjs"),
    ("PhysX-mesh", "float", "node {npm}/physx.mjs"),
    ("Manifold", "float", "node {npm}/manifold.mjs"),
    ("Rapier-hull", "convex", "node {npm}/rapier.mjs hull"),
    ("PhysX-hull", "convex", "node {npm}/physx.mjs hull"),
    ("Jolt-hull", "convex", "node {npm}/jolt.mjs"),
    ("Havok-hull", "convex", "node {npm}/havok.mjs"),
    ("MuJoCo-hull", "convex", "node {npm}/mujoco.mjs"),
    ("SFCGAL", "exact", "{bin}/sfcgal"),
]
# Exact after rounding to a grid: asked of the ladder, lego and metres alone, since they compare all edges with all faces.
ROUNDED = [(f"{what}-{bits}", "rounded", f"{HERE}/rounded.py {bits}" + (" vertices" if what == "vertices" else ""))
           for what, sizes in (("placed", (10, 16, 20, 24, 26, 32, 40)), ("vertices", (10, 16, 20, 24, 26, 32, 40))) for bits in sizes]
# Ours, and the peers in process, by their names in the program.
BUILT_IN = {"adaptive tree": "exact", "CGAL RMCD EPECK": "exact", "double tree": "double", "CGAL RMCD EPICK": "double", "FCL OBBRSS": "double",
            "FCL AABB": "double", "ODE trimesh": "double", "float tree": "float", "Bullet GImpact": "float", "libccd GJK": "convex",
            "libccd MPR": "convex"}
# What a surface engine is asked of solids, and the other way round, is no question that it answers.
KNOWS = {"FCL OBBRSS": "surface", "FCL AABB": "surface", "ODE trimesh": "surface", "Bullet GImpact": "surface", "libccd GJK": "solid",
         "libccd MPR": "solid"}
DEBIAN = {"gts": ("gts.h", "libgts-dev", 20, "pkg-config --cflags --libs gts"),
          "simbody": ("simbody/SimTKmath.h", "libsimbody-dev", 17, "echo -isystem /usr/include/simbody -lSimTKmath -lSimTKcommon"),
          "sfcgal": ("SFCGAL/version.h", "libsfcgal-dev", 20, "echo -DCGAL_USE_GMPXX=1 -lSFCGAL -lgmpxx -lgmp -lmpfr")}
OF_NPM = "node "
NOT_NEAR, EXACTLY = 9999, -9999  # of the table `tally`
# The levels of campaigns that ask the other kinds of question, and the kinds that hellos name for them.
OTHER_LEVELS = {"points": {"inside"}, "rays": {"ray"}, "distances": {"within", "distance"}, "motions": {"first contact"}, "predicate": {"triangles"}}


def run(words, **options):
    return subprocess.run(words, check=True, **options)


def install_npm(folder):
    """Brings the packages of the lockfile, where they are not there."""
    os.makedirs(folder, exist_ok=True)
    source = os.path.join(HERE, "npm")
    lock = os.path.join(folder, "package-lock.json")
    same = os.path.exists(lock) and open(lock).read() == open(os.path.join(source, "package-lock.json")).read()
    for name in os.listdir(source):
        if name != "node_modules":
            shutil.copy(os.path.join(source, name), folder)
    if not same or not os.path.isdir(os.path.join(folder, "node_modules")):
        run(["npm", "ci", "--silent"], cwd=folder)


def compile_debian(folder):
    """Compiles the subjects whose library is here; says which are not."""
    os.makedirs(folder, exist_ok=True)
    for name, (header, package, standard, flags) in DEBIAN.items():
        source, made = os.path.join(HERE, name + ".cpp"), os.path.join(folder, name)
        if not os.path.exists(os.path.join("/usr/include", header)):
            print(f"skipped: {name}, which needs {package}")
        elif not os.path.exists(made) or os.path.getmtime(made) < os.path.getmtime(source):
            words = subprocess.run(flags, shell=True, check=True, capture_output=True, text=True).stdout.split()
            try:
                run(["g++", "-O2", f"-std=c++{standard}", "-I", ROOT, source, "-o", made, *words])
            except subprocess.CalledProcessError:
                print(f"skipped: {name}, which does not compile with this {package}")


def programs(npm, binaries):
    """The programs that can be run here: name, group, command."""
    found = []
    for name, group, command in PROGRAMS:
        command = command.format(npm=npm, bin=binaries)
        if name == "VTK" and subprocess.run(["/usr/bin/python3", "-c", "import vtkmodules"], capture_output=True).returncode != 0:
            print("skipped: VTK, which needs python3-vtk9")
        elif command.startswith(OF_NPM) or os.path.exists(command.split()[0]):
            found.append((name, group, command))
    return found


class Talk:
    """A conversation with a subject."""

    def __init__(self, command):
        self.process = subprocess.Popen(["/bin/sh", "-c", "exec " + command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.hello, self.rest = None, b""

    def tell(self, message):
        self.process.stdin.write(json.dumps(message).encode() + b"\n")
        self.process.stdin.flush()

    def hear(self, seconds):
        """The next object, or nothing past the limit or at the program's end."""
        until = time.monotonic() + seconds
        while True:
            while b"\n" not in self.rest:
                ready, _, _ = select.select([self.process.stdout], [], [], max(0, until - time.monotonic()))
                got = os.read(self.process.stdout.fileno(), 65536) if ready else b""
                if not got:
                    return None
                self.rest += got
            line, self.rest = self.rest.split(b"\n", 1)
            if line.startswith(b"{"):
                message = json.loads(line)
                if "hello" not in message:
                    return message
                self.hello = message

    def end(self):
        """How it ended, in the words of the table of failures; a program that still runs was silent."""
        try:
            status = self.process.wait(0.5)
            return f"signal {-status}" if status < 0 else f"status {status}"
        except subprocess.TimeoutExpired:
            self.close()
            return "silent"

    def close(self):
        self.process.kill()
        self.process.wait()


def replies(command, messages, seconds):
    """The answers to asks among the messages, by their numbers, and the hello; what stays out is missing."""
    talk, told = Talk(command), {}
    try:
        for message in messages:
            talk.tell(message)
            answer = talk.hear(seconds) if "ask" in message or "asks" in message else None
            for one in (answer or {}).get("answers", [answer] if answer else []):
                told[one["ask"]] = one
            if "ask" in message and answer is None:
                break
    except OSError:
        pass
    finally:
        talk.close()
    return told, talk.hello


def bumpy_sphere(levels, bump):
    """An icosahedron halved `levels` times, its radii changed by up to `bump`: 20 x 4^levels triangles."""
    g, rng = (1 + math.sqrt(5)) / 2, random.Random(1)
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2),
             (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middle = {}

        def between(i, j):
            key = min(i, j), max(i, j)
            if key not in middle:
                middle[key] = len(points)
                points.append(tuple((a + b) / 2 for a, b in zip(points[i], points[j])))
            return middle[key]
        faces = [t for a, b, c in faces for t in ((a, between(a, b), between(a, c)), (b, between(b, c), between(a, b)), (c, between(a, c), between(b, c)),
                                                  (between(a, b), between(b, c), between(a, c)))]
    radii = [(1 + bump * rng.uniform(-1, 1)) / math.hypot(*p) for p in points]
    return [[r * x for x in p] for r, p in zip(radii, points)], [list(f) for f in faces]


def speed(found, program, out, rows):
    """Each engine's own clock on one pair of bodies near contact, in a batch where it takes one: bumpy spheres, or round ones for hulls."""
    rng = random.Random(2)
    poses = []
    while len(poses) < 200:
        q = [rng.gauss(0, 1) for _ in range(4)]
        q = [x / math.hypot(*q) for x in q]
        d = [rng.gauss(0, 1) for _ in range(3)]
        poses.append((q, [x / math.hypot(*d) * rng.uniform(1.8, 2.1) for x in d]))
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]

    def row_major(q, t):
        r = field_cases.rotation(q)
        return [x for i in range(3) for x in (*r[i], t[i])]
    for kind, question, levels, bump in (("meshes of 320 triangles", "surface", 2, 0.2), ("hulls of 80 triangles", "solid", 1, 0)):
        vertices, faces = bumpy_sphere(levels, bump)
        files = os.path.join(out, "speed.off"), os.path.join(out, "speed.poses"), os.path.join(out, "speed.csv")
        with open(files[0], "w") as off:
            off.write(f"OFF\n{len(vertices)} {len(faces)} 0\n" + "".join(" ".join(map(repr, v)) + "\n" for v in vertices))
            off.write("".join("3 " + " ".join(map(str, f)) + "\n" for f in faces))
        with open(files[1], "w") as text:
            text.write("".join(" ".join(map(repr, row_major(q, t))) + "\n" for q, t in poses))
        run([program, "collide", files[0], files[0], "--pose-b", files[1], "--question", question, "--time", "--repeat", "5", "--csv", files[2]],
            stdout=subprocess.DEVNULL)
        ours = list(csv.DictReader(open(files[2])))
        rows.append({"table": "speed", "subject": "adaptive tree", "question": question, "regime": kind, "n": len(ours),
                     "value": sum(int(r["ns"]) for r in ours) / len(ours), "text": f"{sum(int(r['answer']) for r in ours)} collide"})
        asks = [{"ask": k, "a": 0, "b": 1, "pose_a": identity, "pose_b": row_major(q, t), "rigid_a": [1, 0, 0, 0, 0, 0, 0], "rigid_b": [*q, *t],
                 "question": question} for k, (q, t) in enumerate(poses)]
        models = [{"model": k, "vertices": vertices, "faces": [[f] for f in faces], "triangles": faces} for k in (0, 1)]
        for name, group, command in found:
            warm, hello = replies(command, models + asks[:1], 20)
            first = warm.get(0, {})
            if first.get("answer") is None or first.get("ns", 1e18) > 1e8:  # declined, or too slow for 200 poses
                continue
            batch = hello and hello.get("batch")
            told, _ = replies(command, models + asks[:20] + ([{"asks": asks}] if batch else asks), 60)
            timed = [a for a in told.values() if a.get("ns") is not None]
            if len(timed) == len(asks):
                rows.append({"table": "speed", "subject": name, "question": question, "regime": kind, "n": len(timed),
                             "value": sum(a["ns"] for a in timed) / len(timed), "text": f"{sum(a['answer'] for a in timed)} collide"})


def exact_answer(case, question, path, program, version):
    """The exact answer to a reproduction, by the program where there is one, else in Python's integers."""
    if not program:
        bodies = {key: {"vertices": case[key], "triangles": field_cases.TRIANGLES} for key in "ab"}
        return field_trial.truth(case | bodies, question)
    with open(path, "w") as file:
        file.write(field_cases.case_file(case, {"surface": 0, "solid": 0}, version).replace('"question": "solid"', f'"question": "{question}"'))
    return int(subprocess.run([program, "collide", path], check=True, capture_output=True, text=True).stdout)


def strip(found, program, out, rows):
    """The reproductions: case files, their exact answers, and what each engine says."""
    folder = os.path.join(out, "field")
    os.makedirs(folder, exist_ok=True)
    version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split()[-1] if program else ""
    for case in field_cases.CASES:
        path = os.path.join(folder, case["name"] + ".case.json")
        truth = {question: exact_answer(case, question, path, program, version) for question in ("surface", "solid")}
        with open(path, "w") as file:
            file.write(field_cases.case_file(case, truth, version))
        for question, value in truth.items():
            rows.append({"table": "case", "subject": "truth", "question": question, "regime": case["name"], "value": value, "text": case["what"]})
    for name, group, command in found:
        messages = [m for k, case in enumerate(field_cases.CASES) for m in field_cases.lines(case, k)]
        told, _ = replies(command, messages, 20)
        for number, answer in sorted(told.items()):
            if answer["answer"] is not None:
                rows.append({"table": "case", "subject": name, "question": ("surface", "solid")[number % 2],
                             "regime": field_cases.CASES[number // 2]["name"], "value": answer["answer"]})


def regime(family, bin_of_ulps):
    if family in ("metres", "ladder", "lego"):
        return family
    if family.startswith("sequence "):
        return "sequences"
    if family in ("nested", "nested-touching", "cavity-wall"):
        return "nested"
    if bin_of_ulps == EXACTLY:
        return "exact"
    return "near" if bin_of_ulps <= 20 else "float-near" if bin_of_ulps <= 40 else "clear"


def tables(db, groups, rows):
    """The campaign's answers in rows: by regime, those that all were asked, the ladder, touches, failures."""
    base = sqlite3.connect(f"file:{db}?mode=ro", uri=True)

    def asked(subject, question):
        return subject in groups and KNOWS.get(subject, question) == question
    sums = {}
    for subject, question, family, bin_, *counts in base.execute(
            "SELECT subject, question, family, bin, n, false_positives, false_negatives, failures, not_asked FROM tally "
            "WHERE level = 'object' AND axis = 'ulps' AND poses = 'doubles'"):
        if asked(subject, question):
            sums.setdefault((subject, question, regime(family, bin_)), [0] * 5)
            sums[subject, question, regime(family, bin_)] = [a + b for a, b in zip(sums[subject, question, regime(family, bin_)], counts)]
    takes = {(s, q) for (s, q, _), c in sums.items() if c[0] > 0}
    for (subject, question, name), (n, invented, missed, failed, declined) in sorted(sums.items()):
        if (subject, question) in takes:
            rows.append({"table": "regime", "subject": subject, "question": question, "regime": name, "n": n, "invented": invented, "missed": missed,
                         "failed": failed, "declined": declined})
    # What rounding the input to floats costs, and what the engine does with the rounded one.
    rounded = {}
    for subject, question, family, bin_, *counts in base.execute(
            "SELECT subject, question, family, bin, n, changed, wrong, excused, false_positives, false_negatives FROM rounded WHERE level = 'object'"):
        if asked(subject, question):
            key = subject, question, regime(family, bin_)
            rounded[key] = [a + b for a, b in zip(rounded.get(key, [0] * 6), counts)]
    for (subject, question, name), (n, changed, wrong_of_input, excused, invented, missed) in sorted(rounded.items()):
        rows.append({"table": "rounded", "subject": subject, "question": question, "regime": name, "n": n, "changed": changed, "wrong": wrong_of_input,
                     "excused": excused, "invented": invented, "missed": missed})
    for subject, why, n in base.execute("SELECT subject, why, count(*) FROM declined WHERE level = 'object' GROUP BY 1, 2 ORDER BY 1, 2"):
        if subject in groups:
            rows.append({"table": "declined", "subject": subject, "regime": why, "n": n})

    # What all were asked that take the question: the first cases of each family are kept one by one.
    declined, cases = {}, {}
    for family, number, subject, question in base.execute("SELECT family, number, subject, question FROM declined WHERE level = 'object'"):
        declined.setdefault((subject, question), set()).add((family, number))
    for family, n in base.execute("SELECT family, sum(cases) FROM done WHERE level = 'object' AND subject = 'truth' GROUP BY family"):
        cases[family] = min(n, 200)
    wrong = {}
    for family, number, parameter, subject, question, truth, answer in base.execute(
            "SELECT family, number, parameter, subject, question, truth, answer FROM wrong WHERE level = 'object'"):
        wrong.setdefault((subject, question), {})[family, number] = (parameter, truth, answer)
    everything = {(family, number) for family, n in cases.items() for number in range(n)}
    for question in ("surface", "solid"):
        whole = [s for s, q in takes if q == question and groups[s] != "rounded"]
        for who, members in (("meshes", [s for s in whole if groups[s] != "convex"]), ("all", whole)):
            if question == "surface" and who == "all":
                continue
            common = everything - set().union(*(declined.get((s, question), set()) for s in members))
            for subject in sorted(members):
                mistakes = wrong.get((subject, question), {})
                rows.append({"table": "common", "subject": subject, "question": question, "regime": who, "n": len(common),
                             "invented": sum(mistakes[k][2] == 1 for k in common & mistakes.keys()),
                             "missed": sum(mistakes[k][2] == 0 for k in common & mistakes.keys()),
                             "failed": sum(mistakes[k][2] is None for k in common & mistakes.keys())})

    # Rungs as in verify/families/ladder.h.
    sizes, shares = (-10, -7, -4, 0, 3, 7, 10, 13), (1, 2, 4, 6, 8, 10, 12, 16, 20, 24, 32, 48)
    rungs = {number: (number * 89 % 200) for number in range(cases.get("ladder", 0))}
    for subject, question in sorted(takes):
        mistakes, out_of = wrong.get((subject, question), {}), declined.get((subject, question), set())
        flush = [number for number, rung in rungs.items() if rung % 25 == 0 and ("ladder", number) not in out_of]
        rows.append({"table": "flush", "subject": subject, "question": question, "n": len(flush),
                     "missed": sum(("ladder", number) in mistakes for number in flush)})
        for index, size in enumerate(sizes):
            mine = {n: r for n, r in rungs.items() if r // 25 == index and r % 25 and ("ladder", n) not in out_of}
            for what, parity in (("gap", 1), ("overlap", 0)):
                bad = [shares[(r % 25 - 1) // 2] for n, r in mine.items() if (r % 25) % 2 == parity and mistakes.get(("ladder", n), (0, 0, None))[2] is not None]
                if any((r % 25) % 2 == parity for r in mine.values()):
                    rows.append({"table": "ladder", "subject": subject, "question": question, "regime": what, "size": size,
                                 "n": sum((r % 25) % 2 == parity for r in mine.values()), "value": -min(bad) if bad else ""})

    # Rounding, by the gap or overlap in steps of the grid, 2^value.
    grid = {}
    for subject, question in sorted(takes):
        if groups[subject] == "rounded":
            mistakes, out_of = wrong.get((subject, question), {}), declined.get((subject, question), set())
            for n, r in rungs.items():
                if r % 25 and ("ladder", n) not in out_of:
                    steps = int(subject.rpartition("-")[2]) - shares[(r % 25 - 1) // 2]
                    count = grid.setdefault((subject.rpartition("-")[0], ("overlap", "gap")[r % 25 % 2], steps), [0, 0])
                    count[0] += 1
                    count[1] += ("ladder", n) in mistakes
    for (subject, what, steps), (n, bad) in sorted(grid.items()):
        rows.append({"table": "grid", "subject": subject, "regime": what, "size": steps, "n": n, "invented" if what == "gap" else "missed": bad})

    # Touches that are called apart: sequences of exact contact, where each frame was asked.
    positives = {(family, question): n for family, question, n in base.execute(
        "SELECT family, question, sum(positives) FROM truth WHERE level = 'object' AND family LIKE 'sequence %' GROUP BY 1, 2")}
    touches = {}
    for subject, question, family, missed, n, out_of in base.execute(
            "SELECT subject, question, family, sum(false_negatives), sum(n), sum(not_asked) FROM tally WHERE level = 'object' AND axis = 'rho' "
            "AND family LIKE 'sequence %' GROUP BY 1, 2, 3"):
        if asked(subject, question) and out_of == 0 and n:
            t = touches.setdefault((subject, question), [0, 0])
            t[0] += missed
            t[1] += positives.get((family, question), 0)
    for (subject, question), (missed, n) in sorted(touches.items()):
        rows.append({"table": "touching", "subject": subject, "question": question, "n": n, "missed": missed})
    for subject, how, n, said in base.execute("SELECT subject, how, sum(n), min(said) FROM failure WHERE level = 'object' GROUP BY 1, 2 ORDER BY 1, 2"):
        if subject in groups:
            rows.append({"table": "failure", "subject": subject, "regime": how, "n": n, "text": said})
    hellos = dict(base.execute("SELECT subject, hello FROM hello"))
    skipped = dict(base.execute("SELECT subject, sum(n) FROM skipped GROUP BY subject"))
    for subject, group in groups.items():
        if any(s == subject for s, _ in takes):
            rows.append({"table": "engine", "subject": subject, "regime": group, "n": skipped.get(subject, 0), "text": hellos.get(subject, "")})
    return base.execute("SELECT version, compiler, flags, processor, seed FROM run ORDER BY id DESC LIMIT 1").fetchone()


def other_kinds(db, program, found, cases, limit, rows):
    """Asks each engine the other kinds of question that its hello names: rows by level and question."""
    base = sqlite3.connect(f"file:{db}?mode=ro", uri=True)
    takes = {subject: set(json.loads(hello or "{}").get("questions", [])) for subject, hello in base.execute("SELECT subject, hello FROM hello")}
    for level, kinds in OTHER_LEVELS.items():
        engines = [(name, command) for name, _, command in found if kinds & takes.get(name, set())]
        words = [w for name, command in engines for w in ("--subject", name, "--subject-command", f"{name}=exec {command}")]
        if engines:
            run([program, "verify", "--db", db, "--level", level, "--cases", str(cases), "--subject-limit", str(limit), *words], stdout=subprocess.DEVNULL)
    for level, subject, question, *counts in base.execute(
            "SELECT level, subject, question, sum(n), sum(false_positives), sum(false_negatives), sum(failures), sum(not_asked) FROM tally "
            "WHERE axis = 'rho' AND level != 'object' GROUP BY 1, 2, 3 ORDER BY 1, 2, 3"):
        if counts[0]:
            rows.append({"table": "kind", "subject": subject, "question": question, "regime": level} |
                        dict(zip(("n", "invented", "missed", "failed", "declined"), counts)))


IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]
COLUMNS = ["table", "subject", "question", "regime", "size", "n", "invented", "missed", "failed", "declined", "changed", "wrong", "excused", "value", "text"]
MADE_BY = ["version", "compiler", "flags", "processor", "seed", "cases", "frames", "node"]


def campaign(options, program, found, out, rows):
    """Asks the campaign's questions; returns what made the rows."""
    groups = BUILT_IN | {name: group for name, group, _ in found + ROUNDED}
    words = [program, "verify", "--db", os.path.join(out, "field.db"), "--level", "object", "--subject-limit", str(options.limit)]
    for name in BUILT_IN:
        words += ["--subject", name]
    for name, _, command in found:
        words += ["--subject-command", f"{name}=exec {command}"]
    # The families of the sizes that engines are made for have more cases; those of a ladder are all its rungs.
    rounded = [w for name, _, command in ROUNDED for w in ("--subject-command", f"{name}=exec {command}")]
    for more in (["--cases", str(options.cases), "--frames", str(options.frames)],
                 ["--cases", "200", "--family", "ladder", "--family", "lego", "--family", "metres", *rounded]):
        status = subprocess.run([*words, *more], stdout=subprocess.DEVNULL).returncode
        if status not in (0, 1):  # 1: an exact subject was wrong, which the page shows
            sys.exit(status)
    made = tables(os.path.join(out, "field.db"), groups, rows)
    other_kinds(os.path.join(out, "field.db"), program, found, options.cases, options.limit, rows)
    return made


def trial(options, found, out, rows):
    """Asks the field's own cases, and the reproductions; returns what made the rows."""
    subjects = [(name, group, functools.partial(Talk, command)) for name, group, command in ROUNDED + found]
    rows += field_trial.rows(subjects, out, options.cases, options.limit)
    strip(found, None, out, rows)
    for name, group, command in found + ROUNDED:
        _, hello = replies(command, [{"model": 0, "vertices": field_cases.CUBE, "faces": field_cases.FACES, "triangles": field_cases.TRIANGLES},
                                     {"ask": 0, "a": 0, "b": 0, "pose_a": IDENTITY, "pose_b": IDENTITY, "question": "surface"}], 30)
        rows.append({"table": "engine", "subject": name, "regime": group, "n": 0, "text": json.dumps(hello) if hello else ""})
    with open("/proc/cpuinfo") as file:
        processor = re.search("model name\\s*: (.*)", file.read())[1]
    with open(os.path.join(ROOT, "CITATION.cff")) as file:
        version = re.search("^version: (.*)$", file.read(), re.M)[1]
    return version, "", "", processor, 1


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", nargs="?", help="build/tetracone; without it, the field's own cases are asked, and no kernel of ours")
    parser.add_argument("--out", default=os.path.join(ROOT, "out", "field"))
    parser.add_argument("--cases", type=int, help="cases a family, 12, while ladder, lego and metres have 200; without a program, 200 of lego and metres")
    parser.add_argument("--frames", type=int, default=8, help="frames of each sequence of exact contact")
    parser.add_argument("--limit", type=float, default=2, help="seconds for an answer")
    parser.add_argument("--csv", help="only make the page of this CSV")
    options = parser.parse_args()
    options.cases = options.cases or (12 if options.program else 200)
    out = os.path.abspath(options.out)
    os.makedirs(out, exist_ok=True)
    page = os.path.join(out, "field.html")
    if options.csv:
        field_page.write(options.csv, page)
        return print("page: " + page)
    program, npm, binaries = options.program and os.path.abspath(options.program), os.path.join(out, "npm"), os.path.join(out, "bin")
    install_npm(npm)
    compile_debian(binaries)
    found = programs(npm, binaries)
    rows = []
    if program:
        made = campaign(options, program, found, out, rows)
        strip(found, program, out, rows)
        speed(found, program, out, rows)
    else:
        made = trial(options, found, out, rows)
    node = subprocess.run(["node", "--version"], capture_output=True, text=True).stdout.strip()
    origin = dict(zip(MADE_BY, (*made, options.cases, options.frames, node)))
    table = os.path.join(out, "field.csv")
    with open(table + ".part", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS + MADE_BY, lineterminator="\n")
        writer.writeheader()
        writer.writerows({"text": ""} | row | origin for row in rows)
    os.replace(table + ".part", table)
    field_page.write(table, page)
    print("page: " + page)


if __name__ == "__main__":
    main()
