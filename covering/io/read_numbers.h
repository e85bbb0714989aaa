#ifndef TETRACONE_COVERING_IO_READ_NUMBERS_H
#define TETRACONE_COVERING_IO_READ_NUMBERS_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/text_lines.h"
#include "tetracone/kernel/number/number.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tetracone::covering {

/// A number of a pose or of a point: a decimal stands for the double nearest to it, a fraction "n/d" for itself.
struct Number {
  double nearest;
  std::optional<kernel::Rational> fraction;  ///< the exact value, where the word is a fraction

  kernel::Rational exact() const { return fraction ? *fraction : kernel::Rational(nearest); }
};

/// The text of a file of numbers, and its name in messages. `-` is standard input, which is read once.
class Number_text {
 public:
  /// Reads the file, and replaces each comma between two numbers of a line by a blank. Throws Input_error as
  /// `read_text`, for a comma that does not stand between two numbers, and where standard input was read before.
  explicit Number_text(const std::filesystem::path& file)
      : name_(file == "-" ? "standard input" : file.native()),
        text_(file == "-" ? as_text(name_, standard_input()) : read_text(file))
  {
    separate();
  }

 protected:
  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

 private:
  std::string standard_input() const
  {
    static std::atomic<bool> was_read = false;
    if (was_read.exchange(true)) throw Input_error(name_, 0, "is named twice", "expected '-' once");
    std::string bytes;
    std::array<char, 1 << 16> some;
    while (const std::size_t got = std::fread(some.data(), 1, some.size(), stdin)) bytes.append(some.data(), got);
    if (std::ferror(stdin) != 0) throw Input_error(name_, 0, "cannot be read to its end", "expected text");
    return bytes;
  }

  void separate()
  {
    std::size_t line = 1;
    bool behind_number = false, behind_comma = false, in_comment = false;
    const auto require = [&](bool holds) {
      if (!holds) throw Input_error(name_, line, "a comma without a number on either side", "expected one between two");
    };
    for (char& c : text_) {
      if (c == '\n' || c == '#') {
        require(!behind_comma);
        in_comment = c == '#';
        behind_number = false;
        line += c == '\n';
      } else if (!in_comment && c == ',') {
        require(behind_number);
        behind_number = false;
        behind_comma = true;
        c = ' ';
      } else if (!in_comment && !is_white(c)) {
        behind_number = true;
        behind_comma = false;
      }
    }
    require(!behind_comma);
  }

  std::string name_, text_;
};

/// The lines of a file of numbers separated by white space or commas. '#' starts a comment; blank lines are skipped.
class Number_lines : private Number_text, public Text_lines {
 public:
  /// Throws Input_error as `Number_text`.
  explicit Number_lines(const std::filesystem::path& file) : Number_text(file), Text_lines(name(), text(), '#') {}
  Number_lines(const Number_lines&) = delete;
  Number_lines& operator=(const Number_lines&) = delete;

  /// Returns the count of numbers on the current line, for messages.
  std::string found() const { return std::to_string(words().size()) + (words().size() == 1 ? " number" : " numbers"); }

  /// Returns word `k` as a number. Throws Input_error for any other word, and for a fraction beyond the largest double.
  Number number(std::size_t k) const
  {
    const std::string_view word = words()[k];
    if (const auto decimal = kernel::parse_double(word)) return {*decimal, std::nullopt};
    if (const auto fraction = kernel::parse_fraction(word)) {
      const double nearest = kernel::nearest_double(*fraction);
      if (std::isfinite(nearest)) return {nearest, fraction};
    }
    fail(in_quotes(word) + " as number " + std::to_string(k + 1), "expected a finite decimal number or a fraction n/d");
  }

  /// Returns the `N` numbers of the current line, which messages call `what`. Throws Input_error for any other line.
  template <std::size_t N>
  std::array<Number, N> numbers(const std::string& what) const
  {
    if (words().size() != N) fail(found(), "expected " + std::to_string(N) + ", " + what);
    std::array<Number, N> numbers;
    for (std::size_t k = 0; k < N; ++k) numbers[k] = number(k);
    return numbers;
  }
};

}  // namespace tetracone::covering

#endif
