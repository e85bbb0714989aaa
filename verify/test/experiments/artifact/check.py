#!/usr/bin/python3
"""Tests of experiments/artifact/check.py: the numbers of README.md are those of experiments/results, and one that is not is found."""

import os
import re
import sys
import unittest

sys.dont_write_bytecode = True
SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "..")
sys.path.insert(0, os.path.join(SOURCE, "experiments", "artifact"))

try:
    import matplotlib  # noqa: F401
except ImportError:
    print("skipped: no matplotlib")
    sys.exit(77)
import check  # noqa: E402

ROUNDED = 1.07  # README.md gives times in one to three digits


class Check(unittest.TestCase):
    def setUp(self):
        with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
            self.readme = file.read()

    def wrong(self, readme):
        return {name for name, factor, said, found in check.claims(readme, os.path.join(SOURCE, "experiments", "results"))
                if not check.is_within(said, found, min(factor, ROUNDED))}

    def test_the_readme_has_the_numbers_of_the_results(self):
        self.assertEqual(self.wrong(self.readme), set())

    def test_every_row_of_the_readme_is_held_against_them(self):
        names = " ".join(name for name, *_ in check.claims(self.readme, os.path.join(SOURCE, "experiments", "results")))
        for row in self.readme.split("## How fast")[1].split("\n## ")[0].split("\n"):
            if row.startswith("| ") and not row.startswith(("| subject", "| contact")):
                self.assertIn(row.split("|")[1].strip(), names)

    def test_a_number_that_is_not_theirs_is_found(self):
        race, price = "| FCL OBBRSS | ", "| shared face, edge, vertex | "
        for start, cell, name in ((race, 0, "time, FCL OBBRSS"), (race, 1, "least .. most, FCL OBBRSS"), (race, 3, "wrong and asked, FCL OBBRSS, near contact"),
                                  (price, 1, "over FCL, shared face, edge, vertex"), (price, 2, "wrong, shared face, edge, vertex: double, FCL")):
            row = next(line for line in self.readme.split("\n") if line.startswith(start))
            cells = row[len(start):].split(" | ")
            cells[cell] = re.sub(r"[0-9.]*[0-9]", lambda number: str(2 * float(number[0]) + 1), cells[cell], count=1)
            self.assertEqual(self.wrong(self.readme.replace(row, start + " | ".join(cells))), {name})

    def test_ranges_are_read_and_compared(self):
        self.assertEqual(check.spans("0 to 34, 8 to 14"), [(0, 34), (8, 14)])
        self.assertEqual(check.spans("0.94 .. 1.03"), [(0.94, 1.03)])
        self.assertEqual(check.spans("18.6"), [(18.6, 18.6)])
        for said, found, factor, within in (([(2, 2)], [(3, 3)], 1.5, True), ([(2, 2)], [(3.1, 3.1)], 1.5, False), ([(3, 3)], [(2, 2)], 1.5, True),
                                            ([(0, 0)], [(0, 0)], 1, True), ([(0, 0)], [(1, 1)], 1.5, False), ([(1, 2)], [(1, 2), (1, 2)], 2, False)):
            self.assertEqual(check.is_within(said, found, factor), within)


if __name__ == "__main__":
    unittest.main()
