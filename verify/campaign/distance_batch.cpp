#include "verify/campaign/distance_batch.h"

#include "tetracone/kernel/number/number.h"
#include "verify/campaign/batch_parts.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/relations/distance_relations.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/distance_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace tetracone::verify {
namespace {

using kernel::Question;
using kernel::Rational;
using Coordinates = std::array<Rational, 3>;

Rational square_of(const Coordinates& p, const Coordinates& q)
{
  Rational sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
  return sum;
}

double next_above(double x) { return std::min(std::nextafter(x, HUGE_VAL), std::numeric_limits<double>::max()); }

/// True when `x` is the double nearest to the root of `square`: the root is not beyond the middle to either neighbour.
bool is_nearest_root(double x, const Rational& square)
{
  if (!(x >= 0)) return false;
  constexpr double largest = std::numeric_limits<double>::max();
  if (std::isinf(x)) return square >= Rational(largest) * Rational(largest);
  const Rational here(x), above(next_above(x)), below(x > 0 ? std::nextafter(x, 0.0) : 0.0);
  const Rational high = (here + above) / 2, low = (here + below) / 2;
  return low * low <= square && square <= high * high;
}

/// True when the named feature contains the exact image of the point, by CGAL. For a point inside a solid the distance
/// itself is the proof.
bool holds(const Placed_body& placed, const Holder& holder, const Coordinates& x)
{
  const Exact::Point_3 p(x[0], x[1], x[2]);
  const auto image = [&](Index v) { return placed.image<Exact>(v); };
  switch (holder.kind) {
    case Holder::Kind::interior: return true;
    case Holder::Kind::vertex: return image(holder.number[0]) == p;
    case Holder::Kind::edge: {
      const Exact::Point_3 &from = image(holder.number[0]), &to = image(holder.number[1]);
      return from == to ? p == from : Exact::Segment_3(from, to).has_on(p);
    }
    case Holder::Kind::face: break;
  }
  return detail::placed_face(placed, holder.number[0]).locate(p) != Place::outside;
}

/// A running batch of cases that ask for distances.
class Distance_batch : Working_batch<Object_subject> {
 public:
  Distance_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running)
      : Working_batch(campaign, batch, done, campaign.distance_subjects), running_(running)
  {}

  Findings judge()
  {
    for_wanted([this](std::uint64_t k) {
      const Object_case c = batch_.family->object_case(seed_, k);
      if (c.a->face_count() <= most_faces && c.b->face_count() <= most_faces) judge(c, k);
    });
    return finish();
  }

 private:
  /// Both truths judge bodies with fewer faces than this.
  static constexpr std::size_t few_faces = 12;

  void judge(const Object_case& c, std::uint64_t k)
  {
    const Brute_body body_a(*c.a), body_b(*c.b);
    const Placed_body a(body_a, c.pose_a), b(body_b, c.pose_b);
    const Rational of_surfaces = squared_distance(a, b);
    if (c.a->face_count() <= few_faces && c.b->face_count() <= few_faces &&
        of_surfaces != squared_distance(a, b, squared_distance_by_program))
      throw Truths_disagree("the two truths of a distance disagree", c, Question::surface);
    const Distance away = distance(c);
    for (const Question question : {Question::surface, Question::solid}) {
      if (question == Question::solid && !(body_a.is_closed() && body_b.is_closed())) continue;
      const bool collide = verify::collide(a, b, question);
      if (question == Question::surface && (sgn(of_surfaces) == 0) != collide)
        throw Truths_disagree("a distance is 0 and bodies apart, or the other way round", c, question);
      const Rational square = collide ? Rational(0) : of_surfaces;
      if (wanted_.truth(k)) found_.add_truth(name_of(question), collide, false);
      for (std::size_t s = 0; s < subjects_.size(); ++s)
        if (wanted_.subject(s, k)) judge_answer(c, k, s, question, a, b, square, away);
    }
  }

  void judge_answer(const Object_case& c, std::uint64_t k, std::size_t s, Question question, const Placed_body& a,
                    const Placed_body& b, const Rational& square, const Distance& away)
  {
    running_[s]->forget();
    const Told_distance told = running_[s]->distance(c, question);
    const std::optional<Spent> spent =
        running_[s]->spent();  // of this answer, not of those that `right_statements` asks
    Findings::Answer answer{{}, told.outcome == Outcome::not_asked};
    if (told.outcome == Outcome::yes) answer.value = right_statements(c, *running_[s], question, told, a, b, square);
    if (told.outcome == Outcome::failed)
      found_.add_failure(subjects_[s].name, name_of(question), k, running_[s]->failure());
    found_.add_answer(subjects_[s].name, name_of(question), kind_of(c, away), distance_statements, answer, spent);
    if (!answer.not_asked && answer.value != distance_statements && k < kept_one_by_one)
      found_.add_wrong(c.origin, subjects_[s].name, name_of(question), away, distance_statements, answer, {});
    if (told.outcome == Outcome::yes && k % relation_stride == 0) try_relation(c, k, s, question, told);
  }

  static int right_statements(const Object_case& c, Running_subject& subject, Question question,
                              const Told_distance& told, const Placed_body& a, const Placed_body& b,
                              const Rational& square)
  {
    const Nearest& nearest = told.nearest;
    std::array<Coordinates, 2> point;
    for (std::size_t body = 0; body < 2; ++body)
      for (std::size_t i = 0; i < 3; ++i) point[body][i] = Rational(nearest.point[body][i]);
    int right = (Rational(nearest.squared) == square) + (square_of(point[0], point[1]) == square) +
                holds(a, nearest.holder[0], point[0]) + holds(b, nearest.holder[1], point[1]) +
                is_nearest_root(nearest.distance, square) + (told.alone == nearest.distance);
    const double d = std::min(nearest.distance, std::numeric_limits<double>::max());
    for (const double limit : {d, std::nextafter(d, 0.0), next_above(d), d / 2,
                               std::min(d + d / 4, std::numeric_limits<double>::max()), 0.0}) {
      const bool is_within = square <= Rational(limit) * Rational(limit);
      const Outcome outcome = subject.within(c, question, kernel::exact_text(Rational(limit)));
      right += outcome == (is_within ? Outcome::yes : Outcome::no);
    }
    return right;
  }

  void try_relation(const Object_case& c, std::uint64_t k, std::size_t s, Question question, const Told_distance& told)
  {
    const auto relations = distance_relations();
    const std::size_t number = (k / relation_stride + std::size_t(batch_.family->number)) % relations.size();
    Random random = random_of(c.origin, number);
    const Verdict verdict = relations[number].check(c, question, *running_[s], told, random);
    found_.add_relation(std::string(relations[number].name), subjects_[s].name, name_of(question),
                        verdict != Verdict::not_applicable, verdict == Verdict::violated);
  }

  Running_subjects& running_;
};

}  // namespace

Findings judge_distances(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running)
{
  return Distance_batch(campaign, batch, done, running).judge();
}

}  // namespace tetracone::verify
