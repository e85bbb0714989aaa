#include "experiments/cli/pair_command.h"
#include "experiments/support/motion_options.h"

namespace tetracone::experiments {
namespace {

struct Motion_options : Answer_options {
  Motion_names names;
  std::string question = "solid";
  bool features = false, first = false;
};

/// The contact with faces as the files have them.
std::optional<First_contact> named_as_in_file(std::optional<First_contact> first,
                                              const std::array<Model_file, 2>& models)
{
  if (first && first->holder)
    for (std::size_t body = 0; body < 2; ++body)
      (*first->holder)[body] = named_as_in_file((*first->holder)[body], models[body]);
  return first;
}

/// `segment` stands behind the times, where it is told.
std::string line_of(const std::optional<First_contact>& first, bool features, std::optional<std::size_t> segment = {})
{
  if (!first) return "0\n";
  std::string line = "1 " + kernel::shortest(first->lo) + " " + kernel::shortest(first->hi);
  if (segment) line += " " + std::to_string(*segment);
  if (features && first->holder)
    for (const Holder& holder : *first->holder) line += "  " + holder.text();
  return line + "\n";
}

std::string row_of(std::size_t k, const std::optional<First_contact>& first, bool features)
{
  std::string row = std::to_string(k) + (first ? ",1," : ",0,");
  row += first ? kernel::shortest(first->lo) + "," + kernel::shortest(first->hi) : ",";
  if (features)
    for (std::size_t body = 0; body < 2; ++body)
      row += "," + (first && first->holder ? (*first->holder)[body].text() : "");
  return row;
}

std::string answers(const Motion_options& options, Query& query, const std::array<Model_file, 2>& models,
                    const Motion_pairs& motions)
{
  std::string text;
  if (!options.csv.empty()) {
    text = "motion,answer,lo,hi";
    if (options.features) text += ",feature_a,feature_b";
    if (options.time) text += ",ns,bounding_tests,primitive_tests,exact_fallbacks";
    text += "\n";
  }
  Progress progress("motions", motions.a.size());
  for (std::size_t k = 0; k < motions.a.size(); ++k) {
    query.clear_statistics();
    const Stopwatch watch;
    const auto found = query.first_contact(motions.a[k], motions.b[k]);
    const double ns = watch.nanoseconds();
    const auto first = named_as_in_file(found, models);
    progress.step();
    if (options.first && !first) continue;
    if (options.csv.empty()) {
      text += line_of(first, options.features, options.first ? std::optional(k) : std::nullopt);
      if (options.first) return text;
      continue;
    }
    text += row_of(k, first, options.features);
    if (options.time) text += work_columns(ns, query.statistics());
    text += "\n";
    if (options.first) return text;
  }
  return options.first && options.csv.empty() ? line_of(std::nullopt, false) : text;
}

void run_motion(const Motion_options& options)
{
  const Question question = required_question(options.question);
  options.require(false);
  if (options.first && options.names.path.empty()) throw CLI::ValidationError("--first", "expected with --path");
  if (!options.certificate.empty() && options.first)
    throw CLI::ValidationError("--certificate", "expected without --first");
  options.require_files([&](const std::string& file) { options.names.refuse_as_output(file); });
  const Motion_pairs motions = read_motion_pairs(options.names);
  const auto models = load_models(options.names.a, options.names.b, options.names.models, question == Question::solid);
  Query query(models[0].body, models[1].body, question);
  write_answers(options.csv, answers(options, query, models, motions));
  if (options.certificate.empty()) return;
  Certificate certificate = certificate_of(models[0], models[1]);
  for (std::size_t k = 0; k < motions.a.size(); ++k)
    certificate.first_contact(motions.a[k], motions.b[k], question, query.first_contact(motions.a[k], motions.b[k]));
  write_certificate(options.certificate, certificate);
}

}  // namespace

void add_motion_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "motion",
      "When two moving models first meet, exactly: `0`, or `1` and the doubles about the time, a line a motion");
  const auto options = std::make_shared<Motion_options>();
  add_models(*command, options->names.a, options->names.b);
  options->names.add_options_to(*command);
  command->add_option("--path", options->names.path,
                      "Poses of B, one after the other: a motion from each to the next, a line each, of times t in [0, "
                      "1] within it. A rests at --pose-a0");
  command->add_flag(
      "--first", options->first,
      "With --path: only the first motion with a contact, `1 LO HI K`, from pose K to pose K + 1, or `0`");
  options->names.models.add_to(*command);
  add_default(*command, "--question", options->question,
              "solid: of the solids, which may collide at t = 0 one within the other; surface: of the surfaces");
  command->add_flag(
      "--features", options->features,
      "What meets first, of A and of B: `vertex V`, `edge V V` or `face F` of the file; nothing at t = 0");
  add_certificate_option(*command, options->certificate);
  command->add_option("--csv", options->csv, "Write a table to this file: motion,answer,lo,hi");
  command->add_flag("--time", options->time, "With --csv: nanoseconds and work of each motion");
  command->footer(
      "lo <= t <= hi are equal where t is a double, else neighbours. `1 0 0`: they collide as they start.\n"
      "Example: tetracone motion cat.off house.poly --pose-b0 start.txt --pose-b1 end.txt\n"
      "         tetracone motion house.poly gripper.stl --path path.txt --first");
  command->callback([options] { run_motion(*options); });
}

}  // namespace tetracone::experiments
