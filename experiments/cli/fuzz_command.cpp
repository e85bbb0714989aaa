#include "experiments/cli/commands.h"

#include "experiments/cli/subject_options.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "tetracone/covering/edge_uses.h"
#include "verify/cases/case_file.h"
#include "verify/cases/random.h"
#include "verify/families/families.h"
#include "verify/integer_truth/integer_features.h"
#include "verify/shrink/mutate.h"
#include "verify/shrink/shrink.h"
#include "verify/shrink/wrong_answers.h"
#include "verify/subjects/predicate_subject.h"
#include "verify/truth/predicate_truth.h"

#include <cctype>
#include <map>
#include <set>

namespace tetracone::experiments {
namespace {

using kernel::Question;
using verify::Family;
using verify::Object_case;
using verify::Outcome;
using verify::Predicate_case;

struct Fuzz_options {
  double seconds = 60;
  std::uint64_t seed = 1;
  std::string subject;
  std::vector<std::string> families;
  Subject_options others;
  std::filesystem::path out = "out/fuzz";
};

/// Cases of predicates for each case of objects, which takes that much longer.
constexpr int predicates_a_round = 8;
/// A small find of today is worth more than the smallest one of tomorrow.
constexpr verify::Shrink_budget budget{4000, 1};

struct Tally {
  std::uint64_t asked = 0, false_positives = 0, false_negatives = 0, failures = 0, kinds = 0;

  std::uint64_t wrong() const { return false_positives + false_negatives + failures; }
  /// Counts an answer (nothing for a failure) and returns its kind of error; empty when it is right.
  std::string add(std::optional<int> answer, int truth)
  {
    ++asked;
    if (answer == truth) return "";
    if (!answer) {
      ++failures;
      return "failed";
    }
    const bool is_positive = *answer > truth;
    ++(is_positive ? false_positives : false_negatives);
    return is_positive ? "fp" : "fn";
  }
};

/// By default: the kernels that users choose from, with their trees.
bool is_default(const std::string& name)
{
  const std::string_view kernel = std::string_view(name).substr(0, name.find(' '));
  constexpr std::array<std::string_view, 4> kernels = {"double", "float", "epick", "adaptive"};
  return std::ranges::find(kernels, kernel) != kernels.end() && !name.ends_with(" brute");
}

/// Returns the names that `wanted` stands for: itself and its continuations after a space, else all that begin with it.
std::set<std::string> chosen(const std::vector<std::string>& names, const std::string& wanted)
{
  const auto those = [&](auto&& is_wanted) {
    std::set<std::string> some;
    std::copy_if(names.begin(), names.end(), std::inserter(some, some.end()), is_wanted);
    return some;
  };
  if (wanted.empty()) return those(is_default);
  auto some = those([&](const std::string& name) { return name == wanted || name.starts_with(wanted + " "); });
  if (some.empty()) some = those([&](const std::string& name) { return name.starts_with(wanted); });
  if (some.empty())
    throw CLI::ValidationError("--subject " + wanted,
                               "expected one of " + joined(names) + ", or how some of them begin");
  return some;
}

/// The families of these names, or all.
std::vector<const Family*> chosen_families(const std::vector<std::string>& names)
{
  std::vector<const Family*> families;
  for (const Family& family : verify::families())
    if (names.empty() || std::ranges::find(names, family.name) != names.end()) families.push_back(&family);
  const std::vector<std::string> all = family_names();
  for (const std::string& name : names) {
    if (verify::find_family(name)) continue;
    if (std::ranges::find(all, name) == all.end()) refuse_family(name);
    throw CLI::ValidationError("--family " + name, "fuzz asks no case of it; expected a family of pairs of bodies");
  }
  return families;
}

/// Letters, digits, dots; a '-' for anything else.
std::string file_safe(std::string name)
{
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.') c = '-';
  return name;
}

class Fuzz {
 public:
  explicit Fuzz(const Fuzz_options& options)
      : options_(options),
        families_(chosen_families(options.families)),
        progress_("seconds", std::size_t(options.seconds))
  {
    const auto commands = command_subjects(options.others, verify::object_subjects());
    std::vector<std::string> names;
    for (const auto& command : commands) names.push_back(command.name);
    for (const auto& subject : verify::object_subjects()) names.push_back(subject.name);
    for (const auto& subject : verify::predicate_subjects()) names.push_back(subject.name);
    const auto wanted = chosen(names, options.subject);
    std::set<std::string> listing;
    for (const auto& subject : verify::feature_subjects()) listing.insert(subject.name);
    for (auto& subject : verify::object_subjects())
      if (wanted.contains(subject.name))
        object_subjects_.push_back({subject, subject.make(), listing.contains(subject.name)});
    for (const auto& subject : commands) object_subjects_.push_back({subject, subject.make(), false});
    for (const auto& subject : verify::predicate_subjects())
      if (wanted.contains(subject.name)) predicate_subjects_.push_back(&subject);
    make_folder(options.out);
  }

  /// Round after round, one case of each family and level and what mutation makes of it, until the time is up.
  void run()
  {
    for (std::uint64_t round = 0;; ++round)
      for (const Family* each_family : families_) {
        const Family& family = *each_family;
        // Families before it in a round have not changed what this one draws.
        verify::Random random(verify::Random(options_.seed ^ (std::uint64_t(family.number) << 32)).bits() ^ round);
        if (!object_subjects_.empty()) {
          const Object_case c = family.object_case(options_.seed, round);
          for (const Object_case& each : {c, verify::mutated(c, random)})
            if (!try_objects(each) || !try_features(each)) return;
        }
        for (int k = 0; k < predicates_a_round && !predicate_subjects_.empty(); ++k) {
          const Predicate_case c = family.predicate_case(options_.seed, predicates_a_round * round + k);
          if (!try_predicates(c) || !try_predicates(verify::mutated(c, random))) return;
        }
      }
  }

  /// A line a subject and level.
  void print() const
  {
    std::printf("%-9s  %-40s %10s %10s %10s %9s %6s\n", "level", "subject", "answers", "false +", "false -", "failures",
                "kinds");
    for (const auto& [who, tally] : tallies_)
      std::printf("%-9s  %-40s %10llu %10llu %10llu %9llu %6llu%s\n", who.first.c_str(), who.second.c_str(),
                  (unsigned long long)tally.asked, (unsigned long long)tally.false_positives,
                  (unsigned long long)tally.false_negatives, (unsigned long long)tally.failures,
                  (unsigned long long)tally.kinds,
                  !exact_.contains(who.second) ? ""
                  : tally.wrong() > 0          ? "  exact, and WRONG"
                                               : "  exact");
  }

  bool exact_was_wrong() const
  {
    return std::any_of(tallies_.begin(), tallies_.end(), [&](const auto& entry) {
      return exact_.contains(entry.first.second) && entry.second.wrong() > 0;
    });
  }

 private:
  struct At_work {
    verify::Object_subject subject;
    std::unique_ptr<verify::Running_subject> answer;
    bool lists_features;
  };

  /// False when the time is up.
  bool go_on()
  {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const auto whole = std::size_t(std::min(seconds, options_.seconds));
    progress_.step(whole - std::exchange(shown_, whole));
    return seconds < options_.seconds;
  }

  bool try_objects(const Object_case& c)
  {
    const bool closed = covering::is_closed(*c.a) && covering::is_closed(*c.b);
    for (const Question question : {Question::surface, Question::solid}) {
      if (question == Question::solid && !closed) continue;
      const bool truth = verify::true_answer(c, question);
      for (At_work& each : object_subjects_) {
        if (!go_on()) return false;
        const Outcome answer = (*each.answer)(c, question);
        if (answer == Outcome::not_asked) continue;
        const auto value = answer == Outcome::failed ? std::nullopt : std::optional<int>(answer == Outcome::yes);
        if (!is_new_error(to_string(verify::Case_kind::object), each.subject, c.origin,
                          std::string(to_string(question)), value, truth))
          continue;
        const std::string left = answer == Outcome::failed ? in_words(each.answer->failure()) : "";
        const Object_case small =
            verify::shrink(c, question, verify::same_error(*each.answer, question, answer, truth), budget);
        verify::Case_file file = verify::case_file_of(small, question, each.subject, answer);
        file.cause += left;
        write(std::move(file), size(c), size(small));
      }
    }
    return true;
  }

  /// By the second truth: campaigns, which ask for fewer, compare both.
  bool try_features(const Object_case& c)
  {
    std::optional<std::vector<kernel::Feature_pair>> truth;
    for (At_work& each : object_subjects_) {
      if (!each.lists_features) continue;
      if (!go_on()) return false;
      const auto listed = each.answer->features(c);
      if (listed.outcome == Outcome::not_asked) continue;
      if (!truth) truth = verify::integer_truth::features(c);
      // A list with one wrong pair in place of a right one is lower.
      const bool is_list = listed.outcome == Outcome::yes;
      const auto value = is_list ? std::optional(verify::as_number(listed.answer, *truth)) : std::nullopt;
      const auto kind = is_new_error("features", each.subject, c.origin, "features", value, int(truth->size()));
      if (!kind) continue;
      const auto still = verify::same_error_of_features(*each.answer, *kind == "fn");
      const Object_case small = is_list ? verify::shrink(c, Question::surface, still, budget) : c;
      write(verify::case_file_of(small, each.subject, each.answer->features(small)), size(c), size(small));
    }
    return true;
  }

  static std::string in_words(const verify::Failure& failure)
  {
    return ", " + failure.how + (failure.said.empty() ? "" : ": " + failure.said);
  }

  static std::string size(const Object_case& c)
  {
    return std::to_string(verify::face_count(c)) + " faces, " + std::to_string(verify::size_of(c).bits) + " bits";
  }

  bool try_predicates(const Predicate_case& c)
  {
    for (const verify::Predicate predicate : verify::all_predicates) {
      const std::optional<int> truth = verify::true_answer(predicate, c);
      if (!truth) continue;
      for (const verify::Predicate_subject* subject : predicate_subjects_) {
        if (!go_on()) return false;
        const std::optional<int> answer = subject->answer(predicate, c);
        if (!answer) continue;
        const auto value = *answer == verify::no_answer ? std::nullopt : answer;
        if (!is_new_error(to_string(verify::Case_kind::predicate), *subject, c.origin, to_string(predicate), value,
                          *truth))
          continue;
        const Predicate_case small =
            verify::shrink(c, verify::same_error(*subject, predicate, c, *answer, *truth), budget);
        const auto size = [](const Predicate_case& x) { return std::to_string(verify::size_of(x).bits) + " bits"; };
        write(verify::case_file_of(small, predicate, *subject, *answer), size(c), size(small));
      }
    }
    return true;
  }

  /// Counts an answer, nothing for a failure. Returns its kind of error, where this question of this family has not had
  /// it before.
  template <class Subject>
  std::optional<std::string> is_new_error(const std::string& level, const Subject& subject,
                                          const verify::Origin& origin, const std::string& question,
                                          std::optional<int> answer, int truth)
  {
    if (subject.is_exact) exact_.insert(subject.name);
    Tally& mine = tallies_[{level, subject.name}];
    const std::string kind = mine.add(answer, truth);
    if (kind.empty()) return std::nullopt;
    name_ = file_safe(subject.name + "-" + origin.family + "-" + question + "-" + kind) + ".case.json";
    if (!names_.insert(name_).second) return std::nullopt;
    ++mine.kinds;
    return kind;
  }

  void write(verify::Case_file file, const std::string& before, const std::string& after)
  {
    file.version = TETRACONE_VERSION;
    const std::filesystem::path path = options_.out / name_;
    write_whole(path, verify::to_json(file));
    std::printf("%s: %s; %s -> %s\n", path.c_str(), file.cause.c_str(), before.c_str(), after.c_str());
    std::fflush(stdout);
  }

  Fuzz_options options_;
  std::vector<const Family*> families_;
  Progress progress_;
  std::size_t shown_ = 0;  // seconds
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<At_work> object_subjects_;
  std::vector<const verify::Predicate_subject*> predicate_subjects_;
  std::map<std::pair<std::string, std::string>, Tally> tallies_;  // by level and subject
  std::set<std::string> exact_, names_;
  std::string name_;  // the file of the last find
};

void run_fuzz(const Fuzz_options& options)
{
  if (!(options.seconds >= 0 && options.seconds <= 1e9))
    throw CLI::ValidationError("--seconds", "expected a number from 0 to 1e9");
  Fuzz fuzz(options);
  fuzz.run();
  fuzz.print();
  if (fuzz.exact_was_wrong()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_fuzz_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("fuzz", "New wrong answers on fresh and mutated cases, shrunk, each a case file");
  const auto options = std::make_shared<Fuzz_options>();
  add_default(*command, "--seconds", options->seconds, "Time to spend");
  add_default(*command, "--seed", options->seed, "Seed of all cases")->check(CLI::Range(0ul, 1ul << 62));
  command->add_option(
      "--subject", options->subject,
      "Only this subject, or those whose names begin so; default: the trees of double, float, epick and adaptive");
  command->add_option("--family", options->families, "Only this family of pairs of bodies; may be given again")
      ->allow_extra_args(false);
  add_subject_options(*command, options->others);
  add_default(*command, "--out", options->out, "Folder of the case files");
  command->footer(
      "Each new kind of wrong answer (subject, family, question or features, direction) is written once.\n"
      "Exit status 1: an exact subject was wrong.\n"
      "Example: tetracone fuzz --seconds 600 --subject \"double brute\" --out out/fuzz");
  command->callback([options] { run_fuzz(*options); });
}

}  // namespace tetracone::experiments
