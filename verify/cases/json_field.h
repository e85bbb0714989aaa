#ifndef TETRACONE_VERIFY_CASES_JSON_FIELD_H
#define TETRACONE_VERIFY_CASES_JSON_FIELD_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/kernel/number/number.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// A parsed JSON text of a file. Throws covering::Input_error with the line if it is no JSON; `what` names the expected
/// contents.
struct Json_text {
  Json_text(std::string text, std::string file, const std::string& what);

  std::string text, file;
  nlohmann::json root;
};

/// A value of a JSON text that knows its position. Taking it as something else than it is throws covering::Input_error
/// with the line of the value and its path. Must not outlive the text.
class Json_field {
 public:
  explicit Json_field(const Json_text& text) : text_(&text), value_(&text.root) {}

  /// Throws Input_error at this value with a fault and the expectation.
  [[noreturn]] void fail(std::string_view wrong, std::string_view expected) const;

  /// Returns the member of an object; it must exist.
  Json_field member(const std::string& name) const;
  bool has(const std::string& name) const;

  /// Fails unless this is an object with these members and no others; each may be missing.
  void only(std::initializer_list<std::string_view> names) const;

  /// Returns the elements of an array, at least `least` or exactly `count`; `what` names them.
  std::vector<Json_field> items(std::size_t least, std::string_view what) const;
  std::vector<Json_field> exactly(std::size_t count, std::string_view what) const;

  /// Returns the members of an object with their names, in their order; at least one.
  std::vector<std::pair<std::string, Json_field>> members(std::string_view what) const;

  /// Returns a string of one line.
  std::string text() const;
  std::uint64_t unsigned_integer(std::uint64_t largest) const;
  int integer(int least, int largest) const;

  /// Returns a finite number exactly: a decimal means its nearest double, a string "n/d" that fraction.
  kernel::Rational rational() const;
  /// Returns such a number, which must be a double.
  double number() const;

  /// Returns the numbers if this is an array of N numbers, none of them a string: the results of `number`, but faster.
  template <std::size_t N>
  std::optional<std::array<double, N>> plain_numbers() const
  {
    if (!value_->is_array() || value_->size() != N) return std::nullopt;
    std::array<double, N> numbers;
    for (std::size_t k = 0; k < N; ++k) {
      if (!(*value_)[k].is_number()) return std::nullopt;
      numbers[k] = (*value_)[k].get<double>();
    }
    return numbers;
  }

  bool is_string() const { return value_->is_string(); }
  bool is_number() const { return value_->is_number(); }

 private:
  Json_field(const Json_field& parent, std::string step, const nlohmann::json& value)
      : text_(parent.text_), value_(&value), path_(parent.path_)
  {
    path_.push_back(std::move(step));
  }

  const Json_text* text_;
  const nlohmann::json* value_;
  std::vector<std::string> path_;  // names and numbers of members from the root
};

}  // namespace tetracone::verify

#endif
