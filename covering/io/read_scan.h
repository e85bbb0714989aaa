#ifndef TETRACONE_COVERING_IO_READ_SCAN_H
#define TETRACONE_COVERING_IO_READ_SCAN_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/text_lines.h"
#include "tetracone/covering/polyhedron.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace tetracone::covering {

using kernel::parse_double;

/// Points with coordinates that are not finite. They are legal where no face uses them.
class Unplaced_points {
 public:
  /// Adds a vertex; `error` is thrown if a face uses it.
  void add(Index vertex, const Input_error& error) { errors_.emplace_back(vertex, error); }

  /// Moves each unplaced point to a vertex of a face, with a note. Throws the error of the first that a face uses.
  void settle(Polyhedron& polyhedron, std::vector<std::string>& notes) const
  {
    if (errors_.empty() || polyhedron.face_count() == 0) return;
    std::vector<bool> used(polyhedron.vertices.size());
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k)
        for (const Index v : polyhedron.loop(f, k)) used[v] = true;
    for (const auto& [vertex, error] : errors_)
      if (used[vertex]) throw Input_error(error);
    const Index place = polyhedron.loop(0, 0)[0];
    for (const auto& [vertex, error] : errors_) polyhedron.vertices[vertex] = polyhedron.vertices[place];
    notes.push_back("points of no face whose coordinates are no finite numbers, each taken to be at vertex " +
                    std::to_string(place) + ": " + std::to_string(errors_.size()) + " (the first: vertex " +
                    std::to_string(errors_.front().first) + ")");
  }

 private:
  std::vector<std::pair<Index, Input_error>> errors_;
};

/// Things of one kind that a reader left out: their count, and the position of the first.
class Left_out {
 public:
  void add(const std::string& where)
  {
    if (count_++ == 0) first_ = where;
  }
  std::size_t count() const { return count_; }

  /// Adds a note if anything was left out: `WHAT: COUNT (the first: WHERE)`.
  void note(const std::string& what, std::vector<std::string>& notes) const
  {
    if (count_ != 0) notes.push_back(what + ": " + std::to_string(count_) + " (the first: " + first_ + ")");
  }

 private:
  std::size_t count_ = 0;
  std::string first_;
};

/// What a scan found in a file. CGAL's reader only confirms it, in `read_model`. Scans replace CGAL's readers. These
/// give no line numbers, trust a header's counts, and skip what they do not know. A scan refuses with an Input_error
/// the first thing that is wrong. It takes over everything else, or a note says what it left out.
struct Scan {
  Polyhedron soup;         ///< all vertices and faces in the file's order, each coordinate the nearest double
  bool cgal_knows = true;  ///< false: a legal dialect that CGAL's reader does not take, or takes for something else
  bool single_coordinates = false;  ///< CGAL rounds the coordinates to float before they become double
  std::vector<std::string> notes;   ///< what was left out, or is not as it is written; one sentence each
  Unplaced_points unplaced;         ///< vertices whose coordinates are no finite numbers
  Left_out short_faces;             ///< faces of one or two corners
};

/// True for any number, nan and infinity too, and for any word "1.#..." with or without a sign. Microsoft's runtime
/// wrote these up to 2013 ("-1.#IND", "1.#INF00"). A coordinate must be finite, but what is not used (a normal, a
/// colour, a quality) need not.
inline bool is_number_word(std::string_view word)
{
  if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
  if (word.starts_with("1.#")) return true;
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  return rest == end && error != std::errc::invalid_argument && !word.starts_with('-');
}

/// Appends the point of the words `k`, `k`+1 and `k`+2. A point that is not finite is legal while no face uses it.
inline void add_vertex(const Text_lines& lines, std::size_t k, std::vector<Vertex>& vertices, Unplaced_points& unplaced)
{
  try {
    vertices.push_back(lines.point(k));
  } catch (const Input_error& error) {
    const auto& words = lines.words();
    if (words.size() < k + 3 || !std::all_of(words.begin() + k, words.begin() + k + 3, is_number_word)) throw;
    unplaced.add(static_cast<Index>(vertices.size()), error);
    vertices.emplace_back();
  }
}

/// Refuses a face of fewer than `least` corners. The message always says 3, since fewer bound nothing.
inline void need_corners(const Text_lines& lines, std::uint64_t corners, std::uint64_t least = 3)
{
  if (corners < least)
    lines.fail("a face of " + std::to_string(corners) + (corners == 1 ? " corner" : " corners"), "expected at least 3");
}

/// Appends a face. A face of one or two corners has no area and bounds nothing, so it is left out, and `where()` says
/// where it was.
template <class Where>
void add_face(Scan& scan, const std::vector<Index>& loop, const Where& where)
{
  if (loop.size() >= 3) {
    scan.soup.add_polygon(loop);
    return;
  }
  scan.short_faces.add(where());
  scan.cgal_knows = false;
}

/// Returns "line 7" for the current line.
inline std::string at_line(const Text_lines& lines) { return "line " + std::to_string(lines.line()); }

/// Adds notes of everything that was left out, once all is read. Throws Input_error for a face's point that is not
/// finite.
inline void finish(Scan& scan)
{
  scan.unplaced.settle(scan.soup, scan.notes);
  scan.short_faces.note("faces of one or two corners are left out, and faces are numbered without them", scan.notes);
}

/// Returns word `k` of the line as a vertex number below `vertices`. Throws Input_error for any other word.
inline Index vertex_index(const Text_lines& lines, std::size_t k, std::size_t vertices)
{
  const std::uint64_t index = lines.count(k, "vertex index");
  if (index >= vertices)
    lines.fail("vertex index " + std::to_string(index) + " with " + std::to_string(vertices) + " vertices",
               vertices == 0 ? "expected vertices" : "expected 0 to " + std::to_string(vertices - 1));
  return static_cast<Index>(index);
}

}  // namespace tetracone::covering

#endif
