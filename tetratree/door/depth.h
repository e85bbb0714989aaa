#ifndef TETRACONE_TETRATREE_DOOR_DEPTH_H
#define TETRACONE_TETRATREE_DOOR_DEPTH_H

#include <array>
#include <cstddef>
#include <string>

namespace tetracone {

/// How narrow a bracket of a depth is asked for, and for how much work.
struct Depth_options {
  double relative = 1e-9;      ///< the search ends at this width over the upper end
  std::size_t budget = 20000;  ///< the search ends after so many boxes of translations, whatever the width
};

/// A bracket of the length of the least translation of A after which the interiors of two solids share no point. The
/// solids may touch. All is 0 where the interiors share no point at the start.
struct Depth {
  double low = 0;                  ///< lower bound
  double high = 0;                 ///< upper bound: the length of `vector`, rounded up
  std::array<double, 3> vector{};  ///< the doubles nearest to a translation that parts the solids
  bool is_exact = true;            ///< no shorter translation parts the solids: this is proved

  std::string exact_square = "0";                             ///< the square of the vector's length, as a fraction
  std::array<std::string, 3> exact_vector = {"0", "0", "0"};  ///< the translation in fractions
};

}  // namespace tetracone

#endif
