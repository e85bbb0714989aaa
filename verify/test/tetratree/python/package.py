#!/usr/bin/python3
"""Tests of the package `tetracone`: answers against the program's, errors, arrays of every kind, threads, documentation."""

import copy
import doctest
import json
import os
import pathlib
import pickle
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from decimal import Decimal
from fractions import Fraction

from support import CUBE, PROGRAM, examples_failed, off_of, text_of

import numpy as np
import tetracone
from tetracone import Body, Error, Query

CHECKER = pathlib.Path(__file__).resolve().parents[4] / "experiments/certificates/check.py"
IDENTITY = np.eye(3, 4)
TETRAHEDRON = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
# A square frame: a face above and one below, each with a hole, and eight walls.
FRAME = ([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (3, 0), (3, 3), (0, 3), (1, 1), (2, 1), (2, 2), (1, 2))],
         [[[8, 9, 10, 11], [15, 14, 13, 12]], [[3, 2, 1, 0], [4, 5, 6, 7]]]
         + [[k, (k + 1) % 4, (k + 1) % 4 + 8, k + 8] for k in range(4)]
         + [[k + 12, (k + 1) % 4 + 12, (k + 1) % 4 + 4, k + 4] for k in range(4)])


def translations(*vectors):
    poses = np.tile(IDENTITY, (len(vectors), 1, 1))
    poses[:, :, 3] = vectors
    return poses


def random_poses(n, seed):
    """Rigid in doubles, near and far, some of them in exact contact with the unit cube."""
    random = np.random.default_rng(seed)
    poses = np.zeros((n, 3, 4))
    poses[:, :, :3] = np.linalg.qr(random.normal(size=(n, 3, 3)))[0]
    poses[:, :, 3] = random.uniform(-1.5, 1.5, (n, 3))
    poses[::3, :, :3] = np.eye(3)
    poses[::3, :, 3] = random.choice([-1, -0.5, 0, 0.5, 1, np.nextafter(1, 2)], (len(poses[::3]), 3))
    return poses


class Case(unittest.TestCase):
    def error(self, line, function, *arguments, **options):
        with self.assertRaises(Error) as raised:
            function(*arguments, **options)
        self.assertEqual(str(raised.exception), line)


class Answers(Case):
    def program(self, *words):
        if not PROGRAM:
            self.skipTest("no program")
        return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)

    def test_collide_relation_and_features_are_the_program_s(self):
        a, b = Body(*CUBE), Body(*TETRAHEDRON)
        poses = random_poses(60, 1)
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("a.off", off_of(a)), ("b.off", off_of(b)), ("poses.txt", text_of(poses))):
                with open(os.path.join(folder, name), "w") as file:
                    file.write(text)
            models = [os.path.join(folder, name) for name in ("a.off", "b.off")]
            moved = ["--pose-b", os.path.join(folder, "poses.txt")]
            for question in ("solid", "surface"):
                for kernel, method in (("adaptive", "tree"), ("epeck", "tree"), ("double", "paper"), ("epick", "brute")):
                    said = self.program("collide", *models, *moved, "--question", question, "--kernel", kernel, "--method", method)
                    ours = Query(a, b, question, kernel, method).collide(poses)
                    self.assertEqual(said.stdout.split(), [str(int(x)) for x in ours], (question, kernel, method))
                    self.assertEqual({0, 1}, set(ours.astype(int)))
            said = self.program("collide", *models, *moved, "--features").stdout
            ours = "".join(f"{k} {f['body']} {f['edge_from']} {f['edge_to']} {f['face']} {f['kind']}\n"
                           for k, found in enumerate(Query(a, b).features(poses)) for f in found)
            self.assertEqual(said, ours)
            read = [tetracone.read(model) for model in models]
            self.assertEqual(Query(*read).collide(poses).tolist(), Query(a, b).collide(poses).tolist())

    def test_inside_is_the_program_s(self):
        points = [[0.5, 0.5, 0.5], [1, 1, 1], [0.5, 0.5, 1], [0.5, 0.5, float(np.nextafter(1, 2))], [2, 0, 0]]
        with tempfile.TemporaryDirectory() as folder:
            names = [os.path.join(folder, name) for name in ("a.off", "points.txt")]
            for name, text in zip(names, (off_of(Body(*CUBE)), "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points))):
                with open(name, "w") as file:
                    file.write(text)
            self.assertEqual(self.program("inside", *names).stdout.split(), [str(x) for x in Body(*CUBE).inside(points)])

    def test_rays_are_the_program_s(self):
        origins = np.array([[-1, 0.5, 0.25], [0.5, 0.5, 0.25], [5, 5, 5], [-1, 0, 0.25], [0.25, -1, 1]])
        directions = np.array([[3, 0, 0], [0, 0, 1], [1, 0, 0], [1, 0, 0], [0, 0.1, 0]])
        with tempfile.TemporaryDirectory() as folder:
            names = [os.path.join(folder, name) for name in ("a.off", "rays.txt")]
            rows = np.hstack([origins, directions])
            for name, text in zip(names, (off_of(Body(*CUBE)), "".join(" ".join(repr(float(x)) for x in row) + "\n" for row in rows))):
                with open(name, "w") as file:
                    file.write(text)
            said = self.program("ray", *names).stdout.splitlines()
            faces, t = Body(*CUBE).first_hit(origins, directions)
            self.assertEqual(said, [f"{f} {np.format_float_positional(x, trim='-')}" if f >= 0 else "-" for f, x in zip(faces, t)])
            said = self.program("ray", *names, "--all").stdout.splitlines()
            rays, faces, t = Body(*CUBE).hits(origins, directions)
            self.assertEqual([[float(x) for x in line.split() if x != "-"] for line in said],
                             [[x for h in np.flatnonzero(rays == k) for x in (faces[h], t[h])] for k in range(len(origins))])
        self.assertEqual(rays.tolist(), sorted(rays.tolist()))
        self.assertEqual(len(set(rays.tolist())), 4)

    def test_rays_end_and_go_through_faces_as_the_program_says(self):
        cube = Body(*CUBE)
        origins, directions = np.array([[-1, 0.5, 0.25], [0.5, 0.5, 0.25], [5, 5, 5], [-1, 0, 0.25]]), np.array([[3, 0, 0], [0, 0, 1], [1, 0, 0], [1, 0, 0]])
        with tempfile.TemporaryDirectory() as folder:
            names = [os.path.join(folder, name) for name in ("a.off", "rays.txt")]
            rows = np.hstack([origins, directions])
            for name, text in zip(names, (off_of(cube), "".join(" ".join(repr(float(x)) for x in row) + "\n" for row in rows))):
                with open(name, "w") as file:
                    file.write(text)
            for end in (0.5, 0.75, 1.0):
                said = self.program("ray", *names, "--end", end, "--sides", "--normals").stdout.splitlines()
                faces, t = cube.first_hit(origins, directions, end)
                sides, normals = cube.crossings(origins, directions, faces), cube.normals(faces)
                self.assertEqual([line.split()[:1] + line.split()[2:3] for line in said], [["-"] if f < 0 else [str(f), s] for f, s in zip(faces, sides)])
                self.assertEqual([[float(x) for x in line.split()[3:]] for line in said], [[] if f < 0 else n.tolist() for f, n in zip(faces, normals)])
                self.assertEqual(self.program("ray", *names, "--end", end, "--any").stdout.split(), [str(int(x)) for x in cube.is_hit(origins, directions, end)])
        self.assertEqual(cube.is_hit(origins, directions).tolist(), [True, True, False, True])
        self.assertEqual(cube.is_hit(origins, directions[:1]).tolist(), [cube.is_hit(o, directions[0]) for o in origins])
        third = cube.first_hit(origins[0], directions[0])[1]
        below = np.nextafter(third, 0)
        self.assertEqual(cube.is_hit(origins[0], directions[0], [third, below, 1, -1, np.inf, -np.inf]).tolist(), [False, False, True, False, True, False])
        self.assertEqual(cube.first_hit(origins[0], directions[0], below), (-1, np.inf))
        self.assertEqual(cube.hits(origins[0], directions[0], [0.5, 1])[0].tolist(), [0, 1, 1])
        self.assertIs(type(cube.is_hit(origins[0], directions[0], 1)), bool)
        rays, faces, _ = cube.hits(origins, directions)
        self.assertEqual(cube.crossings(origins[rays], directions[rays], faces)[:2].tolist(), ["entering", "leaving"])
        self.assertEqual(set(cube.crossings(origins[rays], directions[rays], faces)), {"entering", "leaving", "along"})
        self.assertEqual((cube.crossings([0, 0, 0], [1, 0, 0], 0), cube.crossings([0, 0, 0], [1, 0, 0], -1)), ("entering", ""))
        self.assertEqual(cube.normals(1).tolist(), [1, 0, 0])
        self.assertTrue(np.isnan(cube.normals([-1])).all())
        self.assertEqual((cube.normals([]).shape, cube.crossings([0, 0, 0], [1, 0, 0], []).shape), ((0, 3), (0,)))

    def test_zones_and_pairs_within_a_distance(self):
        cube = Body(*CUBE)
        query = Query(cube, cube)
        poses = translations([1.25, 0, 0], [3, 0, 0], [0.5, 0.5, 0.5])
        # The face x = 1 is near the moved cube; so are those that share its edges.
        self.assertEqual([z.tolist() for z in query.zone("1/4", poses)], [[1, 2, 3, 4, 5], [], [1, 3, 5]])
        self.assertEqual(query.zone(0.2499, poses[0]).tolist(), [])
        self.assertEqual(query.zone(Fraction(1, 4), None, poses_a=poses[0]).tolist(), [0, 2, 3, 4, 5])
        self.assertEqual(query.zone(-1, poses[2]).dtype, np.uint32)
        for limit in (0, Fraction(1, 4), 2):
            self.assertEqual([len(z) > 0 for z in query.zone(limit, poses)], query.within(limit, poses).tolist())
        scene = tetracone.Scene([cube] * 3)
        scene.frame(translations([0, 0, 0], [1.25, 0, 0], [3, 0, 0]))
        for limit, pairs, distances in ((Fraction(1, 4), [[0, 1]], [0.25]), ("3/4", [[0, 1], [1, 2]], [0.25, 0.75]), (-1, [], []), (0.2, [], [])):
            found = scene.pairs_within(limit)
            self.assertEqual((found[0].tolist(), found[1].tolist()), (pairs, distances))
            self.assertEqual(found[0].shape, (len(pairs), 2))
        scene.place(1, [[1, 0, 0, Fraction(4, 3)], [0, 1, 0, 0], [0, 0, 1, 0]])
        for limit, is_near in ((Fraction(1, 3), True), ("1/3", True), (0.3333, False), (1, True)):
            self.assertIs(scene.within(limit, 0, 1), is_near)
        with self.assertRaises(Error):
            scene.pairs_within("far")
        with self.assertRaises(Error):
            query.zone(float("nan"), poses)

    def test_contacts_tell_normals_of_placed_faces(self):
        cube = Body(*CUBE)
        turned = [["3/5", "-4/5", 0, 1], ["4/5", "3/5", 0, 0], [0, 0, -1, 1]]  # a mirror image
        found = Query(cube, cube).contacts(turned)
        normals = found.normals()
        self.assertEqual(normals.shape, (len(found), 2, 2, 3))
        of_model = np.array([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]])
        matrix = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, -1]])
        self.assertTrue((normals[:, 0] == of_model[found.faces[:, 0]][:, None]).all())
        exact = of_model[found.faces[:, 1]] @ matrix.T
        self.assertTrue((normals[:, 1, 0] <= exact).all() and (exact <= normals[:, 1, 1]).all())
        self.assertTrue((normals[:, 1, 1] <= np.nextafter(normals[:, 1, 0], 2)).all())
        self.assertEqual(Query(cube, cube).contacts(translations([3, 0, 0])[0]).normals().shape, (0, 2, 2, 3))

    def test_relations(self):
        query = Query(Body(*CUBE), Body(*CUBE))
        poses = translations([0.25, 0.25, 0.25], [0.25, 0.25, 0.25], [1, 1, 1], [2, 0, 0])
        poses[0, :, :3] /= 4
        said = query.relation(poses)
        self.assertEqual(said.tolist(), ["b_in_a", "surfaces", "surfaces", "apart"])
        self.assertEqual(query.relation(None, poses_a=poses[0]), "a_in_b")
        self.assertEqual(Query(Body(*CUBE), Body(*CUBE), "surface").relation(poses[0]), "apart")

    def test_relations_and_overlaps_of_solids(self):
        query = Query(Body(*CUBE), Body(*CUBE))
        poses = translations([0.25, 0.25, 0.25], [0.5, 0, 0], [1, 0, 0], [1, 1, 1], [2, 0, 0], [0, 0, 0])
        poses[0, :, :3] /= 4
        relations, dimensions = query.solid_relation(poses)
        self.assertEqual(relations.tolist(), ["contains", "overlap", "meet", "meet", "disjoint", "equal"])
        self.assertEqual(dimensions.tolist(), [-1, 2, 2, 0, -1, 2])
        self.assertEqual(query.solid_relation(None, poses_a=poses[0]), ("inside", -1))
        overlap = query.overlap(poses)
        self.assertEqual(overlap["volume"].tolist(), [1 / 64, 0.5, 0, 0, 0, 1])
        self.assertEqual(overlap["exact_volume"][0], Fraction(1, 64))
        self.assertEqual(overlap["centroid"][1].tolist(), [0.75, 0.5, 0.5])
        self.assertEqual(overlap["contact_area"].tolist(), [[0, 0], [2, 2], [1, 1], [0, 0], [0, 0], [6, 6]])
        self.assertEqual(overlap["contact_vector"][2].tolist(), [1, 0, 0])
        self.assertEqual(query.overlap(poses[1])["exact_centroid"], (Fraction(3, 4), Fraction(1, 2), Fraction(1, 2)))
        scene = tetracone.Scene([Body(*CUBE)] * 2)
        scene.frame(poses[[5, 2]])
        self.assertEqual(scene.solid_relation(0, 1), ("meet", 2))
        scene.frame(poses[[5, 1]])
        self.assertEqual(scene.overlap(0, 1)["exact_centroid"], (Fraction(3, 4), Fraction(1, 2), Fraction(1, 2)))
        self.assertEqual(scene.overlap(0, 1)["contact_area"].tolist(), [2, 2])
        self.assertEqual(scene.exits([0, -2, 0], 0, 1)["exact_last"], Fraction(1, 2))
        self.assertEqual(scene.depth(0, 1)["exact_vector"], (Fraction(-1, 2), 0, 0))
        self.error("query: kernel double tells no relation of solids; expected adaptive",
                   Query(Body(*CUBE), Body(*CUBE), kernel="double").solid_relation, IDENTITY)

    def test_exits_along_a_direction(self):
        query = Query(Body(*CUBE), Body(*CUBE))
        poses = translations([0.5, 0, 0], [0, 0, 0.25], [2, 0, 0])
        exits = query.exits([1, 0, 0], poses)
        self.assertEqual(exits["first"].tolist(), [1.5, 1, 0])
        self.assertEqual(exits["last"].tolist(), [1.5, 1, 0])
        self.assertEqual(query.exits(("3/2", 0, Fraction(1, 7)), poses[0])["exact_last"], 1)
        self.assertEqual(query.exits([-3.0, 0, 0], None, poses_a=poses[0])["exact_first"], Fraction(1, 2))
        tiny = Fraction(1, 10 ** 4400)  # Python refuses to read so many decimal digits
        self.assertEqual(query.exits([1, 0, 0], [[1, 0, 0, tiny], [0, 1, 0, 0], [0, 0, 1, 0]])["exact_last"], 1 + tiny)
        self.error("exits: the direction is 0; expected a vector of some length", query.exits, [0, 0, 0], IDENTITY)
        self.error("exits: a direction of 2 numbers; expected 3", query.exits, [1, 0], IDENTITY)
        self.error("exits: 'nan' in the direction; expected a finite decimal number or a fraction n/d",
                   query.exits, [0, float("nan"), 0], IDENTITY)

    def test_depths(self):
        query = Query(Body(*CUBE), Body(*CUBE))
        depth = query.depth(translations([0.5, 0.25, 0], [2, 0, 0]))
        self.assertEqual(depth["bounds"].tolist(), [[0.5, 0.5], [0, 0]])
        self.assertEqual(depth["vector"].tolist(), [[-0.5, 0, 0], [0, 0, 0]])
        self.assertEqual(depth["is_exact"].tolist(), [True, True])
        one = query.depth(None, poses_a=translations([1 / 4, 0, 0])[0], relative=0.5)
        self.assertEqual(one["exact_square"], Fraction(9, 16))
        self.assertEqual(one["exact_vector"], (Fraction(3, 4), 0, 0))
        self.error("depth: a relative width of 2; expected a number from 0 to below 1",
                   lambda: query.depth(IDENTITY, relative=2))

    def test_certificates_are_proved_by_the_checker(self):
        query, poses = Query(Body(*CUBE), Body(*TETRAHEDRON)), random_poses(12, 3)
        asked = {"collide": {}, "distance": {}, "within": {"limit": Fraction(1, 3)}, "relation": {}, "exits": {"direction": [1, 0, "1/3"]}, "depth": {"budget": 100}}
        for ask, more in asked.items():
            proofs = query.certificate(poses, ask=ask, **more)
            run = subprocess.run(["/usr/bin/python3", "-B", CHECKER, "-"], input=json.dumps(proofs) + "\n", capture_output=True, text=True)
            self.assertEqual(run.stdout, "proved\n", ask)
            if ask in ("collide", "distance", "within"):
                self.assertEqual(len(proofs["answers"]), len(poses))
        said = [answer["answer"] != "apart" for answer in query.certificate(poses)["answers"]]
        self.assertEqual(said, query.collide(poses).tolist())
        self.assertEqual(query.certificate(None, poses_a=poses[0])["answers"][0]["pose_b"], ["1", "0", "0", "0"] + ["0", "1", "0", "0"] + ["0", "0", "1", "0"])
        self.error("certificate: ask 'volume'; expected collide, distance, within, relation, exits or depth", query.certificate, poses, ask="volume")
        self.error("depth: a relative width of 2; expected a number from 0 to below 1", query.certificate, poses, ask="depth", relative=2)

    def test_poses_of_both_bodies_go_by_keyword(self):
        cube = Body(*CUBE)
        query, scene = Query(cube, cube), tetracone.Scene([cube] * 2)
        small = np.diag([0.25, 0.25, 0.25, 1])[:3]
        small[:, 3] = 0.25
        self.assertEqual(query.relation(poses_a=small, poses_b=IDENTITY), "a_in_b")
        self.assertEqual(query.relation(poses_b=small, poses_a=IDENTITY), "b_in_a")
        for name in ("collide", "relation", "solid_relation", "overlap", "distance", "features", "contacts"):
            with self.assertRaisesRegex(TypeError, rf"^query: poses of both .*; expected {name}\(poses_a=..., poses_b=...\)$"):
                getattr(query, name)(small, IDENTITY)
        for name, first in (("within", "limit"), ("zone", "limit"), ("exits", "direction")):
            with self.assertRaisesRegex(TypeError, rf"expected {name}\({first}, poses_a=..., poses_b=...\)$"):
                getattr(query, name)(1, small, IDENTITY)
        with self.assertRaisesRegex(TypeError, r"expected first_contact\(poses_a0=..., poses_a1=..., poses_b0=..., poses_b1=...\)$"):
            query.first_contact(small, small, IDENTITY, IDENTITY)
        with self.assertRaisesRegex(TypeError, r"expected first_contacts\(poses_0=..., poses_1=...\)$"):
            scene.first_contacts([IDENTITY] * 2, [IDENTITY] * 2)

    def test_bodies_that_stand_nowhere_have_no_pairs(self):
        scene = tetracone.Scene([Body(*CUBE)] * 2)
        self.error("scene: no body has a pose; expected a body that is placed before pairs are asked for", scene.pairs)
        scene.place(0, IDENTITY)
        self.assertEqual(scene.pairs().tolist(), [])
        scene.place(1, IDENTITY)
        self.assertEqual(scene.pairs().tolist(), [[0, 1]])
        self.assertEqual(tetracone.Scene().pairs().tolist(), [])

    def test_rigid_motions_of_matrices_are_those_of_their_quaternions(self):
        cube = Body(*CUBE)
        query = Query(cube, cube)
        start = np.array([[0.6, -0.8, 0, 3], [0.8, 0.6, 0, 0.25], [0, 0, 1, 0.25], [0, 0, 0, 1]])
        end = np.array([[0, 1, 0, 0.5], [-1, 0, 0, 0.25], [0, 0, 1, 0.25], [0, 0, 0, 1]])
        half = np.sqrt(0.5)
        lo, hi = query.first_contact(start, end, kind="rigid")
        # The quaternions of the matrices turn on the short way round: through the identity.
        quaternions = [[2 / np.sqrt(5), 0, 0, 1 / np.sqrt(5), 3, 0.25, 0.25], [half, 0, 0, -half, 0.5, 0.25, 0.25]]
        np.testing.assert_allclose((lo, hi), query.motion(*quaternions, kind="rigid"), rtol=1e-12)
        self.assertTrue(0 < lo < 1)
        self.assertEqual(query.first_contact(start[None], end, kind="rigid").shape, (1, 2))
        for wrong in (2 * start, np.diag([1, 1, -1, 1]), start + 1e-3 * np.eye(4, k=1)):
            wrong[3] = [0, 0, 0, 1]
            self.error("poses_b0, poses_b1: the 3x3 part at t = 1 is no rotation; expected one to 1e-5 in each entry, or quaternions",
                       query.first_contact, start, wrong, kind="rigid")

    def test_first_contacts_of_a_scene_are_those_of_its_pairs(self):
        random, n = np.random.default_rng(8), 16
        tetrahedron = Body(*TETRAHEDRON)
        scene, query = tetracone.Scene([tetrahedron] * n), Query(tetrahedron, tetrahedron)
        linear = [translations(*random.integers(-2, 3, (n, 3))) for _ in range(2)]
        rigid = [np.hstack([random.uniform(0.1, 1, (n, 4)), random.integers(-2, 3, (n, 3))]) for _ in range(2)]
        for kind, (start, end) in (("linear", linear), ("rigid", rigid)):
            pairs, times = scene.first_contacts(end, poses_0=start, kind=kind)
            expected = []
            for a in range(n):
                for b in range(a + 1, n):
                    first = query.first_contact(start[b], end[b], poses_a0=start[a], poses_a1=end[a], kind=kind)
                    expected += [(*first, a, b)] if first else []
            self.assertGreater(len(expected), 3)
            self.assertEqual([(*t, *p) for t, p in zip(times.tolist(), pairs.tolist())], sorted(expected))
        for number, pose in enumerate(linear[0]):
            scene.place(number, pose)
        for placed, given in zip(scene.first_contacts(linear[1]), scene.first_contacts(linear[1], poses_0=linear[0])):
            self.assertEqual(placed.tolist(), given.tolist())

    def test_a_hole_is_empty(self):
        frame, rod = Body(*FRAME), Body(*CUBE)
        self.assertTrue(frame.is_closed)
        self.assertEqual(frame.inside([[1.5, 1.5, 0.5], [0.5, 0.5, 0.5], [1, 1.5, 0.5], [1.5, 1.5, 1]]).tolist(), [-1, 1, 0, -1])
        thin = [[0.5, 0, 0, 1.25], [0, 0.5, 0, 1.25], [0, 0, 4, -1]]
        self.assertFalse(Query(frame, rod).collide(thin))
        thin[0][3] = 1.5
        self.assertTrue(Query(frame, rod).collide(thin))

    def test_every_kernel_and_method_answers(self):
        poses = translations([0.5, 0.5, 0.5], [3, 0, 0])
        for kernel in tetracone.kernels:
            for method in tetracone.methods:
                for remember in (False, True):
                    query = Query(Body(*CUBE), Body(*TETRAHEDRON), kernel=kernel, method=method, remember=remember)
                    self.assertEqual(query.collide(poses).tolist(), [True, False], (kernel, method))

    def test_statistics_count_poses(self):
        query = Query(Body(*CUBE), Body(*TETRAHEDRON))
        query.collide(random_poses(7, 2))
        self.assertEqual(query.statistics["queries"], 7)
        self.assertGreater(query.statistics["bounding_tests"], 0)
        self.assertGreater(query.bytes, 0)
        self.assertGreater(query.node_count, 0)
        query.clear_statistics()
        self.assertEqual(set(query.statistics.values()), {0})


class Arrays(unittest.TestCase):
    """Poses of every kind of array have the answers that their numbers have."""

    query = Query(Body(*CUBE), Body(*TETRAHEDRON))

    def test_poses_of_any_strides_and_types(self):
        poses = random_poses(50, 3)
        answers = self.query.collide(poses).tolist()
        square = np.zeros((50, 4, 4))
        square[:, :3], square[:, 3, 3] = poses, 1
        padded = np.zeros((100, 5, 7))
        padded[::2, 1:4, 2:6] = poses
        for same in (square, padded[::2, 1:4, 2:6], np.asfortranarray(poses), poses.astype(">f8"), poses.astype(object), poses.tolist(),
                     np.array([[[repr(x) for x in row] for row in pose] for pose in poses.tolist()]), poses.astype(np.longdouble)):
            self.assertEqual(self.query.collide(same).tolist(), answers)
        backwards = poses[::-1]
        self.assertEqual(self.query.collide(backwards).tolist(), answers[::-1])
        whole = translations([1, 0, 0], [2, 0, 0], [-1, 0, 0])
        for kind in ("i1", "i4", "i8", "f4", "f2"):
            self.assertEqual(self.query.collide(whole.astype(kind)).tolist(), self.query.collide(whole).tolist())

    def test_poses_of_doubles_are_not_written(self):
        poses = random_poses(5, 4)
        before = poses.copy()
        poses.flags.writeable = False
        self.query.collide(poses)
        self.assertTrue((poses == before).all())

    def test_one_pose_of_either_goes_with_many_of_the_other(self):
        poses = random_poses(20, 5)
        one = poses[0]
        both = self.query.collide(poses, poses_a=np.repeat(one[None], 20, 0))
        self.assertEqual(self.query.collide(poses, poses_a=one).tolist(), both.tolist())
        self.assertEqual(self.query.collide(poses, poses_a=one[None]).tolist(), both.tolist())
        self.assertEqual(self.query.collide(one, poses_a=poses).tolist(), self.query.collide(np.repeat(one[None], 20, 0), poses_a=poses).tolist())
        self.assertIs(type(self.query.collide(one)), bool)
        self.assertIs(type(self.query.collide(None)), bool)
        self.assertEqual(self.query.collide(one[None]).shape, (1,))
        self.assertEqual(self.query.collide(np.zeros((0, 3, 4))).shape, (0,))
        self.assertEqual(self.query.collide(np.zeros((0, 3, 4)), poses_a=one[None]).shape, (0,))

    def test_numbers_that_are_no_doubles_are_exact(self):
        # Between 1 and the next double: apart in truth, touching when rounded.
        def pose(x):
            return [[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, 0]]

        cube = Body(*CUBE)
        query = Query(cube, cube)
        tiny = Fraction(1, 10**40)
        for x, touches in ((1 + tiny, False), (1 - tiny, True), (1, True), (str(1 + tiny), False), (Decimal(1) + Decimal("1e-20"), False),
                           (np.longdouble(1) + np.finfo(np.longdouble).eps, False)):
            self.assertEqual(query.collide(np.array(pose(x), dtype=object)), touches, x)
        self.assertTrue(query.collide(pose(float(1 + tiny))))
        third = Fraction(1, 3)
        self.assertEqual(cube.inside([[third, third, 1 + tiny], [third, third, 1], [third, third, 1 - tiny]]).tolist(), [-1, 0, 1])
        # 2^53 + 1 is no double.
        n = 2**53
        far = translations([1, 0, 0]).astype(object)
        far[0, 0, 3] = n + 2
        near = translations([n, 0, 0])
        self.assertFalse(query.collide(far, poses_a=near)[0])
        far[0, 0, 3] = n + 1
        self.assertTrue(query.collide(far, poses_a=near)[0])
        self.assertTrue(query.collide(far.astype("i8"), poses_a=near)[0])

    def test_numbers_in_lists_keep_their_values_beside_others(self):
        n, eps = 2**53, np.finfo(np.longdouble).eps
        cube, wide = Body(*CUBE), Body([[x * float(n), y, z] for x, y, z in CUBE[0]], CUBE[1])
        single = np.float32(0.1)
        thin = Body([[x * float(single), y, z] for x, y, z in CUBE[0]], CUBE[1])
        for body, point, place in ((wide, [n + 1, 0.5, 0.5], -1), (wide, [n + 1, "1/2", 0.5], -1), (wide, [float(n), 0.5, 0.5], 0), (wide, [n - 1, 0.5, 0.5], 1),
                                   (wide, [2**63 + 1, -1, 0], -1), (thin, [single, "1/2", "1/2"], 0), (thin, [single, 0.5, "1/2"], 0), (thin, [0.1, "1/2", 0.5], 1),
                                   (cube, [np.longdouble(1) + eps, "1/2", "1/2"], -1), (cube, [np.longdouble(1) + eps, 0.5, 0.5], -1)):
            for points in (point, tuple(point)):
                self.assertEqual(body.inside(points), place, point)
                self.assertEqual(body.inside([points, [9e9, 9e99, 9]]).tolist(), [place, -1], point)
        self.assertFalse(Query(wide, cube).collide([[1, 0, 0, n + 1], [0, 1, 0, 0.5], [0, 0, 1, 0.5]]))
        self.assertTrue(Query(wide, cube).collide([[1, 0, 0, n], [0, 1, 0, 0.5], [0, 0, 1, 0.5]]))
        self.assertEqual(cube.first_hit([-1e17, 0.5, 0.5], [1, 0, 0])[1], 1e17)  # doubles stay doubles
        with self.assertRaisesRegex(Error, "is no double"):
            Body([[0, 0, 0], [1, 0, 0], [0.5, 1, n + 1]], [[0, 1, 2]])

    def test_a_pose_of_four_rows_may_be_of_fractions(self):
        pose = np.array([[Fraction(1, 3), 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=object)
        self.assertTrue(self.query.collide(pose))
        pose[3, 0] = Fraction(1, 7)
        with self.assertRaisesRegex(Error, "poses_b: entry 1 of the last row is 1/7; expected 0 0 0 1"):
            self.query.collide(pose)


class Errors(Case):

    def test_every_wrong_pose_is_named(self):
        cube = Body(*CUBE)
        collide = Query(cube, cube).collide
        poses = random_poses(9, 6)
        for k, value, line in ((4, np.nan, "poses_b[4]: entry 12 of 12 is nan; expected a finite number"),
                               (8, -np.inf, "poses_b[8]: entry 12 of 12 is -inf; expected a finite number")):
            wrong = poses.copy()
            wrong[k, 2, 3] = value
            self.error(line, collide, wrong)
            self.error(line.replace("_b", "_a"), collide, poses, poses_a=wrong)
            texts = "poses_b[%d]: entry 12 of 12 is '%s'; expected a finite decimal number or a fraction n/d" % (k, value)
            self.error(texts, collide, wrong.astype(object))
        flat = poses.copy()
        flat[3, :, :3] = 0
        self.error("poses_b[3]: the 3x3 part has determinant 0; expected a matrix that flattens nothing", collide, flat)
        self.error("poses_b: the 3x3 part has determinant 0; expected a matrix that flattens nothing", collide, flat[3])
        square = np.zeros((2, 4, 4))
        square[:, :3], square[:, 3, 3] = IDENTITY, 1
        square[1, 3, 1] = 0.5
        self.error("poses_b[1]: entry 2 of the last row is 0.5; expected 0 0 0 1", collide, square)
        shapes = "expected (n, 3, 4) or (n, 4, 4), or one pose (3, 4) or (4, 4)"
        for shape in ((), (12,), (3, 3), (2, 4, 3), (2, 2, 3, 4), (4, 5)):
            self.error(f"poses_b: an array of shape {shape}; {shapes}", collide, np.ones(shape))
        self.error("query: 2 poses of a and 3 of b; expected as many, or one of either", collide, poses[:3], poses_a=poses[:2])
        self.error("poses_b: rows of different lengths; expected an array of numbers", collide, [[1, 2], [3]])
        self.error("poses_b: an array of complex128; expected numbers", collide, poses.astype(complex))
        self.error("poses_b: entry 1 of 12 is 'a dict'; expected a finite decimal number or a fraction n/d", collide,
                   np.full((3, 4), {}, dtype=object))
        self.error("poses_b: entry 1 of 12 is '1/0'; expected a finite decimal number or a fraction n/d", collide, [["1/0"] * 4] * 3)

    def test_every_wrong_body_has_its_line(self):
        v, f = CUBE
        numbers = "expected numbers from 0 to 8, the last excluded"
        for vertices, faces, line in (
                (v, [], "body: no face; expected a body with faces"),
                (v, [[0, 1, 8]], f"body: face 0 names vertex 8 of 8 vertices; {numbers}"),
                (v, np.array([[0, 1, 2], [0, 1, -1]]), f"body: face 1 names vertex -1 of 8 vertices; {numbers}"),
                (v, [[0, 1, 2**70]], f"body: face 0 names vertex {2**70} of 8 vertices; {numbers}"),
                (v, [[0, 1, 2.0]], "body: face 0 has a corner of type float; expected vertex numbers, or loops of them"),
                (v, [[0, 1, 2], 3], "body: face 1 is of type int; expected a sequence of vertex numbers, or of loops of them"),
                (v, [[[0, 1, 2], 3]], "body: face 0 has a loop of type int; expected sequences of vertex numbers"),
                (v, [[]], "body: face 0 is empty; expected vertex numbers"),
                (v, [[[0, 1, 2], []]], "body: face 0 has an empty loop; expected vertex numbers"),
                (v, 7, "faces: of type int; expected an array (m, k) of integers, or a sequence of faces"),
                ([[0, 0]], [[0]], "vertices: an array of shape (1, 2); expected (n, 3)"),
                ([[0, 0, np.nan]], [[0]], "body: vertex 0 has the coordinate nan; expected finite coordinates"),
                ([[0, 0, Fraction(1, 3)]], [[0]], "vertices[0]: '1/3' is no double; expected doubles"),
                ([[0, 0, 2**53 + 1]], [[0]], f"vertices[0]: '{2**53 + 1}/1' is no double; expected doubles")):
            self.error(line, Body, vertices, faces)
        lifted = [list(p) for p in v]
        lifted[7][0] = 1.5
        with self.assertRaisesRegex(Error, "^body: face 1 has a corner .* off its plane; expected exactly planar faces"):
            Body(lifted, f)

    def test_an_open_surface_has_no_solid(self):
        cube, opened = Body(*CUBE), Body(CUBE[0], CUBE[1][:-1])
        self.assertFalse(opened.is_closed)
        self.error("query: body b is open at 4 edges, first at the edge from vertex 1 to 3; expected a closed surface for Question::solid",
                   Query, cube, opened)
        self.error("body is open at 4 edges, first at the edge from vertex 1 to 3; expected a closed surface for points inside or outside",
                   opened.inside, [[0, 0, 0]])
        self.assertTrue(Query(cube, opened, "surface").collide(None))

    def test_every_other_misuse_has_its_line(self):
        cube = Body(*CUBE)
        self.error("query: question 'both'; expected solid or surface", Query, cube, cube, "both")
        self.error("query: kernel 'exact'; expected adaptive, double, float, double-eps=E, epick, epeck or rational", Query, cube, cube,
                   kernel="exact")
        self.error("query: method 'fast'; expected tree, tuned, paper, brute", Query, cube, cube, method="fast")
        self.error("points: an array of shape (2, 2); expected (n, 3), or one point (3,)", cube.inside, np.zeros((2, 2)))
        self.error("points[1]: y is nan; expected a finite number", cube.inside, [[0, 0, 0], [0, np.nan, 0]])
        self.error("points: z is 'top'; expected a finite decimal number or a fraction n/d", cube.inside, ["0", "0", "top"])
        self.error("faces[1]: face 6 of 6; expected a face's number", cube.normals, [0, 6])
        for face in (-2, 0.5, np.nan, 2**40):
            self.error(f"faces: {face}; expected a face's number, or -1 for no face", cube.crossings, [0, 0, 0], [1, 0, 0], face)
        self.error("faces: an array of shape (1, 2); expected (n,), or one number", cube.normals, [[0, 1]])
        self.error("rays: 2 of them, and 3 numbers for them; expected as many, or one of either", cube.first_hit, np.zeros((2, 3)), [1, 0, 0], [1, 2, 3])
        self.error("end: numbers that are no doubles; expected doubles", cube.is_hit, [0, 0, 0], [1, 0, 0], "1/3")
        for ask in (cube.first_hit, cube.hits, cube.is_hit):
            self.error("ray: the end is nan; expected a number", ask, [0, 0, 0], [1, 0, 0], np.nan)
            self.error("rays[1]: the direction is 0; expected one of any other length", ask, [0, 0, 0], [[1, 0, 0], [0, 0, 0]])
            self.error("ray: number 2 of 6 is nan; expected a finite number", ask, [0, np.nan, 0], [1, 0, 0])
            self.error("rays: 2 origins and 3 directions; expected as many, or one of either", ask, np.zeros((2, 3)), np.ones((3, 3)))
            self.error("directions: an array of shape (2,); expected (n, 3), or one direction (3,)", ask, [0, 0, 0], [1, 0])
            self.error("origins: numbers that are no doubles; expected doubles", ask, ["1/3", "0", "0"], [1, 0, 0])
        scene = tetracone.Scene([cube] * 2)
        self.error("scene: body 0 has no pose; expected a placed body", scene.first_contacts, [IDENTITY] * 2)
        self.error("scene: 3 poses of 2 bodies; expected one a body", scene.first_contacts, [IDENTITY] * 3)
        self.error("motion: 2 poses at t = 0 and 3 at t = 1; expected as many, or one of either", scene.first_contacts,
                   np.ones((3, 7)), poses_0=np.ones((2, 7)), kind="rigid")
        for direction in ("123", {1: 2, 2: 3, 3: 4}, 7):
            self.error(f"exits: a direction of type {type(direction).__name__}; expected 3 numbers", Query(cube, cube).exits, direction, None)
        for use in (lambda: scene.add(None), lambda: scene.replace(0, None)):
            with self.assertRaises(TypeError):
                use()
        with self.assertRaises(ValueError):  # what numpy's users catch
            Query(cube, cube, "both")

    def test_a_file_s_error_is_the_program_s(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "bad.off")
            with open(name, "w") as file:
                file.write("OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n")
            with self.assertRaises(Error) as raised:
                tetracone.read(name)
            self.assertRegex(str(raised.exception), r"^.*bad\.off:4: ")
            if PROGRAM:
                said = subprocess.run([PROGRAM, "collide", name, name], capture_output=True, text=True)
                self.assertEqual((said.returncode, said.stderr), (2, f"{raised.exception}\n"))


class Objects(unittest.TestCase):
    def test_bodies_say_what_they_were_made_of(self):
        body = Body(*FRAME)
        self.assertEqual(body.vertices.tolist(), [[float(x) for x in v] for v in FRAME[0]])
        self.assertEqual(body.faces[0], [(8, 9, 10, 11), (15, 14, 13, 12)])
        self.assertEqual(body.faces[2], [(0, 1, 9, 8)])
        with self.assertRaises(ValueError):
            body.vertices[0, 0] = 7
        vertices = body.vertices
        del body
        self.assertEqual(vertices[1].tolist(), [3, 0, 0])  # the view keeps the body

    def test_a_body_is_its_own_when_its_arrays_change(self):
        vertices, faces = np.array(CUBE[0], float), np.array(CUBE[1])
        body = Body(vertices, faces)
        vertices[:] = np.nan
        faces[:] = 0
        self.assertEqual(body.inside([0.5, 0.5, 0.5]), 1)

    def test_a_saved_body_answers_as_the_one_that_was_made(self):
        body = Body(*FRAME)
        poses = np.eye(3, 4)[None] + np.linspace(0, 9, 40)[:, None, None] * [[0, 0, 0, 1], [0, 0, 0, 0.5], [0, 0, 0, 0.25]]
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "frame.body")
            body.save(name)
            saved = tetracone.read(name)
            self.assertEqual(saved.faces, body.faces)
            answers = Query(saved, saved).collide(poses)
            self.assertEqual(answers.tolist(), Query(body, body).collide(poses).tolist())
            self.assertTrue(answers.any() and not answers.all())
            with open(name, "r+b") as file:
                file.seek(400)
                byte = file.read(1)
                file.seek(400)
                file.write(bytes([byte[0] ^ 1]))
            with self.assertRaisesRegex(Error, r"frame\.body: is spoiled"):
                tetracone.read(name)
            with self.assertRaisesRegex(Error, r"\.body"):
                body.save(os.path.join(folder, "frame.off"))

    def test_bodies_are_pickled(self):
        with tempfile.TemporaryDirectory() as folder:
            saved, again_saved = os.path.join(folder, "frame.body"), os.path.join(folder, "again.body")
            subprocess.run([PROGRAM, "save", CHECKER.parents[2] / "verify/test/models/frame.poly", "--out", saved], check=True)
            for body in (Body(*CUBE), Body(*FRAME), tetracone.read(saved)):
                for again in (copy.deepcopy(body), *(pickle.loads(pickle.dumps(body, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1))):
                    self.assertEqual((again.vertices.tolist(), again.faces), (body.vertices.tolist(), body.faces))
                    body.save(saved)
                    again.save(again_saved)
                    self.assertEqual(pathlib.Path(again_saved).read_bytes(), pathlib.Path(saved).read_bytes())
            self.assertGreater(len(body.triangles), 10)
            for forged in (body.triangles[1:], body.triangles + 1, body.triangles[:, :3], body.triangles + 0.5, body.triangles - 99.0, np.vstack([body.triangles] * 2)):
                with self.assertRaises(Error):
                    Body(body.vertices, body.faces, forged)

    def test_the_examples_of_the_docstrings(self):
        self.assertEqual(examples_failed(tetracone), 0)

    def test_the_examples_of_the_readme(self):
        name = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "..", "tetratree", "python", "README.md")
        failed, attempted = doctest.testfile(name, module_relative=False, encoding="utf-8")
        self.assertEqual(failed, 0)
        self.assertGreater(attempted, 5)


class Threads(unittest.TestCase):
    def test_queries_run_beside_each_other_and_share_bodies(self):
        a, b = Body(*CUBE), Body(*TETRAHEDRON)
        poses = random_poses(2000, 8)
        expected = Query(a, b).collide(poses).tolist()
        shared, answers = Query(a, b), {}

        def ask(k):
            query = shared if k % 2 else Query(a, b)
            answers[k] = query.collide(poses).tolist()
            query.statistics

        threads = [threading.Thread(target=ask, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(answers, {k: expected for k in range(4)})

    def test_others_run_while_a_query_answers(self):
        query = Query(Body(*CUBE), Body(*CUBE), kernel="rational", method="brute")
        poses = np.tile(IDENTITY, (4000, 1, 1))
        counted, done = 0, threading.Event()

        def ask():
            query.collide(poses)
            done.set()

        thread = threading.Thread(target=ask)
        thread.start()
        while not done.is_set():
            counted += 1
            time.sleep(0.001)
        thread.join()
        self.assertGreater(counted, 2)

    def test_ctrl_c_ends_a_batch(self):
        query = Query(Body(*CUBE), Body(*CUBE), kernel="rational", method="brute")
        poses = np.broadcast_to(IDENTITY, (10**8, 3, 4))  # hours
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            query.collide(poses)
        timer.join()


if __name__ == "__main__":
    unittest.main()
