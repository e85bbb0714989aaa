#ifndef TETRACONE_COVERING_IO_READ_MOVING_PAIRS_H
#define TETRACONE_COVERING_IO_READ_MOVING_PAIRS_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/text_lines.h"
#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/number/number.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// A query of a file, the line at which it begins, and whether the file says that the primitives meet.
struct Moving_query {
  kernel::Moving_pair pair;
  std::size_t line = 0;
  std::optional<bool> truth;
};

/// Returns the kind that the folder of a file of queries is named after: `vertex-face` or `edge-edge`. Nothing for
/// another name.
inline std::optional<kernel::Moving_kind> moving_kind_of(const std::filesystem::path& file)
{
  const std::string folder = std::filesystem::absolute(file).lexically_normal().parent_path().filename().native();
  if (folder == "vertex-face") return kernel::Moving_kind::vertex_face;
  if (folder == "edge-edge") return kernel::Moving_kind::edge_edge;
  return std::nullopt;
}

namespace detail {

/// Returns the fields between the commas of the current line, without blanks around them.
inline std::vector<std::string> comma_fields(const Text_lines& lines)
{
  std::vector<std::string> fields(1);
  for (const std::string_view word : lines.words()) {
    if (!fields.back().empty()) fields.back() += ' ';
    for (const char c : word) {
      if (c == ',')
        fields.emplace_back();
      else
        fields.back() += c;
    }
  }
  for (std::string& field : fields)
    if (field.ends_with(' ')) field.pop_back();
  return fields;
}

/// Returns the double that equals the fraction of two fields. Throws Input_error where there is none.
inline double double_of_fraction(const Text_lines& lines, const std::string& numerator, const std::string& denominator)
{
  const std::string text = numerator + "/" + denominator;
  const auto fraction = kernel::parse_fraction(text);
  if (!fraction) lines.fail(in_quotes(text) + " as a coordinate", "expected integers, the denominator from 1");
  const double nearest = kernel::nearest_double(*fraction);
  if (!std::isfinite(nearest) || kernel::Rational(nearest) != *fraction)
    lines.fail(in_quotes(text) + " as a coordinate", "expected a fraction that is exactly a double");
  return nearest;
}

}  // namespace detail

/// Returns the queries of a file in the format of Wang et al., "A Large Scale Benchmark and an Inclusion-Based
/// Algorithm for Continuous Collision Detection", 2021. A query is eight lines: the four points at t = 0, then at t =
/// 1, as in Moving_pair. A line has numerator and denominator of x, y and z, separated by commas. A seventh field, 1 or
/// 0, may say whether the primitives meet.
///
/// Throws Input_error for another line, and for a coordinate that is no double. Throws it also where the lines of a
/// query differ in their answers, and where the file holds no query or ends within one.
inline std::vector<Moving_query> read_moving_pairs(const std::filesystem::path& file, kernel::Moving_kind kind)
{
  const std::string text = read_text(file);
  Text_lines lines(file.native(), text, '#');
  std::vector<Moving_query> queries;
  while (lines.next()) {
    Moving_query query;
    query.pair.kind = kind;
    query.line = lines.line();
    for (std::size_t row = 0; row < 8; ++row) {
      if (row > 0) lines.need_next("expected eight lines a query");
      const std::vector<std::string> fields = detail::comma_fields(lines);
      if (fields.size() != 6 && fields.size() != 7)
        lines.fail(std::to_string(fields.size()) + (fields.size() == 1 ? " field" : " fields"),
                   "expected 6 integers and 1 or 0, separated by commas");
      std::optional<bool> truth;
      if (fields.size() == 7) {
        if (fields[6] != "0" && fields[6] != "1")
          lines.fail(in_quotes(fields[6]) + " as the answer", "expected 0 or 1");
        truth = fields[6] == "1";
      }
      if (row == 0) query.truth = truth;
      if (truth != query.truth)
        lines.fail("another answer than on line " + std::to_string(query.line), "expected one answer a query");
      kernel::Moving_point& point = query.pair.points[row % 4];
      kernel::Vertex& v = row < 4 ? point.start : point.end;
      for (std::size_t axis = 0; axis < 3; ++axis)
        v[axis] = detail::double_of_fraction(lines, fields[2 * axis], fields[2 * axis + 1]);
    }
    queries.push_back(query);
  }
  if (queries.empty()) throw Input_error(file.native(), 0, "holds no query", "expected eight lines a query");
  return queries;
}

}  // namespace tetracone::covering

#endif
