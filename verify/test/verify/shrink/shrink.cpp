// Shrinking, with subjects that are wrong in a known way: what is left is as small as that way allows.

#include "verify/shrink/shrink.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/planarity.h"
#include "verify/cases/shape_generators.h"
#include "verify/shrink/shrink_numbers.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/predicate_truth.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <memory>

BOOST_AUTO_TEST_SUITE(test_shrink)

using namespace tetracone;
using covering::Index;
using covering::Polyhedron;
using kernel::Pose;
using kernel::Question;
using verify::Object_case;
using verify::Outcome;
using verify::Predicate;
using verify::Predicate_case;
using verify::scenes::object_case;

namespace {

/// Right, but when `goes_wrong` says so.
class Planted : public verify::Running_subject {
 public:
  explicit Planted(std::function<bool(const Object_case&)> goes_wrong) : goes_wrong_(std::move(goes_wrong)) {}

  Outcome operator()(const Object_case& c, Question question) override
  {
    for (const auto& body : {c.a, c.b})
      for (Index f = 0; f < body->face_count(); ++f)
        BOOST_REQUIRE((covering::planarity(*body, f) != covering::Planarity::off_plane));
    if (question == Question::solid) BOOST_REQUIRE((covering::is_closed(*c.a) && covering::is_closed(*c.b)));
    BOOST_REQUIRE((c.pose_a.determinant_sign() != CGAL::ZERO && c.pose_b.determinant_sign() != CGAL::ZERO));
    const bool truth = verify::true_answer(c, question);
    return truth != goes_wrong_(c) ? Outcome::yes : Outcome::no;
  }

 private:
  std::function<bool(const Object_case&)> goes_wrong_;
};

Object_case shrunk(const Object_case& c, Question question, std::function<bool(const Object_case&)> goes_wrong)
{
  Planted subject(std::move(goes_wrong));
  const Outcome answer = subject(c, question);
  const bool truth = verify::true_answer(c, question);
  BOOST_REQUIRE((answer != (truth ? Outcome::yes : Outcome::no)));
  const auto check = verify::same_error(subject, question, answer, truth);
  const Object_case small = verify::shrink(c, question, check);
  BOOST_TEST(check(small));
  BOOST_TEST((verify::size_of(small) <= verify::size_of(c)));
  return small;
}

bool has_odd_last_bit(const Polyhedron& polyhedron)
{
  for (const auto& v : polyhedron.vertices)
    for (const double x : v)
      if (x != 0 && std::fmod(std::ldexp(std::frexp(x, std::make_unique<int>().get()), 53), 2) != 0) return true;
  return false;
}

const Pose turned(std::array<double, 12>{0.8, -0.6, 0, 0.1, 0.6, 0.8, 0, 0.2, 0, 0, 1, 0.3});

}  // namespace

BOOST_AUTO_TEST_CASE(a_subject_that_never_sees_contact_leaves_two_touching_tetrahedra)
{
  const Object_case c = object_case(verify::complex_one(), turned, verify::blob(128, 7), Pose());
  const Object_case small =
      shrunk(c, Question::solid, [](const Object_case& x) { return verify::true_answer(x, Question::solid); });
  BOOST_TEST(verify::face_count(c) == 18u + 128u);
  BOOST_TEST(verify::face_count(small) <= 8u);
  BOOST_TEST((small.pose_a.is_identity() && small.pose_b.is_identity()));
  BOOST_TEST(verify::size_of(small).bits < 40u);
}

BOOST_AUTO_TEST_CASE(an_odd_last_bit_is_all_that_is_left_of_many_bits)
{
  const Object_case c =
      object_case(verify::blob(128, 3), Pose(), verify::blob(32, 4), Pose::translation(0.1, 0.2, 0.3));
  BOOST_REQUIRE(has_odd_last_bit(*c.a));
  const Object_case small = shrunk(c, Question::solid, [](const Object_case& x) { return has_odd_last_bit(*x.a); });
  BOOST_TEST(verify::face_count(small) <= 8u);
  int odd = 0;
  for (const auto& v : small.a->vertices)
    for (const double x : v) odd += verify::bits(x) > 40;
  BOOST_TEST(odd == 1);
}

BOOST_AUTO_TEST_CASE(a_nested_pair_stays_nested)
{
  // Says no where one body is in the other and their surfaces are apart.
  const auto nested = [](const Object_case& x) {
    return verify::true_answer(x, Question::solid) && !verify::true_answer(x, Question::surface);
  };
  const Object_case c = object_case(verify::box_with_cavity(8, 7), Pose(),
                                    verify::box({7.25, 7.25, 7.25}, {7.5, 7.5, 7.5}), Pose::translation(0.125, 0, 0));
  const Object_case small = shrunk(c, Question::solid, nested);
  BOOST_TEST(nested(small));
  BOOST_TEST(small.a->face_count() + small.b->face_count() <= 8u);
}

BOOST_AUTO_TEST_CASE(a_wrong_yes_keeps_its_direction)
{
  // Says yes wherever the pose is no identity.
  const auto moved = [](const Object_case& x) {
    return !verify::true_answer(x, Question::solid) && !(x.pose_b.is_identity() && x.pose_a.is_identity());
  };
  const Object_case c = object_case(verify::unit_cube(), Pose(), verify::prism_with_tunnel(),
                                    Pose::from_quaternion(1, 2, 3, 4, {kernel::Rational(100) / 3, 0, 0}));
  const Object_case small = shrunk(c, Question::solid, moved);
  BOOST_TEST(!verify::true_answer(small, Question::solid));
  BOOST_TEST(!small.pose_a.is_rational());
  BOOST_TEST(!small.pose_b.is_rational());
  BOOST_TEST(verify::face_count(small) <= 8u);
}

BOOST_AUTO_TEST_CASE(a_failure_is_shrunk_too)
{
  class Fails : public verify::Running_subject {
    Outcome operator()(const Object_case& c, Question) override
    {
      return c.a->face_count() >= 3 ? Outcome::failed : Outcome::yes;
    }
  } subject;
  const Object_case c = object_case(verify::complex_one(), Pose(), verify::complex_two(), Pose());
  const auto check =
      verify::same_error(subject, Question::surface, Outcome::failed, verify::true_answer(c, Question::surface));
  const Object_case small = verify::shrink(c, Question::surface, check);
  BOOST_TEST(small.a->face_count() == 3u);
  BOOST_TEST(small.b->face_count() == 1u);
}

BOOST_AUTO_TEST_CASE(a_spent_budget_gives_a_case_that_still_shows_it)
{
  const Object_case c = object_case(verify::blob(512, 1), Pose(), verify::blob(512, 2), Pose());
  const auto check = [](const Object_case& x) { return verify::true_answer(x, Question::surface); };
  BOOST_TEST(check(verify::shrink(c, Question::surface, check, {3, 60})));
  std::size_t asked = 0;
  const auto counted = [&](const Object_case& x) {
    ++asked;
    return check(x);
  };
  verify::shrink(c, Question::surface, counted, {3, 60});
  BOOST_TEST(asked <= 3u);
}

BOOST_AUTO_TEST_CASE(a_predicate_keeps_only_the_points_that_matter)
{
  Predicate_case c{};
  c.v = {{{0.1, 0.2, 0.3}, {1.1, 0.7, -0.3}, {0.3, 1.9, 0.2}, {0.25, 0.3, 1.7}}};
  c.p = {-0.1, 0.2, -1};
  c.q = {0.4, 0.1, 3.1};
  c.r = {17.1, 1e-300, 1e300};
  c.pose_b = turned;
  // A subject that has the wrong sign wherever the true one is positive.
  const int truth = *verify::true_answer(Predicate::orientation, c);
  BOOST_REQUIRE(truth != 0);
  const auto check = [&](const Predicate_case& x) { return verify::true_answer(Predicate::orientation, x) == truth; };
  const Predicate_case small = verify::shrink(c, check);
  BOOST_TEST(check(small));
  BOOST_TEST((small.r == kernel::Vertex{0, 0, 0}));
  BOOST_TEST((small.q == kernel::Vertex{0, 0, 0}));
  BOOST_TEST((small.pose_a.is_identity() && small.pose_b.is_identity()));
  BOOST_TEST(verify::size_of(small).bits <= 6u);
}

BOOST_AUTO_TEST_CASE(a_triangle_and_a_segment_stay_what_they_are)
{
  // A subject that never hits.
  const verify::Predicate_subject never{"never", false, "",
                                        [](Predicate, const Predicate_case&) -> std::optional<int> { return 0; }};
  Predicate_case c{};
  c.v = {{{9, 9, 9}, {0.1, 0.2, 0.3}, {1.1, 0.7, 0.3}, {0.3, 1.9, 0.3}}};
  c.p = {0.5, 0.75, -1.25};
  c.q = {0.5, 0.75, 1.5};
  c.r = {1, 2, 3};
  BOOST_REQUIRE(verify::true_answer(Predicate::segment_triangle, c) == 1);
  const auto small = verify::shrink(c, verify::same_error(never, Predicate::segment_triangle, c, 0, 1));
  BOOST_TEST((small.p != small.q));
  BOOST_TEST((small.v[1] != small.v[2] && small.v[2] != small.v[3] && small.v[1] != small.v[3]));
  BOOST_TEST(verify::size_of(small).bits <= 8u);
  // One that was degenerate before may become more so.
  Predicate_case point = c;
  point.v[2] = point.v[3] = point.v[1];
  point.p = point.q = point.v[1];
  BOOST_TEST(verify::size_of(verify::shrink(point, verify::same_error(never, Predicate::segment_triangle, point, 0, 1)))
                 .bits == 0u);
}

BOOST_AUTO_TEST_CASE(doubles_at_the_ends_of_their_range_shrink_without_infinities)
{
  constexpr double largest = std::numeric_limits<double>::max();
  Predicate_case c{};
  c.v = {{{largest, -largest, 0x1p-1074}, {0x1p-1074, 0, 1}, {-largest, 1, 1}, {0, 1, -largest}}};
  c.p = {largest, largest, largest};
  c.pose_b = Pose::translation(largest, -largest, 0x1p-1074);
  const auto is_finite = [](const Predicate_case& x) {
    for (const auto& v : {x.v[0], x.v[1], x.v[2], x.v[3], x.p, x.q, x.r})
      for (const double coordinate : v)
        if (!std::isfinite(coordinate)) return false;
    return true;
  };
  const Predicate_case small = verify::shrink(c, [&](const Predicate_case& x) {
    BOOST_REQUIRE(is_finite(x));
    return x.v[0][0] == largest || x.p[1] > 1;
  });
  BOOST_TEST(verify::size_of(small).bits < 100u);
}

BOOST_AUTO_TEST_CASE(a_wrong_list_of_features_shrinks_to_what_is_wrong_in_it)
{
  // Misses what is edge against edge.
  class Blind : public verify::Running_subject {
   public:
    Outcome operator()(const Object_case&, Question) override { return Outcome::not_asked; }
    verify::Told<verify::Feature_pairs> features(const Object_case& c) override
    {
      auto pairs = verify::features(verify::Brute_body(*c.a), c.pose_a, verify::Brute_body(*c.b), c.pose_b);
      std::erase_if(pairs, [](const auto& pair) { return pair.kind == kernel::Contact::edge_edge; });
      return {Outcome::yes, pairs};
    }
  } blind;
  const Object_case c = object_case(verify::unit_cube(), Pose(), verify::unit_cube(), Pose::translation(0.5, 0.5, 0));
  const auto misses = verify::same_error_of_features(blind, true),
             invents = verify::same_error_of_features(blind, false);
  BOOST_TEST(misses(c));
  BOOST_TEST(!invents(c));
  const Object_case small = verify::shrink(c, Question::surface, misses);
  BOOST_TEST(misses(small));
  BOOST_TEST(verify::face_count(small) <= 4u);
}

BOOST_AUTO_TEST_SUITE_END()
