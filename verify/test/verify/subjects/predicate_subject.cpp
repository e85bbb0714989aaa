#include "verify/subjects/predicate_subject.h"

#include "verify/cases/random.h"
#include "verify/families/named_family.h"
#include "verify/subjects/segment_triangle_formulations.h"
#include "verify/truth/predicate_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <string>

BOOST_AUTO_TEST_SUITE(test_predicate_subject)

using namespace tetracone;
using namespace tetracone::verify;

namespace {

const Predicate_subject& subject(const char* name)
{
  const Predicate_subject* found = find_named(predicate_subjects(), name);
  BOOST_REQUIRE_MESSAGE(found != nullptr, name);
  return *found;
}

/// The points of a case, to be filled in a loop.
std::array<kernel::Vertex*, 7> points(Predicate_case& c)
{
  return {&c.v[0], &c.v[1], &c.v[2], &c.v[3], &c.p, &c.q, &c.r};
}

int below(Random& random, int n) { return int(random.bits() % std::uint64_t(n)); }

/// Points of a small grid: every degenerate position comes up by itself.
Predicate_case grid_case(Random& random, int size)
{
  Predicate_case c{};
  for (kernel::Vertex* v : points(c))
    for (double& x : *v) x = below(random, 2 * size + 1) - size;
  return c;
}

Predicate_case random_case(Random& random)
{
  Predicate_case c{};
  for (kernel::Vertex* v : points(c))
    for (double& x : *v) x = random.symmetric();
  return c;
}

/// One and the same rounded rotation for both bodies: no grid point is placed exactly, no position relative to the
/// others changes.
kernel::Pose rounded_rotation(Random& random)
{
  const auto q = random.quaternion();
  const auto m = rotation(q[0], q[1], q[2], q[3]);
  return kernel::Pose(std::array<double, 12>{m[0][0], m[0][1], m[0][2], 0.1, m[1][0], m[1][1], m[1][2], -0.3, m[2][0],
                                             m[2][1], m[2][2], 0.7});
}

/// p rounded from the triangle's plane, q beyond it or beside.
Predicate_case nearly_on_plane(Random& random)
{
  Predicate_case c = random_case(random);
  const double s = random.unit(), t = random.unit();
  for (int k = 0; k < 3; ++k) c.p[k] = c.v[1][k] + s * (c.v[2][k] - c.v[1][k]) + t * (c.v[3][k] - c.v[1][k]);
  return c;
}

/// How many of the n cases the subject answers wrongly, over all predicates that it has and that are asked; `asked`
/// counts these.
struct Tally {
  int asked = 0, wrong = 0;
};
Tally tally(const Predicate_subject& s, int n, const std::function<Predicate_case()>& make)
{
  Tally result;
  for (int k = 0; k < n; ++k) {
    const Predicate_case c = make();
    for (const Predicate predicate : all_predicates) {
      const auto truth = true_answer(predicate, c);
      const auto answer = s.answer(predicate, c);
      if (!truth || !answer) continue;
      ++result.asked;
      result.wrong += *answer != *truth;
    }
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_are_unique_and_what_is_not_ours_says_where_it_comes_from)
{
  std::set<std::string> names;
  for (const Predicate_subject& s : predicate_subjects()) {
    BOOST_TEST(names.insert(s.name).second, s.name);
    const bool ours = s.answer(Predicate::orientation, Predicate_case{}).has_value();
    BOOST_TEST(s.note.empty() == ours, s.name);
    for (const Predicate predicate : all_predicates)
      BOOST_TEST(
          s.answer(predicate, Predicate_case{}).has_value() == (ours || predicate == Predicate::segment_triangle),
          s.name);
  }
  for (const char* name :
       {"adaptive", "rational", "epeck", "epick", "double", "double-eps=1e-12", "double-eps=rel:1e-12", "float"})
    BOOST_TEST(names.contains(name), name);
  BOOST_TEST(!subject("rational jimenez-segura-feito-sign-error").is_exact);
}

BOOST_AUTO_TEST_CASE(
    rounding_kernels_are_wrong_next_to_degenerate_positions_and_exact_predicates_only_once_points_are_moved)
{
  const auto wrong = [](const char* name, bool moved) {
    Random random(7);
    return tally(subject(name), 300,
                 [&] {
                   Predicate_case c = nearly_on_plane(random);
                   if (moved) c.pose_a = c.pose_b = rounded_rotation(random);
                   return c;
                 })
        .wrong;
  };
  for (const char* name : {"double", "double-eps=1e-12", "double-eps=rel:1e-12", "float"})
    BOOST_TEST(wrong(name, false) > 0, name);
  BOOST_TEST(wrong("epick", false) == 0);
  BOOST_TEST(wrong("epick", true) > 0);
  BOOST_TEST(wrong("adaptive", true) == 0);
}

BOOST_AUTO_TEST_CASE(every_formulation_is_right_on_a_segment_clearly_through_a_triangle_and_clearly_beside_it)
{
  Predicate_case through{};
  through.v = {{{9, 9, 9}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  through.p = {1, 1, -1};
  through.q = {1, 1, 1};
  Predicate_case beside = through, above = through;
  beside.p = {3, 3, -1};
  beside.q = {3, 3, 1};
  above.p = {1, 1, 2};
  above.q = {1, 1, 1};
  for (const Predicate_subject& s : predicate_subjects()) {
    for (Predicate_case c : {through, beside, above}) {
      for (int turn = 0; turn < 4; ++turn) {
        if (turn % 2 == 1) std::swap(c.p, c.q);
        if (turn == 2) std::swap(c.v[1], c.v[2]);
        BOOST_TEST(*s.answer(Predicate::segment_triangle, c) == *true_answer(Predicate::segment_triangle, c), s.name);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(only_cgal_and_we_decide_coplanar_segments)
{
  Predicate_case c{};  // inside the triangle
  c.v = {{{9, 9, 9}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  c.p = {1, 1, 0};
  c.q = {1, 2, 0};
  for (const Predicate_subject& s : predicate_subjects()) {
    const bool decides = s.note.empty() || s.name.ends_with("cgal");
    BOOST_TEST(*s.answer(Predicate::segment_triangle, c) == int(decides), s.name);
  }
}

BOOST_AUTO_TEST_CASE(cgal_answers_degenerate_segments_and_triangles_too)
{
  for (const char* name : {"double cgal", "epick cgal", "float cgal"}) {
    Random random(13);
    const auto result = tally(subject(name), 1500, [&] {
      Predicate_case c = grid_case(random, 1);
      if (below(random, 3) == 0) c.q = c.p;
      if (below(random, 3) == 0) c.v[2] = c.v[1];
      if (below(random, 5) == 0) c.v[3] = c.v[1];
      return c;
    });
    BOOST_TEST(result.wrong == 0, name);
    BOOST_TEST(result.asked == 1500, name);
  }
}

BOOST_AUTO_TEST_CASE(the_published_wrong_sign_loses_every_segment_that_starts_on_the_plane_and_no_other)
{
  using formulations::First_end_on_plane;
  using formulations::jimenez_segura_feito;
  using Integers = std::array<long, 3>;
  const auto volume = [](const Integers& a, const Integers& b, const Integers& c, const Integers& d) {
    const auto minus_a = [&a](const Integers& x) { return Integers{x[0] - a[0], x[1] - a[1], x[2] - a[2]}; };
    const Integers x = minus_a(b), y = minus_a(c), z = minus_a(d);
    const long det =
        (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] + (x[0] * y[1] - x[1] * y[0]) * z[2];
    return (det > 0) - (det < 0);
  };
  const auto real = [](const Integers& x) {
    return formulations::Vector<double>{double(x[0]), double(x[1]), double(x[2])};
  };
  Random random(20240601);
  int hits = 0, on_plane = 0, lost_on_plane = 0, other_errors = 0, errors_of_right = 0, errors_of_segura = 0;
  for (int k = 0; k < 1'000'000; ++k) {
    std::array<Integers, 5> x;
    for (Integers& point : x)
      for (long& coordinate : point) coordinate = below(random, 7) - 3;
    const auto& [p, q, a, b, c] = x;
    const int side_p = volume(a, b, c, p), side_q = volume(a, b, c, q);
    if (side_p == 0 && side_q == 0) continue;
    const int ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    const bool hit = side_p != side_q && std::max({ab, bc, ca}) - std::min({ab, bc, ca}) < 2;
    hits += hit;
    on_plane += hit && side_p == 0;
    errors_of_right += jimenez_segura_feito(real(p), real(q), real(a), real(b), real(c), 0.0) != hit;
    errors_of_segura += formulations::segura_feito(real(p), real(q), real(a), real(b), real(c)) != hit;
    const bool erring =
        jimenez_segura_feito<First_end_on_plane::sign_error>(real(p), real(q), real(a), real(b), real(c), 0.0);
    lost_on_plane += hit && side_p == 0 && !erring;
    other_errors += erring != hit && !(hit && side_p == 0);
  }
  BOOST_TEST(hits > 100'000);
  BOOST_TEST(on_plane > 10'000);
  BOOST_TEST(lost_on_plane == on_plane);
  BOOST_TEST(other_errors == 0);
  BOOST_TEST(errors_of_right == 0);
  BOOST_TEST(errors_of_segura == 0);
  BOOST_TEST_MESSAGE("hits " << hits << ", of them first end on the plane " << on_plane);
}

BOOST_AUTO_TEST_SUITE_END()
