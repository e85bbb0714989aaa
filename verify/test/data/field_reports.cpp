// Small inputs after reports of other libraries' users, of the folder of real data: the program, asked as they asked.

#include "verify/test/support/data_folder.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_field_reports)

using namespace tetracone::verify;

namespace {

std::string file(const std::string& name) { return in_quotes(scenes::data_folder() / "field-reports" / name); }

}  // namespace

BOOST_AUTO_TEST_CASE(models_are_read_whole)
{
  if (scenes::without_data()) return;
  for (const char* name : {"nan_colour.obj", "solid_tab.stl", "line_feed.stl"}) {
    const Run r = run("check " + file(name));
    BOOST_TEST(r.status == 0, name << ": " << r.error);
    BOOST_TEST(contains(r.out, "volume              1, outward"), name);
    BOOST_TEST(contains(r.out, "note"), name);  // a colour or bytes that CGAL does not take
  }
  const Run r = run("check " + file("group_backslash.obj"));
  BOOST_TEST(r.status == 0);
  BOOST_TEST(contains(r.out, "4, 4 triangles"));
  BOOST_TEST(contains(r.out, "backslash"));
  // Every other command says so, too.
  BOOST_TEST(contains(run("ray " + file("group_backslash.obj") + " " + file("fold.ray")).error, "backslash"));
}

BOOST_AUTO_TEST_CASE(a_soup_is_refused_with_the_option_that_closes_it)
{
  if (scenes::without_data()) return;
  const Temporary_file points("points.txt", "0.5 0.5 0.5\n");
  check_refused("inside " + file("soup.obj") + " " + in_quotes(points.path()), "merging equal vertices would: --merge");
  BOOST_TEST(run("inside --merge " + file("soup.obj") + " " + in_quotes(points.path())).out == "1\n");
}

BOOST_AUTO_TEST_CASE(a_folded_face_is_named_at_each_crossing)
{
  if (scenes::without_data()) return;
  BOOST_TEST(run("ray --all " + file("fold.off") + " " + file("fold.ray")).out == "0 4.5 6 5 8 5 7 5.05 0 5.5\n");
  // The faces of fold2 are those of fold, the first as two triangles.
  BOOST_TEST(run("ray --all " + file("fold2.off") + " " + file("fold.ray")).out == "0 4.5 7 5 9 5 8 5.05 1 5.5\n");
}

BOOST_AUTO_TEST_SUITE_END()
