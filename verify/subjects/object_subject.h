#ifndef TETRACONE_VERIFY_SUBJECTS_OBJECT_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_OBJECT_SUBJECT_H

#include "verify/cases/case.h"
#include "verify/subjects/subject.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// What a subject made of a question.
enum class Outcome {
  no,
  yes,
  not_asked,  ///< the subject does not take such input (a peer whose transforms are rigid, a pose that is not)
  failed      ///< crash, hang, exception
};

/// An object subject that takes questions, in one thread. Keeps what it has prepared for the polyhedra of the last case.
class Running_subject {
 public:
  virtual ~Running_subject() = default;
  virtual Outcome operator()(const Object_case& c, kernel::Question question) = 0;
};

/// Something that answers whether two placed polyhedra collide: a kernel with a method, or another library.
struct Object_subject {
  std::string name;  ///< "double tree", "FCL OBBRSS"
  bool is_exact = false;
  std::string note;            ///< of a peer: the question it really answers
  std::optional<Subject> own;  ///< the kernel and method; nothing for a peer
  std::function<std::unique_ptr<Running_subject>()> make;
  std::string command{};  ///< of somebody else's program: what starts it
};

/// Our kernels with their methods.
std::vector<Object_subject> object_subjects();

/// A kernel and method of our own as a subject of a campaign.
Object_subject object_subject(const Subject& subject);

}  // namespace tetracone::verify

#endif
