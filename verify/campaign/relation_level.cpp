#include "tetracone/kernel/number/number.h"
#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/integer_truth/integer_contacts.h"
#include "verify/integer_truth/integer_overlap.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/truth/overlap_truth.h"

#include <mpfr.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Question;
using kernel::Solid_relation;

constexpr std::array all_relations = {Solid_relation::disjoint,   Solid_relation::meet,   Solid_relation::overlap,
                                      Solid_relation::equal,      Solid_relation::inside, Solid_relation::contains,
                                      Solid_relation::covered_by, Solid_relation::covers};

/// True when the bounds enclose the sum of the roots of these squares, and are equal or neighbours. MPFR adds 500 bits
/// of each root.
bool is_root_sum(const std::array<double, 2>& bounds, const std::vector<kernel::Rational>& squares)
{
  const auto compared = [&](double bound, mpfr_rnd_t rounding) {
    mpfr_t sum, root;
    mpfr_init2(sum, 500);
    mpfr_init2(root, 500);
    mpfr_set_zero(sum, 1);
    for (const kernel::Rational& square : squares) {
      mpfr_set_q(root, square.get_mpq_t(), rounding);
      mpfr_sqrt(root, root, rounding);
      mpfr_add(sum, sum, root, rounding);
    }
    const int sign = mpfr_cmp_d(sum, bound);
    mpfr_clear(sum);
    mpfr_clear(root);
    return sign;
  };
  return compared(bounds[0], MPFR_RNDU) >= 0 && compared(bounds[1], MPFR_RNDD) <= 0 &&
         (bounds[0] == bounds[1] || std::nextafter(bounds[0], HUGE_VAL) == bounds[1]);
}

/// An answer says which relation holds, of which dimension the contact is, and how much the solids overlap. The last
/// are `overlap_statements`:
/// - the exact volume and centroid, and the nearest doubles and the bounds of these four numbers;
/// - the contact vector and the nearest doubles;
/// - the bounds of the contact area.
/// The value is the number of those that are right. The truth says of each relation whether it is the case's. Subjects
/// are not asked about bodies of more than `most_faces` faces.
class Relation_page : public Page<levels::Relations> {
 public:
  std::array<Question, 1> questions(const Object_case&) const { return {Question::solid}; }
  auto relations() const { return solid_relations(); }
  bool tries_relations(std::uint64_t, Question, const Told& told) const { return told.outcome == Outcome::yes; }
  bool takes(const Object_case& c) const { return have_at_most(most_faces, c); }

  void learn(const Object_case& c)
  {
    truth_ = solid_overlap(c, shared_);
    away_ = distance(c);
    is_known_ = c.overlap.has_value();
    if ((is_known_ && *c.overlap != truth_) || (c.shared && *c.shared != shared_))
      throw Truths_disagree("the truth of a relation disagrees with what the family has counted", c, Question::solid);
    const auto [relation, dimension] = truth_.contact;
    if (integer_truth::collide(c, Question::solid) != (relation != Solid_relation::disjoint) ||
        integer_truth::collide(c, Question::surface) != (dimension >= 0) ||
        verify::dimension(integer_truth::contacts(c)) != dimension)
      throw Truths_disagree("the two truths of a relation disagree about points in common", c, Question::solid);
    if (have_at_most(few_faces, c) && !integer_truth::agrees(integer_truth::volumes(c), truth_))
      throw Truths_disagree("the two truths of a relation disagree about volumes", c, Question::solid);
  }

  Truths truths(Question) const
  {
    Truths truths;
    for (const Solid_relation relation : all_relations)
      truths.push_back({std::string(kernel::to_string(relation)), truth_.contact.relation == relation, is_known_});
    return truths;
  }

  Told ask(Running_subject& subject, const Object_case& c, Question) const
  {
    subject.forget();
    return subject.solids(c);
  }

  Statements statements(const Answered& a) const
  {
    const bool fractions = has_fractions(a.c);
    Statement relation{"relation", int(truth_.contact.relation), {}, away_, fractions},
        dimension{"dimension", truth_.contact.dimension, {}, away_, fractions},
        overlap{"overlap", overlap_statements, {}, away_, fractions};
    if (a.told.outcome == Outcome::yes) {
      const Solid_answer& told = a.told.answer;
      const auto [of_all, of_contact] = told.overlap.contact;
      relation.value = told.alone == of_all ? int(of_all) : -1;
      dimension.value = of_contact;
      const auto holds = [](const std::array<double, 2>& bounds, const kernel::Rational& x) {
        // A number beyond the doubles has an infinite bound, which rationals do not take.
        return (bounds[0] == -HUGE_VAL || (std::isfinite(bounds[0]) && bounds[0] <= x)) &&
               (bounds[1] == HUGE_VAL || (std::isfinite(bounds[1]) && x <= bounds[1]));
      };
      overlap.value = (told.overlap.volume == truth_.volume) + (told.volume == kernel::nearest_double(truth_.volume)) +
                      holds(told.bounds.volume, truth_.volume);
      for (std::size_t k = 0; k < 3; ++k)
        *overlap.value += (told.overlap.centroid[k] == truth_.centroid[k]) +
                          (told.centroid[k] == kernel::nearest_double(truth_.centroid[k])) +
                          holds(told.bounds.centroid[k], truth_.centroid[k]) +
                          (told.contact_vector[k] == shared_.vector[k]) +
                          (told.nearest_contact_vector[k] == kernel::nearest_double(shared_.vector[k]));
      *overlap.value += is_root_sum(told.contact_area, shared_.squares);
    }
    return {relation, dimension, overlap};
  }

 private:
  static constexpr int overlap_statements = 19;

  Solid_overlap truth_;
  Shared_area shared_;
  bool is_known_ = false;
  Distance away_{};
};

}  // namespace

Findings levels::Relations::judge(const Job<Relations>& job) { return Level_judge<Relation_page>(job).run(); }

}  // namespace tetracone::verify
