#ifndef TETRACONE_TETRATREE_DOOR_CONTACTS_DATA_H
#define TETRACONE_TETRATREE_DOOR_CONTACTS_DATA_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/contact/face_pairs.h"
#include "tetracone/tetratree/door/solver.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace tetracone::detail {

/// The data that copies of `Contacts` share: pieces as they were found, and their bodies and poses.
struct Contacts_data {
  tetratree::Found_contacts found;
  Shared_body a, b;
  kernel::Pose pose_a, pose_b;
};

/// Returns what `Contacts::loops` returns for piece k, exactly.
std::vector<std::vector<std::array<kernel::Rational, 3>>> rational_loops(const Contacts_data& contacts, std::size_t k);

/// Returns a normal of a face, exactly, of any length; 0 for a face without a plane. Throws Error for a face's number
/// out of range.
kernel::Rational_point exact_normal(const covering::Polyhedron& polyhedron, covering::Index face);

/// Answers queries for features and contacts by the fast tree. `contacts` throws Error for a kernel that rounds.
class Contact_solver {
 public:
  virtual ~Contact_solver() = default;
  virtual std::vector<Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  virtual tetratree::Found_contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  virtual Query_statistics statistics() const = 0;
  virtual void clear_statistics() = 0;
};

/// Makes the solver over K. All kernels of `kernel_list.h` share one compiled unit.
template <class K>
std::unique_ptr<Contact_solver> bvh8_contact_solver(const Shared_body& a, const Shared_body& b,
                                                    const Query_options& options);

/// Throws Error, for contacts that were asked of a kernel that rounds.
[[noreturn]] void refuse_contacts();

}  // namespace tetracone::detail

#endif
