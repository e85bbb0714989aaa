#ifndef TETRACONE_EXPERIMENTS_SPEED_CONTACT_QUESTIONS_H
#define TETRACONE_EXPERIMENTS_SPEED_CONTACT_QUESTIONS_H

#include "experiments/speed/contestant.h"
#include "experiments/speed/workloads.h"

/// What else than collisions is asked of bodies in exact contact, and near it.
namespace tetracone::experiments {

/// The answers of a method to the cases of a question.
class Answers {
 public:
  virtual ~Answers() = default;

  /// Answers case k, and returns the verdict: 0 right, 1 or -1 wrong (contact_verdicts.h). A case is judged at its
  /// first answer alone.
  virtual int verdict(std::size_t k) = 0;

  /// Returns the nanoseconds that the last answer took, its judgement excluded.
  virtual std::optional<double> own_ns() const = 0;

  /// Returns the work since the last call, and the nodes and bytes of the trees, as far as the method counts them.
  virtual tetratree::Query_statistics take_counts() = 0;
  virtual std::size_t node_count() const = 0;
  virtual std::size_t tree_bytes() const = 0;
};

/// A method, and how it is prepared for the bodies of its question.
struct Way {
  Contestant who;
  std::function<std::unique_ptr<Answers>()> prepare;
};

/// A question about the cases of a workload.
struct Contact_question {
  std::string name;
  std::shared_ptr<const Workload> workload;  ///< the bodies; for questions about pairs, a case is a pose
  std::vector<char> truth = {};              ///< whether the bodies of each case are in contact
  std::vector<Way> ways = {};
};

/// A question that is made on demand.
struct Named_question {
  std::string name;  ///< a file name
  std::function<Contact_question()> make;
};

/// Returns the questions, of `rotations` cases each, and a fourth as many motions:
/// - contacts and distances of the study's workloads in exact and near contact, nested bodies excepted;
/// - motions of their cubes through a contact of faces, edges or vertices, and contacts of their triangles;
/// - points and rays in degenerate positions to a body of flat faces;
/// - scenes of cubes that are stacked without gaps, of at least two frames.
///
/// Throws as `study_workloads`, when a workload is made.
std::vector<Named_question> contact_questions(const std::filesystem::path& models, int rotations, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
