#include "tetracone/kernel/bound/bounds.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_bounds)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;
using rationals::Vector;

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 undefined = std::numeric_limits<double>::quiet_NaN();

using Frame = Bound_frame<double, true>;
using Points = std::vector<Vertex>;

double reach_of(const Points& points)
{
  double reach = 0;
  for (const Vertex& p : points)
    for (const double x : p) reach = maximum(reach, std::abs(x));
  return reach;
}

Points random_points(Random& random, int count, int scale)
{
  Points points(count);
  for (Vertex& p : points) {
    p = real_vertex(random, 1);
    for (double& x : p) x = std::ldexp(x, scale);
  }
  return points;
}

// --- frames --------------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(beyond_the_gate_the_error_is_infinite)
{
  const Pose shifted = translation(1, 0, 0);
  BOOST_TEST(std::isfinite(Frame(shifted, 0x1p249).error()));
  BOOST_TEST(!std::isfinite(Frame(shifted, 0x1p251).error()));
  BOOST_TEST(!std::isfinite(Frame(translation(0x1p251, 0, 0), 1).error()));
  BOOST_TEST(!std::isfinite(Frame(Pose(), infinity).error()));
  BOOST_TEST(!std::isfinite(Frame(shifted, undefined).error()));
}

// --- balls ---------------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(an_enclosing_ball_holds_all_points_and_is_no_larger_than_it_must)
{
  Random random(4);
  int wrong = 0;
  for (const int scale : {0, 0, 0, -100, -440, -700, -1060, 200, 500, 1000})
    for (int n = 0; n < 20; ++n) {
      const Points points = random_points(random, 1 + n, scale);
      auto centre = centroid<double>(points);
      if (n % 2 == 1) centre = improved_centre<double>(centre, points, 24);
      const auto ball = enclosing_ball<double, true>(centre, points);
      if (!std::isfinite(ball.radius)) {
        wrong += scale < 500;
        continue;
      }
      Rational largest = 0;
      const Rational radius = ball.radius;
      for (const Vertex& p : points) {
        const Vector d = rationals::minus(rationals::exactly(p), rationals::exactly(centre));
        largest = std::max<Rational>(largest, rationals::inner(d, d));
      }
      wrong += !(largest <= radius * radius);
      if (scale == 0) wrong += !(radius * radius <= largest * Rational(1 + 0x1p-40) + Rational(0x1p-700));
    }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(an_improved_centre_comes_near_that_of_the_smallest_ball)
{
  // The ends of a rod, one of them many times: the centroid is at that end, the smallest ball's centre in the middle.
  Points rod(50, Vertex{1, 0, 0});
  rod.push_back({-1, 0, 0});
  const auto start = centroid<double>(rod);
  BOOST_TEST((enclosing_ball<double, true>(start, rod).radius > 1.9));
  BOOST_TEST((enclosing_ball<double, true>(improved_centre<double>(start, rod, 24), rod).radius < 1.1));
}

BOOST_AUTO_TEST_CASE(balls_apart_by_a_margin_are_separated_and_rounding_alone_decides_without_sound)
{
  const Ball<double> a{{0, 0, 0}, 1};
  BOOST_TEST((separated<double, true>(a, Ball<double>{{2.001, 0, 0}, 1})));
  BOOST_TEST((!separated<double, true>(a, Ball<double>{{2, 0, 0}, 1})));
  BOOST_TEST((!separated<double, true>(a, Ball<double>{{std::nextafter(2.0, 3), 0, 0}, 1})));
  BOOST_TEST((separated<double, false>(a, Ball<double>{{std::nextafter(2.0, 3), 0, 0}, 1})));
  BOOST_TEST((!separated<double, false>(a, Ball<double>{{2, 0, 0}, 1})));
  BOOST_TEST((separated<float, false>(Ball<float>{{0, 0, 0}, 1}, Ball<float>{{2.001f, 0, 0}, 1})));
}

BOOST_AUTO_TEST_CASE(undefined_balls_are_never_separated)
{
  const Ball<double> a{{0, 0, 0}, 1};
  for (const Ball<double>& bad :
       {Ball<double>{{9, 0, 0}, infinity}, {{9, 0, 0}, undefined}, {{undefined, 0, 0}, 1}, {{9, 9, undefined}, 1}})
    BOOST_TEST((!separated<double, true>(a, bad)));
  // A centre that overflowed comes with an infinite radius.
  const Frame frame(translation(0x1p1023, 0, 0), 0x1p1023);
  BOOST_TEST((!separated<double, true>(a, placed(frame, Ball<double>{{0x1p1023, 0, 0}, 1}))));
}

// --- tetrahedra ----------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(all_axes_find_all_tetrahedra_that_are_apart_by_a_margin_and_face_normals_only_some)
{
  Random random(9);
  int missed = 0, missed_by_faces = 0;
  for (int n = 0; n < 3000; ++n) {
    Points a = random_points(random, 4, 0), b = random_points(random, 4, 0);
    const Vertex d = real_vertex(random, 1);
    const auto along = [&d](const Vertex& p, const Vertex& q) { return dot(d, p) < dot(d, q); };
    const double way =
        (dot(d, *std::ranges::max_element(a, along)) - dot(d, *std::ranges::min_element(b, along))) / dot(d, d) +
        0x1p-7;
    for (Vertex& p : b)
      for (int k = 0; k < 3; ++k) p[k] += way * d[k];
    const Frame frame_a(Pose(), reach_of(a)), frame_b(Pose(), reach_of(b));
    const double slack = projection_slack(frame_a, frame_b);
    const Bound_tetrahedron<double> p{a[0], a[1], a[2], a[3]}, q{b[0], b[1], b[2], b[3]};
    missed += !separated<double>(p, q, true, slack);
    missed_by_faces += !separated<double>(p, q, false, slack);
  }
  BOOST_TEST(missed == 0);
  BOOST_TEST(missed_by_faces > 100);
}

BOOST_AUTO_TEST_CASE(tetrahedra_that_touch_in_a_corner_are_separated_by_rounding_alone)
{
  Random random(10);
  int wrong = 0, by_rounding = 0;
  for (int n = 0; n < 1000; ++n) {
    // B is A's mirror image in its first corner, modelled d away, and its pose takes it back.
    const Vertex d = grid_vertex(random, 1 << 20);
    Points a(4), b(4);
    for (Vertex& p : a) p = grid_vertex(random, 1 << 20);
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i) b[k][i] = 2 * a[0][i] - a[k][i] + d[i];
    const Pose pose = random_rotation(random, 9), back = composed(pose, translation(-d[0], -d[1], -d[2]));
    const Frame frame_a(pose, reach_of(a)), frame_b(back, reach_of(b));
    Bound_tetrahedron<double> p, q;
    for (int k = 0; k < 4; ++k) {
      p[k] = frame_a(a[k]);
      q[k] = frame_b(b[k]);
    }
    wrong += separated<double>(p, q, true, projection_slack(frame_a, frame_b));
    by_rounding += separated<double>(p, q, true, 0.0);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(by_rounding > 100);
}

BOOST_AUTO_TEST_CASE(undefined_tetrahedra_are_never_separated)
{
  const Bound_tetrahedron<double> a = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Frame far(translation(0x1p600, 0, 0), 0x1p700), here(Pose(), 1);
  Bound_tetrahedron<double> b;
  for (int k = 0; k < 4; ++k) b[k] = far({0x1p699 * k, 0x1p698, 0});
  BOOST_TEST(!separated<double>(a, b, true, projection_slack(here, far)));
  for (int k = 0; k < 4; ++k)
    for (int axis = 0; axis < 3; ++axis)
      for (const double bad : {undefined, infinity, -infinity}) {
        Bound_tetrahedron<double> c = {{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6}}};
        c[k][axis] = bad;
        // A frame whose images are undefined has an infinite slack.
        BOOST_TEST(!separated<double>(a, c, true, infinity));
      }
}

// --- half-spaces ---------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_half_space_turns_with_a_reflection)
{
  const Half_space<double> low{{1, 0, 0}, {0, 0, 0}, 1};  // x <= 1
  const Pose mirror(std::array<double, 12>{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  const Frame frame(mirror, 1);
  const Placed_half_space<double, true> placed(frame, low, -1);  // -x <= 1
  BOOST_TEST(placed.is_beyond({-1.5, 0, 0}, 0));
  BOOST_TEST(!placed.is_beyond({-1, 0, 0}, 0));
  BOOST_TEST(!placed.is_beyond({1.5, 0, 0}, 0));
}

BOOST_AUTO_TEST_CASE(nothing_is_beyond_an_undefined_half_space)
{
  for (const double scale : {0x1p400, 0x1p1000, 0x1p-400, 0x1p-1070}) {
    const Pose pose(std::array<double, 12>{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0});
    const Frame frame(pose, 0x1p700);
    const Placed_half_space<double, true> plane(frame, {{1, 0, 0}, {0, 0, 0}, 0x1p699}, 1);
    BOOST_TEST(!plane.is_beyond({0x1p200, 0, 0}, infinity));
  }
  const Frame frame(Pose(), 1);
  for (const Half_space<double>& bad : {Half_space<double>{{undefined, 0, 0}, {0, 0, 0}, 1},
                                        {{1, 0, 0}, {0, 0, undefined}, 1},
                                        {{1, 0, 0}, {0, 0, 0}, undefined},
                                        {{1, 0, 0}, {0, 0, 0}, infinity}}) {
    const Placed_half_space<double, true> plane(frame, bad, 1);
    BOOST_TEST(!plane.is_beyond({9, 9, 9}, 0x1p-40));
  }
}

// --- boxes ---------------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(boxes_that_touch_in_a_corner_meet_and_boxes_apart_do_not)
{
  const auto box = [](const Bound_point<double>& low, const Bound_point<double>& high) {
    Box<double> box;
    box.add(low);
    box.add(high);
    return box;
  };
  const Box<double> a = box({0, 0, 0}, {1, 1, 1}), b = box({1, 1, 1}, {2, 3, 2});
  Box<double> c = box({1.5, 1.5, 1.0000001}, {2, 2, 2});
  BOOST_TEST(a.meets(b));
  BOOST_TEST(b.meets(c));
  BOOST_TEST(!a.meets(c));
  c.grow(0.6);
  BOOST_TEST(a.meets(c));
  BOOST_TEST(!a.meets(Box<double>()));  // empty
}

BOOST_AUTO_TEST_CASE(an_undefined_box_meets_everything)
{
  Box<double> small;
  small.add({1, 2, 3});
  for (int axis = 0; axis < 3; ++axis)
    for (const double bad : {undefined, infinity, -infinity}) {
      Bound_point<double> p{1, 2, 3};
      p[axis] = bad;
      Box<double> box;
      box.add(p);
      box.grow(infinity);
      BOOST_TEST(box.meets(small));
      BOOST_TEST(small.meets(box));
    }
}

BOOST_AUTO_TEST_SUITE_END()
