#ifndef TETRACONE_VERIFY_CAMPAIGN_LEVEL_JUDGE_H
#define TETRACONE_VERIFY_CAMPAIGN_LEVEL_JUDGE_H

#include "verify/campaign/batches.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/campaign/findings.h"
#include "verify/campaign/levels.h"
#include "verify/campaign/truths_disagree.h"
#include "verify/cases/random.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The judge of every level: who is asked what, and what of an answer is counted.
namespace tetracone::verify {

/// One in this many of a family's cases is tried with relations.
inline constexpr std::uint64_t relation_stride = 4;

/// Truths that take long judge bodies of at most this many faces.
inline constexpr std::size_t few_faces = 12;

/// True when neither body has more than `most` faces.
inline bool have_at_most(std::size_t most, const Object_case& c)
{
  return c.a->face_count() <= most && c.b->face_count() <= most;
}

/// A batch, and who is asked it.
template <class Level>
struct Job {
  const Batch& batch;
  std::uint64_t seed;
  const typename Level::Family* family;  ///< null for a sequence
  const std::vector<typename Level::Subject>& subjects;
  const std::vector<std::unique_ptr<typename Level::Running>>& running;  ///< the subjects of this thread
  const Done& done;
};

/// For each subject, the first case of a batch that it has not been asked before; the truth counts as a subject.
class Wanted {
 public:
  template <class Level>
  explicit Wanted(const Job<Level>& job) : last_(job.batch.last)
  {
    for (const auto& subject : job.subjects) names_.push_back(subject.name);
    names_.push_back(truth_name);
    for (const std::string& name : names_) next_.push_back(job.done.next(job.batch, name));
  }

  bool subject(std::size_t s, std::uint64_t k) const { return next_[s] <= k; }
  bool truth(std::uint64_t k) const { return next_.back() <= k; }
  bool anyone(std::uint64_t k) const
  {
    return std::ranges::any_of(next_, [k](std::uint64_t next) { return next <= k; });
  }

  /// Records the cases now asked of each subject. Call it when the batch is done.
  void add_done(Findings& found) const
  {
    for (std::size_t s = 0; s < names_.size(); ++s)
      if (next_[s] < last_) found.add_done(names_[s], last_ - next_[s]);
  }

 private:
  std::vector<std::string> names_;   // the truth's is the last
  std::vector<std::uint64_t> next_;  // the first case that each has not been asked
  std::uint64_t last_;
};

/// What a subject told of a question about a case.
template <class Level>
struct Answered {
  const typename Level::Case& c;
  typename Level::Question question;
  std::size_t number;  ///< of the subject
  const typename Level::Subject& subject;
  typename Level::Running& running;
  const Told<typename Level::Answer>& told;
};

/// A truth, as it is counted.
struct True_statement {
  std::string question;
  bool is_positive, by_construction = false;
};

/// True for a case with a pose of fractions.
template <class Case>
bool has_fractions(const Case& c)
{
  return c.pose_a.is_rational() || c.pose_b.is_rational();
}

/// The page of a level. learn(c) finds a case's truth, or throws Truths_disagree. truths() is what the truth says of a
/// question, or nothing where the question is not asked. statements() is what an answer says. relations() lists the
/// level's relations. Each page defines these four, and may hide any member of this class by its own.
template <class Level_>
class Page {
 public:
  using Level = Level_;
  using Case = typename Level::Case;
  using Question = typename Level::Question;
  using Running = typename Level::Running;
  using Told = verify::Told<typename Level::Answer>;
  using Answered = verify::Answered<Level>;
  using Statements = std::vector<Statement>;
  using Truths = std::vector<True_statement>;

  /// True: all relations are tried with a case, as for lists and scenes. False: one is, and another with the next case.
  static constexpr bool tries_all_relations = false;
  static constexpr bool counts_not_applicable = true;  ///< whether relations that do not apply are counted

  /// Returns true when the case is asked.
  bool takes(const Case&) const { return true; }

  /// The questions about a case, and their names in the table of relations.
  std::array<Question, 1> questions(const Case&) const { return {Question::surface}; }
  std::string name(Question) const { return std::string(Level::name); }

  Told ask(Running& subject, const Case& c, Question question) const
  {
    if constexpr (std::invocable<Running&, const Case&>)
      return subject(c);
    else
      return subject(c, question);
  }

  /// Returns true when relations are tried with case k after this answer.
  bool tries_relations(std::uint64_t, Question, const Told&) const { return true; }

  /// Called after the last case.
  void end(const Job<Level>&, Findings&) const {}
};

/// The common part of pages that ask for surfaces and for solids.
template <class Level>
class Two_questions : public Page<Level> {
 public:
  static constexpr std::array both = {kernel::Question::surface, kernel::Question::solid};
  std::array<kernel::Question, 2> questions(const typename Level::Case&) const { return both; }
  std::string name(kernel::Question question) const { return std::string(kernel::to_string(question)); }
};

/// Judges one batch by a level's page.
template <class Page>
class Level_judge {
 public:
  using Level = typename Page::Level;
  using Case = typename Page::Case;
  using Question = typename Page::Question;
  using Told = typename Page::Told;

  explicit Level_judge(const Job<Level>& job)
      : job_(job), wanted_(job), found_(std::string(Level::name), job.batch.family)
  {}

  Findings run()
  {
    for (std::uint64_t k = job_.batch.first; k < job_.batch.last; ++k)
      if (wanted_.anyone(k)) judge(case_at(k), k);
    page_.end(job_, found_);
    wanted_.add_done(found_);
    return std::move(found_);
  }

 private:
  Case case_at(std::uint64_t k) const
  {
    if constexpr (std::same_as<Case, Object_case>)
      if (job_.batch.sequence) return job_.batch.sequence->frames[k];
    return Level::make(*job_.family, job_.seed, k);
  }

  void judge(const Case& c, std::uint64_t k)
  {
    if (!page_.takes(c)) return;
    page_.learn(c);
    for (const Question question : page_.questions(c)) {
      const auto truths = page_.truths(question);
      if (wanted_.truth(k))
        for (const True_statement& truth : truths)
          found_.add_truth(truth.question, truth.is_positive, truth.by_construction);
      for (std::size_t s = 0; s < job_.subjects.size(); ++s) {
        if (!wanted_.subject(s, k)) continue;
        const Told told = truths.empty() ? Told() : judge_answer(c, k, question, s);
        if (job_.family && k % relation_stride == 0 && page_.tries_relations(k, question, told))
          try_relations(c, k, question, s, told);
      }
    }
  }

  Told judge_answer(const Case& c, std::uint64_t k, Question question, std::size_t s)
  {
    auto& running = *job_.running[s];
    const auto& subject = job_.subjects[s];
    const Told told = page_.ask(running, c, question);
    std::string listed;  // the question that has a wrong answer of this case in the list: its first
    for (const Statement& statement : page_.statements({c, question, s, subject, running, told})) {
      const bool is_asked = told.outcome != Outcome::not_asked;
      found_.add_answer(subject.name, statement, is_asked, told.spent);
      if (!is_asked || statement.value == statement.truth) continue;
      if (statement.stage) found_.add_blame(subject.name, statement.question, *statement.stage);
      if (k < kept_one_by_one && statement.question != std::exchange(listed, statement.question))
        found_.add_wrong(c.origin, subject.name, statement);
    }
    if constexpr (requires { running.failure(); }) {
      if (told.outcome == Outcome::failed) found_.add_failure(subject.name, page_.name(question), k, running.failure());
      if constexpr (requires { running.why_not_asked(); })
        if (told.outcome == Outcome::not_asked && !subject.own && k < kept_one_by_one)
          found_.add_declined(c.origin, subject.name, page_.name(question), running.why_not_asked());
      found_.add_skipped(subject.name, running.skipped_lines());
    }
    return told;
  }

  void try_relations(const Case& c, std::uint64_t k, Question question, std::size_t s, const Told& told)
  {
    const auto relations = page_.relations();
    // Each family begins with another relation.
    const std::size_t turn = (k / relation_stride + std::size_t(job_.family->number)) % relations.size();
    for (std::size_t number = 0; number < relations.size(); ++number) {
      if (!Page::tries_all_relations && number != turn) continue;
      Random random(c.origin.seed * 1'000'003 + c.origin.index * 101 + number);
      const Verdict verdict = relations[number].check({c, question, *job_.running[s], told.answer, random});
      const bool is_applicable = verdict != Verdict::not_applicable;
      if (is_applicable || Page::counts_not_applicable)
        found_.add_relation(std::string(relations[number].name), job_.subjects[s].name, page_.name(question),
                            is_applicable, verdict == Verdict::violated);
    }
  }

  const Job<Level>& job_;
  Page page_;
  Wanted wanted_;
  Findings found_;
};

}  // namespace tetracone::verify

#endif
