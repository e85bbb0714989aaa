#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/tetratree/scene/scene.h"
#include "verify/test/support/said.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_scene_motions)

using namespace tetracone;
namespace scenes = verify::scenes;
using verify::said;

namespace {

using Row = std::tuple<double, double, Scene_pair>;

std::vector<Row> rows(const std::vector<Scene_contact>& contacts)
{
  std::vector<Row> all;
  for (const auto& [pair, first] : contacts) all.emplace_back(first.lo, first.hi, pair);
  return all;
}

std::vector<Body> bodies()
{
  return {Body(scenes::triangulated(scenes::cube_with_cavity())), Body(scenes::triangulated(scenes::unit_cube())),
          Body(scenes::triangulated(scenes::box({-1.5, -1.5, -0x1p-20}, {1.5, 1.5, 0x1p-20}))),
          Body(scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})),
          Body(scenes::triangulated(scenes::box({7, -0.5, -0.5}, {9, 0.5, 0.5})))};
}

std::array<double, 3> any_place(scenes::Random& random) { return scenes::grid_vertex(random, 5); }

/// On the grid, where bodies touch, or turned and stretched.
Pose any_pose(scenes::Random& random)
{
  const auto at = any_place(random);
  std::array<double, 12> m = Pose::translation(at[0], at[1], at[2]).rows();
  if (scenes::integer(random, 0, 2) == 0)
    for (double& x : m) x += scenes::real(random, -0.4, 0.4);
  return Pose(m);
}

/// At rest, on lines, far and fast, and turning.
Motion any_motion(scenes::Random& random)
{
  const int kind = scenes::integer(random, 0, 5);
  const Pose from = any_pose(random);
  if (kind == 0) return Motion::linear(from, from);
  if (kind < 4) {
    std::array<double, 12> to = any_pose(random).rows();
    if (kind == 3) to[11] = -4 * from.rows()[11];
    return Motion::linear(from, Pose(to));
  }
  const auto of = [&random] {
    const auto at = any_place(random);
    std::array<double, 7> numbers = {scenes::real(random, 0.1, 1), 0, 0, 0, at[0], at[1], at[2]};
    for (const int k : {1, 2, 3}) numbers[k] = scenes::real(random, -1, 1);
    return numbers;
  };
  return Motion::rigid(of(), of());
}

/// x -> a third of 2^-1040 x + t.
kernel::Pose third_of_2_to_the_minus_1040(double t)
{
  mpz_class divisor = 3;
  divisor <<= 1040;
  std::array<kernel::Rational, 12> m{};
  for (int k = 0; k < 3; ++k) m[5 * k] = 1 / kernel::Rational(divisor);
  m[3] = t;
  return kernel::Pose(m);
}

void check_scenes(const Scene_options& options, int rounds, bool by_makers = false)
{
  const std::vector<Body> models = bodies();
  const std::size_t n = 11, removed = 2;
  Scene scene(options);
  for (const Body& body : models)
    if (by_makers)
      scene.add_model([body] { return Body(body.polyhedron()); }, "made");
    else
      scene.add_model(body);
  const auto model_of = [&](std::size_t body) { return (7 * body + 3) % models.size(); };
  for (std::size_t k = 0; k < n; ++k) scene.add_body(model_of(k));
  scene.ignore(4, 1);
  scene.remove_body(removed);
  scenes::Random random(17);
  std::size_t found = 0, at_start = 0, within = 0, asked = 0, held = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Motion> motions;
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < n; ++k)
      if (k != removed) {
        numbers.push_back(k);
        motions.push_back(any_motion(random));
      }
    std::vector<Row> expected;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (std::size_t j = i + 1; j < numbers.size(); ++j) {
        const Scene_pair pair = {numbers[i], numbers[j]};
        Query query(models[model_of(pair.a)], models[model_of(pair.b)], options.question);
        const auto first = query.first_contact(motions[i], motions[j]);
        if (!first || pair == Scene_pair{1, 4}) continue;
        expected.emplace_back(first->lo, first->hi, pair);
        ++(first->hi == 0 ? at_start : within);
      }
    std::ranges::sort(expected);
    const std::vector<Scene_contact> contacts = scene.first_contacts(motions);
    BOOST_REQUIRE_MESSAGE(rows(contacts) == expected, "round " << round);
    for (const Scene_contact& contact : contacts) {
      BOOST_TEST(contact.first.holder.has_value() == (contact.first.hi > 0));
      if (!contact.first.holder) continue;
      // A holder's numbers are those of its own body.
      for (const std::size_t side : {0u, 1u}) {
        const Holder& holder = (*contact.first.holder)[side];
        const auto& polyhedron = models[model_of(side == 0 ? contact.pair.a : contact.pair.b)].polyhedron();
        const std::size_t count =
            holder.kind == Holder::Kind::face ? polyhedron.face_count() : polyhedron.vertices.size();
        for (const auto number : holder.number) BOOST_TEST(number < count);
        held += holder.kind != Holder::Kind::interior;
      }
    }
    found += expected.size();
    asked += scene.statistics().queries;
  }
  BOOST_TEST(found > std::size_t(rounds));
  BOOST_TEST(held > 0u);
  BOOST_TEST(at_start > 0u);
  BOOST_TEST(within > 0u);
  BOOST_TEST(asked >= found);
  BOOST_TEST(asked < std::size_t(rounds) * 45);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_huge_model_under_a_fraction_that_rounds_to_0_is_met_in_motion)
{
  // The cube's image is 2^-40 / 3 about the origin, the small one's of 2^-42.
  const Body huge(scenes::cube(0x1p1000)), small(scenes::cube(0x1p-42));
  Scene scene;
  for (const Body* body : {&huge, &small}) scene.add_body(scene.add_model(*body));
  const kernel::Pose still = third_of_2_to_the_minus_1040(0);
  const auto at = [](double x) { return kernel::Pose::translation(x, 0, 0); };
  const Motion rests(kernel::Body_motion::linear(still, still)),
      comes(kernel::Body_motion::linear(at(0x1p-38), at(0x1p-41)));
  const auto met = scene.first_contacts(std::vector{rests, comes});
  const auto expected = Query(huge, small).first_contact(rests, comes);
  BOOST_REQUIRE(expected);
  BOOST_REQUIRE(met.size() == 1u);
  BOOST_TEST(met[0].first.lo == expected->lo);
  BOOST_TEST(met[0].first.hi == expected->hi);
  BOOST_TEST(expected->lo > 0);
}

BOOST_AUTO_TEST_CASE(a_scene_has_the_first_contact_of_every_pair_in_order_of_time)
{
  check_scenes({}, 12);
  check_scenes({.question = Question::surface}, 6);
}

BOOST_AUTO_TEST_CASE(threads_and_memory_change_no_contact)
{
  check_scenes({.threads = 2}, 6);
  check_scenes({.memory = 300000}, 3, true);
}

BOOST_AUTO_TEST_CASE(bodies_move_on_lines_from_where_they_stand_and_stand_there_still)
{
  Scene scene;
  scene.add_model(Body(scenes::unit_cube()));
  const auto at = [](double x) { return Pose::translation(x, 0.25, 0.25); };
  for (const double x : {0.0, 3.0, 9.0, 20.0}) scene.place(scene.add_body(0), at(x));
  BOOST_TEST(scene.pairs().empty());
  const std::vector<Pose> to = {at(0), at(-3), at(1), at(20)};
  const std::vector<Scene_contact> contacts = scene.first_contacts(to);
  BOOST_REQUIRE(contacts.size() == 2u);
  BOOST_TEST((contacts[0].pair == Scene_pair{0, 1}));
  BOOST_TEST(contacts[0].first.lo == 1.0 / 3);
  BOOST_TEST((contacts[1].pair == Scene_pair{0, 2}));
  BOOST_TEST(contacts[1].first.lo == 1);  // they touch at the end
  BOOST_TEST(contacts[1].first.hi == 1);
  BOOST_TEST(scene.statistics().queries == 3u);  // the last body is near none
  BOOST_TEST(scene.pairs().empty());
  BOOST_TEST(scene.statistics().moved == 0u);
  BOOST_TEST(scene.distance(0, 1) == 2);
  BOOST_TEST(scene.frame(to).size() == 1u);
}

BOOST_AUTO_TEST_CASE(motions_that_cannot_be_followed_are_refused_with_a_line)
{
  Scene scene;
  scene.add_model(Body(scenes::unit_cube()));
  scene.add_model(Body(scenes::cube_with_tunnel()));
  scene.add_model([]() -> Body { throw Error("cube.off: not there; expected a model"); }, "cube.off");
  scene.add_body(0);
  const std::size_t holed = scene.add_body(1);
  const Motion rests = Motion::linear(Pose(), Pose());
  const std::vector<Motion> one(1, rests), two(2, rests);
  BOOST_TEST(said([&] { scene.first_contacts(one); }) == "scene: 1 motions of 2 bodies; expected one a body");
  BOOST_TEST(said([&] { scene.first_contacts(std::vector<Pose>(3)); }) ==
             "scene: 3 poses of 2 bodies; expected one a body");
  BOOST_TEST(said([&] { scene.first_contacts(std::vector<Pose>(2)); }) ==
             "scene: body 0 has no pose; expected a placed body");
  BOOST_TEST(said([&] { scene.first_contacts(two); }).starts_with("motion: model 1 has a face"));
  scene.set_model(holed, 2);
  BOOST_TEST(said([&] { scene.first_contacts(two); }) == "cube.off: not there; expected a model");
  Scene rounded({.query = {.kernel = Kernel::double_}});
  BOOST_TEST(said([&] { rounded.first_contacts(std::vector<Motion>{}); }) ==
             "query: kernel double follows no motion; expected adaptive");
}

BOOST_AUTO_TEST_SUITE_END()
