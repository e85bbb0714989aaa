#ifndef TETRACONE_KERNEL_WIDE_POINTS_H
#define TETRACONE_KERNEL_WIDE_POINTS_H

#include "kernel/adaptive.h"

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetracone::kernel {

/// Points as the filter sees them, a rounded image and its error each, coordinate by coordinate: `count` doubles at each pointer, and
/// whatever may be read after them up to the next multiple of `block`.
struct Wide_points {
  static constexpr std::size_t block = 8;

  const double *x, *y, *z, *error;
  std::size_t count;
};

/// The same, owned.
class Point_columns {
 public:
  void clear() { count_ = 0; }
  void push_back(const Adaptive::Point_3& point)
  {
    if (count_ == columns_[0].size())
      for (auto& column : columns_) column.resize(std::max(2 * count_, Wide_points::block));
    for (int k = 0; k < 3; ++k) columns_[k][count_] = point.image[k];
    columns_[3][count_++] = point.error;
  }
  std::size_t size() const { return count_; }
  operator Wide_points() const { return {columns_[0].data(), columns_[1].data(), columns_[2].data(), columns_[3].data(), count_}; }

 private:
  std::array<std::vector<double>, 4> columns_;  // of a multiple of blocks
  std::size_t count_ = 0;
};

/// The signs of 64 numbers: a bit each. Neither bit: undecided.
struct Wide_signs {
  std::uint64_t positive = 0, negative = 0;

  Adaptive::Decision operator[](int k) const
  {
    if (positive >> k & 1) return CGAL::POSITIVE;
    if (negative >> k & 1) return CGAL::NEGATIVE;
    return std::nullopt;
  }
};
inline std::size_t words_of(std::size_t count) { return (count + 63) / 64; }

/// A triangle as the filter sees it: `error` of a, and the larger one of b and c.
struct Wide_triangle {
  Vertex a, b, c;
  double error_of_a, error_of_b_and_c;
};
using Filtered_volume_signs = void(const Wide_triangle& triangle, const Wide_points& points, Wide_signs* signs);

}  // namespace tetracone::kernel

#endif
