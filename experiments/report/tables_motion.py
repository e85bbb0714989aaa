"""The table of moving primitives: how often, and at what time a query, each way to decide whether they meet is wrong."""

import html
import os

from report_data import distinct, read, rounded
from report_page import Source


def sections(page, study, campaign):
    """OUT/motion.csv, where it is there."""
    rows = read(os.path.join(page.out, "motion.csv"))
    if not rows:
        return
    source = Source.of(rows, "How fast, and how often wrong, are ways to decide whether a moving vertex and face, or two moving edges, meet?",
                       f"{sum(int(r['n']) for r in rows if r['subject'] == rows[0]['subject']):,} moving pairs")
    groups = (("published", lambda r: r["family"].startswith("published")), ("families", lambda r: not r["family"].startswith("published")))
    lines = []
    for group, within in groups:
        for subject in distinct(r["subject"] for r in rows):
            mine = [r for r in rows if r["subject"] == subject and within(r)]
            if not mine:
                continue
            n = sum(int(r["n"]) for r in mine)
            us = sum(int(r["n"]) * float(r["us"]) for r in mine) / n
            lines.append([group, subject, n, *(sum(int(r[c]) for r in mine) for c in ("contacts", "false_positives", "false_negatives")),
                          f"{us:.4g}"])
    columns = ["of", "subject", "n", "contacts", "false_positives", "false_negatives", "us"]
    data = page.table("motion", columns, lines, source)
    body = [(missed == invented == 0, [group, html.escape(subject),
                                       *(f"{x:,}" for x in (n, contacts, missed, invented)), rounded(float(us), 4)])
            for group, subject, n, contacts, invented, missed, us in lines]
    head = ["queries", "subject", "asked", "contacts", "missed", "invented", "µs a query"]
    yield page.section("motion", "Moving primitives",
                       "<p>A vertex and a face, or two edges, move at constant speed: do they meet? <b>adaptive</b> is this project's; <b>root-parity</b> "
                       "(Brochu et al. 2012) and <b>inclusion</b> (Wang et al. 2021) are written from their descriptions, the first in rationals "
                       "throughout, so its time is not the published one's. Shaded: never wrong here.</p>",
                       page.html_table(head, body, source, data))
