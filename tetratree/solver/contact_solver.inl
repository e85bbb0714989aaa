#ifndef TETRACONE_TETRATREE_SOLVER_CONTACT_SOLVER_INL
#define TETRACONE_TETRATREE_SOLVER_CONTACT_SOLVER_INL
// Included by the unit that instantiates it for every kernel.

#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/query/bvh8_contacts.h"

#include <memory>
#include <type_traits>
#include <vector>

namespace tetracone::detail {

template <class K>
class Bvh8_contact_solver : public Contact_solver {
 public:
  Bvh8_contact_solver(const Shared_body& a, const Shared_body& b, const Query_options& options)
      : a_(a),
        b_(b),
        tolerance_(options.tolerance),
        finder_(a->bvh8(), a->model<K>(), a->polyhedron, b->bvh8(), b->model<K>(), b->polyhedron)
  {}

  std::vector<Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    if constexpr (std::is_same_v<K, kernel::Tolerant>) kernel::Tolerant::tolerance() = tolerance_;
    return finder_.features(pose_a, pose_b);
  }
  tetratree::Found_contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    if constexpr (kernel::Kernel_traits<K>::exact_motion)
      return finder_.contacts(pose_a, pose_b);
    else
      refuse_contacts();
  }
  Query_statistics statistics() const override { return finder_.counts(); }
  void clear_statistics() override { finder_.clear_counts(); }

 private:
  Shared_body a_, b_;
  Tolerance tolerance_;
  tetratree::Bvh8_contacts<K> finder_;
};

template <class K>
std::unique_ptr<Contact_solver> bvh8_contact_solver(const Shared_body& a, const Shared_body& b,
                                                    const Query_options& options)
{
  return std::make_unique<Bvh8_contact_solver<K>>(a, b, options);
}

}  // namespace tetracone::detail

#endif
