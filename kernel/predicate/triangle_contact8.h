#ifndef TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT8_H
#define TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT8_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/adaptive_bounds.h"
#include "tetracone/kernel/predicate/triangle_contact.h"
#include "tetracone/kernel/simd/simd.h"

#include <cstddef>
#include <cstdint>

/// The filter of `triangle_contact<Adaptive>`, eight pairs of triangles at once.
namespace tetracone::kernel {

/// Up to eight triangles of a body before it is placed, a lane each.
struct alignas(64) Triangles8 {
  static constexpr std::size_t count = 8;

  double corner[3][3][count] = {};  ///< coordinate k of corner c, in lanes: corner[c][k]

  /// Sets the triangle of a lane.
  void set(std::size_t lane, const Vertex& a, const Vertex& b, const Vertex& c)
  {
    for (int k = 0; k < 3; ++k) {
      corner[0][k][lane] = a[k];
      corner[1][k][lane] = b[k];
      corner[2][k][lane] = c[k];
    }
  }
};

/// The answers of signs in double about eight pairs of triangles. Lanes that are in neither set are undecided.
struct Triangle_contacts8 {
  unsigned apart = 0;     ///< lanes, as bits: the triangles share no point
  unsigned crossing = 0;  ///< lanes: they share a segment, and no corner of either is in the other's plane

  /// Edge sets, a byte each: of the segment's first end on p, on q, of its second on p, on q.
  alignas(64) std::uint64_t ends[Triangles8::count];

  /// Returns the answer of `triangle_contact` for a lane in `crossing`.
  Triangle_contact contact(std::size_t lane) const
  {
    const auto part = [&](int place) { return Edge_set(ends[lane] >> place & 0xff); };
    Triangle_contact segment;
    segment.add({part(0), part(8)});
    segment.add({part(16), part(24)});
    return segment;
  }
};

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/predicate/triangle_contact8_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Writes to `found` how triangle k of p under `pose_p` meets triangle k of q under `pose_q`, for every lane k. It is
/// exact where it decides. Requires sound floating point.
inline void triangle_contacts8(const Triangles8& p, const Pose& pose_p, const Triangles8& q, const Pose& pose_q,
                               Triangle_contacts8& found)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(triangle_contacts8_simd);
  fastest(p, pose_p, q, pose_q, found);
}

}  // namespace tetracone::kernel

#endif
