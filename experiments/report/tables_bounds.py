"""The table of error bounds: each constant in the code, what is proved to be enough, and the worst found."""

import html
import os
import re

from report_data import read
from report_page import Source


def sections(page, study, campaign):
    """OUT/error_bounds.csv, where it is there."""
    rows = read(os.path.join(page.out, "error_bounds.csv"))
    if not rows:
        return
    source = Source.of(rows, "How much of each error bound is proved to be needed, and how much does a search find?",
                       f"{len(rows)} constants")
    columns = ["constant", "file", "unit", "in_code", "proved", "proved_by", "proof", "found", "proved_over_found", "not_searched"]
    data = page.table("error_bounds", columns, [[r[c] for c in columns] for r in rows], source)

    def number(text):
        return f"<span class=whole>{float(text):.4g}</span>" if text else ""

    def name(text):  # its lines end within long names too
        return re.sub(r"(/|_|::)", r"\1<wbr>", html.escape(text))
    body = [(False, [name(r["constant"]), name(r["file"]), *(number(r[c]) for c in ("unit", "in_code", "proved")),
                     r["proved_by"], name(r["proof"]), number(r["found"]) or html.escape(r["not_searched"]),
                     number(r["proved_over_found"])]) for r in rows]
    head = ["constant", "file", "unit", "in the code", "proved", "by", "proof", "found", "proved / found"]
    yield page.section("bounds", "Error bounds, proved by machine",
                       "<p>Constants by which rounded arithmetic decides or discards, in multiples of the unit. <b>Proved</b>: the least that the "
                       "proof shows to be enough: by Gappa, from what the templates of the code record when they run, or in exact rationals "
                       "or intervals where the argument is one of geometry or counts roundings. <b>Found</b>: the worst of a search by hill climbing "
                       "against rational truth, or why there is none. What is by <b>hand</b> is checked by no machine: its reason stands in place of what is found.</p>", page.html_table(head, body, source, data))
