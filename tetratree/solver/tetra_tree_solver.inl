#ifndef TETRACONE_TETRATREE_SOLVER_TETRA_TREE_SOLVER_INL
#define TETRACONE_TETRATREE_SOLVER_TETRA_TREE_SOLVER_INL
// Included by the one unit of each kernel.

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/tolerant.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/door/solver.h"
#include "tetracone/tetratree/paper/collision.h"
#include "tetracone/tetratree/solver/method_config.h"

#include <set>
#include <utility>
#include <vector>

namespace tetracone::detail {

template <class K>
class Tetra_tree_solver : public Solver {
 public:
  Tetra_tree_solver(const Shared_body& a, const Shared_body& b, const Query_options& options)
      : tolerance_(options.tolerance),
        body_a_(a),
        body_b_(b),
        a_(tree(*a, options)),
        b_(tree(*b, options)),
        collision_(*a_, *b_)
  {}

  Relation relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                    tetratree::Pair_memory*) override
  {
    use_tolerance(tolerance_);
    return collision_.relation(pose_a, pose_b, question);
  }
  std::vector<Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    use_tolerance(tolerance_);
    return collision_.features(pose_a, pose_b);
  }
  tetratree::Found_contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    if constexpr (kernel::Kernel_traits<K>::exact_motion)
      return leaves_contacts(pose_a, pose_b);
    else
      refuse_contacts();
  }
  Query_statistics statistics() const override { return collision_.counts(); }
  void clear_statistics() override { collision_.clear_counts(); }
  std::size_t bytes() const override { return a_->bytes() + b_->bytes(); }
  std::size_t node_count() const override { return a_->node_count() + b_->node_count(); }

 private:
  using Tree = tetratree::Tetra_tree<K>;

  /// Returns the contacts of the pairs of faces in leaves that the descent does not discard; each pair is tested once.
  tetratree::Found_contacts leaves_contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
  {
    std::set<std::pair<covering::Index, covering::Index>> candidates;
    collision_.any_leaf_pair(pose_a, pose_b, [&](const auto& leaf_a, const auto& leaf_b) {
      for (const covering::Index face_a : a_->faces(leaf_a))
        for (const covering::Index face_b : b_->faces(leaf_b)) candidates.insert({face_a, face_b});
      return false;
    });
    const tetratree::Contact_faces faces_a(body_a_->polyhedron, a_->model().covering()),
        faces_b(body_b_->polyhedron, b_->model().covering());
    tetratree::Face_pairs<K> pairs(faces_a, faces_b);
    std::vector<tetratree::Face_pair> asked;
    for (const auto& [face_a, face_b] : candidates) asked.push_back(pairs.pair(face_a, face_b));
    tetratree::Found_contacts found;
    pairs.add_contacts(collision_.a().body(), pose_a, collision_.b().body(), pose_b, asked, found);
    return found;
  }

  // The tolerance belongs to the thread; the tree is built with it, too.
  static void use_tolerance(const Tolerance& tolerance) { kernel::Tolerant::tolerance() = tolerance; }

  static std::shared_ptr<Tree> tree(const Body_data& body, const Query_options& options)
  {
    use_tolerance(options.tolerance);
    return body.tetra_tree<K>(tree_name(options), config_of(options.method));
  }

  Tolerance tolerance_;
  Shared_body body_a_, body_b_;
  std::shared_ptr<Tree> a_, b_;
  tetratree::Collision<K> collision_;
};

template <class K>
std::unique_ptr<Solver> tetra_tree_solver(const Shared_body& a, const Shared_body& b, const Query_options& options)
{
  return std::make_unique<Tetra_tree_solver<K>>(a, b, options);
}

}  // namespace tetracone::detail

#endif
