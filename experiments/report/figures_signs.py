"""Figure 4, sign maps: what each arithmetic answers at a square of neighbouring doubles, in the manner of Kettner et al. 2008."""

import os

import matplotlib.pyplot as plt
import numpy as np

from report_data import distinct, percent, read
from report_page import Source
from report_style import WIDTH

# Minus, zero, plus: no, on the boundary, yes, where the answer has two or three values.
COLOURS = {"-": (0, 114, 178), "0": (240, 228, 66), "+": (213, 94, 0)}


def picture(rows):
    letters = np.array([list(r["answers"]) for r in sorted(rows, key=lambda r: int(r["row"]))])
    colours = np.zeros((*letters.shape, 3), dtype=np.uint8)
    for letter, colour in COLOURS.items():
        colours[letters == letter] = colour
    return letters, colours


def sections(page, study, campaign):
    rows = read(os.path.join(page.out, "sign_maps.csv"))
    if not rows:
        return
    maps, subjects = distinct(r["map"] for r in rows), distinct(r["subject"] for r in rows)
    fig, axes = plt.subplots(len(maps), len(subjects), figsize=(WIDTH, 1.42 * len(maps) + 0.2), squeeze=False)
    lines = []
    for line, name in zip(axes, maps):
        pictures = {s: picture([r for r in rows if (r["map"], r["subject"]) == (name, s)]) for s in subjects}
        truth = pictures["exact"][0]
        for axis, subject in zip(line, subjects):
            letters, colours = pictures[subject]
            wrong = int((letters != truth).sum())
            axis.imshow(colours, interpolation="nearest", origin="lower")
            axis.set_xticks([])
            axis.set_yticks([])
            for spine in axis.spines.values():
                spine.set_visible(False)
            axis.set_xlabel("the truth" if subject == "exact" else f"{percent(wrong / truth.size)} wrong", fontsize=6.5, labelpad=2)
            if name == maps[0]:
                axis.set_title(subject, fontsize=7)
            lines.append([name, subject, letters.size, wrong, *(int((letters == c).sum()) for c in COLOURS)])
        line[0].set_ylabel(name, fontsize=7)
    fig.tight_layout(w_pad=0.3, h_pad=0.4)
    source = Source.of(rows, "What does each arithmetic answer at a grid of neighbouring doubles about a degenerate place?",
                       f"{sum(line[2] for line in lines):,} answers", seed="none: a grid of doubles")
    data = page.table("sign_maps", ["map", "subject", "asked", "wrong", "minus", "zero", "plus"], lines, source)
    yield page.section("sign-maps", "Sign maps", f"<p>One coordinate runs over {len(rows[0]['answers'])} neighbouring doubles across, another up; each dot is one "
                       "answer. Blue: negative, or no; yellow: zero, or touching; orange: positive, or yes. Where a picture differs from "
                       "the last of its row, the arithmetic is wrong.</p>", page.figure("sign_maps", fig, source, data))
