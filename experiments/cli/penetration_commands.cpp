#include "experiments/cli/solid_answers.h"

namespace tetracone::experiments {
namespace {

struct Exit_options : Solid_options {
  std::array<std::string, 3> along;
};

struct Depth_command_options : Solid_options {
  Depth_options limits;
};

std::vector<Cell> cells(const Exits& exits, bool is_exact)
{
  if (is_exact) return {cell("first", exits.exact_first), cell("last", exits.exact_last)};
  return {cell("first", exits.first), cell("last", exits.last)};
}

std::vector<Cell> cells(const Depth& depth, bool is_exact)
{
  std::vector<Cell> row;
  if (is_exact)
    row = {depth.is_exact ? cell("square", depth.exact_square) : Cell{"square", "-", nullptr}};
  else
    row = {cell("low", depth.low), cell("high", depth.high)};
  const std::array<std::string, 3> axes = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k)
    row.push_back(is_exact ? cell(axes[k], depth.exact_vector[k]) : cell(axes[k], depth.vector[k]));
  return row;
}

void add_options(CLI::App& command, Solid_options& options, const char* exact)
{
  add_models(command, options.names.a, options.names.b);
  command.add_flag("--exact", options.exact, exact);
  add_certificate_option(command, options.certificate);
  add_table_options(command, options, "Write JSON to standard output");
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
        [&](const Exits& answer) { return cells(answer, options->exact); },
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
  add_default(*command, "--relative", options->limits.relative,
              "The bracket's width over its upper end, at most; in [0, 1)");
  add_default(*command, "--budget", options->limits.budget, "Boxes of translations to look at, at most")
      ->check(whole_number());
  command->footer(
      "Prints a line for each pose: a lower and an upper bound of the length of the least translation after which the "
      "interiors share no point, and the translation that attains the upper one. All is 0 where the interiors share no "
      "point at the start.\n"
      "Example: tetracone depth cat.off house.poly --pose-b poses.txt --relative 1e-3");
  command->callback([options] {
    answer_all(
        *options, [&](Query& query, const auto& a, const auto& b) { return query.depth(a, b, options->limits); },
        [&](const Depth& answer) { return cells(answer, options->exact); },
        [&](Certificate& certificate, const auto& a, const auto& b, const Depth& answer) {
          certificate.depth(a, b, answer);
        });
  });
}

}  // namespace tetracone::experiments
