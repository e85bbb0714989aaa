// Cases with known answers from the tests of CGAL, FCL and Coal, of the folder of real data (not part of the project).

#include "verify/test/support/data_folder.h"
#include "verify/test/support/object_cases.h"
#include "verify/test/support/rationals.h"
#include "verify/truth/cgal_truth.h"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_other_libraries)

using namespace tetracone::verify;
using tetracone::kernel::Contact;
using tetracone::kernel::parse_double;
using tetracone::kernel::parse_fraction;
using namespace tetracone::verify::scenes;

namespace {

using Tree = boost::property_tree::ptree;

Tree read_cases(const std::string& file)
{
  Tree tree;
  boost::property_tree::read_json((data_folder() / "cases" / file).string(), tree);
  return tree.get_child("cases");
}

Rational number(const Tree& tree)
{
  const std::string text = tree.data();
  if (const auto fraction = parse_fraction(text)) return *fraction;
  return Rational(parse_double(text).value());
}
std::vector<Rational> numbers(const Tree& tree)
{
  std::vector<Rational> numbers;
  for (const auto& [key, child] : tree) numbers.push_back(number(child));
  return numbers;
}
Pose pose(const Tree& tree)
{
  const std::vector<Rational> entries = numbers(tree);
  BOOST_TEST_REQUIRE(entries.size() == 12u);
  std::array<Rational, 12> matrix;
  std::copy(entries.begin(), entries.end(), matrix.begin());
  return Pose(matrix);
}
Polyhedron model(const Tree& tree)
{
  if (const auto size = tree.get_child_optional("box")) {
    Vertex half;
    for (int k = 0; k < 3; ++k) half[k] = CGAL::to_double(numbers(*size)[k]) / 2;
    return triangulated(box({-half[0], -half[1], -half[2]}, half));
  }
  Polyhedron polyhedron;
  for (const auto& [key, vertex] : tree.get_child("vertices")) {
    const auto x = numbers(vertex);
    polyhedron.vertices.push_back({CGAL::to_double(x[0]), CGAL::to_double(x[1]), CGAL::to_double(x[2])});
  }
  for (const auto& [key, face] : tree.get_child("faces")) {
    std::vector<Index> loop;
    for (const auto& [name, corner] : face) loop.push_back(corner.get_value<Index>());
    polyhedron.add_polygon(loop);
  }
  return triangulated(polyhedron);
}

}  // namespace

BOOST_AUTO_TEST_CASE(triangles_of_the_tests_of_cgal)
{
  if (without_data()) return;
  const Tree cases = read_cases("tri_tri_cgal.json");
  // A triangle with rational corners is an exact image of this one.
  const Brute_body body(polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  const auto placed = [](const Tree& tree) {
    std::vector<rationals::Vector> p;
    for (const auto& [key, child] : tree) p.push_back({numbers(child)[0], numbers(child)[1], numbers(child)[2]});
    const auto u = rationals::minus(p[1], p[0]), v = rationals::minus(p[2], p[0]), w = rationals::outer(u, v);
    std::array<Rational, 12> entries;
    for (int i = 0; i < 3; ++i) {
      entries[4 * i] = u[i];
      entries[4 * i + 1] = v[i];
      entries[4 * i + 2] = w[i];
      entries[4 * i + 3] = p[0][i];
    }
    return Pose(entries);
  };
  int count = 0;
  for (const auto& [key, test] : cases) {
    ++count;
    BOOST_TEST_INFO_SCOPE(test.get<std::string>("id") << ": " << test.get<std::string>("what"));
    const Pose t1 = placed(test.get_child("t1")), t2 = placed(test.get_child("t2"));
    const bool expected = test.get<bool>("do_intersect");
    const auto pairs = features(body, t1, body, t2);
    BOOST_TEST(collide(body, t1, body, t2, Question::surface) == expected);
    BOOST_TEST(collide(body, t2, body, t1, Question::surface) == expected);
    BOOST_TEST(!pairs.empty() == expected);
    const std::string what = test.get<std::string>("what"), shape = test.get<std::string>("intersection");
    const bool overlap = std::any_of(pairs.begin(), pairs.end(),
                                     [](const auto& pair) { return pair.kind == Contact::coplanar_overlap; });
    if (shape == "point") BOOST_TEST(!overlap);
    if (shape != "point" && shape != "empty" && what.starts_with("coplanar")) BOOST_TEST(overlap);
  }
  BOOST_TEST(count == 35);
}

BOOST_AUTO_TEST_CASE(boxes_and_convex_bodies_of_the_tests_of_fcl_and_coal)
{
  if (without_data()) return;
  const Tree cases = read_cases("fcl_coal_cases.json");
  int count = 0;
  for (const auto& [key, test] : cases) {
    ++count;
    BOOST_TEST_INFO_SCOPE(test.get<std::string>("id"));
    const Brute_body a(model(test.get_child("A"))), b(model(test.get_child("B")));
    const Placed_body placed_a(a, pose(test.get_child("TA"))), placed_b(b, pose(test.get_child("TB")));
    const Tree& expected = test.get_child("expected");
    BOOST_TEST(collide(placed_a, placed_b) == expected.get<bool>("solids_intersect"));
    BOOST_TEST(collide(placed_a, placed_b, Question::surface) == expected.get<bool>("surfaces_intersect"));
    BOOST_TEST(collide(placed_b, placed_a) == expected.get<bool>("solids_intersect"));
    if (test.get_child("A").count("box") != 0) continue;  // which diagonals their boxes have is not told
    int pairs = 0;
    for (const Element& x : a.elements())
      for (const Element& y : b.elements()) pairs += detail::elements_meet(placed_a, x, placed_b, y);
    BOOST_TEST(pairs == expected.get<int>("intersecting_triangle_pairs"));
  }
  BOOST_TEST(count == 56);
}

BOOST_AUTO_TEST_SUITE_END()
