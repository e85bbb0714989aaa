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
using namespace tetracone;
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

BOOST_AUTO_TEST_CASE(a_query_gives_its_certificate)
{
  for (const auto& a : bodies())
    for (const auto& b : bodies()) {
      Query query{Body(a), Body(b)};
      Certificate certificate(query);
      for (const Pose& pose : poses()) {
        BOOST_TEST(certificate.collide(query, Pose(), pose).relation() == query.collide(Pose(), pose).relation());
        BOOST_TEST(certificate.distance(query, Pose(), pose).squared == query.nearest(Pose(), pose).squared);
        BOOST_TEST(certificate.within(query, Pose(), pose, "1.5") == query.within(Pose(), pose, "1.5"));
      }
      BOOST_TEST(certificate.without_proof() == 0);
      BOOST_TEST(is_proved(certificate));
    }
}

BOOST_AUTO_TEST_CASE(solids_that_touch_are_proved)
{
  const auto cube = [](double size, double x, double y, double z) {
    return Pose(std::array<double, 12>{size, 0, 0, x, 0, size, 0, y, 0, 0, size, z});
  };
  using tetracone::Solid_relation;
  const Body one(scenes::unit_cube()), hollow(scenes::cube_with_cavity());
  Query same(one, one), held(one, hollow);
  Certificate of_cubes(same), of_hollow(held);
  const auto is_so = [](Certificate& certificate, Query& query, const Pose& pose, Solid_relation expected) {
    BOOST_TEST(certificate.relation(query, pose, Pose()).relation == expected);
    BOOST_TEST(certificate.without_proof() == 0);
  };
  is_so(of_cubes, same, Pose(), Solid_relation::equal);
  is_so(of_cubes, same, cube(0.5, 0, 0, 0), Solid_relation::covered_by);
  is_so(of_cubes, same, cube(0.5, 0.25, 0.25, 0), Solid_relation::covered_by);
  is_so(of_cubes, same, cube(2, 0, -0.5, 0), Solid_relation::covers);
  is_so(of_cubes, same, cube(1, 1, 0.25, 0), Solid_relation::meet);
  is_so(of_cubes, same, cube(1, 0.5, 0.25, 0), Solid_relation::overlap);
  is_so(of_cubes, same, cube(0.5, 0.25, 0.25, 0.25), Solid_relation::inside);
  is_so(of_cubes, same, cube(3, -1, -1, -1), Solid_relation::contains);
  is_so(of_cubes, same, cube(1, 3, 0, 0), Solid_relation::disjoint);
  BOOST_TEST(is_proved(of_cubes));
  // No plane is between bodies of which one fills the cavity of the other, or touches its walls.
  is_so(of_hollow, held, cube(4, -2, -2, -2), Solid_relation::meet);
  is_so(of_hollow, held, cube(1, 1, 0, 0), Solid_relation::meet);
  is_so(of_hollow, held, cube(1, 2, 0, 0), Solid_relation::covered_by);
  is_so(of_hollow, held, cube(1, -0.5, -0.5, 3), Solid_relation::meet);
  BOOST_TEST(is_proved(of_hollow));
}

BOOST_AUTO_TEST_CASE(an_overlap_of_surfaces_that_are_apart_is_left_out)
{
  const covering::Polyhedron cube = scenes::unit_cube();
  covering::Polyhedron large = cube, two = cube, other = cube;
  for (auto& v : large.vertices)
    for (double& x : v) x = 3 * x - 1;
  for (auto& v : other.vertices) v[0] += 10;
  covering::append(two, other);
  Query query{Body(two), Body(large)};
  Certificate certificate(query);
  BOOST_TEST(certificate.relation(query, Pose(), Pose()).relation == tetracone::Solid_relation::overlap);
  BOOST_TEST(certificate.without_proof() == 1);
}

BOOST_AUTO_TEST_CASE(answers_far_from_the_origin_are_proved_as_near_ones)
{
  const Body cube(scenes::unit_cube()), large(scenes::cube(1));
  // The parts of the proofs that a search may not find, when both bodies are moved this far.
  const auto found = [&](const Body& body, double far, double aside) {
    const Pose a = Pose::translation(far, -far, far / 2),
               b = Pose::translation(far + aside, -far - aside / 2, far / 2 + aside / 4);
    Query query{body, cube};
    Certificate certificate(query);
    certificate.collide(query, a, b);
    certificate.relation(query, a, b);
    certificate.exits(query, a, b, {"1", "0", "1/3"});
    certificate.depth(query, a, b);
    BOOST_TEST(certificate.without_proof() == 0);
    BOOST_TEST(is_proved(certificate));
    const std::string text = certificate.text();
    return std::array{text.find("\"overlap\":[") != std::string::npos, text.find("\"low\":{") != std::string::npos};
  };
  for (const Body& body : {cube, large}) {
    BOOST_TEST((found(body, 0, 0.75) == std::array{true, true}));
    BOOST_TEST((found(body, 0x1p40, 0.75) == std::array{true, true}));
    BOOST_TEST((found(body, -0x1p300, 0) == found(body, 0, 0)));
  }
}

BOOST_AUTO_TEST_CASE(numbers_near_the_ends_of_the_doubles_are_proved_or_left_out)
{
  const Body cube(scenes::unit_cube());
  const auto scaled = [](double size) {
    return Pose(std::array<double, 12>{size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0});
  };
  Query query{cube, cube};
  Certificate certificate(query);
  const auto is_proved_relation = [&](const Pose& a, const Pose& b) {
    return certificate.relation(a, b, query.solid_relation(a, b).relation);
  };
  for (const double size : {1e-100, 0x1p1020}) BOOST_TEST(is_proved_relation(scaled(size), scaled(size / 2)), size);
  BOOST_TEST(is_proved_relation(Pose(), Pose(std::array<double, 12>{1, 0, 0, 1e-100, 0, 1, 0, 0.25, 0, 0, 1, 0.5})));
  const auto is_proved_exit = [&](const Pose& pose, const std::array<std::string, 3>& along) {
    return certificate.exits(pose, pose, along, query.exits(pose, pose, along));
  };
  BOOST_TEST(is_proved_exit(Pose(), {"1e-320", "0", "0"}));
  // What follows the last exit is beyond the doubles.
  BOOST_TEST(!is_proved_exit(scaled(0x1.8p1023), {"1", "1", "0"}));
  // A quaternion may be short.
  const Motion still = Motion::linear(tetracone::Pose(), tetracone::Pose()),
               turns = Motion::rigid({1e-160, 0, 0, 0, 9, 0, 0}, {0, 0, 0, 1, 5, 0, 0});
  BOOST_TEST(certificate.first_contact(still, turns, Question::solid, query.first_contact(still, turns)));
  BOOST_TEST(is_proved(certificate));
}

BOOST_AUTO_TEST_CASE(answers_near_a_face_whose_loop_crosses_itself_are_left_out)
{
  covering::Polyhedron bow;
  bow.vertices = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 1}};
  bow.add_face({{0, 1, 2, 3}});
  for (Index k = 0; k < 4; ++k) bow.add_face({{(k + 1) % 4, k, 4}});
  const Body body(bow), cube(scenes::cube(0.05));
  const Pose beside = Pose::translation(1, 0.2, 0);
  for (const Question question : {Question::solid, Question::surface}) {
    Query query{body, cube, question};
    Certificate certificate(query);
    BOOST_TEST((certificate.collide(query, Pose(), beside).relation() == Relation::apart));
    certificate.distance(query, Pose(), beside);
    certificate.within(query, Pose(), beside, "1e-9");
    BOOST_TEST(certificate.without_proof() == 3);
    certificate.collide(query, Pose(), Pose::translation(1, 0.2, 1));
    BOOST_TEST(certificate.without_proof() == 3);
    BOOST_TEST(is_proved(certificate));
  }
  Certificate certificate(body);
  const tetracone::Ray through{{1, 0.2, -1}, {0, 0, 1}};
  BOOST_TEST(!body.first_hit(through));
  BOOST_TEST(!certificate.first_hit(through, std::nullopt));
  BOOST_TEST(certificate.without_proof() == 1);
  const std::array<std::string, 3> in_its_plane = {"1", "1/5", "0"};
  BOOST_TEST((body.inside_text(in_its_plane) == Location::outside));
  BOOST_TEST(!certificate.inside(in_its_plane, Location::outside));
  BOOST_TEST(certificate.without_proof() == 2);
}

BOOST_AUTO_TEST_CASE(a_miss_of_a_ray_from_far_away_is_proved)
{
  covering::Polyhedron needle;
  needle.vertices = {
      {-43721, 196064, 123089}, {15291, 72054, 37215}, {-50695, 220642, 138901}, {-967789, 473671, 1036222}};
  for (const auto& face : {std::vector<Index>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) needle.add_polygon(face);
  const Body body(needle);
  // The doubles of a search across this ray are nothing but errors along it.
  const tetracone::Ray ray{{-0x1p72, 0x1p71, 0x1p70}, {0x1p20, -0x1p19, -0x1p18}};
  Certificate certificate(body);
  BOOST_TEST(!body.first_hit(ray));
  BOOST_TEST(certificate.first_hit(ray, std::nullopt));
  BOOST_TEST(is_proved(certificate));
}

BOOST_AUTO_TEST_CASE(exits_and_depths_are_proved)
{
  const Body cube(scenes::unit_cube());
  Query query(cube, cube);
  Certificate certificate(query);
  for (const Pose& pose : {Pose(), Pose::translation(0.75, 0.5, 0), Pose::translation(3, 0, 0),
                           Pose::from_quaternion(3, 1, 2, 5, {0, 0, 0})}) {
    certificate.exits(query, pose, Pose(), {"1", "0", "1/3"});
    certificate.depth(query, pose, Pose());
  }
  BOOST_TEST(certificate.without_proof() == 0);
  BOOST_TEST(is_proved(certificate));
}

BOOST_AUTO_TEST_CASE(that_no_shorter_move_parts_the_solids_is_proved)
{
  const Body small(scenes::unit_cube()), large(scenes::box({-2, -2, -2}, {5, 5, 5}));
  const auto count = [](const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  for (const Body* other : {&large, &small}) {
    Query query(small, *other);
    Certificate certificate(query);
    const auto rotated = Pose::from_quaternion(3, 1, 2, 5, {0.75, 0.5, 0.125});
    for (const Pose& pose : {Pose::translation(0.75, 0.125, 0), rotated}) {
      BOOST_TEST(certificate.exits(query, pose, Pose(), {"1", "1/7", "1/3"}).first > 0);
      BOOST_TEST(certificate.depth(query, pose, Pose()).low > 0);
    }
    const std::string text = certificate.text();
    BOOST_TEST(count(text, "\"low\"") == 2u);
    BOOST_TEST(count(text, "\"overlap\"") == 2u);
    BOOST_TEST(is_proved(certificate));
  }
}

BOOST_AUTO_TEST_CASE(rigid_motions_are_proved)
{
  using Ends = std::array<std::array<double, 7>, 2>;
  const Body cube(scenes::unit_cube()), other(scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  const auto motion = [](const Ends& ends) { return Motion::rigid(ends[0], ends[1]); };
  const Motion still = motion({{{1, 0, 0, 0, 0, 0, 0}, {3, 0, 0, 0, 0, 0, 0}}}),
               line = Motion::linear(tetracone::Pose::translation(-5, 0, 0), tetracone::Pose());
  for (const Question question : {Question::solid, Question::surface}) {
    Query query(cube, other, question);
    Certificate certificate(query);
    std::size_t contacts = 0, count = 0;
    for (const Ends& ends :
         {Ends{{{1, 0, 0, 0, 4, 0.5, 0.25}, {1, 1, 0.5, 0, -4, 0.25, 0.125}}},  // turns and comes
          Ends{{{1, 0, 0, 0, 4, 0.5, 0.25}, {-1, 0, 0, 8, -4, 0.25, 0.125}}},   // by more than half a turn
          Ends{{{1, 0, 0, 0, 2, 0.25, 0.25}, {1, 1, 0, 0, 1, 0.25, 0.25}}},     // contact at the end
          Ends{{{1, 0, 0, 0, 2, 2, 0.25}, {0, 0, 0, 1, 2, 2, 0.25}}},           // half a turn beside the cube
          Ends{{{2, 1, 0, 1, 7, 3, 0.1}, {1, -1, 3, 0.5, -4, 9, 1e-30}}},       // passes
          Ends{{{1, 0, 0, 0, 0.25, 0.25, 0.25}, {1, 1, 0, 0, 3, 0, 0}}}}) {     // contact as it begins, or inside
      for (const Motion& first : {still, line}) {
        const Motion last = motion(ends);
        const auto found = query.first_contact(first, last);
        contacts += found.has_value();
        BOOST_TEST(certificate.first_contact(first, last, question, found));
        ++count;
      }
    }
    BOOST_TEST(contacts > 4);
    BOOST_TEST(contacts < count);
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
