#include "tetracone/kernel/number/number.h"
#include "verify/campaign/level_judge.h"
#include "verify/cases/exit_direction.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/relations/convex_body.h"
#include "verify/truth/exit_truth.h"

#include <array>
#include <optional>

namespace tetracone::verify {
namespace {

/// An answer says the first and the last exit along the case's direction. The value of either is the number of what is
/// right of it: the fraction, and the nearest double. The truth says whether the interiors share a point at the start,
/// and whether they do again after the first exit. Families that count exits are one truth, the events of all pairs
/// another, and the formula for convex solids a third. Minkowski sums of Nef polyhedra tell the depth, beside those
/// that count it and the formula. The bracket must hold it, and be exact where it says so.
class Exit_page : public Page<levels::Exits> {
 public:
  std::array<Question, 1> questions(const Object_case&) const { return {Question::solid}; }
  auto relations() const { return exit_relations(); }
  bool tries_relations(std::uint64_t, Question, const Told& told) const { return told.outcome == Outcome::yes; }
  bool takes(const Object_case& c) const { return have_at_most(c.exits ? most_faces : few_faces, c); }

  void learn(const Object_case& c)
  {
    const auto direction = exit_direction(c);
    away_ = distance(c);
    is_counted_ = c.exits.has_value();
    squared_depth_ = c.squared_depth;
    const bool is_small = have_at_most(few_faces, c);
    truth_ = is_small ? exits_by_events(c, direction) : c.exits->exits;
    if (is_counted_ && c.exits->exits != truth_)
      throw Truths_disagree("the truth of exits disagrees with what the family has counted", c, Question::solid);
    if (!is_counted_ && is_convex(*c.a) && is_convex(*c.b)) {
      squared_depth_ = convex_squared_depth(c);
      const kernel::Rational exit = convex_exit(c, direction);
      if (truth_ != Solid_exits{exit, exit})
        throw Truths_disagree("the two truths of exits disagree", c, Question::solid);
    }
    if (!is_small) return;
    const auto square = minkowski_squared_depth(c);
    if (square && squared_depth_ && square != squared_depth_)
      throw Truths_disagree("the two truths of depths disagree", c, Question::solid);
    if (square) squared_depth_ = square;
  }

  Truths truths(Question) const
  {
    return {{"overlap", truth_.first != 0, is_counted_}, {"overlap again", truth_.first != truth_.last, is_counted_}};
  }

  Told ask(Running_subject& subject, const Object_case& c, Question) const
  {
    subject.forget();
    return subject.exits(c, exit_direction(c));
  }

  Statements statements(const Answered& a) const
  {
    const bool fractions = has_fractions(a.c);
    Statement first{"first exit", right_statements, {}, away_, fractions},
        last{"last exit", right_statements, {}, away_, fractions};
    if (a.told.outcome == Outcome::yes) {
      const auto count = [](const kernel::Rational& told, double nearest, const kernel::Rational& truth) {
        return (told == truth) + (nearest == kernel::nearest_double(truth));
      };
      const Exit_answer& told = a.told.answer;
      first.value = count(told.exits.first, told.first, truth_.first);
      last.value = count(told.exits.last, told.last, truth_.last);
    }
    if (!squared_depth_) return {first, last};
    Statement depth{"depth", right_statements, {}, away_, fractions};
    const auto told = a.told.outcome == Outcome::yes ? a.running.depth(a.c) : verify::Told<Depth>();
    if (told.outcome == Outcome::yes) depth.value = right_of(told.answer);
    return {first, last, depth};
  }

 private:
  /// Returns how many statements of a bracket hold: both its ends, and the square where it is exact.
  int right_of(const Depth& depth) const
  {
    const kernel::Rational low(depth.low), square(depth.exact_square);
    const bool is_above = depth.is_exact ? square == *squared_depth_ : square >= *squared_depth_;
    return (low * low <= *squared_depth_) + is_above;
  }

  static constexpr int right_statements = 2;

  Solid_exits truth_;
  bool is_counted_ = false;
  std::optional<kernel::Rational> squared_depth_;  // nothing where nobody knows it
  Distance away_{};
};

}  // namespace

Findings levels::Exits::judge(const Job<Exits>& job) { return Level_judge<Exit_page>(job).run(); }

}  // namespace tetracone::verify
