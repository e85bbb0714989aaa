#include "tetracone/tetratree/scene/swept_box.h"

#include "tetracone/tetratree/scene/body_extent.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/world_boxes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>

BOOST_AUTO_TEST_SUITE(test_swept_box)

using namespace tetracone;
using kernel::Body_motion;
using kernel::Pose;
using kernel::Rational;
using tetratree::Body_extent;
using tetratree::World_box;
namespace scenes = verify::scenes;
namespace rationals = verify::rationals;

namespace {

World_box box_about(const Body_extent& extent, const Body_motion& motion)
{
  return tetratree::swept_box(motion, [&](const Pose& pose) { return tetratree::world_box(extent, pose); });
}

Body_motion any_motion(scenes::Random& random, bool rigid)
{
  const auto any = [&random](double size) { return scenes::real(random, -size, size); };
  if (rigid) {
    const auto pose = [&] { return kernel::Rigid_pose{{any(1), any(1), any(1), any(1)}, {any(50), any(50), any(50)}}; };
    return Body_motion::rigid(pose(), pose()).value();
  }
  const auto pose = [&] {
    std::array<double, 12> m;
    for (double& x : m) x = any(3);
    return Pose(m);
  };
  return Body_motion::linear(pose(), pose());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_body_stays_in_its_box)
{
  scenes::Random random(3);
  std::size_t reached = 0;
  for (int n = 0; n < 120; ++n) {
    const bool rigid = n % 2 == 0;
    covering::Polyhedron body = scenes::cube(1);
    const double at = std::ldexp(scenes::real(random, -1, 1), scenes::integer(random, -4, 30));
    for (auto& v : body.vertices) v[0] += at;
    const Body_motion motion = any_motion(random, rigid);
    const World_box box = box_about(Body_extent(body.vertices), motion);
    BOOST_TEST(box.is_bounded());
    for (int t = 0; t <= 8; ++t) {
      const Pose pose = motion.at(Rational(t) / 8);
      for (const auto& v : body.vertices) {
        const auto p = rationals::image(pose, rationals::exactly(v));
        BOOST_REQUIRE(verify::holds(box, p));
        for (int k = 0; k < 3; ++k) {
          const double size = double(box.high[k]) - double(box.low[k]);
          reached += double(box.high[k]) - p[k].get_d() < 1e-3 * size;
        }
      }
    }
  }
  BOOST_TEST(reached > 100u);
}

BOOST_AUTO_TEST_CASE(a_turn_about_an_end_is_within_twice_the_body)
{
  const Body_extent rod(scenes::box({0, -0.5, -0.5}, {8, 0.5, 0.5}).vertices);
  const World_box box = box_about(rod, Body_motion::rigid({}, {{1, 0, 0, 1}, {}}).value());
  BOOST_TEST((box.high[1] >= 8 && box.high[1] < 14));
  BOOST_TEST((box.low[0] <= -0.5 && box.low[0] > -6));
  BOOST_TEST((box.low[2] <= -0.5f && box.low[2] > -0.6f));
}

BOOST_AUTO_TEST_CASE(where_nothing_is_known_the_box_is_everything)
{
  const Body_extent extent(scenes::cube(1).vertices);
  const auto to = kernel::Rigid_pose{{-1, Rational(1) / kernel::Integer("1000000000000000000"), 0, 0}, {}};
  BOOST_TEST((box_about(extent, Body_motion::rigid({}, to).value()) == World_box()));
}

BOOST_AUTO_TEST_SUITE_END()
