#!/usr/bin/env python3
"""score.py ANSWERS.csv: the table of errors of a file of answers, as CSV on standard output. See README.md."""

import csv
import sys

import tetracone_dataset as dataset

COLUMNS = ("family", "question", "n", "false_positives", "false_negatives", "failures", "declined", "missing")
HEADER = ["id", "question", "answer"]


class Error(Exception):
    """An error in the file of answers, told in one line."""


def truths(folder):
    """{(id, question): (family, true answer)}, in order."""
    found = {}
    for row in dataset.rows("cases.jsonl", folder):
        for question in ("surface", "solid"):
            found[row["id"], question] = row["family"], int(row[question])
    for row in dataset.rows("predicates.jsonl", folder):
        name = "solid-predicate" if row["predicate"] == "solid" else row["predicate"]
        found[row["id"], name] = row["family"], row["truth"]
    for row in dataset.rows("triangles.jsonl", folder):
        found[row["id"], "triangle-triangle"] = row["family"], row["truth"]
    return found


def read_answers(name, truth):
    """{(id, question): "1", "0", "-1", "failed" or "declined"}."""
    answers = {}
    try:
        file = open(name, newline="", encoding="utf-8", errors="replace")
    except OSError as error:
        raise Error(f"{name}: {error.strerror}; expected a file of answers") from None
    with file:
        lines = csv.reader(file)
        if next(lines, None) != HEADER:
            raise Error(f"{name}:1: another header; expected {','.join(HEADER)}")
        for row in lines:
            where = f"{name}:{lines.line_num}"
            if len(row) != 3:
                raise Error(f"{where}: {len(row)} fields; expected {','.join(HEADER)}")
            key, answer = (row[0], row[1]), row[2]
            if key not in truth:
                raise Error(f"{where}: no case '{row[0]}' with the question '{row[1]}'; expected one of the dataset")
            if key in answers:
                raise Error(f"{where}: '{row[0]}', '{row[1]}' once more; expected one answer")
            wide = row[1] in ("orientation", "solid-predicate")
            if answer not in ("0", "1", "failed", "declined") and not (wide and answer == "-1"):
                raise Error(f"{where}: the answer '{answer}'; expected {'-1, ' if wide else ''}0, 1, failed or declined")
            answers[key] = answer
    return answers


def score(answers, truth):
    """Rows of COLUMNS, for the questions that were answered at all: families in their order, then `all`."""
    asked = list(dict.fromkeys(question for _, question in truth))
    answered = {question for _, question in answers}
    table = {(family, question): [0] * 6 for question in asked if question in answered
             for family in [*dict.fromkeys(f for (_, q), (f, _) in truth.items() if q == question), "all"]}
    for (name, question), (family, right) in truth.items():
        if question not in answered:
            continue
        answer = answers.get((name, question))
        for row in (table[family, question], table["all", question]):
            if answer is None:
                row[5] += 1
            elif answer == "declined":
                row[4] += 1
            else:
                row[0] += 1
                row[3] += answer == "failed"
                row[1] += answer != "failed" and int(answer) > right
                row[2] += answer != "failed" and int(answer) < right
    return [(*key, *row) for key, row in table.items()]


def main(arguments, folder=dataset.FOLDER):
    if len(arguments) != 1:
        print("score.py: expected one file of answers, id,question,answer", file=sys.stderr)
        return 2
    try:
        dataset.check(folder)
        truth = truths(folder)
        rows = score(read_answers(arguments[0], truth), truth)
    except (Error, dataset.Error) as error:
        print(error, file=sys.stderr)
        return 2
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(COLUMNS)
    out.writerows(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
