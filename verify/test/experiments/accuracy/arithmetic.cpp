// The experiments of arithmetic, `sign-maps` and `stability`, as their users run them: their exact rows against what
// can be said with pencil and paper.

#include "verify/test/support/csv_rows.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_arithmetic)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(sign_maps_are_exact_where_they_say_so_and_rounding_shows)
{
  constexpr int size = 32;
  const Temporary_folder out("sign_maps");
  const Run made = run("experiment sign-maps --size " + std::to_string(size) + " --out " + in_quotes(out.path()));
  BOOST_TEST_REQUIRE(made.status == 0, made.error);

  std::map<std::pair<std::string, std::string>, std::vector<std::string>> maps;
  for (const auto& row : csv_rows(out.path() / "sign_maps.csv")) {
    auto& lines = maps[{row.at("map"), row.at("subject")}];
    BOOST_TEST(row.at("row") == std::to_string(lines.size()));
    BOOST_TEST(row.at("answers").size() == std::size_t(size));
    lines.push_back(row.at("answers"));
  }
  BOOST_TEST(maps.size() == 4u * 6u);
  for (const auto& [name, lines] : maps)
    BOOST_TEST(lines.size() == std::size_t(size), name.first << ", " << name.second);

  // The moving point is (1/2 + column d, 1/2 + row d, 1/2 + size/2 d). The plane is x + y = 2 z, with the triangle on
  // the side x >= y of its edge. So the point is above the plane, which is -, by (column + row - size) d. The segment
  // goes from it to a point above, across x = y. It meets the triangle when it comes from below or the plane itself,
  // with x >= y.
  const auto plane = [](int row, int column) { return row + column < size ? '+' : row + column > size ? '-' : '0'; };
  const auto triangle = [](int row, int column) { return row + column <= size && column >= row ? '+' : '-'; };
  const auto differing = [&](const std::string& map, const std::string& subject, const auto& expected) {
    int count = 0;
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) count += maps[{map, subject}][row][column] != expected(row, column);
    return count;
  };
  BOOST_TEST(differing("barycentric coordinate", "exact", plane) == 0);
  BOOST_TEST(differing("segment and triangle", "exact", triangle) == 0);
  for (const char* rounded : {"float", "double", "FMA double"}) {
    BOOST_TEST(differing("barycentric coordinate", rounded, plane) > 0, rounded);
    BOOST_TEST(differing("segment and triangle", rounded, triangle) > 0, rounded);
  }
  for (const char* map : {"classification in a cone", "collision of two bodies"}) {
    std::string all;
    for (const std::string& line : maps[{map, "exact"}]) all += line;
    BOOST_TEST(all.find('+') != std::string::npos, map);
    BOOST_TEST(all.find('-') != std::string::npos, map);
  }
}

BOOST_AUTO_TEST_CASE(the_exact_kernel_changes_its_answer_at_the_exact_place_and_float_far_from_it)
{
  const Temporary_folder out("stability");
  const Run made = run("experiment stability --seed 5 --out " + in_quotes(out.path()));
  BOOST_TEST_REQUIRE(made.status == 0, made.error);
  std::map<std::string, std::vector<double>> errors;  // of a subject, in doubles
  for (const auto& row : csv_rows(out.path() / "stability.csv"))
    errors[row.at("subject")].push_back(std::stod(row.at("error_doubles")));
  BOOST_TEST(errors.size() == 6u);
  for (auto& [subject, list] : errors) {
    BOOST_TEST(list.size() > 40u, subject);  // of 60 ways, those that meet
    std::sort(list.begin(), list.end());
  }
  const auto median = [&](const std::string& subject) {
    BOOST_REQUIRE(errors.contains(subject));
    return errors[subject][errors[subject].size() / 2];
  };
  BOOST_TEST(median("adaptive tree") == 0);
  BOOST_TEST(errors["adaptive tree"].back() == 0);
  BOOST_TEST(errors["double tree"].back() > 0);
  // 1e-12 is some thousands of doubles between 1/4 and 4; float's numbers have 29 bits fewer.
  BOOST_TEST(median("double-eps=1e-12 tree") > 0x1p10);
  BOOST_TEST(median("double-eps=1e-12 tree") < 0x1p16);
  BOOST_TEST(median("float tree") > 0x1p20);
  BOOST_TEST(median("float tree") < 0x1p40);
}

BOOST_AUTO_TEST_SUITE_END()
