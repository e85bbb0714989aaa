#ifndef TETRACONE_KERNEL_CONTACT_CONE_SUMS_H
#define TETRACONE_KERNEL_CONTACT_CONE_SUMS_H

#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/contact/rational_map.h"
#include "tetracone/kernel/number/volume.h"

#include <CGAL/Mpzf.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// Signed volumes and first moments of cones over faces (JS08 Theorem 1). The apex is the origin of the space in which
/// bodies are placed.
namespace tetracone::kernel {

/// A sum of rationals. Terms are added in pairs, then the pairs in pairs, so that few additions are of many digits.
class Rational_sum {
 public:
  void add(Rational term)
  {
    std::size_t k = 0;
    for (; k < parts_.size() && parts_[k].second; ++k) {
      term += parts_[k].first;
      parts_[k].second = false;
    }
    if (k == parts_.size()) parts_.emplace_back();
    parts_[k] = {std::move(term), true};
  }

  /// Returns the sum of all terms.
  Rational value() const
  {
    Rational sum = 0;
    for (const auto& [part, is_set] : parts_)
      if (is_set) sum += part;
    return sum;
  }

 private:
  std::vector<std::pair<Rational, bool>> parts_;  // part k is of 2^k terms, where it is set
};

/// A volume, and the integral of x over it.
struct Volume_moment {
  Rational volume = 0;
  Rational_point moment = {0, 0, 0};

  Volume_moment& operator+=(const Volume_moment& other)
  {
    volume += other.volume;
    for (int k = 0; k < 3; ++k) moment[k] += other.moment[k];
    return *this;
  }
};

/// The fraction top / bottom, which may have a common factor.
struct Wide_fraction {
  mpz_class top = 0, bottom = 1;

  Wide_fraction() = default;
  Wide_fraction(mpz_class numerator, mpz_class divisor) : top(std::move(numerator)), bottom(std::move(divisor)) {}
  Wide_fraction(const Rational& x) : top(x.get_num()), bottom(x.get_den()) {}

  /// Returns the fraction in lowest terms. Requires bottom != 0.
  Rational reduced() const
  {
    Rational fraction(top, bottom);
    fraction.canonicalize();
    return fraction;
  }
};

/// The volume and the centroid of a solid. Where the volume is 0, the centroid means nothing: its `bottom` may be 0.
struct Exact_solid {
  Wide_fraction volume;
  std::array<Wide_fraction, 3> centroid;

  Exact_solid() = default;
  explicit Exact_solid(const Volume_moment& sums) : volume(sums.volume)
  {
    for (int k = 0; k < 3 && sums.volume != 0; ++k) centroid[k] = Rational(sums.moment[k] / sums.volume);
  }
};

/// The cones over triangles of rational points.
class Rational_cones {
 public:
  /// Adds `weight` times the cone over (a, b, c). It is positive where they are anticlockwise as seen from outside.
  void add(int weight, const Rational_point& a, const Rational_point& b, const Rational_point& c)
  {
    const Rational volume = weight * dot(a, cross(b, c));
    volume_.add(volume);
    for (int k = 0; k < 3; ++k) moment_[k].add(volume * (a[k] + b[k] + c[k]));
  }

  /// Returns the sums of all cones.
  Volume_moment value() const
  {
    return {volume_.value() / 6,
            {Rational(moment_[0].value() / 24), Rational(moment_[1].value() / 24), Rational(moment_[2].value() / 24)}};
  }

 private:
  Rational_sum volume_;                 // times 6
  std::array<Rational_sum, 3> moment_;  // times 24
};

/// The cones over triangles of a model, which is placed afterwards. Sums are of binary fractions, without a division.
class Model_cones {
 public:
  /// Adds `weight` times the cone over (a, b, c). It is positive where they are anticlockwise as seen from outside.
  void add(int weight, const Vertex& a, const Vertex& b, const Vertex& c)
  {
    const Point p = point(a), q = point(b), r = point(c);
    const Point qr = cross(q, r), rp = cross(r, p), pq = cross(p, q);
    const Number w = weight, volume = w * dot(p, qr);
    volume_ = volume_ + volume;
    for (int i = 0; i < 3; ++i) {
      const Number normal = w * (qr[i] + rp[i] + pq[i]), sum = p[i] + q[i] + r[i];
      normal_[i] = normal_[i] + normal;
      moment_[i] = moment_[i] + volume * sum;
      for (int j = 0; j < 3; ++j) normals_[i][j] = normals_[i][j] + normal * (p[j] + q[j] + r[j]);
    }
  }

  /// Returns the sums of the placed model; a reflection changes no sign of a volume. With the apex o in the model's
  /// coordinates, det[a - o, b - o, c - o] is det[a, b, c] - o . n for n = a x b + b x c + c x a. The centroid of the
  /// cone is (o + a + b + c) / 4.
  Volume_moment placed(const Rational_map& pose) const
  {
    const Rational_point o = pose.inverse({0, 0, 0});
    Rational volume = rational(volume_);
    for (int i = 0; i < 3; ++i) volume -= o[i] * rational(normal_[i]);
    Rational_point moment;
    for (int j = 0; j < 3; ++j) {
      moment[j] = rational(moment_[j]) + o[j] * volume;
      for (int i = 0; i < 3; ++i) moment[j] -= o[i] * rational(normals_[i][j]);
      moment[j] /= 24;
    }
    volume /= 6;
    Rational_point image = pose(moment, volume);
    const Rational scale = abs(pose.determinant());
    for (Rational& x : image) x *= scale;
    return {Rational(volume * scale), image};
  }

 private:
  using Number = CGAL::Mpzf;
  using Point = std::array<Number, 3>;

  static Point point(const Vertex& v) { return {Number(v[0]), Number(v[1]), Number(v[2])}; }

  Number volume_ = 0;             // the sum of det[a, b, c]
  Point normal_{};                // of n
  Point moment_{};                // of det[a, b, c] (a + b + c)
  std::array<Point, 3> normals_;  // of n_i (a + b + c)_j
};

}  // namespace tetracone::kernel

#endif
