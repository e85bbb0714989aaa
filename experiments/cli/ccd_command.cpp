#include "experiments/cli/commands.h"

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_moving_pairs.h"
#include "tetracone/kernel/motion/first_contact.h"
#include "tetracone/kernel/number/number.h"

namespace tetracone::experiments {
namespace {

struct Ccd_options {
  std::vector<std::string> files;
  std::string kind;
  bool first = false;
};

kernel::Moving_kind kind_of(const Ccd_options& options, const std::string& file)
{
  if (!options.kind.empty())
    return options.kind == "vertex-face" ? kernel::Moving_kind::vertex_face : kernel::Moving_kind::edge_edge;
  if (const auto kind = covering::moving_kind_of(file)) return *kind;
  throw covering::Input_error(file, 0, "its folder is not named after a kind",
                              "expected vertex-face or edge-edge, or --kind");
}

/// The line of an answer.
std::string answer(const kernel::Moving_pair& pair, bool meets, bool first)
{
  std::string text = meets ? "1" : "0";
  if (meets && first) {
    const auto time = kernel::first_contact_time(pair).value();
    text += " " + kernel::shortest(time.lo) + " " + kernel::shortest(time.hi);
  }
  return text + "\n";
}

void run_ccd(const Ccd_options& options)
{
  std::vector<std::pair<std::string, std::vector<covering::Moving_query>>> files;
  for (const std::string& file : options.files)
    files.emplace_back(file, covering::read_moving_pairs(file, kind_of(options, file)));

  std::string text, differing;
  std::size_t wrong = 0, judged = 0;
  for (const auto& [file, queries] : files)
    for (const covering::Moving_query& query : queries) {
      const bool meets = kernel::meet_in_motion(query.pair);
      text += answer(query.pair, meets, options.first);
      judged += query.truth.has_value();
      if (!query.truth || *query.truth == meets) continue;
      if (wrong++ == 0) differing = file + ":" + std::to_string(query.line);
    }
  std::cout << text;
  if (wrong == 0) return;
  std::cerr << differing << ": the answer is not the file's, the first of " << wrong << " of " << judged << '\n';
  throw CLI::RuntimeError(1);
}

}  // namespace

void add_ccd_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("ccd", "Whether a moving vertex and face, or two moving edges, meet");
  const auto options = std::make_shared<Ccd_options>();
  command
      ->add_option("QUERIES", options->files,
                   "CSV: eight lines a query, four points at t = 0, then at t = 1; a line has numerator,denominator of "
                   "x, y, z and the right answer where it is known")
      ->required();
  command->add_option("--kind", options->kind, "vertex-face or edge-edge; default: the name of the file's folder")
      ->check(CLI::IsMember({"vertex-face", "edge-edge"}));
  command->add_flag("--first", options->first,
                    "Print, after a 1, the doubles about the first time of contact: equal, or neighbours");
  command->footer(
      "One line a query: 1 or 0. Status 1 where a file says otherwise.\n"
      "Example: tetracone ccd unit-tests/edge-edge/data_0_0.csv");
  command->callback([options] { run_ccd(*options); });
}

}  // namespace tetracone::experiments
