"""What the checker trusts: numbers, objects of JSON, and model files as they are read. README.md has the format."""
import hashlib
import os
import re
from fractions import Fraction

from geometry import area_vector

DECIMAL = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")
FRACTION = re.compile(r"[-+]?[0-9]+/0*[1-9][0-9]*")
EXACT = re.compile(r"-?[0-9]+(/0*[1-9][0-9]*)?")


class Bad(Exception):
    """The input has not the format."""


class Refused(Exception):
    """The input does not prove its answer."""


def need(holds, what):
    if not holds:
        raise Refused(what)


def need_form(holds, what):
    if not holds:
        raise Bad(what)


# Numbers and vectors


def given(text):
    """A number as the input has it: a fraction is exact, a decimal stands for the nearest double."""
    need_form(isinstance(text, str), "a number is not a string")
    if FRACTION.fullmatch(text):
        return Fraction(text)
    need_form(DECIMAL.fullmatch(text) and abs(float(text)) < float("inf"), f"'{text[:40]}' is not a finite number")
    return Fraction(float(text))


def exact(text):
    need_form(isinstance(text, str) and EXACT.fullmatch(text), f"'{str(text)[:40]}' is not an integer or a fraction")
    return Fraction(text)


def vector(texts, number=exact, size=3):
    need_form(isinstance(texts, list) and len(texts) == size, f"a list has not {size} numbers")
    return [number(text) for text in texts]


def index(number, things, what):
    need_form(type(number) is int and 0 <= number < len(things), f"there is no {what} {str(number)[:40]}")
    return number


class Object(dict):
    """An object of JSON."""

    def __init__(self, items):
        super().__init__(items)
        need_form(len(self) == len(items), "a key is there twice")

    def __missing__(self, key):
        raise Bad(f"the key {key} is missing")


def need_keys(entry, known):
    need_form(isinstance(entry, Object), "something is not an object")
    for key in entry:
        need_form(key in known.split(), f"the key {key[:40]} is unknown here")


def lines_of(data, path):
    """The words of each line that has some; '#' begins a comment. A lone CR ends a line where no line ends in LF."""
    text = data.decode("utf-8-sig", "replace")
    text = text if "\n" in text else text.replace("\r", "\n")
    need_form(text.strip(), f"{path} is empty")
    return [words for line in text.split("\n") if (words := re.findall("[^ \t\r\v\f]+", line.split("#")[0]))]


def count(word):
    need_form(re.fullmatch("[0-9]+", word), f"'{word[:40]}' is not a count or an index")
    return int(word)


def read_off(lines):
    if not lines[0][0].isdigit():  # the keyword may be left out
        keyword = re.fullmatch("(?:ST|C|N)*OFF([0-9]*)", lines[0][0])
        need_form(keyword, "the file does not begin with OFF")
        counts = [keyword[1]] * (keyword[1] != "") + lines[0][1:]
        lines = [counts] * (counts != []) + lines[1:]
    first = 1 + count(lines[0][0])
    faces = [[[count(x) for x in words[1:1 + count(words[0])]]] for words in lines[first:first + count(lines[0][1])]]
    need_form(len(faces) == count(lines[0][1]), "the file ends too early")
    return [[given(x) for x in words[:3]] for words in lines[1:first]], faces


GEOMETRY = ("v", "f", "fo", "q")  # statements of OBJ: a vertex; three ways to begin a face


def read_obj(lines):
    vertices, faces, words = [], [], []
    for line in lines:
        # A name may end in a backslash: a vertex or a face behind it is a statement of its own.
        words = line if line[0] in GEOMETRY and words[:1] and words[0] not in GEOMETRY else words + line
        if words[-1].endswith("\\"):
            words[-1:] = [words[-1][:-1]] * (len(words[-1]) > 1)
            continue
        if words[:1] == ["v"]:
            vertices.append([given(x) for x in words[1:4]])
        elif words[:1] and words[0] in GEOMETRY:
            numbers = [word.split("/")[0] for word in words[1:]]
            faces.append([[len(vertices) - count(n[1:]) if n.startswith("-") else count(n) - 1 for n in numbers]])
        words = []
    return vertices, faces


def read_poly(lines, nodes):
    """TetGen's facets of several polygons; the first is the outer one. Nodes may have a file of their own."""
    head = lines.pop(0)
    nodes, size = (nodes, count(nodes.pop(0)[0])) if nodes else (lines, count(head[0]))
    first = count(nodes[0][0])
    vertices = [[given(x) for x in nodes.pop(0)[1:4]] for _ in range(size)]
    faces = []
    for _ in range(count(lines.pop(0)[0])):
        polygons, holes = [count(x) for x in (lines.pop(0) + ["0"])[:2]]
        faces.append([])
        for _ in range(polygons):
            words = lines.pop(0)
            while len(words) <= count(words[0]):
                words += lines.pop(0)
            faces[-1].append([count(x) - first for x in words[1:]])
        del lines[:holes]
        # The program turns such loops, as they are seen where the outer one is largest.
        outer, *inner = [area_vector([vertices[v] for v in loop]) for loop in faces[-1]]
        axis = max(range(3), key=lambda k: abs(outer[k]))
        need(all(outer[axis] * way[axis] <= 0 for way in inner), "a hole runs the same way round as the face; expected the other way")
    return vertices, faces


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def read_model(path):
    """Vertices, faces, and the hash of the file's bytes."""
    data, (stem, suffix) = read_bytes(path), os.path.splitext(path)
    need_form(suffix.lower() in (".off", ".obj", ".poly"), f"{path} is no .off, .obj or .poly file")
    lines = lines_of(data, path)
    try:
        if suffix.lower() == ".poly":
            beside = read_bytes(stem + ".node") if count(lines[0][0]) == 0 else b""
            vertices, faces = read_poly(lines, lines_of(beside, path) if beside else None)
            data += beside
        else:
            vertices, faces = (read_off if suffix.lower() == ".off" else read_obj)(lines)
            need_form(all(len(loop) > 2 for loops in faces for loop in loops), f"{path} has a face of less than three corners, which the program leaves out")
    except IndexError:
        raise Bad(f"{path} ends too early") from None
    need_form(all(len(v) == 3 for v in vertices), f"{path} has a vertex without three numbers")
    return vertices, faces, hashlib.sha256(data).hexdigest()


def need_given(answers, rows, asked, key, path):
    """Each answer is about its row of the file, of `asked` rows; one row serves all. A row is one number, or a vector or pose."""
    said = [answer["origin"] + answer["direction"] if key == "ray" else answer[key] for answer in answers]
    said = [[words] if isinstance(words, str) else words for words in said]
    size = len(said[0])
    numbers = [given(x) for words in lines_of(read_bytes(path), path) for x in " ".join(words).replace(",", " ").split()]
    need_form(size and numbers, f"{path}, or the certificate, has no numbers of {key}")
    if size == 12 and len(numbers) in (16, 16 * asked) and all(numbers[k + 12:k + 16] == [0, 0, 0, 1] for k in range(0, len(numbers), 16)):
        numbers = [x for k in range(0, len(numbers), 16) for x in numbers[k:k + 12]]  # matrices of four rows
    need_form(len(numbers) in (size, size * asked), f"{path} has not {size} numbers for each of {asked} rows")
    for row, words in zip(rows, said):
        first = row * size % len(numbers)
        need(vector(words, given, size) == numbers[first:first + size], f"answer {row} is not about what {path} says")
