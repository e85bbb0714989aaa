#include "verify/test/support/program.h"

#include <nlohmann/json.hpp>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_distance_command)

using namespace tetracone::verify;
using Json = nlohmann::ordered_json;

namespace {

const std::string cube_off =
    "OFF\n8 6 0\n0 0 0\n0 0 1\n0 1 0\n0 1 1\n1 0 0\n1 0 1\n1 1 0\n1 1 1\n4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n"
    "4 0 2 6 4\n4 1 5 7 3\n";
const std::string poses =
    "1 0 0 1.5 0 1 0 2.25 0 0 1 0.25\n3/5 -4/5 0 3 4/5 3/5 0 1/3 0 0 1 5\n1 0 0 1 0 1 0 0 0 0 1 0\n"
    "0.25 0 0 0.5 0 0.25 0 0.5 0 0 0.25 0.5\n1 0.5 0 3 0 1 0.1 4 0 0 2 0\n";

struct Files {
  Temporary_file cube{"cube.off", cube_off}, poses_b{"poses", poses};
  std::string words() const
  {
    return "distance " + in_quotes(cube.path()) + " " + in_quotes(cube.path()) + " --pose-b " +
           in_quotes(poses_b.path());
  }
};

/// Returns the checker's exit status for a certificate about the files.
int checked(const Files& files, const Json& certificate)
{
  const Temporary_file file("certificate.json", certificate.dump());
  const std::string command = "/usr/bin/python3 -B '" TETRACONE_SOURCE_DIR "/experiments/certificates/check.py' " +
                              in_quotes(file.path()) + " " + in_quotes(files.cube.path()) + " " +
                              in_quotes(files.cube.path()) + " >/dev/null 2>&1";
  return std::system(command.c_str());
}

Json certificate_of(const Files& files, const std::string& question)
{
  const Temporary_file file("certificate", "");
  const Run r = run(files.words() + " --question " + question + " --certificate " + in_quotes(file.path()));
  BOOST_TEST(r.status == 0, r.error);
  return Json::parse(contents(file.path()));
}

}  // namespace

BOOST_AUTO_TEST_CASE(distances_are_told_rounded_exactly_and_as_limits)
{
  const Files files;
  // One cube is in the other: the surfaces are apart, the solids, which are asked unless it is said otherwise, are not.
  const std::string surface = " --question surface";
  BOOST_TEST(run(files.words() + surface).out == "1.346291201783626\n4.17612260356422\n0\n0.25\n3.605551275463989\n");
  BOOST_TEST(run(files.words()).out == "1.346291201783626\n4.17612260356422\n0\n0\n3.605551275463989\n");
  BOOST_TEST(run(files.words() + " --within 1/4" + surface).out == "0\n0\n1\n1\n0\n");
  BOOST_TEST(run(files.words() + " --within 1/5").out == "0\n0\n1\n1\n0\n");
  BOOST_TEST(run(files.words() + " --within 1/5" + surface).out == "0\n0\n1\n0\n0\n");
  BOOST_TEST(
      run(files.words() + " --exact")
          .out.starts_with(
              "29/16  1 1 1/4 edge 6 7  3/2 9/4 1/4 vertex 0\n436/25  1 14/15 1 edge 7 5  11/5 14/15 5 vertex 2\n"));
  for (const char* kernel : {"double", "rational"})
    BOOST_TEST(run(files.words() + " --kernel " + kernel).out.starts_with("1.346291201783626\n4.17612260356422\n0\n"));
}

BOOST_AUTO_TEST_CASE(the_table_says_what_its_column_is)
{
  const Files files;
  const std::string csv = files.words() + " --question surface --csv /dev/stdout";
  BOOST_TEST(run(csv).out.starts_with("pose,distance\n0,1.346291201783626\n"));
  BOOST_TEST(run(csv + " --within 1/4").out == "pose,within\n0,0\n1,0\n2,1\n3,1\n4,0\n");
  BOOST_TEST(run(csv + " --within 1/4 --time")
                 .out.starts_with("pose,within,ns,bounding_tests,primitive_tests,exact_fallbacks\n0,0,"));
}

BOOST_AUTO_TEST_CASE(holders_are_faces_of_the_file)
{
  // Face 0 becomes two triangles.
  const Temporary_file a("saddle.off",
                         "OFF\n7 2 0\n0 -1 0\n2 0 1\n0 1 0\n-2 0 1\n0 0 9\n8 0 9\n0 8 9\n4 0 1 2 3\n3 4 5 6\n"),
      b("b.off", "OFF\n3 1 0\n1 1 10\n1 2 12\n2 1 12\n3 0 1 2\n"), start("start", "1 0 0 0 0 1 0 0 0 0 1 0\n"),
      end("end", "1 0 0 0 0 1 0 0 0 0 1 -2\n");
  const std::string bodies = in_quotes(a.path()) + " " + in_quotes(b.path()) + " --question surface ";
  BOOST_TEST(run("distance " + bodies + "--exact").out == "1  1 1 9 face 1  1 1 10 vertex 0\n");
  BOOST_TEST(run("motion " + bodies + "--features --pose-a0 " + in_quotes(start.path()) + " --pose-a1 " +
                 in_quotes(start.path()) + " --pose-b0 " + in_quotes(start.path()) + " --pose-b1 " +
                 in_quotes(end.path()))
                 .out == "1 0.5 0.5  face 1  vertex 0\n");
}

BOOST_AUTO_TEST_CASE(a_distance_beyond_the_largest_double_is_rounded_as_ieee_754_does)
{
  const std::string largest = "1.7976931348623157e308";
  const Temporary_file a("a.off",
                         "OFF\n3 1 0\n" + largest + " -1 -1\n" + largest + " 3 -1\n" + largest + " -1 3\n3 0 1 2\n");
  // 2^969, 2^970: with the largest double below half a step, and half a step.
  for (const auto& [x, expected] :
       {std::pair<std::string, std::string>{"-4.9896007738368e291", "1.7976931348623157e+308\n"},
        {"-9.9792015476736e291", "inf\n"}}) {
    const Temporary_file b("b.off", "OFF\n3 1 0\n" + x + " -1 -1\n" + x + " 3 -1\n" + x + " -1 3\n3 0 1 2\n");
    BOOST_TEST(
        run("distance " + in_quotes(a.path()) + " " + in_quotes(b.path()) + " --question surface").out == expected, x);
  }
}

BOOST_AUTO_TEST_CASE(nearest_points_are_the_doubles_nearest_to_the_exact_ones)
{
  const Files files;
  BOOST_TEST(run(files.words() + " --points")
                 .out.starts_with("1.346291201783626  1 1 0.25  1.5 2.25 0.25\n"
                                  "4.17612260356422  1 0.9333333333333333 1  2.2 "
                                  "0.9333333333333333 5\n0  "));
  const Temporary_file csv("points.csv", "");
  BOOST_TEST(run(files.words() + " --points --csv " + in_quotes(csv.path())).status == 0);
  BOOST_TEST(contents(csv.path())
                 .starts_with("pose,distance,x0,y0,z0,x1,y1,z1\n0,1.346291201783626,1,1,0.25,1.5,2.25,0.25\n"));
}

BOOST_AUTO_TEST_CASE(an_open_surface_is_told_the_question_that_it_has)
{
  const Files files;
  const Temporary_file open("open.off", "OFF\n3 1 0\n0 0 3\n1 0 3\n0 1 3\n3 0 1 2\n");
  const std::string words = "distance " + in_quotes(files.cube.path()) + " " + in_quotes(open.path());
  for (const char* also : {"", " --within 1", " --exact", " --points"})
    check_refused(words + also, "an open surface has no solid");
  check_refused(words, "expected a closed polyhedron, or --question surface");
  BOOST_TEST(run(words + " --question surface").out == "2\n");
}

BOOST_AUTO_TEST_CASE(bad_use_is_refused)
{
  const Files files;
  for (const char* words : {"--within nan", "--within x", "--kernel epick", "--question both", "--time", "--repeat 0",
                            "--exact --within 1", "--exact --kernel double", "--certificate /tmp/x --kernel double",
                            "--points --exact", "--points --within 1", "--points --kernel double"})
    check_refused(files.words() + " " + words, "expected");
}

BOOST_AUTO_TEST_CASE(a_certificate_is_proved_and_a_spoiled_one_refused)
{
  const Files files;
  for (const std::string question : {"surface", "solid"}) {
    const Json good = certificate_of(files, question);
    BOOST_TEST(checked(files, good) == 0);
    const std::vector<std::pair<std::string, std::function<void(Json&)>>> ways = {
        {"square", [](Json& c) { c["answers"][0]["answer"] = "29/15"; }},
        {"greater square", [](Json& c) { c["answers"][4]["answer"] = "14"; }},
        {"point", [](Json& c) { c["answers"][0]["witness"]["points"][0][2] = "1/3"; }},
        {"face", [](Json& c) { c["answers"][0]["witness"]["faces"][0] = 0; }},
        {"pose", [](Json& c) { c["answers"][0]["pose_b"][3] = "2"; }},
        {"pose of a", [](Json& c) { c["answers"][0]["pose_a"][3] = "-1"; }},
        {"flat pose", [](Json& c) { c["answers"][0]["pose_b"][10] = "0"; }},
        {"file", [](Json& c) { c["bodies"][0]["sha256"] = std::string(64, '0'); }},
        {"no cover", [](Json& c) { c["answers"][0].erase("cover"); }},
        {"question", [](Json& c) { c["answers"][0]["question"] = "other"; }},
        {"answers", [](Json& c) { c["answers"] = Json::array(); }}};
    for (const auto& [what, spoil] : ways) {
      Json bad = good;
      spoil(bad);
      BOOST_TEST(checked(files, bad) != 0, question << ": " << what);
    }
  }
  // A proof for the surfaces need not hold for the solids: one cube is in the other.
  Json inside = certificate_of(files, "surface");
  for (Json& answer : inside["answers"]) answer["question"] = "solid";
  BOOST_TEST(checked(files, inside) != 0);
}

BOOST_AUTO_TEST_SUITE_END()
