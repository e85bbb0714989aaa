#include "verify/campaign/levels.h"

#include "verify/campaign/campaign.h"
#include "verify/test/support/database_number.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_levels)

using namespace tetracone::verify;
using tetracone::kernel::Question;
using tetracone::kernel::Solid_relation;

namespace {

const std::string wrong = "false_positives + false_negatives + failures";

/// The rows of campaigns that ask one level alone.
template <class Level>
class Rows {
 public:
  Rows(std::vector<const typename Level::Family*> families, std::vector<typename Level::Subject> subjects)
  {
    static_cast<Sizes&>(campaign_) = {0, 0, 0, 0};
    campaign_.seed = 7;
    campaign_.sequence_frames = 0;
    campaign_.made_by = {"0", "compiler", "flags", "processor"};
    campaign_.at<Level>() = {true, std::move(families), std::move(subjects)};
  }

  /// Asks so many cases of each family, and returns how many it has asked or found.
  std::int64_t ask(std::uint64_t cases)
  {
    campaign_.*Level::size = cases;
    std::int64_t done = 0;
    run_campaign(database_, campaign_, [&](std::uint64_t n) { done += std::int64_t(n); });
    BOOST_TEST(done == std::int64_t(case_count(campaign_)));
    BOOST_TEST(done == std::int64_t(cases * campaign_.at<Level>().families.size()));
    return done;
  }

  std::int64_t number(const std::string& query) { return tetracone::verify::number(database_, query); }
  std::int64_t truth(const std::string& what) { return number("SELECT sum(" + what + ") FROM truth"); }
  std::int64_t relations(const std::string& what, const std::string& subject)
  {
    return number("SELECT sum(" + what + ") FROM relation WHERE subject LIKE '" + subject + "'");
  }
  std::int64_t sum(const std::string& what, const std::string& subject, const std::string& question = "%")
  {
    return tally(database_, what, "subject LIKE '" + subject + "' AND question LIKE '" + question + "'");
  }

 private:
  Temporary_file file_{"level_campaign.db", ""};
  Database database_{file_.path(), Database::Mode::write};
  Campaign campaign_;
};

/// What a subject tells, except for one error.
template <class Case, class Answer, class... Question>
class Spoils : public Running<Case, Answer, Question...> {
 public:
  using Right = std::unique_ptr<Running<Case, Answer, Question...>>;
  using Spoil = std::function<void(Told<Answer>&)>;
  Spoils(Right right, Spoil spoil) : right_(std::move(right)), spoil_(std::move(spoil)) {}

  Told<Answer> operator()(const Case& c, Question... question) override
  {
    Told<Answer> told = (*right_)(c, question...);
    spoil_(told);
    return told;
  }

 private:
  Right right_;
  Spoil spoil_;
};

/// Returns `right` with an error, under another name.
template <class Case, class Answer, class... Question>
auto spoiled(const Subject_of<Running<Case, Answer, Question...>>& right, const char* name,
             const std::type_identity_t<std::function<void(Told<Answer>&)>>& spoil, bool is_exact = false)
{
  using Spoiled = Spoils<Case, Answer, Question...>;
  return Subject_of<Running<Case, Answer, Question...>>{
      name, is_exact, "", [right, spoil] { return std::make_unique<Spoiled>(right.make(), spoil); }};
}

template <class Answer>
void fail(Told<Answer>& told)
{
  told = {Outcome::failed};
}

/// The adaptive tree's answers, except for one statement.
class Spoils_one : public Running_subject {
 public:
  /// Nothing is spoiled where no function is given.
  struct Spoil {
    void (*distance)(Distance_answer& answer) = nullptr;
    void (*solids)(Solid_answer& answer) = nullptr;
    void (*exits)(Exit_answer& answer) = nullptr;
    bool says_within = false;  ///< whatever the limit
  };
  explicit Spoils_one(const Spoil& spoil) : spoil_(spoil) {}

  Outcome operator()(const Object_case& c, Question question) override { return (*right_)(c, question); }
  Told<Distance_answer> distance(const Object_case& c, Question question) override
  {
    return spoiled(right_->distance(c, question), spoil_.distance);
  }
  Told<Solid_answer> solids(const Object_case& c) override { return spoiled(right_->solids(c), spoil_.solids); }
  Told<Exit_answer> exits(const Object_case& c, const std::array<tetracone::kernel::Rational, 3>& direction) override
  {
    return spoiled(right_->exits(c, direction), spoil_.exits);
  }
  Outcome within(const Object_case& c, Question question, const std::string& limit) override
  {
    return spoil_.says_within ? Outcome::yes : right_->within(c, question, limit);
  }

 private:
  template <class Answer>
  static Told<Answer> spoiled(Told<Answer> told, void (*spoil)(Answer& answer))
  {
    if (spoil) spoil(told.answer);
    return told;
  }

  Spoil spoil_;
  std::unique_ptr<Running_subject> right_ = solid_subjects()[0].make();
};

Object_subject spoiling(const char* name, const Spoils_one::Spoil& spoil)
{
  return {name, false, "", {}, [spoil] { return std::make_unique<Spoils_one>(spoil); }};
}
Object_subject spoiled_solids(const char* name, void (*spoil)(Solid_answer& answer))
{
  return spoiling(name, {.solids = spoil});
}
Object_subject spoiled_exits(const char* name, void (*spoil)(Exit_answer& answer))
{
  return spoiling(name, {.exits = spoil});
}

Solid_relation another(Solid_relation relation) { return Solid_relation(7 - int(relation)); }

class Tells_nothing : public Running_subject {
 public:
  Outcome operator()(const Object_case&, Question) override { return Outcome::no; }
};
const Object_subject nothing{"nothing", false, "", {}, [] { return std::make_unique<Tells_nothing>(); }};

std::vector<const Family*> named(const std::vector<const char*>& names)
{
  std::vector<const Family*> families;
  for (const char* name : names) families.push_back(find_family(name));
  return families;
}

/// Asks the exact subjects of a level so many cases of every family: both truths agree, all answers are right, and all
/// relations hold.
template <class Level>
void check_exact(std::uint64_t cases)
{
  auto subjects = Level::subjects();
  std::erase_if(subjects, [](const auto& subject) { return !subject.is_exact; });
  Rows<Level> rows(Level::families(), subjects);
  rows.ask(cases);
  BOOST_TEST_CONTEXT(Level::name)
  {
    BOOST_TEST(rows.sum(wrong, "%") == 0);
    BOOST_TEST(rows.relations("violated", "%") == 0);
    BOOST_TEST(rows.relations("tried", "%") > 0);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_subjects_are_right_about_every_family)
{
  check_exact<levels::Predicates>(24);
  check_exact<levels::Objects>(2);
  check_exact<levels::Features>(2);
  check_exact<levels::Contacts>(2);
  check_exact<levels::Points>(8);
  check_exact<levels::Rays>(8);
}

BOOST_AUTO_TEST_CASE(a_program_is_counted_for_the_triangles_that_it_is_asked)
{
  /// Declines, fails and says yes in turn.
  class Takes_turns : public Running_predicates {
   public:
    Takes_turns() : Running_predicates("turns") {}
    Told<int> operator()(const Predicate_case& c, Predicate predicate) override
    {
      if (predicate != Predicate::triangle_triangle || c.origin.index % 3 == 0) return {};
      if (c.origin.index % 3 == 1) return {Outcome::failed};
      return {Outcome::yes, 1};
    }
    Failure failure() const override { return {"status 3", "no idea"}; }
  };
  const Predicate_subject turns{"turns", false, "", nullptr, [] { return std::make_unique<Takes_turns>(); }};
  const auto all = levels::Predicates::families();
  const auto apart = std::ranges::find(all, "nested", [](const Family* family) { return family->name; });
  BOOST_TEST_REQUIRE((apart != all.end()));
  Rows<levels::Predicates> rows({*apart}, {turns});
  rows.ask(12);
  for (const char* question : {"%", "triangle-triangle"}) {
    BOOST_TEST(rows.sum("n", "turns", question) == 8);
    BOOST_TEST(rows.sum("failures", "turns", question) == 4);
    BOOST_TEST(rows.sum("not_asked", "turns", question) == 4);
    BOOST_TEST(rows.sum("false_positives", "turns", question) == 4);
  }
  BOOST_TEST(rows.number("SELECT n FROM failure WHERE how = 'status 3' AND question = 'triangle-triangle'") == 4);
}

BOOST_AUTO_TEST_CASE(what_rounding_the_input_costs_is_parted_from_what_the_subject_does)
{
  /// Exact about the input in floats.
  class Rounds : public Running_subject {
   public:
    Outcome operator()(const Object_case& c, Question question) override
    {
      const auto rounded = float_input(c, In_floats::vertices_and_poses);
      return rounded ? (*exact_)(*rounded, question) : Outcome::not_asked;
    }

   private:
    std::unique_ptr<Running_subject> exact_ = object_subjects()[0].make();
  };
  Object_subject exact = object_subjects()[0];
  exact.in_floats = In_floats::vertices_and_poses;
  Object_subject rounds = exact;
  rounds.name = "rounds";
  rounds.own.reset();
  rounds.make = [] { return std::make_unique<Rounds>(); };
  const auto all = levels::Objects::families();
  const auto ladder = std::ranges::find(all, "ladder", [](const Family* family) { return family->name; });
  BOOST_TEST_REQUIRE((ladder != all.end()));
  Rows<levels::Objects> rows({*ladder}, {exact, rounds});
  rows.ask(40);
  const auto sum = [&](const std::string& what, const std::string& subject) {
    return rows.number("SELECT sum(" + what + ") FROM rounded WHERE subject = '" + subject + "'");
  };
  const auto changed = sum("changed", exact.name);
  BOOST_TEST(changed > 4);
  BOOST_TEST(sum("n", exact.name) == 80);
  BOOST_TEST(sum("wrong", exact.name) == 0);
  BOOST_TEST(sum("false_positives + false_negatives", exact.name) == changed);
  BOOST_TEST(sum("n", "rounds") == 80);
  BOOST_TEST(sum("wrong", "rounds") == changed);
  BOOST_TEST(sum("excused", "rounds") == changed);
  BOOST_TEST(sum("false_positives + false_negatives", "rounds") == 0);
  BOOST_TEST(rows.sum(wrong, "rounds") == changed);
}

BOOST_AUTO_TEST_CASE(every_distance_of_every_family_is_exact)
{
  auto families = named({"random", "voxels", "sliver", "wild", "nested", "degenerate-face"});
  for (const Family& family : distance_families()) families.push_back(&family);
  Rows<levels::Distances> rows(families, distance_subjects());
  rows.ask(1);
  const std::int64_t asked = rows.truth("n"), zero = rows.truth("positives");
  BOOST_TEST(asked > 20);
  BOOST_TEST(zero > 0);
  BOOST_TEST(asked - zero > 12);
  for (const Object_subject& subject : distance_subjects()) {
    BOOST_TEST(rows.sum("n + not_asked", subject.name) == asked, subject.name);
    BOOST_TEST(rows.sum("n", subject.name) > asked / 3, subject.name);
    BOOST_TEST(rows.sum(wrong, subject.name) == 0, subject.name);
  }
  BOOST_TEST(rows.relations("violated", "adaptive%") == 0);
  BOOST_TEST(rows.relations("tried", "adaptive%") > asked / 4);
}

BOOST_AUTO_TEST_CASE(each_wrong_statement_about_a_distance_is_counted)
{
  auto families = named({"random", "nested", "degenerate-face"});
  for (std::size_t k = 0; k < 4; ++k) families.push_back(&distance_families()[k]);
  Rows<levels::Distances> rows(
      families,
      {spoiling("root", {[](Distance_answer& a) { a.alone = a.nearest.distance = std::nextafter(a.alone, HUGE_VAL); }}),
       spoiling("square", {[](Distance_answer& a) { a.nearest.squared = "7/3"; }}),
       spoiling("points", {[](Distance_answer& a) { std::swap(a.nearest.point[0], a.nearest.point[1]); }}),
       spoiling("always within", {.says_within = true}), nothing});
  rows.ask(1);
  const std::int64_t asked = rows.truth("n"), zero = rows.truth("positives");
  BOOST_TEST(zero > 0);
  BOOST_TEST(asked - zero > 6);
  for (const char* subject : {"root", "square", "points", "always within"}) {
    BOOST_TEST(rows.sum("n", subject) == asked, subject);
    BOOST_TEST(rows.sum("false_positives", subject) == 0, subject);
    BOOST_TEST(rows.sum("false_negatives", subject) >= asked - zero - 2, subject);
  }
  BOOST_TEST(rows.sum("not_asked", "nothing") == asked);
}

BOOST_AUTO_TEST_CASE(every_relation_is_exact_and_each_wrong_statement_is_counted)
{
  Rows<levels::Relations> rows(
      named({"lego", "random", "nested", "nested-touching", "face-on-face", "degenerate-face", "wild", "voxels"}),
      {solid_subjects()[0], solid_subjects()[1], solid_subjects()[2],
       spoiled_solids("relation", [](Solid_answer& a) { a.overlap.contact.relation = a.alone = another(a.alone); }),
       spoiled_solids("alone", [](Solid_answer& a) { a.alone = another(a.alone); }),
       spoiled_solids("dimension", [](Solid_answer& a) { --a.overlap.contact.dimension; }),
       spoiled_solids("volume", [](Solid_answer& a) { a.overlap.volume += 1; }),
       spoiled_solids("bounds", [](Solid_answer& a) { a.bounds.volume[1] = -1; }),
       spoiled_solids("vector", [](Solid_answer& a) { a.contact_vector[1] += 1; }),
       spoiled_solids("area", [](Solid_answer& a) { a.contact_area[0] = a.contact_area[1] + 1; }),
       spoiled_solids("doubles", [](Solid_answer& a) { a.centroid[2] = std::nextafter(a.centroid[2], HUGE_VAL); }),
       nothing});
  const std::int64_t asked = rows.ask(4);
  BOOST_TEST(rows.truth("n") == 8 * asked);
  BOOST_TEST(rows.truth("positives") == asked);
  BOOST_TEST(rows.truth("by_construction") == 8 * 4);
  for (const Object_subject& subject : solid_subjects()) {
    BOOST_TEST(rows.sum("n", subject.name) == 3 * asked, subject.name);
    BOOST_TEST(rows.sum(wrong, subject.name) == 0, subject.name);
    BOOST_TEST(rows.relations("violated", subject.name) == 0, subject.name);
    BOOST_TEST(rows.relations("tried", subject.name) > asked / 8, subject.name);
  }
  BOOST_TEST(rows.sum(wrong, "relation", "relation") == asked);
  BOOST_TEST(rows.sum("false_negatives", "alone", "relation") == asked);
  BOOST_TEST(rows.sum("false_negatives", "dimension", "dimension") == asked);
  BOOST_TEST(rows.sum("false_negatives", "volume", "overlap") == asked);
  for (const char* subject : {"bounds", "doubles", "vector", "area"})
    BOOST_TEST(rows.sum("false_negatives", subject, "overlap") == asked);
  for (const char* question : {"relation", "overlap"}) BOOST_TEST(rows.sum(wrong, "dimension", question) == 0);
  BOOST_TEST(rows.sum("not_asked", "nothing") == 3 * asked);
}

BOOST_AUTO_TEST_CASE(every_exit_is_exact_and_each_wrong_statement_is_counted)
{
  Rows<levels::Exits> rows(
      named({"lego", "random", "nested", "nested-touching", "face-on-face", "degenerate-face"}),
      {solid_subjects()[0], solid_subjects()[1], solid_subjects()[2],
       spoiled_exits("first", [](Exit_answer& a) { a.exits.first += 1; }),
       spoiled_exits("last", [](Exit_answer& a) { a.exits.last += 1; }),
       spoiled_exits("doubles", [](Exit_answer& a) { a.last = std::nextafter(a.last, HUGE_VAL); }), nothing});
  rows.ask(4);
  const std::int64_t asked = rows.truth("n") / 2;
  BOOST_TEST(asked > 6);
  BOOST_TEST(rows.truth("positives") > asked / 4);
  BOOST_TEST(rows.truth("by_construction") == 2 * 4);
  const std::int64_t depths = rows.sum("n", solid_subjects()[0].name, "depth");
  BOOST_TEST(depths > 0);
  for (const Object_subject& subject : solid_subjects()) {
    BOOST_TEST(rows.sum("n", subject.name) == 2 * asked + depths, subject.name);
    BOOST_TEST(rows.sum(wrong, subject.name) == 0, subject.name);
    BOOST_TEST(rows.relations("violated", subject.name) == 0, subject.name);
    BOOST_TEST(rows.relations("tried", subject.name) > 0, subject.name);
  }
  BOOST_TEST(rows.sum(wrong, "first", "first exit") == asked);
  BOOST_TEST(rows.sum(wrong, "last", "last exit") == asked);
  BOOST_TEST(rows.sum(wrong, "doubles", "last exit") == asked);
  for (const char* subject : {"last", "doubles"}) BOOST_TEST(rows.sum(wrong, subject, "first exit") == 0);
  BOOST_TEST(rows.sum("not_asked", "nothing") == 2 * asked + depths);
}

BOOST_AUTO_TEST_CASE(first_contacts_of_every_family_are_judged)
{
  const auto all = moving_bodies_subjects();
  const auto spoil = [&](const char* name, const std::function<void(Told_contact&)>& how, bool is_exact = false) {
    return spoiled(all[0], name, how, is_exact);
  };
  Rows<levels::Motions> rows(
      pointers(moving_body_families()),
      {all[0], all[1], spoil("one of the doubles", [](Told_contact& told) { told.answer.hi = told.answer.lo; }),
       spoil(
           "one, and promises both", [](Told_contact& told) { told.answer.lo = told.answer.hi; }, true),
       spoil("late",
             [](Told_contact& told) { told.answer.lo = told.answer.hi = std::nextafter(told.answer.hi, HUGE_VAL); }),
       spoil("misses", [](Told_contact& told) { told = {Outcome::no}; }),
       spoil("invents", [](Told_contact& told) { told = {Outcome::yes}; }),
       spoil("declines", [](Told_contact& told) { told = {}; }), spoil("fails", fail<tetracone::kernel::Time_bounds>)});
  const std::int64_t done = rows.ask(1), asked = 2 * done, meet = rows.truth("positives");
  const auto sum = [&](const std::string& what, const std::string& subject, bool of_times) {
    const std::int64_t times = rows.sum(what, subject, "% time");
    return of_times ? times : rows.sum(what, subject) - times;
  };
  BOOST_TEST(rows.truth("n") == asked);
  BOOST_TEST(rows.truth("by_construction") > asked / 4);
  BOOST_TEST(meet > asked / 4);
  BOOST_TEST(meet < asked);
  BOOST_TEST(sum("n", "adaptive tree", false) == asked);
  BOOST_TEST(sum("n", "adaptive tree", true) == meet);
  BOOST_TEST(rows.sum(wrong, "adaptive tree") == 0);
  BOOST_TEST(sum(wrong, "one of the doubles", true) == 0);
  BOOST_TEST(sum("false_positives", "one, and promises both", true) > 0);
  BOOST_TEST(sum("false_positives", "static 10", false) == 0);
  BOOST_TEST(sum("false_positives", "static 10", true) > 0);
  BOOST_TEST(sum("false_negatives", "static 10", true) == 0);
  BOOST_TEST(sum(wrong, "late", false) == 0);
  BOOST_TEST(sum("false_positives", "late", true) == meet);
  BOOST_TEST(sum("false_negatives", "misses", false) == meet);
  BOOST_TEST(sum("n", "misses", true) == 0);
  BOOST_TEST(sum("false_positives", "invents", false) == asked - meet);
  BOOST_TEST(sum("false_negatives", "invents", true) > 0);
  BOOST_TEST(rows.sum("not_asked", "declines") == asked);
  BOOST_TEST(rows.sum("failures", "fails") == asked);
  BOOST_TEST(rows.number("SELECT count(*) FROM wrong WHERE subject = 'fails' AND answer IS NULL") == asked);
  BOOST_TEST(rows.relations("violated", "adaptive tree") == 0);
  BOOST_TEST(rows.relations("tried", "adaptive tree") > done / 2);
  BOOST_TEST(rows.relations("tried", "declines") == 0);
  // Again with the same words: nothing is asked twice.
  rows.ask(1);
  BOOST_TEST(sum("n", "adaptive tree", false) == asked);
}

BOOST_AUTO_TEST_CASE(points_are_judged)
{
  const Point_subject right = point_subjects()[0];
  Rows<levels::Points> rows(
      pointers(point_families()),
      {right, spoiled(right, "misses", [](Told<int>& told) { told.answer = -1; }), spoiled(right, "fails", fail<int>)});
  const std::int64_t points = rows.ask(12), inside = rows.truth("positives");
  BOOST_TEST(rows.sum("n", right.name) == points);
  BOOST_TEST(rows.sum(wrong, right.name) == 0);
  BOOST_TEST(rows.sum("failures", "fails") == points);
  BOOST_TEST(inside > points / 20);
  BOOST_TEST(rows.sum("false_negatives", "misses") > inside);  // what is on the surface too
  BOOST_TEST(rows.sum("false_positives", "misses") == 0);
  BOOST_TEST(rows.relations("violated", right.name) == 0);
  BOOST_TEST(rows.relations("tried", right.name) > points / 6);
  BOOST_TEST(rows.number("SELECT count(*) FROM wrong WHERE subject = 'fails' AND answer IS NULL") == points);
  // Again with the same words nothing is asked twice, and with more cases only these.
  rows.ask(12);
  BOOST_TEST(rows.sum("n", right.name) == points);
  rows.ask(20);
  BOOST_TEST(rows.sum("n", right.name) == points / 12 * 20);
}

BOOST_AUTO_TEST_CASE(rays_are_judged_by_three_questions)
{
  const Ray_subject right = ray_subjects()[0];
  Rows<levels::Rays> rows(pointers(ray_families()),
                          {right, spoiled(right, "misses", [](Told<Ray_answer>& told) { told.answer = {}; }),
                           spoiled(right, "fails", fail<Ray_answer>)});
  const std::int64_t rays = rows.ask(12), met = rows.truth("positives") / 3;
  BOOST_TEST(rows.sum("n", right.name) == 3 * rays);
  BOOST_TEST(rows.sum(wrong, right.name) == 0);
  BOOST_TEST(rows.sum("failures", "fails") == 3 * rays);
  BOOST_TEST(met > rays / 3);
  for (const char* question : {"first", "hits", "faces"}) {
    BOOST_TEST(rows.sum("false_negatives", "misses", question) == met);
    BOOST_TEST(rows.sum("false_positives", "misses", question) == 0);
  }
  BOOST_TEST(rows.relations("violated", right.name) == 0);
  BOOST_TEST(rows.relations("tried", right.name) > rays / 6);
  BOOST_TEST(rows.number("SELECT count(*) FROM wrong WHERE subject = 'fails' AND answer IS NULL") == 3 * rays);
}

BOOST_AUTO_TEST_CASE(every_frame_of_every_family_is_exact_and_each_wrong_list_is_counted)
{
  auto subjects = scene_subjects();
  const auto add = [&](const char* name, void (*spoil)(Frames_of_pairs & told)) {
    subjects.push_back(spoiled(subjects[0], name, [spoil](Told<Frames_of_pairs>& told) { spoil(told.answer); }));
  };
  add("as the frame before", [](Frames_of_pairs& told) {
    for (std::size_t f = told.size(); f-- > 1;) told[f] = told[f - 1];
  });
  add("one too many", [](Frames_of_pairs& told) {
    for (auto& pairs : told) pairs.push_back({98, 99});
  });
  add("one too few", [](Frames_of_pairs& told) {
    for (auto& pairs : told)
      if (!pairs.empty()) pairs.pop_back();
  });
  subjects.push_back(spoiled(subjects[0], "nothing", fail<Frames_of_pairs>));

  Rows<levels::Scenes> rows(pointers(scene_families()), subjects);
  const std::int64_t scenes = rows.ask(1), frames = rows.truth("n"), meet = rows.truth("positives");
  BOOST_TEST(frames == 8 * scenes);
  BOOST_TEST(meet > frames / 2);
  for (const Scene_subject& subject : scene_subjects()) {
    BOOST_TEST(rows.sum("n", subject.name) == frames, subject.name);
    if (subject.is_exact) BOOST_TEST(rows.sum(wrong, subject.name) == 0, subject.name);
  }
  BOOST_TEST(rows.sum(wrong, "as the frame before") > frames / 4);
  BOOST_TEST(rows.sum("false_positives", "one too many") == frames);
  BOOST_TEST(rows.sum("false_negatives", "one too few") == meet);
  BOOST_TEST(rows.sum("failures", "nothing") == frames);
  // Only the first wrong frame of a scene is listed.
  BOOST_TEST(rows.number("SELECT count(*) FROM wrong WHERE subject = 'one too many'") == scenes);
  BOOST_TEST(rows.relations("violated", "adaptive%") == 0);
  BOOST_TEST(rows.relations("tried", "adaptive%") > frames);
  BOOST_TEST(rows.relations("violated", "as the frame before") > 0);
}

BOOST_AUTO_TEST_SUITE_END()
