#ifndef TETRACONE_VERIFY_CASES_OBJECT_PLACING_H
#define TETRACONE_VERIFY_CASES_OBJECT_PLACING_H

#include "verify/cases/case.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_library.h"

#include <array>
#include <optional>

/// Exact contacts and their placing, from which the object families are made. The compiler chooses the order in which
/// arguments of one call are evaluated. Therefore at most one of them draws from `random`, here and in the families, so
/// that a seed gives the same cases everywhere. (Braced lists are evaluated from left to right.)
namespace tetracone::verify::object_family {

using kernel::Pose;
using kernel::Rational;

/// An integer from `low` to `high`.
int integer(Random& random, int low, int high);

/// 2^k, for positive and negative k, exactly.
Rational power_of_two(int k);

/// An odd multiple of 2^-bits strictly between 0 and 1; 1 <= bits <= 52.
double dyadic(Random& random, int bits);

/// A vector of integers from -size to size, not zero.
Exact_vector integer_direction(Random& random, int size);

/// Signed permutation k of 48: the first is the identity, the first 24 are rotations.
Pose signed_permutation(int k);

/// The rotation of a quaternion of integers from -size to size.
Pose rational_rotation(Random& random, int size);

/// Returns the pose that rotates, then moves by `at`.
Pose rotated(const Rotation& m, const Vector& at);

/// The rounded rotation of a random quaternion.
Pose double_rotation(Random& random);

/// Returns the product of the linear parts, each entry rounded as a program would; the translation is 0.
Pose rounded_product(const Pose& second, const Pose& first);

/// A product of two integer shears x += s y with |s| <= `size`, which is unimodular; and its inverse.
std::array<Pose, 2> shear_and_inverse(Random& random, int size);

/// x -> diag(2^exponents) x. Requires powers with a finite nearest double.
Pose stretch(const std::array<int, 3>& exponents);

/// A similarity by about 2^exponent with fractions as entries, its translation scaled too. Below the denormals, the
/// nearest double of an entry is 0.
Pose fraction_map(Random& random, int exponent);

/// A map of any kind: a turn, reflection or shear between two stretches by up to 2^+-size along the axes, then perhaps
/// a translation. It is exact, and of rationals if the turn is.
Pose wild_map(Random& random, int size);

/// The map that is applied to both bodies of a case last. All but `rounded` keep a contact exactly.
enum class Motion { identity, translation, permutation, rotation, similarity, shear, rounded };

/// Returns a random kind other than `rounded`; few are `shear`.
Motion exact_motion(Random& random);

/// Returns a random map of a kind, exactly. `rounded` gives a rotation: `placed` rounds the poses afterwards.
Pose motion(Random& random, Motion kind);

/// A turn of B against A: none, a signed permutation, or a rational rotation.
Pose any_turn(Random& random);

/// Two bodies in contact, in A's frame.
struct Touching {
  Body a, b;
  Pose relative;           ///< of B
  Exact_vector apart;      ///< the direction in which B leaves A
  bool separated = false;  ///< true when all of A is on one side of a plane that is normal to `apart`, and all of B is
                           ///< on the other. They share a point of it then.
};

/// Returns the map that applies `turn`, then the translation that puts the lowest vertex of B along `normal` on
/// `point`: B is on the upper side of the plane.
Pose resting(const covering::Polyhedron& b, const Pose& turn, const Exact_vector& point, const Exact_vector& normal);

/// A vertex of B on an inner point of a hull triangle of A, at barycentric coordinates of `bits` bits. Requires a hull
/// triangle, and two bits or more.
Touching vertex_on_face(Random& random, const Shape& a, const Body& b, const Pose& turn, int bits);
/// A vertex of B on a hull edge of A at an odd multiple of 2^-bits. Requires a hull edge.
Touching vertex_on_edge(Random& random, const Shape& a, const Body& b, const Pose& turn, int bits);
/// The extreme vertices of both along a random direction.
Touching vertex_on_vertex(Random& random, const Body& a, const Body& b, const Pose& turn);
/// Two edges that cross at parameters of `bits` bits. They lie on the hulls, unless dozens of tries find no such edges.
/// Requires a similarity as `turn`.
Touching edge_across_edge(Random& random, const Shape& a, const Shape& b, const Pose& turn, int bits);
/// One of these. With a vertex on A's face, B's lowest edge or face may lie on it.
Touching any_contact(Random& random, const Shape& a, const Shape& b, const Pose& turn);
/// Any of these with bodies of any kind.
Touching any_contact(Random& random, const Pose& turn);

/// A point inside the triangle, at barycentric coordinates of `bits` bits. Requires two bits or more.
Exact_vector point_inside(Random& random, const Shape& shape, const Face_triangle& triangle, int bits);
/// The first corner, plus s and t times the ways to the two others.
Exact_vector point_on(const Shape& shape, const Face_triangle& triangle, double s, double t);

/// Returns 0 half of the time, else a gap or a penetration of 2^-10 to 2^-60.
Rational any_gap(Random& random);

/// Places A at the identity and B at `relative`, then moves both, and perhaps exchanges them. No answer is known.
Object_case placed(Random& random, const Body& a, const Body& b, const Pose& relative, Motion kind);
Object_case placed(Random& random, const Body& a, const Body& b, const Pose& relative, const Pose& common);

/// Opens the contact by `gap` times a length of about one, along `apart`; a negative gap closes it further. Sets the
/// answers as far as they are known.
Object_case placed(Random& random, const Touching& contact, const Rational& gap, Motion kind);
Object_case placed(Random& random, const Touching& contact, const Rational& gap, const Pose& common);
/// Does so under any exact motion; without `gap`, by `any_gap`.
Object_case placed(Random& random, const Touching& contact, const Rational& gap);
Object_case placed(Random& random, const Touching& contact);

/// Sets both answers.
Object_case with_answer(Object_case c, std::optional<bool> surface, std::optional<bool> solid);
Object_case with_answer(Object_case c, bool both);

/// Returns the case with all poses rounded to doubles. If that changes a pose, `surface` and `solid` are not known
/// any more.
Object_case rounded_poses(Object_case c);

}  // namespace tetracone::verify::object_family

#endif
