#include "verify/relations/level.h"

#include "verify/cases/exit_direction.h"
#include "verify/families/distance_families.h"
#include "verify/families/families.h"
#include "verify/families/moving_body_families.h"
#include "verify/families/probe_families.h"
#include "verify/families/scene_families.h"
#include "verify/relations/relations.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <string_view>
#include <utility>

// The relations of features, contacts, distances, solids, points, rays, scenes and motions.
BOOST_AUTO_TEST_SUITE(test_level)

using namespace tetracone::verify;
using tetracone::kernel::Question;
using tetracone::kernel::Rational;
using tetracone::kernel::Solid_relation;

namespace {

struct Tried {
  int held = 0, noticed = 0;
};
using All_tried = std::map<std::string_view, Tried>;

/// Tries the relations with a right subject and its answer, which must violate none, and with a wrong pair.
template <class Level>
void try_all(All_tried& tried, std::span<const typename Level::Relation> relations, const typename Level::Case& c,
             Question question, typename Level::Running& right, const typename Level::Answer& answer,
             typename Level::Running& wrong, const typename Level::Answer& wrong_answer)
{
  for (const auto& relation : relations) {
    Random random(c.origin.index), same(c.origin.index);
    const Verdict verdict = relation.check({c, question, right, answer, random});
    BOOST_TEST((verdict != Verdict::violated), relation.name << ", " << c.origin.family << ' ' << c.origin.index);
    tried[relation.name].held += verdict == Verdict::holds;
    tried[relation.name].noticed += relation.check({c, question, wrong, wrong_answer, same}) == Verdict::violated;
  }
}

/// A right subject whose answers for some cases are spoiled.
template <class Case, class Answer, class... Questions>
class Spoils : public Running<Case, Answer, Questions...> {
 public:
  using Spoil = std::function<void(const Case&, Answer&)>;
  Spoils(Running<Case, Answer, Questions...>& right, Spoil spoil) : right_(right), spoil_(std::move(spoil)) {}

  Told<Answer> operator()(const Case& c, Questions... question) override
  {
    Told<Answer> told = right_(c, question...);
    spoil_(c, told.answer);
    return told;
  }

 private:
  Running<Case, Answer, Questions...>& right_;
  Spoil spoil_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(relations_of_contacts_hold)
{
  const auto ask = contact_subjects()[0].make();
  All_tried tried;
  for (const char* family : {"face-on-face", "edge-across-edge", "swept-contact", "random"})
    for (std::uint64_t k = 0; k < 4; ++k) {
      const Object_case c = find_family(family)->object_case(9, k);
      const Contact_forms given = ask->contacts(c).answer;
      Contact_forms fewer = given;
      if (!fewer.empty()) fewer.pop_back();
      try_all<Contact_level>(tried, contact_relations(), c, Question::surface, *ask, given, *ask, fewer);
    }
  for (const auto& [name, t] : tried) BOOST_TEST(t.held > 0, name);
  BOOST_TEST(tried["R5 swap"].noticed > 4);
}

BOOST_AUTO_TEST_CASE(relations_of_distances_hold_and_are_violated_by_a_wrong_square)
{
  const auto ask = distance_subjects()[0].make();
  All_tried tried;
  for (const char* name : {"apart-from-face", "two-spikes", "between-walls", "mirrored", "of-any-size", "parallel"})
    for (std::uint64_t k = 0; k < 2; ++k) {
      const Object_case c = find_named(distance_families(), name)->object_case(9, k);
      for (const Question question : {Question::surface, Question::solid}) {
        const auto given = ask->distance(c, question);
        BOOST_TEST_REQUIRE((given.outcome == Outcome::yes));
        Distance_answer wrong = given.answer;
        wrong.nearest.squared = wrong.nearest.squared == "0" ? "1" : "0";
        wrong.nearest.point[1] = wrong.nearest.point[0];
        try_all<Distance_level>(tried, distance_relations(), c, question, *ask, given.answer, *ask, wrong);
      }
    }
  for (const auto& [name, t] : tried) BOOST_TEST(t.held > 3, name);
  // A smaller square is no greater than that of a face less, and a square of 0 cannot be approached.
  for (const char* name : {"R1 zero", "R5 swap", "R6 motion", "R6 twice", "R6 scale", "R7 face", "R8 order"})
    BOOST_TEST(tried[name].noticed > 5, name);
}

BOOST_AUTO_TEST_CASE(relations_of_solids_hold_and_are_violated_by_wrong_answers)
{
  const auto ask = solid_subjects()[0].make();
  All_tried tried;
  for (const char* name : {"lego", "nested-touching", "face-on-face", "vertex-on-vertex", "stacked"})
    for (std::uint64_t k = 0; k < 12; ++k) {
      const Object_case c = find_family(name)->object_case(9, k);
      if (c.a->face_count() + c.b->face_count() > 24) continue;
      const auto given = ask->solids(c);
      BOOST_TEST_REQUIRE((given.outcome == Outcome::yes));
      Solid_answer wrong = given.answer;
      // Another containment, another volume, and meet where it is something else.
      wrong.overlap.volume += 1;
      auto& relation = wrong.overlap.contact.relation;
      relation = relation == Solid_relation::disjoint ? Solid_relation::inside
                 : relation == Solid_relation::meet   ? Solid_relation::covered_by
                                                      : Solid_relation::disjoint;
      try_all<Solid_level>(tried, solid_relations(), c, Question::solid, *ask, given.answer, *ask, wrong);
    }
  for (const auto& [name, t] : tried) BOOST_TEST(t.held > 1, name);
  for (const char* name : {"R1 collide", "R5 swap", "R6 affine", "R7 face", "R8 order", "R9 transitive"})
    BOOST_TEST(tried[name].noticed > 2, name);
}

BOOST_AUTO_TEST_CASE(relations_of_exits_hold_and_are_violated_by_wrong_exits)
{
  const auto ask = solid_subjects()[0].make();
  All_tried tried;
  for (const char* name : {"lego", "nested-touching", "face-on-face", "random"})
    for (std::uint64_t k = 0; k < 8; ++k) {
      const Object_case c = find_family(name)->object_case(9, k);
      if (c.a->face_count() + c.b->face_count() > 40) continue;
      const auto given = ask->exits(c, exit_direction(c));
      BOOST_TEST_REQUIRE((given.outcome == Outcome::yes));
      Exit_answer wrong = given.answer;
      // Too short, and some way where there is none.
      wrong.exits.first = wrong.exits.first == 0 ? 1 : Rational(wrong.exits.first / 2);
      wrong.exits.last += 1;
      try_all<Exit_level>(tried, exit_relations(), c, Question::solid, *ask, given.answer, *ask, wrong);
    }
  for (const auto& [name, t] : tried) BOOST_TEST(t.held > 1, name);
  for (const auto& [name, t] : tried) BOOST_TEST(t.noticed > 2, name);
}

BOOST_AUTO_TEST_CASE(a_nudge_that_leads_nowhere_is_noticed)
{
  const auto ask = solid_subjects()[0].make();
  Solid_answer given;
  given.overlap.contact = {Solid_relation::meet, 0};
  given.alone = Solid_relation::meet;
  const auto relations = solid_relations();
  const auto nudge = std::ranges::find(relations, "R13 nudge", &Solid_level::Relation::name);
  int noticed = 0;
  for (std::uint64_t k = 0; k < 40; ++k) {
    const Object_case c = find_family("stacked")->object_case(9, k);
    if (ask->solids(c).answer.overlap.contact.relation != Solid_relation::disjoint) continue;
    Random random(k);
    noticed += nudge->check({c, Question::solid, *ask, given, random}) == Verdict::violated;
  }
  BOOST_TEST(noticed > 0);
}

BOOST_AUTO_TEST_CASE(a_way_that_is_too_long_is_noticed)
{
  const auto ask = distance_subjects()[0].make();
  const Object_case c = find_named(distance_families(), "apart-from-vertex")->object_case(9, 0);
  Distance_answer given = ask->distance(c, Question::surface).answer;
  given.nearest.point[0] = {"1000", "0", "0"};
  const auto relations = distance_relations();
  const auto approach = std::ranges::find(relations, "R13 approach", &Distance_level::Relation::name);
  Random random(1);
  BOOST_TEST((approach->check({c, Question::surface, *ask, given, random}) == Verdict::violated));
}

BOOST_AUTO_TEST_CASE(relations_of_points_hold_and_are_violated_by_lies_of_twins)
{
  const auto ask = point_subjects()[0].make();
  All_tried tried;
  for (const Probe_family& family : point_families())
    for (std::uint64_t k = 0; k < 3; ++k) {
      const Probe_case c = family.probe_case(6, 5 * k);
      Spoils<Probe_case, int> lies(*ask, [&](const Probe_case& asked, int& place) {
        if (asked.body != c.body) place = place == 1 ? -1 : place + 1;
      });
      try_all<Point_level>(tried, point_relations(), c, Question::surface, *ask, 0, lies, 0);
    }
  for (const auto& [name, t] : tried) {
    BOOST_TEST(t.held > 8, name);
    BOOST_TEST(t.noticed == t.held, name);
  }
}

BOOST_AUTO_TEST_CASE(relations_of_rays_hold_and_are_violated_by_lies_of_twins)
{
  const auto ask = ray_subjects()[0].make();
  All_tried tried;
  for (const Probe_family& family : ray_families())
    for (std::uint64_t k = 0; k < 3; ++k) {
      const Probe_case c = family.probe_case(6, 5 * k);
      Spoils<Probe_case, Ray_answer> lies(*ask, [&](const Probe_case& asked, Ray_answer& answer) {
        if (asked.body != c.body || asked.from != c.from || asked.direction != c.direction) answer.all.clear();
      });
      try_all<Ray_level>(tried, ray_relations(), c, Question::surface, *ask, {}, lies, {});
    }
  for (const auto& [name, t] : tried) {
    BOOST_TEST(t.held > 8, name);
    if (name != "R1 first") BOOST_TEST(t.noticed > t.held / 8, name);  // of rays that meet something
  }
}

BOOST_AUTO_TEST_CASE(hits_out_of_order_are_noticed)
{
  const auto ask = ray_subjects()[0].make();
  const Probe_case c = ray_families()[0].probe_case(1, 0);
  const Ray_answer backwards{Ray_hit{0, 1.0}, {Ray_hit{0, 1.0}, Ray_hit{1, 0.5}}},
      another_first{Ray_hit{2, 1.0}, {Ray_hit{0, 1.0}}};
  BOOST_TEST_REQUIRE(ray_relations()[0].name == "R1 first");
  for (const Ray_answer& told : {backwards, another_first}) {
    Spoils<Probe_case, Ray_answer> spoiled(*ask, [&](const Probe_case&, Ray_answer& answer) { answer = told; });
    Random random(1);
    BOOST_TEST((ray_relations()[0].check({c, Question::surface, spoiled, told, random}) == Verdict::violated));
  }
}

BOOST_AUTO_TEST_CASE(relations_of_scenes_hold_and_each_is_violated_by_some_error)
{
  using Wrong = Spoils<Scene_case, Frames_of_pairs>;
  const auto right = scene_subjects()[0].make();
  Wrong not_of_the_last(*right, [](const Scene_case& c, Frames_of_pairs& told) {
    for (auto& pairs : told)
      std::erase_if(pairs, [&](const Body_pair& pair) { return pair[1] + 1 == c.frames[0].bodies.size(); });
  });
  Wrong of_large_numbers_alone(*right, [](const Scene_case& c, Frames_of_pairs& told) {
    for (std::size_t f = 0; f < told.size(); ++f)
      std::erase_if(told[f], [&](const Body_pair& pair) { return !(c.frames[f].bodies[pair[0]]->pose[3] >= 0); });
  });
  Wrong late(*right, [](const Scene_case&, Frames_of_pairs& told) {
    for (std::size_t f = told.size(); f-- > 1;) told[f] = told[f - 1];
  });
  Wrong no_solids(*right, [](const Scene_case& c, Frames_of_pairs& told) {
    if (c.question == Question::solid)
      for (auto& pairs : told) pairs.clear();
  });
  Wrong* const wrong[] = {&not_of_the_last, &of_large_numbers_alone, &late, &late, &late, &no_solids};
  const auto relations = scene_relations();
  BOOST_REQUIRE(relations.size() == std::size(wrong));
  All_tried tried;
  for (const char* name : {"scene-grid", "scene-drift", "scene-hollows", "scene-crowd"})
    for (std::uint64_t k = 0; k < 4; ++k) {
      const Scene_case c = find_named(scene_families(), name)->scene_case(2, k);
      const Frames_of_pairs given = (*right)(c).answer;
      for (std::size_t number = 0; number < relations.size(); ++number)
        try_all<Scene_level>(tried, relations.subspan(number, 1), c, c.question, *right, given, *wrong[number],
                             (*wrong[number])(c).answer);
    }
  for (const auto& [name, t] : tried) BOOST_TEST(t.noticed > 0, name);
}

BOOST_AUTO_TEST_CASE(relations_of_motions_hold_are_violated_by_wrong_times_and_not_by_silence)
{
  /// Tells the same of every motion.
  class Tells : public Running_motion {
   public:
    explicit Tells(Told_contact told) : told_(told) {}
    Told_contact operator()(const Moving_bodies&, Question) override { return told_; }

   private:
    Told_contact told_;
  };
  Tells late({Outcome::yes, {0.75, 0.75}}), declines({Outcome::not_asked}), fails({Outcome::failed});
  const auto right = moving_bodies_subjects().front().make();
  All_tried tried;
  int violated = 0;
  for (const Moving_body_family& family : moving_body_families())
    for (std::uint64_t k = 0; k < 3; ++k) {
      const Moving_bodies c = moving_bodies_case(family, 5, k);
      try_all<Motion_level>(tried, moving_body_relations(), c, Question::surface, *right, {}, late, {});
      Random random(3);
      for (const Motion_level::Relation& relation : moving_body_relations())
        for (Tells* silent : {&declines, &fails})
          BOOST_TEST((relation.check({c, Question::surface, *silent, {}, random}) == Verdict::not_applicable),
                     relation.name);
    }
  for (const auto& [name, t] : tried) {
    BOOST_TEST(t.held > 30, name);
    violated += t.noticed;
  }
  BOOST_TEST(violated > int(moving_body_families().size()));
}

BOOST_AUTO_TEST_SUITE_END()
