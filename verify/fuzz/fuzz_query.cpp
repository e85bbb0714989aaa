// Makes two small bodies and up to eight pairs of poses from raw bytes. The fast tree and the paper's tree answer, with
// and without the memory of the last pose. Their answers must be those of all pairs of elements in rational arithmetic.
// No box of a scene may separate bodies that meet.

#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/memory/pair_certificate.h"
#include "tetracone/tetratree/paper/collision.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "tetracone/tetratree/scene/body_box.h"
#include "tetracone/tetratree/scene/turned_box.h"
#include "verify/fuzz/doubles.h"
#include "verify/fuzz/fuzz_body.h"
#include "verify/fuzz/fuzz_targets.h"
#include "verify/truth/cgal_truth.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>

using namespace tetracone;
using kernel::Pose;
using kernel::Question;

namespace {

/// A scene's data of a body that is placed for the first time, and its next position.
struct In_a_scene {
  tetratree::Body_extent extent;
  tetratree::Support_table table;
  tetratree::Body_place place = {};
  tetratree::Body_box box = {};
  Pose last = {};
  bool is_placed = false;

  In_a_scene(const covering::Polyhedron& body, const tetratree::Bvh8& tree) : extent(body.vertices), table(tree) {}

  void move(const Pose& pose)
  {
    const auto [at, turned] = tetratree::body_step(extent, is_placed ? last : pose, pose);
    const bool is_known = is_placed && turned <= std::numeric_limits<double>::max();
    place = {at, is_known ? tetratree::sum_above(place.turned, turned) : 0};
    if (!is_known) box = {world_box(extent, pose), place};
    last = pose;
    is_placed = true;
  }
};

void boxes_meet(In_a_scene& a, const tetratree::Bvh8& tree_a, In_a_scene& b, const tetratree::Bvh8& tree_b)
{
  using verify::same;
  same(world_box(a.extent, a.last).meets(world_box(b.extent, b.last)));
  same(world_box(a.table, tree_a.scale(), a.last).meets(world_box(b.table, tree_b.scale(), b.last)));
  same(!(a.box.gap(a.place, b.box, b.place) > 0));
  const std::array other = {tetratree::turned_box(b.extent, b.last)};
  same(!(turned_gaps(tetratree::turned_box(a.extent, a.last), other)[0] > 0));
}

}  // namespace

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
  In_a_scene scene_a(a, fast_a), scene_b(b, fast_b);
  for (int k = 0; k < 8 && (k == 0 || !doubles.empty()); ++k) {
    const Pose pose_a = verify::fuzz_pose(doubles), pose_b = verify::fuzz_pose(doubles);
    if (pose_a.determinant_sign() == CGAL::ZERO || pose_b.determinant_sign() == CGAL::ZERO) continue;
    scene_a.move(pose_a);
    scene_b.move(pose_b);
    for (const Question question : {Question::surface, Question::solid}) {
      const bool truth = verify::collide(truth_a, pose_a, truth_b, pose_b, question);
      same(fast(pose_a, pose_b, question) == truth);
      same(remembering(pose_a, pose_b, question) == truth);
      same(other_way(pose_b, pose_a, question) == truth);
      same(paper(pose_a, pose_b, question) == truth);
      if (truth) boxes_meet(scene_a, fast_a, scene_b, fast_b);
    }
  }
}
