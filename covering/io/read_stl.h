#ifndef TETRACONE_COVERING_IO_READ_STL_H
#define TETRACONE_COVERING_IO_READ_STL_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

namespace tetracone::covering {

/// The unsigned integer of `bytes` at `text[at]`, least significant byte first. Requires that many bytes.
inline std::uint64_t little_endian(std::string_view text, std::size_t at, std::size_t bytes)
{
  std::uint64_t value = 0;
  for (std::size_t k = bytes; k-- > 0;) value = value << 8 | static_cast<unsigned char>(text[at + k]);
  return value;
}

/// Scans a binary STL: 80 bytes, the count of triangles, then 50 bytes a triangle and nothing behind them. Vertices are
/// the three corners of each triangle, not merged.
inline Scan scan_stl_binary(const std::string& file, std::string_view text)
{
  const auto fail = [&file](const std::string& wrong, const std::string& expected) {
    throw Input_error(file, 0, wrong, expected);
  };
  if (text.size() < 84)
    fail("no STL text, and only " + std::to_string(text.size()) + " bytes",
         "expected 'solid', or 84 bytes before the first triangle");
  const std::uint64_t triangles = little_endian(text, 80, 4);
  if (text.size() != 84 + 50 * triangles)
    fail("binary STL of " + std::to_string(triangles) + " triangles in " + std::to_string(text.size()) + " bytes",
         "expected " + std::to_string(84 + 50 * triangles) + " bytes");
  Scan scan;
  // CGAL reads the machine's own byte order.
  scan.cgal_knows = std::endian::native == std::endian::little;
  scan.soup.vertices.reserve(3 * triangles);
  scan.soup.reserve_faces(triangles, 3 * triangles);
  for (std::uint64_t t = 0; t < triangles; ++t) {
    const Index first = static_cast<Index>(scan.soup.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      kernel::Vertex vertex;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t at = 84 + 50 * t + 12 * (corner + 1) + 4 * axis;
        vertex[axis] = std::bit_cast<float>(static_cast<std::uint32_t>(little_endian(text, at, 4)));
        if (!std::isfinite(vertex[axis]))
          fail("triangle " + std::to_string(t) + " has a coordinate that is no finite number (byte " +
                   std::to_string(at) + ")",
               "expected finite numbers");
      }
      scan.soup.vertices.push_back(vertex);
    }
    scan.soup.add_polygon({first, first + 1, first + 2});
  }
  return scan;
}

/// Scans an STL text: `solid` blocks of `facet normal ... outer loop, three `vertex`, endloop, endfacet`, in any case
/// of letters. Normals must be there and are not used. Vertices are the three corners of each triangle, not merged.
/// CGAL is not asked about keywords in capitals, and about names that hold a keyword.
inline Scan scan_stl_text(const std::string& file, std::string_view text)
{
  Scan scan;
  Text_lines lines(file, text, '\0');
  const auto lower = [](std::string_view word) {
    std::string result(word);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
    return result;
  };
  const auto is = [&](std::size_t k, std::string_view keyword) {
    if (k >= lines.words().size() || lower(lines.words()[k]) != keyword) return false;
    scan.cgal_knows = scan.cgal_knows && lines.words()[k] == keyword;
    return true;
  };
  const auto need = [&](std::string_view keywords, bool whole) {
    lines.need_next("expected " + in_quotes(keywords));
    std::size_t k = 0;
    for (std::size_t begin = 0; begin <= keywords.size(); ++k) {
      const std::size_t end = std::min(keywords.find(' ', begin), keywords.size());
      if (!is(k, keywords.substr(begin, end - begin)))
        lines.fail(in_quotes(lines.words()[0]) + " where a triangle goes on", "expected " + in_quotes(keywords));
      begin = end + 1;
    }
    if (whole && k != lines.words().size())
      lines.fail(in_quotes(lines.words()[k]) + " behind " + in_quotes(keywords), "expected the end of the line");
  };
  const auto name = [&] {
    // CGAL takes a name's words for keywords.
    for (std::size_t k = 1; k < lines.words().size(); ++k)
      for (const char* keyword : {"solid", "facet", "endsolid"})
        if (lines.words()[k] == keyword) scan.cgal_knows = false;
  };
  bool in_solid = false;
  while (true) {
    if (!in_solid) {
      if (!lines.next()) break;
      if (!is(0, "solid")) lines.fail(in_quotes(lines.words()[0]) + " outside a solid", "expected 'solid'");
      name();
      in_solid = true;
      continue;
    }
    lines.need_next("expected 'endsolid'");
    if (is(0, "endsolid")) {
      name();
      in_solid = false;
      continue;
    }
    if (!is(0, "facet")) lines.fail(in_quotes(lines.words()[0]) + " in a solid", "expected 'facet' or 'endsolid'");
    if (!is(1, "normal") || lines.words().size() != 5 ||
        !std::all_of(lines.words().begin() + 2, lines.words().end(), is_number_word))
      lines.fail("'facet' without a normal", "expected 'facet normal' and three numbers");
    need("outer loop", true);
    const Index first = static_cast<Index>(scan.soup.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      need("vertex", false);
      if (lines.words().size() != 4)
        lines.fail("a vertex of " + std::to_string(lines.words().size() - 1) + " numbers", "expected 3");
      scan.soup.vertices.push_back(lines.point(1));
    }
    need("endloop", true);
    need("endfacet", true);
    scan.soup.add_polygon({first, first + 1, first + 2});
  }
  if (lines.line() == 0) lines.fail("the file is empty", "expected 'solid'");
  return scan;
}

/// Whether the size is the one that a binary STL file's count of triangles asks for.
inline bool has_size_of_binary_stl(std::string_view text)
{
  return text.size() >= 84 && text.size() == 84 + 50 * little_endian(text, 80, 4);
}

/// Scans an STL file: binary where its size is the one that its count of triangles asks for, else text where it begins
/// with `solid` and holds no zero byte, else a binary file that is broken.
inline Scan scan_stl(const std::string& file, std::string_view text)
{
  if (text.empty()) throw Input_error(file, 0, "the file is empty", "expected an STL file");
  if (has_size_of_binary_stl(text)) {
    Scan scan = scan_stl_binary(file, text);
    // CGAL tries such a file as text first.
    scan.cgal_knows = scan.cgal_knows && text.find("facet") == std::string_view::npos;
    return scan;
  }
  const auto begin = std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size());
  const std::string_view start = text.substr(begin, 5);
  const bool solid = start.size() == 5 && std::ranges::equal(start, std::string_view("solid"),
                                                             [](char a, char b) { return (a | 0x20) == b; });
  return solid && text.find('\0') == std::string_view::npos ? scan_stl_text(file, text) : scan_stl_binary(file, text);
}

}  // namespace tetracone::covering

#endif
