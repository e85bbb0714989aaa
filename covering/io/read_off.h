#ifndef TETRACONE_COVERING_IO_READ_OFF_H
#define TETRACONE_COVERING_IO_READ_OFF_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// Scans an OFF text: [ST][C][N]OFF, then the counts of vertices, faces and (optionally) edges on one line, then a line
/// a vertex and a line a face. '#' starts a comment anywhere. Colours, normals and texture coordinates are skipped.
/// CGAL is not asked about colours and texture coordinates (it takes as many as the header lets it hope for), about a
/// count line without edges, and about counts that stick to the keyword.
inline Scan scan_off(const std::string& file, std::string_view text)
{
  Text_lines lines(file, text, '#');
  lines.need_next("expected the keyword OFF");
  std::vector<std::string_view> header = lines.words();

  // The keyword and the digits that may stick to it.
  std::string_view prefix = header[0];
  const auto keyword_end = prefix.find("OFF");
  if (keyword_end == std::string_view::npos)
    lines.fail(in_quotes(header[0]) + " where the keyword should be",
               "expected OFF, COFF, NOFF, CNOFF or ST before one of them");
  const std::string_view stuck = prefix.substr(keyword_end + 3);
  prefix = prefix.substr(0, keyword_end);
  const auto take = [&prefix](std::string_view word) {
    const bool found = prefix.starts_with(word);
    if (found) prefix.remove_prefix(word.size());
    return found;
  };
  const bool textures = take("ST"), colours = take("C"), normals = take("N");
  if (!prefix.empty())
    lines.fail(in_quotes(header[0]) + " as keyword", "expected three plain coordinates: OFF, COFF, NOFF, STOFF");
  header.erase(header.begin());
  if (!stuck.empty()) header.insert(header.begin(), stuck);
  if (!header.empty() && header[0] == "BINARY") lines.fail("a binary OFF file", "expected OFF as text");

  Scan scan;
  scan.cgal_knows = !textures && !colours && stuck.empty();
  const bool same_line = !header.empty();
  if (!same_line) {
    lines.need_next("expected the counts of vertices, faces and edges");
    header = lines.words();
  }
  if (header.size() != 2 && header.size() != 3)
    lines.fail(std::to_string(header.size()) + " words as counts", "expected the counts of vertices, faces and edges");
  scan.cgal_knows = scan.cgal_knows && header.size() == 3;
  const std::size_t vertices = lines.count_ahead(header[0], "count of vertices", 6);  // "0 0 0" and a line's end
  const std::size_t faces = lines.count_ahead(header[1], "count of faces", 8);
  if (header.size() == 3) {
    // Nobody uses it, but CGAL reads it as an int.
    const std::uint64_t edges = lines.count(header[2], "count of edges");
    scan.cgal_knows = scan.cgal_knows && edges < (1u << 30);
  }

  scan.soup.vertices.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    lines.need_next("vertex", v, vertices);
    const std::size_t least = 3 + (normals ? 3 : 0) + (textures ? 2 : 0);
    if (lines.words().size() < least)
      lines.fail("a vertex of " + std::to_string(lines.words().size()) + " numbers",
                 "expected " + std::to_string(least));
    scan.soup.vertices.push_back(lines.point(0));
    for (std::size_t k = 3; k < lines.words().size(); ++k)
      if (!is_number_word(lines.words()[k]))
        lines.fail(in_quotes(lines.words()[k]) + " behind a vertex", "expected a number");
      else if (!parse_double(lines.words()[k]))
        scan.cgal_knows = false;
  }
  scan.soup.reserve_faces(faces, 3 * faces);
  std::vector<Index> loop;
  for (std::size_t f = 0; f < faces; ++f) {
    lines.need_next("face", f, faces);
    const std::uint64_t corners = lines.count(0, "count of corners");
    need_corners(lines, corners);
    if (corners > lines.words().size() - 1)
      lines.fail("a face of " + std::to_string(corners) + " corners with " + std::to_string(lines.words().size() - 1) +
                     " numbers",
                 "expected an index for each corner");
    loop.clear();
    for (std::size_t k = 1; k <= corners; ++k) loop.push_back(vertex_index(lines, k, vertices));
    for (std::size_t k = corners + 1; k < lines.words().size(); ++k)
      if (!is_number_word(lines.words()[k]))
        lines.fail(in_quotes(lines.words()[k]) + " behind a face", "expected a number");
    scan.soup.add_polygon(loop);
  }
  if (lines.next())
    lines.fail("more lines than the header counts", "expected the end of the file after " + std::to_string(vertices) +
                                                        " vertices and " + std::to_string(faces) + " faces");
  return scan;
}

}  // namespace tetracone::covering

#endif
