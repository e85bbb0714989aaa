#!/usr/bin/python3
"""cost.py BUILD [--poses N] [--passes P] [--csv FILE]: what Python costs over C++.

Times `Query.collide` of the package in BUILD/python and the same loop in C++ through the door (BUILD/python/libthrough_door.so). Both run in
one process, pass about, on the same bodies and poses. The clock is the thread's own, which a busy machine does not move; the fastest pass of
each counts. Prints, for each workload, nanoseconds a pose of either, their ratio, and how much longer a call with a single pose takes. Made by

    cmake --build BUILD --target _tetracone through_door && experiments/python/cost.py BUILD
"""

import argparse
import csv
import ctypes
import os
import platform
import sys
import time

import numpy as np


def blob(n):
    """A closed surface about 0, its radius waving: about 2 n^2 triangles."""
    u, v = np.meshgrid(np.arange(1, n) * np.pi / n, np.arange(n) * 2 * np.pi / n, indexing="ij")
    r = 1 + 0.3 * np.sin(3 * u) * np.cos(4 * v)
    ring = np.stack([r * np.sin(u) * np.cos(v), r * np.sin(u) * np.sin(v), r * np.cos(u)], -1).reshape(-1, 3)
    vertices = np.vstack([ring, [[0, 0, 1], [0, 0, -1]]])
    top, bottom, faces = len(ring), len(ring) + 1, []
    for j in range(n):
        k = (j + 1) % n
        faces += [[top, j, k], [bottom, (n - 2) * n + k, (n - 2) * n + j]]
        for i in range(n - 2):
            a, b, c, d = i * n + j, i * n + k, (i + 1) * n + j, (i + 1) * n + k
            faces += [[a, c, b], [b, c, d]]
    return vertices, np.array(faces, np.uint32)


def rotations(n, random):
    q = random.normal(size=(n, 4))
    w, x, y, z = (q / np.linalg.norm(q, axis=1, keepdims=True)).T
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z), 1 - 2 * (x * x + z * z),
                     2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], -1).reshape(n, 3, 3)


def workloads(n):
    random = np.random.default_rng(1)
    directions = random.normal(size=(n, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    for name, low, high in (("far apart", 4, 8), ("near contact", 1.8, 2.4), ("overlapping", 0, 1)):
        poses = np.empty((n, 3, 4))
        poses[:, :, :3] = rotations(n, random)
        poses[:, :, 3] = directions * random.uniform(low, high, (n, 1))
        yield name, poses


def best(function, passes):
    times = []
    for _ in range(passes):
        start = time.thread_time_ns()
        function()
        times.append(time.thread_time_ns() - start)
    return min(times)


def main():
    words = argparse.ArgumentParser(description="What Python costs over C++, on the same poses in one run.")
    words.add_argument("build", help="a build folder with _tetracone and through_door")
    words.add_argument("--poses", type=int, default=100000)
    words.add_argument("--passes", type=int, default=7)
    words.add_argument("--csv", help="also write the rows to this file")
    options = words.parse_args()
    package = os.path.join(options.build, "python")
    sys.path.insert(0, package)
    import tetracone

    door = ctypes.CDLL(os.path.join(package, "libthrough_door.so"))
    door.new_query.restype = ctypes.c_void_p
    door.new_query.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_size_t]
    door.collide.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]
    door.free_query.argtypes = [ctypes.c_void_p]

    vertices, faces = blob(20)
    body = tetracone.Body(vertices, faces)
    ours = tetracone.Query(body, body)
    theirs = door.new_query(vertices.ctypes.data, len(vertices), faces.ctypes.data, len(faces))
    rows = []
    for name, poses in workloads(options.poses):
        n = len(poses)
        answers = np.zeros(n, bool)
        fastest = {"c++": float("inf"), "python": float("inf")}
        for _ in range(options.passes):
            fastest["c++"] = min(fastest["c++"], best(lambda: door.collide(theirs, poses.ctypes.data, n, answers.ctypes.data), 1) / n)
            fastest["python"] = min(fastest["python"], best(lambda: ours.collide(poses), 1) / n)
        if not (ours.collide(poses) == answers).all():
            sys.exit(f"{name}: the answers differ")
        few = [pose.copy() for pose in poses[:2000]]
        single = best(lambda: [ours.collide(pose) for pose in few], options.passes) / len(few)
        batch = best(lambda: ours.collide(poses[:2000]), options.passes) / len(few)
        rows.append(dict(workload=name, poses=n, collisions=int(answers.sum()), cpp_ns=round(fastest["c++"], 1),
                         python_ns=round(fastest["python"], 1), ratio=round(fastest["python"] / fastest["c++"], 4),
                         single_call_overhead_ns=round(single - batch), triangles=len(faces), version=tetracone.__version__,
                         python=platform.python_version(), numpy=np.__version__,
                         again=f"experiments/python/cost.py build --poses {options.poses} --passes {options.passes} --csv out/python.csv"))
    door.free_query(theirs)
    for row in rows:
        print("{workload:>12}: {collisions} of {poses} collide; {cpp_ns} ns a pose in C++, {python_ns} in Python, ratio {ratio}; "
              "a call of one pose costs {single_call_overhead_ns} ns more".format(**row))
    if options.csv:
        with open(options.csv + ".part", "w", newline="") as file:
            out = csv.DictWriter(file, rows[0], lineterminator="\n")
            out.writeheader()
            out.writerows(rows)
        os.replace(options.csv + ".part", options.csv)


if __name__ == "__main__":
    main()
