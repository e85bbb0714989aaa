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
  std::optional<Ply_type> count;  ///< the type of a list's count; nothing for a scalar
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

/// Returns a PLY header, from the first line up to the line `end_header`. Throws Input_error.
inline Ply_header scan_ply_header(Text_lines& lines)
{
  Ply_header header;
  lines.need_next("expected 'ply'");
  if (lines.words()[0] != "ply" || lines.words().size() != 1)
    lines.fail(in_quotes(lines.words()[0]) + " where the keyword should be", "expected 'ply'");
  header.cgal_knows = lines.line() == 1;
  bool format_found = false;
  for (std::size_t before = lines.line();; before = lines.line()) {
    lines.need_next("expected 'end_header'");
    const auto& words = lines.words();
    // CGAL wants the format in the second line, and no empty one.
    if (lines.line() != before + 1 || (!format_found && words[0] != "format")) header.cgal_knows = false;
    const auto need = [&](std::size_t count, const char* form) {
      if (words.size() != count) lines.fail(std::to_string(words.size()) + " words", std::string("expected ") + form);
    };
    if (words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format") {
      need(3, "'format KIND 1.0'");
      using Format = Ply_header::Format;
      if (format_found) lines.fail("a second format", "expected one");
      if (words[1] == "ascii")
        header.format = Format::text;
      else if (words[1] == "binary_little_endian")
        header.format = Format::little_endian;
      else if (words[1] == "binary_big_endian")
        header.format = Format::big_endian;
      else
        lines.fail(in_quotes(words[1]) + " as format", "expected ascii, binary_little_endian or binary_big_endian");
      if (words[2] != "1.0") lines.fail(in_quotes(words[2]) + " as version of the format", "expected 1.0");
      format_found = true;
    } else if (words[0] == "element") {
      need(3, "'element NAME COUNT'");
      const std::size_t items = lines.count_ahead(words[2], "count of " + in_quotes(words[1]), 1);
      for (const Ply_element& element : header.elements)
        if (element.name == words[1]) lines.fail("a second element " + in_quotes(words[1]), "expected one");
      header.elements.push_back({std::string(words[1]), items, lines.line(), {}});
    } else if (words[0] == "property") {
      if (header.elements.empty()) lines.fail("a property of no element", "expected 'element' first");
      const bool list = words.size() > 1 && words[1] == "list";
      if (list)
        need(5, "'property list TYPE TYPE NAME'");
      else
        need(3, "'property TYPE NAME'");
      Ply_property property;
      property.name = words.back();
      for (const Ply_property& other : header.elements.back().properties)
        if (other.name == property.name) lines.fail("a second property " + in_quotes(words.back()), "expected one");
      const auto type = [&](std::size_t k) {
        const auto found = ply_type(words[k]);
        if (!found)
          lines.fail(in_quotes(words[k]) + " as type",
                     "expected char, uchar, short, ushort, int, uint, float or double");
        return *found;
      };
      property.type = type(words.size() - 2);
      if (list) {
        property.count = type(2);
        if (property.count->kind == 'f')
          lines.fail(in_quotes(words[2]) + " as type of a count", "expected an integer type");
      }
      header.elements.back().properties.push_back(property);
    } else if (words[0] == "end_header") {
      need(1, "'end_header' alone");
      if (!format_found) lines.fail("no line 'format'", "expected one in the header");
      return header;
    } else {
      lines.fail(in_quotes(words[0]) + " in the header", "expected element, property, comment or end_header");
    }
  }
}

}  // namespace tetracone::covering

#endif
