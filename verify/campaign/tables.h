#ifndef TETRACONE_VERIFY_CAMPAIGN_TABLES_H
#define TETRACONE_VERIFY_CAMPAIGN_TABLES_H

#include "verify/campaign/database.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// Returns the names of the tables that can be made from a campaign's database, each with its description.
const std::vector<std::pair<std::string_view, std::string_view>>& tables();

/// Returns one table as CSV, with its header line; equal databases give equal bytes. Requires a name of `tables()`.
/// Throws covering::Input_error when the database is not one of a campaign.
std::string table_as_csv(Database& database, std::string_view name);

/// An interval for a rate.
struct Interval {
  double low, high;
};

/// Returns Wilson's 95 % interval for `hits` of `n`; [0, 1] when n = 0. For no hits in n its upper end is 3.84 / (n +
/// 3.84): the upper bound of the rate behind "none".
Interval wilson(std::int64_t hits, std::int64_t n);

}  // namespace tetracone::verify

#endif
