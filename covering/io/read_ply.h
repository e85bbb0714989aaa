#ifndef TETRACONE_COVERING_IO_READ_PLY_H
#define TETRACONE_COVERING_IO_READ_PLY_H

#include "tetracone/covering/io/read_ply_header.h"
#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// The scalars of a PLY body, one after the other: words of text (an item is a line), or bytes.
class Ply_body {
 public:
  Ply_body(Text_lines& lines, std::string_view text, Ply_header::Format format)
      : lines_(lines), text_(text), format_(format), at_(lines.offset())
  {}

  bool is_text() const { return format_ == Ply_header::Format::text; }

  /// Goes to an item of an element: in text, to its line. Throws Input_error at the end of the text.
  void begin_item(const Ply_element& element, std::size_t item)
  {
    element_ = &element;
    item_ = item;
    word_ = 0;
    if (is_text() && !element.properties.empty())
      lines_.need_next("expected " + what() + " of " + std::to_string(element.items));
  }

  void end_item()
  {
    if (is_text() && word_ != lines_.words().size() && word_ != 0)
      lines_.fail(std::to_string(lines_.words().size()) + " numbers in " + what(), "expected " + std::to_string(word_));
  }

  /// Returns the next scalar, an integer in the type's range. Throws Input_error for any other.
  std::int64_t integer(Ply_type type, std::string_view name)
  {
    if (!is_text()) {
      const std::uint64_t bits = bytes(type.bytes, name);
      const int unused = 64 - 8 * static_cast<int>(type.bytes);
      return type.kind == 'u' ? static_cast<std::int64_t>(bits) : static_cast<std::int64_t>(bits << unused) >> unused;
    }
    std::string_view word = next_word(name);
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    std::int64_t value = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const std::int64_t span = std::int64_t{1} << (8 * type.bytes - (type.kind == 'i' ? 1 : 0));
    if (rest != word.data() + word.size() || error != std::errc() || value >= span ||
        value < (type.kind == 'i' ? -span : 0))
      fail(in_quotes(word) + " as " + std::string(name) + " of " + what(), "expected an integer of its type");
    return value;
  }

  /// Returns the next scalar, of a floating-point type. In text it is the double nearest to the decimal, whatever the
  /// type, or nan where it is not finite. Throws Input_error for a word that is no number.
  double floating(Ply_type type, std::string_view name)
  {
    if (is_text()) {
      const std::string_view word = next_word(name);
      if (const auto number = parse_double(word)) return *number;
      if (!is_number_word(word))
        fail(in_quotes(word) + " as " + std::string(name) + " of " + what(), "expected a finite decimal number");
      return NAN;
    }
    const std::uint64_t bits = bytes(type.bytes, name);
    return type.bytes == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits)) : std::bit_cast<double>(bits);
  }

  /// True when the item's line of text has no more words.
  bool is_line_over() const { return is_text() && word_ == lines_.words().size(); }

  /// Refuses anything but white space behind the last item.
  void need_end()
  {
    if (is_text()) {
      if (lines_.next()) lines_.fail("more lines than the header counts", "expected the end of the file");
      return;
    }
    if (text_.find_first_not_of(" \t\r\n", at_) != std::string_view::npos)
      fail(std::to_string(text_.size() - at_) + " bytes behind the last element",
           "expected as many elements as the header counts");
  }

  std::size_t bytes_left() const { return is_text() ? text_.size() : text_.size() - at_; }  ///< upper bound

  /// Returns the name of the current item for an error.
  std::string what() const { return element_->name + " " + std::to_string(item_); }

  /// Returns the position of the current item for a note.
  std::string where() const { return is_text() ? at_line(lines_) : what(); }

  /// Returns an error at this position; without a line in a binary file.
  Input_error error(const std::string& wrong, const std::string& expected) const
  {
    return {lines_.file(), is_text() ? lines_.line() : 0, wrong, expected};
  }
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const { throw error(wrong, expected); }

 private:
  std::string_view next_word(std::string_view name)
  {
    if (word_ >= lines_.words().size())
      fail("the line ends before " + std::string(name) + " of " + what(), "expected a number");
    return lines_.words()[word_++];
  }

  std::uint64_t bytes(std::size_t count, std::string_view name)
  {
    if (count > text_.size() - at_)
      fail("the file ends before " + std::string(name) + " of " + what(),
           "expected as many elements as the header counts");
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t offset = format_ == Ply_header::Format::big_endian ? k : count - 1 - k;
      value = value << 8 | static_cast<unsigned char>(text_[at_ + offset]);
    }
    at_ += count;
    return value;
  }

  Text_lines& lines_;
  std::string_view text_;
  Ply_header::Format format_;
  std::size_t at_;
  std::size_t word_ = 0;
  const Ply_element* element_ = nullptr;
  std::size_t item_ = 0;
};

/// Appends the triangles of strips. Each index makes one with the two before it, in alternating directions, and -1 ends
/// a strip. A triangle that names a vertex twice only continues the strip, and is left out.
inline void add_triangle_strips(const std::vector<std::int64_t>& indices, Polyhedron& polyhedron)
{
  std::size_t begin = 0;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (indices[k] < 0) begin = k + 1;
    if (k < begin + 2) continue;
    std::array<Index, 3> corner{};
    for (int j = 0; j < 3; ++j) corner[j] = static_cast<Index>(indices[k - 2 + j]);
    if ((k - begin) % 2 == 1) std::swap(corner[0], corner[1]);
    if (corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0]) polyhedron.add_polygon(corner);
  }
}

/// The parts of a PLY file that make the model: the elements, and the positions of their properties.
struct Ply_parts {
  const Ply_element* vertex = nullptr;
  const Ply_element* face = nullptr;    ///< absent where there are strips
  const Ply_element* strips = nullptr;  ///< absent in most files
  std::array<std::size_t, 3> axis{};    ///< x, y and z of a vertex
  std::size_t corners = 0;              ///< the list of vertices of a face
  std::size_t strip = 0;                ///< the list of vertices of strips

  /// Returns how many properties of the element are read; the last of them is used.
  std::size_t used_properties(const Ply_element& element) const
  {
    if (&element == vertex) return *std::max_element(axis.begin(), axis.end()) + 1;
    if (&element == face) return corners + 1;
    return &element == strips ? strip + 1 : 0;
  }
};

/// Returns the position of the element's property of this name; the count of properties if there is none.
inline std::size_t find_property(const Ply_element& element, std::string_view name)
{
  return static_cast<std::size_t>(std::ranges::find(element.properties, name, &Ply_property::name) -
                                  element.properties.begin());
}

/// Returns the position of the element's list of vertices. Throws Input_error where it has none.
inline std::size_t find_corners(const std::string& file, const Ply_element& element)
{
  std::size_t corners = find_property(element, "vertex_indices");
  if (corners == element.properties.size()) corners = find_property(element, "vertex_index");
  if (corners == element.properties.size() || !element.properties[corners].count ||
      element.properties[corners].type.kind == 'f')
    throw Input_error(file, element.line, "faces without a list of vertex indices",
                      "expected the property vertex_indices");
  return corners;
}

/// Returns the parts. Records in the scan what CGAL does not take. Throws Input_error where one is missing.
inline Ply_parts find_ply_parts(const Text_lines& lines, const Ply_header& header, Scan& scan)
{
  const auto find = [&](const char* name, const char* other) -> const Ply_element* {
    const auto named = [&](const char* wanted) {
      return std::ranges::find(header.elements, wanted, &Ply_element::name);
    };
    const auto first = named(name), second = named(other);
    if (first != header.elements.end() && second != header.elements.end())
      lines.fail(std::string("the elements ") + name + " and " + other, "expected one of them");
    const auto found = first != header.elements.end() ? first : second;
    return found == header.elements.end() ? nullptr : &*found;
  };
  Ply_parts parts;
  parts.vertex = find("vertex", "vertices");
  parts.face = find("face", "faces");
  parts.strips = find("tristrips", "tristrip");
  if (!parts.vertex) lines.fail("no element vertex", "expected one in the header");
  if (!parts.face && !parts.strips) lines.fail("no element face", "expected one in the header");
  for (int k = 0; k < 3; ++k) {
    const std::string name(1, "xyz"[k]);
    parts.axis[k] = find_property(*parts.vertex, name);
    const auto& properties = parts.vertex->properties;
    if (parts.axis[k] == properties.size() || properties[parts.axis[k]].count)
      throw Input_error(lines.file(), parts.vertex->line, "vertices without a number " + name,
                        "expected the properties x, y and z");
    const Ply_type type = properties[parts.axis[k]].type;
    if (type.kind != 'f') scan.cgal_knows = false;
    scan.single_coordinates = scan.single_coordinates || (header.format == Ply_header::Format::text && type.bytes == 4);
  }
  if (parts.face) {
    parts.corners = find_corners(lines.file(), *parts.face);
    if (parts.face->properties[parts.corners].type.bytes != 4) scan.cgal_knows = false;
  }
  if (parts.strips) {
    parts.strip = find_corners(lines.file(), *parts.strips);
    scan.cgal_knows = false;
  }
  return parts;
}

/// Returns what a PLY file holds, text or binary of either byte order. Other elements and properties than these are
/// skipped; properties may be in any order and of any type.
///
/// - element `vertex` (or `vertices`): the properties x, y and z.
/// - element `face` (or `faces`): the list vertex_indices (or vertex_index).
/// - element `tristrips`: such a list.
///
/// A decimal of a text file is read as the double nearest to it, also where the header calls it float. (CGAL would
/// round it to float first.) A line of text may lack its last unused properties, with a note: VCGLIB promises colours
/// that it does not write.
///
/// These dialects are read by the scan alone, since CGAL's reader does not take them, or not as they are meant:
///
/// - strips, and the element `halfedge`;
/// - indices that are neither int nor uint;
/// - coordinates of integer types, and colours that are not uchar;
/// - coordinates that are not finite, and numbers of a text that are not finite or, as float, too large;
/// - lines without their last properties;
/// - faces of one or two corners, which are left out with a note;
/// - headers with empty lines, with carriage returns alone, or with the format not in line 2.
inline Scan scan_ply(const std::string& file, std::string_view text)
{
  std::string copied;
  const std::string_view given = text;
  text = with_line_feeds(text, copied);
  Text_lines lines(file, text, '\0');
  const Ply_header header = scan_ply_header(lines);
  Scan scan;
  scan.cgal_knows = header.cgal_knows && text.data() == given.data();
  const Ply_parts parts = find_ply_parts(lines, header, scan);
  for (const Ply_element& element : header.elements) {
    if (element.name == "halfedge") scan.cgal_knows = false;
    for (const Ply_property& each : element.properties)
      for (const char* colour : {"red", "green", "blue", "r", "g", "b"})
        if (each.name == colour && (each.count || each.type.kind != 'u' || each.type.bytes != 1))
          scan.cgal_knows = false;
    std::size_t least = 0;
    for (const Ply_property& each : element.properties)
      least += header.format == Ply_header::Format::text ? 2 : (each.count ? *each.count : each.type).bytes;
    if (header.format == Ply_header::Format::text) least = std::min(least, 2 * parts.used_properties(element));
    if (element.items * least > lines.bytes_left() + 1)
      throw Input_error(file, element.line,
                        std::to_string(element.items) + " of " + in_quotes(element.name) + ", with " +
                            std::to_string(lines.bytes_left()) + " bytes behind the header",
                        "expected a count that the file can hold");
  }

  Ply_body body(lines, text, header.format);
  const auto scalar = [&](const Ply_type& type, std::string_view name) {
    if (type.kind != 'f') return static_cast<double>(body.integer(type, name));
    const double value = body.floating(type, name);
    if (body.is_text() && (!std::isfinite(value) || (type.bytes == 4 && std::abs(value) > FLT_MAX)))
      scan.cgal_knows = false;
    return value;
  };
  std::vector<std::int64_t> indices;
  std::vector<Index> loop;
  Left_out unwritten;
  // The header's counts are such as the file can hold.
  scan.soup.vertices.reserve(parts.vertex->items);
  if (parts.face) scan.soup.reserve_faces(parts.face->items, 3 * parts.face->items);
  for (const Ply_element& element : header.elements) {
    std::vector<std::string> counts;
    for (const Ply_property& each : element.properties) counts.push_back("count of " + each.name);
    const std::size_t used_properties = parts.used_properties(element);
    const bool is_strips = &element == parts.strips;
    for (std::size_t item = 0; item < element.items; ++item) {
      body.begin_item(element, item);
      kernel::Vertex vertex{};
      bool is_placed = true, is_whole = true;
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Ply_property& each = element.properties[p];
        if (p >= used_properties && body.is_line_over()) {
          is_whole = false;
          break;
        }
        if (!each.count) {
          const double value = scalar(each.type, each.name);
          const auto coordinate = std::ranges::find(parts.axis, p) - parts.axis.begin();
          if (&element != parts.vertex || coordinate == 3) continue;
          vertex[coordinate] = value;
          if (std::isfinite(value) || !std::exchange(is_placed, false)) continue;
          scan.cgal_knows = false;
          scan.unplaced.add(
              static_cast<Index>(item),
              body.error(each.name + " of " + body.what() + " is no finite number", "expected finite coordinates"));
          continue;
        }
        const bool is_face = &element == parts.face && p == parts.corners, is_strip = is_strips && p == parts.strip;
        const std::int64_t count = body.integer(*each.count, counts[p]);
        if (count < 0 || static_cast<std::uint64_t>(count) > body.bytes_left())
          body.fail(std::to_string(count) + " as count of " + each.name + " of " + body.what(),
                    "expected a count that the file can hold");
        if (is_face && count == 0) body.fail(body.what() + " has 0 corners", "expected at least 3");
        indices.clear();
        for (std::int64_t k = 0; k < count; ++k) {
          if (!is_face && !is_strip) {
            if (body.is_line_over()) {
              is_whole = false;
              break;
            }
            scalar(each.type, each.name);
            continue;
          }
          const std::int64_t index = body.integer(each.type, "vertex index");
          // -1 ends a strip, also where the type has no sign.
          const bool is_end = is_strip && (index == -1 || index == std::numeric_limits<std::uint32_t>::max());
          if (!is_end && (index < 0 || static_cast<std::uint64_t>(index) >= parts.vertex->items))
            body.fail("vertex index " + std::to_string(index) + " in " + body.what() + " with " +
                          std::to_string(parts.vertex->items) + " vertices",
                      "expected an index from 0 below that");
          indices.push_back(is_end ? -1 : index);
        }
        if (is_strip) add_triangle_strips(indices, scan.soup);
        if (!is_face) continue;
        loop.assign(indices.begin(), indices.end());
        add_face(scan, loop, [&] { return body.where(); });
      }
      if (!is_whole) unwritten.add(body.where());
      body.end_item();
      if (&element == parts.vertex) scan.soup.vertices.push_back(is_placed ? vertex : kernel::Vertex{});
    }
  }
  body.need_end();
  unwritten.note("lines that lack properties of the header, which are not used", scan.notes);
  if (unwritten.count() != 0) scan.cgal_knows = false;
  finish(scan);
  return scan;
}

}  // namespace tetracone::covering

#endif
