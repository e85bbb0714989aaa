#include "verify/families/distance_families.h"

#include "tetracone/covering/edge_uses.h"
#include "verify/truth/distance_truth.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <string_view>

BOOST_AUTO_TEST_SUITE(test_distance_families)

using namespace tetracone::verify;

namespace {

Rational square_of(const Object_case& c)
{
  const Brute_body a(*c.a), b(*c.b);
  return squared_distance(Placed_body(a, c.pose_a), Placed_body(b, c.pose_b));
}

}  // namespace

BOOST_AUTO_TEST_CASE(cases_are_legal_and_mostly_apart)
{
  std::set<std::string_view> names;
  for (const Family& family : families()) names.insert(family.name);
  int number = 49;
  for (const Family& family : distance_families()) {
    BOOST_TEST(names.insert(family.name).second);
    BOOST_TEST(family.number == ++number);
    int apart = 0;
    for (std::uint64_t k = 0; k < 6; ++k) {
      const Object_case c = family.object_case(2, k);
      BOOST_TEST((c.pose_a.determinant_sign() != CGAL::ZERO));
      BOOST_TEST(tetracone::covering::is_closed(*c.a));
      BOOST_TEST(tetracone::covering::is_closed(*c.b));
      if (c.a->face_count() < 40 && c.b->face_count() < 40)
        apart += square_of(c) > 0;
      else
        ++apart;
    }
    BOOST_TEST(apart >= 3, family.name);
  }
}

BOOST_AUTO_TEST_CASE(a_mirror_image_is_as_far_as_its_family_says)
{
  const Family& family = *find_named(distance_families(), "mirrored");
  int exact = 0;
  for (std::uint64_t k = 0; k < 8; ++k) {
    const Object_case c = family.object_case(4, k);
    if (c.a->face_count() > 40) continue;
    const Rational gap = 2 * Rational(std::ldexp(1.0, int(c.origin.parameter) - 1));
    exact += square_of(c) == gap * gap;
  }
  BOOST_TEST(exact >= 2);  // where the common motion keeps lengths
}

BOOST_AUTO_TEST_SUITE_END()
