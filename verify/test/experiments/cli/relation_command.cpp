#include "verify/test/support/program.h"

#include <nlohmann/json.hpp>

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_relation_command)

using namespace tetracone::verify;
using Json = nlohmann::ordered_json;

namespace {

const std::string poses =
    "1 0 0 1.5 0 1 0 2.25 0 0 1 0.25\n3/5 -4/5 0 1 4/5 3/5 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n"
    "0.25 0 0 0.5 0 0.25 0 0.5 0 0 0.25 0.5\n1 0 0 1/3 0 1 0 0 0 0 1 0\n";

struct Files {
  Temporary_file poses_b{"poses", poses};
  std::string words() const
  {
    return "relation " + in_quotes(cube) + " " + in_quotes(cube) + " --pose-b " + in_quotes(poses_b.path());
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(relations_dimensions_and_volumes_are_columns)
{
  const Files files;
  BOOST_TEST(run(files.words()).out == "disjoint -\noverlap 2\nmeet 2\ncontains -\noverlap 2\n");
  BOOST_TEST(run(files.words() + " --volume").out ==
             "disjoint - 0\noverlap 2 0.5\nmeet 2 0\ncontains - 0.015625\noverlap 2 0.6666666666666666\n");
  BOOST_TEST(run(files.words() + " --volume --exact").out ==
             "disjoint - 0 0 0 0\noverlap 2 1/2 7/10 3/5 1/2\nmeet 2 0 0 0 0\ncontains - 1/64 5/8 5/8 5/8\n"
             "overlap 2 2/3 2/3 1/2 1/2\n");
}

BOOST_AUTO_TEST_CASE(tables_have_the_centroid_too)
{
  const Files files;
  const std::string csv = files.words() + " --csv /dev/stdout";
  BOOST_TEST(run(csv).out.starts_with("pose,relation,dimension\n0,disjoint,-\n1,overlap,2\n"));
  BOOST_TEST(run(csv + " --volume").out.starts_with("pose,relation,dimension,volume,x,y,z\n0,disjoint,-,0,0,0,0\n"));
  BOOST_TEST(
      run(csv + " --exact --time").out.starts_with("pose,relation,dimension,volume,x,y,z,ns\n0,disjoint,-,0,0,0,0,"));
  const Json rows = Json::parse(run(files.words() + " --json --volume").out);
  BOOST_TEST(rows[0]["dimension"].is_null());
  BOOST_TEST(rows[2]["relation"] == "meet");
  BOOST_TEST(rows[2]["contact_area"] == Json({1.0, 1.0}));
  BOOST_TEST(rows[2]["contact_vector"] == Json({1.0, 0.0, 0.0}));
}

BOOST_AUTO_TEST_CASE(what_has_no_answer_is_refused_in_one_line)
{
  const Files files;
  for (const char* words : {" --kernel double", " --time", " --json --csv x.csv", " --repeat 0"}) {
    const Run r = run(files.words() + words);
    BOOST_TEST(r.status == 2, words);
    BOOST_TEST(r.out.empty());
  }
  const Temporary_file open("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  BOOST_TEST(run("relation " + in_quotes(cube) + " " + in_quotes(open.path())).status == 2);
}

BOOST_AUTO_TEST_CASE(a_scene_tells_relations_too)
{
  const Temporary_file scene("s.scene.json",
                             "{\"models\": {\"c\": " + Json(cube).dump() +
                                 "}, \"bodies\": [{\"model\": \"c\"}, {\"model\": \"c\"}, {\"model\": \"c\"}], "
                                 "\"frames\": [[[1,0,0,0,0,1,0,0,0,0,1,0], [1,0,0,1,0,1,0,0,0,0,1,0], "
                                 "[1,0,0,1.5,0,1,0,1,0,0,1,1]]]}");
  const std::string words = "scene " + in_quotes(scene.path()) + " --relation";
  BOOST_TEST(run(words).out == "0 0 1 meet 2\n0 1 2 meet 1\n");
  BOOST_TEST(run(words + " --csv /dev/stdout").out == "frame,a,b,relation,dimension\n0,0,1,meet,2\n0,1,2,meet,1\n");
  BOOST_TEST(Json::parse(run(words + " --json").out)[0]["relations"][1] ==
             Json::parse(R"({"relation": "meet", "dimension": 1})"));
  BOOST_TEST(run(words + " --question surface").status == 2);
}

BOOST_AUTO_TEST_SUITE_END()
