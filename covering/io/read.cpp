#include "tetracone/covering/io/read.h"

#include "tetracone/covering/io/file_bytes.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_obj.h"
#include "tetracone/covering/io/read_off.h"
#include "tetracone/covering/io/read_ply.h"
#include "tetracone/covering/io/read_poly.h"
#include "tetracone/covering/io/read_scan.h"
#include "tetracone/covering/io/read_stl.h"
#include "tetracone/kernel/number/floating_point.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace tetracone::covering {

namespace {

/// Returns a hash that is equal for equal vertices: 0 is equal to -0.
std::uint64_t hash_of(const Vertex& vertex)
{
  std::uint64_t hash = 0;
  for (const double x : vertex) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 29;
  }
  return hash;
}

/// Keeps each vertex once, at its first position, and returns the new number of each.
std::vector<Index> merge(std::vector<Vertex>& vertices)
{
  constexpr Index none = std::numeric_limits<Index>::max();
  const int bits = int(std::bit_width(vertices.size())) + 1;
  std::vector<Index> places(std::size_t(1) << bits, none), numbers(vertices.size());
  Index kept = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    std::size_t place = hash_of(vertices[v]) >> (64 - bits);
    while (places[place] != none && vertices[places[place]] != vertices[v]) place = (place + 1) & (places.size() - 1);
    if (places[place] == none) {
      places[place] = kept;
      vertices[kept++] = vertices[v];
    }
    numbers[v] = places[place];
  }
  vertices.resize(kept);
  vertices.shrink_to_fit();
  return numbers;
}

}  // namespace

Polyhedron merge_equal_vertices(Polyhedron polyhedron)
{
  const std::vector<Index> numbers = merge(polyhedron.vertices);
  polyhedron.renumber([&](Index v) { return numbers[v]; });
  return polyhedron;
}

namespace {

namespace cgal {

using Point = CGAL::Simple_cartesian<double>::Point_3;

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// Returns the polygon soup that CGAL reads from the text; nothing where CGAL refuses it.
std::optional<Soup> read(const std::string& suffix, std::string_view text)
try {
  std::istringstream in(std::string(text), std::ios::binary);
  Soup soup;
  const bool done = suffix == ".off"   ? CGAL::IO::read_OFF(in, soup.points, soup.polygons)
                    : suffix == ".obj" ? CGAL::IO::read_OBJ(in, soup.points, soup.polygons)
                    : suffix == ".ply" ? CGAL::IO::read_PLY(in, soup.points, soup.polygons)
                                       : CGAL::IO::read_STL(in, soup.points, soup.polygons);
  if (!done) return std::nullopt;
  return soup;
} catch (const std::exception&) {
  return std::nullopt;
}

/// True when CGAL's soup is the scanned one: the same counts, the same indices and, unless CGAL rounds to float, the
/// same coordinates.
bool agrees(const Soup& soup, const Polyhedron& scanned, bool compare_coordinates)
{
  if (soup.points.size() != scanned.vertices.size() || soup.polygons.size() != scanned.face_count()) return false;
  for (std::size_t v = 0; compare_coordinates && v < soup.points.size(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      if (soup.points[v][axis] != scanned.vertices[v][axis]) return false;
  for (Index f = 0; f < soup.polygons.size(); ++f)
    if (!std::ranges::equal(soup.polygons[f], scanned.loop(f, 0))) return false;
  return true;
}

}  // namespace cgal

/// The size of a file above which the scan's reading is not compared with CGAL's.
constexpr std::size_t most_for_cgal = 100'000'000;

/// Returns a note of how CGAL's reader differs on the text that was scanned as `polyhedron`; empty where it reads the
/// same.
std::string note_of_cgal(const std::string& suffix, std::string_view text, const Scan& scan,
                         const Polyhedron& polyhedron)
{
  if (text.size() > most_for_cgal) return "so large that CGAL's reader would take far longer: read by the scan alone";
  if (!scan.cgal_knows) return "a dialect that CGAL's reader does not take: read by the scan alone";
  const auto soup = cgal::read(suffix, text);
  if (!soup) return "CGAL's reader refuses the file: read by the scan alone";
  if (!cgal::agrees(*soup, polyhedron, !scan.single_coordinates))
    return "CGAL's reader finds something else in the file than the scan, which is the one that counts";
  return "";
}

}  // namespace

std::string suffix_of(const std::filesystem::path& path)
{
  std::string suffix = path.extension().native();
  std::ranges::transform(suffix, suffix.begin(),
                         [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return suffix;
}

namespace {

Read_model read_model(const std::filesystem::path& path, bool also_by_cgal)
{
  kernel::require_sound_floating_point();
  const std::string suffix = suffix_of(path);
  const std::string& file = path.native();
  const bool known = suffix == ".off" || suffix == ".obj" || suffix == ".ply" || suffix == ".stl" || suffix == ".poly";
  // A missing file is reported before an unknown suffix.
  std::error_code ignored;
  if (!known && std::filesystem::is_regular_file(path, ignored))
    throw Input_error(file, 0, (suffix.empty() ? "no suffix" : "unknown suffix " + in_quotes(suffix)),
                      "expected .off, .obj, .ply, .stl or .poly");
  const File_bytes bytes(path);
  std::string_view text = bytes.bytes();
  if (!known) throw Input_error(file, 0, "unknown suffix", "expected .off, .obj, .ply, .stl or .poly");
  if (text.empty()) throw Input_error(file, 0, "the file is empty", "expected a model");
  const bool is_utf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
  const bool binary = (suffix == ".stl" && (has_size_of_binary_stl(text) || !(is_utf16 || is_stl_text(text)))) ||
                      (suffix == ".ply" && is_binary_ply(text));
  std::string copied;
  if (!binary) text = copied = as_text(file, std::string(text));

  Read_model model;
  if (suffix == ".poly") {
    model = read_poly(path, text);
  } else {
    Scan scan = suffix == ".off"   ? scan_off(file, text)
                : suffix == ".obj" ? scan_obj(file, text)
                : suffix == ".ply" ? scan_ply(file, text)
                                   : scan_stl(file, text);
    model.notes = std::move(scan.notes);
    model.polyhedron = suffix == ".stl" ? merge_equal_vertices(std::move(scan.soup)) : std::move(scan.soup);
    if (model.polyhedron.face_count() != 0 && also_by_cgal) {
      const std::string note = note_of_cgal(suffix, text, scan, model.polyhedron);
      if (!note.empty()) model.notes.push_back(note);
    }
  }
  if (model.polyhedron.face_count() == 0) throw Input_error(file, 0, "no face", "expected a model with faces");
  model.name = path.filename().native();
  return model;
}

}  // namespace

Read_model read_model(const std::filesystem::path& path) { return read_model(path, true); }

Read_model read_with_notes(const std::filesystem::path& path) { return read_model(path, false); }

Polyhedron read(const std::filesystem::path& path) { return read_with_notes(path).polyhedron; }

}  // namespace tetracone::covering
