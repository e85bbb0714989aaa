// Runs `tetracone experiment contact-cost` itself, of a few poses.

#include "tetracone/covering/io/write.h"
#include "verify/cases/shape_generators.h"
#include "verify/test/support/csv_rows.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_contact_cost)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(every_question_has_its_verdicts_and_exact_ones_are_right)
{
  const Temporary_folder folder("contact_cost");
  // A mesh takes the place of the one that is downloaded.
  std::filesystem::create_directories(folder.path() / "meshes");
  std::ofstream(folder.path() / "meshes" / "bunny00.off") << tetracone::covering::write_off(blob(1000, 1));
  const std::string in_folder = in_quotes(folder.path());
  const Run r = run("experiment contact-cost --rotations 4 --models " + in_folder + " --out " + in_folder);
  BOOST_TEST_REQUIRE(r.status == 0, r.error);

  std::map<std::string, std::size_t> wrong_in_double;  // by question
  std::map<std::string, std::set<std::string>> subjects;
  std::set<std::pair<std::string, std::string>> in_contact;
  for (const auto& row : csv_rows(folder.path() / "contact_cost.csv")) {
    const auto count = [&row](const std::string& name) { return std::stoull(row.at(name)); };
    const std::string &question = row.at("question"), &subject = row.at("subject");
    const std::size_t wrong = count("false_positives") + count("false_negatives");
    const std::string which = question + ", " + row.at("scenario") + ", " + subject;
    if (row.at("exact") == "1") BOOST_TEST(wrong == 0u, which);
    if (row.at("kernel") == "double") wrong_in_double[question] += wrong;
    BOOST_TEST(count("poses") > 0u, which);
    BOOST_TEST(count("mean_ns") > 0u, which);
    const std::string& again = row.at("again");
    BOOST_TEST(again.starts_with("\"build/tetracone experiment contact-cost --out out"), which);
    BOOST_TEST(again.find(" --rotations 4 ") != std::string::npos, which);
    subjects[question].insert(subject);
    if (count("collisions") > 0) in_contact.emplace(question, row.at("scenario"));
  }
  const std::set<std::string> trees = {"adaptive tree", "double tree", "epeck tree"};
  std::set<std::string> with_fcl = trees;
  if (subjects["surface"].size() > trees.size()) with_fcl.insert("FCL OBBRSS");  // FCL is installed
  const std::map<std::string, std::set<std::string>> expected = {
      {"surface", with_fcl},
      {"solid", trees},
      {"contacts", {"adaptive tree", "epeck tree"}},
      {"contacts of triangles", {"adaptive tree", "epeck tree"}},
      {"distance", {"adaptive tree", "double tree", "rational tree"}},
      {"motion", {"adaptive tree"}},
      {"point", trees},
      {"point by table", {"adaptive locator"}},
      {"ray", {"adaptive tree", "double moeller-trumbore"}},
      {"scene", trees},
      {"solid relation", {"adaptive tree"}}};
  BOOST_TEST((subjects == expected));
  for (const std::string question :
       {"surface", "contacts", "contacts of triangles", "solid relation", "distance", "motion"})
    for (const std::string shared : {"face", "edge", "vertex"})
      BOOST_TEST(in_contact.contains({question, "shared " + shared}), question + ", " + shared);
  for (const std::string at : {"on a vertex", "on an edge", "on a face"})
    BOOST_TEST(in_contact.contains({"point", at}), at);
  // The verdicts see what is wrong: double is, under turned poses and at vertices and edges.
  for (const std::string question : {"surface", "distance", "ray", "scene"})
    BOOST_TEST(wrong_in_double[question] > 0u, question);
}

BOOST_AUTO_TEST_SUITE_END()
