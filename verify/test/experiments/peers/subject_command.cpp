// Runs small Python programs as external methods.

#include "experiments/peers/subject_command.h"

#include "experiments/peers/check_subject.h"
#include "verify/cases/shape_generators.h"
#include "verify/cases/shape_library.h"
#include "verify/test/support/print_outcome.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>

BOOST_AUTO_TEST_SUITE(test_subject_command)

using namespace tetracone;
using kernel::Pose;
using kernel::Question;
using verify::Object_case;
using verify::Outcome;
using verify::Temporary_file;
using verify::object_family::shared;
using namespace std::chrono_literals;

namespace {

/// Does what B's translation along x says, and with the argument `MODE` one thing wrong.
constexpr const char* script = R"(
import json, os, sys, time
mode = sys.argv[1] if len(sys.argv) > 1 else ""
bodies, held = {}, []
def put(value):
    line = value if isinstance(value, str) else json.dumps(value)
    if mode == "held": held.append(line)
    else: print(line, flush=True)
if mode == "banner":
    put("welcome")
if mode == "misspelt":
    put({"hello": 1, "bodies": "konvex"})
if mode in ("solids", "rigid", "convex"):
    put({"hello": 1, "name": mode, "version": "1", "questions": ["solid"] if mode == "solids" else ["surface", "solid"],
         "poses": "rigid" if mode == "rigid" else "affine", "bodies": "convex" if mode == "convex" else "any", "batch": True})
for line in sys.stdin:
    m = json.loads(line)
    if "model" in m:
        bodies[m["model"]] = m
    if "forget" in m:
        del bodies[m["forget"]]
        if mode == "forgetful":
            bodies.clear()
    if "ask" not in m:
        continue
    x = m["pose_b"][3]
    bodies[m["a"]], bodies[m["b"]]
    if mode: x = 2 if mode not in ("column", "twice") else 0
    if x == 3: os.abort()
    elif x == 4: put("{no JSON")
    elif x == 5:
        print("thinking", file=sys.stderr, flush=True)
        time.sleep(60)
    elif x == 6: put({"ask": m["ask"] + 1, "answer": 1})
    elif x == 7: put({"ask": m["ask"], "answer": len(bodies) % 2})
    elif x == 8: put({"ask": m["ask"], "answer": True})
    elif mode == "endless":
        put({"ask": m["ask"], "answer": None})
        while True: print("again", file=sys.stderr)
    elif mode == "flood":
        while True: print("again" * 100)
    elif mode == "long":
        print("x" * 10**6, end="")
        put({"ask": m["ask"], "answer": 1})
        put({"ask": m["ask"], "answer": None})
    elif mode == "declines": put({"why": "no idea", "answer": None, "ask": m["ask"]})
    elif x == 2 or mode in ("held", "forgetful", "banner", "once"): put({"ask": m["ask"], "answer": None})
    elif mode == "column": put({"ask": m["ask"], "answer": int(all(-1 <= a - b <= 1 for a, b in zip(m["pose_b"][9:], m["pose_a"][9:])))})
    elif mode == "twice": print("\n".join([json.dumps({"ask": m["ask"], "answer": None})] * 2), flush=True)
    elif x == 9: put({"ask": m["ask"], "answer": 1, "ns": 1234.5})
    elif x == 10: put({"ask": m["ask"], "answer": 1, "ns": "soon"})
    else: put({"ask": m["ask"], "answer": 1 if x in (1, "1/3") else 0})
    if mode == "once": sys.exit(3)
print("\n".join(held))
)";

const Temporary_file& program()
{
  static const Temporary_file file("subject.py", script);
  return file;
}

std::string python(const std::filesystem::path& file) { return "exec '" TETRACONE_PYTHON "' '" + file.native() + "' "; }

std::string command(const std::string& mode = "") { return python(program().path()) + mode; }

Object_case cubes(const Pose& pose_b)
{
  static const auto cube = shared(verify::unit_cube());
  return {cube, cube, {}, pose_b, {}, {}, {}};
}

Object_case along(double x) { return cubes(Pose::translation(x, 0, 0)); }

using Running = std::unique_ptr<verify::Running_subject>;

Running started(const std::string& words = command(), std::chrono::milliseconds limit = 10s)
{
  return experiments::subject_command("mine", words, limit).make();
}

/// The answer about the surfaces of a cube and one that is moved by x.
Outcome surface(const Running& running, double x) { return (*running)(along(x), Question::surface); }

bool contains(const std::ostringstream& out, const std::string& part) { return verify::contains(out.str(), part); }

std::string checked(const std::string& mode)
{
  std::ostringstream out;
  const bool follows = experiments::check_subject(command(mode), 4s, out);
  BOOST_TEST(follows == (out.str().find("WRONG") == std::string::npos));
  return out.str();
}

}  // namespace

BOOST_AUTO_TEST_CASE(its_time_is_what_it_tells_and_not_the_pipes)
{
  const Running mine = started();
  for (const double x : {1, 9, 10}) {
    BOOST_TEST(surface(mine, x) == Outcome::yes);
    BOOST_TEST(mine->spent().has_value() == (x == 9));
    if (x == 9) BOOST_TEST((mine->spent()->asking == 1234u && !mine->spent()->making));
  }
}

BOOST_AUTO_TEST_CASE(its_answers_are_taken_as_they_are)
{
  const auto subject = experiments::subject_command("mine", command(), 10s);
  BOOST_TEST(subject.name == "mine");
  BOOST_TEST(subject.command == command());
  BOOST_TEST(!subject.is_exact);
  const auto running = subject.make();
  BOOST_TEST(surface(running, 1) == Outcome::yes);
  BOOST_TEST((*running)(along(0), Question::solid) == Outcome::no);
  BOOST_TEST((*running)(along(2), Question::solid) == Outcome::not_asked);
  // A fraction comes as it is.
  const Pose third = Pose::from_quaternion(1, 0, 0, 0, {kernel::Rational(1, 3), 0, 0});
  BOOST_TEST((*running)(cubes(third), Question::surface) == Outcome::yes);
}

BOOST_AUTO_TEST_CASE(what_goes_wrong_is_a_failure_and_the_next_question_is_answered)
{
  // 3 dies, 4 no JSON behind a brace, 6 another ask, 8 `true` for 1.
  const Running running = started();
  for (const double wrong : {3, 4, 6, 8, 3}) {
    BOOST_TEST(surface(running, wrong) == Outcome::failed, wrong);
    BOOST_TEST(surface(running, 1) == Outcome::yes, wrong);
  }
}

BOOST_AUTO_TEST_CASE(a_failure_keeps_how_the_program_ended_and_its_last_words)
{
  const auto left_by = [](const std::string& words) {
    const Running running = started(words);  // all end by themselves
    BOOST_TEST(surface(running, 1) == Outcome::failed, words);
    const verify::Failure failure = running->failure();
    return failure.how + ": " + failure.said;
  };
  const std::string asked = "head -n 2 >/dev/null; ";  // a body and the question
  BOOST_TEST(left_by("echo first >&2; " + asked + "printf 'out of\\tmemory \\n\\n' >&2; exit 3") ==
             "status 3: out of?memory");
  BOOST_TEST(left_by(asked + "echo '\"quoted\", last' >&2; kill -11 $$") == "signal 11: \"quoted\", last");
  BOOST_TEST(left_by("exit 0") == "status 0: ");
  const std::string wrong = left_by("echo hm >&2; echo Loaded.; echo {no JSON; exec sleep 60");
  BOOST_TEST((wrong.starts_with("wrong line: ") && wrong.ends_with("; hm")), wrong);
  // One who writes without end is silent all the same.
  const auto running = started(command("endless"), 300ms);
  BOOST_TEST(surface(running, 1) == Outcome::not_asked);
  BOOST_TEST(surface(running, 1) == Outcome::failed);
  BOOST_TEST(running->failure().how == "silent");
  BOOST_TEST(std::string("again").starts_with(running->failure().said));
  // More than a pipe holds, of which the last line counts.
  BOOST_TEST(left_by("yes error | head -n 100000 >&2; echo at last >&2; exit 4") == "status 4: at last");
}

BOOST_AUTO_TEST_CASE(silence_past_the_limit_is_a_failure)
{
  const auto running = started(command(), 300ms);
  BOOST_TEST(surface(running, 1) == Outcome::yes);
  const auto start = std::chrono::steady_clock::now();
  BOOST_TEST(surface(running, 5) == Outcome::failed);
  const auto took = std::chrono::steady_clock::now() - start;
  BOOST_TEST((took >= 300ms));
  BOOST_TEST((took < 20s));
  BOOST_TEST(running->failure().how == "silent");
  BOOST_TEST(running->failure().said == "thinking");
  BOOST_TEST(surface(running, 1) == Outcome::yes);
}

BOOST_AUTO_TEST_CASE(bodies_are_announced_once_and_forgotten_when_others_come)
{
  const auto running = started();
  const auto cube = cubes({}).a, box = shared(verify::box({0, 0, 0}, {1, 2, 3}));
  Object_case one = along(7), two = along(7);  // 7: whether the program has an odd number of bodies
  two.b = box;
  for (int k = 0; k < 3; ++k) {
    BOOST_TEST((*running)(one, Question::surface) == Outcome::yes);
    BOOST_TEST((*running)(two, Question::surface) == Outcome::no);
  }
  one.a = one.b = box;
  BOOST_TEST((*running)(one, Question::surface) == Outcome::yes);
}

BOOST_AUTO_TEST_CASE(a_command_that_cannot_be_run_is_refused_and_one_that_dies_is_not)
{
  BOOST_CHECK_THROW(experiments::require_command("/nowhere/program --option", 1s), std::runtime_error);
  BOOST_CHECK_THROW(experiments::require_command("/dev/null", 1s), std::runtime_error);
  experiments::require_command("exit 3", 1s);
  experiments::require_command(command(), 10s);
  BOOST_TEST(surface(started("exit 3", 1s), 1) == Outcome::failed);
}

BOOST_AUTO_TEST_CASE(nothing_that_it_started_outlives_it)
{
  // The shell stays and starts a process that would go on.
  const Temporary_file number("child", "");
  const std::string grandchild = "sleep 600 & echo $! > '" + number.path().native() + "'; ";
  {
    const Running running = started(grandchild + "'" TETRACONE_PYTHON "' '" + program().path().native() + "'; true");
    BOOST_TEST(surface(running, 1) == Outcome::yes);
  }
  pid_t child = 0;
  std::ifstream(number.path()) >> child;
  BOOST_TEST_REQUIRE(child > 0);
  BOOST_TEST(verify::ends_soon(child));
}

BOOST_AUTO_TEST_CASE(the_check_says_what_is_wrong)
{
  const auto wrong = [](const std::string& mode, const std::string& what) {
    const std::string said = checked(mode);
    BOOST_TEST((verify::contains(said, "WRONG") && verify::contains(said, what)), mode << ": " << said);
  };
  wrong("held", "flushed");
  wrong("column", "poses are row-major");
  wrong("forgetful", "a body forgotten, and its number used again: no line, and it ends with status 1");
  wrong("once", "ends with status 3");
  wrong("twice", "output behind the answer");
}

BOOST_AUTO_TEST_CASE(lines_without_end_are_silence_and_the_rest_of_a_long_line_is_no_answer)
{
  const auto running = started(command("flood"), 300ms);
  BOOST_TEST(surface(running, 2) == Outcome::failed);
  BOOST_TEST(running->failure().how == "silent");
  const auto wordy = started(command("long"));
  BOOST_TEST(surface(wordy, 2) == Outcome::not_asked);
  BOOST_TEST(wordy->skipped_lines() == 1u);
}

BOOST_AUTO_TEST_CASE(lines_that_are_no_objects_are_skipped_and_counted)
{
  const auto running = started(command("banner"));
  BOOST_TEST(surface(running, 2) == Outcome::not_asked);
  BOOST_TEST(running->why_not_asked() == "declined");
  BOOST_TEST(running->skipped_lines() == 1u);
  BOOST_TEST(surface(running, 2) == Outcome::not_asked);
  BOOST_TEST(running->skipped_lines() == 0u);
  const std::string said = checked("banner");
  BOOST_TEST(verify::contains(said, "skipped 14 lines that do not begin with {"), said);
}

BOOST_AUTO_TEST_CASE(a_misspelt_hello_does_not_follow_the_protocol)
{
  const std::string said = checked("misspelt");
  BOOST_TEST(said.find("'bodies' of the hello; expected convex|manifold|closed|any") != std::string::npos, said);
}

BOOST_AUTO_TEST_CASE(a_hello_says_what_is_asked)
{
  const auto asked = [](const std::string& mode, const Object_case& c, Question question) {
    const auto hello = experiments::require_command(command(mode), 10s);
    BOOST_TEST_REQUIRE(hello.has_value());
    BOOST_TEST(hello->takes_batches);
    const auto running = experiments::subject_command("mine", command(mode), 10s, hello).make();
    return (*running)(c, question) == Outcome::not_asked ? running->why_not_asked() : "asked";
  };
  Object_case tunnel = along(1);
  tunnel.b = shared(verify::prism_with_tunnel());
  const Pose sheared(std::array<double, 12>{1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  // A question is declined: with a word the program declines all.
  BOOST_TEST(asked("solids", along(1), Question::surface) == "not taken");
  BOOST_TEST(asked("solids", along(1), Question::solid) == "declined");
  BOOST_TEST(asked("rigid", along(1), Question::surface) == "declined");
  BOOST_TEST(asked("rigid", cubes(Pose::from_quaternion(1, 2, 3, 4)), Question::surface) == "declined");
  BOOST_TEST(asked("rigid", cubes(sheared), Question::surface) == "not taken");
  BOOST_TEST(asked("convex", cubes(sheared), Question::surface) == "declined");
  BOOST_TEST(asked("convex", tunnel, Question::surface) == "not taken");
  BOOST_TEST(!experiments::require_command(command(), 10s).has_value());
}

BOOST_AUTO_TEST_CASE(a_program_is_asked_the_kinds_of_question_that_its_hello_names)
{
  const std::string questions = python(TETRACONE_SOURCE_DIR "/experiments/subjects/questions.py");
  auto subject = experiments::subject_command("mine", questions, 10s, experiments::require_command(questions, 10s));
  std::ostringstream out;
  BOOST_TEST(experiments::check_subject(questions, 10s, out), out.str());
  for (const char* kind : {"relation", "within", "distance", "inside", "ray", "first contact", "triangles"})
    BOOST_TEST(contains(out, std::string("takes  ") + kind), kind);

  BOOST_TEST(experiments::tells_distances(subject));
  const auto running = subject.make();
  // A relation answers both questions: a cube in a cube has no common surface.
  Object_case in_another = along(0);
  in_another.b = shared(verify::box({-1, -1, -1}, {2, 2, 2}));
  BOOST_TEST(((*running)(in_another, Question::surface) == Outcome::no));
  BOOST_TEST(((*running)(in_another, Question::solid) == Outcome::yes));
  BOOST_TEST((surface(running, 1) == Outcome::yes));
  BOOST_TEST(((*running)(along(1.5), Question::solid) == Outcome::no));
  const auto apart = along(3);
  const auto told = running->distance(apart, Question::solid);
  BOOST_TEST((told.outcome == Outcome::yes && told.answer.is_alone));
  BOOST_TEST(told.answer.alone == 2);
  BOOST_TEST((running->within(apart, Question::surface, "2") == Outcome::yes));
  BOOST_TEST((running->within(apart, Question::surface, "5/3") == Outcome::no));

  verify::Probe_case probe{apart.a, {0.5, 0.5, 0.25}, {0, 0, 0}, {}};
  const auto points = experiments::point_command(subject, 10s)->make();
  for (const auto& [x, place] : {std::pair{0.5, 1}, {1, 0}, {2, -1}}) {
    probe.from[0] = x;
    BOOST_TEST((*points)(probe).answer == place);
  }
  const auto rays = experiments::ray_command(subject, 10s)->make();
  probe.direction = {-2, 0, 0};
  auto hit = (*rays)(probe);
  BOOST_TEST((hit.outcome == Outcome::yes && hit.answer.is_first_t));
  BOOST_TEST_REQUIRE(hit.answer.first.has_value());
  BOOST_TEST(hit.answer.first->t == 0.5);
  probe.direction = {2, 0, 0};
  hit = (*rays)(probe);
  BOOST_TEST((hit.outcome == Outcome::yes && !hit.answer.first));

  const auto motions = experiments::motion_command(subject, 10s)->make();
  verify::Moving_bodies moving{*apart.a, *apart.b, {}, {}};
  moving.motion_a = {{{1, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0}}};
  moving.motion_b = {{{1, 0, 0, 0, 3, 0, 0}, {1, 0, 0, 0, -1, 0, 0}}};
  const auto met = (*motions)(moving, Question::surface);
  BOOST_TEST((met.outcome == Outcome::yes && met.answer.lo == 0.5 && met.answer.hi == 0.5));
  moving.motion_b[1][4] = 9;
  BOOST_TEST(((*motions)(moving, Question::surface).outcome == Outcome::no));
  moving.motion_b[1][1] = 1;  // it turns
  BOOST_TEST(((*motions)(moving, Question::surface).outcome == Outcome::not_asked));

  verify::Predicate_case pair{
      {kernel::Vertex{9, 9, 9}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {1, 1, 0}, {2, 1, 1}, {1, 2, 1}, {}, {}, {}};
  const auto triangles = experiments::triangle_command(subject, 10s)->make();
  for (const int crosses : {1, 0}) {
    pair.pose_b = Pose::translation(0, 0, crosses ? -0.5 : 0.5);
    const auto told = (*triangles)(pair, verify::Predicate::triangle_triangle);
    BOOST_TEST((told.outcome == Outcome::yes && told.answer == crosses));
  }
  BOOST_TEST(((*triangles)(pair, verify::Predicate::segment_triangle).outcome == Outcome::not_asked));

  // A program is asked of no other kind unless it names it.
  subject.hello = R"({"hello": 1, "questions": ["solid", "within"]})";
  BOOST_TEST(experiments::tells_distances(subject));
  BOOST_TEST((!experiments::point_command(subject, 10s) && !experiments::ray_command(subject, 10s) &&
              !experiments::motion_command(subject, 10s) && !experiments::triangle_command(subject, 10s)));
  subject.hello = "";
  BOOST_TEST(!experiments::tells_distances(subject));
}

BOOST_AUTO_TEST_CASE(answers_of_each_kind_have_their_form)
{
  namespace lines = experiments::subject_lines;
  using lines::Kind;
  const auto outcome = [](Kind kind, const std::string& answer) {
    return lines::read("{\"ask\": 1, \"answer\": " + answer + "}", 1, kind).outcome;
  };
  for (const Kind kind : lines::all_kinds) {
    BOOST_TEST((outcome(kind, "null") == Outcome::not_asked), to_string(kind));
    BOOST_TEST(!outcome(kind, "2.5").has_value() == (kind != Kind::distance), to_string(kind));
    BOOST_TEST(!outcome(kind, "-1").has_value() == (kind != Kind::inside), to_string(kind));
    BOOST_TEST(!outcome(kind, "\"1\"").has_value(), to_string(kind));
  }
  BOOST_TEST((outcome(Kind::ray, "1, \"t\": 7") == Outcome::yes));
  BOOST_TEST(!outcome(Kind::first_contact, "1, \"t\": 7").has_value());
  BOOST_TEST(!outcome(Kind::ray, "1").has_value());
}

BOOST_AUTO_TEST_CASE(triangles_are_told_placed_and_a_failure_about_them_is_one)
{
  verify::Predicate_case c{
      {kernel::Vertex{9, 9, 9}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {1, 1, 0.1}, {2, 1, 1}, {}, {}, {}, {}};
  c.pose_b = Pose::from_quaternion(1, 0, 0, 0, {0, 0, kernel::Rational(1, 3)});
  BOOST_TEST(experiments::subject_lines::triangles(5, c) ==
             "{\"ask\":5,\"triangle_a\":[[0,0,0],[4,0,0],[0,4,0]],\"triangle_b\":[[1,1,\"" +
                 kernel::to_string(kernel::Rational(0.1) + kernel::Rational(1, 3)) +
                 "\"],[2,1,\"4/3\"],[0,0,\"1/3\"]],\"question\":\"triangles\"}\n");
  // It declines the first question, and ends at the second one.
  const Temporary_file ends("ends.py", R"(
import json, sys
print(json.dumps({"hello": 1, "questions": ["triangles"]}), flush=True)
for asked, line in enumerate(sys.stdin):
    if asked: sys.exit(3)
    print(json.dumps({"ask": json.loads(line)["ask"], "answer": None}), flush=True)
)");
  const std::string words = python(ends.path());
  const auto subject = experiments::subject_command("mine", words, 10s, experiments::require_command(words, 10s));
  const auto running = experiments::triangle_command(subject, 10s)->make();
  for (const Outcome expected : {Outcome::not_asked, Outcome::failed})
    BOOST_TEST((*running)(c, verify::Predicate::triangle_triangle).outcome == expected);
  BOOST_TEST(running->failure().how == "status 3");
}

BOOST_AUTO_TEST_CASE(a_program_that_is_too_slow_is_not_asked_larger_bodies)
{
  const auto running = started(command(), 200ms);
  Object_case large = along(1), slow = along(5);
  large.b = slow.b = shared(verify::torus_knot(640));
  for (int k = 0; k < 3; ++k) {
    BOOST_TEST((*running)(large, Question::surface) != Outcome::not_asked, k);
    BOOST_TEST((*running)(slow, Question::surface) == Outcome::failed, k);
  }
  BOOST_TEST((*running)(slow, Question::surface) == Outcome::failed);
  BOOST_TEST((*running)(large, Question::surface) == Outcome::not_asked);
  BOOST_TEST(running->why_not_asked() == "too slow");
  BOOST_TEST(surface(running, 1) == Outcome::yes);
}

BOOST_AUTO_TEST_CASE(the_lines_tell_triangles_and_rigid_motions)
{
  namespace lines = experiments::subject_lines;
  const std::string cube = lines::model(0, verify::unit_cube());
  const auto count = [](const std::string& text, char c) { return std::ranges::count(text, c); };
  BOOST_TEST(count(cube.substr(cube.find("\"triangles\":")), '[') == 1 + 12);
  const auto turned = lines::rigid_motion(Pose::from_quaternion(0, 0, 0, 1, {1, 2, 3}));
  BOOST_TEST_REQUIRE(turned.has_value());
  const std::array<double, 7> expected = {0, 0, 0, 1, 1, 2, 3};
  BOOST_TEST(*turned == expected, boost::test_tools::per_element());
  BOOST_TEST(!lines::rigid_motion(Pose(std::array<double, 12>{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0})));
  BOOST_TEST(!lines::rigid_motion(Pose(std::array<double, 12>{1, 1e-11, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0})));
  const Pose sheared(std::array<double, 12>{1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  const std::string ask = lines::ask(1, 0, 0, {}, sheared, Question::solid);
  BOOST_TEST((verify::contains(ask, "\"rigid_a\":[1,0,0,0,0,0,0]") && !verify::contains(ask, "rigid_b")), ask);
  BOOST_TEST(lines::batch({"{\"ask\":1}\n", "{\"ask\":2}\n"}) == "{\"asks\":[{\"ask\":1},{\"ask\":2}]}\n");
  const auto replies = lines::read_batch(R"({"answers": [{"ask": 4, "answer": 1}, {"ask": 5, "answer": null}]})", 4, 2);
  BOOST_TEST_REQUIRE(replies.size() == 2u);
  BOOST_TEST((replies[0].outcome == Outcome::yes && replies[1].outcome == Outcome::not_asked));
  BOOST_TEST(!lines::read_batch(R"({"answers": [{"ask": 4, "answer": 1}]})", 4, 2).front().outcome);
}

BOOST_AUTO_TEST_CASE(a_program_that_declines_all_follows_the_protocol)
{
  const std::string said = checked("declines");
  BOOST_TEST(!verify::contains(said, "WRONG"), said);
  BOOST_TEST(verify::contains(said, "declined 30 of 30 questions"), said);
}

BOOST_AUTO_TEST_CASE(the_examples_follow_the_protocol)
{
  // C++ subjects are built where their libraries are installed.
  const auto folder = std::filesystem::path(TETRACONE_PROGRAM).parent_path() / "subjects";
  const auto example = [](const std::string& name, const std::string& words, bool is_there) {
    if (!is_there) {
      BOOST_TEST_MESSAGE("skipped: " << name << " is not in this build, or what it needs is not installed");
      return;
    }
    std::ostringstream out;
    BOOST_TEST(experiments::check_subject(words, 10s, out), name << ":\n" << out.str());
    // Surfaces of the cubes are asked of all.
    const auto running = experiments::subject_command(name, words, 10s).make();
    BOOST_TEST(surface(running, 0.5) == Outcome::yes, name);
    BOOST_TEST(surface(running, 1.5) == Outcome::no, name);
  };
  for (const char* name : {"plain_sat", "embree_rays"})
    example(name, "exec '" + (folder / name).native() + "'", std::filesystem::exists(folder / name));
  // A plug-in tells the time of its function alone.
  const std::string plugged =
      "exec '" + (folder / "plugin_host").native() + "' '" + (folder / "plugin_edges.so").native() + "'";
  example("plugin_edges", plugged, std::filesystem::exists(folder / "plugin_edges.so"));
  if (std::filesystem::exists(folder / "plugin_edges.so")) {
    const auto running = experiments::subject_command("plugin", plugged, 10s).make();
    BOOST_TEST(surface(running, 0.5) == Outcome::yes);
    BOOST_TEST_REQUIRE(running->spent().has_value());
    BOOST_TEST(running->spent()->asking > 0u);
    BOOST_TEST((*running)(along(0.5), Question::solid) == Outcome::not_asked);
    BOOST_TEST((!experiments::require_command("exec '" + (folder / "plugin_host").native() + "' /dev/null", 10s)));
  }
  example("numpy_edges", python(TETRACONE_SOURCE_DIR "/experiments/subjects/numpy_edges.py"),
          std::system("'" TETRACONE_PYTHON "' -c 'import numpy' 2> /dev/null") == 0);
}

BOOST_AUTO_TEST_SUITE_END()
