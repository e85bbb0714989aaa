#ifndef TETRACONE_VERIFY_PROOFS_OBB8_DISTANCE_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_OBB8_DISTANCE_PROOFS_H

#include "tetracone/kernel/bound/obb8_distance.h"
#include "verify/proofs/box_test.h"
#include "verify/proofs/proof.h"

#include <type_traits>

/// The constants of kernel/bound/obb8_distance.h, from kernel/bound/obb8_distance_simd.inl itself.
namespace tetracone::verify::proofs {

namespace detail {

/// The box whose axes are the frame in which a direction between two boxes is sought.
enum class Frame_of { eight, single_box };

/// Numbers of inputs of an expression: those of a comparison, and the components of a direction in the frame.
inline constexpr std::size_t way_in_frame = Box_test<double, true>::end, distance_inputs = way_in_frame + 3;

/// Returns the gap along a direction, times its length, without slack; `none` is 0.
template <bool fused, class Number>
Number gap_of_way(const std::vector<Number>& in, Frame_of frame, const Number& none)
{
  using Floats = Axis_number<Number, fused>;
  const Box_test<Number, fused> test(in, Edges::carried, false, none);
  const auto ways = kernel::HWY_NAMESPACE::ways_in_frames<true>(test);
  const bool is_own = frame == Frame_of::eight;
  Floats g[3], room[3], f[3], r[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Floats single(test.box.extent[i]);
    g[i] = Floats(in[way_in_frame + i]);
    f[i] = is_own ? single : test.boxes.extent[i];
    room[i] = kernel::HWY_NAMESPACE::room_along(is_own ? ways.t[i] : ways.s[i], is_own ? test.boxes.extent[i] : single,
                                                Floats(none));
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = is_own ? ways.r[i][j] : ways.r[j][i];
  }
  return kernel::HWY_NAMESPACE::gap_of_way(g, room, g, f, r).one();
}

/// Returns the rounding error of that gap, relative to the sum of the direction's components times M. M is the sum of
/// the centres' coordinates and the extents. A slice has one component of the direction, and the entries that lead
/// there from a term of M. The component is the first, which has the most roundings.
template <bool fused>
Rational rounding_of_way(Frame_of frame)
{
  using Place = Box_test<double, true>;
  std::vector<Slice> slices;
  const auto add = [&](const std::vector<int>& places) {
    slices.push_back(slice_of(distance_inputs, places));
    slices.back()[way_in_frame] = 1;
  };
  // Along axis 0 of the eight boxes, or along edge 0, which the directions turn from its first coordinate.
  for (int k = 0; k < 3; ++k)
    for (const int centre : {Place::single_centre, Place::centre}) {
      if (frame == Frame_of::eight)
        add({centre + k, Place::axis + k});
      else
        add({centre + k, Place::edge, Place::direction + 3 * k});
    }
  add({frame == Frame_of::eight ? Place::extent : Place::single_extent});
  for (int q = 0; q < 3; ++q)
    add({frame == Frame_of::eight ? Place::single_extent : Place::extent, Place::axis + q, Place::edge,
         Place::direction + 3 * q});
  return largest(slice_errors<Relative_32>(
      [frame](const auto& in) {
        return gap_of_way<fused>(in, frame, std::decay_t<decltype(in[0])>(*in[0].script(), "0"));
      },
      slices));
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds obb8_distance_proofs()
{
  using detail::Frame_of;
  const double u = kernel::unit_roundoff<float>;
  const Rational roundoff(u), computed = 1 + Rational(0x1p-16), defect(kernel::axis_defect),
                              carried = defect + 3 * roundoff * computed;
  const std::string file = "kernel/bound/obb8_distance.h";
  Proved_bounds bounds;

  // A sum over the entries of a row of the directions, a rotation, counts root 3 times. Axes have defects. Along an
  // axis of the eight boxes, a box reaches farther by their defect. Along an edge of the single box it reaches farther
  // by the edges' defect. Edges of any map are rounded to float.
  const auto rounding = [](Frame_of frame) {
    return std::max(detail::rounding_of_way<true>(frame), detail::rounding_of_way<false>(frame));
  };
  const Rational of_eight = root_3() * rounding(Frame_of::eight) + std::max(defect, roundoff),
                 of_single_box = root_3() * rounding(Frame_of::single_box) + carried;
  bounds.push_back({"distance_rounding", file, Rational(kernel::distance_rounding),
                    std::max(of_eight, of_single_box) * computed, u, 1.59, "gappa"});

  // The square of the length of a way of such axes is off by 3 times their defect. A quotient of squares has 5
  // roundings. The root halves all of these, and is rounded. The product with the stretch is rounded once, and the
  // stretch twice.
  const Rational roundings = power(1 + roundoff, 1 + 1 + 2 + 3), length = 1 + Rational(3, 2) * carried;
  bounds.push_back({"distance_shrink", file, 1 - Rational(kernel::distance_shrink), 1 - 1 / (length * roundings), u,
                    2.73, "rationals"});
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
