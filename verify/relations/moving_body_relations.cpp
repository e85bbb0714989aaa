#include "tetracone/tetratree/door/tetracone.h"
#include "verify/relations/relations.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace moving_body_relation {
namespace {

using kernel::Question;
using kernel::Rational;
using kernel::Time_bounds;
using First = std::optional<Time_bounds>;
using Numbers = std::vector<Rational>;
using Trial = Motion_level::Trial;

/// Thrown when the subject gives no answer.
struct Untold {};

First first_of(const Trial& t, const Moving_bodies& bodies)
{
  const Told_contact told = t.subject(bodies, t.question);
  if (told.outcome != Outcome::yes && told.outcome != Outcome::no) throw Untold();
  return told.outcome == Outcome::yes ? First(told.answer) : std::nullopt;
}

bool equal(const First& a, const First& b)
{
  return a.has_value() == b.has_value() && (!a || (a->lo == b->lo && a->hi == b->hi));
}

Verdict swapped(const Trial& t)
{
  return verdict(equal(first_of(t, t.c), first_of(t, {t.c.b, t.c.a, t.c.motion_b, t.c.motion_a})));
}

/// The first contact of the reversed motion is the last of the motion, so not before its first.
Verdict reversed_time(const Trial& t)
{
  Moving_bodies reversed = t.c;
  for (Motion_ends* motion : {&reversed.motion_a, &reversed.motion_b}) std::swap((*motion)[0], (*motion)[1]);
  const First first = first_of(t, t.c), last = first_of(t, reversed);
  if (first.has_value() != last.has_value()) return Verdict::violated;
  return verdict(!first || Rational(first->lo) + Rational(last->lo) <= 1);
}

Numbers between(const Motion_ends& ends, const Rational& time)
{
  Numbers numbers;
  for (std::size_t k = 0; k < ends[0].size(); ++k)
    numbers.push_back(Rational(ends[0][k] + time * (ends[1][k] - ends[0][k])));
  return numbers;
}

bool is_flat(const Numbers& pose) { return pose.size() == 12 && pose_of(pose).determinant_sign() == CGAL::ZERO; }

/// The first contact of a motion is that of its part before a time, else that of the part after it. Not where a body is
/// flat then, since no motion starts so.
Verdict split(const Trial& t)
{
  const Rational time = Rational(1 + t.random.bits() % 7) / 8;
  Moving_bodies before = t.c, after = t.c;
  for (const auto member : {&Moving_bodies::motion_a, &Moving_bodies::motion_b})
    (before.*member)[1] = (after.*member)[0] = between(t.c.*member, time);
  if (is_flat(after.motion_a[0]) || is_flat(after.motion_b[0])) return Verdict::not_applicable;
  const First whole = first_of(t, t.c), first = first_of(t, before), second = first ? First() : first_of(t, after);
  if (whole.has_value() != (first || second)) return Verdict::violated;
  if (!whole) return Verdict::holds;
  const auto in_whole = [&](double x) { return first ? Rational(time * x) : Rational(time + (1 - time) * x); };
  const Time_bounds& part = first ? *first : *second;
  return verdict(in_whole(part.lo) <= Rational(whole->hi) && Rational(whole->lo) <= in_whole(part.hi));
}

/// Relation: both bodies take part in one more motion, a fixed turn and a translation in time.
Verdict common_motion(const Trial& t)
{
  const auto small = [&] { return Rational(long(t.random.bits() % 9) - 4); };
  const std::array<Rational, 4> g = {small(), small(), small(), Rational(3)};
  std::array<std::array<Rational, 3>, 2> shift;
  for (auto& v : shift)
    for (Rational& x : v) x = small() / 4;
  const kernel::Pose turn = kernel::Body_motion::rigid({g, {0, 0, 0}}, {g, {0, 0, 0}}).value().at(0);
  const auto turned = [&](const std::array<Rational, 3>& v) {
    std::array<Rational, 3> image;
    for (int i = 0; i < 3; ++i)
      image[i] = turn.exact(4 * i) * v[0] + turn.exact(4 * i + 1) * v[1] + turn.exact(4 * i + 2) * v[2];
    return image;
  };
  Moving_bodies twin = t.c;
  for (Motion_ends* motion : {&twin.motion_a, &twin.motion_b})
    for (std::size_t end = 0; end < 2; ++end) {
      Numbers& n = (*motion)[end];
      if (n.size() == 7) {
        const std::array<Rational, 4> q = {n[0], n[1], n[2], n[3]};
        n[0] = g[0] * q[0] - g[1] * q[1] - g[2] * q[2] - g[3] * q[3];
        n[1] = g[0] * q[1] + g[1] * q[0] + g[2] * q[3] - g[3] * q[2];
        n[2] = g[0] * q[2] - g[1] * q[3] + g[2] * q[0] + g[3] * q[1];
        n[3] = g[0] * q[3] + g[1] * q[2] - g[2] * q[1] + g[3] * q[0];
        const auto at = turned({n[4], n[5], n[6]});
        for (std::size_t k = 0; k < 3; ++k) n[4 + k] = at[k] + shift[end][k];
      } else {
        for (std::size_t j = 0; j < 4; ++j) {
          const auto column = turned({n[j], n[4 + j], n[8 + j]});
          for (std::size_t i = 0; i < 3; ++i) n[4 * i + j] = column[i];
        }
        for (std::size_t i = 0; i < 3; ++i) n[4 * i + 3] += shift[end][i];
      }
    }
  return verdict(equal(first_of(t, t.c), first_of(t, twin)));
}

/// No static answer at an eighth of the time before the first contact is a collision; without one, none is.
Verdict finer_steps(const Trial& t)
{
  const First first = first_of(t, t.c);
  Query query(Body(t.c.a), Body(t.c.b), Question::surface);
  const kernel::Body_motion a = motion_of(t.c.motion_a), b = motion_of(t.c.motion_b);
  for (int k = 0; k <= 8; ++k) {
    const double time = k / 8.0;
    if (first && (first->lo == first->hi ? time >= first->lo : time > first->lo)) break;
    const kernel::Pose pose_a = a.at(time), pose_b = b.at(time);
    if (pose_a.determinant_sign() == CGAL::ZERO || pose_b.determinant_sign() == CGAL::ZERO) continue;
    if (query.collide(pose_a, pose_b)) return Verdict::violated;
  }
  return Verdict::holds;
}

template <Verdict (*relation)(const Trial&)>
Verdict or_untold(const Trial& t)
{
  try {
    return relation(t);
  } catch (const Untold&) {
    return Verdict::not_applicable;
  }
}

constexpr std::array of_motion = std::to_array<Motion_level::Relation>({
    {"swapped", "the same time with the bodies swapped", or_untold<swapped>},
    {"reversed-time", "existence, and the first time before the last", or_untold<reversed_time>},
    {"split", "the first contact of the first part that has one", or_untold<split>},
    {"common-motion", "the same time where both bodies are carried along by one motion", or_untold<common_motion>},
    {"finer-steps", "no collision at a step before the first contact", or_untold<finer_steps>},
});

}  // namespace
}  // namespace moving_body_relation

std::span<const Motion_level::Relation> moving_body_relations() { return moving_body_relation::of_motion; }

}  // namespace tetracone::verify
