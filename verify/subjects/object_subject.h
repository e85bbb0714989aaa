#ifndef TETRACONE_VERIFY_SUBJECTS_OBJECT_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_OBJECT_SUBJECT_H

#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/tetratree/door/nearest.h"
#include "tetracone/tetratree/door/overlap.h"
#include "verify/cases/case.h"
#include "verify/subjects/float_input.h"
#include "verify/subjects/running.h"
#include "verify/subjects/subject.h"
#include "verify/truth/contact_pieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// All pairs of an edge of one body and a face of the other that share a point, sorted.
using Feature_pairs = std::vector<kernel::Feature_pair>;

/// The distance of two placed bodies.
struct Distance_answer {
  Nearest nearest;
  double alone = 0;       ///< the distance, asked for without the rest
  bool is_alone = false;  ///< `alone` is all that it knows; NaN where it answers `within` alone
};

/// The relation of two placed solids, and their overlap.
struct Solid_answer {
  Solid_overlap overlap;
  kernel::Solid_relation alone{};  ///< the relation, asked for without the rest
  double volume = 0;               ///< that of the overlap, rounded
  std::array<double, 3> centroid{};
  Overlap_bounds bounds;
  std::array<kernel::Rational, 3> contact_vector{};  ///< of the area that the surfaces share
  std::array<double, 3> nearest_contact_vector{};    ///< the same, rounded
  std::array<double, 2> contact_area{};              ///< bounds of that area
};

/// The exits of a solid along a direction, and the nearest doubles.
struct Exit_answer {
  Solid_exits exits;
  double first = 0, last = 0;
};

/// A running object subject, for one thread. It keeps what it prepared for the polyhedra of the last case.
class Running_subject {
 public:
  virtual ~Running_subject() = default;
  virtual Outcome operator()(const Object_case& c, kernel::Question question) = 0;

  /// The answers of subjects that know more than whether bodies collide; most do not. Lists are sorted.
  virtual Told<Feature_pairs> features(const Object_case&) { return {}; }
  virtual Told<Contact_forms> contacts(const Object_case&) { return {}; }
  virtual Told<Distance_answer> distance(const Object_case&, kernel::Question) { return {}; }
  virtual Told<Solid_answer> solids(const Object_case&) { return {}; }
  virtual Told<Depth> depth(const Object_case&) { return {}; }
  virtual Told<Exit_answer> exits(const Object_case&, const std::array<kernel::Rational, 3>&) { return {}; }

  /// Answers whether the distance is at most the limit, a decimal or fraction.
  virtual Outcome within(const Object_case&, kernel::Question, const std::string&) { return Outcome::not_asked; }

  /// Makes the next case prepare its bodies anew, even if they are the last case's.
  virtual void forget() {}

  /// Returns the time of the last answer whether the bodies collide; nothing if the subject gave none, or does not know
  /// it.
  virtual std::optional<Spent> spent() const { return std::nullopt; }
  /// Returns the traces of the last answer, which was `failed`.
  virtual Failure failure() const { return {"exception", ""}; }
  /// Returns why the last answer was `not_asked`.
  virtual std::string why_not_asked() const { return "declined"; }
  /// Returns the number of lines that a program wrote with the last answer and that are not for us.
  virtual std::uint64_t skipped_lines() const { return 0; }
};

/// The questions that a library knows. Its answer to the other question is not counted as its error.
enum class Knows { both, surfaces, solids };

/// A method that answers whether two placed polyhedra collide: a kernel with a method, or another library.
struct Object_subject {
  std::string name;  ///< "double tree", "FCL OBBRSS"
  bool is_exact = false;
  std::string note;            ///< for a peer: the question that it really answers
  std::optional<Subject> own;  ///< our kernel and method; nothing for a peer
  std::function<std::unique_ptr<Running_subject>()> make;
  std::string command{};  ///< for an external program: its command line
  std::string hello{};    ///< what that program says of itself; may be empty
  std::string digest{};   ///< of that program's files
  Knows knows = Knows::both;
  In_floats in_floats = In_floats::nothing;  ///< for peers and programs
};

/// Returns our kernels with their methods as subjects. The adaptive kernel has two more. One is the fast tree that
/// remembers the last pose; it is asked other poses before each one that counts. The other is the fast tree whose
/// leaves are whole faces. Methods without a tree that is built on demand are not asked about bodies of more than
/// `most_faces` faces. No subject is asked about the features of such bodies. Above `most_faces_of_trees` only the fast
/// trees of the adaptive kernel and of double are asked, since kernels decide only leaves and shells.
std::vector<Object_subject> object_subjects();
inline constexpr std::size_t most_faces = 800, most_faces_of_trees = 10000;

/// Returns the subjects that campaigns ask for features. They are each kernel as its users ask it, and the paper's tree
/// and all pairs, in the adaptive kernel and in double. These two find features otherwise.
std::vector<Object_subject> feature_subjects();

/// Returns the subjects that campaigns ask for contacts. They are the fast tree of the exact kernels and, in the
/// adaptive kernel, three more. These are the paper's tree, all pairs, and the fast tree whose leaves are whole faces.
std::vector<Object_subject> contact_subjects();

/// Returns the subjects that campaigns ask for distances. They are the fast tree of the adaptive kernel, also
/// remembering and with whole faces as leaves, and that of the rational kernel. The rational one is asked about bodies
/// of at most `most_faces_in_rationals` faces.
std::vector<Object_subject> distance_subjects();
inline constexpr std::size_t most_faces_in_rationals = 24;

/// Returns the subjects that campaigns ask for the relations and exits of solids. They are the fast tree of the
/// adaptive kernel, also remembering and with whole faces as leaves.
std::vector<Object_subject> solid_subjects();

/// Returns a list of contacts in the form in which lists are compared.
Contact_forms contact_forms(const Contacts& contacts);

/// Returns a kernel and method of our own as a subject of a campaign.
Object_subject object_subject(const Subject& subject);

}  // namespace tetracone::verify

#endif
