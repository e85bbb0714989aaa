#include "experiments/speed/timed_poses.h"

#include <boost/test/unit_test.hpp>

#include <set>
#include <string>

BOOST_AUTO_TEST_SUITE(test_timed_poses)

using namespace tetracone;
using namespace tetracone::experiments;

namespace {

/// The truth of `poses` poses, where those in `hits` collide.
std::vector<char> truth_of(std::size_t poses, const std::set<std::size_t>& hits)
{
  std::vector<char> truth(poses);
  for (const std::size_t k : hits) truth[k] = 1;
  return truth;
}

/// The work of the whole course, estimated from what is asked: a hit costs 1000 tests, a miss 7.
std::uint64_t estimated_tests(const std::vector<char>& truth, std::size_t one_in)
{
  Timed_poses poses(truth, one_in);
  tetratree::Query_statistics all, now;
  poses.pass(
      [&](std::size_t k) {
        now.box_tests += truth[k] ? 1000 : 7;
        return truth[k] != 0;
      },
      0,
      [&](double weight) {
        all += weighted(now, weight);
        now = {};
      });
  return all.box_tests;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sample_has_hits_and_misses_and_estimates_the_whole_course)
{
  const std::set<std::size_t> few = {0, 1, 2, 40, 77};
  for (const std::size_t one_in : {1, 2, 7, 20, 60, 1000}) {
    const std::vector<char> truth = truth_of(120, few);
    const Timed_poses poses(truth, one_in);
    double stands_for = 0;
    std::set<std::size_t> asked;
    std::size_t hits = 0;
    for (const Stratum& stratum : poses.strata())
      for (const std::size_t k : stratum.numbers) {
        BOOST_TEST(asked.insert(k).second);
        hits += few.contains(k);
        stands_for += stratum.weight;
      }
    BOOST_TEST(hits >= 1u);
    BOOST_TEST(hits < asked.size());
    BOOST_TEST(stands_for == 120, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(asked.size() <= 120 / one_in + 2);
    BOOST_TEST(poses.judged().poses == asked.size());
    BOOST_TEST(poses.judged().course_poses == 120u);
    BOOST_TEST(poses.judged().course_collisions == few.size());
    BOOST_TEST((poses.judged().estimator() == std::string("every pose")) == (one_in == 1));
    BOOST_TEST(estimated_tests(truth, one_in) == 5u * 1000 + 115 * 7);
  }
}

BOOST_AUTO_TEST_CASE(courses_of_one_kind_are_sampled_too)
{
  for (const auto& truth : {std::vector<char>(50, 0), std::vector<char>(50, 1)}) {
    BOOST_TEST(Timed_poses(truth, 10).judged().poses == 5u);
    BOOST_TEST(estimated_tests(truth, 10) == 50u * (truth[0] ? 1000 : 7));
  }
  BOOST_TEST(Timed_poses(truth_of(1, {0}), 20).judged().poses == 1u);
}

BOOST_AUTO_TEST_CASE(all_poses_are_asked_in_their_order)
{
  const std::vector<char> truth = truth_of(9, {2, 5});
  Timed_poses poses(truth, 1);
  std::vector<std::size_t> asked;
  const auto answer = [&asked](std::size_t k) {
    asked.push_back(k);
    return k == 2 || k == 3;
  };
  const double mean = poses.pass(answer, 0, [](double) {});
  BOOST_TEST((asked == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  BOOST_TEST(poses.judged().false_positives == 1u);
  BOOST_TEST(poses.judged().false_negatives == 1u);
  BOOST_TEST(poses.judged().collisions == 2u);
  BOOST_TEST(mean == poses.mean_ns(poses), boost::test_tools::tolerance(1e-9));  // one pass, which is the fastest
  BOOST_TEST(poses.quantile_ns(0) <= poses.quantile_ns(0.5));
}

BOOST_AUTO_TEST_CASE(a_number_above_the_truth_is_a_false_positive_and_one_below_a_false_negative)
{
  const std::vector<char> truth = truth_of(4, {1, 2, 3});
  Timed_poses poses(truth, 1);
  const int told[] = {1, 1, 0, 2};
  poses.pass([&](std::size_t k) { return told[k]; }, 0, [](double) {});
  BOOST_TEST(poses.judged().collisions == 3u);
  BOOST_TEST(poses.judged().false_positives == 2u);
  BOOST_TEST(poses.judged().false_negatives == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
