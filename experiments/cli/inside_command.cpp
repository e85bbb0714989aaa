#include "experiments/cli/commands.h"

#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/covering/io/read_points.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>

namespace tetracone::experiments {
namespace {

struct Inside_options {
  std::string model, points, csv;
  Model_options models;
  bool time = false;
};

Location answer(const Body& body, const covering::Point_numbers& p)
{
  if (std::ranges::any_of(p, [](const covering::Number& x) { return x.fraction.has_value(); }))
    return body.inside_text(
        {kernel::exact_text(p[0].exact()), kernel::exact_text(p[1].exact()), kernel::exact_text(p[2].exact())});
  return body.inside({p[0].nearest, p[1].nearest, p[2].nearest});
}

void run_inside(const Inside_options& options)
{
  if (options.time && options.csv.empty()) throw CLI::ValidationError("--time", "expected --csv to hold the times");
  if (!options.csv.empty()) refuse_input(options.csv, {options.model, options.points});
  const auto points = covering::read_points(options.points);
  const Body body = load_model(options.model, options.models, true).body;
  body.inside_bytes();  // no point's time is that of the table

  std::string text, csv = options.time ? "point,answer,ns\n" : "point,answer\n";
  Progress progress("points", points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Stopwatch watch;
    const std::string at = std::to_string(int(answer(body, points[k])));
    const long long ns = static_cast<long long>(watch.nanoseconds());
    text += at + "\n";
    csv += std::to_string(k) + "," + at + (options.time ? "," + std::to_string(ns) : "") + "\n";
    progress.step();
  }
  if (options.csv.empty())
    std::cout << text;
  else
    write_whole(options.csv, csv);
}

}  // namespace

void add_inside_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("inside", "Where points are: 1 inside the solid, 0 on its surface, -1 outside");
  const auto options = std::make_shared<Inside_options>();
  command->add_option("MODEL", options->model, "A closed model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")
      ->required();
  command
      ->add_option("POINTS", options->points,
                   "Points: one a line, three numbers, decimals or fractions n/d; '#' comments")
      ->required();
  command->add_option("--csv", options->csv, "Write a table to this file");
  command->add_flag("--time", options->time, "With --csv: nanoseconds of each point");
  options->models.add_to(*command);
  command->footer("One line a point. Example: tetracone inside house.poly points.txt");
  command->callback([options] { run_inside(*options); });
}

}  // namespace tetracone::experiments
