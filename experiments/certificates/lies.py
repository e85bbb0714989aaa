#!/usr/bin/env python3
"""Spoils certificates in every way that a field allows, and counts the lies that the checker believes: there should be none.

  lies.py CERTIFICATE [A [B]]

There are two kinds of lies. Spoiled proofs: a field is changed so that it cannot prove anything, whatever the answer. False claims:
an answer is wrong, or a row has another's answer and proof; then each field of the proof is changed as well.
Prints each lie that is believed, and the count of all. Status 1 where one is."""
import copy
import json
import sys
from fractions import Fraction

from check import BAD, prove
from reading import Refused, given

ANSWERS = {"collide": ["apart", "surfaces", "a_in_b", "b_in_a"], "within": [0, 1], "inside": [-1, 0, 1],
           "relation": ["disjoint", "meet", "overlap", "equal", "inside", "contains", "covered_by", "covers"]}
PROOF = ("witness", "windings", "directions", "cover", "ray", "winding", "face", "plane", "way", "ways", "border", "gone", "before", "low", "overlap")


def places(entry, way=()):
    """Every field within an entry, as the keys that lead to it."""
    items = entry.items() if isinstance(entry, dict) else enumerate(entry) if isinstance(entry, list) else ()
    for key, below in items:
        yield (*way, key)
        yield from places(below, (*way, key))


def at(entry, way):
    for key in way:
        entry = entry[key]
    return entry


def changed(certificate, way, value):
    """A copy with another value there. It shares all that is not on the way, since certificates are large."""
    if not way:
        return value
    spoiled = copy.copy(certificate)
    spoiled[way[0]] = changed(certificate[way[0]], way[1:], value)
    return spoiled


def negated(text):
    return text[1:] if text.startswith("-") else text if text == "0" else "-" + text


def other_values(value):
    """Values of the same form."""
    if isinstance(value, bool) or value is None:
        return []
    if isinstance(value, int):
        return [value + 1, max(0, value - 1), value + 1000]
    if isinstance(value, str):
        numerator, _, denominator = value.partition("/")
        if not numerator.lstrip("-").isdigit():
            return {"crossed": [0, "touched"], "touched": [0, "crossed"], "a": ["b"], "b": ["a"]}.get(value, [])
        big = str(int(numerator) * 10**30 + 1) + "/" + str(int(denominator or 1) * 10**30)
        return ["0", negated(value), big, str(int(numerator) + 1) + ("/" + denominator if denominator else "")]
    if isinstance(value, list):
        return [value[1:], value[:-1], value[::-1], value + value[-1:]]
    return []


def spoiled_proofs(certificate):
    """What proves nothing, whatever the answer is."""
    opens_groups = any(f'["{body}"' in json.dumps(certificate["answers"]) for body in "ab")
    for way in places(certificate):
        key, value = way[-1], at(certificate, way)
        # All keys that are written are needed, with few exceptions: groups that no cover opens, and their triangles. A ray's end behind its
        # hit is needless too, and so is a bound that an answer does not claim.
        is_needless = key in ("end", "low", "overlap") or key in ("cut", "groups") and not (opens_groups and "groups" in at(certificate, way[:-1]))
        if isinstance(key, str) and not is_needless:
            rest = {name: below for name, below in at(certificate, way[:-1]).items() if name != key}
            yield f"{way} is missing", changed(certificate, way[:-1], rest)
            yield f"{way} is another object", changed(certificate, way, {})
        if len(way) > 3 and way[-3] == "cut" and key > 0:
            yield f"{way} is another vertex", changed(certificate, way, value + 4)
        if key == "sha256":
            yield f"{way} of another file", changed(certificate, way, value[::-1])
        if key == "winding" and type(value) is int:
            yield f"{way} is one more", changed(certificate, way, value + 1)
        if len(way) > 1 and way[-2] == "directions":
            yield f"{way} is 0", changed(certificate, way, ["0", "0", "0"])
            yield f"{way} is turned", changed(certificate, way, [negated(x) for x in value])
        if len(way) > 1 and way[-2] == "points":
            yield f"{way} is far away", changed(certificate, way, [x + "0000000000007" if "/" not in x else str(10**40) for x in value])
        if "cover" in way and isinstance(value, list):
            yield f"{way} lacks a node", changed(certificate, way, value[:-1])
        if value == "crossed":
            yield f"{way} is believed apart", changed(certificate, way, 0)
        if key == "boxes":
            yield f"{way} are believed long", changed(certificate, way, "long")
        if way[-2:] == ("low", "square"):
            yield f"{way} is more", changed(certificate, way, str(2 * Fraction(value)))
        if way[-2:] == ("low", "half"):
            yield f"{way} is less", changed(certificate, way, str(Fraction(value) / 4))
        if key == "radius":
            yield f"{way} is more", changed(certificate, way, str(2 * Fraction(value)))
        if "groups" in way and isinstance(value, list):
            yield f"{way} lacks a member", changed(certificate, way, value[:-1])


def false_claims(certificate):
    """Answers that are wrong, with proofs of other answers and with changed ones."""
    answers = certificate["answers"]
    for k, answer in enumerate(answers):
        for other in ANSWERS.get(answer["ask"], ()):
            if other != answer["answer"]:
                yield from with_changes(f"answer {k} is {other}", changed(certificate, ("answers", k, "answer"), other), k)
        if answer["ask"] in ("distance", "motion", "ray", "exit", "depth"):
            for value in (other_exits if answer["ask"] == "exit" else other_claims)(answer["answer"]):
                yield from with_changes(f"answer {k} is {value}", changed(certificate, ("answers", k, "answer"), value), k)
        if answer["ask"] == "exit" and answer["answer"][1] != "0":
            yield f"answer {k} begins where the solids are apart", begun_earlier(certificate, k)
        for donor in answers:
            if donor["ask"] == answer["ask"] and donor["answer"] != answer["answer"]:
                row = {key: value for key, value in answer.items() if key not in PROOF}
                row.update({key: value for key, value in donor.items() if key in (*PROOF, "answer")})
                yield from with_changes(f"answer {k} with another's proof", changed(certificate, ("answers", k), row), k)


def begun_earlier(certificate, k):
    """Exits of A moved back so far that the solids are apart. The true ones are 0; all moves that the proof is about are the same."""
    answer = dict(certificate["answers"][k])
    answer.pop("overlap", None)
    back = Fraction(2**40)
    for row, x in enumerate(answer["direction"]):
        moved = given(answer["pose_a"][4 * row + 3]) - back * given(x)
        answer["pose_a"] = [*answer["pose_a"][:4 * row + 3], f"{moved.numerator}/{moved.denominator}", *answer["pose_a"][4 * row + 4:]]
    answer["answer"] = [str(Fraction(x) + back) for x in answer["answer"]]
    return changed(certificate, ("answers", k), answer)


def other_claims(answer):
    if answer is None:
        return []
    if isinstance(answer, str):
        return [x for x in other_values(answer) if x != answer]
    if isinstance(answer, list):
        return [None, ["0", "0"], [answer[0], answer[0]]] if answer[0] != answer[1] else [None]
    return [None, {"face": answer["face"] + 1, "t": answer["t"]}, *({"face": answer["face"], "t": t} for t in other_values(answer["t"]) if t != answer["t"])]


def other_exits(answer):
    first, last = answer
    return [x for x in ([None], *([x, last] for x in other_values(first)), *([first, x] for x in other_values(last))) if x != answer]


def with_changes(name, certificate, k):
    yield name, certificate
    answer = certificate["answers"][k]
    for way in places(answer):
        if way[0] in PROOF:
            for value in other_values(at(answer, way)):
                yield f"{name}, {way} is {str(value)[:60]}", changed(certificate, ("answers", k, *way), value)


def believed(certificate, models=()):
    """True when the checker takes the certificate."""
    try:
        return bool(list(prove(certificate, models)))
    except (Refused, *BAD):
        return False


def main():
    sys.setrecursionlimit(10000)  # as check.py
    with open(sys.argv[1], encoding="utf-8") as file:
        certificate = json.load(file)
    count = wrong = 0
    for kind in (spoiled_proofs, false_claims):
        for name, spoiled in kind(certificate):
            count += 1
            if believed(json.dumps(spoiled), sys.argv[2:]):
                wrong += 1
                print("believed:", name)
    print(count, "lies,", wrong, "believed")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
