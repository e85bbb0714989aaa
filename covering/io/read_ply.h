#ifndef TETRACONE_COVERING_IO_READ_PLY_H
#define TETRACONE_COVERING_IO_READ_PLY_H

#include "tetracone/covering/io/read_ply_header.h"
#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// The scalars of a PLY body, one after the other: words of text (an item is a line), or bytes.
class Ply_body {
 public:
  Ply_body(Text_lines& lines, std::string_view text, Ply_header::Format format)
      : lines_(lines), text_(text), format_(format), at_(lines.offset())
  {}

  bool is_text() const { return format_ == Ply_header::Format::text; }

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

  /// An integer of the type; it is in the type's range.
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

  /// A floating-point number of the type. As text: the double nearest to the decimal, whatever the type; where it is
  /// unused it may be nan or infinite, which is returned as nan.
  double floating(Ply_type type, std::string_view name, bool used)
  {
    double value = NAN;
    if (is_text()) {
      const std::string_view word = next_word(name);
      if (const auto number = parse_double(word))
        value = *number;
      else if (used || !is_number_word(word))
        fail(in_quotes(word) + " as " + std::string(name) + " of " + what(), "expected a finite decimal number");
      return value;
    }
    const std::uint64_t bits = bytes(type.bytes, name);
    value = type.bytes == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits)) : std::bit_cast<double>(bits);
    if (used && !std::isfinite(value))
      fail(std::string(name) + " of " + what() + " is no finite number", "expected finite coordinates");
    return value;
  }

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

  std::size_t bytes_left() const { return is_text() ? text_.size() : text_.size() - at_; }

  /// The item under way, as an error names it.
  std::string what() const { return element_->name + " " + std::to_string(item_); }

  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const
  {
    throw Input_error(lines_.file(), is_text() ? lines_.line() : 0, wrong, expected);
  }

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

/// Scans a PLY file, text or binary of either byte order: the element `vertex` (or `vertices`) with the properties x, y
/// and z, the element `face` (or `faces`) with the list vertex_indices (or vertex_index); properties in any order and
/// of any type, other elements and properties are skipped. A decimal of a text file is the double nearest to it, also
/// where the header calls it float (CGAL would round it to float first).
/// CGAL is not asked about indices that are neither int nor uint, coordinates or colours of integer or other types, the
/// element `halfedge`, numbers that are not finite in what is unused, and headers with the format not in line 2 or with
/// empty lines.
inline Scan scan_ply(const std::string& file, std::string_view text)
{
  Text_lines lines(file, text, '\0');
  const Ply_header header = scan_ply_header(lines);
  Scan scan;
  scan.cgal_knows = header.cgal_knows;

  const auto find = [&](const char* name, const char* other) {
    const auto named = [&](const char* wanted) {
      return std::ranges::find(header.elements, wanted, &Ply_element::name);
    };
    const auto first = named(name), second = named(other);
    if (first == header.elements.end() && second == header.elements.end())
      lines.fail(std::string("no element ") + name, "expected one in the header");
    if (first != header.elements.end() && second != header.elements.end())
      lines.fail(std::string("the elements ") + name + " and " + other, "expected one of them");
    return first != header.elements.end() ? first : second;
  };
  const auto vertex_element = find("vertex", "vertices");
  const auto face_element = find("face", "faces");
  const auto property = [&](const Ply_element& element, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(element.properties, name, &Ply_property::name) -
                                    element.properties.begin());
  };
  std::array<std::size_t, 3> axis{};
  for (int k = 0; k < 3; ++k) {
    const std::string name(1, "xyz"[k]);
    axis[k] = property(*vertex_element, name);
    const bool missing = axis[k] == vertex_element->properties.size() || vertex_element->properties[axis[k]].count;
    if (missing)
      throw Input_error(file, vertex_element->line, "vertices without a number " + name,
                        "expected the properties x, y and z");
    const Ply_type type = vertex_element->properties[axis[k]].type;
    if (type.kind != 'f') scan.cgal_knows = false;
    scan.single_coordinates = scan.single_coordinates || (header.format == Ply_header::Format::text && type.bytes == 4);
  }
  std::size_t corners = property(*face_element, "vertex_indices");
  if (corners == face_element->properties.size()) corners = property(*face_element, "vertex_index");
  if (corners == face_element->properties.size() || !face_element->properties[corners].count ||
      face_element->properties[corners].type.kind == 'f')
    throw Input_error(file, face_element->line, "faces without a list of vertex indices",
                      "expected the property vertex_indices");
  if (face_element->properties[corners].type.bytes != 4) scan.cgal_knows = false;
  for (const Ply_element& element : header.elements) {
    if (element.name == "halfedge") scan.cgal_knows = false;
    for (const Ply_property& each : element.properties)
      for (const char* colour : {"red", "green", "blue", "r", "g", "b"})
        if (each.name == colour && (each.count || each.type.kind != 'u' || each.type.bytes != 1))
          scan.cgal_knows = false;
    std::size_t least = 0;
    for (const Ply_property& each : element.properties)
      least += header.format == Ply_header::Format::text ? 2 : (each.count ? *each.count : each.type).bytes;
    if (element.items * least > lines.bytes_left() + 1)
      throw Input_error(file, element.line,
                        std::to_string(element.items) + " of " + in_quotes(element.name) + ", with " +
                            std::to_string(lines.bytes_left()) + " bytes behind the header",
                        "expected a count that the file can hold");
  }

  Ply_body body(lines, text, header.format);
  const auto scalar = [&](const Ply_type& type, std::string_view name, bool used) {
    if (type.kind != 'f') return static_cast<double>(body.integer(type, name));
    const double value = body.floating(type, name, used);
    if (body.is_text() && (!std::isfinite(value) || (type.bytes == 4 && std::abs(value) > FLT_MAX)))
      scan.cgal_knows = false;
    return value;
  };
  std::vector<Index> loop;
  // The header's counts are such as the file can hold.
  scan.soup.vertices.reserve(vertex_element->items);
  scan.soup.reserve_faces(face_element->items, 3 * face_element->items);
  for (auto element = header.elements.begin(); element != header.elements.end(); ++element) {
    std::vector<std::string> counts;
    for (const Ply_property& each : element->properties) counts.push_back("count of " + each.name);
    for (std::size_t item = 0; item < element->items; ++item) {
      body.begin_item(*element, item);
      kernel::Vertex vertex{};
      for (std::size_t p = 0; p < element->properties.size(); ++p) {
        const Ply_property& each = element->properties[p];
        if (!each.count) {
          const auto coordinate = std::ranges::find(axis, p) - axis.begin();
          const bool used = element == vertex_element && coordinate < 3;
          const double value = scalar(each.type, each.name, used);
          if (used) vertex[coordinate] = value;
          continue;
        }
        const bool is_face = element == face_element && p == corners;
        const std::int64_t count = body.integer(*each.count, counts[p]);
        if (count < 0 || static_cast<std::uint64_t>(count) > body.bytes_left())
          body.fail(std::to_string(count) + " as count of " + each.name + " of " + body.what(),
                    "expected a count that the file can hold");
        if (is_face && count < 3)
          body.fail(body.what() + " has " + std::to_string(count) + (count == 1 ? " corner" : " corners"),
                    "expected at least 3");
        loop.clear();
        for (std::int64_t k = 0; k < count; ++k) {
          if (!is_face) {
            scalar(each.type, each.name, false);
            continue;
          }
          const std::int64_t index = body.integer(each.type, "vertex index");
          if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_element->items)
            body.fail("vertex index " + std::to_string(index) + " in " + body.what() + " with " +
                          std::to_string(vertex_element->items) + " vertices",
                      "expected an index from 0 below that");
          loop.push_back(static_cast<Index>(index));
        }
        if (is_face) scan.soup.add_polygon(loop);
      }
      body.end_item();
      if (element == vertex_element) scan.soup.vertices.push_back(vertex);
    }
  }
  body.need_end();
  return scan;
}

}  // namespace tetracone::covering

#endif
