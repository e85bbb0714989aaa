"""Hard cases with their true answers, for whatever answers whether two placed polyhedra collide.

>>> from tetracone import verify
>>> def boxes(case):
...     "Whether the boxes of the placed vertices meet."
...     a, b = (pose[:, :3].astype(float) @ body.vertices.T + pose[:, 3:].astype(float)
...             for body, pose in ((case.a, case.pose_a), (case.b, case.pose_b)))
...     return bool((a.min(1) <= b.max(1)).all() and (b.min(1) <= a.max(1)).all())
>>> table = verify.judge(boxes, verify.cases("nested", 20))
>>> print(table)
family  question   n  false_positives  false_negatives  failures
nested  solid     20                4                0         0
>>> small = verify.shrink(table.wrong[0], boxes, seconds=0.5)
>>> verify.truth(small), boxes(small)
(False, True)
"""

import os as _os
import tempfile as _tempfile
from collections import namedtuple as _namedtuple
from fractions import Fraction as _Fraction
from operator import index as _index

import numpy as _numpy

from . import _verify
from ._tetracone import Body as _Body
from ._tetracone import Error as _Error


def _of_type(value, kind, name):
    if not isinstance(value, kind):
        raise TypeError(f"{name} is of type {type(value).__name__}; expected a {kind.__name__}")
    return value


def _function(value, name):
    if not callable(value):
        raise TypeError(f"{name} is of type {type(value).__name__}; expected a function of a Case")
    return value


def _count(value, name):
    if not 0 <= _index(value) < 2**64:
        raise _Error(f"{name} is below 0 or has more than 64 bits; expected a number from 0 to 2^64 - 1")
    return value


#: What the cases of a family have in common, by the family's name.
families = _verify.families()


class Case:
    """Two bodies under two poses, and a question of them.

    a, b: `tetracone.Body`. pose_a, pose_b: arrays (3, 4) of doubles; of fractions.Fraction where some number is no
    double. question: "solid" or "surface". family, seed, index, parameter: what made it; family is "" where nobody did.
    Immutable.

    >>> import numpy as np
    >>> from tetracone import Body, verify
    >>> a = Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    >>> case = verify.Case(a, a, pose_b=np.eye(3, 4))
    >>> case.question, verify.truth(case)
    ('solid', True)
    """

    __slots__ = ("_asked", "_bodies", "_poses")

    def __init__(self, a, b, pose_a=None, pose_b=None, question="solid"):
        a, b = _of_type(a, _Body, "case: a"), _of_type(b, _Body, "case: b")
        self._asked = _verify.Asked(a.vertices, a.faces, pose_a, b.vertices, b.faces, pose_b, question)
        self._bodies, self._poses = [a, b], [None, None]

    @classmethod
    def _of(cls, asked, before=None):
        case = cls.__new__(cls)
        case._asked, case._bodies, case._poses = asked, [None, None], [None, None]
        for b in range(2):  # what prepares a body does so once
            if before is not None and asked.same_body(before._asked, b):
                case._bodies[b] = before._body(b)
        return case

    def _body(self, b):
        if self._bodies[b] is None:
            self._bodies[b] = _Body(*self._asked.body(b))
        return self._bodies[b]

    def _pose(self, b):
        if self._poses[b] is None:
            exact = [_Fraction(int(top, 16), int(bottom, 16)) for top, bottom in self._asked.pose(b)]
            doubles = [float(x) for x in exact]
            pose = _numpy.array(doubles if doubles == exact else exact).reshape(3, 4)
            pose.flags.writeable = False
            self._poses[b] = pose
        return self._poses[b]

    a = property(lambda self: self._body(0))
    b = property(lambda self: self._body(1))
    pose_a = property(lambda self: self._pose(0))
    pose_b = property(lambda self: self._pose(1))
    question = property(lambda self: self._asked.question)
    family = property(lambda self: self._asked.origin[0])
    seed = property(lambda self: self._asked.origin[1])
    index = property(lambda self: self._asked.origin[2])
    parameter = property(lambda self: self._asked.origin[3])

    def __repr__(self):
        made = f"{self.family} {self.index}, " if self.family else ""
        return f"Case({made}{self.a}, {self.b}, {self.question})"


def cases(family, n, seed=1, question="solid"):
    """The first n cases of a family, one after the other: the same on every machine.

    Raises Error for a family that is none of `families`, and for another question than "solid" or "surface". It also
    raises Error for a seed below 0 or of more than 64 bits.

    >>> from tetracone import verify
    >>> [case.parameter for case in verify.cases("nested", 3)]
    [0.25, 0.0009765625, 9.5367431640625e-07]
    """
    case, seed = None, _count(seed, "cases: seed")
    for index in range(n):
        case = Case._of(_verify.case_of(family, seed, index, question), case)
        yield case


def truth(case):
    """The right answer, True or False, computed twice: in rationals by CGAL and in integers, all pairs, no tree.

    >>> from tetracone import verify
    >>> [verify.truth(case) for case in verify.cases("nested", 3)]
    [True, True, True]
    """
    return _verify.truth(_of_type(case, Case, "truth: case")._asked)


#: A row of `judge`: of n questions that the function did not decline, its wrong answers.
Errors = _namedtuple("Errors", "family question n false_positives false_negatives failures")


class Table(list):
    """Rows of `Errors`, a family and question each; `str` of it is a table in columns. `wrong`: the cases that were
    answered wrong, in order."""

    def __init__(self, rows, wrong):
        super().__init__(rows)
        self.wrong = wrong

    def __str__(self):
        rows = [Errors._fields, *([str(value) for value in row] for row in self)]
        widths = [max(map(len, column)) for column in zip(*rows)]
        return "\n".join("  ".join(cell.ljust(w) if k < 2 else cell.rjust(w) for k, (cell, w) in enumerate(zip(row, widths)))
                         for row in rows)


_failed = "failed"


def _answer(function, case):
    """What the function says: True or False, None where it declines, `_failed` for an exception and for all else."""
    try:
        answer = function(case)
        if answer is None:
            return None
        if isinstance(answer, (int, _numpy.integer, _numpy.bool_)) and answer in (0, 1):
            return bool(answer)
    except Exception:
        pass
    return _failed


def judge(function, cases):
    """The wrong answers of `function(case)` on cases, a `Table` with a row a family and question.

    The function answers True or False, or 1 or 0; None declines, and is not counted; an exception, and any other answer,
    is a failure.

    >>> from tetracone import Query, verify
    >>> def exact(case):
    ...     return Query(case.a, case.b, case.question).collide(poses_a=case.pose_a, poses_b=case.pose_b)
    >>> print(verify.judge(exact, verify.cases("stacked", 10)))
    family   question   n  false_positives  false_negatives  failures
    stacked  solid     10                0                0         0
    """
    counts, wrong = {}, []
    function = _function(function, "judge: function")
    for case in cases:
        case = _of_type(case, Case, "judge: a case")
        row = counts.setdefault((case.family, case.question), [0, 0, 0, 0])
        answer = _answer(function, case)
        if answer is None:
            continue
        right = truth(case)
        row[0] += 1
        row[1] += answer is True and not right
        row[2] += answer is False and right
        row[3] += answer is _failed
        if answer is not right:
            wrong.append(case)
    return Table([Errors(*key, *row) for key, row in counts.items()], wrong)


def shrink(case, function, seconds=3.0, evaluations=20000):
    """A smaller case that `function` still gets wrong in the same way: fewer faces, simpler poses, shorter numbers.

    Stops after so many seconds or questions to the function. A smaller case that it declines is none. Raises Error when
    the function is right about the case, or declines it.

    >>> from tetracone import verify
    >>> case = next(case for case in verify.cases("nested", 20) if not verify.truth(case))
    >>> small = verify.shrink(case, lambda case: True, seconds=0.5)
    >>> len(small.a.faces) <= len(case.a.faces), verify.truth(small)
    (True, False)
    """
    asked, function = _of_type(case, Case, "shrink: case")._asked, _function(function, "shrink: function")
    return Case._of(_verify.shrunk(asked, lambda smaller: _answer(function, Case._of(smaller)), seconds, _count(evaluations, "shrink: evaluations")))


#: What a case file says besides the case: the right answer, who was wrong with what answer (None: failed), and why.
Case_file = _namedtuple("Case_file", "case truth wrong cause")


def read_case(path):
    """The `Case_file` of a file *.case.json. Raises Error, with the line, for a file that is none.

    >>> import tempfile, os
    >>> from tetracone import verify
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     name = os.path.join(folder, "nested.case.json")
    ...     verify.write_case(name, next(verify.cases("nested", 1)), wrong={"boxes": False}, cause="a test")
    ...     file = verify.read_case(name)
    >>> file.truth, file.wrong, file.cause
    (True, {'boxes': False}, 'a test')
    """
    asked, right, wrong, cause = _verify.read_case(path)
    return Case_file(Case._of(asked), right, {name: None if answer is None else bool(answer) for name, answer in wrong}, cause)


def _shown(text):
    """A text as messages quote it: on one line, and printable."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in str(text))


def _one_line(text, name):
    if not isinstance(text, str):
        raise _Error(f"write_case: {name} is of type {type(text).__name__}; expected one line of text")
    if any(c < " " or "\ud800" <= c <= "\udfff" for c in text):
        raise _Error(f"write_case: {name} '{_shown(text)}' is no line of text; expected one without control characters and surrogates")
    return text


def write_case(path, case, wrong={}, cause=""):
    """Writes a case file, *.case.json, which `tetracone collide` replays with any kernel and `read_case` reads. Complete
    or not at all.

    wrong: by the name of what was wrong, its answer, True or False, None where it failed. cause: one line. See
    `read_case`. Raises Error for what it could not read.
    """
    path, asked = _os.fsdecode(path), _of_type(case, Case, "write_case: case")._asked
    if not path.endswith(".case.json"):
        raise _Error(f"{_shown(path)}: not the name of a case file; expected *.case.json")
    answers = []
    for name, answer in wrong.items():
        said = _answer(lambda _: answer, None)
        if said is _failed:
            raise _Error(f"write_case: the answer of '{_shown(name)}' is {_shown(repr(answer))[:40]}; expected True, False or None")
        answers.append((_one_line(name, "a name of `wrong`"), None if said is None else int(said)))
    text = _verify.case_text(asked, answers, _one_line(cause, "the cause"))
    temporary = None
    try:
        handle, temporary = _tempfile.mkstemp(dir=_os.path.dirname(path) or ".")
        with _os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        _os.chmod(temporary, 0o644)
        _os.replace(temporary, path)
        temporary = None
    except (OSError, ValueError) as error:  # ValueError: no name of a file
        raise _Error(f"{_shown(path)}: {getattr(error, 'strerror', error)}; expected a folder that can be written") from None
    finally:
        if temporary is not None:
            _os.unlink(temporary)
