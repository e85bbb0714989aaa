"""Certificates: which answers are proved, and what a proof costs."""

import matplotlib.pyplot as plt
from matplotlib.ticker import PercentFormatter

from report_style import BLUE, GREEN, GREY, ORANGE, WIDTH
from tables_queries import rows_and_source


def shares(axis, rows):
    """The share of answers that have a proof which the checker accepts."""
    axis.barh(range(len(rows)), [100 * int(r["proved"]) / int(r["asked"]) for r in rows], color=GREEN, height=0.6)
    axis.set_xlim(0, 100)
    axis.xaxis.set_major_formatter(PercentFormatter(decimals=0))
    axis.set_yticks(range(len(rows)), [r["kind"] for r in rows])
    axis.invert_yaxis()
    axis.set_title("answers proved")


def costs(axis, rows, columns, unit, title):
    """A mark a column: (its name, its colour, its label), in units of so much."""
    for column, colour, label in columns:
        places = [(float(r[column]) / unit, k) for k, r in enumerate(rows) if int(r["proved"]) > 0]
        axis.plot([x for x, _ in places], [k for _, k in places], ls="", marker="o", ms=4.5, color=colour, label=label)
    axis.set_xscale("log")
    axis.grid(True, axis="x")
    axis.legend(fontsize=6.5, frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.1), ncol=len(columns), handletextpad=0.1, columnspacing=1.0)
    axis.set_title(title)


def sections(page, study, campaign):
    """OUT/certificates.csv, where it is there."""
    rows, source = rows_and_source(page, "certificates", "Which answers are proved by a program without our code, and what does a proof cost?")
    if not rows:
        return
    fig, axes = plt.subplots(1, 3, figsize=(WIDTH, 0.9 + 0.19 * len(rows)), sharey=True)
    shares(axes[0], rows)
    costs(axes[1], rows, (("bytes_mean", BLUE, "mean"), ("bytes_most", GREY, "largest")), 1000, "size, kB")
    costs(axes[2], rows, (("made_ns", BLUE, "made"), ("checked_ns", ORANGE, "checked")), 1e6, "time, ms")
    fig.tight_layout(w_pad=1.0)
    asked, proved, refused = (sum(int(r[column]) for r in rows) for column in ("asked", "proved", "refused"))
    source = source.about(cases=f"{asked:,} answers, {proved:,} proved, {refused:,} refused")
    columns = ["kind", "asked", "proved", "without_proof", "refused", "bytes_mean", "bytes_most", "made_ns", "checked_ns"]
    data = page.table("certificates_by_kind", columns, [[r[c] for c in columns] for r in rows], source)
    yield page.section(
        "certificates", "Answers that carry their proof",
        "<p>Each answer of these kinds writes a certificate, and a checker that shares no code with us proves it in fractions. An answer without a proof is right as far as the two truths tell, "
        "but the search found no certificate. The bodies stand in the certificate. Its making includes the search for the proof.</p>",
        page.figure("certificates", fig, source, data))
