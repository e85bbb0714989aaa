#ifndef TETRACONE_TETRATREE_DOOR_OVERLAP_H
#define TETRACONE_TETRATREE_DOOR_OVERLAP_H

#include <array>
#include <memory>
#include <string>

namespace tetracone {
namespace detail {
struct Overlap_data;
}

/// How much two placed solids overlap and touch. Each double is the one nearest to its fraction. A fraction is "n/d" or
/// "n", in lowest terms; it is reduced and written when it is asked for, since it may have many thousands of digits.
class Overlap {
 public:
  double volume = 0;                 ///< of the intersection of the interiors
  std::array<double, 3> centroid{};  ///< of that intersection; 0 where the volume is 0
  /// The sum of area times A's outward unit normal, over the area that faces of both share and A is beside on one side.
  std::array<double, 3> contact_vector{};
  /// Doubles that enclose the area that faces of both surfaces share: equal, or neighbours.
  std::array<double, 2> contact_area{};

  std::string exact_volume() const;                         ///< the volume as a fraction
  std::array<std::string, 3> exact_centroid() const;        ///< the centroid in fractions
  std::array<std::string, 3> exact_contact_vector() const;  ///< the contact vector in fractions

  std::shared_ptr<const detail::Overlap_data> data;  ///< the fractions, not reduced; null where all are 0
};

/// Lower and upper bounds of the volume and the centroid of the overlap of two placed solids.
struct Overlap_bounds {
  std::array<double, 2> volume{};                   ///< of the intersection of the interiors
  std::array<std::array<double, 2>, 3> centroid{};  ///< by coordinate; 0 where the volume is 0
};

}  // namespace tetracone

#endif
