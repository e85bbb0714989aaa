#ifndef TETRACONE_EXPERIMENTS_CLI_PAIR_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_PAIR_COMMAND_H

#include "experiments/cli/answer_rows.h"
#include "experiments/cli/certificate_file.h"
#include "experiments/cli/commands.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/scene_options.h"
#include "tetracone/kernel/number/number.h"

/// The common parts of commands that answer one line for each pose, motion, point or ray.
namespace tetracone::experiments {

/// Where answers go, and whether they are timed. A command adds the options that it has.
struct Answer_options {
  std::string csv, certificate;
  bool json = false, time = false;
  int repeat = 1;

  /// Returns the number of passes over all questions: one without times.
  int passes() const { return time ? repeat : 1; }
  /// Returns what stands between the numbers of a line.
  const char* blank() const { return csv.empty() ? " " : ","; }

  /// Throws CLI::ValidationError for --json with --csv, for --time without either, and for a bad number of passes. A
  /// command that has --json says `may_be_json`, for the message.
  void require(bool may_be_json) const
  {
    if (json && !csv.empty()) throw CLI::ValidationError("--json", "expected without --csv");
    if (time && csv.empty() && !json)
      throw CLI::ValidationError(
          "--time", may_be_json ? "expected --csv or --json to hold the times" : "expected --csv to hold the times");
    if (repeat < 1) throw CLI::ValidationError("--repeat", "expected a number from 1");
  }

  /// Calls refuse(file) for each file to be written, and throws CLI::ValidationError where two are one.
  template <class Refuse>
  void require_files(const Refuse& refuse) const
  {
    for (const std::string& file : {csv, certificate})
      if (!file.empty()) refuse(file);
    require_other_file(certificate, csv);
  }
};

/// The options of a command about two models under poses.
struct Pair_options : Answer_options {
  Scene_names names;

  /// Throws covering::Input_error when a file to be written is one that is read, and CLI::ValidationError when both
  /// files to be written are one.
  void require_files() const
  {
    Answer_options::require_files([this](const std::string& file) { names.refuse_as_output(file); });
  }
};

/// Adds the positional options A and B.
inline void add_models(CLI::App& command, std::string& a, std::string& b)
{
  command.add_option("A", a, "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command.add_option("B", b, "Model")->required();
}

/// Adds --csv, --json, --time and --repeat. `json` is the help of --json. --time adds one column of nanoseconds, and no
/// counts of work.
inline void add_table_options(CLI::App& command, Answer_options& options, const char* json)
{
  command.add_option("--csv", options.csv, "Write a table to this file");
  command.add_flag("--json", options.json, json);
  command.add_flag("--time", options.time, "With --csv or --json: nanoseconds of each pose");
  add_default(command, "--repeat", options.repeat, "With --time: passes over all poses, of which the fastest counts");
}

/// Returns the question. Throws CLI::ValidationError for another name.
inline Question required_question(const std::string& name)
{
  const auto question = kernel::parse_question(name);
  if (!question) throw CLI::ValidationError("--question " + name, "expected solid or surface");
  return *question;
}

/// Throws CLI::ValidationError when the distance of --within is no number. An empty text means that none was given.
inline void require_distance(const std::string& within)
{
  if (!within.empty() && !kernel::parse_number(within))
    throw CLI::ValidationError("--within " + within, "expected a decimal number or a fraction n/d");
}

/// Clocks ask(k) for each k below `count`, pass after pass. tell(k, answer, ns) takes each answer and its nanoseconds.
template <class Ask, class Tell>
void ask_all(const std::string& what, std::size_t count, int passes, const Ask& ask, const Tell& tell)
{
  Progress progress(what, count * std::size_t(passes));
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t k = 0; k < count; ++k) {
      const Stopwatch watch;
      auto answer = ask(k);
      const double ns = watch.nanoseconds();
      tell(k, std::move(answer), ns);
      progress.step();
    }
}

/// Two models, their poses, and what is asked of them.
struct Asked_pair {
  Pose_pairs poses;
  std::array<Model_file, 2> models;
  Query query;
};

/// Reads poses and models, which must be solids where the question is about solids. Throws covering::Input_error for a
/// bad file, and for numbers of poses of A and B that do not fit; else as the constructor of `Query`.
inline Asked_pair read_pair(const Scene_names& names, Question question, const Query_options& how = {})
{
  Pose_pairs poses = read_pose_pairs(names);
  auto models = load_models(names.a, names.b, names.models, question == Question::solid);
  Query query(models[0].body, models[1].body, question, how);
  return {std::move(poses), std::move(models), std::move(query)};
}

/// Returns whole nanoseconds as a column of a table, behind a comma. Requires a finite number.
inline std::string ns_column(double ns) { return "," + std::to_string(static_cast<long long>(ns)); }

}  // namespace tetracone::experiments

#endif
