from collections.abc import Callable, Iterable, Iterator, Mapping
from os import PathLike
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy.typing as npt

from . import Body

Question = Literal["solid", "surface"]
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

class Case_file(NamedTuple):
    case: Case
    truth: bool
    wrong: dict[str, Optional[bool]]
    cause: str

def cases(family: str, n: int, seed: int = 1, question: Question = "solid") -> Iterator[Case]: ...
def truth(case: Case) -> bool: ...
def judge(function: Callable[[Case], Optional[bool]], cases: Iterable[Case]) -> Table: ...
def shrink(case: Case, function: Callable[[Case], Optional[bool]], seconds: float = 3.0, evaluations: int = 20000) -> Case: ...
def read_case(path: Union[str, PathLike[str]]) -> Case_file: ...
def write_case(path: Union[str, PathLike[str]], case: Case, wrong: Mapping[str, Optional[bool]] = {}, cause: str = "") -> None: ...
