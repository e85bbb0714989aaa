#ifndef TETRACONE_VERIFY_SUBJECTS_BLAME_H
#define TETRACONE_VERIFY_SUBJECTS_BLAME_H

#include "verify/cases/case.h"
#include "verify/subjects/subject.h"

#include <array>
#include <optional>

namespace tetracone::verify {

/// The stages at which a tree in rounded arithmetic can leave the right answer, in the order in which a query goes
/// through them.
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
inline constexpr std::array all_stages = {
    Stage::pose,         Stage::classification, Stage::bounding_sphere, Stage::bounding_tetrahedron,
    Stage::regular_hull, Stage::bounding_box,   Stage::leaf_sign,       Stage::containment};

inline const char* to_string(Stage stage)
{
  constexpr std::array names = {"pose",         "classification", "bounding sphere", "bounding tetrahedron",
                                "regular hull", "bounding box",   "leaf sign",       "containment"};
  return names[static_cast<std::size_t>(stage)];
}

/// The stage that made the subject's answer wrong: the query is run with its first stages the subject's own and the
/// rest exact, with no stage of its own, with one, with two, ...; the stage with which the answer first differs from
/// `truth` is to blame. What is exact is `Rounded_pair`, which shares no formulation with the subject: a wrong formula
/// is blamed where it stands, as rounding is.
///  - pose: the images of the vertices as the subject has them already give the wrong answer;
///  - classification: no leaf pair of the subject's tree holds what meets;
///  - bounding sphere, bounding tetrahedron, regular hull, and of the fast tree bounding box: the leaf pair that holds
///    it is discarded. The fast tree's boxes and separating directions bound the bodies where they exactly are, and a
/// box
///    is to blame where only rounding has brought together what is in it. A separating direction never is: it ends a
///    query only where the bodies are exactly apart, and then the answer is right;
///  - leaf sign: the subject's own leaf tests go wrong on it; containment: its own sums over the covering do.
/// The descent is followed to its end, where the subject itself may have given it up (`Config::all_pairs_after`).
/// Nothing for exact subjects, and where the subject's answer is right after all.
std::optional<Stage> blame(const Subject& subject, const Object_case& c, kernel::Question question, bool truth);

}  // namespace tetracone::verify

#endif
