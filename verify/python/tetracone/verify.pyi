from collections.abc import Callable, Iterable, Iterator, Mapping
from os import PathLike
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import Body

Question = Literal["solid", "surface"]
Answer = Union[int, np.integer[Any], np.bool_, None]  # True or 1, False or 0, None: declined
Path = Union[str, bytes, PathLike[str], PathLike[bytes]]
families: dict[str, str]

class Case:
    def __init__(self, a: Body, b: Body, pose_a: Any = None, pose_b: Any = None, question: Question = "solid") -> None: ...
    @property
    def a(self) -> Body: ...
    @property
    def b(self) -> Body: ...
    @property
    def pose_a(self) -> npt.NDArray[Any]: ...
    @property
    def pose_b(self) -> npt.NDArray[Any]: ...
    @property
    def question(self) -> Question: ...
    @property
    def family(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def index(self) -> int: ...
    @property
    def parameter(self) -> float: ...

class Errors(NamedTuple):
    family: str
    question: Question
    n: int
    false_positives: int
    false_negatives: int
    failures: int

class Table(list[Errors]):
    wrong: list[Case]
    def __init__(self, rows: Iterable[Errors], wrong: list[Case]) -> None: ...

class Case_file(NamedTuple):
    case: Case
    truth: bool
    wrong: dict[str, Optional[bool]]
    cause: str

def cases(family: str, n: int, seed: int = 1, question: Question = "solid") -> Iterator[Case]: ...
def truth(case: Case) -> bool: ...
def judge(function: Callable[[Case], Answer], cases: Iterable[Case]) -> Table: ...
def shrink(case: Case, function: Callable[[Case], Answer], seconds: float = 3.0, evaluations: int = 20000) -> Case: ...
def read_case(path: Path) -> Case_file: ...
def write_case(path: Path, case: Case, wrong: Mapping[str, Answer] = {}, cause: str = "") -> None: ...
