#include "verify/cases/case_numbers.h"

#include <bit>
#include <cmath>
#include <cstdlib>

namespace tetracone::verify {

Case_numbers numbers_of(const Object_case& c) { return {{c.a->vertices, c.b->vertices}, {c.pose_a, c.pose_b}}; }
Case_numbers numbers_of(const Predicate_case& c)
{
  return {{{{c.v.begin(), c.v.end()}, {c.p, c.q, c.r}}}, {c.pose_a, c.pose_b}};
}

std::array<std::array<kernel::Number_point<kernel::Rational>, 3>, 2> placed_triangles(const Predicate_case& c)
{
  const auto placed = [](const std::array<kernel::Vertex, 3>& corners, const kernel::Pose& pose) {
    std::array<kernel::Rational, 12> m;
    for (int k = 0; k < 12; ++k) m[std::size_t(k)] = pose.exact(k);
    return std::array{kernel::image(corners[0], m), kernel::image(corners[1], m), kernel::image(corners[2], m)};
  };
  return {placed({c.v[1], c.v[2], c.v[3]}, c.pose_a), placed({c.p, c.q, c.r}, c.pose_b)};
}

Object_case with_numbers(const Object_case& c, const Case_numbers& numbers)
{
  const auto body = [](const std::shared_ptr<const covering::Polyhedron>& old,
                       const std::vector<kernel::Vertex>& points) {
    if (points == old->vertices) return old;
    auto moved = std::make_shared<covering::Polyhedron>(*old);
    moved->vertices = points;
    return std::shared_ptr<const covering::Polyhedron>(moved);
  };
  return {
      body(c.a, numbers.points[0]), body(c.b, numbers.points[1]), numbers.poses[0], numbers.poses[1], c.origin, {}, {}};
}

Predicate_case with_numbers(const Predicate_case& c, const Case_numbers& numbers)
{
  Predicate_case result{
      {},      numbers.points[1][0], numbers.points[1][1], numbers.points[1][2], numbers.poses[0], numbers.poses[1],
      c.origin};
  std::copy_n(numbers.points[0].begin(), 4, result.v.begin());
  return result;
}

Odd odd(double x)
{
  if (x == 0) return {};
  int exponent;
  const double fraction = std::frexp(std::abs(x), &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(digits);
  return {digits >> zeros, exponent - 53 + zeros};
}

std::size_t bits(double x)
{
  const Odd parts = odd(x);
  return std::bit_width(parts.mantissa) + std::bit_width(unsigned(std::abs(parts.exponent)));
}

std::size_t bits(const kernel::Rational& x)
{
  const double nearest = kernel::nearest_double(x);
  if (kernel::Rational(nearest) == x) return bits(nearest);
  // A decimal digit is 3.3 binary ones; the slash is one of them.
  return kernel::to_string(x).size() * 10 / 3;
}

std::size_t bits(const Case_numbers& numbers)
{
  std::size_t sum = 0;
  const kernel::Pose identity;
  for (int body = 0; body < 2; ++body) {
    for (const kernel::Vertex& point : numbers.points[body])
      for (const double x : point) sum += bits(x);
    const kernel::Pose& pose = numbers.poses[body];
    for (int k = 0; k < 12; ++k) {
      if (pose.is_rational())
        sum += pose.exact(k) == kernel::Rational(identity[k]) ? 0 : 1 + bits(pose.exact(k));
      else
        sum += pose[k] == identity[k] ? 0 : 1 + bits(pose[k]);
    }
  }
  return sum;
}

}  // namespace tetracone::verify
