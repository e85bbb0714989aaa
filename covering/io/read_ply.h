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
    const auto value = parse_integer<std::int64_t>(word);
    const std::int64_t span = std::int64_t{1} << (8 * type.bytes - (type.kind == 'i' ? 1 : 0));
    if (!value || *value >= span || *value < (type.kind == 'i' ? -span : 0))
      fail(in_quotes(word) + " as " + std::string(name) + " of " + what(), "expected an integer of its type");
    return *value;
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

/// True when CGAL's reader takes an element as it is meant: it has its colours as uchar, and no halfedges.
inline bool cgal_takes(const Ply_element& element)
{
  constexpr std::array<std::string_view, 6> colours = {"red", "green", "blue", "r", "g", "b"};
  return element.name != "halfedge" && std::ranges::none_of(element.properties, [&](const Ply_property& each) {
           const bool is_uchar = !each.count && each.type.kind == 'u' && each.type.bytes == 1;
           return !is_uchar && std::ranges::find(colours, each.name) != colours.end();
         });
}

/// Refuses an element of more items than the text behind the header can hold. A used property of a text takes 2 bytes
/// or more.
inline void need_room(const Text_lines& lines, const Ply_header& header, const Ply_parts& parts,
                      const Ply_element& element)
{
  std::size_t least = 0;
  if (header.format == Ply_header::Format::text)
    least = 2 * parts.used_properties(element);
  else
    for (const Ply_property& each : element.properties) least += each.count.value_or(each.type).bytes;
  if (element.items * least > lines.bytes_left() + 1)
    throw Input_error(lines.file(), element.line,
                      std::to_string(element.items) + " of " + in_quotes(element.name) + ", with " +
                          std::to_string(lines.bytes_left()) + " bytes behind the header",
                      "expected a count that the file can hold");
}

/// A reader of the items of a PLY body. Its functions throw Input_error.
class Ply_items {
 public:
  /// The arguments must outlive this object.
  Ply_items(const Ply_parts& parts, Ply_body& body, Scan& scan) : parts_(parts), body_(body), scan_(scan) {}

  /// Reads all items of an element into the scan. Requires the elements in the order of the header.
  void read(const Ply_element& element)
  {
    const std::size_t used_properties = parts_.used_properties(element);
    for (std::size_t item = 0; item < element.items; ++item) {
      body_.begin_item(element, item);
      vertex_ = {};
      is_placed_ = true;
      if (!read_properties(element, used_properties)) unwritten_.add(body_.where());
      body_.end_item();
      if (&element == parts_.vertex) scan_.soup.vertices.push_back(is_placed_ ? vertex_ : kernel::Vertex{});
    }
  }

  /// Refuses more than the header counts, and records the lines without their last properties.
  void finish()
  {
    body_.need_end();
    unwritten_.note("lines that lack properties of the header, which are not used", scan_.notes);
    if (unwritten_.count() != 0) scan_.cgal_knows = false;
  }

 private:
  /// Reads the properties of an item. Returns false where its line lacks some that are not used.
  bool read_properties(const Ply_element& element, std::size_t used_properties)
  {
    bool is_whole = true;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Ply_property& property = element.properties[p];
      if (p >= used_properties && body_.is_line_over()) return false;
      if (!property.count) {
        const double value = number(property);
        const auto axis = std::ranges::find(parts_.axis, p) - parts_.axis.begin();
        if (&element == parts_.vertex && axis != 3) set_coordinate(property.name, axis, value);
      } else if (&element == parts_.face && p == parts_.corners) {
        read_face(property);
      } else if (&element == parts_.strips && p == parts_.strip) {
        read_strips(property);
      } else {
        is_whole = skip_list(property) && is_whole;
      }
    }
    return is_whole;
  }

  /// Returns the next number, of a property or of a list that is not used. CGAL takes none that float cannot hold.
  double number(const Ply_property& property)
  {
    const Ply_type type = property.type;
    if (type.kind != 'f') return static_cast<double>(body_.integer(type, property.name));
    const double value = body_.floating(type, property.name);
    if (body_.is_text() && (!std::isfinite(value) || (type.bytes == 4 && std::abs(value) > FLT_MAX)))
      scan_.cgal_knows = false;
    return value;
  }

  void set_coordinate(const std::string& name, std::ptrdiff_t axis, double value)
  {
    vertex_[axis] = value;
    if (std::isfinite(value) || !std::exchange(is_placed_, false)) return;
    scan_.cgal_knows = false;
    scan_.unplaced.add(
        static_cast<Index>(scan_.soup.vertices.size()),
        body_.error(name + " of " + body_.what() + " is no finite number", "expected finite coordinates"));
  }

  void read_face(const Ply_property& corners)
  {
    const std::int64_t count = read_count(corners);
    if (count == 0) body_.fail(body_.what() + " has 0 corners", "expected at least 3");
    loop_.clear();
    for (std::int64_t k = 0; k < count; ++k) loop_.push_back(vertex(body_.integer(corners.type, "vertex index")));
    add_face(scan_, loop_, [&] { return body_.where(); });
  }

  void read_strips(const Ply_property& strip)
  {
    const std::int64_t count = read_count(strip);
    indices_.clear();
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t index = body_.integer(strip.type, "vertex index");
      // -1 ends a strip, also where the type has no sign.
      const bool is_end = index == -1 || index == std::numeric_limits<std::uint32_t>::max();
      indices_.push_back(is_end ? -1 : std::int64_t{vertex(index)});
    }
    add_triangle_strips(indices_, scan_.soup);
  }

  /// Reads a list that is not used. Returns false where its line is over before.
  bool skip_list(const Ply_property& list)
  {
    const std::int64_t count = read_count(list);
    for (std::int64_t k = 0; k < count; ++k) {
      if (body_.is_line_over()) return false;
      number(list);
    }
    return true;
  }

  std::int64_t read_count(const Ply_property& list)
  {
    const std::int64_t count = body_.integer(*list.count, list.count_name);
    if (count < 0 || static_cast<std::uint64_t>(count) > body_.bytes_left())
      body_.fail(std::to_string(count) + " as count of " + list.name + " of " + body_.what(),
                 "expected a count that the file can hold");
    return count;
  }

  /// Returns the vertex of this index.
  Index vertex(std::int64_t index) const
  {
    if (index < 0 || static_cast<std::uint64_t>(index) >= parts_.vertex->items)
      body_.fail("vertex index " + std::to_string(index) + " in " + body_.what() + " with " +
                     std::to_string(parts_.vertex->items) + " vertices",
                 "expected an index from 0 below that");
    return static_cast<Index>(index);
  }

  const Ply_parts& parts_;
  Ply_body& body_;
  Scan& scan_;
  kernel::Vertex vertex_{};  // of the current item
  bool is_placed_ = true;    // its coordinates so far are finite
  std::vector<Index> loop_;
  std::vector<std::int64_t> indices_;
  Left_out unwritten_;
};

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
  const Ply_header header = Ply_header_scan(lines)();
  Scan scan;
  scan.cgal_knows = header.cgal_knows && text.data() == given.data();
  const Ply_parts parts = find_ply_parts(lines, header, scan);
  for (const Ply_element& element : header.elements) {
    if (!cgal_takes(element)) scan.cgal_knows = false;
    need_room(lines, header, parts, element);
  }
  // The header's counts are such as the file can hold.
  scan.soup.vertices.reserve(parts.vertex->items);
  if (parts.face) scan.soup.reserve_faces(parts.face->items, 3 * parts.face->items);
  Ply_body body(lines, text, header.format);
  Ply_items items(parts, body, scan);
  for (const Ply_element& element : header.elements) items.read(element);
  items.finish();
  finish(scan);
  return scan;
}

}  // namespace tetracone::covering

#endif
