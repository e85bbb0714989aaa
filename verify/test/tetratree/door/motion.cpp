#include "tetracone/tetratree/door/motion.h"

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <string>

BOOST_AUTO_TEST_SUITE(test_motion)

using namespace tetracone;
namespace scenes = tetracone::verify::scenes;

namespace {

using Seven = std::array<double, 7>;

const Motion rests = Motion::linear(Pose(), Pose());

Motion shift(double from, double to)
{
  return Motion::linear(Pose::translation(from, 0.25, 0.25), Pose::translation(to, 0.25, 0.25));
}

bool says(const Error& error, const std::string& words)
{
  return std::string(error.what()).find(words) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bodies_are_followed_to_their_first_contact)
{
  const Body cube(scenes::unit_cube());
  Query query(cube, cube);
  const auto first = query.first_contact(rests, shift(3, -3));
  BOOST_REQUIRE(first.has_value());
  BOOST_TEST(first->lo == 1.0 / 3);
  BOOST_TEST(first->hi == std::nextafter(1.0 / 3, 1));
  BOOST_REQUIRE(first->holder.has_value());
  BOOST_TEST(((*first->holder)[0].kind != Holder::Kind::interior));
  BOOST_TEST(query.statistics().exact_fallbacks > 0u);
  BOOST_TEST(!query.first_contact(rests, shift(3, 1.5)));
  const auto at_end = query.first_contact(rests, shift(3, 1));
  BOOST_REQUIRE(at_end.has_value());
  BOOST_TEST(at_end->lo == 1);
  BOOST_TEST(at_end->hi == 1);
  query.clear_statistics();
  BOOST_TEST(query.statistics().exact_fallbacks == 0u);
}

BOOST_AUTO_TEST_CASE(what_collides_at_the_start_is_in_contact_at_0_and_the_question_matters_there)
{
  const Body room(scenes::cube(2)), ball(scenes::cube(0.5));
  const Motion out = Motion::linear(Pose(), Pose::translation(4, 0, 0));
  const auto solid = Query(room, ball).first_contact(rests, out);
  BOOST_REQUIRE(solid.has_value());
  BOOST_TEST(solid->hi == 0);
  BOOST_TEST(!solid->holder.has_value());
  const auto surface = Query(room, ball, Question::surface).first_contact(rests, out);
  BOOST_REQUIRE(surface.has_value());
  BOOST_TEST(surface->lo == 0.375);
  BOOST_TEST(surface->hi == 0.375);
}

BOOST_AUTO_TEST_CASE(surfaces_apart_at_the_start_or_not_are_told_in_any_order)
{
  const Body cube(scenes::unit_cube());
  Query query(cube, cube, Question::surface);
  for (int round = 0; round < 3; ++round) {
    const auto apart = query.first_contact(rests, shift(3, -3));
    BOOST_REQUIRE(apart.has_value());
    BOOST_TEST(apart->lo == 1.0 / 3);
    BOOST_TEST(!query.first_contact(rests, shift(3, 1.5)));
    for (int k = 0; k <= round; ++k) {
      const auto begun = query.first_contact(rests, shift(0.5 * k, 4));
      BOOST_REQUIRE(begun.has_value());
      BOOST_TEST(begun->hi == 0);
      BOOST_TEST(!begun->holder.has_value());
    }
  }
}

BOOST_AUTO_TEST_CASE(rigid_motions_are_of_doubles_or_fractions)
{
  const Body bar(scenes::box({-3, -0.5, -0.5}, {3, 0.5, 0.5})), post(scenes::box({-0.5, 2, -4}, {0.5, 3, 4}));
  Query query(bar, post);
  const Seven start = {1, 0, 0, 0, 0, 0, 0}, turned = {1, 0, 0, 1, 0, 0, 0};
  const Motion still = Motion::rigid(start, start), turns = Motion::rigid(start, turned);
  const auto first = query.first_contact(turns, still);
  BOOST_REQUIRE(first.has_value());
  const std::array<std::string, 7> whole = {"1", "0", "0", "0", "0", "0", "0"},
                                   scaled = {"1/3", "0", "0", "1/3", "0", "0", "0"};
  // A quaternion's length changes the speed of its turn, but not the turn.
  const auto other = query.first_contact(Motion::rigid_from_text(whole, scaled), still);
  BOOST_REQUIRE(other.has_value());
  BOOST_TEST(other->lo > first->lo);
  // Until the bar's end is over the post: the static answer changes about the time.
  const auto pose = [&](double time) { return turns.exact().at(time); };
  BOOST_TEST(!query.collide(pose(first->lo * 0.999), still.exact().at(0)));
  BOOST_TEST(bool(query.collide(pose(first->hi), still.exact().at(0))));
}

BOOST_AUTO_TEST_CASE(what_no_motion_can_be_is_refused)
{
  const Seven one = {1, 0, 0, 0, 0, 0, 0}, against = {-2, 0, 0, 0, 0, 0, 0}, zero = {0, 0, 0, 0, 1, 0, 0};
  Seven bad = one;
  bad[5] = std::numeric_limits<double>::infinity();
  BOOST_CHECK_EXCEPTION(Motion::rigid(one, against), Error, [](const Error& e) { return says(e, "is 0 at some t"); });
  BOOST_CHECK_THROW(Motion::rigid(one, zero), Error);
  BOOST_CHECK_EXCEPTION(Motion::rigid(one, bad), Error, [](const Error& e) { return says(e, "'inf'"); });
  BOOST_CHECK_EXCEPTION(
      Motion::rigid_from_text({"1", "0", "0", "0", "0", "0", "x"}, {"1", "0", "0", "0", "0", "0", "0"}), Error,
      [](const Error& e) { return says(e, "'x'"); });

  const Body cube(scenes::unit_cube()), holed(scenes::cube_with_tunnel());
  Query rounded(cube, cube, Question::solid, {.kernel = Kernel::double_});
  BOOST_CHECK_EXCEPTION(rounded.first_contact(rests, rests), Error,
                        [](const Error& e) { return says(e, "kernel double follows no motion"); });
  Query whole(cube, holed);
  BOOST_CHECK_EXCEPTION(whole.first_contact(rests, shift(9, 8)), Error,
                        [](const Error& e) { return says(e, "body b has a face") && says(e, "without triangles"); });
}

BOOST_AUTO_TEST_SUITE_END()
