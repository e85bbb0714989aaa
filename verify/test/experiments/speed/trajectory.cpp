#include "experiments/speed/trajectory.h"

#include "verify/cases/shape_generators.h"
#include "verify/subjects/subject.h"

#include <boost/test/unit_test.hpp>

#include <bit>
#include <cmath>
#include <memory>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_trajectory)

using namespace tetracone;
using namespace tetracone::experiments;
using namespace tetracone::verify;
using kernel::Pose;

namespace {

/// The surface question about two objects, in double: fast, and right except for hair-thin cases that do not matter
/// here.
struct Scene {
  Polyhedron a, b;
  std::shared_ptr<verify::Prepared_pair> pair;
  Collides collides;

  Scene(const Polyhedron& first, const Polyhedron& second)
      : a(first), b(second), pair(verify::prepare(*verify::Subject::parse("double"), a, b))
  {
    collides = [p = pair](const Pose& pose) { return p->collide(Pose(), pose, kernel::Question::surface); };
  }

  int colliding(const std::vector<Pose>& poses) const
  {
    int found = 0;
    for (const Pose& pose : poses) found += collides(pose);
    return found;
  }
};

std::uint64_t hash(const std::vector<Pose>& poses)
{
  std::uint64_t h = 14695981039346656037u;  // FNV-1a, of words
  for (const Pose& pose : poses)
    for (const double entry : pose.entries()) h = (h ^ std::bit_cast<std::uint64_t>(entry)) * 1099511628211u;
  return h;
}

const std::vector<Scene>& scenes()
{
  static const std::vector<Scene> all = {{complex_one(), complex_two()},
                                         {complex_two(), blob(200, 4)},
                                         {torus_knot(640), complex_one()},
                                         {unit_cube(), unit_cube()}};
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(on_the_circle_3_to_4_5_percent_collide_and_along_the_contour_5_to_10)
{
  std::uint64_t seed = 1;
  for (const Scene& scene : scenes())
    for (const double ratio : {1, 4, 16}) {
      const auto circle = circular_trajectory(scene.a, scene.b, ratio, 100, ++seed, scene.collides),
                 contour = contour_trajectory(scene.a, scene.b, ratio, 100, seed, scene.collides);
      BOOST_TEST_INFO_SCOPE("seed " << seed << " ratio " << ratio);
      BOOST_TEST(circle.size() == 100u);
      BOOST_TEST(contour.size() == 100u);
      const int on_circle = scene.colliding(circle), on_contour = scene.colliding(contour);
      BOOST_TEST((on_circle == 3 || on_circle == 4), on_circle);
      BOOST_TEST((on_contour >= 6 && on_contour <= 9), on_contour);
    }
}

BOOST_AUTO_TEST_CASE(few_frames_get_the_nearest_whole_number)
{
  const Scene& scene = scenes()[0];
  for (const int frames : {1, 10, 20, 21, 40, 50, 70}) {
    const int circle = scene.colliding(circular_trajectory(scene.a, scene.b, 1, frames, 5, scene.collides));
    BOOST_TEST(circle * 20 < frames);
    if (frames > 20) BOOST_TEST(circle > 0);
    const int contour = scene.colliding(contour_trajectory(scene.a, scene.b, 1, frames, 5, scene.collides));
    BOOST_TEST(std::abs(contour - 0.075 * frames) <= kernel::maximum(0.5, 0.02 * frames), frames << ": " << contour);
  }
}

BOOST_AUTO_TEST_CASE(a_seed_means_the_same_poses_each_time)
{
  const Scene& scene = scenes()[0];
  // The trajectories are equal on every machine, too.
  for (const auto& [trajectory, expected] :
       {std::pair(&circular_trajectory, 2464733422047427051u), std::pair(&contour_trajectory, 16816156988353229294u)}) {
    const auto of = [&](std::uint64_t seed) {
      return hash(trajectory(scene.a, scene.b, 2, 60, seed, scene.collides, Turning::yes));
    };
    BOOST_TEST(of(1) == expected);
    BOOST_TEST(of(1) != of(2));
  }
}

BOOST_AUTO_TEST_CASE(the_scale_is_in_the_pose)
{
  const Scene& scene = scenes()[0];
  for (const double ratio : {1, 8})
    for (const Pose& pose : contour_trajectory(scene.a, scene.b, ratio, 20, 3, scene.collides))
      for (int row = 0; row < 3; ++row) {
        const double x = pose[4 * row], y = pose[4 * row + 1], z = pose[4 * row + 2];
        BOOST_TEST(std::abs(std::sqrt(x * x + y * y + z * z) * ratio - 1) < 1e-14);
      }
}

BOOST_AUTO_TEST_CASE(contour_frames_are_close_to_the_border)
{
  // About a cube of half-width 1, a small one: every frame has its centre in the layer that its size and the gap allow.
  const Scene scene(box({-1, -1, -1}, {1, 1, 1}), box({-1, -1, -1}, {1, 1, 1}));
  const double size = std::sqrt(3.0) / 16;
  for (const Pose& pose : contour_trajectory(scene.a, scene.b, 16, 200, 3, scene.collides)) {
    double outside = -1;
    for (const int k : {3, 7, 11}) outside = kernel::maximum(outside, std::abs(pose[k]) - 1);
    BOOST_TEST(outside > 0);
    BOOST_TEST(outside < size + 0.06);
  }
}

BOOST_AUTO_TEST_CASE(a_smooth_walk_of_more_frames_is_the_same_way_in_smaller_steps)
{
  const Scene& scene = scenes()[0];
  const auto walk = [&](int frames) { return smooth_walk(scene.a, scene.b, 1, frames, 0.01, 3, scene.collides); };
  const std::vector<Pose> coarse = walk(64), fine = walk(512);
  int hits = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    hits += scene.collides(fine[k]);  // in the directions that were asked: it keeps clear
    for (int entry = 0; entry < 12 && k % 8 == 0; ++entry)
      BOOST_TEST(std::abs(fine[k][entry] - coarse[k / 8][entry]) < 1e-12);
  }
  BOOST_TEST(hits == 0);
  const double step = mean_motion(scene.a, scene.b, fine), larger = mean_motion(scene.a, scene.b, coarse);
  BOOST_TEST(larger > 6 * step);
  BOOST_TEST(larger < 9 * step);
  BOOST_TEST(larger < 1);
}

BOOST_AUTO_TEST_CASE(one_that_never_collides_ends_all_the_same)
{
  const Scene& scene = scenes()[0];
  for (const bool collides : {false, true})
    for (const auto trajectory : {&circular_trajectory, &contour_trajectory})
      BOOST_TEST(trajectory(
                     scene.a, scene.b, 1, 100, 1, [=](const Pose&) { return collides; }, Turning::yes)
                     .size() == 100u);
}

BOOST_AUTO_TEST_SUITE_END()
