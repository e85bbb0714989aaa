#include "verify/proofs/other_constants.h"

#include "tetracone/kernel/number/number.h"
#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_other_constants)

using namespace tetracone::verify::proofs;

namespace {

const std::filesystem::path source = TETRACONE_SOURCE_DIR;

std::string text_of(const std::filesystem::path& file)
{
  std::ifstream in(source / file);
  BOOST_TEST_REQUIRE(in.good(), file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The declarators of a declaration: what commas part that stand in no brackets.
std::vector<std::string> declarators(const std::string& declaration)
{
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : declaration) {
    depth += (c == '(' || c == '{' || c == '<') - (c == ')' || c == '}' || c == '>');
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Constants of a source, by their names, and literals below 1 of its expressions that no comparison is made with. A
/// constant whose value has no digit is another's.
std::vector<std::string> constants_of(const std::string& text)
{
  static const std::regex comment("//[^\\n]*"), number("[0-9]"),
      declaration("\\bconstexpr\\s+(?:double|float|B|Number)\\s+(\\w+\\s*=[^;]*);"), name("^\\s*(\\w+)\\s*=([^]*)"),
      compared("[<>]=?\\s*-?0x1p-[0-9]+f?"), literal("0x1p-[0-9]+f?");
  std::string code = std::regex_replace(text, comment, ""), rest;
  std::vector<std::string> found;
  for (std::sregex_iterator at(code.begin(), code.end(), declaration), end; at != end; ++at)
    for (const std::string& part : declarators((*at)[1])) {
      std::smatch match;
      if (!std::regex_search(part, match, name)) continue;
      const std::string value = match[2];
      if (std::regex_search(std::regex_replace(value, std::regex("_[0-9]|[a-z][0-9]+"), ""), number))
        found.push_back(match[1]);
    }
  rest = std::regex_replace(std::regex_replace(code, declaration, ""), compared, "");
  for (std::sregex_iterator at(rest.begin(), rest.end(), literal), end; at != end; ++at) found.push_back(at->str());
  return found;
}

bool has_word(const std::string& text, const std::string& word)
{
  return std::regex_search(text, std::regex("(^|[^\\w])" + word + "($|[^\\w])"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_proof_is_a_file_and_every_value_a_number)
{
  if (skipped_without_gappa()) return;
  for (const Proved_bound& bound : all_proofs()) {
    BOOST_TEST(std::filesystem::is_regular_file(source / bound.proof), bound.name << ": no proof " << bound.proof);
    BOOST_TEST(std::filesystem::is_regular_file(source / bound.file), bound.name << ": no file " << bound.file);
    for (const double value : {bound.unit, bound.in_code.get_d() / bound.unit, bound.proved.get_d() / bound.unit})
      BOOST_TEST((std::isfinite(value) && value > 0), bound.name << " has " << value);
  }
}

BOOST_AUTO_TEST_CASE(every_constant_of_the_package_is_proved_or_has_its_reason)
{
  if (skipped_without_gappa()) return;
  std::set<std::pair<std::string, std::string>> listed;
  for (const Other_constant& constant : other_constants()) {
    BOOST_TEST(listed.emplace(constant.file, constant.name).second, constant.name << " is listed twice");
    BOOST_TEST(text_of(constant.file).find(constant.name) != std::string::npos,
               constant.file << " has no " << constant.name);
    BOOST_TEST(*constant.reason != 0, constant.name);
    if (constant.kind == Constant_kind::tested)
      BOOST_TEST(has_word(text_of(constant.reason), constant.name), constant.reason << " does not name it");
  }
  const Proved_bounds proved = all_proofs();
  for (const char* folder : {"kernel", "covering", "tetratree"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".inl" && extension != ".cpp") continue;
      const std::string file = std::filesystem::relative(entry.path(), source);
      for (const std::string& name : constants_of(text_of(file))) {
        bool is_proved = false;
        for (const Proved_bound& bound : proved)
          is_proved = is_proved || (bound.file == file && has_word(bound.name, name));
        const bool is_listed = listed.contains({file, name});
        BOOST_TEST(is_proved != is_listed, file << ": " << name
                                                << (is_proved ? " is proved, and listed as if it were not"
                                                              : " has neither a proof nor a reason"));
      }
    }
}

BOOST_AUTO_TEST_CASE(the_kept_table_has_a_proof_in_every_row_and_no_value_that_is_none)
{
  std::ifstream in(source / "experiments/results/error_bounds.csv");
  std::string line;
  std::getline(in, line);
  BOOST_TEST_REQUIRE(line.starts_with("constant,file,unit,in_code,proved,proved_by,proof,"));
  int rows = 0;
  for (; std::getline(in, line); ++rows) {
    std::vector<std::string> fields;
    for (std::size_t at = 0; at <= line.size(); at = line.find(',', at) + 1) {
      fields.push_back(line.substr(at, line.find(',', at) - at));
      if (line.find(',', at) == std::string::npos) break;
    }
    BOOST_TEST_INFO_SCOPE(line);
    BOOST_TEST_REQUIRE(fields.size() > 9u);
    BOOST_TEST(std::filesystem::is_regular_file(source / fields[1]));
    BOOST_TEST(std::filesystem::is_regular_file(source / fields[6]));
    const bool has_values = fields[5] != "hand" && fields[5] != "test";
    for (const std::size_t k : {2, 3, 4})
      BOOST_TEST((fields[k].empty() ? !has_values : tetracone::kernel::parse_double(fields[k]).has_value()));
    if (fields[5] == "hand") BOOST_TEST(!fields[9].empty(), "no reason");
  }
  BOOST_TEST(rows > 150);
}

BOOST_AUTO_TEST_CASE(a_constant_is_found_by_its_name_and_a_literal_by_itself)
{
  const auto found = constants_of(
      "inline constexpr double a = 8 * u, b = two(1, 2);  // constexpr double c = 3;\n"
      "static constexpr float d = unit_roundoff<float>;\n"
      "if (x < 0x1p-30) y = x * (1 + 0x1p-20f);");
  BOOST_TEST(found == (std::vector<std::string>{"a", "b", "0x1p-20f"}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
