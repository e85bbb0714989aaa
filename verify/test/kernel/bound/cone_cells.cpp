#include "tetracone/kernel/bound/cone_cells.h"

#include "verify/cases/random.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_cone_cells)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using rationals::Vector;
using tetracone::verify::Random;

/// A triangle about a point at this distance from the origin, of this size; seen nearly edge-on now and then.
Local_triangle triangle(Random& random, double from_origin, double size)
{
  const Local_point about = random.direction();
  Local_triangle t;
  for (Local_point& corner : t)
    for (int k = 0; k < 3; ++k) corner[k] = from_origin * about[k] + size * random.symmetric();
  if (random.unit() < 0.5) {
    const double share = 1 + size * random.symmetric(), off = size * std::exp2(-20 * random.unit());
    for (int k = 0; k < 3; ++k) t[2][k] = share * (t[0][k] + t[1][k]) / 2 + off * random.symmetric();
  }
  return t;
}

BOOST_AUTO_TEST_CASE(planes_are_as_near_to_the_exact_ones_as_is_said)
{
  Random random(21);
  const Rational of_normal(0x1p-46), of_offset(0x1p-43);
  for (int round = 0; round < 2000; ++round) {
    Local_triangle t;
    for (Local_point& corner : t)
      for (double& x : corner) x = round % 3 == 0 ? (random.symmetric() < 0 ? -1 : 1) : random.symmetric();
    const Local_facet facet(t);
    std::array<Vector, 3> exact;
    for (std::size_t c = 0; c < 3; ++c) {
      exact[c] = rationals::exactly(t[c]);
      for (int k = 0; k < 3; ++k) exact[c][k] += Rational(local_error) * Rational(random.symmetric() < 0 ? -1 : 1);
    }
    const Vector u = rationals::minus(exact[1], exact[0]), v = rationals::minus(exact[2], exact[0]);
    Rational offset = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Rational normal = u[i] * v[j] - u[j] * v[i];
      offset += normal * exact[0][k];
      BOOST_TEST(abs(normal - Rational(facet.normal[k])) < of_normal);
    }
    BOOST_TEST(abs(offset - Rational(facet.offset)) < of_offset);
  }
}

BOOST_AUTO_TEST_CASE(each_point_of_a_triangle_is_within_the_norms_of_its_cell)
{
  Random random(22);
  long asked = 0, narrow = 0;
  for (int round = 0; round < 3000; ++round) {
    const int n = 1 << (round % 11);
    const double from_origin = round % 5 == 0 ? std::exp2(-15 * random.unit()) : 0.7;
    const double size = from_origin * std::exp2(-4 * random.unit()) * 4 / (4 + n);
    const Local_triangle t = triangle(random, from_origin, size);
    const Cone_cells cells(n);
    std::map<std::size_t, std::pair<float, float>> norms;
    cells.for_cells(Local_facet(t), [&](std::size_t cell, float low, float high) { norms[cell] = {low, high}; });
    for (int k = 0; k < 20; ++k) {
      const bool on_edge = k % 4 == 0;
      const Local_point p = random.in_triangle({t[0], t[1], on_edge ? t[0] : t[2]});
      const double norm = octahedral_norm(p);
      if (norm < 4 * Cone_cells::core) continue;
      const auto found = norms.find(cells.cell(p, norm));
      BOOST_REQUIRE((found != norms.end()));
      const auto [low, high] = found->second;
      BOOST_TEST((low < norm && norm < high));
      ++asked;
      narrow += high - low < size / 4;
    }
  }
  BOOST_TEST(asked > 50000);
  BOOST_TEST(narrow > asked / 50);
}

BOOST_AUTO_TEST_SUITE_END()
