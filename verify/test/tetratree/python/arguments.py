#!/usr/bin/python3
"""Tests of what the package `tetracone` makes of arguments of any kind: arrays, texts, files' names, signals, objects that nobody made."""

import faulthandler
import os
import pathlib
import signal
import tempfile
import threading
import time
import unittest
from fractions import Fraction

from support import CUBE, off_of

import numpy as np
import tetracone
from tetracone import Body, Error, Query

faulthandler.dump_traceback_later(120, exit=True)  # what waits for itself is a failure, not a hang
IDENTITY = np.eye(3, 4)
cube = Body(*CUBE)


class Case(unittest.TestCase):
    def error(self, line, function, *arguments, **options):
        with self.assertRaises(Error) as raised:
            function(*arguments, **options)
        self.assertEqual(str(raised.exception), line)


class Arrays(Case):
    query = Query(cube, cube)

    def test_no_poses_have_no_answers_whatever_they_would_be_made_of(self):
        for rows in (3, 4):
            for kind in ("f8", "i8", "?", "U3", object):
                none = np.empty((0, rows, 4), kind)
                for b, a in ((none, None), (None, none), (none, none), (IDENTITY, none), (none, [IDENTITY])):
                    self.assertEqual(self.query.collide(b, poses_a=a).shape, (0,), kind)
                    self.assertEqual(self.query.relation(poses_a=a, poses_b=b).shape, (0,), kind)
                    self.assertEqual(self.query.features(b, poses_a=a), [], kind)
        for kind in ("f8", object):
            self.assertEqual(cube.inside(np.empty((0, 3), kind)).shape, (0,))

    def test_poses_of_truth_values_and_unsigned_numbers_in_any_order_of_bytes(self):
        poses = np.tile(IDENTITY, (6, 1, 1))
        poses[:, :, 3] = [[0, 0, 0], [1, 1, 1], [1, 0, 0], [2, 0, 0], [0, 200, 0], [1, 1, 2]]
        answers = [True, True, True, False, False, False]
        for kind in ("u1", "u2", ">u2", "u4", ">u4", "u8", ">u8", ">i2", ">i4", ">i8", ">f4", ">f8"):
            same = poses.astype(kind)
            apart = np.zeros((6, 3, 8), kind)
            apart[:, :, ::2] = same
            for these in (same, apart[:, :, ::2], np.asfortranarray(same), same[::-1][::-1]):
                self.assertEqual(self.query.collide(these).tolist(), answers, kind)
        self.assertEqual(self.query.collide(poses[:3].astype(bool)).tolist(), answers[:3])
        # More than a signed number holds: -1 would touch.
        far = IDENTITY.astype("u8")
        far[0, 3] = 2**64 - 1
        self.assertFalse(self.query.collide(far))

    def test_vertices_and_faces_of_every_kind_of_integer(self):
        vertices, faces = np.array(CUBE[0]), np.array(CUBE[1])
        for kind in ("?", "u1", ">i2", "u8", ">u8", ">f4", "f2"):
            self.assertEqual(Body(vertices.astype(kind), faces).vertices.tolist(), vertices.tolist(), kind)
        for kind in ("u1", "i1", "u2", ">u2", ">i4", ">u8", "u8", "i8"):
            wide = np.full((6, 8), 99, kind)
            wide[:, ::2] = faces
            for these in (faces.astype(kind), wide[:, ::2], np.asfortranarray(faces.astype(kind)), list(faces.astype(kind)),
                          faces.astype(kind).reshape(6, 1, 4)):
                self.assertEqual(Body(vertices, these).faces, cube.faces, kind)
        self.error("body: face 0 names vertex 18446744073709551615 of 8 vertices; expected numbers from 0 to 8, the last excluded", Body,
                   vertices, np.array([[0, 1, 2**64 - 1]], "u8"))
        digits = "1" + 39 * "0"  # Python refuses to write all of them
        self.error(f"body: face 0 names vertex {digits} of 8 vertices; expected numbers from 0 to 8, the last excluded", Body, vertices,
                   [[0, 1, 10**5000]])

    def test_truth_values_and_texts_are_no_vertex_numbers(self):
        corner = "body: face 0 has a corner of type {}; expected vertex numbers, or loops of them"
        face = "body: face 0 is of type {}; expected a sequence of vertex numbers, or of loops of them"
        all_faces = "faces: of type {}; expected an array (m, k) of integers, or a sequence of faces"
        for faces, line in (([[0, 1, True]], corner.format("bool")), ([[np.True_, 1, 2]], corner.format(np.bool_.__name__)),
                            (np.ones((2, 3), bool), corner.format(np.bool_.__name__)), (["012"], face.format("str")), ([b"\0\1\2"], face.format("bytes")),
                            ("012", all_faces.format("str")), (b"\0\1\2", all_faces.format("bytes")), ({0: 1}, all_faces.format("dict")),
                            ((f for f in CUBE[1]), all_faces.format("generator")), (np.ones((2, 3)), corner.format("float64"))):
            self.error(line, Body, CUBE[0], faces)

    def test_a_text_is_no_array(self):
        for text in ("1 0 0", b"1 0 0"):
            self.error("poses_b: an array of shape (); expected (n, 3, 4) or (n, 4, 4), or one pose (3, 4) or (4, 4)", self.query.collide, text)
            self.error("points: an array of shape (); expected (n, 3), or one point (3,)", cube.inside, text)
            self.error("vertices: an array of shape (); expected (n, 3)", Body, text, CUBE[1])
        self.error("poses_b: entry 1 of 12 is 'a bytes'; expected a finite decimal number or a fraction n/d", self.query.collide,
                   np.full((3, 4), b"1"))

    def test_vertices_of_texts_are_the_nearest_doubles_or_exactly_fractions(self):
        made = Body([["0.1", "0", "1e-1"], ["1/2", "0", "0"], ["0", "3/1", "0"]], [[0, 1, 2]])
        self.assertEqual(made.vertices.tolist(), [[0.1, 0, 0.1], [0.5, 0, 0], [0, 3, 0]])

    def test_the_last_row_of_a_pose_of_texts_is_any_way_to_write_0_0_0_1(self):
        pose = [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0.0", "-0", "0/7", "1.00"]]
        self.assertTrue(self.query.collide(pose))
        pose[3][2] = "7" * 100
        self.error(f"poses_b: entry 3 of the last row is {'7' * 40}; expected 0 0 0 1", self.query.collide, pose)

    def test_masked_entries_are_refused_and_arrays_without_any_are_arrays(self):
        one = np.eye(3, 4) == 1
        self.assertTrue(self.query.collide(np.ma.masked_array(IDENTITY)))
        self.assertTrue(self.query.collide([np.ma.masked_array(IDENTITY, mask=False)]).all())
        for masked in (np.ma.masked_array(IDENTITY, one), [np.ma.masked_array(IDENTITY, one)], [list(np.ma.masked_array(IDENTITY, one))]):
            self.error("poses_b: an array with masked entries; expected numbers", self.query.collide, masked)
        self.error("points: an array with masked entries; expected numbers", cube.inside, np.ma.masked_array([1, 2, 3], [0, 0, 1]))
        self.error("vertices: an array with masked entries; expected numbers", Body, np.ma.masked_array(CUBE[0], np.array(CUBE[0]) == 1), CUBE[1])
        self.error("faces: an array with masked entries; expected vertex numbers", Body, CUBE[0],
                   np.ma.masked_array(CUBE[1], np.array(CUBE[1]) == 7))

    def test_an_error_of_the_caller_s_own_object_is_that_error(self):
        class Broken:
            def __array__(self, *_):
                raise RuntimeError("broken")

            def __index__(self):
                raise RuntimeError("broken")

        with self.assertRaisesRegex(RuntimeError, "^broken$"):
            self.query.collide(Broken())
        with self.assertRaisesRegex(RuntimeError, "^broken$"):
            Body(CUBE[0], [[0, 1, Broken()]])


class Texts(Case):
    def test_names_of_any_letters_are_quoted_on_one_line(self):
        for said, shown in (("so\nlid", r"so\nlid"), ("so\udc80lid", r"so\udc80lid"), ("\x1b[2J", r"\x1b[2J"), ("fläche", "fläche")):
            self.error(f"query: question '{shown}'; expected solid or surface", Query, cube, cube, said)
            with self.assertRaisesRegex(Error, "^query: kernel "):
                Query(cube, cube, kernel=said)
        pose = IDENTITY.astype(object)
        pose[0, 0] = "\ud800\n"
        self.error(r"poses_b: entry 1 of 12 is '\ud800\n'; expected a finite decimal number or a fraction n/d", Query(cube, cube).collide, pose)

    def test_arguments_of_other_types_are_python_s_type_errors(self):
        for arguments in ((cube, cube, b"solid"), (cube, cube, None), (1, 2), (cube,)):
            with self.assertRaises(TypeError):
                Query(*arguments)
        for path in (3, None, [cube]):
            with self.assertRaises(TypeError):
                tetracone.read(path)


class Files(Case):
    def test_a_file_s_name_is_text_bytes_or_a_path(self):
        class Bytes_path:
            def __init__(self, path):
                self.path = path

            def __fspath__(self):
                return os.fsencode(self.path)

        with tempfile.TemporaryDirectory() as folder:
            for name in (b"cube.off", b"w\xfcrfel.off", "würfel \n.off".encode()):  # the second is no text in UTF-8
                path = os.path.join(os.fsencode(folder), name)
                with open(path, "w") as file:
                    file.write(off_of(cube))
                for same in (path, os.fsdecode(path), pathlib.Path(os.fsdecode(path)), Bytes_path(path)):
                    self.assertEqual(tetracone.read(same).faces, cube.faces)

    def test_a_name_of_no_file_has_its_line(self):
        for name, shown in ((b"no\xff.off", r"no\xff.off"), ("no\udcff.off", r"no\xff.off"), ("no\n.off", "no?.off")):
            self.error(f"{shown}: no such file; expected a file to read", tetracone.read, name)
        self.error(r"a\0: no name of a file; expected one without zero bytes", tetracone.read, "a\0b.off")
        self.error(r"a\ud800.off: no name of a file; expected one that the file system can spell", tetracone.read, "a\ud800.off")
        self.error("/: is a folder; expected a file", tetracone.read, "/")


class Objects(Case):
    def test_what_nobody_made_is_an_error(self):
        for use in (repr, lambda body: body.vertices, lambda body: body.inside([0, 0, 0]), lambda body: Query(body, body)):
            self.error("body: not made; expected Body(vertices, faces)", use, Body.__new__(Body))
        for use in (lambda query: query.collide(None), lambda query: query.statistics, lambda query: query.bytes):
            self.error("query: not made; expected Query(a, b)", use, Query.__new__(Query))
        for use in (len, tetracone.Scene.pairs):
            self.error("scene: not made; expected Scene(bodies)", use, tetracone.Scene.__new__(tetracone.Scene))
        for use in (len, tetracone.Contacts.curves):
            self.error("contacts: not made; expected Query.contacts", use, tetracone.Contacts.__new__(tetracone.Contacts))


class Signals(unittest.TestCase):
    """A signal while a batch is under way is answered within it."""

    slow = Query(cube, cube, kernel="rational", method="brute")
    hours = np.broadcast_to(IDENTITY, (10**8, 3, 4))

    def after(self, seconds, handler):
        before = signal.signal(signal.SIGALRM, handler)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, seconds)

    def test_what_answers_it_may_ask_the_same_query(self):
        answers = []

        def ask(*_):
            answers.append(self.slow.collide(None))
            raise InterruptedError("enough")

        self.after(0.15, ask)
        with self.assertRaisesRegex(InterruptedError, "enough"):
            self.slow.collide(self.hours)
        self.assertEqual(answers, [True])
        self.assertEqual(self.slow.relation(None), "surfaces")  # the query is as it was

    def test_a_batch_goes_on_after_a_signal_that_ends_nothing(self):
        noticed = []
        self.after(0.15, lambda *_: noticed.append(True))
        begun, poses = time.monotonic(), 2000
        while not noticed:  # as long as it takes for one to come within a batch
            self.assertTrue(self.slow.collide(self.hours[:poses]).all())
            poses *= 2
        self.assertLess(time.monotonic() - begun, 60)

    def test_points_are_interrupted_too(self):
        def stop(*_):
            raise KeyboardInterrupt

        self.after(0.15, stop)
        with self.assertRaises(KeyboardInterrupt):
            cube.inside(np.broadcast_to(np.full(3, 0.5), (10**8, 3)))

    def test_another_thread_s_batch_is_not_waited_for_with_the_interpreter_s_lock(self):
        def stop(*_):
            raise KeyboardInterrupt

        begun = threading.Event()

        def ask():
            begun.set()
            self.slow.collide(self.hours[:2000])

        thread = threading.Thread(target=ask)
        thread.start()
        begun.wait()
        self.after(0.1, stop)
        with self.assertRaises(KeyboardInterrupt):
            while True:
                self.slow.collide(self.hours[:2000])
        thread.join()


if __name__ == "__main__":
    unittest.main()
