// Poses and bodies of any exponents: the fast tree over whole faces and over triangles, with and without the memory of
// the last pose, in both orders, and the paper's tree, against all pairs in rational arithmetic. TETRACONE_WILD_POSES
// says how many poses, TETRACONE_WILD_SEED which.

#include "verify/families/object_families.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/fast/bvh8_collision.h"
#include "tetracone/tetratree/paper/collision.h"
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
    tetratree::Bvh8 whole_a(a), whole_b(b), triangles_a(a, covering::triangulate_faces(a)),
        triangles_b(b, covering::triangulate_faces(b));
    using tetratree::Coherence, tetratree::Bvh8_collision;
    Bvh8_collision whole(whole_a, whole_b), triangles(triangles_a, triangles_b, Coherence::last_frame),
        other_way(triangles_b, whole_a, Coherence::last_frame);
    tetratree::Tetra_tree<kernel::Adaptive> paper_a(a), paper_b(b);
    tetratree::Collision<kernel::Adaptive> paper(paper_a, paper_b);
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
        // Each in turn beside the first, which is asked every pose.
        wrong += triangles(pose_a, pose_b, question) != truth;
        wrong += (k % 3 == 0   ? whole(pose_a, pose_b, question)
                  : k % 3 == 1 ? other_way(pose_b, pose_a, question)
                               : paper(pose_a, pose_b, question)) != truth;
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
