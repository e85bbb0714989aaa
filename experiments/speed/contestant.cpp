#include "experiments/speed/contestant.h"

#include "tetracone/covering/repair/repair.h"
#include "experiments/peers/peer.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/paper/collision.h"
#include "tetracone/tetratree/fast/bvh8_collision.h"

#include <utility>

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

struct Wide_trees {
  Wide_trees(const Polyhedron& polyhedron_a, const Polyhedron& polyhedron_b, Nodes nodes)
      : a(polyhedron_a, covering::triangulate_faces(polyhedron_a)), b(polyhedron_b, covering::triangulate_faces(polyhedron_b))
  {
    if (nodes == Nodes::on_demand) return;
    a.make_all();
    b.make_all();
  }
  tetratree::Bvh8 a, b;
};

class Wide_ready : public Ready {
 public:
  Wide_ready(std::shared_ptr<Wide_trees> trees, tetratree::Coherence coherence)
      : trees_(std::move(trees)), collision_(trees_->a, trees_->b, coherence)
  {
  }

  const std::shared_ptr<Wide_trees>& trees() const { return trees_; }

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override { return collision_(pose_a, pose_b, question); }
  tetratree::Query_statistics take_counts() override { return taken(collision_); }
  std::size_t node_count() const override { return trees_->a.node_count() + trees_->b.node_count(); }
  std::size_t tree_bytes() const override { return trees_->a.bytes() + trees_->b.bytes() + collision_.bytes(); }

 private:
  std::shared_ptr<Wide_trees> trees_;
  tetratree::Bvh8_collision collision_;
};

Contestant wide_as(const std::string& name, tetratree::Coherence coherence)
{
  const auto prepare = [coherence](Nodes nodes) {
    return [=](const Polyhedron& a, const Polyhedron& b) { return std::make_unique<Wide_ready>(std::make_shared<Wide_trees>(a, b, nodes), coherence); };
  };
  const auto share = [coherence](const Ready& other) -> std::unique_ptr<Ready> {
    const auto* wide = dynamic_cast<const Wide_ready*>(&other);
    return wide ? std::make_unique<Wide_ready>(wide->trees(), coherence) : nullptr;
  };
  return {name, true, true, true, 1, prepare(Nodes::at_once), prepare(Nodes::on_demand), share};
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
  tetratree::Query_statistics take_counts() override { return taken(collision_); }
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
          [config](const Polyhedron& a, const Polyhedron& b) { return std::make_unique<Paper_ready<K>>(a, b, config); }, {}, {}};
}

class Peer_ready : public Ready {
 public:
  explicit Peer_ready(std::unique_ptr<Peer_pair> pair) : pair_(std::move(pair)) {}
  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override { return pair_->collide(pose_a, pose_b, question); }

 private:
  std::unique_ptr<Peer_pair> pair_;
};

}  // namespace

Contestant wide() { return wide_as("tetracone", tetratree::Coherence::none); }
Contestant wide_with_last_frame() { return wide_as("tetracone with last frame", tetratree::Coherence::last_frame); }

Contestant paper(const std::string& name, const tetratree::Config& config) { return paper_over<kernel::Double>(name, config); }
Contestant paper_adaptive(const std::string& name, const tetratree::Config& config) { return paper_over<kernel::Adaptive>(name, config); }

Contestant peer(const std::string& name, std::size_t one_in)
{
  Contestant result{name, false, name.starts_with("CGAL"), false, one_in, [](const Polyhedron&, const Polyhedron&) { return nullptr; }, {}, {}};
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
