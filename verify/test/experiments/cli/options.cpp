// Runs the program itself: options out of their range, and words that are empty.

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_options)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(numbers_out_of_their_range_are_refused_at_once)
{
  for (const std::string number : {"-1", "0", "1e9", "nan", "99999999999999999999", "x"}) {
    check_refused("experiment dataset --out /nowhere/x --cases " + number, "--cases");
    check_refused("experiment study --out /nowhere/x --frames " + number, "--frames");
    check_refused("experiment study --out /nowhere/x --rotations " + number, "--rotations");
    check_refused("experiment peers --out /nowhere/x --race-frames " + number, "--race-frames");
    check_refused("experiment sign-maps --out /nowhere/x --size " + number, "--size");
    check_refused("verify --db /nowhere/x --cases " + number, "--cases");
    check_refused("collide " + cube + " " + cube + " --repeat " + number, "--repeat");
  }
  for (const std::string number : {"-1", "nan", "0.5", "18446744073709551615", "18446744073709551616"}) {
    check_refused("experiment dataset --out /nowhere/x --seed " + number, "--seed");
    check_refused("verify --db /nowhere/x --seed " + number, "--seed");
    check_refused("fuzz --out /nowhere/x --seed " + number, "--seed");
  }
  for (const std::string number : {"-1", "nan", "-nan", "inf", "1e10", "x"})
    check_refused("fuzz --out /nowhere/x --seconds " + number, "--seconds");
  check_refused("verify --db /nowhere/x --frames -1", "--frames");
}

BOOST_AUTO_TEST_CASE(an_empty_word_is_refused_by_name)
{
  const std::string collide = "collide " + cube + " " + cube;
  for (const std::string option :
       {"--pose-a", "--pose-b", "--csv", "--kernel", "--compare", "--method", "--question", "--repeat"}) {
    check_refused(collide + " " + option + " ''", option + ": an empty word; expected a value");
    check_refused(collide + " " + option + "='' --json", option + "=: an empty word; expected a value");
  }
  check_refused("collide '' " + cube, "A: an empty word");
  check_refused("collide " + cube + " ''", "B: an empty word");
  for (const std::string option :
       {"--db", "--cases", "--seed", "--shard", "--family", "--subject", "--level", "--frames"})
    check_refused("verify " + option + " ''", option);
  for (const std::string option : {"--seconds", "--seed", "--subject", "--out"})
    check_refused("fuzz " + option + " ''", option);
  for (const std::string option : {"--out", "--models", "--model", "--seed", "--cases"})
    check_refused("experiment method " + option + " ''", option);
  check_refused("view " + cube + " --out ''", "--out: an empty word");
  check_refused("report ''", "DB: an empty word");
  check_refused("report x.db --out ''", "--out: an empty word");
  check_refused("report x.db --table ''", "--table: an empty word");
  check_refused("merge '' x.db", "INTO: an empty word");
  check_refused("merge x.db ''", "FROM: an empty word");
  check_refused("inside " + cube + " ''", "POINTS: an empty word");
  check_refused("ray " + cube + " ''", "RAYS: an empty word");
}

BOOST_AUTO_TEST_SUITE_END()
