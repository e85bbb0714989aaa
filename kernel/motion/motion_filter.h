#ifndef TETRACONE_KERNEL_MOTION_MOTION_FILTER_H
#define TETRACONE_KERNEL_MOTION_MOTION_FILTER_H

#include "tetracone/kernel/motion/motion_forms.h"
#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::kernel {

/// The answer of a stage about a moving pair.
enum class Moving_contact { apart, meet, uncertain };

/// The knowledge about the volume of the four points before the filter looks at it; `zero` means zero all the time.
enum class Volume { unknown, zero };

namespace motion_filter {

/// The largest number of nested halvings of [0, 1].
inline constexpr int halvings = 24;

/// Upper bounds of the rounding errors of `Scaled` forms of differences, after up to `halvings` halvings
/// (verify/proofs/motion_proofs.h). They are relative to the product of the extents of the axes that occur. The extent
/// D of an axis is the largest computed |difference| along it.
///
/// Differences have a relative error of u. A minor a_i b_j - a_j b_i is a difference of two products, each with an
/// error of 3u. With its own rounding of at most 2u that is 8u, and it is at most 2 in magnitude. The middle
/// coefficient of a cross product is the sum of two: 16u + 4u = 20u, at most 4; the others are doubled, 16u, at most 4.
/// A halving takes two rounds of averages, each with an error of u of its result, and averages the errors before it:
/// 8u.
///
/// n1 + n2 + n3 (`sum_error`) has three times that, and two sums of at most 8 and 12: 60u + 20u, 12 in magnitude, 24u a
/// halving.
///
/// Volume: a product n_i c_i has an error of 8u + 4u of 2, for the middle minor 20u + 8u of 4. Three of them and two
/// sums give 36u + 10u, at most 6, and 84u + 20u, at most 12. Inner coefficients add one of either: 150u + 18u, at most
/// 18. Outer ones are tripled: 138u + 18u. Three rounds of averages: 54u a halving.
///
/// Each constant has about a tenth beyond that, for terms in u^2 and for the rounding of the bound itself.
inline constexpr double cross_error = (22 + 9 * halvings) * unit_roundoff<double>;
inline constexpr double sum_error = (88 + 27 * halvings) * unit_roundoff<double>;
inline constexpr double volume_error = (185 + 60 * halvings) * unit_roundoff<double>;

/// Upper bound of the error of forms that are rounded once, each coefficient by less than 2u of itself, none beyond 1
/// (verify/proofs/motion_proofs.h). Outer coefficients are tripled at most, 6u + 3u. Three rounds of averages add 9u a
/// halving.
inline constexpr double rounded_error = (10 + 10 * halvings) * unit_roundoff<double>;

/// A form by its coefficients in Bernstein's basis, times its degree. Averages of neighbours halve the time that it is
/// over. Where all coefficients have one sign, the form has that sign.
template <std::size_t N, class Number = double>
using Scaled = std::array<Number, N>;

template <class Number>
Scaled<3, Number> scaled(const Quadratic_form<Number>& q)
{
  return {Number(2) * q[0], q[1], Number(2) * q[2]};
}
template <class Number>
Scaled<4, Number> scaled(const Cubic_form<Number>& q)
{
  return {Number(3) * q[0], q[1], q[2], Number(3) * q[3]};
}

inline double halved(double x) { return x * 0.5; }

/// Returns the form over the second half of its time; `form` becomes the form over the first half.
template <std::size_t N, class Number>
Scaled<N, Number> halve(std::array<Number, N>& form)
{
  Scaled<N, Number> second;
  for (std::size_t round = 0; round < N; ++round) {
    second[N - 1 - round] = form[N - 1];
    for (std::size_t k = N - 1; k > round; --k) form[k] = halved(form[k - 1] + form[k]);
  }
  return second;
}

/// Returns 1 or -1 where the form certainly has that sign all the time, else 0. NaN is never certain.
template <std::size_t N>
int certain_sign(const Scaled<N>& form, double error)
{
  bool positive = true, negative = true;
  for (const double x : form) {
    positive = positive && x > error;
    negative = negative && x < -error;
  }
  return positive - negative;
}

/// The forms over a span of time: volume, and for each axis n1, n2, n3 and, for two edges, their sum.
struct Span {
  Scaled<4> volume;
  std::array<std::array<Scaled<3>, 4>, 3> turns;
};

/// Upper bounds of the errors of a span's forms and of all their halves.
struct Errors {
  double volume;
  std::array<std::array<double, 4>, 3> turns;
};

/// Returns whether the primitives, projected along the axis of these turns, are apart or cross properly all the time of
/// the span.
inline Moving_contact projected(Moving_kind kind, const std::array<Scaled<3>, 4>& n,
                                const std::array<double, 4>& errors)
{
  const auto sign = [&](std::size_t k) { return certain_sign(n[k], errors[k]); };
  const int n1 = sign(0), n2 = sign(1), n3 = sign(2);
  if (kind == Moving_kind::vertex_face) {
    if (n1 * n2 < 0 || n2 * n3 < 0 || n3 * n1 < 0) return Moving_contact::apart;
    return n1 * n2 > 0 && n2 * n3 > 0 ? Moving_contact::meet : Moving_contact::uncertain;
  }
  if (n1 * n3 < 0) return Moving_contact::apart;
  const int other = n2 == 0 ? 0 : n2 * sign(3);
  if (other > 0) return Moving_contact::apart;
  return other < 0 && n1 * n3 > 0 ? Moving_contact::meet : Moving_contact::uncertain;
}

/// Returns whether the primitives meet in the span, which is halved up to `halvings_left` times.
inline Moving_contact decide(Moving_kind kind, Volume known, Span span, const Errors& errors, int halvings_left)
{
  if (known == Volume::unknown && certain_sign(span.volume, errors.volume) != 0) return Moving_contact::apart;
  // A proper contact along one axis is a contact in space, where the four points are coplanar: the projection of their
  // plane is not flat.
  bool crosses = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Moving_contact seen = projected(kind, span.turns[axis], errors.turns[axis]);
    if (seen == Moving_contact::apart) return Moving_contact::apart;
    crosses = crosses || seen == Moving_contact::meet;
  }
  const double first = span.volume.front(), last = span.volume.back();
  const bool coplanar_once = known == Volume::zero || (first > errors.volume && last < -errors.volume) ||
                             (first < -errors.volume && last > errors.volume);
  if (crosses && coplanar_once) return Moving_contact::meet;
  if (halvings_left == 0) return Moving_contact::uncertain;
  Span second;
  second.volume = halve(span.volume);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < 4; ++k) second.turns[axis][k] = halve(span.turns[axis][k]);
  const Moving_contact before = decide(kind, known, span, errors, halvings_left - 1);
  // After an uncertain first half, only a contact in the second would decide, which is rare. So it is not looked at.
  if (before != Moving_contact::apart) return before;
  return decide(kind, known, second, errors, halvings_left - 1);
}

/// The forms of a pair over [0, 1], and the bounds of their errors.
struct Forms {
  Span span;
  Errors errors;
  bool in_range;  ///< nothing overflows
};

inline Forms forms(const Moving_pair& pair)
{
  const Moving_point& o = pair.points[0];
  const auto difference = [&](const Moving_point& to) {
    Linear_vector<double> d;
    for (std::size_t axis = 0; axis < 3; ++axis) d[axis] = {to.start[axis] - o.start[axis], to.end[axis] - o.end[axis]};
    return d;
  };
  const Linear_vector<double> a = difference(pair.points[1]), b = difference(pair.points[2]),
                              c = difference(pair.points[3]);
  std::array<double, 3> extent;
  for (std::size_t axis = 0; axis < 3; ++axis)
    extent[axis] = maximum(std::abs(a[axis][0]), std::abs(a[axis][1]), std::abs(b[axis][0]), std::abs(b[axis][1]),
                           std::abs(c[axis][0]), std::abs(c[axis][1]));
  Forms all;
  all.in_range = extent[0] <= magnitude_gate && extent[1] <= magnitude_gate && extent[2] <= magnitude_gate;
  std::array<Quadratic_form<double>, 3> n1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto& turns = all.span.turns[axis];
    n1[axis] = cross_form(a, b, axis);
    turns[0] = scaled(n1[axis]);
    turns[1] = scaled(cross_form(b, c, axis));
    turns[2] = scaled(cross_form(c, a, axis));
    for (std::size_t k = 0; k < 3; ++k) turns[3][k] = turns[0][k] + turns[1][k] + turns[2][k];
    const double area = extent[(axis + 1) % 3] * extent[(axis + 2) % 3];
    const double cross = cross_error * area + underflow_slack;
    all.errors.turns[axis] = {cross, cross, cross, sum_error * area + underflow_slack};
  }
  all.span.volume = scaled(dot_form(n1, c));
  all.errors.volume = volume_error * (extent[0] * extent[1] * extent[2]) + underflow_slack;
  return all;
}

}  // namespace motion_filter

/// True where the boxes of the primitives are apart along an axis at both ends, all differences of one sign: then all
/// the time. It compares doubles alone, so it is exact.
inline bool apart_along_an_axis(const Moving_pair& pair)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto all = [&](auto order) {
      return all_differences(pair.kind, [&](const Between& d) {
        const Moving_point &from = pair.points[d.from], &to = pair.points[d.to];
        return order(from.start[axis], to.start[axis]) && order(from.end[axis], to.end[axis]);
      });
    };
    if (all([](double x, double y) { return x < y; }) || all([](double x, double y) { return x > y; })) return true;
  }
  return false;
}

/// Returns whether the pair meets, in doubles with bounds of their errors. [0, 1] is halved where a sign is not
/// certain. The answers apart and meet are proved.
inline Moving_contact filtered_contact(const Moving_pair& pair)
{
  if (apart_along_an_axis(pair)) return Moving_contact::apart;
  const motion_filter::Forms forms = motion_filter::forms(pair);
  if (!forms.in_range) return Moving_contact::uncertain;
  return motion_filter::decide(pair.kind, Volume::unknown, forms.span, forms.errors, motion_filter::halvings);
}

}  // namespace tetracone::kernel

#endif
