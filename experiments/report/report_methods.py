"""The page's frame: style, methods, how to cite."""

import html
import os
import re

from report_data import distinct

KEY_OF_CHART = ("<p class=note>Each point is a way of answering. Across: time per query, geometric mean over the workloads; up: share of "
                "answers that differ from the truth, bars are 95 % intervals (Wilson). The green band is none wrong; there the dotted line "
                "reaches the bound that so many cases can give. Colour: kernel; shape: method; filled: exact by construction. Dashed: the "
                "Pareto front.</p>")

STYLE = """
:root { color-scheme: light dark; --ink: #1b1b1b; --paper: #ffffff; --line: #d5d5d5; --shade: #e8f5f0; --link: #00527f; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e8; --paper: #16181b; --line: #3a3f45; --shade: #17352c; --link: #7cc4f0; } }
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 72rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.4rem; margin: 0; line-height: 1.2; } h2 { font-size: 1.2rem; margin: 2rem 0 0.4rem; }
a { color: var(--link); } p { max-width: 60rem; }
figure { margin: 0.5rem 0 1rem; } .drawing { overflow-x: auto; } .on-white { background: #fff; border-radius: 6px; }
.drawing svg { width: 100%; min-width: 36rem; max-width: 72rem; height: auto; display: block; }
.scroll { overflow-x: auto; width: max-content; min-width: 100%; max-width: min(100vw - 2rem, 110rem); margin-left: 50%;
  transform: translateX(-50%); }
table { border-collapse: collapse; font-size: 0.82rem; } td { max-width: 26rem; } td:first-child { min-width: 8rem; }
.what { display: block; min-width: 12rem; }
th, td { padding: 0.2rem 0.4rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
tr.exact td { background: var(--shade); }
.source, .note { font-size: 0.78rem; line-height: 1.4; } .source { opacity: 0.85; overflow-wrap: anywhere; max-width: none; }
.whole { white-space: nowrap; } code { font-size: 0.92em; overflow-wrap: anywhere; }
pre { overflow-x: auto; font-size: 0.8rem; padding: 0.6rem; border: 1px solid var(--line); border-radius: 6px; white-space: pre-wrap; }
.claim { font-size: 1.02rem; margin: 0.2rem 0; max-width: none; }
#verdicts { margin: 0.4rem 0 0; } #opening figure { margin-bottom: 0.2rem; }
.verdicts { font-size: 0.76rem; line-height: 1.35; padding-left: 0; list-style: none; columns: 3 20rem; column-gap: 1.5rem;
  margin: 0.3rem 0; }
.verdicts li { break-inside: avoid; padding: 0.15rem 0.4rem; border-bottom: 1px solid var(--line); }
.verdicts li.exact { background: var(--shade); }
nav { font-size: 0.8rem; } nav a { margin-right: 0.8rem; white-space: nowrap; display: inline-block; } summary { cursor: pointer; }
@media print {
  :root { --ink: #000; --paper: #fff; --line: #bbb; --shade: #eef6f2; --link: #000; }
  @page { size: A4; margin: 14mm; }
  body { max-width: none; padding: 0; font-size: 9.5pt; } nav { display: none; } a { text-decoration: none; }
  .drawing, .scroll { overflow: visible; } .drawing svg { min-width: 0; } table { font-size: 6.2pt; }
  .scroll { width: auto; max-width: none; margin: 0; transform: none; }
  td, th { padding: 1pt 3pt; } td:first-child, .what { min-width: 0; }
  figure, .verdicts li, tr { break-inside: avoid; } h2, h2 + p { break-after: avoid; } thead { display: table-header-group; }
}
"""

METHODS = (
    ("Definitions", "Every coordinate is a double and every entry of a pose a double or a fraction, taken as the rational that it is; the placed "
     "polyhedron is the exact affine image. Fractions make exact rotations. <i>surface</i> asks whether the two closed surfaces share a point, <i>solid</i> whether the two closed "
     "solids do: touching counts, in a single point too; one inside the other collides as solids, one inside the other's cavity does not."),
    ("Truth", "An answer is right or wrong against the exact answer; there is no tolerance in the comparison. The campaign computes each "
     "truth twice, by formulations that share with each other and with what they judge the polyhedron, the exact entries of poses and GMP alone: CGAL's exact intersections over rationals, "
     "and integers of GMP; a case on which the two disagree, or which contradicts what its family knows by construction, stops the "
     "campaign. The study's truth is the first of the two."),
    ("Subjects", "<i>tree</i> is the fast tree of oriented boxes, eight a node, with leaves and containment decided by the kernel; <i>tuned</i> is "
     "the tetra-tree tuned within its own parameters, with boxes in its leaves; <i>paper</i> has the choices of Jiménez and Segura 2008. "
     "Both look at all pairs once where their leaves would be asked about more. <i>brute</i> tests every edge against every face. Peers are other libraries as their users run them, each in a process of its own. A subject that does not take an input is not "
     "asked: a library of doubles no pose that has a fraction, since it would be judged by a pose that it was not given. Our rounding kernels "
     "are asked all poses, since taking the nearest doubles is their definition; fractions stand apart. A library of surfaces is counted "
     "by the surface question, and what it says of solids stands apart. A crash or a missing answer is counted as wrong."),
    ("Families", "A family is a generator from (seed, index); its parameter sweeps from far from degenerate to exactly degenerate. They "
     "are grouped for the panels thus: {regimes}. <i>random</i> is two things: the family <i>random</i>, of random coordinates, which is the "
     "panel <i>random coordinates</i> of the campaign; and <i>random</i> motion, the trajectories of the study. Sequences are motions in exact contact, frame by frame, by dyadic steps or rational "
     "rotations."),
    ("Distance", "The relative determinant is |D| / P, with D the determinant nearest to zero of those that decide the case and P the sum "
     "of the absolute values of its products; in ulps it is the distance of the vertex from the plane, or of two lines, in units of the "
     "last place of the largest coordinate. Both are exact."),
    ("Statistics", "Shares are counts over cases with Wilson's 95 % interval; none in n is stated with its upper end, 3.84 / (n + 3.84). "
     "Times are means per workload, combined by the geometric mean; each query's time in the study is the fastest of up to five passes on "
     "one core, the rational kernel asked every fourth pose. Times of the campaign are of one pass, on bodies made anew for each question: what it takes to make them "
     "ready and to ask are two columns. Those of a library are taken in its own process, without the pipe to it; those of somebody else's "
     "program are what it tells of itself, else none is kept. Fast trees make their nodes while they are asked."),
    ("Threats to validity", "The families are chosen to be hard: a share over them is no forecast for any application, only what can be "
     "compared between subjects on equal cases. Cases of a family share their bodies at times, and frames of a sequence follow one "
     "another, so that answers are not independent and intervals are too narrow there. Degenerate cases are over-weighted by design. "
     "Objects are not the paper's, which were not published: two are of its counts of vertices and faces, two meshes are decimated to its "
     "sizes, and the machine is another. Times are of one machine, with whatever else ran on it; compare them within one report. Peers may "
     "be faster or surer with other settings. Both truths could be wrong alike; they share the input and the definition."))


def bibtex(citation):
    """The entries of the program and the dataset, from CITATION.cff, and of the paper."""
    title, version, year = citation["title"], citation["version"], citation["year"]
    return (f"@software{{tetracone,\n  title = {{{title}}},\n  author = {{{{{citation['author']}}}}},\n  version = {{{version}}},\n"
            f"  year = {{{year}}}\n}}\n\n"
            f"@misc{{tetracone_dataset,\n  title = {{Collisions with exact truth}},\n  author = {{{{{citation['author']}}}}},\n  "
            f"note = {{Dataset of version {version}, made by tetracone experiment dataset}},\n  year = {{{year}}}\n}}\n\n"
            "@article{jimenez2008collision,\n  title = {Collision detection between complex polyhedra},\n  author = {Jim{\\'e}nez, Juan J. "
            "and Segura, Rafael J.},\n  journal = {Computers \\& Graphics},\n  volume = {32},\n  number = {4},\n  pages = {402--411},\n  "
            "year = {2008},\n  doi = {10.1016/j.cag.2008.05.002}\n}")


def citation():
    """The first title, version, date and author of CITATION.cff, which holds them a line each."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "CITATION.cff"), encoding="utf-8") as file:
        text = file.read()
    def first(key):
        found = re.search(rf'^[ -]*{key}: *"?([^"\n]*)"?$', text, re.MULTILINE)
        if not found:
            raise ValueError(f"CITATION.cff: no {key}")
        return found.group(1)
    return dict(title=first("title"), version=first("version"), year=first("date-released")[:4], author=first("name"))


def sections(page, study, campaign):
    from campaign_data import REGIME
    regimes = "; ".join(f"<i>{regime}</i>: {', '.join(f for f, r in REGIME.items() if r == regime)}"
                        for regime in distinct(REGIME.values()))
    if others := [r["family"] for r in campaign.tables["families"] if "object" in r["levels"].split() and r["family"] not in REGIME]:
        regimes += f"; in no panel: {', '.join(others)}"
    yield page.section("methods", "Methods", *(f"<p><b>{title}.</b> {text.replace('{regimes}', regimes)}</p>" for title, text in METHODS))
    seeds = distinct([r["seed"] for r in study.rows] + [r["seed"] for r in campaign.tables["runs"]])
    yield page.section("cite", "How to cite", f"<p>Cite the software by its version, with the seed {', '.join(seeds)} of these numbers, "
                       f"and the paper whose method it makes exact. The same entries are in "
                       f"<code>experiments/artifact/README.md</code>.</p><pre>{html.escape(bibtex(citation()))}</pre>")


def frame(opening, sections):
    links = "".join(f'<a href="#{name}">{title}</a>' for section in sections
                    for name, title in re.findall(r'^<section id="([^"]*)"><h2>([^<]*)</h2>', section))
    return (f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, '
            f'initial-scale=1">\n<title>Tetracone: speed against accuracy</title>\n'
            f"<style>{STYLE}</style></head><body>\n<h1>Collision detection: speed against accuracy</h1>\n<section "
            f"id=\"opening\">{opening}</section>\n<nav>{links}</nav>\n{''.join(sections)}\n</body></html>\n")
