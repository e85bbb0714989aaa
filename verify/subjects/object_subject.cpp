#include "verify/subjects/object_subject.h"

#include <exception>
#include <string_view>
#include <utility>

namespace tetracone::verify {
namespace {

class Own : public Running_subject {
 public:
  explicit Own(Subject subject) : subject_(std::move(subject)) {}

  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    try {
      if (!pair_ || c.a != a_ || c.b != b_) {
        a_ = c.a;
        b_ = c.b;
        pair_ = prepare(subject_, *a_, *b_);
      }
      return pair_->collide(c.pose_a, c.pose_b, question) ? Outcome::yes : Outcome::no;
    } catch (const std::exception&) {
      pair_.reset();
      return Outcome::failed;
    }
  }

 private:
  Subject subject_;
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
  for (const std::string_view kernel :
       {"adaptive", "rational", "epeck", "epick", "double", "double-eps=1e-12", "double-eps=rel:1e-12", "float"})
    for (const Method method : all_methods)
      // All pairs in rational arithmetic are the truth itself.
      if (kernel != "rational" || method != Method::brute)
        subjects.push_back(object_subject(*Subject::parse(kernel, method)));
  return subjects;
}

}  // namespace tetracone::verify
