#ifndef TETRACONE_VERIFY_CAMPAIGN_FAMILY_LINES_H
#define TETRACONE_VERIFY_CAMPAIGN_FAMILY_LINES_H

#include <string>
#include <string_view>
#include <vector>

namespace tetracone::verify {

/// The description of a family in lists and reports.
struct Family_line {
  std::string levels;          ///< that ask its cases, a space between two
  std::string_view name;       ///< what --family takes
  std::string_view what;       ///< what its cases have in common
  std::string_view parameter;  ///< what its parameter means; empty where there is none
  std::vector<double> sweep;   ///< the values of the parameter, in turn
};

/// Returns all families of all levels, each once.
std::vector<Family_line> family_lines();

/// Returns the different values of the sweep in their order, separated by spaces.
std::string sweep_text(const Family_line& line);

}  // namespace tetracone::verify

#endif
