#ifndef TETRACONE_VERIFY_SUBJECTS_OBJECT_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_OBJECT_SUBJECT_H

#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/tetratree/door/nearest.h"
#include "verify/cases/case.h"
#include "verify/subjects/spent.h"
#include "verify/subjects/subject.h"
#include "verify/truth/contact_pieces.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// What a subject made of a question.
enum class Outcome {
  no,
  yes,
  not_asked,  ///< the subject does not take such input (a pose that is not rigid, for a peer whose transforms are;
              ///< all pairs of 10^5 faces)
  failed      ///< crash, hang, exception
};

/// What a subject left that has failed.
struct Failure {
  std::string how;   ///< "status 3", "signal 11", "silent", "wrong line" or "exception"
  std::string said;  ///< the last line of its standard error, and what is wrong with its line
};

/// What a subject lists of the features of two placed bodies.
struct Listed {
  Outcome outcome = Outcome::not_asked;     ///< yes: it has listed
  std::vector<kernel::Feature_pair> pairs;  ///< sorted
};

/// What a subject lists of the contacts of two placed bodies.
struct Listed_contacts {
  Outcome outcome = Outcome::not_asked;  ///< yes: it has listed
  Contact_forms forms;                   ///< sorted
};

/// What a subject says of the distance of two placed bodies.
struct Told_distance {
  Outcome outcome = Outcome::not_asked;  ///< yes: it has told
  Nearest nearest;
  double alone = 0;  ///< the distance, asked for without the rest
};

/// Returns the value of an answer that is a list: its number of right elements or, where none is missing, its length.
/// Requires sorted lists.
template <class List>
int as_number(const List& listed, const List& truth)
{
  List right;
  std::set_intersection(listed.begin(), listed.end(), truth.begin(), truth.end(), std::back_inserter(right));
  return int(right.size() < truth.size() ? right.size() : listed.size());
}

/// An object subject that takes questions, in one thread. Keeps what it has prepared for the polyhedra of the last
/// case.
class Running_subject {
 public:
  virtual ~Running_subject() = default;
  virtual Outcome operator()(const Object_case& c, kernel::Question question) = 0;

  /// All pairs of an edge of one and a face of the other that share a point. Most subjects don't list them.
  virtual Listed features(const Object_case&) { return {}; }

  /// All maximal pieces of what pairs of faces share.
  virtual Listed_contacts contacts(const Object_case&) { return {}; }

  /// How far apart the bodies are.
  virtual Told_distance distance(const Object_case&, kernel::Question) { return {}; }

  /// Whether they are at most as far as a decimal or fraction says.
  virtual Outcome within(const Object_case&, kernel::Question, const std::string&) { return Outcome::not_asked; }

  /// The bodies of the next case are made ready anew, also where they are those of the last one.
  virtual void forget() {}

  /// The time of the last answer; nothing where the subject gave none, or does not know.
  virtual std::optional<Spent> spent() const { return std::nullopt; }
  /// What the last answer left that was `failed`.
  virtual Failure failure() const { return {"exception", ""}; }
};

/// The questions that a library knows. What it says to the other one is no error of its own.
enum class Knows { both, surfaces, solids };

/// Something that answers whether two placed polyhedra collide: a kernel with a method, or another library.
struct Object_subject {
  std::string name;  ///< "double tree", "FCL OBBRSS"
  bool is_exact = false;
  std::string note;            ///< of a peer: the question it really answers
  std::optional<Subject> own;  ///< the kernel and method; nothing for a peer
  std::function<std::unique_ptr<Running_subject>()> make;
  std::string command{};  ///< of somebody else's program: what starts it
  Knows knows = Knows::both;
};

/// Our kernels with their methods; and of the adaptive kernel the fast tree that remembers the last pose, asked others
/// before each one that counts, and the fast tree whose leaves are whole faces. Methods without a tree that is made on
/// demand are not asked about bodies of more than `most_faces` faces, and nobody about their features; the fast trees
/// of the adaptive kernel and of double alone about more than `most_faces_of_trees`, since kernels decide nothing but
/// leaves and shells.
std::vector<Object_subject> object_subjects();
inline constexpr std::size_t most_faces = 800, most_faces_of_trees = 10000;

/// Those of them that campaigns ask for features: each kernel as its users ask it, and what else differs there, the
/// paper's tree and all pairs, of the adaptive kernel and of double.
std::vector<Object_subject> feature_subjects();

/// Those of them that campaigns ask for contacts: the exact kernels' fast tree, and of the adaptive kernel the paper's
/// tree, all pairs, and the fast tree whose leaves are whole faces.
std::vector<Object_subject> contact_subjects();

/// Those of them that campaigns ask for distances: the fast tree of the adaptive kernel, also where it remembers and
/// where its leaves are whole faces, and of the rational one, of bodies of at most `most_faces_in_rationals` faces.
std::vector<Object_subject> distance_subjects();
inline constexpr std::size_t most_faces_in_rationals = 24;

/// A list of contacts in the form in which lists are compared.
Contact_forms contact_forms(const Contacts& contacts);

/// A kernel and method of our own as a subject of a campaign.
Object_subject object_subject(const Subject& subject);

}  // namespace tetracone::verify

#endif
