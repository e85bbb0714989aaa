#include "tetracone/kernel/predicate/plane_basis.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_plane_basis)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

std::optional<std::array<std::size_t, 3>> plane_basis(const std::vector<Vertex>& corners)
{
  return tetracone::kernel::plane_basis(corners.size(), [&](std::size_t k) -> const Vertex& { return corners[k]; });
}

bool collinear(const Vertex& a, const Vertex& b, const Vertex& c)
{
  using namespace rationals;
  return is_zero(outer(minus(exactly(b), exactly(a)), minus(exactly(c), exactly(a))));
}

// Whether some three corners are off one line, by all triples.
bool span_a_plane(const std::vector<Vertex>& corners)
{
  for (const Vertex& a : corners)
    for (const Vertex& b : corners)
      for (const Vertex& c : corners)
        if (!collinear(a, b, c)) return true;
  return false;
}

bool is_right(const std::vector<Vertex>& corners)
{
  const auto triple = plane_basis(corners);
  if (!triple) return !span_a_plane(corners);
  return !collinear(corners[(*triple)[0]], corners[(*triple)[1]], corners[(*triple)[2]]);
}

BOOST_AUTO_TEST_CASE(a_triple_off_one_line_is_found_exactly_where_there_is_one)
{
  Random random(1);
  int wrong = 0, none = 0;
  for (int n = 0; n < 2000; ++n) {
    std::vector<Vertex> corners(integer(random, 1, 6));
    const Vertex along = grid_vertex(random, 1), from = grid_vertex(random, 2);
    for (Vertex& v : corners) {
      v = grid_vertex(random, 1);
      if (n % 2 == 0) {
        const int s = integer(random, -3, 3);
        for (int k = 0; k < 3; ++k) v[k] = from[k] + s * along[k];
      }
    }
    wrong += !is_right(corners);
    none += !plane_basis(corners);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(none > 200);
  BOOST_TEST(none < 1800);
}

BOOST_AUTO_TEST_CASE(the_triple_is_the_first_corner_the_farthest_from_it_and_the_widest)
{
  const auto triple = plane_basis({{0, 0, 0}, {1, 0, 0}, {8, 0, 0}, {4, 1, 0}, {4, 3, 0}, {0, 2, 0}});
  BOOST_REQUIRE(triple.has_value());
  BOOST_TEST((*triple)[0] == 0u);
  BOOST_TEST((*triple)[1] == 2u);
  BOOST_TEST((*triple)[2] == 4u);
}

BOOST_AUTO_TEST_CASE(one_ulp_off_a_line_is_a_plane)
{
  const double up = std::nextafter(1.0, 2);
  BOOST_TEST(plane_basis({{0, 0, 0}, {0.5, 0.5, 0.5}, {1, 1, up}}).has_value());
  BOOST_TEST(!plane_basis({{0, 0, 0}, {0.5, 0.5, 0.5}, {1, 1, 1}}).has_value());
  BOOST_TEST(
      plane_basis({{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.30000000000000004, 0.30000000000000004, 0.3}}).has_value());
}

BOOST_AUTO_TEST_CASE(planes_too_small_too_large_and_too_thin_for_double_are_found)
{
  Random random(2);
  for (const double scale : {0x1p-1074, 0x1p-600, 0x1p-300, 0x1p600, 0x1p1023}) {
    std::vector<Vertex> corners = {{0, 0, 0}, {scale, 0, 0}, {scale, scale, 0}, {0, scale, scale}};
    do {
      BOOST_TEST(is_right(corners));
      BOOST_TEST(plane_basis(corners).has_value());
    } while (std::next_permutation(corners.begin(), corners.end()));
    BOOST_TEST(!plane_basis({{0, 0, 0}, {scale, -scale, 0}, {-scale, scale, 0}}).has_value());
  }
  // Opposite ends of the range: their difference overflows.
  const double most = 0x1.fffffffffffffp1023;
  BOOST_TEST(plane_basis({{-most, -most, -most}, {most, most, most}, {most, most, -most}}).has_value());
  BOOST_TEST(!plane_basis({{-most, -most, -most}, {most, most, most}, {0, 0, 0}}).has_value());
  // All on one line but the last, by the least there is.
  BOOST_TEST(plane_basis({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0x1p-1074, 0}}).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
