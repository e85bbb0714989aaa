#ifndef TETRACONE_VERIFY_TEST_SUPPORT_DATABASE_NUMBER_H
#define TETRACONE_VERIFY_TEST_SUPPORT_DATABASE_NUMBER_H

#include "verify/campaign/database.h"

#include <cstdint>
#include <string>

namespace tetracone::verify {

/// The one number that a query gives.
inline std::int64_t number(Database& database, const std::string& query)
{
  Database::Statement row(database, query);
  row.with().next();
  return row.integer(0);
}

}  // namespace tetracone::verify

#endif
