#!/usr/bin/python3
"""Tests of experiments/report/report.py: what the page says is what the rows say, and no figure is without what made it."""

import csv
import html
import os
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "..", "experiments", "report")
sys.path.insert(0, SOURCE)

try:
    import matplotlib  # noqa: F401
except ImportError:
    print("skipped: no matplotlib")
    sys.exit(77)
import figures_certificates  # noqa: E402
import figures_failure  # noqa: E402
import figures_motion  # noqa: E402
import figures_overlap  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import report_methods  # noqa: E402
from report_data import rounded, share, times, wilson  # noqa: E402
from report_page import Source  # noqa: E402

STUDY_COUNTS = ("mean_ns median_ns p99_ns build_ms bytes nodes pairs_visited discarded_by_hull discarded_by_sphere "
                "discarded_by_tetrahedron bounding_tests primitive_tests exact_fallbacks").split()
MADE = dict(seed="7", version="9.9.9", compiler="g++ 1", flags="-O7", processor="Abacus", again="build/tetracone experiment any --out out --seed 7")
CAMPAIGN = ("build/tetracone verify --db out/mine.db --cases 100 --seed 7 --level predicate",
            "build/tetracone verify --db out/mine.db --cases 12 --seed 7 --subject mine --subject-command 'mine=./mine --eps 1e-9'")
SUBJECTS = (("double tree", "double", "tree", 0, 4), ("adaptive tree", "adaptive", "tree", 1, 0), ("double paper", "double", "paper", 0, 3),
            ("FCL OBBRSS", "FCL", "peer", 0, 5))
SCENES = (("trajectory", "circular", "x", "x", 1, "surface"), ("trajectory", "circular", "x", "x", 2, "surface"),
          ("trajectory", "contour", "x", "x", 1, "surface"),
          ("trajectory", "contour", "x", "x", 2, "surface"), ("degenerate", "shared face", "cube", "cube", 1, "surface"),
          ("degenerate", "shared edge (rounded poses)", "cube", "cube", 1, "surface"),
          ("degenerate", "nested", "cube", "small cube", 1, "solid"))


def study():
    rows = []
    for k, scene in enumerate(SCENES):
        for s, (subject, kernel, method, exact, wrong) in enumerate(SUBJECTS):
            row = dict(zip(("regime", "scenario", "a", "b", "ratio", "question"), scene), subject=subject, kernel=kernel, method=method,
                       exact=exact, poses=50, collisions=20, faces_a=12, faces_b=20,
                       false_positives=0, false_negatives=wrong if scene[0] == "degenerate" else 0,
                       **{c: 1000 * (s + 1) + k for c in STUDY_COUNTS}, **MADE)
            rows.append(row)
    return rows


def contact_cost():
    """One question in exact contact, and one that the study has too."""
    return [dict(next(r for r in study() if (r["scenario"], r["subject"]) == ("shared face", "adaptive tree")), question=question, subject=subject, mean_ns=ns)
            for question in ("distance", "surface") for subject, ns in (("adaptive tree", 300), ("double tree", 200), ("rational tree", 6000))]


def campaign():
    """Tables by name, small but whole: every section has something to draw."""
    asked = [(level, s, q) for level, subjects, questions in (("object", ("double brute", "double tree", "adaptive tree", "FCL OBBRSS"),
                                                               ("solid", "surface")),
                                                             ("predicate", ("double", "adaptive", "float"), ("segment-triangle",)),
                                                             ("object", ("mine", "tree"), ("solid", "surface")),
                                                             ("motions", ("adaptive tree", "static 10"), ("surface", "surface time")))
             for s in subjects for q in questions]
    errors, sweeps, needs, times = [], [], [], []
    for family, parameters in (("random", (0.0,)), ("far-from-origin", (0.0, 10.0)), ("mixed-scales", (0.0, 10.0)), ("sliver", (2.0, 10.0)),
                               ("nested", (0.25,)), ("stacked", (0.0,))):
        for level, subject, question in asked:
            wrong = 0 if "adaptive" in subject else 3
            errors.append(dict(level=level, family=family, subject=subject, question=question, n=40, false_positives=1 if wrong else 0,
                               false_negatives=2 if wrong else 0, failures=0))
            sweeps += [dict(level=level, family=family, parameter=p, subject=subject, question=question, n=20, rate=wrong / 20, low=0,
                            high=1) for p in parameters]
            if subject not in ("mine", "tree"):  # programs that do not tell their time
                times.append(dict(level=level, family=family, subject=subject, question=question, n=40,
                                  make_ns="" if level == "motions" else 1000, ask_ns=4000))
        needs += [dict(level="object", family=family, question="surface", bin=b, n=10) for b in (-9999, -60, -30, 9999)]
    subjects = [dict(level=l, subject=s, question=q, n=240, false_positives=6 if "adaptive" not in s else 0,
                     false_negatives=12 if "adaptive" not in s else 0, failures=0, not_asked=0) for l, s, q in asked]
    # Half of the slivers once more under poses with fractions, of which double misses all.
    poses = [dict(r, poses="doubles", not_asked=0) for r in errors] + [
        dict(r, poses="fractions", n=0 if r["subject"] == "FCL OBBRSS" else 20, not_asked=20 if r["subject"] == "FCL OBBRSS" else 0,
             false_positives=0, false_negatives=20 if r["subject"] == "double tree" else 0, failures=0)
        for r in errors if (r["level"], r["family"]) == ("object", "sliver")] + [
        dict(level="object", family="sequence rolling", subject=s, question="surface", poses="doubles", n=16, not_asked=0, false_positives=0,
             false_negatives=2 if s == "double tree" else 0, failures=0) for s in ("double tree", "adaptive tree")]
    return dict(
        poses=poses, errors=errors, sweeps=sweeps, needs=needs, times=times, subjects=subjects,
        distance=[dict(level=l, subject=s, question=q, poses=p, axis=a, bin=b, n=60, low=0, high=1,
                       rate=0 if "adaptive" in s else 0.05 if p == "doubles" else 1)
                  for l, s, q in asked for p in ("doubles", "fractions") for a in ("rho", "ulps") for b in (-9999, -8, 0, 9999)],
        families=[dict(levels="predicate object", family=f, what=f"cases of {f}", parameter="height & width", sweep="2 10")
                  for f in ("random", "sliver", "brand-new")] +
                 [dict(levels="motions", family="motion-rolling", what="a cube", parameter="", sweep="")],
        wrong=[dict(level="object", family=f, subject="double brute", question="surface", log2_rho=rho, log2_ulps=ulps)
               for f, rho, ulps in (("stacked", -3, -1), ("sliver", -9, -4), ("extreme-exponents", -2, 9), ("sliver", -4, 30), ("sliver", -50, -1),
                                    ("sliver", "inf", "inf"), ("sliver", "-inf", "-inf"))],
        notes=[dict(level="object", subject="FCL OBBRSS", knows="surface", note="FCL: surfaces only")],
        blame=[dict(subject="double tree", family="sliver", question="solid", stage=stage, n=n)
               for stage, n in (("pose", 7), ("leaf sign", 5))],
        relations=[dict(level=l, relation=k, subject=s, tried=40, violated=0 if "adaptive" in s else 2, not_applicable=0,
                        rate=0 if "adaptive" in s else 0.05, low=0, high=1)
                   for l, s, _ in asked for k in ("R3 absorbed", "R5 swap")],
        flips=[dict(sequence=f"sequence cube {m}", subject=s, question="surface", frames=60, wrong=0 if "adaptive" in s else 9,
                    changes=t + (0 if "adaptive" in s else 6), true_changes=t)
               for m, t in (("sliding on a floor", 0), ("rolling", 0), ("down onto a face", 1)) for s in ("double tree", "adaptive tree")],
        truth=[dict(level=l, family=f, question="surface", n=40, positives=20, by_construction=5) for l in ("object", "predicate")
               for f in ("random", "sliver")],
        failures=[dict(level="object", family=f, subject="mine", question="surface", how="signal 11", n=n, said="out of <memory>")
                  for f, n in (("random", 2), ("sliver", 5))],
        runs=[dict(MADE, run=k, real_meshes=1, again=words) for k, words in enumerate(CAMPAIGN)])


def one_level(level):
    """The tables of a campaign that asked one level, of a family and a sequence, and few cases."""
    asked = [dict(level=level, subject=s, question="surface", n=n) for s, n in (("adaptive tree", 5), ("double tree", 5))]
    wrong = [dict(false_positives=0, false_negatives=k, failures=k, not_asked=0) for k in (0, 1)]
    errors = [dict(a, family="random", **w) for a, w in zip(asked, wrong)]
    return dict(
        errors=errors, poses=[dict(r, poses="doubles") for r in errors], subjects=[{**a, **w} for a, w in zip(asked, wrong)],
        distance=[dict(a, poses="doubles", axis=axis, bin=-9999, rate=w["failures"] * 2 / 5, low=0, high=1)
                  for a, w in zip(asked, wrong) for axis in ("rho", "ulps")],
        truth=[dict(level=level, family=f, question="surface", n=n, positives=1, by_construction=1)
               for f, n in (("random", 3), ("sequence rolling", 2))],
        relations=[dict(level=level, relation="R5 swap", subject=a["subject"], tried=4, violated=w["failures"], not_applicable=0,
                        rate=w["failures"] / 4, low=0, high=1) for a, w in zip(asked, wrong)],
        runs=[dict(MADE, run=0, real_meshes=1, again=CAMPAIGN[0])])


def signs():
    return [dict(map="barycentric coordinate", subject=s, row=row, answers="-0+" if s == "exact" else "-++", **MADE)
            for s in ("double", "exact") for row in range(3)]


def thresholds():
    return [dict(motion="cube at a cube", way=w, subject=s, threshold=1.5, error_doubles=e, error_ulps=e, **MADE) for w in range(3)
            for s, e in (("double tree", 12), ("adaptive tree", 0))]


def compilers():
    return [dict(compiler="g++", compiler_version="1", flags="-O0", subject="double", test=t, n=100, wrong=w, outcome="ran",
                 version="9.9.9", processor="Abacus", again=MADE["again"]) for t, w in (("random", 0), ("grid", 30))]


def motion():
    return [dict(family=f, subject=s, n=100, contacts=40, false_positives=0, false_negatives=w, us=us, **MADE)
            for f in ("published scene", "grazing") for s, w, us in (("adaptive", 0, 1.5), ("double", 7, 0.3))]


def peers():
    """Two courses in motion, one of which has no contact, and one near contact."""
    def row(scenario, name, degenerate, collisions, poses, subject, exact, wrong, ns):
        return dict(scenario=scenario, object=name, triangles=9, ratio=1, degenerate=degenerate, question="surface", subject=subject, exact=exact, poses=poses,
                    collisions=collisions, false_positives=0, false_negatives=wrong, mean_ns=ns, course_poses=poses, course_collisions=collisions, **MADE)
    return [row(*course, *subject) for *course, wrong in (("circular", "x", 0, 2, 50, 5), ("circular", "y", 0, 0, 50, 0), ("one ulp apart", "plate", 1, 0, 10, 6))
            for subject in (("tetracone", 1, 0, 1000), ("FCL", 0, wrong, 500))]


def scenes():
    """Rows of a budget and of what is asked: name and rows."""
    return (("budget", [dict(frames_asked="alone", triangles=760, budget_ns=int(1000 * x), budget_of_a_frame=x, frame_ns=900 * x, frame_of_a_frame=0.9 * x, candidates=40,
                             decided=d, undecided=40 - d, share_decided=d / 40, wrong=0, farther_than_said=0, mean_farthest_in_sizes=1.5, **MADE)
                        for x, d in ((0.25, 0), (0.5, 20), (1, 35), (2, 40))]),
            ("demand", [dict(frame=k, bodies=9, triangles=7000, pairs=k, differ=0, trees=k, nodes=10 * k, nodes_of_whole_trees=900, bytes_of_trees=k,
                             bytes_of_whole_trees=99, bytes=50 + k, bytes_made_first=150, signs=1000 * k, signs_beyond_doubles=k // 2, ns=100 * k,
                             ns_made_first=900 + 90 * k, **MADE) for k in range(4)]))


def queries():
    """Rows of contacts, distances, moving bodies, points: name and rows."""
    return (("moving_bodies", [dict(course="plate", triangles=9, subject=s, motions=40, contacts=30, missed=m, invented=0, latest=late, static_ns=100, apart_in_statics=2,
                                    contact_in_statics=x, **MADE) for s, m, late, x in (("tetracone", 0, 0, 50), ("static 10", 30, 0, 5), ("static 100", 3, 0.01, 20),
                                                                                       ("fcl steps", 6, 0.1, 8))]),
            ("certificates", [dict(kind=kind, asked=50, proved=proved, without_proof=50 - proved, refused=0, bytes_mean=size, bytes_most=2 * size, made_ns=1e6, checked_ns=2e6, **MADE)
                              for kind, proved, size in (("collide apart", 50, 3000), ("relation meet", 40, 5000), ("motion rigid", 0, 0))]),
            ("contacts", [dict(scenario="circular", object="x", triangles=9, method=m, poses=4, pairs=10, ns=ns, ratio=ns / 2000, lost=lost,
                               invented=0, **MADE) for m, ns, lost in (("tetracone", 2000, 0), ("FCL", 9000, 3))]),
            ("distance", [dict(trajectory="gaps", triangles=12, subject="FCL RSS", question="distance", poses=5, mean_ns=1234567, mean_ulps=2.5,
                               most_ulps=7, apart=4, zero_apart=1, touching=1, positive_touching=0, **MADE)]),
            ("points", [dict(body="x", triangles=9, asked="near", contestant="cones", ns=70, signs=0.25, setup_ms=8, bytes_per_triangle=45.5,
                             judged=50, wrong=0, **MADE)]))


def overlaps():
    """Rows of boxes that touch, of depths by other libraries and of brackets: name and rows."""
    return (("touching", [dict(kind=kind, relation=relation, frame="axes", wrong_relations=0, peer=peer, asked=20, collide=collide, **MADE)
                          for kind, relation, counts in (("faces touch", "meet", (20, 0)), ("half overlap", "overlap", (20, 20)), ("inside", "contains", (0, 20)))
                          for peer, collide in zip(("FCL OBBRSS", "open"), counts)]),
            ("penetration_peers", [dict(shape="round", peer="Bullet", pairs=10, apart=1, failed=0, infinite=0, negative=2, off_millionth=4, off_hundredth=3, mean_off=0.25,
                                        most_off=0.5, ns=1000, exact_ns=2000, **MADE),
                                   dict(shape="boxes", peer="libccd EPA", pairs=10, apart=10, failed=0, infinite=0, negative=0, off_millionth=0, off_hundredth=0, mean_off="",
                                        most_off=0, ns=1000, exact_ns=2000, **MADE)]),
            ("penetration_widths", [dict(triangles=200, place=place, budget=budget, poses=1, mean_ns=ns, exact=0, mean_width=width, **MADE)
                                    for place, budget, ns, width in (("deep", 0, 1e6, 0.5), ("deep", 100, 4e6, 0.1), ("shallow", 0, 2e6, 1e-16), ("shallow", 100, 3e6, 0))]))


def write(path, rows):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def files_of(folder):
    found = {}
    for root, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(root, name), "rb") as file:
                found[os.path.relpath(os.path.join(root, name), folder)] = file.read()
    return found


def words_of(name):
    """The words by which the rows of NAME.csv say that they were made: other sizes for each."""
    return f"build/tetracone experiment {name} --out out --sizes {len(name)} --seed 7"


def draw(out, with_study=None, with_campaign=None, everything=True):
    if with_study is not None:
        write(f"{out}/study.csv", with_study)
    for name, rows in (with_campaign or {}).items():
        write(f"{out}/tables/verify_{name}.csv", rows)
    if everything:
        for name, rows in (("sign_maps", signs()), ("stability", thresholds()), ("compilers", compilers()), ("peers", peers()),
                           ("contact_cost", contact_cost()), *queries(), *scenes(), *overlaps(), ("motion", motion())):
            write(f"{out}/{name}.csv", [dict(row, again=words_of(name)) for row in rows])
    done = subprocess.run([sys.executable, "-B", os.path.join(SOURCE, "report.py"), out], capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(done.stderr)
    with open(f"{out}/report.html", encoding="utf-8") as file:
        return file.read().replace("\N{NO-BREAK SPACE}", " ")


def claim_of(page):
    return re.sub("<[^>]*>", "", re.search(r'<p class="claim">(.*?)</p>', page, re.DOTALL).group(1))


def verdict_of(page, subject):
    return re.search(rf"<li[^>]*><b>{re.escape(subject)}</b>: (.*?)</li>", page, re.DOTALL).group(1)


class Whole_report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = os.path.join(cls.folder.name, "out")
        cls.page = draw(cls.out, study(), campaign())
        cls.changed = cls.changed_page()

    @staticmethod
    def changed_page():
        """With two wrong answers of an exact kernel, a slow row of the paper's, and more wrong ones of the campaign."""
        rows, tables = study(), campaign()
        assert rows[1]["subject"] == "adaptive tree"
        rows[1]["false_negatives"] = 2
        for row in rows:
            if row["subject"] == "double paper" and row["scenario"] == "contour" and row["ratio"] == 2:
                row["mean_ns"] = 40_000_000
        next(r for r in tables["poses"] if r["subject"] == "double tree" and r["family"] == "sliver")["false_negatives"] = 29
        with tempfile.TemporaryDirectory() as out:
            return draw(out, rows, tables, everything=False)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_figure_says_what_made_it(self):
        figures = re.findall(r'<figure id="figure-([^"]*)">(.*?)</figure>', self.page, re.DOTALL)
        expected = {"speed_against_accuracy", "speed_against_accuracy_cold", "errors_by_distance", "errors_by_parameter", "flips",
                    "thresholds", "sign_maps", "frames_per_second",
                    "relative_sizes", "stages", "blame", "relations", "compilers", "needs", "digits", "budget", "demand", "first_contacts",
                    "depths", "certificates"}
        self.assertEqual({name for name, _ in figures}, expected)
        self.assertEqual(self.page.count("<svg"), len(figures), "a drawing outside a figure")
        for name, figure in figures:
            caption = re.search("<figcaption class=source>(.*?)</figcaption>", figure, re.DOTALL)
            self.assertIsNotNone(caption, name)
            text = html.unescape(re.sub("<[^>]*>", "", caption.group(1)))
            for label, what in (("Asked", ".{10,}?"), ("Cases", "[0-9].*?"), ("Seed", "[^ ].*?"), ("Again", "build/tetracone .*?"),
                                ("Version", "9.9.9, .*?"), ("Machine", "Abacus.*?")):
                self.assertRegex(text, rf"{label}: {what}\. ?[A-Z]", f"{name}: {label}")
            tables = re.findall(r'href="([^"]*\.csv)"', caption.group(1))
            self.assertTrue(tables, name)
            for file in tables + [f"figures/{name}.pdf", f"figures/{name}.svg"]:
                self.assertTrue(os.path.exists(f"{self.out}/{file}"), file)

    def test_the_words_under_a_figure_are_those_of_its_rows(self):
        of_campaign = " && ".join(CAMPAIGN) + " && build/tetracone report out/mine.db --out out"
        for figure, words in {"sign_maps": words_of("sign_maps"), "thresholds": words_of("stability"), "compilers": words_of("compilers"),
                              "budget": words_of("budget"), "demand": words_of("demand"), "first_contacts": words_of("moving_bodies"),
                              "stages": MADE["again"], "flips": of_campaign}.items():
            with open(f"{self.out}/figures/{figure}.svg", encoding="utf-8") as file:
                self.assertIn(html.escape(words, quote=False), file.read(), figure)
            self.assertIn(f"<b>Again:</b> <code>{html.escape(words)}</code>", self.page)
        for table in ("points", "contacts", "distance", "peers_ratios"):
            with open(f"{self.out}/tables/{table}.csv", newline="", encoding="utf-8") as file:
                self.assertEqual({r["command"] for r in csv.DictReader(file)}, {words_of(table.split("_")[0])})

    def test_no_time_is_drawn_that_is_the_pipes(self):
        with open(f"{self.out}/tables/speed_against_accuracy_cold.csv", newline="", encoding="utf-8") as file:
            self.assertEqual({r["subject"] for r in csv.DictReader(file)}, {"double brute", "double tree", "adaptive tree", "FCL OBBRSS"})

    def test_the_price_of_exactness_is_told_by_kind_of_contact(self):
        with open(f"{self.out}/tables/price.csv", newline="", encoding="utf-8") as file:
            rows = {(r["contact"], r["question"]): r for r in csv.DictReader(file)}
        face, moving = rows["shared face", "surface"], rows["circular", "surface"]
        self.assertEqual([face[c] for c in ("regime", "workloads", "poses", "collisions", "over_double", "over_double_low", "over_fcl", "wrong_double")],
                         ["exact contact", "1", "50", "20", f"{2004 / 1004:.4g}", "", f"{2004 / 4004:.4g}", "4"])
        self.assertEqual((moving["regime"], moving["workloads"], moving["wrong_fcl"]), ("in motion", "2", "0"))
        self.assertLessEqual(float(moving["over_double_low"]), float(moving["over_double"]))
        self.assertEqual(rows["nested", "solid"]["over_fcl"], "")  # it answers of surfaces

    def test_the_price_of_other_questions_is_told_beside(self):
        with open(f"{self.out}/tables/price_of_questions.csv", newline="", encoding="utf-8") as file:
            (row,) = csv.DictReader(file)
        self.assertEqual([row[c] for c in ("question", "contact", "over_double", "over_fcl", "over_general", "wrong_double")],
                         ["distance", "shared face", "1.5", "", "0.05", "0"])
        self.assertEqual(row["command"], words_of("contact_cost"))

    def test_moving_primitives_are_summed_over_families(self):
        with open(f"{self.out}/tables/motion.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(r["of"], r["subject"], r["n"], r["false_negatives"]) for r in rows],
                         [(g, s, "100", w) for g in ("published", "families") for s, w in (("adaptive", "0"), ("double", "7"))])
        self.assertIn("<tr><td>families</td><td>double</td><td>100</td><td>40</td><td>7</td><td>0</td><td>0.3</td></tr>", self.page)

    def test_steps_are_drawn_by_what_they_miss_and_how_late_they_are(self):
        self.assertIn("40 motions, 30 of them with a contact", self.page)
        with open(f"{self.out}/figures/first_contacts.svg", encoding="utf-8") as file:
            drawing = file.read()
        for text in ("10 static poses", "FCL, steps", "ours, exact", "plate", "contacts missed"):
            self.assertIn(text, drawing)
        self.assertNotIn("FCL, advancement", drawing)  # it has no row here
        rows = [dict((k, str(v)) for k, v in r.items()) for name, some in queries() if name == "moving_bodies" for r in some]
        figure, axes = plt.subplots(1, 2)
        figures_motion.late_against_time(axes[0], rows, ["plate"])
        figures_motion.missed_against_steps(axes[1], rows, ["plate"])
        late = {(line.get_xdata()[0], line.get_ydata()[0]) for line in axes[0].get_lines()}
        self.assertEqual(late, {(5.0, figures_motion.ON_TIME), (2.0, 0.01), (0.8, 0.1)})  # ten poses miss all
        missed = [(list(line.get_xdata()), list(line.get_ydata())) for line in axes[1].get_lines()]
        self.assertEqual(missed, [([0, 1], [100, 10]), ([4], [0]), ([2], [20])])
        plt.close(figure)

    def test_what_touches_is_counted_by_who_says_that_it_collides(self):
        section = re.search('<section id="touching">(.*?)</section>', self.page, re.DOTALL).group(1)
        self.assertIn("<tr class=\"exact\"><td>faces touch</td><td>axes</td><td>meet, 20 of 20</td><td>20 of 20</td><td>0 of 20</td>", section)
        self.assertIn("<td>inside</td><td>axes</td><td>contains, 20 of 20</td><td>0 of 20</td><td>20 of 20</td>", section)
        self.assertIn("All together say of 20 of 40 touching pairs that they collide. Those that tell them apart here: open.", section)

    def test_depths_are_drawn_by_how_far_off_they_are_and_widths_by_their_time(self):
        rows = {name: [dict((k, str(v)) for k, v in r.items()) for r in some] for name, some in overlaps()}
        figure, axes = plt.subplots(1, 2)
        figures_overlap.draw_answers(axes[0], rows["penetration_peers"])
        shares = [bar.get_width() for bar in axes[0].patches]
        self.assertEqual([round(x) for x in shares], [30, 10, 30, 20, 0, 0, 10, 0, 0, 0, 0, 0, 0, 100])
        figures_overlap.draw_widths(axes[1], rows["penetration_widths"])
        lines = [(list(line.get_xdata()), list(line.get_ydata())) for line in axes[1].get_lines()]
        exact = figures_overlap.EXACT_WIDTH
        self.assertEqual(lines, [([1, 4], [0.5, 0.1]), ([2, 3], [1e-16, exact])])
        plt.close(figure)
        section = re.search('<section id="depths">(.*?)</section>', self.page, re.DOTALL).group(1)
        self.assertIn("<td>round</td><td>Bullet</td><td>10</td><td>1</td><td>0</td><td>2</td><td>4</td><td>3</td><td>0.25</td><td>0.5</td><td>1</td><td>2</td>", section)
        self.assertIn("20 answers of other libraries, and 4 brackets", section)

    def test_certificates_are_drawn_by_the_share_that_is_proved(self):
        self.assertIn("150 answers, 90 proved, 0 refused", self.page)
        with open(f"{self.out}/figures/certificates.svg", encoding="utf-8") as file:
            drawing = file.read()
        for text in ("collide apart", "relation meet", "motion rigid", "answers proved", "size, kB", "time, ms"):
            self.assertIn(text, drawing)
        rows = [dict((k, str(v)) for k, v in r.items()) for name, some in queries() if name == "certificates" for r in some]
        figure, axes = plt.subplots(1, 2)
        figures_certificates.shares(axes[0], rows)
        figures_certificates.costs(axes[1], rows, (("bytes_mean", "blue", "mean"),), 1000, "size, kB")
        self.assertEqual([bar.get_width() for bar in axes[0].patches], [100, 80, 0])
        self.assertEqual(list(axes[1].get_lines()[0].get_xdata()), [3, 5])  # of what has a proof
        plt.close(figure)

    def test_a_crash_is_told_with_its_last_words(self):
        self.assertIn("<td>mine</td><td>signal 11</td><td>7</td><td><small>out of &lt;memory&gt;</small></td>", self.page)

    def test_budgets_say_what_was_wrong_and_demand_what_share_was_made(self):
        self.assertIn("160 pairs, 0 decided wrong, 0 farther apart than said", self.page)
        with open(f"{self.out}/figures/demand.svg", encoding="utf-8") as file:
            self.assertIn("nodes of trees, millions; at the end 3.3 %", file.read())

    def test_every_row_of_a_table_says_what_made_it(self):
        names = [n for n in os.listdir(f"{self.out}/tables") if not n.startswith("verify_")]
        self.assertGreater(len(names), 12)
        for name in names:
            with open(f"{self.out}/tables/{name}", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.assertTrue(rows, name)
            for row in rows:
                for key in ("seed", "version", "compiler", "processor", "command"):
                    self.assertTrue(row[key], f"{name}: {key}")

    def test_every_link_leads_somewhere(self):
        for target in re.findall(r'<a href="([^"#]+)"', self.page):
            self.assertTrue(os.path.exists(f"{self.out}/{target}"), target)
        for anchor in re.findall(r'<a href="#([^"]+)"', self.page):
            self.assertIn(f'id="{anchor}"', self.page)

    def test_an_id_stands_for_one_place(self):
        ids = re.findall(r'\bid="([^"]*)"', self.page)
        self.assertEqual(len(ids), len(set(ids)))
        self.assertGreater(self.page.count("url(#"), 0)
        for target in re.findall(r'(?:href="#|url\(#)([^")]+)', self.page):
            self.assertIn(target, ids)

    def test_the_page_needs_no_network(self):
        self.assertEqual(re.findall(r'(?:src|href)="(?:https?:)?//[^"]*"', self.page), [])
        self.assertNotIn("<script", self.page)
        self.assertNotIn("@import", self.page)

    def test_the_colours_of_the_page_reach_the_drawings(self):
        drawing = re.search("<svg.*?</svg>", self.page, re.DOTALL).group(0)
        self.assertIn("var(--ink)", drawing)
        self.assertNotIn("#1a1b1c", drawing)

    def test_a_second_run_writes_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as other:
            draw(other, study(), campaign())
            self.assertEqual(files_of(self.out), files_of(other))

    def test_a_wrong_answer_of_an_exact_kernel_changes_the_claim(self):
        # 7 scenes of 50, and 5 questions of 240 in the campaign
        self.assertTrue(claim_of(self.page).startswith("Our exact methods: 0 wrong of 1,550 answers (95 %: below 0.25 %). "))
        self.assertIn(" 2 wrong of 1,550 answers ", claim_of(self.changed))
        self.assertIn("In exactly degenerate contact others are wrong: our tree in double 8 %, FCL 10 %.", claim_of(self.page))
        self.assertIn("wrong in 2 of 200 (1 %) random", verdict_of(self.changed, "adaptive tree"))
        self.assertIn("right in all 350 of the study", verdict_of(self.page, "adaptive tree"))

    def test_a_value_of_the_campaign_changes_its_sentence(self):
        self.assertIn("campaign: 36 of 480 (7.5 %) wrong", verdict_of(self.page, "double tree"))
        self.assertIn("campaign: 63 of 480 (13 %) wrong, breaks most on <i>sliver</i> (41 %)", verdict_of(self.changed, "double tree"))

    def test_fractions_sequences_and_what_a_library_does_not_know_stand_apart(self):
        self.assertIn("; frames of motions in exact contact: 2 of 16 (12 %); poses with fractions: 40 of 40 (100 %)",
                      verdict_of(self.page, "double tree"))
        fcl = verdict_of(self.page, "FCL OBBRSS")
        self.assertIn("campaign, surface question: 18 of 240 (7.5 %) wrong, ", fcl)
        self.assertIn("; the other question, which it does not know: 18 of 240 (7.5 %)", fcl)
        self.assertNotIn("fractions", fcl)
        self.assertIn("right in all 350", verdict_of(self.page, "adaptive tree"))
        self.assertNotRegex(fcl, "wrong in .*nested")  # a question of solids
        # The table of all subjects, and that of fractions, in which the library has no row of its own.
        tables = re.findall("<h3>Poses (.*?)</table>", self.page, re.DOTALL)
        object_tables = [t for t in tables if "<td>double tree</td>" in t and "solid" in t]
        self.assertEqual([t.startswith("of doubles") for t in object_tables], [True, False])
        self.assertIn("<small>knows surfaces alone:</small> 18 of 240", object_tables[0])
        self.assertIn("<td>double tree</td><td>20 of 20 (100 %)", object_tables[1])
        self.assertNotIn("FCL", object_tables[1])
        self.assertIn("<td>sliver <small>with fractions</small></td>", self.page)

    def test_the_chart_of_single_queries_has_what_each_subject_knows_and_both_times(self):
        with open(f"{self.out}/tables/speed_against_accuracy_cold.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({r["time_ns"] for r in rows}, {"5000"})  # of making and of asking
        self.assertEqual({r["panel"] for r in rows}, {"random coordinates", "near-degenerate", "exactly degenerate", "nested"})
        self.assertEqual({r["panel"] for r in rows if r["subject"] == "FCL OBBRSS"}, {r["panel"] for r in rows} - {"nested"})
        self.assertEqual({r["asked"] for r in rows if r["panel"] == "near-degenerate"}, {"120"})  # no fraction

    def test_wrong_answers_far_from_zero_are_explained(self):
        self.assertIn("Of 4 such answers of <i>double brute</i> above 2<sup>-40</sup>, 2 are nearer to contact than two ulps, 1 are at the "
                      "ends of the doubles' range, and 1 neither.", self.page)
        with open(f"{self.out}/tables/errors_by_distance.csv", newline="", encoding="utf-8") as file:
            self.assertEqual({(r["wrong"], r["asked"]) for r in csv.DictReader(file)}, {("0", "60"), ("3", "60")})

    def test_families_are_described_and_grouped(self):
        self.assertIn("<td>sliver</td><td>predicate object</td><td>cases of sliver</td><td>height &amp; width</td><td>2 10</td>"
                      "<td>near-degenerate</td>", self.page)
        self.assertIn("in no panel: brand-new", self.page)
        self.assertNotIn("Every coordinate and every entry of a pose is a double,", self.page)

    def test_a_slow_row_breaks_the_papers_statement(self):
        self.assertIn("holds; slowest", self.page)
        self.assertIn("<b>not</b> in 1 of 4; slowest 25 (contour, x / x)", self.changed)
        self.assertNotIn("<b>not</b> in 1 of 4", self.page)

    def test_peers_are_ratios_with_their_wrong_answers(self):
        self.assertIn("<td>0.5 × (0.5 .. 0.5); 5 of 100 (5 %) wrong</td><td>0.5 ×; 6 of 10 (60 %) wrong</td>", self.page)
        self.assertIn("<td>1 × (1 .. 1); 0 of 100 (&lt; 3.7 %) wrong</td>", self.page)
        self.assertIn("<th>in motion, surface</th><th>near contact, one ulp apart, surface</th>", self.page)

    def test_a_course_without_a_contact_is_said_to_be_too_small(self):
        self.assertIn("circular 2 of 100 poses (2 %); too small to be compared with longer runs, since no pose collides: circular y 9 1", self.page)

    def test_what_else_is_asked_has_tables(self):
        for cells in (("FCL", "4", "2.5", "9", "4.50", "3", "0"), ("FCL RSS", "distance", "1,235", "2.5", "7", "1 of 4", "0 of 1"),
                      ("near", "cones", "0.07", "0.25", "8.0", "46", "0 of 50")):
            self.assertIn("".join(f"<td>{cell}</td>" for cell in cells), self.page)

    def test_none_wrong_is_stated_with_its_bound(self):
        self.assertIn("0 of 350 (&lt; 1.1 %)", share(0, 350))
        self.assertRegex(self.page, r"0 of 50 \(&lt; 7\.1 %\)")

    def test_the_citation_is_that_of_the_file(self):
        with open(os.path.join(SOURCE, "..", "..", "CITATION.cff"), encoding="utf-8") as file:
            text = file.read()
        version = re.search(r"^version: (.*)$", text, re.MULTILINE).group(1)
        self.assertIn(f"version = {{{version}}}", self.page)
        for entry in ("@software{tetracone,", "@misc{tetracone_dataset,", "@article{jimenez2008collision,"):
            self.assertIn(entry, self.page)
        with open(os.path.join(SOURCE, "..", "artifact", "README.md"), encoding="utf-8") as file:
            self.assertIn(f"```bibtex\n{report_methods.bibtex(report_methods.citation())}\n```", file.read())


class Parts(unittest.TestCase):
    def test_a_study_alone_is_a_report(self):
        with tempfile.TemporaryDirectory() as out:
            self.assertIn('id="paper"', draw(out, study(), everything=False))

    def test_a_campaign_alone_is_a_report(self):
        with tempfile.TemporaryDirectory() as out:
            page = draw(out, with_campaign=campaign(), everything=False)
            self.assertIn('id="figure-speed_against_accuracy_cold"', page)
            self.assertIn("Our exact methods: 0 wrong of 1,200 answers", claim_of(page))

    def test_the_levels_are_those_of_campaigns(self):
        with open(os.path.join(SOURCE, "..", "..", "verify", "campaign", "levels.h"), encoding="utf-8") as file:
            names = re.findall(r'std::string_view name = "(.*?)";', file.read())
        self.assertEqual(sorted(names), sorted(level for level, *_ in figures_failure.LEVELS))

    def test_a_campaign_of_one_level_is_a_report_of_what_it_asked(self):
        for level, *_ in figures_failure.LEVELS:
            with self.subTest(level), tempfile.TemporaryDirectory() as out:
                page = draw(out, with_campaign=one_level(level), everything=False)
                section = re.search(f'<section id="level-{level}">(.*?)</section>', page, re.DOTALL).group(1)
                self.assertIn("<td>adaptive tree</td><td>0 of 5 (&lt; 43 %)</td>", section)
                self.assertIn("<td>double tree</td><td>2 of 5 (40 %)<br><small>missed 1, invented 0, failed 1</small></td>", section)
                self.assertIn("violated: exact subjects 0 of 4 (&lt; 49 %), the others 1 of 4 (25 %).", section)
                self.assertIn(f"<td>{level}</td><td>2</td><td>5</td><td>2</td><td>2</td><td>0 of 5", page)
                self.assertEqual(re.findall('<section id="level-([^"]*)">', page), [level])
                self.assertNotIn("<tbody></tbody>", page)
                self.assertEqual("The verdict" in page, level == "object")
                self.assertEqual("Which family breaks whom" in page, level == "object")
                self.assertEqual("Each point is a way of answering" in page, "speed_against_accuracy" in page)
                drawn = {"relations"} if level in ("object", "predicate") else set()
                self.assertEqual(set(re.findall('<figure id="figure-([^"]*)">', page)), drawn)

    def test_only_panels_with_points_are_drawn(self):
        tables = campaign()
        tables["sweeps"] = [r for r in tables["sweeps"] if r["family"] == "sliver" and r["subject"] == "float"]
        with tempfile.TemporaryDirectory() as out:
            page = draw(out, with_campaign=tables, everything=False)
        figure = re.search('<figure id="figure-errors_by_parameter">(.*?)</figure>', page, re.DOTALL).group(1)
        self.assertIn("fail, by height of a sliver?", figure)
        self.assertEqual(len(set(re.findall(r'id="errors_by_parameter-(axes_\d+)"', figure))), 1)

    def test_who_is_never_wrong_is_not_said_to_be(self):
        rows = [dict(r, false_negatives=0 if r["subject"] == "double tree" else r["false_negatives"]) for r in study()]
        with tempfile.TemporaryDirectory() as out:
            self.assertIn("others are wrong: FCL 10 %.", claim_of(draw(out, rows, everything=False)))

    def test_an_empty_folder_is_refused_in_a_line(self):
        with tempfile.TemporaryDirectory() as out:
            done = subprocess.run([sys.executable, "-B", os.path.join(SOURCE, "report.py"), out], capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertRegex(done.stderr, r"^[^\n]*study\.csv: no such file; expected [^\n]*\n$")
            self.assertEqual(os.listdir(out), [])

    def test_a_figure_without_its_source_is_refused(self):
        whole = Source("Why?", "3", "1", "make", "1", "cc", "Abacus")
        whole.check()
        for field in ("asked", "cases", "seed", "command", "version", "compiler", "machine"):
            with self.assertRaises(ValueError):
                whole.about(**{field: " "}).check()

    def test_large_numbers_have_no_exponent(self):
        for x, text in ((0.01234, "0.0123"), (1.3, "1.3"), (999.4, "999"), (999.5, "1,000"), (1310, "1,310"), (1e6, "1,000,000")):
            self.assertEqual(rounded(x), text)
        self.assertEqual(times(99.7), "100")

    def test_wilson_is_the_interval_of_the_textbook(self):
        for (wrong, n), (low, high) in {(10, 100): (0.05522914, 0.17436566), (5, 10): (0.2365931, 0.7634069),
                                        (0, 10): (0, 0.2775328)}.items():
            self.assertAlmostEqual(wilson(wrong, n)[0], low, 6)
            self.assertAlmostEqual(wilson(wrong, n)[1], high, 6)
        self.assertEqual(wilson(0, 0), (0, 1))


if __name__ == "__main__":
    unittest.main()
