#include "experiments/cli/pair_command.h"

namespace tetracone::experiments {
namespace {

struct Zone_options {
  Scene_names names;
  std::string within, question = "solid";
};

void run_zone(const Zone_options& options)
{
  const Question question = required_question(options.question);
  require_distance(options.within);
  Asked_pair asked = read_pair(options.names, question);
  std::string text;
  Progress progress("poses", asked.poses.count());
  for (std::size_t k = 0; k < asked.poses.count(); ++k) {
    std::vector<covering::Index> faces;
    for (const covering::Index f : asked.query.zone(asked.poses.of_a(k), asked.poses.of_b(k), options.within))
      faces.push_back(asked.models[0].source_face[f]);
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
  add_models(*command, options->names.a, options->names.b);
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
