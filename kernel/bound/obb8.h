#ifndef TETRACONE_KERNEL_BOUND_OBB8_H
#define TETRACONE_KERNEL_BOUND_OBB8_H

#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

/// Comparisons of eight oriented boxes with one, at once.
///
/// Boxes are in a body's local units, relative to the origin of their node, in float. Every comparison carries a slack,
/// so that a box that is found apart is apart in exact arithmetic. The comparison itself is in obb8_overlap.h.
namespace tetracone::kernel {

inline constexpr std::size_t lanes = 8;

/// Eight boxes, a lane each. Box k is {c + sum_i s_i a_i, |s_i| <= e_i}. Its centre is c = origin + centre[.][k], its
/// axes are a_i = axis[i][.][k], and e_i = extent[i][k]. The axes are nearly orthonormal: a_i . a_j differs from 1 or 0
/// by at most `axis_defect`.
struct alignas(32) Obb8 {
  float centre[3][lanes], axis[3][3][lanes], extent[3][lanes];
  float origin[3];
  float reach;           ///< upper bound of |c|_2 + sum_i e_i of every lane, c relative to the origin
  int lane_count;        ///< number of lanes that hold a box, the first ones
  std::uint32_t marked;  ///< lanes, as bits, that the keeper of the boxes has marked
};
/// Upper bound of the difference of a_i . a_j from 1 or 0 for the axes of a box.
inline constexpr double axis_defect = 0x1p-21;

/// Returns the centre of box `lane`, in the body's local units.
inline std::array<double, 3> centre_of(const Obb8& boxes, int lane)
{
  std::array<double, 3> centre;
  for (int k = 0; k < 3; ++k) centre[k] = double(boxes.origin[k]) + double(boxes.centre[k][lane]);
  return centre;
}

/// Returns the half edges of box `lane`: its axes, times its extents.
inline std::array<std::array<double, 3>, 3> half_edges_of(const Obb8& boxes, int lane)
{
  std::array<std::array<double, 3>, 3> half_edge;
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k) half_edge[j][k] = double(boxes.extent[j][lane]) * double(boxes.axis[j][k][lane]);
  return half_edge;
}

/// A point's coordinates s along axes of defect d differ from a_i . y by at most 3 d (1 + 4 d) max_k |a_k . y|. The
/// factor 4 covers that and rounding in double. |a_i|_1 is below 2: an error of each coordinate moves a point along an
/// axis by at most this factor. Both are proved in verify/proofs/separation_proofs.h.
inline constexpr double axis_defect_factor = 4, axis_norm_1 = 2;

/// The place of a triangle in its box, in 16 bits; 0 for a box of something else. Along axes 1 and 2, it lies within
/// the corners (-e1, -e2), (e1, -e2) and (apex e1, e2), up to `apex_tolerance` (e1 + e2).
using Apex_code = std::uint16_t;
inline constexpr float no_apex = 2;
inline constexpr double apex_tolerance = 0x1p-15;
inline constexpr int apex_steps = 32767;  ///< from -1 to 0, and from 0 to 1
/// Returns the apex of a code, from -1 to 1; `no_apex` for the code 0.
inline float apex_of(Apex_code code)
{
  return code == 0 ? no_apex : float(int(code) - apex_steps - 1) * (1 / float(apex_steps));
}

/// A box of the other body, carried into the frame of the eight and relative to their origin. It is a parallelepiped
/// with centre c and half-edges extent[j] * edge[j]. edge[j] has a length of nearly 1 where `slack` is finite;
/// normal[j] = edge[j+1] x edge[j+2]. For a similarity the edges are nearly orthonormal, and normals are not used.
/// `apex` is the place of a triangle in the box, if it holds one. `slack` is an upper bound of all rounding, for each
/// axis tried: see `obb8_slack`.
struct Single_box {
  alignas(16) float edge[3][4];  // the fourth is not used
  float centre[3], extent[3], normal[3][3], slack, apex = no_apex;
};

/// Upper bound of the error of a comparison of boxes, relative to M: roundings, and the axes' defect
/// (verify/proofs/obb8_proofs.h). M = |t|_1 + reach + sum of extents. t is the single box's centre relative to the
/// node's origin, and reach an upper bound of |c|_2 + sum_i e_i of every lane.
inline constexpr double box_rounding = 80 * 0x1p-24;

/// Upper bound of the error of a comparison with a box that a similarity carries, relative to reach + sum of extents
/// (verify/proofs/obb8_proofs.h). Where |t|_2 is above that sum, the boxes are apart, whatever is computed. The edges
/// are carried in float.
inline constexpr double carried_box_rounding = 192 * 0x1p-24;

/// Upper bound of |axis|_1 of every axis tried. An error of each coordinate of a point moves it along an axis by at
/// most this factor: verify/proofs/obb8_proofs.h.
inline constexpr double position_factor = 8;

/// A factor that covers the roundings of a bound made of a few floats: verify/proofs/margin_proofs.h.
inline constexpr float rounded_up = 1 + 0x1p-20f;

/// Upper bound of the error of a comparison by products of floats that underflow: verify/proofs/margin_proofs.h.
inline constexpr float box_underflow = 0x1p-100f;

/// Returns the slack of a test among boxes of a node; `m` is M of `box_rounding`. `position_error` is an upper bound of
/// the error of a coordinate of any point of the single box.
inline float obb8_slack(double m, double position_error)
{
  return static_cast<float>(box_rounding * m + position_factor * position_error) * rounded_up + box_underflow;
}

/// A `Relative_frame` made ready to carry boxes.
class Box_map {
 public:
  Box_map() : column_{}, direction_{} {}

  explicit Box_map(const Relative_frame& frame) : frame_(frame) { make_ready(); }

  /// The map from B's local units to A's: see `Relative_frame`.
  Box_map(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b) : frame_(a, in_a, b, in_b)
  {
    make_ready();
  }
  Box_map(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b, const Origin_offset& d)
      : frame_(a, in_a, b, in_b, d)
  {
    make_ready();
  }

  const Relative_frame& frame() const { return frame_; }
  bool is_similarity() const { return frame_.is_similarity(); }

  /// Returns the factor by which a similarity lengthens.
  double scale() const { return frame_.scale(); }

  /// Returns column j of the map, divided by `scale`.
  const float* direction(int j) const { return direction_[j]; }

  /// Returns column j of the map; column 3 is its offset.
  const double* column(int j) const { return column_[j]; }
  /// Returns an upper bound of the factor by which a similarity lengthens.
  float stretch() const { return stretch_; }

  /// Returns the slack for a box that a similarity carries, wherever it is: see `obb8_slack`.
  float slack(float reach, float size) const { return float(carried_box_rounding) * (reach + size) + position_slack_; }

  /// Returns box `lane` of `from`, carried into the frame of `boxes` by any map.
  Single_box operator()(const Obb8& boxes, const Obb8& from, int lane) const
  {
    Single_box box;
    double sum = boxes.reach;
    for (int j = 0; j < 3; ++j) {
      const auto edge =
          frame_.direction(std::array{from.axis[j][0][lane], from.axis[j][1][lane], from.axis[j][2][lane]});
      const double square = edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2], length = std::sqrt(square);
      // Below that, products underflow and `edge` would not be of length 1: no lane is found apart.
      if (!(square >= 0x1p-900)) sum = std::numeric_limits<double>::infinity();
      for (int i = 0; i < 3; ++i) box.edge[j][i] = float(edge[i] / length);
      sum += box.extent[j] = float(double(from.extent[j][lane]) * length) * rounded_up;
    }
    for (int j = 0; j < 3; ++j) {
      const auto &p = box.edge[(j + 1) % 3], &q = box.edge[(j + 2) % 3];
      const auto normal = cross(std::array{p[0], p[1], p[2]}, std::array{q[0], q[1], q[2]});
      for (int i = 0; i < 3; ++i) box.normal[j][i] = normal[i];
    }
    place_centre(box, sum, boxes, from, lane);
    return box;
  }

 private:
  void make_ready()
  {
    const auto& m = frame_.linear();
    const double shrink = 1 / frame_.scale();
    stretch_ = float(frame_.scale()) * rounded_up;
    position_slack_ = obb8_slack(0, frame_.error());
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        direction_[j][i] = float(m[i][j] * shrink);
        column_[j][i] = m[i][j];
      }
      direction_[j][3] = 0;
      column_[j][3] = 0;
    }
    for (int i = 0; i < 3; ++i) column_[3][i] = frame_.offset()[i];
    column_[3][3] = 0;
  }

  void place_centre(Single_box& box, double sum, const Obb8& boxes, const Obb8& from, int lane) const
  {
    const auto centre = frame_(centre_of(from, lane));
    for (int i = 0; i < 3; ++i) {
      const double t = centre[i] - double(boxes.origin[i]);
      box.centre[i] = float(t);
      sum += std::abs(t);
    }
    box.slack = obb8_slack(sum, frame_.error());
  }

  Relative_frame frame_;
  alignas(32) double column_[4][4];  // of each, the fourth is not used
  alignas(16) float direction_[3][4];
  float stretch_ = 1, position_slack_ = 0;
};

}  // namespace tetracone::kernel

#endif
