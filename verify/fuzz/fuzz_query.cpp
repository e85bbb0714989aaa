// Two small bodies and up to eight pairs of poses from raw bytes: what the fast tree and the paper's tree answer, with
// and without the memory of the last pose, is what all pairs of elements give in rational arithmetic.

#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/fast/bvh8_collision.h"
#include "tetracone/tetratree/paper/collision.h"
#include "verify/fuzz/doubles.h"
#include "verify/fuzz/fuzz_body.h"
#include "verify/fuzz/fuzz_targets.h"
#include "verify/truth/cgal_truth.h"

#include <cstdint>
#include <cstdlib>

using namespace tetracone;
using kernel::Pose;
using kernel::Question;

void tetracone::verify::fuzz_query(const std::uint8_t* data, std::size_t size)
{
  // An image is three products and a sum: below the largest double.
  verify::Doubles doubles(data, size, 0x1p510);
  const covering::Polyhedron a = verify::fuzz_body(doubles), b = verify::fuzz_body(doubles);
  const verify::Brute_body truth_a(a), truth_b(b);
  tetratree::Bvh8 fast_a(a), fast_b(b);
  tetratree::Bvh8_collision fast(fast_a, fast_b), remembering(fast_a, fast_b, tetratree::Coherence::last_frame),
      other_way(fast_b, fast_a);
  using Tree = tetratree::Tetra_tree<kernel::Adaptive>;
  Tree paper_a(a), paper_b(b);
  tetratree::Collision<kernel::Adaptive> paper(paper_a, paper_b);
  for (int k = 0; k < 8 && (k == 0 || !doubles.empty()); ++k) {
    const Pose pose_a = verify::fuzz_pose(doubles), pose_b = verify::fuzz_pose(doubles);
    if (pose_a.determinant_sign() == CGAL::ZERO || pose_b.determinant_sign() == CGAL::ZERO) continue;
    for (const Question question : {Question::surface, Question::solid}) {
      const bool truth = verify::collide(truth_a, pose_a, truth_b, pose_b, question);
      same(fast(pose_a, pose_b, question) == truth);
      same(remembering(pose_a, pose_b, question) == truth);
      same(other_way(pose_b, pose_a, question) == truth);
      same(paper(pose_a, pose_b, question) == truth);
    }
  }
}
