#include "experiments/cli/solid_answers.h"

namespace tetracone::experiments {
namespace {

struct Relation_options : Solid_options {
  std::string kernel = "adaptive";
  bool volume = false;

  /// True when the volume is asked for; its fraction is a way to write it.
  bool measures() const { return volume || exact; }
};

struct Relation_answer {
  Solid_contact contact;
  Overlap overlap;
};

/// Three numbers in JSON.
nlohmann::ordered_json numbers(const std::array<double, 3>& x)
{
  return {json_number(x[0]), json_number(x[1]), json_number(x[2])};
}

/// Returns relation and dimension, and if it is asked for the volume. Tables have its centroid too, lines only with
/// fractions; JSON also has what the bodies' surfaces share.
std::vector<Cell> cells(const Relation_answer& answer, const Relation_options& options)
{
  const auto& [contact, overlap] = answer;
  const std::string relation(to_string(contact.relation));
  std::vector<Cell> row = {{"relation", relation, relation}, {"dimension", "-", nullptr}};
  if (contact.dimension >= 0) row[1] = {"dimension", std::to_string(contact.dimension), contact.dimension};
  if (!options.measures()) return row;
  row.push_back(options.exact ? cell("volume", overlap.exact_volume()) : cell("volume", overlap.volume));
  if (options.json) {
    using Json = nlohmann::ordered_json;
    row.push_back({"centroid", "", options.exact ? Json(overlap.exact_centroid()) : numbers(overlap.centroid)});
    row.push_back(
        {"contact_vector", "", options.exact ? Json(overlap.exact_contact_vector()) : numbers(overlap.contact_vector)});
    row.push_back({"contact_area", "", {json_number(overlap.contact_area[0]), json_number(overlap.contact_area[1])}});
  } else if (options.exact) {
    const auto centroid = overlap.exact_centroid();
    for (std::size_t k = 0; k < 3; ++k) row.push_back(cell(std::string(1, "xyz"[k]), centroid[k]));
  } else if (!options.csv.empty()) {
    for (std::size_t k = 0; k < 3; ++k) row.push_back(cell(std::string(1, "xyz"[k]), overlap.centroid[k]));
  }
  return row;
}

void run_relation(const Relation_options& options)
{
  const auto way = parse_kernel(options.kernel);
  if (!way || way->kernel != Kernel::adaptive)
    throw CLI::ValidationError("--kernel " + options.kernel, "expected adaptive");
  answer_all(
      options,
      [&](Query& query, const auto& a, const auto& b) {
        return Relation_answer{query.solid_relation(a, b), options.measures() ? query.overlap(a, b) : Overlap()};
      },
      [&](const Relation_answer& answer) { return cells(answer, options); },
      [](Certificate& certificate, const auto& a, const auto& b, const Relation_answer& answer) {
        certificate.relation(a, b, answer.contact.relation);
      });
}

}  // namespace

void add_relation_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "relation", "Which of eight relations two solids have, exactly, and the dimension of the contact");
  const auto options = std::make_shared<Relation_options>();
  add_models(*command, options->names.a, options->names.b);
  command->add_flag(
      "--volume", options->volume,
      "Print, after the dimension, the double nearest to the volume of the overlap; tables have its centroid too");
  command->add_flag("--exact", options->exact, "Print the volume and the centroid, as fractions");
  add_default(*command, "--kernel", options->kernel, "adaptive");
  add_certificate_option(*command, options->certificate);
  add_table_options(*command, *options, "Write JSON to standard output, with --volume also the contact area");
  options->names.add_options_to(*command);
  command->footer(
      "Prints a line for each pose: disjoint, meet, overlap, equal, inside, contains, covered_by or covers, and the "
      "dimension of what the surfaces share: 0 points, 1 a segment, 2 an area, `-` nothing. Solids that only touch "
      "`meet`; `inside` is without contact with the other's border, `covered_by` with it.\n"
      "Example: tetracone relation cat.off house.poly --pose-b poses.txt --volume");
  command->callback([options] { run_relation(*options); });
}

}  // namespace tetracone::experiments
