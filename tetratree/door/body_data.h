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

namespace tetracone::tetratree {
class Solid_sides;
}

namespace tetracone::detail {

/// The data that copies of a `Body` share. Parts are made on demand, once, by the first thread that needs them.
struct Body_data {
  Body_data(covering::Polyhedron p, std::vector<covering::Face_triangle> t)
      : polyhedron(std::move(p)), triangles(std::move(t))
  {}

  /// A body that was saved, with its fast tree.
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

  /// True when no two faces intersect improperly. The first call decides it, with all nodes of the fast tree.
  bool is_simple() const;

  /// Returns the fast tree; makes its root on first use. `both` runs pairs of steps that make its model.
  const tetratree::Bvh8& bvh8(const covering::Both& both = {}) const
  {
    std::call_once(bvh8_once_, [&] {
      bvh8_.emplace(polyhedron, triangles, tetratree::Bvh8_options{}, both);
      made_bvh8_.store(&*bvh8_, std::memory_order_release);
    });
    return *bvh8_;
  }
  /// Returns the fast tree; null where it has not been made.
  const tetratree::Bvh8* made_bvh8() const { return made_bvh8_.load(std::memory_order_acquire); }

  /// Returns the table for points in the solid. Requires a closed polyhedron.
  const tetratree::Point_locator& point_locator() const
  {
    std::call_once(point_locator_once_, [this] { point_locator_.emplace(bvh8().model()); });
    return *point_locator_;
  }

  /// Returns this body with each of its triangles as a face of its own; faces without triangles stay as they are.
  const Body_data& by_triangles() const
  {
    if (triangles.empty()) return *this;
    std::call_once(by_triangles_once_, [this] {
      by_triangles_ = std::make_unique<const Body_data>(covering::each_triangle_a_face(polyhedron, triangles),
                                                        std::vector<covering::Face_triangle>());
    });
    return *by_triangles_;
  }

  /// Returns which sides of its faces are in the solid. Requires a closed polyhedron, and `this == &by_triangles()`.
  const tetratree::Solid_sides& solid_sides() const;

  /// Returns the polyhedron as K sees it. The fast tree holds the adaptive kernel's model.
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

  /// Returns the tetra-tree over K with this config, with all its nodes. It is cached under `name`, so a name must
  /// stand for one K and one config.
  template <class K>
  std::shared_ptr<tetratree::Tetra_tree<K>> tetra_tree(const std::string& name, const tetratree::Config& config) const
  {
    const std::lock_guard lock(trees_lock_);
    std::shared_ptr<void>& tree = trees_[name];
    if (!tree) tree = std::make_shared<tetratree::Tetra_tree<K>>(polyhedron, config);
    return std::static_pointer_cast<tetratree::Tetra_tree<K>>(tree);
  }

 private:
  mutable std::once_flag closed_once_, simple_once_, bvh8_once_, point_locator_once_, by_triangles_once_,
      solid_sides_once_;
  mutable bool closed_ = false, simple_ = false;
  mutable std::optional<tetratree::Bvh8> bvh8_;
  mutable std::atomic<const tetratree::Bvh8*> made_bvh8_ = nullptr;
  mutable std::optional<tetratree::Point_locator> point_locator_;
  mutable std::unique_ptr<const Body_data> by_triangles_;
  mutable std::shared_ptr<const tetratree::Solid_sides> solid_sides_;
  mutable std::mutex trees_lock_;
  mutable std::map<std::string, std::shared_ptr<void>> trees_;
  mutable std::map<std::type_index, std::shared_ptr<void>> models_;
};

/// Returns the triangles of a body: those given, and fans of the other faces that a fan covers. `name` begins messages.
/// Throws Error as `Body` does. Requires a polyhedron with legal loops and faces (`has_legal_loops`).
std::vector<covering::Face_triangle> legal_triangles(const covering::Polyhedron& polyhedron,
                                                     std::vector<covering::Face_triangle> given,
                                                     const std::string& name);

/// Throws Error, "WHO is open at ...; expected a closed surface for WHAT", when the body has no solid.
void require_solid(const Body_data& body, const std::string& who, const std::string& what);

}  // namespace tetracone::detail

#endif
