#ifndef TETRACONE_COVERING_IO_READ_STL_H
#define TETRACONE_COVERING_IO_READ_STL_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// Returns the unsigned integer of `bytes` bytes at `text[at]`, least significant byte first. Requires that many bytes.
inline std::uint64_t little_endian(std::string_view text, std::size_t at, std::size_t bytes)
{
  std::uint64_t value = 0;
  for (std::size_t k = bytes; k-- > 0;) value = value << 8 | static_cast<unsigned char>(text[at + k]);
  return value;
}

/// True when the size is right for a binary STL file with its count of triangles.
inline bool has_size_of_binary_stl(std::string_view text)
{
  return text.size() >= 84 && text.size() == 84 + 50 * little_endian(text, 80, 4);
}

/// True when the text begins with a triangle as programs write it. Its numbers are finite, its normal has length 0 or
/// about 1, and its corners are not all in one place.
inline bool begins_with_triangle(std::string_view text)
{
  if (text.size() < 50) return false;
  std::array<float, 12> number;
  for (std::size_t k = 0; k < number.size(); ++k) {
    number[k] = std::bit_cast<float>(std::uint32_t(little_endian(text, 4 * k, 4)));
    if (!std::isfinite(number[k])) return false;
  }
  const auto corner = [&](std::size_t k) { return std::array{number[3 * k], number[3 * k + 1], number[3 * k + 2]}; };
  double square = 0;
  for (const float x : corner(0)) square += double(x) * double(x);
  // Normals may be rounded to few digits.
  const bool is_normal = square == 0 || (square > 0.99 && square < 1.01);
  return is_normal && !(corner(1) == corner(2) && corner(1) == corner(3));
}

/// The positions of the triangles of a binary STL, 50 bytes each, and notes of the bytes between and behind them.
struct Stl_layout {
  std::vector<std::size_t> begins;  ///< where they begin; none: one behind the other from byte 84 on
  std::uint64_t triangles = 0;
  std::vector<std::string> notes;
};

/// Returns the layout of a binary STL. The count may be 0, as by a writer that cannot go back to it: then the triangles
/// go up to the end. Each triangle may be followed by as many bytes of attributes as its last two bytes say. The last
/// triangle may be followed by other bytes, such as a line feed. Their number is no multiple of 50, they do not begin
/// with a triangle, and they are no binary STL of their own. Throws Input_error for any other size.
inline Stl_layout layout_of_binary_stl(const std::string& file, std::string_view text)
{
  if (text.size() < 84)
    throw Input_error(file, 0, "no STL text, and only " + std::to_string(text.size()) + " bytes",
                      "expected 'solid', or 84 bytes before the first triangle");
  const std::uint64_t counted = little_endian(text, 80, 4), size = text.size(), usual = 84 + 50 * counted;
  Stl_layout layout;
  layout.triangles = counted;
  if (size == usual) return layout;
  if (counted == 0 && (size - 84) % 50 == 0) {
    layout.triangles = (size - 84) / 50;
    layout.notes.push_back("the count of triangles is 0: those up to the end of the file are read, " +
                           std::to_string(layout.triangles));
    return layout;
  }
  if (size > usual) {
    std::size_t at = 84;
    for (std::uint64_t t = 0; t < counted && at + 50 <= size; ++t) {
      layout.begins.push_back(at);
      at += 50 + little_endian(text, at + 48, 2);
    }
    if (at == size && layout.begins.size() == counted) {
      layout.notes.push_back("bytes of attributes behind triangles are left out: " + std::to_string(size - usual));
      return layout;
    }
    layout.begins.clear();
    const std::string_view behind = text.substr(usual);
    if (counted != 0 && behind.size() % 50 != 0 && !has_size_of_binary_stl(behind) && !begins_with_triangle(behind)) {
      layout.notes.push_back("bytes behind the last triangle are left out: " + std::to_string(behind.size()));
      return layout;
    }
  }
  throw Input_error(file, 0,
                    "binary STL of " + std::to_string(counted) + " triangles in " + std::to_string(size) + " bytes",
                    "expected " + std::to_string(usual) + " bytes");
}

/// Returns the contents of a binary STL: 80 bytes, the count of triangles, then 50 bytes a triangle, laid out as
/// `layout_of_binary_stl` says. Vertices are the three corners of each triangle, not merged. Throws Input_error.
inline Scan scan_stl_binary(const std::string& file, std::string_view text)
{
  const Stl_layout layout = layout_of_binary_stl(file, text);
  Scan scan;
  scan.notes = layout.notes;
  // CGAL reads the machine's own byte order, and the usual layout.
  scan.cgal_knows = std::endian::native == std::endian::little && layout.notes.empty();
  scan.soup.vertices.reserve(3 * layout.triangles);
  scan.soup.reserve_faces(layout.triangles, 3 * layout.triangles);
  for (std::uint64_t t = 0; t < layout.triangles; ++t) {
    const Index first = static_cast<Index>(scan.soup.vertices.size());
    const std::size_t begin = layout.begins.empty() ? 84 + 50 * t : layout.begins[t];
    for (int corner = 0; corner < 3; ++corner) {
      kernel::Vertex vertex;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t at = begin + 12 * (corner + 1) + 4 * axis;
        vertex[axis] = std::bit_cast<float>(static_cast<std::uint32_t>(little_endian(text, at, 4)));
        if (!std::isfinite(vertex[axis]))
          throw Input_error(file, 0,
                            "triangle " + std::to_string(t) + " has a coordinate that is no finite number (byte " +
                                std::to_string(at) + ")",
                            "expected finite numbers");
      }
      scan.soup.vertices.push_back(vertex);
    }
    scan.soup.add_polygon({first, first + 1, first + 2});
  }
  return scan;
}

/// The words of an STL text, one after the other, whatever their lines. It also records whether keywords are written as
/// CGAL takes them.
class Stl_words {
 public:
  Stl_words(const std::string& file, std::string_view text) : lines_(file, text, '\0') {}

  /// Goes to the next word; false at the end of the text.
  bool next()
  {
    if (!is_kept_ && ++at_ >= lines_.words().size()) {
      if (!lines_.next()) return false;
      at_ = 0;
    }
    is_kept_ = false;
    return true;
  }
  /// Goes to the next word. Throws Input_error at the end of the text; `expected` is its text of what should come.
  void need_next(std::string_view expected)
  {
    if (!next()) lines_.need_next(expected);
  }
  /// Makes the current word come once more.
  void keep() { is_kept_ = true; }

  /// True when the current word is the keyword, in any case of letters. It records what `begins_with` does.
  bool is(std::string_view keyword) { return begins_with(keyword) && word().size() == keyword.size(); }
  /// True when the current word begins with the keyword, in any case of letters. It records a longer word, and capital
  /// letters. Requires a keyword in small letters.
  bool begins_with(std::string_view keyword)
  {
    const bool begins = std::ranges::equal(word().substr(0, keyword.size()), keyword,
                                           [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
    usual_ = usual_ && (!begins || word() == keyword);
    return begins;
  }

  /// Goes to the end of a name, which is the end of the line; a triangle may begin on it.
  void skip_name()
  {
    const std::size_t words = lines_.words().size();
    for (++at_; at_ < words; ++at_) {
      // CGAL takes a name's words for keywords.
      for (const char* keyword : {"solid", "facet", "endsolid"})
        if (word() == keyword) usual_ = false;
      if (!is("facet") || at_ + 1 == words) continue;
      ++at_;
      const bool is_facet = is("normal");
      --at_;
      if (is_facet) break;
    }
    if (at_ < words) keep();
  }

  std::string_view word() const { return lines_.words()[at_]; }
  const Text_lines& lines() const { return lines_; }
  /// Throws Input_error about the current word: the word in quotes, `what`, and what was expected.
  [[noreturn]] void fail(const std::string& what, const std::string& expected) const
  {
    lines_.fail(in_quotes(word()) + what, "expected " + expected);
  }

  /// True when all keywords so far are written as CGAL takes them.
  bool is_usual() const { return usual_; }
  /// Records a spelling that CGAL does not take.
  void be_unusual() { usual_ = false; }

 private:
  Text_lines lines_;
  std::size_t at_ = 0;
  bool is_kept_ = false;
  bool usual_ = true;
};

/// Reads the keywords. Throws Input_error with the one that was expected.
inline void need_stl_keywords(Stl_words& words, std::initializer_list<std::string_view> keywords)
{
  for (const std::string_view keyword : keywords) {
    words.need_next("expected " + in_quotes(keyword));
    if (!words.is(keyword)) words.fail(" where a triangle goes on", in_quotes(keyword));
  }
}

/// Reads `endloop` or `end loop` for `what` = "loop", and so on. Throws Input_error.
inline void need_stl_end(Stl_words& words, std::string_view what)
{
  const std::string keyword = "end" + std::string(what);
  words.need_next("expected " + in_quotes(keyword));
  if (words.is(keyword)) return;
  if (!words.is("end")) words.fail(" where a triangle goes on", in_quotes(keyword));
  words.be_unusual();
  need_stl_keywords(words, {what});
}

/// Reads a triangle behind its keyword `facet`. Throws Input_error.
inline void scan_stl_facet(Stl_words& words, Scan& scan)
{
  const auto fail_without_normal = [&] {
    words.lines().fail("'facet' without a normal", "expected 'facet normal' and three numbers");
  };
  words.need_next("expected 'normal'");
  if (!words.is("normal")) fail_without_normal();
  for (int axis = 0; axis < 3; ++axis) {
    words.need_next("expected three numbers of the normal");
    if (!is_number_word(words.word())) fail_without_normal();
  }
  need_stl_keywords(words, {"outer", "loop"});
  const Index first = static_cast<Index>(scan.soup.vertices.size());
  for (int corner = 0; corner < 3; ++corner) {
    need_stl_keywords(words, {"vertex"});
    kernel::Vertex vertex{};
    for (double& x : vertex) {
      words.need_next("expected three coordinates of a vertex");
      const auto value = parse_double(words.word());
      if (!value) words.fail(" as a coordinate", "a finite decimal number");
      x = *value;
    }
    scan.soup.vertices.push_back(vertex);
  }
  need_stl_end(words, "loop");
  need_stl_end(words, "facet");
  scan.soup.add_polygon({first, first + 1, first + 2});
}

/// Scans an STL text: `solid` blocks of `facet normal ... outer loop`, three `vertex`, `endloop`, `endfacet`. Letters
/// may be of any case, and lines are free. An `end` may stand apart (`end solid`), and a name may stick to `solid` and
/// `endsolid`. Normals must be there; they and colours (`color` and numbers) are not used. Vertices are the three
/// corners of each triangle, not merged. Other spellings than CGAL's own, and names that hold a keyword, are read by
/// the scan alone (`Scan::cgal_knows`). Throws Input_error.
inline Scan scan_stl_text(const std::string& file, std::string_view text)
{
  Scan scan;
  Stl_words words(file, text);
  bool in_solid = false;
  while (true) {
    if (!in_solid) {
      if (!words.next()) break;
      if (!words.begins_with("solid")) words.fail(" outside a solid", "'solid'");
      words.skip_name();
      in_solid = true;
      continue;
    }
    words.need_next("expected 'endsolid'");
    if (words.is("facet")) {
      scan_stl_facet(words, scan);
    } else if (words.begins_with("endsolid")) {
      words.skip_name();
      in_solid = false;
    } else if (words.is("end")) {
      words.be_unusual();
      need_stl_keywords(words, {"solid"});
      words.skip_name();
      in_solid = false;
    } else if (words.is("color")) {
      words.be_unusual();
      while (words.next())
        if (!is_number_word(words.word())) {
          words.keep();
          break;
        }
    } else {
      words.fail(" in a solid", "'facet' or 'endsolid'");
    }
  }
  if (words.lines().line() == 0) words.lines().fail("the file is empty", "expected 'solid'");
  scan.cgal_knows = words.is_usual();
  return scan;
}

/// True when the file is text. It begins with `solid`, in any case of letters, after white space and a UTF-8 byte order
/// mark, if any. It holds no zero byte, and does not have the size of a binary file with its count of triangles.
inline bool is_stl_text(std::string_view text)
{
  if (has_size_of_binary_stl(text)) return false;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const auto begin = std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size());
  const std::string_view start = text.substr(begin, 5);
  const bool solid = start.size() == 5 && std::ranges::equal(start, std::string_view("solid"),
                                                             [](char a, char b) { return (a | 0x20) == b; });
  return solid && text.find('\0') == std::string_view::npos;
}

/// Scans an STL file, text or binary. Throws Input_error.
inline Scan scan_stl(const std::string& file, std::string_view text)
{
  if (text.empty()) throw Input_error(file, 0, "the file is empty", "expected an STL file");
  if (is_stl_text(text)) return scan_stl_text(file, text);
  Scan scan = scan_stl_binary(file, text);
  // CGAL tries such a file as text first.
  scan.cgal_knows = scan.cgal_knows && text.find("facet") == std::string_view::npos;
  return scan;
}

}  // namespace tetracone::covering

#endif
