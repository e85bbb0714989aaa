#include "verify/test/support/program.h"

#include <nlohmann/json.hpp>

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_penetration_commands)

using namespace tetracone::verify;
using Json = nlohmann::ordered_json;

namespace {

std::string depth_words(const Temporary_file& poses_b)
{
  return "depth " + in_quotes(cube) + " " + in_quotes(cube) + " --pose-b " + in_quotes(poses_b.path());
}

struct Files {
  Temporary_file poses_b{"poses", "1 0 0 0.5 0 1 0 0 0 0 1 0\n1 0 0 1/3 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n"};
  std::string words(const std::string& direction = "2 0 0") const
  {
    return "exit " + in_quotes(cube) + " " + in_quotes(cube) + " --pose-b " + in_quotes(poses_b.path()) + " --along " +
           direction;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(exits_are_two_columns)
{
  const Files files;
  BOOST_TEST(run(files.words()).out == "0.75 0.75\n0.6666666666666666 0.6666666666666666\n0 0\n");
  BOOST_TEST(run(files.words() + " --exact").out == "3/4 3/4\n2/3 2/3\n0 0\n");
  BOOST_TEST(run(files.words("-1/3 0 0") + " --exact").out == "3/2 3/2\n2 2\n0 0\n");
  BOOST_TEST(run(files.words() + " --exact --csv /dev/stdout").out == "pose,first,last\n0,3/4,3/4\n1,2/3,2/3\n2,0,0\n");
  BOOST_TEST(run(files.words() + " --time --csv /dev/stdout").out.starts_with("pose,first,last,ns\n0,0.75,0.75,"));
  const Json rows = Json::parse(run(files.words() + " --json").out);
  BOOST_TEST(rows[0] == Json::parse(R"({"pose": 0, "first": 0.75, "last": 0.75})"));
  BOOST_TEST(Json::parse(run(files.words() + " --json --exact").out)[1]["last"] == "2/3");
}

BOOST_AUTO_TEST_CASE(a_depth_is_a_bracket_and_a_vector)
{
  const Files files;
  const std::string words = depth_words(files.poses_b);
  BOOST_TEST(run(words).out ==
             "0.5 0.5 -0.5 0 0\n0.6666666666666666 0.6666666666666667 -0.6666666666666666 0 0\n0 0 0 0 0\n");
  BOOST_TEST(run(words + " --exact").out == "1/4 -1/2 0 0\n4/9 -2/3 0 0\n0 0 0 0\n");
  BOOST_TEST(run(words + " --csv /dev/stdout").out.starts_with("pose,low,high,x,y,z\n0,0.5,0.5,-0.5,0,0\n"));
  const Json rows = Json::parse(run(words + " --json --exact --time --budget 0").out);
  BOOST_TEST(rows[0]["square"] == "1/4");
  BOOST_TEST(rows[0]["x"] == "-1/2");
  BOOST_TEST(rows[0]["ns"] > 0);
  for (const char* wrong : {" --relative 1", " --relative -1", " --relative nan", " --budget -1", " --repeat 0"})
    BOOST_TEST(run(words + wrong).status == 2, wrong);
}

BOOST_AUTO_TEST_CASE(a_square_that_is_not_proved_is_not_told)
{
  const std::string frame = in_quotes(models + "frame.poly");
  const std::string words = "depth " + frame + " " + frame + " --exact --budget 0";
  BOOST_TEST(run(words).out == "- 0 0 1\n");
  BOOST_TEST(Json::parse(run(words + " --json").out)[0]["square"].is_null());
}

BOOST_AUTO_TEST_CASE(what_has_no_answer_is_refused_in_one_line)
{
  const Files files;
  for (const char* direction : {"0 0 0", "1 0", "1 0 nan", "1 0 x", "1 0 1/0"}) {
    const Run r = run(files.words(direction));
    BOOST_TEST(r.status == 2, direction);
    BOOST_TEST(r.out.empty());
  }
  for (const char* words : {" --time", " --json --csv x.csv", " --repeat 0"})
    BOOST_TEST(run(files.words() + words).status == 2, words);
  const Temporary_file open("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  BOOST_TEST(run("exit " + in_quotes(cube) + " " + in_quotes(open.path()) + " --along 1 0 0").status == 2);
}

BOOST_AUTO_TEST_SUITE_END()
