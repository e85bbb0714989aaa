#ifndef TETRACONE_TETRATREE_DOOR_BODY_DATA_H
#define TETRACONE_TETRATREE_DOOR_BODY_DATA_H

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/locator/point_locator.h"
#include "tetracone/tetratree/paper/config.h"
#include "tetracone/tetratree/paper/tetra_tree.h"

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace tetracone::detail {

/// What copies of a `Body` share. What is not yet here is made once, by the first thread that asks for it.
struct Body_data {
  Body_data(covering::Polyhedron p, std::vector<covering::Face_triangle> t)
      : polyhedron(std::move(p)), triangles(std::move(t))
  {}

  /// One that was saved: its fast tree is known.
  Body_data(covering::Polyhedron p, std::vector<covering::Face_triangle> t, tetratree::Bvh8_elements elements,
            tetratree::Reserved_array<tetratree::Bvh8_node> nodes)
      : Body_data(std::move(p), std::move(t))
  {
    std::call_once(bvh8_once_, [&] {
      bvh8_.emplace(std::move(elements), std::move(nodes));
      made_bvh8_.store(&*bvh8_, std::memory_order_release);
    });
  }

  const covering::Polyhedron polyhedron;
  const std::vector<covering::Face_triangle> triangles;

  bool is_closed() const
  {
    std::call_once(closed_once_, [this] { closed_ = covering::is_closed(polyhedron); });
    return closed_;
  }

  /// What it is made of is found by `both`.
  const tetratree::Bvh8& bvh8(const covering::Both& both = {}) const
  {
    std::call_once(bvh8_once_, [&] {
      bvh8_.emplace(polyhedron, triangles, tetratree::Bvh8_options{}, both);
      made_bvh8_.store(&*bvh8_, std::memory_order_release);
    });
    return *bvh8_;
  }
  /// The same, or nothing where no query has asked for it yet.
  const tetratree::Bvh8* made_bvh8() const { return made_bvh8_.load(std::memory_order_acquire); }

  /// Requires a closed polyhedron.
  const tetratree::Point_locator& point_locator() const
  {
    std::call_once(point_locator_once_, [this] { point_locator_.emplace(bvh8().model()); });
    return *point_locator_;
  }

  /// The polyhedron as K sees it, of which the fast tree has the adaptive kernel's.
  template <class K>
  const covering::Model<K>& model() const
  {
    if constexpr (std::is_same_v<K, kernel::Adaptive>) {
      return bvh8().model();
    } else {
      const std::lock_guard lock(trees_lock_);
      std::shared_ptr<void>& model = models_[typeid(K)];
      if (!model) model = std::make_shared<covering::Model<K>>(polyhedron);
      return *std::static_pointer_cast<covering::Model<K>>(model);
    }
  }

  /// The tetra-tree over K of this config, `name`d so; all of its nodes are made.
  template <class K>
  std::shared_ptr<tetratree::Tetra_tree<K>> tetra_tree(const std::string& name, const tetratree::Config& config) const
  {
    const std::lock_guard lock(trees_lock_);
    std::shared_ptr<void>& tree = trees_[name];
    if (!tree) tree = std::make_shared<tetratree::Tetra_tree<K>>(polyhedron, config);
    return std::static_pointer_cast<tetratree::Tetra_tree<K>>(tree);
  }

 private:
  mutable std::once_flag closed_once_, bvh8_once_, point_locator_once_;
  mutable bool closed_ = false;
  mutable std::optional<tetratree::Bvh8> bvh8_;
  mutable std::atomic<const tetratree::Bvh8*> made_bvh8_ = nullptr;
  mutable std::optional<tetratree::Point_locator> point_locator_;
  mutable std::mutex trees_lock_;
  mutable std::map<std::string, std::shared_ptr<void>> trees_;
  mutable std::map<std::type_index, std::shared_ptr<void>> models_;
};

/// The triangles of a body: those given, and fans of the faces that have none and that a fan covers. `name`: what
/// messages begin with. Throws Error as `Body` does. Requires a polyhedron of loops and faces that are
/// (`has_legal_loops`).
std::vector<covering::Face_triangle> legal_triangles(const covering::Polyhedron& polyhedron,
                                                     std::vector<covering::Face_triangle> given,
                                                     const std::string& name);

/// Throws Error when the body is no solid: "WHO is open at ...; expected a closed surface for WHAT".
void require_solid(const Body_data& body, const std::string& who, const std::string& what);

}  // namespace tetracone::detail

#endif
