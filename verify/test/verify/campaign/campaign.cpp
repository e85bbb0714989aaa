#include "verify/campaign/campaign.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/campaign/campaign_words.h"
#include "verify/campaign/tables.h"
#include "verify/test/support/database_number.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/temporary_file.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/predicate_truth.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_campaign)

using namespace tetracone::verify;
namespace scenes = tetracone::verify::scenes;
using scenes::Polyhedron;
using scenes::Pose;
using tetracone::covering::Input_error;
using Mode = Database::Mode;

namespace {

// Families of the test's own: cheap, and of known answers.

Predicate_case points(tetracone::verify::Random& random, double)
{
  const auto grid = [&] {
    return tetracone::kernel::Vertex{double(random.bits() % 5), double(random.bits() % 5), double(random.bits() % 5)};
  };
  return {{grid(), grid(), grid(), grid()}, grid(), grid(), grid(), Pose(), Pose(), {}};
}

Object_case cubes_apart(double gap)
{
  static const auto cube = std::make_shared<const Polyhedron>(scenes::unit_cube());
  return {cube, cube, Pose(), Pose::translation(1 + gap, 0.25, 0), {}, gap == 0, gap == 0};
}

Object_case cubes(tetracone::verify::Random& random, double gap)
{
  return cubes_apart(random.bits() % 2 == 0 ? 0 : gap);
}

Object_case nonsense(tetracone::verify::Random& random, double gap)
{
  Object_case c = cubes(random, gap);
  c.surface = !*c.surface;
  return c;
}

/// Cubes that touch, every other case under poses with thirds.
Object_case thirds(tetracone::verify::Random&, double third)
{
  Object_case c = cubes_apart(0);
  const tetracone::kernel::Rational shift(third == 0 ? "1/4" : "1/3");
  c.pose_a = c.pose_b = Pose::from_quaternion(1, 0, 0, 0, {shift, 0, 0});
  return c;
}

const Family cheap{{"cheap", "", "gap", {1, 0.5}, 1}, points, cubes};
const Family cheap_too{{"cheap-too", "", "gap", {0.25}, 2}, points, cubes};
const Family turned{{"turned", "", "third", {0, 1}, 4}, points, thirds};
const Family lying{{"lying", "", "gap", {1}, 3}, points, nonsense};

/// Says the same of every case.
template <Outcome outcome>
class Says : public Running_subject {
 public:
  Outcome operator()(const Object_case&, Question) override { return outcome; }
};

/// As a library of doubles: declines fractions, says no to the rest; 3 ns for making what it was made to forget, and 4
/// to answer.
class Of_doubles : public Running_subject {
 public:
  Outcome operator()(const Object_case& c, Question) override
  {
    spent_.reset();
    if (c.pose_a.is_rational() || c.pose_b.is_rational()) return Outcome::not_asked;
    spent_ = Spent{std::uint64_t(has_forgotten_ ? 3 : 0), 4};
    has_forgotten_ = false;
    return Outcome::no;
  }
  void forget() override { has_forgotten_ = true; }
  std::optional<Spent> spent() const override { return spent_; }

 private:
  bool has_forgotten_ = false;
  std::optional<Spent> spent_;
};

/// Right except for one pair, which it invents or leaves out.
template <bool invents>
class Lists : public Running_subject {
 public:
  Outcome operator()(const Object_case&, Question) override { return Outcome::not_asked; }
  Told<Feature_pairs> features(const Object_case& c) override
  {
    Feature_pairs pairs = tetracone::verify::features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b);
    if (invents)
      pairs.push_back({2, 0, 0, 0, tetracone::kernel::Contact::edge_face});
    else if (!pairs.empty())
      pairs.pop_back();
    return {Outcome::yes, pairs};
  }
};

Object_subject says_no{"says no", false, "", {},          [] { return std::make_unique<Says<Outcome::no>>(); },
                       "",        "",    "", Knows::both, In_floats::vertices_and_poses};
Object_subject of_doubles_alone{"of doubles", false, "", {}, [] { return std::make_unique<Of_doubles>(); }};
Object_subject fails{"fails", false, "", {}, [] { return std::make_unique<Says<Outcome::failed>>(); }};
Object_subject declines{"declines", false, "", {}, [] { return std::make_unique<Says<Outcome::not_asked>>(); }};

Object_subject invents{"invents", false, "", {}, [] { return std::make_unique<Lists<true>>(); }};
Object_subject leaves_out{"leaves out", false, "", {}, [] { return std::make_unique<Lists<false>>(); }};

Predicate_subject right{"right", true, "",
                        [](Predicate predicate, const Predicate_case& c) { return true_answer(predicate, c); }};
Predicate_subject low{"low", false, "", [](Predicate, const Predicate_case&) { return std::optional<int>(-7); }};

void set_families(Campaign& campaign, const std::vector<const Family*>& families)
{
  campaign.at<levels::Predicates>().families = campaign.at<levels::Objects>().families =
      campaign.at<levels::Features>().families = families;
}

std::vector<Object_subject>& object_subjects_of(Campaign& campaign) { return campaign.at<levels::Objects>().subjects; }

Campaign small()
{
  Campaign campaign;
  campaign.seed = 5;
  campaign.predicate_cases = 450;
  campaign.object_cases = 25;
  campaign.feature_cases = 8;
  campaign.sequence_frames = 0;
  set_families(campaign, {&cheap, &cheap_too});
  campaign.at<levels::Predicates>().subjects = {right, low};
  object_subjects_of(campaign) = {object_subject(*Subject::parse("adaptive")),
                                  object_subject(*Subject::parse("double", Method::paper)), says_no, fails, declines};
  campaign.at<levels::Features>().subjects = {object_subject(*Subject::parse("adaptive")), invents, leaves_out, fails,
                                              declines};
  campaign.made_by = {"0", "compiler", "flags", "processor"};
  return campaign;
}

std::string name_of(const char* name) { return std::string("campaign_") + name + ".db"; }

struct Results {
  explicit Results(const char* name) : file(name_of(name), ""), database(file.path(), Mode::write) {}
  Results& with(const Campaign& campaign)
  {
    run_campaign(database, campaign, [](std::uint64_t) {});
    return *this;
  }

  /// Every row but those of the tables of time.
  std::string rows()
  {
    std::string all;
    for (const auto& [name, what] : tables())
      if (!std::string_view(name).starts_with("time")) all += std::string(name) + "\n" + table_as_csv(database, name);
    Database::Statement done(database, "SELECT * FROM done ORDER BY 1, 2, 3, 4, 5");
    for (done.with(); done.next();)
      for (int k = 0; k < done.columns(); ++k) all += done.text(k) + (k + 1 == done.columns() ? "\n" : ",");
    return all;
  }

  std::int64_t sum(const std::string& what, const std::string& where) { return tally(database, what, where); }

  Temporary_file file;
  Database database;
};

}  // namespace

BOOST_AUTO_TEST_CASE(planted_answers_are_counted_as_what_they_are)
{
  Results results("planted");
  results.with(small());
  Database::Statement truth(results.database,
                            "SELECT sum(n), sum(positives), sum(by_construction) FROM truth WHERE level = 'object'");
  BOOST_TEST_REQUIRE(truth.with().next());
  const auto n = truth.integer(0), positives = truth.integer(1);
  BOOST_TEST(n == 2 * 2 * 25);
  BOOST_TEST(truth.integer(2) == n);
  BOOST_TEST(positives > 0);
  BOOST_TEST(positives < n);
  BOOST_TEST(results.sum("n", "subject = 'says no'") == n);
  BOOST_TEST(results.sum("false_negatives", "subject = 'says no'") == positives);
  BOOST_TEST(results.sum("false_positives", "subject = 'says no'") == 0);
  BOOST_TEST(results.sum("failures", "level = 'object' AND subject = 'fails'") == n);
  BOOST_TEST(results.sum("not_asked", "level = 'object' AND subject = 'declines'") == n);
  BOOST_TEST(results.sum("n", "subject = 'declines'") == 0);
  BOOST_TEST(results.sum("n", "level = 'object' AND subject = 'adaptive tree'") == n);
  BOOST_TEST(results.sum("false_positives + false_negatives + failures", "subject = 'adaptive tree'") == 0);
  BOOST_TEST(results.sum("false_positives + false_negatives + failures", "subject = 'right'") == 0);
  BOOST_TEST(results.sum("n", "subject = 'low'") == results.sum("false_negatives", "subject = 'low'"));
  BOOST_TEST(results.sum("n", "subject = 'low' AND question = 'orientation'") == 2 * 450);
  // Lists of features.
  const auto features = [&](const std::string& what, const std::string& subject) {
    return results.sum(what, "level = 'features' AND question = 'features' AND subject = '" + subject + "'");
  };
  Database::Statement lists(results.database, "SELECT sum(n), sum(positives) FROM truth WHERE level = 'features'");
  BOOST_TEST_REQUIRE(lists.with().next());
  BOOST_TEST(lists.integer(0) == 2 * 8);
  BOOST_TEST(lists.integer(1) > 0);
  BOOST_TEST(lists.integer(1) < 2 * 8);
  BOOST_TEST(features("n", "adaptive tree") == 2 * 8);
  BOOST_TEST(features("false_positives + false_negatives + failures", "adaptive tree") == 0);
  BOOST_TEST(features("false_positives", "invents") == 2 * 8);
  BOOST_TEST(features("false_negatives", "invents") == 0);
  BOOST_TEST(features("false_positives", "leaves out") == 0);
  BOOST_TEST(features("false_negatives", "leaves out") == lists.integer(1));
  BOOST_TEST(features("not_asked", "fails") == 2 * 8);
  Database::Statement swaps(
      results.database,
      "SELECT subject, sum(tried), sum(violated) FROM relation WHERE level = 'features' GROUP BY 1 ORDER BY 1");
  BOOST_TEST_REQUIRE(swaps.with().next());
  BOOST_TEST(swaps.text(0) == "adaptive tree");
  BOOST_TEST(swaps.integer(1) == 2 * 2);
  BOOST_TEST(swaps.integer(2) == 0);
  // Both axes count each answer once.
  Database::Statement axes(results.database, "SELECT sum(CASE axis WHEN 'rho' THEN n ELSE -n END), sum(n) FROM tally");
  BOOST_TEST_REQUIRE(axes.with().next());
  BOOST_TEST(axes.integer(0) == 0);
  BOOST_TEST(axes.integer(1) > 0);
}

BOOST_AUTO_TEST_CASE(poses_with_fractions_are_counted_apart)
{
  Results results("fractions");
  Campaign campaign = small();
  set_families(campaign, {&turned});
  campaign.object_cases = 20;
  campaign.predicate_cases = campaign.feature_cases = 0;
  object_subjects_of(campaign) = {says_no, of_doubles_alone};
  results.with(campaign);
  for (const char* question : {"surface", "solid"}) {
    const std::string asked = std::string("question = '") + question + "' AND subject = ";
    for (const char* poses : {"doubles", "fractions"})
      BOOST_TEST(results.sum("n", asked + "'says no' AND poses = '" + poses + "'") == 10, poses);
    BOOST_TEST(results.sum("n", asked + "'of doubles' AND poses = 'doubles'") == 10);
    BOOST_TEST(results.sum("n", asked + "'of doubles' AND poses = 'fractions'") == 0);
    BOOST_TEST(results.sum("not_asked", asked + "'of doubles' AND poses = 'fractions'") == 10);
  }
  BOOST_TEST(table_as_csv(results.database, "poses").find("object,turned,of doubles,solid,fractions,0,0,0,0,10\n") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(each_question_is_timed_on_bodies_made_for_it)
{
  Results results("timed");
  Campaign campaign = small();
  campaign.object_cases = 20;
  campaign.predicate_cases = campaign.feature_cases = 0;
  object_subjects_of(campaign) = {object_subject(*Subject::parse("adaptive")), says_no, of_doubles_alone};
  results.with(campaign);
  const std::string times = table_as_csv(results.database, "time");
  BOOST_TEST(times.starts_with("level,subject,question,n,make_ns,ask_ns\n"));
  for (const char* question : {"surface", "solid"}) {
    BOOST_TEST(times.find(std::string("object,of doubles,") + question + ",40,3,4\n") != std::string::npos, times);
    const std::string where =
        std::string(" FROM time WHERE subject = 'adaptive tree' AND question = '") + question + "'";
    // Two bodies and a query take microseconds.
    BOOST_TEST(number(results.database, "SELECT min(making / n)" + where) > 1000);
    BOOST_TEST(number(results.database, "SELECT min(asking / n)" + where) > 0);
  }
  BOOST_TEST(times.find("says no") == std::string::npos, "it does not say what it took");
}

BOOST_AUTO_TEST_CASE(frames_that_a_subject_does_not_take_are_none_that_it_gets_wrong)
{
  Results results("frames");
  Campaign campaign = small();
  campaign.predicate_cases = campaign.object_cases = campaign.feature_cases = 0;
  campaign.sequence_frames = 4;
  object_subjects_of(campaign) = {says_no, of_doubles_alone, declines};
  results.with(campaign);
  const auto count = [&](const std::string& what, const std::string& where) {
    return number(results.database, "SELECT " + what + " FROM flips WHERE " + where);
  };
  BOOST_TEST(count("count(*)", "subject = 'declines'") == 0);
  BOOST_TEST(count("count(*)", "subject = 'of doubles'") > 0);
  BOOST_TEST(count("count(*)", "subject = 'of doubles' AND sequence LIKE '%, turned'") == 0);
  BOOST_TEST(count("count(*)", "subject = 'says no' AND sequence LIKE '%, turned'") > 0);
  BOOST_TEST(results.sum("n", "subject = 'of doubles'") == count("sum(frames)", "subject = 'of doubles'"));
  BOOST_TEST(results.sum("false_negatives", "subject = 'of doubles'") == count("sum(wrong)", "subject = 'of doubles'"));
}

BOOST_AUTO_TEST_CASE(run_again_it_adds_nothing)
{
  Results results("again");
  const std::string once = results.with(small()).rows();
  BOOST_TEST(once.size() > 1000);
  BOOST_TEST(once.find("excused,false_positives,false_negatives,rate,low,high\nobject,") != std::string::npos);
  BOOST_TEST((results.with(small()).rows() == once));
  BOOST_TEST((Results("other").with(small()).rows() == once));
}

BOOST_AUTO_TEST_CASE(cases_and_subjects_added_later_make_the_same_rows)
{
  const std::string at_once = Results("at_once").with(small()).rows();
  Results results("later");
  Campaign part = small();
  part.predicate_cases = 130;
  part.object_cases = 7;
  part.feature_cases = 4;
  object_subjects_of(part).resize(2);
  part.at<levels::Features>().subjects.resize(1);
  part.at<levels::Predicates>().subjects = {low};
  results.with(part);
  BOOST_TEST((results.rows() != at_once));
  BOOST_TEST((results.with(small()).rows() == at_once));
}

BOOST_AUTO_TEST_CASE(shards_merge_to_the_whole)
{
  const std::string whole = Results("whole").with(small()).rows();
  Results merged("merged");
  for (const int shard : {2, 0, 1}) {
    Results part(("shard" + std::to_string(shard)).c_str());
    Campaign campaign = small();
    campaign.shard = shard;
    campaign.shards = 3;
    part.with(campaign);
    BOOST_TEST((part.rows() != whole));
    merge(merged.database, part.file.path());
    if (shard != 0) continue;
    const std::string before = merged.rows();
    merge(merged.database, part.file.path());
    BOOST_TEST((merged.rows() == before));
  }
  BOOST_TEST((merged.rows() == whole));
  BOOST_CHECK_THROW(merge(merged.database, merged.file.path().native() + ".not-there"), Input_error);
}

BOOST_AUTO_TEST_CASE(shards_of_another_campaign_are_refused)
{
  Campaign first = small();
  object_subjects_of(first) = {says_no};
  object_subjects_of(first)[0].command = "./mine";
  first.shards = 2;
  Results into("into");
  into.with(first);
  const std::string before = into.rows();
  const auto refused = [&](const Campaign& campaign, const std::string& what) {
    Results other("other_words");
    other.with(campaign);
    try {
      merge(into.database, other.file.path());
      BOOST_ERROR(what + " was taken");
    } catch (const Input_error& error) {
      BOOST_TEST(std::string(error.what()).find(what) != std::string::npos, error.what());
    }
    BOOST_TEST((into.rows() == before));
  };
  Campaign second = first;
  second.shard = 1;
  const auto with = [&second](const auto& change) {
    Campaign other = second;
    change(other);
    return other;
  };
  refused(with([](Campaign& c) { c.seed = 6; }), "seed: 6 instead of 5");
  refused(with([](Campaign& c) { c.object_cases = 24; }), "object cases: 24 instead of 25");
  refused(with([](Campaign& c) { c.feature_cases = 7; }), "feature cases: 7 instead of 8");
  refused(with([](Campaign& c) { c.made_by.version = "1"; }), "version: 1 instead of 0");
  refused(with([](Campaign& c) { set_families(c, {&cheap}); }), "families: ");
  refused(with([](Campaign& c) { c.at<levels::Predicates>().subjects.pop_back(); }), "subjects: ");
  refused(with([](Campaign& c) { c.shards = 3; }), "shards: 3 instead of 2");
  refused(with([](Campaign& c) { object_subjects_of(c)[0].command = "./other"; }), "says no was the command './other'");
  Results last("last");
  last.with(second);
  merge(into.database, last.file.path());
  BOOST_TEST((into.rows() != before));
}

BOOST_AUTO_TEST_CASE(an_earlier_state_of_a_shard_is_no_double)
{
  Results into("earlier"), later("later_state");
  Campaign part = small();
  part.object_cases = 10;
  later.with(part);
  merge(into.database, later.file.path());
  const std::string before = into.rows();
  later.with(small());
  BOOST_CHECK_THROW(merge(into.database, later.file.path()), Input_error);
  BOOST_TEST((into.rows() == before));
}

BOOST_AUTO_TEST_CASE(a_subject_keeps_its_command)
{
  Results results("command");
  Campaign campaign = small();
  object_subjects_of(campaign) = {says_no};
  object_subjects_of(campaign)[0].command = "./mine";
  const std::string once = results.with(campaign).rows();
  BOOST_TEST(once.find("says no,./mine") != std::string::npos);
  object_subjects_of(campaign)[0].command = "./mine --better";
  BOOST_CHECK_THROW(results.with(campaign), Input_error);
  BOOST_TEST((results.rows() == once));
  // Nor does it go on with a program that has changed.
  object_subjects_of(campaign)[0].command = "./mine";
  for (std::string Object_subject::*what : {&Object_subject::hello, &Object_subject::digest}) {
    object_subjects_of(campaign)[0].*what = "another";
    BOOST_CHECK_THROW(results.with(campaign), Input_error);
    object_subjects_of(campaign)[0].*what = "";
  }
  BOOST_TEST((results.with(campaign).rows() == once));
}

BOOST_AUTO_TEST_CASE(a_database_of_another_versions_tables_is_refused_with_these)
{
  Results results("older"), into("newer");
  results.with(small());
  results.database.run("DROP TABLE words; CREATE TABLE words (version TEXT, seed INTEGER, shard INTEGER)");
  const std::string before = results.rows();
  const auto says_what_differs = [](const Input_error& error) {
    const std::string what = error.what();
    return what.find("table words (version, seed, shard)") != std::string::npos &&
           what.find("feature_cases") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(open_campaign(results.file.path()), Input_error, says_what_differs);
  BOOST_CHECK_EXCEPTION(require_campaign(results.file.path()), Input_error, says_what_differs);
  BOOST_CHECK_EXCEPTION(merge(into.database, results.file.path()), Input_error, says_what_differs);
  BOOST_CHECK_EXCEPTION(progress(results.database), Input_error, says_what_differs);
  BOOST_TEST((results.rows() == before));
}

BOOST_AUTO_TEST_CASE(progress_is_of_the_last_words)
{
  Results results("progress");
  BOOST_CHECK_THROW(progress(results.database), Input_error);
  Campaign campaign = small();
  object_subjects_of(campaign) = {says_no};
  campaign.shards = 3;
  campaign.shard = 1;
  std::uint64_t cases = 0;
  run_campaign(results.database, campaign, [&](std::uint64_t n) { cases += n; });
  const auto whole = progress(results.database);
  BOOST_TEST(whole.shards == 3);
  BOOST_TEST((whole.begun == std::vector<int>{1}));
  BOOST_TEST(whole.done == whole.of_begun);
  BOOST_TEST(whole.done > 2 * cases);  // the truth and at least one subject
  // A subject less: all of that is done.
  campaign.at<levels::Predicates>().subjects.pop_back();
  results.with(campaign);
  const auto less = progress(results.database);
  BOOST_TEST(less.done == less.of_begun);
  BOOST_TEST(less.done < whole.done);
  // A batch less is missed.
  results.database.run("DELETE FROM done WHERE subject = 'says no'");
  BOOST_TEST(progress(results.database).done < less.done);
}

BOOST_AUTO_TEST_CASE(a_truth_that_is_contradicted_stops_the_campaign)
{
  Results results("lying");
  Campaign campaign = small();
  set_families(campaign, {&cheap, &lying});
  try {
    results.with(campaign);
    BOOST_ERROR("no contradiction was found");
  } catch (const Truths_disagree& found) {
    BOOST_TEST_REQUIRE(found.object.has_value());
    BOOST_TEST(found.object->origin.family == "lying");
    BOOST_TEST((found.question == Question::surface));
  }
}

BOOST_AUTO_TEST_CASE(case_count_is_what_is_reported_done)
{
  Results results("count");
  std::uint64_t done = 0;
  Campaign campaign = small();
  campaign.sequence_frames = 3;
  object_subjects_of(campaign) = {says_no};
  run_campaign(results.database, campaign, [&](std::uint64_t cases) { done += cases; });
  BOOST_TEST(done == case_count(campaign));
  BOOST_TEST(done > 2 * 475);
  Database::Statement flips(results.database, "SELECT count(*), max(changes), max(true_changes) FROM flips");
  BOOST_TEST_REQUIRE(flips.with().next());
  BOOST_TEST(flips.integer(0) > 0);
  BOOST_TEST(flips.integer(1) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
