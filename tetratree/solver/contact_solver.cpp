#include "tetracone/tetratree/solver/contact_solver.inl"

#include "tetracone/tetratree/door/kernel_list.h"

namespace tetracone::detail {

void refuse_contacts() { throw Error("query: contacts by a kernel that rounds; expected an exact one"); }

#define TETRACONE_CONTACT_SOLVER(kernel_, name, type, exact)                                                         \
  template std::unique_ptr<Contact_solver> bvh8_contact_solver<kernel::type>(const Shared_body&, const Shared_body&, \
                                                                             const Query_options&);
TETRACONE_FOR_EACH_KERNEL(TETRACONE_CONTACT_SOLVER)
#undef TETRACONE_CONTACT_SOLVER

}  // namespace tetracone::detail
