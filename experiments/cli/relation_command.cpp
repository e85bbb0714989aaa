#include "experiments/cli/command_words.h"
#include "experiments/cli/commands.h"

#include "experiments/cli/answer_rows.h"
#include "experiments/cli/certificate_file.h"
#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/scene_options.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

using Json = nlohmann::ordered_json;

struct Relation_options {
  Scene_names names;
  std::string csv, certificate, kernel = "adaptive";
  bool volume = false, exact = false, json = false, time = false;
  int repeat = 1;

  /// True when the volume is asked for; its fraction is a way to write it.
  bool measures() const { return volume || exact; }
};

/// The answer of one pose.
struct Relation_row {
  Solid_contact contact{};
  Overlap overlap;
  double nanoseconds = std::numeric_limits<double>::infinity();
};

std::vector<Relation_row> ask(Query& query, const Pose_pairs& poses, const Relation_options& options)
{
  std::vector<Relation_row> rows(poses.count());
  const int passes = options.time ? options.repeat : 1;
  Progress progress("poses", rows.size() * passes);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Stopwatch watch;
      rows[k].contact = query.solid_relation(poses.of_a(k), poses.of_b(k));
      if (options.measures()) rows[k].overlap = query.overlap(poses.of_a(k), poses.of_b(k));
      rows[k].nanoseconds = std::min(rows[k].nanoseconds, watch.nanoseconds());
      progress.step();
    }
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
    if (options.time) text += "," + std::to_string(static_cast<long long>(rows[k].nanoseconds));
    text += "\n";
  }
  return text;
}

void run_relation(const Relation_options& options)
{
  const auto way = parse_kernel(options.kernel);
  if (!way || way->kernel != Kernel::adaptive)
    throw CLI::ValidationError("--kernel " + options.kernel, "expected adaptive");
  if (options.json && !options.csv.empty()) throw CLI::ValidationError("--json", "expected without --csv");
  if (options.time && options.csv.empty() && !options.json)
    throw CLI::ValidationError("--time", "expected --csv or --json to hold the times");
  if (options.repeat < 1) throw CLI::ValidationError("--repeat", "expected a number from 1");
  for (const std::string& output : {options.csv, options.certificate})
    if (!output.empty()) options.names.refuse_as_output(output);
  require_other_file(options.certificate, options.csv);

  const Pose_pairs poses = read_pose_pairs(options.names);
  const auto models = load_models(options.names.a, options.names.b, options.names.models, true);
  Query query(models[0].body, models[1].body, Question::solid, *way);
  const std::vector<Relation_row> rows = ask(query, poses, options);
  const std::string text = text_of(rows, options);
  write_answers(options.csv, text);
  if (options.certificate.empty()) return;
  Certificate certificate = certificate_of(models[0], models[1]);
  for (std::size_t k = 0; k < rows.size(); ++k)
    certificate.relation(poses.of_a(k), poses.of_b(k), rows[k].contact.relation);
  write_certificate(options.certificate, certificate);
}

}  // namespace

void add_relation_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "relation", "Which of eight relations two solids have, exactly, and the dimension of the contact");
  const auto options = std::make_shared<Relation_options>();
  command->add_option("A", options->names.a, "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command->add_option("B", options->names.b, "Model")->required();
  command->add_flag(
      "--volume", options->volume,
      "Print, after the dimension, the double nearest to the volume of the overlap; tables have its centroid too");
  command->add_flag("--exact", options->exact, "Print the volume and the centroid, as fractions");
  add_default(*command, "--kernel", options->kernel, "adaptive");
  add_certificate_option(*command, options->certificate);
  command->add_option("--csv", options->csv, "Write a table to this file");
  command->add_flag("--json", options->json, "Write JSON to standard output, with --volume also the contact area");
  command->add_flag("--time", options->time, "With --csv or --json: nanoseconds of each pose");
  add_default(*command, "--repeat", options->repeat, "With --time: passes over all poses, of which the fastest counts");
  options->names.add_options_to(*command);
  command->footer(
      "Prints a line for each pose: disjoint, meet, overlap, equal, inside, contains, covered_by or covers, and the "
      "dimension of what the surfaces share: 0 points, 1 a segment, 2 an area, `-` nothing. Solids that only touch "
      "`meet`; `inside` is without contact with the other's border, `covered_by` with it.\n"
      "Example: tetracone relation cat.off house.poly --pose-b poses.txt --volume");
  command->callback([options] { run_relation(*options); });
}

}  // namespace tetracone::experiments
