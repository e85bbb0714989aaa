#include "verify/campaign/campaign_schema.h"

#include "tetracone/covering/io/input_error.h"

#include <map>
#include <string>

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

}  // namespace

bool has_table(Database& database, const std::string& table, const std::string& in)
{
  return Database::Statement(database, "SELECT 1 FROM " + in + ".sqlite_master WHERE name = ?1").with(table).next();
}

void require_columns_of_schema(Database& database)
{
  Database empty(":memory:", Database::Mode::write);
  empty.run(campaign_schema);
  const auto expected = columns_of(empty);
  for (const auto& [table, columns] : columns_of(database)) {
    const auto ours = expected.find(table);
    if (ours != expected.end() && ours->second != columns)
      throw covering::Input_error(database.file().native(), 0,
                                  "another version of tetracone wrote it: table " + table + " (" + columns + ")",
                                  "expected (" + ours->second + "), or a new file");
  }
}

}  // namespace tetracone::verify
