#include "tetracone/kernel/bound/cone_coordinates.h"

#include "tetracone/tetratree/paper/tetra_cone.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_cone_coordinates)

using namespace tetracone::kernel;
using tetracone::tetratree::Tetra_cone;

BOOST_AUTO_TEST_CASE(the_volume_is_that_of_the_tetrahedron_cut_off)
{
  const Tetra_cone octant = Tetra_cone::octant(0);
  const std::vector<Bound_point<double>> points = {{1, 1, 1}};
  const Cone_coordinates<double, true> coordinates(octant.ray, 1.0 / lattice_size, points, 2);
  BOOST_TEST(coordinates.volume({1, 1, 1}) == 1.0 / 6);
  BOOST_TEST(coordinates.volume({1, 2, 3}) == 1.0);
  // x + y + z <= 3 holds (1, 1, 1) on its border.
  BOOST_TEST(coordinates.bounded_by({3.0000001, 3.0000001, 3.0000001}));
  BOOST_TEST(!coordinates.bounded_by({3, 3, 3}));  // exactly on it, but not provably
  const Cone_coordinates<double, false> plain(octant.ray, 1.0 / lattice_size, points, 2);
  BOOST_TEST(!plain.bounded_by({2.999, 2.999, 2.999}));
  BOOST_TEST(plain.bounded_by({3.0000001, 3.0000001, 3.0000001}));
}

BOOST_AUTO_TEST_CASE(isosceles_lengths_are_equal_as_distances)
{
  const Tetra_cone cone = Tetra_cone::octant(3).child(1).child(2);
  const std::vector<Bound_point<double>> points = {{-0.5, -0.25, 1}};
  const Cone_coordinates<double, true> coordinates(cone.ray, 1.0 / lattice_size, points, 2);
  const auto length = coordinates.isosceles();
  const auto distance = [&](int i) { return length[i] * std::hypot(cone.ray[i][0], cone.ray[i][1], cone.ray[i][2]); };
  for (const int i : {1, 2}) BOOST_TEST(distance(i) == distance(0), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(points_that_are_all_behind_the_origin_leave_lengths_that_are_not_zero)
{
  const Tetra_cone octant = Tetra_cone::octant(0);
  const std::vector<Bound_point<double>> points = {{-1, -2, -3}, {-3, -1, -1}};
  const Cone_coordinates<double, true> coordinates(octant.ray, 1.0 / lattice_size, points, 4);
  for (const double length : coordinates.least_volume(coordinates.isosceles())) BOOST_TEST(length > 0);
}

BOOST_AUTO_TEST_CASE(undefined_coordinates_are_bounded_by_nothing)
{
  const Tetra_cone octant = Tetra_cone::octant(0);
  const std::vector<Bound_point<double>> points = {{std::nan(""), 0, 0}};
  const Cone_coordinates<double, true> coordinates(octant.ray, 1, points, 1);
  BOOST_TEST(!coordinates.bounded_by({1, 1, 1}));
  BOOST_TEST(!coordinates.bounded_by({1e300, 1e300, 1e300}));
}

BOOST_AUTO_TEST_SUITE_END()
