#include "tetracone/kernel/motion/first_contact.h"

#include "tetracone/kernel/number/number.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_first_contact)

using namespace tetracone::kernel;

constexpr Moving_point still(Vertex v) { return {v, v}; }

/// A vertex and the face of (0,0,0), (1,0,0), (0,1,0), which rests.
Moving_pair onto_face(Vertex start, Vertex end)
{
  return {Moving_kind::vertex_face, {{{start, end}, still({0, 0, 0}), still({1, 0, 0}), still({0, 1, 0})}}};
}

Moving_pair edges(Moving_point a, Moving_point b, Moving_point c, Moving_point d)
{
  return {Moving_kind::edge_edge, {{a, b, c, d}}};
}

/// "-", or the bounds of the first time, one number where they are equal.
std::string first(const Moving_pair& pair)
{
  const auto time = first_contact_time(pair);
  BOOST_TEST(meet_in_motion(pair) == time.has_value());
  BOOST_TEST(Exact_motion(pair).first_contact().has_value() == time.has_value());
  if (!time) return "-";
  if (time->lo == time->hi) return shortest(time->lo);
  BOOST_TEST(time->hi == std::nextafter(time->lo, 2));
  return shortest(time->lo) + " " + shortest(time->hi);
}

BOOST_AUTO_TEST_CASE(a_vertex_falls_through_a_face_its_edge_its_corner_or_past_it)
{
  BOOST_TEST(first(onto_face({0.25, 0.25, 1}, {0.25, 0.25, -1})) == "0.5");
  BOOST_TEST(first(onto_face({0.5, 0.5, 1}, {0.5, 0.5, -3})) == "0.25");
  BOOST_TEST(first(onto_face({0, 0, 3}, {0, 0, -1})) == "0.75");
  BOOST_TEST(first(onto_face({0.5, std::nextafter(0.5, 1), 1}, {0.5, std::nextafter(0.5, 1), -1})) == "-");
  BOOST_TEST(first(onto_face({-0x1p-1074, 0.5, 1}, {-0x1p-1074, 0.5, -1})) == "-");
}

BOOST_AUTO_TEST_CASE(times_that_are_no_doubles_have_their_neighbours_and_tiny_ones_are_doubles)
{
  const double third = 1.0 / 3;  // below 1/3
  BOOST_TEST(first(onto_face({0.25, 0.25, 1}, {0.25, 0.25, -2})) ==
             shortest(third) + " " + shortest(std::nextafter(third, 1)));
  // z = s 2^-1000 - t: t is 2^-1000 / (1 + 2^-1000).
  const auto time = first_contact_time(onto_face({0.25, 0.25, 0x1p-1000}, {0.25, 0.25, -1}));
  BOOST_REQUIRE(time.has_value());
  BOOST_TEST(time->hi == 0x1p-1000);
  BOOST_TEST(time->lo == std::nextafter(0x1p-1000, 0));
}

BOOST_AUTO_TEST_CASE(contact_at_the_start_alone_and_at_the_end_alone)
{
  BOOST_TEST(first(onto_face({0.25, 0.25, 0}, {0.25, 0.25, 1})) == "0");
  BOOST_TEST(first(onto_face({0.25, 0.25, 1}, {0.25, 0.25, 0})) == "1");
  BOOST_TEST(first(onto_face({0.25, 0.25, 1}, {0.25, 0.25, 0x1p-1074})) == "-");
  BOOST_TEST(first(onto_face({0.25, 0.25, 0x1p-1074}, {0.25, 0.25, 1})) == "-");
  BOOST_TEST(first(onto_face({1, 0, 1}, {1, 0, 0})) == "1");
}

BOOST_AUTO_TEST_CASE(all_in_one_plane_all_the_time)
{
  // A vertex glides in the face's plane: into it, along an edge's line, past a corner.
  BOOST_TEST(first(onto_face({-1, 0.25, 0}, {1, 0.25, 0})) == "0.5");
  BOOST_TEST(first(onto_face({-1, 0, 0}, {3, 0, 0})) == "0.25");
  BOOST_TEST(first(onto_face({-1, 1, 0}, {1, 1, 0})) == "0.5");
  BOOST_TEST(first(onto_face({-1, 1.25, 0}, {1, 1.25, 0})) == "-");
  BOOST_TEST(first(onto_face({2, 0, 0}, {0, 2, 0})) == "-");
  BOOST_TEST(first(onto_face({1.5, -0.5, 0}, {-0.5, 1.5, 0})) == "0.25");
  BOOST_TEST(first(onto_face({2, -2, 0}, {-1, 1, 0})) ==
             shortest(2.0 / 3) + " " + shortest(std::nextafter(2.0 / 3, 1)));
  // Edges of one plane.
  const Moving_point left = still({0, 0, 0}), right = still({1, 0, 0});
  BOOST_TEST(first(edges(left, right, {{0.5, 2, 0}, {0.5, 0, 0}}, {{0.5, 3, 0}, {0.5, 1, 0}})) == "1");
  BOOST_TEST(first(edges(left, right, {{0.5, 2, 0}, {0.5, -2, 0}}, {{0.5, 3, 0}, {0.5, -1, 0}})) == "0.5");
  BOOST_TEST(first(edges(left, right, {{1.25, 2, 0}, {1.25, -2, 0}}, {{1.25, 3, 0}, {1.25, -1, 0}})) == "-");
}

BOOST_AUTO_TEST_CASE(parallel_edges)
{
  const Moving_point left = still({0, 0, 0}), right = still({1, 0, 0});
  const auto falls = [&](double x) {
    return edges(left, right, {{x, 0, 1}, {x, 0, -1}}, {{x + 1, 0, 1}, {x + 1, 0, -1}});
  };
  BOOST_TEST(first(falls(0.5)) == "0.5");
  BOOST_TEST(first(falls(0)) == "0.5");
  BOOST_TEST(first(falls(1)) == "0.5");  // end to end
  BOOST_TEST(first(falls(std::nextafter(1, 2))) == "-");
  BOOST_TEST(first(falls(-1)) == "0.5");
  // On one line, end to end at 1/2.
  BOOST_TEST(first(edges(left, right, {{3, 0, 0}, {-1, 0, 0}}, {{4, 0, 0}, {0, 0, 0}})) == "0.5");
  BOOST_TEST(first(edges(left, right, {{3, 0, 0}, {2, 0, 0}}, {{4, 0, 0}, {3, 0, 0}})) == "-");
}

BOOST_AUTO_TEST_CASE(rounded_integer_forms_decide_what_differences_in_doubles_cannot)
{
  // Turns of some 2^-60 of their terms.
  Moving_pair pair = onto_face({0.5, 0.5 + 0x1p-50, 1}, {0.5, 0.5 + 0x1p-50, -1});
  BOOST_TEST((filtered_contact(pair) == Moving_contact::uncertain));
  BOOST_TEST((Exact_motion(pair).rounded_contact() == Moving_contact::apart));
  pair = onto_face({0.5, 0.5 - 0x1p-50, 1}, {0.5, 0.5 - 0x1p-50, -1});
  BOOST_TEST((filtered_contact(pair) == Moving_contact::uncertain));
  BOOST_TEST((Exact_motion(pair).rounded_contact() == Moving_contact::meet));
  BOOST_TEST((Exact_motion(onto_face({0.5, 0.5, 1}, {0.5, 0.5, -1})).rounded_contact() == Moving_contact::uncertain));
}

BOOST_AUTO_TEST_SUITE_END()
