#ifndef TETRACONE_TETRATREE_SOLVER_BVH8_SOLVER_INL
#define TETRACONE_TETRATREE_SOLVER_BVH8_SOLVER_INL
// Included by the one unit of each kernel.

#include "tetracone/kernel/predicate/tolerant.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/door/solver.h"
#include "tetracone/tetratree/query/bvh8_collision.h"

namespace tetracone::detail {

template <class K>
class Bvh8_solver : public Solver {
 public:
  Bvh8_solver(const Shared_body& a, const Shared_body& b, const Query_options& options)
      : a_(a),
        b_(b),
        options_(options),
        collision_(a->bvh8(), a->model<K>(), b->bvh8(), b->model<K>(),
                   options.remember ? tetratree::Coherence::last_frame : tetratree::Coherence::none)
  {}

  Relation relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                    tetratree::Pair_memory* memory) override
  {
    if constexpr (std::is_same_v<K, kernel::Tolerant>) kernel::Tolerant::tolerance() = options_.tolerance;
    return collision_.relation(pose_a, pose_b, question, memory);
  }
  std::vector<Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    return of_contacts().features(pose_a, pose_b);
  }
  tetratree::Found_contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    return of_contacts().contacts(pose_a, pose_b);
  }
  double certified_gap() const override { return collision_.certified_gap(); }
  Query_statistics statistics() const override
  {
    Query_statistics all = collision_.counts();
    if (of_contacts_) all += of_contacts_->statistics();
    return all;
  }
  void clear_statistics() override
  {
    collision_.clear_counts();
    if (of_contacts_) of_contacts_->clear_statistics();
  }
  std::size_t bytes() const override { return a_->bvh8().bytes() + b_->bvh8().bytes() + collision_.bytes(); }
  std::size_t node_count() const override { return a_->bvh8().node_count() + b_->bvh8().node_count(); }

 private:
  Contact_solver& of_contacts()
  {
    if (!of_contacts_) of_contacts_ = bvh8_contact_solver<K>(a_, b_, options_);
    return *of_contacts_;
  }

  Shared_body a_, b_;
  Query_options options_;
  tetratree::Bvh8_collision<K> collision_;
  std::unique_ptr<Contact_solver> of_contacts_;  // made when features or contacts are first asked for
};

template <class K>
std::unique_ptr<Solver> bvh8_solver(const Shared_body& a, const Shared_body& b, const Query_options& options)
{
  return std::make_unique<Bvh8_solver<K>>(a, b, options);
}

}  // namespace tetracone::detail

#endif
