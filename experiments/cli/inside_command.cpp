#include "experiments/cli/inside_command.h"

#include "experiments/support/model_file.h"
#include "experiments/support/progress.h"
#include "tetracone/covering/io/read_points.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

struct Options {
  std::string model, points;
  Model_options models;
};

void run(const Options& options)
{
  const auto points = covering::read_points(options.points);
  const Model_file model = load_model(options.model, options.models, true);
  Point_query query(Body(model.polyhedron));

  std::string text;
  Progress progress("points", points.size());
  for (const covering::Point_numbers& p : points) {
    const bool fractions = std::ranges::any_of(p, [](const covering::Number& x) { return x.fraction.has_value(); });
    const auto exact = [&](int k) { return kernel::exact_text(p[k].exact()); };
    const Location at = fractions ? query.locate_text({exact(0), exact(1), exact(2)})
                                  : query.locate({p[0].nearest, p[1].nearest, p[2].nearest});
    text += std::to_string(static_cast<int>(at)) + "\n";
    progress.step();
  }
  std::cout << text;
}

}  // namespace

void add_inside_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("inside", "Where points are: 1 inside the solid, 0 on its surface, -1 outside");
  const auto options = std::make_shared<Options>();
  command->add_option("MODEL", options->model, "A closed model: OFF, OBJ, PLY, STL or TetGen .poly")->required();
  command
      ->add_option("POINTS", options->points,
                   "Points: one a line, three numbers, decimals or fractions n/d; '#' comments")
      ->required();
  options->models.add_to(*command);
  command->footer("One line a point. Example: tetracone inside house.poly points.txt");
  command->callback([options] { run(*options); });
}

}  // namespace tetracone::experiments
