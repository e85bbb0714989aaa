#include "verify/relations/relations.h"

#include "tetracone/covering/covering.h"
#include "verify/cases/exact_motion.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_relations)

using namespace tetracone::verify;
using tetracone::covering::Index;
using tetracone::covering::Polyhedron;
using tetracone::kernel::Pose;
using tetracone::kernel::Question;
using tetracone::kernel::Rational;
using tetracone::kernel::Vertex;
namespace kernel = tetracone::kernel;
namespace scenes = tetracone::verify::scenes;

namespace {

// --- subjects --------------------------------------------------------------------------------------------------------

const Predicate_subject& named(std::string_view name)
{
  const auto& all = predicate_subjects();
  return *std::ranges::find(all, name, &Predicate_subject::name);
}

/// The exact answer.
std::optional<int> right(Predicate predicate, const Predicate_case& c)
{
  static const Predicate_subject& adaptive = named("adaptive");
  return adaptive.answer(predicate, c);
}

Predicate_subject predicate_subject(const std::string& name,
                                    std::optional<int> (*answer)(Predicate, const Predicate_case&))
{
  return {name, true, "", answer};
}

/// The answer of a planted subject, given a case and the right answers.
using Truth = std::function<bool(const Object_case&, Question)>;
using Planted = std::function<Outcome(const Object_case&, Question, const Truth&)>;

class Wrong : public Running_subject {
 public:
  explicit Wrong(Planted planted) : planted_(std::move(planted)) {}
  Outcome operator()(const Object_case& c, Question question) override
  {
    return planted_(c, question,
                    [this](const Object_case& asked, Question q) { return (*truth_)(asked, q) == Outcome::yes; });
  }

 private:
  Planted planted_;
  std::unique_ptr<Running_subject> truth_ = object_subject(*Subject::parse("adaptive")).make();
};

Outcome outcome(bool yes) { return yes ? Outcome::yes : Outcome::no; }

// --- cases -----------------------------------------------------------------------------------------------------------

int between(Random& random, int low, int high) { return low + int(one_of(random, high - low + 1)); }

/// Identity, dyadic translation, signed permutation with translation, truly rigid, rounded, or any affine map of small
/// integers.
Pose any_pose(Random& random)
{
  const auto q = [&] {
    return Pose::from_quaternion(between(random, 1, 3), between(random, -2, 2), between(random, -2, 2),
                                 between(random, -2, 2));
  };
  const auto half = [&] { return between(random, -4, 4) * 0.5; };
  const Pose step = Pose::translation(half(), half(), half());
  switch (one_of(random, 6)) {
    case 0: return Pose();
    case 1: return step;
    case 2: return turned(Signed_permutation::any(random), step);
    case 3: return *translated(q(), {Rational(half()), Rational(half()), Rational(half())});
    case 4: return *translated(Pose(q().entries()), {0, 0, 0});
    default: break;
  }
  for (;;) {
    std::array<double, 12> entries;
    for (double& entry : entries) entry = between(random, -2, 2);
    if (Pose(entries).determinant_sign() != CGAL::ZERO) return Pose(entries);
  }
}

/// Points on a small grid, mostly degenerate; full mantissas; or full mantissas with p rounded onto a plane, an edge or
/// a corner.
Predicate_case any_points(Random& random)
{
  Predicate_case c{};
  const std::size_t kind = one_of(random, 4);
  const auto point = [&]() -> Vertex {
    Vertex v;
    for (double& x : v) x = kind == 0 ? between(random, -2, 2) : random.symmetric();
    return v;
  };
  for (Vertex& v : c.v) v = point();
  c.p = point();
  c.q = point();
  c.r = point();
  c.pose_a = any_pose(random);
  c.pose_b = one_of(random, 2) == 0 ? c.pose_a : any_pose(random);
  if (kind < 2) return c;
  const double s = random.unit(), t = kind == 2 ? random.unit() * (1 - s) : 0;
  for (int k = 0; k < 3; ++k) c.p[k] = s * c.v[1][k] + t * c.v[2][k] + (1 - s - t) * c.v[3][k];
  c.pose_b = c.pose_a;
  return c;
}

/// Small bodies of every kind on a small grid, often touching, or in general position.
Object_case any_bodies(Random& random)
{
  static const std::vector<scenes::Named> bodies = [] {
    std::vector<scenes::Named> bodies = scenes::closed_bodies();
    scenes::Random of_scenes(5);
    for (int k = 0; k < 3; ++k) bodies.push_back({"blob", scenes::blob(of_scenes, 1, 1, 2)});
    for (int k = 0; k < 4; ++k) bodies.push_back({"tetrahedron", scenes::random_tetrahedra(of_scenes, 1, 3)});
    bodies.push_back({"unit cube", scenes::unit_cube()});
    bodies.push_back({"unit cube of triangles", scenes::triangulated(scenes::unit_cube())});
    bodies.push_back({"thin box", scenes::box({0, 0, 0}, {3, 0.5, 1})});
    return bodies;
  }();
  const auto one = [&] { return std::make_shared<const Polyhedron>(bodies[one_of(random, bodies.size())].body); };
  Object_case c{one(), one(), any_pose(random), any_pose(random), {}, {}, {}};
  if (one_of(random, 3) == 0) {  // unit cubes that touch, or nearly so, under a true rotation
    c.a = std::make_shared<const Polyhedron>(scenes::unit_cube());
    c.b = std::make_shared<const Polyhedron>(scenes::triangulated(scenes::unit_cube()));
    c.pose_a = Pose::from_quaternion(between(random, 1, 3), between(random, -3, 3), between(random, -3, 3),
                                     between(random, -3, 3));
    c.pose_b = *translated_back(c.pose_a, {between(random, -1, 1) * 1.0, 1, between(random, -2, 2) * 0.5});
  } else if (one_of(random, 2) == 0) {  // side by side under one motion
    c.pose_a = any_pose(random);
    const Vertex step{between(random, -6, 6) * 0.5, between(random, -6, 6) * 0.5, between(random, -4, 4) * 0.5};
    if (const auto beside = translated_back(c.pose_a, step)) c.pose_b = *beside;
  }
  return c;
}

// --- judging ---------------------------------------------------------------------------------------------------------

struct Count {
  int applicable = 0, violated = 0;
};
using Counts = std::map<std::string, Count, std::less<>>;

void count(Counts& counts, std::string_view relation, Verdict verdict)
{
  Count& of = counts[std::string(relation)];
  of.applicable += verdict != Verdict::not_applicable;
  of.violated += verdict == Verdict::violated;
}

/// All relations, or one.
Counts of_predicates(const Predicate_subject& subject, int cases, std::uint64_t seed, std::string_view only = "")
{
  Counts counts;
  Random random(seed);
  for (int k = 0; k < cases; ++k) {
    const Predicate_case c = any_points(random);
    for (const auto& relation : predicate_relations())
      for (const Predicate predicate : all_predicates)
        if (only.empty() || relation.name == only)
          count(counts, relation.name, relation.check({c, predicate, subject, 0, random}));
  }
  return counts;
}

Counts of_objects(Running_subject& subject, int cases, std::uint64_t seed, std::string_view only = "")
{
  Counts counts;
  Random random(seed);
  for (int k = 0; k < cases; ++k) {
    const Object_case c = any_bodies(random);
    for (const auto& relation : object_relations())
      for (const Question question : {Question::solid, Question::surface})
        if (only.empty() || relation.name == only)
          count(counts, relation.name, relation.check({c, question, subject, {}, random}));
  }
  return counts;
}

std::set<std::string> violated(const Counts& counts)
{
  std::set<std::string> names;
  for (const auto& [name, of] : counts)
    if (of.violated > 0) names.insert(name);
  return names;
}

int violations(const Planted& planted, std::string_view relation)
{
  Wrong subject(planted);
  return of_objects(subject, 80, 31, relation).find(relation)->second.violated;
}

int violations(std::optional<int> (*planted)(Predicate, const Predicate_case&), std::string_view relation)
{
  return of_predicates(predicate_subject("planted", planted), 600, 32, relation).find(relation)->second.violated;
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_are_unique_on_each_level)
{
  const auto check = [](const auto& relations) {
    std::set<std::string_view> names;
    for (const auto& relation : relations) {
      BOOST_TEST(names.insert(relation.name).second, relation.name);
      BOOST_TEST(!relation.what.empty(), relation.name);
    }
    BOOST_TEST(!names.empty());
  };
  check(predicate_relations());
  check(object_relations());
  check(feature_relations());
  check(contact_relations());
  check(distance_relations());
  check(point_relations());
  check(ray_relations());
  check(scene_relations());
  check(moving_body_relations());
  check(solid_relations());
}

BOOST_AUTO_TEST_CASE(exact_sums_are_those_that_rationals_find_exact)
{
  Random random(1);
  int exact = 0;
  for (int k = 0; k < 2000; ++k) {
    const double a = std::ldexp(random.symmetric(), between(random, -3, 3)),
                 b = std::ldexp(random.symmetric(), between(random, -60, 3));
    const auto sum = exact_sum(a, b);
    BOOST_TEST(sum.has_value() == (Rational(a + b) == Rational(a) + Rational(b)));
    exact += sum.has_value();
    if (const auto middle = exact_middle(a, b)) BOOST_TEST((2 * Rational(*middle) == Rational(a) + Rational(b)));
  }
  BOOST_TEST((exact > 50 && exact < 1900));
  BOOST_TEST(!exact_sum(1e308, 1e308).has_value());
  BOOST_TEST(!exact_scaled(5e-324, -1).has_value());
  BOOST_TEST(!exact_middle(5e-324, 0).has_value());
  BOOST_TEST(!exact_scaled(1e308, 4).has_value());
  BOOST_TEST(exact_scaled(3, -2).value() == 0.75);
}

BOOST_AUTO_TEST_CASE(a_pose_is_scaled_by_powers_of_two_that_are_doubles_only)
{
  const Pose pose = Pose::translation(3, 0, -0.5), still;
  const Pose least = scaled(pose, -1072).value();
  BOOST_TEST((least[3] == std::ldexp(3.0, -1072) && least[11] == std::ldexp(-0.5, -1072)));
  BOOST_TEST(scaled(pose, 1022).value()[3] == std::ldexp(3.0, 1022));
  for (const int exponent : {1023, 1024, 5000, -1074, -1075, -5000})
    BOOST_TEST(!scaled(pose, exponent).has_value(), exponent);
  for (const int exponent : {1024, 5000, -1075, -5000}) BOOST_TEST(!scaled(still, exponent).has_value(), exponent);
  BOOST_TEST(scaled(still, -1074).value().is_identity());
}

BOOST_AUTO_TEST_CASE(motions_done_before_and_after_a_pose_are_what_they_say)
{
  Random random(2);
  for (int k = 0; k < 100; ++k) {
    const Pose pose = any_pose(random), other = any_pose(random);
    const Vertex v{random.symmetric(), 2, random.symmetric()}, d{0.5, -2, between(random, -3, 3) * 0.25};
    const auto image = [](const Pose& of, const Vertex& at) {
      std::array<Rational, 3> result;
      for (int row = 0; row < 3; ++row) {
        result[row] = of.exact(4 * row + 3);
        for (int j = 0; j < 3; ++j) result[row] += of.exact(4 * row + j) * Rational(at[j]);
      }
      return result;
    };
    const auto p = Signed_permutation::any(random);
    const auto at = image(pose, v), turned_at = image(turned(p, pose), v);
    for (int j = 0; j < 3; ++j) BOOST_TEST((turned_at[j] == p.sign[j] * at[p.axis[j]]));
    BOOST_TEST((image(turned_back(pose, p), p(v)) == at));
    BOOST_TEST((turned(p, Pose()).determinant_sign() == p.determinant()));
    const Vertex grid{1, -2, 3}, moved{grid[0] + d[0], grid[1] + d[1], grid[2] + d[2]};
    if (const auto back = translated_back(pose, d)) BOOST_TEST((image(*back, moved) == image(pose, grid)));
    if (const auto seen = seen_from(pose, other)) {
      // pose after seen is other: at the corners of a tetrahedron, hence everywhere.
      for (const Vertex& corner : {Vertex{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
        const auto s = image(*seen, corner);
        std::array<Rational, 3> whole;
        for (int row = 0; row < 3; ++row) {
          whole[row] = pose.exact(4 * row + 3);
          for (int j = 0; j < 3; ++j) whole[row] += pose.exact(4 * row + j) * s[j];
        }
        BOOST_TEST((whole == image(other, corner)));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(exact_predicates_hold_every_relation_and_each_is_asked_often)
{
  for (const Predicate_subject& subject : predicate_subjects()) {
    if (!subject.is_exact) continue;
    const bool is_adaptive = subject.name == "adaptive";
    for (const auto& [name, of] : of_predicates(subject, is_adaptive ? 500 : 120, 41)) {
      BOOST_TEST_INFO_SCOPE(subject.name << ", " << name << ": applied " << of.applicable);
      BOOST_TEST(of.violated == 0);
      BOOST_TEST(of.applicable >= (name == "R11 stages" && !is_adaptive ? 0 : 50));
    }
  }
}

BOOST_AUTO_TEST_CASE(rounded_predicates_violate_many_relations)
{
  const auto names = violated(of_predicates(named("double"), 800, 42));
  for (const char* name : {"R1 permutations", "R2 one frame", "R4 grassmann-pluecker", "R7 split", "R8 order"})
    BOOST_TEST(names.count(name) == 1u, name << " is never violated");
  // A permutation of the axes and a power of two change no rounding.
  BOOST_TEST(names.count("R6 scale") == 0u);
}

BOOST_AUTO_TEST_CASE(exact_objects_hold_every_relation_and_each_is_asked_often)
{
  const std::vector<std::tuple<const char*, Method, int>> subjects = {{"adaptive", Method::tree, 40},
                                                                      {"adaptive", Method::paper, 20},
                                                                      {"adaptive", Method::brute, 60},
                                                                      {"rational", Method::tree, 10}};
  for (const auto& [kernel_name, method, cases] : subjects) {
    const auto subject = object_subject(*Subject::parse(kernel_name, method));
    const Counts counts = of_objects(*subject.make(), cases, 51);
    for (const auto& [name, of] : counts) {
      BOOST_TEST_INFO_SCOPE(subject.name << ", " << name << ": applied " << of.applicable);
      BOOST_TEST(of.violated == 0);
      BOOST_TEST(of.applicable >= cases / 20);
    }
  }
}

BOOST_AUTO_TEST_CASE(features_may_be_asked_with_the_bodies_swapped)
{
  // Leaves out what is an edge of B.
  class One_way : public Running_subject {
   public:
    Outcome operator()(const Object_case&, Question) override { return Outcome::not_asked; }
    Told<Feature_pairs> features(const Object_case& c) override
    {
      auto all = exact_->features(c);
      std::erase_if(all.answer, [](const auto& pair) { return pair.body == 1; });
      return all;
    }

   private:
    std::unique_ptr<Running_subject> exact_ = object_subject(*Subject::parse("adaptive")).make();
  } one_way;
  const auto exact = object_subject(*Subject::parse("adaptive")).make();
  Random random(54);
  int violated = 0;
  for (int k = 0; k < 20; ++k) {
    const Object_case c = any_bodies(random);
    const auto check = feature_relations()[0].check;
    BOOST_TEST((check({c, Question::surface, *exact, {}, random}) == Verdict::holds));
    violated += check({c, Question::surface, one_way, {}, random}) == Verdict::violated;
  }
  BOOST_TEST(violated > 0);
}

BOOST_AUTO_TEST_CASE(rounded_objects_violate_several_relations)
{
  const auto subject = object_subject(*Subject::parse("double"));
  const auto names = violated(of_objects(*subject.make(), 100, 52));
  BOOST_TEST(names.size() >= 3u, "only " << names.size());
  BOOST_TEST(names.count("R6 scale") == 0u);
  const auto tolerant = object_subject(*Subject::parse("double-eps=1e-12"));
  BOOST_TEST(violated(of_objects(*tolerant.make(), 80, 53, "R6 scale")).count("R6 scale") == 1u);
}

BOOST_AUTO_TEST_CASE(planted_errors_of_objects_are_caught_by_the_relation_meant_for_them)
{
  const auto extent = [](const Object_case& c) {
    return std::abs(c.a->vertices[0][0]) + std::abs(c.a->vertices[1][0]) + std::abs(c.a->vertices[2][0]);
  };
  BOOST_TEST(violations(
                 [](const Object_case& c, Question q, const Truth& truth) {
                   return outcome(truth(c, q) && c.a->loop(0, 0)[0] % 2 == 0);  // by the order of vertices and faces
                 },
                 "R8 order") > 0);
  BOOST_TEST(
      violations([](const Object_case& c, Question q,
                    const Truth& truth) { return outcome(truth(c, q) && c.a->face_count() <= c.b->face_count()); },
                 "R5 swap") > 0);
  BOOST_TEST(violations([extent](const Object_case& c, Question q,
                                 const Truth& truth) { return outcome(truth(c, q) || extent(c) < 1e-6); },
                        "R6 scale") > 0);
  BOOST_TEST(violations(
                 [](const Object_case& c, Question q, const Truth& truth) {
                   return outcome(truth(c, q) &&
                                  (c.pose_a.is_identity() || c.pose_b.determinant_sign() == CGAL::POSITIVE));
                 },
                 "R6 motion") > 0);
  BOOST_TEST(violations([](const Object_case& c, Question q,
                           const Truth& truth) { return outcome(truth(c, q) && !c.pose_a.is_identity()); },
                        "R3 absorbed") > 0);
  BOOST_TEST(violations([](const Object_case& c, Question q,
                           const Truth& truth) { return outcome(truth(c, q) && !c.pose_a.is_identity()); },
                        "R5 relative") > 0);
  BOOST_TEST(violations(
                 [](const Object_case& c, Question q, const Truth& truth) {
                   return outcome(truth(c, q) && (q == Question::surface || tetracone::covering::volume(*c.a) > 0));
                 },
                 "R8 winding") > 0);
  BOOST_TEST(violations([](const Object_case& c, Question q,
                           const Truth& truth) { return outcome(truth(c, q) && c.a->vertices.size() % 2 == 0); },
                        "R10 unused") > 0);
  BOOST_TEST(violations([](const Object_case& c, Question q,
                           const Truth& truth) { return outcome(truth(c, q) && c.a->vertices[0][0] != 0); },
                        "R10 opposite") > 0);
  BOOST_TEST(violations([](const Object_case& c, Question q,
                           const Truth& truth) { return outcome(truth(c, q) && c.a->face_count() <= 8); },
                        "R9 adding") > 0);
  for (const char* relation : {"R7 edge", "R7 face"})
    BOOST_TEST(violations(
                   [](const Object_case& c, Question q, const Truth& truth) {
                     return outcome(truth(c, q) && (c.a->face_count() + c.a->vertices.size()) % 2 == 0);
                   },
                   relation) > 0,
               relation);
  BOOST_TEST(violations(
                 [](const Object_case& c, Question q, const Truth& truth) {
                   return outcome(truth(c, q) || (q == Question::surface && c.a->face_count() % 2 == 1));
                 },
                 "R9 removing") > 0);
  BOOST_TEST(violations(
                 [](const Object_case& c, Question q, const Truth& truth) {
                   const double t = c.pose_b[3] + c.pose_b[7] + c.pose_b[11];
                   return outcome(truth(c, q) && 2 * t != std::floor(2 * t));  // shy of the touching position itself
                 },
                 "R13 monotone") > 0);
}

BOOST_AUTO_TEST_CASE(planted_errors_of_predicates_are_caught_by_the_relation_meant_for_them)
{
  using Case = const Predicate_case&;
  const auto zero_is_positive = [](Predicate predicate, Case c) -> std::optional<int> {
    const auto answer = right(predicate, c);
    return predicate == Predicate::orientation && answer == 0 ? 1 : answer;
  };
  BOOST_TEST(violations(zero_is_positive, "R1 permutations") > 0);
  BOOST_TEST(violations(zero_is_positive, "R2 one frame") > 0);
  BOOST_TEST(violations(zero_is_positive, "R4 grassmann-pluecker") > 0);
  const auto first_end_in_plane_is_lost = [](Predicate predicate, Case c) -> std::optional<int> {
    // The effect of the published sign error: see kernel/predicate/segment_face.h.
    if (predicate == Predicate::segment_triangle && right(Predicate::orientation, c) == 0) return 0;
    return right(predicate, c);
  };
  BOOST_TEST(violations(first_end_in_plane_is_lost, "R5 swap") > 0);
  const auto long_segments_are_lost = [](Predicate predicate, Case c) -> std::optional<int> {
    const bool is_long = std::abs(c.p[0] - c.q[0]) > 1;
    return predicate == Predicate::segment_triangle && is_long ? std::optional(0) : right(predicate, c);
  };
  BOOST_TEST(violations(long_segments_are_lost, "R7 split") > 0);
  const auto far_is_outside = [](Predicate predicate, Case c) -> std::optional<int> {
    const bool far = magnitude(c.p) > 16;
    return far && predicate != Predicate::orientation ? std::optional(0) : right(predicate, c);
  };
  BOOST_TEST(violations(far_is_outside, "R6 scale") > 0);
  const auto reflections_are_forgotten = [](Predicate predicate, Case c) -> std::optional<int> {
    const auto answer = right(predicate, c);
    return predicate == Predicate::orientation && answer ? std::optional(*answer * int(c.pose_a.determinant_sign()))
                                                         : answer;
  };
  BOOST_TEST(violations(reflections_are_forgotten, "R2 one frame") > 0);
  BOOST_TEST(violations(reflections_are_forgotten, "R3 absorbed") > 0);
  BOOST_TEST(violations(reflections_are_forgotten, "R6 motion") > 0);
  const auto two_sides_of_three = [](Predicate predicate, Case c) -> std::optional<int> {
    if (predicate != Predicate::tetra_cone) return right(predicate, c);
    Predicate_case twin = c;
    for (int k = 0; k < 3; ++k) twin.v[3][k] = 2 * c.v[3][k] - c.v[1][k];  // a cone that is too wide
    return right(predicate, twin);
  };
  BOOST_TEST(violations(two_sides_of_three, "R8 order") > 0);
  const auto never_at_its_origin = [](Predicate predicate, Case c) -> std::optional<int> {
    if (predicate == Predicate::solid && c.p == c.q) return 0;
    return right(predicate, c);
  };
  BOOST_TEST(violations(never_at_its_origin, "R10 apex") > 0);
  const auto touching_is_apart = [](Predicate predicate, Case c) -> std::optional<int> {
    const double t = c.pose_b[3] + c.pose_b[7] + c.pose_b[11];
    if (predicate == Predicate::tetrahedron && 2 * t == std::floor(2 * t)) return 0;
    return right(predicate, c);
  };
  BOOST_TEST(violations(touching_is_apart, "R13 monotone") > 0);
}

BOOST_AUTO_TEST_CASE(a_subject_that_does_not_answer_violates_nothing)
{
  const auto silent = [](Predicate, const Predicate_case&) -> std::optional<int> { return std::nullopt; };
  for (const auto& [name, of] : of_predicates(predicate_subject("silent", silent), 50, 61))
    BOOST_TEST(of.applicable == 0, name);
  for (const Outcome mute : {Outcome::not_asked, Outcome::failed}) {
    Wrong subject([mute](const Object_case&, Question, const Truth&) { return mute; });
    for (const auto& [name, of] : of_objects(subject, 20, 62)) BOOST_TEST(of.applicable == 0, name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
