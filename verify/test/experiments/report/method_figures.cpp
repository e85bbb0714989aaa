// Runs `tetracone experiment method` itself: the data of the pictures is consistent, and every picture is drawn.

#include "experiments/report/method_figures.h"

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_method_figures)

using namespace tetracone::verify;
using Json = nlohmann::json;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(every_picture_is_drawn_from_data_that_agree)
{
  if (std::system("'" TETRACONE_PYTHON "' -c 'import matplotlib' 2> /dev/null") != 0) {
    std::puts("skipped: no python3-matplotlib");
    return;
  }
  const Temporary_folder folder("method");
  const fs::path& out = folder.path();
  const Run r = run("experiment method --out " + in_quotes(out));
  BOOST_TEST_REQUIRE(r.status == 0, r.error);
  std::ifstream in(out / "method.json");
  const Json data = Json::parse(in), &pair = data["pair"], &a = pair["bodies"][0];

  // The two meet, so some leaves are left, and all that is left are leaves.
  BOOST_TEST(pair["exact"][0] == 1);
  for (const Json& left : pair["left"][0]) {
    BOOST_TEST(!left.empty());
    for (const std::size_t node : left) BOOST_TEST(a["nodes"]["leaf"][node] == 1);
  }
  // Down the path cones hold fewer and fewer of the tetrahedra.
  std::size_t before = a["covering"]["signs"].size();
  for (const Json& step : data["path"]) {
    BOOST_TEST(step["tetrahedra"].size() <= before);
    before = step["tetrahedra"].size();
    BOOST_TEST(before > 0u);
  }
  for (const std::string name :
       {"covering", "cone", "classification", "levels", "bounds", "tetrahedra", "spheres", "theorem_2"})
    for (const std::string ending : {".svg", ".pdf"})
      BOOST_TEST(fs::file_size(out / "figures" / ("method_" + name + ending)) > 3000u, name);
}

BOOST_AUTO_TEST_SUITE_END()
