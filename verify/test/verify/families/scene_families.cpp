#include "verify/families/scene_families.h"

#include "tetracone/kernel/number/number.h"
#include "verify/subjects/scene_subject.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <map>
#include <set>
#include <string>

BOOST_AUTO_TEST_SUITE(test_scene_families)

using namespace tetracone::verify;
using tetracone::kernel::Question;

BOOST_AUTO_TEST_CASE(scenes_are_legal_the_same_each_time_and_of_both_questions)
{
  std::set<std::string> names;
  for (const Scene_family& family : scene_families()) {
    BOOST_TEST(names.emplace(family.name).second, family.name);
    std::map<Question, int> questions;
    std::size_t moved = 0;
    for (std::uint64_t k = 0; k < 12; ++k) {
      const Scene_case c = family.scene_case(3, k), again = family.scene_case(3, k);
      ++questions[c.question];
      BOOST_TEST(c.origin.parameter == family.sweep[k % family.sweep.size()]);
      BOOST_REQUIRE(c.frames.size() > 4u);
      for (std::size_t f = 0; f < c.frames.size(); ++f) {
        BOOST_TEST((c.frames[f].bodies == again.frames[f].bodies && c.frames[f].ignored == again.frames[f].ignored));
        BOOST_TEST(c.frames[f].bodies.size() == c.frames[0].bodies.size());
        moved += f > 0 && c.frames[f].bodies != c.frames[f - 1].bodies;
        for (const auto& body : c.frames[f].bodies)
          if (body) {
            BOOST_TEST(body->model < c.models.size());
            BOOST_TEST((body->pose.determinant_sign() != CGAL::ZERO));
          }
        for (const auto& [a, b] : c.frames[f].ignored) BOOST_TEST((a < b && b < c.frames[f].bodies.size()));
      }
    }
    BOOST_TEST(questions.size() == 2u, family.name);
    BOOST_TEST((moved > 24 || family.name == "scene-rests"), family.name);
  }
}

BOOST_AUTO_TEST_CASE(frames_have_pairs_that_collide_and_pairs_that_do_not_and_neither_stays)
{
  const auto scene = scene_subjects()[0].make();
  for (const Scene_family& family : scene_families()) {
    std::size_t collide = 0, pairs = 0, changes = 0;
    for (std::uint64_t k = 0; k < 4; ++k) {
      const Scene_case c = family.scene_case(5, k);
      const auto [outcome, told, spent] = (*scene)(c);
      BOOST_REQUIRE((outcome == Outcome::yes));
      for (std::size_t f = 0; f < told.size(); ++f) {
        const std::size_t n = c.frames[f].bodies.size();
        collide += told[f].size();
        pairs += n * (n - 1) / 2;
        changes += f > 0 && told[f] != told[f - 1];
      }
    }
    BOOST_TEST(collide > 0u, family.name);
    BOOST_TEST(collide < pairs, family.name);
    BOOST_TEST(changes > 0u, family.name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
