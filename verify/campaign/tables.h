#ifndef TETRACONE_VERIFY_CAMPAIGN_TABLES_H
#define TETRACONE_VERIFY_CAMPAIGN_TABLES_H

#include "verify/campaign/database.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// The names of the tables that can be drawn from a campaign's database, each with what it says.
const std::vector<std::pair<std::string_view, std::string_view>>& tables();

/// One table as CSV, with its header line; the same database gives the same bytes. Requires a name of `tables()`.
/// Throws covering::Input_error when the database is not one of a campaign.
std::string table_as_csv(Database& database, std::string_view name);

/// An interval for a rate.
struct Interval {
  double low, high;
};

/// Wilson's 95 % interval for `hits` of `n`; [0, 1] where n = 0. With no hits in n its upper end, 3.84 / (n + 3.84), is
/// the bound that "none" stands for.
Interval wilson(std::int64_t hits, std::int64_t n);

}  // namespace tetracone::verify

#endif
