// Runs the program itself: where its output may go, and what is said when it cannot.

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_output)

using namespace tetracone::verify;
namespace fs = std::filesystem;

namespace {

const std::string collide = "collide " + cube + " " + cube;
const std::string table = "pose,answer\n0,1\n";

/// A folder that is there.
struct Folder : Temporary_folder {
  explicit Folder(const std::string& name) : Temporary_folder(name) { fs::create_directory(path()); }

  std::size_t entries() const
  {
    return std::size_t(std::distance(fs::directory_iterator(path()), fs::directory_iterator()));
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_device_stays_a_device)
{
  BOOST_TEST(run(collide + " --csv /dev/null").status == 0);
  BOOST_TEST(fs::is_character_file("/dev/null"));
  const Run r = run(collide + " --csv /dev/stdout");
  BOOST_TEST(r.status == 0);
  BOOST_TEST(r.out == table);
  BOOST_TEST(fs::is_symlink("/dev/stdout"));
}

BOOST_AUTO_TEST_CASE(a_fifo_is_written_and_stays_one)
{
  const Folder folder("fifo");
  const fs::path fifo = folder.path() / "fifo", copy = folder.path() / "copy";
  BOOST_TEST_REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);
  const Run r =
      run(collide + " --csv " + in_quotes(fifo) + "; wait", "cat " + in_quotes(fifo) + " >" + in_quotes(copy) + " & ");
  BOOST_TEST(r.status == 0);
  BOOST_TEST(fs::is_fifo(fifo));
  BOOST_TEST(contents(copy) == table);
}

BOOST_AUTO_TEST_CASE(a_link_is_followed_and_stays_one)
{
  const Folder folder("links");
  const fs::path link = folder.path() / "link", again = folder.path() / "again", file = folder.path() / "file";
  fs::create_symlink("file", link);
  fs::create_symlink(link, again);
  for (const fs::path& name : {link, again}) {  // to no file yet, then to one
    BOOST_TEST(run(collide + " --csv " + in_quotes(name)).status == 0);
    BOOST_TEST(contents(file) == table);
    BOOST_TEST(fs::is_symlink(name));
  }
  BOOST_TEST(folder.entries() == 3u);
  const fs::path round = folder.path() / "round";
  fs::create_symlink("round", round);
  check_refused(collide + " --csv " + in_quotes(round), "symbolic links");
  BOOST_TEST(fs::is_symlink(round));
}

BOOST_AUTO_TEST_CASE(what_the_shell_goes_on_to_write_is_kept)
{
  const Temporary_file log("log", "before\n");
  run(collide + " --csv /dev/stdout; echo after; } >>" + in_quotes(log.path()), "{ ");
  BOOST_TEST(contents(log.path()) == "before\n" + table + "after\n");
}

BOOST_AUTO_TEST_CASE(an_input_is_no_output)
{
  const Folder folder("inputs");
  const fs::path model = folder.path() / "a.off", poses = folder.path() / "poses.txt", link = folder.path() / "link",
                 hard = folder.path() / "hard";
  fs::copy_file(cube, model);
  fs::copy_file(models + "poses.txt", poses);
  fs::create_symlink(model, link);
  fs::create_hard_link(poses, hard);
  const std::string words = in_quotes(model) + " " + cube + " --pose-b " + in_quotes(poses);
  const std::string around = folder.path().native() + "/../" + folder.path().filename().native() + "/a.off";
  for (const fs::path& output : {model, poses, link, hard, fs::path(around)}) {
    check_refused("collide " + words + " --csv " + in_quotes(output), "is an input too");
    check_refused("view " + words + " --out " + in_quotes(output), "is an input too");
  }
  BOOST_TEST(contents(model) == contents(cube));
  BOOST_TEST(contents(poses) == contents(models + "poses.txt"));
  const fs::path poly = folder.path() / "t.poly", node = folder.path() / "t.node";
  fs::copy_file(models + "tetrahedron.poly", poly);
  fs::copy_file(models + "tetrahedron.node", node);
  check_refused("collide " + cube + " " + in_quotes(poly) + " --csv " + in_quotes(node), "is an input too");
}

BOOST_AUTO_TEST_CASE(a_failed_write_says_why_and_leaves_what_was_there)
{
  check_refused(collide + " --csv /dev/full", "/dev/full: cannot be written: No space left on device");
  check_refused(collide + " --csv " + models, "cannot be written: Is a directory");
  check_refused(collide + " --csv " + cube + "/x.csv", "cannot be written: Not a directory");
  check_refused(collide + " --csv /no/such/folder/x.csv", "cannot be written: No such file or directory");
  // No file may grow.
  const Folder folder("limit");
  const fs::path file = folder.path() / "old.csv";
  std::ofstream(file) << "old\n";
  const Run r = run(collide + " --csv " + in_quotes(file), "trap '' XFSZ; ulimit -f 0; exec ");
  BOOST_TEST(r.status == 2);
  BOOST_TEST(contents(file) == "old\n");
  BOOST_TEST(folder.entries() == 1u);
}

BOOST_AUTO_TEST_CASE(a_full_standard_output_is_status_2_with_the_reason)
{
  for (const std::string& words : {std::string("--help"), std::string("--version"), std::string("collide --help"),
                                   std::string("experiment --list"), "check " + cube}) {
    const Run r = run(words + " >/dev/full");
    BOOST_TEST(r.status == 2, words);
    BOOST_TEST(contains(r.error, "No space left on device"), words << ": " << r.error);
    BOOST_TEST(r.error.find('\n') + 1 == r.error.size(), words << ": " << r.error);
  }
  BOOST_TEST(run(collide + " >/dev/full").status == 2);
}

BOOST_AUTO_TEST_SUITE_END()
