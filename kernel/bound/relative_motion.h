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
struct alignas(32) Box_corners {
  using Row = std::array<double, 3>;
  float corner[3][lanes] = {};
  float reach = 0;  ///< upper bound of the magnitude of every coordinate of its points

  Box_corners() = default;

  /// The box of all c + sum_j s_j h_j with |s_j| <= 1, c the centre and h_j the half edges.
  Box_corners(const Row& centre, const std::array<Row, 3>& half_edge)
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

  explicit Box_corners(const Obb8& boxes, int lane) : Box_corners(centre_of(boxes, lane), half_edges_of(boxes, lane)) {}
};

/// The place of a body in the frame of another: the part of a `Box_map` that its motion needs.
struct alignas(32) Placement {
  double column[4][4];  ///< in double; the last is the offset, and the fourth entry of each is 0
  double scale;         ///< see `Relative_frame`
  double error;         ///< upper bound of the distance between an image by these columns and the exact one; infinite
                        ///< where unknown

  Placement() = default;
  explicit Placement(const Box_map& map) : scale(map.scale()), error(error_of(map))
  {
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) column[j][k] = map.column(j)[k];
  }

  /// Upper bound of the distance by which an error of 1 in each coordinate moves a point along an axis:
  /// verify/proofs/gap_proofs.h.
  static constexpr double position_norm = 2;

  /// Returns `error`: the map's error in three coordinates, and a few roundings in double. The rounded terms sum to at
  /// most |offset|_1 and three columns, each counted as 2 `scale`.
  static double error_of(const Box_map& map)
  {
    const double* offset = map.column(3);
    return position_norm * map.frame().error() +
           few_roundings * (6 * map.scale() + (std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2])));
  }
};

/// A motion in equal steps. Each step moves every point p of a body by L p + s. Columns 0 to 2 are L, column 3 is s.
struct alignas(32) Course {
  float column[4][4] = {};  ///< of the linear part, and the shift; the fourth entry of each is 0
  float size = 0;           ///< upper bound of the sum of all magnitudes

  /// The course that moves no point.
  Course() = default;

  /// The course whose step leads from one place to the other, each entry rounded.
  Course(const Placement& before, const Placement& after)
  {
    float sum = 0;
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        column[j][k] = to_float(after.column[j][k] - before.column[j][k]);
        sum += std::abs(column[j][k]);
      }
    size = sum * rounded_up;
  }

  /// Returns the course of A in the frame of B, at B's present place; this is the course of B in the frame of A.
  /// `other` places A in B's frame: a similarity whose `error` is at most 2^-24 of `scale`. The columns have an error
  /// of at most that fraction of the size, beside one rounding.
  Course reversed(const Placement& other) const
  {
    Course course;
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k)
        course.column[j][k] =
            -float(other.column[0][k] * double(column[j][0]) + other.column[1][k] * double(column[j][1]) +
                   other.column[2][k] * double(column[j][2]));
    // The image by a similarity is at most sqrt(3) times as long in |.|_1, times the scale.
    course.size = size * float(other.scale) * 2;
    return course;
  }

  /// Numbers of steps are multiples of it, so that floats hold their sums, up to `most_steps` + 1.
  static constexpr double least_step = 0x1p-10;
  /// The most steps for which a course is followed, in one motion and in all.
  static constexpr double most_steps = 0x1p12;
};

/// Upper bound of the rounding error of bounds of motions in float, relative to the entries of a step
/// (verify/proofs/gap_proofs.h). The linear entries count times the largest coordinate of the body. They and the
/// corners are rounded; products and sums have 4 roundings. The error of the length of the computed vector is covered
/// by `rounded_up`.
inline constexpr double motion_rounding = 16 * 0x1p-24;

/// Upper bound of the error of a length whose squares underflow: verify/proofs/reference_proofs.h.
inline constexpr double motion_underflow = 0x1p-60;

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/relative_motion_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Returns the number of steps that is nearest to the motion between two places, cut down to a multiple of
/// `Course::least_step`. Returns 0 below `least_step` and above `most_steps`. The number is no bound of anything.
inline double steps_along(const Course& course, const Placement& before, const Placement& after)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(steps_along_simd);
  return fastest(course, before, after);
}

/// Returns the stray. It is an upper bound of the distance between a point's place after the motion and the place that
/// `steps` steps of the course predict. It holds for all points p of `box` with |p_k| <= 1. The motion leads from the
/// point's exact image under `before` to its exact image under `after`. Infinite or undefined where nothing is known.
///
/// The bound is |D p + d| plus the errors of both images. D and d are the columns of `after` less those of `before`,
/// less `steps` times the course's. These are rounded a few times in double, which the placements' errors include, and
/// then to float. |D p + d| is convex, so it is largest at a corner of the box.
inline double stray_bound(const Course& course, double steps, const Placement& before, const Placement& after,
                          const Box_corners& box)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(stray_bound_simd);
  return fastest(course, steps, before, after, box);
}

/// Returns an upper bound of the distance by which a step of the course moves any point of the box.
inline double pace_bound(const Course& course, const Box_corners& box)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(pace_bound_simd);
  return fastest(course, box);
}

}  // namespace tetracone::kernel

#endif
