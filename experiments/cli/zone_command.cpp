#include "experiments/cli/command_words.h"
#include "experiments/cli/commands.h"

#include "experiments/support/model_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/scene_options.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

struct Zone_options {
  Scene_names names;
  std::string within, question = "solid";
};

void run_zone(const Zone_options& options)
{
  const auto question = kernel::parse_question(options.question);
  if (!question) throw CLI::ValidationError("--question " + options.question, "expected solid or surface");
  if (!kernel::parse_number(options.within))
    throw CLI::ValidationError("--within " + options.within, "expected a decimal number or a fraction n/d");
  const Pose_pairs poses = read_pose_pairs(options.names);
  const auto models = load_models(options.names.a, options.names.b, options.names.models, *question == Question::solid);
  Query query(models[0].body, models[1].body, *question);
  std::string text;
  Progress progress("poses", poses.count());
  for (std::size_t k = 0; k < poses.count(); ++k) {
    std::vector<covering::Index> faces;
    for (const covering::Index f : query.zone(poses.of_a(k), poses.of_b(k), options.within))
      faces.push_back(models[0].source_face[f]);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const covering::Index f : faces) text += (f == faces.front() ? "" : " ") + std::to_string(f);
    text += faces.empty() ? "-\n" : "\n";
    progress.step();
  }
  std::cout << text;
}

}  // namespace

void add_zone_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("zone", "The faces of one model that come near another, a line a pose");
  const auto options = std::make_shared<Zone_options>();
  command->add_option("A", options->names.a, "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command->add_option("B", options->names.b, "Model")->required();
  command
      ->add_option("--within", options->within,
                   "The distance, a decimal number (its double) or a fraction n/d: decided on squares, exactly")
      ->required();
  add_default(*command, "--question", options->question,
              "solid: how far from B's solid; surface: from its surface, which may be open");
  options->names.add_options_to(*command);
  command->footer(
      "One line a pose: the numbers of the faces of A that have a point within that distance of B, or `-` for none.\n"
      "Example: tetracone zone cat.off house.poly --within 1/10 --pose-b poses.txt");
  command->callback([options] { run_zone(*options); });
}

}  // namespace tetracone::experiments
