#include "tetracone/tetratree/door/certificate.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_certificate)

namespace scenes = tetracone::verify::scenes;
using tetracone::Body;
using tetracone::Certificate;
using tetracone::Error;
using tetracone::Location;
using tetracone::Query;
using tetracone::Question;
using tetracone::Ray;
using tetracone::Relation;
using tetracone::kernel::Pose;
using tetracone::verify::Temporary_file;

namespace {

/// True when the checker proves all answers, without any code of ours.
bool is_proved(const Certificate& certificate)
{
  const Temporary_file file("certificate.json", certificate.text());
  const std::string command =
      std::string("'" TETRACONE_PYTHON "' -B '" TETRACONE_SOURCE_DIR "/experiments/certificates/check.py' '") +
      file.path().string() + "' >/dev/null";
  return std::system(command.c_str()) == 0;
}

/// Poses that touch, cross, hold and part two bodies about the origin; the last are not rigid, and in fractions.
std::vector<Pose> poses()
{
  std::vector<Pose> poses = {Pose(),
                             Pose::translation(2, 0, 0),
                             Pose::translation(1.5, 1.25, 0.1),
                             Pose::translation(2, 2, 2),
                             Pose::translation(0x1p-40 + 4, 1, 0),
                             Pose::translation(-40, 1, 1e-300),
                             Pose::from_quaternion(3, 1, 2, 5, {3, -2, 1})};
  for (const double size : {0.125, 0.5, 2.0, 9.0, 1e-150, 1e150})
    poses.emplace_back(std::array<double, 12>{size, 0, 0, 0.25, 0, size, 0, 0.125, 0, size / 8, size, -0.5});
  return poses;
}

std::vector<tetracone::Polyhedron> bodies()
{
  return {scenes::unit_cube(), scenes::cube_with_cavity(), scenes::triangulated(scenes::cube(1)),
          scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})};
}

}  // namespace

BOOST_AUTO_TEST_CASE(collisions_and_distances_are_proved)
{
  for (const auto& a : bodies())
    for (const auto& b : bodies()) {
      Certificate certificate{Body(a), Body(b)};
      for (const Question question : {Question::solid, Question::surface}) {
        Query query{Body(a), Body(b), question};
        for (const Pose& pose : poses()) {
          certificate.collide(Pose(), pose, question, query.collide(Pose(), pose).relation());
          const auto nearest = query.nearest(Pose(), pose);
          certificate.distance(Pose(), pose, question, nearest);
          for (const char* limit : {"-1", "0", "1/3", "1.5", "100"})
            certificate.within(Pose(), pose, question, limit, query.within(Pose(), pose, limit), nearest);
        }
      }
      BOOST_TEST(is_proved(certificate));
    }
}

BOOST_AUTO_TEST_CASE(points_and_rays_are_proved)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const auto& a : bodies()) {
    const Body body(a);
    Certificate certificate(body);
    for (const char* x : {"0", "1/3", "1", "-2.5", "2.9999999999999996"})
      for (const char* y : {"0.25", "0", "1", "3"}) {
        const std::array<std::string, 3> point = {x, y, "1/7"};
        certificate.inside(point, body.inside_text(point));
      }
    for (const double x : {0.0, 0.5, -1.0, 3.0, 1e-30})
      for (const double y : {1.0, 0.25, -0.125})
        for (const double end : {infinite, 1.0, 0.0, -1.0}) {
          const Ray ray{{x, y, -4}, {y - 0.5, x / 3, 2}}, within{{x, 0.5, y}, {1, y, 0}};
          for (const Ray& r : {ray, within}) certificate.first_hit(r, body.first_hit(r, end), end);
        }
    BOOST_TEST(is_proved(certificate));
  }
}

BOOST_AUTO_TEST_CASE(a_wrong_answer_gets_no_certificate)
{
  const Body cube(scenes::unit_cube());
  Certificate pair(cube, cube), one(cube);
  const Pose far = Pose::translation(3, 0, 0);
  for (const Relation wrong : {Relation::surfaces, Relation::a_in_b, Relation::b_in_a})
    BOOST_CHECK_THROW(pair.collide(Pose(), far, Question::solid, wrong), Error);
  for (const Relation wrong : {Relation::apart, Relation::a_in_b})
    BOOST_CHECK_THROW(pair.collide(Pose(), Pose(), Question::solid, wrong), Error);
  BOOST_CHECK_THROW(one.inside({"1/2", "1/2", "1/2"}, Location::outside), Error);
  BOOST_CHECK_THROW(one.inside({"1/2", "1/2", "1/2"}, Location::on_surface), Error);
  for (const Location wrong : {Location::inside, Location::outside})
    BOOST_CHECK_THROW(one.inside({"1/2", "1/2", "1"}, wrong), Error);
  BOOST_CHECK_THROW(one.first_hit(Ray{{-1, 0.5, 0.25}, {1, 0, 0}}, std::nullopt), Error);
  // The questions of the other kind of certificate.
  BOOST_CHECK_THROW(one.collide(Pose(), far, Question::solid, Relation::apart), Error);
  BOOST_CHECK_THROW(pair.inside({"0", "0", "9"}, Location::outside), Error);
}

BOOST_AUTO_TEST_SUITE_END()
