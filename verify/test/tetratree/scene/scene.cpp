#include "tetracone/tetratree/scene/scene.h"

#include "verify/test/support/object_cases.h"
#include "verify/test/support/said.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_scene)

using namespace tetracone;
namespace scenes = verify::scenes;
using verify::said;

namespace {

/// The models of the tests: round, flat, hollow, and one to fit the hollow.
std::vector<Body> bodies()
{
  return {Body(scenes::triangulated(scenes::torus(12, 8))), Body(scenes::unit_cube()), Body(scenes::cube_with_cavity()),
          Body(scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}))};
}

/// Small steps, jumps, rests, and steps on a grid, where bodies touch.
class Walk {
 public:
  explicit Walk(std::uint64_t seed) : random_(seed) {}

  Pose next(const std::optional<Pose>& last)
  {
    const int kind = scenes::integer(random_, 0, 9);
    if (last && kind < 4) return *last;
    std::array<double, 12> m = last ? last->rows() : Pose().rows();
    if (last && kind < 8) {
      for (double& x : m) x += scenes::real(random_, -1, 1) * (kind < 6 ? 0.001 : 0.05);
    } else {
      const auto turned = Pose::from_text({"3/5", "-4/5", "0", "0", "4/5", "3/5", "0", "0", "0", "0", "1", "0"});
      if (kind == 9) m = turned.rows();
      for (int i = 0; i < 3; ++i) m[4 * i + 3] = scenes::integer(random_, -9, 9) * 0.5;
    }
    return Pose(m);
  }

 private:
  scenes::Random random_;
};

/// By a query of its own for every pair and frame.
class Truth {
 public:
  std::vector<Body> models = bodies();

  bool collide(std::size_t model_a, const Pose& a, std::size_t model_b, const Pose& b, Question question) const
  {
    Query query(models[model_a], models[model_b], question);
    return bool(query.collide(a, b));
  }
};

void check_walk(const Scene_options& options, std::size_t n, int frames, bool by_makers = false)
{
  const Truth truth;
  Scene scene(options);
  for (const Body& body : truth.models)
    if (by_makers)
      scene.add_model([body] { return Body(body.polyhedron()); }, "made");
    else
      scene.add_model(body);
  std::vector<std::size_t> model_of;
  std::vector<std::optional<Pose>> poses(n);
  for (std::size_t k = 0; k < n; ++k) scene.add_body(model_of.emplace_back(k % truth.models.size()));
  scene.ignore(3, 1);
  Walk walk(n);
  std::size_t found = 0;
  for (int frame = 0; frame < frames; ++frame) {
    if (frame == frames / 2) {
      scene.remove_body(2);
      scene.set_model(0, 3);
      model_of[0] = 3;
    }
    for (std::size_t k = 0; k < n; ++k)
      if (k != 2 || frame < frames / 2) {
        if (frame % 4 == 1 && k % 3 == 0 && poses[k]) scene.place(k, walk.next(poses[k]));  // and on from there
        scene.place(k, *(poses[k] = walk.next(poses[k])));
      }
    std::vector<Scene_pair> expected;
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
        if (!(a == 1 && b == 3) && (frame < frames / 2 || (a != 2 && b != 2)) &&
            truth.collide(model_of[a], *poses[a], model_of[b], *poses[b], options.question))
          expected.push_back({a, b});
    BOOST_REQUIRE_MESSAGE(scene.pairs() == expected, "frame " << frame);
    BOOST_REQUIRE_MESSAGE(scene.pairs() == expected, "frame " << frame << ", asked again");
    found += expected.size();
  }
  BOOST_TEST(found > 0u);
}

/// A chain of rings that turn and sway by small steps, in contact now and then; and one beside the chain's first. Each
/// rests now and then, and one jumps away and back.
class Rings {
 public:
  static constexpr std::size_t count = 6, beside = 5;

  const std::optional<Pose>& operator[](std::size_t k) const { return poses_[k]; }

  void move(int frame)
  {
    for (std::size_t k = 0; k < count; ++k) {
      const bool jumps = frame % 17 == 16 && std::size_t(frame) % count == k;
      if (!poses_[k] || frame % 17 < 2 || jumps || (std::size_t(frame) + k) % 7 > 1)
        poses_[k] = k == beside ? mirrored(frame) : linked(double(k), frame, jumps ? 100 : 0);
    }
    if (frame % 6 == 0) poses_[0] = Pose();
  }

 private:
  static Pose linked(double k, int frame, double away)
  {
    const double a = (int(k) % 2) * M_PI / 2 + 0.002 * frame * (k + 1), c = std::cos(a), s = std::sin(a);
    return Pose(std::array<double, 12>{1, 0, 0, -3.9 * k + 0.12 * std::sin(0.05 * frame + k) + away, 0, c, -s,
                                       0.05 * std::cos(0.04 * frame), 0, s, c, 0});
  }

  /// The mirror image of a ring at the identity beyond its outermost vertex: there they touch, or are an ulp apart.
  static Pose mirrored(int frame)
  {
    const double x = frame % 12 == 0 ? 8 : std::nextafter(8.0, 9.0);
    return Pose(std::array<double, 12>{-1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0});
  }

  std::array<std::optional<Pose>, count> poses_;
};

/// Rings of three models, of which two change theirs and one goes, against queries of their own. Returns the most bytes
/// that a frame said.
std::size_t check_rings(const Scene_options& options, bool by_makers = false)
{
  const std::vector<Body> models = {Body(scenes::triangulated(scenes::torus(32, 20))),
                                    Body(scenes::triangulated(scenes::torus(28, 18))),
                                    Body(scenes::triangulated(scenes::torus(36, 20)))};
  Scene scene(options);
  int made = 0;
  for (const Body& body : models)
    if (by_makers)
      scene.add_model(
          [&made, body] {
            ++made;
            return Body(body.polyhedron());
          },
          "made");
    else
      scene.add_model(body);
  std::vector<std::size_t> model_of;
  for (std::size_t k = 0; k < Rings::count; ++k) scene.add_body(model_of.emplace_back(k < 5 ? k % 3 : 0));
  Rings rings;
  std::size_t found = 0, asked = 0, most = 0;
  for (int frame = 0; frame < 72; ++frame) {
    rings.move(frame);
    for (std::size_t k = 0; k < Rings::count; ++k)
      if (k != 4 || frame < 50) scene.place(k, *rings[k]);
    if (frame % 20 == 13)
      for (const std::size_t k : {1, 2}) scene.set_model(k, model_of[k] = (model_of[k] + 1) % 3);
    if (frame == 50) scene.remove_body(4);
    std::vector<Scene_pair> expected;
    for (std::size_t a = 0; a < Rings::count; ++a)
      for (std::size_t b = a + 1; b < Rings::count; ++b) {
        if (frame >= 50 && (a == 4 || b == 4)) continue;
        Query query(models[model_of[a]], models[model_of[b]], options.question);
        if (query.collide(*rings[a], *rings[b])) expected.push_back({a, b});
      }
    BOOST_REQUIRE_MESSAGE(scene.pairs() == expected, "frame " << frame);
    found += expected.size();
    asked += scene.statistics().queries;
    most = std::max(most, scene.statistics().bytes);
  }
  BOOST_TEST(found > 72u);
  BOOST_TEST(found < asked);
  if (by_makers) BOOST_TEST(made > 30);
  return most;
}

/// Turned by an eighth about z: beside a cube, their boxes meet and they do not.
Pose turned(double x, double y = 0.7)
{
  const double c = std::sqrt(0.5);
  return Pose(std::array<double, 12>{c, -c, 0, x, c, c, 0, y, 0, 0, 1, 0});
}

void add_two_cubes(Scene& scene)
{
  scene.add_model(Body(scenes::unit_cube()));
  for (int k = 0; k < 2; ++k) scene.add_body(0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_frame_has_exactly_the_pairs_that_collide)
{
  check_walk({}, 24, 40);
  check_walk({.question = Question::surface}, 24, 30);
  check_walk({.threads = 3}, 24, 30);
  check_walk({.query = {.kernel = Kernel::rational}}, 8, 6);
  // With this many bodies, the trees of their models are built before their boxes.
  check_walk({}, 48, 6);
  check_walk({.threads = 2}, 48, 6);
}

BOOST_AUTO_TEST_CASE(models_that_are_given_back_change_no_answer) { check_walk({.memory = 400000}, 24, 12, true); }

BOOST_AUTO_TEST_CASE(fronts_that_near_pairs_keep_change_no_answer)
{
  const std::size_t most = check_rings({});
  check_rings({.question = Question::surface, .threads = 2});
  // Two models, and fronts of theirs.
  check_rings({.memory = 2 * most / 3}, true);
}

BOOST_AUTO_TEST_CASE(pairs_that_are_apart_are_not_asked_again_before_the_gap_is_used_up)
{
  Scene scene;
  add_two_cubes(scene);
  scene.place(0, Pose());
  scene.place(1, turned(1.45));
  BOOST_TEST(scene.pairs().empty());
  std::size_t asked = scene.statistics().queries;
  BOOST_TEST(asked == 1u);
  for (int k = 1; k <= 100; ++k) {
    scene.place(1, turned(1.45 - k * 1e-4));
    BOOST_TEST(scene.pairs().empty());
    asked += scene.statistics().queries;
  }
  BOOST_TEST(asked < 20u);
  scene.place(1, Pose());
  BOOST_TEST((scene.pairs() == std::vector<Scene_pair>{{0, 1}}));
}

BOOST_AUTO_TEST_CASE(pairs_whose_bodies_move_alike_are_not_asked_again)
{
  Scene scene;
  add_two_cubes(scene);
  std::size_t asked = 0;
  for (int k = 0; k < 100; ++k) {
    const double x = 0.25 * k, y = 0.01 * k * k;
    scene.place(0, Pose::translation(x, y, 0));
    scene.place(1, turned(x + 1.45, y + 0.7));
    BOOST_TEST(scene.pairs().empty());
    asked += scene.statistics().queries;
  }
  // The first ones all pairs of faces, which tells no gap.
  BOOST_TEST(asked < 12u);
  scene.place(0, Pose::translation(0.25 * 99 + 0.5, 0.01 * 99 * 99, 0));
  BOOST_TEST(scene.pairs().size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_step_that_is_summed_up_by_other_rounding_keeps_no_answer)
{
  Scene scene;
  add_two_cubes(scene);
  scene.place(0, Pose());
  for (int k = 0; k < 24; ++k) {
    const Pose pose = turned(1.45 - k * 1e-6);
    if (k == 22) std::fesetround(FE_DOWNWARD);
    scene.place(1, pose);
    std::fesetround(FE_TONEAREST);
    BOOST_TEST(scene.pairs().empty());
    if (k > 20) BOOST_TEST(scene.statistics().queries == (k == 22 ? 1u : 0u));
  }
}

BOOST_AUTO_TEST_CASE(a_long_body_that_becomes_another_has_its_turned_box_no_more)
{
  Scene scene;
  scene.add_model(Body(scenes::box({-10, -0.5, -0.5}, {10, 0.5, 0.5})));
  scene.add_model(Body(scenes::cube(3)));
  scene.add_model(Body(scenes::cube(1)));
  scene.place(scene.add_body(0), Pose());
  scene.place(scene.add_body(2), Pose::translation(0, 3, 0));
  BOOST_TEST(scene.pairs().empty());
  scene.set_model(0, 1);
  BOOST_TEST(scene.pairs().size() == 1u);
  scene.set_model(0, 0);
  BOOST_TEST(scene.pairs().empty());
}

BOOST_AUTO_TEST_CASE(a_model_is_made_when_a_body_of_it_is_placed_and_treed_when_another_is_near)
{
  int made = 0;
  Scene scene;
  scene.add_model(
      [&] {
        ++made;
        return Body(scenes::triangulated(scenes::torus(12, 8)));
      },
      "torus");
  scene.add_model([]() -> Body { throw Error("never needed"); }, "none");
  scene.add_body(0);
  scene.add_body(0);
  scene.add_body(1);
  BOOST_CHECK_THROW(scene.pairs(), Error);
  BOOST_TEST(made == 0);
  scene.place(0, Pose());
  scene.place(1, Pose::translation(9, 0, 0));
  scene.pairs();
  BOOST_TEST(made == 1);
  BOOST_TEST(scene.statistics().nodes_made == 0u);
  scene.place(1, Pose::translation(0.5, 0, 0));
  BOOST_TEST(scene.pairs().size() == 1u);
  BOOST_TEST(scene.statistics().nodes_made > 0u);
  BOOST_TEST(scene.relation(0, 1) == Relation::surfaces);
  BOOST_TEST(scene.distance(0, 1) == 0);
  BOOST_TEST(scene.within(0, 1, 0));
  BOOST_TEST(scene.contacts(0, 1).size() > 0u);
}

BOOST_AUTO_TEST_CASE(small_bodies_that_are_asked_seldom_get_no_trees)
{
  Scene scene;
  scene.add_model(Body(scenes::unit_cube()));
  for (int k = 0; k < 2; ++k) scene.place(scene.add_body(0), Pose::translation(0.5 * k, 0, 0));
  BOOST_TEST(scene.pairs().size() == 1u);
  BOOST_TEST(scene.statistics().queries == 1u);
  std::size_t nodes = scene.statistics().nodes_made;
  BOOST_TEST(nodes == 0u);
  for (int k = 0; k < 100; ++k) {
    scene.place(1, Pose::translation(0.5 + 0.001 * k, 0, 0));
    BOOST_TEST(scene.pairs().size() == 1u);
    nodes += scene.statistics().nodes_made;
  }
  BOOST_TEST(nodes > 0u);
}

BOOST_AUTO_TEST_CASE(a_budget_leaves_pairs_undecided_and_later_frames_decide_them)
{
  const Body torus(scenes::triangulated(scenes::torus(24, 16)));
  Scene hurried({.budget = std::chrono::nanoseconds(1)}), scene;
  for (Scene* each : {&hurried, &scene}) {
    each->add_model(torus);
    for (int k = 0; k < 6; ++k) each->place(each->add_body(0), Pose::translation(k * 0.9, 0, 0));
  }
  const std::vector<Scene_pair> all = scene.pairs();
  const std::size_t decided = hurried.pairs().size();
  BOOST_TEST(decided + hurried.undecided().size() >= all.size());
  BOOST_TEST(!hurried.undecided().empty());
  for (const Undecided_pair& left : hurried.undecided())
    BOOST_TEST(scene.distance(left.pair.a, left.pair.b) <= left.farthest);

  const Scene_pair first = hurried.undecided().front().pair;
  hurried.remove_body(first.a);
  hurried.pairs();
  BOOST_TEST(!hurried.undecided().empty());
  for (const Undecided_pair& left : hurried.undecided()) BOOST_TEST((left.pair.a != first.a && left.pair.b != first.a));
}

BOOST_AUTO_TEST_CASE(misuse_is_refused_with_a_line)
{
  Scene scene;
  BOOST_TEST(said([&] { scene.add_body(0); }) == "scene: model 0 of 0; expected a model's number");
  scene.add_model(Body(scenes::unit_cube()));
  const std::size_t body = scene.add_body(0), other = scene.add_body(0);
  BOOST_TEST(said([&] { scene.set_model(body, 7); }) == "scene: model 7 of 1; expected a model's number");
  BOOST_TEST(said([&] { scene.place(9, Pose()); }) == "scene: body 9 is not there; expected the number of one that is");
  BOOST_TEST(said([&] { scene.relation(body, other); }) == "scene: body 0 has no pose; expected a placed body");
  BOOST_TEST(said([&] { scene.ignore(body, body); }) == "scene: body 0 with itself; expected two bodies to ignore");
  BOOST_TEST(said([&] { scene.frame({}); }) == "scene: 0 poses of 2 bodies; expected one a body");
  scene.remove_body(other);
  BOOST_TEST(said([&] { scene.remove_body(other); }) ==
             "scene: body 1 is not there; expected the number of one that is");
  BOOST_TEST(said([] { Scene({.budget = std::chrono::nanoseconds(-1)}); }) ==
             "scene: a budget below 0; expected nanoseconds, or 0 for no limit");
}

BOOST_AUTO_TEST_CASE(what_fails_once_is_asked_again)
{
  bool is_there = false;
  Scene scene;
  scene.add_model(
      [&] {
        if (!is_there) throw Error("cube.off: not yet; expected later");
        return Body(scenes::unit_cube());
      },
      "cube");
  for (int k = 0; k < 2; ++k) scene.place(scene.add_body(0), Pose());
  BOOST_TEST(said([&] { scene.pairs(); }) == "cube.off: not yet; expected later");
  is_there = true;
  BOOST_TEST(scene.pairs().size() == 1u);

  Scene open;
  open.add_model(Body(scenes::polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})));
  open.place(open.add_body(0), Pose());
  BOOST_TEST(said([&] { open.pairs(); }).starts_with("model 0 is open at 3 edges"));

  Scene small({.memory = 1000});
  small.add_model([] { return Body(scenes::triangulated(scenes::torus(24, 16))); }, "torus");
  for (int k = 0; k < 2; ++k) small.place(small.add_body(0), Pose());
  BOOST_TEST(said([&] { small.pairs(); }).starts_with("scene: a memory of 1000 bytes does not hold 'torus'"));
  // The pair was answered before the memory was looked at.
  BOOST_TEST(small.pairs().size() == 1u);
}

BOOST_AUTO_TEST_CASE(pairs_that_were_answered_before_a_failure_are_told_later)
{
  bool is_there = true;
  Polyhedron tall = scenes::unit_cube();
  for (auto& x : tall.vertices) x[2] *= 1.5;
  Scene scene({.memory = 32000});
  const std::size_t first = scene.add_model([] { return Body(scenes::unit_cube()); }, "first");
  const std::size_t second = scene.add_model(
      [&] {
        if (!is_there) throw Error("second.off: not now; expected later");
        return Body(tall);
      },
      "second");
  for (const std::size_t model : {first, first, second, second}) scene.add_body(model);
  // The second cube of each two is turned, so that boxes meet before the bodies do.
  const auto pairs_at = [&](double d) {
    const double c = std::sqrt(0.5);
    for (const double x : {0.0, 50.0}) {
      const std::size_t body = x == 0 ? 0 : 2;
      scene.place(body, Pose::translation(x, 0, 0));
      scene.place(body + 1, Pose(std::array<double, 12>{c, -c, 0, x + d, c, c, 0, d - c, 0, 0, 1, 0}));
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const Scene_pair& pair : scene.pairs()) pairs.push_back({pair.a, pair.b});
    return pairs;
  };
  const std::vector<std::pair<std::size_t, std::size_t>> none, both = {{0, 1}, {2, 3}};
  for (const auto& [d, expected] : {std::pair(1.5, none), {1.3, both}, {1.5, none}, {1.3, both}}) {
    is_there = false;
    said([&] { pairs_at(d); });  // at the first distance no model has been made yet
    is_there = true;
    BOOST_TEST((pairs_at(d) == expected), d);
  }
}

BOOST_AUTO_TEST_CASE(one_thread_makes_the_models_of_pairs_within_a_distance)
{
  const auto own = std::this_thread::get_id();
  std::atomic<std::size_t> elsewhere = 0;
  Scene scene({.threads = 2, .memory = 110000});
  for (int m = 0; m < 4; ++m)
    scene.add_model(
        [&elsewhere, own, m] {
          elsewhere += std::this_thread::get_id() != own;
          Polyhedron tall = scenes::unit_cube();
          for (auto& x : tall.vertices) x[2] *= 1 + m;
          return Body(tall);
        },
        "cube");
  for (int k = 0; k < 16; ++k) scene.place(scene.add_body(std::size_t(k % 4)), Pose::translation(1.5 * k, 0, 0));
  for (int n = 0; n < 10; ++n) BOOST_TEST(scene.pairs_within("1/2").size() == 15u);
  BOOST_TEST(elsewhere == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
