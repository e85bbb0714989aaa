#include "verify/subjects/object_subject.h"

#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/exit_direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <type_traits>
#include <utility>

namespace tetracone::verify {
namespace {

/// Returns the middle of the placed body's box, rounded.
std::array<double, 3> middle(const covering::Polyhedron& body, const kernel::Pose& m)
{
  std::array<double, 3> low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  for (const auto& [x, y, z] : body.vertices)
    for (int i = 0; i < 3; ++i) {
      const double image = m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 2] * z + m[4 * i + 3];
      low[i] = std::min(low[i], image);
      high[i] = std::max(high[i], image);
    }
  return {low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2, low[2] / 2 + high[2] / 2};
}

/// Returns poses of B that fill a memory before the case's own pose. The first has B's middle on A's, where surfaces
/// usually meet; the second is slightly off the case's pose, away from A. Poses that cannot be asked are left out.
std::vector<kernel::Pose> poses_before(const Object_case& c)
{
  const std::array<double, 3> of_a = middle(*c.a, c.pose_a), of_b = middle(*c.b, c.pose_b);
  std::vector<kernel::Pose> poses;
  for (const double share : {1.0, -1 / 16.0}) {
    std::array<double, 12> entries = c.pose_b.entries();
    for (int i = 0; i < 3; ++i) entries[4 * i + 3] += share * (of_a[i] - of_b[i]);
    if (!std::ranges::all_of(entries, [](double x) { return std::isfinite(x); })) continue;
    const kernel::Pose pose(entries);
    if (pose.determinant_sign() != CGAL::ZERO) poses.push_back(pose);
  }
  return poses;
}

class Own : public Running_subject {
 public:
  explicit Own(Subject subject) : subject_(std::move(subject)) {}

  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    const auto collide = [&](const kernel::Pose& pose_b) { return pair_->collide(c.pose_a, pose_b, question); };
    const Told<bool> told = tell(
        c, question, most_faces_asked(), [&] { return collide(c.pose_b); }, collide);
    spent_ = told.spent;
    return told.outcome == Outcome::yes && !told.answer ? Outcome::no : told.outcome;
  }

  Told<Feature_pairs> features(const Object_case& c) override
  {
    return tell(c, kernel::Question::surface, most_faces, [&] { return pair_->features(c.pose_a, c.pose_b); });
  }

  Told<Contact_forms> contacts(const Object_case& c) override
  {
    const auto told = tell(c, kernel::Question::surface, most_faces,
                           [&] { return std::optional(pair_->contacts(c.pose_a, c.pose_b)); });
    return {told.outcome, told.answer ? contact_forms(*told.answer) : Contact_forms(), told.spent};
  }

  Told<Distance_answer> distance(const Object_case& c, kernel::Question question) override
  {
    const bool is_rational = subject_.kernel == Kernel_name::rational;
    const auto distance = [&](const kernel::Pose& pose_b) {
      return pair_->query(question)->distance(c.pose_a, pose_b);
    };
    const auto nearest = [&] {
      Nearest nearest = pair_->query(question)->nearest(c.pose_a, c.pose_b);
      return Distance_answer{std::move(nearest), distance(c.pose_b)};
    };
    return tell(c, question, is_rational ? most_faces_in_rationals : most_faces, nearest, distance);
  }

  Told<Solid_answer> solids(const Object_case& c) override
  {
    const auto solid = kernel::Question::solid;
    const auto contact = [&](const kernel::Pose& pose_b) {
      return pair_->query(solid)->solid_relation(c.pose_a, pose_b);
    };
    const auto answer = [&] {
      const Overlap overlap = pair_->query(solid)->overlap(c.pose_a, c.pose_b);
      Solid_answer answer{{contact(c.pose_b), kernel::Rational(overlap.exact_volume())},
                          pair_->query(solid)->solid_relation_alone(c.pose_a, c.pose_b),
                          overlap.volume,
                          overlap.centroid,
                          pair_->query(solid)->overlap_bounds(c.pose_a, c.pose_b),
                          {},
                          overlap.contact_vector,
                          overlap.contact_area};
      const auto exact_centroid = overlap.exact_centroid(), exact_vector = overlap.exact_contact_vector();
      for (std::size_t k = 0; k < 3; ++k) {
        answer.overlap.centroid[k] = kernel::Rational(exact_centroid[k]);
        answer.contact_vector[k] = kernel::Rational(exact_vector[k]);
      }
      return answer;
    };
    return tell(c, solid, most_faces, answer, contact);
  }

  Told<Exit_answer> exits(const Object_case& c, const std::array<kernel::Rational, 3>& direction) override
  {
    const auto solid = kernel::Question::solid;
    const std::array<std::string, 3> along = as_texts(direction);
    const auto exits = [&](const kernel::Pose& pose_b) { return pair_->query(solid)->exits(c.pose_a, pose_b, along); };
    const auto answer = [&] {
      const Exits found = exits(c.pose_b);
      return Exit_answer{
          {kernel::Rational(found.exact_first), kernel::Rational(found.exact_last)}, found.first, found.last};
    };
    return tell(c, solid, most_faces, answer, exits);
  }

  Told<Depth> depth(const Object_case& c) override
  {
    constexpr std::size_t boxes = 2000;
    const auto solid = kernel::Question::solid;
    return tell(c, solid, most_faces, [&] { return pair_->query(solid)->depth(c.pose_a, c.pose_b, {1e-9, boxes}); });
  }

  Outcome within(const Object_case& c, kernel::Question question, const std::string& limit) override
  {
    const Told<bool> told =
        tell(c, question, any_number, [&] { return pair_->query(question)->within(c.pose_a, c.pose_b, limit); });
    return told.outcome == Outcome::yes && !told.answer ? Outcome::no : told.outcome;
  }

  void forget() override { pair_.reset(); }
  std::optional<Spent> spent() const override { return spent_; }

 private:
  static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

  std::size_t most_faces_asked() const
  {
    if (subject_.method != Method::tree) return most_faces;
    const bool largest = subject_.kernel == Kernel_name::adaptive || subject_.kernel == Kernel_name::double_;
    return largest ? any_number : most_faces_of_trees;
  }

  /// Prepares bodies of at most `faces` faces, and the question's query, and returns what answer() tells. A subject
  /// that remembers is first asked the poses before the case's pose, each by ask_before(pose).
  template <class Answer, class Ask>
  Told<std::invoke_result_t<Answer>> tell(const Object_case& c, kernel::Question question, std::size_t faces,
                                          const Answer& answer, const Ask& ask_before)
  {
    if (c.a->face_count() > faces || c.b->face_count() > faces) return {};
    try {
      const std::uint64_t making = timed([&] {
                                     if (!pair_ || c.a != a_ || c.b != b_) {
                                       a_ = c.a;
                                       b_ = c.b;
                                       pair_ = prepare(subject_, *a_, *b_);
                                     }
                                     pair_->query(question);
                                     if (subject_.remembers) std::ranges::for_each(poses_before(c), ask_before);
                                     return true;
                                   }).second;
      auto [result, asking] = timed(answer);
      return {Outcome::yes, std::move(result), Spent{making, asking}};
    } catch (const std::exception&) {
      pair_.reset();
      return {Outcome::failed};
    }
  }
  template <class Answer>
  Told<std::invoke_result_t<Answer>> tell(const Object_case& c, kernel::Question question, std::size_t faces,
                                          const Answer& answer)
  {
    return tell(c, question, faces, answer, [](const kernel::Pose&) {});
  }

  Subject subject_;
  std::optional<Spent> spent_;
  std::shared_ptr<const covering::Polyhedron> a_, b_;
  std::unique_ptr<Prepared_pair> pair_;
};

}  // namespace

Object_subject object_subject(const Subject& subject)
{
  return {subject.name(), subject.is_exact(), "", subject, [subject] { return std::make_unique<Own>(subject); }};
}

std::vector<Object_subject> object_subjects()
{
  std::vector<Object_subject> subjects;
  for (const Kernel_name kernel : all_kernels)
    for (const kernel::Tolerance& tolerance : studied_tolerances(kernel))
      for (const Method method : all_methods)
        // All pairs in rational arithmetic are the truth itself.
        if (kernel != Kernel_name::rational || method != Method::brute)
          subjects.push_back(object_subject({kernel, tolerance, method}));
  Subject special;
  special.remembers = true;
  subjects.push_back(object_subject(special));
  special = {};
  special.whole_faces = true;
  subjects.push_back(object_subject(special));
  return subjects;
}

namespace {

/// Returns those of `object_subjects` that keep(subject) keeps.
template <class Keep>
std::vector<Object_subject> some_subjects(const Keep& keep)
{
  std::vector<Object_subject> subjects = object_subjects();
  std::erase_if(subjects, [&](const Object_subject& subject) { return !keep(*subject.own); });
  return subjects;
}

}  // namespace

std::vector<Object_subject> feature_subjects()
{
  return some_subjects([](const Subject& own) {
    if (own.remembers || own.whole_faces || own.method == Method::tuned) return false;
    return own.method == Method::tree || own.kernel == Kernel_name::adaptive || own.kernel == Kernel_name::double_;
  });
}

std::vector<Object_subject> contact_subjects()
{
  return some_subjects([](const Subject& own) {
    if (!own.is_exact() || own.remembers || own.method == Method::tuned) return false;
    return own.method == Method::tree || own.kernel == Kernel_name::adaptive;
  });
}

std::vector<Object_subject> distance_subjects()
{
  return some_subjects([](const Subject& own) {
    return own.method == Method::tree && (own.kernel == Kernel_name::adaptive || own.kernel == Kernel_name::rational);
  });
}

std::vector<Object_subject> solid_subjects()
{
  return some_subjects(
      [](const Subject& own) { return own.method == Method::tree && own.kernel == Kernel_name::adaptive; });
}

Contact_forms contact_forms(const Contacts& contacts)
{
  Contact_forms forms;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact_piece piece = contacts[k];
    forms.push_back(piece_form(piece.face_a, piece.face_b, piece.kind, piece.in_a, piece.in_b,
                               tetracone::detail::rational_loops(contacts.data(), k)));
  }
  std::sort(forms.begin(), forms.end());
  return forms;
}

}  // namespace tetracone::verify
