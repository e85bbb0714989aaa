// Compiled by `tetracone experiment compilers` with one set of flags after another: how often is the sign of four
// points wrong? The points, and the right sign, come from integer arithmetic alone, which no flag changes. One line a
// test: subject,test,n,wrong.
//
// With -ffast-math our own headers refuse to compile: ADAPTIVE is not defined then.

#ifdef ADAPTIVE
#include "tetracone/kernel/predicate/signs.h"
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <cstdio>

namespace {

using Integer = __int128;
using Quadruple = std::array<std::array<Integer, 3>, 4>;  // coordinates in units of 2^-unit
constexpr int unit = 100;

std::uint64_t state = 0;
std::uint64_t bits()
{
  std::uint64_t z = state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// The integer rounded to 53 bits, ties to even, as a conversion to double does.
Integer rounded(Integer x)
{
  const Integer magnitude = x < 0 ? -x : x;
  int shift = 0;
  while ((magnitude >> shift) >= (Integer(1) << 53)) ++shift;
  if (shift == 0) return x;
  const Integer half = Integer(1) << (shift - 1), low = magnitude & ((Integer(1) << shift) - 1);
  Integer kept = magnitude >> shift;
  if (low > half || (low == half && (kept & 1))) ++kept;
  return x < 0 ? -(kept << shift) : kept << shift;
}

Integer coordinate() { return Integer(bits() >> 11) << (unit - 53); }  // in [0, 1), 53 bits

/// The double of an integer of at most 53 significant bits: conversions and powers of two are exact.
double as_double(Integer x)
{
  double scale = 1;
  for (int k = 0; k < unit; ++k) scale *= 0.5;
  return double(x) * scale;
}

mpz_class exactly(Integer x)
{
  const unsigned __int128 magnitude = x < 0 ? -(unsigned __int128)x : (unsigned __int128)x;
  const mpz_class high = (unsigned long)(magnitude >> 64), low = (unsigned long)magnitude;
  const mpz_class value = (high << 64) + low;
  return x < 0 ? mpz_class(-value) : value;
}

int true_sign(const Quadruple& q)
{
  const auto d = [&q](int i, int k) { return exactly(q[i + 1][k] - q[0][k]); };
  mpz_class sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, n = (k + 2) % 3;
    sum += d(0, k) * (d(1, l) * d(2, n) - d(1, n) * d(2, l));
  }
  return sgn(sum);
}

// Four random points per query.

Quadruple random_points()
{
  Quadruple q;
  for (auto& point : q)
    for (Integer& x : point) x = coordinate();
  return q;
}
Quadruple rounded_on_plane()
{
  Quadruple q = random_points();
  const Integer s = Integer(bits() >> 44), t = Integer(bits() >> 44);  // of 2^20
  for (int k = 0; k < 3; ++k)
    q[3][k] = rounded(q[0][k] + (((q[1][k] - q[0][k]) >> 20) * s) + (((q[2][k] - q[0][k]) >> 20) * t));
  return q;
}
Quadruple coplanar_grid()
{
  // An integer grid of 20 bits: p0, p0 + u, p0 + v, p0 + i u + j v.
  Quadruple q;
  const auto entry = [] { return Integer(bits() >> 44) - (Integer(1) << 19); };
  const int i = int(bits() % 7) - 3, j = int(bits() % 7) - 3;
  for (int k = 0; k < 3; ++k) {
    const Integer o = entry(), u = entry(), v = entry();
    q[0][k] = o << 60;
    q[1][k] = (o + u) << 60;
    q[2][k] = (o + v) << 60;
    q[3][k] = (o + i * u + j * v) << 60;
  }
  return q;
}
Quadruple repeated_point()
{
  Quadruple q = random_points();
  q[2] = q[1];
  return q;
}

template <class K>
int sign(const Quadruple& q)
{
  const auto p = [&](int k) { return typename K::Point_3(as_double(q[k][0]), as_double(q[k][1]), as_double(q[k][2])); };
  return CGAL::orientation(p(0), p(1), p(2), p(3));
}

#ifdef ADAPTIVE
int adaptive_sign(const Quadruple& q)
{
  using K = tetracone::kernel::Adaptive;
  const auto p = [&](int k) { return K::unmoved({as_double(q[k][0]), as_double(q[k][1]), as_double(q[k][2])}); };
  return tetracone::kernel::volume_sign<K>(p(0), p(1), p(2), p(3));
}
#endif

template <class Sign>
void test(const char* subject, const Sign& sign_of)
{
  constexpr int n = 20000;
  struct {
    const char* name;
    Quadruple (*make)();
  } const tests[] = {{"random", random_points},
                     {"rounded on the plane", rounded_on_plane},
                     {"coplanar grid", coplanar_grid},
                     {"a point twice", repeated_point}};
  for (const auto& [name, make] : tests) {
    state = 1;
    int wrong = 0;
    for (int k = 0; k < n; ++k) {
      const Quadruple q = make();
      wrong += sign_of(q) != true_sign(q);
    }
    std::printf("%s,%s,%d,%d\n", subject, name, n, wrong);
  }
  state = 1;
  int broken = 0;
  for (int k = 0; k < n; ++k) {
    const Quadruple q = rounded_on_plane();
    broken += sign_of(q) != -sign_of({q[1], q[0], q[2], q[3]});
  }
  std::printf("%s,%s,%d,%d\n", subject, "two points swapped: not the opposite sign", n, broken);
}

}  // namespace

int main()
{
  test("double", sign<CGAL::Simple_cartesian<double>>);
  test("EPICK", sign<CGAL::Epick>);
#ifdef ADAPTIVE
  test("adaptive", adaptive_sign);
#endif
}
