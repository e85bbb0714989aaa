#ifndef TETRACONE_KERNEL_BOUND_BOUNDS_H
#define TETRACONE_KERNEL_BOUND_BOUNDS_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>

/// Bounding volumes and the tests that separate them, over a rounded number type B (double or float).
///
/// Every test may only answer "separated" or "not known". It is written so that NaN and infinity mean "not known". With
/// `sound` each comparison carries a slack that covers all rounding before it: of the volume, of the pose, and of the
/// test. "Separated" is a proof then. Without `sound` there is no slack, as in the paper's program.
namespace tetracone::kernel {

template <class B>
using Bound_point = std::array<B, 3>;

template <class B>
B norm_1(const Bound_point<B>& a)
{
  using std::abs;
  return abs(a[0]) + abs(a[1]) + abs(a[2]);
}
template <class B>
B squared_length(const Bound_point<B>& a)
{
  return dot(a, a);
}

/// Returns a vertex in the arithmetic of the bounds. The conversion is exact in double and rounds in float.
template <class B>
Bound_point<B> bound_point(const Vertex& v)
{
  return {static_cast<B>(v[0]), static_cast<B>(v[1]), static_cast<B>(v[2])};
}

/// The largest magnitude at which sound tests separate anything. Up to it no expression here overflows.
inline constexpr double separation_gate = 0x1p250;

template <class B>
struct Ball {
  Bound_point<B> centre{};
  B radius = -1;  ///< negative: empty
};

/// A pose in the arithmetic of the bounds, with an upper bound of the error of its images.
///
/// All points that are placed lie in the cube |x|, |y|, |z| <= reach. Let S = max_i sum_j |M_ij| * reach + |t_i|. Three
/// things add to an image's error:
/// - Placing rounds at most 4 times a term: 4.001 u S.
/// - An entry that was a fraction has been rounded once: 1.001 u S.
/// - A point of the cube that was itself computed in the model's frame has at most 2 more roundings: 2.001 u S.
///
/// `error` = 8 u S covers all three. `magnitude` = S (1 + 16 u) is an upper bound of every coordinate. `stretch` is an
/// upper bound of the factor by which M lengthens, since ||M||^2 <= max row sum of |M^T M|.
template <class B, bool sound>
class Bound_frame {
 public:
  static constexpr B u = unit_roundoff<B>;

  // Each is proved in verify/proofs/bound_proofs.h.
  static constexpr B error_rounding = 8 * u,  ///< upper bound of an image's error, relative to S
      stretch_rounding = 32 * u,              ///< upper bound of the relative error of the root of the largest row sum
      magnitude_rounding = 16 * u;            ///< upper bound of the relative error of S as computed

  /// Returns the term of S that one row gives.
  template <class Number>
  static Number reach_of_row(const Number& m0, const Number& m1, const Number& m2, const Number& t, const Number& reach)
  {
    using std::abs;
    return (abs(m0) + abs(m1) + abs(m2)) * reach + abs(t);
  }

  Bound_frame() = default;
  Bound_frame(const Pose& pose, B reach) : identity_(pose.is_identity())
  {
    for (int k = 0; k < 12; ++k) m_[k] = static_cast<B>(pose[k]);
    B largest = 0;
    for (int i = 0; i < 3; ++i)
      largest = maximum(largest, reach_of_row(m_[4 * i], m_[4 * i + 1], m_[4 * i + 2], m_[4 * i + 3], reach));
    magnitude_ = largest * (1 + magnitude_rounding);
    if constexpr (sound) {
      // Beyond the gate a product of three coordinates could overflow: nothing is separated then.
      const bool in_range = reach <= B(separation_gate) && magnitude_ <= B(separation_gate);
      error_ = in_range ? error_rounding * magnitude_ + B(underflow_slack) : std::numeric_limits<B>::infinity();
    }
    B square = 0;
    for (int i = 0; i < 3; ++i) {
      B row = 0;
      for (int j = 0; j < 3; ++j) row += std::abs(dot(column(i), column(j)));
      square = maximum(square, row);  // undefined where products overflow to both sides: no ball of that radius is
                                      // apart from another
    }
    if constexpr (sound) square += B(underflow_slack);
    stretch_ = identity_ ? 1 : std::sqrt(square) * (sound ? 1 + stretch_rounding : 1);
  }

  /// Returns the image of a point, rounded.
  Bound_point<B> operator()(const Bound_point<B>& p) const
  {
    if (identity_) return p;
    const auto row = [&](int i) { return sum(placed_terms(m_[i], m_[i + 1], m_[i + 2], m_[i + 3], p)); };
    return {row(0), row(4), row(8)};
  }

  /// Returns a multiple of M^-1 v, by cofactors, rounded. Multiplied by sign(det M) it is the direction in the model's
  /// frame that the map turns into v, up to a positive factor.
  Bound_point<B> pulled_back(const Bound_point<B>& v) const
  {
    if (identity_) return v;
    Bound_point<B> result{0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      const int p = (i + 1) % 3, q = (i + 2) % 3;
      for (int j = 0; j < 3; ++j) {
        const int k = (j + 1) % 3, l = (j + 2) % 3;
        result[j] += (m_[4 * p + k] * m_[4 * q + l] - m_[4 * p + l] * m_[4 * q + k]) * v[i];
      }
    }
    return result;
  }

  /// Returns an upper bound of the error of a coordinate of an image; 0 unless `sound`.
  B error() const { return error_; }
  /// Returns an upper bound of every coordinate of an image.
  B magnitude() const { return magnitude_; }
  /// Returns an upper bound of the factor by which M lengthens.
  B stretch() const { return stretch_; }
  const std::array<B, 12>& entries() const { return m_; }

 private:
  Bound_point<B> column(int j) const { return {m_[j], m_[4 + j], m_[8 + j]}; }

  std::array<B, 12> m_{};
  B error_ = 0, magnitude_ = 0, stretch_ = 1;
  bool identity_ = true;
};

/// Returns the placed ball: its centre is moved, its radius stretched. A sound radius also grows by the error of the
/// centre, which is sqrt(3) < 2 times a coordinate's error.
template <class B, bool sound>
Ball<B> placed(const Bound_frame<B, sound>& frame, const Ball<B>& ball)
{
  return {frame(ball.centre), ball.radius * frame.stretch() + 2 * frame.error()};
}

/// Upper bound of the relative error of a comparison of squared distances of balls: verify/proofs/bound_proofs.h.
inline constexpr double ball_distance_rounding = 12 * unit_roundoff<double>,
                        /// Upper bound of the relative error of an enclosing ball's radius: the same file.
    ball_radius_rounding = 6 * unit_roundoff<double>;

/// Returns an upper bound of the squared distance at which balls of these radii touch.
template <class Number>
Number touching_distance_2(const Number& a, const Number& b)
{
  const Number radius = a + b;
  return radius * radius * Number(1 + ball_distance_rounding) + Number(underflow_slack);
}

/// True when the two closed balls are found to share no point.
template <class B, bool sound>
bool separated(const Ball<B>& a, const Ball<B>& b)
{
  const B distance_2 = squared_length(difference(a.centre, b.centre)), radius = a.radius + b.radius;
  if constexpr (sound) return distance_2 > touching_distance_2(a.radius, b.radius);
  return distance_2 > radius * radius;
}

/// Returns a ball about `centre` that holds all points. Its radius is the largest distance, rounded up when sound.
template <class B, bool sound>
Ball<B> enclosing_ball(const Bound_point<B>& centre, std::span<const Bound_point<B>> points)
{
  B largest = 0;
  for (const auto& p : points) largest = maximum(largest, squared_length(difference(p, centre)));
  B radius = std::sqrt(largest);
  if constexpr (sound) radius = std::sqrt(largest + B(underflow_slack)) * B(1 + ball_radius_rounding);
  return {centre, radius};
}

/// Returns the mean of the points. Requires at least one.
template <class B>
Bound_point<B> centroid(std::span<const Bound_point<B>> points)
{
  Bound_point<B> sum{0, 0, 0};
  for (const auto& p : points)
    for (int k = 0; k < 3; ++k) sum[k] += p[k] / B(points.size());
  return sum;
}

/// Returns a point near the centre of the smallest enclosing ball (Badoiu & Clarkson 2003). It walks from `start`
/// towards the farthest point in shrinking steps. After n steps the radius is within a factor 1 + O(1/sqrt n) of the
/// smallest.
template <class B>
Bound_point<B> improved_centre(Bound_point<B> start, std::span<const Bound_point<B>> points, int steps)
{
  Bound_point<B> best = start;
  B best_radius = std::numeric_limits<B>::infinity();
  for (int n = 1; n <= steps; ++n) {
    const Bound_point<B>* farthest = nullptr;
    B radius = -1;
    for (const auto& p : points)
      if (const B d = squared_length(difference(p, start)); d > radius) {
        radius = d;
        farthest = &p;
      }
    if (radius < best_radius) {
      best = start;
      best_radius = radius;
    }
    if (farthest == nullptr) break;
    for (int k = 0; k < 3; ++k) start[k] += ((*farthest)[k] - start[k]) / B(n + 1);
  }
  return best;
}

template <class B>
using Bound_tetrahedron = std::array<Bound_point<B>, 4>;

/// Upper bound of the rounding error of an interval between projections on an axis, relative to the larger magnitude
/// times |axis|_1. It has 3 roundings of each dot product and one of the difference. Proved together with
/// `error_rounding` of two frames: verify/proofs/bound_proofs.h.
template <class B>
inline constexpr B projection_rounding = 8 * unit_roundoff<B>;

/// Returns an upper bound of the error of an interval of dot products with an axis, per unit of |axis|_1. It holds for
/// both bodies together: the errors of their points, and rounding.
template <class B, bool sound>
B projection_slack(const Bound_frame<B, sound>& a, const Bound_frame<B, sound>& b)
{
  if constexpr (!sound) return 0;
  return a.error() + b.error() + projection_rounding<B> * maximum(a.magnitude(), b.magnitude());
}

/// The projections of the four corners of a tetrahedron on an axis, and the interval that they span.
template <class B>
struct Projection {
  std::array<B, 4> corner;
  B low, high;

  [[gnu::always_inline]] Projection(const Bound_point<B>& axis, const Bound_tetrahedron<B>& t)
      : corner{dot(axis, t[0]), dot(axis, t[1]), dot(axis, t[2]), dot(axis, t[3])},
        low(minimum(corner[0], corner[1], corner[2], corner[3])),
        high(maximum(corner[0], corner[1], corner[2], corner[3]))
  {}
};

/// True when the projections on `axis` are disjoint by more than slack * |axis|_1, and false where any of these is NaN.
/// The answer is sound for any axis, also for one that rounding has moved.
template <class B, class Interval>
bool separated_along(const Bound_point<B>& axis, const Interval& a, const Interval& b, B slack)
{
  const B allowed = slack == 0 ? 0 : slack * norm_1(axis) + B(underflow_slack);
  return b.low - a.high > allowed || a.low - b.high > allowed;
}

/// True when the two tetrahedra are found to share no point. The axes are the 8 face normals and, with `all_axes`, the
/// 36 cross products of edges. With these the test is complete (separating axis theorem) up to rounding and slack.
///
/// A corner of one may lie between the face and the opposite corner of the other along all four of its normals. Then it
/// is inside the other, and no axis is left to try.
template <class B>
bool separated(const Bound_tetrahedron<B>& a, const Bound_tetrahedron<B>& b, bool all_axes, B slack)
{
  using Edges = std::array<Bound_point<B>, 6>;
  const auto edges_of = [](const Bound_tetrahedron<B>& t) {
    return Edges{difference(t[1], t[0]), difference(t[2], t[0]), difference(t[3], t[0]),
                 difference(t[2], t[1]), difference(t[3], t[1]), difference(t[3], t[2])};
  };
  const Edges e = edges_of(a), f = edges_of(b);
  bool corner_inside = false;
  const auto face_normals_separate = [&](const Bound_tetrahedron<B>& self, const Edges& g,
                                         const Bound_tetrahedron<B>& other) {
    std::array<bool, 4> inside{true, true, true, true};
    // The far face 1 2 3, which separates most often, then 0 1 2, 0 2 3, 0 3 1.
    constexpr std::array<std::array<int, 2>, 4> faces = {{{3, 4}, {0, 1}, {1, 2}, {2, 0}}};
    for (const auto& [i, j] : faces) {
      const Bound_point<B> axis = cross(g[i], g[j]);
      const Projection<B> mine(axis, self), its(axis, other);
      if (separated_along(axis, mine, its, slack)) return true;
      for (int k = 0; k < 4; ++k) inside[k] = inside[k] && mine.low <= its.corner[k] && its.corner[k] <= mine.high;
    }
    corner_inside = corner_inside || inside[0] || inside[1] || inside[2] || inside[3];
    return false;
  };
  if (face_normals_separate(a, e, b) || face_normals_separate(b, f, a)) return true;
  if (!all_axes || corner_inside) return false;
  for (const auto& edge_a : e)
    for (const auto& edge_b : f) {
      const Bound_point<B> axis = cross(edge_a, edge_b);
      if (separated_along(axis, Projection<B>(axis, a), Projection<B>(axis, b), slack)) return true;
    }
  return false;
}

/// A half-space that holds a body, in the body's frame: normal . (x - origin) <= offset for every point x of the body.
template <class B>
struct Half_space {
  Bound_point<B> normal, origin;
  B offset;
};

/// A half-space placed with its body, which tells the points of another body that lie strictly beyond it.
///
/// With C the cofactors of M, N = C n: N . (Mx - MO) = det M (n . (x - O)), so sign(det M) N . (y - y_O) <= |det M|
/// offset for every image y. A component N_i is a determinant with n. Its error is a fraction of its permanent A_i, and
/// |y - y_O| <= 2 magnitude. The error of det M is a fraction of its own permanent. `threshold` takes all of these, and
/// the slack of a projection on N^ covers the points asked.
///
/// Products that underflow, and the nearest double below 2^-1022 of a fraction, have an absolute error e = 2^-1075
/// before they are multiplied with other entries: see `absolute_error`.
template <class B, bool sound>
class Placed_half_space {
 public:
  static constexpr B u = unit_roundoff<B>;

  // Both are proved in verify/proofs/bound_proofs.h.
  static constexpr B determinant_rounding = 16 * u,  ///< error of |det M| offset, over the permanent times offset
      normal_rounding = 32 * u;  ///< error of N . (y - y_O), over the sum of the A_i times `magnitude`

  Placed_half_space(const Bound_frame<B, sound>& frame, const Half_space<B>& half_space, int determinant_sign)
  {
    const auto& m = frame.entries();
    const auto row = [&m](int i) { return Bound_point<B>{m[4 * i], m[4 * i + 1], m[4 * i + 2]}; };
    B absolute_sum = 0;
    for (int i = 0; i < 3; ++i) {
      const Bound_point<B> p = row((i + 1) % 3), q = row((i + 2) % 3);
      normal_[i] = B(determinant_sign) * determinant(p, q, half_space.normal);
      absolute_sum += permanent(p, q, half_space.normal);
    }
    origin_ = frame(half_space.origin);
    const B volume = std::abs(determinant(row(1), row(2), row(0)));
    threshold_ = volume * half_space.offset;
    if constexpr (sound) {
      B largest = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) largest = maximum(largest, std::abs(m[4 * i + j]));
      threshold_ =
          sound_threshold(volume, permanent(row(1), row(2), row(0)), half_space.offset, absolute_sum, frame.magnitude(),
                          absolute_error(largest, norm_1(half_space.normal), half_space.offset, frame.magnitude()));
    }
  }

  /// Returns the threshold: |det M| offset, and upper bounds of all errors.
  template <class Number>
  static Number sound_threshold(const Number& volume, const Number& permanent, const Number& offset,
                                const Number& absolute_sum, const Number& magnitude, const Number& absolute)
  {
    return (volume * offset + Number(determinant_rounding) * permanent * offset +
            Number(normal_rounding) * absolute_sum * magnitude) *
               Number(1 + few_roundings) +
           absolute;
  }

  /// A factor of the terms of `absolute_error`: 32 e.
  static constexpr double entry_underflow = 0x1p-1070;

  /// Returns an upper bound of the absolute errors of N . (y - y_O) and of det M times the offset, for entries up to
  /// `entry` and |n|_1 = `normal`. A minor has an error of at most (4 entry + 3) e. N multiplies it with n and then
  /// with a difference of points, |y - y_O|_1 <= 6 magnitude. The error of det M is at most (18 entry^2 + 9 entry + 3)
  /// e.
  template <class Number>
  static Number absolute_error(const Number& entry, const Number& normal, const Number& offset, const Number& magnitude)
  {
    const Number one = Number(1), larger = one + entry;
    return Number(entry_underflow) * larger * ((one + normal) * magnitude + larger * offset) + Number(underflow_slack);
  }

  /// True when the point lies strictly beyond the body's half-space. `slack` is the `projection_slack` of both bodies.
  bool is_beyond(const Bound_point<B>& point, B slack) const
  {
    return dot(normal_, difference(point, origin_)) > threshold_ + slack * norm_1(normal_);
  }

 private:
  Bound_point<B> normal_{}, origin_{};
  B threshold_ = 0;
};

/// An axis-aligned box of the placed points of an edge or of a face, grown by the error of the frame that placed them.
/// A bound that is NaN separates the box from no other.
template <class B>
struct Box {
  Bound_point<B> low, high;

  Box()
  {
    low.fill(std::numeric_limits<B>::infinity());
    high.fill(-std::numeric_limits<B>::infinity());
  }

  void add(const Bound_point<B>& p)
  {
    for (int k = 0; k < 3; ++k) {
      low[k] = minimum(low[k], p[k]);
      high[k] = maximum(high[k], p[k]);
    }
  }
  void grow(B margin)
  {
    for (int k = 0; k < 3; ++k) {
      low[k] -= margin;
      high[k] += margin;
    }
  }
  bool meets(const Box& other) const
  {
    return !(low[0] > other.high[0] || other.low[0] > high[0] || low[1] > other.high[1] || other.low[1] > high[1] ||
             low[2] > other.high[2] || other.low[2] > high[2]);
  }
};

}  // namespace tetracone::kernel

#endif
