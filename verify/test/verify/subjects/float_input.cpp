#include "verify/subjects/float_input.h"

#include "tetracone/covering/check.h"
#include "verify/cases/shape_generators.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <memory>

using namespace tetracone;
using kernel::Pose;
using verify::In_floats;

BOOST_AUTO_TEST_SUITE(test_float_input)

namespace {

verify::Object_case of(covering::Polyhedron a, const Pose& pose_b)
{
  verify::Object_case c;
  c.a = c.b = std::make_shared<const covering::Polyhedron>(std::move(a));
  c.pose_b = pose_b;
  c.surface = c.solid = true;
  return c;
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_become_the_nearest_floats_and_faces_triangles)
{
  const auto c = of(verify::box({0.1, 0, 0}, {1, 1, 1}), Pose::translation(1 / 3.0, 0, 0));
  const auto all = verify::float_input(c, In_floats::vertices_and_poses);
  BOOST_TEST_REQUIRE(all.has_value());
  BOOST_TEST(all->a == all->b);
  BOOST_TEST(all->a->face_count() == 12u);
  BOOST_TEST(covering::is_closed(*all->a));
  double least = 1;
  for (const auto& v : all->a->vertices) least = std::min(least, v[0]);
  BOOST_TEST(least == double(0.1f));
  BOOST_TEST(all->pose_b[3] == double(1 / 3.0f));
  BOOST_TEST(!all->known(kernel::Question::surface).has_value());
  const auto vertices = verify::float_input(c, In_floats::vertices);
  BOOST_TEST_REQUIRE(vertices.has_value());
  BOOST_TEST(vertices->pose_b[3] == 1 / 3.0);
}

BOOST_AUTO_TEST_CASE(an_input_without_floats_is_none)
{
  const auto is_none = [](const verify::Object_case& c, In_floats in_floats) {
    return !verify::float_input(c, in_floats).has_value();
  };
  BOOST_TEST(is_none(of(verify::box({0, 0, 0}, {1, 1, 1e39}), {}), In_floats::vertices));
  const Pose flat(std::array<double, 12>{1e-50, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  const Pose far = Pose::translation(1e300, 0, 0);
  for (const Pose& pose : {flat, far}) {
    BOOST_TEST(is_none(of(verify::unit_cube(), pose), In_floats::vertices_and_poses));
    BOOST_TEST(!is_none(of(verify::unit_cube(), pose), In_floats::vertices));
  }
}

BOOST_AUTO_TEST_SUITE_END()
