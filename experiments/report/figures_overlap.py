"""Touch or overlap, and how deep: what other libraries say of boxes side by side and of convex bodies' depths, and what a bracket costs."""

import html

import matplotlib.pyplot as plt

from report_data import by, distinct, duration, rounded
from report_page import Source
from report_style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION, WIDTH
from tables_queries import rows_and_source, us

TOUCHES = "meet"  # the relation of bodies that share points, and no inner ones
EXACT_WIDTH = 1e-17  # what is exact stands there


def collide_in(rows):
    return sum(int(r["collide"]) for r in rows), sum(int(r["asked"]) for r in rows)


def touching(page):
    rows, source = rows_and_source(page, "touching", "Do other libraries tell bodies that touch from bodies that overlap?")
    if not rows:
        return
    peers = distinct(r["peer"] for r in rows)
    body = []
    for (kind, relation, frame), mine in by(rows, "kind", "relation", "frame").items():
        said = {r["peer"]: f"{r['collide']} of {r['asked']}" for r in mine}
        asked = max(int(r["asked"]) for r in mine)
        ours = f"{relation}, {asked - int(mine[0]['wrong_relations'])} of {asked}"
        body.append((relation == TOUCHES, [html.escape(kind), html.escape(frame), html.escape(ours), *(said.get(p, "-") for p in peers)]))
    columns = ["kind", "relation", "frame", "wrong_relations", "peer", "asked", "collide"]
    data = page.table("touching", columns, [[r[c] for c in columns] for r in rows], source.about(cases=f"{len(rows)} rows"))
    apart, overlaps = ([r for r in rows if (r["relation"] == TOUCHES) == touch] for touch in (True, False))
    told = [p for p in peers if collide_in([r for r in apart if r["peer"] == p])[0] == 0
            and len(set(collide_in([r for r in overlaps if r["peer"] == p]))) == 1]
    verdict = f"Those that tell them apart here: {', '.join(map(html.escape, told))}." if told else "None of them tells touching from overlapping boxes in every row."
    touch, n = collide_in(apart)
    yield page.section(
        "touching", "Touch or overlap",
        "<p>Boxes touch or overlap, and the exact relation of each pair is known. Their sizes and places are random; the doubles of the poses place them exactly. <b>Axes</b>: boxes along the axes; "
        "<b>turned</b>: both in one frame, turned by a rotation to 1e-11. A library says only whether they collide; the counts are of pairs that it says collide. Where touching counts, all pairs collide. "
        "Where it does not, those of shaded rows do not. Libraries of surfaces miss one box inside another. "
        f"All together say of {touch:,} of {n:,} touching pairs that they collide. {verdict}</p>",
        page.html_table(["pair", "frame", "exact relation, ours", *map(html.escape, peers)], body, source.about(cases=f"{len(rows)} rows"), data))


# What a peer's answers are counted as, in the order in which bars show them: name, colour, and the number of a row.
ANSWERS = (("within 1e-6", GREEN, lambda r: above_zero(r) - int(r["off_millionth"])),
           ("off, to 1 %", SKY, lambda r: int(r["off_millionth"]) - int(r["off_hundredth"])),
           ("off by more", ORANGE, lambda r: int(r["off_hundredth"])),
           ("0 or negative", VERMILION, lambda r: int(r["negative"])),
           ("infinite", PURPLE, lambda r: int(r["infinite"])),
           ("threw", INK, lambda r: int(r["failed"])),
           ("said apart", GREY, lambda r: int(r["apart"])))


def above_zero(row):
    return int(row["pairs"]) - sum(int(row[c]) for c in ("apart", "failed", "infinite", "negative"))


def draw_answers(axis, rows):
    """A bar a shape and peer: the shares of its answers."""
    for k, row in enumerate(rows):
        left = 0
        for _, colour, count in ANSWERS:
            share = 100 * count(row) / int(row["pairs"])
            axis.barh(k, share, left=left, color=colour, height=0.72)
            left += share
    axis.set_yticks(range(len(rows)), [f"{r['peer']}: {r['shape']}" for r in rows], fontsize=6.5)
    axis.invert_yaxis()
    axis.set_xlim(0, 100)
    axis.set_xlabel("answers, %")
    axis.set_title("depth of convex pairs, by other libraries")
    axis.legend(handles=[plt.Rectangle((0, 0), 1, 1, color=colour, label=name) for name, colour, count in ANSWERS if any(count(r) for r in rows)],
                ncol=3, fontsize=6, frameon=False, loc="upper center", bbox_to_anchor=(0.4, -0.18), handlelength=1, columnspacing=1)


def draw_widths(axis, rows):
    """A line a body and place: time against width, box after box."""
    for colour, ((triangles, place), mine) in zip((BLUE, SKY, VERMILION, ORANGE, PURPLE, GREEN), by(rows, "triangles", "place").items()):
        # Widths of a rounded root are as good as none.
        axis.plot([float(r["mean_ns"]) / 1e6 for r in mine], [max(float(r["mean_width"]), EXACT_WIDTH) for r in mine], color=colour, marker="o", ms=3.5, lw=1,
                  label=f"{triangles} triangles, {place}")
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_ylim(EXACT_WIDTH / 3, 2)
    axis.set_yticks([EXACT_WIDTH, 1e-12, 1e-9, 1e-6, 1e-3, 1], ["exact", "1e-12", "1e-9", "1e-6", "1e-3", "1"])
    axis.minorticks_off()
    axis.set_xlabel("time of a depth, ms")
    axis.set_title("width of the bracket, of the depth")
    axis.grid(True)
    axis.legend(fontsize=6, frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.18), ncol=2)


def depths(page):
    asked = "How deep do bodies penetrate each other, by other libraries, and what does a bracket of the least translation cost?"
    peers, _ = rows_and_source(page, "penetration_peers", asked)
    widths, _ = rows_and_source(page, "penetration_widths", asked)
    if not peers or not widths:
        return
    source = Source.of(peers + widths, asked, f"{sum(int(r['pairs']) for r in peers):,} answers of other libraries, and {len(widths)} brackets' means")
    columns = ["shape", "peer", "pairs", "apart", "failed", "infinite", "negative", "off_millionth", "off_hundredth", "mean_off", "most_off", "ns", "exact_ns"]
    data = page.table("penetration_peers", columns, [[r[c] for c in columns] for r in peers], source)
    width_columns = ["triangles", "place", "budget", "poses", "mean_ns", "exact", "mean_width"]
    data_of_widths = page.table("penetration_widths", width_columns, [[r[c] for c in width_columns] for r in widths], source)
    fig, axes = plt.subplots(1, 2, figsize=(WIDTH, 3.4), gridspec_kw={"width_ratios": [1, 1.1]})
    draw_answers(axes[0], peers)
    draw_widths(axes[1], widths)
    fig.tight_layout(w_pad=1.2)
    body = [(False, [html.escape(r["shape"]), html.escape(r["peer"]), r["pairs"], r["apart"], str(int(r["infinite"]) + int(r["failed"])), r["negative"],
                     r["off_millionth"], r["off_hundredth"], r["mean_off"] and rounded(float(r["mean_off"]), 2),
                     rounded(float(r["most_off"]), 2), us(r["ns"]), us(r["exact_ns"])])
            for r in peers]
    slowest = max(float(r["mean_ns"]) for r in widths)
    yield page.section(
        "depths", "How deep",
        "<p>The depth is the length of the least translation that parts two bodies. On the left are convex pairs, whose exact depth is known in closed form, and how far off other libraries are. "
        "libccd's MPR promises no least depth. On the right are bodies that are not convex. A bracket of the depth is never wrong; it gets narrower with each box of translations that is looked at. "
        f"<b>Shallow</b>: a hundredth of the size is left to go; <b>deep</b>: a third. The longest mean here is {duration(slowest)}.</p>",
        page.figure("depths", fig, source, data_of_widths),
        page.html_table(["shape", "library", "pairs", "said apart", "infinite or threw", "0 or negative", "off by &gt; 1e-6", "off by &gt; 1 %", "mean off", "most off",
                         "\u00b5s", "\u00b5s, ours, exact"], body, source, data))


def sections(page, study, campaign):
    """OUT/touching.csv, and OUT/penetration_*.csv, where they are there."""
    yield from touching(page)
    yield from depths(page)
