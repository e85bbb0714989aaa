#include "tetracone/tetratree/query/span_reference.h"

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <optional>

BOOST_AUTO_TEST_SUITE(test_span_reference)

namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using namespace tetracone::tetratree;
using scenes::Random;
using scenes::real;
using namespace tetracone::kernel;

namespace {

/// The corner of a lane's box that is farthest along a direction of local units, a little within.
Vertex corner(const tetracone::kernel::Obb8& boxes, int lane, const Vertex& along)
{
  Vertex corner{};
  for (int i = 0; i < 3; ++i) {
    const Vertex axis = {boxes.axis[i][0][lane], boxes.axis[i][1][lane], boxes.axis[i][2][lane]};
    const double sense = tetracone::kernel::dot(axis, along) > 0 ? 1 : -1;
    for (int k = 0; k < 3; ++k) corner[k] += sense * (1 - 0x1p-22) * double(boxes.extent[i][lane]) * axis[k];
  }
  for (int k = 0; k < 3; ++k) corner[k] += double(boxes.origin[k]) + double(boxes.centre[k][lane]);
  return corner;
}

rationals::Vector from_local(const Local_scale& units, const Vertex& local)
{
  rationals::Vector x;
  for (int k = 0; k < 3; ++k) x[k] = Rational(units.origin[k]) + Rational(units.unit) * Rational(local[k]);
  return x;
}

/// The local direction of which `n` is the normal after the map.
Vertex pulled_back(const Pose& pose, const Vertex& n)
{
  Vertex l{};
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) l[k] += pose[4 * i + k] * n[i];
  return l;
}

/// Two nearly rigid poses, not far from one another; or near to a half-turn.
struct Ends {
  Rigid_pose from, to;
};
Ends any_ends(Random& random)
{
  Ends ends;
  const double turn = std::exp2(real(random, -12, 1));
  for (int k = 0; k < 4; ++k) {
    const double q = real(random, -1, 1);
    ends.from.quaternion[k] = Rational(q);
    ends.to.quaternion[k] = Rational(q + turn * real(random, -1, 1));
  }
  for (int k = 0; k < 3; ++k) {
    ends.from.translation[k] = Rational(real(random, -1, 1));
    ends.to.translation[k] = ends.from.translation[k] + Rational(turn * real(random, -1, 1));
  }
  return ends;
}

Pose pose_of(const Rigid_pose& at) { return Body_motion::rigid(at, at).value().at(0); }

/// The motion with all of it shifted.
struct Motion_of {
  bool is_rigid, is_double;
  Ends ends;

  std::optional<Body_motion> operator()(const rationals::Vector& shift) const
  {
    Ends moved = ends;
    for (Rigid_pose* const at : {&moved.from, &moved.to})
      for (int k = 0; k < 3; ++k) at->translation[k] += shift[k];
    if (is_rigid) return Body_motion::rigid(moved.from, moved.to);
    const Pose from = pose_of(moved.from), to = pose_of(moved.to);
    return is_double ? Body_motion::linear(scenes::rounded(from), scenes::rounded(to)) : Body_motion::linear(from, to);
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_that_touch_at_some_time_may_meet_then)
{
  Random random(1);
  const Bvh8 tree(scenes::triangulated(scenes::blob(random, 6, 0.5, 1.5)));
  tree.make_all();
  const Local_scale& units = tree.scale();
  const tetracone::kernel::Motion_units in = {units.origin, units.unit};
  int found = 0, asked = 0, narrow = 0;
  for (int round = 0; round < 700; ++round) {
    const Motion_of moves_a{round % 2 == 1, round % 3 != 0, any_ends(random)},
        moves_b{round % 4 >= 2, round % 3 != 0, any_ends(random)};
    const auto a = moves_a({0, 0, 0}), b = moves_b({0, 0, 0});
    if (!a || !b) continue;
    const auto& node = tree.node(Index(scenes::integer(random, 0, int(tree.node_count()) - 1))).boxes;
    const auto& other = tree.node(Index(scenes::integer(random, 0, int(tree.node_count()) - 1))).boxes;
    const int lane = scenes::integer(random, 0, node.lane_count - 1),
              others = scenes::integer(random, 0, other.lane_count - 1);
    const std::size_t of_node = round / 8 % 2;

    // A part of the time, and a time in it at which the boxes touch, along n.
    const unsigned halvings = unsigned(round % 7);
    const long part = scenes::integer(random, 0, (1 << halvings) - 1);
    const Rational time = (Rational(4 * part) + scenes::integer(random, 0, 4)) / Rational(4L << halvings);
    const Vertex n = scenes::real_vertex(random, 1), back = {-n[0], -n[1], -n[2]};
    const Pose pose_a = a->at(time), pose_b = b->at(time);
    const auto &boxes_a = of_node == 0 ? node : other, &boxes_b = of_node == 0 ? other : node;
    const Vertex p = corner(boxes_a, of_node == 0 ? lane : others, pulled_back(pose_a, n)),
                 q = corner(boxes_b, of_node == 0 ? others : lane, pulled_back(pose_b, back));
    const rationals::Vector shift = rationals::minus(rationals::image(pose_a, from_local(units, p)),
                                                     rationals::image(pose_b, from_local(units, q)));

    // And a little away from one another.
    for (const double away : {0.0, 0.01, 0.3}) {
      const auto shifted = moves_b(rationals::plus(shift, rationals::times(Rational(away), rationals::exactly(n))));
      std::optional<Motion_span> span;
      if (a->ends() && shifted->ends()) span = Motion_span::of_lines(*a->ends(), in, *shifted->ends(), in);
      if (!span) span.emplace(Pair_motion(*a, *shifted), in, in);
      for (unsigned k = halvings; k-- > 0;) span = span->half(part >> k & 1);
      BOOST_TEST(span->m() == std::uint64_t(part));
      const Span_reference reference(*span);
      if (!reference.is_certifiable()) continue;
      const double share = tetracone::kernel::nearest_double(Rational(time * Rational(1L << halvings) - part));
      // Times at which the boxes touch are among those that are known.
      tetracone::kernel::Known_times known;
      if (round % 5 == 0) known = {float(share) - 0x1p-10f, float(share) + 0x1p-10f};
      tetracone::kernel::Sweep_test test;
      reference.ask(test, of_node, node, other, others, tetracone::kernel::no_apex, known);
      tetracone::kernel::find_near(&test, 1);
      const bool is_near = test.near >> lane & 1;
      const tetracone::kernel::Near_times& times = test.times;
      if (away == 0) {
        BOOST_TEST(is_near, "round " << round);
        BOOST_TEST((double(times.from[lane]) <= share && share <= double(times.until[lane])), "round " << round);
        narrow += round % 5 != 0 && times.until[lane] - times.from[lane] < 0.75f;
      } else {
        found += !is_near;
      }
      asked += away != 0;
    }
  }
  BOOST_TEST_MESSAGE("apart " << found << " of " << asked << ", narrow " << narrow);
  BOOST_TEST(found > 0.2 * asked);
  BOOST_TEST(asked > 700);
  BOOST_TEST(narrow > 50);
}

BOOST_AUTO_TEST_SUITE_END()
