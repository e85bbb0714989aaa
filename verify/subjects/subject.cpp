#include "verify/subjects/subject.h"

#include "tetracone/tetratree/door/repair.h"
#include "verify/truth/cgal_truth.h"

#include <array>
#include <optional>

namespace tetracone::verify {
namespace {

/// Answers by the library's own interface. Each question has its query; the query of solids is made when it is first
/// needed.
class Query_pair : public Prepared_pair {
 public:
  Query_pair(const Subject& subject, const Body& a, const Body& b)
      : options_{subject.kernel, subject.method, subject.tolerance, subject.remembers}, a_(a), b_(b)
  {
    asked(kernel::Question::surface);
  }

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    return bool(asked(question).collide(pose_a, pose_b));
  }
  kernel::Relation relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    return asked(question).collide(pose_a, pose_b).relation();
  }
  std::vector<kernel::Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    return asked(kernel::Question::surface).features(pose_a, pose_b);
  }
  Contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    return asked(kernel::Question::surface).contacts(pose_a, pose_b);
  }
  Query* query(kernel::Question question) override { return &asked(question); }
  tetratree::Query_statistics take_counts() override
  {
    tetratree::Query_statistics counts;
    for (auto& query : queries_)
      if (query) {
        counts += query->statistics();
        query->clear_statistics();
      }
    return counts;
  }
  std::size_t bytes() const override { return queries_[0]->bytes(); }
  std::size_t node_count() const override { return queries_[0]->node_count(); }

 private:
  Query& asked(kernel::Question question)
  {
    auto& query = queries_[question == kernel::Question::solid ? 1 : 0];
    if (!query) query.emplace(a_, b_, question, options_);
    return *query;
  }

  Query_options options_;
  Body a_, b_;
  std::array<std::optional<Query>, 2> queries_;
};

class Truth_pair : public Prepared_pair {
 public:
  Truth_pair(const covering::Polyhedron& a, const covering::Polyhedron& b) : a_(a), b_(b) {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    return verify::collide(a_, pose_a, b_, pose_b, question);
  }
  kernel::Relation relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    const Placed_body a(a_, pose_a), b(b_, pose_b);
    if (verify::collide(a, b, kernel::Question::surface)) return kernel::Relation::surfaces;
    if (question == kernel::Question::surface) return kernel::Relation::apart;
    detail::require_closed(a, b);
    return detail::contains(a, b)   ? kernel::Relation::b_in_a
           : detail::contains(b, a) ? kernel::Relation::a_in_b
                                    : kernel::Relation::apart;
  }
  std::vector<kernel::Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    return verify::features(a_, pose_a, b_, pose_b);
  }
  Contacts contacts(const kernel::Pose&, const kernel::Pose&) override
  {
    throw Error("contacts of all pairs in rationals; expected another method or kernel");
  }
  tetratree::Query_statistics take_counts() override { return {}; }
  std::size_t bytes() const override { return 0; }
  std::size_t node_count() const override { return 0; }

 private:
  Brute_body a_, b_;
};

bool is_truth(const Subject& subject)
{
  return subject.kernel == Kernel_name::rational && subject.method == Method::brute;
}

}  // namespace

std::optional<Subject> Subject::parse(std::string_view kernel, Method method)
{
  const auto options = parse_kernel(kernel);
  if (!options) return std::nullopt;
  return Subject{options->kernel, options->tolerance, method};
}

std::vector<kernel::Tolerance> studied_tolerances(Kernel_name kernel)
{
  if (kernel != Kernel_name::double_eps) return {{}};
  return {{1e-12, 0}, {0, 1e-12}};
}

std::string Subject::kernel_name() const { return tetracone::kernel_name(kernel, tolerance); }

std::string Subject::name() const
{
  return kernel_name() + " " + std::string(to_string(method)) + (remembers ? " remembering" : "") +
         (whole_faces ? " whole-faces" : "");
}

std::unique_ptr<Prepared_pair> prepare(const Subject& subject, const covering::Polyhedron& a,
                                       const covering::Polyhedron& b)
{
  if (is_truth(subject)) return std::make_unique<Truth_pair>(a, b);
  const auto body = [&](const covering::Polyhedron& polyhedron) {
    return subject.whole_faces ? Body(polyhedron) : triangulated_body(polyhedron);
  };
  return std::make_unique<Query_pair>(subject, body(a), body(b));
}

std::unique_ptr<Prepared_pair> prepare(const Subject& subject, const Body& a, const Body& b)
{
  if (is_truth(subject)) return std::make_unique<Truth_pair>(a.polyhedron(), b.polyhedron());
  return std::make_unique<Query_pair>(subject, a, b);
}

}  // namespace tetracone::verify
