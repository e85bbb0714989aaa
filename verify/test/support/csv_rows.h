#ifndef TETRACONE_VERIFY_TEST_SUPPORT_CSV_ROWS_H
#define TETRACONE_VERIFY_TEST_SUPPORT_CSV_ROWS_H

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace tetracone::verify {

/// Returns the rows of a CSV, each field by its column's name. Requires fields without quotes.
inline std::vector<std::map<std::string, std::string>> csv_rows(const std::filesystem::path& file)
{
  const auto fields = [](const std::string& line) {
    std::vector<std::string> all;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) all.push_back(field);
    return all;
  };
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = fields(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = fields(line);
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < names.size() && k < values.size(); ++k) row[names[k]] = values[k];
  }
  return rows;
}

}  // namespace tetracone::verify

#endif
