#ifndef TETRACONE_KERNEL_WIDE_BOXES_H
#define TETRACONE_KERNEL_WIDE_BOXES_H

#include <array>
#include <cstdint>

/// Eight oriented boxes against one, at once.
///
/// Boxes live in a body's local units, relative to the origin of their node, in float; every comparison carries a slack, so that a box
/// that is said to be apart is apart in exact arithmetic. The eight lanes are written with the compilers' vector types and compiled for
/// several instruction sets; each lane does the same IEEE operations on all of them, so results are the same bit for bit.
namespace tetracone::kernel {

inline constexpr int lanes = 8;
using Lanes = float __attribute__((vector_size(4 * lanes)));
using Lane_bits = std::int32_t __attribute__((vector_size(4 * lanes)));

/// Box k is {c + sum_i s_i a_i, |s_i| <= e_i} with centre c = centre[.][k], nearly orthonormal axes a_i = axis[i][.][k] and
/// e_i = extent[i][k]. "Nearly": a_i . a_j differs from 1 or 0 by at most `axis_defect`.
struct Wide_boxes {
  Lanes centre[3], axis[3][3], extent[3];
};
inline constexpr double axis_defect = 0x1p-21;

/// One box of the other body, carried into the frame of the eight: a parallelepiped of centre c and half-edges extent[j] * edge[j], edge[j] of
/// length nearly 1; normal[j] = edge[j+1] x edge[j+2]. For a similarity the edges are nearly orthonormal, and normals are not used.
/// `slack` bounds, for each axis tried, all rounding: see `wide_slack`.
struct Single_box {
  float centre[3], edge[3][3], normal[3][3], extent[3], slack;
};

/// The slack of a test among boxes of a node. With M = |t|_1 + reach + sum of extents, t the single box's centre relative to the node's
/// origin and reach a bound on |c_k| + sum_i e_i of every lane, each side of each of the 15 inequalities is a sum of at most
/// six terms below 2 M, each rounded at most 6 times (a dot product of three, a product, two sums) on top of the roundings of its
/// factors to float (1 each) and of the axes' defect (8 u): below 60 u M in all, both sides together. `position_error`
/// bounds how far, in one coordinate, any point of the single box is from where it belongs; no axis is longer than sqrt(3) (1 + 2^-20).
/// The last term is for what underflows.
inline float wide_slack(double m, double position_error)
{
  return static_cast<float>(64 * 0x1p-24 * m + 8 * position_error) * (1 + 0x1p-20f) + 0x1p-100f;
}

namespace wide {

// All of these are inlined: how such vectors would be passed does not matter.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

[[gnu::always_inline]] inline Lanes all(float x) { return Lanes{x, x, x, x, x, x, x, x}; }
[[gnu::always_inline]] inline Lanes absolute(Lanes x)
{
  return reinterpret_cast<Lanes>(reinterpret_cast<Lane_bits>(x) & 0x7fffffff);
}
[[gnu::always_inline]] inline unsigned lanes_set(Lane_bits mask)
{
  const Lane_bits bit{1, 2, 4, 8, 16, 32, 64, 128};
  mask &= bit;
  using Halves = std::int32_t __attribute__((vector_size(16)));
  const Halves low{mask[0], mask[1], mask[2], mask[3]}, high{mask[4], mask[5], mask[6], mask[7]};
  const Halves either = low | high;
  return unsigned(either[0] | either[1] | either[2] | either[3]);
}

/// The lanes whose box may meet the single box, as bits: separating axes are the normals of both and the 9 cross products of edges.
template <bool similarity>
[[gnu::always_inline]] inline unsigned overlapping(const Wide_boxes& boxes, const Single_box& box)
{
  const Lanes slack = all(box.slack);
  const Lanes x = all(box.centre[0]) - boxes.centre[0], y = all(box.centre[1]) - boxes.centre[1], z = all(box.centre[2]) - boxes.centre[2];
  Lanes t[3], r[3][3], absolute_r[3][3], n[3][3];
  Lane_bits apart{};
  for (int i = 0; i < 3; ++i) {
    t[i] = x * boxes.axis[i][0] + y * boxes.axis[i][1] + z * boxes.axis[i][2];
    for (int j = 0; j < 3; ++j) {
      r[i][j] = boxes.axis[i][0] * box.edge[j][0] + boxes.axis[i][1] * box.edge[j][1] + boxes.axis[i][2] * box.edge[j][2];
      absolute_r[i][j] = absolute(r[i][j]);
    }
    const Lanes reach = boxes.extent[i] + (absolute_r[i][0] * box.extent[0] + absolute_r[i][1] * box.extent[1] + absolute_r[i][2] * box.extent[2]) + slack;
    apart |= absolute(t[i]) > reach;
  }
  for (int j = 0; j < 3; ++j) {
    // The normal of the single box's face j.
    Lanes distance, reach;
    if constexpr (similarity) {
      distance = t[0] * r[0][j] + t[1] * r[1][j] + t[2] * r[2][j];
      reach = boxes.extent[0] * absolute_r[0][j] + boxes.extent[1] * absolute_r[1][j] + boxes.extent[2] * absolute_r[2][j] + all(box.extent[j]);
    } else {
      for (int i = 0; i < 3; ++i)
        n[i][j] = boxes.axis[i][0] * box.normal[j][0] + boxes.axis[i][1] * box.normal[j][1] + boxes.axis[i][2] * box.normal[j][2];
      distance = t[0] * n[0][j] + t[1] * n[1][j] + t[2] * n[2][j];
      const float height = box.edge[j][0] * box.normal[j][0] + box.edge[j][1] * box.normal[j][1] + box.edge[j][2] * box.normal[j][2];
      for (int i = 0; i < 3; ++i) n[i][j] = absolute(n[i][j]);
      reach = boxes.extent[0] * n[0][j] + boxes.extent[1] * n[1][j] + boxes.extent[2] * n[2][j] + all(box.extent[j] * (height < 0 ? -height : height));
    }
    apart |= absolute(distance) > reach + slack;
  }
  for (int i = 0; i < 3; ++i) {
    const int l = (i + 1) % 3, m = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      // a_i x edge_j, with components 0, -r[m][j], r[l][j] along a_i, a_l, a_m; edges k of the box project on it as normals do on a_i.
      const int k = (j + 1) % 3, o = (j + 2) % 3;
      const Lanes distance = t[m] * r[l][j] - t[l] * r[m][j];
      const Lanes own = boxes.extent[l] * absolute_r[m][j] + boxes.extent[m] * absolute_r[l][j];
      const Lanes other = similarity ? box.extent[k] * absolute_r[i][o] + box.extent[o] * absolute_r[i][k] : box.extent[k] * n[i][o] + box.extent[o] * n[i][k];
      apart |= absolute(distance) > own + other + slack;
    }
  }
  return ~lanes_set(apart) & 0xffu;
}

#pragma GCC diagnostic pop

#if defined(__x86_64__) && defined(__GNUC__)
template <bool similarity>
[[gnu::target("avx2")]] inline unsigned overlapping_avx2(const Wide_boxes& boxes, const Single_box& box)
{
  return overlapping<similarity>(boxes, box);
}
#endif
template <bool similarity>
inline unsigned overlapping_anywhere(const Wide_boxes& boxes, const Single_box& box)
{
  return overlapping<similarity>(boxes, box);
}

}  // namespace wide

/// The lanes whose box may meet the single box.
using Overlapping = unsigned (*)(const Wide_boxes& boxes, const Single_box& box);

/// The fastest of the ways that this processor has; all give the same bits.
inline Overlapping overlapping_boxes(bool similarity)
{
#if defined(__x86_64__) && defined(__GNUC__)
  static const bool avx2 = __builtin_cpu_supports("avx2");
  if (avx2) return similarity ? wide::overlapping_avx2<true> : wide::overlapping_avx2<false>;
#endif
  return similarity ? wide::overlapping_anywhere<true> : wide::overlapping_anywhere<false>;
}

}  // namespace tetracone::kernel

#endif
