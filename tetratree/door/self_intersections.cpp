#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/query/bvh8_self_contacts.h"

#include <memory>
#include <mutex>

namespace tetracone {

bool detail::Body_data::is_simple() const
{
  kernel::require_sound_floating_point();
  std::call_once(simple_once_, [this] { simple_ = tetratree::Bvh8_self_contacts(bvh8(), polyhedron).is_simple(); });
  return simple_;
}

bool Body::is_simple() const { return data_->is_simple(); }

Contacts Body::self_intersections() const
{
  kernel::require_sound_floating_point();
  tetratree::Found_contacts found = tetratree::Bvh8_self_contacts(data_->bvh8(), data_->polyhedron).improper();
  return Contacts(std::make_shared<const detail::Contacts_data>(
      detail::Contacts_data{std::move(found), data_, data_, kernel::Pose(), kernel::Pose()}));
}

}  // namespace tetracone
