#include "tetracone/kernel/bound/cone_probe.h"

#include "verify/cases/random.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_cone_probe)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using rationals::Vector;
using tetracone::verify::Random;

/// The exact facts. One is the sense in which the triangle's edges turn about p, 0 where they do not all agree. The
/// other is whether p is before its plane.
struct Truth {
  int facing;
  bool is_before, is_on_plane;
};

Truth truth(const std::array<Vector, 3>& t, const Vector& p)
{
  int least = 1, most = -1;
  for (int k = 0; k < 3; ++k) {
    const int turn = rationals::sign(rationals::determinant(t[k], t[(k + 1) % 3], p));
    least = std::min(least, turn);
    most = std::max(most, turn);
  }
  const int facing = least == most ? least : 0;
  const int side = rationals::sign(rationals::six_volume(t[0], t[1], t[2], p));
  return {facing, side == -facing, side == 0};
}

/// An exact point, moved by the largest error of a local point.
Vector moved(Random& random, const Local_point& p)
{
  Vector exact = rationals::exactly(p);
  for (int k = 0; k < 3; ++k) exact[k] += Rational(local_error) * Rational(random.symmetric() < 0 ? -1 : 1);
  return exact;
}

/// The probe's answers for a triangle, once with each corner as the first, and last for its reverse.
Cone_probe::Views views(const Local_triangle& t, const Local_point& p)
{
  const std::array<Rounded_point, 3> c = {rounded(t[0]), rounded(t[1]), rounded(t[2])};
  return Cone_probe(p)({c[0], c[1], c[2], c[0]}, {c[1], c[2], c[0], c[2]}, {c[2], c[0], c[1], c[1]});
}

/// A number of 2^-least to 1 in size.
double spread(Random& random, int least) { return std::exp2(-least * random.unit()); }

BOOST_AUTO_TEST_CASE(what_is_certain_is_true_of_the_exact_points)
{
  Random random(11);
  long asked = 0, wrong = 0, missed = 0, before = 0, beyond = 0, undecided = 0;
  for (int round = 0; round < 12000; ++round) {
    // A triangle about a point, small or flat now and then. The point p is near the ray through one of its edges or of
    // its plane, at its depth or at another one.
    Local_triangle t;
    const Local_point about = random.direction();
    const double from_origin = round % 7 == 0 ? spread(random, 19) : 0.5, size = from_origin * spread(random, 16);
    for (Local_point& corner : t)
      for (int k = 0; k < 3; ++k) corner[k] = from_origin * about[k] + size * random.symmetric();
    if (round % 5 == 0)
      for (int k = 0; k < 3; ++k) t[2][k] = (t[0][k] + t[1][k]) / 2 + size * spread(random, 24) * random.symmetric();
    const double b = random.unit(), c = round % 4 == 0 ? 0 : random.symmetric();
    const double share = round % 3 == 0 ? 2 * random.symmetric() : 1, off = spread(random, 30);
    Local_point p;
    for (int k = 0; k < 3; ++k)
      p[k] = share * (t[0][k] + b * (t[1][k] - t[0][k]) + c * (t[2][k] - t[0][k])) + off * random.symmetric();
    bool is_model = octahedral_norm(p) >= Cone_cells::core && octahedral_norm(p) <= 4;
    for (const Local_point& corner : t)
      for (const double x : corner) is_model = is_model && std::abs(x) <= 1;
    if (!is_model) continue;
    ++asked;
    const Cone_probe::Views seen = views(t, p);
    const Truth exact = truth({moved(random, t[0]), moved(random, t[1]), moved(random, t[2])}, moved(random, p));
    for (unsigned k = 0; k < 4; ++k) {
      const int facing = k == 3 && seen.facing(3) != cone_undecided ? -seen.facing(3) : seen.facing(k);
      if (facing == cone_undecided) {
        ++undecided;
        continue;
      }
      const bool is_before = seen.before >> k & 1;
      wrong += facing != exact.facing || (facing != 0 && (exact.is_on_plane || is_before != exact.is_before));
      missed += facing == 0;
      before += facing != 0 && is_before;
      beyond += facing != 0 && !is_before;
      wrong += facing == 0 && is_before;
    }
  }
  BOOST_TEST(wrong == 0);
  for (const long some : {missed, before, beyond, undecided}) BOOST_TEST(some > asked / 100);
}

// Planted and seen to fail in what_is_certain_is_true_of_the_exact_points: a turn's bound of a 512th, a height's of a
// 128th.

BOOST_AUTO_TEST_SUITE_END()
