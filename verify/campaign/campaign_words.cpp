#include "verify/campaign/campaign_words.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/cases/shape_library.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace tetracone::verify {
namespace {

/// Returns the names as a sorted JSON array, which SQLite reads.
std::string array_of(const std::set<std::string>& names) { return nlohmann::json(names).dump(); }

std::string families_of(const Campaign& campaign)
{
  std::set<std::string> names;
  for_each_level(campaign.levels, [&](const auto& asked) {
    for (const auto* family : asked.families) names.emplace(family->name);
  });
  return array_of(names);
}

std::string subjects_of(const Campaign& campaign)
{
  std::set<std::string> names;
  for_each_level(campaign.levels, [&]<class Level>(const Asked<Level>& asked) {
    for (const auto& subject : asked.subjects) names.insert(std::string(Level::name) + " " + subject.name);
  });
  return array_of(names);
}

/// The columns in which shards of one campaign agree.
const std::string common =
    "version, seed, predicate_cases, object_cases, feature_cases, probe_cases, frames, families, subjects, "
    "real_meshes, shards";
constexpr std::array common_words = {"version",       "seed",        "predicate cases", "object cases",
                                     "feature cases", "probe cases", "frames",          "families",
                                     "subjects",      "real meshes", "shards"};

/// Returns the first column in which two rows differ, shortened if it is a list.
std::string difference(const Database::Statement& one, const Database::Statement& other)
{
  constexpr std::size_t enough = 60;
  const auto shown = [](const std::string& text) {
    return text.size() > enough ? text.substr(0, enough) + "..." : text;
  };
  for (int k = 0; k < int(common_words.size()); ++k)
    if (one.text(k) != other.text(k))
      return std::string(common_words[std::size_t(k)]) + ": " + shown(one.text(k)) + " instead of " +
             shown(other.text(k));
  return "words";
}

}  // namespace

void record_words(Database& database, const Campaign& campaign, std::uint64_t answers)
{
  Database::Transaction transaction(database);
  Database::Statement known(database, "SELECT command FROM command WHERE subject = ?1");
  Database::Statement add(database, "INSERT OR IGNORE INTO command VALUES (?1, ?2)");
  Database::Statement hello(database, "SELECT hello, digest FROM hello WHERE subject = ?1");
  Database::Statement add_hello(database, "INSERT OR IGNORE INTO hello VALUES (?1, ?2, ?3)");
  for (const Object_subject& subject : campaign.at<levels::Objects>().subjects) {
    if (subject.command.empty()) continue;
    if (known.with(subject.name).next() && known.text(0) != subject.command)
      throw covering::Input_error(database.file().native(), 0,
                                  subject.name + " was the command '" + known.text(0) + "'",
                                  "expected the same command, or another name for '" + subject.command + "'");
    add.run(subject.name, subject.command);
    if (hello.with(subject.name).next() && (hello.text(0) != subject.hello || hello.text(1) != subject.digest))
      throw covering::Input_error(
          database.file().native(), 0,
          "the program of " + subject.name + " has changed, or its hello, which was '" + hello.text(0) + "'",
          "expected another name for the new program");
    add_hello.run(subject.name, subject.hello, subject.digest);
  }
  // A replaced row becomes the last row.
  Database::Statement(database, "INSERT OR REPLACE INTO words (" + common +
                                    ", shard, answers) "
                                    "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13)")
      .run(campaign.made_by.version, campaign.seed, campaign.predicate_cases, campaign.object_cases,
           campaign.feature_cases, campaign.probe_cases, campaign.sequence_frames, families_of(campaign),
           subjects_of(campaign), real_meshes_available(), campaign.shards, campaign.shard, answers);
  transaction.commit();
}

void refuse_other_words(Database& into, const std::filesystem::path& from)
{
  Database::Statement here(into, "SELECT DISTINCT " + common + " FROM main.words"),
      there(into, "SELECT DISTINCT " + common + " FROM other.words");
  if (!here.with().next()) return;
  for (const std::string& apart :
       {"SELECT " + common + " FROM other.words EXCEPT SELECT " + common + " FROM main.words",
        "SELECT " + common + " FROM main.words EXCEPT SELECT " + common + " FROM other.words"})
    if (Database::Statement(into, apart).with().next())
      throw covering::Input_error(
          from.native(), 0,
          "of another campaign than " + into.file().native() +
              (there.with().next() ? ", " + difference(there, here) : std::string(": nothing was asked")),
          "expected shards that were asked with the same words");
  if (has_table(into, "hello") && has_table(into, "hello", "other")) {
    Database::Statement hello(into,
                              "SELECT there.subject FROM other.hello AS there JOIN main.hello AS here USING (subject) "
                              "WHERE there.hello != here.hello OR there.digest != here.digest");
    if (hello.with().next())
      throw covering::Input_error(from.native(), 0,
                                  "the program of " + hello.text(0) + " is not that of " + into.file().native(),
                                  "expected shards that were asked of the same programs");
  }
  Database::Statement command(into,
                              "SELECT there.subject, there.command, here.command FROM other.command AS there JOIN "
                              "main.command AS here USING (subject) WHERE there.command != here.command");
  if (command.with().next())
    throw covering::Input_error(from.native(), 0,
                                command.text(0) + " was the command '" + command.text(1) + "', in " +
                                    into.file().native() + " '" + command.text(2) + "'",
                                "expected shards that were asked with the same words");
}

Campaign_progress progress(Database& database)
{
  require_columns_of_schema(database);
  Database::Statement rows(database, "SELECT shard, answers, " + common + " FROM words NATURAL JOIN (SELECT " + common +
                                         " FROM words ORDER BY words.rowid DESC LIMIT 1) ORDER BY shard");
  Campaign_progress progress;
  Database::Statement done(
      database,
      "SELECT ifnull(sum(cases), 0) FROM done WHERE seed = ?1 AND (family IN (SELECT value FROM "
      "json_each(?2)) OR (?4 > 0 AND family LIKE 'sequence %')) AND (subject = 'truth' OR level || "
      "' ' || subject IN (SELECT value FROM json_each(?3)))");
  for (rows.with(); rows.next();) {
    progress.begun.push_back(int(rows.integer(0)));
    progress.of_begun += std::uint64_t(rows.integer(1));
    progress.shards = int(rows.integer(12));
    if (progress.begun.size() > 1) continue;
    done.with(rows.integer(3), rows.text(9), rows.text(10), rows.integer(8)).next();
    progress.done = std::uint64_t(done.integer(0));
  }
  if (progress.begun.empty())
    throw covering::Input_error(database.file().native(), 0, "nothing was ever asked",
                                "expected a database that `tetracone verify` wrote");
  progress.done = std::min(progress.done, progress.of_begun);  // of a larger campaign before
  return progress;
}

}  // namespace tetracone::verify
