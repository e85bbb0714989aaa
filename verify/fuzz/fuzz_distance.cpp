// Makes two small bodies and up to four pairs of poses from raw bytes. Their distances, nearest points and limits must
// be those of all pairs of elements in rational arithmetic.

#include "tetracone/tetratree/query/bvh8_distance.h"
#include "verify/fuzz/doubles.h"
#include "verify/fuzz/fuzz_body.h"
#include "verify/fuzz/fuzz_targets.h"
#include "verify/truth/distance_truth.h"

#include <cstdint>
#include <cstdlib>

using namespace tetracone;
using kernel::Question;
using kernel::Rational;

void tetracone::verify::fuzz_distance(const std::uint8_t* data, std::size_t size)
{
  // An image is three products and a sum: below the largest double.
  verify::Doubles doubles(data, size, 0x1p510);
  const covering::Polyhedron a = verify::fuzz_body(doubles), b = verify::fuzz_body(doubles);
  const verify::Brute_body brute_a(a), brute_b(b);
  const tetratree::Bvh8 tree_a(a), tree_b(b);
  tetratree::Bvh8_distance<> distance(tree_a, tree_a.model(), tree_b, tree_b.model()),
      other_way(tree_b, tree_b.model(), tree_a, tree_a.model());
  for (int k = 0; k < 4 && (k == 0 || !doubles.empty()); ++k) {
    const kernel::Pose pose_a = verify::fuzz_pose(doubles), pose_b = verify::fuzz_pose(doubles);
    if (pose_a.determinant_sign() == CGAL::ZERO || pose_b.determinant_sign() == CGAL::ZERO) continue;
    const verify::Placed_body placed_a(brute_a, pose_a), placed_b(brute_b, pose_b);
    const Rational of_surfaces = verify::squared_distance(placed_a, placed_b);
    for (const Question question : {Question::surface, Question::solid}) {
      const Rational square = verify::collide(placed_a, placed_b, question) ? Rational(0) : of_surfaces;
      const double root = kernel::nearest_root(square);
      same(distance(pose_a, pose_b, question) == root);
      same(other_way(pose_b, pose_a, question) == root);
      const tetratree::Nearest_pair nearest = distance.nearest(pose_a, pose_b, question);
      same(nearest.square == square);
      Rational between = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Rational d = nearest.point[0][i] - nearest.point[1][i];
        between += d * d;
      }
      same(between == square);
      for (const double limit : {root, doubles.next()})
        if (std::isfinite(limit) && limit >= 0)
          same(distance.within(pose_a, pose_b, question, Rational(limit)) ==
               (square <= Rational(limit) * Rational(limit)));
    }
  }
}
