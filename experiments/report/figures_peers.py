"""Figure 7, peers, scaling and ablation: what the performance experiments drew, where they were run, and peers' times beside their
wrong answers."""

import html
import os

from race_data import OURS, fitness, is_near, ratio
from report_data import by, distinct, geometric_mean, interval, read, rounded, share, times
from report_page import Source, again, of_its_own

EXPERIMENTS = (("peers", "Peers", "How does each library compare, in time and in wrong answers?"),
               ("scaling", "Scaling", "How do time, preparation and memory grow with the number of triangles?"),
               ("ablation", "Ablation", "What does each choice of the method cost, or bring?"),
               ("paper", "The rest of the paper's study", "What do adjusted tetrahedra, depth, relative size and a turning body cost and bring?"))
MADE_BY = ("seed", "version", "compiler", "flags", "processor", "again", "fcl")
WORKLOAD = ("scenario", "object", "triangles", "ratio", "question")


def source_of(name, asked, rows):
    """From the columns that the experiment wrote; what it did not is said to be missing."""
    def all_of(key):
        return "; ".join(distinct(r[key] for r in rows if r.get(key))) or f"not recorded in {name}.csv"
    compiler = all_of("compiler") + (f", flags {all_of('flags')}" if rows[0].get("flags") else "")
    asked_of = f"{sum(int(r['poses']) for r in rows):,} answers, {len(rows):,} rows" if rows[0].get("poses") else f"{len(rows):,} rows"
    return Source(asked, asked_of, all_of("seed"), again(rows), all_of("version"), compiler, all_of("processor"))


def drawing(page, name, source):
    """The experiment's own figure, as it stands in OUT or OUT/figures."""
    base = next((b for b in (f"figures/{name}", name) if os.path.exists(os.path.join(page.out, b + ".svg"))), None)
    if base is None:
        return ""
    with open(os.path.join(page.out, base + ".svg"), encoding="utf-8") as file:
        svg = file.read()
    links = [f for f in (base + ".pdf",) if os.path.exists(os.path.join(page.out, f))]
    drawn = of_its_own(svg[svg.index("<svg"):], name)
    return (f'<figure id="figure-{name}"><div class="drawing on-white">{drawn}</div><figcaption '
            f'class=source>{page.made(source, name + ".csv")}'
            + "".join(f' <a href="{f}">PDF</a>.' for f in links) + "</figcaption></figure>")


def groups_of(rows):
    """The rows in motion, and those of each scenario of near contact, of either question, with the group's name; groups without rows are left out."""
    groups = []
    for scenario in [None, *distinct(r["scenario"] for r in rows if is_near(r))]:
        for question in ("surface", "solid"):
            mine = [r for r in rows if r["question"] == question and (r["scenario"] == scenario if scenario else not is_near(r))]
            if mine:
                groups.append((f"near contact, {scenario}, {question}" if scenario else f"in motion, {question}", mine))
    return groups


def over_the_first(row, first):
    """The ratio of mean times, on the poses that both were asked."""
    times_of = ("mean_ns", "same_poses_ns", "tetracone_same_poses_ns")
    return ratio(*({**r, **{key: float(r[key]) for key in times_of if r.get(key)}, "subject": OURS} for r in (row, first)), "mean_ns")


def against_the_first(page, rows, source):
    """Time as a multiple of the first subject's on the same workload, with the wrong answers beside it, in motion and near contact."""
    key = lambda r: tuple(r[k] for k in WORKLOAD)
    first = rows[0]["subject"]
    reference = {key(r): r for r in rows if r["subject"] == first}
    groups = groups_of(rows)
    body, lines = [], []
    for (subject,), mine in by(rows, "subject").items():
        cells = [html.escape(subject)]
        for name, group in groups:
            own = [r for r in group if r["subject"] == subject]
            if not own:
                cells.append("–")
                continue
            wrong = sum(int(r["false_positives"]) + int(r["false_negatives"]) for r in own)
            asked = sum(int(r["poses"]) for r in own)
            ratios = [over_the_first(r, reference[key(r)]) for r in own if key(r) in reference and r["mean_ns"]]  # a program may tell no time
            mean, (low, high) = geometric_mean(ratios), interval(ratios)
            time = (f"{times(mean)} ×" + (f" ({times(low)} .. {times(high)})" if low else "") + "; ") if ratios else ""
            cells.append(f"{time}{share(wrong, asked)} wrong")
            lines.append([subject, name, len(ratios), *(f"{x:.4g}" if ratios and x else "" for x in (mean, low, high)), wrong, asked])
        body.append((mine[0].get("exact") == "1", cells))
    data = page.table("peers_ratios", ["subject", "workloads", "courses", f"time_per_{first}".replace(" ", "_"), "low_95", "high_95", "wrong", "asked"], lines, source)
    table = page.html_table(["subject"] + [name for name, _ in groups], body, source, data)
    return (f"<p>Times are multiples of those of <i>{html.escape(first)}</i> on the same poses: geometric means over courses, in parentheses their 95 % interval "
            "by resampling the courses. Only what is in motion is a mean over courses; each scenario of near contact is one.</p>") + table


def number(text):
    try:
        value = float(text)
    except (TypeError, ValueError):
        return html.escape(text or "")
    return text if value == int(value) and len(text) < 9 else rounded(value, 4)


def sections(page, study, campaign):
    for name, title, asked in EXPERIMENTS:
        rows = read(os.path.join(page.out, name + ".csv"))
        if not rows:
            continue
        source = source_of(name, asked, rows)
        source.check()
        columns = [c for c in rows[0] if c not in MADE_BY]
        parts = [drawing(page, name, source)]
        if all(k in rows[0] for k in (*WORKLOAD, "degenerate", "collisions")):
            parts.insert(0, f"<p>{html.escape(fitness(rows))}.</p>".replace("<p>c", "<p>C"))
        if name == "peers" and all(k in rows[0] for k in (*WORKLOAD, "subject", "degenerate", "mean_ns", "poses", "false_positives",
                                                          "false_negatives")):
            parts.append(against_the_first(page, rows, source))
        if len(rows) <= 100 or len(parts) == 1:
            table = page.html_table([html.escape(c.replace("_", " ")) for c in columns],
                                    [(False, [number(r[c]) for c in columns]) for r in rows], source, name + ".csv")
            parts.append(f"<details><summary>{len(rows):,} rows</summary>{table}</details>")
        yield page.section(f"experiment-{name}", title, *parts)
