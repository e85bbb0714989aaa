// The house rule of includes, read from the sources as text: experiments -> verify -> tetratree -> covering -> kernel,
// and within each folder from room to room. Rules are functions from a file's path and text to what is wrong with it,
// so that each is also shown a file that breaks it.

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
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

const fs::path root = TETRACONE_SOURCE_DIR;
// Each may include those before it.
const Strings folders = {"kernel", "covering", "tetratree", "verify", "experiments"};
// Those that are the package: their headers are included as "tetracone/FOLDER/...".
constexpr std::size_t package_folders = 3;

// Rooms that may include each other, from where to where; a folder's own files count as the room of its name.
const std::set<std::pair<std::string, std::string>> ways_within = {{"kernel/predicate", "kernel/number"},
                                                                   {"kernel/bound", "kernel/number"},
                                                                   {"kernel/bound", "kernel/simd"},
                                                                   {"covering/io", "covering"},
                                                                   {"covering/repair", "covering"},
                                                                   {"tetratree/paper", "tetratree"},
                                                                   {"tetratree/fast", "tetratree"},
                                                                   {"tetratree/door", "tetratree"},
                                                                   {"tetratree/door", "tetratree/paper"},
                                                                   {"tetratree/door", "tetratree/fast"},
                                                                   {"verify/truth", "verify/cases"},
                                                                   {"verify/subjects", "verify/cases"},
                                                                   {"verify/subjects", "verify/truth"},
                                                                   {"verify/relations", "verify/cases"},
                                                                   {"verify/relations", "verify/subjects"},
                                                                   {"verify/shrink", "verify/cases"},
                                                                   {"verify/shrink", "verify/truth"},
                                                                   {"verify/shrink", "verify/subjects"},
                                                                   {"verify/campaign", "verify/cases"},
                                                                   {"verify/campaign", "verify/truth"},
                                                                   {"verify/campaign", "verify/subjects"},
                                                                   {"verify/campaign", "verify/relations"},
                                                                   {"experiments/viewer", "experiments/support"},
                                                                   {"experiments/speed", "experiments/support"},
                                                                   {"experiments/speed", "experiments/peers"},
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

/// How far left a file stands: 0 in kernel. Tests test every folder.
std::size_t rank_of(const std::string& path)
{
  if (path.starts_with("verify/test/") || path.starts_with("verify/mutants/") || path.starts_with("verify/fuzz/"))
    return folders.size();
  return std::find(folders.begin(), folders.end(), folder_of(path)) - folders.begin();
}

/// Project headers are included by their whole path, "tetracone/folder/room/name.h" where the folder is the package's;
/// only from the same room, a room that `ways_within` allows, or a folder to the right. The command line may include
/// every room of its folder.
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
/// files.
Strings worldly_includes(const std::string& path, const std::string& text)
{
  const std::set<std::string> world = {"fstream", "filesystem", "chrono", "ctime", "thread", "future"};
  Strings wrong;
  if (folder_of(path) != "tetratree" || room_of(path) == "tetratree/door") return wrong;
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

/// Ways from `path` (relative to the project or to CGAL's include folder) to a GPL part of CGAL or to a file of ours
/// that may use one. Reads every include as taken, whatever #if it stands under. `seen` holds the files done.
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

/// The project's C++ files, relative to its root; but for the user's project of the package's test, which is not ours.
Strings sources()
{
  Strings found;
  for (const std::string& folder : folders) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& path = entry.path();
      if (path.parent_path().filename() != "install" &&
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

BOOST_AUTO_TEST_SUITE(test_house)

BOOST_AUTO_TEST_CASE(the_sources_are_found)
{
  const Strings found = sources();
  for (const std::string file : {"kernel/number/pose.h", "covering/polyhedron.h", "verify/test/house.cpp"})
    BOOST_TEST(std::ranges::count(found, file) == 1, file);
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

BOOST_AUTO_TEST_CASE(the_test_of_a_header_includes_it_first)
{
  check_each_source([](const std::string& path, const std::string& text) {
    return path.starts_with("verify/test/") ? late_own_header(path, text) : Strings{};
  });
  BOOST_TEST(late_own_header("verify/test/kernel/number/pose.cpp", "#include \"kernel/number/number.h\"").size() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
