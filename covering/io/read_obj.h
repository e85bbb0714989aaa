#ifndef TETRACONE_COVERING_IO_READ_OBJ_H
#define TETRACONE_COVERING_IO_READ_OBJ_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// Returns the vertex number of a corner "v", "v/vt", "v/vt/vn" or "v//vn" of an OBJ face, as written (from 1, or
/// negative). The other numbers must be integers or missing; they are not used. Throws Input_error for any other word.
inline std::int64_t obj_corner(const Text_lines& lines, std::string_view corner)
{
  std::int64_t vertex = 0;
  std::string_view rest = corner;
  for (int field = 0; field < 3; ++field) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view word = rest.substr(0, slash);
    const auto value = parse_integer<std::int64_t>(word);
    if (!value && (field == 0 || !word.empty())) break;
    if (field == 0) vertex = *value;
    if (slash == rest.size()) return vertex;
    rest.remove_prefix(slash + 1);
  }
  lines.fail(in_quotes(corner) + " as corner of a face", "expected v, v/vt, v//vn or v/vt/vn in integers");
}

/// True when the statement is a vertex (`v`) or a face (`f`, the old `fo`, or `q` of QOBJ).
inline bool is_obj_geometry(std::string_view statement)
{
  return statement == "v" || statement == "f" || statement == "fo" || statement == "q";
}

/// The words of OBJ statements, one after the other.
class Obj_statements {
 public:
  explicit Obj_statements(Text_lines& lines) : lines_(lines) {}

  /// Goes to the next statement; false at the end. A line that ends in a backslash goes on in the next. A name may end
  /// in one, too (`g C:\parts\`). So a vertex or a face in the next line is a statement of its own, unless it continues
  /// a vertex or a face. Throws Input_error if the text ends where one of these goes on.
  bool next()
  {
    words_.clear();
    while (words_.empty()) {
      if (!std::exchange(is_current_, false) && !lines_.next()) return false;
      append();
      while (!words_.empty() && words_.back().ends_with('\\')) {
        continued_ = true;
        words_.back().pop_back();
        if (words_.back().empty()) words_.pop_back();
        if (!words_.empty() && is_obj_geometry(words_[0])) {
          lines_.need_next("expected the line that the backslash continues");
        } else if (!lines_.next()) {
          break;
        } else if (!words_.empty() && is_obj_geometry(lines_.words()[0])) {
          kept_.add(at_line(lines_));
          is_current_ = true;
          break;
        }
        append();
      }
    }
    return true;
  }

  const std::vector<std::string>& words() const { return words_; }

  /// True when some line so far ended in a backslash.
  bool continued() const { return continued_; }

  /// Returns the vertices and faces that were read although the line before them, of something else, ends in a
  /// backslash.
  const Left_out& kept() const { return kept_; }

 private:
  /// Appends the words of the current line up to its comment. A comment begins at a word that begins with '#', since
  /// CGAL takes 'g#' for a statement. In a vertex or a face it may begin within a word, but not in "1.#IND".
  void append()
  {
    for (const std::string_view word : lines_.words()) {
      if (word.starts_with('#')) return;
      words_.emplace_back(word);
      const bool has_comment = word.find('#') != std::string_view::npos && word.find("1.#") == std::string_view::npos;
      if (!has_comment || !is_obj_geometry(words_[0])) continue;
      words_.back().resize(word.find('#'));
      return;
    }
  }

  Text_lines& lines_;
  std::vector<std::string> words_;
  bool is_current_ = false;  // the current line is not yet part of a statement
  bool continued_ = false;
  Left_out kept_;
};

/// Adds the vertex of a statement `v`: x y z, then nothing, a weight, a colour, or both, which are not used. The weight
/// belongs to rational curves, and is no homogeneous coordinate. Throws Input_error for another count, for a
/// word that is no number, and for 2^31 vertices.
inline void add_obj_vertex(const Text_lines& lines, const std::vector<std::string>& words, Scan& scan)
{
  const std::size_t numbers = words.size() - 1;
  if (numbers < 3 || numbers == 5 || numbers > 7)
    lines.fail("a vertex of " + std::to_string(numbers) + " numbers", "expected 3, and perhaps a weight and a colour");
  auto& vertices = scan.soup.vertices;
  if (vertices.size() == std::numeric_limits<std::int32_t>::max())
    lines.fail("too many vertices", "expected less than 2^31");
  kernel::Vertex vertex{};
  bool is_placed = true;
  for (std::size_t k = 0; k < numbers; ++k) {
    const std::string& word = words[k + 1];
    if (const auto value = parse_double(word)) {
      if (k < 3) vertex[k] = *value;
      continue;
    }
    const Input_error error(lines.file(), lines.line(), in_quotes(word) + " as coordinate",
                            "expected a finite decimal number");
    if (!is_number_word(word)) throw error;
    scan.cgal_knows = false;
    if (k < 3 && std::exchange(is_placed, false)) scan.unplaced.add(static_cast<Index>(vertices.size()), error);
  }
  vertices.push_back(vertex);
}

/// A reader of an OBJ text. Its functions throw Input_error.
class Obj_scan {
 public:
  Obj_scan(const std::string& file, std::string_view text) : lines_(file, text, '\0') {}

  /// Returns what the text holds. Requires that it is called once.
  Scan operator()()
  {
    if (statements_.next() && !take_counts()) add_statement();
    while (statements_.next()) add_statement();
    if (statements_.continued()) scan_.cgal_knows = false;
    free_form_.note("free-form surfaces are left out", scan_.notes);
    statements_.kept().note("lines behind one that ends in a backslash are read as statements of their own",
                            scan_.notes);
    need_vertices_ahead();
    need_counts();
    if (lines_.line() == 0) lines_.fail("the file is empty", "expected vertices and faces");
    finish(scan_);
    return std::move(scan_);
  }

 private:
  /// Takes the current statement as the counts of vertices and faces, if it is two integers.
  bool take_counts()
  {
    if (words_.size() != 2) return false;
    const auto vertices = parse_count(words_[0]), faces = parse_count(words_[1]);
    if (!vertices || !faces) return false;
    counts_ = {*vertices, *faces};
    scan_.cgal_knows = false;
    return true;
  }

  void add_statement()
  {
    if (words_[0] == "v")
      add_obj_vertex(lines_, words_, scan_);
    else if (is_obj_geometry(words_[0]))
      add_obj_face();
    else
      skip(words_[0]);
  }

  void add_obj_face()
  {
    if (words_[0] != "f") scan_.cgal_knows = false;
    need_corners(lines_, words_.size() - 1, 1);
    if (words_[0] == "q" && words_.size() != 5)
      lines_.fail("a face q of " + std::to_string(words_.size() - 1) + " corners", "expected 4");
    loop_.clear();
    for (std::size_t k = 1; k < words_.size(); ++k) loop_.push_back(vertex(obj_corner(lines_, words_[k])));
    // CGAL skips from an index to the next blank: any other white space hides the indices behind it.
    const std::string_view first = lines_.words().front(), last = lines_.words().back();
    const std::string_view row(first.data(), last.data() + last.size() - first.data());
    if (row.find_first_of("\t\r\v\f") != std::string_view::npos) scan_.cgal_knows = false;
    add_face(scan_, loop_, [&] { return at_line(lines_); });
  }

  /// Returns the vertex that a corner names, and records one that comes later.
  Index vertex(std::int64_t corner)
  {
    const auto so_far = static_cast<std::int64_t>(scan_.soup.vertices.size());
    const std::int64_t index = corner > 0 ? corner - 1 : so_far + corner;
    if (corner == 0 || index < 0 || index > std::numeric_limits<std::int32_t>::max())
      lines_.fail("vertex index " + std::to_string(corner) + " after " + std::to_string(so_far) + " vertices",
                  "expected an index from 1, or from -1 down to the first vertex");
    if (index >= so_far && (ahead_.empty() || ahead_.back().second < index)) ahead_.emplace_back(lines_.line(), index);
    return static_cast<Index>(index);
  }

  /// Skips a statement that is no vertex and no face, or refuses an unknown one.
  void skip(std::string_view statement)
  {
    constexpr std::array skipped = {
        "vt",       "vn",     "vp",   "bevel", "lod",      "ctech",  "c_interp",   "usemap",    "usemtl",   "stech",
        "d_interp", "mtllib", "o",    "g",     "s",        "p",      "shadow_obj", "cstype",    "deg",      "step",
        "bmat",     "con",    "curv", "curv2", "parm",     "trim",   "hole",       "trace_obj", "scrv",     "sp",
        "end",      "surf_1", "q0_1", "q1_1",  "curv2d_1", "surf_2", "q0_2",       "q1_2",      "curv2d_2", "cdc"};
    constexpr std::array surfaces = {"surf", "bsp", "bzp", "cdp", "res"};
    constexpr std::array unknown_to_cgal = {"l", "call", "csh", "maplib", "mg"};
    const auto is_one_of = [&](const auto& names) { return std::ranges::find(names, statement) != names.end(); };
    if (is_one_of(surfaces))
      free_form_.add(at_line(lines_));
    else if (is_one_of(unknown_to_cgal))
      scan_.cgal_knows = false;
    else if (!is_one_of(skipped))
      lines_.fail(in_quotes(statement) + " as statement", "expected v, f or another statement of the format");
  }

  /// Refuses an index that no vertex has had in the end.
  void need_vertices_ahead() const
  {
    const std::size_t vertices = scan_.soup.vertices.size();
    for (const auto& [line, index] : ahead_)
      if (index >= static_cast<std::int64_t>(vertices))
        throw Input_error(
            lines_.file(), line,
            "vertex index " + std::to_string(index + 1) + " with " + std::to_string(vertices) + " vertices",
            "expected 1 to the number of vertices");
  }

  /// Refuses other numbers of vertices and faces than the first line counts.
  void need_counts() const
  {
    const std::size_t vertices = scan_.soup.vertices.size(),
                      faces = scan_.soup.face_count() + scan_.short_faces.count();
    if (counts_ && *counts_ != std::array<std::uint64_t, 2>{vertices, faces})
      throw Input_error(lines_.file(), 0,
                        std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces",
                        "expected " + std::to_string((*counts_)[0]) + " and " + std::to_string((*counts_)[1]) +
                            " as the first line counts");
  }

  Text_lines lines_;
  Obj_statements statements_{lines_};
  const std::vector<std::string>& words_ = statements_.words();  // of the current statement
  Scan scan_;
  std::vector<Index> loop_;
  std::optional<std::array<std::uint64_t, 2>> counts_;
  // The line and the index of each corner that was further ahead than all before it. They are settled at the end.
  std::vector<std::pair<std::size_t, std::int64_t>> ahead_;
  Left_out free_form_;
};

/// Returns what a Wavefront OBJ text holds: vertices (`v`) and faces (`f`, `fo`, `q`). A face stays a polygon. Its
/// indices count from 1, or backwards from the last vertex before it. A line that ends in a backslash goes on in the
/// next. Statements that draw something else (points, lines, curves, groups, materials) are skipped, free-form surfaces
/// with a note; unknown ones are refused. A first line of two counts, of vertices and faces, is taken too (FCL's files
/// have it), and must be right. A face may name vertices that come later. Throws Input_error at a flaw.
///
/// These dialects are read by the scan alone, since CGAL's reader does not take them, or not as they are meant:
///
/// - such a first line, and continued lines;
/// - faces of one or two corners;
/// - white space other than blanks between corners;
/// - numbers that are not finite;
/// - statements that it does not take (`fo`, `q`, `l`, `call`, `csh`, `maplib`, `mg`).
inline Scan scan_obj(const std::string& file, std::string_view text) { return Obj_scan(file, text)(); }

}  // namespace tetracone::covering

#endif
