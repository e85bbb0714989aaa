#ifndef TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_MIRROR_IMAGE_H
#define TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_MIRROR_IMAGE_H
// Recipe "A family of cases": both generators.

#include "verify/cases/object_placing.h"
#include "verify/cases/shape_library.h"
#include "verify/predicate_families/predicate_points.h"

namespace tetracone::verify {

namespace object_family {

/// A body and its own mirror image, in contact; `parameter` selects the mirror, from 0 to 23. At most one argument of a
/// call draws from `random`, since the compiler chooses the order in which arguments are evaluated.
inline Object_case mirror_image(Random& random, double parameter)
{
  const Shape& body = any_block(random);
  const Touching contact = any_contact(random, body, body, signed_permutation(24 + static_cast<int>(parameter)));
  return placed(random, contact, any_gap(random));
}

}  // namespace object_family

namespace predicate_family {

/// A contact in which B's points are written in a mirrored frame.
inline Predicate_case mirror_image(Random& random, double which)
{
  using namespace points;
  Frames f;
  f.b = signed_permutation(24 + static_cast<int>(which));
  return any_contact(random, f);
}

}  // namespace predicate_family

}  // namespace tetracone::verify

#endif
