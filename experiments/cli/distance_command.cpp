#include "experiments/cli/command_words.h"
#include "experiments/cli/commands.h"

#include "experiments/cli/answer_rows.h"
#include "experiments/cli/certificate_file.h"
#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/scene_options.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

struct Distance_options {
  Scene_names names;
  std::string csv, within, certificate, question = "solid", kernel = "adaptive";
  bool exact = false, points = false, time = false;
  int repeat = 1;
};

std::string exact_line(const Nearest& nearest, const std::array<Model_file, 2>& models)
{
  std::string line = nearest.squared;
  for (int body = 0; body < 2; ++body) {
    line += " ";
    for (int k = 0; k < 3; ++k) line += " " + nearest.point[body][k];
    line += " " + named_as_in_file(nearest.holder[body], models[body]).text();
  }
  return line + "\n";
}

/// The distance and the two points, each number as the double nearest to it.
std::string points_line(const Nearest& nearest, const std::string& blank, const std::string& wide_blank)
{
  std::string line = kernel::shortest(nearest.distance);
  for (const auto& point : nearest.point)
    for (std::size_t k = 0; k < 3; ++k)
      line += (k == 0 ? wide_blank : blank) + kernel::shortest(kernel::nearest_double(kernel::Rational(point[k])));
  return line + "\n";
}

/// A line a pose, or a row of the table.
class Asking {
 public:
  Asking(const Distance_options& options, Query& query, const std::array<Model_file, 2>& models,
         const Pose_pairs& poses)
      : options_(options), query_(query), models_(models), poses_(poses)
  {}

  std::string text()
  {
    std::string text;
    if (!options_.csv.empty()) {
      text = std::string("pose,") + (options_.within.empty() ? "distance" : "within");
      if (options_.points) text += ",x0,y0,z0,x1,y1,z1";
      text += options_.time ? ",ns,bounding_tests,primitive_tests,exact_fallbacks\n" : "\n";
    }
    std::vector<double> fastest(poses_.count(), std::numeric_limits<double>::infinity());
    const int passes = options_.time ? options_.repeat : 1;
    Progress progress("poses", poses_.count() * passes);
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t k = 0; k < poses_.count(); ++k) {
        query_.clear_statistics();
        const Stopwatch watch;
        const std::string answer = this->answer(k);
        fastest[k] = std::min(fastest[k], watch.nanoseconds());
        if (pass + 1 == passes) text += row(k, answer, fastest[k]);
        progress.step();
      }
    return text;
  }

 private:
  std::string answer(std::size_t k)
  {
    const kernel::Pose &a = poses_.of_a(k), &b = poses_.of_b(k);
    if (options_.exact) return exact_line(query_.nearest(a, b), models_);
    if (options_.points)
      return points_line(query_.nearest(a, b), options_.csv.empty() ? " " : ",", options_.csv.empty() ? "  " : ",");
    if (!options_.within.empty()) return query_.within(a, b, options_.within) ? "1\n" : "0\n";
    return kernel::shortest(query_.distance(a, b)) + "\n";
  }

  std::string row(std::size_t k, const std::string& answer, double ns) const
  {
    if (options_.csv.empty()) return answer;
    std::string row = std::to_string(k) + "," + answer.substr(0, answer.size() - 1);
    if (options_.time) row += work_columns(ns, query_.statistics());
    return row + "\n";
  }

  const Distance_options& options_;
  Query& query_;
  const std::array<Model_file, 2>& models_;
  const Pose_pairs& poses_;
};

std::string certificate(const Distance_options& options, Query& query, const std::array<Model_file, 2>& models,
                        const Pose_pairs& poses)
{
  Certificate certificate = certificate_of(models[0], models[1]);
  for (std::size_t k = 0; k < poses.count(); ++k) {
    const kernel::Pose &a = poses.of_a(k), &b = poses.of_b(k);
    if (options.within.empty())
      certificate.distance(query, a, b);
    else
      certificate.within(query, a, b, options.within);
  }
  return certificate.text();
}

void run_distance(const Distance_options& options)
{
  const auto question = kernel::parse_question(options.question);
  if (!question) throw CLI::ValidationError("--question " + options.question, "expected solid or surface");
  const auto how = parse_kernel(options.kernel);
  if (!how || (how->kernel != Kernel::adaptive && how->kernel != Kernel::double_ && how->kernel != Kernel::rational))
    throw CLI::ValidationError("--kernel " + options.kernel, "expected adaptive, double or rational");
  if (options.exact && how->kernel == Kernel::double_)
    throw CLI::ValidationError("--exact", "expected --kernel adaptive or rational");
  if (options.points && how->kernel == Kernel::double_)
    throw CLI::ValidationError("--points", "expected --kernel adaptive or rational");
  if (!options.certificate.empty() && how->kernel == Kernel::double_)
    throw CLI::ValidationError("--certificate", "expected --kernel adaptive or rational");
  if (options.points && (options.exact || !options.within.empty()))
    throw CLI::ValidationError("--points", "expected without --exact and --within");
  if (options.exact && !options.within.empty()) throw CLI::ValidationError("--exact", "expected without --within");
  if (options.exact && !options.csv.empty()) throw CLI::ValidationError("--exact", "expected without --csv");
  if (!options.within.empty() && !kernel::parse_number(options.within))
    throw CLI::ValidationError("--within " + options.within, "expected a decimal number or a fraction n/d");
  if (options.time && options.csv.empty()) throw CLI::ValidationError("--time", "expected --csv to hold the times");
  if (options.repeat < 1) throw CLI::ValidationError("--repeat", "expected a number from 1");
  for (const std::string& output : {options.csv, options.certificate})
    if (!output.empty()) options.names.refuse_as_output(output);
  require_other_file(options.certificate, options.csv);

  const Pose_pairs poses = read_pose_pairs(options.names);
  const bool solid = *question == Question::solid;
  const auto models = load_models(options.names.a, options.names.b, options.names.models, solid);
  Query query(models[0].body, models[1].body, *question, *how);
  const std::string text = Asking(options, query, models, poses).text();
  if (!options.certificate.empty()) write_whole(options.certificate, certificate(options, query, models, poses));
  write_answers(options.csv, text);
}

}  // namespace

void add_distance_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "distance", "How far apart two models are: the double nearest to the exact distance, a line a pose");
  const auto options = std::make_shared<Distance_options>();
  command->add_option("A", options->names.a, "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command->add_option("B", options->names.b, "Model")->required();
  add_default(*command, "--question", options->question,
              "solid: of the solids, 0 where they collide; surface: of the surfaces, which may be open");
  command->add_flag("--exact", options->exact,
                    "Print the squared distance, then of A and of B the nearest point and what holds it, as fractions");
  command->add_flag("--points", options->points,
                    "Print, after the distance, the nearest point of A and that of B, each coordinate as the double "
                    "nearest to it; of several such pairs one");
  command->add_option("--within", options->within,
                      "1 or 0: is the distance at most this, a decimal number (its double) or a fraction n/d");
  add_default(*command, "--kernel", options->kernel, "adaptive, double or rational");
  command->add_option("--csv", options->csv,
                      "Write a table to this file: pose,distance or, with --within, pose,within");
  command->add_flag("--time", options->time, "With --csv: nanoseconds and work of each pose");
  add_default(*command, "--repeat", options->repeat, "With --time: passes over all poses, of which the fastest counts");
  add_certificate_option(*command, options->certificate);
  options->names.add_options_to(*command);
  command->footer(
      "With --exact a line is `SQUARE  X Y Z HOLDER  X Y Z HOLDER`; a holder is `vertex V`, `edge V V`, `face F` or "
      "`interior`. Faces are those of the file: triangles that replace a face are that face.\n"
      "From 2^1024 - 2^970 on, half a step beyond the largest double, the nearest double is `inf`, as IEEE 754 "
      "rounds.\n"
      "Example: tetracone distance cat.off house.poly --pose-b poses.txt --within 1/10");
  command->callback([options] { run_distance(*options); });
}

}  // namespace tetracone::experiments
