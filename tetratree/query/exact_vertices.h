#ifndef TETRACONE_TETRATREE_QUERY_EXACT_VERTICES_H
#define TETRACONE_TETRATREE_QUERY_EXACT_VERTICES_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/face_distance.h"

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

namespace tetracone::tetratree {

/// The exact images of a body's vertices, times a weight that two bodies share. Each is computed on first use. One
/// object serves one thread.
class Exact_vertices {
 public:
  /// The vertices must outlive this object.
  explicit Exact_vertices(const std::vector<covering::Vertex>& vertices)
      : vertices_(&vertices), place_(vertices.size(), none)
  {}

  /// Sets the body's pose; `other` places the body that shares the weight. `pose` must outlive all use until the next
  /// call.
  void place(const kernel::Pose& pose, const kernel::Pose& other)
  {
    for (const std::uint32_t v : found_) place_[v] = none;
    found_.clear();
    images_.clear();
    pose_ = &pose;
    others_weight_ = other.weight();
    is_weighted_ = other.is_rational();
    has_entries_ = false;
  }

  /// Returns the exact image of vertex v times `weight`; it is valid until the next `place`. Requires `place`.
  const kernel::Exact_vector& operator()(covering::Index v)
  {
    if (place_[v] == none) {
      images_.push_back(image((*vertices_)[v]));
      found_.push_back(v);
      place_[v] = std::uint32_t(images_.size() - 1);
    }
    return images_[place_[v]];
  }

  /// Returns the factor of all images. Requires `place`.
  kernel::Exact_number weight() const { return pose_->weight() * others_weight_; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t(0);

  kernel::Exact_vector image(const covering::Vertex& v)
  {
    if (!has_entries_) {
      for (int k = 0; k < 12; ++k) entry_[k] = is_weighted_ ? pose_->whole(k) * others_weight_ : pose_->whole(k);
      has_entries_ = true;
    }
    return kernel::image(v, entry_);
  }

  const std::vector<covering::Vertex>* vertices_;
  const kernel::Pose* pose_ = nullptr;
  kernel::Exact_number others_weight_ = 1;
  bool is_weighted_ = false, has_entries_ = false;
  std::array<kernel::Exact_number, 12> entry_;
  std::vector<std::uint32_t> place_;  // the number of each vertex's image, or `none`
  std::vector<std::uint32_t> found_;  // the vertices that have one
  std::deque<kernel::Exact_vector> images_;
};

}  // namespace tetracone::tetratree

#endif
