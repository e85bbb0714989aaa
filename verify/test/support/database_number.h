#ifndef TETRACONE_VERIFY_TEST_SUPPORT_DATABASE_NUMBER_H
#define TETRACONE_VERIFY_TEST_SUPPORT_DATABASE_NUMBER_H

#include "verify/campaign/database.h"

#include <cstdint>
#include <string>

namespace tetracone::verify {

/// Returns the only number of a query's result.
inline std::int64_t number(Database& database, const std::string& query)
{
  Database::Statement row(database, query);
  row.with().next();
  return row.integer(0);
}

/// Returns the sum of a column of the table tally, or of an expression of columns. The rows are those of axis `rho`
/// where the condition holds.
inline std::int64_t tally(Database& database, const std::string& what, const std::string& where)
{
  return number(database, "SELECT sum(" + what + ") FROM tally WHERE axis = 'rho' AND " + where);
}

}  // namespace tetracone::verify

#endif
