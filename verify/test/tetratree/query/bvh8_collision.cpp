#include "tetracone/tetratree/query/bvh8_collision.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/paper/collision.h"
#include "verify/test/support/keep_environment.h"
#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_collision)

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace verify = tetracone::verify;
using namespace tetracone::verify::scenes;
using tetracone::kernel::Question;

namespace {

using Kernels = std::tuple<tetracone::kernel::Float, tetracone::kernel::Double, tetracone::kernel::Tolerant,
                           tetracone::kernel::Epick, tetracone::kernel::Epeck, tetracone::kernel::Rational_kernel>;

/// All cuts, numbers of parts and sizes of leaves, by number.
Bvh8_options options_number(std::size_t n)
{
  const auto cuts = std::array{Cuts::tetra_cones, Cuts::through_origin, Cuts::principal, Cuts::least_cost}[n % 4];
  return {cuts, cuts == Cuts::tetra_cones ? 8 : 2 + n % 7, 1 + n % 5};
}

struct Body {
  explicit Body(const Polyhedron& p, std::size_t n = 0)
      : polyhedron(p),
        whole(p),
        triangles(p, covering::triangulate_faces(p)),
        chosen(p, covering::triangulate_faces(p), options_number(n)),
        truth(p)
  {}
  Polyhedron polyhedron;
  Bvh8 whole, triangles, chosen;
  verify::Brute_body truth;
};

std::vector<std::unique_ptr<Body>> bodies()
{
  Random random(1);
  std::vector<std::unique_ptr<Body>> all;
  for (const Polyhedron& p : {unit_cube(), cube_with_cavity(), cube_with_tunnel(), star_prism(), cube(0.5),
                              blob(random, 4, 1, 2), turned(cube_with_tunnel()), random_tetrahedra(random, 6, 3),
                              tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2})})
    all.push_back(std::make_unique<Body>(p, all.size()));
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
      Bvh8_collision whole(a->whole, b->whole), triangles(a->triangles, b->triangles),
          chosen(a->chosen, b->chosen, Coherence::last_frame);
      for (int k = 0; k < 25; ++k) {
        const Pose pose_a = k % 4 == 0 ? any_pose(random, k / 4 % 5) : Pose(), pose_b = any_pose(random, k % 5);
        if (pose_a.determinant_sign() == CGAL::ZERO || pose_b.determinant_sign() == CGAL::ZERO) continue;
        for (const Question question : {Question::surface, Question::solid}) {
          const bool truth = verify::collide(a->truth, pose_a, b->truth, pose_b, question);
          differ += whole(pose_a, pose_b, question) != truth;
          differ += triangles(pose_a, pose_b, question) != truth;
          differ += chosen(pose_a, pose_b, question) != truth;
          (truth ? yes : no)++;
        }
      }
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(yes > 500);
  BOOST_TEST(no > 500);
}

KERNEL_TEST_CASE(leaves_are_decided_by_any_kernel, K, Kernels)
{
  const auto all = bodies();
  constexpr bool is_exact = tetracone::kernel::Kernel_traits<K>::exact_motion;
  Random random(4);
  int yes = 0, no = 0, differ = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); j += 2) {
      const Body &a = *all[i], &b = *all[j];
      const covering::Model<K> model_a(a.polyhedron), model_b(b.polyhedron);
      Bvh8_collision<K> triangles(a.triangles, model_a, b.triangles, model_b, Coherence::last_frame),
          whole(a.whole, model_a, b.whole, model_b);
      for (int k = 0; k < 8; ++k) {
        // Where images and signs are rounded, nothing near a contact is asked.
        const Pose pose = any_pose(random, is_exact ? k % 5 : 3);
        if (pose.determinant_sign() == CGAL::ZERO) continue;
        for (const Question question : {Question::surface, Question::solid}) {
          const bool truth = verify::collide(a.truth, Pose(), b.truth, pose, question);
          differ += triangles(Pose(), pose, question) != truth;
          differ += whole(Pose(), pose, question) != truth;
          (truth ? yes : no)++;
        }
      }
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(yes > 50);
  BOOST_TEST(no > 50);
}

BOOST_AUTO_TEST_CASE(exact_contact_and_a_hair_off_it_are_told_apart_under_any_rotation)
{
  // Two cubes under one rational rotation, the second moved along its own axes: face, edge or vertex in contact, or
  // 2^-60 away.
  Body body(unit_cube());
  Bvh8_collision collision(body.triangles, body.triangles);
  Random random(3);
  int wrong = 0;
  for (int k = 0; k < 600; ++k) {
    const Pose rotation = random_rotation(random, 9);
    const Rational gap = k % 2 == 0 ? Rational(0) : Rational(0x1p-60);
    const std::array<Rational, 3> shift = {1 + gap, k % 3 == 0 ? Rational(0) : Rational(1),
                                           k % 3 == 2 ? Rational(1) : Rational(1) / 3};
    std::array<Rational, 12> moved;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) moved[4 * i + j] = rotation.exact(4 * i + j);
      for (int j = 0; j < 3; ++j) moved[4 * i + 3] += rotation.exact(4 * i + j) * shift[j];
    }
    for (const Question question : {Question::surface, Question::solid})
      wrong += collision(rotation, Pose(moved), question) != (k % 2 == 0);
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
    const Pose turned_and_moved =
        random_rotation(random, 5, {Rational(integer(random, -8, 8)) / 10, Rational(integer(random, -8, 8)) / 10, 0});
    for (Body* inner : {&small, &dot}) {
      Bvh8_collision in_box(box.triangles, inner->triangles), other_way(inner->whole, box.whole),
          in_hollow(hollow.triangles, inner->triangles);
      BOOST_TEST(in_box(Pose(), turned_and_moved, Question::solid));
      BOOST_TEST(!in_box(Pose(), turned_and_moved, Question::surface));
      BOOST_TEST(other_way(turned_and_moved, Pose(), Question::solid));
      BOOST_TEST(!in_hollow(Pose(), turned_and_moved, Question::solid));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_kept_from_the_last_pose_changes_no_answer)
{
  // Along trajectories of small steps through contact, and between far and near poses; against an object that keeps
  // nothing, and the truth.
  const auto all = bodies();
  Random random(5);
  int differ = 0, wrong = 0, yes = 0, no = 0;
  for (const auto& a : all)
    for (const auto& b : all) {
      Bvh8_collision none(a->triangles, b->triangles), last(a->triangles, b->triangles, Coherence::last_frame),
          whole(a->whole, b->whole, Coherence::last_frame), of_many(a->triangles, b->triangles);
      Pair_memory memory;
      const Pose rotation = random_rotation(random, 3);
      for (int k = -16; k <= 16; ++k) {
        const double x = k / 2.0;
        const Pose near = k % 2 == 0 ? composed(rotation, translation(x, 0.5, 0)) : translation(x, 1, 1),
                   pose_b = k % 4 < 2 ? rotation : Pose();
        const Pose pose_a = k % 5 == 0   ? composed(translation(1e6, 0, 0), near)
                            : k % 7 == 0 ? random_affine(random, 2)
                                         : near;
        const Question question = k % 3 == 0 ? Question::surface : Question::solid;
        const bool answer = none(pose_a, pose_b, question);
        differ += last(pose_a, pose_b, question) != answer;
        differ += whole(pose_a, pose_b, question) != answer;
        differ += (of_many.relation(pose_a, pose_b, question, &memory) != Relation::apart) != answer;
        if (k % 4 == 0) wrong += answer != verify::collide(a->truth, pose_a, b->truth, pose_b, question);
        ++(answer ? yes : no);
      }
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(wrong == 0);
  BOOST_TEST(yes > 500);
  BOOST_TEST(no > 500);
}

BOOST_AUTO_TEST_CASE(a_witness_or_a_direction_of_the_last_pose_saves_the_work)
{
  Body a(cube_with_tunnel()), b(cube(2));
  Bvh8_collision last(a.triangles, b.triangles, Coherence::last_frame);
  BOOST_TEST(last(Pose(), translation(2, 0, 0), Question::surface));
  last.clear_counts();
  BOOST_TEST(last(Pose(), translation(2.001, 0, 0), Question::surface));
  BOOST_TEST(last.counts().box_tests == 0u);
  BOOST_TEST(last.counts().leaf_pairs == 1u);
  BOOST_TEST(!last(Pose(), translation(100, 0, 0), Question::surface));
  BOOST_TEST(last(Pose(), translation(2, 0, 0), Question::surface));

  // A witness that the caller keeps.
  Bvh8_collision of_many(a.triangles, b.triangles);
  Pair_memory memory;
  const auto ask = [&](double x) { return of_many.relation(Pose(), translation(x, 0, 0), Question::surface, &memory); };
  BOOST_TEST((ask(2) == Relation::surfaces && memory.witness));
  of_many.clear_counts();
  BOOST_TEST((ask(2.001) == Relation::surfaces && memory.witness));
  BOOST_TEST(of_many.counts().box_tests == 0u);
  BOOST_TEST(of_many.counts().leaf_pairs == 1u);
  BOOST_TEST((ask(100) == Relation::apart && !memory.witness));
  BOOST_TEST(of_many.certified_gap() > 0);
}

BOOST_AUTO_TEST_CASE(bodies_of_unlike_sizes_end_and_are_right)
{
  // A tiny body that crosses a face of the large one, touches it in a vertex, is a hair off it, or is inside: sizes in
  // one unit underflow and overflow in float, and their ratio in double.
  int wrong = 0;
  for (const double large : {1.0, 0x1p100, 0x1p1000})
    for (const int ratio : {20, 59, 62, 130, 160, 500, 1010, 1050}) {
      const double tiny = std::ldexp(large, -ratio);
      if (tiny == 0) continue;
      const Polyhedron wall = box({0, -large, -large}, {large, large, large});
      struct {
        Vertex at;
        bool surface, solid;
      } cases[] = {{{0, 0, 0}, true, true},
                   {{-tiny, 0, 0}, true, true},
                   {{-1.5 * tiny, 0, 0}, false, false},
                   {{1.5 * tiny, 0, 0}, false, true},
                   {{large / 2, 0, 0}, false, true}};
      for (const auto& [at, surface, solid] : cases) {
        const Polyhedron dust = moved(cube(1), tiny, at);
        if (at[0] == large / 2 && dust.vertices[0] == dust.vertices[1]) continue;  // rounded to one point
        Body a(wall), b(dust);
        for (const Pose& pose : {Pose(), Pose::from_quaternion(1, 2, 3, 4)})
          for (const bool swapped : {false, true}) {
            Bvh8_collision collision(swapped ? b.triangles : a.triangles, swapped ? a.triangles : b.triangles,
                                     swapped ? Coherence::last_frame : Coherence::none);
            for (int again = 0; again < 2; ++again) {
              wrong += collision(pose, pose, Question::surface) != surface;
              wrong += collision(pose, pose, Question::solid) != solid;
            }
          }
      }
    }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(poses_that_are_nearly_flat_or_far_off_in_size_end_and_are_right)
{
  Body a(cube(1)), b(star_prism());
  int wrong = 0;
  for (const double thin : {0x1p-30, 0x1p-100, 0x1p-300, 0x1p-600, 0x1p-1000})
    for (const double height : {0.5, 1.0, std::nextafter(1.0, 2.0), 1.5})
      for (int axis = 0; axis < 3; ++axis) {
        std::array<double, 12> entries{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        entries[5 * axis] = thin;
        entries[4 * axis + 3] = height;
        for (const Body* other : {&a, &b}) {
          Body second(other == &a ? cube(1) : star_prism());
          const bool truth = verify::collide(a.truth, Pose(), second.truth, Pose(entries), Question::solid);
          Bvh8_collision collision(a.triangles, second.triangles),
              other_way(second.triangles, a.triangles, Coherence::last_frame);
          wrong += collision(Pose(), Pose(entries)) != truth;
          wrong += other_way(Pose(entries), Pose()) != truth;
        }
      }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(triangles_with_sides_of_any_size_are_found_in_a_face)
{
  // A triangle in a cube's face, beside the rest of its body, which is larger: as small as doubles get.
  Bvh8 cube(triangulated(box({-1, 1, -1}, {1, 2, 1})));
  int missed = 0, tried = 0;
  for (int exponent = -1074; exponent < 0; ++exponent)
    for (int k = 0; k < (exponent < -480 && exponent > -560 ? 32 : 2); ++k) {
      const double d = std::ldexp(1 + k / 32.0, exponent);
      Polyhedron small;
      small.vertices = {{d, 1, 0}, {-d, 1, 0}, {0, 1, d}, {1, -1, 0}, {-1, -1, 0}, {0, -1, 0.5}, {0, -1, -0.5}};
      for (const auto& [p, q, r] : {std::array<Index, 3>{0, 1, 2}, {3, 4, 5}, {3, 4, 6}}) small.add_polygon({p, q, r});
      Bvh8 tree(small);
      for (const Pose& pose : {Pose(), translation(0.25, 0, 0.25)}) {
        ++tried;
        missed += !Bvh8_collision(tree, cube)(pose, Pose(), Question::surface) +
                  !Bvh8_collision(cube, tree)(Pose(), pose, Question::surface);
      }
    }
  BOOST_TEST(missed == 0);
  BOOST_TEST(tried > 9000);
}

BOOST_AUTO_TEST_CASE(the_papers_tree_in_rational_arithmetic_says_the_same)
{
  using Rational_tree = Tetra_tree<tetracone::kernel::Rational_kernel>;
  Random random(6);
  const std::vector<Polyhedron> shapes = {unit_cube(), cube_with_tunnel(), star_prism(), triangulated(cube(2)),
                                          blob(random, 2, 1, 3)};
  int differ = 0, yes = 0, no = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      const Config config = Config::fastest();
      Rational_tree paper_a(shapes[i], config), paper_b(shapes[j], config);
      Collision<tetracone::kernel::Rational_kernel> paper(paper_a, paper_b);
      Bvh8 a(shapes[i]), b(shapes[j]);
      Bvh8_collision wide(a, b, Coherence::last_frame);
      for (int k = 0; k < 6; ++k) {
        const Pose pose_a = any_pose(random, k % 5), pose_b = any_pose(random, (k + 3) % 5);
        const bool expected = paper(pose_a, pose_b, Question::solid);
        differ += wide(pose_a, pose_b, Question::solid) != expected;
        ++(expected ? yes : no);
      }
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(yes > 20);
  BOOST_TEST(no > 20);
}

BOOST_AUTO_TEST_CASE(no_tree_is_made_and_no_query_answered_where_floating_point_is_not_sound)
{
  // A denormal apart: under denormals-are-zero these met.
  const Polyhedron left = box({-1, 0, 0}, {0, 1, 1}), right = box({0x1p-1074, 0, 0}, {1, 1, 1});
  using tetracone::kernel::Unsound_floating_point;
  Bvh8 a(left), b(right);
  Bvh8_collision collision(a, b), last(a, b, Coherence::last_frame);
  const auto refused = [](const auto& ask) { return verify::not_refused<Unsound_floating_point>(ask) == 0; };
  BOOST_TEST(refused([&] { Bvh8 tree(left); }));
  BOOST_TEST(refused([&] { a.make_all(); }));
  BOOST_TEST(refused([&] { Bvh8_collision fresh(a, b); }));
  for (const Pose& pose : {Pose(), translation(100, 0, 0)})
    for (Bvh8_collision<>* ask : {&collision, &last}) {
      BOOST_TEST(refused([&] { (*ask)(Pose(), pose); }));
      BOOST_TEST(!(*ask)(Pose(), pose));
    }
}

BOOST_AUTO_TEST_CASE(an_anisotropic_pose_whose_squares_overflow_is_no_similarity)
{
  // Columns (1, 0, 0), (0, h, h), (0, -h, h): entries of M^T M are infinity minus infinity.
  Body a(cube(1)), cross(box({0, -1, -1}, {2, 1, 1})), inside(box({-0.5, -1, -1}, {0.5, 1, 1}));
  int wrong = 0;
  for (const int exponent : {200, 511, 512, 600, 900, 1000}) {
    const double h = std::ldexp(1.0, exponent), small = std::ldexp(1.0, -exponent);
    const Pose pose_a(std::array<double, 12>{1, 0, 0, 0, 0, h, -h, 0, 0, h, h, 0}),
        pose_b(std::array<double, 12>{1, 0, 0, 0, 0, small, 0, 0, 0, 0, small, 0});
    for (Body* b : {&cross, &inside})
      for (const Question question : {Question::surface, Question::solid}) {
        const bool truth = verify::collide(a.truth, pose_a, b->truth, pose_b, question);
        for (const Coherence coherence : {Coherence::none, Coherence::last_frame}) {
          wrong += Bvh8_collision(a.triangles, b->triangles, coherence)(pose_a, pose_b, question) != truth;
          wrong += Bvh8_collision(b->whole, a.whole, coherence)(pose_b, pose_a, question) != truth;
        }
      }
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(work_is_counted)
{
  Body a(cube_with_tunnel()), b(star_prism());
  Bvh8_collision collision(a.triangles, b.triangles);
  collision(Pose(), translation(100, 0, 0));
  BOOST_TEST(collision.counts().queries == 1u);
  BOOST_TEST(collision.counts().leaf_pairs == 0u);
  collision(Pose(), translation(0.5, 0, 0));
  BOOST_TEST(collision.counts().box_tests > 8u);
  BOOST_TEST(collision.counts().leaf_pairs > 0u);
  collision.clear_counts();
  BOOST_TEST(collision.counts().queries == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
