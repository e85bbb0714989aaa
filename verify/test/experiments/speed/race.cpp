#include "experiments/speed/race.h"

#include "verify/cases/shape_generators.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>

BOOST_AUTO_TEST_SUITE(test_race)

using namespace tetracone;
using namespace tetracone::experiments;
using kernel::Pose;
using kernel::Question;

namespace {

/// Two cubes on a line: apart, touching, and crossing.
Race_course three_poses()
{
  Race_course course{"line", "cube", 1, verify::unit_cube(), verify::unit_cube(), {}};
  for (const double x : {2.0, 1.0, 0.5, std::nextafter(1.0, 2.0)}) course.poses_b.push_back(Pose::translation(x, 0, 0));
  return course;
}

/// Says no, whatever is asked.
class Denying : public Prepared_pair {
 public:
  bool collide(const Pose&, const Pose&, Question) override { return false; }
};

}  // namespace

BOOST_AUTO_TEST_CASE(wrong_answers_are_counted_by_their_kind_and_only_where_they_were_given)
{
  const Race_course course = three_poses();
  const Contestant denying{
      .name = "denying", .one_in = 2, .prepare = [](const covering::Polyhedron&, const covering::Polyhedron&) {
        return std::make_unique<Denying>();
      }};
  const Course_truth truth = course_truth(course);
  Race race(course, truth, {fast(), denying});
  const auto surface = race.run(Question::surface, 2, 1);
  BOOST_TEST(surface[0]->poses == 4u);
  BOOST_TEST(surface[0]->collisions == 2u);
  BOOST_TEST(surface[0]->false_positives + surface[0]->false_negatives == 0u);
  BOOST_TEST(surface[1]->poses == 2u);  // one that collides and one that does not
  BOOST_TEST(surface[1]->false_negatives == 1u);
  BOOST_TEST(surface[1]->false_positives == 0u);
  BOOST_TEST(!race.run(Question::solid, 1, 1)[1]);  // it knows none
}

namespace {

/// A program that is right, tells `ns` of each answer, and declines the poses where B is at `declined`.
class Says : public verify::Running_subject {
 public:
  Says(std::optional<std::uint64_t> ns, double declined) : ns_(ns), declined_(declined) {}

  verify::Outcome operator()(const verify::Object_case& c, Question) override
  {
    if (c.pose_b[3] == declined_) return verify::Outcome::not_asked;
    return c.pose_b[3] <= 1 ? verify::Outcome::yes : verify::Outcome::no;
  }
  std::optional<verify::Spent> spent() const override
  {
    return ns_ ? std::optional(verify::Spent{{}, *ns_}) : std::nullopt;
  }

 private:
  std::optional<std::uint64_t> ns_;
  double declined_;
};

Contestant says(std::optional<std::uint64_t> ns, double declined)
{
  verify::Object_subject subject;
  subject.name = "says";
  subject.make = [=] { return std::make_unique<Says>(ns, declined); };
  return program(subject);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_programs_time_is_its_own_clocks)
{
  const Race_course course = three_poses();
  const Course_truth truth = course_truth(course);
  Race race(course, truth, {fast(), says(12'345, -1), says(std::nullopt, -1), says(7, 0.5)});
  for (const Question question : {Question::surface, Question::solid}) {
    const auto timings = race.run(question, 3, 1);
    BOOST_TEST_REQUIRE(timings[1].has_value());
    BOOST_TEST(timings[1]->mean_ns == 12'345);
    BOOST_TEST(timings[1]->median_ns == 12'345);
    BOOST_TEST(timings[1]->false_positives + timings[1]->false_negatives == 0u);
    // Without one there is no time, but answers.
    BOOST_TEST_REQUIRE(timings[2].has_value());
    BOOST_TEST(!std::isfinite(timings[2]->mean_ns));
    BOOST_TEST(timings[2]->poses == 4u);
    // One that declines a pose is left out of the course.
    BOOST_TEST(!timings[3].has_value());
  }
}

BOOST_AUTO_TEST_CASE(a_contestant_that_takes_no_such_bodies_is_not_in_the_race)
{
  const Race_course course = three_poses();
  const Course_truth truth = course_truth(course);
  Race race(course, truth, {fast(), peer("no such library")});
  BOOST_TEST(!race.run(Question::surface, 1, 1)[1]);
}

BOOST_AUTO_TEST_CASE(several_trajectories_follow_one_another_each_from_a_seed_of_its_own)
{
  const auto course = [body = verify::blob(300, 1)](int trajectories) {
    return on_trajectory(body, "blob", "circular", 8, 50, 3, trajectories);
  };
  const Race_course several = course(3);
  const auto one = course(1).poses_b, &three = several.poses_b;
  BOOST_TEST(one.size() == 50u);
  BOOST_REQUIRE(three.size() == 150u);
  BOOST_TEST(std::equal(one.begin(), one.end(), three.begin()));
  for (std::size_t k = 0; k < 50; ++k) BOOST_TEST((!(three[k] == three[50 + k]) && !(three[50 + k] == three[100 + k])));
  // Two in each fifty are between 3 and 4.5 %.
  const Course_truth truth = course_truth(several);
  Race race(several, truth, {fast()});
  BOOST_TEST(race.run(Question::surface, 1, 1)[0]->collisions == 6u);
}

BOOST_AUTO_TEST_CASE(with_the_last_frame_or_without_the_same_trees_are_asked)
{
  const Race_course course = on_trajectory(verify::blob(300, 1), "blob", "contour", 1, 10, 1);
  const auto first = fast().prepare_on_demand(course.a, course.b), second = fast_with_last_frame().share(*first);
  BOOST_REQUIRE(second);
  const std::size_t few = second->node_count();
  for (const Pose& pose : course.poses_b)
    BOOST_TEST(first->collide(Pose(), pose, Question::surface) == second->collide(Pose(), pose, Question::surface));
  BOOST_TEST(second->node_count() > few);
  BOOST_TEST(second->node_count() == first->node_count());
  BOOST_TEST(first->take_counts().queries == 10u);
  BOOST_TEST(second->take_counts().queries == 10u);
  BOOST_TEST(!fast().share(Denying()));
  BOOST_TEST(!peer("no such library").share);
}

BOOST_AUTO_TEST_CASE(time_memory_and_nodes_are_measured)
{
  const Race_course course = on_trajectory(verify::blob(2000, 1), "blob", "contour", 1, 20, 1);
  const Course_truth truth = course_truth(course);
  Race race(course, truth, {fast()});
  const Build& build = race.contestants()[0].build;
  BOOST_TEST(build.milliseconds > 0);
  BOOST_TEST(build.bytes > 100u * (course.a.face_count() + course.b.face_count()));
  BOOST_TEST(build.nodes_after_one <= build.nodes_after_first);
  BOOST_TEST(build.nodes_after_first < race.contestants()[0].pair->node_count());
  const auto timing = race.run(Question::surface, 3, 1)[0];
  BOOST_TEST(timing->passes == 3u);
  BOOST_TEST(timing->mean_ns > 0);
  BOOST_TEST(timing->median_ns <= timing->p99_ns);
  BOOST_TEST(timing->counts.queries == 20u);  // of one pass
}

BOOST_AUTO_TEST_CASE(first_queries_make_nodes_and_empty_caches_cost_time)
{
  const Race_course course = on_trajectory(verify::blob(2000, 1), "blob", "contour", 1, 20, 1);
  const Course_truth truth = course_truth(course);
  Race race(course, truth, {fast(), fast_in_double()});
  const auto timings = race.run(Question::surface, 3, 1);
  const Build &build = race.contestants()[0].build, &other = race.contestants()[1].build;
  BOOST_TEST(build.first_build_milliseconds > 0);
  BOOST_TEST(build.first_query_milliseconds * 1e6 > timings[0]->mean_ns);
  BOOST_TEST(timings[0]->cold_ns > timings[0]->warm_ns);
  BOOST_TEST(timings[0]->warm_ns > 0);
  BOOST_TEST(other.first_query_milliseconds == 0);  // is not clocked so
  BOOST_TEST(timings[1]->cold_ns == 0);
}

BOOST_AUTO_TEST_SUITE_END()
