#include "tetracone/kernel/motion/contact_plane.h"

#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_contact_plane)

using namespace tetracone::kernel;

Body_motion shift(const Vertex& from, const Vertex& to)
{
  return Body_motion::linear(Pose::translation(from[0], from[1], from[2]), Pose::translation(to[0], to[1], to[2]));
}

const Body_motion rests = shift({0, 0, 0}, {0, 0, 0});
const std::array<Vertex, 4> on_face = {{{0.25, 0.25, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
const std::array<Vertex, 4> on_edge = {{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}, {0.5, 1, 0}}};

std::optional<Time_root> first_contact(const Pair_motion& motion, Moving_kind kind, int body,
                                       const std::array<Vertex, 4>& corner)
{
  std::array<Form_vector, 4> points;
  for (std::size_t k = 0; k < 4; ++k) {
    const int of = kind == Moving_kind::vertex_face ? (k == 0 ? body : 1 - body) : k < 2 ? 0 : 1;
    points[k] = motion.image(of, corner[k], -10);
  }
  return Exact_motion(kind, points, motion.square()).first_contact();
}

/// The plane of a first contact, from the start until then.
struct Landing {
  Time_root time;
  Times_before times{{0, 0}, time};
  Contact_plane plane;

  Landing(const Pair_motion& motion, Moving_kind kind, int body, const std::array<Vertex, 4>& corner)
      : time(first_contact(motion, kind, body, corner).value()), plane(times.over(motion), times, kind, body, corner)
  {}
};

/// A's points are at most at height 0, B's above it, until B's plane z = 0 comes to A's.
void check_sides(Contact_plane& plane)
{
  BOOST_REQUIRE(plane.is_defined());
  BOOST_TEST(plane.holds(0, {5, 7, 0}));
  BOOST_TEST(plane.holds(0, {0.5, -7, -1}));
  BOOST_TEST(!plane.holds(0, {0, 0, 0x1p-60}));
  BOOST_TEST(!plane.holds(0, {0, 0, 4}));
  BOOST_TEST(plane.holds(1, {9, -9, 0}));
  BOOST_TEST(plane.holds(1, {0.125, 3, 0x1p-10}));
  BOOST_TEST(plane.holds(1, {0, 0, 1}));
  BOOST_TEST(!plane.holds(1, {0, 0, -0x1p-60}));
  BOOST_TEST(!plane.holds(1, {0, 0, -0.5}));
  plane.use_units({Motion_units{{0, 0, 0}, 1}, {{0, 0, 0}, 1}});
  const auto box = [](double z) { return Moving_box{{0.25, 0.25, z}, {Vertex{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.25}}}; };
  BOOST_TEST(plane.holds(1, box(0.5)));
  BOOST_TEST(!plane.holds(1, box(0.25)));
  BOOST_TEST(!plane.holds(1, box(0)));
  BOOST_TEST(plane.holds(0, box(-0.5)));
  BOOST_TEST(!plane.holds(0, box(-0.25)));
  BOOST_TEST(!plane.holds(0, box(0.5)));
}

BOOST_AUTO_TEST_CASE(a_plane_parts_what_lands_together_at_a_dyadic_time_and_at_a_third)
{
  for (const double down : {-1.0, -2.0})
    for (const Moving_kind kind : {Moving_kind::vertex_face, Moving_kind::edge_edge}) {
      const Pair_motion motion(rests, shift({0, 0, 1}, {0, 0, down}));
      const auto& corner = kind == Moving_kind::vertex_face ? on_face : on_edge;
      Landing landing(motion, kind, 1, corner);
      BOOST_TEST(landing.time.is_dyadic() == (down == -1));
      check_sides(landing.plane);
    }
}

BOOST_AUTO_TEST_CASE(a_plane_parts_what_lands_together_after_a_turn)
{
  // B turns about an axis above A, and comes down by a rotation alone or by both: its plane z = 0 lands flat.
  const Body_motion still = Body_motion::rigid({}, {}).value();
  const Body_motion turns = Body_motion::rigid({{1, 0, 0, 0}, {0, 0, 1}}, {{1, 0, 0, 1}, {0, 0, Rational(-2)}}).value();
  const Pair_motion motion(still, turns);
  const std::array<Vertex, 4> corner = {{{0, 0, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
  Landing landing(motion, Moving_kind::vertex_face, 1, corner);
  check_sides(landing.plane);
}

BOOST_AUTO_TEST_CASE(a_vertex_that_leaves_the_plane_is_held_by_the_closed_side_alone)
{
  // B is sheared as it comes down: its points at x = 1, z = -1 are on A's plane at the start, and above it later on.
  const Pose above = Pose::translation(0, 0, 1), sheared(std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1, -1});
  const Pair_motion motion(rests, Body_motion::linear(above, sheared));
  Landing landing(motion, Moving_kind::vertex_face, 1, on_face);
  BOOST_REQUIRE(landing.plane.is_defined());
  BOOST_TEST(!landing.plane.holds(1, {1, 0, -1}));
  BOOST_TEST(landing.plane.holds(1, {1, 0, -0.75}));
  // A's triangle in B's place: B's side is the closed one.
  const Pair_motion turned(Body_motion::linear(above, sheared), rests);
  Landing other(turned, Moving_kind::vertex_face, 0, on_face);
  BOOST_REQUIRE(other.plane.is_defined());
  BOOST_TEST(!other.plane.holds(0, {1, 0, -1}));
  BOOST_TEST(other.plane.holds(1, {1, 0, 0}));
}

BOOST_AUTO_TEST_CASE(parallel_edges_and_vertices_that_stay_in_the_plane_have_none)
{
  const Pair_motion motion(rests, shift({0, 0, 1}, {0, 0, -1}));
  Time_root half(1, 1);
  Times_before times({0, 0}, half);
  const Contact_plane parallel(times.over(motion), times, Moving_kind::edge_edge, 0,
                               {{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {2, 0, 0}}});
  BOOST_TEST(!parallel.is_defined());
  const Contact_plane upright(times.over(motion), times, Moving_kind::vertex_face, 1,
                              {{{0.5, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}}});
  BOOST_TEST(!upright.is_defined());
}

BOOST_AUTO_TEST_SUITE_END()
