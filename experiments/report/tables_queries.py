"""The tables of what else is asked exactly: all contacts, distances, points and rays, beside other libraries; and poses in small steps."""

import html
import os

from report_data import read, rounded
from report_page import Source


def us(ns):
    return rounded(float(ns) / 1000)


def rows_and_source(page, name, question):
    rows = read(os.path.join(page.out, f"{name}.csv"))
    return rows, rows and Source.of(rows, question, f"{len(rows)} rows")


# A table has its CSV in OUT and the question that it answers. Then come title and words of its section, the columns that its CSV keeps, and the heads
# of the page's columns. Last is a function of a row, which returns whether the row is ours, and its cells.
TABLES = (
    ("contacts", "How fast are all contacts of bodies that collide, and how many of FCL's pairs are wrong?",
     "All contacts of bodies that collide",
     "Poses of a trajectory in which surfaces meet; each lists all pairs of triangles that share a point. Ours say exactly what they share, "
     "with enclosures where they share it. FCL has no limit of contacts. <b>Lost</b> and <b>invented</b>: pairs that it misses or makes up, "
     "of those that exact signs find.",
     ["scenario", "object", "triangles", "method", "poses", "pairs", "ns", "ratio", "lost", "invented"],
     ["trajectory", "bodies", "method", "poses", "pairs a pose", "\u00b5s a pose", "time / ours", "lost", "invented"],
     lambda r: (r["method"] == "tetracone", [
         html.escape(r["scenario"]), html.escape(r["object"]), html.escape(r["method"]), r["poses"],
         f"{float(r['pairs']) / float(r['poses']):.1f}", us(r["ns"]), f"{float(r['ratio']):.2f}", r["lost"], r["invented"]])),
    ("distance", "What does an exact distance cost beside FCL's, and how far off is each?",
     "Exact distances",
     "The distance of two surfaces along trajectories, and whether it is within a tenth of the body's size. Errors are in units in the last place "
     "of the double nearest to the exact distance, over poses in which the bodies are apart. <b>0, apart</b>: poses in which bodies that are apart "
     "have distance 0; <b>&gt; 0, touching</b>: the other mistake. In <i>gaps</i>, cubes of known distance; elsewhere the exact distance is our own.",
     ["trajectory", "triangles", "subject", "question", "poses", "mean_ns", "mean_ulps", "most_ulps", "apart", "zero_apart", "touching",
      "positive_touching"],
     ["trajectory", "triangles", "subject", "question", "\u00b5s", "mean ulps", "most ulps", "0, apart", "&gt; 0, touching"],
     lambda r: (r["subject"] == "tetracone adaptive", [
         html.escape(r["trajectory"]), r["triangles"], html.escape(r["subject"]), html.escape(r["question"]), us(r["mean_ns"]),
         r["mean_ulps"], r["most_ulps"], f"{r['zero_apart']} of {r['apart']}", f"{r['positive_touching']} of {r['touching']}"])),
    ("coherence", "What does remembering the last pose save, by how far a body moves from one to the next?",
     "Poses in small steps",
     "Smooth walks of a star-shaped body round itself, asked with what the last pose told remembered and without, in turn. The size is the larger body's. "
     "<b>Differ</b>: poses in which the two do not answer alike.",
     ["ratio", "clearance", "motion", "question", "poses", "collisions", "differ", "ns_without", "ns_with", "times_faster", "box_tests_without",
      "box_tests_with"],
     ["relative size", "clearance", "motion a pose, % of the size", "question", "\u00b5s without", "\u00b5s with", "times faster", "box tests", "with",
      "differ"],
     lambda r: (float(r["times_faster"]) >= 1, [
         f"1:{float(r['ratio']):g}", f"{100 * float(r['clearance']):g} %", rounded(100 * float(r["motion"])),
         html.escape(r["question"]),
         us(r["ns_without"]), us(r["ns_with"]), f"{float(r['times_faster']):.2f}", f"{float(r['box_tests_without']):.0f}",
         f"{float(r['box_tests_with']):.0f}", f"{r['differ']} of {r['poses']}"])),
    ("points", "What does a point in a solid cost, and the first hit of a ray?",
     "Points and rays",
     "Random points in the box of the body, points within a thousandth of its surface, and the first faces that rays meet. <b>Signs</b>: decisions "
     "by a sign of the adaptive kernel, a question. All answers are judged by the truth.",
     ["body", "triangles", "asked", "contestant", "ns", "signs", "setup_ms", "bytes_per_triangle", "judged", "wrong"],
     ["body", "triangles", "asked", "method", "\u00b5s", "signs", "set-up, ms", "bytes a triangle", "wrong"],
     lambda r: (r["contestant"] in ("cones", "boxes"), [
         html.escape(r["body"]), r["triangles"], html.escape(r["asked"]), html.escape(r["contestant"]), us(r["ns"]), r["signs"],
         f"{float(r['setup_ms']):.1f}", f"{float(r['bytes_per_triangle']):.0f}", f"{r['wrong']} of {r['judged']}"])),
    ("scenes", "How fast is a frame of many bodies, and who misses what?",
     "Scenes of many bodies",
     "The mean time of a frame after the first, and the pairs that each broad phase lets through. Lost and invented pairs are against the truth in rationals: on all frames of 1,000 bodies, "
     "on the last frame of more. <i>tetracone</i> keeps pairs apart by the gap between them; <i>CGAL boxes, our "
     "queries</i> asks every pair of boxes anew.",
     ["scene", "model", "triangles", "bodies", "method", "frames", "us_a_frame", "us_first_frame", "ratio", "candidates", "pairs_judged", "lost",
      "invented"],
     ["scene", "model", "bodies", "method", "ms a frame", "first, ms", "ratio", "candidates", "pairs judged", "lost", "invented"],
     lambda r: (r["method"] == "tetracone", [
         html.escape(r["scene"]), html.escape(r["model"]), r["bodies"], html.escape(r["method"]),
         *(rounded(float(r[c]) / 1000) for c in ("us_a_frame", "us_first_frame")), f"{float(r['ratio']):.2f}",
         r["candidates"], r["pairs_judged"], r["lost"], r["invented"]])),
    ("moving_bodies", "What does the exact first contact of two moving bodies cost, and which contacts do others miss?",
     "Bodies in motion",
     "Each motion of a course asked for its first contact; <b>static N</b> asks at N poses of it. Time is in questions at one pose of the same course, of motions without "
     "a contact and with one. <b>Latest</b>: how much later than the exact first contact one is told, of the motion. FCL's continuousCollide: by conservative advancement, and by steps.",
     ["course", "triangles", "subject", "motions", "contacts", "missed", "invented", "latest", "static_ns", "apart_in_statics", "contact_in_statics"],
     ["course", "triangles", "method", "motions", "contacts", "missed", "invented", "latest", "apart, in static questions", "contact"],
     lambda r: (r["subject"] == "tetracone", [
         html.escape(r["course"]), r["triangles"], html.escape(r["subject"]), r["motions"], r["contacts"], r["missed"], r["invented"],
         rounded(float(r["latest"]), 2), *(rounded(float(r[c])) for c in ("apart_in_statics", "contact_in_statics"))])),
)


def sections(page, study, campaign):
    """A section of each of these tables in OUT that is there."""
    for name, question, title, words, columns, head, line in TABLES:
        rows, source = rows_and_source(page, name, question)
        if rows:
            data = page.table(name, columns, [[r[c] for c in columns] for r in rows], source)
            yield page.section(f"asked-{name}", title, f"<p>{words}</p>", page.html_table(head, [line(r) for r in rows], source, data))
