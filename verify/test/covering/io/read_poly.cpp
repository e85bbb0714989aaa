#include "tetracone/covering/io/read_poly.h"

#include "verify/test/support/model_texts.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_read_poly)

using namespace tetracone::covering;
using namespace tetracone::verify::scenes;
using namespace tetracone::verify::texts;
using tetracone::kernel::Rational;
using tetracone::verify::Temporary_file;

Read_model read_poly(const std::string& text) { return read_text(".poly", text); }

std::string nodes(const Polyhedron& body, int base)
{
  std::string text = std::to_string(body.vertices.size()) + " 3 0 0\n";
  for (std::size_t k = 0; k < body.vertices.size(); ++k) {
    text += std::to_string(k + base);
    for (const double x : body.vertices[k]) text += " " + tetracone::kernel::shortest(x);
    text += "\n";
  }
  return text;
}

/// The nodes and the facets of a body, the first node numbered `base`.
std::string poly(const Polyhedron& body, int base = 0)
{
  std::string text = nodes(body, base) + std::to_string(body.face_count()) + " 0\n";
  for (Index f = 0; f < body.face_count(); ++f) {
    text.append("1\n").append(std::to_string(body.loop(f, 0).size()));
    for (const Index v : body.loop(f, 0)) text.append(" ").append(std::to_string(v + base));
    text += "\n";
  }
  return text;
}

BOOST_AUTO_TEST_CASE(hole_loops_are_turned_against_their_outer_loop_and_facets_across_their_edges)
{
  const Read_model frame = read_model(models + "frame.poly");
  BOOST_TEST(frame.polyhedron.vertices.size() == 16u);
  BOOST_TEST(frame.polyhedron.face_count() == 10u);
  BOOST_TEST(frame.polyhedron.loop_count(0) == 2u);
  BOOST_TEST(is_closed(frame.polyhedron));
  BOOST_TEST((volume(frame.polyhedron) == 8));
  BOOST_TEST(frame.loops_turned == 2u);
  BOOST_TEST(frame.facets_turned != 0u);
}

BOOST_AUTO_TEST_CASE(what_closes_as_it_stands_is_left_alone_inward_too)
{
  for (const int base : {0, 1}) {
    const Read_model out = read_poly(poly(unit_cube(), base) + "0\n0\n");
    BOOST_TEST((volume(out.polyhedron) == 1));
    BOOST_TEST(out.facets_turned == 0u);
    const Read_model in = read_poly(poly(turned(unit_cube()), base) + "0\n");
    BOOST_TEST((volume(in.polyhedron) == -1));
    BOOST_TEST(in.facets_turned == 0u);
  }
}

BOOST_AUTO_TEST_CASE(turned_facets_are_turned_back)
{
  for (const std::uint64_t turned : {0u, 1u, 22u, 62u}) {
    const Read_model model = read_poly(poly(turn_some(unit_cube(), turned), 1) + "0\n");
    BOOST_TEST((volume(model.polyhedron) == 1));
    BOOST_TEST(model.facets_turned == std::size_t(std::popcount(turned)));
  }
}

BOOST_AUTO_TEST_CASE(nodes_may_stand_in_a_file_of_their_own)
{
  const Polyhedron tetrahedron = read(models + "tetrahedron.poly");
  BOOST_TEST(tetrahedron.vertices.size() == 4u);
  BOOST_TEST(is_closed(tetrahedron));
  BOOST_TEST((volume(tetrahedron) == Rational(1) / 6));
  // Without the file, the error names it.
  const Temporary_file lonely("lonely.poly", "0 3 0 0\n1\n1\n3 0 1 2\n");
  try {
    read(lonely.path());
    BOOST_ERROR("no error");
  } catch (const Input_error& error) {
    BOOST_TEST(std::string(error.what()).ends_with("lonely.node: no such file; expected a file to read"));
  }
}

BOOST_AUTO_TEST_CASE(hole_points_and_regions_behind_the_facets_are_passed_over)
{
  const Read_model model = read_poly(poly(unit_cube()) + "1\n1 0.5 0.5 0.5\n1\n1 0.5 0.5 0.5 1 0.1\n");
  BOOST_TEST((volume(model.polyhedron) == 1));
  BOOST_TEST(model.notes.at(0) == "hole points of the volume are not used: only the facets' directions make a cavity");
  BOOST_TEST(model.notes.at(1) == "regions are not used");
}

BOOST_AUTO_TEST_CASE(facets_beyond_their_count_are_no_hole_points)
{
  const std::string points = nodes(unit_cube(), 1) + "1\n1\n4 1 2 3 4\n";
  check_refused(".poly", ":13", points, {"1 0\n3 1 2 3\n", "1 0\n", "1 0 0 0\n"});
  check_refused(".poly", ":14", points, {"1\n3 1 2 3\n", "1\n1 0 0 0 0\n"});
  check_refused(".poly", ":15", points, {"0\n0\njunk\n", "0\n1 0\n3 1 2 3\n", "2\n1 0 0 0\n3 1 2 3\n"});
}

BOOST_AUTO_TEST_CASE(an_open_facet_list_stays_open)
{
  BOOST_TEST(!is_closed(read_poly(poly(without_last_face(unit_cube()))).polyhedron));
}

BOOST_AUTO_TEST_CASE(a_hole_loop_is_turned_in_a_projection_where_it_has_area)
{
  // A frame in each coordinate plane, and a skew one: the hole must come out against the outer loop.
  for (int axis = 0; axis < 4; ++axis) {
    std::vector<Vertex> frame;
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}})
      frame.push_back(std::array<Vertex, 4>{{{0, u, v}, {u, 0, v}, {u, v, 0}, {u, v, u + v}}}[std::size_t(axis)]);
    for (const bool same : {true, false}) {
      const std::vector<Index> hole = same ? std::vector<Index>{4, 5, 6, 7} : std::vector<Index>{7, 6, 5, 4};
      const Polyhedron face = one_face(frame, {{0, 1, 2, 3}, hole});
      std::size_t turned = 0;
      const Polyhedron result = turn_hole_loops(face, turned);
      BOOST_TEST(turned == (same ? 1u : 0u));
      BOOST_TEST(result.loop(0, 1)[0] == 7u);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_first_thing_wrong_is_named_with_its_line)
{
  const std::string points = nodes(unit_cube(), 1);
  check_refused(".poly", ":1", "", {"2 2 0 0\n1 0 0\n2 1 0\n"});
  check_refused(".poly", ":2", "1 3 0 0\n", {"2 0 0 0\n"});
  check_refused(".poly", ":3", "2 3 0 0\n1 0 0 0\n", {"3 0 0 0\n", "2 0 0 # y is missing\n", "2 0 0 0 7\n"});
  check_refused(".poly", ":2", "2 3 0 0\n", {"1 0 0 0 # the last one\n"});
  check_refused(".poly", ":9", points, {""});
  check_refused(".poly", ":10", points, {"1\n", "99999\n1\n3 1 2 3\n"});
  check_refused(".poly", ":11", points, {"1\n0 # no polygon\n", "1\n2 0\n4 1 2 3 4\n3 5 6 7\n"});
  check_refused(".poly", ":12", points + "1\n1\n",
                {"3 1 2 9\n", "3 1 2 0\n", "3 1 2\n", "3 1 2 3 4\n", "2 1 2\n", "4294967298 1 2\n"});
  check_refused(".poly", ":14", points, {"1\n2 1\n4 1 2 3 4\n3 5 6 7\n1 0 x 0\n"});
  check_refused(".poly", ":13", points, {"1\n1\n3 1 2 3\n2\n1 0 0 0\n"});
  BOOST_TEST(error_of(".poly", points + "0\n") == ": no face; expected a model with faces");
}

BOOST_AUTO_TEST_SUITE_END()
