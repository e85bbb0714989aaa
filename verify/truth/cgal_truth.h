#ifndef TETRACONE_VERIFY_TRUTH_CGAL_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_CGAL_TRUTH_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"
#include "verify/truth/brute_body.h"
#include "verify/truth/contact_pieces.h"
#include "verify/truth/placed_body.h"

#include <array>
#include <vector>

/// The truth: rational arithmetic on all pairs of elements whose outward-rounded boxes meet. It uses no tree and no
/// predicate of ours: triangulation, box pairs, intersection tests and orientations are CGAL's. CGAL's intervals decide
/// a pair where they are certain, rationals elsewhere.
namespace tetracone::verify {

using kernel::Feature_pair;
using kernel::Pose;
using kernel::Question;

namespace detail {

/// True when the elements x of a and y of b share a point.
bool elements_meet(const Placed_body& a, const Element& x, const Placed_body& b, const Element& y);

/// Returns the winding number of the surface of `solid` about the image of `point` of `other`, by signed crossings of a
/// ray. Requires that the image is not on the surface. The rays' directions (1, s, s^2) lie on a curve that meets every
/// plane through 0 in at most two of them. Therefore, after finitely many, a ray runs through no edge and in no plane
/// of a triangle.
int winding(const Placed_body& solid, const Placed_body& other, Index point);
/// Does the same for a point that is on no triangle of the surface.
int winding(const Placed_body& solid, const std::array<kernel::Rational, 3>& point);

/// True when the surfaces share a point.
bool surfaces_meet(const Placed_body& a, const Placed_body& b);

/// True when some connected part of the surface of `inner` is in the solid of `outer`. Requires surfaces that share no
/// point.
bool contains(const Placed_body& outer, const Placed_body& inner);

/// Throws std::invalid_argument when one of them is not closed.
void require_closed(const Placed_body& a, const Placed_body& b);

/// Returns the exact image of a face.
Planar_face placed_face(const Placed_body& placed, Index f);

}  // namespace detail

/// True when the two placed bodies share a point of their solids or surfaces. Touching counts. Throws
/// std::invalid_argument when the question is `solid` and a body is not closed.
bool collide(const Placed_body& a, const Placed_body& b, Question question = Question::solid);

/// The answers for the surfaces and for the solids of two placed bodies.
struct Both_answers {
  bool surface = false, solid = false;
};

/// Answers both questions at once. Throws std::invalid_argument when a body is not closed.
Both_answers collide_both(const Placed_body& a, const Placed_body& b);

/// Places the bodies and answers. Requires poses whose det M is not 0.
bool collide(const Brute_body& a, const Pose& pose_a, const Brute_body& b, const Pose& pose_b,
             Question question = Question::solid);

/// Returns 1 for a point inside the solid, 0 on the surface, -1 outside. Throws std::invalid_argument when the body is
/// not closed.
int inside(const Placed_body& solid, const std::array<kernel::Rational, 3>& point);
int inside(const Brute_body& body, const std::array<kernel::Rational, 3>& point);

/// Returns all pairs (edge of one body, face of the other) that share a point, in both directions, sorted and unique.
std::vector<Feature_pair> features(const Placed_body& a, const Placed_body& b);

/// Places the bodies, and returns these pairs. Requires poses whose det M is not 0.
std::vector<Feature_pair> features(const Brute_body& a, const Pose& pose_a, const Brute_body& b, const Pose& pose_b);

/// Returns all maximal pieces of the intersections of faces, sorted. CGAL triangulates the faces and intersects the
/// triangles in rationals; the parts of each pair of faces are then joined. Requires det M != 0 and planar faces.
Contact_forms contacts(const Object_case& c);

}  // namespace tetracone::verify

#endif
