#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_scene_command)

using namespace tetracone::verify;

namespace {

std::string at(const std::string& x) { return "[1, 0, 0, " + x + ", 0, 1, 0, 0, 0, 0, 1, 0]"; }

/// Three cubes: the first two touch in frame 0, in frame 1 they are 10^-20 apart and the last two meet.
std::string scene(const std::string& frames, const std::string& more = "")
{
  return "{\"models\": {\"cube\": \"" + cube +
         "\", \"unused\": \"nothing.off\"},\n \"bodies\": [{\"model\": \"cube\"}, {\"model\": \"cube\"}, {\"model\": "
         "\"cube\"}],\n \"frames\": [\n" +
         frames + "]" + more + "}\n";
}
std::string frame(const std::string& x, const std::string& y, const std::string& z)
{
  return "  [" + at(x) + ", " + at(y) + ", " + at(z) + "]";
}
const std::string two_frames =
    frame("0", "1", "5") + ",\n" + frame("0", "\"100000000000000000001/100000000000000000000\"", "1.5");

}  // namespace

BOOST_AUTO_TEST_CASE(a_pair_has_a_line_and_a_frame_has_a_row)
{
  const Temporary_file file("touch.scene.json", scene(two_frames)),
      without("without.scene.json", scene(two_frames, ", \"ignore\": [[1, 0]]"));
  const std::string ask = "scene " + in_quotes(file.path());
  BOOST_TEST(run(ask).out == "0 0 1\n1 1 2\n");
  BOOST_TEST(run(ask + " --kernel rational --question surface --threads 2").out == "0 0 1\n1 1 2\n");
  BOOST_TEST(run("scene " + in_quotes(without.path())).out == "1 1 2\n");
  BOOST_TEST(run(ask + " --csv /dev/stdout").out == "frame,a,b\n0,0,1\n1,1,2\n");
  const std::string times = run(ask + " --csv /dev/stdout --time").out;
  BOOST_TEST(times.starts_with("frame,pairs,ns,candidates,queries,nodes_made,bytes\n0,1,"), times);
  BOOST_TEST(run(ask + " --json").out.starts_with("[\n  {\"frame\": 0, \"pairs\": [[0, 1]]},\n"));
  BOOST_TEST(contains(run(ask + " --budget 1 --csv /dev/stdout").out, ",undecided,"));
}

BOOST_AUTO_TEST_CASE(pairs_within_a_distance_have_a_line_with_it)
{
  const Temporary_file file("touch.scene.json", scene(two_frames));
  const std::string ask = "scene " + in_quotes(file.path());
  BOOST_TEST(run(ask + " --within 3").out == "0 0 1 0\n0 1 2 3\n1 0 1 1e-20\n1 0 2 0.5\n1 1 2 0\n");
  BOOST_TEST(run(ask + " --within 0 --threads 2").out == "0 0 1 0\n1 1 2 0\n");
  BOOST_TEST(run(ask + " --within 1/100000000000000000000").out == "0 0 1 0\n1 0 1 1e-20\n1 1 2 0\n");
  BOOST_TEST(run(ask + " --within 1/100000000000000000001").out == "0 0 1 0\n1 1 2 0\n");
  BOOST_TEST(run(ask + " --within 0 --csv /dev/stdout").out == "frame,a,b,distance\n0,0,1,0\n1,1,2,0\n");
  check_refused(ask + " --within x", "--within x: expected a decimal number");
  check_refused(ask + " --within 1 --budget 5", "expected without --motion and --budget");
}

BOOST_AUTO_TEST_CASE(what_meets_between_frames_has_a_line_in_order_of_time)
{
  // From 5 to 1.5 the last cube meets the second, which is 10^-20 further than at first, at t = 6/7.
  const Temporary_file file("moving.scene.json", scene(two_frames + ",\n" + frame("3", "1", "0")));
  const std::string ask = "scene " + in_quotes(file.path()) + " --motion linear";
  const std::string first = "0 0 1 0 0\n0 1 2 0.8571428571428571 0.8571428571428572\n";
  BOOST_TEST(run(ask).out.starts_with(first + "1 1 2 0 0\n"));
  BOOST_TEST(run(ask + " --threads 2").out == run(ask).out);
  BOOST_TEST(run(ask + " --csv /dev/stdout").out.starts_with("frame,a,b,lo,hi\n0,0,1,0,0\n0,1,2,0.857"));
  BOOST_TEST(
      run(ask + " --json")
          .out.starts_with(
              "[\n  {\"frame\": 0, \"contacts\": [{\"pair\": [0, 1], \"lo\": 0, \"hi\": 0}, {\"pair\": [1, 2], "));
  BOOST_TEST(run(ask + " --csv /dev/stdout --time")
                 .out.starts_with("frame,pairs,ns,candidates,queries,nodes_made,bytes\n0,2,"));
  BOOST_TEST(run("scene " + in_quotes(Temporary_file("one.scene.json", scene(frame("0", "1", "5"))).path()) +
                 " --motion linear")
                 .out.empty());
  check_refused(ask + " --budget 1", "--budget: expected without --motion");
  check_refused(ask + " --kernel double", "kernel double follows no motion");
  check_refused("scene " + in_quotes(file.path()) + " --motion screw", "expected linear or rigid");
  check_refused("scene " + in_quotes(file.path()) + " --motion rigid", "expected 7: a quaternion");
}

BOOST_AUTO_TEST_CASE(rigid_frames_are_quaternions_and_translations)
{
  const auto at = [](const std::string& x, const std::string& q) { return "[" + q + ", " + x + ", 0, 0]"; };
  const std::string still = "1, 0, 0, 0", turned = "1, 0, 0, 1", none = "0, 0, 0, 0", against = "-2, 0, 0, 0";
  const auto text = [&](const std::string& to) {
    return scene("[" + at("0", still) + ", " + at("\"5/2\"", still) + ", " + at("9", still) + "], [" + at("0", to) +
                 ", " + at("1.5", still) + ", " + at("9", still) + "]");
  };
  const auto ask = [](const Temporary_file& file) { return "scene " + in_quotes(file.path()) + " --motion rigid"; };
  const Temporary_file rest("rest.scene.json", text(still)), turn("turn.scene.json", text(turned)),
      zero("zero.scene.json", text(none)), opposite("opposite.scene.json", text(against));
  // A cube's corner reaches sqrt 2 from its axis, and 5/2 - t is 1.5 at least.
  BOOST_TEST(run(ask(rest)).out.empty());
  BOOST_TEST(run(ask(turn)).status == 0);
  check_refused(ask(zero), "has the quaternion 0");
  check_refused(ask(opposite), "one quaternion between them is 0");
  const Temporary_file frames("rigid.bin", "");
  {
    std::ofstream out(frames.path(), std::ios::binary);
    for (const double x : {0.0, 3.0, 9.0, 0.0, -3.0, 9.0}) {
      const double pose[7] = {1, 0, 0, 0, x, 0.25, 0.25};
      out.write(reinterpret_cast<const char*>(pose), sizeof pose);
    }
  }
  std::string binary = scene("");
  binary.replace(binary.find("\"frames\""), std::string::npos,
                 "\"frames_file\": \"" + frames.path().string() + "\"}\n");
  const Temporary_file file("rigid.scene.json", binary);
  BOOST_TEST(run(ask(file)).out.starts_with("0 0 1 0.3333333333333333 0.333333333333333"));
  check_refused("scene " + in_quotes(file.path()), "expected a multiple of 288, 12 doubles a body and frame");
}

BOOST_AUTO_TEST_CASE(frames_may_be_doubles_of_a_file)
{
  const Temporary_file frames("frames.bin", "");
  {
    std::ofstream out(frames.path(), std::ios::binary);
    for (const double x : {0.0, 0.5, 9.0}) {
      const double pose[12] = {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0};
      out.write(reinterpret_cast<const char*>(pose), sizeof pose);
    }
  }
  std::string text = scene("");
  text.replace(text.find("\"frames\""), std::string::npos, "\"frames_file\": \"" + frames.path().string() + "\"}\n");
  const Temporary_file file("binary.scene.json", text);
  BOOST_TEST(run("scene " + in_quotes(file.path())).out == "0 0 1\n");
  std::filesystem::resize_file(frames.path(), 300);
  check_refused("scene " + in_quotes(file.path()), "expected a multiple of 288, 12 doubles a body and frame");
}

BOOST_AUTO_TEST_CASE(what_was_computed_before_a_fault_is_kept)
{
  const Temporary_file flat("flat.scene.json", scene(two_frames + ",\n  [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0], " +
                                                     at("0") + ", " + at("9") + "]")),
      csv("kept.csv", "");
  const Run r = run("scene " + in_quotes(flat.path()));
  BOOST_TEST(r.status == 2);
  BOOST_TEST(r.out == "0 0 1\n1 1 2\n");
  BOOST_TEST(
      r.error.ends_with(
          ".scene.json:6: /frames/2/0 has a 3x3 part of determinant 0; expected a matrix that flattens nothing\n"),
      r.error);
  BOOST_TEST(run("scene " + in_quotes(flat.path()) + " --csv " + in_quotes(csv.path())).status == 2);
  BOOST_TEST(contents(csv.path()) == "frame,a,b\n0,0,1\n1,1,2\n");
}

BOOST_AUTO_TEST_CASE(a_scene_that_is_none_is_refused_with_its_line)
{
  const auto refused = [](const std::string& text, const std::string& says) {
    const Temporary_file file("bad.scene.json", text);
    check_refused("scene " + in_quotes(file.path()), says);
  };
  const std::string good = scene(two_frames);
  const auto with = [&good](const std::string& what, const std::string& instead) {
    std::string text = good;
    return text.replace(text.find(what), what.size(), instead);
  };
  refused("{", "expected a scene file as JSON");
  refused(with("\"bodies\"", "\"bodys\""), "is unknown here");
  refused(with("[{\"model\": \"cube\"}, ", "[{\"model\": \"cub\"}, "), ":2: /bodies/0/model 'cub' is no model");
  refused(scene(two_frames, ", \"ignore\": [[0, 3]]"), "/ignore/0/1 is no such integer; expected one from 0 to 2");
  refused(scene(two_frames, ", \"ignore\": [[1, 1]]"), "is one body twice");
  refused(scene(two_frames, ", \"frames_file\": \"x\""), "expected either 'frames' or 'frames_file'");
  refused(scene("  [" + at("0") + "]"), ":4: /frames/0 has 1 elements; expected 3: a pose a body");
  refused(scene("  [[1], " + at("0") + ", " + at("1") + "]"), "expected 12: the rows of a 3x4 matrix");
  refused(with("cube.off", "none.off"), "none.off: no such file");
  const Temporary_file file("touch.scene.json", good);
  const std::string ask = "scene " + in_quotes(file.path());
  check_refused(ask + " --time", "--time: expected --csv or --json");
  check_refused(ask + " --budget -1", "expected nanoseconds");
  check_refused(ask + " --kernel exact", "--kernel exact");
  check_refused(ask + " --csv " + in_quotes(file.path()), "is an input too");
}

BOOST_AUTO_TEST_SUITE_END()
