#include "tetracone/kernel/predicate/hull_separation.h"

#include "verify/cases/random.h"
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

BOOST_AUTO_TEST_CASE(images_of_points_are_no_farther_from_their_doubles_than_the_error_says)
{
  tetracone::verify::Random random(5);
  // Entries of the last map are beyond the doubles, but their products with the corners are not.
  constexpr std::array<std::array<double, 3>, 6> sizes = {{{1, 1, 1},
                                                           {0x1p-900, 1, 1},
                                                           {0x1p900, 1, 1},
                                                           {0x1p-1060, 1, 1},
                                                           {0x1p1010, 1, 1},
                                                           {0x1p800, 0x1p300, 0x1p-1000}}};
  for (const auto& [size, again, corner] : sizes) {
    std::vector<Rounded_vector> corners;
    corners.reserve(40);
    for (int n = 0; n < 40; ++n)
      corners.push_back(
          {corner * random.symmetric(), corner * std::ldexp(random.symmetric(), -n % 20), n % 8 == 0 ? 0 : corner / 3});
    std::array<Exact_number, 12> map;
    for (Exact_number& entry : map) entry = Exact_number(size * random.symmetric()) * Exact_number(again);
    map[5] = Exact_number(-2) * map[4];  // what cancels
    for (const std::size_t k : {3, 7, 11}) map[k] = map[k] * Exact_number(corner);
    Rounded_vector reach{};
    for (const Rounded_vector& x : corners)
      for (std::size_t k = 0; k < 3; ++k) reach[k] = maximum(reach[k], std::abs(x[k]));
    Hull_points images(corners, reach, map), origin{{0, 0, 0}};
    const Exact_number factor = round_together(images, origin);
    BOOST_TEST(images.largest() >= 0x1p-200);
    BOOST_TEST(images.largest() <= 0x1p200);
    if (again == 1) BOOST_TEST(images.error() >= image_rounding * images.largest() + image_underflow);
    BOOST_TEST(images.error() <= 32 * image_rounding * images.largest());
    for (std::size_t v = corners.size(); v-- > 0;)
      for (std::size_t k = 0; k < 3; ++k) {
        Exact_number at = map[4 * k + 3];
        for (std::size_t i = 0; i < 3; ++i) at = at + map[4 * k + i] * Exact_number(corners[v][i]);
        BOOST_TEST((images.exact(v)[k] == at));
        const Exact_number off = Exact_number(at * factor) - Exact_number(images.rounded(v)[k]);
        const double rounded_once = 0x1p-53 * std::abs(images.rounded(v)[k]);
        BOOST_TEST((abs(off) <= Exact_number(maximum(images.error(), rounded_once))));
      }
  }
}

BOOST_AUTO_TEST_CASE(directions_of_few_bits_do_not_go_along_a_recession)
{
  tetracone::verify::Random random(6);
  const Exact_vector none = {0, 0, 0};
  for (const double bad : {0.0, double(HUGE_VAL), double(NAN)})
    BOOST_TEST((rounded_to_bits(Rounded_vector{0, bad, 0}, 6) == none));
  for (int n = 0; n < 200; ++n) {
    const Exact_vector recession = {Exact_number(random.symmetric()), Exact_number(random.symmetric()),
                                    Exact_number(n % 3 == 0 ? 0 : random.symmetric())};
    Rounded_vector direction = {random.symmetric(), random.symmetric(), random.symmetric()};
    for (const int bits : {6, 14, 26, 52})
      BOOST_TEST((dot(rounded_to_bits(direction, bits, recession), recession).sign() != CGAL::POSITIVE));
  }
  // Along the recession alone, nothing is left.
  BOOST_TEST((rounded_to_bits(Rounded_vector{4, -2, -1}, 6, Exact_vector{4, -2, -1}) == none));
  BOOST_TEST((rounded_to_bits(Rounded_vector{NAN, 0, 0}, 6, Exact_vector{4, -2, -1}) == none));
}

BOOST_AUTO_TEST_SUITE_END()
