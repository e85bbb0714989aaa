#include "verify/searches/searches.h"

#include "tetracone/kernel/bound/obb8_gap.h"
#include "verify/proofs/box_test.h"
#include "verify/proofs/gap_proofs.h"
#include "verify/proofs/obb8_distance_proofs.h"
#include "verify/proofs/scene_proofs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tetracone::verify::proofs {
namespace {
namespace box_search {

using detail::u_of_float;
using Float = Tracked<float>;

/// The inputs of a comparison: centres, extents, and a quaternion for each frame of axes.
struct Boxes {
  enum Place {
    single_centre = 0,
    centre = 3,
    extent = 6,
    single_extent = 9,
    axes = 12,
    edges = 16,
    directions = 20,
    end = 24
  };

  /// Column k of a quaternion's rotation, in float.
  static std::array<float, 3> column(const Inputs& in, int q, int k)
  {
    const auto m = detail::rotation(in, q);
    if (std::isnan(m[0][0])) return {float(k == 0), float(k == 1), float(k == 2)};
    return {float(m[0][k]), float(m[1][k]), float(m[2][k])};
  }

  /// An edge of any map: also of length 1, but with its own direction.
  static std::array<float, 3> slanted(const Inputs& in, int k)
  {
    const int first = edges + 2 * k;
    const double length = std::hypot(in[first], in[first + 1], in[first + 2]);
    if (!(length > 0)) return {float(k == 0), float(k == 1), float(k == 2)};
    return {float(in[first] / length), float(in[first + 1] / length), float(in[first + 2] / length)};
  }

  std::vector<Float> inputs(const Inputs& in, Edges kind)
  {
    const auto add = [this](double x) { all.emplace_back(x); };
    for (int k = 0; k < 3; ++k) add(in[single_centre + k]);
    for (int k = 0; k < 3; ++k) add(in[centre + k]);
    for (int k = 0; k < 6; ++k) add(std::abs(in[extent + k]));
    for (int j = 0; j < 3; ++j)
      for (const float x : column(in, axes, j)) add(x);
    for (int j = 0; j < 3; ++j)
      for (const float x : kind == Edges::general ? slanted(in, j) : column(in, edges, j)) add(x);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) add(column(in, directions, j)[k]);
    return all;
  }

  double sum_of_extents() const
  {
    double sum = std::hypot(double(all[3].computed), double(all[4].computed), double(all[5].computed));
    for (int k = extent; k < axes; ++k) sum += all[k].computed;
    return sum;
  }
  double norm_1_of_single_centre() const
  {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += std::abs(all[k].computed);
    return sum;
  }

  std::vector<Float> all;
};

template <bool fused>
double worst_of(const std::vector<Float>& in, Edges kind, bool triangle)
{
  const auto gaps = gaps_of(Box_test<Float, fused>(in, kind, triangle, Float(0)), kind);
  constexpr std::size_t axes_of_boxes = 15;
  double worst = 0;
  for (std::size_t k = triangle ? axes_of_boxes : 0; k < (triangle ? gaps.size() : axes_of_boxes); ++k)
    worst = std::max(worst, gaps[k].error());
  return worst;
}
double worst_of(const std::vector<Float>& in, Edges kind, bool triangle)
{
  return std::max(worst_of<true>(in, kind, triangle), worst_of<false>(in, kind, triangle));
}

/// Rounding errors only; the axes' defects are added separately.
template <Edges kind>
double any_boxes(const Inputs& in)
{
  Boxes boxes;
  const double worst = worst_of(boxes.inputs(in, kind), kind, false);
  return detail::ratio(worst, boxes.norm_1_of_single_centre() + boxes.sum_of_extents()) / u_of_float;
}

/// Centres that are no farther apart than the reach of both boxes.
template <bool triangle>
double carried_boxes(const Inputs& in)
{
  Boxes boxes;
  Inputs near = in;
  const double extents =
      std::abs(in[6]) + std::abs(in[7]) + std::abs(in[8]) + std::abs(in[9]) + std::abs(in[10]) + std::abs(in[11]);
  for (int k = 0; k < 3; ++k) near[k] = std::clamp(in[k], -1.0, 1.0) * extents / 2;
  const double worst = worst_of(boxes.inputs(near, Edges::carried), Edges::carried, triangle);
  const double sides = triangle ? std::abs(in[10]) + 2 * std::abs(in[11]) : 1;
  return detail::ratio(worst, sides * boxes.sum_of_extents()) / u_of_float;
}

/// A gap, and its axis as it is stored, as they are computed.
struct Stored_gap {
  float gap;
  std::array<float, 3> axis;
};

/// The stored gaps of all axes, or of a triangle's two sides.
template <bool fused>
std::vector<Stored_gap> stored_gaps(const Box_test<Float, fused>& test, bool triangle)
{
  namespace simd = kernel::HWY_NAMESPACE;
  const auto largest = simd::largest_gap<true>(test, Keep_all());
  auto found = largest.kept;
  if (triangle) {
    const auto sides =
        simd::beyond_triangle(test, largest.edges, test.boxes.extent[0], test.boxes.extent[1], test.boxes.extent[2]);
    found = Max(simd::gap_beyond(Keep_all(), test, sides.left, sides.left_length, sides.left_normal, Float(0)),
                simd::gap_beyond(Keep_all(), test, sides.right, sides.right_length, sides.right_normal, Float(0)));
  }
  std::vector<Stored_gap> gaps;
  for (const auto& [gap, n0, n1, n2] : found.all) {
    const auto coordinate = [&](int k) { return simd::component_in_frame(test, k, n0, n1, n2).one().computed; };
    gaps.push_back({gap.one().computed, {coordinate(0), coordinate(1), coordinate(2)}});
  }
  return gaps;
}

/// The exact gap along an axis, for boxes whose edges are not rounded. A triangle's axis leads from the other box.
template <bool fused>
Rational exact_gap(const Box_test<Float, fused>& test, const std::array<float, 3>& axis, bool triangle)
{
  Rational way = 0, reach = 0, along[3], of_axis[3];
  for (int k = 0; k < 3; ++k) {
    const Rational n(axis[std::size_t(k)]);
    way += n * (test.box.centre[k].exact - test.boxes.centre[k].one().exact);
    for (int j = 0; j < 3; ++j) {
      along[j] += n * test.box.edge[j][k].exact * test.box.extent[j].exact;
      of_axis[j] += n * test.boxes.axis[j][k].one().exact * test.boxes.extent[j].one().exact;
    }
  }
  for (const Rational& x : of_axis) reach += abs(x);
  if (triangle)
    return Rational(way - reach +
                    std::min({Rational(-along[1] - along[2]), Rational(along[1] - along[2]), Rational(along[2])}));
  for (const Rational& x : along) reach += abs(x);
  return Rational(abs(way) - reach);
}

/// The excess of a computed gap over the exact one.
template <bool triangle>
double certified_gaps(const Inputs& in)
{
  Boxes boxes;
  const std::vector<Float> numbers = boxes.inputs(in, Edges::carried);
  double worst = 0;
  const auto compare = [&](const auto& test) {
    for (const Stored_gap& found : stored_gaps(test, triangle))
      worst = std::max(worst, Rational(Rational(found.gap) - exact_gap(test, found.axis, triangle)).get_d());
  };
  compare(Box_test<Float, true>(numbers, Edges::carried, false, Float(0)));
  compare(Box_test<Float, false>(numbers, Edges::carried, false, Float(0)));
  return detail::ratio(worst, boxes.norm_1_of_single_centre() + boxes.sum_of_extents()) / u_of_float;
}

/// The excess of a stored axis' length over 1.
double stored_length(const Inputs& in)
{
  Boxes boxes;
  const Box_test<Float, true> test(boxes.inputs(in, Edges::carried), Edges::carried, false, Float(0));
  double longest = 0;
  for (const bool triangle : {false, true})
    for (const Stored_gap& found : stored_gaps(test, triangle)) {
      Rational square = 0;
      for (const float n : found.axis) square += Rational(n) * Rational(n);
      longest = std::max(longest, Rational(square - 1).get_d() / 2);
    }
  return longest / u_of_float;
}

/// n . displacement in float, both rounded to float.
double way(const Inputs& in)
{
  using Floats = Axis_number<Float, false>;
  Floats n[3], moved[3];
  double largest = 0, sum = 0;
  const auto rounded = [](double x) { return Float(float(x), Rational(x)); };
  for (int k = 0; k < 3; ++k) {
    n[k] = rounded(in[k]);
    moved[k] = rounded(in[3 + k]);
    largest = std::max(largest, std::abs(in[k]));
    sum += std::abs(in[3 + k]);
  }
  return detail::ratio(kernel::HWY_NAMESPACE::along_axis(n, moved).one().error(), largest * sum) / u_of_float;
}

/// A sweep along an axis: entries are rounded to float.
double sweep(const Inputs& in)
{
  using Place = detail::Sweep_place;
  std::vector<Float> numbers;
  double square = 0, reach = 0, size = 0;
  for (std::size_t k = 0; k < Place::axes; ++k) {
    const double x = in[k];
    numbers.push_back(k < Place::shift ? Float(x) : Float(float(x), Rational(x)));
    if (k < Place::centre) square += x * x;
    if (k >= Place::centre && k < Place::shift) reach = std::max(reach, std::abs(x));
    if (k >= Place::shift) size += (k < Place::bend ? 1 : reach) * std::abs(x);
  }
  for (int j = 0; j < 3; ++j)
    for (const float x : Boxes::column(in, int(Place::axes), j)) numbers.emplace_back(x);
  return detail::ratio(detail::way_of_sweep(numbers).one().error(), std::sqrt(square) * size) / u_of_float;
}

/// The gap along a direction in a frame: rounding errors only.
double distances(const Inputs& in)
{
  Boxes boxes;
  std::vector<Float> numbers = boxes.inputs(in, Edges::carried);
  double sum = 0, worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    numbers.emplace_back(std::abs(in[Boxes::end + k]));
    sum += numbers.back().computed;
  }
  for (const auto frame : {detail::Frame_of::eight, detail::Frame_of::single_box})
    worst = std::max({worst, detail::gap_of_way<true>(numbers, frame, Float(0)).error(),
                      detail::gap_of_way<false>(numbers, frame, Float(0)).error()});
  return detail::ratio(worst, sum * (boxes.norm_1_of_single_centre() + boxes.sum_of_extents())) / u_of_float;
}

/// A coordinate of a placed box's lower end, of entries that are rounded.
double placed(const Inputs& in)
{
  std::vector<Tracked<double>> numbers;
  for (int k = 0; k < 10; ++k) {
    const double x = k < 7 ? in[std::size_t(k)] : std::abs(in[std::size_t(k)]);
    numbers.push_back(k < 4 ? detail::rounded_once<double>(x, in[std::size_t(10 + k)]) : Tracked<double>(x));
  }
  const auto x = detail::placed_coordinate(numbers);
  return detail::ratio((x.at - x.reach).error(), x.terms.computed) / detail::u;
}

/// A coordinate of the image of a box's centre after a step, of entries that are rounded.
double placed_by_step(const Inputs& in)
{
  std::vector<Tracked<double>> numbers(15, Tracked<double>(0));
  numbers[14] = Tracked<double>(1);
  for (int k = 0; k < 7; ++k)
    numbers[std::size_t(4 + k)] = k < 4 ? detail::rounded_once<double>(in[std::size_t(k)], in[std::size_t(10 + k)])
                                        : Tracked<double>(in[std::size_t(k)]);
  const auto row = detail::step_of_row(numbers);
  return detail::ratio((row.at[0] + row.at[1]).error(), row.terms[0].computed + row.terms[1].computed) / detail::u;
}

/// The end of a ray from the holder's origin through a point, and where its box ends, by its centre, direction and
/// extent in float.
double ray(const Inputs& in)
{
  const double length = std::hypot(in[0], in[1], in[2]), end = std::max(2.0, 1.5 * length);
  if (!(length > 0x1p-20)) return 0;
  double square = 0;
  const double extent = float(0.5 * (end - length));
  for (int k = 0; k < 3; ++k) {
    const Rational exact = Rational(in[k]) * Rational(end) / Rational(length);
    const Rational box = Rational(double(float(0.5 * (1 + end / length) * in[k]))) +
                         Rational(extent) * Rational(double(float(in[k] / length)));
    const double off = Rational(exact - box).get_d();
    square += off * off;
  }
  return std::sqrt(square) / end / u_of_float;
}

/// Coordinates along nearly orthonormal axes, and scalar products with them.
double coordinates(const Inputs& in)
{
  using Vector = std::array<double, 3>;
  // Axes of a symmetric defect, and half the largest defect of their products.
  std::array<Vector, 3> axis = {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  constexpr double part = kernel::axis_defect / 8;
  constexpr std::array<std::array<int, 2>, 6> places = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto [i, j] = places[k];
    axis[i][j] += part * in[k];
    if (i != j) axis[j][i] += part * in[k];
  }
  double defect = 0, along = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) defect = std::max(defect, std::abs(kernel::dot(axis[i], axis[j]) - (i == j)));
  Vector y{}, products{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) y[k] += in[6 + i] * axis[i][k];
  for (int i = 0; i < 3; ++i) {
    products[i] = std::abs(kernel::dot(axis[i], y));
    along = std::max(along, products[i]);
  }
  double worst = 0;
  for (int i = 0; i < 3; ++i) worst = std::max(worst, std::abs(in[6 + i]) - products[i]);
  return detail::ratio(worst, defect * along);
}

}  // namespace box_search
}  // namespace

Searches box_searches()
{
  using namespace box_search;
  return {{"box_rounding, boxes of any map", {Boxes::end, any_boxes<Edges::general>}},
          {"box_rounding, rays of containment", {Boxes::end, any_boxes<Edges::given>}},
          {"carried_box_rounding", {Boxes::end, carried_boxes<false>}},
          {"twice carried_box_rounding, sides of a triangle", {Boxes::end, carried_boxes<true>}},
          {"gap_rounding", {Boxes::end, certified_gaps<false>}},
          {"twice gap_rounding, sides of a triangle", {Boxes::end, certified_gaps<true>}},
          {"gap_shrink", {Boxes::end, stored_length}},
          {"Carried_box::way_rounding", {6, way}},
          {"sweep_rounding", {detail::Sweep_place::axes + 4, sweep}},
          {"distance_rounding", {Boxes::end + 3, distances}},
          {"placed_rounding", {14, placed}},
          {"placed_rounding, of steps", {14, placed_by_step}},
          {"Bvh8_containment::ray_rounding", {3, ray}},
          {"axis_defect_factor", {9, coordinates}}};
}

}  // namespace tetracone::verify::proofs
