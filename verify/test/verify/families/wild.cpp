// Poses and bodies of any exponents: the fast tree over whole faces and over triangles, with and without the memory of
// the last pose, in both orders, and the paper's tree, against all pairs in rational arithmetic. TETRACONE_WILD_POSES
// says how many poses, TETRACONE_WILD_SEED which.

#include "verify/families/object_families.h"

#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <cstdlib>

BOOST_AUTO_TEST_SUITE(test_wild)

using namespace tetracone;
using namespace tetracone::verify;
using kernel::Question;

namespace {

long number_from(const char* variable, long otherwise)
{
  const char* const text = std::getenv(variable);
  return text ? std::strtol(text, nullptr, 10) : otherwise;
}

/// The queries that two bodies are asked.
class Asked {
 public:
  Asked(const covering::Polyhedron& a, const covering::Polyhedron& b, Question question)
      : Asked(Body(a), Body(b), triangulated_body(a), triangulated_body(b), question)
  {}

  /// How many answers are not `truth`: that over triangles, and in turn one of the others.
  int wrong(const kernel::Pose& pose_a, const kernel::Pose& pose_b, std::size_t turn, bool truth)
  {
    const Answer other = turn % 3 == 0   ? whole_.collide(pose_a, pose_b)
                         : turn % 3 == 1 ? other_way_.collide(pose_b, pose_a)
                                         : paper_.collide(pose_a, pose_b);
    return (bool(triangles_.collide(pose_a, pose_b)) != truth) + (bool(other) != truth);
  }

 private:
  Asked(const Body& a, const Body& b, const Body& triangles_a, const Body& triangles_b, Question question)
      : whole_(a, b, question),
        triangles_(triangles_a, triangles_b, question, {.remember = true}),
        other_way_(triangles_b, a, question, {.remember = true}),
        paper_(a, b, question, {.method = Method::paper})
  {}

  Query whole_, triangles_, other_way_, paper_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(answers_on_wild_poses_are_those_of_all_pairs_in_rationals)
{
  const long poses = number_from("TETRACONE_WILD_POSES", 2000), seed = number_from("TETRACONE_WILD_SEED", 1);
  constexpr int run = 8;
  Random random(static_cast<std::uint64_t>(seed));
  long asked = 0, yes = 0, contained = 0, wrong = 0, known_wrong = 0;
  // The larger, the slower: every sign is exact.
  constexpr std::array parameters = {30.0, 150.0, 30.0, 500.0, 30.0, 150.0, 30.0, 960.0};
  for (long done = 0; done < poses; done += run) {
    const auto cases = object_family::wild_run(random, parameters[std::size_t(done / run) % parameters.size()], run);
    const covering::Polyhedron &a = *cases.front().a, &b = *cases.front().b;
    const Brute_body truth_a(a), truth_b(b);
    Asked of_surface(a, b, Question::surface), of_solid(a, b, Question::solid);
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const Object_case& c = cases[k];
      // The family exchanges the bodies of half its cases.
      const bool exchanged = c.a != cases.front().a;
      const kernel::Pose &pose_a = exchanged ? c.pose_b : c.pose_a, &pose_b = exchanged ? c.pose_a : c.pose_b;
      bool surface = false;
      for (const Question question : {Question::surface, Question::solid}) {
        const bool truth = surface || collide(truth_a, pose_a, truth_b, pose_b, question);
        if (question == Question::surface)
          surface = truth;
        else
          contained += truth && !surface;
        wrong += (question == Question::surface ? of_surface : of_solid).wrong(pose_a, pose_b, k, truth);
        known_wrong += c.known(question) && *c.known(question) != truth;
        ++asked;
        yes += truth;
      }
    }
  }
  BOOST_TEST_MESSAGE(asked << " questions, " << yes << " yes, " << contained << " of these by containment");
  BOOST_TEST(wrong == 0);
  BOOST_TEST(known_wrong == 0);
  BOOST_TEST(10 * yes > 2 * asked);
  BOOST_TEST(10 * yes < 8 * asked);
  BOOST_TEST(100 * contained > asked);
}

BOOST_AUTO_TEST_SUITE_END()
