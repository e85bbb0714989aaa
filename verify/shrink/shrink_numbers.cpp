#include "verify/shrink/shrink_numbers.h"

#include "verify/cases/exact_motion.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>

namespace tetracone::verify {
namespace {

using kernel::Pose;
using kernel::Rational;
using kernel::Vertex;

/// The multiple of 2^exponent nearest to x; never -0.
double on_grid(double x, int exponent) { return std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent) + 0.0; }

bool is_finite(double x) { return std::isfinite(x); }

/// Simpler numbers in place of x, the simplest first.
std::vector<double> simpler(double x)
{
  std::vector<double> values = {0, std::copysign(1.0, x), -std::copysign(1.0, x)};
  if (std::abs(x) < 0x1p40) values.insert(values.end(), {std::nearbyint(x) + 0.0, std::floor(x), std::ceil(x) + 0.0});
  int exponent;
  const double fraction = std::frexp(x, &exponent);
  const int digits = std::bit_width(odd(x).mantissa);
  for (const int kept : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 40, 48, digits - 2, digits - 1}) {
    if (kept < 1 || kept >= digits) continue;
    values.push_back(on_grid(x, exponent - kept));
    values.push_back(std::ldexp(std::trunc(std::ldexp(fraction, kept)), exponent - kept));
  }
  values.push_back(2 * fraction);                               // exponent 0
  values.push_back(std::copysign(double(odd(x).mantissa), x));  // an integer of the same digits
  std::erase_if(values, [x](double value) { return !std::isfinite(value) || value == x || bits(value) > bits(x); });
  return values;
}

/// Simpler rationals in place of x, which is no double: multiples of powers of two, the coarsest first.
std::vector<Rational> simpler(const Rational& x)
{
  std::vector<Rational> values;
  const double nearest = kernel::nearest_double(x);
  if (nearest == 0 || std::abs(std::ilogb(nearest)) > 400) return values;
  for (const double value : simpler(nearest)) values.push_back(value);
  values.push_back(nearest);
  // What rounding to double leaves, rounded itself.
  const double rest = kernel::nearest_double(Rational(x - Rational(nearest)));
  if (rest == 0 || std::ilogb(rest) < -1000) return values;
  for (const int kept : {1, 2, 4, 8, 16, 32, 53})
    values.push_back(Rational(Rational(nearest) + Rational(on_grid(rest, std::ilogb(rest) + 1 - kept))));
  return values;
}

class Simplify {
 public:
  Simplify(Case_numbers& numbers, const std::function<bool(const Case_numbers&)>& accept)
      : numbers_(numbers), accept_(accept), bits_(bits(numbers))
  {}

  bool run()
  {
    poses();
    common_frames();
    scales();
    grids();
    equal_coordinates();
    coordinates();
    entries();
    return changed_;
  }

 private:
  bool keep(const Case_numbers& candidate)
  {
    const std::size_t size = bits(candidate);
    if (size >= bits_ || !accept_(candidate)) return false;
    numbers_ = candidate;
    bits_ = size;
    return changed_ = true;
  }

  /// A change of a copy of the numbers; it returns false where it is impossible.
  template <class Change>
  bool with(Change&& change)
  {
    Case_numbers candidate = numbers_;
    return change(candidate) && keep(candidate);
  }

  bool with_pose(int body, const std::optional<Pose>& pose)
  {
    return pose && with([&](Case_numbers& n) {
             n.poses[body] = *pose;
             return true;
           });
  }

  static bool move_points(std::vector<Vertex>& points, const auto& change)
  {
    for (Vertex& point : points) {
      const std::optional<Vertex> moved = change(point);
      if (!moved) return false;
      point = *moved;
    }
    return true;
  }

  void poses()
  {
    with([](Case_numbers& n) {
      n.poses = {};
      return true;
    });
    // The images for the points.
    for (int body = 0; body < 2; ++body)
      with([&](Case_numbers& n) {
        const Pose pose = n.poses[body];
        n.poses[body] = Pose();
        return move_points(n.points[body], [&](const Vertex& v) { return exact_image(pose, v); });
      });
    // One seen from the other.
    for (int body = 0; body < 2; ++body)
      with([&](Case_numbers& n) {
        const auto relative = seen_from(n.poses[body], n.poses[1 - body]);
        if (!relative) return false;
        n.poses[body] = Pose();
        n.poses[1 - body] = *relative;
        return true;
      });
    for (int body = 0; body < 2; ++body) {
      with_pose(body, Pose());
      Entries m = entries_of(numbers_.poses[body]);
      for (int row = 0; row < 3; ++row) m[4 * row + 3] = 0;
      with_pose(body, exact_pose(m, true));
      m = entries_of(numbers_.poses[body]);
      for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 3; ++k) m[4 * row + k] = row == k;
      with_pose(body, exact_pose(m, true));
      with_pose(body, near_permutation(numbers_.poses[body]));
      with_pose(body, Pose(numbers_.poses[body].entries()));
    }
  }

  /// The signed permutation of each row's largest entry; nothing when two rows have it in one column.
  static std::optional<Pose> near_permutation(const Pose& pose)
  {
    Entries m = entries_of(pose);
    std::set<int> columns;
    for (int row = 0; row < 3; ++row) {
      int largest = 0;
      for (int k = 1; k < 3; ++k)
        if (abs(m[4 * row + k]) > abs(m[4 * row + largest])) largest = k;
      columns.insert(largest);
      for (int k = 0; k < 3; ++k) m[4 * row + k] = k == largest ? sgn(m[4 * row + k]) : 0;
    }
    return columns.size() == 3 ? exact_pose(m, true) : std::nullopt;
  }

  /// Moves a point to the origin of its frame, or of the world, by an exact translation.
  void common_frames()
  {
    for (int body = 0; body < 2; ++body)
      for (std::size_t i = 0; i < numbers_.points[body].size(); ++i) {
        with([&](Case_numbers& n) {
          const Vertex to = n.points[body][i];
          const auto pose = translated_back(n.poses[body], {-to[0], -to[1], -to[2]});
          if (!pose) return false;
          n.poses[body] = *pose;
          return move_back(n.points[body], to);
        });
        with([&](Case_numbers& n) {
          const Vertex to = n.points[body][i];
          return n.poses[0].is_identity() && n.poses[1].is_identity() && move_back(n.points[0], to) &&
                 move_back(n.points[1], to);
        });
      }
    for (int row = 0; row < 3; ++row)
      for (int body = 0; body < 2; ++body)
        with([&](Case_numbers& n) {
          std::array<Rational, 3> shift = {0, 0, 0};
          shift[row] = -n.poses[body].exact(4 * row + 3);
          for (Pose& pose : n.poses) {
            const auto moved = translated(pose, shift);
            if (!moved) return false;
            pose = *moved;
          }
          return true;
        });
  }

  static bool move_back(std::vector<Vertex>& points, const Vertex& by)
  {
    return move_points(points, [&](const Vertex& v) { return exact_sum(v, {-by[0], -by[1], -by[2]}); });
  }

  void scales()
  {
    // Everything; then one body; then one axis of points that nothing turns.
    for (const int exponent : exponents({0, 1}, 0, 3))
      with([&](Case_numbers& n) {
        for (int body = 0; body < 2; ++body) {
          const auto pose = scaled(n.poses[body], exponent);
          if (!pose || !move_points(n.points[body], [&](const Vertex& v) { return exact_scaled(v, exponent); }))
            return false;
          n.poses[body] = *pose;
        }
        return true;
      });
    for (int body = 0; body < 2; ++body)
      for (const int exponent : exponents({body}, 0, 3))
        with([&](Case_numbers& n) {
          return move_points(n.points[body], [&](const Vertex& v) { return exact_scaled(v, exponent); });
        });
    for (int axis = 0; axis < 3; ++axis)
      for (const int exponent : exponents({0, 1}, axis, axis + 1))
        with([&](Case_numbers& n) {
          for (auto& points : n.points)
            if (!move_points(points, [&](Vertex v) -> std::optional<Vertex> {
                  const auto coordinate = exact_scaled(v[axis], exponent);
                  if (!coordinate) return std::nullopt;
                  v[axis] = *coordinate;
                  return v;
                }))
              return false;
          return true;
        });
  }

  /// Powers of two by which coordinates of these axes become integers, or at most 1.
  std::vector<int> exponents(std::initializer_list<int> bodies, int from_axis, int to_axis) const
  {
    std::optional<int> lowest, highest;
    for (const int body : bodies)
      for (const Vertex& v : numbers_.points[body])
        for (int k = from_axis; k < to_axis; ++k) {
          if (v[k] == 0) continue;
          const int exponent = odd(v[k]).exponent;
          lowest = std::min(lowest.value_or(exponent), exponent);
          highest = std::max(highest.value_or(std::ilogb(v[k])), std::ilogb(v[k]));
        }
    if (!lowest) return {};
    // 2^exponent itself has to be a double.
    std::vector<int> result = {-*lowest, -*highest};
    std::erase_if(result, [](int exponent) { return exponent == 0 || std::abs(exponent) > 1000; });
    return result;
  }

  /// All coordinates, translations too, on one grid, the coarsest first; then one body's.
  void grids()
  {
    double largest = 0;
    for (const auto& points : numbers_.points)
      for (const Vertex& v : points) largest = std::max(largest, magnitude(v));
    if (largest == 0) return;
    for (const int fine : {0, 1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 32, 40, 48, 51}) {
      const int exponent = std::ilogb(largest) - fine;
      const auto all = [&](Case_numbers& n, int body) {
        for (Vertex& v : n.points[body])
          for (double& x : v) x = on_grid(x, exponent);
        std::array<double, 12> m = n.poses[body].entries();
        for (int row = 0; row < 3; ++row) m[4 * row + 3] = on_grid(m[4 * row + 3], exponent);
        if (!std::all_of(m.begin(), m.end(), is_finite)) return false;
        if (!n.poses[body].is_rational()) n.poses[body] = Pose(m);
        return std::all_of(n.points[body].begin(), n.points[body].end(),
                           [&](const Vertex& v) { return std::all_of(v.begin(), v.end(), is_finite); });
      };
      if (with([&](Case_numbers& n) { return all(n, 0) && all(n, 1); })) return;
      for (int body = 0; body < 2; ++body) with([&](Case_numbers& n) { return all(n, body); });
    }
  }

  /// Changes equal coordinates of an axis together, so that flat faces stay flat.
  void equal_coordinates()
  {
    for (int body = 0; body < 2; ++body)
      for (int axis = 0; axis < 3; ++axis) {
        std::set<double> values;
        for (const Vertex& v : numbers_.points[body]) values.insert(v[axis]);
        for (const double value : values)
          for (const double other : simpler(value))
            if (with([&](Case_numbers& n) {
                  for (Vertex& v : n.points[body])
                    if (v[axis] == value) v[axis] = other;
                  return true;
                }))
              break;
      }
  }

  void coordinates()
  {
    for (int body = 0; body < 2; ++body)
      for (std::size_t i = 0; i < numbers_.points[body].size(); ++i) {
        with([&](Case_numbers& n) {
          n.points[body][i] = {0, 0, 0};
          return true;
        });
        for (int axis = 0; axis < 3; ++axis)
          for (const double value : simpler(numbers_.points[body][i][axis]))
            if (with([&](Case_numbers& n) {
                  n.points[body][i][axis] = value;
                  return true;
                }))
              break;
      }
  }

  void entries()
  {
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 12; ++k)
        for (const Rational& value : simpler_entries(numbers_.poses[body], k)) {
          Entries m = entries_of(numbers_.poses[body]);
          m[k] = value;
          if (with_pose(body, exact_pose(m, true))) break;
        }
  }

  static std::vector<Rational> simpler_entries(const Pose& pose, int k)
  {
    if (Rational(pose[k]) != pose.exact(k)) return simpler(pose.exact(k));
    const std::vector<double> values = simpler(pose[k]);
    return {values.begin(), values.end()};
  }

  Case_numbers& numbers_;
  const std::function<bool(const Case_numbers&)>& accept_;
  std::size_t bits_;
  bool changed_ = false;
};

}  // namespace

bool simplify(Case_numbers& numbers, const std::function<bool(const Case_numbers&)>& accept)
{
  return Simplify(numbers, accept).run();
}

}  // namespace tetracone::verify
