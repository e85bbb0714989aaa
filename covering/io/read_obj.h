#ifndef TETRACONE_COVERING_IO_READ_OBJ_H
#define TETRACONE_COVERING_IO_READ_OBJ_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// The vertex number of a corner "v", "v/vt", "v/vt/vn" or "v//vn" of an OBJ face, as written (from 1, or negative).
/// The other numbers must be integers or missing; they are not used.
inline std::int64_t obj_corner(const Text_lines& lines, std::string_view corner)
{
  const auto integer = [](std::string_view word, std::int64_t& value) {
    const char* const end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, value);
    return rest == end && error == std::errc();
  };
  std::int64_t vertex = 0;
  std::string_view rest = corner;
  for (int field = 0; field < 3; ++field) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view word = rest.substr(0, slash);
    std::int64_t value = 0;
    if (!(integer(word, value) || (field > 0 && word.empty()))) break;
    if (field == 0) vertex = value;
    if (slash == rest.size()) return vertex;
    rest.remove_prefix(slash + 1);
  }
  lines.fail(in_quotes(corner) + " as corner of a face", "expected v, v/vt, v//vn or v/vt/vn in integers");
}

/// Scans a Wavefront OBJ text: the lines `v` and `f`; a face stays the polygon it is, its indices count from 1 or
/// backwards from the last vertex before it. A line that ends in a backslash goes on in the next. Statements that draw
/// something else (points, lines, curves, groups, materials) are skipped; unknown ones are refused.
/// A first line of two counts, of vertices and of faces, is taken too (FCL's files have it), and must be right.
/// CGAL is not asked about such a line, continued lines, white space other than blanks between corners, and statements
/// that it does not know (`l`, `call`, `csh`, `maplib`, `mg`).
inline Scan scan_obj(const std::string& file, std::string_view text)
{
  constexpr std::array skipped = {
      "vt",    "vn",        "vp",     "bevel", "lod",      "ctech",  "c_interp", "usemap",     "usemtl",
      "stech", "d_interp",  "mtllib", "o",     "g",        "s",      "p",        "shadow_obj", "cstype",
      "deg",   "step",      "bmat",   "con",   "curv",     "curv2",  "surf",     "parm",       "trim",
      "hole",  "trace_obj", "scrv",   "sp",    "end",      "surf_1", "q0_1",     "q1_1",       "curv2d_1",
      "bsp",   "surf_2",    "q0_2",   "q1_2",  "curv2d_2", "bzp",    "cdc",      "cdp",        "res"};
  constexpr std::array unknown_to_cgal = {"l", "call", "csh", "maplib", "mg"};

  Scan scan;
  auto& vertices = scan.soup.vertices;
  Text_lines lines(file, text, '\0');
  // A face may name vertices that come later; each index that is further ahead than all before it is settled at the
  // end.
  std::vector<std::pair<std::size_t, std::int64_t>> ahead;
  std::optional<std::array<std::uint64_t, 2>> counts;
  bool first_statement = true;
  std::vector<std::string> words;
  std::vector<Index> loop;
  // A comment begins a word: CGAL takes 'g#' for a statement.
  const auto append = [&words, &lines] {
    for (const std::string_view word : lines.words()) {
      if (word.starts_with('#')) return;
      words.emplace_back(word);
    }
  };
  while (lines.next()) {
    words.clear();
    append();
    while (!words.empty() && words.back().ends_with('\\')) {
      scan.cgal_knows = false;
      words.back().pop_back();
      if (words.back().empty()) words.pop_back();
      lines.need_next("expected the line that the backslash continues");
      append();
    }
    if (words.empty()) continue;
    if (std::exchange(first_statement, false) && words.size() == 2 && parse_count(words[0]) && parse_count(words[1])) {
      counts = {*parse_count(words[0]), *parse_count(words[1])};
      scan.cgal_knows = false;
      continue;
    }
    const std::string& statement = words[0];
    const auto is_statement = [&statement](std::string_view name) { return statement == name; };
    if (statement == "v") {
      // x y z, then nothing, a weight, a colour, or both; only curves use the weight.
      const std::size_t numbers = words.size() - 1;
      if (numbers < 3 || numbers == 5 || numbers > 7)
        lines.fail("a vertex of " + std::to_string(numbers) + " numbers",
                   "expected 3, and perhaps a weight and a colour");
      kernel::Vertex vertex{};
      for (std::size_t k = 0; k < numbers; ++k) {
        const auto value = parse_double(words[k + 1]);
        if (!value) lines.fail(in_quotes(words[k + 1]) + " as coordinate", "expected a finite decimal number");
        if (k < 3) vertex[k] = *value;
      }
      if (vertices.size() == std::numeric_limits<std::int32_t>::max())
        lines.fail("too many vertices", "expected less than 2^31");
      vertices.push_back(vertex);
    } else if (statement == "f") {
      need_corners(lines, words.size() - 1);
      loop.clear();
      for (std::size_t k = 1; k < words.size(); ++k) {
        const std::int64_t corner = obj_corner(lines, words[k]);
        const auto so_far = static_cast<std::int64_t>(vertices.size());
        const std::int64_t index = corner > 0 ? corner - 1 : so_far + corner;
        if (corner == 0 || index < 0 || index > std::numeric_limits<std::int32_t>::max())
          lines.fail("vertex index " + std::to_string(corner) + " after " + std::to_string(so_far) + " vertices",
                     "expected an index from 1, or from -1 down to the first vertex");
        if (index >= so_far && (ahead.empty() || ahead.back().second < index)) ahead.emplace_back(lines.line(), index);
        loop.push_back(static_cast<Index>(index));
      }
      // CGAL skips from an index to the next blank: any other white space hides the indices behind it.
      const std::string_view first = lines.words().front(), last = lines.words().back();
      const std::string_view row(first.data(), last.data() + last.size() - first.data());
      if (row.find_first_of("\t\r\v\f") != std::string_view::npos) scan.cgal_knows = false;
      scan.soup.add_polygon(loop);
    } else if (std::ranges::any_of(unknown_to_cgal, is_statement)) {
      scan.cgal_knows = false;
    } else if (std::ranges::none_of(skipped, is_statement)) {
      lines.fail(in_quotes(statement) + " as statement", "expected v, f or another statement of the format");
    }
  }
  for (const auto& [line, index] : ahead)
    if (index >= static_cast<std::int64_t>(vertices.size()))
      throw Input_error(
          file, line,
          "vertex index " + std::to_string(index + 1) + " with " + std::to_string(vertices.size()) + " vertices",
          "expected 1 to the number of vertices");
  if (counts && *counts != std::array<std::uint64_t, 2>{vertices.size(), scan.soup.face_count()})
    throw Input_error(
        file, 0, std::to_string(vertices.size()) + " vertices and " + std::to_string(scan.soup.face_count()) + " faces",
        "expected " + std::to_string((*counts)[0]) + " and " + std::to_string((*counts)[1]) +
            " as the first line counts");
  if (lines.line() == 0) lines.fail("the file is empty", "expected vertices and faces");
  return scan;
}

}  // namespace tetracone::covering

#endif
