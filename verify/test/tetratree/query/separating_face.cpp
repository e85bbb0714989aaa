#include "tetracone/tetratree/query/separating_face.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "verify/cases/shape_generators.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <memory>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_separating_face)

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace kernel = tetracone::kernel;
namespace verify = tetracone::verify;
using namespace tetracone::verify::scenes;
using tetracone::kernel::Question;

namespace {

struct Body {
  explicit Body(const Polyhedron& p) : polyhedron(p), tree(p, covering::triangulate_faces(p)), truth(p) {}

  /// Returns the least (sign < 0) or largest x of a vertex.
  Rational extreme(int sign) const
  {
    double best = polyhedron.vertices[0][0];
    for (const Vertex& v : polyhedron.vertices)
      if (sign * v[0] > sign * best) best = v[0];
    return best;
  }

  Polyhedron polyhedron;
  Bvh8 tree;
  verify::Brute_body truth;
};

Pose any_frame(Random& random, int kind)
{
  const std::array<Rational, 3> offset = {Rational(integer(random, -99, 99)) / 97, 3, Rational(integer(random, -9, 9))};
  switch (kind) {
    case 0: return random_rotation(random, 5, offset);
    case 1: return rounded(random_rotation(random, 5, offset));
    case 2: return random_affine(random);  // of both signs
    default: return translation(0.125, 2, -3);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(bodies_an_ulp_apart_in_contact_and_overlapping_are_told_apart_in_any_frame)
{
  Random random(3);
  std::vector<std::unique_ptr<Body>> all;
  for (const Polyhedron& p :
       {unit_cube(), turned(unit_cube()), box({0, -2, 0}, {1, 3, 0.5}), cube_with_tunnel(), star_prism(),
        tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), polygon({{0, -1, -1}, {0, 2, -1}, {0, 0, 2}})})
    all.push_back(std::make_unique<Body>(p));
  int yes = 0, no = 0, differ = 0;
  for (const auto& a : all)
    for (const auto& b : all) {
      Bvh8_collision collision(a->tree, b->tree);
      const bool are_closed = a != all.back() && b != all.back();
      for (int k = 0; k < 24; ++k) {
        // B is beyond A, or ends with it from inside: then A's plane does not separate.
        const bool is_inside = k % 3 == 0;
        const Rational gap = Rational(integer(random, -1, 1)) * Rational(std::ldexp(1.0, -integer(random, 20, 60)));
        const Rational x = a->extreme(1) - b->extreme(is_inside ? 1 : -1) + (is_inside ? -abs(gap) : gap);
        const Pose shift(std::array<Rational, 12>{1, 0, 0, x, 0, 1, 0, Rational(integer(random, -2, 2)) / 3, 0, 0, 1,
                                                  Rational(integer(random, -2, 2)) / 7});
        const Pose frame = any_frame(random, k % 4), moved = composed(frame, shift);
        const Pose& pose_a = frame;
        const Pose pose_b = k % 4 == 1 ? rounded(moved) : moved;
        for (const Question question : {Question::surface, Question::solid}) {
          if (question == Question::solid && !are_closed) continue;
          const bool truth = verify::collide(a->truth, pose_a, b->truth, pose_b, question);
          differ += collision(pose_a, pose_b, question) != truth;
          (truth ? yes : no)++;
        }
      }
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(yes > 500);
  BOOST_TEST(no > 500);
}

BOOST_AUTO_TEST_CASE(one_plane_answers_for_all_triangles_of_faces_an_ulp_apart)
{
  Random random(4);
  const Polyhedron plate = triangulated(box({0, 0, 0}, {1, 1, 1}));
  Bvh8 a(plate), b(plate);
  Bvh8_collision collision(a, b);
  for (int k = 0; k < 20; ++k) {
    const Pose frame = any_frame(random, k % 2 == 0 ? 0 : 3);
    const Rational one_ulp = 1 + Rational(0x1p-52);
    const Pose beside = composed(frame, Pose(std::array<Rational, 12>{1, 0, 0, one_ulp, 0, 1, 0, 0, 0, 0, 1, 0}));
    collision.clear_counts();
    BOOST_TEST(!collision(frame, beside, Question::solid));
    BOOST_TEST(collision.counts().triangle_tests < 5u);
  }
  BOOST_TEST(collision.bytes() > Bvh8_collision(a, b).bytes());
}

BOOST_AUTO_TEST_CASE(corners_that_nearly_touch_are_told_apart_in_any_frame_of_few_vertices_and_of_many)
{
  Random random(5);
  int wrong = 0, apart = 0, by_few_pairs = 0;
  // A corner of B against the opposite one of A.
  for (const auto& [polyhedron, size] : {std::pair{triangulated(unit_cube()), std::array{1, 1, 1}},
                                         std::pair{verify::plate(6, 0, 1), std::array{2, 2, 1}}}) {
    const Body body(polyhedron);
    Bvh8_collision collision(body.tree, body.tree);
    const bool has_few = polyhedron.vertices.size() == 8;
    for (int k = 0; k < 300; ++k) {
      const Rational gap = Rational(integer(random, -1, 1)) * Rational(std::ldexp(1.0, -integer(random, 20, 60)));
      const Pose shift(
          std::array<Rational, 12>{1, 0, 0, size[0] + gap, 0, 1, 0, size[1] + gap, 0, 0, 1, size[2] + gap});
      const int kind = has_few ? k % 4 : k % 4 == 1 ? 0 : k % 4;  // rounded frames where the truth costs little
      const Pose frame = any_frame(random, kind), moved = composed(frame, shift);
      const Pose pose_b = kind == 1 ? rounded(moved) : moved;
      const bool truth =
          kind == 1 ? verify::collide(body.truth, frame, body.truth, pose_b, Question::surface) : gap <= 0;
      collision.clear_counts();
      wrong += collision(frame, pose_b, Question::surface) != truth;
      if (truth) continue;
      ++apart;
      by_few_pairs += collision.counts().triangle_tests < 5;
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(apart > 150);
  BOOST_TEST(2 * by_few_pairs > apart);
}

BOOST_AUTO_TEST_SUITE_END()
