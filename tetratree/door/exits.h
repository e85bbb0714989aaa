#ifndef TETRACONE_TETRATREE_DOOR_EXITS_H
#define TETRACONE_TETRATREE_DOOR_EXITS_H

#include <string>

namespace tetracone {

/// How far a solid must be moved along a direction to leave another one, in lengths of the direction. Fractions are
/// "n/d" or "n", in lowest terms; each double is the one nearest to its fraction.
///
/// The solids may touch: interiors alone count. Both exits are 0 where the interiors share no point at the start.
struct Exits {
  double first = 0;  ///< the least s >= 0 at which the interiors share no point
  double last = 0;   ///< the least s >= 0 from which on they never share one again

  std::string exact_first = "0";  ///< the first exit as a fraction
  std::string exact_last = "0";   ///< the last exit as a fraction
};

}  // namespace tetracone

#endif
