#include "tetracone/covering/inclusion.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_inclusion)

using namespace tetracone::covering;
using namespace tetracone::kernel;

using Exact_motions = std::tuple<Epeck, Rational_kernel, Adaptive>;

KERNEL_TEST_CASE(a_tetrahedron_of_the_covering_holds_a_point_with_its_own_sign, K, Exact_motions)
{
  const auto at = [](double x, double y, double z) { return point<K>({x, y, z}); };
  const auto o = at(0, 0, 0), x = at(4, 0, 0), y = at(0, 4, 0), z = at(0, 0, 4);
  BOOST_TEST(signed_inclusion<K>(at(1, 1, 1), o, x, y, z) == 1);
  BOOST_TEST(signed_inclusion<K>(at(1, 1, 1), o, y, x, z) == -1);
  BOOST_TEST(signed_inclusion<K>(at(3, 3, 3), o, x, y, z) == 0);
  BOOST_TEST(signed_inclusion<K>(at(1, 1, 1), o, x, y, at(1, 1, 0)) == 0);  // flat
  // On its border: the point moved by (e, e^2, e^3) is in exactly one of the two tetrahedra on the two sides.
  const auto below = at(0, 0, -4);
  for (const auto& p : {at(1, 1, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 0)}) {
    BOOST_TEST(signed_inclusion<K>(p, o, x, y, z) == 1);
    for (const auto& [a, b, c] : {std::array{y, x, below}, {x, below, y}, {below, y, x}})
      BOOST_TEST(signed_inclusion<K>(p, o, a, b, c) == 0);
  }
  BOOST_TEST(signed_inclusion<K>(at(4, 0, 0), o, x, y, z) == 0);
}

KERNEL_TEST_CASE(a_mirrored_solid_has_the_negative_winding_number, K, Exact_motions)
{
  const Model<K> model(tetracone::verify::scenes::unit_cube());
  Placed_model<K> placed(model);
  for (const double side : {1.0, -1.0}) {
    const Pose pose(std::array<double, 12>{side, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    placed.place(pose);
    BOOST_TEST(winding_number<K>(point<K>({side / 2, 0.5, 0.5}), placed) == side);
    BOOST_TEST((locate<K>(point<K>({side, 0.5, 0.5}), placed) == Location::on_surface));
    BOOST_TEST((locate<K>(point<K>({-side, 0.5, 0.5}), placed) == Location::outside));
  }
}

BOOST_AUTO_TEST_SUITE_END()
