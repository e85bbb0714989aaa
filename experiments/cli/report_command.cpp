#include "experiments/cli/commands.h"

#include "experiments/peers/fcl.h"
#include "experiments/support/draw.h"
#include "experiments/support/output_file.h"
#include "tetracone/covering/io/input_error.h"
#include "verify/campaign/campaign.h"
#include "verify/campaign/campaign_words.h"
#include "verify/campaign/tables.h"
#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/predicate_subject.h"

#include <cmath>
#include <set>

namespace tetracone::experiments {
namespace {

struct Report_options {
  std::vector<std::string> dbs;
  std::string table, out = "out";
  bool progress = false;
};

/// Returns the notes on subjects that are not ours. A note is the only question that a subject knows, if it does not
/// know both. In words it says the subject's question, its numbers and its source.
std::string notes_as_csv(verify::Database& database)
{
  std::string csv = "level,subject,knows,note\n";
  const auto add = [&csv](const std::string& level, const std::string& subject, std::string note,
                          const std::string& knows = "") {
    std::replace(note.begin(), note.end(), '"', '\'');
    if (!note.empty()) csv += level + "," + subject + "," + knows + ",\"" + note + "\"\n";
  };
  for (const Peer& peer : peers())
    add("object", peer.name, peer.note,
        peer.knows == verify::Knows::surfaces ? "surface"
        : peer.knows == verify::Knows::solids ? "solid"
                                              : "");
  for (const auto& subject : verify::moving_bodies_subjects()) add("motions", subject.name, subject.note);
  for (const Named_motion_peer& peer : motion_peers()) add("motions", peer.name, peer.note);
  verify::Database::Statement commands(database, "SELECT subject, command FROM command ORDER BY 1");
  for (commands.with(); commands.next();)
    add("object", commands.text(0), "somebody else's program: " + commands.text(1));
  for (const verify::Predicate_subject& subject : verify::predicate_subjects())
    add("predicate", subject.name, subject.note);
  return csv;
}

/// The table `runs`, whose words name the database `db`: from the project's folder, or in out/ where it is elsewhere.
std::string runs_of(const std::string& table, const std::filesystem::path& db)
{
  const std::filesystem::path from_project = std::filesystem::absolute(db).lexically_relative(TETRACONE_SOURCE_DIR);
  const bool is_within = !from_project.empty() && *from_project.begin() != "..";
  const std::string name = shell_word((is_within ? from_project : "out" / db.filename()).native());
  constexpr std::string_view verify = "build/tetracone verify ";
  std::string runs = table;
  for (std::size_t at = 0; (at = runs.find(verify, at)) != std::string::npos; at += verify.size())
    runs.insert(at + verify.size(), "--db " + name + " ");
  return runs;
}

std::string share(std::uint64_t done, std::uint64_t of)
{
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%llu of %llu answers, %.1f %%", (unsigned long long)done,
                (unsigned long long)of, of == 0 ? 100.0 : std::floor(1000 * double(done) / double(of)) / 10);
  return text.data();
}

/// A line a database and one of all. Throws CLI::RuntimeError(1) unless every shard is done.
void print_progress(const std::vector<std::string>& dbs)
{
  std::set<int> begun;
  int shards = 0;
  std::uint64_t done = 0, of = 0;
  std::string lines;
  for (const std::string& db : dbs) {
    verify::require_campaign(db);
    verify::Database database(db, verify::Database::Mode::read);
    const verify::Campaign_progress progress = verify::progress(database);
    if (shards != 0 && progress.shards != shards)
      throw covering::Input_error(db, 0, "of a campaign in " + std::to_string(progress.shards) + " shards",
                                  "expected " + std::to_string(shards) + ", as in " + dbs.front());
    shards = progress.shards;
    for (const int shard : progress.begun) begun.insert(shard);
    done += progress.done;
    of += progress.of_begun;
    const std::string which = progress.begun.size() == 1 ? "shard " + std::to_string(progress.begun.front())
                                                         : std::to_string(progress.begun.size()) + " shards";
    lines +=
        db + ": " + which + " of " + std::to_string(shards) + ", " + share(progress.done, progress.of_begun) + "\n";
  }
  std::cout << lines << "all: " << begun.size() << " of " << shards << " shards begun, " << share(done, of)
            << " of these\n";
  if (done < of || int(begun.size()) < shards) throw CLI::RuntimeError(1);
}

void run_report(const Report_options& options)
{
  if (options.progress) {
    if (!options.table.empty()) throw CLI::ValidationError("--progress", "expected without --table");
    print_progress(options.dbs);
    return;
  }
  const auto& tables = verify::tables();
  if (options.dbs.size() != 1)
    throw CLI::ValidationError("DB", "expected one database; `tetracone merge` joins several");
  const std::string& db = options.dbs.front();
  verify::require_campaign(db);
  verify::Database database(db, verify::Database::Mode::read);
  if (!options.table.empty()) {
    if (std::none_of(tables.begin(), tables.end(), [&](const auto& table) { return table.first == options.table; })) {
      std::vector<std::string> names;
      for (const auto& [name, what] : tables) names.emplace_back(name);
      throw CLI::ValidationError("--table " + options.table, "expected one of " + joined(names));
    }
    std::cout << verify::table_as_csv(database, options.table);
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(options.out) / "tables";
  make_folder(folder);
  for (const auto& [name, what] : tables) {
    const std::string table = verify::table_as_csv(database, name);
    write_whole(folder / ("verify_" + std::string(name) + ".csv"), name == "runs" ? runs_of(table, db) : table);
  }
  write_whole(folder / "verify_notes.csv", notes_as_csv(database));
  draw("report.py", options.out);
}

}  // namespace

void add_report_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("report", "The report and the tables of a campaign's database");
  const auto options = std::make_shared<Report_options>();
  command->add_option("DB", options->dbs, "Database that `tetracone verify` wrote; with --progress, any number")
      ->required();
  command->add_flag("--progress", options->progress,
                    "Print how far each database and the whole campaign are; exit status 1 while something is missing");
  command->add_option("--table", options->table, "Print this one table as CSV");
  add_default(*command, "--out", options->out,
              "Folder of the results: OUT/report.html, and each table as OUT/tables/verify_NAME.csv");
  std::string footer = "Tables:";
  for (const auto& [name, what] : verify::tables())
    footer +=
        "\n  " + std::string(name) + std::string(12 - std::min<std::size_t>(11, name.size()), ' ') + std::string(what);
  command->footer(footer +
                  "\nExample: tetracone report out/verify.db --table errors\n"
                  "         tetracone report --progress out/shard-*.db");
  command->callback([options] { run_report(*options); });
}

}  // namespace tetracone::experiments
