#include "verify/campaign/campaign_schema.h"

#include "tetracone/covering/io/input_error.h"

#include <map>
#include <string>
#include <vector>

namespace tetracone::verify {
namespace {

/// The columns of each table, in order.
std::map<std::string, std::string> columns_of(Database& database)
{
  Database::Statement rows(database,
                           "SELECT one.name, info.name FROM sqlite_master AS one JOIN pragma_table_info(one.name) AS "
                           "info WHERE one.type = 'table' ORDER BY one.name, info.cid");
  std::map<std::string, std::string> columns;
  for (rows.with(); rows.next();) {
    std::string& all = columns[rows.text(0)];
    all += (all.empty() ? "" : ", ") + rows.text(1);
  }
  return columns;
}

/// The columns of each table of the schema.
const std::map<std::string, std::string>& columns_of_schema()
{
  static const auto columns = [] {
    Database empty(":memory:", Database::Mode::write);
    empty.run(campaign_schema);
    return columns_of(empty);
  }();
  return columns;
}

}  // namespace

std::string on_conflict(const std::string& table)
{
  static const std::map<std::string, std::vector<std::string>> summed = {
      {"done", {"cases"}},
      {"tally", {"n", "false_positives", "false_negatives", "failures", "not_asked"}},
      {"rounded", {"n", "changed", "wrong", "excused", "false_positives", "false_negatives"}},
      {"truth", {"n", "positives", "by_construction"}},
      {"blame", {"n"}},
      {"failure", {"n"}},
      {"relation", {"tried", "violated", "not_applicable"}},
      {"skipped", {"n"}},
      {"time", {"n", "making", "asking"}}};
  const auto sums = summed.find(table);
  if (sums == summed.end()) return table == "declined" ? " ON CONFLICT DO NOTHING" : "";
  std::string set;
  for (const std::string& sum : sums->second)
    set += (set.empty() ? "" : ", ") + sum + " = " + sum + " + excluded." + sum;
  if (table == "failure")
    set += ", said = iif(excluded.first < first, excluded.said, said), first = min(first, excluded.first)";
  return " ON CONFLICT DO UPDATE SET " + set;
}

std::string insertion(const std::string& table, int n)
{
  std::string values;
  for (int k = 1; k <= n; ++k) values += (k == 1 ? "?" : ", ?") + std::to_string(k);
  return "INSERT INTO " + table + " VALUES (" + values + ")" + on_conflict(table);
}

std::string merging(const std::string& table)
{
  const std::string after_run = columns_of_schema().at(table).substr(std::string("run").size());
  return "INSERT INTO main." + table + " SELECT here" + after_run + " FROM other." + table +
         " JOIN renumbered ON run = there WHERE true" + on_conflict(table);
}

bool has_table(Database& database, const std::string& table, const std::string& in)
{
  return Database::Statement(database, "SELECT 1 FROM " + in + ".sqlite_master WHERE name = ?1").with(table).next();
}

void require_columns_of_schema(Database& database)
{
  for (const auto& [table, columns] : columns_of(database)) {
    const auto ours = columns_of_schema().find(table);
    if (ours != columns_of_schema().end() && ours->second != columns)
      throw covering::Input_error(database.file().native(), 0,
                                  "another version of tetracone wrote it: table " + table + " (" + columns + ")",
                                  "expected (" + ours->second + "), or a new file");
  }
}

}  // namespace tetracone::verify
