#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_save_command)

using namespace tetracone::verify;

namespace {

const std::string frame = models + "frame.poly", lifted = models + "lifted.obj", open = models + "open.stl";

}  // namespace

BOOST_AUTO_TEST_CASE(a_saved_body_is_taken_wherever_a_model_is)
{
  const Temporary_file a("a.body", ""), b("b.body", ""), points("points.txt", "0.5 0.5 0.5\n1 1/3 1/7\n2 0 0\n"),
      rays("rays.txt", "-1 0.5 0.5 3 0 0\n5 5 5 1 0 0\n");
  const std::string in_a = in_quotes(a.path()), in_b = in_quotes(b.path());
  BOOST_TEST(run("save " + cube + " --out " + in_a).status == 0);
  BOOST_TEST(run("save " + frame + " --out " + in_b).status == 0);
  for (const std::string command : {"collide", "distance", "collide --features",
                                    "collide --kernel rational --method brute", "collide --method paper"}) {
    const auto of_models = run(command + " " + cube + " " + frame), of_saved = run(command + " " + in_a + " " + in_b);
    BOOST_TEST(of_saved.status == of_models.status);
    BOOST_TEST(of_saved.out == of_models.out, command);
    BOOST_TEST(of_saved.error == of_models.error, command);
  }
  const auto same = [&](const std::string& before, const std::string& behind) {
    const auto of_model = run(before + " " + cube + " " + behind), of_saved = run(before + " " + in_a + " " + behind);
    BOOST_TEST(of_saved.status == 0, of_saved.error);
    BOOST_TEST(of_saved.out == of_model.out);
  };
  same("inside", in_quotes(points.path()));
  same("ray --all", in_quotes(rays.path()));
  same("collide --merge", frame);
  const std::string checked = run("check " + in_a).out, of_model = run("check " + cube).out;
  BOOST_TEST(checked.substr(checked.find('\n')) == of_model.substr(of_model.find('\n')));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_saved_or_is_spoiled_is_refused)
{
  const Temporary_file file("refused.body", "");
  const std::string saved = in_quotes(file.path());
  check_refused("save " + cube, "--out");
  check_refused("save " + cube + " --out cube.off", "--out cube.off: expected a name that ends in .body");
  check_refused("save " + lifted + " --strict --out " + saved, "is not exactly planar");
  check_refused("save " + cube + " --out " + in_quotes(temporary_path("no folder") / "cube.body"), "cannot be written");
  check_refused("collide " + saved + " " + cube, "refused.body: the file is empty; expected a saved body");
  BOOST_TEST(run("save " + open + " --out " + saved).status == 0);
  check_refused("save " + saved + " --out " + saved, "is an input too");
  check_refused("collide " + saved + " " + cube, "an open surface has no solid");
  BOOST_TEST(run("collide --question surface " + saved + " " + cube).status == 0);
  std::string bytes = contents(file.path());
  bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(file.path(), std::ios::binary) << bytes;
  for (const std::string command : {"collide --question surface ", "distance ", "check "})
    check_refused(command + saved + (command == "check " ? "" : " " + cube),
                  "refused.body: is spoiled: its checksum is not that of its bytes; expected the file as it was saved");
}

BOOST_AUTO_TEST_SUITE_END()
