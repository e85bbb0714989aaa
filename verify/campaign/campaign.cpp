#include "verify/campaign/campaign.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/campaign/batch_judge.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/campaign/campaign_words.h"
#include "verify/cases/shape_library.h"

#include <tbb/parallel_for_each.h>

#include <mutex>

namespace tetracone::verify {
namespace {

/// Makes all tables or none: a file with only some of them is another program's.
void make_tables(Database& database)
{
  Database::Transaction transaction(database);
  database.run(campaign_schema);
  transaction.commit();
}

void require_tables(Database& database)
{
  Database::Statement(database, "SELECT again, cases, not_asked FROM run, done, tally");
}

std::int64_t run_number(Database& database, const Campaign& campaign)
{
  const Provenance& p = campaign.made_by;
  const bool meshes = real_meshes_available();
  Database::Transaction transaction(database);
  Database::Statement(database,
                      "INSERT OR IGNORE INTO run (version, compiler, flags, processor, seed, real_meshes, again) "
                      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)")
      .run(p.version, p.compiler, p.flags, p.processor, campaign.seed, meshes, p.again);
  Database::Statement row(
      database,
      "SELECT id FROM run WHERE version = ?1 AND compiler = ?2 AND flags = ?3 AND processor = ?4 AND seed = ?5 "
      "AND real_meshes = ?6 AND again = ?7");
  row.with(p.version, p.compiler, p.flags, p.processor, campaign.seed, meshes, p.again).next();
  const std::int64_t id = row.integer(0);
  row.next();
  transaction.commit();
  return id;
}

/// Attaches the database of another campaign, as `other`, for its own lifetime.
class Attached {
 public:
  Attached(Database& database, const std::filesystem::path& other) : database_(database)
  {
    Database::Statement(database, "ATTACH ?1 AS other").run(other.native());
  }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;
  ~Attached()
  {
    try {
      database_.run("DETACH other");
    } catch (const covering::Input_error&) {
    }
  }

 private:
  Database& database_;
};

/// True when `into` has every batch of the attached database, up to the same case.
bool has_all(Database& into)
{
  return !Database::Statement(into, "SELECT 1 FROM (SELECT * FROM other.done EXCEPT SELECT * FROM main.done) LIMIT 1")
              .with()
              .next();
}

/// Throws covering::Input_error when `into` and the attached database `from` have the same batch for one subject.
void refuse_common_batches(Database& into, const std::filesystem::path& from)
{
  Database::Statement twice(into,
                            "SELECT level, family, batch, subject FROM done JOIN other.done USING (seed, level, "
                            "family, batch, subject) LIMIT 1");
  if (twice.with().next())
    throw covering::Input_error(from.native(), 0,
                                "batch " + twice.text(2) + " of " + twice.text(0) + " " + twice.text(1) + " asked of " +
                                    twice.text(3) + " is in " + into.file().native() + " already",
                                "expected each shard once, or a new file that takes all");
}

/// Adds the attached database's runs, and remembers their numbers here and there.
constexpr const char* merge_runs = R"(
    INSERT OR IGNORE INTO run (version, compiler, flags, processor, seed, real_meshes, again)
      SELECT version, compiler, flags, processor, seed, real_meshes, again FROM other.run;
    CREATE TEMP TABLE renumbered AS SELECT there.id AS there, here.id AS here FROM other.run AS there
      JOIN main.run AS here USING (version, compiler, flags, processor, seed, real_meshes, again);
    INSERT INTO main.done SELECT * FROM other.done;
  )";

}  // namespace

std::uint64_t case_count(const Campaign& campaign)
{
  std::uint64_t count = 0;
  const auto sequences = sequences_of(campaign);
  for (const Batch& batch : batches(campaign, sequences)) count += batch.last - batch.first;
  return count;
}

void run_campaign(Database& database, const Campaign& campaign, const std::function<void(std::uint64_t)>& done)
{
  const auto sequences = sequences_of(campaign);
  const auto todo = batches(campaign, sequences);
  make_tables(database);
  record_words(database, campaign, answer_count(campaign, todo));
  const std::int64_t run = run_number(database, campaign);
  const Done before(database, campaign.seed);
  Batch_judge judged(campaign, before);
  std::mutex one_at_a_time;
  tbb::parallel_for_each(todo, [&](const Batch& batch) {
    const Findings found = judged(batch);
    const std::lock_guard lock(one_at_a_time);
    Database::Transaction transaction(database);
    found.store(database, run, campaign.seed, batch.number);
    transaction.commit();
    done(batch.last - batch.first);
  });
}

void require_campaign(const std::filesystem::path& file)
{
  Database database(file, Database::Mode::read);
  require_tables(database);
  require_columns_of_schema(database);
}

Database open_campaign(const std::filesystem::path& file)
{
  std::error_code missing;
  if (std::filesystem::file_size(file, missing) != 0 && !missing) {
    Database there(file, Database::Mode::read);
    if (Database::Statement(there, "SELECT 1 FROM sqlite_master").with().next()) {
      require_tables(there);
      require_columns_of_schema(there);
    }
  }
  return Database(file, Database::Mode::write);
}

void merge(Database& into, const std::filesystem::path& from)
{
  Database other(from, Database::Mode::read);
  require_tables(other);
  require_columns_of_schema(other);
  make_tables(into);
  const Attached attached(into, from);
  Database::Transaction transaction(into);
  refuse_other_words(into, from);
  if (!has_all(into)) {
    refuse_common_batches(into, from);
    into.run(merge_runs);
    for (const char* table :
         {"tally", "truth", "wrong", "blame", "failure", "relation", "flips", "time", "declined", "skipped", "rounded"})
      if (has_table(into, table, "other")) into.run(merging(table));
    into.run("DROP TABLE renumbered");
  }
  into.run(
      "INSERT OR IGNORE INTO main.words SELECT * FROM other.words ORDER BY rowid;"
      "INSERT OR IGNORE INTO main.command SELECT * FROM other.command");
  if (has_table(into, "hello", "other")) into.run("INSERT OR IGNORE INTO main.hello SELECT * FROM other.hello");
  transaction.commit();
}

}  // namespace tetracone::verify
