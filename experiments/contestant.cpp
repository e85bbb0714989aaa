#include "experiments/contestant.h"

#include "covering/repair.h"
#include "experiments/peer.h"
#include "kernel/kernels.h"
#include "tetratree/collision.h"
#include "tetratree/wide_collision.h"

#include <utility>

namespace tetracone::experiments {
namespace {

using covering::Polyhedron;
using kernel::Pose;
using kernel::Question;

template <class Collision>
tetratree::Counts taken(Collision& collision)
{
  const tetratree::Counts counts = collision.counts();
  collision.clear_counts();
  return counts;
}

enum class Nodes { at_once, on_demand };

class Wide_ready : public Ready {
 public:
  template <class... Options>
  Wide_ready(const Polyhedron& a, const Polyhedron& b, Nodes nodes, Options... options)
      : a_(a, covering::triangulate_faces(a)), b_(b, covering::triangulate_faces(b)), collision_(a_, b_, options...)
  {
    if (nodes == Nodes::on_demand) return;
    a_.make_all();
    b_.make_all();
  }

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override { return collision_(pose_a, pose_b, question); }
  tetratree::Counts take_counts() override { return taken(collision_); }
  std::size_t node_count() const override { return a_.node_count() + b_.node_count(); }
  std::size_t tree_bytes() const override { return a_.bytes() + b_.bytes() + collision_.bytes(); }

 private:
  tetratree::Wide_tree a_, b_;
  tetratree::Wide_collision collision_;
};

template <class... Options>
Contestant wide_as(const std::string& name, Options... options)
{
  const auto prepare = [=](Nodes nodes) {
    return [=](const Polyhedron& a, const Polyhedron& b) { return std::make_unique<Wide_ready>(a, b, nodes, options...); };
  };
  return {name, true, true, true, 1, prepare(Nodes::at_once), prepare(Nodes::on_demand)};
}

template <class K>
double copies_in_leaves(const tetratree::Tetra_tree<K>& tree)
{
  std::size_t copies = 0;
  for (covering::Index n = 0; n < tree.node_count(); ++n)
    if (tree.node(n).is_leaf) copies += tree.node(n).end - tree.node(n).begin;
  return double(copies) / double(tree.model().face_count());
}

template <class K>
class Paper_ready : public Ready {
 public:
  Paper_ready(const Polyhedron& a, const Polyhedron& b, const tetratree::Config& config) : a_(a, config), b_(b, config), collision_(a_, b_) {}

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override { return collision_(pose_a, pose_b, question); }
  tetratree::Counts take_counts() override { return taken(collision_); }
  std::size_t node_count() const override { return a_.node_count() + b_.node_count(); }
  double copies() const override { return (copies_in_leaves(a_) + copies_in_leaves(b_)) / 2; }

 private:
  tetratree::Tetra_tree<K> a_, b_;
  tetratree::Collision<K> collision_;
};

template <class K>
Contestant paper_over(const std::string& name, const tetratree::Config& config)
{
  return {name, kernel::Kernel_traits<K>::exact_signs, true, true, 1,
          [config](const Polyhedron& a, const Polyhedron& b) { return std::make_unique<Paper_ready<K>>(a, b, config); }, {}};
}

class Peer_ready : public Ready {
 public:
  explicit Peer_ready(std::unique_ptr<Peer_pair> pair) : pair_(std::move(pair)) {}
  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override { return pair_->collide(pose_a, pose_b, question); }

 private:
  std::unique_ptr<Peer_pair> pair_;
};

}  // namespace

Contestant wide() { return wide_as("tetracone"); }
Contestant wide_with_last_frame() { return wide_as("tetracone with last frame", tetratree::Coherence::last_frame); }

Contestant paper(const std::string& name, const tetratree::Config& config) { return paper_over<kernel::Double>(name, config); }
Contestant paper_adaptive(const std::string& name, const tetratree::Config& config) { return paper_over<kernel::Adaptive>(name, config); }

Contestant peer(const std::string& name, std::size_t one_in)
{
  Contestant result{name, false, name.starts_with("CGAL"), false, one_in, [](const Polyhedron&, const Polyhedron&) { return nullptr; }, {}};
  for (const Peer& known : peers()) {
    if (known.name != name) continue;
    result.prepare = [prepare = known.prepare](const Polyhedron& a, const Polyhedron& b) -> std::unique_ptr<Ready> {
      const auto mesh_a = peer_mesh(a), mesh_b = peer_mesh(b);
      auto pair = mesh_a && mesh_b ? prepare(*mesh_a, *mesh_b) : nullptr;
      return pair ? std::make_unique<Peer_ready>(std::move(pair)) : nullptr;
    };
  }
  return result;
}

}  // namespace tetracone::experiments
