#ifndef TETRACONE_EXPERIMENTS_CLI_SOLID_ANSWERS_H
#define TETRACONE_EXPERIMENTS_CLI_SOLID_ANSWERS_H

#include "experiments/cli/pair_command.h"

#include <nlohmann/json.hpp>

/// What the commands share whose answer about two solids has several parts: relation, exit and depth.
namespace tetracone::experiments {

/// The options of each of them.
struct Solid_options : Pair_options {
  bool exact = false;
};

/// A part of an answer: its column, how a line writes it, and its value in JSON.
struct Cell {
  std::string column, text;
  nlohmann::ordered_json value;
};

/// Returns a part that is a double, or a fraction "n/d", which is text in JSON too.
inline Cell cell(const std::string& column, double x) { return {column, kernel::shortest(x), json_number(x)}; }
inline Cell cell(const std::string& column, const std::string& fraction) { return {column, fraction, fraction}; }

/// The answer of one pose.
struct Solid_row {
  std::vector<Cell> cells;
  double nanoseconds = std::numeric_limits<double>::infinity();  ///< of the fastest pass
};

/// Returns the answers in the form that the options name. Requires a row.
inline std::string text_of(const std::vector<Solid_row>& rows, const Solid_options& options)
{
  using Json = nlohmann::ordered_json;
  if (options.json) {
    Json all = Json::array();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      Json object = {{"pose", k}};
      for (const Cell& cell : rows[k].cells) object[cell.column] = cell.value;
      if (options.time) object["ns"] = static_cast<long long>(rows[k].nanoseconds);
      all.push_back(std::move(object));
    }
    return all.dump(1) + "\n";
  }
  std::string text;
  if (!options.csv.empty()) {
    text = "pose";
    for (const Cell& cell : rows[0].cells) text += "," + cell.column;
    text += options.time ? ",ns\n" : "\n";
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!options.csv.empty()) text += std::to_string(k) + ",";
    for (const Cell& cell : rows[k].cells) text += (&cell == &rows[k].cells[0] ? "" : options.blank()) + cell.text;
    if (options.time) text += ns_column(rows[k].nanoseconds);
    text += "\n";
  }
  return text;
}

/// Asks ask(query, pose of A, pose of B) for all poses, in as many passes as the options say. Writes the parts that
/// cells(answer) returns for the first pass. With --certificate, prove(certificate, pose of A, pose of B, answer) adds
/// a proof, and the certificate is written too. Throws CLI::ValidationError for bad options, and covering::Input_error
/// for bad files.
template <class Ask, class Cells, class Prove>
void answer_all(const Solid_options& options, const Ask& ask, const Cells& cells, const Prove& prove)
{
  options.require(true);
  options.require_files();

  Asked_pair asked = read_pair(options.names, Question::solid);
  const Pose_pairs& poses = asked.poses;
  std::vector<Solid_row> rows(poses.count());
  std::optional<Certificate> certificate;
  if (!options.certificate.empty()) certificate = certificate_of(asked.models[0], asked.models[1]);
  ask_all(
      "poses", rows.size(), options.passes(),
      [&](std::size_t k) { return ask(asked.query, poses.of_a(k), poses.of_b(k)); },
      [&](std::size_t k, const auto& answer, double ns) {
        rows[k].nanoseconds = std::min(rows[k].nanoseconds, ns);
        if (!rows[k].cells.empty()) return;  // an earlier pass has answered
        rows[k].cells = cells(answer);
        if (certificate) prove(*certificate, poses.of_a(k), poses.of_b(k), answer);
      });
  write_answers(options.csv, text_of(rows, options));
  if (certificate) write_certificate(options.certificate, *certificate);
}

}  // namespace tetracone::experiments

#endif
