#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/integer_truth/integer_contacts.h"
#include "verify/integer_truth/integer_features.h"
#include "verify/truth/cgal_truth.h"

namespace tetracone::verify {
namespace {

using kernel::Question;

/// The common part of levels that ask two bodies for a list.
template <class Level>
class List_page : public Page<Level> {
 public:
  static constexpr bool tries_all_relations = true;

  auto truths(Question question) const { return std::vector<True_statement>{{this->name(question), !truth_.empty()}}; }

  std::vector<Statement> statements(const Answered<Level>& a) const
  {
    Statement statement{this->name(a.question), int(truth_.size()), {}, away_, has_fractions(a.c)};
    if (a.told.outcome == Outcome::yes) statement.value = as_number(a.told.answer, truth_);
    return {statement};
  }

 protected:
  void set_truth(const Object_case& c, const typename Level::Answer& truth)
  {
    truth_ = truth;
    away_ = distance(c);
  }

 private:
  typename Level::Answer truth_;
  Distance away_{};
};

class Feature_page : public List_page<levels::Features> {
 public:
  auto relations() const { return feature_relations(); }

  void learn(const Object_case& c)
  {
    const Feature_pairs truth = features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b);
    if (truth != integer_truth::features(c))
      throw Truths_disagree("the two truths of features disagree", c, Question::surface);
    set_truth(c, truth);
  }

  Told ask(Running_subject& subject, const Object_case& c, Question) const
  {
    subject.forget();
    return subject.features(c);
  }
};

/// Subjects are not asked about bodies of more than `most_faces` faces.
class Contact_page : public List_page<levels::Contacts> {
 public:
  auto relations() const { return contact_relations(); }
  bool tries_relations(std::uint64_t, Question, const Told& told) const { return told.outcome == Outcome::yes; }
  bool takes(const Object_case& c) const { return have_at_most(most_faces, c); }

  void learn(const Object_case& c)
  {
    const Contact_forms truth = contacts(c);
    if (with_joined_polygons(truth) != integer_truth::contacts(c))
      throw Truths_disagree("the two truths of contacts disagree", c, Question::surface);
    set_truth(c, truth);
  }

  Told ask(Running_subject& subject, const Object_case& c, Question) const
  {
    subject.forget();
    return subject.contacts(c);
  }
};

}  // namespace

Findings levels::Features::judge(const Job<Features>& job) { return Level_judge<Feature_page>(job).run(); }

Findings levels::Contacts::judge(const Job<Contacts>& job) { return Level_judge<Contact_page>(job).run(); }

}  // namespace tetracone::verify
