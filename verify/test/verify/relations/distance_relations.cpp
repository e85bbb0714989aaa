#include "verify/relations/distance_relations.h"

#include "verify/families/distance_families.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

BOOST_AUTO_TEST_SUITE(test_distance_relations)

using namespace tetracone::verify;
using tetracone::kernel::Question;

BOOST_AUTO_TEST_CASE(relations_of_distances_hold_and_are_violated_by_a_wrong_square)
{
  const auto ask = distance_subjects()[0].make();
  std::map<std::string_view, int> held, noticed;
  for (const char* name : {"apart-from-face", "two-spikes", "between-walls", "mirrored", "of-any-size", "parallel"})
    for (std::uint64_t k = 0; k < 2; ++k) {
      const Object_case c = find_distance_family(name)->object_case(9, k);
      for (const Question question : {Question::surface, Question::solid}) {
        const Told_distance given = ask->distance(c, question);
        BOOST_TEST_REQUIRE((given.outcome == Outcome::yes));
        Told_distance wrong = given;
        wrong.nearest.squared = given.nearest.squared == "0" ? "1" : "0";
        wrong.nearest.point[1] = wrong.nearest.point[0];
        for (const Distance_relation& relation : distance_relations()) {
          Random random(k), same(k);
          const Verdict verdict = relation.check(c, question, *ask, given, random);
          BOOST_TEST((verdict != Verdict::violated), relation.name << ", " << name << ' ' << k);
          held[relation.name] += verdict == Verdict::holds;
          noticed[relation.name] += relation.check(c, question, *ask, wrong, same) == Verdict::violated;
        }
      }
    }
  for (const Distance_relation& relation : distance_relations()) BOOST_TEST(held[relation.name] > 3, relation.name);
  // A smaller square is no greater than that of a face less, and a square of 0 cannot be approached.
  for (const char* name : {"R1 zero", "R5 swap", "R6 motion", "R6 twice", "R6 scale", "R7 face", "R8 order"})
    BOOST_TEST(noticed[name] > 5, name);
}

BOOST_AUTO_TEST_CASE(a_way_that_is_too_long_is_noticed)
{
  const auto ask = distance_subjects()[0].make();
  const Object_case c = find_distance_family("apart-from-vertex")->object_case(9, 0);
  Told_distance given = ask->distance(c, Question::surface);
  BOOST_TEST_REQUIRE((given.outcome == Outcome::yes));
  given.nearest.point[0] = {"1000", "0", "0"};
  for (const Distance_relation& relation : distance_relations()) {
    Random random(1);
    if (relation.name == "R13 approach")
      BOOST_TEST((relation.check(c, Question::surface, *ask, given, random) == Verdict::violated));
  }
}

BOOST_AUTO_TEST_SUITE_END()
