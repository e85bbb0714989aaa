#ifndef TETRACONE_TETRATREE_DOOR_OVERLAP_H
#define TETRACONE_TETRATREE_DOOR_OVERLAP_H

#include <array>
#include <string>

namespace tetracone {

/// How much two placed solids overlap and touch. Fractions are "n/d" or "n", in lowest terms; each double is the one
/// nearest to its fraction.
struct Overlap {
  double volume = 0;                 ///< of the intersection of the interiors
  std::array<double, 3> centroid{};  ///< of that intersection; 0 where the volume is 0
  /// The sum of area times A's outward unit normal, over the area that faces of both share and A is beside on one side.
  std::array<double, 3> contact_vector{};
  /// Doubles that enclose the area that faces of both surfaces share: equal, or neighbours.
  std::array<double, 2> contact_area{};

  std::string exact_volume = "0";                                     ///< the volume as a fraction
  std::array<std::string, 3> exact_centroid = {"0", "0", "0"};        ///< the centroid in fractions
  std::array<std::string, 3> exact_contact_vector = {"0", "0", "0"};  ///< the contact vector in fractions
};

}  // namespace tetracone

#endif
