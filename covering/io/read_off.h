#ifndef TETRACONE_COVERING_IO_READ_OFF_H
#define TETRACONE_COVERING_IO_READ_OFF_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// True when the line could be one more face: a count, and behind it an index below `vertices` for each corner.
inline bool is_face_line(const Text_lines& lines, std::size_t vertices)
{
  const auto corners = parse_count(lines.words()[0]);
  if (!corners || *corners == 0 || *corners > lines.words().size() - 1) return false;
  return std::all_of(lines.words().begin() + 1, lines.words().begin() + 1 + std::ptrdiff_t(*corners), [&](auto word) {
    const auto index = parse_count(word);
    return index && *index < vertices;
  });
}

/// Returns what an OFF text holds, or throws Input_error. '#' starts a comment anywhere. Its parts are, in order:
///
/// - the keyword OFF, which may be absent, with ST, C and N before it in any order;
/// - the counts of vertices, faces and (optionally) edges on one line;
/// - one line for each vertex;
/// - one line for each face.
///
/// Colours, normals and texture coordinates are skipped. Lines behind the last face are left out, with a note, unless
/// one could be a face.
///
/// CGAL's reader refuses or misreads these dialects, so it confirms none (see `Scan`):
///
/// - colours and texture coordinates, since it takes as many as the header promises;
/// - a count line without edges, or with 2^30 edges or more;
/// - counts that stick to the keyword, or a file without it;
/// - numbers of vertices that are not finite;
/// - faces of one or two corners.
inline Scan scan_off(const std::string& file, std::string_view text)
{
  Text_lines lines(file, text, '#');
  lines.need_next("expected the keyword OFF");
  std::vector<std::string_view> header = lines.words();
  Scan scan;
  bool textures = false, colours = false, normals = false;
  if (parse_count(header[0])) {
    scan.cgal_knows = false;
  } else {
    // The keyword and the digits that may stick to it.
    std::string_view prefix = header[0];
    const auto keyword_end = prefix.find("OFF");
    if (keyword_end == std::string_view::npos)
      lines.fail(in_quotes(header[0]) + " where the keyword should be",
                 "expected OFF, COFF, NOFF, CNOFF or ST before one of them");
    const std::string_view stuck = prefix.substr(keyword_end + 3);
    prefix = prefix.substr(0, keyword_end);
    const auto take = [&prefix](std::string_view word, bool& taken) {
      if (taken || !prefix.starts_with(word)) return false;
      prefix.remove_prefix(word.size());
      return taken = true;
    };
    while (take("ST", textures) || take("C", colours) || take("N", normals)) continue;
    if (!prefix.empty())
      lines.fail(in_quotes(header[0]) + " as keyword", "expected three plain coordinates: OFF, COFF, NOFF, STOFF");
    header.erase(header.begin());
    if (!stuck.empty()) header.insert(header.begin(), stuck);
    if (!header.empty() && header[0] == "BINARY") lines.fail("a binary OFF file", "expected OFF as text");
    scan.cgal_knows = !textures && !colours && stuck.empty();
  }
  if (header.empty()) {
    lines.need_next("expected the counts of vertices, faces and edges");
    header = lines.words();
  }
  if (header.size() != 2 && header.size() != 3)
    lines.fail(std::to_string(header.size()) + " words as counts", "expected the counts of vertices, faces and edges");
  scan.cgal_knows = scan.cgal_knows && header.size() == 3;
  const std::size_t vertices = lines.count_ahead(header[0], "count of vertices", 6);  // "0 0 0" and a line's end
  const std::size_t faces = lines.count_ahead(header[1], "count of faces", 4);        // "1 0" and a line's end
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
    add_vertex(lines, 0, scan.soup.vertices, scan.unplaced);
    for (std::size_t k = 0; k < lines.words().size(); ++k)
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
    need_corners(lines, corners, 1);
    if (corners > lines.words().size() - 1)
      lines.fail("a face of " + std::to_string(corners) + " corners with " + std::to_string(lines.words().size() - 1) +
                     " numbers",
                 "expected an index for each corner");
    loop.clear();
    for (std::size_t k = 1; k <= corners; ++k) loop.push_back(vertex_index(lines, k, vertices));
    for (std::size_t k = corners + 1; k < lines.words().size(); ++k)
      if (!is_number_word(lines.words()[k]))
        lines.fail(in_quotes(lines.words()[k]) + " behind a face", "expected a number");
    add_face(scan, loop, [&] { return at_line(lines); });
  }
  Left_out behind;
  for (; lines.next(); behind.add(at_line(lines)))
    if (is_face_line(lines, vertices))
      lines.fail("more faces than the header counts", "expected the end of the file after " + std::to_string(vertices) +
                                                          " vertices and " + std::to_string(faces) + " faces");
  behind.note("lines behind the last face are left out", scan.notes);
  finish(scan);
  return scan;
}

}  // namespace tetracone::covering

#endif
