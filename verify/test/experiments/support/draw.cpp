#include "experiments/support/draw.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

BOOST_AUTO_TEST_SUITE(test_draw)

using namespace tetracone::experiments;
using tetracone::covering::Input_error;
using tetracone::verify::Temporary_folder;

BOOST_AUTO_TEST_CASE(a_script_that_is_missing_is_named)
{
  const auto says = [](const Input_error& error) {
    return std::string(error.what())
        .ends_with(
            "/experiments/report/no_script.py: no such file; expected it among the sources that this program was built "
            "from, or installed with it");
  };
  BOOST_CHECK_EXCEPTION(draw("no_script.py", "out"), Input_error, says);
}

BOOST_AUTO_TEST_CASE(a_script_that_fails_has_the_last_word)
{
  // It wants a table that is not there.
  const Temporary_folder folder("draw");
  const auto is_one_line = [](const std::runtime_error& error) {
    const std::string what = error.what();
    return what.find('\n') == std::string::npos && what.find("; expected") != std::string::npos &&
           what.find("Traceback") == std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(draw("report.py", folder.path()), std::runtime_error, is_one_line);
  BOOST_CHECK_EXCEPTION(draw("draw_peers.py", folder.path()), std::runtime_error, is_one_line);
}

BOOST_AUTO_TEST_SUITE_END()
