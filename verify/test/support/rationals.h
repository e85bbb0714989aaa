#ifndef TETRACONE_VERIFY_TEST_SUPPORT_RATIONALS_H
#define TETRACONE_VERIFY_TEST_SUPPORT_RATIONALS_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"

#include <array>
#include <optional>
#include <vector>

/// Plain rational geometry, with which tests compare the code. It uses no predicate of the library.
namespace tetracone::verify::rationals {

using covering::Index;
using covering::Polyhedron;
using kernel::Pose;
using kernel::Rational;
using kernel::Vertex;

using Vector = std::array<Rational, 3>;

inline Vector exactly(const Vertex& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

inline Vector minus(const Vector& a, const Vector& b)
{
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}
inline Vector plus(const Vector& a, const Vector& b)
{
  return {Rational(a[0] + b[0]), Rational(a[1] + b[1]), Rational(a[2] + b[2])};
}
inline Vector times(const Rational& s, const Vector& a)
{
  return {Rational(s * a[0]), Rational(s * a[1]), Rational(s * a[2])};
}
inline Rational inner(const Vector& a, const Vector& b) { return Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]); }
inline Vector outer(const Vector& a, const Vector& b)
{
  return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
          Rational(a[0] * b[1] - a[1] * b[0])};
}
inline Rational determinant(const Vector& a, const Vector& b, const Vector& c) { return inner(outer(a, b), c); }
/// Returns six times the signed volume of a tetrahedron.
inline Rational six_volume(const Vector& o, const Vector& a, const Vector& b, const Vector& c)
{
  return determinant(minus(a, o), minus(b, o), minus(c, o));
}
inline bool is_zero(const Vector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
inline int sign(const Rational& a) { return (a > 0) - (a < 0); }

/// 2^exponent, exponent >= 0.
inline Rational power(int exponent)
{
  mpz_class power = 1;
  power <<= mp_bitcnt_t(exponent);
  return power;
}

/// The exact image.
inline Vector image(const Pose& pose, const Vector& p)
{
  Vector result;
  for (int i = 0; i < 3; ++i)
    result[i] =
        pose.exact(4 * i) * p[0] + pose.exact(4 * i + 1) * p[1] + pose.exact(4 * i + 2) * p[2] + pose.exact(4 * i + 3);
  return result;
}

/// The image of a direction.
inline Vector turned(const Pose& pose, const Vector& d) { return minus(image(pose, d), image(pose, {0, 0, 0})); }

/// True when the rows of the pose have length 1 and are across one another, exactly.
inline bool is_orthonormal(const Pose& pose)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Rational dot = 0;
      for (int k = 0; k < 3; ++k) dot += pose.exact(4 * i + k) * pose.exact(4 * j + k);
      if (dot != (i == j ? 1 : 0)) return false;
    }
  return true;
}

inline std::array<Vector, 3> images(const Pose& pose, const std::array<Vertex, 3>& t)
{
  return {image(pose, exactly(t[0])), image(pose, exactly(t[1])), image(pose, exactly(t[2]))};
}

/// Returns a normal of the face's plane, of any sign; zero when its corners are on one line.
inline Vector normal(const Polyhedron& polyhedron, Index f)
{
  const Vector a = exactly(polyhedron.vertices[polyhedron.loop(f, 0)[0]]);
  std::optional<Vector> along;
  for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l)
    for (const Index v : polyhedron.loop(f, l)) {
      const Vector d = minus(exactly(polyhedron.vertices[v]), a);
      if (is_zero(d)) continue;
      if (!along) along = d;
      const Vector n = outer(*along, d);
      if (!is_zero(n)) return n;
    }
  return {0, 0, 0};
}

/// Returns six times the volume by the divergence theorem, with triangle fans of every loop about the loop's own first
/// corner.
inline Rational six_volumes(const Polyhedron& polyhedron)
{
  Rational sum = 0;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
      const auto loop = polyhedron.loop(f, l);
      for (std::size_t k = 1; k + 1 < loop.size(); ++k)
        sum += determinant(exactly(polyhedron.vertices[loop[0]]), exactly(polyhedron.vertices[loop[k]]),
                           exactly(polyhedron.vertices[loop[k + 1]]));
    }
  return sum;
}

}  // namespace tetracone::verify::rationals

#endif
