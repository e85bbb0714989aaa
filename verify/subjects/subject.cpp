#include "verify/subjects/subject.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/paper/collision.h"
#include "tetracone/tetratree/fast/bvh8_collision.h"
#include "verify/truth/cgal_truth.h"

#include <array>
#include <cmath>
#include <utility>

namespace tetracone::verify {
namespace {

constexpr std::array<std::pair<Kernel_name, std::string_view>, 7> kernel_names = {{
    {Kernel_name::adaptive, "adaptive"},
    {Kernel_name::double_, "double"},
    {Kernel_name::float_, "float"},
    {Kernel_name::double_eps, "double-eps"},
    {Kernel_name::epick, "epick"},
    {Kernel_name::epeck, "epeck"},
    {Kernel_name::rational, "rational"},
}};
constexpr std::array<std::pair<Method, std::string_view>, 3> method_names = {
    {{Method::tree, "tree"}, {Method::paper, "paper"}, {Method::brute, "brute"}}};

template <class K>
class Tree_pair : public Prepared_pair {
 public:
  Tree_pair(const Subject& subject, const covering::Polyhedron& a, const covering::Polyhedron& b)
      : use_(subject), a_(a, config_of(subject.method)), b_(b, config_of(subject.method)), collision_(a_, b_)
  {
  }

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    use_.now();
    return collision_(pose_a, pose_b, question);
  }

  std::vector<kernel::Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    use_.now();
    return collision_.features(pose_a, pose_b);
  }

  tetratree::Query_statistics take_counts() override
  {
    const tetratree::Query_statistics counts = collision_.counts();
    collision_.clear_counts();
    return counts;
  }

  std::size_t bytes() const override { return a_.bytes() + b_.bytes(); }
  std::size_t node_count() const override { return a_.node_count() + b_.node_count(); }

 private:
  // The tolerance belongs to the thread, and the tree is built with it too: set before the trees, and again for each query.
  struct Tolerance_in_use {
    explicit Tolerance_in_use(const Subject& subject) : tolerance(subject.tolerance) { now(); }
    void now() const { kernel::Tolerant::tolerance() = tolerance; }
    kernel::Tolerance tolerance;
  };

  Tolerance_in_use use_;
  tetratree::Tetra_tree<K> a_, b_;
  tetratree::Collision<K> collision_;
};

/// The fast tree of the adaptive kernel. Features are asked of the tetra-tree, which is made when they are.
class Wide_pair : public Prepared_pair {
 public:
  Wide_pair(const Subject& subject, const covering::Polyhedron& a, const covering::Polyhedron& b)
      : subject_(subject), polyhedron_a_(a), polyhedron_b_(b), a_(a, covering::triangulate_faces(a)), b_(b, covering::triangulate_faces(b)), collision_(a_, b_)
  {
  }

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    return collision_(pose_a, pose_b, question);
  }
  std::vector<kernel::Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    if (!of_features_) of_features_ = std::make_unique<Tree_pair<kernel::Adaptive>>(subject_, polyhedron_a_, polyhedron_b_);
    return of_features_->features(pose_a, pose_b);
  }
  tetratree::Query_statistics take_counts() override
  {
    tetratree::Query_statistics counts = collision_.counts();
    collision_.clear_counts();
    if (of_features_) counts += of_features_->take_counts();
    return counts;
  }
  std::size_t bytes() const override { return a_.bytes() + b_.bytes() + collision_.bytes(); }
  std::size_t node_count() const override { return a_.node_count() + b_.node_count(); }

 private:
  Subject subject_;
  covering::Polyhedron polyhedron_a_, polyhedron_b_;
  tetratree::Bvh8 a_, b_;
  tetratree::Bvh8_collision collision_;
  std::unique_ptr<Tree_pair<kernel::Adaptive>> of_features_;
};

class Truth_pair : public Prepared_pair {
 public:
  Truth_pair(const covering::Polyhedron& a, const covering::Polyhedron& b) : a_(a), b_(b) {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    return verify::collide(a_, pose_a, b_, pose_b, question);
  }
  std::vector<kernel::Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    return verify::features(a_, pose_a, b_, pose_b);
  }
  tetratree::Query_statistics take_counts() override { return {}; }
  std::size_t bytes() const override { return 0; }
  std::size_t node_count() const override { return 0; }

 private:
  Brute_body a_, b_;
};

}  // namespace

std::string_view to_string(Method method)
{
  return method_names[static_cast<std::size_t>(method)].second;
}

tetratree::Config config_of(Method method)
{
  if (method == Method::tree) return tetratree::Config::fastest();
  if (method == Method::brute) return tetratree::Config::brute();
  return {};
}

std::optional<Method> parse_method(std::string_view name)
{
  for (const auto& [method, known] : method_names)
    if (name == known) return method;
  return std::nullopt;
}

std::optional<Subject> Subject::parse(std::string_view kernel, Method method)
{
  Subject subject;
  subject.method = method;
  constexpr std::string_view eps = "double-eps=", relative = "rel:";
  if (kernel.starts_with(eps)) {
    kernel.remove_prefix(eps.size());
    const bool is_relative = kernel.starts_with(relative);
    if (is_relative) kernel.remove_prefix(relative.size());
    const auto value = kernel::parse_double(kernel);
    if (!value || std::signbit(*value)) return std::nullopt;
    subject.kernel = Kernel_name::double_eps;
    (is_relative ? subject.tolerance.relative : subject.tolerance.absolute) = *value;
    return subject;
  }
  for (const auto& [name, known] : kernel_names) {
    if (kernel != known || name == Kernel_name::double_eps) continue;
    subject.kernel = name;
    return subject;
  }
  return std::nullopt;
}

std::string Subject::kernel_name() const
{
  std::string name(kernel_names[static_cast<std::size_t>(kernel)].second);
  if (kernel != Kernel_name::double_eps) return name;
  return name + (tolerance.relative > 0 ? "=rel:" + kernel::shortest(tolerance.relative) : "=" + kernel::shortest(tolerance.absolute));
}

std::string Subject::name() const
{
  return kernel_name() + " " + std::string(to_string(method));
}

std::unique_ptr<Prepared_pair> prepare(const Subject& subject, const covering::Polyhedron& a, const covering::Polyhedron& b)
{
  switch (subject.kernel) {
    case Kernel_name::adaptive:
      if (subject.method == Method::tree) return std::make_unique<Wide_pair>(subject, a, b);
      return std::make_unique<Tree_pair<kernel::Adaptive>>(subject, a, b);
    case Kernel_name::double_: return std::make_unique<Tree_pair<kernel::Double>>(subject, a, b);
    case Kernel_name::float_: return std::make_unique<Tree_pair<kernel::Float>>(subject, a, b);
    case Kernel_name::double_eps: return std::make_unique<Tree_pair<kernel::Tolerant>>(subject, a, b);
    case Kernel_name::epick: return std::make_unique<Tree_pair<kernel::Epick>>(subject, a, b);
    case Kernel_name::epeck: return std::make_unique<Tree_pair<kernel::Epeck>>(subject, a, b);
    case Kernel_name::rational: break;
  }
  if (subject.method == Method::brute) return std::make_unique<Truth_pair>(a, b);
  return std::make_unique<Tree_pair<kernel::Rational_kernel>>(subject, a, b);
}

}  // namespace tetracone::verify
