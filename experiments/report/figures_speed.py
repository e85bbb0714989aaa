"""Figure 1, speed against accuracy, and what the page opens with: the claim, the chart, a sentence a method."""

import html

import matplotlib.pyplot as plt

from campaign_data import DOUBLES, FRACTIONS, PANEL, REGIME, is_exact
from report_data import by, distinct, duration, geometric_mean, kernel_of, method_of, percent, share, short, times, wilson, wrong_in
from report_style import GREEN, GREY, WIDTH, colour_of, key_of_marks, label_points, mark
from study_data import QUESTION, REGIMES, workload

BAND = (2e-5, 3e-4)  # where "none wrong" stands on a log axis


def front(points):
    """The points (time, rate, ...) that no other beats in one and equals or beats in the other, fastest first; of equal points, one."""
    best, kept = None, []
    for point in sorted(points, key=lambda p: (p[0], p[1])):
        if best is None or point[1] < best:
            kept.append(point)
            best = point[1]
    return kept


def panel(axis, title, points):
    """points: (subject, kernel, method, exact, nanoseconds, wrong, asked). Gives what is to be named when the layout is final."""
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_ylim(BAND[0] / 1.3, 1.9)
    axis.axhspan(*BAND, color=GREEN, alpha=0.14, lw=0)
    rows = 5  # in the band, neighbours stand at different heights
    places, seats = [], 0
    for subject, kernel, method, exact, ns, wrong, n in sorted(points, key=lambda p: p[4]):
        low, high = wilson(wrong, n)
        if wrong == 0:
            y = BAND[0] * (BAND[1] / BAND[0]) ** ((seats % rows + 0.7) / (rows + 0.4))
            seats += 1
            axis.plot([ns, ns], [y, high], color=colour_of(kernel), lw=0.6, ls=":", alpha=0.7, zorder=2)
            axis.plot(ns, high, "_", color=colour_of(kernel), ms=4, mew=0.8, zorder=2)
        else:
            y = wrong / n
            axis.plot([ns, ns], [max(low, BAND[1] * 1.05), high], color=colour_of(kernel), lw=0.9, alpha=0.7, zorder=2)
        axis.plot(ns, y, zorder=3, **mark(kernel, method, exact))
        places.append((ns, wrong / n, y, subject, kernel))
    pareto = front(places)
    if pareto:
        xs, ys = [], []
        for k, (ns, _, y, *_) in enumerate(pareto):
            if k:
                xs.append(ns)
                ys.append(ys[-1])
            xs.append(ns)
            ys.append(y)
        axis.plot(xs, ys, color=GREY, lw=0.9, ls="--", zorder=1)
    axis.set_title(title)
    axis.set_xlabel("time per query, ns")
    axis.grid(True, which="major")
    axis.margins(x=0.2)
    # Both ends of the front; and peers, which the key cannot tell apart.
    peers = {subject for *_, subject, _ in places if method_of(subject) == "peer"}
    named = {subject for *_, subject, _ in pareto[:1] + pareto[-1:]} | {"adaptive tree"} | peers
    return ([(ns, y, short(subject), colour_of(kernel)) for ns, _, y, subject, kernel in places if subject in named],
            [(ns, y) for ns, _, y, *_ in places])


def chart(panels, rows=1):
    """panels: (title, points)."""
    fig, axes = plt.subplots(rows, -(-len(panels) // rows), figsize=(WIDTH, 0.55 + 2.35 * rows), sharey=True, squeeze=False)
    labels = [panel(axis, title, points) for axis, (title, points) in zip(axes.flat, panels)]
    for axis in axes.flat[len(panels):]:
        axis.set_visible(False)
    axes[0][0].set_yticks([(BAND[0] * BAND[1]) ** 0.5, 1e-3, 1e-2, 1e-1, 1], ["none\nwrong", "0.1 %", "1 %", "10 %", "100 %"])
    axes[0][0].minorticks_off()
    for axis in axes[:, 0]:
        axis.set_ylabel("wrong answers")
    every = [p for _, points in panels for p in points]
    key_of_marks(fig, distinct((p[1], p[3]) for p in every if p[2] not in ("peer", "program")), distinct(p[2] for p in every))
    fig.tight_layout(rect=(0, 0.3 / fig.get_figheight(), 1, 1), w_pad=0.6)
    for axis, (names, obstacles) in zip(axes.flat, labels):
        label_points(axis, names, obstacles)
    return fig


HEADER = ["panel", "question", "subject", "kernel", "method", "exact", "time_ns", "wrong", "asked", "low_95", "high_95"]


def lines_of(panels, question):
    return [[title, question(title), s, k, m, int(e), round(ns), int(w), int(n), *(f"{x:.6g}" for x in wilson(w, n))]
            for title, points in panels for s, k, m, e, ns, w, n in points]


def study_chart(page, study):
    panels = [(regime, [(r["subject"], r["kernel"], r["method"], r["exact"], ns, wrong, n) for r, ns, wrong, n in study.points(regime)])
              for regime in REGIMES]
    panels = [p for p in panels if p[1]]
    source = study.source("How much time does a query take, and how often is the answer wrong?",
                          [r for regime in REGIMES for r in study.asked_in(regime)])
    data = page.table("speed_against_accuracy", HEADER, lines_of(panels, QUESTION.get), source)
    return page.figure("speed_against_accuracy", chart(panels), source, data)


def campaign_chart(page, campaign):
    """The chart of everything that the campaign asks, on its families; a query here includes making the bodies ready. Poses are of doubles,
    which everyone is asked; a library is in the panels of the question that it knows."""
    spent = {}
    for r in campaign.tables["times"]:
        if r["level"] == "object" and r["family"] in REGIME:
            spent[r["family"], r["subject"], r["question"]] = float(r["make_ns"] or 0) + float(r["ask_ns"])
    errors = [r for r in campaign.rows("object", DOUBLES) if r["family"] in REGIME and int(r["n"]) and campaign.is_known(r)]
    panels = []
    for regime in REGIMES:
        rows = [r for r in errors if REGIME[r["family"]] == regime and r["question"] == QUESTION[regime]]
        wrong, points = campaign.wrong_by(rows, "subject"), []
        for (subject,), mine in by(rows, "subject").items():
            ns = [spent[key] for r in mine if (key := (r["family"], subject, r["question"])) in spent]
            if ns:
                points.append((subject, kernel_of(subject), method_of(subject), is_exact(subject), geometric_mean(ns), *wrong[subject,]))
        panels.append((regime, points))
    panels = [(PANEL.get(regime, regime), points) for regime, points in panels if points]
    if not panels:
        return ""
    question = {PANEL.get(regime, regime): asked for regime, asked in QUESTION.items()}
    source = campaign.source("And with everything that the campaign asks, every method and every peer, the bodies made ready for the one "
                             "query?", campaign.answers(errors))
    data = page.table("speed_against_accuracy_cold", HEADER, lines_of(panels, question.get), source)
    return page.figure("speed_against_accuracy_cold", chart(panels, 2), source, data)


def claim(study, campaign):
    """How often exact subjects were wrong, over all that was asked; and the others in exact contact."""
    wrong = asked = 0
    for r in study.rows:
        if r["exact"]:
            wrong, asked = wrong + r["wrong"], asked + r["poses"]
    if campaign:
        for (subject,), (w, n) in campaign.wrong_by(campaign.tables["subjects"], "subject").items():
            if is_exact(subject):
                wrong, asked = wrong + w, asked + n
    if asked == 0:
        return "No exact method was asked."
    low, high = wilson(wrong, asked)
    interval = f"{'below' if wrong == 0 else percent(low) + ' to'} {percent(high)}"
    text = f"Our exact methods: <b>{wrong:,.0f} wrong of {asked:,.0f} answers</b> (95 %: {interval})."
    if study:
        points = {r["subject"]: (w, n) for r, _, w, n in study.points("exactly degenerate")}
    else:
        rows = [r for r in campaign.rows("object", DOUBLES) if (REGIME.get(r["family"]), r["question"]) == ("exactly degenerate", "surface")]
        points = {subject: count for (subject,), count in campaign.wrong_by(rows, "subject").items()}
    parts = [f"{name} {percent(points[subject][0] / points[subject][1])}" for subject, name in OTHERS
             if subject in points and points[subject][0]]
    return text + (f" In exactly degenerate contact others are wrong: {', '.join(parts)}." if parts else "")


OTHERS = (("float tree", "our tree in float"), ("double tree", "our tree in double"), ("epick tree", "our tree over CGAL's EPICK"),
          ("FCL OBBRSS", "FCL"))


def of_campaign(subject, campaign):
    """What the campaign says of a subject: by the question that it knows, poses of doubles and families first, the rest apart."""
    def counted(rows):
        return sum(map(wrong_in, rows)), sum(int(r["n"]) for r in rows)

    def mine(poses, of_sequences, is_known=True):
        return [r for r in campaign.rows("object", poses, of_sequences) if r["subject"] == subject and campaign.is_known(r) == is_known]

    families = mine(DOUBLES, False)
    wrong, n = counted(families)
    if n == 0:
        return ""
    known = campaign.knows(subject)
    text = f"campaign{f', {known} question' if known else ''}: {share(wrong, n)} wrong"
    worst = sorted(((w / k, f) for (f,), (w, k) in campaign.wrong_by(families, "family").items() if w), reverse=True)
    if worst:
        text += ", breaks most on " + " and ".join(f"<i>{html.escape(f)}</i> ({percent(x)})" for x, f in worst[:2])
    apart = [(name, *counted(rows)) for name, rows in (("frames of motions in exact contact", mine(DOUBLES, True)),
                                                       ("poses with fractions", mine(FRACTIONS, False) + mine(FRACTIONS, True)),
                                                       ("the other question, which it does not know",
                                                        mine(None, False, False) + mine(None, True, False)))]
    if wrong == 0 and not any(w for _, w, _ in apart[:2]):
        text += ", nothing breaks it"
    return text + "".join(f"; {name}: {share(w, k)}" for name, w, k in apart if k)


def verdict(subject, study, campaign):
    """What a subject's numbers say, in a sentence: how fast, how right, and where it breaks."""
    mine = [r for r in study.rows if r["subject"] == subject]
    parts = []
    if mine:
        random = [r for r in study.asked_in("random") if r["subject"] == subject]
        if random:
            fast = f"{duration(geometric_mean(r['mean_ns'] for r in random))} a query in random motion"
            peer = {workload(r): r["mean_ns"] for r in study.rows if r["method"] == "peer"}
            pairs = [r["mean_ns"] / peer[workload(r)] for r in random if workload(r) in peer and r["method"] != "peer"]
            if pairs:
                fast += f", {times(geometric_mean(pairs))} times FCL's"
            parts.append(fast)
        counts = [(regime, sum(r["wrong"] for r in rows), sum(r["poses"] for r in rows)) for regime in REGIMES
                  if (rows := [r for r in study.asked_in(regime) if r["subject"] == subject and campaign.is_known(r)])]
        bad = [f"{share(w, n)} {regime}" for regime, w, n in counts if w]
        parts.append("wrong in " + ", ".join(bad) if bad else f"right in all {sum(n for _, _, n in counts):,.0f} of the study")
    if campaign and (text := of_campaign(subject, campaign)):
        parts.append(text)
    note = campaign.notes("object").get(subject, "")
    return "; ".join(parts) + (f" <i>({html.escape(note.split(': ', 1)[-1])})</i>" if note and parts else "")


def verdicts(study, campaign):
    subjects = study.subjects or distinct(r["subject"] for r in campaign.tables["subjects"] if r["level"] == "object")
    if study and campaign:
        subjects = subjects + [s for s in distinct(r["subject"] for r in campaign.tables["subjects"] if r["level"] == "object")
                               if method_of(s) == "peer" and s not in subjects]
    first = sorted((s for s in subjects if is_exact(s)), key=lambda s: not s.startswith("adaptive"))
    lines = [(s, verdict(s, study, campaign)) for s in first + [s for s in subjects if s not in first]]
    items = "".join(f'<li{" class=exact" if is_exact(s) else ""}><b>{html.escape(s)}</b>: {text}.</li>'
                    for s, text in lines if text)
    return f"<ul class=verdicts>{items}</ul>" if items else ""


def summary(page, study):
    """A line a subject: wrong answers in each regime, time, and time against FCL on the same workloads."""
    peer = {workload(r): r["mean_ns"] for r in study.rows if r["method"] == "peer"}
    lines, body = [], []
    for subject in study.subjects:
        on = {regime: [r for r in study.asked_in(regime) if r["subject"] == subject] for regime in REGIMES}
        counts = [(sum(r["wrong"] for r in rows), sum(r["poses"] for r in rows)) for rows in on.values()]
        ns = geometric_mean(r["mean_ns"] for r in on["random"])
        against = geometric_mean(r["mean_ns"] / peer[workload(r)] for r in on["random"] if workload(r) in peer)
        missed, invented = (sum(r[key] for rows in on.values() for r in rows) for key in ("false_negatives", "false_positives"))
        there = bool(on["random"])
        lines.append([subject, *(int(x) for pair in counts for x in pair), int(missed), int(invented), round(ns) if there else "",
                      f"{against:.4g}" if against == against else ""])
        body.append((is_exact(subject), [html.escape(subject), duration(ns) if there else "–",
                                         times(against) if against == against else "–",
                                         *(share(w, n) if n else "–" for w, n in counts), f"{missed:.0f}, {invented:.0f}"]))
    source = study.source("What does each subject take, and where is it wrong?")
    header = [f"{regime.replace(' ', '_')}_{what}" for regime in REGIMES for what in ("wrong", "asked")]
    data = page.table("summary", ["subject", *header, "missed", "invented", "random_ns", "against_fcl"], lines, source)
    return page.html_table(["subject", "time, random", "time / FCL", *REGIMES, "missed, invented"], body, source, data)


def degenerate(page, study):
    """Exact contacts by scenario: where each subject breaks."""
    rows = [r for r in study.rows if r["regime"] == "degenerate"]
    cell = {(r["scenario"], r["question"], r["subject"]): r for r in rows}
    subjects, body, lines = distinct(r["subject"] for r in rows), [], []
    for (scenario, question), group in by(rows, "scenario", "question").items():
        cells = [f"{html.escape(scenario)}<br><small>{question}, {max(r['poses'] for r in group):.0f} poses</small>"]
        for subject in subjects:
            r = cell.get((scenario, question, subject))
            cells.append("–" if r is None else "0" if r["wrong"] == 0
                         else f"<b>{percent(r['wrong'] / r['poses'])}</b><br><small>{r['false_negatives']:.0f}, "
                         f"{r['false_positives']:.0f}</small>")
            if r is not None:
                lines.append([scenario, question, subject, int(r["poses"]), int(r["collisions"]), int(r["false_positives"]),
                              int(r["false_negatives"])])
        body.append((False, cells))
    source = study.source("Which contacts does each subject get wrong?", rows)
    data = page.table("degenerate", ["scenario", "question", "subject", "n", "collisions", "false_positives", "false_negatives"], lines,
                      source)
    return page.html_table(["contact"] + [html.escape(s) for s in subjects], body, source, data)


def sections(page, study, campaign):
    if study:
        yield page.section("every-subject", "Every subject",
                           "<p>A zero in n is stated with the upper end of its 95 % interval (Wilson). FCL knows surfaces alone: it is not asked of "
                           "nested solids. Exact subjects are shaded.</p>",
                           summary(page, study))
        yield page.section("contacts", "Where rounding fails",
                           "<p>Bodies under random common rotations of integer quaternions, exact in rationals, unless the scenario says "
                           "that both poses were rounded to doubles first; the truth is that of the poses as given. Below a share: missed, "
                           "invented.</p>", degenerate(page, study))
    if study and campaign and (drawn := campaign_chart(page, campaign)):  # without a study the page opens with it
        yield page.section("cold", "Speed against accuracy, every method and peer",
                           "<p>On the campaign's families, poses of doubles. Bodies are small and made anew for each question, so a time is that "
                           "of making them ready and of asking once, both as the subject's own process measures them; "
                           "<code>tables/verify_times.csv</code> has the two apart. The chart above has times of a question that is asked "
                           "again. <i>random coordinates</i> is the family <i>random</i> and no motion. A library of surfaces is not in the "
                           "panel of nested solids, and a program that does not tell its own time in none.</p>", drawn)
