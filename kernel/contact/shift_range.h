#ifndef TETRACONE_KERNEL_CONTACT_SHIFT_RANGE_H
#define TETRACONE_KERNEL_CONTACT_SHIFT_RANGE_H

#include "tetracone/kernel/contact/corner_errors.h"
#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/interval.h"
#include "tetracone/kernel/number/number.h"

#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// By how much a convex polygon of A has to rise for it to meet one of B.
///
/// Heights are along z, as in `Direction_view`. N is `Rational`, or `Interval` in a block of upward rounding.
/// Pieces may have integer corners, too. Rounded pieces give intervals that are a little wider, and take a fraction of
/// the time.
namespace tetracone::kernel {

/// A convex polygon with area: its corners in order, of which no three are on one line.
template <class N>
struct Convex_piece {
  std::array<Number_point<N>, 4> corner;
  int count = 0;  ///< 3 or 4
};

/// A piece in integers: its corners are those in space, times a positive denominator.
struct Integer_piece : Convex_piece<mpz_class> {
  mpz_class denominator = 1;

  Integer_piece() = default;
  explicit Integer_piece(const Convex_piece<Rational>& piece)
  {
    count = piece.count;
    for (int k = 0; k < count; ++k)
      for (const Rational& x : piece.corner[k]) denominator = lcm(denominator, x.get_den());
    for (int k = 0; k < count; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const Rational& x = piece.corner[k][i];
        corner[k][i] = x.get_num() * (denominator / x.get_den());
      }
  }
};

/// True where coordinates are at most 2^200, so that no sum or product of `Shift_range` overflows.
inline bool is_bounded(const Convex_piece<Interval>& piece)
{
  for (int k = 0; k < piece.count; ++k)
    for (const Interval& x : piece.corner[k])
      if (!(x.inf() >= -0x1p200 && x.sup() <= 0x1p200)) return false;
  return true;
}

/// A piece in rounded numbers, with upper bounds of their errors.
struct Rounded_piece : Convex_piece<double> {
  Corner_errors errors;

  Rounded_piece() = default;
  /// Requires a block of upward rounding, and a piece that `is_bounded`.
  explicit Rounded_piece(const Convex_piece<Interval>& piece)
  {
    count = piece.count;
    for (int k = 0; k < count; ++k) corner[k] = errors.rounded(piece.corner[k]);
    for (int k = 0; k < count; ++k) errors.add_edge(difference(corner[(k + 1) % count], corner[k]));
    errors.add_edge(difference(corner[2], corner[0]));
  }
};

/// An axis along which two pieces are compared. It is a normal, or a product of an edge of each, or of an edge and the
/// direction of the shift.
struct Shift_axis {
  enum class Kind {
    edge_of_a,    ///< an edge of A and the direction of the shift
    edge_of_b,    ///< an edge of B and that direction
    normal_of_a,  ///< the normal of A's piece
    normal_of_b,  ///< the normal of B's piece
    edges         ///< an edge of each
  } kind;
  int edge_a = 0, edge_b = 0;  ///< numbers of edges: edge k leads from corner k to the next
};

namespace detail {

inline double lower(const Interval& x) { return x.inf(); }
inline double upper(const Interval& x) { return x.sup(); }
inline const Rational& lower(const Rational& x) { return x; }
inline const Rational& upper(const Rational& x) { return x; }

inline Interval least(const Interval& x, const Interval& y)
{
  return {minimum(x.inf(), y.inf()), minimum(x.sup(), y.sup())};
}
inline Interval largest(const Interval& x, const Interval& y)
{
  return {maximum(x.inf(), y.inf()), maximum(x.sup(), y.sup())};
}
inline double least(double x, double y) { return x < y ? x : y; }
inline double largest(double x, double y) { return x > y ? x : y; }
inline Rational least(const Rational& x, const Rational& y) { return x < y ? x : y; }
inline Rational largest(const Rational& x, const Rational& y) { return x > y ? x : y; }
inline mpz_class least(const mpz_class& x, const mpz_class& y) { return x < y ? x : y; }
inline mpz_class largest(const mpz_class& x, const mpz_class& y) { return x > y ? x : y; }

template <class N>
bool may_be_zero(const Number_point<N>& x)
{
  return lower(x[0]) <= 0 && upper(x[0]) >= 0 && lower(x[1]) <= 0 && upper(x[1]) >= 0 && lower(x[2]) <= 0 &&
         upper(x[2]) >= 0;
}

template <class N>
Number_point<N> edge(const Convex_piece<N>& piece, int k)
{
  return difference(piece.corner[(k + 1) % piece.count], piece.corner[k]);
}
template <class N>
Number_point<N> normal(const Convex_piece<N>& piece)
{
  return cross(edge(piece, 0), difference(piece.corner[2], piece.corner[0]));
}
/// Returns a direction across z that is perpendicular to the edge.
template <class N>
Number_point<N> beside(const Number_point<N>& edge)
{
  return {N(-edge[1]), edge[0], N(0)};
}

/// Returns the direction of an axis.
template <class N>
Number_point<N> direction(const Shift_axis& axis, const Convex_piece<N>& a, const Convex_piece<N>& b)
{
  switch (axis.kind) {
    case Shift_axis::Kind::edge_of_a: return beside(edge(a, axis.edge_a));
    case Shift_axis::Kind::edge_of_b: return beside(edge(b, axis.edge_b));
    case Shift_axis::Kind::normal_of_a: return normal(a);
    case Shift_axis::Kind::normal_of_b: return normal(b);
    case Shift_axis::Kind::edges: break;
  }
  return cross(edge(a, axis.edge_a), edge(b, axis.edge_b));
}

/// The least and the largest product of a direction with the corners of a piece.
template <class N>
struct Extent {
  N low, high;

  Extent(const Number_point<N>& direction, const Convex_piece<N>& piece)
      : low(dot(direction, piece.corner[0])), high(low)
  {
    for (int k = 1; k < piece.count; ++k) {
      const N at = dot(direction, piece.corner[k]);
      low = least(low, at);
      high = largest(high, at);
    }
  }
};

/// The shifts s for which s `rise` lies from `low` to `high`: what an axis allows. `rise` is the axis's own z.
template <class N>
struct Allowed {
  N rise, low, high;
  bool is_axis;          ///< false where the direction is exactly 0: it says nothing
  bool may_say_nothing;  ///< the direction may be 0

  Allowed(const Shift_axis& axis, const Convex_piece<N>& a, const Convex_piece<N>& b)
  {
    const Number_point<N> n = direction(axis, a, b);
    const auto is_nothing = [](const N& x) { return lower(x) == 0 && upper(x) == 0; };
    is_axis = !(is_nothing(n[0]) && is_nothing(n[1]) && is_nothing(n[2]));
    may_say_nothing = may_be_zero(n);
    rise = n[2];
    const Extent<N> of_a(n, a), of_b(n, b);
    low = of_b.low - of_a.high;
    high = of_b.high - of_a.low;
  }

  /// Encloses what the axis allows. `errors` hold for both pieces.
  Allowed(const Shift_axis& axis, const Rounded_piece& a, const Rounded_piece& b,
          const Corner_errors& errors) requires std::is_same_v<N, Interval>
  {
    const Number_point<double> n = direction<double>(axis, a, b);
    const bool is_beside = axis.kind == Shift_axis::Kind::edge_of_a || axis.kind == Shift_axis::Kind::edge_of_b;
    const double off = is_beside ? errors.off_edge() : errors.off_normal(),
                 off_height = is_beside ? errors.off_edge_height() : errors.off_height();
    const Interval both(-2 * off_height, 2 * off_height);
    is_axis = true;
    may_say_nothing = !(std::abs(n[0]) > off || std::abs(n[1]) > off || std::abs(n[2]) > off);
    rise = is_beside ? Interval(0) : Interval(n[2]) + Interval(-off, off);
    const Extent<double> of_a(n, a), of_b(n, b);
    low = Interval(of_b.low) - Interval(of_a.high) + both;
    high = Interval(of_b.high) - Interval(of_a.low) + both;
  }

  /// Returns what an axis allows. The three numbers are those of the integer pieces' `direction`, times both
  /// denominators. They have one positive factor, so their signs and quotients are those in space.
  Allowed(const Shift_axis& axis, const Integer_piece& a, const Integer_piece& b) requires std::is_same_v<N, Rational>
  {
    const Number_point<mpz_class> n = direction<mpz_class>(axis, a, b);
    is_axis = !is_zero(n);
    may_say_nothing = !is_axis;
    rise = n[2] * a.denominator * b.denominator;
    const Extent<mpz_class> of_a(n, a), of_b(n, b);
    low = of_b.low * a.denominator - of_a.high * b.denominator;
    high = of_b.high * a.denominator - of_a.low * b.denominator;
  }

  /// Encloses what an axis exactly allows. Quotients are enclosed, since the three numbers may be beyond the doubles.
  explicit Allowed(const Allowed<Rational>& exact) requires std::is_same_v<N, Interval>
      : rise(exact.is_level() ? 0 : 1),
        low(CGAL::to_interval(exact.is_level() ? exact.low : exact.first())),
        high(CGAL::to_interval(exact.is_level() ? exact.high : exact.last())),
        is_axis(exact.is_axis),
        may_say_nothing(!exact.is_axis)
  {}

  bool is_rising() const { return lower(rise) > 0; }
  bool is_falling() const { return upper(rise) < 0; }
  bool is_level() const { return lower(rise) == 0 && upper(rise) == 0; }
  /// True when a level axis surely allows all shifts.
  bool allows_all() const { return lower(high) > 0 && upper(low) < 0; }
  /// True when a level axis surely allows none.
  bool allows_none() const { return !(upper(high) > 0 && lower(low) < 0); }
  /// True when it is certain what the axis says.
  bool is_decided() const
  {
    if (!is_axis || is_rising() || is_falling()) return true;
    return is_level() && !may_say_nothing && (allows_all() || allows_none());
  }
  /// Return the least and the largest shift. Require an axis that is rising or falling.
  N first() const { return N((is_rising() ? low : high) / rise); }
  N last() const { return N((is_rising() ? high : low) / rise); }
};

/// Calls what(axis) for all axes until it returns false. Axes that are level come first.
template <class N, class What>
void for_shift_axes(const Convex_piece<N>& a, const Convex_piece<N>& b, const What& what)
{
  using Kind = Shift_axis::Kind;
  for (int i = 0; i < a.count; ++i)
    if (!what({Kind::edge_of_a, i, 0})) return;
  for (int j = 0; j < b.count; ++j)
    if (!what({Kind::edge_of_b, 0, j})) return;
  if (!what({Kind::normal_of_a}) || !what({Kind::normal_of_b})) return;
  for (int i = 0; i < a.count; ++i)
    for (int j = 0; j < b.count; ++j)
      if (!what({Kind::edges, i, j})) return;
}

}  // namespace detail

/// The shifts s along z for which piece a, moved by s, shares a point with piece b. Pieces count only where their
/// projections along z share area, or one is projected to a line through the other's inside.
///
/// These are the s for which (0, 0, s) is in the Minkowski difference b - a. Where the planes of a and b are not
/// parallel, it is a polytope, and the axes are all normals of its facets. Then `low < high` exactly where the line x =
/// y = 0 goes through its inside, and for every s between them a goes through b. Where the planes are parallel and not
/// upright, one s is left, if the projections share area. Nothing is left where one piece is projected to a line that
/// does not cross the other's inside, and for upright pieces of parallel planes.
template <class N>
class Shift_range {
 public:
  using Bound = std::conditional_t<std::is_same_v<N, Rational>, Rational, double>;

  /// Bounds of an end. They are equal in rationals.
  struct End {
    Bound least, most;
  };

  /// In rationals this is the reference of tests; bodies have their pieces in integers.
  Shift_range(const Convex_piece<N>& a, const Convex_piece<N>& b)
  {
    restrict_to_all(a, b, [&](const Shift_axis& axis) { return detail::Allowed<N>(axis, a, b); });
  }

  Shift_range(const Integer_piece& a, const Integer_piece& b) requires std::is_same_v<N, Rational>
  {
    restrict_to_all(a, b, [&](const Shift_axis& axis) { return detail::Allowed<N>(axis, a, b); });
  }

  /// Requires a block of upward rounding, and pieces that are bounded.
  Shift_range(const Rounded_piece& a, const Rounded_piece& b) requires std::is_same_v<N, Interval>
  {
    const Corner_errors errors(a.errors, b.errors);
    restrict_to_all(a, b, [&](const Shift_axis& axis) { return detail::Allowed<N>(axis, a, b, errors); });
  }

  /// Encloses the range of both pieces, and decides in integers what enclosures do not say of an axis. So parallel
  /// edges, and faces along the shift, leave the range certain. exact() is called for each such axis. It returns
  /// pointers to both pieces in integers, for the time of the call.
  /// Requires a block of upward rounding, and pieces that are bounded.
  template <class Exact>
  Shift_range(const Convex_piece<Interval>& a, const Convex_piece<Interval>& b,
              const Exact& exact) requires std::is_same_v<N, Interval>
  {
    restrict_to_all(a, b, [&](const Shift_axis& axis) {
      const detail::Allowed<Interval> about(axis, a, b);
      if (about.is_decided()) return about;
      const auto [exact_a, exact_b] = exact();
      return detail::Allowed<Interval>(detail::Allowed<Rational>(axis, *exact_a, *exact_b));
    });
  }

  /// True when there is surely no such s.
  bool is_empty() const { return is_empty_; }
  /// True when there surely is one. In rationals one of the two is true.
  bool is_certain() const { return is_certain_; }
  /// Return bounds of the least and of the largest s. `high().most` and `low().least` are bounds even where
  /// `is_certain` is false; the other two are not. Nothing where no bound is known; in rationals only if `is_empty`.
  const std::optional<End>& low() const { return low_; }
  const std::optional<End>& high() const { return high_; }

 private:
  template <class M, class Allow>
  void restrict_to_all(const Convex_piece<M>& a, const Convex_piece<M>& b, const Allow& allowed)
  {
    detail::for_shift_axes<M>(a, b, [&](const Shift_axis& axis) {
      restrict_to(allowed(axis));
      return !is_empty_;
    });
    if (is_empty_ || !low_ || !(low_->most <= high_->least)) is_certain_ = false;
  }

  void restrict_to(const detail::Allowed<N>& allowed)
  {
    using detail::lower;
    using detail::upper;
    if (!allowed.is_axis) return;
    if (allowed.is_rising() || allowed.is_falling()) {
      const N first = allowed.first(), last = allowed.last();
      if (!low_) {
        low_ = End{lower(first), upper(first)};
        high_ = End{lower(last), upper(last)};
      } else {
        low_ = End{maximum(low_->least, Bound(lower(first))), maximum(low_->most, Bound(upper(first)))};
        high_ = End{minimum(high_->least, Bound(lower(last))), minimum(high_->most, Bound(upper(last)))};
      }
      if (low_->least > high_->most) is_empty_ = true;
    } else if (!allowed.is_decided()) {
      is_certain_ = false;
    } else if (allowed.allows_none()) {
      is_empty_ = true;
    }
  }

  std::optional<End> low_, high_;
  bool is_empty_ = false, is_certain_ = true;
};

namespace detail {

/// Returns the largest or the least product of an exact direction with the corners of a piece. Enclosures tell which
/// corners need not be multiplied.
inline mpz_class exact_end(bool is_largest, const Number_point<Interval>& direction,
                           const Convex_piece<Interval>& piece, const Number_point<mpz_class>& exact_direction,
                           const Integer_piece& exact)
{
  const Extent<Interval> extent(direction, piece);
  std::optional<mpz_class> end;
  for (int k = 0; k < piece.count; ++k) {
    const Interval about = dot(direction, piece.corner[k]);
    if (is_largest ? about.sup() < extent.high.inf() : about.inf() > extent.low.sup()) continue;
    const mpz_class at = dot(exact_direction, exact.corner[k]);
    if (!end || (is_largest ? at > *end : at < *end)) end = at;
  }
  return *end;
}

}  // namespace detail

/// Returns the exact end `high` of two pieces that surely have one. The enclosed pieces tell which axes need not be
/// asked: those beyond `most`, the upper bound that `Shift_range` gave. Requires a block of upward rounding, and
/// bounded pieces that enclose the exact ones.
inline Rational exact_high(const Convex_piece<Interval>& a, const Convex_piece<Interval>& b, double most,
                           const Integer_piece& exact_a, const Integer_piece& exact_b)
{
  std::optional<Rational> high;
  detail::for_shift_axes(a, b, [&](const Shift_axis& axis) {
    const detail::Allowed<Interval> about(axis, a, b);
    if (!about.is_axis || about.is_level()) return true;
    std::optional<Rational> last;
    if (about.is_rising() || about.is_falling()) {
      if (about.last().inf() > most) return true;
      const auto n = detail::direction(axis, a, b);
      const auto exact_n = detail::direction<mpz_class>(axis, exact_a, exact_b);
      const bool rises = about.is_rising();
      const mpz_class &of_a = exact_a.denominator, &of_b = exact_b.denominator;
      last = Rational(detail::exact_end(rises, n, b, exact_n, exact_b) * of_a -
                      detail::exact_end(!rises, n, a, exact_n, exact_a) * of_b) /
             Rational(exact_n[2] * of_a * of_b);
    } else if (const detail::Allowed<Rational> exact(axis, exact_a, exact_b); !exact.is_level()) {
      last = exact.last();
    }
    if (last && (!high || *last < *high)) high = std::move(last);
    return true;
  });
  return *high;
}

/// Returns the directions of the axes that allow no s above `high`, the end of two pieces. They are normals of the
/// facets in which a leaves b.
inline std::vector<Number_point<Rational>> directions_at(const Integer_piece& a, const Integer_piece& b,
                                                         const Rational& high)
{
  std::vector<Number_point<Rational>> directions;
  detail::for_shift_axes<mpz_class>(a, b, [&](const Shift_axis& axis) {
    const detail::Allowed<Rational> allowed(axis, a, b);
    if (!allowed.is_level() && allowed.last() == high) {
      const Number_point<mpz_class> n = detail::direction<mpz_class>(axis, a, b);
      directions.push_back({n[0], n[1], n[2]});
    }
    return true;
  });
  return directions;
}

}  // namespace tetracone::kernel

#endif
