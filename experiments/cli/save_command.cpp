#include "experiments/cli/commands.h"

#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "tetracone/tetratree/door/body_file.h"

namespace tetracone::experiments {
namespace {

struct Save_options {
  std::string model, out;
  Model_options models;
};

void run_save(const Save_options& options)
{
  if (!detail::is_body_file(options.out))
    throw CLI::ValidationError("--out " + options.out, "expected a name that ends in .body");
  refuse_input(options.out, {options.model});
  save_body(load_model(options.model, options.models, false).body, options.out);
}

}  // namespace

void add_save_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("save", "Saves a model with its tree: it is read again far faster, wherever a model is taken");
  const auto options = std::make_shared<Save_options>();
  command->add_option("MODEL", options->model, "A model: OFF, OBJ, PLY, STL or TetGen .poly")->required();
  command->add_option("--out", options->out, "The file to write, *.body")->required();
  options->models.add_to(*command);
  command->footer(
      "The same model is the same bytes. A file that was spoiled, or is of another version of the format, is refused.\n"
      "Example: tetracone save dragon.ply --out dragon.body && tetracone collide dragon.body cube.off");
  command->callback([options] { run_save(*options); });
}

}  // namespace tetracone::experiments
