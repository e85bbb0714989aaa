#include "verify/cases/json_field.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tetracone::verify {
namespace {

std::size_t line_at(std::string_view text, std::size_t position)
{
  return 1 +
         std::size_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(std::min(position, text.size())), '\n'));
}

constexpr const char* blanks = " \t\r\n";

/// Returns the position behind the JSON string that begins at `at`.
std::size_t behind_string(std::string_view text, std::size_t at)
{
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return at + 1;
}

/// Finds the position of a value in a JSON text, which the parsed value does not know.
class Walk {
 public:
  Walk(std::string_view text, std::size_t from) : text_(text), at_(from) { skip_blanks(); }

  std::size_t position() const { return at_; }

  /// Moves from the start of an object or array to its member; false when its name is spelt in another way.
  bool enter(const std::string& step)
  {
    const bool object = text_[at_++] == '{';
    for (std::size_t k = 0;; ++k) {
      skip_blanks();
      if (at_ >= text_.size() || text_[at_] == '}' || text_[at_] == ']') return false;
      bool found = !object && std::to_string(k) == step;
      if (object) {
        const std::size_t begin = at_;
        at_ = behind_string(text_, at_);
        found = text_.substr(begin + 1, at_ - begin - 2) == step;
        at_ = text_.find(':', at_) + 1;
        skip_blanks();
      }
      if (found) return true;
      skip_value();
      skip_blanks();
      if (at_ < text_.size() && text_[at_] == ',') ++at_;
    }
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }

 private:
  void skip_value()
  {
    std::size_t depth = 0;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (depth == 0 && (c == ',' || c == '}' || c == ']')) return;
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      if (c == '"') at_ = behind_string(text_, at_) - 1;
    }
  }

  std::string_view text_;
  std::size_t at_;
};

std::size_t line_of(std::string_view text, const std::vector<std::string>& path)
{
  // A text with members starts with a bracket, perhaps after a byte order mark.
  Walk walk(text, path.empty() ? 0 : text.find_first_of("{["));
  for (const std::string& step : path)
    if (!walk.enter(step)) break;
  return line_at(text, walk.position());
}

/// Returns the position of a name that occurs twice in its object; nothing when all differ. Requires JSON, which for
/// the parser ends at its first zero byte.
std::optional<std::size_t> repeated_name(std::string_view text)
{
  std::vector<std::set<std::string>> names;  // of the objects and, empty, the arrays around
  text = text.substr(0, text.find('\0'));
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '{' || c == '[') names.emplace_back();
    if (c == '}' || c == ']') names.pop_back();
    if (c != '"') continue;
    const std::size_t end = behind_string(text, at), next = text.find_first_not_of(blanks, end);
    if (next < text.size() && text[next] == ':' &&
        !names.back().insert(nlohmann::json::parse(text.substr(at, end - at)).get<std::string>()).second)
      return at;
    at = end - 1;
  }
  return std::nullopt;
}

}  // namespace

Json_text::Json_text(std::string text_given, std::string file_given, const std::string& what)
    : text(std::move(text_given)), file(std::move(file_given))
{
  try {
    root = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw covering::Input_error(file, line_at(text, error.byte == 0 ? 0 : error.byte - 1), "is not JSON here",
                                "expected " + what + " as JSON");
  } catch (const nlohmann::json::exception& error) {
    // Any other error of parsing is a number beyond the doubles; the message has only its digits, in quotes.
    const std::string_view said = error.what();
    const std::size_t begin = said.find('\'') + 1;
    const std::string_view digits = said.substr(begin, said.rfind('\'') - begin);
    throw covering::Input_error(file, line_at(text, text.find(digits)),
                                covering::in_quotes(digits) + " is beyond the largest double",
                                "expected finite numbers");
  }
  if (const auto place = repeated_name(text))
    throw covering::Input_error(
        file, line_at(text, *place),
        covering::in_quotes(text.substr(*place + 1, behind_string(text, *place) - *place - 2)) + " a second time",
        "expected each name of an object once");
}

void Json_field::fail(std::string_view wrong, std::string_view expected) const
{
  std::string place;
  for (const std::string& step : path_) place += "/" + step;
  constexpr std::size_t longest = 80;
  if (place.size() > longest) place = place.substr(0, longest) + "...";
  throw covering::Input_error(text_->file, line_of(text_->text, path_),
                              (place.empty() ? "the file" : place) + " " + std::string(wrong), expected);
}

Json_field Json_field::member(const std::string& name) const
{
  if (!value_->is_object()) fail("is no object", "expected one with '" + name + "'");
  const auto found = value_->find(name);
  if (found == value_->end()) fail("has no '" + name + "'", "expected one");
  return {*this, name, *found};
}

bool Json_field::has(const std::string& name) const { return value_->is_object() && value_->contains(name); }

void Json_field::only(std::initializer_list<std::string_view> names) const
{
  if (!value_->is_object()) fail("is no object", "expected one");
  for (const auto& [name, value] : value_->items()) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    std::string known;
    for (const std::string_view each : names) known += (known.empty() ? "" : ", ") + std::string(each);
    Json_field(*this, name, value).fail("is unknown here", "expected only " + known);
  }
}

std::vector<Json_field> Json_field::items(std::size_t least, std::string_view what) const
{
  const std::string expected =
      (least == 0 ? "expected an array: " : "expected an array of at least " + std::to_string(least) + ": ") +
      std::string(what);
  if (!value_->is_array()) fail("is no array", expected);
  if (value_->size() < least) fail("has " + std::to_string(value_->size()) + " elements", expected);
  std::vector<Json_field> fields;
  for (std::size_t k = 0; k < value_->size(); ++k) fields.push_back(Json_field(*this, std::to_string(k), (*value_)[k]));
  return fields;
}

std::vector<Json_field> Json_field::exactly(std::size_t count, std::string_view what) const
{
  auto fields = items(0, what);
  if (fields.size() != count)
    fail("has " + std::to_string(fields.size()) + " elements",
         "expected " + std::to_string(count) + ": " + std::string(what));
  return fields;
}

std::vector<std::pair<std::string, Json_field>> Json_field::members(std::string_view what) const
{
  if (!value_->is_object() || value_->empty()) fail("is no object that has members", "expected " + std::string(what));
  std::vector<std::pair<std::string, Json_field>> members;
  for (const auto& [name, value] : value_->items()) members.emplace_back(name, Json_field(*this, name, value));
  return members;
}

std::string Json_field::text() const
{
  if (!value_->is_string()) fail("is no string", "expected a string");
  const auto text = value_->get<std::string>();
  if (std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    fail("has a control character", "expected one line");
  return text;
}

std::uint64_t Json_field::unsigned_integer(std::uint64_t largest) const
{
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() > largest)
    fail("is no such integer", "expected one from 0 to " + std::to_string(largest));
  return value_->get<std::uint64_t>();
}

int Json_field::integer(int least, int largest) const
{
  const bool fits = value_->is_number_unsigned()
                        ? value_->get<std::uint64_t>() <= std::uint64_t(std::max(largest, 0))
                        : value_->is_number_integer() && value_->get<std::int64_t>() <= largest;
  if (!fits || value_->get<std::int64_t>() < least)
    fail("is no such integer", "expected one from " + std::to_string(least) + " to " + std::to_string(largest));
  return value_->get<int>();
}

kernel::Rational Json_field::rational() const
{
  if (value_->is_number()) return kernel::Rational(value_->get<double>());
  std::optional<kernel::Rational> fraction;
  if (value_->is_string()) fraction = kernel::parse_fraction(value_->get_ref<const std::string&>());
  if (!fraction || !std::isfinite(kernel::nearest_double(*fraction)))
    fail("is no finite number", "expected a number or a string \"n/d\"");
  return *fraction;
}

double Json_field::number() const
{
  // The value does not go through a rational, so that -0.0 stays -0.0.
  if (value_->is_number()) return value_->get<double>();
  const kernel::Rational exact = rational();
  const double nearest = kernel::nearest_double(exact);
  if (kernel::Rational(nearest) != exact) fail("is no double", "expected one: only poses may have other rationals");
  return nearest;
}

}  // namespace tetracone::verify
