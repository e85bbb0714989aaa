#include "tetracone/tetratree/door/contacts.h"

#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/object_cases.h"
#include "verify/test/support/self_touching.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>
#include <string>

BOOST_AUTO_TEST_SUITE(test_contacts)

using namespace tetracone;
namespace scenes = verify::scenes;

namespace {

std::size_t count(const Contacts& contacts, Piece kind)
{
  std::size_t n = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) n += contacts[k].kind == kind;
  return n;
}

const Polyhedron cube = scenes::unit_cube(), triangulated_cube = scenes::triangulated(cube);

}  // namespace

BOOST_AUTO_TEST_CASE(cubes_that_overlap_meet_in_one_closed_curve)
{
  for (const Polyhedron& body : {cube, triangulated_cube}) {
    Query query{Body(body), Body(body), Question::surface};
    query.contacts(Pose(), Pose::translation(0.25, 0.5, 0.25));  // of which nothing may be kept
    const Contacts contacts = query.contacts(Pose(), Pose::translation(0.5, 0.25, 0.125));
    BOOST_TEST(count(contacts, Piece::segment) == contacts.size());
    const auto curves = contacts.curves();
    BOOST_TEST_REQUIRE(curves.size() == 1u);
    BOOST_TEST(curves[0].closed);
    // Six of the edges of either box's corner in the other: a hexagon, whose sides no diagonals of faces cut.
    BOOST_TEST(curves[0].points.size() == 6u);
    for (const auto& x : curves[0].points) {
      BOOST_TEST((x[0] == 0.5 || x[1] == 0.25 || x[2] == 0.125));
      BOOST_TEST((x[0] == 1 || x[1] == 1 || x[2] == 1));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_border_of_faces_that_touch_is_one_curve_however_they_are_split)
{
  for (const Polyhedron& a : {cube, triangulated_cube})
    for (const Polyhedron& b : {cube, triangulated_cube}) {
      Query query{Body(a), Body(b), Question::surface};
      const auto curves = query.contacts(Pose(), Pose::translation(1, 0.5, 0.25)).curves();
      BOOST_TEST_REQUIRE(curves.size() == 1u);
      BOOST_TEST(curves[0].closed);
      const std::set<std::array<double, 3>> corners(curves[0].points.begin(), curves[0].points.end()),
          expected = {{1, 0.5, 0.25}, {1, 1, 0.25}, {1, 1, 1}, {1, 0.5, 1}};
      BOOST_TEST((corners == expected));
    }
}

BOOST_AUTO_TEST_CASE(a_straight_line_is_cut_where_another_ends)
{
  // Two cubes side by side, through the bottom of a larger one: three paths join the ends of their common segment.
  Polyhedron two = cube;
  append(two, scenes::box({1, 0, 0}, {2, 1, 1}));
  Query query{Body(two), Body(cube), Question::surface};
  const auto curves = query.contacts(Pose(), Pose({4, 0, 0, -1, 0, 4, 0, -1, 0, 0, 4, 0.5})).curves();
  std::multiset<std::size_t> sizes;
  for (const auto& curve : curves) {
    BOOST_TEST(!curve.closed);
    sizes.insert(curve.points.size());
    for (const auto& end : {curve.points.front(), curve.points.back()}) BOOST_TEST((end[0] == 1 && end[2] == 0.5));
  }
  BOOST_TEST((sizes == std::multiset<std::size_t>{2, 4, 4}));
}

BOOST_AUTO_TEST_CASE(cubes_face_on_face_share_a_polygon_and_its_border)
{
  Query query{Body(cube), Body(cube), Question::surface};
  const Contacts contacts = query.contacts(Pose(), Pose::translation(1, 0.5, 0));
  const auto polygon = [&] {
    for (std::size_t k = 0; k < contacts.size(); ++k)
      if (contacts[k].kind == Piece::polygon && contacts[k].face_a == 1) return k;
    return contacts.size();
  }();
  BOOST_TEST_REQUIRE(polygon < contacts.size());
  BOOST_TEST(contacts[polygon].face_b == 0u);
  BOOST_TEST((contacts[polygon].in_a == Feature::interior));
  const auto loops = contacts.nearest_loops(polygon);
  BOOST_TEST_REQUIRE(loops.size() == 1u);
  const std::set<std::array<double, 3>> corners(loops[0].begin(), loops[0].end()),
      expected = {{1, 0.5, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0.5, 1}};
  BOOST_TEST((corners == expected));
  // The polygons of the sides z = 0 and z = 1 meet in a segment: they touch along x = 1.
  BOOST_TEST(count(contacts, Piece::polygon) == 1u);
}

BOOST_AUTO_TEST_CASE(normals_point_outward_under_every_pose_and_are_enclosed)
{
  // A cube that is sheared, stretched and mirrored touches one that is not, with faces of all six directions.
  Query query{Body(cube), Body(triangulated_cube), Question::surface};
  const Pose sheared = Pose::from_text({"-2", "1/3", "0", "1", "0", "1/7", "0", "0", "0", "1", "3", "1/2"});
  for (const Pose& pose : {Pose(), sheared}) {
    const Contacts contacts = query.contacts(Pose(), pose);
    BOOST_TEST(!contacts.empty());
    const auto placed = [&](const std::array<double, 3>& x) {
      std::array<double, 3> image{};
      for (std::size_t i = 0; i < 3; ++i) {
        image[i] = pose.rows()[4 * i + 3];
        for (std::size_t k = 0; k < 3; ++k) image[i] += pose.rows()[4 * i + k] * x[k];
      }
      return image;
    };
    const std::array<double, 3> inner = placed({0.5, 0.5, 0.5});
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const auto normals = contact_normals(contacts, k);
      const Polyhedron& b = triangulated_cube;
      const covering::Loop loop = b.loop(contacts[k].face_b, 0);
      std::array<std::array<double, 3>, 3> corner;
      for (std::size_t j = 0; j < 3; ++j) corner[j] = placed(b.vertices[loop[j]]);
      double length = 0, outward = 0;
      std::array<double, 2> along{};
      for (std::size_t i = 0; i < 3; ++i) {
        BOOST_TEST(normals[1].lower[i] <= normals[1].upper[i]);
        BOOST_TEST(normals[1].upper[i] <= std::nextafter(normals[1].lower[i], 2));
        const double x = normals[1].lower[i];
        length += x * x;
        outward += x * (corner[0][i] - inner[i]);
        for (std::size_t j : {0, 1}) along[j] += x * (corner[j + 1][i] - corner[0][i]);
      }
      BOOST_TEST(length == 1, boost::test_tools::tolerance(1e-14));
      BOOST_TEST(outward > 0.01);
      for (const double x : along) BOOST_TEST(std::abs(x) < 1e-14);
      // The cube of A is not moved: one coordinate of its normals is 1 or -1.
      BOOST_TEST((normals[0].lower == normals[0].upper));
      BOOST_TEST((std::ranges::count(normals[0].lower, 0) == 2));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_face_without_area_has_no_normal)
{
  const Polyhedron needle = scenes::polygon({{0, 0, 0.5}, {0.5, 0.5, 0.5}, {2, 2, 0.5}});
  Query query{Body(cube), Body(needle), Question::surface};
  const Contacts contacts = query.contacts(Pose(), Pose());
  BOOST_TEST_REQUIRE(!contacts.empty());
  BOOST_TEST((contact_normals(contacts, 0)[1].lower == std::array<double, 3>{0, 0, 0}));
  BOOST_TEST((contact_normals(contacts, 0)[1].upper == std::array<double, 3>{0, 0, 0}));
}

BOOST_AUTO_TEST_CASE(places_are_exact_enclosed_and_nearest)
{
  Query query{Body(triangulated_cube), Body(triangulated_cube), Question::surface};
  const Pose moved = Pose::from_text({"1", "0", "0", "1/3", "0", "1", "1/7", "1/3", "0", "0", "1", "1/3"});
  const Contacts contacts = query.contacts(Pose(), moved);
  BOOST_TEST(!contacts.empty());
  bool some_fraction = false;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto exact = contacts.exact_loops(k);
    const auto enclosed = contacts.loops(k);
    const auto nearest = contacts.nearest_loops(k);
    BOOST_TEST_REQUIRE(exact[0].size() == enclosed[0].size());
    for (std::size_t i = 0; i < exact[0].size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        some_fraction = some_fraction || exact[0][i][axis].find('/') != std::string::npos;
        BOOST_TEST(enclosed[0][i].lower[axis] <= nearest[0][i][axis]);
        BOOST_TEST(enclosed[0][i].upper[axis] >= nearest[0][i][axis]);
        BOOST_TEST(enclosed[0][i].upper[axis] - enclosed[0][i].lower[axis] < 1e-11);
      }
  }
  BOOST_TEST(some_fraction);
  Query rounded{Body(cube), Body(cube), Question::surface, {.kernel = Kernel::double_}};
  BOOST_CHECK_THROW(rounded.contacts(Pose(), Pose()), Error);
}

BOOST_AUTO_TEST_CASE(an_edge_is_listed_once_with_each_face_that_it_meets)
{
  for (const Polyhedron& body : {cube, triangulated_cube})
    for (const Pose& pose : {Pose::translation(0.5, 0.25, 0.125), Pose::translation(1, 0.5, 0)}) {
      const auto listed = [&](Method method) {
        auto features = Query(Body(body), Body(body), Question::surface, {.method = method}).features(Pose(), pose);
        std::ranges::sort(features);
        return features;
      };
      const auto features = listed(Method::tree);
      BOOST_TEST(!features.empty());
      BOOST_TEST((std::ranges::adjacent_find(features) == features.end()));
      BOOST_TEST((features == listed(Method::brute)));
    }
}

BOOST_AUTO_TEST_CASE(grids_in_one_plane_take_what_they_print)
{
  // 2 x 60 x 60 triangles on as many of another grid: each meets a few, not all.
  constexpr int n = 60;
  const Polyhedron grid = scenes::grid(n);
  Query query{Body(grid), Body(scenes::moved(grid, 1.25)), Question::surface};
  const Contacts contacts = query.contacts(Pose(), Pose());
  const auto features = query.features(Pose(), Pose());
  BOOST_TEST(contacts.size() > 2u * n * n);
  BOOST_TEST(features.size() > contacts.size());
  // Pairs of triangles that were decided: no more than a few for each that is printed.
  const Query_statistics work = query.statistics();
  BOOST_TEST(work.box_tests < 60 * (contacts.size() + features.size()));
}

BOOST_AUTO_TEST_SUITE_END()
