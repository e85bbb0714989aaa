"""The page of the field on trial, FIELD.html, from field.csv alone: write(CSV, HTML)."""

import csv
import html
import json
import math

GROUPS = {"exact": "exact arithmetic", "double": "meshes in double", "float": "meshes and solids in float", "convex": "convex solids alone",
          "rounded": "exact after rounding to a grid of 2^-n of the size"}
REGIMES = {"metres": "metres", "ladder": "ladder", "lego": "lego", "clear": "clear", "float-near": "near for float", "near": "near", "exact": "degenerate",
           "sequences": "sliding", "nested": "nested"}
OURS = ("adaptive tree", "double tree", "float tree")
STYLE = """
:root { color-scheme: light dark; --ink: #222; --paper: #fff; --line: #ddd; --shade: #f2f2f2; --faint: #bbb;
  --note: #555; --best: #2c5f9e; --other: #999; --wrong: #e8a090; --missed: 224 123 108; --invented: 127 168 217 }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e8; --paper: #16181b; --line: #3a3f45; --shade: #24282d;
  --faint: #666; --note: #aaa; --best: #7cb0f0; --other: #888; --wrong: #8c3f30; --missed: 158 62 48; --invented: 46 92 150 } }
body { font: 15px/1.45 system-ui, sans-serif; max-width: 1340px; margin: 2em auto; padding: 0 1em }
body { color: var(--ink); background: var(--paper) } svg { fill: var(--ink) }
table { border-collapse: collapse; margin: 1em 0; font-size: 12px } th, td { padding: 2px 3px; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap }
th { font-weight: 600; vertical-align: bottom; white-space: normal } td:first-child, th:first-child { text-align: left } .group td { font-weight: 600; background: var(--shade); text-align: left }
.cell { border-left: 2px solid var(--paper) } .strip td:first-child { min-width: 24em } .none { color: var(--faint) } .note { color: var(--note); max-width: 75em } .bad { background: var(--wrong) } .ours { font-style: italic }
.bar { display: inline-block; height: 9px; background: #7a9cc0 } .text { text-align: left; white-space: normal; overflow-wrap: break-word } .text.long { min-width: 22em } figure { margin: 1em 0 }
"""


def wilson(hits, n):
    if n == 0:
        return 0, 1
    z, p = 1.959963984540054, hits / n
    centre, half = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return max(0, (centre - half) / (1 + z * z / n)), min(1, (centre + half) / (1 + z * z / n))


def number(row, *keys):
    return sum(int(row[k] or 0) for k in keys)


def shade(share, kind):
    """The colour of what is "missed" or "invented", none at a share of 0 and whole at 60 % and more.

    It grows with the root of the share, so that few errors are seen."""
    weight = min(1, math.sqrt(share / 0.6)) if share > 0 else 0
    return f"rgb(var(--{kind}) / {weight:.3g})"


def percent(hits, n):
    low, high = wilson(hits, n)
    return f"{100 * hits / n:.1f} % ({100 * low:.1f} .. {100 * high:.1f})" if n else ""


class Field:
    def __init__(self, path):
        self.rows = list(csv.DictReader(open(path)))
        self.group = {r["subject"]: r["regime"] for r in self.of("engine")}
        self.hello = {r["subject"]: json.loads(r["text"]) if r["text"] else {} for r in self.of("engine")}

    def of(self, table, **values):
        return [r for r in self.rows if r["table"] == table and all(r[k] == v for k, v in values.items())]

    def engines(self, question=None):
        """Engines by group, ours first, that were asked the question."""
        asked = {r["subject"] for r in self.of("regime") if question in (None, r["question"])}
        return [(g, sorted((s for s in self.group if self.group[s] == g and s in asked), key=lambda s: (s not in OURS, s.lower()))) for g in GROUPS]


def name_of(field, subject):
    wasm = "@" in field.hello.get(subject, {}).get("library", "")
    text = html.escape(subject.replace("-", " ") if wasm else subject) + (" <small>wasm</small>" if wasm else "")
    return f'<span class="ours">tetracone, {text}</span>' if subject in OURS else text


def cell(missed, invented, failed, n):
    if n == 0:
        return '<td class="none">.</td>'
    left, right = shade(missed / n, "missed"), shade(invented / n, "invented")
    title = f"{missed} missed, {invented} invented, {failed} failed of {n}: wrong {percent(missed + invented, n)}"
    failures = f"+{failed}f" if failed else ""
    return (f'<td class="cell" title="{title}" style="background: linear-gradient(90deg, {left} 50%, {right} 50%)">'
            f'{missed}+{invented}{failures}<small> /{n}</small></td>')


def heat_map(field, question):
    common = {(r["subject"], r["regime"]): r for r in field.of("common", question=question)}
    touching = {r["subject"]: r for r in field.of("touching", question=question)}
    flush = {r["subject"]: r for r in field.of("flush", question=question)}
    kinds = [k for k in ("meshes", "all") if any(key[1] == k for key in common)]
    regimes = [k for k in REGIMES if any(r["regime"] == k for r in field.of("regime"))]
    head = "".join(f"<th>{REGIMES[k]}</th>" for k in regimes)
    names = {"meshes": "asked of all<br>mesh engines", "all": "asked of<br>all engines"}
    apart = [(title, table) for title, table in (("touching<br>apart", touching), ("flush<br>apart", flush)) if table]
    head += "<th>wrong of all, 95 %</th><th>coverage</th>" + "".join(f"<th>{t}</th>" for t in [names[k] for k in kinds] + [title for title, _ in apart])
    body = ""
    for group, subjects in field.engines(question):
        body += f'<tr class="group"><td colspan="{3 + len(regimes) + len(kinds) + len(apart)}">{GROUPS[group]}</td></tr>' if subjects else ""
        for subject in subjects:
            rows = {r["regime"]: r for r in field.of("regime", subject=subject, question=question)}
            body += f"<tr><td>{name_of(field, subject)}</td>"
            for regime in regimes:
                r = rows.get(regime)
                body += cell(number(r, "missed"), number(r, "invented"), number(r, "failed"), number(r, "n")) if r else cell(0, 0, 0, 0)
            n, wrong = sum(number(r, "n") for r in rows.values()), sum(number(r, "missed", "invented") for r in rows.values())
            share = n / max(1, n + sum(number(r, "declined") for r in rows.values()))
            body += f'<td>{percent(wrong, n)}</td><td title="{n} asked"><span class="bar" style="width: {24 * share:.0f}px"></span> {100 * share:.0f} %</td>'
            for kind in kinds:
                r = common.get((subject, kind))
                body += cell(number(r, "missed"), number(r, "invented"), number(r, "failed"), number(r, "n")) if r else cell(0, 0, 0, 0)
            for _, table in apart:
                r = table.get(subject)
                body += f'<td>{r["missed"]}<small> /{r["n"]}</small></td>' if r and int(r["n"]) else '<td class="none">.</td>'
            body += "</tr>\n"
    return f"<table><tr><th>engine</th>{head}</tr>\n{body}</table>"


def floats(field, question):
    """Wrong answers of engines that hold their input as floats, parted into what rounding the input explains and what it does not."""
    regimes = [k for k in REGIMES if field.of("rounded", question=question, regime=k)]
    if not regimes:
        return ""
    head = "".join(f"<th>{REGIMES[k]}</th>" for k in regimes)
    body = ""
    for _, subjects in field.engines(question):
        for subject in subjects:
            rows = {r["regime"]: r for r in field.of("rounded", subject=subject, question=question)}
            if not rows:
                continue
            n, wrong, excused = (sum(number(r, k) for r in rows.values()) for k in ("n", "wrong", "excused"))
            changed, missed, invented = (sum(number(r, k) for r in rows.values()) for k in ("changed", "missed", "invented"))
            body += (f"<tr><td>{name_of(field, subject)}</td><td>{n}</td><td>{percent(changed, n)}</td><td>{percent(wrong, n)}</td><td>{percent(excused, n)}</td>"
                     f"<td>{percent(missed + invented, n)}</td>")
            for regime in regimes:
                r = rows.get(regime)
                body += cell(number(r, "missed"), number(r, "invented"), 0, number(r, "n")) if r else cell(0, 0, 0, 0)
            body += "</tr>\n"
    return (f"<h3>{question}</h3><table><tr><th>engine</th><th>asked</th><th>rounding changes<br>the truth</th><th>wrong of<br>the input</th>"
            f"<th>explained by<br>the rounding</th><th>wrong of the<br>rounded input</th>{head}</tr>\n{body}</table>")


def ladder(field):
    """Two panels: by the cubes' size, the largest gap called contact and the largest overlap missed, as powers of 2 of the size."""
    sizes = sorted({int(r["size"]) for r in field.of("ladder")})
    if not sizes:
        return "<p>The ladder was not asked.</p>"
    colours = ["#c0392b", "#2c5f9e", "#27864a", "#8e5bb5", "#d98324", "#16858f", "#7f6a4a", "#d1508f", "#5d6d7e", "#9aa11d"]
    colour, parts, width, height = {}, [], 560, 300
    x = {s: 60 + k * (width - 90) / max(1, len(sizes) - 1) for k, s in enumerate(sizes)}

    def y(exponent):
        return 30 + -exponent * (height - 70) / 50

    for panel, (what, title) in enumerate((("gap", "largest gap called contact"), ("overlap", "largest overlap missed"))):
        out = [f'<g transform="translate({panel * width} 0)"><text x="{width / 2}" y="14" text-anchor="middle">{title}, share of the size</text>']
        out.append(f'<rect x="60" y="{y(-23):.1f}" width="{width - 90}" height="{y(-25) - y(-23):.1f}" fill="var(--line)"/>')
        for e in (0, -10, -20, -30, -40, -50):
            out.append(f'<line x1="60" x2="{width - 30}" y1="{y(e):.1f}" y2="{y(e):.1f}" stroke="var(--line)"/><text x="54" y="{y(e) + 4:.1f}" text-anchor="end">2^{e}</text>')
        for s in sizes:
            out.append(f'<text x="{x[s]:.1f}" y="{height - 22}" text-anchor="middle">2^{s} m</text>')
        lines = {}
        for r in field.of("ladder", regime=what):
            if r["value"] != "" and field.group[r["subject"]] != "rounded":
                lines.setdefault(r["subject"], {}).setdefault(int(r["size"]), []).append(int(r["value"]))
        for subject in sorted(lines):
            colour.setdefault(subject, colours[len(colour) % len(colours)])
            dash = "" if list(colour).index(subject) < len(colours) else ' stroke-dasharray="4 3"'
            points = [(x[s], y(max(v))) for s, v in sorted(lines[subject].items())]
            path = " ".join(f"{a:.1f},{b:.1f}" for a, b in points)
            out.append(f'<polyline points="{path}" fill="none" stroke="{colour[subject]}" stroke-width="1.6"{dash}><title>{html.escape(subject)}</title></polyline>')
            out += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3" fill="{colour[subject]}"><title>{html.escape(subject)}</title></circle>' for a, b in points]
        parts.append("".join(out) + "</g>")
    keys = "".join(f'<g transform="translate({60 + 200 * (k % 5)} {height + 16 * (k // 5)})"><rect width="12" height="4" y="-4" fill="{c}"/>'
                   f'<text x="17">{html.escape(s)}</text></g>' for k, (s, c) in enumerate(colour.items()))
    total = height + 16 * (len(colour) // 5 + 1)
    right = [s for s in sorted({r["subject"] for r in field.of("ladder")}) if s not in colour and field.group[s] != "rounded"]
    return (f'<figure><svg viewBox="0 0 {2 * width} {total}" font-size="11" width="100%">{"".join(parts)}{keys}</svg></figure>'
            f'<p class="note">Never wrong on the ladder at any gap or overlap, down to 2^-48 of the size: {html.escape(", ".join(right)) or "none"}.</p>')


def rounding(field):
    """Wrong answers of those that round and then decide exactly, by the gap or overlap in steps of the grid."""
    steps = sorted({int(r["size"]) for r in field.of("grid")})
    kinds = [(s, w) for s in ("placed", "vertices") for w in ("gap", "overlap") if field.of("grid", subject=s, regime=w)]
    if not kinds:
        return ""
    body = ""
    for low, high in ((-40, -9), (-8, -5), (-4, -3), (-2, -2), (-1, -1), (0, 0), (1, 1), (2, 2), (3, 4), (5, 8), (9, 40)):
        if not any(low <= s <= high for s in steps):
            continue
        body += f"<tr><td>2^{low}" + (f" .. 2^{high}" if low != high else "") + "</td>"
        for subject, what in kinds:
            rows = [r for r in field.of("grid", subject=subject, regime=what) if low <= int(r["size"]) <= high]
            n, bad = sum(number(r, "n") for r in rows), sum(number(r, "invented", "missed") for r in rows)
            colour = shade(bad / n if n else 0, "invented" if what == "gap" else "missed")
            body += f'<td style="background: {colour}" title="{percent(bad, n)}">{bad}<small> /{n}</small></td>' if n else '<td class="none">.</td>'
        body += "</tr>"
    head = "".join(f"<th>{s} rounded:<br>{'gap called contact' if w == 'gap' else 'overlap missed'}</th>" for s, w in kinds)
    return f"<table><tr><th>gap or overlap<br>in steps of the grid</th>{head}</tr>{body}</table>"


def strip(field):
    names = list(dict.fromkeys(r["regime"] for r in field.of("case", subject="truth")))
    said = {(r["subject"], r["regime"], r["question"]): r["value"] for r in field.of("case")}
    what = {r["regime"]: r["text"] for r in field.of("case", subject="truth")}
    subjects = [s for _, members in field.engines() for s in members if any(k[0] == s for k in said)]
    head = "".join(f"<th>{name_of(field, s)}</th>" for s in subjects)
    body = ""
    for name in names:
        for question in ("surface", "solid"):
            if all((s, name, question) not in said for s in subjects):
                continue
            truth = said["truth", name, question]
            body += f'<tr><td class="text">{html.escape(what[name])} <small><code>field/{name}.case.json</code></small></td><td>{question}</td><td><b>{truth}</b></td>'
            for s in subjects:
                value = said.get((s, name, question))
                body += '<td class="none">.</td>' if value is None else f'<td class="{"bad" if value != truth else ""}">{value}</td>'
            body += "</tr>\n"
    return f"<table class='strip'><tr><th>case</th><th>question</th><th>truth</th>{head}</tr>\n{body}</table>"


def scatter(field, kind):
    """Time against wrong answers, of engines that tell a time. The best of each group is labelled, the rest is grey. An engine that declines more than half is hollow."""
    points = []
    for r in field.of("speed", regime=kind):
        rows = field.of("regime", subject=r["subject"], question=r["question"])
        n, wrong, declined = (sum(number(x, *keys) for x in rows) for keys in (("n",), ("missed", "invented"), ("declined",)))
        if n:
            points.append((float(r["value"]) / 1000, max(wrong / n, 1e-4), wrong, n, declined > n, r["subject"]))
    if not points:
        return ""
    width, height = 640, 250
    low, high = math.floor(min(math.log10(p[0]) for p in points)), math.ceil(max(math.log10(p[0]) for p in points) + 1e-9)

    def x(us):
        return 60 + (math.log10(us) - low) / (high - low) * (width - 200)

    def y(share):
        return height - 40 + (math.log10(share) + 4) / 4 * (60 - height)
    out = [f'<text x="60" y="12">{kind}</text><text x="60" y="{height - 4}">microseconds a pose, by its own clock</text>']
    for e in range(low, high + 1):
        out.append(f'<line x1="{x(10 ** e):.0f}" x2="{x(10 ** e):.0f}" y1="20" y2="{height - 40}" stroke="var(--line)"/>'
                   f'<text x="{x(10 ** e):.0f}" y="{height - 24}" text-anchor="middle">10^{e}</text>')
    for share, text in ((1, "100 %"), (0.1, "10 %"), (0.01, "1 %"), (1e-3, "0.1 %"), (1e-4, "none")):
        out.append(f'<line x1="60" x2="{width - 140}" y1="{y(share):.0f}" y2="{y(share):.0f}" stroke="var(--line)"/>'
                   f'<text x="54" y="{y(share) + 4:.0f}" text-anchor="end">{text}</text>')
    best = {}
    for p in points:
        group = field.group[p[5]]
        best[group] = min(best.get(group, p), p, key=lambda q: (q[2] / q[3], q[0]))
    for p in points:
        us, share, wrong, n, declines, subject = p
        group = field.group[subject]
        colour = "var(--best)" if best[group] is p else "var(--other)"
        out.append(f'<circle cx="{x(us):.1f}" cy="{y(share):.1f}" r="4" fill="{"var(--paper)" if declines else colour}" stroke="{colour}" stroke-width="1.5">'
                   f'<title>{html.escape(subject)}: {us:,.1f} microseconds, {wrong} wrong of {n}</title></circle>')
        if best[group] is p:
            out.append(f'<text x="{x(us) + 8:.1f}" y="{y(share) - 5:.1f}" fill="{colour}">{html.escape(subject)} ({group})</text>')
    return f'<figure><svg viewBox="0 0 {width} {height}" font-size="11" width="{width}">{"".join(out)}</svg></figure>'


def speeds(field):
    out = ""
    for kind in dict.fromkeys(r["regime"] for r in field.of("speed")):
        rows = sorted(field.of("speed", regime=kind), key=lambda r: float(r["value"]))
        body = "".join(f'<tr><td>{name_of(field, r["subject"])}</td><td>{float(r["value"]) / 1000:,.1f}</td><td>{r["n"]}</td><td>{r["text"]}</td></tr>' for r in rows)
        out += scatter(field, kind)
        out += f"<table><tr><th>{kind}, near contact</th><th>microseconds a pose, by its own clock</th><th>poses</th><th>answers</th></tr>{body}</table>"
    return out


def kinds(field):
    """Answers to the other kinds of question, of the engines that take them: a row an engine, a column a question."""
    rows = field.of("kind")
    if not rows:
        return ""
    columns = list(dict.fromkeys((r["regime"], r["question"]) for r in rows))
    body = ""
    for subject in dict.fromkeys(r["subject"] for r in rows):
        mine = {(r["regime"], r["question"]): r for r in rows if r["subject"] == subject}
        body += f"<tr><td>{name_of(field, subject)}</td>"
        for column in columns:
            r = mine.get(column)
            body += cell(number(r, "missed"), number(r, "invented"), number(r, "failed"), number(r, "n")) if r else cell(0, 0, 0, 0)
        body += "</tr>\n"
    head = "".join(f"<th>{level}:<br>{question}</th>" for level, question in columns)
    return f"<table><tr><th>engine</th>{head}</tr>\n{body}</table>"


def engines(field):
    body = ""
    for group, subjects in field.engines():
        for s in subjects:
            h = field.hello[s]
            why = ", ".join(f'{r["regime"]} {r["n"]}' for r in field.of("declined", subject=s))
            failures = ", ".join(f'{r["regime"]} {r["n"]}' + (f' <small>{html.escape(r["text"])}</small>' if r["text"] else "") for r in field.of("failure", subject=s))
            sizes = h.get("sizes")
            body += (f'<tr><td>{name_of(field, s)}</td><td class="text">{html.escape(h.get("library") or h.get("version", "built in"))}</td><td>{h.get("precision", "")}</td><td class="text">{", ".join(h.get("questions", []))}</td>'
                     f'<td>{h.get("bodies", "")}</td><td>{h.get("poses", "")}</td><td>{h.get("touching", "")}</td>'
                     f'<td>{f"{sizes[0]} .. {sizes[1]} m" if sizes else ""}</td><td class="text">{why}</td><td class="text long">{failures}</td></tr>\n')
    return ("<table><tr><th>engine</th><th>version</th><th>numbers</th><th>takes</th><th>bodies</th><th>poses</th><th>sets</th><th>sizes advised</th>"
            f"<th>not asked, of the first cases</th><th>failures, and last words</th></tr>\n{body}</table>")


def write(table, page):
    field = Field(table)
    made = field.rows[0]
    engines_asked = sum(group != "rounded" for group in field.group.values())
    asked, most = sum(number(r, "n") for r in field.of("regime")), {}
    for r in field.of("regime"):
        most[r["regime"]] = max(most.get(r["regime"], 0), number(r, "n", "declined"))
    size = (f'{made["cases"]} cases a family (200 of ladder, lego and metres), {made["frames"]} frames a sequence' if made["compiler"] else
            "the field's own cases, " + ", ".join(f"{n} of {name}" for name, n in most.items()) + ", judged in integers by Python")
    text = f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>The field on trial</title><style>{STYLE}</style></head><body>
<h1>The field on trial</h1>
<p class="note">{engines_asked} engines and kernels, and {len(field.group) - engines_asked} roundings, gave {asked:,} answers to questions whose exact answer is known. Each engine runs with its
defaults, and is asked only what it takes. Every number is from <code>field.csv</code>: {html.escape(", ".join(made[k] for k in ("version", "compiler", "processor") if made[k]))}, seed {made["seed"]}, {size}, node
{html.escape(made["node"])}. <code>./reproduce field</code> makes it again.</p>
<h2>Wrong answers: surfaces</h2>
<p class="note">A cell reads <b>missed+invented /asked</b>: a contact that is not seen, and one that is not there; red on the left is the share missed, blue on the right the share
invented; f counts failures. Rows have different n where engines decline, and are no ranking; the columns <i>asked of all</i> compare like with like. <i>metres</i>: bodies of 0.1 to 10 m,
rigid poses within 100 m. <i>ladder</i>: two cubes of 1 mm to 8 km, a gap or overlap of 2^-1 to 2^-48 of the size. <i>lego</i>: aligned cells. <i>clear</i> is more than 2^40 ulps from
degenerate, <i>near for float</i> 2^20 to 2^40, <i>near</i> less, <i>degenerate</i> exactly so. <i>Touching apart</i>: frames of exact contact called apart, which engines of open sets
do by design; <i>flush apart</i>: likewise flush cubes.</p>
{heat_map(field, "surface")}
<h2>Wrong answers: solids</h2>
{heat_map(field, "solid")}
<h2>What floats cost, and what the engine does</h2>
<p class="note">{"" if field.of("rounded") else "Not asked. "}An engine of floats never sees the bodies that it is given. Here its answers are judged twice: by the truth of the input, and
by the truth of the input with each number rounded to the nearest float, vertices and poses, or vertices alone where its poses are of double. <i>Explained by the rounding</i>: wrong of the
input and right of the rounded one. The cells are wrong answers to the rounded input: what the engine does.</p>
{floats(field, "surface")}
{floats(field, "solid")}
<h2>The ladder</h2>
<p class="note">How near may two equal cubes be before an engine errs? The grey band is half an ulp of float at the size, which a float engine cannot avoid. Engines for games have
absolute tolerances for bodies of about a metre: read the middle of the figure for those. The cubes of a rung are aligned, shifted sideways or turned.</p>
{ladder(field)}
<h2>What rounding costs</h2>
<p class="note">Many libraries round to a grid first, and are exact from there on. These subjects round the placed vertices, or those of the bodies, to 2^-10 .. 2^-40 of the size on the
ladder, and then decide without error: what is wrong is the rounding's.</p>
{rounding(field)}
<h2>Other kinds of question</h2>
<p class="note">{"" if field.of("kind") else "Not asked. "}Some engines can be asked more than whether bodies collide. <i>meets</i>, <i>surface</i> and <i>solid</i> count like the cells above. A
number is wrong where it is not the double nearest to the exact one: <i>first t</i>, <i>time</i> and a distance count as missed where they are too small, as invented where they are too large. A float
engine's numbers are therefore nearly all wrong, by some of its ulps.</p>
{kinds(field)}
<h2>What your engine says</h2>
<p class="note">Each case is a file that <code>tetracone collide FILE</code> replays, and that <code>experiments/subjects/</code> can be asked. Red is wrong; a dot was not asked.
Calling a flush or single-corner contact apart is right for an engine of open sets.</p>
{strip(field)}
<h2>Time</h2>
<p class="note">{"" if field.of("speed") else "Not measured: the machine was busy. "}Self-reported: an engine's own clock around its own query, without the pipe and without making its bodies, unless it makes them at each query (Rapier's shapes, GTS,
SFCGAL). The builds of npm are WebAssembly, not the native ones. The machine was not idle: read orders of magnitude. The number that collide is the answers' verdict. In the figures a
group's best is labelled, by wrong answers and then by time; hollow ones decline more than half of the questions; <i>none</i> is none wrong of what was asked.</p>
{speeds(field)}
<h2>Engines</h2>
{engines(field)}
</body></html>
"""
    with open(page, "w") as file:
        file.write(text)
