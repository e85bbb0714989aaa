// Case files: what is written reads back as it was, and what is no case is refused in one line.

#include "verify/cases/case_file.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/cases/shape_generators.h"
#include "verify/test/support/temporary_file.h"
#include "verify/test/verify/same_body.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>

BOOST_AUTO_TEST_SUITE(test_case_file)

using namespace tetracone;
using kernel::Pose;
using kernel::Question;
using kernel::Rational;
using verify::Case_file;
using verify::Case_kind;
using verify::same;

namespace {

/// Every bit, the sign of zero too.
bool same(const kernel::Vertex& a, const kernel::Vertex& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool same(const verify::Origin& a, const verify::Origin& b)
{
  return a.family == b.family && a.seed == b.seed && a.index == b.index && a.parameter == b.parameter;
}

Case_file object_file()
{
  Case_file file;
  file.level = Case_kind::object;
  file.object.emplace();
  file.object->a = std::make_shared<covering::Polyhedron>(verify::unit_cube());
  file.object->b = std::make_shared<covering::Polyhedron>(verify::prism_with_tunnel());
  file.object->origin = {"stacked", 18446744073709551615u, 3, -2};
  file.question = Question::solid;
  file.truth = 1;
  file.object->solid = true;
  file.object->surface = false;
  file.wrong = {{"double tree", 0}, {"float brute", std::nullopt}};
  file.cause = "a quotation mark \" and a backslash \\";
  file.version = "0.1.0";
  return file;
}

Case_file predicate_file()
{
  Case_file file;
  file.level = Case_kind::predicate;
  file.predicate = verify::Predicate::orientation;
  file.points.emplace();
  file.points->v = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  file.points->p = {0.1, -0.0, 0x1p-1074};
  file.points->q = {std::numeric_limits<double>::max(), 0x1.fffffffffffffp-1, -0x1p-1022};
  file.points->r = {123456789012345680.0, 1e22, 5e-324};
  file.points->origin = {"near-parallel-edges", 1, 2, std::numeric_limits<double>::infinity()};
  file.truth = -1;
  file.wrong = {{"double", 1}};
  return file;
}

Case_file again(const Case_file& file) { return verify::parse_case(verify::to_json(file), "again"); }

void check_poses(const Pose& pose)
{
  Case_file file = predicate_file();
  file.points->pose_b = pose;
  BOOST_TEST((again(file).points->pose_b == pose));
}

/// `text` with its first `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, from);
  return text.replace(at, from.size(), to);
}

/// Refused, in one line that names file and line and says `what`.
void check_refused(const std::string& text, std::size_t line, const std::string& what)
{
  try {
    verify::parse_case(text, "x.case.json");
    BOOST_ERROR("accepted, expected: " + what);
  } catch (const covering::Input_error& error) {
    const std::string message = error.what();
    BOOST_TEST(message.starts_with("x.case.json:" + std::to_string(line) + ": "), message << " at line " << line);
    BOOST_TEST(message.find(what) != std::string::npos, message << " says: " << what);
    BOOST_TEST(message.find("; expected") != std::string::npos, message);
    BOOST_TEST(message.find('\n') == std::string::npos, message);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_object_case_with_holes_reads_back_as_it_was)
{
  const Case_file file = object_file(), read = again(file);
  BOOST_TEST(same(*read.object->a, *file.object->a));
  BOOST_TEST(same(*read.object->b, *file.object->b));
  BOOST_TEST(read.object->b->loop_count(0) + read.object->b->loop_count(1) > 2u, "the tunnel's ends have holes");
  BOOST_TEST((read.object->pose_a == file.object->pose_a));
  BOOST_TEST(same(read.origin(), file.origin()));
  BOOST_TEST((read.level == Case_kind::object));
  BOOST_TEST((read.question == Question::solid));
  BOOST_TEST(read.truth == 1);
  BOOST_TEST((read.object->surface == false));
  BOOST_TEST((read.object->solid == true));
  BOOST_TEST((read.wrong == file.wrong));
  BOOST_TEST(read.cause == file.cause);
  BOOST_TEST(read.version == file.version);
  BOOST_TEST(verify::to_json(read) == verify::to_json(file));
}

BOOST_AUTO_TEST_CASE(a_predicate_case_keeps_denormals_the_largest_double_and_the_sign_of_zero)
{
  const Case_file file = predicate_file(), read = again(file);
  for (int k = 0; k < 4; ++k) BOOST_TEST(same(read.points->v[k], file.points->v[k]));
  BOOST_TEST(same(read.points->p, file.points->p));
  BOOST_TEST(same(read.points->q, file.points->q));
  BOOST_TEST(same(read.points->r, file.points->r));
  BOOST_TEST((read.predicate == verify::Predicate::orientation));
  BOOST_TEST(read.truth == -1);
  BOOST_TEST(same(read.origin(), file.origin()));
  BOOST_TEST(verify::to_json(read) == verify::to_json(file));
}

BOOST_AUTO_TEST_CASE(poses_of_doubles_and_of_fractions_read_back_exactly)
{
  check_poses(Pose::translation(0.1, 1e300, -0x1p-1074));
  check_poses(Pose::from_quaternion(1, 2, 3, 4));
  check_poses(Pose::from_quaternion(3, 1, 0, 0, {Rational(1) / 3, Rational(-7) / 9, Rational(1000000007)}));
  // An integer that is no double.
  std::array<Rational, 12> entries = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  entries[3] = Rational("9007199254740993");
  check_poses(Pose(entries));
}

BOOST_AUTO_TEST_CASE(every_predicate_and_question_has_a_name_that_reads_back)
{
  for (const verify::Predicate predicate : verify::all_predicates) {
    Case_file file = predicate_file();
    file.predicate = predicate;
    file.truth = 1;
    BOOST_TEST((again(file).predicate == predicate));
  }
  Case_file file = object_file();
  file.question = Question::surface;
  file.truth = 0;
  BOOST_TEST((again(file).question == Question::surface));
}

BOOST_AUTO_TEST_CASE(an_open_surface_is_a_case_of_the_surface_question)
{
  Case_file file = object_file();
  covering::Polyhedron triangle;
  triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.add_polygon({0, 1, 2});
  file.object->a = std::make_shared<covering::Polyhedron>(triangle);
  file.object->solid.reset();
  file.question = Question::surface;
  BOOST_TEST(again(file).object->a->face_count() == 1u);
  BOOST_TEST(!again(file).object->solid.has_value());
  file.object->solid = true;
  check_refused(verify::to_json(file), 12, "/a is open");
}

BOOST_AUTO_TEST_CASE(fractions_may_stand_for_coordinates_that_are_doubles)
{
  const std::string text = verify::to_json(predicate_file());
  BOOST_TEST(verify::parse_case(with(text, "[1, 0, 0]", "[\"3/4\", 0, 0]"), "").points->v[1][0] == 0.75);
  check_refused(with(text, "[1, 0, 0]", "[\"1/3\", 0, 0]"), 14, "/points/v1/0 is no double");
}

BOOST_AUTO_TEST_CASE(a_case_for_a_small_body_is_a_page)
{
  const std::string text = verify::to_json(object_file());
  BOOST_TEST(std::count(text.begin(), text.end(), '\n') < 80);
  BOOST_TEST(text.find("      [0, 0, 0],\n      [1, 0, 0],\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_no_json_is_refused_at_its_line)
{
  check_refused("", 1, "is not JSON");
  check_refused("{\n\"format\": 1,\n", 3, "is not JSON");
  check_refused("{\n  \"format\": 1,\n  nan\n}", 3, "is not JSON");
  check_refused(std::string(100000, '['), 1, "is not JSON");
  check_refused("[1]", 1, "the file is no object");
  check_refused("{}", 1, "the file has no 'format'");
  std::string text = verify::to_json(object_file());
  check_refused(with(text, "[0, 0, 0],", "[0, NaN, 0],"), 14, "is not JSON");
  check_refused(with(text, "[0, 0, 0],", "[0, 1e400, 0],"), 14, "'1e400' is beyond the largest double");
  text.resize(text.size() / 2);
  check_refused(text, 1 + std::size_t(std::count(text.begin(), text.end(), '\n')), "is not JSON");
}

BOOST_AUTO_TEST_CASE(malformed_object_cases_are_refused_at_their_line)
{
  const std::string text = verify::to_json(object_file());
  check_refused(with(text, "\"format\": 1", "\"format\": 2"), 2, "/format is unknown; expected 1");
  check_refused(with(text, "\"version\": \"0.1.0\"", "\"version\": 0.1"), 3, "/version is no string");
  check_refused(with(text, "\"object\"", "\"scene\""), 4, "/level is unknown; expected one of predicate, object");
  check_refused(with(text, "\"cause\"", "\"reason\""), 1, "the file has no 'cause'");
  check_refused(with(text, "\"seed\": 18446744073709551615", "\"seed\": -1"), 6, "/origin/seed is no such integer");
  check_refused(with(text, "\"question\": \"solid\"", "\"question\": \"both\""), 7,
                "/question is unknown; expected one of solid, surface");
  check_refused(with(text, ", \"solid\": 1}", "}"), 8, "/truth has no 'solid'");
  check_refused(with(text, "\"solid\": 1}", "\"solid\": 2}"), 8,
                "/truth/solid is no such integer; expected one from 0 to 1");
  check_refused(with(text, "\"answer\": 0", "\"answer\": \"maybe\""), 10, "/wrong/0/answer is unknown");
  check_refused(with(text, "\"answer\": 0", "\"answer\": 0, \"why\": 1"), 10, "/wrong/0/why is unknown here");
  check_refused(with(text, "\"vertices\"", "\"points\""), 13, "/a/points is unknown here");
  check_refused(with(text, "[0, 0, 0],", "[0, 0],"), 14, "/a/vertices/0 has 2 elements");
  check_refused(with(text, "[0, 0, 0],", "[0, \"x\", 0],"), 14, "/a/vertices/0/1 is no finite number");
  check_refused(with(text, "[0, 0, 0],", "[0, \"1/0\", 0],"), 14, "/a/vertices/0/1 is no finite number");
  check_refused(with(text, "[0, 0, 0],", "[0, \"1" + std::string(400, '0') + "/1\", 0],"), 14,
                "/a/vertices/0/1 is no finite number");
  check_refused(with(text, "[0, 0, 0],", "[0, null, 0],"), 14, "/a/vertices/0/1 is no finite number");
  check_refused(with(text, "[0, 0, 0],", "[0, 0.25, 0],"), 26, "/a/faces/2 is not exactly planar");
  check_refused(with(text, "[[0, ", "[[8, "), 26, "/a/faces/2/0/0 is vertex 8; expected one of 8 vertices");
  check_refused(with(text, "[[0, ", "[[-1, "), 26, "/a/faces/2/0/0 is no such integer");
  check_refused(with(text, "[[0, ", "[[0.5, "), 26, "/a/faces/2/0/0 is no such integer");
  check_refused(with(text, "[[0, ", "[[], [0, "), 26, "/a/faces/2/0 has 0 elements");
  check_refused(with(text, "    [0, 1, 0, 0],\n", ""), 32, "/pose_a has 2 elements; expected 3");
  check_refused(with(text, "    [0, 1, 0, 0],\n", "    [0, 1, 0],\n"), 34, "/pose_a/1 has 3 elements");
  check_refused(with(text, "    [0, 1, 0, 0],\n", "    [2, 0, 0, 0],\n"), 32,
                "/pose_a has a 3x3 part of determinant 0");
}

BOOST_AUTO_TEST_CASE(malformed_predicate_cases_are_refused_at_their_line)
{
  const std::string text = verify::to_json(predicate_file());
  check_refused(with(text, "\"orientation\"", "\"volume\""), 7,
                "/predicate is unknown; expected one of orientation, tetra-cone");
  check_refused(with(text, "\"orientation\"", "\"tetra-cone\""), 8,
                "/truth is no such integer; expected one from 0 to 1");
  check_refused(with(text, "\"v2\"", "\"v4\""), 15, "/points/v4 is unknown here");
  check_refused(with(text, "\"predicate\": \"orientation\",\n", ""), 1, "the file has no 'predicate'");
  check_refused(with(text, "\"truth\": -1", "\"truth\": {}"), 8, "/truth is no such integer");
}

BOOST_AUTO_TEST_CASE(a_face_left_out_is_an_open_surface)
{
  const std::string text = verify::to_json(object_file());
  const std::size_t begin = text.find("      [[0, "), end = text.find('\n', begin) + 1;
  check_refused(std::string(text).erase(begin, end - begin), 12, "/a is open: it has no solid");
}

BOOST_AUTO_TEST_CASE(files_are_read_by_name)
{
  const verify::Temporary_file file("one.case.json", verify::to_json(object_file()));
  BOOST_TEST(verify::is_case_name(file.path()));
  BOOST_TEST(!verify::is_case_name("one.off"));
  BOOST_TEST(same(*verify::read_case(file.path()).object->a, verify::unit_cube()));
  BOOST_CHECK_THROW(verify::read_case("no/such/file.case.json"), covering::Input_error);
  BOOST_CHECK_THROW(verify::read_case("/"), covering::Input_error);
}

BOOST_AUTO_TEST_SUITE_END()
