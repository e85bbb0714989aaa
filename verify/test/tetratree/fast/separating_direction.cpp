#include "tetracone/tetratree/fast/separating_direction.h"

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "verify/test/support/placed_boxes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_separating_direction)

using namespace tetracone::tetratree;
namespace kernel = tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using namespace tetracone::verify::scenes;

namespace {

struct Placed {
  Pose pose_a, pose_b;
};

bool told_apart_by(Separating_direction& separation, const Placed& p, int steps, bool again = false)
{
  return separation(p.pose_a, p.pose_b, steps, again);
}

Pose plus(const Pose& pose, const std::array<Rational, 3>& t)
{
  return composed(Pose(std::array<Rational, 12>{1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2]}), pose);
}

/// The pose moved so that vertex v of the body comes, exactly, to `to`.
Pose brought(const Pose& pose, const Polyhedron& body, Index v, const rationals::Vector& to)
{
  return plus(pose, rationals::minus(to, rationals::image(pose, rationals::exactly(body.vertices[v]))));
}

struct Body {
  explicit Body(const Polyhedron& p) : polyhedron(p), tree(p) {}
  Polyhedron polyhedron;
  Bvh8 tree;
};

std::vector<std::unique_ptr<Body>> bodies()
{
  Random random(1);
  std::vector<std::unique_ptr<Body>> all;
  for (const Polyhedron& p :
       {unit_cube(), star_prism(), blob(random, 3, 0.9, 1.1), blob(random, 2, 0.3, 2),
        tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}), box({-1, -1e-3, -1}, {1, 1e-3, 1}),
        moved(unit_cube(), 0x1p-20, {1, 1, 1}), moved(blob(random, 2, 1, 1), 1000)})
    all.push_back(std::make_unique<Body>(p));
  return all;
}

/// The vertex that reaches farthest in the direction.
Index farthest(const Polyhedron& body, const Pose& pose, const kernel::Vector& direction)
{
  const auto reach = [&](const Vertex& v) {
    kernel::Vector image;
    for (int i = 0; i < 3; ++i)
      image[i] = pose[4 * i] * v[0] + pose[4 * i + 1] * v[1] + pose[4 * i + 2] * v[2] + pose[4 * i + 3];
    return direction.dot(image);
  };
  return Index(std::max_element(body.vertices.begin(), body.vertices.end(),
                                [&](const Vertex& p, const Vertex& q) { return reach(p) < reach(q); }) -
               body.vertices.begin());
}

}  // namespace

BOOST_AUTO_TEST_CASE(bodies_that_touch_in_one_vertex_are_never_apart)
{
  // The one that reaches farthest of A is put on the one of B that reaches farthest the other way. A hair more and they
  // are apart.
  const auto all = bodies();
  Random random(2);
  int told_apart = 0, tried = 0, a_hair = 0;
  for (const auto& a : all)
    for (const auto& b : all) {
      Separating_direction separation(a->tree, b->tree);
      for (int k = 0; k < 40; ++k) {
        const kernel::Vector direction = vector(random).normalized();
        const Pose pose_b = k % 3 == 0   ? Pose()
                            : k % 3 == 1 ? random_rotation(random, 5, {Rational(1) / 3, 0, 0})
                                         : random_affine(random, 2);
        const Pose turned = k % 4 == 0 ? Pose() : k % 4 == 1 ? random_affine(random, 2) : random_rotation(random, 5);
        const Index p = farthest(a->polyhedron, turned, -direction), q = farthest(b->polyhedron, pose_b, direction);
        const rationals::Vector at = rationals::image(pose_b, rationals::exactly(b->polyhedron.vertices[q]));
        const Pose pose_a = brought(turned, a->polyhedron, p, at);
        ++tried;
        const auto touching = Placed{pose_a, pose_b};
        told_apart += told_apart_by(separation, touching, k % 5 == 0 ? 50 : 4);
        // With the direction that parted them a step apart, and with what that led to.
        std::array<Rational, 3> step;
        for (int i = 0; i < 3; ++i) step[i] = Rational(direction[i]) / 64;
        a_hair += told_apart_by(separation, Placed{plus(pose_a, step), pose_b}, 50);
        told_apart += told_apart_by(separation, touching, 1, true);
        told_apart += told_apart_by(separation, touching, 8, true);
      }
    }
  BOOST_TEST(told_apart == 0);
  BOOST_TEST(tried == 2560);
  BOOST_TEST(a_hair > 400);  // so the directions are near to those that could tell
}

BOOST_AUTO_TEST_CASE(bodies_that_touch_at_some_time_of_a_span_are_never_apart_in_it)
{
  // As above at one time, A moving past B along the plane between them.
  const auto all = bodies();
  Random random(5);
  int told_apart = 0, a_hair = 0;
  for (const auto& a : all)
    for (const auto& b : all) {
      Separating_direction separation(a->tree, b->tree);
      const auto units = [](const Body& body) {
        return kernel::Motion_units{body.tree.scale().origin, body.tree.scale().unit};
      };
      for (unsigned k = 0; k < 8; ++k) {
        const kernel::Vector direction = vector(random).normalized(), past = direction.cross(vector(random));
        const Pose pose_b = k % 2 == 0 ? Pose() : random_rotation(random, 5), turned = random_rotation(random, 5);
        const Index p = farthest(a->polyhedron, turned, -direction), q = farthest(b->polyhedron, pose_b, direction);
        const Pose touching =
            brought(turned, a->polyhedron, p, rationals::image(pose_b, rationals::exactly(b->polyhedron.vertices[q])));
        const long part = integer(random, 0, (1 << k) - 1);
        const Rational time = (Rational(4 * part) + integer(random, 0, 4)) / Rational(4L << k);
        const auto told = [&](const Rational& away) {
          const auto at = [&](const Rational& later) {
            rationals::Vector step;
            for (int i = 0; i < 3; ++i) step[i] = later * Rational(past[i]) + away * Rational(direction[i]);
            return plus(touching, step);
          };
          const auto motion_a = kernel::Body_motion::linear(at(-time), at(1 - time)),
                     motion_b = kernel::Body_motion::linear(pose_b, pose_b);
          kernel::Motion_span span(kernel::Pair_motion(motion_a, motion_b), units(*a), units(*b));
          for (unsigned halvings = k; halvings-- > 0;) span = span.half(part >> halvings & 1);
          return separation(span, 20);
        };
        told_apart += told(0);
        a_hair += told(Rational(1) / 64);
        told_apart += told(0);  // with the direction that parted them
      }
    }
  BOOST_TEST(told_apart == 0);
  BOOST_TEST(a_hair > 100);
}

BOOST_AUTO_TEST_CASE(bodies_that_touch_where_placed_origins_are_hardly_known_are_never_apart)
{
  // A's vertices are far from its model's origin, so that rounding may move it by a tenth of its size; B touches it
  // there.
  Body a(moved(unit_cube(), 1, {0x1p50, 0, 0})), b(unit_cube());
  Separating_direction separation(a.tree, b.tree);
  Random random(7);
  int told_apart = 0, beside = 0;
  for (int k = 0; k < 600; ++k) {
    const Pose rotation = random_rotation(random, 9);
    const auto placed_by = [&](const Rational& distance) {
      std::array<Rational, 3> t;
      for (int i = 0; i < 3; ++i) t[i] = rotation.exact(4 * i) * (Rational(0x1p50) + distance);
      return Placed{rotation, plus(rotation, t)};
    };
    told_apart += told_apart_by(separation, placed_by(k % 2 == 0 ? 1 : -1), 4);
    beside += told_apart_by(separation, placed_by(k % 2 == 0 ? 20 : -20), 4);
  }
  BOOST_TEST(told_apart == 0);
  BOOST_TEST(beside == 600);
}

BOOST_AUTO_TEST_CASE(bodies_that_touch_far_from_both_origins_are_never_apart)
{
  // No translation tells of it: images of both bodies' origins are far, and their difference is small.
  Body a(moved(unit_cube(), 1, {0x1p50, 0, 0})), b(moved(unit_cube(), 1, {0x1p50 + 1, 0, 0})),
      c(moved(unit_cube(), 1, {0x1p50 + 40, 0, 0}));
  Separating_direction of_touching(a.tree, b.tree), of_apart(a.tree, c.tree);
  Random random(8);
  int told_apart = 0, beside = 0;
  for (int k = 0; k < 600; ++k) {
    const Pose rotation = k % 2 == 0 ? random_rotation(random, 9) : rounded(random_rotation(random, 9));
    told_apart += told_apart_by(of_touching, Placed{rotation, rotation}, 4);
    beside += told_apart_by(of_apart, Placed{rotation, rotation}, 4);
  }
  BOOST_TEST(told_apart == 0);
  BOOST_TEST(beside == 600);
}

BOOST_AUTO_TEST_CASE(bodies_clearly_apart_are_told_apart)
{
  const auto all = bodies();
  Random random(4);
  int missed = 0, missed_again = 0, tried = 0;
  for (const auto& a : all)
    for (const auto& b : all) {
      Separating_direction separation(a->tree, b->tree);
      for (int k = 0; k < 20; ++k) {
        const kernel::Vector direction = vector(random).normalized();
        const Pose pose_a = k % 2 == 0 ? Pose() : random_rotation(random, 5),
                   pose_b = rounded(random_rotation(random, 5));
        // Beyond the spheres about their first vertices.
        double far = 0;
        for (const auto* body : {a.get(), b.get()})
          for (const Vertex& v : body->polyhedron.vertices) far += 2 * std::hypot(v[0], v[1], v[2]);
        std::array<Rational, 3> t;
        for (int i = 0; i < 3; ++i) t[i] = Rational(std::min(far, 1e4) * direction[i]);
        ++tried;
        const auto apart = Placed{plus(pose_a, t), pose_b};
        missed += !told_apart_by(separation, apart, 4);
        missed_again += !told_apart_by(separation, apart, 1, true);
      }
    }
  BOOST_TEST(missed == 0);
  BOOST_TEST(missed_again == 0);
  BOOST_TEST(tried == 1280);
}

BOOST_AUTO_TEST_CASE(a_stale_direction_under_huge_poses_stays_sound)
{
  // Two tips that meet, stretched so far that products with the long direction from the frame before are beyond the
  // floats.
  Polyhedron tip = tetrahedron({-1.875, -0.25, 0}, {1.875, 0, 0}, {-1.875, 0.25, 0.25}, {-1.875, 0.25, -0.25}),
             other = tip;
  for (Vertex& v : other.vertices)
    for (double& x : v) x = -x;
  Body a(tip), b(other);
  int told_apart = 0, told = 0;
  for (int exponent = 40; exponent < 130; ++exponent) {
    const double stretch = std::ldexp(1.5, exponent);
    const auto pose = [&](double t) {
      return Pose(std::array<double, 12>{stretch, 0, 0, t, stretch, 1, 0, t, stretch, 0, 1, t});
    };
    const auto touching = Placed{pose(0), pose(3.75 * stretch)};
    for (int length = 10; length < 60; ++length) {
      Separating_direction separation(a.tree, b.tree);
      told += told_apart_by(
          separation,
          Placed{Pose(), translation(std::ldexp(2, length), std::ldexp(-1, length), std::ldexp(-1, length))}, 3);
      told_apart += told_apart_by(separation, touching, 1, true);
      told_apart += told_apart_by(separation, touching, 3);
    }
  }
  BOOST_TEST(told_apart == 0);
  BOOST_TEST(told > 3000);
}

BOOST_AUTO_TEST_CASE(far_away_huge_tiny_and_unknown_it_ends_and_says_nothing_wrong)
{
  Random random(6);
  int told_apart = 0, told = 0, apart = 0;
  for (const double size : {0x1p-1000, 0x1p-200, 0x1p-60, 0x1p-30, 1.0, 0x1p30, 0x1p60, 0x1p200, 0x1p1000}) {
    // A cube of this size with a corner on a face of the unit cube, which all contacts below keep.
    Body a(moved(unit_cube(), size, {1, 0, 0})), b(unit_cube());
    Separating_direction separation(a.tree, b.tree);
    for (int k = 0; k < 30; ++k) {
      const Pose rotation =
          k % 3 == 0 ? Pose() : random_rotation(random, 5, {Rational(std::ldexp(1.0, k % 7 * 20)), 0, 0});
      told_apart += told_apart_by(separation, Placed{rotation, rotation}, 1 + k % 30);
      told_apart += told_apart_by(separation, Placed{rotation, rotation}, 30, true);
      if (size < 0x1p-31 || size > 1) continue;  // beyond a large one the gap is too small for floats
      ++apart;
      told += told_apart_by(separation, Placed{plus(Pose(), {Rational(2), 0, 0}), Pose()}, 4);
    }
    // Nothing can be told of where nothing is known: overflows, and what is undefined.
    for (const double huge : {0x1p1000, 0x1p1023}) {
      const Pose pose(
          std::array<double, 12>{huge, -huge, huge, huge, huge, huge, -huge, -huge, -huge, huge, huge, huge});
      BOOST_TEST(!told_apart_by(separation, Placed{pose, Pose()}, 4));
      BOOST_TEST(!told_apart_by(separation, Placed{pose, pose}, 4, true));
    }
  }
  BOOST_TEST(told_apart == 0);
  BOOST_TEST(told == apart);
  BOOST_TEST(apart == 60);
}

BOOST_AUTO_TEST_CASE(one_step_tells_what_the_way_between_origins_does)
{
  Body a(unit_cube()), b(unit_cube());
  Separating_direction separation(a.tree, b.tree);
  BOOST_TEST(told_apart_by(separation, Placed{translation(5, 0, 0), Pose()}, 1));
  BOOST_TEST(!told_apart_by(separation, Placed{translation(0.5, 0, 0), Pose()}, 1));
  BOOST_TEST(separation.bytes() > 0u);
}

BOOST_AUTO_TEST_CASE(the_last_direction_tells_where_the_way_between_origins_does_not)
{
  // Two plates, one above the other and shifted: the gap is thin along the way between their centres.
  Body a(box({-1, -1, -0x1p-6}, {1, 1, 0x1p-6})), b(box({-1, -1, -0x1p-6}, {1, 1, 0x1p-6}));
  Separating_direction separation(a.tree, b.tree);
  const Placed shifted{Pose(), translation(0.5, 0.25, 0.0625)};
  BOOST_TEST(!told_apart_by(separation, shifted, 1));
  BOOST_TEST(!told_apart_by(separation, shifted, 1, true));  // nothing was apart, so nothing is remembered
  BOOST_TEST(told_apart_by(separation, Placed{Pose(), translation(0, 0, 1)}, 1));
  BOOST_TEST(told_apart_by(separation, shifted, 1, true));
  BOOST_TEST(told_apart_by(separation, shifted, 1, true));
  BOOST_TEST(!told_apart_by(separation, shifted, 1));
}

BOOST_AUTO_TEST_SUITE_END()
