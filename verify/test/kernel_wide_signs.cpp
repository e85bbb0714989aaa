#include "kernel/wide_signs.h"

#include <boost/test/unit_test.hpp>

#include <hwy/highway.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace tetracone::kernel {

/// Every version of the kernel, the fastest first.
std::vector<Simd_version<Filtered_volume_signs>> versions() { return TETRACONE_SIMD_VERSIONS(filtered_volume_signs_kernel); }

}  // namespace tetracone::kernel

using namespace tetracone::kernel;
using Point = Adaptive::Point_3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Random {
 public:
  explicit Random(int seed) : random_(seed) {}
  int from(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double real() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vertex vertex() { return {real(), real(), real()}; }

 private:
  std::mt19937_64 random_;
};

struct Family {
  std::string name;
  Vertex (*vertex)(Random&, const std::vector<Point>& before);
  bool placed;
};

Vertex times(Vertex v, double s)
{
  for (double& x : v) x *= s;
  return v;
}

const std::vector<Family>& families()
{
  using Before = const std::vector<Point>&;
  static const std::vector<Family> all = {
      {"random", [](Random& r, Before) { return r.vertex(); }, false},
      {"placed", [](Random& r, Before) { return r.vertex(); }, true},
      {"one plane", [](Random& r, Before) { return Vertex{r.real(), r.real(), 0.5}; }, false},
      {"a small grid", [](Random& r, Before) { return Vertex{double(r.from(-2, 2)), double(r.from(-2, 2)), double(r.from(-2, 2))}; }, true},
      {"near the first three's plane",
       [](Random& r, Before before) {
         if (before.size() < 3) return r.vertex();
         const double s = r.real(), t = r.real();
         Vertex v;
         for (int i = 0; i < 3; ++i)
           v[i] = before[0].image[i] + s * (before[1].image[i] - before[0].image[i]) + t * (before[2].image[i] - before[0].image[i]);
         for (double& x : v) x += std::ldexp(r.real(), -r.from(45, 55));
         return v;
       },
       false},
      {"huge and tiny", [](Random& r, Before) { return times(r.vertex(), std::ldexp(1, r.from(-300, 109))); }, false},
      {"beyond the gate", [](Random& r, Before) { return times(r.vertex(), r.from(0, 1) ? DBL_MAX : 1); }, true},
      {"denormal", [](Random& r, Before) { return times(r.vertex(), 0x1p-1060); }, false},
      {"overflowing images", [](Random& r, Before) { return Vertex{r.from(0, 1) ? DBL_MAX : -DBL_MAX, r.real() * DBL_MAX, r.real()}; }, true},
  };
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_target_gives_the_bits_of_the_filter_of_one_point)
{
  // Poses of size 1 and of size 2^60, far away: images are inexact, and beyond the gate unknown.
  const std::vector<Pose> poses = {Pose(std::array<double, 12>{0.6, -0.8, 0, 0.1, 0.8, 0.6, 0, 0.2, 0, 0, 1, 0.3}),
                                   Pose(std::array<double, 12>{0x1p60, 0, 0, 0x1p70, 0, 0x1p60, 3, 1, 0, 0, -0x1p60, 0})};
  const std::int64_t here = hwy::SupportedTargets();
  Random random(1);
  int targets = 0;
  for (const auto& version : versions()) {
    if (!(version.target & here) && version.target != HWY_STATIC_TARGET) continue;
    ++targets;
    Random random(1);  // the same points for each
    for (const Family& family : families()) {
      int different = 0, decided = 0, undecided = 0;
      for (const int count : {1, 2, 3, 5, 7, 8, 9, 63, 64, 65, 127, 200})
        for (int repeat = 0; repeat < 20; ++repeat) {
          std::vector<Point> points;
          Point_columns columns;
          for (int k = 0; k < count + 3; ++k) {
            const Vertex v = family.vertex(random, points);
            points.push_back(family.placed && random.from(0, 2) > 0 ? Adaptive::placed(v, poses[repeat % 2]) : Adaptive::unmoved(v));
            if (k >= 3) columns.push_back(points.back());
          }
          const auto& [a, b, c] = std::tie(points[0], points[1], points[2]);
          // What lies beyond must stay, whatever it was.
          std::vector<Wide_signs> signs(words_of(count) + 1, Wide_signs{~0ull, ~0ull});
          version.function({a.image, b.image, c.image, a.error, std::max(b.error, c.error)}, columns, signs.data());
          for (int k = 0; k < count; ++k) {
            const auto one = Adaptive::filtered_volume_sign(a, b, c, points[3 + k]);
            different += signs[k / 64][k % 64] != one || (signs[k / 64].positive & signs[k / 64].negative) != 0;
            ++(one ? decided : undecided);
          }
          if (count % 64 != 0) different += (signs[count / 64].positive | signs[count / 64].negative) >> count % 64 != 0;
          different += signs.back().positive != ~0ull || signs.back().negative != ~0ull;
        }
      BOOST_TEST_CONTEXT(hwy::TargetName(version.target) << ", " << family.name) { BOOST_TEST(different == 0); }
      BOOST_TEST_MESSAGE(hwy::TargetName(version.target) << ", " << family.name << ": " << decided << " decided, " << undecided << " not");
    }
  }
  BOOST_TEST(targets >= 1);
  BOOST_TEST_MESSAGE(targets << " of " << versions().size() << " targets");
}

BOOST_AUTO_TEST_CASE(every_target_turns_where_the_filter_does)
{
  // Volume h over rows of magnitude 1, as h passes the bound by single steps.
  const Point o = Adaptive::unmoved({0, 0, 0}), x = Adaptive::unmoved({1, 0, 1}), y = Adaptive::unmoved({0, 1, 0});
  const std::int64_t here = hwy::SupportedTargets();
  for (const double error : {0.0, 0x1p-60, 0x1p-30}) {
    Point_columns columns;
    std::vector<Point> points;
    double h = error == 0 ? 49 * 0x1p-53 : 49 * 0x1p-53 + 18.003 * error;
    for (int k = 0; k < 40; ++k) h = std::nextafter(h, 0);
    for (int k = 0; k < 128; ++k, h = std::nextafter(h, 1)) {
      points.push_back(Adaptive::unmoved({0, 0, k % 2 ? h : -h}));
      points.back().error = error;
      columns.push_back(points.back());
    }
    int decided = 0;
    for (const auto& version : versions()) {
      if (!(version.target & here) && version.target != HWY_STATIC_TARGET) continue;
      Wide_signs signs[2];
      version.function({o.image, x.image, y.image, o.error, std::max(x.error, y.error)}, columns, signs);
      for (int k = 0; k < 128; ++k) {
        const auto one = Adaptive::filtered_volume_sign(o, x, y, points[k]);
        BOOST_TEST((signs[k / 64][k % 64] == one));
        decided += one.has_value();
      }
    }
    if (error == 0) BOOST_TEST((0 < decided && decided < 128 * int(versions().size())));
  }
}

BOOST_AUTO_TEST_CASE(an_infinite_error_decides_nothing)
{
  Point_columns columns;
  for (int k = 0; k < 70; ++k) {
    columns.push_back(Adaptive::unmoved({0, 0, k - 35.0}));
  }
  for (int which = 0; which < 3; ++which) {
    Point triangle[3] = {Adaptive::unmoved({0, 0, 0}), Adaptive::unmoved({1, 0, 0}), Adaptive::unmoved({0, 1, 0})};
    triangle[which].error = infinity;
    Wide_signs signs[2];
    filtered_volume_signs(triangle[0], triangle[1], triangle[2], columns, signs);
    for (const Wide_signs& word : signs) BOOST_TEST((word.positive == 0 && word.negative == 0));
  }
  Wide_signs signs[2];
  filtered_volume_signs(Adaptive::unmoved({0, 0, 0}), Adaptive::unmoved({1, 0, 0}), Adaptive::unmoved({0, 1, 0}), columns, signs);
  for (int k = 0; k < 70; ++k)
    BOOST_TEST((signs[k / 64][k % 64] == (k < 35 ? Adaptive::Decision(CGAL::NEGATIVE) : k > 35 ? Adaptive::Decision(CGAL::POSITIVE) : std::nullopt)));
}

BOOST_AUTO_TEST_CASE(columns_are_refilled_and_no_points_write_nothing)
{
  Point_columns columns;
  Wide_signs untouched{1, 2};
  const Point o = Adaptive::unmoved({0, 0, 0}), x = Adaptive::unmoved({1, 0, 0}), y = Adaptive::unmoved({0, 1, 0});
  filtered_volume_signs(o, x, y, columns, &untouched);
  BOOST_TEST((untouched.positive == 1 && untouched.negative == 2));
  for (int k = 0; k < 100; ++k) columns.push_back(Adaptive::unmoved({0, 0, 1}));
  columns.clear();
  columns.push_back(Adaptive::unmoved({0, 0, -1}));
  BOOST_TEST(columns.size() == 1u);
  filtered_volume_signs(o, x, y, columns, &untouched);
  BOOST_TEST((untouched.positive == 0 && untouched.negative == 1));
}
