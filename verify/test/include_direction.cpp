// The house rule of includes, read from the sources as text: experiments -> verify -> tetratree -> covering -> kernel.
// Rules are functions from a file's path and text to what is wrong with it, so that each is also shown a file that breaks it.

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

const fs::path root = TETRACONE_SOURCE_DIR;
// Each may include those before it.
const Strings folders = {"kernel", "covering", "tetratree", "verify", "experiments"};

std::string read(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The words of the preprocessor line `line` after its '#', or nothing when it is none: `#  include <x>` is "include <x>".
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

/// The first folder of a path such as "kernel/pose.h".
std::string folder_of(const std::string& path) { return path.substr(0, path.find('/')); }

/// How far left a file stands: 0 in kernel. Tests test every folder.
std::size_t rank_of(const std::string& path)
{
  if (path.starts_with("verify/test/") || path.starts_with("verify/mutants/") || path.starts_with("verify/fuzz/")) return folders.size();
  return std::find(folders.begin(), folders.end(), folder_of(path)) - folders.begin();
}

/// Project headers are included as "folder/name.h", and only from the same folder or one to the right.
Strings wrong_includes(const std::string& path, const std::string& text)
{
  Strings wrong;
  for (const auto& [file, quoted] : includes(text)) {
    const bool ours = std::find(folders.begin(), folders.end(), folder_of(file)) != folders.end();
    const bool prefixed = ours && file.find('/') != std::string::npos;
    if (quoted && !prefixed) wrong.push_back(path + ": \"" + file + "\" has no folder of the project as prefix");
    if (!quoted && (prefixed || file.starts_with("tetracone/")))
      wrong.push_back(path + ": <" + file + "> is the project's own: \"folder/name.h\"");
    if (quoted && prefixed && rank_of(file) > rank_of(path))
      wrong.push_back(path + ": " + file + " stands to its left");
  }
  return wrong;
}

/// "kernel/segment_face.h" is guarded by TETRACONE_KERNEL_SEGMENT_FACE_H.
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

/// What tetratree must not know: files, clocks, threads.
Strings worldly_includes(const std::string& path, const std::string& text)
{
  const std::set<std::string> world = {"fstream", "filesystem", "chrono", "ctime", "thread", "mutex", "future"};
  Strings wrong;
  if (folder_of(path) != "tetratree") return wrong;
  for (const Include& include : includes(text))
    if (world.contains(include.file)) wrong.push_back(path + ": <" + include.file + ">");
  return wrong;
}

/// Only these of the package may use the parts of CGAL that are GPL; the rest of it, and CGAL's kernels, are LGPL.
bool may_use_gpl(const std::string& path)
{
  return path.starts_with("covering/read") || path.starts_with("covering/repair");
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

/// Ways from `path` (relative to the project or to CGAL's include folder) to a GPL part of CGAL or to a file of ours that
/// may use one. Reads every include as taken, whatever #if it stands under. `seen` holds the files done.
Strings ways_to_gpl(const std::string& path, const std::string& way, std::set<std::string>& seen)
{
  if (!seen.insert(path).second) return {};
  if (may_use_gpl(path)) return {way + path};
  const std::string text = read((path.starts_with("CGAL/") ? fs::path(CGAL_INCLUDE) : root) / path);
  if (path.starts_with("CGAL/") && says_gpl(text)) return {way + path};
  Strings found;
  for (const auto& [file, quoted] : includes(text))
    if (file.starts_with("CGAL/") || rank_of(file) < folders.size())
      std::ranges::move(ways_to_gpl(file, way + path + " -> ", seen), std::back_inserter(found));
  return found;
}

/// What drops NaN by the order of its arguments: `maximum` and `minimum` of kernel/floating_point.h keep it. Text has no NaN.
Strings drops_nan(const std::string& path, const std::string& text)
{
  Strings wrong;
  if ((folder_of(path) != "kernel" && folder_of(path) != "tetratree") || path == "kernel/text_lines.h") return wrong;
  for (const std::string name : {"std::max(", "std::max<", "std::min(", "std::min<", "std::minmax(", "std::fmax(", "std::fmin("})
    if (text.find(name) != std::string::npos) wrong.push_back(path + ": " + name.substr(0, name.size() - 1) + " may drop NaN; kernel::maximum or minimum");
  return wrong;
}

/// The test of a header includes it first, so that the header is known to compile alone.
Strings late_own_header(const std::string& path, const std::string& text)
{
  const std::string name = fs::path(path).stem().string();
  for (const std::string& folder : folders) {
    if (!name.starts_with(folder + "_")) continue;
    const std::string header = folder + "/" + name.substr(folder.size() + 1) + ".h";
    if (!fs::exists(root / header)) return {};
    const auto all = includes(text);
    if (all.empty() || all.front().file != header) return {path + ": its first include is not \"" + header + "\""};
  }
  return {};
}

/// The project's C++ files, relative to its root; but for the user's project of the package's test, which is not ours.
Strings sources()
{
  Strings found;
  for (const std::string& folder : folders) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& path = entry.path();
      if (path.parent_path().filename() != "install" && (path.extension() == ".h" || path.extension() == ".cpp"))
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
  for (const std::string file : {"kernel/pose.h", "covering/polyhedron.h", "verify/test/include_direction.cpp"})
    BOOST_TEST(std::ranges::count(found, file) == 1, file);
}

BOOST_AUTO_TEST_CASE(includes_point_only_to_the_right) { check_each_source(wrong_includes); }

BOOST_AUTO_TEST_CASE(an_include_to_the_left_or_without_its_folder_is_noticed)
{
  BOOST_TEST(wrong_includes("tetratree/tree.h", "#include \"tetratree/cone.h\"\n#include \"kernel/pose.h\"").empty());
  BOOST_TEST(wrong_includes("verify/test/kernel_pose.cpp", "#include \"experiments/table.h\"").empty());
  BOOST_TEST(wrong_includes("kernel/pose.h", "#include \"covering/polyhedron.h\"").size() == 1);
  BOOST_TEST(wrong_includes("verify/brute.h", "\n  #  include\t\"experiments/table.h\"\n").size() == 1);
  BOOST_TEST(wrong_includes("kernel/pose.h", "#include \"number.h\"").size() == 1);
  BOOST_TEST(wrong_includes("kernel/pose.h", "#include \"../kernel/number.h\"").size() == 1);
  BOOST_TEST(wrong_includes("covering/check.h", "#include <kernel/number.h>").size() == 1);
  BOOST_TEST(wrong_includes("covering/check.h", "#include <tetracone/kernel/number.h>").size() == 1);
}

BOOST_AUTO_TEST_CASE(every_header_has_the_guard_of_its_name)
{
  check_each_source([](const std::string& path, const std::string& text) {
    return path.ends_with(".h") ? wrong_guard(path, text) : Strings{};
  });
}

BOOST_AUTO_TEST_CASE(a_guard_of_another_name_is_noticed)
{
  const auto guarded_by = [](const std::string& name) {
    return "#ifndef " + name + "\n#define " + name + "\n#endif\n";
  };
  BOOST_TEST(wrong_guard("kernel/segment_face.h", guarded_by("TETRACONE_KERNEL_SEGMENT_FACE_H")).empty());
  BOOST_TEST(wrong_guard("kernel/segment.h", guarded_by("TETRACONE_KERNEL_SEGMENT_FACE_H")).size() == 1);
  BOOST_TEST(wrong_guard("kernel/segment.h", "#pragma once\n").size() == 1);
}

BOOST_AUTO_TEST_CASE(tetratree_knows_no_file_clock_or_thread)
{
  check_each_source(worldly_includes);
  BOOST_TEST(worldly_includes("tetratree/tree.h", "#include <thread>").size() == 1);
}

BOOST_AUTO_TEST_CASE(only_readers_and_repair_use_parts_of_cgal_that_are_gpl)
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
  BOOST_TEST(ways_to_gpl("covering/read.h", "", seen).size() == 1);
}

BOOST_AUTO_TEST_CASE(no_bound_is_made_by_what_may_drop_nan)
{
  check_each_source(drops_nan);
  BOOST_TEST(drops_nan("kernel/bounds.h", "worst = std::max({x, y, z});").size() == 1);
  BOOST_TEST(drops_nan("tetratree/tree.h", "least = std::min<double>(x, y);").size() == 1);
  BOOST_TEST(drops_nan("kernel/bounds.h", "worst = maximum(x, y, z);").empty());
  BOOST_TEST(drops_nan("covering/check.h", "first = std::min(a, b);").empty());
}

BOOST_AUTO_TEST_CASE(the_test_of_a_header_includes_it_first)
{
  check_each_source([](const std::string& path, const std::string& text) {
    return path.starts_with("verify/test/") ? late_own_header(path, text) : Strings{};
  });
  BOOST_TEST(late_own_header("verify/test/kernel_pose.cpp", "#include \"kernel/number.h\"").size() == 1);
}
