#include "tetracone/tetratree/memory/bvh8_front.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_front)

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace kernel = tetracone::kernel;
namespace verify = tetracone::verify;
using namespace tetracone::verify::scenes;
using kernel::Question;
using kernel::Relation;

namespace {

struct Body {
  explicit Body(const Polyhedron& p) : polyhedron(p), tree(p, covering::triangulate_faces(p)), truth(p) {}
  Polyhedron polyhedron;
  Bvh8 tree;
  verify::Brute_body truth;
};

/// About the axis of the quaternion (0, 2, 1, 3).
Pose rotated(double angle, double x, double y, double z, double scale = 1)
{
  const double c = std::cos(angle / 2), s = std::sin(angle / 2) / std::sqrt(14.0), i = 2 * s, j = s, k = 3 * s;
  std::array<double, 12> m = {1 - 2 * (j * j + k * k), 2 * (i * j - c * k),     2 * (i * k + c * j),     x,
                              2 * (i * j + c * k),     1 - 2 * (i * i + k * k), 2 * (j * k - c * i),     y,
                              2 * (i * k - c * j),     2 * (j * k + c * i),     1 - 2 * (i * i + j * j), z};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) m[4 * row + column] *= scale;
  return Pose(m);
}

struct Walk {
  std::string name;
  const Body *a, *b;
  int frames;
  std::function<Pose(int)> pose_a, pose_b;
};

struct Bodies {
  Body blob, tunnel{cube_with_tunnel()}, cavity{cube_with_cavity()}, small{cube(0.5)};

  explicit Bodies(Random random) : blob(tetracone::verify::scenes::blob(random, 3, 0.8, 1.2)) {}
};
const Bodies& bodies()
{
  static const Bodies all{Random(3)};
  return all;
}

/// Smooth ones along contact, through it, and inside. Others have jumps, rests, restarts, and steps of the size of
/// bodies. Some poses are no similarities, in fractions, mirrored, or of changing size.
std::vector<Walk> walks()
{
  const auto still = [](int) { return Pose(); };
  const auto along = [](double step, double distance) {
    return [=](int k) {
      const double t = step * k;
      return rotated(2 * t, distance * std::cos(t), distance * std::sin(t), 0.1 * std::sin(5 * t));
    };
  };
  std::vector<Walk> all;
  all.push_back({"along", &bodies().blob, &bodies().blob, 160, still, along(0.002, 2.1)});
  all.push_back({"through", &bodies().blob, &bodies().blob, 120, still,
                 [](int k) { return rotated(0.01 * k, 2.3 - 0.008 * k, 0.1, 0.2); }});
  all.push_back({"both move", &bodies().blob, &bodies().tunnel, 100, along(0.003, 0.2),
                 [](int k) { return rotated(-0.004 * k, 3.6 - 0.002 * k, 0.3, -0.1); }});
  all.push_back({"in the tunnel", &bodies().tunnel, &bodies().small, 160, still,
                 [](int k) { return rotated(0.001 * k, 0.3 * std::sin(0.01 * k), 0.2, 5 - 0.06 * k); }});
  all.push_back({"in the cavity", &bodies().cavity, &bodies().small, 160, still,
                 [](int k) { return rotated(0.01 * k, 1.8 * std::sin(0.02 * k), 1.2, -1); }});
  all.push_back({"inside", &bodies().cavity, &bodies().small, 80, still,
                 [](int k) { return rotated(0.002 * k, 2.5 + 0.004 * k, 0, 0, 0.2); }});
  all.push_back({"inside, the other way", &bodies().small, &bodies().cavity, 80,
                 [](int k) { return rotated(0.002 * k, 2.5 + 0.004 * k, 0, 0, 0.2); }, still});
  all.push_back({"jumps", &bodies().blob, &bodies().tunnel, 120, still,
                 [along](int k) { return k % 10 == 0 ? along(1, 4)(k) : along(0.002, 3.3)(k); }});
  all.push_back(
      {"rests", &bodies().blob, &bodies().blob, 60, still, [along](int k) { return along(0.002, 2.1)(k / 8); }});
  all.push_back({"coarse", &bodies().blob, &bodies().blob, 300, still, along(0.3, 2.05)});
  all.push_back({"fractions", &bodies().blob, &bodies().small, 60, still, [](int k) {
                   return Pose::from_quaternion(9, 1, 2, 3, {Rational(1400 + k) / 1000, Rational(1) / 7, 0});
                 }});
  all.push_back({"grows", &bodies().blob, &bodies().blob, 60, still,
                 [](int k) { return rotated(0.3, 2.6, 0.1, 0, 1 + 0.008 * k); }});
  all.push_back({"sheared now and then", &bodies().blob, &bodies().small, 80, still, [](int k) {
                   auto m = rotated(0.002 * k, 1.6 - 0.002 * k, 0, 0.1).entries();
                   if (k % 9 > 5) m[1] += 0.3;
                   if (k % 13 == 0) m[8] = -m[8];
                   return Pose(m);
                 }});
  all.push_back({"mirrored", &bodies().blob, &bodies().blob, 60, still, [](int k) {
                   auto m = rotated(0.004 * k, 2.1 - 0.001 * k, 0, 0).entries();
                   for (int i = 0; i < 3; ++i) m[4 * i] = -m[4 * i];
                   return Pose(m);
                 }});
  all.push_back({"far off", &bodies().blob, &bodies().blob, 60,
                 [](int k) { return rotated(0.01 * k, 1e9, 1e9 + k, 3e8); },
                 [](int k) { return rotated(0.01 * k + 0.001 * k, 1e9 + 2.1, 1e9 + k, 3e8); }});
  return all;
}

/// `uncovered` counts the pairs of elements that are below no entry of the front. `too_far` counts those whose distance
/// is less than what an entry says, or that meet. `gap_of` is an upper bound of the distance.
struct Judged {
  std::size_t uncovered = 0, too_far = 0, certified = 0;
};

void mark(const Bvh8& tree, Box_id box, std::vector<const Element*>& found)
{
  if (tree.is_leaf(box)) {
    for (Index k = 0; k < tree.leaf_count(box); ++k) found.push_back(&tree.element(box, k));
    return;
  }
  const Index child = tree.child(box);
  for (int part = 0; part < tree.node(child).boxes.lane_count; ++part) mark(tree, {child, part}, found);
}

Judged judge(const Bvh8_front& front, const Walk& walk, const Pose& pose_a, const Pose& pose_b)
{
  const Bvh8 &a = walk.a->tree, &b = walk.b->tree;
  const kernel::Relative_frame frame(pose_a, a.scale(), pose_b, b.scale());
  std::vector<const Element*> all_a, all_b;
  mark(a, {}, all_a);
  mark(b, {}, all_b);
  const auto numbers = [](const std::vector<const Element*>& all, const std::vector<const Element*>& some) {
    std::vector<std::size_t> found;
    for (const Element* one : some) found.push_back(std::find(all.begin(), all.end(), one) - all.begin());
    return found;
  };
  std::vector<kernel::Double_triangle> in_a, in_b;
  const auto corners = [](const Bvh8& tree, const Element& element) {
    kernel::Double_triangle t;
    for (int k = 0; k < 3; ++k) {
      const kernel::Vector p = tree.local(element.corner[k]);
      t[k] = {p[0], p[1], p[2]};
    }
    return t;
  };
  for (const Element* e : all_a) in_a.push_back(corners(a, *e));
  for (const Element* e : all_b) {
    in_b.push_back(corners(b, *e));
    for (auto& p : in_b.back()) p = frame(p);
  }
  std::vector<char> covered(all_a.size() * all_b.size(), 0);
  Judged judged;
  const auto cover = [&](Box_id box_a, Box_id box_b, double gap) {
    std::vector<const Element*> of_a, of_b;
    mark(a, box_a, of_a);
    mark(b, box_b, of_b);
    const std::vector<std::size_t> columns = numbers(all_b, of_b);
    for (const std::size_t i : numbers(all_a, of_a))
      for (const std::size_t j : columns) {
        covered[i * all_b.size() + j] = 1;
        if (!(gap > 0)) continue;
        ++judged.certified;
        judged.too_far += kernel::triangle_gap(in_a[i], in_b[j], 1e-6, 4).high < gap;
      }
  };
  for (std::size_t k = 0; k < front.entries().count(); ++k) {
    const Front_entry& entry = front.entries()[k];
    const double gap = front.gap(k);
    if (entry.kind == Front_entry::Kind::pair) {
      cover(entry.first, entry.second, gap);
      continue;
    }
    for (int lane = 0; lane < 8; ++lane) {
      if (!(entry.lanes >> lane & 1)) continue;
      if (entry.kind == Front_entry::Kind::node_of_a)
        cover({entry.first.node(), lane}, entry.second, gap);
      else
        cover(entry.second, {entry.first.node(), lane}, gap);
    }
  }
  for (const char one : covered) judged.uncovered += one == 0;
  return judged;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_walk_with_a_front_answers_as_without_and_as_the_truth)
{
  std::size_t answers[4] = {0, 0, 0, 0};
  for (const Walk& walk : walks()) {
    BOOST_TEST_INFO_SCOPE(walk.name);
    Bvh8_collision<> none(walk.a->tree, walk.b->tree), last(walk.a->tree, walk.b->tree, Coherence::last_frame);
    Pair_memory surface = Pair_memory::with_front(), solid = Pair_memory::with_front();
    int differ = 0, wrong = 0;
    for (int k = 0; k < walk.frames; ++k) {
      const Pose pose_a = walk.pose_a(k), pose_b = walk.pose_b(k);
      const Relation answer = none.relation(pose_a, pose_b, Question::solid);
      // One object for both fronts, and one that keeps its own for questions in turn.
      differ += none.relation(pose_a, pose_b, Question::solid, &solid) != answer;
      differ += (none.relation(pose_a, pose_b, Question::surface, &surface) == Relation::surfaces) !=
                (answer == Relation::surfaces);
      const Question question = k % 3 == 0 ? Question::surface : Question::solid;
      differ += last.relation(pose_a, pose_b, question) != none.relation(pose_a, pose_b, question);
      if (k % 8 == 0)
        wrong += verify::collide(walk.a->truth, pose_a, walk.b->truth, pose_b, Question::solid) !=
                 (answer != Relation::apart);
      ++answers[int(answer)];
    }
    BOOST_TEST(differ == 0);
    BOOST_TEST(wrong == 0);
  }
  for (const std::size_t count : answers) BOOST_TEST(count > 30u);
}

BOOST_AUTO_TEST_CASE(every_pair_of_elements_is_below_an_entry_that_holds_or_is_to_be_asked)
{
  std::size_t followed = 0, certified = 0;
  for (const Walk& walk : walks()) {
    BOOST_TEST_INFO_SCOPE(walk.name);
    Bvh8_collision<> collision(walk.a->tree, walk.b->tree);
    Pair_memory memory = Pair_memory::with_front();
    const Bvh8_front& front = *memory.front;
    std::size_t uncovered = 0, too_far = 0;
    for (int k = 0; k < walk.frames; ++k) {
      const Pose pose_a = walk.pose_a(k), pose_b = walk.pose_b(k);
      const std::size_t before = front.poses_followed();
      collision.relation(pose_a, pose_b, Question::surface, &memory);
      if (!front.holds() || memory.was_plane_found || memory.witness) continue;
      followed += front.poses_followed() > before;
      if (k % 4 != 0) continue;
      const Judged judged = judge(front, walk, pose_a, pose_b);
      uncovered += judged.uncovered;
      too_far += judged.too_far;
      certified += judged.certified;
    }
    BOOST_TEST(uncovered == 0u);
    BOOST_TEST(too_far == 0u);
  }
  BOOST_TEST_MESSAGE("poses followed: " << followed << ", pairs certified: " << certified);
  BOOST_TEST(followed > 300u);
  BOOST_TEST(certified > 1000000u);
}

BOOST_AUTO_TEST_CASE(small_steps_cost_a_few_tests_and_large_ones_no_more_than_without)
{
  const Body& body = bodies().blob;
  for (const double step : {0.0002, 0.3}) {
    Bvh8_collision<> none(body.tree, body.tree), last(body.tree, body.tree, Coherence::last_frame);
    for (int k = 0; k < 600; ++k) {
      const double t = step * k;
      const Pose pose = rotated(2 * t, 2.02 * std::cos(t), 2.02 * std::sin(t), 0.1 * std::sin(5 * t));
      none(Pose(), pose, Question::surface);
      last(Pose(), pose, Question::surface);
    }
    BOOST_TEST_MESSAGE(none.counts().box_tests << " without, " << last.counts().box_tests << " with");
    BOOST_TEST(none.counts().box_tests > 10000u);
    if (step < 0.1)
      BOOST_TEST(last.counts().box_tests * 4 < none.counts().box_tests);
    else
      BOOST_TEST(last.counts().box_tests < none.counts().box_tests * 1.05);
  }
}

BOOST_AUTO_TEST_CASE(bodies_at_rest_are_asked_nothing_again)
{
  // In the tunnel, where no plane is between them.
  Pair_memory memory = Pair_memory::with_front();
  Bvh8_collision<> tunnel(bodies().tunnel.tree, bodies().small.tree);
  const Pose inside = rotated(0.1, 0.2, 0.1, 1);
  for (int k = 0; k < 3; ++k)
    BOOST_TEST((tunnel.relation(Pose(), inside, Question::solid, &memory) == Relation::apart));
  BOOST_TEST(memory.holds_front());
  tunnel.clear_counts();
  BOOST_TEST((tunnel.relation(Pose(), inside, Question::solid, &memory) == Relation::apart));
  BOOST_TEST(tunnel.counts().box_tests == 0u);
  BOOST_TEST(tunnel.counts().leaf_pairs == 0u);
  BOOST_TEST(tunnel.counts().inclusion_tests == 0u);
}

BOOST_AUTO_TEST_CASE(a_body_that_passes_a_wall_between_two_poses_is_no_longer_where_it_was)
{
  // A thin wall, and a body that is in it in no pose, now on the one side and now on the other.
  const Body shell(with_cavity(cube(3), cube(2.99))), dust(cube(0.005));
  Bvh8_collision<> none(shell.tree, dust.tree), other_way(dust.tree, shell.tree);
  Pair_memory there = Pair_memory::with_front(), back = Pair_memory::with_front();
  const Bvh8_front& front = *there.front;
  int differ = 0, followed = 0, inside = 0;
  for (int k = 0; k < 200; ++k) {
    const Pose pose = rotated(0.01 * k, 2.995 - (k % 12 < 6 ? 0.03 : -0.03), 0.001 * k, 0.4);
    const Pose in_wall = k % 7 == 0 ? rotated(0.01 * k, 2.995, 0, 0.4, 0.1) : pose;
    const std::size_t before = front.poses_followed();
    differ += none.relation(Pose(), in_wall, Question::solid, &there) != none.relation(Pose(), in_wall);
    differ += other_way.relation(in_wall, Pose(), Question::solid, &back) != other_way.relation(in_wall, Pose());
    followed += front.holds() && front.poses_followed() > before;
    inside += none.relation(Pose(), in_wall) == Relation::b_in_a;
  }
  BOOST_TEST(differ == 0);
  BOOST_TEST(followed > 10);
  BOOST_TEST(inside > 20);
}

BOOST_AUTO_TEST_CASE(no_map_that_is_unknown_or_no_similarity_certifies)
{
  const Body& body = bodies().blob;
  const auto certifies = [&](const Pose& a, const Pose& b) {
    const kernel::Local_scale& units = body.tree.scale();
    const kernel::Box_map of_a(b, units, a, units), of_b(a, units, b, units);
    return Bvh8_front::is_certifiable({{body.tree.nodes(), body.tree.nodes()}, {&of_a, &of_b}, 1});
  };
  auto sheared = Pose().entries(), flat = sheared, far = sheared;
  sheared[1] = 0.1;
  flat[10] = 0x1p-100;
  far[3] = 1e300;
  BOOST_TEST(certifies(Pose(), rotated(1, 2, 3, 4)));
  BOOST_TEST(certifies(Pose(), random_rotation(*std::make_unique<Random>(1))));
  BOOST_TEST(!certifies(Pose(), Pose(sheared)));
  BOOST_TEST(!certifies(Pose(flat), Pose(flat)));
  BOOST_TEST(!certifies(Pose(), Pose(far)));
  // And is asked without a front.
  Bvh8_collision<> collision(body.tree, body.tree);
  Pair_memory memory = Pair_memory::with_front();
  BOOST_TEST((collision.relation(Pose(), Pose(sheared), Question::surface, &memory) == Relation::surfaces));
  BOOST_TEST(!memory.holds_front());
}

BOOST_AUTO_TEST_SUITE_END()
