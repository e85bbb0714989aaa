#ifndef TETRACONE_VERIFY_PREDICATE_FAMILIES_PREDICATE_POINTS_H
#define TETRACONE_VERIFY_PREDICATE_FAMILIES_PREDICATE_POINTS_H

#include "verify/cases/case.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/random.h"

#include <array>
#include <cstddef>
#include <optional>

/// Building blocks of the predicate families: seven points in the world, exactly, and frames whose poses put them
/// there.
namespace tetracone::verify::points {

using kernel::Pose;
using kernel::Rational;
using kernel::Vertex;
using object_family::composed;
using object_family::cross;
using object_family::difference;
using object_family::dot;
using object_family::double_rotation;
using object_family::dyadic;
using object_family::exact;
using object_family::integer;
using object_family::is_zero;
using object_family::moved;
using object_family::power_of_two;
using object_family::preimage;
using object_family::rounded;
using object_family::rounded_product;
using object_family::shear_and_inverse;
using object_family::signed_permutation;
using object_family::sum;
using object_family::times;
using Point = object_family::Exact_vector;
using Tetra = std::array<Point, 4>;

/// The points of a case: a tetrahedron v, and p, q, r.
struct Scene {
  Tetra v;
  Point p, q, r;
};

// --- draws -----------------------------------------------------------------------------------------------------------

inline bool one_in(Random& random, int n) { return random.bits() % n == 0; }
inline int sign(Random& random) { return one_in(random, 2) ? 1 : -1; }
template <class Choice, std::size_t n>
Choice any_of(Random& random, const std::array<Choice, n>& choices)
{
  return choices[random.bits() % n];
}

/// Returns a point of integers from -size to size.
Point grid_point(Random& random, int size);

/// Returns a point with coordinates in [-1, 1) that are multiples of 2^-bits.
Point mantissa_point(Random& random, int bits);

/// Returns four integer corners whose determinant has a magnitude of at least size^3 / 4, and is not 0. With
/// `anchored`, v1 is the origin.
Tetra tetrahedron(Random& random, int size, bool anchored = false);

/// Returns a tetrahedron with the origin on its boundary: at v1, on the edge v1 v2 or in the face v1 v2 v3. The
/// origin's barycentric coordinates have few bits.
Tetra tetrahedron_at_origin(Random& random, int size = 8);

/// Returns a tetrahedron with v1 = 0 on which points of barycentric coordinates of `bits` bits are doubles. If these
/// need many bits, its own coordinates are -1, 0 and 1.
Tetra tetrahedron_for(Random& random, int bits);

/// Returns a point strictly inside, with barycentric coordinates in sixteenths.
Point inner_point(Random& random, const Tetra& v);

/// Returns a point strictly inside the simplex of the first n corners of v1 v2 v3, n = 1, 2, 3, with barycentric
/// coordinates of `bits` bits.
Point element_point(Random& random, const Tetra& v, int n, int bits);

/// Returns a + s (b - a).
inline Point between(const Point& a, const Point& b, const Rational& s) { return sum(a, s, difference(b, a)); }

/// Returns v1 + a (v2 - v1) + b (v3 - v1).
inline Point in_plane(const Tetra& v, const Rational& a, const Rational& b)
{
  return sum(sum(v[1], a, difference(v[2], v[1])), b, difference(v[3], v[1]));
}

/// Returns the nearest doubles of the coordinates, each rounded down to a multiple of 2^-bits.
Point on_grid(const Point& x, int bits);

// --- about a contact -------------------------------------------------------------------------------------------------

/// The usual `grid`: multiples of 2^-10 are fine beside tetrahedra of integers, and have few bits.
inline constexpr int usual_grid = 10;

/// Returns a point outside v, beyond the point x of its boundary as seen from an inner point, on multiples of 2^-grid.
Point outward(Random& random, const Tetra& v, const Point& x, int grid = usual_grid);

/// Chooses q and r for a p on the boundary of v. Mostly both are outside. Else one is inside v, or q is beyond v as
/// seen from p, or pq is along the face or edge. The points are on multiples of 2^-grid, except in the last case.
void complete(Random& random, Scene& scene, int grid = usual_grid);

/// Leaves p where it is, or moves it clearly out of v or into it. Returns the number of ulps by which `nudge` is to
/// move it at last.
int moved_aside(Random& random, Scene& scene, int grid = usual_grid);

/// Permutes the corners of v in half of the calls. Then p is on another face, edge or vertex than those of v1 v2 v3.
void relabel(Random& random, Scene& scene);

/// Adds `ulps` ulps to a random coordinate of p: its own ulps or, if it is 0, those of the largest coordinate of p q r.
void nudge(Random& random, Predicate_case& c, int ulps);

// --- placing ---------------------------------------------------------------------------------------------------------

/// Frames in which the bodies' points are written, and a map applied last to both.
struct Frames {
  Pose a, b, common;
  Rational scale = 1;  ///< of the scene, so that its points are doubles in the frames
};

/// How the frames a and b differ from the world's.
enum class Frame_kind { identity, translation, permutation, true_rotation, rounded_rotation, shear };

/// Returns random frames of a kind, or of any kind.
Frames frames(Random& random, Frame_kind kind);
Frames any_frames(Random& random);

/// Returns frames a and b that are rotated exactly, by quaternions of integers up to `size`.
Frames true_rotations(Random& random, int size);

/// Returns the case whose placed points are the scene, scaled and moved by `common`, exactly; nothing when a point is
/// no double in its frame.
std::optional<Predicate_case> placed(const Scene& scene, const Frames& frames);

/// Returns `placed` of these frames or, where that is nothing, of `common` alone.
std::optional<Predicate_case> placed_somehow(const Scene& scene, const Frames& frames);

/// Returns `placed_somehow`, with p changed at last by `nudge`.
std::optional<Predicate_case> finished(Random& random, const Scene& scene, const Frames& frames, int ulps);

/// Returns `finished` of the relabelled scene in `any_frames`.
std::optional<Predicate_case> finished(Random& random, Scene scene, int ulps);

/// Returns the case of the nearest doubles in the frames. Its placed points differ from the scene by an ulp or two.
Predicate_case placed_nearly(const Scene& scene, const Frames& frames);

/// Returns the case with all lengths times 2^exponent, translations too. Requires that nothing is lost.
Predicate_case rescaled(Predicate_case c, int exponent);

/// Calls `attempt`, which draws anew each time, until it makes a case.
template <class Attempt>
Predicate_case settled(const Attempt& attempt)
{
  for (;;)
    if (std::optional<Predicate_case> c = attempt()) return *c;
}

/// Returns a contact of p = x with the boundary of v: completed, moved aside, relabelled, placed, nudged.
std::optional<Predicate_case> contact(Random& random, const Tetra& v, const Point& x, const Frames& frames,
                                      int grid = usual_grid);

/// Returns a contact with v1, with the edge v1 v2 or with the face v1 v2 v3, of few bits, under these frames.
Predicate_case any_contact(Random& random, const Frames& frames);

}  // namespace tetracone::verify::points

#endif
