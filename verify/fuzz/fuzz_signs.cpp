// Makes any five points and two poses. Every sign of the adaptive kernel must be that of rational arithmetic, and so
// must the contact of a segment and a triangle.

#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/signs.h"
#include "verify/fuzz/doubles.h"
#include "verify/fuzz/fuzz_targets.h"

#include <array>
#include <cstdint>
#include <cstdlib>

using namespace tetracone::kernel;

void tetracone::verify::fuzz_signs(const std::uint8_t* data, std::size_t size)
{
  // Images must stay finite: a pose multiplies three coordinates and adds.
  tetracone::verify::Doubles doubles(data, size, 0x1p500);
  std::array<double, 12> entries_a, entries_b;
  for (double& x : entries_a) x = doubles.next();
  for (double& x : entries_b) x = doubles.next();
  const Pose pose_a(entries_a), pose_b(entries_b);
  if (pose_a.determinant_sign() == ZERO || pose_b.determinant_sign() == ZERO) return;
  const Frame<Adaptive> adaptive_a(pose_a), adaptive_b(pose_b);
  const Frame<Rational_kernel> rational_a(pose_a), rational_b(pose_b);
  std::array<Vertex, 5> vertices;
  for (Vertex& v : vertices)
    for (double& x : v) x = doubles.next();

  // Points 0, 1 and 2 are of the one body; 3 and 4 of the other.
  std::array<Adaptive::Point_3, 5> p;
  std::array<Rational_kernel::Point_3, 5> q;
  for (int k = 0; k < 5; ++k) {
    p[k] = k < 3 ? adaptive_a(point<Adaptive>(vertices[k])) : adaptive_b(point<Adaptive>(vertices[k]));
    q[k] = k < 3 ? rational_a(point<Rational_kernel>(vertices[k])) : rational_b(point<Rational_kernel>(vertices[k]));
  }
  for (int last = 3; last < 5; ++last)
    same(volume_sign<Adaptive>(p[0], p[1], p[2], p[last]) == volume_sign<Rational_kernel>(q[0], q[1], q[2], q[last]));
  for (int axis = 0; axis < 3; ++axis) {
    same(normal_sign<Adaptive>(p[0], p[1], p[3], axis) == normal_sign<Rational_kernel>(q[0], q[1], q[3], axis));
    same(difference_sign<Adaptive>(p[0], p[4], axis) == difference_sign<Rational_kernel>(q[0], q[4], axis));
  }
  same(segment_face<Adaptive>(p[3], p[4], Triangle<Adaptive>{p[0], p[1], p[2]}) ==
       segment_face<Rational_kernel>(q[3], q[4], Triangle<Rational_kernel>{q[0], q[1], q[2]}));
}
