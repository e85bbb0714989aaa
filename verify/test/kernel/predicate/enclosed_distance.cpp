#include "tetracone/kernel/predicate/enclosed_distance.h"

#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/face_distance.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_enclosed_distance)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

/// The corners of a feature, and their images over both kinds of numbers.
struct Feature_pair {
  std::array<std::vector<Vertex>, 2> corner;
  std::array<Ball_hull, 2> ball;
  std::array<std::vector<Exact_vector>, 2> exact;

  Feature_pair(const std::vector<Vertex>& a, const Pose& pose_a, const std::vector<Vertex>& b, const Pose& pose_b)
      : corner{a, b}
  {
    const std::array<const Pose*, 2> poses = {&pose_a, &pose_b};
    for (int body = 0; body < 2; ++body)
      for (const Vertex& v : corner[body]) {
        const Pose& m = *poses[std::size_t(body)];
        ball[body].add(v, m);
        const auto row = [&](int i) -> Exact_number {
          return m.whole(i) * Exact_number(v[0]) + m.whole(i + 1) * Exact_number(v[1]) +
                 m.whole(i + 2) * Exact_number(v[2]) + m.whole(i + 3);
        };
        exact[body].push_back({row(0), row(4), row(8)});
      }
  }
};

Rational rational(const Exact_number& x) { return Rational(x); }

Pose turned(Random& random, double size)
{
  std::array<double, 12> m;
  for (double& x : m) x = real(random, -size, size);
  return Pose(m);
}

BOOST_AUTO_TEST_CASE(an_enclosed_distance_is_the_exact_one_rounded_once)
{
  Random random(1);
  int told = 0, untold = 0, wrong = 0;
  for (int k = 0; k < 4000; ++k) {
    const int of_a = 1 + k % 3, of_b = of_a == 3 ? 1 : of_a == 2 ? 1 + k / 3 % 2 : 1 + k / 3 % 3;
    const double size = k % 5 == 0 ? 0x1p-40 : 1;
    const auto feature = [&](int count, double offset) {
      std::vector<Vertex> corners;
      for (int i = 0; i < count; ++i) corners.push_back(real_vertex(random, size));
      if (count == 3) corners = {{-9 * size, -8 * size, 0}, {9 * size, -7 * size, 0}, {0, 8 * size, size}};
      for (Vertex& v : corners) v[2] += offset;
      return corners;
    };
    const Feature_pair pair(feature(of_a, 0), k % 2 == 0 ? Pose() : turned(random, 2), feature(of_b, 3 * size),
                            k % 2 == 0 ? Pose() : turned(random, 2));
    const auto exact = distance_of_hulls(pair.exact[0], pair.exact[1], Nearest_points::are_not_asked_for);
    const auto found = enclosed_distance(pair.ball[0], pair.ball[1]);
    if (!found) {
      untold += exact.has_value();
      continue;
    }
    ++told;
    if (!exact) {
      ++wrong;
      continue;
    }
    const auto nearest = nearest_over_root(found->height, found->square);
    wrong += nearest && *nearest != nearest_root(rational(exact->top()), rational(exact->bottom()));
    // The direction, up to its length.
    double share = 0, off = 0, sum = 0;
    for (int i = 0; i < 3; ++i) sum += std::abs(exact->direction[i].to_double());
    for (int i = 0; i < 3; ++i) share += std::abs(found->direction[i]) / sum;
    for (int i = 0; i < 3; ++i)
      off += std::abs(
          nearest_double(Rational(Rational(found->direction[i]) - Rational(share) * rational(exact->direction[i]))));
    wrong += off > 0x1p-47 * share * sum;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(told > 1500);
  BOOST_TEST(untold < told / 50);
}

BOOST_AUTO_TEST_CASE(a_point_beside_a_triangle_is_not_taken_as_over_it)
{
  Random random(2);
  int told = 0, untold = 0, wrong = 0;
  for (int k = 0; k < 6000; ++k) {
    // The foot of the point is about 2^-40 to 2^-60 from a side, on either side of it.
    const double size = k % 5 == 0 ? 0x1p-40 : 1;
    const std::vector<Vertex> t = {real_vertex(random, size), real_vertex(random, size), real_vertex(random, size)};
    const double along = real(random, 0.1, 0.9), inward = std::ldexp(real(random, -1, 1), -40 - k % 20);
    const std::array<double, 3> e = difference(t[1], t[0]), f = difference(t[2], t[0]), n = cross(e, f);
    const double height = real(random, 0.1, 1);
    Vertex x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = t[0][i] + along * e[i] + inward * f[i] + height / size * n[i];
    const Feature_pair pair({x}, Pose(), t, Pose());
    const bool is_over = distance_of_hulls(pair.exact[0], pair.exact[1], Nearest_points::are_not_asked_for).has_value();
    const bool is_told = enclosed_distance(pair.ball[0], pair.ball[1]).has_value();
    told += is_told;
    untold += is_over && !is_told;
    wrong += is_told && !is_over;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(told > 2000);
  BOOST_TEST(untold < told / 50);
}

BOOST_AUTO_TEST_CASE(nothing_is_told_of_what_touches_or_is_beyond_the_gate)
{
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<Vertex> x = {{0, 0, 0}, {1, 0, 0}}, y = {{0.5, -1, 0}, {0.5, 1, 0}}, far = {{0, 0, 0x1p200}},
                            low = {{0.5, -1, -1}, {0.5, 1, -1}}, beside = {{0, -1, 1}, {0, 1, 1}};
  const auto told = [&](const std::vector<Vertex>& a, const std::vector<Vertex>& b) {
    const Feature_pair pair(a, Pose(), b, Pose());
    return enclosed_distance(pair.ball[0], pair.ball[1]).has_value();
  };
  BOOST_TEST(told(x, low));
  BOOST_TEST(told(low, x));
  BOOST_TEST(!told(x, y));
  BOOST_TEST(!told({x[0]}, {x[0]}));
  BOOST_TEST(!told({x[0]}, far));
  // The nearest point is an end.
  BOOST_TEST(!told(x, beside));
  Ball_hull undefined;
  undefined.add({0, 0, 0}, Pose());
  undefined.corner[0][0].radius = infinite;
  const Feature_pair pair(low, Pose(), low, Pose());
  BOOST_TEST(!enclosed_distance(undefined, pair.ball[0]).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
