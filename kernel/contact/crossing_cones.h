#ifndef TETRACONE_KERNEL_CONTACT_CROSSING_CONES_H
#define TETRACONE_KERNEL_CONTACT_CROSSING_CONES_H

#include "tetracone/kernel/contact/cone_sums.h"
#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/interval.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

/// The cones over the parts of each solid's faces that are inside the other solid, over a number type N. Integers give
/// exact sums, intervals give enclosures.
namespace tetracone::kernel {

/// Returns the sign. Throws CGAL::Uncertain_conversion_exception where an interval does not tell it.
inline int certain_sign(const mpz_class& x) { return sgn(x); }
inline int certain_sign(const Interval& x) { return CGAL::make_certain(CGAL::sign(x)); }

/// A triangle. `outward` is 1 where its corners are anticlockwise as seen from outside its solid, else -1.
template <class N>
struct Cone_triangle {
  std::array<Number_point<N>, 3> corner;
  int outward;

  /// Returns a normal towards the outside.
  Number_point<N> normal() const
  {
    const Number_point<N> n = normal_of(corner);
    return outward > 0 ? n : negated(n);
  }
};

/// The point where an edge goes through the inside of a triangle: `top / bottom`.
template <class N>
struct Edge_crossing {
  Number_point<N> top;
  N bottom;                  ///< positive
  N part;                    ///< `part / bottom` is the share of the edge that lies before the point
  bool enters;               ///< whether the edge enters the triangle's solid there
  std::uint32_t number = 0;  ///< names the edge, in either direction, and the triangle

  /// Requires an edge whose ends are on different sides of the triangle's plane.
  Edge_crossing(const Number_point<N>& from, const Number_point<N>& to, const Cone_triangle<N>& triangle)
  {
    const Number_point<N> n = triangle.normal(), whole = difference(to, from);
    part = dot(n, difference(triangle.corner[0], from));
    bottom = dot(n, whole);
    enters = certain_sign(bottom) < 0;
    if (enters) {
      bottom = -bottom;
      part = -part;
    }
    for (int k = 0; k < 3; ++k) top[k] = from[k] * bottom + part * whole[k];
    if constexpr (std::is_same_v<N, mpz_class>) shorten(from, to);
  }

 private:
  /// Gives an end of the edge the denominator 1. The limit of a crossing may be one.
  void shorten(const Number_point<N>& from, const Number_point<N>& to)
  {
    const bool is_end = part == bottom;
    if (!is_end && part != 0) return;
    top = is_end ? to : from;
    part = is_end;
    bottom = 1;
  }
};

/// A sum of volumes, times 6, and of moments (volume times centroid), times 24.
template <class N>
class Cone_sums;

template <>
class Cone_sums<Interval> {
 public:
  /// Adds of_volume / bottom and of_moment / bottom^2, where `bottom` is the product of the crossings' `bottom`s.
  void add(std::initializer_list<const Edge_crossing<Interval>*> /*crossings*/, const Interval& bottom,
           const Interval& of_volume, const Number_point<Interval>& of_moment)
  {
    volume += of_volume / bottom;
    for (std::size_t k = 0; k < 3; ++k) moment[k] += of_moment[k] / CGAL::square(bottom);
  }

  Interval volume = 0;
  Number_point<Interval> moment = {0, 0, 0};
};

/// Terms are added in pairs, then the pairs in pairs, so that few additions are of many digits. A denominator is the
/// product of the `bottom` of all crossings of its terms, each once. Other common factors are divided out at the end.
template <>
class Cone_sums<mpz_class> {
 public:
  /// Adds volume / bottom and moment / bottom^2, where `bottom` is the product of the crossings' `bottom`s.
  void add(std::initializer_list<const Edge_crossing<mpz_class>*> crossings, mpz_class bottom, mpz_class volume,
           Number_point<mpz_class> moment)
  {
    std::vector<Factor> factors;
    for (const Edge_crossing<mpz_class>* x : crossings) factors.emplace_back(x->number, x->bottom);
    std::ranges::sort(factors, {}, &Factor::first);
    terms_.push_back({std::move(factors), std::move(bottom), std::move(volume), std::move(moment)});
    for (std::size_t n = ++count_; n % 2 == 0; n /= 2) add_last_two();
  }

  /// Returns volume and centroid of the sum plus `more`. The sum's coordinates, not `more`'s, are scaled by `scale`.
  Exact_solid value(const mpz_class& scale, const Volume_moment& more)
  {
    if (terms_.empty()) add({}, 1, 0, {0, 0, 0});
    while (terms_.size() > 1) add_last_two();
    count_ = 1;
    const auto& [factors, bottom, volume, moment] = terms_[0];
    mpz_class of_more = more.volume.get_den();
    for (const Rational& x : more.moment) of_more = lcm(of_more, x.get_den());
    const auto whole = [&of_more](const Rational& x) { return mpz_class(x.get_num() * (of_more / x.get_den())); };
    const mpz_class divisor = 6 * scale * scale * scale * bottom, by_volume = 4 * scale * bottom;
    Exact_solid sum;
    sum.volume = {volume * of_more + whole(more.volume) * divisor, divisor * of_more};
    for (int k = 0; k < 3; ++k)
      sum.centroid[k] = {moment[k] * of_more + whole(more.moment[k]) * divisor * by_volume, by_volume * sum.volume.top};
    return sum;
  }

 private:
  using Factor = std::pair<std::uint32_t, mpz_class>;  // a crossing's number, and its `bottom`

  struct Term {
    std::vector<Factor> factors;  // of `bottom`, in order
    mpz_class bottom, volume;
    Number_point<mpz_class> moment;
  };

  void add_last_two()
  {
    const Term last = std::move(terms_.back());
    terms_.pop_back();
    Term& sum = terms_.back();
    std::vector<Factor> all;
    mpz_class common = 1;
    auto y = last.factors.begin();
    for (auto x = sum.factors.begin(); x != sum.factors.end() || y != last.factors.end();) {
      const bool takes_x = y == last.factors.end() || (x != sum.factors.end() && x->first <= y->first);
      if (takes_x && y != last.factors.end() && x->first == y->first) common *= (y++)->second;
      all.push_back(takes_x ? *x++ : *y++);
    }
    const mpz_class by_last = sum.bottom / common, by_sum = last.bottom / common;
    sum.volume = sum.volume * by_sum + last.volume * by_last;
    for (int k = 0; k < 3; ++k)
      sum.moment[k] = sum.moment[k] * (by_sum * by_sum) + last.moment[k] * (by_last * by_last);
    sum.bottom *= by_sum;
    sum.factors = std::move(all);
  }

  std::vector<Term> terms_;
  std::size_t count_ = 0;
};

/// The cones over the parts of each solid's faces that are inside the other. Requires that every contact of two faces
/// is a proper crossing.
///
/// Face f has the corners p, q, r. The part of f in the other solid is bounded by contacts and by parts of f's edges.
/// Its cone is the sum of the cones over the triangles (p, x, y) of this border's segments xy. Those on the edges at p
/// are 0, so the edge qr and the contacts suffice. At a contact of f and g both parts have the border xy, in opposite
/// directions.
template <class N>
class Crossing_cones {
 public:
  using Triangle = Cone_triangle<N>;
  using Crossing = Edge_crossing<N>;

  /// Adds the cone over the part of edge qr in the other solid, by its crossings from q to r. `ends_inside`: r is
  /// inside.
  void add_edge(const Triangle& face, const std::vector<Crossing>& crossings, bool ends_inside)
  {
    if (ends_inside) add_whole(face);
    if (crossings.empty()) return;
    const auto& [p, q, r] = face.corner;
    const N volume = volume_of(face);
    for (const Crossing& x : crossings) {
      const N part = N(volume * x.part) * (x.enters ? -1 : 1);
      Number_point<N> moment;
      for (int k = 0; k < 3; ++k) moment[k] = part * ((p[k] + 2 * q[k]) * x.bottom + (r[k] - q[k]) * x.part);
      sums.add({&x}, x.bottom, part, moment);
    }
  }

  /// Adds a face that is wholly inside.
  void add_whole(const Triangle& face)
  {
    const auto& [p, q, r] = face.corner;
    const N volume = volume_of(face);
    Number_point<N> moment;
    for (int k = 0; k < 3; ++k) moment[k] = volume * (p[k] + q[k] + r[k]);
    sums.add({}, N(1), volume, moment);
  }

  /// Adds the contact of a face of each body between two crossings.
  void add_contact(const Triangle& f, const Triangle& g, const Crossing& x, const Crossing& y)
  {
    // As seen from outside f, the other solid is on the left of the product of both outward normals.
    Number_point<N> along;
    for (int k = 0; k < 3; ++k) along[k] = y.top[k] * x.bottom - x.top[k] * y.bottom;
    const int way = certain_sign(dot(cross(f.normal(), g.normal()), along));
    if (way == 0) return;  // the limit of a segment is a point
    const Number_point<N> xy = cross(x.top, y.top);
    const N of_f = dot(f.corner[0], xy) * way, of_g = dot(g.corner[0], xy) * way, bottom = x.bottom * y.bottom;
    Number_point<N> moment;
    for (int k = 0; k < 3; ++k) {
      const N ends = x.top[k] * y.bottom + y.top[k] * x.bottom;
      moment[k] = of_f * (f.corner[0][k] * bottom + ends) - of_g * (g.corner[0][k] * bottom + ends);
    }
    sums.add({&x, &y}, bottom, of_f - of_g, moment);
  }

  Cone_sums<N> sums;

 private:
  static N volume_of(const Triangle& face)
  {
    return dot(face.corner[0], cross(face.corner[1], face.corner[2])) * face.outward;
  }
};

}  // namespace tetracone::kernel

#endif
