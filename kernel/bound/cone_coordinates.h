#ifndef TETRACONE_KERNEL_BOUND_CONE_COORDINATES_H
#define TETRACONE_KERNEL_BOUND_CONE_COORDINATES_H

#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/kernel/bound/cone_lattice.h"
#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace tetracone::kernel {

/// Coordinates of points along the rays of a cone: p = V0 + c_1 V_1 + c_2 V_2 + c_3 V_3, with V_i the vectors to
/// lattice points. A bounding tetrahedron has a plane that cuts ray i at length_i V_i. All points must lie on V0's side
/// of it: sum_i c_i / length_i <= 1, the sign of the barycentric coordinate at V0.
///
/// Sound: c_i = ((p - V0) . N_i) / D with N_i, D exact (products of integers below 2^13). So only p - V0, the products,
/// sums and the division round. Their errors are fractions of A_i = sum_k |p - V0|_k |N_ik| / D. With the largest A_i
/// of all points, sum_i `form_rounding` A_i / length_i is an upper bound of the error of the whole form. `bounded_by`
/// subtracts it from 1.
template <class B, bool sound>
class Cone_coordinates {
 public:
  // Both are proved in verify/proofs/bound_proofs.h.
  static constexpr B form_rounding = 16 * unit_roundoff<B>,  ///< upper bound of the form's error, relative to its terms
      one_rounding = 4 * unit_roundoff<B>;  ///< upper bound of the error of 1 less these errors, as computed

  /// Upper bound of the relative error of the distance from V0 to the plane through the unit points of the rays:
  /// verify/proofs/margin_proofs.h.
  static constexpr double height_rounding = 0x1p-36;

  /// Returns c_i of a point p relative to V0. `normal` and `scale` are N_i and D, divided by one factor.
  template <class Number>
  static Number coordinate(const std::array<Number, 3>& p, const std::array<Number, 3>& normal, const Number& scale)
  {
    return dot(p, normal) / scale;
  }

  /// Returns the form, which is 1 on the plane that cuts the rays at these lengths.
  template <class Number>
  static Number form(const std::array<Number, 3>& c, const std::array<Number, 3>& length)
  {
    return c[0] / length[0] + c[1] / length[1] + c[2] / length[2];
  }

  /// Returns the largest form that is accepted: 1 less the errors of the coordinates' terms.
  template <class Number>
  static Number allowed(const std::array<Number, 3>& shares)
  {
    return (((Number(1) - shares[0]) - shares[1]) - shares[2]) - Number(one_rounding);
  }

  /// Computes the coordinates of points, given relative to the origin, each at most `radius` away. Requires det[V1, V2,
  /// V3] > 0.
  Cone_coordinates(const std::array<Direction, 3>& ray, B step, std::span<const Bound_point<B>> relative, B radius)
  {
    std::array<Bound_point<B>, 3> v;
    for (int i = 0; i < 3; ++i) v[i] = {B(ray[i][0]), B(ray[i][1]), B(ray[i][2])};
    const std::array<Bound_point<B>, 3> normal = {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
    const B determinant = dot(v[0], normal[0]);
    volume_ = determinant * step * step * step / 6;
    for (int i = 0; i < 3; ++i) length_of_ray_[i] = std::sqrt(squared_length(v[i])) * step;
    const B scale = determinant * step;
    coordinates_.reserve(relative.size());
    for (const auto& p : relative) {
      std::array<B, 3> c;
      for (int i = 0; i < 3; ++i) {
        c[i] = coordinate(p, normal[i], scale);
        const B absolute =
            (std::abs(p[0] * normal[i][0]) + std::abs(p[1] * normal[i][1]) + std::abs(p[2] * normal[i][2])) / scale;
        largest_[i] = maximum(largest_[i], absolute);
      }
      coordinates_.push_back(c);
    }
    // The plane through the unit points of the rays has distance h from V0. Rays of length radius / h keep it beyond
    // all points.
    std::array<Bound_point<B>, 3> unit;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) unit[i][k] = v[i][k] * step / length_of_ray_[i];
    const Bound_point<B> plane = cross(difference(unit[1], unit[0]), difference(unit[2], unit[0]));
    const B height = std::abs(dot(plane, unit[0])) / std::sqrt(squared_length(plane));
    for (int i = 0; i < 3; ++i)
      isosceles_[i] = radius / height * (sound ? B(1 + height_rounding) : B(1)) / length_of_ray_[i];
  }

  /// True when the plane that cuts the rays at these lengths has all points on V0's side.
  bool bounded_by(const std::array<B, 3>& length) const
  {
    const auto share = [&](int i) { return form_rounding * largest_[i] / length[i]; };
    const B most = sound ? allowed(std::array{share(0), share(1), share(2)}) : B(1);
    for (const auto& c : coordinates_)
      if (!(form(c, length) <= most)) return false;
    return true;
  }

  /// Returns the lengths, in units of the V_i, of three equal edges that bound every point within the radius.
  const std::array<B, 3>& isosceles() const { return isosceles_; }

  /// Returns the volume of the tetrahedron cut off at these lengths.
  B volume(const std::array<B, 3>& length) const { return volume_ * length[0] * length[1] * length[2]; }

  /// Returns lengths that bound all points, of nearly the least volume. A pattern search over the two ratios of the
  /// lengths finds them; the third number follows from the farthest point. No edge grows beyond 4 times the isosceles
  /// ones. Requires that `start` bounds the points.
  std::array<B, 3> least_volume(const std::array<B, 3>& start) const
  {
    const auto lengths = [this](B x, B y) {
      // The rays have lengths in the ratio e^x : e^y : e^(-x-y), scaled until the farthest point lies on the plane.
      std::array<B, 3> length = {std::exp(x) / length_of_ray_[0], std::exp(y) / length_of_ray_[1],
                                 std::exp(-x - y) / length_of_ray_[2]};
      B farthest = 0;
      for (const auto& c : coordinates_) farthest = maximum(farthest, form(c, length));
      // The allowance is not below `bounded_by`'s: in a slender cone it is many u.
      for (int i = 0; i < 3; ++i)
        farthest += (sound ? form_rounding + unit_roundoff<B> : unit_roundoff<B>)*largest_[i] / length[i];
      for (B& l : length) l *= farthest * (1 + 64 * unit_roundoff<B>);
      return length;
    };
    std::array<B, 3> best = start;
    B best_volume = volume(start), x = 0, y = 0;
    const B widest = std::log(B(2));
    for (B stride = widest / 2; stride > B(1e-3); stride /= 2) {
      for (bool moved = true; moved;) {
        moved = false;
        const std::array<std::array<B, 2>, 6> moves = {
            {{stride, 0}, {-stride, 0}, {0, stride}, {0, -stride}, {stride, -stride}, {-stride, stride}}};
        for (const auto& [dx, dy] : moves) {
          if (std::abs(x + dx) > widest || std::abs(y + dy) > widest || std::abs(x + dx + y + dy) > widest) continue;
          const auto candidate = lengths(x + dx, y + dy);
          const B candidate_volume = volume(candidate);
          bool long_edge = false;
          for (int i = 0; i < 3; ++i) long_edge = long_edge || candidate[i] > 4 * isosceles_[i];
          // A volume of 0 means that no point is on the cone's side of V0, or that it underflowed.
          if (candidate_volume > 0 && candidate_volume < best_volume && !long_edge && bounded_by(candidate)) {
            best = candidate;
            best_volume = candidate_volume;
            x += dx;
            y += dy;
            moved = true;
            break;
          }
        }
      }
    }
    return best;
  }

 private:
  std::vector<std::array<B, 3>> coordinates_;
  std::array<B, 3> largest_{0, 0, 0}, length_of_ray_{}, isosceles_{};
  B volume_ = 0;
};

}  // namespace tetracone::kernel

#endif
