// What a case file says about a case: who is wrong, how the bodies stand, and why.

#include "verify/shrink/wrong_answers.h"

#include "verify/cases/shape_generators.h"
#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <optional>
#include <string>

BOOST_AUTO_TEST_SUITE(test_wrong_answers)

using namespace tetracone;
using kernel::Pose;
using kernel::Question;
using verify::Object_case;

namespace {

Object_case cubes(const Pose& pose_b, double size = 1)
{
  return verify::scenes::object_case(verify::unit_cube(), Pose(), verify::box({0, 0, 0}, {size, size, size}), pose_b);
}

bool names(const std::vector<verify::Wrong>& wrong, const std::string& subject)
{
  return std::any_of(wrong.begin(), wrong.end(), [&](const auto& each) { return each.subject == subject; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(how_two_bodies_stand_is_named_after_their_most_special_contact)
{
  BOOST_TEST(verify::contact_of(cubes(Pose::translation(3, 0, 0))) == "apart");
  BOOST_TEST(verify::contact_of(cubes(Pose::translation(0.25, 0.25, 0.25), 0.5)) == "nested");
  BOOST_TEST(verify::contact_of(cubes(Pose::translation(1, 1, 1))) == "vertex-vertex");
  BOOST_TEST(verify::contact_of(cubes(Pose::translation(0.5, 0.25, 1))) == "coplanar overlap");
  BOOST_TEST(verify::contact_of(cubes(Pose::translation(0.5, 0.5, 0.5))) == "edge-face");
}

BOOST_AUTO_TEST_CASE(nobody_is_wrong_about_cubes_far_from_one_another)
{
  BOOST_TEST(verify::wrong_answers(cubes(Pose::translation(3, 0, 0)), Question::solid, false).empty());
}

BOOST_AUTO_TEST_CASE(a_gap_below_a_tolerance_is_blamed_on_the_leaves)
{
  // Tolerance 1e-12, gap 2^-42: apart, and only doubles with an absolute tolerance and floats don't see it.
  const Object_case c = cubes(Pose::translation(0, 0, 1 + 0x1p-42));
  const auto wrong = verify::wrong_answers(c, Question::surface, false);
  BOOST_TEST(names(wrong, "double-eps=1e-12 brute"));
  BOOST_TEST(names(wrong, "float brute"));
  BOOST_TEST(!names(wrong, "double brute"));
  BOOST_TEST(!names(wrong, "adaptive tree"));
  const auto subject = verify::object_subject(*verify::Subject::parse("double-eps=1e-12", verify::Method::brute));
  const auto file = verify::case_file_of(c, Question::surface, subject, verify::Outcome::yes);
  BOOST_TEST(file.truth == 0);
  BOOST_TEST(file.cause == "double-eps=1e-12 brute: false positive by leaf sign, apart");
  BOOST_TEST((file.object->surface == false && file.object->solid == false));
  BOOST_TEST((verify::parse_case(verify::to_json(file), "").wrong == file.wrong));
}

BOOST_AUTO_TEST_CASE(a_failure_has_no_answer)
{
  const verify::Object_subject broken{"broken", false, "", std::nullopt, nullptr};
  const auto file = verify::case_file_of(cubes(Pose()), Question::solid, broken, verify::Outcome::failed);
  BOOST_TEST(file.cause == "broken: fails, coplanar overlap");
  BOOST_TEST(file.truth == 1);
}

BOOST_AUTO_TEST_CASE(a_formulation_with_a_wrong_sign_is_wrong_in_rationals_too)
{
  verify::Predicate_case c{};
  c.v = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}}};
  c.p = {0, 0.25, 0.25};
  c.q = {1, 0, 0};
  c.r = {0, 0, 0};
  const auto wrong = verify::wrong_answers(c, verify::Predicate::segment_triangle, 1);
  BOOST_TEST(names(wrong, "rational jimenez-segura-feito-sign-error"));
  BOOST_TEST(!names(wrong, "double"));
}

BOOST_AUTO_TEST_SUITE_END()
