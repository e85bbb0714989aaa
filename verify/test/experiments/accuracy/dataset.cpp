// Runs `tetracone experiment dataset` itself: its rows as JSON Lines and as CSV.

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_dataset)

using namespace tetracone::verify;
using Json = nlohmann::json;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(rows_of_json_lines_have_numbers_and_booleans)
{
  const Temporary_folder folder("dataset");
  const Run r = run("experiment dataset --cases 1 --out " + in_quotes(folder.path()));
  BOOST_TEST_REQUIRE(r.status == 0, r.error);
  std::ifstream in(folder.path() / "dataset" / "cases.jsonl"), csv(folder.path() / "dataset" / "cases.csv");
  std::string line;
  std::getline(csv, line);
  BOOST_TEST(line.starts_with("id,family,index,parameter,seed,mesh_a,mesh_b,surface,solid,log2_rho,log2_ulps,a00,"));
  int count = 0, fractions = 0;
  for (std::string text; std::getline(in, text); ++count) {
    const Json row = Json::parse(text);
    BOOST_TEST(row["surface"].is_boolean());
    BOOST_TEST(row["solid"].is_boolean());
    BOOST_TEST(row["index"].is_number_unsigned());
    BOOST_TEST(row["seed"].is_number_unsigned());
    for (const char* name : {"parameter", "log2_rho", "log2_ulps"})
      BOOST_TEST((row[name].is_number() || row[name] == "inf" || row[name] == "-inf"), row[name]);
    for (const char body : {'a', 'b'})
      for (int k = 0; k < 12; ++k) {
        const Json& number = row[body + std::to_string(k / 4) + std::to_string(k % 4)];
        fractions += number.is_string();
        BOOST_TEST((number.is_number() || number.get<std::string>().find('/') != std::string::npos), number);
      }
    std::getline(csv, line);
    BOOST_TEST(line.starts_with(row["id"].get<std::string>() + ","));
    const std::string truths =
        std::string(row["surface"].get<bool>() ? ",1," : ",0,") + (row["solid"].get<bool>() ? "1," : "0,");
    BOOST_TEST(line.find(row["mesh_b"].get<std::string>() + truths) != std::string::npos, line);
  }
  BOOST_TEST(count > 20);
  BOOST_TEST(fractions > 0);
}

BOOST_AUTO_TEST_SUITE_END()
