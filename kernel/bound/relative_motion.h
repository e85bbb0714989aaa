#ifndef TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_H
#define TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tetracone::kernel {

/// The corners of a box that holds a body, in its local units.
struct alignas(32) Body_box {
  using Row = std::array<double, 3>;
  float corner[3][lanes] = {};
  float reach = 0;  ///< at least the magnitude of every coordinate of its points

  Body_box() = default;

  /// All c + sum_j s_j h_j with |s_j| <= 1, c the centre and h_j the half edges.
  Body_box(const Row& centre, const std::array<Row, 3>& half_edge)
  {
    for (int k = 0; k < 3; ++k) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        double x = centre[k];
        for (std::size_t j = 0; j < 3; ++j) x += lane >> j & 1 ? half_edge[j][k] : -half_edge[j][k];
        corner[k][lane] = float(x);
      }
      const double most =
          std::abs(centre[k]) + std::abs(half_edge[0][k]) + std::abs(half_edge[1][k]) + std::abs(half_edge[2][k]);
      reach = maximum(reach, float(most) * rounded_up);
    }
  }

  explicit Body_box(const Obb8& boxes, int lane)
  {
    std::array<Row, 3> half_edge;
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) half_edge[j][k] = double(boxes.extent[j][lane]) * double(boxes.axis[j][k][lane]);
    *this = Body_box(centre_of(boxes, lane), half_edge);
  }
};

/// Where a body is in the frame of another: a `Box_map`, as far as its motion is concerned.
struct alignas(32) Placement {
  double column[4][4];  ///< in double, the last the offset; of each the fourth is 0
  double scale;         ///< see `Relative_frame`
  double error;         ///< at least how far an image by these columns is from the exact one; infinite where unknown

  Placement() = default;
  explicit Placement(const Box_map& map) : scale(map.scale()), error(error_of(map))
  {
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) column[j][k] = map.column(j)[k];
  }

  /// Above what an error of each coordinate of a point moves it along an axis.
  static constexpr double position_norm = 2;

  /// Of an image in double: the map's, in three coordinates, and few roundings of terms that are at most the offset and
  /// three times twice a column.
  static double error_of(const Box_map& map)
  {
    const double* offset = map.column(3);
    return position_norm * map.frame().error() +
           few_roundings * (6 * map.scale() + (std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2])));
  }
};

/// A motion that goes on by the same step: each takes every point p of a body on by linear p + shift.
struct alignas(32) Course {
  float column[4][4] = {};  ///< of the linear part, and the shift; of each the fourth is 0
  float size = 0;           ///< above the sum of all magnitudes

  /// None: of steps that take no point anywhere.
  Course() = default;

  /// By the step between two places, each entry rounded.
  Course(const Placement& before, const Placement& after)
  {
    float sum = 0;
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        column[j][k] = float(after.column[j][k] - before.column[j][k]);
        sum += std::abs(column[j][k]);
      }
    size = sum * rounded_up;
  }

  /// How the other body seems to go, in the frame of the one that is on the course as it is now, where that one's own
  /// points are; `other` is the other's place there, a similarity of which `error` is at most 2^-24 of `scale`. So much
  /// columns are off at most, a share of the size, beside one rounding.
  Course reversed(const Placement& other) const
  {
    Course course;
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k)
        course.column[j][k] =
            -float(other.column[0][k] * double(column[j][0]) + other.column[1][k] * double(column[j][1]) +
                   other.column[2][k] * double(column[j][2]));
    // A similarity's image is at most sqrt(3) times as long in |.|_1, times the scale.
    course.size = size * float(other.scale) * 2;
    return course;
  }

  /// Steps come in parts of that size, so that floats hold their sums, up to `most_steps` and one more.
  static constexpr double least_step = 0x1p-10, most_steps = 0x1p12;
};

/// What bounds of motions lose in float, a share of the entries of a step, of which the linear ones count as often as
/// the body reaches: they and corners are rounded, products and sums by 4. The length of what is computed is off by less
/// than `rounded_up`.
inline constexpr double motion_rounding = 16 * 0x1p-24;

/// Above what a length loses where squares underflow.
inline constexpr double motion_underflow = 0x1p-60;

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/relative_motion_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// How many steps of the course the way between two places is most like, a multiple of `Course::least_step`; 0 where it
/// leads elsewhere. Nothing is certain about it.
inline double steps_along(const Course& course, const Placement& before, const Placement& after)
{
  using Function = double(const Course&, const Placement&, const Placement&);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(steps_along_simd));
  return fastest(course, before, after);
}

/// At least how far any point p of the box with |p_k| <= 1 is from where so many steps of the course would have taken it
/// when it has gone from its image under the exact map of the one place to that of the other. Infinite or undefined
/// where nothing is known.
///
/// In double, that is D p + d and what the images are off by, D and d the differences of columns, the course's taken
/// off: these are rounded a few times in double, which is among the placements' errors too, and then to float. |D p + d|
/// is convex, so that it is largest at a corner.
inline double stray_bound(const Course& course, double steps, const Placement& before, const Placement& after,
                          const Body_box& box)
{
  using Function = double(const Course&, double, const Placement&, const Placement&, const Body_box&);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(stray_bound_simd));
  return fastest(course, steps, before, after, box);
}

/// At least how far a step of the course takes any point of the box.
inline double pace_bound(const Course& course, const Body_box& box)
{
  using Function = double(const Course&, const Body_box&);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(pace_bound_simd));
  return fastest(course, box);
}

}  // namespace tetracone::kernel

#endif
