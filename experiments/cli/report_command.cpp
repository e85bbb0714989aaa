#include "experiments/cli/report_command.h"

#include "experiments/peers/peer.h"
#include "experiments/support/draw.h"
#include "experiments/support/output_file.h"
#include "verify/campaign/campaign.h"
#include "verify/campaign/tables.h"
#include "verify/subjects/predicate_subject.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

namespace tetracone::experiments {
namespace {

struct Options {
  std::string db, table, out = "out";
};

/// What a subject's answers mean where it is not ours: the question that it answers, its numbers, its source.
std::string notes_as_csv()
{
  std::string csv = "level,subject,note\n";
  const auto add = [&csv](const std::string& level, const std::string& subject, std::string note) {
    std::replace(note.begin(), note.end(), '"', '\'');
    if (!note.empty()) csv += level + "," + subject + ",\"" + note + "\"\n";
  };
  for (const Peer& peer : peers()) add("object", peer.name, peer.note);
  for (const verify::Predicate_subject& subject : verify::predicate_subjects())
    add("predicate", subject.name, subject.note);
  return csv;
}

void run(const Options& options)
{
  const auto& tables = verify::tables();
  verify::require_campaign(options.db);
  verify::Database database(options.db, verify::Database::Mode::read);
  if (!options.table.empty()) {
    if (std::none_of(tables.begin(), tables.end(), [&](const auto& table) { return table.first == options.table; })) {
      std::string list;
      for (const auto& [name, what] : tables) list += (list.empty() ? "" : ", ") + std::string(name);
      throw CLI::ValidationError("--table " + options.table, "expected one of " + list);
    }
    std::cout << verify::table_as_csv(database, options.table);
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(options.out) / "tables";
  make_folder(folder);
  for (const auto& [name, what] : tables)
    write_whole(folder / ("verify_" + std::string(name) + ".csv"), verify::table_as_csv(database, name));
  write_whole(folder / "verify_notes.csv", notes_as_csv());
  draw("report.py", options.out);
}

}  // namespace

void add_report_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("report", "The report and the tables of a campaign's database");
  const auto options = std::make_shared<Options>();
  command->add_option("DB", options->db, "Database that `tetracone verify` wrote")->required();
  command->add_option("--table", options->table, "Print this one table as CSV");
  command
      ->add_option("--out", options->out,
                   "Folder of the results: OUT/report.html, and each table as OUT/tables/verify_NAME.csv")
      ->capture_default_str();
  std::string footer = "Tables:";
  for (const auto& [name, what] : verify::tables())
    footer +=
        "\n  " + std::string(name) + std::string(12 - std::min<std::size_t>(11, name.size()), ' ') + std::string(what);
  command->footer(footer + "\nExample: tetracone report out/verify.db --table errors");
  command->callback([options] { run(*options); });
}

}  // namespace tetracone::experiments
