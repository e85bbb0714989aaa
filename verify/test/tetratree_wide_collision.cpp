#include "tetratree/wide_collision.h"

#include "covering/repair.h"
#include "verify/brute.h"
#include "verify/test/scenes.h"

#include <boost/test/unit_test.hpp>

#include <memory>
#include <vector>

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace verify = tetracone::verify;
using namespace tetracone::verify::scenes;
using tetracone::kernel::Question;

namespace {

struct Body {
  explicit Body(const Polyhedron& polyhedron)
      : whole(polyhedron), triangles(polyhedron, covering::triangulate_faces(polyhedron)), truth(polyhedron)
  {
  }
  Wide_tree whole, triangles;
  verify::Brute_body truth;
};

std::vector<std::unique_ptr<Body>> bodies()
{
  Random random(1);
  std::vector<std::unique_ptr<Body>> all;
  for (const Polyhedron& p : {unit_cube(), cube_with_cavity(), cube_with_tunnel(), star_prism(), cube(0.5), blob(random, 4, 1, 2), turned(cube_with_tunnel()),
                              random_tetrahedra(random, 6, 3), tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2})})
    all.push_back(std::make_unique<Body>(p));
  return all;
}

Pose any_pose(Random& random, int kind)
{
  const auto half = [&] { return double(integer(random, -8, 8)) / 2; };
  switch (kind) {
    case 0: return translation(half(), half(), half());
    case 1: return random_rotation(random, 3, {Rational(integer(random, -3, 3)), 0, Rational(1) / 3});
    case 2: return rounded(random_rotation(random, 5, {Rational(integer(random, -3, 3)), 1, 0}));
    case 3: return random_affine(random);
    default: return translation(1e-3 * half(), half() * 0.9, real(random, -3, 3));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(answers_are_those_of_all_pairs)
{
  const auto all = bodies();
  Random random(2);
  int yes = 0, no = 0, differ = 0;
  for (const auto& a : all)
    for (const auto& b : all) {
      Wide_collision whole(a->whole, b->whole), triangles(a->triangles, b->triangles);
      for (int k = 0; k < 25; ++k) {
        const Pose pose_a = k % 4 == 0 ? any_pose(random, k / 4 % 5) : Pose(), pose_b = any_pose(random, k % 5);
        if (pose_a.determinant_sign() == CGAL::ZERO || pose_b.determinant_sign() == CGAL::ZERO) continue;
        for (const Question question : {Question::surface, Question::solid}) {
          const bool truth = verify::collide(a->truth, pose_a, b->truth, pose_b, question);
          differ += whole(pose_a, pose_b, question) != truth;
          differ += triangles(pose_a, pose_b, question) != truth;
          (truth ? yes : no)++;
        }
      }
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(yes > 500);
  BOOST_TEST(no > 500);
}

BOOST_AUTO_TEST_CASE(exact_contact_and_a_hair_off_it_are_told_apart_under_any_rotation)
{
  // Two cubes under one rational rotation, the second moved along its own axes: face, edge or vertex in contact, or 2^-60 away.
  Body body(unit_cube());
  Wide_collision collision(body.triangles, body.triangles);
  Random random(3);
  int wrong = 0;
  for (int k = 0; k < 600; ++k) {
    const Pose rotation = random_rotation(random, 9);
    const Rational gap = k % 2 == 0 ? Rational(0) : Rational(0x1p-60);
    const std::array<Rational, 3> shift = {1 + gap, k % 3 == 0 ? Rational(0) : Rational(1), k % 3 == 2 ? Rational(1) : Rational(1) / 3};
    std::array<Rational, 12> moved;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) moved[4 * i + j] = rotation.exact(4 * i + j);
      for (int j = 0; j < 3; ++j) moved[4 * i + 3] += rotation.exact(4 * i + j) * shift[j];
    }
    for (const Question question : {Question::surface, Question::solid}) wrong += collision(rotation, Pose(moved), question) != (k % 2 == 0);
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(a_solid_inside_another_collides_and_one_in_its_cavity_does_not)
{
  Body box(cube(3)), hollow(cube_with_cavity()), small(cube(0.5)), dot([] {
    Polyhedron point;
    point.vertices = {{0, 0, 0}};
    point.add_polygon({0});
    return point;
  }());
  Random random(4);
  for (int k = 0; k < 100; ++k) {
    const Pose turned_and_moved = random_rotation(random, 5, {Rational(integer(random, -8, 8)) / 10, Rational(integer(random, -8, 8)) / 10, 0});
    for (Body* inner : {&small, &dot}) {
      Wide_collision in_box(box.triangles, inner->triangles), other_way(inner->whole, box.whole), in_hollow(hollow.triangles, inner->triangles);
      BOOST_TEST(in_box(Pose(), turned_and_moved, Question::solid));
      BOOST_TEST(!in_box(Pose(), turned_and_moved, Question::surface));
      BOOST_TEST(other_way(turned_and_moved, Pose(), Question::solid));
      BOOST_TEST(!in_hollow(Pose(), turned_and_moved, Question::solid));
    }
  }
}

BOOST_AUTO_TEST_CASE(work_is_counted)
{
  Body a(cube_with_tunnel()), b(star_prism());
  Wide_collision collision(a.triangles, b.triangles);
  collision(Pose(), translation(100, 0, 0));
  BOOST_TEST(collision.counts().queries == 1u);
  BOOST_TEST(collision.counts().leaf_pairs == 0u);
  collision(Pose(), translation(0.5, 0, 0));
  BOOST_TEST(collision.counts().box_tests > 8u);
  BOOST_TEST(collision.counts().leaf_pairs > 0u);
  collision.clear_counts();
  BOOST_TEST(collision.counts().queries == 0u);
}
