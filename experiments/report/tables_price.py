#!/usr/bin/python3
"""OUT/study.csv, OUT/contact_cost.csv -> the price of exactness by regime and kind of contact, on the terminal.  usage: tables_price.py OUT

The adaptive kernel's time is given over double's on the same tree, and over that of the general exact stage alone. It is also given over FCL's,
whose answers are wrong at times.
"""

import html
import os
import sys

from report_data import by, geometric_mean, interval, rounded, share
from study_data import Study, workload

EXACT, ROUNDED, FCL = ("adaptive tree", "adaptive locator"), ("double tree",), ("FCL OBBRSS",)
GENERAL = "epeck tree", "rational tree"  # distances are not asked of the first
COLUMNS = ("regime", "contact", "question", "workloads", "poses", "collisions", "adaptive_us", "over_double", "over_double_low", "over_double_high",
           "over_fcl", "over_fcl_low", "over_fcl_high", "over_general", "over_general_low", "over_general_high", "exact_signs", "wrong_double", "wrong_fcl")
COLLISIONS = "surface", "solid"
REGIME = {"random": "in motion", "exactly degenerate": "exact contact", "near-degenerate": "near contact", "nested": "containment"}


def whole(rows, key):
    return int(sum(r[key] for r in rows))


def prices(study):
    """A row a trajectory or a kind of contact, and question: see COLUMNS. FCL answers of surfaces alone."""
    lines = []
    order = {panel: k for k, panel in enumerate(REGIME)}
    mine = sorted((r for r in study.rows if r["subject"] in EXACT), key=lambda r: order[r["panel"]])
    other = {(workload(r), r["subject"]): r for r in study.rows}
    for (panel, scenario, question), rows in by(mine, "panel", "scenario", "question").items():
        both = {of: [(r, next(other[workload(r), s] for s in of if (workload(r), s) in other)) for r in rows if any((workload(r), s) in other for s in of)]
                for of in (ROUNDED, FCL, GENERAL)}
        if question == "solid":
            both[FCL] = []  # its answers are of surfaces
        over = {of: [a["mean_ns"] / b["mean_ns"] for a, b in pairs] for of, pairs in both.items()}
        lines.append([REGIME[panel], scenario, question, len(rows), whole(rows, "poses"), whole(rows, "collisions"),
                      f"{geometric_mean(r['mean_ns'] for r in rows) / 1000:.4g}",
                      *(f"{x:.4g}" if ratios and x is not None else "" for ratios in over.values() for x in (geometric_mean(ratios), *interval(ratios))),
                      f"{sum(r['exact_fallbacks'] for r in rows) / len(rows):.3g}",
                      *(whole([b for _, b in both[of]], "wrong") if both[of] else "" for of in (ROUNDED, FCL))])
    return [dict(zip(COLUMNS, line)) for line in lines]


def ratio(price, key):
    """5.2 (4.9 .. 5.5): the geometric mean, and its interval where there are several workloads."""
    if not price[key]:
        return "–"
    low, high = price[key + "_low"], price[key + "_high"]
    return rounded(float(price[key])) + (f" ({rounded(float(low))} .. {rounded(float(high))})" if low else "")


def section(page, study, name, title, words, asked, found):
    source = study.source(asked, [r for r in study.rows if r["subject"] in EXACT + ROUNDED + FCL + GENERAL and r["question"] in {p["question"] for p in found}])
    data = page.table(name, list(COLUMNS), [list(p.values()) for p in found], source)
    body = [(False, [p["regime"], f"{html.escape(p['contact'])}<br><small>{p['question']}</small>", f"{p['collisions']:,} of {p['poses']:,}",
                     rounded(float(p["adaptive_us"])),
                     *(ratio(p, key) for key in ("over_double", "over_fcl", "over_general")),
                     rounded(float(p["exact_signs"])),
                     *(share(p[w], p["poses"]) if p[w] != "" else "–" for w in ("wrong_double", "wrong_fcl"))]) for p in found]
    head = ["regime", "contact", "collide", "adaptive, µs", "time / double's, same tree", "time / FCL's", "time / general exact stage's", "exact signs a query",
            "wrong: double", "wrong: FCL"]
    return page.section(name, title, f"<p>{words}</p>", page.html_table(head, body, source, data))


def sections(page, study, campaign):
    if study and any(s in study.subjects for s in EXACT) and any(s in study.subjects for s in ROUNDED):
        yield section(page, study, "price", "The price of exactness", "The adaptive kernel on the fast tree, over the same tree with leaves decided in double, "
                      "over FCL, and over rationals that are filtered by intervals. In parentheses: the 95 % interval of the geometric mean, by resampling the "
                      "workloads, where there are several.", "What does exactness cost, by regime and kind of contact?", prices(study))
    others = Study(page.out, "contact_cost")
    if found := [p for p in prices(others) if p["question"] not in COLLISIONS]:
        yield section(page, others, "price_of_questions", "The price of exactness, of other questions in contact", "Contacts, distances, motions, points, rays and "
                      "scenes where bodies touch or nearly do, as above. A point by table is asked of <code>Body::inside</code>, a motion and a ray have no method "
                      "in double on the same tree. In <b>collide</b> are the cases in contact.",
                      "What does exactness cost where bodies touch, by question and kind of contact?", found)


def main():
    if len(sys.argv) != 2:
        sys.exit(f"usage: {os.path.basename(sys.argv[0])} OUT")
    found = [p for name in ("study", "contact_cost") for p in prices(Study(sys.argv[1], name))]
    if not found:
        sys.exit(f"{sys.argv[1]}: no study.csv or contact_cost.csv; expected the results of tetracone experiment study or contact-cost")
    print("| regime | contact | question | collide | adaptive, µs | over double, same tree | over FCL | over general exact | exact signs a query | wrong: double | "
          "wrong: FCL |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for p in found:
        print("| " + " | ".join([p["regime"], p["contact"], p["question"], f"{p['collisions']} of {p['poses']}", f"{float(p['adaptive_us']):.2g}",
                                 *(ratio(p, key) for key in ("over_double", "over_fcl", "over_general")), p["exact_signs"], str(p["wrong_double"]), str(p["wrong_fcl"])]) + " |")


if __name__ == "__main__":
    main()
