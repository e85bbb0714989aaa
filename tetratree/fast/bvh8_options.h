#ifndef TETRACONE_TETRATREE_FAST_BVH8_OPTIONS_H
#define TETRACONE_TETRATREE_FAST_BVH8_OPTIONS_H

#include <cstddef>

namespace tetracone::tetratree {

/// How the elements of a node of a `Bvh8` are parted. Under the first two, `Bvh8_treelet` parts nodes of up to 64
/// elements.
enum class Cuts {
  least_cost,  ///< by the better of the best cuts of the next two (SAH); one through the origin may cost up to 3 % more
  principal,   ///< by planes across the direction in which they spread most
  through_origin,  ///< by planes through the origin, the sides of cones, if all elements lie before it; else across the
                   ///< spread
  tetra_cones  ///< by the octants, then by the four children of a tetra-cone (JS08 Definition 4); the centroid decides
               ///< an element's cone
};

/// What can be chosen about a `Bvh8`. The default is the fastest choice known; no choice changes an answer.
struct Bvh8_options {
  Cuts cuts = Cuts::least_cost;

  /// The most parts of a node. Requires 2 to 8, and 8 for `Cuts::tetra_cones`.
  std::size_t parts = 8;

  /// A part of at most this many elements is a leaf. Requires at least 1.
  std::size_t leaf_size = 1;
};

/// Counts the cuts of a builder. Parts of two elements need no cut.
struct Cut_counts {
  std::size_t all = 0;             ///< cuts made so far
  std::size_t tried_cones = 0;     ///< cuts for which planes through the origin were tried
  std::size_t through_origin = 0;  ///< cuts by one of these planes

  Cut_counts& operator+=(const Cut_counts& other)
  {
    all += other.all;
    tried_cones += other.tried_cones;
    through_origin += other.through_origin;
    return *this;
  }
};

}  // namespace tetracone::tetratree

#endif
