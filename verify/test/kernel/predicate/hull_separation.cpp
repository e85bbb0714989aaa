#include "tetracone/kernel/predicate/hull_separation.h"

#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_hull_separation)

using namespace tetracone::kernel;

BOOST_AUTO_TEST_CASE(a_ray_crosses_what_is_before_it_and_neither_its_origin_nor_what_is_behind)
{
  const Exact_vector a = {0, 0, 0}, b = {4, 0, 0}, c = {0, 4, 0}, up = {0, 0, 1};
  const Exact_face face{{{a, b}, {b, c}, {c, a}}, {{a, b, c}}};
  const auto crossing = [&](const Exact_vector& origin, const Exact_vector& direction) {
    Exact_vector end = origin;
    for (std::size_t k = 0; k < 3; ++k) end[k] = end[k] + Exact_number(8) * direction[k];
    return generic_crossing(face, origin, direction, Exact_face{{{origin, end}, {end, origin}}, std::nullopt});
  };
  BOOST_TEST((crossing({1, 1, -1}, up) == 1));
  BOOST_TEST((crossing({1, 1, 1}, {0, 0, -1}) == -1));
  BOOST_TEST((crossing({1, 1, 0}, up) == std::nullopt));
  BOOST_TEST((crossing({1, 1, 1}, up) == std::nullopt));
  BOOST_TEST((crossing({2, 0, -1}, up) == std::nullopt));  // an edge
  BOOST_TEST((crossing({1, -1, 0}, {0, 1, 0}) == std::nullopt));
}

BOOST_AUTO_TEST_SUITE_END()
