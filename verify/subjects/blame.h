#ifndef TETRACONE_VERIFY_SUBJECTS_BLAME_H
#define TETRACONE_VERIFY_SUBJECTS_BLAME_H

#include "verify/cases/case.h"
#include "verify/subjects/subject.h"

#include <array>
#include <optional>

namespace tetracone::verify {

/// The stages at which a tree in rounded arithmetic can depart from the right answer, in the order of a query.
enum class Stage {
  pose,
  classification,
  bounding_sphere,
  bounding_tetrahedron,
  regular_hull,
  bounding_box,
  leaf_sign,
  containment
};

inline const char* to_string(Stage stage)
{
  constexpr std::array names = {"pose",         "classification", "bounding sphere", "bounding tetrahedron",
                                "regular hull", "bounding box",   "leaf sign",       "containment"};
  return names[static_cast<std::size_t>(stage)];
}

/// Returns the stage that made the subject's answer wrong. The query is run with the subject's own first stages and
/// exact stages after them. It is run with none of its own, with one, with two, and so on. The stage with which the
/// answer first differs from `truth` is to blame. The exact stages are those of `Rounded_pair`, which shares no
/// formulation with the subject. A wrong formula is therefore blamed where it stands, as rounding is.
///  - pose: the subject's rounded images of the vertices already give the wrong answer, or are not finite;
///  - classification: no leaf pair of the subject's tree contains the features that meet;
///  - bounding sphere, bounding tetrahedron, regular hull, and for the fast tree bounding box: the leaf pair with these
///    features is discarded;
///  - leaf sign: the subject's own leaf tests are wrong about them;
///  - containment: the subject's own sums over the covering are wrong.
///
/// The fast tree's boxes and separating directions bound the bodies where they exactly are. A box is to blame only
/// where rounding alone has brought its contents together. A separating direction never is to blame: it ends a query
/// only where the bodies are exactly apart, and that answer is right. The descent is followed to its end, where the
/// subject itself may have given it up (`Config::all_pairs_after`). Returns nothing for exact subjects, and where the
/// subject's answer is right after all.
std::optional<Stage> blame(const Subject& subject, const Object_case& c, kernel::Question question, bool truth);

}  // namespace tetracone::verify

#endif
