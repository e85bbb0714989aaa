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

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

using Json = nlohmann::ordered_json;

/// The options of both commands.
struct Penetration_options {
  Scene_names names;
  std::string csv, certificate;
  bool exact = false, json = false, time = false;
  int repeat = 1;
};

struct Exit_options : Penetration_options {
  std::array<std::string, 3> along;
};

struct Depth_command_options : Penetration_options {
  Depth_options limits;
};

/// A part of an answer: its column, how a line writes it, and its value in JSON.
struct Cell {
  std::string column, text;
  Json value;
};

Cell cell(const std::string& column, double x) { return {column, kernel::shortest(x), json_number(x)}; }
Cell cell(const std::string& column, const std::string& fraction) { return {column, fraction, fraction}; }

std::vector<Cell> cells(const Exits& exits, bool is_exact)
{
  if (is_exact) return {cell("first", exits.exact_first), cell("last", exits.exact_last)};
  return {cell("first", exits.first), cell("last", exits.last)};
}

std::vector<Cell> cells(const Depth& depth, bool is_exact)
{
  std::vector<Cell> row;
  if (is_exact)
    row = {depth.is_exact ? cell("square", depth.exact_square) : Cell{"square", "-", Json()}};
  else
    row = {cell("low", depth.low), cell("high", depth.high)};
  const std::array<std::string, 3> axes = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k)
    row.push_back(is_exact ? cell(axes[k], depth.exact_vector[k]) : cell(axes[k], depth.vector[k]));
  return row;
}

/// The answer of one pose.
struct Row {
  std::vector<Cell> cells;
  double nanoseconds = std::numeric_limits<double>::infinity();
};

std::string text_of(const std::vector<Row>& rows, const Penetration_options& options)
{
  const auto ns = [](const Row& row) { return static_cast<long long>(row.nanoseconds); };
  if (options.json) {
    Json all = Json::array();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      Json object = {{"pose", k}};
      for (const Cell& cell : rows[k].cells) object[cell.column] = cell.value;
      if (options.time) object["ns"] = ns(rows[k]);
      all.push_back(std::move(object));
    }
    return all.dump(1) + "\n";
  }
  std::string text;
  if (!options.csv.empty() && !rows.empty()) {
    text = "pose";
    for (const Cell& cell : rows[0].cells) text += "," + cell.column;
    text += options.time ? ",ns\n" : "\n";
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!options.csv.empty()) text += std::to_string(k) + ",";
    const char blank = options.csv.empty() ? ' ' : ',';
    for (const Cell& cell : rows[k].cells)
      text += (&cell == &rows[k].cells[0] ? "" : std::string(1, blank)) + cell.text;
    if (options.time) text += "," + std::to_string(ns(rows[k]));
    text += "\n";
  }
  return text;
}

/// Asks question(query, pose of A, pose of B) for all poses, and writes the answers. prove(certificate, pose of A, pose
/// of B, answer) adds a proof.
template <class Question, class Prove>
void answer_all(const Penetration_options& options, const Question& question, const Prove& prove)
{
  if (options.json && !options.csv.empty()) throw CLI::ValidationError("--json", "expected without --csv");
  if (options.time && options.csv.empty() && !options.json)
    throw CLI::ValidationError("--time", "expected --csv or --json to hold the times");
  if (options.repeat < 1) throw CLI::ValidationError("--repeat", "expected a number from 1");
  for (const std::string& output : {options.csv, options.certificate})
    if (!output.empty()) options.names.refuse_as_output(output);
  require_other_file(options.certificate, options.csv);

  const Pose_pairs poses = read_pose_pairs(options.names);
  const auto models = load_models(options.names.a, options.names.b, options.names.models, true);
  Query query(models[0].body, models[1].body);
  std::vector<Row> rows(poses.count());
  std::optional<Certificate> certificate;
  if (!options.certificate.empty()) certificate = certificate_of(models[0], models[1]);
  const int passes = options.time ? options.repeat : 1;
  Progress progress("poses", rows.size() * passes);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Stopwatch watch;
      const auto answer = question(query, poses.of_a(k), poses.of_b(k));
      rows[k].nanoseconds = std::min(rows[k].nanoseconds, watch.nanoseconds());
      rows[k].cells = cells(answer, options.exact);
      if (certificate && pass == 0) prove(*certificate, poses.of_a(k), poses.of_b(k), answer);
      progress.step();
    }
  const std::string text = text_of(rows, options);
  write_answers(options.csv, text);
  if (certificate) write_certificate(options.certificate, *certificate);
}

void add_options(CLI::App& command, Penetration_options& options, const char* exact)
{
  command.add_option("A", options.names.a, "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command.add_option("B", options.names.b, "Model")->required();
  command.add_flag("--exact", options.exact, exact);
  add_certificate_option(command, options.certificate);
  command.add_option("--csv", options.csv, "Write a table to this file");
  command.add_flag("--json", options.json, "Write JSON to standard output");
  command.add_flag("--time", options.time, "With --csv or --json: nanoseconds of each pose");
  add_default(command, "--repeat", options.repeat, "With --time: passes over all poses, of which the fastest counts");
  options.names.add_options_to(command);
}

}  // namespace

void add_exit_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "exit", "How far A must be moved along a direction for two overlapping solids to part, exactly");
  const auto options = std::make_shared<Exit_options>();
  add_options(*command, *options, "Print fractions instead of the nearest doubles");
  command->add_option("--along", options->along, "The direction, three decimals or fractions n/d")->required();
  command->footer(
      "Prints a line for each pose: the first exit, where the interiors first share no point, and the last exit, from "
      "where on they never do again. Both are in lengths of the direction. The solids may touch on the way, so that "
      "sliding costs nothing. Both are 0 where the interiors share no point at the start.\n"
      "Example: tetracone exit peg.off block.off --along 0 0 1 --pose-a poses.txt --exact");
  command->callback([options] {
    answer_all(
        *options, [&](Query& query, const auto& a, const auto& b) { return query.exits(a, b, options->along); },
        [&](Certificate& certificate, const auto& a, const auto& b, const Exits& answer) {
          certificate.exits(a, b, options->along, answer);
        });
  });
}

void add_depth_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "depth", "The least translation of A for two overlapping solids to part, in a bracket that is never wrong");
  const auto options = std::make_shared<Depth_command_options>();
  add_options(*command, *options,
              "Print the square of the length and the vector as fractions; `-` for a length that is not proved to be "
              "the least");
  add_default(*command, "--relative", options->limits.relative, "The bracket's width over its upper end, at most");
  add_default(*command, "--budget", options->limits.budget, "Boxes of translations to look at, at most")
      ->check(CLI::NonNegativeNumber);
  command->footer(
      "Prints a line for each pose: a lower and an upper bound of the length of the least translation after which the "
      "interiors share no point, and the translation that attains the upper one. All is 0 where the interiors share no "
      "point at the start.\n"
      "Example: tetracone depth cat.off house.poly --pose-b poses.txt --relative 1e-3");
  command->callback([options] {
    answer_all(
        *options, [&](Query& query, const auto& a, const auto& b) { return query.depth(a, b, options->limits); },
        [&](Certificate& certificate, const auto& a, const auto& b, const Depth& answer) {
          certificate.depth(a, b, answer);
        });
  });
}

}  // namespace tetracone::experiments
