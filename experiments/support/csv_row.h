#ifndef TETRACONE_EXPERIMENTS_SUPPORT_CSV_ROW_H
#define TETRACONE_EXPERIMENTS_SUPPORT_CSV_ROW_H

#include "experiments/support/build_info.h"
#include "tetracone/kernel/number/number.h"

#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>

namespace tetracone::experiments {

/// A row of a CSV with its header: each field has a name. Numbers are written with four digits, counts in full.
class Csv_row {
 public:
  /// Adds a field, whose text is made safe by `field`.
  Csv_row& add(const std::string& name, const std::string& value) { return add_raw(name, field(value)); }
  Csv_row& add(const std::string& name, const char* value) { return add(name, std::string(value)); }
  Csv_row& add(const std::string& name, std::integral auto value) { return add(name, std::to_string(value)); }
  Csv_row& add(const std::string& name, double value)
  {
    if (value == 0 || !std::isfinite(value)) return add(name, kernel::shortest(value));
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 3);
    const double rounded = unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value / unit) * unit;
    // Near the ends of the doubles' range, the unit or its inverse is not a double.
    return add(name, kernel::shortest(unit > 0 && std::isfinite(rounded) && rounded != 0 ? rounded : value));
  }
  /// Adds the value, or an empty field for a missing one.
  Csv_row& add(const std::string& name, const std::optional<double>& value)
  {
    return value ? add(name, *value) : none(name);
  }
  /// Adds the shortest decimal that is read back as this double.
  Csv_row& add_exact(const std::string& name, double value) { return add(name, kernel::shortest(value)); }
  /// Adds an empty field for a missing value.
  Csv_row& none(const std::string& name) { return add(name, std::string()); }

  /// Adds the program and the processor that made the row, and the command line that makes it again.
  Csv_row& add_build()
  {
    return add("version", TETRACONE_VERSION)
        .add("compiler", compiler())
        .add("flags", compiler_flags())
        .add("processor", processor())
        .add_again();
  }
  /// Adds the command line that makes the row again, in quotes, since it may contain commas.
  Csv_row& add_again()
  {
    std::string quoted;
    for (const char c : again()) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return add_raw("again", '"' + quoted + '"');
  }
  /// Adds the seed and the fields of `add_build`.
  Csv_row& add_origin(std::uint64_t seed) { return add("seed", seed).add_build(); }

  /// Returns the names of the fields, or the fields, as a line with its end.
  std::string header() const { return header_ + '\n'; }
  std::string line() const { return line_ + '\n'; }

 private:
  Csv_row& add_raw(const std::string& name, const std::string& field)
  {
    const char* comma = header_.empty() ? "" : ",";
    header_ += comma + name;
    line_ += comma + field;
    return *this;
  }

  std::string header_, line_;
};

/// A CSV of rows, all of which must have the names of the first.
class Csv_table {
 public:
  void add(const Csv_row& row)
  {
    if (text_.empty()) text_ = row.header();
    text_ += row.line();
  }

  /// Returns the header and all rows; empty when there is no row.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace tetracone::experiments

#endif
