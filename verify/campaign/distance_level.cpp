#include "tetracone/kernel/number/number.h"
#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/distance_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

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

/// An answer makes `statement_count` statements:
/// - the exact square;
/// - that the nearest points are that far apart, and lie on the named features;
/// - the rounded root, asked together with them and alone;
/// - limits at the distance, beside it and far from it.
/// The answer's value is the number of right statements. Subjects are not asked about bodies of more than `most_faces`
/// faces.
///
/// A subject that knows the rounded distance alone is judged by two questions. Its distance is 0 for the nearest
/// double, -1 for a smaller one, 1 for a larger one. Its right answers to the six limits are counted.
class Distance_page : public Two_questions<levels::Distances> {
 public:
  auto relations() const { return distance_relations(); }
  bool tries_relations(std::uint64_t, Question, const Told& told) const
  {
    return told.outcome == Outcome::yes && !told.answer.is_alone;
  }
  bool takes(const Object_case& c) const { return have_at_most(most_faces, c); }

  void learn(const Object_case& c)
  {
    body_a_.emplace(*c.a);
    body_b_.emplace(*c.b);
    const Placed_body &a = a_.emplace(*body_a_, c.pose_a), &b = b_.emplace(*body_b_, c.pose_b);
    of_surfaces_ = squared_distance(a, b);
    if (have_at_most(few_faces, c) && of_surfaces_ != squared_distance(a, b, squared_distance_by_program))
      throw Truths_disagree("the two truths of a distance disagree", c, Question::surface);
    if ((sgn(of_surfaces_) == 0) != collide(a, b, Question::surface))
      throw Truths_disagree("a distance is 0 and bodies apart, or the other way round", c, Question::surface);
    away_ = distance(c);
  }
  Truths truths(Question question)
  {
    if (question == Question::solid && !(body_a_->is_closed() && body_b_->is_closed())) return {};
    const bool is_zero = collide(*a_, *b_, question);
    square_ = is_zero ? Rational(0) : of_surfaces_;
    return {{name(question), is_zero}};
  }

  Told ask(Running_subject& subject, const Object_case& c, Question question) const
  {
    subject.forget();
    return subject.distance(c, question);
  }

  Statements statements(const Answered& a) const
  {
    if (a.told.answer.is_alone) return of_rounded(a);
    Statement statement{name(a.question), statement_count, {}, away_, has_fractions(a.c)};
    if (a.told.outcome == Outcome::yes) statement.value = right_statements(a);
    return {statement};
  }

 private:
  static constexpr int limit_count = 6, statement_count = 6 + limit_count;

  int right_statements(const Answered& a) const
  {
    const Nearest& nearest = a.told.answer.nearest;
    std::array<Coordinates, 2> point;
    for (std::size_t body = 0; body < 2; ++body)
      for (std::size_t i = 0; i < 3; ++i) point[body][i] = Rational(nearest.point[body][i]);
    int right = (Rational(nearest.squared) == square_) + (square_of(point[0], point[1]) == square_) +
                holds(*a_, nearest.holder[0], point[0]) + holds(*b_, nearest.holder[1], point[1]) +
                is_nearest_root(nearest.distance, square_) + (a.told.answer.alone == nearest.distance);
    for (const double limit : limits(nearest.distance)) right += answers_within(a, limit) == is_within(limit);
    return right;
  }

  static std::array<double, limit_count> limits(double distance)
  {
    constexpr double largest = std::numeric_limits<double>::max();
    const double d = std::min(distance, largest);
    return {d, std::nextafter(d, 0.0), next_above(d), d / 2, std::min(d + d / 4, largest), 0.0};
  }
  Outcome is_within(double limit) const
  {
    return square_ <= Rational(limit) * Rational(limit) ? Outcome::yes : Outcome::no;
  }
  static Outcome answers_within(const Answered& a, double limit)
  {
    return a.running.within(a.c, a.question, kernel::exact_text(Rational(limit)));
  }

  Statements of_rounded(const Answered& a) const
  {
    Statements all;
    const double told = a.told.answer.alone;
    Statement statement{name(a.question), 0, {}, away_, has_fractions(a.c)};
    if (a.told.outcome != Outcome::yes) return {statement};
    if (!std::isnan(told)) {
      statement.value = is_nearest_root(told, square_) ? 0 : Rational(told) * Rational(told) < square_ ? -1 : 1;
      all.push_back(statement);
    }
    statement.question += " within";
    statement.truth = limit_count;
    int right = 0;
    for (const double limit : limits(std::sqrt(square_.get_d()))) {
      const Outcome outcome = answers_within(a, limit);
      if (outcome == Outcome::not_asked) return all;
      right += outcome == is_within(limit);
    }
    statement.value = right;
    all.push_back(statement);
    return all;
  }

  std::optional<Brute_body> body_a_, body_b_;
  std::optional<Placed_body> a_, b_;
  Rational of_surfaces_, square_;
  Distance away_{};
};

}  // namespace

Findings levels::Distances::judge(const Job<Distances>& job) { return Level_judge<Distance_page>(job).run(); }

}  // namespace tetracone::verify
