#include "verify/relations/scene_relations.h"

#include "verify/families/scene_families.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

BOOST_AUTO_TEST_SUITE(test_scene_relations)

using namespace tetracone::verify;

namespace {

/// A subject that spoils each frame of the library's scene.
class Wrong : public Running_scene {
 public:
  using Spoil = void (*)(const Scene_case& c, Frames_of_pairs& told);
  explicit Wrong(Spoil spoil) : spoil_(spoil), right_(scene_subjects()[0].make()) {}
  std::optional<Frames_of_pairs> play(const Scene_case& c) override
  {
    auto told = right_->play(c);
    spoil_(c, *told);
    return told;
  }

 private:
  Spoil spoil_;
  std::unique_ptr<Running_scene> right_;
};

/// How many of some scenes violate the relation.
int violations(const Scene_relation& relation, Running_scene& subject)
{
  int violated = 0;
  for (const char* name : {"scene-grid", "scene-drift", "scene-hollows", "scene-crowd"})
    for (std::uint64_t k = 0; k < 4; ++k) {
      const Scene_case c = find_scene_family(name)->scene_case(2, k);
      Random random(k);
      violated += relation.check(c, subject, *subject.play(c), random) == Verdict::violated;
    }
  return violated;
}

}  // namespace

BOOST_AUTO_TEST_CASE(relations_of_scenes_hold_and_each_is_violated_by_some_error)
{
  const auto right = scene_subjects()[0].make();
  Wrong not_of_the_last([](const Scene_case& c, Frames_of_pairs& told) {
    for (auto& pairs : told)
      std::erase_if(pairs, [&](const Body_pair& pair) { return pair[1] + 1 == c.frames[0].bodies.size(); });
  });
  Wrong of_large_numbers_alone([](const Scene_case& c, Frames_of_pairs& told) {
    for (std::size_t f = 0; f < told.size(); ++f)
      std::erase_if(told[f], [&](const Body_pair& pair) { return !(c.frames[f].bodies[pair[0]]->pose[3] >= 0); });
  });
  Wrong late([](const Scene_case&, Frames_of_pairs& told) {
    for (std::size_t f = told.size(); f-- > 1;) told[f] = told[f - 1];
  });
  Wrong no_solids([](const Scene_case& c, Frames_of_pairs& told) {
    if (c.question == tetracone::kernel::Question::solid)
      for (auto& pairs : told) pairs.clear();
  });
  Running_scene* const wrong[] = {&not_of_the_last, &of_large_numbers_alone, &late, &late, &late, &no_solids};
  const auto relations = scene_relations();
  BOOST_REQUIRE(relations.size() == std::size(wrong));
  for (std::size_t number = 0; number < relations.size(); ++number) {
    BOOST_TEST(violations(relations[number], *right) == 0, std::string(relations[number].name));
    BOOST_TEST(violations(relations[number], *wrong[number]) > 0, std::string(relations[number].name));
  }
}

BOOST_AUTO_TEST_SUITE_END()
