#include "tetracone/kernel/bound/obb8_overlap.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_obb8_overlap)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using tetracone::verify::scenes::set;

inline auto versions() { return TETRACONE_VERSIONS_HERE(overlapping_simd); }
inline auto mapped_versions() { return TETRACONE_VERSIONS_HERE(overlapping_mapped_simd); }

void set(Single_box& box, const Solid& s)
{
  for (int j = 0; j < 3; ++j) {
    const Vector normal = s.edges.col((j + 1) % 3).cross(s.edges.col((j + 2) % 3));
    for (int i = 0; i < 3; ++i) {
      box.edge[j][i] = float(s.edges(i, j));
      box.normal[j][i] = float(normal[i]);
    }
    box.extent[j] = float(s.extent[j]);
    box.centre[j] = float(s.centre[j]);
  }
}

Matrix axes(Random& random) { return random_axes(random); }

Vector extents(Random& random)
{
  Vector e = random_extents(random);
  if (random() % 5 == 0) e *= 1e-3;
  return e;
}

/// One of the 15 axes along which two boxes can be apart.
Vector axis_of(int k, const Solid& p, const Solid& q)
{
  if (k < 3) return p.edges.col(k);
  if (k < 6) return q.edges.col((k - 2) % 3).cross(q.edges.col((k - 1) % 3));
  return p.edges.col((k - 6) / 3).cross(q.edges.col((k - 6) % 3));
}

Matrix sheared(Random& random)
{
  Matrix edges = axes(random);
  for (int j = 0; j < 3; ++j) edges.col(j) = (edges.col(j) + vector(random, 0.7)).normalized();
  return edges;
}

BOOST_AUTO_TEST_CASE(boxes_that_touch_are_never_told_apart)
{
  // Eight boxes, each with its corner on one of the single box's, and all the rest beyond a plane across one of the 15
  // axes. Nothing is enlarged, so rounding alone parts them: without slack many are told apart.
  Random random(1);
  for (const auto overlap : versions()) {
    int told_apart = 0, without_slack = 0;
    for (int k = 0; k < 3000; ++k) {
      const bool similarity = k % 2 == 0;
      Solid single{vector(random, k % 3 == 0 ? 0.1 : 2), similarity ? axes(random) : sheared(random), extents(random)};
      single.round();
      Obb8 boxes{};
      for (int lane = 0; lane < int(lanes); ++lane) {
        Solid p{Vector(), axes(random), extents(random)};
        p.round();
        const Vector n = axis_of(integer(random, 0, 14), p, single);
        p.centre = single.corner(n) - p.corner(-n);
        p.round();
        set(boxes, lane, p);
      }
      Single_box box{};
      set(box, single);
      const double m = single.centre.norm_1() + single.extent.sum() + boxes.reach;
      box.slack = obb8_slack(m, 0);
      told_apart += int(lanes) - std::popcount(overlap(boxes, box, similarity));
      box.slack = 0;
      without_slack += int(lanes) - std::popcount(overlap(boxes, box, similarity));
    }
    BOOST_TEST(told_apart == 0);
    BOOST_TEST(without_slack > 3000);
  }
}

BOOST_AUTO_TEST_CASE(boxes_apart_by_a_plane_are_told_apart_by_each_of_the_15_axes)
{
  Random random(3);
  for (const auto overlap : versions()) {
    std::array<int, 15> missed{}, tried{};
    for (int k = 0; k < 6000; ++k) {
      const bool similarity = k % 2 == 0;
      Solid p{vector(random), axes(random), extents(random)},
          single{Vector(), similarity ? axes(random) : sheared(random), extents(random)};
      const int which = k % 15;
      Vector n = axis_of(which, p, single);
      const double length = n.norm();
      if (length < 0.2) continue;
      n /= length;
      if (k % 4 < 2) n = -n;
      single.centre = p.corner(n) - single.corner(-n) + 1e-3 * n;
      Obb8 boxes{};
      for (int lane = 0; lane < int(lanes); ++lane) set(boxes, lane, p);
      Single_box box{};
      set(box, single);
      box.slack = obb8_slack(10, 0);
      ++tried[which];
      missed[which] += overlap(boxes, box, similarity) != 0;
      if (similarity) missed[which] += overlap(boxes, box, false) != 0;
    }
    for (int which = 0; which < 15; ++which) {
      BOOST_TEST_INFO_SCOPE("axis " << which);
      BOOST_TEST(missed[which] == 0);
      BOOST_TEST(tried[which] > 200);
    }
  }
}

/// A single box with a triangle in it, and points of its plane, as shares of the box's extents.
struct Triangle {
  Single_box box{};
  Solid solid;
  double apex;

  explicit Triangle(Random& random)
      : solid{vector(random, 1), axes(random), Vector(0, real(random, 0.01, 1), real(random, 0.01, 1))}
  {
    if (random() % 4 == 0) solid.extent *= 0.01;
    solid.round();
    set(box, solid);
    box.apex = random() % 5 == 0 ? (random() % 2 ? 1.0f : -1.0f) : float(real(random, -1, 1));
    apex = box.apex;
  }
  Vector at(double x, double y) const
  {
    return solid.centre + x * solid.extent[1] * solid.edges.col(1) + y * solid.extent[2] * solid.edges.col(2);
  }
  /// The positions of the two slanted sides at height y in [-1, 1].
  double left(double y) const { return -1 + (1 + apex) * (y + 1) / 2; }
  double right(double y) const { return 1 - (1 - apex) * (y + 1) / 2; }
};

BOOST_AUTO_TEST_CASE(boxes_that_touch_a_triangle_are_never_told_apart_from_it)
{
  // Each with a point of its surface, most often a corner, on a side of the triangle or in it.
  Random random(7);
  for (const auto overlap : versions()) {
    int told_apart = 0, without_slack = 0;
    for (int k = 0; k < 6000; ++k) {
      Triangle t(random);
      Obb8 boxes{};
      for (int lane = 0; lane < int(lanes); ++lane) {
        const double y = real(random, -1, 1), share = lane % 3 == 0 ? 0 : lane % 3 == 1 ? 1 : real(random, 0, 1);
        const Vector touched = t.at((1 - share) * t.left(y) + share * t.right(y), y);
        Solid p{Vector(), axes(random), extents(random)};
        p.round();
        // Beyond a plane through that side, if it is one.
        const double side = lane % 3 == 0 ? -1 : 1;
        const Vector beyond = lane % 3 == 2 ? vector(random)
                                            : 2 * side * t.solid.extent[2] * t.solid.edges.col(1) +
                                                  t.solid.extent[1] * (1 - side * t.apex) * t.solid.edges.col(2);
        p.centre = touched - p.corner(-beyond);
        p.round();
        set(boxes, lane, p);
      }
      t.box.slack = obb8_slack(boxes.reach + t.solid.extent.sum() + t.solid.centre.norm_1(), 0);
      told_apart += overlap(boxes, t.box, true) != 255;
      t.box.slack = 0;
      t.box.extent[0] += 1e-3f;  // so that only the sides can tell
      without_slack += overlap(boxes, t.box, true) != 255;
    }
    BOOST_TEST(told_apart == 0);
  }
}

BOOST_AUTO_TEST_CASE(boxes_in_the_corners_that_a_triangle_leaves_of_its_box_are_told_apart)
{
  Random random(8);
  for (const auto overlap : versions()) {
    int told_apart = 0, of_the_box = 0, tried = 0;
    for (int k = 0; k < 6000; ++k) {
      Triangle t(random);
      Obb8 boxes{};
      const double y = real(random, -0.9, 1),
                   x = random() % 2 ? real(random, -1, t.left(y)) : real(random, t.right(y), 1);
      const Vector left(t.left(y) - x, 0, 0), right(x - t.right(y), 0, 0);
      const double beside = maximum(left[0], right[0]) * t.solid.extent[1];  // along the box
      const double steep =
          2 * t.solid.extent[2] / std::hypot(2 * t.solid.extent[2], t.solid.extent[1] * (1 + std::abs(t.apex)));
      if (!(beside * steep > 0.01 * t.solid.extent.sum() + 2e-4)) continue;  // the slack is some 5e-5
      ++tried;
      const double size = 0.4 * beside * steep;
      for (int lane = 0; lane < int(lanes); ++lane)
        set(boxes, lane,
            {t.at(x, y), axes(random),
             size / std::sqrt(3) * Vector(real(random, 0, 1), real(random, 0, 1), real(random, 0, 1))});
      boxes.reach = float(t.at(x, y).norm() + 2 * size);
      t.box.slack = obb8_slack(boxes.reach + t.solid.extent.sum() + t.solid.centre.norm_1(), 0);
      told_apart += overlap(boxes, t.box, true) == 0;
      t.box.apex = no_apex;
      of_the_box += overlap(boxes, t.box, true) == 255;
    }
    BOOST_TEST(tried > 2000);
    BOOST_TEST(told_apart == tried);
    BOOST_TEST(of_the_box == tried);
  }
}

BOOST_AUTO_TEST_CASE(lanes_are_compared_one_by_one)
{
  Random random(4);
  for (const auto overlap : versions())
    for (int k = 0; k < 500; ++k) {
      const unsigned expected = unsigned(random() % 256);
      Obb8 boxes{};
      for (int lane = 0; lane < int(lanes); ++lane)
        set(boxes, lane,
            {expected >> lane & 1 ? Vector() : vector(random).normalized() * 20, axes(random), extents(random)});
      Single_box box{};
      set(box, {vector(random, 0.001), axes(random), Vector(1, 1, 1)});
      box.slack = obb8_slack(60, 0);
      BOOST_TEST(overlap(boxes, box, k % 2 == 0) == expected);
    }
}

BOOST_AUTO_TEST_CASE(what_is_infinite_or_undefined_is_not_told_apart)
{
  constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  Random random(5);
  for (const auto overlap : versions())
    for (const bool similarity : {false, true}) {
      Obb8 boxes{};
      for (int lane = 0; lane < int(lanes); ++lane) set(boxes, lane, {vector(random), axes(random), extents(random)});
      Single_box box{};
      set(box, {Vector(100, 0, 0), axes(random), extents(random)});
      box.slack = obb8_slack(1, 0);
      BOOST_TEST(overlap(boxes, box, similarity) == 0u);
      std::vector<Single_box> undefined(similarity ? 6 : 7, box);
      undefined[0].slack = infinity;
      undefined[1].slack = nan;
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) undefined[2 + k].centre[i] = std::array{infinity, nan, -infinity}[k];
        undefined[2 + k].slack = infinity;
      }
      undefined[5].centre[0] = nan;
      // As of an edge that vanishes, which an affine map may have.
      for (int i = 0; i < 3 && !similarity; ++i)
        undefined[6].edge[1][i] = undefined[6].normal[0][i] = undefined[6].normal[2][i] = nan;
      for (const Single_box& one : undefined) BOOST_TEST(overlap(boxes, one, similarity) == 0xffu);
    }
}

Placing placing(Random& random, int kind)
{
  Placing p = random_placing(random);
  p.b = composed(translation(1, 0, 0.125), p.b);
  switch (kind % 6) {
    case 0: break;
    case 1: p.b = random_affine(random, 2); break;
    case 2: p.a = random_affine(random, 2); break;
    case 3: move_far(p, 0x1p35); break;
    case 4: p.in_b.unit = std::ldexp(1.0, integer(random, -30, 30)); break;
    default: {  // a rotation times a scale, nearly a similarity
      const double scale = std::ldexp(1.0 + real(random, 0, 1), integer(random, -5, 5));
      auto b = scaled(p.b, scale).entries();
      b[0] += 0x1p-26 * scale;
      p.b = Pose(b);
    }
  }
  return p;
}

/// A point of B's local units in A's, solved exactly.
Vector exact_image(const Placing& p, const Vector& local)
{
  const rationals::Vector at = p.image({Rational(local[0]), Rational(local[1]), Rational(local[2])});
  return {nearest_double(at[0]), nearest_double(at[1]), nearest_double(at[2])};
}

BOOST_AUTO_TEST_CASE(mapped_boxes_that_touch_are_never_told_apart)
{
  // A box of B whose corner is mapped, exactly, onto a corner of boxes of A that lie beyond it.
  Random random(6);
  std::vector<int> told_apart(mapped_versions().size(), 0);
  int similar = 0, general = 0, known = 0;
  for (int k = 0; k < 1500; ++k) {
    const Placing p = placing(random, k);
    const Box_map map = p.map();
    ++(map.is_similarity() ? similar : general);
    known += std::isfinite(map.slack(1, 1));
    Obb8 from{}, boxes{};
    const int lane = integer(random, 0, 7);
    // Small ones far from the node's origin, too: their extents, grown by a share of them, don't cover the roundings of
    // their place.
    Solid b{vector(random, 0.4), axes(random), (k % 5 < 2 ? 1e-4 : 0.3) * extents(random)};
    b.round();
    set(from, lane, b);
    for (int i = 0; i < 3; ++i) from.origin[i] = float(real(random, -0.25, 0.25));
    const Vector from_origin = vector_of(from.origin), middle = exact_image(p, b.centre + from_origin);
    for (int i = 0; i < 3; ++i) boxes.origin[i] = float(middle[i] + real(random, -1, 1) * (k % 5 == 0 ? 2 : 0.5));
    const Vector origin = vector_of(boxes.origin);
    for (int other = 0; other < int(lanes); ++other) {
      const Vector direction = vector(random);
      const Vector at = exact_image(p, b.corner(direction) + from_origin), out = (at - middle).normalized();
      Solid a{Vector(), axes(random), extents(random)};
      if (other % 2 == 0) a.edges = detail::axes_from(out, vector(random));  // its face towards B
      a.round();
      a.centre = at - origin - a.corner(-out);
      a.round();
      set(boxes, other, a);
    }
    for (std::size_t version = 0; version < told_apart.size(); ++version)
      told_apart[version] += int(lanes) - std::popcount(mapped_versions()[version](boxes, map, from, lane));
  }
  for (const int count : told_apart) BOOST_TEST(count == 0);
  BOOST_TEST(similar > 500);
  BOOST_TEST(general > 300);
  BOOST_TEST(known > 1400);
}

BOOST_AUTO_TEST_CASE(mapped_boxes_that_are_clearly_apart_are_told_apart)
{
  Random random(7);
  int missed = 0;
  for (int k = 0; k < 600; ++k) {
    const Placing p = placing(random, k);
    const Box_map map = p.map();
    Obb8 from{}, boxes{};
    set(from, 2, {vector(random, 0.4), axes(random), 0.3 * extents(random)});
    const Vector middle = exact_image(p, Vector(from.centre[0][2], from.centre[1][2], from.centre[2][2]));
    double size = 0;  // B's box is within, as seen from A
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) size += 0.6 * std::abs(map.column(j)[i]);
    for (int i = 0; i < 3; ++i) boxes.origin[i] = float(middle[i]);
    for (int other = 0; other < int(lanes); ++other) {
      set(boxes, other, Solid{vector(random).normalized() * (size + 3), axes(random), extents(random)});
    }
    for (const auto mapped : mapped_versions()) missed += std::popcount(mapped(boxes, map, from, 2));
  }
  BOOST_TEST(missed == 0);
}

BOOST_AUTO_TEST_SUITE_END()
