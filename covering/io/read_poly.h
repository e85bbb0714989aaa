#ifndef TETRACONE_COVERING_IO_READ_POLY_H
#define TETRACONE_COVERING_IO_READ_POLY_H

#include "tetracone/covering/io/read_model.h"
#include "tetracone/covering/io/read_scan.h"
#include "tetracone/covering/orient.h"
#include "tetracone/covering/projection.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// The nodes of a TetGen file: "count dimension attributes markers", then a line a node, "index x y z ...".
struct Poly_nodes {
  std::vector<kernel::Vertex> vertices;
  Unplaced_points unplaced;  ///< those whose coordinates are not finite
  std::uint64_t first = 0;   ///< the index of the first one: 0 or 1
};

/// Returns the nodes that begin on the next line. Throws Input_error.
inline Poly_nodes scan_poly_nodes(Text_lines& lines)
{
  Poly_nodes nodes;
  lines.need_next("expected the count of nodes, 3, and the counts of attributes and markers");
  const std::size_t count = lines.count_ahead(lines.words()[0], "count of nodes", 8);  // "1 0 0 0" and a line's end
  if (lines.words().size() > 1 && lines.count(1, "dimension") != 3)
    lines.fail(in_quotes(lines.words()[1]) + " as dimension", "expected 3");
  std::uint64_t extra = 0;
  for (std::size_t k = 2; k < lines.words().size(); ++k) {
    const std::uint64_t columns = lines.count(k, k == 2 ? "count of attributes" : "count of markers");
    if (k > 3 || columns > lines.bytes_left())
      lines.fail(in_quotes(lines.words()[k]) + " in the line of the nodes", "expected counts of columns");
    extra += columns;
  }
  nodes.vertices.reserve(count);
  for (std::size_t v = 0; v < count; ++v) {
    lines.need_next("node", v + 1, count);
    const std::uint64_t index = lines.count(0, "index of a node");
    if (v == 0 && index > 1) lines.fail("first node " + std::to_string(index), "expected 0 or 1");
    if (v == 0) nodes.first = index;
    if (index != nodes.first + v)
      lines.fail("node " + in_quotes(lines.words()[0]), "expected " + std::to_string(nodes.first + v));
    add_vertex(lines, 1, nodes.vertices, nodes.unplaced);
    if (lines.words().size() > 4 + extra)
      lines.fail("a node of " + std::to_string(lines.words().size()) + " numbers",
                 "expected at most " + std::to_string(4 + extra));
    for (std::size_t k = 4; k < lines.words().size(); ++k)
      if (!is_number_word(lines.words()[k])) lines.number(k, "attribute or marker");
  }
  return nodes;
}

/// Returns the polyhedron with each hole loop turned against its face's outer loop. The signs of their areas in the
/// projection of the outer loop decide. A loop of area 0 stays. Adds the number of loops turned to `count`.
inline Polyhedron turn_hole_loops(const Polyhedron& polyhedron, std::size_t& count)
{
  Polyhedron result;
  result.vertices = polyhedron.vertices;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    auto loops = face_loops(polyhedron, f);
    if (loops.size() > 1) {
      const int axis = projection_axis(polyhedron, loops[0]);
      const auto sign = [&](const Loop& loop) { return sgn(projected_area(polyhedron, loop, axis)); };
      const int outer = sign(loops[0]);
      for (std::size_t k = 1; k < loops.size(); ++k)
        if (sign(loops[k]) * outer > 0) {
          std::ranges::reverse(loops[k]);
          ++count;
        }
    }
    result.add_face(loops);
  }
  return result;
}

/// Reads a list behind the facets: a line with its count, then a line each, which begins with its index. The indices
/// ascend from 0 or 1. Returns the count, 0 at the end of the file. Throws Input_error, as for facets that the file
/// does not count.
inline std::size_t scan_poly_list(Text_lines& lines, const std::string& what, bool are_points)
{
  if (!lines.next()) return 0;
  if (are_points && lines.words().size() != 1)
    lines.fail(std::to_string(lines.words().size()) + " words behind the last facet that is counted",
               "expected the count of " + what + "s alone, or the end of the file");
  const std::size_t count = lines.count_ahead(lines.words()[0], "count of " + what + "s", are_points ? 8 : 2);
  std::uint64_t first = 0;
  for (std::size_t k = 0; k < count; ++k) {
    lines.need_next(what, k + 1, count);
    const std::uint64_t index = lines.count(0, "index of a " + what);
    if (k == 0) first = index;
    if (first > 1 || index != first + k)
      lines.fail(what + " " + in_quotes(lines.words()[0]),
                 k == 0 ? "expected 0 or 1" : "expected " + std::to_string(first + k));
    if (!are_points) continue;
    lines.point(1);
    if (lines.words().size() > 4)
      lines.fail("a " + what + " of " + std::to_string(lines.words().size()) + " numbers", "expected 4");
  }
  return count;
}

/// Reads the facets into `model`, and what is behind them. It checks the hole points and regions of the volume and
/// drops them, with a note. Throws Input_error.
inline void scan_poly_facets(Text_lines& lines, const Poly_nodes& nodes, Read_model& model)
{
  Polyhedron& polyhedron = model.polyhedron;
  polyhedron.vertices = nodes.vertices;
  lines.need_next("expected the count of facets");
  const std::size_t facets = lines.count_ahead(lines.words()[0], "count of facets", 4);
  std::vector<std::vector<Index>> loops;
  for (std::size_t f = 0; f < facets; ++f) {
    lines.need_next("facet", f + 1, facets);
    const std::size_t polygons = lines.count_ahead(lines.words()[0], "count of polygons", 2);
    const std::size_t holes = lines.words().size() > 1 ? lines.count_ahead(lines.words()[1], "count of holes", 8) : 0;
    for (std::size_t k = 2; k < lines.words().size(); ++k) lines.number(k, "marker of a facet");
    if (polygons == 0) lines.fail("a facet of no polygon", "expected at least 1");
    if (holes != polygons - 1)
      lines.fail(std::to_string(polygons) + " polygons and " + std::to_string(holes) + " hole points in a facet",
                 "expected the outer polygon first, and one hole point for each other");
    loops.clear();
    for (std::size_t k = 0; k < polygons; ++k) {
      lines.need_next("expected polygon " + std::to_string(k + 1) + " of facet " + std::to_string(f + 1));
      const std::uint64_t corners = lines.count(0, "count of corners");
      if (corners > lines.words().size() + lines.bytes_left())
        lines.fail(std::to_string(corners) + " as count of corners", "expected a count that the file can hold");
      need_corners(lines, corners);
      std::vector<Index> loop;
      for (std::size_t word = 1; loop.size() < corners; ++word) {
        // A long polygon may go on in the next line.
        if (word == lines.words().size()) {
          lines.need_next("corner", loop.size() + 1, corners);
          word = 0;
        }
        const std::uint64_t index = lines.count(word, "node of a polygon");
        if (index < nodes.first || index - nodes.first >= nodes.vertices.size())
          lines.fail("node " + std::to_string(index) + " with " + std::to_string(nodes.vertices.size()) + " nodes",
                     nodes.vertices.empty() ? "expected nodes"
                                            : "expected an index from " + std::to_string(nodes.first) + " to " +
                                                  std::to_string(nodes.first + nodes.vertices.size() - 1));
        loop.push_back(static_cast<Index>(index - nodes.first));
        if (loop.size() == corners && word + 1 != lines.words().size())
          lines.fail("more nodes than the polygon counts", "expected " + std::to_string(corners));
      }
      loops.push_back(loop);
    }
    for (std::size_t k = 0; k < holes; ++k) {
      lines.need_next("expected hole point " + std::to_string(k + 1) + " of facet " + std::to_string(f + 1));
      lines.point(1);
    }
    polyhedron.add_face(loops);
  }
  if (scan_poly_list(lines, "hole point", true) != 0)
    model.notes.push_back("hole points of the volume are not used: only the facets' directions make a cavity");
  if (scan_poly_list(lines, "region", false) != 0) model.notes.push_back("regions are not used");
  if (lines.next()) lines.fail("more lines than the counts say", "expected the end of the file");
}

/// Returns the model of a TetGen .poly file at `path` with the content `text`, without a name. Throws Input_error.
/// Indices count from 0 or 1 as the first node says; '#' starts a comment. The parts of the file are, in order:
///
/// - nodes; if there are none, they are in the .node file beside it;
/// - facets of one or more polygons, the first being the outer one, with a hole point for each other;
/// - hole points of the volume, which are not used, with a note;
/// - regions, which are not used, with a note.
///
/// The format orders neither facets nor hole loops. Loops stand as given where the directed edges then cancel.
/// Otherwise hole loops are turned against their outer loop. Where that is not enough, facets are oriented across their
/// edges (`orient_across_edges`). `Read_model::loops_turned` and `facets_turned` count both.
inline Read_model read_poly(const std::filesystem::path& path, std::string_view text)
{
  Read_model model;
  Text_lines lines(path.native(), text, '#');
  Poly_nodes nodes = scan_poly_nodes(lines);
  if (nodes.vertices.empty()) {
    const auto node_path = std::filesystem::path(path).replace_extension(".node");
    const std::string node_text = covering::read_text(node_path);
    Text_lines node_lines(node_path.native(), node_text, '#');
    nodes = scan_poly_nodes(node_lines);
    if (node_lines.next()) node_lines.fail("more lines than the first one counts", "expected the end of the file");
  }
  scan_poly_facets(lines, nodes, model);
  nodes.unplaced.settle(model.polyhedron, model.notes);
  std::size_t as_outer = 0;
  Polyhedron turned = turn_hole_loops(model.polyhedron, as_outer);
  if (is_closed(model.polyhedron)) {
    if (as_outer > 0)
      model.notes.push_back("hole loops that run as their outer loop does, which closes the surface: " +
                            std::to_string(as_outer));
    return model;
  }
  model.polyhedron = std::move(turned);
  model.loops_turned = as_outer;
  if (is_closed(model.polyhedron)) return model;
  Oriented oriented = orient_across_edges(model.polyhedron);
  model.facets_turned = oriented.turned.size();
  model.polyhedron = std::move(oriented.polyhedron);
  return model;
}

}  // namespace tetracone::covering

#endif
