#ifndef TETRACONE_COVERING_IO_TEXT_LINES_H
#define TETRACONE_COVERING_IO_TEXT_LINES_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/kernel/number/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// Returns the status of a file that can be read to its end; a pipe can, too. Throws Input_error where there is no such
/// file, and for a folder or a device.
inline std::filesystem::file_status status_to_read(const std::filesystem::path& file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw Input_error(file.native(), 0, "no such file", "expected a file to read");
  if (std::filesystem::is_directory(status)) throw Input_error(file.native(), 0, "is a folder", "expected a file");
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
    throw Input_error(file.native(), 0, "is a device", "expected a file");
  return status;
}

/// Returns all bytes of a file. Throws Input_error as `status_to_read`, and where it cannot be read.
inline std::string read_bytes(const std::filesystem::path& file)
{
  const auto status = status_to_read(file);
  std::error_code error;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Input_error(file.native(), 0, "cannot be opened", "expected a file that may be read");
  std::string bytes;
  if (std::filesystem::is_regular_file(status)) bytes.reserve(std::filesystem::file_size(file, error));
  for (std::array<char, 1 << 16> some; in.read(some.data(), some.size()), in.gcount() > 0;)
    bytes.append(some.data(), std::size_t(in.gcount()));
  if (in.bad()) throw Input_error(file.native(), 0, "cannot be read to its end", "expected a file that may be read");
  return bytes;
}

/// Returns a text as all readers here take it. It has no UTF-8 byte order mark. Carriage returns that alone end lines
/// become line feeds. Throws Input_error for UTF-16.
inline std::string as_text(const std::string& file, std::string bytes)
{
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    throw Input_error(file, 0, "is text in UTF-16", "expected UTF-8 or ASCII");
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
  if (bytes.find('\n') == std::string::npos) std::ranges::replace(bytes, '\r', '\n');
  return bytes;
}

/// Returns the text of a file. Throws Input_error as `read_bytes` and `as_text` do.
inline std::string read_text(const std::filesystem::path& file) { return as_text(file.native(), read_bytes(file)); }

/// True when the character separates words of a line.
inline bool is_white(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Returns the decimal integer that the whole of `word` is. Nothing when it is none or does not fit.
template <class Integer>
std::optional<Integer> parse_integer(std::string_view word)
{
  Integer value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (rest != end || error != std::errc()) return std::nullopt;
  return value;
}

/// Returns the integer from 0 that the whole of `word` is. Nothing when it is none or does not fit.
inline std::optional<std::uint64_t> parse_count(std::string_view word) { return parse_integer<std::uint64_t>(word); }

/// The lines of a text that hold at least one word, each split into its words at white space, with its number. Every
/// error is thrown as an Input_error at the current line. The text must outlive this object.
class Text_lines {
 public:
  /// What follows the character `comment` on a line is skipped; '\0': no comments.
  Text_lines(std::string file, std::string_view text, char comment)
      : file_(std::move(file)), text_(text), comment_(comment)
  {}

  /// Goes to the next line with a word; false at the end of the text, where the current line is the last one.
  bool next()
  {
    words_.clear();
    while (rest_ < text_.size() && words_.empty()) {
      ++line_;
      const std::size_t end = std::min(text_.find('\n', rest_), text_.size());
      split(text_.substr(rest_, end - rest_));
      rest_ = std::min(end + 1, text_.size());
    }
    return !words_.empty();
  }

  /// Goes to the next line with a word. Throws at the end of the text; `expected` is the error's text of what should
  /// come.
  void need_next(std::string_view expected)
  {
    if (!next()) fail(line_ == 0 ? "the file is empty" : "the file ends here", expected);
  }
  /// Does the same. The error says that thing `number` of `count` should come, each a `what`.
  void need_next(std::string_view what, std::size_t number, std::size_t count)
  {
    if (next()) return;
    need_next("expected " + std::string(what) + " " + std::to_string(number) + " of " + std::to_string(count));
  }

  std::size_t line() const { return line_; }
  const std::string& file() const { return file_; }
  const std::vector<std::string_view>& words() const { return words_; }

  /// Returns where the next line begins, in bytes from the start of the text.
  std::size_t offset() const { return rest_; }
  std::size_t bytes_left() const { return text_.size() - rest_; }

  [[noreturn]] void fail(std::string_view wrong, std::string_view expected) const
  {
    throw Input_error(file_, line_, wrong, expected);
  }

  /// Returns word `k` as a finite number, the double nearest to the decimal. `what` names it.
  double number(std::size_t k, std::string_view what) const
  {
    if (k >= words_.size()) fail("the line ends before " + std::string(what), "expected a number");
    const auto value = kernel::parse_double(words_[k]);
    if (!value) fail(in_quotes(words_[k]) + " as " + std::string(what), "expected a finite decimal number");
    return *value;
  }

  /// Returns words `k`, `k`+1 and `k`+2 as a point.
  kernel::Vertex point(std::size_t k) const
  {
    return {number(k, "coordinate x"), number(k + 1, "coordinate y"), number(k + 2, "coordinate z")};
  }

  /// Returns a word as an integer from 0; `what` names it.
  std::uint64_t count(std::string_view word, std::string_view what) const
  {
    const auto value = parse_count(word);
    if (!value) fail(in_quotes(word) + " as " + std::string(what), "expected an integer from 0");
    return *value;
  }

  /// Returns word `k` as an integer from 0; `what` names it.
  std::uint64_t count(std::size_t k, std::string_view what) const
  {
    if (k >= words_.size()) fail("the line ends before " + std::string(what), "expected an integer");
    return count(words_[k], what);
  }

  /// Returns a word as a count of things in the lines that follow, each on at least `bytes` bytes. Throws where the
  /// text is too short for them, so that a wrong count reserves no memory.
  std::size_t count_ahead(std::string_view word, std::string_view what, std::size_t bytes) const
  {
    const std::uint64_t value = count(word, what);
    // The last line needs no end.
    if (value > (bytes_left() + 1) / bytes || value > std::numeric_limits<std::uint32_t>::max())
      fail(std::string(word) + " as " + std::string(what) + ", with " + std::to_string(bytes_left()) +
               " bytes left in the file",
           "expected a count that the file can hold");
    return value;
  }

 private:
  void split(std::string_view line)
  {
    if (comment_ != '\0') line = line.substr(0, line.find(comment_));
    for (std::size_t begin = 0, end = 0; begin < line.size(); begin = end) {
      while (begin < line.size() && is_white(line[begin])) ++begin;
      end = begin;
      while (end < line.size() && !is_white(line[end])) ++end;
      if (begin < end) words_.push_back(line.substr(begin, end - begin));
    }
  }

  std::string file_;
  std::string_view text_;
  char comment_;
  std::size_t rest_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace tetracone::covering

#endif
