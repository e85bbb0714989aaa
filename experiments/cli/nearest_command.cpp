#include "experiments/cli/commands.h"

#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/covering/io/read_points.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string>

namespace tetracone::experiments {
namespace {

struct Nearest_options {
  std::string model, points, csv;
  Model_options models;
  bool exact = false, time = false;
};

/// The answer's words: the distance or its square, the point, what holds it, and whether it is the only one.
std::array<std::string, 6> answer(const Body& body, const Model_file& model, const covering::Point_numbers& p,
                                  bool exact)
{
  const auto words = [&](const std::string& distance, const auto& point, const Nearest_point& nearest) {
    return std::array<std::string, 6>{distance,
                                      point(0),
                                      point(1),
                                      point(2),
                                      named_as_in_file(nearest.holder, model).text(),
                                      nearest.is_only ? "only" : "tied"};
  };
  const auto in_doubles = [&](const Nearest_point& nearest) {
    return words(
        kernel::shortest(nearest.distance), [&](std::size_t k) { return kernel::shortest(nearest.point[k]); }, nearest);
  };
  const bool has_fractions = std::ranges::any_of(p, [](const auto& x) { return x.fraction.has_value(); });
  if (!exact && !has_fractions) return in_doubles(body.nearest({p[0].nearest, p[1].nearest, p[2].nearest}));
  const Exact_nearest_point nearest = body.nearest_text(
      {kernel::exact_text(p[0].exact()), kernel::exact_text(p[1].exact()), kernel::exact_text(p[2].exact())});
  if (!exact) return in_doubles(nearest);
  return words(
      nearest.squared, [&](std::size_t k) { return nearest.exact_point[k]; }, nearest);
}

void run_nearest(const Nearest_options& options)
{
  if (options.time && options.csv.empty()) throw CLI::ValidationError("--time", "expected --csv to hold the times");
  if (!options.csv.empty()) refuse_input(options.csv, {options.model, options.points});
  const auto points = covering::read_points(options.points);
  const Model_file model = load_model(options.model, options.models, true);
  model.body.inside_bytes();  // no point's time is that of the table or of the tree
  model.body.make_all();

  const bool is_table = !options.csv.empty();
  std::string text;
  if (is_table) text = std::string("point,") + (options.exact ? "square" : "distance") + ",x,y,z,holder,ties";
  if (is_table) text += options.time ? ",ns\n" : "\n";
  Progress progress("points", points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Stopwatch watch;
    const auto words = answer(model.body, model, points[k], options.exact);
    const auto ns = static_cast<long long>(watch.nanoseconds());
    if (is_table) text += std::to_string(k) + ",";
    for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : is_table ? "," : " ") + words[i];
    if (options.time) text += "," + std::to_string(ns);
    text += "\n";
    progress.step();
  }
  if (is_table)
    write_whole(options.csv, text);
  else
    std::cout << text;
}

}  // namespace

void add_nearest_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("nearest", "Signed distances of points, and the nearest points of a model's surface");
  const auto options = std::make_shared<Nearest_options>();
  command->add_option("MODEL", options->model, "A closed model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")
      ->required();
  command
      ->add_option("POINTS", options->points,
                   "Points: one a line, three numbers, decimals or fractions n/d; '#' comments")
      ->required();
  command->add_flag("--exact", options->exact, "The squared distance and the nearest point as fractions");
  command->add_option("--csv", options->csv, "Write a table to this file");
  command->add_flag("--time", options->time, "With --csv: nanoseconds of each point");
  options->models.add_to(*command);
  command->footer(
      "One line a point: `DISTANCE X Y Z HOLDER only|tied`. The distance is negative inside the solid; each number is "
      "the double nearest to the exact one. A holder is `vertex V`, `edge V V` or `face F`. Where other points are as "
      "near, `tied` says so.\n"
      "Example: tetracone nearest house.poly points.txt");
  command->callback([options] { run_nearest(*options); });
}

}  // namespace tetracone::experiments
