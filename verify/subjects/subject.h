#ifndef TETRACONE_VERIFY_SUBJECTS_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_SUBJECT_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/kernel/predicate/tolerant.h"
#include "tetracone/tetratree/door/contacts.h"
#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/query_statistics.h"
#include "tetracone/tetratree/solver/method_config.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone {
class Body;
class Query;
}  // namespace tetracone

namespace tetracone::verify {

using Kernel_name = tetracone::Kernel;

/// The way in which a subject finds its answer. `brute` with the rational kernel is the truth of `cgal_truth.h`, which
/// shares no code with the others.
using tetracone::Method;

/// A way of answering, which is compared, timed and judged: a kernel and a method.
struct Subject {
  Kernel_name kernel = Kernel_name::adaptive;
  kernel::Tolerance tolerance;  ///< of double_eps
  Method method = Method::tree;
  bool remembers = false;    ///< Method::tree only: keeps from pose to pose what decided the last one
  bool whole_faces = false;  ///< Method::tree only: leaves are original faces, as of a body without `repair`

  /// Returns the subject for the kernel's name, as `parse_kernel` reads it; nothing for an unknown name.
  static std::optional<Subject> parse(std::string_view kernel, Method method = Method::tree);

  /// Returns a name like "adaptive tree", "double-eps=1e-12 brute", "adaptive tree remembering", "adaptive tree
  /// whole-faces".
  std::string name() const;
  std::string kernel_name() const;

  /// True when every answer is right by construction.
  bool is_exact() const { return tetracone::is_exact(kernel); }
};

using tetracone::all_kernels;
using tetracone::all_methods;
using tetracone::parse_method;
using tetracone::to_string;

/// Returns the tolerances with which a kernel is studied: an absolute and a relative one for `double_eps`, none for the
/// others.
std::vector<kernel::Tolerance> studied_tolerances(Kernel_name kernel);

/// Two polyhedra prepared for one subject: built once, asked for many poses. Requires planar faces.
class Prepared_pair {
 public:
  virtual ~Prepared_pair() = default;

  /// Returns the answer, the relation by which it is found, or the pairs of features in contact, sorted. The question
  /// of solids requires closed polyhedra.
  virtual bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) = 0;
  virtual kernel::Relation relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                                    kernel::Question question) = 0;
  virtual std::vector<kernel::Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;

  /// Lists the contacts by an exact kernel. Throws Error for other kernels, and for the truth, which has no such list.
  virtual Contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;

  /// Returns the library's own query, which also computes distances; null for the truth.
  virtual Query* query(kernel::Question) { return nullptr; }

  /// Returns the work since the last call; zero for a method that counts nothing.
  virtual tetratree::Query_statistics take_counts() = 0;

  /// Returns the bytes of both trees, and the number of their nodes, as far as the question of surfaces needs them; 0
  /// for the truth.
  virtual std::size_t bytes() const = 0;
  virtual std::size_t node_count() const = 0;
};

/// Returns two polyhedra prepared for a subject.
std::unique_ptr<Prepared_pair> prepare(const Subject& subject, const covering::Polyhedron& a,
                                       const covering::Polyhedron& b);
/// Returns two bodies prepared for a subject, from the trees that they already have; `whole_faces` is not looked at.
std::unique_ptr<Prepared_pair> prepare(const Subject& subject, const Body& a, const Body& b);

}  // namespace tetracone::verify

#endif
