#include "tetracone/kernel/number/number.h"
#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/integer_probes.h"
#include "verify/truth/point_truth.h"
#include "verify/truth/ray_truth.h"

#include <algorithm>
#include <cmath>

namespace tetracone::verify {
namespace {

/// The distance of a point or ray, which is exactly degenerate or not near to it.
Distance degeneracy(bool is_degenerate)
{
  const double log2 = is_degenerate ? -HUGE_VAL : HUGE_VAL;
  return {log2, log2};
}

/// The truths for the body of the last case.
template <class First>
class Truths_of_body {
 public:
  void be_about(const Probe_case& c)
  {
    if (c.body == body_) return;
    body_ = c.body;
    first_.emplace(*body_);
    second_.emplace(*body_);
  }
  const First& first() const { return *first_; }
  const integer_truth::Probed_body& second() const { return *second_; }

 private:
  std::shared_ptr<const covering::Polyhedron> body_;
  std::optional<First> first_;
  std::optional<integer_truth::Probed_body> second_;
};

class Point_page : public Page<levels::Points> {
 public:
  auto relations() const { return point_relations(); }

  void learn(const Probe_case& c)
  {
    truths_.be_about(c);
    truth_ = truths_.first()(c.from);
    if (truth_ != truths_.second().where(c.from)) throw Truths_disagree("the two truths of a point disagree", c);
  }
  Truths truths(Question) const { return {{"inside", truth_ > 0}}; }

  Statements statements(const Answered& a) const
  {
    const bool is_told = a.told.outcome == Outcome::yes;
    return {{"inside", truth_, is_told ? std::optional(a.told.answer) : std::nullopt, degeneracy(truth_ == 0)}};
  }

 private:
  Truths_of_body<Point_truth> truths_;
  int truth_ = 0;
};

/// Judges three questions: the first face with its t, all faces with their t, and all faces. An answer is a list. An
/// answer of the first t alone is judged by whether the ray meets the body. Where both say that it does, its t is 0 for
/// the nearest double, -1 for a smaller one, 1 for a larger one.
class Ray_page : public Page<levels::Rays> {
 public:
  auto relations() const { return ray_relations(); }
  bool tries_relations(std::uint64_t, Question, const Told& told) const { return !told.answer.is_first_t; }

  void learn(const Probe_case& c)
  {
    truths_.be_about(c);
    const auto exact = truths_.first()(c.from, c.direction);
    if (exact != truths_.second().hits(c.from, c.direction))
      throw Truths_disagree("the two truths of a ray disagree", c);
    std::vector<Ray_hit> hits;
    for (const auto& [t, face] : exact) hits.push_back({face, kernel::nearest_double(t)});
    truth_ = lists_of({hits.empty() ? std::nullopt : std::optional(hits[0]), hits});
    is_tied_ = std::ranges::adjacent_find(exact, {}, [](const auto& hit) { return hit.first; }) != exact.end();
  }
  Truths truths(Question) const
  {
    const bool meets = !truth_.all.empty();
    return {{"first", meets}, {"hits", meets}, {"faces", meets}};
  }

  Statements statements(const Answered& a) const
  {
    if (a.told.answer.is_first_t) return of_first_t(a);
    const Lists told = lists_of(a.told.answer);
    const auto statement = [&](const char* question, const auto& given, const auto& truth) {
      const bool is_told = a.told.outcome == Outcome::yes;
      return Statement{question, int(truth.size()), is_told ? std::optional(as_number(given, truth)) : std::nullopt,
                       degeneracy(is_tied_)};
    };
    return {statement("first", told.first, truth_.first), statement("hits", told.all, truth_.all),
            statement("faces", told.faces, truth_.faces)};
  }

 private:
  Statements of_first_t(const Answered& a) const
  {
    Statement meets{"meets", !truth_.all.empty(), {}, degeneracy(is_tied_)};
    const auto& first = a.told.answer.first;
    if (a.told.outcome == Outcome::yes) meets.value = first.has_value();
    if (!first || truth_.all.empty()) return {meets};
    const double t = truth_.first[0].first;
    return {meets, {"first t", 0, first->t == t ? 0 : first->t < t ? -1 : 1, degeneracy(is_tied_)}};
  }

  /// An answer as sorted lists.
  struct Lists {
    std::vector<std::pair<double, covering::Index>> first, all;
    std::vector<covering::Index> faces;
  };

  static Lists lists_of(const Ray_answer& answer)
  {
    Lists lists;
    if (answer.first) lists.first = {{answer.first->t, answer.first->face}};
    for (const Ray_hit& hit : answer.all) {
      lists.all.emplace_back(hit.t, hit.face);
      lists.faces.push_back(hit.face);
    }
    std::ranges::sort(lists.all);
    std::ranges::sort(lists.faces);
    return lists;
  }

  Truths_of_body<Ray_truth> truths_;
  Lists truth_;
  bool is_tied_ = false;
};

}  // namespace

Findings levels::Points::judge(const Job<Points>& job) { return Level_judge<Point_page>(job).run(); }

Findings levels::Rays::judge(const Job<Rays>& job) { return Level_judge<Ray_page>(job).run(); }

}  // namespace tetracone::verify
