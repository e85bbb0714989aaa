#include "experiments/cli/command_words.h"
#include "experiments/cli/commands.h"

#include "experiments/cli/answer_rows.h"
#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/scene_options.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

using Json = nlohmann::ordered_json;

struct Exit_options {
  Scene_names names;
  std::array<std::string, 3> along;
  std::string csv;
  bool exact = false, json = false, time = false;
  int repeat = 1;
};

/// The answer of one pose.
struct Exit_row {
  Exits exits;
  double nanoseconds = std::numeric_limits<double>::infinity();
};

std::vector<Exit_row> ask(Query& query, const Pose_pairs& poses, const Exit_options& options)
{
  std::vector<Exit_row> rows(poses.count());
  const int passes = options.time ? options.repeat : 1;
  Progress progress("poses", rows.size() * passes);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Stopwatch watch;
      rows[k].exits = query.exits(poses.of_a(k), poses.of_b(k), options.along);
      rows[k].nanoseconds = std::min(rows[k].nanoseconds, watch.nanoseconds());
      progress.step();
    }
  return rows;
}

std::string fields(const Exits& exits, bool is_exact, char blank)
{
  if (is_exact) return exits.exact_first + blank + exits.exact_last;
  return kernel::shortest(exits.first) + blank + kernel::shortest(exits.last);
}

Json object(std::size_t pose, const Exit_row& row, const Exit_options& options)
{
  Json object = {{"pose", pose}};
  if (options.exact) {
    object["first"] = row.exits.exact_first;
    object["last"] = row.exits.exact_last;
  } else {
    object["first"] = json_number(row.exits.first);
    object["last"] = json_number(row.exits.last);
  }
  if (options.time) object["ns"] = static_cast<long long>(row.nanoseconds);
  return object;
}

std::string text_of(const std::vector<Exit_row>& rows, const Exit_options& options)
{
  if (options.json) {
    Json all = Json::array();
    for (std::size_t k = 0; k < rows.size(); ++k) all.push_back(object(k, rows[k], options));
    return all.dump(1) + "\n";
  }
  std::string text;
  if (!options.csv.empty()) text = std::string("pose,first,last") + (options.time ? ",ns\n" : "\n");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (options.csv.empty()) {
      text += fields(rows[k].exits, options.exact, ' ') + "\n";
      continue;
    }
    text += std::to_string(k) + "," + fields(rows[k].exits, options.exact, ',');
    if (options.time) text += "," + std::to_string(static_cast<long long>(rows[k].nanoseconds));
    text += "\n";
  }
  return text;
}

void run_exit(const Exit_options& options)
{
  if (options.json && !options.csv.empty()) throw CLI::ValidationError("--json", "expected without --csv");
  if (options.time && options.csv.empty() && !options.json)
    throw CLI::ValidationError("--time", "expected --csv or --json to hold the times");
  if (options.repeat < 1) throw CLI::ValidationError("--repeat", "expected a number from 1");
  if (!options.csv.empty()) options.names.refuse_as_output(options.csv);

  const Pose_pairs poses = read_pose_pairs(options.names);
  const auto models = load_models(options.names.a, options.names.b, options.names.models, true);
  Query query(models[0].body, models[1].body);
  const std::string text = text_of(ask(query, poses, options), options);
  if (options.csv.empty())
    std::cout << text;
  else
    write_whole(options.csv, text);
}

}  // namespace

void add_exit_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "exit", "How far A must be moved along a direction for two overlapping solids to part, exactly");
  const auto options = std::make_shared<Exit_options>();
  command->add_option("A", options->names.a, "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command->add_option("B", options->names.b, "Model")->required();
  command->add_option("--along", options->along, "The direction, three decimals or fractions n/d")->required();
  command->add_flag("--exact", options->exact, "Fractions instead of the nearest doubles");
  command->add_option("--csv", options->csv, "Write a table to this file: pose,first,last");
  command->add_flag("--json", options->json, "Write JSON to standard output");
  command->add_flag("--time", options->time, "With --csv or --json: nanoseconds of each pose");
  add_default(*command, "--repeat", options->repeat, "With --time: passes over all poses, of which the fastest counts");
  options->names.add_options_to(*command);
  command->footer(
      "Prints a line for each pose: the first exit, where the interiors first share no point, and the last exit, from "
      "where on they never do again. Both are in lengths of the direction. The solids may touch on the way, so that "
      "sliding costs nothing. Both are 0 where the interiors share no point at the start.\n"
      "Example: tetracone exit peg.off block.off --along 0 0 1 --pose-a poses.txt --exact");
  command->callback([options] { run_exit(*options); });
}

}  // namespace tetracone::experiments
