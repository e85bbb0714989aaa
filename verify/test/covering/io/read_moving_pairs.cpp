#include "tetracone/covering/io/read_moving_pairs.h"

#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

BOOST_AUTO_TEST_SUITE(test_read_moving_pairs)

using namespace tetracone::covering;
using tetracone::kernel::Moving_kind;
using tetracone::verify::Temporary_file;

std::string rows(int count, const std::string& row)
{
  std::string text;
  for (int k = 0; k < count; ++k) text += row + "\n";
  return text;
}

std::string error_of(const std::string& text)
{
  return tetracone::verify::error_of(Temporary_file("queries.csv", text),
                                     [](const auto& path) { read_moving_pairs(path, Moving_kind::edge_edge); });
}

BOOST_AUTO_TEST_CASE(queries_are_eight_lines_each)
{
  const Temporary_file file("queries.csv", "-8388609,8388608,1,1,-1,2,0\n" + rows(6, "0,1, 0,1 ,0,1,0") +
                                               "5,1,6,1,7,1,0\r\n\n" + rows(8, "3,4,0,1,0,1"));
  const auto queries = read_moving_pairs(file.path(), Moving_kind::vertex_face);
  BOOST_REQUIRE(queries.size() == 2u);
  BOOST_TEST((queries[0].pair.kind == Moving_kind::vertex_face));
  BOOST_TEST((queries[0].pair.points[0].start == tetracone::kernel::Vertex{-8388609.0 / 8388608, 1, -0.5}));
  BOOST_TEST((queries[0].pair.points[3].end == tetracone::kernel::Vertex{5, 6, 7}));
  BOOST_TEST(queries[0].truth.value() == false);
  BOOST_TEST(queries[1].line == 10u);
  BOOST_TEST(!queries[1].truth.has_value());
}

BOOST_AUTO_TEST_CASE(the_kind_is_the_name_of_the_folder)
{
  BOOST_TEST((moving_kind_of("x/edge-edge/data.csv") == Moving_kind::edge_edge));
  BOOST_TEST((moving_kind_of("/x/vertex-face/data.csv") == Moving_kind::vertex_face));
  BOOST_TEST(!moving_kind_of("edge-edge/x/data.csv").has_value());
}

BOOST_AUTO_TEST_CASE(the_first_thing_wrong_is_named_with_its_line)
{
  const std::string row = "0,1,0,1,0,1,1";
  BOOST_TEST(error_of("") == ": holds no query; expected eight lines a query");
  BOOST_TEST(error_of(rows(7, row)) == ":7: the file ends here; expected eight lines a query");
  BOOST_TEST(error_of(rows(2, row) + "0,1,0,1,0\n") ==
             ":3: 5 fields; expected 6 integers and 1 or 0, separated by commas");
  BOOST_TEST(error_of("0,1,0,1,0,1,2\n") == ":1: '2' as the answer; expected 0 or 1");
  BOOST_TEST(error_of(row + "\n0,1,0,1,0,1,0\n") == ":2: another answer than on line 1; expected one answer a query");
  BOOST_TEST(error_of("0,1,0,1,0,0,1\n") == ":1: '0/0' as a coordinate; expected integers, the denominator from 1");
  BOOST_TEST(error_of("0,1,0.5,1,0,1,1\n") == ":1: '0.5/1' as a coordinate; expected integers, the denominator from 1");
  BOOST_TEST(error_of("0,1,,1,0,1,1\n") == ":1: '/1' as a coordinate; expected integers, the denominator from 1");
  BOOST_TEST(error_of("1,3,0,1,0,1,1\n") == ":1: '1/3' as a coordinate; expected a fraction that is exactly a double");
  BOOST_TEST(error_of("1" + std::string(400, '0') + ",1,0,1,0,1,1\n")
                 .ends_with("expected a fraction that is exactly a double"));
}

BOOST_AUTO_TEST_SUITE_END()
