#include "kernel/wide_boxes.h"

#include "kernel/oriented_box.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <random>

using namespace tetracone::kernel;

namespace {

using Random = std::mt19937_64;

double real(Random& random, double low = -1, double high = 1) { return std::uniform_real_distribution<double>(low, high)(random); }
Vector vector(Random& random, double size = 1) { return size * Vector(real(random), real(random), real(random)); }
Matrix axes(Random& random) { return detail::axes_from(vector(random), vector(random)); }

struct Parallelepiped {
  Vector centre;
  Matrix edges;  // columns of length about 1
  Vector extent;

  Vector point(Random& random, bool on_border) const
  {
    Vector s(real(random), real(random), real(random));
    if (on_border)
      for (int i = 0; i < 3; ++i) s[i] = s[i] < 0 ? -1 : 1;
    return centre + edges * s.cwiseProduct(extent);
  }
};

void set(Single_box& box, const Parallelepiped& p)
{
  for (int j = 0; j < 3; ++j) {
    const Vector normal = p.edges.col((j + 1) % 3).cross(p.edges.col((j + 2) % 3));
    for (int i = 0; i < 3; ++i) {
      box.edge[j][i] = float(p.edges(i, j));
      box.normal[j][i] = float(normal[i]);
    }
    box.extent[j] = float(p.extent[j]) * (1 + 0x1p-20f);
    box.centre[j] = float(p.centre[j]);
  }
}

void set(Wide_boxes& boxes, int lane, const Parallelepiped& p)
{
  for (int i = 0; i < 3; ++i) {
    boxes.centre[i][lane] = float(p.centre[i]);
    boxes.extent[i][lane] = float(p.extent[i]) * (1 + 0x1p-20f);
    for (int k = 0; k < 3; ++k) boxes.axis[i][k][lane] = float(p.edges(k, i));
  }
}

Vector extents(Random& random)
{
  Vector e(real(random, 0, 1), real(random, 0, 1), real(random, 0, 1));
  if (random() % 3 == 0) e[random() % 3] = 0;  // flat, as of a triangle
  return e;
}

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_that_share_a_point_are_never_told_apart)
{
  Random random(1);
  int told_apart = 0, lanes_tried = 0;
  for (int k = 0; k < 4000; ++k) {
    const bool similarity = k % 2 == 0;
    Parallelepiped single{vector(random, 3), axes(random), extents(random)};
    if (!similarity)
      for (int j = 0; j < 3; ++j) single.edges.col(j) = (single.edges.col(j) + vector(random, 0.7)).normalized();
    Wide_boxes boxes{};
    double sum = 0, reach = 0;
    for (int lane = 0; lane < lanes; ++lane) {
      Parallelepiped p{Vector::Zero(), axes(random), extents(random)};
      // A point of the one, most often a corner, is put on a point of the other.
      const Vector from = p.point(random, lane % 2 == 0), to = single.point(random, lane % 4 < 2);
      p.centre = to - from;
      set(boxes, lane, p);
      reach = std::max(reach, p.extent.sum() + p.centre.cwiseAbs().maxCoeff());
    }
    Single_box box{};
    set(box, single);
    sum = single.centre.cwiseAbs().sum() + single.extent.sum() + reach;
    box.slack = wide_slack(sum, 0x1p-24 * sum);
    told_apart += lanes - __builtin_popcount(overlapping_boxes(similarity)(boxes, box));
    lanes_tried += lanes;
  }
  BOOST_TEST(told_apart == 0);
  BOOST_TEST(lanes_tried == 32000);
}

BOOST_AUTO_TEST_CASE(every_instruction_set_gives_the_same_lanes)
{
  Random random(2);
  int apart = 0, together = 0;
  for (int k = 0; k < 4000; ++k) {
    Wide_boxes boxes{};
    for (int lane = 0; lane < lanes; ++lane) set(boxes, lane, {vector(random, 1.5), axes(random), extents(random)});
    Single_box box{};
    set(box, {vector(random), axes(random), extents(random)});
    box.slack = k % 3 == 0 ? 0 : wide_slack(6, 0);
    const unsigned similar = wide::overlapping_anywhere<true>(boxes, box), general = wide::overlapping_anywhere<false>(boxes, box);
    BOOST_TEST(overlapping_boxes(true)(boxes, box) == similar);
    BOOST_TEST(overlapping_boxes(false)(boxes, box) == general);
    apart += lanes - __builtin_popcount(similar), together += __builtin_popcount(similar);
  }
  BOOST_TEST(apart > 1000);
  BOOST_TEST(together > 1000);
}

BOOST_AUTO_TEST_CASE(boxes_that_are_apart_by_a_plane_are_told_apart)
{
  // The plane between them is a face of the one, of the other, or along an edge of both: each kind of axis is needed.
  Random random(3);
  int missed = 0;
  for (int k = 0; k < 6000; ++k) {
    Parallelepiped p{Vector::Zero(), axes(random), extents(random)}, single{Vector::Zero(), axes(random), extents(random)};
    const Vector normal = k % 3 == 0 ? Vector(p.edges.col(k % 9 / 3)) : k % 3 == 1 ? Vector(single.edges.col(k % 9 / 3)) : Vector(p.edges.col(k % 9 / 3).cross(single.edges.col(k % 27 / 9)));
    const double length = normal.norm();
    if (length < 0.1) continue;
    double reach = 0;
    for (int i = 0; i < 3; ++i) reach += p.extent[i] * std::abs(normal.dot(p.edges.col(i))) + single.extent[i] * std::abs(normal.dot(single.edges.col(i)));
    single.centre = normal / (length * length) * (reach + 1e-3 * length);
    Wide_boxes boxes{};
    for (int lane = 0; lane < lanes; ++lane) set(boxes, lane, p);
    Single_box box{};
    set(box, single);
    box.slack = wide_slack(8, 0);
    missed += overlapping_boxes(true)(boxes, box) != 0;
    missed += overlapping_boxes(false)(boxes, box) != 0;
  }
  BOOST_TEST(missed == 0);
}

BOOST_AUTO_TEST_CASE(what_is_infinite_or_undefined_is_not_told_apart)
{
  Random random(4);
  Wide_boxes boxes{};
  for (int lane = 0; lane < lanes; ++lane) set(boxes, lane, {vector(random), axes(random), extents(random)});
  Single_box box{};
  set(box, {Vector(100, 0, 0), axes(random), extents(random)});
  box.slack = wide_slack(1, HUGE_VAL);
  BOOST_TEST(overlapping_boxes(true)(boxes, box) == 0xffu);
  box.slack = wide_slack(1, 0);
  BOOST_TEST(overlapping_boxes(true)(boxes, box) == 0u);
  box.centre[0] = std::nanf("");
  BOOST_TEST(overlapping_boxes(false)(boxes, box) == 0xffu);
}
