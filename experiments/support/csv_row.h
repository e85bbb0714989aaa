#ifndef TETRACONE_EXPERIMENTS_SUPPORT_CSV_ROW_H
#define TETRACONE_EXPERIMENTS_SUPPORT_CSV_ROW_H

#include "experiments/support/build_info.h"
#include "tetracone/kernel/number/number.h"

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>

namespace tetracone::experiments {

/// A row of a table with its header: each field with its name. Numbers are written to four digits, counts as they are.
class Csv_row {
 public:
  Csv_row& add(const std::string& name, const std::string& value)
  {
    const char* comma = header_.empty() ? "" : ",";
    header_ += comma + name;
    line_ += comma + field(value);
    return *this;
  }
  Csv_row& add(const std::string& name, const char* value) { return add(name, std::string(value)); }
  Csv_row& add(const std::string& name, std::integral auto value) { return add(name, std::to_string(value)); }
  Csv_row& add(const std::string& name, double value)
  {
    if (value == 0 || !std::isfinite(value)) return add(name, kernel::shortest(value));
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 3);
    return add(name, kernel::shortest(unit < 1 ? std::round(value / unit) / std::round(1 / unit)
                                               : std::round(value / unit) * unit));
  }
  /// A field that this row has no value for.
  Csv_row& none(const std::string& name) { return add(name, std::string()); }

  /// What made the row.
  Csv_row& add_origin(std::uint64_t seed)
  {
    return add("seed", seed)
        .add("version", TETRACONE_VERSION)
        .add("compiler", compiler())
        .add("flags", compiler_flags())
        .add("processor", processor())
        .add("fcl", TETRACONE_FCL);
  }

  std::string header() const { return header_ + '\n'; }
  std::string line() const { return line_ + '\n'; }

 private:
  std::string header_, line_;
};

}  // namespace tetracone::experiments

#endif
