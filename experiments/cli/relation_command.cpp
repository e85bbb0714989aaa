#include "experiments/cli/pair_command.h"

#include <nlohmann/json.hpp>

namespace tetracone::experiments {
namespace {

using Json = nlohmann::ordered_json;

struct Relation_options : Pair_options {
  std::string kernel = "adaptive";
  bool volume = false, exact = false;

  /// True when the volume is asked for; its fraction is a way to write it.
  bool measures() const { return volume || exact; }
};

/// The answer of one pose.
struct Relation_row {
  Solid_contact contact{};
  Overlap overlap;
  double nanoseconds = std::numeric_limits<double>::infinity();
};

std::vector<Relation_row> ask(Asked_pair& asked, const Relation_options& options)
{
  std::vector<Relation_row> rows(asked.poses.count());
  const auto answer = [&](std::size_t k) {
    const kernel::Pose &a = asked.poses.of_a(k), &b = asked.poses.of_b(k);
    Relation_row row{asked.query.solid_relation(a, b), {}, rows[k].nanoseconds};
    if (options.measures()) row.overlap = asked.query.overlap(a, b);
    return row;
  };
  ask_all("poses", rows.size(), options.passes(), answer, [&](std::size_t k, Relation_row row, double ns) {
    rows[k] = std::move(row);
    rows[k].nanoseconds = std::min(rows[k].nanoseconds, ns);
  });
  return rows;
}

/// Returns the relation, the dimension, and if it is asked for the volume; the centroid too where `with_centroid`.
std::string fields(const Relation_row& row, const Relation_options& options, char blank, bool with_centroid)
{
  std::string text(to_string(row.contact.relation));
  text += blank + (row.contact.dimension < 0 ? "-" : std::to_string(row.contact.dimension));
  if (!options.measures()) return text;
  std::array<std::string, 3> exact_centroid;
  if (options.exact && with_centroid) exact_centroid = row.overlap.exact_centroid();
  text += blank + (options.exact ? row.overlap.exact_volume() : kernel::shortest(row.overlap.volume));
  for (std::size_t k = 0; k < 3 && with_centroid; ++k)
    text += blank + (options.exact ? exact_centroid[k] : kernel::shortest(row.overlap.centroid[k]));
  return text;
}

Json object(std::size_t pose, const Relation_row& row, const Relation_options& options)
{
  Json object = {{"pose", pose}, {"relation", to_string(row.contact.relation)}};
  object["dimension"] = row.contact.dimension < 0 ? Json() : Json(row.contact.dimension);
  const auto numbers = [](const std::array<double, 3>& x) {
    return Json::array({json_number(x[0]), json_number(x[1]), json_number(x[2])});
  };
  const Overlap& overlap = row.overlap;
  if (options.exact) {
    object["volume"] = overlap.exact_volume();
    object["centroid"] = overlap.exact_centroid();
    object["contact_vector"] = overlap.exact_contact_vector();
  } else if (options.volume) {
    object["volume"] = json_number(overlap.volume);
    object["centroid"] = numbers(overlap.centroid);
    object["contact_vector"] = numbers(overlap.contact_vector);
  }
  if (options.measures())
    object["contact_area"] = {json_number(overlap.contact_area[0]), json_number(overlap.contact_area[1])};
  if (options.time) object["ns"] = static_cast<long long>(row.nanoseconds);
  return object;
}

std::string text_of(const std::vector<Relation_row>& rows, const Relation_options& options)
{
  if (options.json) {
    Json all = Json::array();
    for (std::size_t k = 0; k < rows.size(); ++k) all.push_back(object(k, rows[k], options));
    return all.dump(1) + "\n";
  }
  std::string text;
  if (!options.csv.empty())
    text = std::string("pose,relation,dimension") + (options.measures() ? ",volume,x,y,z" : "") +
           (options.time ? ",ns\n" : "\n");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (options.csv.empty()) {
      text += fields(rows[k], options, ' ', options.exact) + "\n";
      continue;
    }
    text += std::to_string(k) + "," + fields(rows[k], options, ',', true);
    if (options.time) text += ns_column(rows[k].nanoseconds);
    text += "\n";
  }
  return text;
}

void run_relation(const Relation_options& options)
{
  const auto way = parse_kernel(options.kernel);
  if (!way || way->kernel != Kernel::adaptive)
    throw CLI::ValidationError("--kernel " + options.kernel, "expected adaptive");
  options.require(true);
  options.require_files();

  Asked_pair asked = read_pair(options.names, Question::solid, *way);
  const std::vector<Relation_row> rows = ask(asked, options);
  write_answers(options.csv, text_of(rows, options));
  if (options.certificate.empty()) return;
  Certificate certificate = certificate_of(asked.models[0], asked.models[1]);
  for (std::size_t k = 0; k < rows.size(); ++k)
    certificate.relation(asked.poses.of_a(k), asked.poses.of_b(k), rows[k].contact.relation);
  write_certificate(options.certificate, certificate);
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
