#ifndef TETRACONE_TETRATREE_DOOR_OVERLAP_H
#define TETRACONE_TETRATREE_DOOR_OVERLAP_H

#include <array>
#include <cstddef>
#include <memory>
#include <string>

namespace tetracone {
namespace detail {
struct Overlap_data;
}

/// How much two placed solids overlap and touch, in the units of the placed coordinates. Each double is the one nearest
/// to its fraction, and infinite where that is beyond the doubles. A fraction is "n/d" or "n", in lowest terms. It is
/// reduced and written when it is asked for, since it may have many thousands of digits.
class Overlap {
 public:
  double volume = 0;                 ///< of the intersection of the interiors
  std::array<double, 3> centroid{};  ///< of that intersection; 0 where the volume is 0
  /// The integral of A's outward unit normal over the area that both surfaces share, without area that has A on both
  /// sides.
  std::array<double, 3> contact_vector{};
  /// Doubles that enclose the area that faces of both surfaces share: equal, or neighbours.
  std::array<double, 2> contact_area{};

  std::string exact_volume() const;                         ///< the volume as a fraction
  std::array<std::string, 3> exact_centroid() const;        ///< the centroid in fractions
  std::array<std::string, 3> exact_contact_vector() const;  ///< the contact vector in fractions

  std::shared_ptr<const detail::Overlap_data> data;  ///< the fractions, not reduced; if null, all are 0
};

/// Lower and upper bounds of the volume and the centroid of the overlap of two placed solids, in the units of the
/// placed coordinates.
struct Overlap_bounds {
  std::array<double, 2> volume{};                   ///< of the intersection of the interiors
  std::array<std::array<double, 2>, 3> centroid{};  ///< by coordinate; 0 where the volume is 0
};

/// How far a solid must be moved along a direction to leave another one, in lengths of the direction. Fractions are
/// "n/d" or "n", in lowest terms; each double is the one nearest to its fraction, infinite beyond the doubles.
///
/// The solids may touch: interiors alone count. Both exits are 0 where the interiors share no point at the start.
struct Exits {
  double first = 0;  ///< the least s >= 0 at which the interiors share no point
  double last = 0;   ///< the least s >= 0 from which on they never share one again

  std::string exact_first = "0";  ///< the first exit as a fraction
  std::string exact_last = "0";   ///< the last exit as a fraction
};

/// How narrow a bracket of a depth is asked for, and for how much work.
struct Depth_options {
  /// The search ends when (high - low) / high is at most this; in [0, 1), else `depth` throws Error.
  double relative = 1e-9;
  std::size_t budget = 100000;  ///< the search ends after this number of boxes of translations, whatever the width
};

/// A bracket of the length of the least translation of A after which the interiors of two solids share no point. The
/// solids may touch. All is 0 where the interiors share no point at the start. Lengths are in the units of the placed
/// coordinates.
struct Depth {
  double low = 0;                  ///< lower bound
  double high = 0;                 ///< upper bound: the length of `exact_vector`, rounded up
  std::array<double, 3> vector{};  ///< the doubles nearest to a translation that parts the solids
  bool is_exact = true;            ///< no shorter translation parts the solids: this is proved

  std::string exact_square = "0";                             ///< the squared length of `exact_vector`, as a fraction
  std::array<std::string, 3> exact_vector = {"0", "0", "0"};  ///< the translation in fractions
};

}  // namespace tetracone

#endif
