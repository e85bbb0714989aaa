#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_PAIR_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_PAIR_H

#include "verify/cases/case.h"
#include "verify/integer_truth/integer_body.h"
#include "verify/integer_truth/integer_points.h"

#include <utility>

namespace tetracone::verify {

/// Both placed bodies of a case, in integers over one denominator, which is positive.
struct Integer_pair {
  Integer denominator;
  Integer_body a, b;
};

/// Returns the bodies of a case, which must outlive them.
inline Integer_pair integer_pair(const Object_case& c)
{
  Integer_points of_a = placed(c.a->vertices, c.pose_a), of_b = placed(c.b->vertices, c.pose_b);
  bring_together(of_a, of_b);
  return {of_a.denominator, {*c.a, std::move(of_a.points)}, {*c.b, std::move(of_b.points)}};
}

}  // namespace tetracone::verify

#endif
