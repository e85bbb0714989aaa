// House rules read from the sources as text. Includes point to the right, experiments -> verify -> tetratree ->
// covering -> kernel, and within each folder from room to room. Others are about guards, NaN, comma operators and
// comments. A rule is a function from a file's path and text to what is wrong with it. Each is also shown a file that
// breaks it.

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_house)

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

const fs::path root = TETRACONE_SOURCE_DIR;
// Each may include those before it.
const Strings folders = {"kernel", "covering", "tetratree", "verify", "experiments"};
// The folders of the package: their headers are included as "tetracone/FOLDER/...".
constexpr std::size_t package_folders = 3;

// Rooms that may include each other, from where to where; a folder's own files count as the room of its name.
const std::set<std::pair<std::string, std::string>> ways_within = {{"kernel/predicate", "kernel/number"},
                                                                   {"kernel/predicate", "kernel/simd"},
                                                                   {"kernel/contact", "kernel/number"},
                                                                   {"kernel/contact", "kernel/predicate"},
                                                                   {"kernel/bound", "kernel/number"},
                                                                   {"kernel/bound", "kernel/simd"},
                                                                   {"kernel/motion", "kernel/number"},
                                                                   {"covering/io", "covering"},
                                                                   {"covering/repair", "covering"},
                                                                   {"tetratree/paper", "tetratree"},
                                                                   {"tetratree/fast", "tetratree"},
                                                                   {"tetratree/locator", "tetratree"},
                                                                   {"tetratree/door", "tetratree"},
                                                                   {"tetratree/memory", "tetratree/fast"},
                                                                   {"tetratree/query", "tetratree"},
                                                                   {"tetratree/query", "tetratree/contact"},
                                                                   {"tetratree/query", "tetratree/fast"},
                                                                   {"tetratree/query", "tetratree/memory"},
                                                                   {"tetratree/relation", "tetratree"},
                                                                   {"tetratree/relation", "tetratree/contact"},
                                                                   {"tetratree/relation", "tetratree/locator"},
                                                                   {"tetratree/relation", "tetratree/query"},
                                                                   {"tetratree/penetration", "tetratree"},
                                                                   {"tetratree/penetration", "tetratree/fast"},
                                                                   {"tetratree/penetration", "tetratree/locator"},
                                                                   {"tetratree/penetration", "tetratree/query"},
                                                                   {"tetratree/penetration", "tetratree/relation"},
                                                                   {"tetratree/certificate", "tetratree/fast"},
                                                                   {"tetratree/certificate", "tetratree/door"},
                                                                   {"tetratree/certificate", "tetratree/memory"},
                                                                   {"tetratree/certificate", "tetratree/penetration"},
                                                                   {"tetratree/door", "tetratree/contact"},
                                                                   {"tetratree/door", "tetratree/paper"},
                                                                   {"tetratree/door", "tetratree/fast"},
                                                                   {"tetratree/door", "tetratree/locator"},
                                                                   {"tetratree/door", "tetratree/memory"},
                                                                   {"tetratree/door", "tetratree/query"},
                                                                   {"tetratree/solver", "tetratree/door"},
                                                                   {"tetratree/solver", "tetratree/query"},
                                                                   {"tetratree/solver", "tetratree/relation"},
                                                                   {"tetratree/solver", "tetratree/penetration"},
                                                                   {"tetratree/solver", "tetratree/paper"},
                                                                   {"tetratree/scene", "tetratree/door"},
                                                                   {"tetratree/scene", "tetratree/fast"},
                                                                   {"tetratree/scene", "tetratree/memory"},
                                                                   {"tetratree/python", "tetratree/door"},
                                                                   {"tetratree/python", "tetratree/scene"},
                                                                   {"verify/predicate_families", "verify/cases"},
                                                                   {"verify/families", "verify/cases"},
                                                                   {"verify/families", "verify/predicate_families"},
                                                                   {"verify/truth", "verify/cases"},
                                                                   {"verify/integer_truth", "verify/cases"},
                                                                   {"verify/integer_truth", "verify/truth"},
                                                                   {"verify/subjects", "verify/cases"},
                                                                   {"verify/subjects", "verify/truth"},
                                                                   {"verify/subjects", "verify/integer_truth"},
                                                                   {"verify/relations", "verify/cases"},
                                                                   {"verify/relations", "verify/subjects"},
                                                                   {"verify/shrink", "verify/cases"},
                                                                   {"verify/shrink", "verify/truth"},
                                                                   {"verify/shrink", "verify/integer_truth"},
                                                                   {"verify/shrink", "verify/subjects"},
                                                                   {"verify/campaign", "verify/cases"},
                                                                   {"verify/campaign", "verify/families"},
                                                                   {"verify/campaign", "verify/truth"},
                                                                   {"verify/campaign", "verify/integer_truth"},
                                                                   {"verify/campaign", "verify/subjects"},
                                                                   {"verify/campaign", "verify/relations"},
                                                                   {"verify/searches", "verify/proofs"},
                                                                   {"verify/python", "verify/cases"},
                                                                   {"verify/python", "verify/families"},
                                                                   {"verify/python", "verify/truth"},
                                                                   {"verify/python", "verify/integer_truth"},
                                                                   {"verify/python", "verify/shrink"},
                                                                   {"experiments/viewer", "experiments/support"},
                                                                   {"experiments/certificates", "experiments/peers"},
                                                                   {"experiments/certificates", "experiments/support"},
                                                                   {"experiments/speed", "experiments/support"},
                                                                   {"experiments/speed", "experiments/peers"},
                                                                   {"experiments/queries", "experiments/support"},
                                                                   {"experiments/queries", "experiments/peers"},
                                                                   {"experiments/queries", "experiments/speed"},
                                                                   {"experiments/scenes", "experiments/support"},
                                                                   {"experiments/scenes", "experiments/peers"},
                                                                   {"experiments/scenes", "experiments/speed"},
                                                                   {"experiments/accuracy", "experiments/support"},
                                                                   {"experiments/report", "experiments/support"},
                                                                   {"experiments/report", "experiments/viewer"}};

std::string read(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The words of the preprocessor line `line` after its '#', or nothing when it is none: `#  include <x>` is "include
/// <x>".
std::optional<std::string> directive(std::string_view line)
{
  const auto skip_blanks = [&line] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip_blanks();
  if (!line.starts_with('#')) return std::nullopt;
  line.remove_prefix(1);
  skip_blanks();
  return std::string(line);
}

Strings directives(const std::string& text)
{
  Strings found;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    if (const auto words = directive(std::string_view(text).substr(begin, end - begin))) found.push_back(*words);
    begin = end + 1;
  }
  return found;
}

struct Include {
  std::string file;
  bool quoted;  ///< "file", not <file>
};

std::vector<Include> includes(const std::string& text)
{
  std::vector<Include> found;
  for (const std::string& words : directives(text)) {
    if (!words.starts_with("include")) continue;
    const std::size_t open = words.find_first_of("\"<");
    if (open == std::string::npos) continue;
    const bool quoted = words[open] == '"';
    const std::size_t close = words.find(quoted ? '"' : '>', open + 1);
    if (close != std::string::npos) found.push_back({words.substr(open + 1, close - open - 1), quoted});
  }
  return found;
}

/// The first folder of a path such as "kernel/number/pose.h".
std::string folder_of(const std::string& path) { return path.substr(0, path.find('/')); }

/// The room of a path: its folder, with the room where there is one.
std::string room_of(const std::string& path) { return path.substr(0, path.rfind('/')); }

/// A file of ours as an include names it, without the package's prefix.
std::string without_prefix(const std::string& file) { return file.starts_with("tetracone/") ? file.substr(10) : file; }

/// The rank of a file's folder: 0 for kernel. Tests may include every folder.
std::size_t rank_of(const std::string& path)
{
  if (path.starts_with("verify/test/") || path.starts_with("verify/mutants/") || path.starts_with("verify/fuzz/"))
    return folders.size();
  return std::find(folders.begin(), folders.end(), folder_of(path)) - folders.begin();
}

/// Project headers are included by their whole path, "tetracone/folder/room/name.h" where the folder is the package's.
/// They are those of the same room, of a room that `ways_within` allows, or of a folder to the right. The command line
/// may include every room of its folder.
Strings wrong_includes(const std::string& path, const std::string& text)
{
  Strings wrong;
  for (const auto& [file, quoted] : includes(text)) {
    const std::string ours = without_prefix(file);
    const std::size_t rank = rank_of(ours);
    if (rank >= folders.size() && !ours.starts_with("verify/")) {
      if (quoted) wrong.push_back(path + ": \"" + file + "\" has no folder of the project as prefix");
      continue;
    }
    if (!quoted) wrong.push_back(path + ": <" + file + "> is the project's own: \"...\"");
    if ((ours != file) != (rank < package_folders))
      wrong.push_back(path + ": " + file + ": \"tetracone/\" stands before the package's folders alone");
    if (rank > rank_of(path)) wrong.push_back(path + ": " + file + " stands to its left");
    const std::string from = room_of(path), to = room_of(ours);
    if (rank == rank_of(path) && rank < folders.size() && from != to && from != "experiments/cli" &&
        !ways_within.contains({from, to}))
      wrong.push_back(path + ": " + from + " may not include " + to);
  }
  return wrong;
}

/// "kernel/predicate/segment_face.h" is guarded by TETRACONE_KERNEL_PREDICATE_SEGMENT_FACE_H.
Strings wrong_guard(const std::string& path, const std::string& text)
{
  std::string guard = "TETRACONE_" + path;
  for (char& c : guard)
    c = std::isalnum(static_cast<unsigned char>(c)) ? std::toupper(static_cast<unsigned char>(c)) : '_';
  const Strings lines = directives(text);
  const bool guarded = lines.size() >= 3 && lines[0] == "ifndef " + guard && lines[1] == "define " + guard &&
                       lines.back().starts_with("endif");
  return guarded ? Strings{} : Strings{path + ": its guard is not " + guard};
}

/// What trees must not know: files, clocks, threads; a lock is all that makes nodes while threads ask. The door reads
/// files; a scene looks at a clock for its budget, the Python module for Ctrl-C.
Strings worldly_includes(const std::string& path, const std::string& text)
{
  const std::set<std::string> world = {"fstream", "filesystem", "chrono", "ctime", "thread", "future"};
  Strings wrong;
  const std::set<std::string> worldly_rooms = {"tetratree/door", "tetratree/scene", "tetratree/python"};
  if (folder_of(path) != "tetratree" || worldly_rooms.contains(room_of(path))) return wrong;
  for (const Include& include : includes(text))
    if (world.contains(include.file)) wrong.push_back(path + ": <" + include.file + ">");
  return wrong;
}

/// Only these of the package may use the parts of CGAL that are GPL; the rest of it, and CGAL's kernels, are LGPL.
bool may_use_gpl(const std::string& path)
{
  return path.starts_with("covering/repair/") || path.starts_with("tetratree/door/repair.");
}

/// True when the file says that it is GPL, which LGPL is not.
bool says_gpl(const std::string& text)
{
  const std::size_t begin = text.find("SPDX-License-Identifier:");
  if (begin == std::string::npos) return false;
  const std::string_view line = std::string_view(text).substr(begin, text.find('\n', begin) - begin);
  for (std::size_t at = line.find("GPL-"); at != std::string_view::npos; at = line.find("GPL-", at + 1))
    if (line[at - 1] != 'L' && line[at - 1] != 'A') return true;
  return false;
}

/// Ways from `path` to a GPL part of CGAL or to a file of ours that may use one. The path is relative to the project or
/// to CGAL's include folder. Reads every include as taken, whatever #if it stands under. `seen` holds the files done.
Strings ways_to_gpl(const std::string& path, const std::string& way, std::set<std::string>& seen)
{
  if (!seen.insert(path).second) return {};
  if (may_use_gpl(path)) return {way + path};
  const std::string text = read((path.starts_with("CGAL/") ? fs::path(CGAL_INCLUDE) : root) / path);
  if (path.starts_with("CGAL/") && says_gpl(text)) return {way + path};
  Strings found;
  for (const auto& [file, quoted] : includes(text))
    if (file.starts_with("CGAL/") || rank_of(without_prefix(file)) < folders.size())
      std::ranges::move(ways_to_gpl(without_prefix(file), way + path + " -> ", seen), std::back_inserter(found));
  return found;
}

/// What drops NaN by the order of its arguments: `maximum` and `minimum` of kernel/number/floating_point.h keep it.
/// Text has no NaN.
Strings drops_nan(const std::string& path, const std::string& text)
{
  Strings wrong;
  if ((folder_of(path) != "kernel" && folder_of(path) != "tetratree") || path == "covering/io/text_lines.h")
    return wrong;
  for (const std::string name :
       {"std::max(", "std::max<", "std::min(", "std::min<", "std::minmax(", "std::fmax(", "std::fmin("})
    if (text.find(name) != std::string::npos)
      wrong.push_back(path + ": " + name.substr(0, name.size() - 1) + " may drop NaN; kernel::maximum or minimum");
  return wrong;
}

/// g++ compiles a friend that is defined in a class template for the processor that every unit is for, not for that of
/// its round. Without optimisation, vectors then reach it in other registers than it looks in.
Strings vector_friends(const std::string& path, const std::string& text)
{
  if (!path.ends_with("_simd.inl") || text.find("friend ") == std::string::npos) return {};
  return {path + ": a friend is not compiled for the round's processor; a function template"};
}

/// The code of a C++ text: comments, literals and preprocessor lines are blanks, line breaks stay.
std::string code_of(const std::string& text)
{
  std::string code = text;
  const auto blank = [&code](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      if (code[k] != '\n') code[k] = ' ';
  };
  const auto after = [&text](const std::string& what, std::size_t from) {
    const std::size_t at = text.find(what, from);
    return at == std::string::npos ? text.size() : at + what.size();
  };
  bool line_is_empty = true;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = k;
    if (text.compare(k, 2, "//") == 0) {
      end = std::min(text.find('\n', k), text.size());
    } else if (text.compare(k, 2, "/*") == 0) {
      end = after("*/", k + 2);
    } else if (text[k] == '#' && line_is_empty) {
      do end = after("\n", end);
      while (end < text.size() && text[end - 2] == '\\');
      --end;
    } else if (text.compare(k, 2, "R\"") == 0) {
      end = after(")" + text.substr(k + 2, text.find('(', k) - k - 2) + "\"", k);
    } else if (text[k] == '"' ||
               (text[k] == '\'' && (k == 0 || !std::isalnum(static_cast<unsigned char>(text[k - 1]))))) {
      for (end = k + 1; end < text.size() && text[end] != text[k]; ++end) end += text[end] == '\\' ? 1 : 0;
      end = std::min(end + 1, text.size());
    }
    line_is_empty = text[k] == '\n' || (line_is_empty && std::isspace(static_cast<unsigned char>(text[k])));
    if (end == k) {
      ++k;
      continue;
    }
    blank(k, end);
    if (text[k] == '"') code[k] = '0';  // a string is a value
    k = end;
  }
  return code;
}

/// A comment with its first line's number: lines of `//` that follow one another, joined, without their slashes.
struct Comment {
  std::size_t line;
  std::string text;
};

Strings lines_of(const std::string& text)
{
  Strings lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<Comment> comments(const std::string& text)
{
  std::vector<Comment> found;
  const std::string code = code_of(text);
  std::size_t begin = 0, number = 0, last = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    // A literal that holds slashes is a blank in the code too: a comment is blank from its slashes to the line's end.
    const std::size_t at = line.find("//");
    const bool is_comment = at != std::string::npos && code.compare(begin + at, 2, "  ") == 0 &&
                            std::count(line.begin(), line.begin() + at, '"') % 2 == 0;
    begin += line.size() + 1;
    if (!is_comment) continue;
    std::string words = line.substr(std::min(line.find_first_not_of("/<", at), line.size()));
    words.erase(0, std::min(words.find_first_not_of(' '), words.size()));
    const bool stands_alone = line.find_first_not_of(' ') == at;
    if (stands_alone && last + 1 == number && !found.empty())
      found.back().text += words.empty() ? ". " : " " + words;
    else
      found.push_back({number, words});
    last = stands_alone ? number : 0;
  }
  return found;
}

/// Returns what a stranger stumbles over: sentences without a subject, bounds that are named inversely, and comment
/// lines that are longer than code may be.
Strings hard_english(const std::string& path, const std::string& text)
{
  constexpr std::size_t column_limit = 120;
  Strings wrong;
  const auto report = [&](std::size_t line, const std::string& what) {
    wrong.push_back(path + ":" + std::to_string(line) + ": " + what);
  };
  static const std::regex head(R"((^|[.:] )(Of|The same|So many|What is) [^.]{0,40})"),
      inverse(R"([Aa]t (least|most) (by )?(how|this far)|[Aa]t (least|most),? how)");
  for (const Comment& comment : comments(text)) {
    std::smatch found;
    if (std::regex_search(comment.text, found, head))
      report(comment.line, "begins without a subject: '" + found.str() + "'");
    if (std::regex_search(comment.text, found, inverse))
      report(comment.line, "'" + found.str() + "'; lower bound of, or upper bound of");
  }
  std::size_t number = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    if (line.find("//") != std::string::npos && line.size() > column_limit)
      report(number, "is longer than 120 columns");
  }
  return wrong;
}

/// The end of what `text` opens at `begin`, one beyond the bracket that closes it.
std::size_t bracket_end(std::string_view text, std::size_t begin)
{
  int depth = 0;
  for (std::size_t k = begin; k < text.size(); ++k) {
    if (text[k] == '(' || text[k] == '[' || text[k] == '{') ++depth;
    if ((text[k] == ')' || text[k] == ']' || text[k] == '}') && --depth == 0) return k + 1;
  }
  return text.size();
}

/// Reads the pieces of an expression from the front of a text, blanks skipped before each.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) { skip_blanks(); }

  std::string_view rest() const { return rest_; }
  bool starts_with(std::string_view what) const { return rest_.starts_with(what); }

  bool take(std::string_view what)
  {
    if (!starts_with(what)) return false;
    drop(what.size());
    return true;
  }

  /// A word of letters, digits and '_'; empty where none stands.
  std::string_view word()
  {
    std::size_t n = 0;
    while (n < rest_.size() && (std::isalnum(static_cast<unsigned char>(rest_[n])) || rest_[n] == '_')) ++n;
    const std::string_view found = rest_.substr(0, n);
    drop(n);
    return found;
  }

  bool take_word(std::string_view what)
  {
    Reader ahead = *this;
    if (ahead.word() != what) return false;
    *this = ahead;
    return true;
  }

  bool take_brackets(char open)
  {
    if (rest_.empty() || rest_[0] != open) return false;
    drop(bracket_end(rest_, 0));
    return true;
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n\t\r"), rest_.size())); }
  void drop(std::size_t n)
  {
    rest_.remove_prefix(n);
    skip_blanks();
  }

  std::string_view rest_;
};

/// Without what stands before a statement's expression: labels, `else`, `do`, headers of `if`, `for`, `while`.
std::string_view without_headers(std::string_view statement)
{
  for (Reader reader(statement);;) {
    Reader ahead = reader;
    if (ahead.take_word("else") || ahead.take_word("do")) {
      reader = ahead;
      continue;
    }
    if (ahead.take_word("if") || ahead.take_word("for") || ahead.take_word("while") || ahead.take_word("switch")) {
      ahead.take_word("constexpr");
      if (!ahead.take_brackets('(')) return reader.rest();
    } else if (ahead.take_word("case")) {
      while (!ahead.rest().empty() && (!ahead.take(":") || ahead.take(":"))) {
        if (ahead.word().empty() && !ahead.starts_with(":")) return reader.rest();
      }
    } else if (ahead.word().empty() || !ahead.take(":") || ahead.starts_with(":")) {
      return reader.rest();
    }
    reader = ahead;
  }
}

/// A statement that begins with a call, an increment or an assignment, which no declaration does, or with `return`.
bool begins_as_expression(std::string_view statement)
{
  Reader reader(statement);
  if (reader.take_word("return")) return true;
  bool acts = false;
  for (bool more = true; more;) {
    more = reader.take("*");
    if (reader.take("++") || reader.take("--")) acts = more = true;
  }
  reader.take("::");
  do {
    const std::string_view word = reader.word();
    if (word.empty() || word == "auto" || word == "operator") return false;
  } while (reader.take("::") || reader.take("->") || (!reader.starts_with("...") && reader.take(".")));
  for (;;) {
    if (reader.take_brackets('(') || reader.take("++") || reader.take("--")) {
      acts = true;
    } else if (reader.take("->") || reader.take(".")) {
      reader.word();
    } else if (!reader.take_brackets('[')) {
      break;
    }
  }
  if (acts && reader.starts_with(",")) return true;
  for (const std::string_view assignment : {"+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>="})
    if (reader.starts_with(assignment)) return true;
  return reader.starts_with("=") && !reader.starts_with("==");
}

/// The text without template arguments, as far as they can be told from comparisons: words, calls and commas alone.
std::string without_template_arguments(std::string text)
{
  for (std::size_t open = text.rfind('<'); open != std::string::npos && open > 0; open = text.rfind('<', open - 1)) {
    const std::size_t close = text.find_first_not_of(
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
        "_:,*&(). \n",
        open + 1);
    const bool after_word = std::isalnum(static_cast<unsigned char>(text[open - 1])) || text[open - 1] == '_';
    if (after_word && close != std::string::npos && text[close] == '>') text.erase(open, close + 1 - open);
  }
  return text;
}

/// True when a comma of the statement stands in no bracket.
bool has_open_comma(std::string_view statement)
{
  for (std::size_t k = 0; k < statement.size(); ++k) {
    if (statement[k] == ',') return true;
    if (statement[k] == '(' || statement[k] == '[' || statement[k] == '{') k = bracket_end(statement, k) - 1;
  }
  return false;
}

/// Comma operators of statements, those of lambdas too; not those within brackets, nor in the headers of `for`.
Strings comma_operators(const std::string& path, const std::string& text)
{
  struct Block {
    std::string statement;  // so far
    std::size_t begin = 0;
    int open = 0;  // parentheses and brackets
  };
  const std::string code = code_of(text);
  Strings wrong;
  std::vector<Block> blocks(1);
  for (std::size_t k = 0; k < code.size(); ++k) {
    const char c = code[k];
    if (c == '}') {
      if (blocks.size() > 1) blocks.pop_back();
      Block& outer = blocks.back();
      const std::string plain = without_template_arguments(outer.statement);
      if (outer.open > 0 || begins_as_expression(without_headers(plain)))
        outer.statement += "{}";
      else
        outer.statement.clear();
      continue;
    }
    Block& block = blocks.back();
    if (c == '{') {
      blocks.emplace_back();
      continue;
    }
    block.open += (c == '(' || c == '[') - (c == ')' || c == ']');
    if (c != ';' || block.open > 0) {
      if (block.statement.empty()) block.begin = k;
      if (!block.statement.empty() || !std::isspace(static_cast<unsigned char>(c))) block.statement += c;
      continue;
    }
    const std::string plain = without_template_arguments(block.statement);
    const std::string_view expression = without_headers(plain);
    if (begins_as_expression(expression) && has_open_comma(expression))
      wrong.push_back(path + ":" + std::to_string(1 + std::count(code.begin(), code.begin() + block.begin, '\n')) +
                      ": a comma operator outside the header of a for");
    block.statement.clear();
  }
  return wrong;
}

/// The test of a header includes it first: verify/test/FOLDER/ROOM/NAME.cpp that of FOLDER/ROOM/NAME.h.
Strings late_own_header(const std::string& path, const std::string& text)
{
  const std::string header = path.substr(12, path.size() - 15) + "h";
  if (!fs::exists(root / header)) return {};
  const auto all = includes(text);
  if (all.empty() || without_prefix(all.front().file) != header)
    return {path + ": its first include is not \"" + header + "\""};
  return {};
}

/// The project's C++ files, relative to its root. Programs of users, the examples and the package's test, are left out.
Strings sources()
{
  Strings found;
  for (const std::string& folder : folders) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& path = entry.path();
      const fs::path room = path.parent_path().filename();
      if (room != "install" && room != "examples" &&
          (path.extension() == ".h" || path.extension() == ".inl" || path.extension() == ".cpp"))
        found.push_back(path.lexically_relative(root).generic_string());
    }
  }
  std::ranges::sort(found);
  return found;
}

template <class Rule>
void check_each_source(const Rule& rule)
{
  for (const std::string& path : sources())
    for (const std::string& wrong : rule(path, read(root / path))) BOOST_ERROR(wrong);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_sources_are_found)
{
  const Strings found = sources();
  for (const std::string file : {"kernel/number/pose.h", "covering/polyhedron.h", "verify/test/house.cpp"})
    BOOST_TEST(std::ranges::count(found, file) == 1, file);
}

BOOST_AUTO_TEST_CASE(no_room_is_crowded)
{
  std::map<std::string, std::size_t> files;
  for (const std::string& path : sources()) ++files[fs::path(path).parent_path().generic_string()];
  for (const auto& [room, count] : files)
    if (count > 35)
      BOOST_ERROR(room + ": " + std::to_string(count) + " files; expected at most 35: make a room of some");
}

BOOST_AUTO_TEST_CASE(includes_point_only_to_the_right) { check_each_source(wrong_includes); }

BOOST_AUTO_TEST_CASE(an_include_to_the_left_or_without_its_folder_is_noticed)
{
  BOOST_TEST(
      wrong_includes("tetratree/paper/tree.h",
                     "#include \"tetracone/tetratree/paper/cone.h\"\n#include \"tetracone/kernel/number/pose.h\"")
          .empty());
  BOOST_TEST(wrong_includes("verify/test/kernel/number/pose.cpp", "#include \"experiments/support/table.h\"").empty());
  BOOST_TEST(wrong_includes("kernel/number/pose.h", "#include \"tetracone/covering/polyhedron.h\"").size() == 1);
  BOOST_TEST(wrong_includes("verify/truth/truth.h", "\n  #  include\t\"experiments/support/table.h\"\n").size() == 1);
  BOOST_TEST(wrong_includes("kernel/number/pose.h", "#include \"number.h\"").size() == 1);
  BOOST_TEST(wrong_includes("kernel/number/pose.h", "#include \"../number/number.h\"").size() == 1);
  BOOST_TEST(wrong_includes("covering/check.h", "#include <tetracone/kernel/number/number.h>").size() == 1);
  BOOST_TEST(wrong_includes("covering/check.h", "#include \"kernel/number/number.h\"").size() == 1);
  BOOST_TEST(wrong_includes("experiments/cli/tetracone.cpp", "#include \"tetracone/verify/cases/case.h\"").size() == 1);
}

BOOST_AUTO_TEST_CASE(an_include_of_a_room_that_is_not_beside_is_noticed)
{
  BOOST_TEST(wrong_includes("kernel/bound/bounds.h", "#include \"tetracone/kernel/number/pose.h\"").empty());
  BOOST_TEST(wrong_includes("kernel/bound/bounds.h", "#include \"tetracone/kernel/predicate/signs.h\"").size() == 1);
  BOOST_TEST(wrong_includes("tetratree/fast/bvh8.h", "#include \"tetracone/tetratree/paper/config.h\"").size() == 1);
  BOOST_TEST(wrong_includes("verify/cases/case.h", "#include \"verify/truth/truth.h\"").size() == 1);
  BOOST_TEST(
      wrong_includes("experiments/cli/tetracone.cpp", "#include \"experiments/report/method_figures.h\"").empty());
}

BOOST_AUTO_TEST_CASE(every_header_has_the_guard_of_its_name)
{
  check_each_source([](const std::string& path, const std::string& text) {
    return path.ends_with(".h") || path.ends_with(".inl") ? wrong_guard(path, text) : Strings{};
  });
}

BOOST_AUTO_TEST_CASE(a_guard_of_another_name_is_noticed)
{
  const auto guarded_by = [](const std::string& name) {
    return "#ifndef " + name + "\n#define " + name + "\n#endif\n";
  };
  BOOST_TEST(
      wrong_guard("kernel/predicate/segment_face.h", guarded_by("TETRACONE_KERNEL_PREDICATE_SEGMENT_FACE_H")).empty());
  BOOST_TEST(
      wrong_guard("kernel/predicate/segment.h", guarded_by("TETRACONE_KERNEL_PREDICATE_SEGMENT_FACE_H")).size() == 1);
  BOOST_TEST(wrong_guard("kernel/predicate/segment.h", "#pragma once\n").size() == 1);
}

BOOST_AUTO_TEST_CASE(tetratree_knows_no_file_clock_or_thread)
{
  check_each_source(worldly_includes);
  BOOST_TEST(worldly_includes("tetratree/fast/tree.h", "#include <thread>").size() == 1);
}

BOOST_AUTO_TEST_CASE(only_repair_uses_parts_of_cgal_that_are_gpl)
{
  BOOST_REQUIRE(fs::exists(fs::path(CGAL_INCLUDE) / "CGAL/config.h"));
  std::set<std::string> seen;
  for (const std::string& path : sources())
    if (rank_of(path) <= rank_of("tetratree/") && !may_use_gpl(path))
      for (const std::string& way : ways_to_gpl(path, "", seen)) BOOST_ERROR(way);
}

BOOST_AUTO_TEST_CASE(gpl_parts_of_cgal_are_told_from_lgpl_ones)
{
  BOOST_TEST(says_gpl("// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial\n"));
  BOOST_TEST(says_gpl("// SPDX-License-Identifier: ( GPL-3.0-or-later OR LicenseRef-Commercial ) AND MIT\n"));
  BOOST_TEST(!says_gpl("// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial\n"));
  BOOST_TEST(!says_gpl("// SPDX-License-Identifier: BSL-1.0\n"));
  std::set<std::string> seen;
  BOOST_TEST(ways_to_gpl("CGAL/Exact_predicates_exact_constructions_kernel.h", "", seen).empty());
  BOOST_TEST(ways_to_gpl("CGAL/AABB_tree.h", "", seen).size() == 1);
  BOOST_TEST(ways_to_gpl("covering/repair/repair.h", "", seen).size() == 1);
}

BOOST_AUTO_TEST_CASE(no_bound_is_made_by_what_may_drop_nan)
{
  check_each_source(drops_nan);
  BOOST_TEST(drops_nan("kernel/bound/bounds.h", "worst = std::max({x, y, z});").size() == 1);
  BOOST_TEST(drops_nan("tetratree/tree.h", "least = std::min<double>(x, y);").size() == 1);
  BOOST_TEST(drops_nan("kernel/bound/bounds.h", "worst = maximum(x, y, z);").empty());
  BOOST_TEST(drops_nan("covering/check.h", "first = std::min(a, b);").empty());
}

BOOST_AUTO_TEST_CASE(no_vector_function_is_a_friend)
{
  check_each_source(vector_friends);
  BOOST_TEST(vector_friends("kernel/bound/x_simd.inl", "friend HWY_INLINE V Max(V a, V b) { return a; }").size() == 1);
}

BOOST_AUTO_TEST_CASE(comments_are_plain_english)
{
  check_each_source(hard_english);
  const auto count = [](const std::string& text) { return hard_english("kernel/x.h", text).size(); };
  for (const std::string wrong :
       {"/// Of two boxes, the larger.", "  // The same for three.", "/// Returns it. What is lost is little.",
        "/// So many bytes.", "/// At least how far apart they are.", "/// The gap: at most how far\n/// they are.",
        "int x;  ///< Of what was."})
    BOOST_TEST(count(wrong) == 1, wrong);
  BOOST_TEST(count("/// " + std::string(120, 'x')) == 1);
  for (const std::string right : {"/// The lower bound of the distance of both.", "const char* text = \"// Of two\";",
                                  "/// Offers the same.", "/// The sum of what is lost."})
    BOOST_TEST(count(right) == 0, right);
}

BOOST_AUTO_TEST_CASE(no_comma_operator_stands_outside_the_header_of_a_for) { check_each_source(comma_operators); }

BOOST_AUTO_TEST_CASE(comma_operators_are_told_from_other_commas)
{
  const auto count = [](const std::string& text) { return comma_operators("kernel/x.h", text).size(); };
  for (const std::string wrong :
       {"void f() { a = b, c = d; }", "if (x) a[k] += 2, ++n;", "else std::swap(a, b), std::swap(c, d);",
        "x.y = {1, 2}, z = 3;", "each([&](int k) { ++n, sum += k; });", "case Case::one: a->b = 1, c = 2;",
        "for (int k = 0; k < n; ++k) *a++ = k, b = k;", "do f(a), g(b); while (x);", "return a, b;",
        "f = [](int k) { return k; }, g = 1;", "a = \"x\", b = '\\'', c = 1;"})
    BOOST_TEST(count(wrong) == 1, wrong);
  for (const std::string right :
       {"int a = 1, b = 2;", "const auto [a, b] = f(c, d);", "for (a = 0, b = 1; a < b; ++a, --b) f(a, b);",
        "auto [a, b] = c;", "std::map<A, B> x = y, z{1, 2};", "x = std::map<A, std::pair<B, C>>{a, b};",
        "return std::pair<A, B>(a, b);", "Point(A a, B b) : a_(a), b_{b} { f(a, b); }", "enum { a = 1, b = 2 };",
        "// a = b, c = d;\n#define X a = b, \\\n c = d;\n", "f(a = b, c);", "auto f = R\"(a = b, c = d;)\";",
        "T* a = b, *c = d;", "template <class A, class B> void f(A, B);"})
    BOOST_TEST(count(right) == 0, right);
}

BOOST_AUTO_TEST_CASE(the_test_of_a_header_includes_it_first)
{
  check_each_source([](const std::string& path, const std::string& text) {
    return path.starts_with("verify/test/") ? late_own_header(path, text) : Strings{};
  });
  BOOST_TEST(late_own_header("verify/test/kernel/number/pose.cpp", "#include \"kernel/number/number.h\"").size() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
