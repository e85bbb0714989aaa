#ifndef TETRACONE_TETRATREE_FAST_CORNER_SET_H
#define TETRACONE_TETRATREE_FAST_CORNER_SET_H

#include "tetracone/tetratree/fast/bvh8_elements.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// The corners of a few elements, each once, in local units.
class Corner_set {
 public:
  /// Collects the corners of elements first .. last.
  void gather(const Bvh8_elements& elements, Index first, Index last)
  {
    vertices_.clear();
    begins_.clear();
    for (Index e = first; e < last; ++e) {
      begins_.push_back(std::uint32_t(vertices_.size()));
      elements.for_vertices(elements[e], [&](Index v) { vertices_.push_back(v); });
    }
    begins_.push_back(std::uint32_t(vertices_.size()));
    number_vertices(elements);
  }

  /// Returns the corners, in the order in which elements first name them.
  std::span<const kernel::Vector> points() const { return points_; }

  /// Returns the corners of the k-th element, as numbers into `points`.
  std::span<const std::uint32_t> of(std::size_t k) const
  {
    return std::span(vertices_).subspan(begins_[k], begins_[k + 1] - begins_[k]);
  }

 private:
  /// Numbers the vertices by a hash table at most half full (linear probing).
  void number_vertices(const Bvh8_elements& elements)
  {
    const int bits = int(std::bit_width(vertices_.size())) + 1;
    places_.assign(std::size_t(1) << bits, {covering::none, 0});
    points_.clear();
    for (std::uint32_t& v : vertices_) {
      std::size_t place = (v * 0x9e3779b1u) >> (32 - bits);
      while (places_[place].vertex != covering::none && places_[place].vertex != v)
        place = (place + 1) & (places_.size() - 1);
      if (places_[place].vertex == covering::none) {
        places_[place] = {v, std::uint32_t(points_.size())};
        points_.push_back(elements.local(v));
      }
      v = places_[place].number;
    }
  }

  struct Place {
    Index vertex;
    std::uint32_t number;
  };
  std::vector<std::uint32_t> vertices_, begins_;
  std::vector<Place> places_;
  std::vector<kernel::Vector> points_;
};

}  // namespace tetracone::tetratree

#endif
