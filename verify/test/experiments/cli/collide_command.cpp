// Runs the program itself: the answers of several kernels side by side, and poses of long fractions.

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_collide_command)

using namespace tetracone::verify;

namespace {

/// Unit cubes that touch, then by less apart than a float can say, then far apart.
const std::string poses =
    "1 0 0 1 0 1 0 0 0 0 1 0\n"
    "1 0 0 1.0000000001 0 1 0 0 0 0 1 0\n"
    "1 0 0 3 0 1 0 0 0 0 1 0\n";

}  // namespace

BOOST_AUTO_TEST_CASE(kernels_compared_answer_side_by_side)
{
  const Temporary_file file("poses.txt", poses), csv("compared.csv", "");
  const std::string words = "collide " + cube + " " + cube + " --pose-b " + in_quotes(file.path());
  const std::string compared = words + " --compare float,rational";
  BOOST_TEST(run(compared).out == "1 1 1\n0 1 0\n0 0 0\n");
  BOOST_TEST(run(words + " --kernel float --compare adaptive").out == "1 1\n1 0\n0 0\n");
  BOOST_TEST(run(compared + " --csv /dev/stdout").out == "pose,adaptive,float,rational\n0,1,1,1\n1,0,1,0\n2,0,0,0\n");
  const auto json = nlohmann::json::parse(run(compared + " --json").out);
  BOOST_TEST(json.size() == 3u);
  BOOST_TEST((json[1] == nlohmann::json{{"pose", 1}, {"answers", {{"adaptive", 0}, {"float", 1}, {"rational", 0}}}}));
  check_refused(words + " --compare float,foo", "expected adaptive");
  check_refused(words + " --compare float,float", "each kernel once");
  check_refused(words + " --compare adaptive", "each kernel once");
  check_refused(compared + " --features", "without --time and --features");
  check_refused(compared + " --time --json", "without --time and --features");
}

BOOST_AUTO_TEST_CASE(what_the_first_query_makes_is_told_beside_the_table)
{
  const Temporary_file file("poses.txt", poses);
  const std::string words =
      "collide " + cube + " " + cube + " --pose-b " + in_quotes(file.path()) + " --csv /dev/stdout";
  const Run timed = run(words + " --time --repeat 2");
  BOOST_TEST(timed.out.starts_with("pose,answer,ns,bounding_tests,primitive_tests,exact_fallbacks\n0,1,"), timed.out);
  BOOST_TEST(timed.error.starts_with("first query: "), timed.error);
  BOOST_TEST(contains(timed.error, "of it trees "), timed.error);
  BOOST_TEST(run(words).error.empty());
}

BOOST_AUTO_TEST_CASE(contacts_are_rows_fractions_polygons_and_curves)
{
  // The cube on itself, moved along x: so its right half, and then its side.
  const Temporary_file overlapping("poses.txt", "1 0 0 1/3 0 1 0 1/3 0 0 1 1/3\n"),
      touching("touching.txt", "1 0 0 1 0 1 0 0.5 0 0 1 0\n");
  const std::string words = "collide " + cube + " " + cube + " --contacts --pose-b ";
  const Run rows = run(words + in_quotes(overlapping.path()) + " --exact --csv /dev/stdout");
  BOOST_TEST(rows.out.starts_with("pose,face_a,face_b,kind,x0,y0,z0,x1,y1,z1\n0,"), rows.out);
  BOOST_TEST(contains(rows.out, ",segment,"), rows.out);
  BOOST_TEST(contains(rows.out, "1/3"), rows.out);
  BOOST_TEST(!contains(rows.out, "0.3"), rows.out);
  const Run polygons = run(words + in_quotes(touching.path()) + " --json");
  BOOST_TEST(contains(polygons.out, "\"kind\": \"coplanar\""), polygons.out);
  // B's left side lies on A's right one.
  const std::string normals = run(words + in_quotes(touching.path()) + " --normals --csv /dev/stdout").out;
  BOOST_TEST(normals.starts_with("pose,face_a,face_b,kind,x0,y0,z0,x1,y1,z1,ax,ay,az,bx,by,bz\n0,"), normals);
  BOOST_TEST(contains(normals, ",coplanar,,,,,,,1,0,0,-1,0,0\n"), normals);
  BOOST_TEST(contains(run(words + in_quotes(touching.path()) + " --normals --json").out, "\"normals\""));
  const Temporary_file curves("curves.obj", "");
  BOOST_TEST(run(words + in_quotes(overlapping.path()) + " --curves " + in_quotes(curves.path())).status == 0);
  const std::string text = contents(curves.path());
  BOOST_TEST(text.starts_with("v "), text);
  BOOST_TEST(contains(text, "\nl 1 2 "), text);

  check_refused("collide " + cube + " " + cube + " --contacts --kernel float", "an exact kernel");
  check_refused("collide " + cube + " " + cube + " --exact", "expected with --contacts");
  check_refused("collide " + cube + " " + cube + " --normals", "expected with --contacts");
  check_refused("collide " + cube + " " + cube + " --contacts --curves out.txt", "*.obj or *.ply");
  check_refused("collide " + cube + " " + cube + " --contacts --csv ./x.obj --curves x.obj", "another file");
}

BOOST_AUTO_TEST_CASE(relations_say_how_bodies_stand)
{
  const Temporary_file file("poses.txt",
                            "0.25 0 0 0.25 0 0.25 0 0.25 0 0 0.25 0.25\n"
                            "1 0 0 0.5 0 1 0 0 0 0 1 0\n"
                            "1 0 0 3 0 1 0 0 0 0 1 0\n"
                            "9 0 0 -4 0 9 0 -4 0 0 9 -4\n");
  const std::string words = "collide " + cube + " " + cube + " --pose-b " + in_quotes(file.path()) + " --relation";
  BOOST_TEST(run(words).out == "b_in_a\nsurfaces\napart\na_in_b\n");
  BOOST_TEST(run(words + " --kernel rational --method brute").out == "b_in_a\nsurfaces\napart\na_in_b\n");
  check_refused(words + " --question surface", "expected with --question solid");
}

BOOST_AUTO_TEST_CASE(fractions_of_a_hundred_thousand_digits_are_read_in_seconds)
{
  // x = 1 + 10^-100000 in both rows of one pose: an exactly known gap that no double holds.
  const std::string n = "1" + std::string(99999, '0') + "1", d = "1" + std::string(100000, '0');
  const Temporary_file file("long.txt", "1 0 0 " + n + "/" + d + " 0 1 0 0 0 0 1 0\n");
  const auto start = std::chrono::steady_clock::now();
  const Run r = run("collide " + cube + " " + cube + " --pose-b " + in_quotes(file.path()));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  BOOST_TEST(r.out == "0\n", r.error);
  BOOST_TEST(seconds < 20);
}

BOOST_AUTO_TEST_CASE(a_name_that_comes_twice_in_a_case_file_is_refused)
{
  const Temporary_file file(
      "twice.case.json",
      "{\"format\": 1,\n \"level\": \"object\",\n \"a\": {\"x\": [{\"y\": 1}, {\"y\": 2}],\n  \"\\u0078\": 2}}\n");
  check_refused("collide " + in_quotes(file.path()),
                ":4: '\\u0078' a second time; expected each name of an object once");
}

BOOST_AUTO_TEST_CASE(contacts_beyond_the_largest_double_are_rounded_as_ieee_754_does)
{
  const std::string largest = "1.7976931348623157e308";
  const Temporary_file a("a.off", "OFF\n3 1 0\n" + largest + " -1 0\n" + largest + " 1 0\n1e308 0 0\n3 0 1 2\n"),
      b("b.off", "OFF\n3 1 0\n" + largest + " 0 -1\n" + largest + " 0 1\n1e308 5 0\n3 0 1 2\n");
  // 2^969, 2^970: with the largest double below half a step, and half a step.
  for (const auto& [x, expected] :
       {std::pair<std::string, std::string>{"4.9896007738368e291", "1.7976931348623157e+308"},
        {"9.9792015476736e291", "inf"}}) {
    const Temporary_file pose("pose", "1 0 0 " + x + " 0 1 0 0 0 0 1 0\n");
    const std::string words = "collide " + in_quotes(a.path()) + " " + in_quotes(b.path()) + " --contacts --pose-a " +
                              in_quotes(pose.path()) + " --pose-b " + in_quotes(pose.path());
    BOOST_TEST(run(words).out.ends_with(" " + expected + " 0 0\n"), x);
    if (expected != "inf") continue;
    BOOST_TEST(contains(run(words + " --json").out, "\"inf\""));
    check_refused(words + " --curves curves.obj", "expected --contacts without --curves");
  }
}

BOOST_AUTO_TEST_CASE(contacts_of_a_face_that_is_not_planar_are_all_told_once)
{
  // A saddle over its short diagonal from vertex 0 to 2, z = abs(x) / 2, and faces that meet it. They cut both of its
  // triangles, or touch the diagonal along it and in a point.
  const Temporary_file saddle("saddle.off", "OFF\n4 1 0\n0 -1 0\n2 0 1\n0 1 0\n-2 0 1\n4 0 1 2 3\n");
  for (const auto& [vertices, expected] :
       {std::pair<std::string, std::string>{
            "-9 -9 0.25\n9 -9 0.25\n0 20 0.25\n",
            "0 0 0 segment -0.5 -0.75 0.25 -0.5 0.75 0.25\n0 0 0 segment 0.5 0.75 0.25 0.5 -0.75 0.25\n"},
        {"0 -9 -9\n0 9 -9\n0 0 20\n", "0 0 0 segment 0 1 0 0 -1 0\n"},
        {"0 0 0\n1 0 -5\n-1 0 -5\n", "0 0 0 point 0 0 0 0 0 0\n"}}) {
    const Temporary_file other("other.off", "OFF\n3 1 0\n" + vertices + "3 0 1 2\n");
    std::string lines = run("collide " + in_quotes(saddle.path()) + " " + in_quotes(other.path()) + " --contacts").out;
    std::vector<std::string> sorted;
    for (std::size_t begin = 0, end; (end = lines.find('\n', begin)) != std::string::npos; begin = end + 1)
      sorted.push_back(lines.substr(begin, end - begin + 1));
    std::sort(sorted.begin(), sorted.end());
    std::string text;
    for (const std::string& line : sorted) text += line;
    BOOST_TEST(text == expected, vertices);
  }
}

BOOST_AUTO_TEST_CASE(a_case_is_replayed_through_somebody_elses_program)
{
  // Says no; declines what is turned; dies where B is moved by more than 2.
  const Temporary_file script("mine.py", R"(
import json, sys
for line in sys.stdin:
    m = json.loads(line)
    if "ask" not in m: continue
    if isinstance(m["pose_b"][3], (int, float)) and m["pose_b"][3] > 2:
        print("first", file=sys.stderr)
        print("the pose is too far", file=sys.stderr)
        sys.exit(7)
    print(json.dumps({"ask": m["ask"], "answer": None if m["pose_b"][1] else 0}), flush=True)
)");
  const std::string command = " --subject-command 'mine=" TETRACONE_PYTHON " " + script.path().native() + "'";
  const std::string file = source + "/verify/corpus/double-false-negative-pose-vertex-vertex.case.json";
  const Run own = run("collide " + file), replayed = run("collide " + file + command);
  BOOST_TEST(own.out == "1\n");
  BOOST_TEST(replayed.status == 0, replayed.error);
  BOOST_TEST((replayed.out == "1 0\n" || replayed.out == "1 -\n"), replayed.out);
  const Temporary_file file_b("poses.txt", poses + "0 -1 0 0 1 0 0 0 0 0 1 0\n");
  const std::string words = "collide " + cube + " " + cube + " --pose-b " + in_quotes(file_b.path());
  const Run many = run(words + " --compare float" + command);
  BOOST_TEST(many.out == "1 1 0\n0 1 0\n0 0 failed\n1 1 -\n");
  BOOST_TEST(many.status == 1);
  BOOST_TEST(many.error == "mine failed on pose 2, status 7: the pose is too far\n");
  const Run table = run(words + command + " --csv /dev/stdout");
  BOOST_TEST(table.out == "pose,adaptive,mine\n0,1,0\n1,0,0\n2,0,failed\n3,1,-\n");
  const auto json = nlohmann::json::parse(run(words + command + " --json").out);
  BOOST_TEST(json[2]["answers"]["mine"].is_null());
  BOOST_TEST(json[0]["answers"]["mine"] == 0);
  for (const char* also : {" --features", " --contacts", " --relation", " --time --json"})
    check_refused(words + command + also, "--subject-command");
  check_refused("collide " + source + "/verify/corpus/double-false-negative-orientation.case.json" + command,
                "asks a predicate");
  check_refused(words + " --subject-command mine=/nowhere/program", "expected a program that the shell can run");
}

BOOST_AUTO_TEST_SUITE_END()
