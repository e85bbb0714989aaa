#ifndef TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_BOX_SUBJECT_H
#define TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_BOX_SUBJECT_H
// Recipe "A subject": its header is the last declaration, its source the rest.

#include "verify/subjects/object_subject.h"

#include <CGAL/Bbox_3.h>

#include <memory>
#include <optional>

namespace tetracone::verify {

inline CGAL::Bbox_3 box_of(const covering::Polyhedron& body, const kernel::Pose& m)
{
  CGAL::Bbox_3 all;
  for (const auto& [x, y, z] : body.vertices)
    all += CGAL::Bbox_3(m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7],
                        m[8] * x + m[9] * y + m[10] * z + m[11], m[0] * x + m[1] * y + m[2] * z + m[3],
                        m[4] * x + m[5] * y + m[6] * z + m[7], m[8] * x + m[9] * y + m[10] * z + m[11]);
  return all;
}

class Boxes : public Running_subject {
 public:
  Outcome operator()(const Object_case& c, kernel::Question) override
  {
    return CGAL::do_overlap(box_of(*c.a, c.pose_a), box_of(*c.b, c.pose_b)) ? Outcome::yes : Outcome::no;
  }
};

/// Answers by boxes of the vertices placed in double, as a broad phase does. Except for rounding, its "no" is right.
inline Object_subject box_subject()
{
  return {"boxes", false, "axis-parallel boxes of the vertices, in double: no surface is asked", std::nullopt,
          [] { return std::make_unique<Boxes>(); }};
}

}  // namespace tetracone::verify

#endif
