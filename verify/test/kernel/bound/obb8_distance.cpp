#include "tetracone/kernel/bound/obb8_distance.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_obb8_distance)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using Find = void(Gap_test*, std::size_t);

inline auto versions() { return TETRACONE_VERSIONS_HERE(find_gaps_simd); }

Solid any(Random& random)
{
  Solid s{vector(random), random_axes(random), random_extents(random)};
  s.round();
  return s;
}

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Eight boxes, each beyond a face of its own or of the single one. `corners_apart` has the distance of a corner of
/// each from a corner of the single box.
struct Scene {
  Obb8 boxes{}, from{};
  Pose pose;
  std::array<double, lanes> corners_apart{};

  Scene(Random& random, bool similarity, double gap)
  {
    Matrix map = real(random, 0.3, 2) * random_axes(random);
    if (!similarity) map.col(0) += 0.4 * map.col(1);
    const Vector offset = vector(random);
    std::array<double, 12> entries;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) entries[std::size_t(4 * i + j)] = map(i, j);
      entries[std::size_t(4 * i + 3)] = offset[i];
    }
    pose = Pose(entries);
    const Solid in_b = any(random), single{map * in_b.centre + offset, map * in_b.edges, in_b.extent};
    from.lane_count = 1;
    set(from, 0, in_b);
    boxes.lane_count = int(lanes);
    for (int lane = 0; lane < int(lanes); ++lane) {
      Solid p = any(random);
      const int k = int(random() % 6);
      const Vector normal = k < 3 ? p.edges.col(k) : single.edges.col((k + 1) % 3).cross(single.edges.col((k + 2) % 3));
      const Vector n = normal.normalized();
      p.centre += single.corner(n) + gap * n - p.corner(-n);
      p.round();
      set(boxes, lane, p);
      corners_apart[std::size_t(lane)] = (p.corner(-n) - single.corner(n)).norm();
    }
  }
  Box_map map() const { return Box_map(Pose(), Local_scale(), pose, Local_scale()); }
  Gap_test test(const Box_map& map, const Gap_question& question) const
  {
    return {&boxes, &map, &from, 0, question, 0, {}};
  }
  Gap_test found(Find* find, const Gap_question& question) const
  {
    const Box_map carries = map();
    Gap_test made = test(carries, question);
    find(&made, 1);
    return made;
  }
};

BOOST_AUTO_TEST_CASE(no_box_is_told_farther_than_two_corners_are_and_most_nearly_as_far)
{
  for (Find* const find : versions()) {
    Random random(1);
    int too_far = 0, beyond_limit = 0, near = 0;
    for (int k = 0; k < 1500; ++k) {
      const double gap = k % 3 == 0 ? 1e-3 : k % 3 == 1 ? 0.1 : 1;
      const Scene scene(random, k % 2 == 0, gap);
      const Gap_test all = scene.found(find, {distance_shrink, infinite, 0, 1});
      BOOST_TEST(all.nearer == 255u);
      const unsigned left = scene.found(find, {distance_shrink, float(gap / 2), 0, 1}).nearer;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        too_far += double(all.gaps.low[lane]) > scene.corners_apart[lane];
        near += double(all.gaps.low[lane]) > 0.99 * gap - 1e-4;
        beyond_limit += (left >> lane & 1) != (all.gaps.low[lane] <= float(gap / 2));
      }
    }
    BOOST_TEST(too_far == 0);
    BOOST_TEST(beyond_limit == 0);
    BOOST_TEST(near > 8000);
  }
}

BOOST_AUTO_TEST_CASE(several_tests_at_once_find_what_each_finds_alone)
{
  Random random(3);
  std::vector<Scene> scenes;
  std::vector<Box_map> maps;
  for (std::size_t k = 0; k < most_gap_tests; ++k) scenes.emplace_back(random, k % 2 == 0, 0.1);
  for (const Scene& scene : scenes) maps.push_back(scene.map());
  for (Find* const find : versions()) {
    std::vector<Gap_test> tests;
    for (std::size_t k = 0; k < most_gap_tests; ++k)
      tests.push_back(scenes[k].test(maps[k], {distance_shrink, 0.3f + 0.1f * float(k), 0.01f * float(k), 2}));
    find(tests.data(), tests.size());
    for (std::size_t k = 0; k < most_gap_tests; ++k) {
      const Gap_test alone = scenes[k].found(find, tests[k].question);
      BOOST_TEST(tests[k].nearer == alone.nearer);
      BOOST_TEST((tests[k].gaps.low == alone.gaps.low));
      BOOST_TEST((tests[k].gaps.size == alone.gaps.size));
      BOOST_TEST((tests[k].gaps.between == alone.gaps.between));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_infinite_or_undefined_is_no_bound)
{
  Random random(2);
  const Scene scene(random, true, 1);
  for (Find* const find : versions()) {
    // Nothing is known of lengths; nor of coordinates that overflow.
    const Gap_test unknown = scene.found(find, {0, 0.5f, 0.25f, 1});
    BOOST_TEST(unknown.nearer == 255u);
    for (const float low : unknown.gaps.low) BOOST_TEST(low == 0.25f);
    for (const float bad : {infinite, std::numeric_limits<float>::quiet_NaN(), 1e30f}) {
      Scene far = scene;
      far.from.centre[0][0] = bad;
      for (const float low : far.found(find, {distance_shrink, infinite, 0.25f, 1}).gaps.low) BOOST_TEST(low == 0.25f);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
