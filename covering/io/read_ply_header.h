#ifndef TETRACONE_COVERING_IO_READ_PLY_HEADER_H
#define TETRACONE_COVERING_IO_READ_PLY_HEADER_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// A scalar type of a PLY file.
struct Ply_type {
  char kind;  ///< 'i' signed, 'u' unsigned, 'f' floating point
  std::size_t bytes;
};

/// Returns the type of this name; nothing for another word.
inline std::optional<Ply_type> ply_type(std::string_view word)
{
  struct Name {
    std::string_view old, sized;
    Ply_type type;
  };
  constexpr std::array names = {Name{"char", "int8", {'i', 1}},     Name{"uchar", "uint8", {'u', 1}},
                                Name{"short", "int16", {'i', 2}},   Name{"ushort", "uint16", {'u', 2}},
                                Name{"int", "int32", {'i', 4}},     Name{"uint", "uint32", {'u', 4}},
                                Name{"float", "float32", {'f', 4}}, Name{"double", "float64", {'f', 8}}};
  for (const Name& name : names)
    if (word == name.old || word == name.sized) return name.type;
  return std::nullopt;
}

/// A property of an element: a scalar or a list.
struct Ply_property {
  std::string name;
  Ply_type type;
  std::optional<Ply_type> count;                ///< the type of a list's count; nothing for a scalar
  std::string count_name = "count of " + name;  ///< for errors
};

/// An element of a PLY header, with its properties.
struct Ply_element {
  std::string name;
  std::size_t items;
  std::size_t line;  ///< its line in the header
  std::vector<Ply_property> properties;
};

/// The header of a PLY file.
struct Ply_header {
  enum class Format { text, little_endian, big_endian } format = Format::text;
  std::vector<Ply_element> elements;
  bool cgal_knows = true;  ///< as `Scan::cgal_knows`
};

/// Returns the text of a PLY file. Where carriage returns alone end the lines of its header, they become line feeds;
/// `copied` then holds the result. The bytes after the header are never changed.
inline std::string_view with_line_feeds(std::string_view text, std::string& copied)
{
  constexpr std::string_view end = "end_header";
  const std::size_t header = text.find(end);
  if (header == std::string_view::npos || text.substr(0, header).find('\n') != std::string_view::npos) return text;
  const std::size_t last = text.find_first_not_of(" \t", header + end.size());
  if (last == std::string_view::npos || text[last] != '\r') return text;
  copied = text;
  std::replace(copied.begin(), copied.begin() + std::ptrdiff_t(last) + 1, '\r', '\n');
  return copied;
}

/// True when a line of the header says that binary data follow.
inline bool is_binary_ply(std::string_view text)
{
  text = text.substr(0, text.find("end_header"));
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    Text_lines line("", text.substr(begin, end - begin), '\0');
    if (line.next() && line.words().size() > 1 && line.words()[0] == "format" && line.words()[1].starts_with("binary"))
      return true;
    begin = end + 1;
  }
  return false;
}

/// A reader of the lines of a PLY header. Its functions throw Input_error.
class Ply_header_scan {
 public:
  explicit Ply_header_scan(Text_lines& lines) : lines_(lines), words_(lines.words()) {}

  /// Returns the header, from the first line up to the line `end_header`.
  Ply_header operator()()
  {
    lines_.need_next("expected 'ply'");
    if (words_[0] != "ply" || words_.size() != 1)
      lines_.fail(in_quotes(words_[0]) + " where the keyword should be", "expected 'ply'");
    header_.cgal_knows = lines_.line() == 1;
    do {
      const std::size_t before = lines_.line();
      lines_.need_next("expected 'end_header'");
      // CGAL wants the format in the second line, and no empty one.
      if (lines_.line() != before + 1 || (!has_format_ && words_[0] != "format")) header_.cgal_knows = false;
    } while (add_line());
    return header_;
  }

 private:
  /// Adds the current line. Returns false for the last one.
  bool add_line()
  {
    const std::string_view keyword = words_[0];
    if (keyword == "end_header") {
      need_words(1, "'end_header' alone");
      if (!has_format_) lines_.fail("no line 'format'", "expected one in the header");
      return false;
    }
    if (keyword == "format")
      add_format();
    else if (keyword == "element")
      add_element();
    else if (keyword == "property")
      add_property();
    else if (keyword != "comment" && keyword != "obj_info")
      lines_.fail(in_quotes(keyword) + " in the header", "expected element, property, comment or end_header");
    return true;
  }

  void add_format()
  {
    need_words(3, "'format KIND 1.0'");
    using Format = Ply_header::Format;
    if (has_format_) lines_.fail("a second format", "expected one");
    if (words_[1] == "ascii")
      header_.format = Format::text;
    else if (words_[1] == "binary_little_endian")
      header_.format = Format::little_endian;
    else if (words_[1] == "binary_big_endian")
      header_.format = Format::big_endian;
    else
      lines_.fail(in_quotes(words_[1]) + " as format", "expected ascii, binary_little_endian or binary_big_endian");
    if (words_[2] != "1.0") lines_.fail(in_quotes(words_[2]) + " as version of the format", "expected 1.0");
    has_format_ = true;
  }

  void add_element()
  {
    need_words(3, "'element NAME COUNT'");
    const std::size_t items = lines_.count_ahead(words_[2], "count of " + in_quotes(words_[1]), 1);
    need_new(header_.elements, words_[1], "element");
    header_.elements.push_back({std::string(words_[1]), items, lines_.line(), {}});
  }

  void add_property()
  {
    if (header_.elements.empty()) lines_.fail("a property of no element", "expected 'element' first");
    const bool is_list = words_.size() > 1 && words_[1] == "list";
    if (is_list)
      need_words(5, "'property list TYPE TYPE NAME'");
    else
      need_words(3, "'property TYPE NAME'");
    std::vector<Ply_property>& properties = header_.elements.back().properties;
    need_new(properties, words_.back(), "property");
    Ply_property property{std::string(words_.back()), type(words_.size() - 2), std::nullopt};
    if (is_list) {
      property.count = type(2);
      if (property.count->kind == 'f')
        lines_.fail(in_quotes(words_[2]) + " as type of a count", "expected an integer type");
    }
    properties.push_back(property);
  }

  /// Refuses a line of another number of words.
  void need_words(std::size_t count, const char* form) const
  {
    if (words_.size() != count) lines_.fail(std::to_string(words_.size()) + " words", std::string("expected ") + form);
  }

  /// Refuses a name that one of `named`, each a `what`, has already.
  template <class Named>
  void need_new(const std::vector<Named>& named, std::string_view name, const char* what) const
  {
    for (const Named& other : named)
      if (other.name == name) lines_.fail(std::string("a second ") + what + " " + in_quotes(name), "expected one");
  }

  /// Returns the type that word `k` names.
  Ply_type type(std::size_t k) const
  {
    const auto found = ply_type(words_[k]);
    if (!found)
      lines_.fail(in_quotes(words_[k]) + " as type", "expected char, uchar, short, ushort, int, uint, float or double");
    return *found;
  }

  Text_lines& lines_;
  const std::vector<std::string_view>& words_;  // of the current line
  Ply_header header_;
  bool has_format_ = false;
};

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

}  // namespace tetracone::covering

#endif
