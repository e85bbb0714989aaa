#!/usr/bin/python3
"""Tests of `tetracone.verify`: cases, truth, judgement, shrinking and case files, against the program's where it says them too."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tetratree", "python"))
from support import CUBE, PROGRAM, examples_failed

import numpy as np
from tetracone import Body, Error, Query, verify


def by(kernel, method="tree"):
    return lambda case: Query(case.a, case.b, case.question, kernel, method).collide(poses_a=case.pose_a, poses_b=case.pose_b)


class Harness(unittest.TestCase):
    def test_the_examples_of_the_docstrings(self):
        self.assertEqual(examples_failed(verify), 0)

    def test_families_and_cases(self):
        self.assertGreaterEqual(len(verify.families), 48)
        for family in ("stacked", "true-rotation"):
            for question in ("solid", "surface"):
                some = list(verify.cases(family, 4, seed=3, question=question))
                self.assertEqual([(c.family, c.seed, c.index, c.question) for c in some], [(family, 3, k, question) for k in range(4)])
        case = next(verify.cases("true-rotation", 1))
        self.assertTrue(any(isinstance(x, Fraction) for pose in (case.pose_a, case.pose_b) for x in pose.ravel()))

    def test_adaptive_is_never_wrong_and_float_is(self):
        wrong = 0
        for family in ("stacked", "true-rotation", "far-from-origin", "nested"):
            cases = list(verify.cases(family, 15))
            self.assertFalse(verify.judge(by("adaptive"), cases).wrong)
            wrong += len(verify.judge(by("float"), cases).wrong)
        self.assertGreater(wrong, 0)

    def test_judge_counts_each_way_to_be_wrong(self):
        cases = list(verify.cases("nested", 20))
        right = sum(map(verify.truth, cases))
        self.assertIn(right, range(1, 20))
        row = ("nested", "solid", 20)
        self.assertEqual(list(verify.judge(verify.truth, cases)), [(*row, 0, 0, 0)])
        self.assertEqual(list(verify.judge(lambda case: True, cases)), [(*row, 20 - right, 0, 0)])
        self.assertEqual(list(verify.judge(lambda case: False, cases)), [(*row, 0, right, 0)])
        self.assertEqual(list(verify.judge(lambda case: 1 / 0, cases)), [(*row, 0, 0, 20)])
        self.assertEqual(list(verify.judge(lambda case: None, cases)), [("nested", "solid", 0, 0, 0, 0)])
        answers = iter(range(20))
        table = verify.judge(lambda case: verify.truth(case) != (next(answers) == 7), cases)
        self.assertEqual([case.index for case in table.wrong], [7])

    def test_shrinking_keeps_what_is_wrong(self):
        case = next(c for c in verify.cases("far-from-origin", 60) if verify.truth(c) != by("float", "brute")(c))
        small = verify.shrink(case, by("float", "brute"), seconds=1)
        self.assertNotEqual(verify.truth(small), by("float", "brute")(small))
        self.assertEqual(verify.truth(small), verify.truth(case))
        corners = [sum(len(loop) for body in (c.a, c.b) for face in body.faces for loop in face) for c in (case, small)]
        self.assertLessEqual(corners[1], corners[0])
        with self.assertRaisesRegex(Error, "^shrink: the function is right about this case"):
            verify.shrink(case, verify.truth)
        with self.assertRaisesRegex(Error, "^shrink: the function declines this case"):
            verify.shrink(case, lambda case: None)

    def test_odd_answers_are_failures_and_numbers_that_say_yes_or_no_are_answers(self):
        class Broken:
            def __eq__(self, other):
                raise RuntimeError("broken")

        cases = list(verify.cases("nested", 2))
        for odd in ("yes", "", 2, -1, 0.0, 1.0, np.nan, [], [True], np.array([True]), np.array(1), Broken(), Fraction(1), NotImplemented):
            self.assertEqual(list(verify.judge(lambda case: odd, cases)), [("nested", "solid", 2, 0, 0, 2)], repr(type(odd)))
        for kind in (int, np.int8, np.uint64, np.bool_):
            self.assertEqual(list(verify.judge(lambda case: kind(verify.truth(case)), cases)), [("nested", "solid", 2, 0, 0, 0)])

    def test_shrinking_keeps_a_failure_and_takes_no_case_that_is_declined(self):
        case = next(c for c in verify.cases("nested", 20) if len(c.a.faces) > 4)
        for odd in (lambda c: "yes", lambda c: 1 / 0):
            self.assertLess(len(verify.shrink(case, odd, seconds=0.3).a.faces), len(case.a.faces))
        small = verify.shrink(case, lambda c: None if len(c.a.faces) < len(case.a.faces) else "yes", seconds=0.3)
        self.assertEqual(len(small.a.faces), len(case.a.faces))

    def test_ctrl_c_while_the_function_runs_ends_judging_and_shrinking(self):
        def pressed(case):
            os.kill(os.getpid(), signal.SIGINT)
            return None if by("adaptive")(case) else True

        cases = list(verify.cases("nested", 2))
        with self.assertRaises(KeyboardInterrupt):
            verify.judge(pressed, cases)
        with self.assertRaises(KeyboardInterrupt):
            verify.shrink(cases[0], pressed)

    def test_arguments_of_other_types_are_type_errors_that_say_so(self):
        cube = Body(*CUBE)
        case = verify.Case(cube, cube)
        for line, call in (("case: b is of type int; expected a Body", lambda: verify.Case(cube, 2)),
                           ("truth: case is of type int; expected a Case", lambda: verify.truth(3)),
                           ("judge: function is of type int; expected a function of a Case", lambda: verify.judge(3, [case])),
                           ("judge: a case is of type Body; expected a Case", lambda: verify.judge(verify.truth, [cube])),
                           ("shrink: function is of type NoneType; expected a function of a Case", lambda: verify.shrink(case, None)),
                           ("shrink: case is of type Body; expected a Case", lambda: verify.shrink(cube, verify.truth)),
                           ("write_case: case is of type Body; expected a Case", lambda: verify.write_case("x.case.json", cube))):
            with self.assertRaises(TypeError) as raised:
                call()
            self.assertEqual(str(raised.exception), line)
        numbers = "is below 0 or has more than 64 bits; expected a number from 0 to 2\\^64 - 1"
        for seed in (-1, 2**64, 10**5000):
            with self.assertRaisesRegex(Error, f"^cases: seed {numbers}$"):
                next(verify.cases("nested", 1, seed=seed))
        with self.assertRaisesRegex(Error, f"^shrink: evaluations {numbers}$"):
            verify.shrink(next(verify.cases("nested", 1)), lambda case: False, evaluations=-1)
        self.assertEqual(next(verify.cases("nested", 1, seed=2**64 - 1)).seed, 2**64 - 1)

    def test_case_files_come_back_and_are_the_program_s(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "x.case.json")
            for case in (*verify.cases("true-rotation", 3), *verify.cases("nested", 3, question="surface")):
                verify.write_case(name, case, wrong={"mine": None, "yours": True}, cause="none")
                self.assertEqual(os.listdir(folder), ["x.case.json"])
                again, truth, wrong, cause = verify.read_case(name)
                self.assertEqual((truth, wrong, cause), (verify.truth(case), {"mine": None, "yours": True}, "none"))
                self.assertEqual([again.question, again.family, again.index], [case.question, case.family, case.index])
                for x, y in ((case.a, again.a), (case.b, again.b)):
                    self.assertEqual((x.vertices.tolist(), x.faces), (y.vertices.tolist(), y.faces))
                for x, y in ((case.pose_a, again.pose_a), (case.pose_b, again.pose_b)):
                    self.assertEqual(x.tolist(), y.tolist())
                if PROGRAM:
                    said = subprocess.run([PROGRAM, "collide", name], capture_output=True, text=True)
                    self.assertEqual(said.stdout, f"{int(truth)}\n")
            bad = os.path.join(folder, "bad.case.json")
            with open(bad, "w") as file:
                file.write('{"level": "object",\n"what": }')
            with self.assertRaisesRegex(Error, r"^.*bad\.case\.json:2: "):
                verify.read_case(bad)
            with self.assertRaisesRegex(Error, "not the name of a case file"):
                verify.write_case(os.path.join(folder, "x.json"), case)
            with self.assertRaisesRegex(Error, "expected a folder that can be written"):
                verify.write_case(os.path.join(folder, "none", "x.case.json"), case)

    def test_a_case_file_s_name_is_text_bytes_or_a_path(self):
        case = next(verify.cases("nested", 1))
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "w\udcfcrfel.case.json")  # no text in UTF-8
            for same in (name, os.fsencode(name), pathlib.Path(name)):
                verify.write_case(same, case)
                self.assertEqual(os.listdir(os.fsencode(folder)), [b"w\xfcrfel.case.json"])
                self.assertEqual(verify.read_case(same).case.index, 0)
                os.unlink(name)
            for wrong in ("a\0b.case.json", "\ud800.case.json"):
                with self.assertRaises(Error):
                    verify.write_case(os.path.join(folder, wrong), case)
                with self.assertRaisesRegex(Error, "no name of a file; expected one"):
                    verify.read_case(os.path.join(folder, wrong))
            self.assertEqual(os.listdir(folder), [])
            for wrong, line in (({"mine": "yes"}, "write_case: the answer of 'mine' is 'yes'; expected True, False or None"),
                                ({3: True}, "write_case: a name of `wrong` is of type int; expected one line of text"),
                                ({"a\nb": True}, r"write_case: a name of `wrong` 'a\nb' is no line of text; expected one without control "
                                                 "characters and surrogates")):
                with self.assertRaises(Error) as raised:
                    verify.write_case(name, case, wrong=wrong)
                self.assertEqual(str(raised.exception), line)
            self.assertEqual(os.listdir(folder), [])

    def test_poses_of_any_length_come_back(self):
        cube, long = Body(*CUBE), Fraction(10**5000 + 1, 10**5000 + 3)  # Python writes no decimals of so many digits
        pose = np.eye(3, 4).astype(object)
        pose[0, 0] = long
        self.assertEqual(verify.Case(cube, cube, pose).pose_a[0, 0], long)

    def test_a_case_of_one_s_own(self):
        cube = Body(*CUBE)
        pose = np.eye(3, 4)
        pose[0, 3] = np.nextafter(1, 2)
        self.assertFalse(verify.truth(verify.Case(cube, cube, None, pose)))
        pose[0, 3] = 1
        self.assertTrue(verify.truth(verify.Case(cube, cube, None, pose, "surface")))
        opened = Body(CUBE[0], CUBE[1][:-1])
        with self.assertRaisesRegex(Error, "^query: body b is open at 4 edges"):
            verify.Case(cube, opened)
        with self.assertRaisesRegex(Error, "^pose_b: the 3x3 part has determinant 0"):
            verify.Case(cube, cube, None, np.zeros((3, 4)))
        for zeros in (np.zeros((3, 4), object), np.zeros((3, 4), bool), [["0"] * 4] * 3):
            with self.assertRaisesRegex(Error, "^pose_a: the 3x3 part has determinant 0"):
                verify.Case(cube, cube, zeros)
        with self.assertRaisesRegex(Error, "^pose_a: many poses; expected one"):
            verify.Case(cube, cube, np.zeros((2, 3, 4)))
        with self.assertRaisesRegex(Error, "^cases: no family 'easy'"):
            list(verify.cases("easy", 1))
        with self.assertRaisesRegex(Error, "^cases: question 'both'"):
            list(verify.cases("nested", 1, question="both"))


if __name__ == "__main__":
    unittest.main()
