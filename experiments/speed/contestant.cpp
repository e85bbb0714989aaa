#include "experiments/speed/contestant.h"

#include "experiments/peers/peer.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/paper/collision.h"
#include "tetracone/tetratree/query/bvh8_collision.h"

#include <limits>

namespace tetracone::experiments {
namespace {

using covering::Polyhedron;
using kernel::Pose;
using kernel::Question;

template <class Collision>
tetratree::Query_statistics taken(Collision& collision)
{
  const tetratree::Query_statistics counts = collision.counts();
  collision.clear_counts();
  return counts;
}

enum class Nodes { at_once, on_demand };

struct Bodies {
  Bodies(const Polyhedron& polyhedron_a, const Polyhedron& polyhedron_b, Nodes nodes)
      : a(triangulated_body(polyhedron_a)), b(triangulated_body(polyhedron_b))
  {
    if (nodes == Nodes::on_demand) return;
    a.make_all();
    b.make_all();
  }
  Body a, b;
};

class Fast_pair : public Prepared_pair {
 public:
  Fast_pair(const Bodies& bodies, const Query_options& options)
      : bodies_(bodies), options_(options), surface_(bodies.a, bodies.b, Question::surface, options)
  {}

  const Bodies& bodies() const { return bodies_; }

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override
  {
    if (question == Question::surface) return bool(surface_.collide(pose_a, pose_b));
    if (!solid_) solid_.emplace(bodies_.a, bodies_.b, Question::solid, options_);
    return bool(solid_->collide(pose_a, pose_b));
  }
  tetratree::Query_statistics take_counts() override
  {
    tetratree::Query_statistics counts = surface_.statistics();
    surface_.clear_statistics();
    if (!solid_) return counts;
    counts += solid_->statistics();
    solid_->clear_statistics();
    return counts;
  }
  std::size_t node_count() const override { return surface_.node_count(); }
  std::size_t tree_bytes() const override { return surface_.bytes(); }
  std::size_t mapped_bytes() const override { return node_count() * sizeof(tetratree::Bvh8_node); }

 private:
  Bodies bodies_;
  Query_options options_;
  Query surface_;
  std::optional<Query> solid_;
};

Contestant fast_as(const std::string& name, const Query_options& options)
{
  const auto prepare = [options](Nodes nodes) {
    return [=](const Polyhedron& a, const Polyhedron& b) {
      return std::make_unique<Fast_pair>(Bodies(a, b, nodes), options);
    };
  };
  const auto share = [options](const Prepared_pair& other) -> std::unique_ptr<Prepared_pair> {
    const auto* fast = dynamic_cast<const Fast_pair*>(&other);
    return fast ? std::make_unique<Fast_pair>(fast->bodies(), options) : nullptr;
  };
  return {.name = name,
          .exact = options.kernel == Kernel::adaptive,
          .knows_solids = true,
          .counts_work = true,
          .prepare = prepare(Nodes::at_once),
          .prepare_on_demand = prepare(Nodes::on_demand),
          .share = share};
}

class Chosen_pair : public Prepared_pair {
 public:
  Chosen_pair(const Polyhedron& a, const Polyhedron& b, const tetratree::Bvh8_options& options)
      : a_(a, {}, options), b_(b, {}, options), collision_(a_, b_)
  {
    a_.make_all();
    b_.make_all();
  }

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override
  {
    return collision_(pose_a, pose_b, question);
  }
  tetratree::Query_statistics take_counts() override { return taken(collision_); }
  std::size_t node_count() const override { return a_.node_count() + b_.node_count(); }
  std::size_t tree_bytes() const override { return a_.bytes() + b_.bytes() + collision_.bytes(); }
  std::size_t mapped_bytes() const override { return a_.node_bytes() + b_.node_bytes(); }
  tetratree::Cut_counts cuts() const override
  {
    const tetratree::Cut_counts a = a_.cuts(), b = b_.cuts();
    return {a.all + b.all, a.tried_cones + b.tried_cones, a.through_origin + b.through_origin};
  }

 private:
  tetratree::Bvh8 a_, b_;
  tetratree::Bvh8_collision<> collision_;
};

template <class K>
double copies_in_leaves(const tetratree::Tetra_tree<K>& tree)
{
  std::size_t copies = 0;
  for (covering::Index n = 0; n < tree.node_count(); ++n)
    if (tree.node(n).is_leaf) copies += tree.node(n).end - tree.node(n).begin;
  return double(copies) / double(tree.model().face_count());
}

template <class K>
class Paper_pair : public Prepared_pair {
 public:
  Paper_pair(const Polyhedron& a, const tetratree::Config& of_a, const Polyhedron& b, const tetratree::Config& of_b)
      : a_(a, of_a), b_(b, of_b), collision_(a_, b_)
  {}

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override
  {
    return collision_(pose_a, pose_b, question);
  }
  tetratree::Query_statistics take_counts() override { return taken(collision_); }
  std::size_t node_count() const override { return a_.node_count() + b_.node_count(); }
  double copies() const override { return (copies_in_leaves(a_) + copies_in_leaves(b_)) / 2; }

 private:
  tetratree::Tetra_tree<K> a_, b_;
  tetratree::Collision<K> collision_;
};

template <class K>
Contestant paper_over(const std::string& name, const tetratree::Config& of_a, const tetratree::Config& of_b)
{
  return {.name = name,
          .exact = kernel::Kernel_traits<K>::exact_signs,
          .knows_solids = true,
          .counts_work = true,
          .prepare = [of_a, of_b](const Polyhedron& a, const Polyhedron& b) {
            return std::make_unique<Paper_pair<K>>(a, of_a, b, of_b);
          }};
}

/// Two bodies that a program is asked about.
class Program_pair : public Prepared_pair {
 public:
  Program_pair(const verify::Object_subject& subject, const Polyhedron& a, const Polyhedron& b)
      : name_(subject.name), running_(subject.make())
  {
    case_.a = std::make_shared<const Polyhedron>(a);
    case_.b = std::make_shared<const Polyhedron>(b);
  }

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override
  {
    case_.pose_a = pose_a;
    case_.pose_b = pose_b;
    const verify::Outcome outcome = (*running_)(case_, question);
    if (outcome == verify::Outcome::failed) throw No_answer(name_ + " failed: " + running_->failure().how);
    if (outcome == verify::Outcome::not_asked) throw No_answer(name_ + " is not asked: " + running_->why_not_asked());
    return outcome == verify::Outcome::yes;
  }
  std::optional<double> own_ns() const override
  {
    const auto spent = running_->spent();
    return spent ? double(spent->asking) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::string name_;
  std::unique_ptr<verify::Running_subject> running_;
  verify::Object_case case_;
};

}  // namespace

Contestant program(const verify::Object_subject& subject)
{
  return {.name = subject.name,
          .knows_solids = true,
          .prepare = [subject](const Polyhedron& a,
                               const Polyhedron& b) { return std::make_unique<Program_pair>(subject, a, b); },
          .kernel = subject.name,
          .method = "program"};
}

Contestant fast()
{
  Contestant contestant = fast_as("tetracone", {});
  contestant.clocked_cold = true;
  return contestant;
}
Contestant fast_with_last_frame() { return fast_as("tetracone with last frame", {.remember = true}); }
Contestant fast_in_double() { return fast_as("tetracone in double", {.kernel = Kernel::double_}); }

Contestant fast_as_chosen(const std::string& name, const tetratree::Bvh8_options& options)
{
  return {.name = name,
          .exact = true,
          .knows_solids = true,
          .counts_work = true,
          .prepare = [options](const Polyhedron& a, const Polyhedron& b) {
            return std::make_unique<Chosen_pair>(a, b, options);
          }};
}

Contestant paper(const std::string& name, const tetratree::Config& config) { return paper(name, config, config); }
Contestant paper(const std::string& name, const tetratree::Config& of_a, const tetratree::Config& of_b)
{
  return paper_over<kernel::Double>(name, of_a, of_b);
}
Contestant paper_adaptive(const std::string& name, const tetratree::Config& config)
{
  return paper_over<kernel::Adaptive>(name, config, config);
}

Contestant peer(const std::string& name, std::size_t one_in)
{
  Contestant result{.name = name,
                    .knows_solids = name.starts_with("CGAL"),
                    .clocked_cold = name.starts_with("FCL"),
                    .one_in = one_in,
                    .prepare = [](const Polyhedron&, const Polyhedron&) { return nullptr; }};
  for (const Peer& known : peers()) {
    if (known.name != name) continue;
    result.prepare = [prepare = known.prepare](const Polyhedron& a,
                                               const Polyhedron& b) -> std::unique_ptr<Prepared_pair> {
      const auto mesh_a = peer_mesh(a), mesh_b = peer_mesh(b);
      return mesh_a && mesh_b ? prepare(*mesh_a, *mesh_b) : nullptr;
    };
  }
  return result;
}

}  // namespace tetracone::experiments
