#include "verify/families/families.h"

#include "verify/families/ladder.h"
#include "verify/families/object_families.h"
#include "verify/predicate_families/predicate_families.h"

#include <limits>

namespace tetracone::verify {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The generators of cases of predicates and of objects, where they have one name.
#define TETRACONE_OF_BOTH_LEVELS(name) predicate_family::name, object_family::name

/// All families; the number of each is its place.
std::vector<Family> entries()
{
  return {
      {{"random",
        "uniform random coordinates, nothing on purpose near to anything; one pose each, no motion",
        "scale 2^s: s",
        {-40, -20, -4, 0, 4, 20, 40}},
       predicate_family::random_points,
       object_family::random},
      {{"rounded-on-plane",
        "an affine combination of a plane's points, rounded",
        "bits kept",
        {4, 8, 16, 24, 32, 40, 48, 53}},
       TETRACONE_OF_BOTH_LEVELS(rounded_on_plane)},
      {{"ulps-off-plane", "a point off a plane by a few ulps", "ulps", {1024, 64, 32, 16, 8, 4, 2, 1, 0}},
       TETRACONE_OF_BOTH_LEVELS(ulps_off_plane)},
      {{"perturbed-zero",
        "an exact zero with one coordinate changed by a share of it",
        "2^-q: q, infinite for none",
        {20, 30, 40, 45, 50, 52, 54, 60, infinite}},
       TETRACONE_OF_BOTH_LEVELS(perturbed_zero)},
      {{"coplanar-grid", "coplanar points of an integer grid", "bits of the grid", {8, 12, 16, 20, 25}},
       TETRACONE_OF_BOTH_LEVELS(coplanar_grid)},
      {{"coplanar-parallelogram",
        "the exact fourth corner of a parallelogram of full mantissas",
        "bits of the corners",
        {40, 44, 48, 50, 52}},
       TETRACONE_OF_BOTH_LEVELS(coplanar_parallelogram)},
      {{"ulp-walk",
        "a patch of neighbouring doubles around a contact",
        "pair of axes walked: 0 xy, 1 yz, 2 zx",
        {0, 1, 2}},
       TETRACONE_OF_BOTH_LEVELS(ulp_walk)},
      {{"decimal-grid", "decimal fractions: integers / 10^d, rounded", "d", {1, 2, 3, 6, 9}},
       TETRACONE_OF_BOTH_LEVELS(decimal_grid)},
      {{"vertex-on-vertex",
        "a vertex on a vertex of the other body",
        "pose: 0 identity, 1 translation, 2 signed permutation, 3 true rotation, 4 rounded rotation",
        {0, 1, 2, 3, 4}},
       TETRACONE_OF_BOTH_LEVELS(vertex_on_vertex)},
      {{"vertex-on-edge", "a vertex on an edge's inside, at j / 2^k", "k", {1, 4, 16, 32, 52}},
       TETRACONE_OF_BOTH_LEVELS(vertex_on_edge)},
      {{"vertex-on-face",
        "a vertex on a face's inside, at dyadic barycentric coordinates of k bits",
        "k",
        {2, 4, 16, 32, 52}},
       TETRACONE_OF_BOTH_LEVELS(vertex_on_face)},
      {{"edge-across-edge", "two edges that cross, at dyadic parameters of k bits", "k", {1, 4, 16, 32, 52}},
       TETRACONE_OF_BOTH_LEVELS(edge_across_edge)},
      {{"edge-along-edge",
        "two edges on one line",
        "length of the overlap; negative: a gap",
        {1, 0x1p-10, 0x1p-30, 0x1p-50, 0, -0x1p-50, -0x1p-10}},
       TETRACONE_OF_BOTH_LEVELS(edge_along_edge)},
      {{"edge-in-face-plane", "an edge in a face's plane", "0 missing, 1 crossing, 2 inside, 3 touching", {0, 1, 2, 3}},
       TETRACONE_OF_BOTH_LEVELS(edge_in_face_plane)},
      {{"face-on-face",
        "coplanar faces",
        "overlap: 0 equal, 1 partial, 2 inside, 3 an edge, 4 a vertex, 5 none; + 6: normals alike",
        {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
       TETRACONE_OF_BOTH_LEVELS(face_on_face)},
      {{"coplanar-sharing", "coplanar, and shared only", "0 a vertex, 1 an edge", {0, 1}},
       TETRACONE_OF_BOTH_LEVELS(coplanar_sharing)},
      {{"stacked", "boxes stacked with a gap", "gap in ulps", {-64, -2, -1, 0, 1, 2, 64}},
       TETRACONE_OF_BOTH_LEVELS(stacked)},
      {{"nested-touching", "a solid in a solid that touches it from inside", "dimension of the contact", {0, 1, 2}},
       TETRACONE_OF_BOTH_LEVELS(nested_touching)},
      {{"nested",
        "a solid strictly in a solid",
        "distance between the surfaces",
        {0x1p-2, 0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40, 0x1p-50}},
       TETRACONE_OF_BOTH_LEVELS(nested)},
      {{"cavity-wall", "at the wall of a cavity, or of tunnels", "genus: 0 cavity, 1, 2", {0, 1, 2}},
       TETRACONE_OF_BOTH_LEVELS(cavity_wall)},
      {{"sliver", "triangles of a tiny height", "height 2^-h: h", {2, 10, 20, 30, 40, 50}},
       TETRACONE_OF_BOTH_LEVELS(sliver)},
      {{"needle", "tetrahedra of a tiny aspect", "aspect 10^a: a", {1, 3, 6, 9, 12, 15}},
       TETRACONE_OF_BOTH_LEVELS(needle)},
      {{"nearly-collinear", "three corners of a face collinear but for a few ulps", "ulps", {1024, 64, 16, 4, 1, 0}},
       TETRACONE_OF_BOTH_LEVELS(nearly_collinear)},
      {{"degenerate-face",
        "faces that are segments or points",
        "0 segment, 1 point, 2 segment with a repeated corner, 3 a loop of one point",
        {0, 1, 2, 3}},
       TETRACONE_OF_BOTH_LEVELS(degenerate_face)},
      {{"duplicates",
        "repeated elements and edges of many faces",
        "0 vertices, 1 faces, 2 an edge of four faces, 3 of six",
        {0, 1, 2, 3}},
       TETRACONE_OF_BOTH_LEVELS(duplicates)},
      {{"far-from-origin", "everything moved by 2^f", "f", {0, 10, 20, 30, 40, 50}},
       TETRACONE_OF_BOTH_LEVELS(far_from_origin)},
      {{"mixed-scales", "a big body and one smaller by 2^s", "s", {0, 10, 20, 30, 40, 50, 60}},
       TETRACONE_OF_BOTH_LEVELS(mixed_scales)},
      {{"cancelled-translation", "a translation of 2^f that cancels coordinates", "f", {0, 10, 20, 30, 40, 50}},
       TETRACONE_OF_BOTH_LEVELS(cancelled_translation)},
      {{"exponent-gate",
        "coordinates at the ends of the filters' range",
        "0 2^-110, 1 2^110, 2 below, 3 above, 4 both ends",
        {0, 1, 2, 3, 4}},
       TETRACONE_OF_BOTH_LEVELS(exponent_gate)},
      {{"extreme-exponents",
        "coordinates at the ends of the doubles' range",
        "0 denormal, 1 near the largest, 2 mixed",
        {0, 1, 2}},
       TETRACONE_OF_BOTH_LEVELS(extreme_exponents)},
      {{"special-poses",
        "poses that permute axes exactly, and half-turns that nearly do",
        "0 identity, 1-24 signed permutations, 25-27 half-turns in doubles",
        {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27}},
       TETRACONE_OF_BOTH_LEVELS(special_poses)},
      {{"true-rotation",
        "exact contact under the rational rotation of an integer quaternion",
        "largest entry of the quaternion",
        {1, 2, 4, 9, 30}},
       TETRACONE_OF_BOTH_LEVELS(true_rotation)},
      {{"shear", "a unimodular integer shear, and its exact inverse", "largest entry", {1, 3, 9, 100}},
       TETRACONE_OF_BOTH_LEVELS(shear)},
      {{"nearly-singular",
        "maps of determinant 2^-d, or -2^-d",
        "d, with its sign",
        {1, 10, 20, 30, 40, 50, -1, -10, -30, -50}},
       TETRACONE_OF_BOTH_LEVELS(nearly_singular)},
      {{"drifted-rotation", "a product of n rounded rotations", "n", {1, 10, 100, 1000}},
       TETRACONE_OF_BOTH_LEVELS(drifted_rotation)},
      {{"swept-contact",
        "the last free and the first colliding double of a sweep, by bisection",
        "bisections",
        {4, 8, 16, 32, 48, 64}},
       TETRACONE_OF_BOTH_LEVELS(swept_contact)},
      {{"covering-elements", "a point on an inner element of the covering", "0 facet, 1 edge, 2 apex", {0, 1, 2}},
       TETRACONE_OF_BOTH_LEVELS(covering_elements)},
      {{"covering-apex",
        "a covering whose apex is on the surface's planes",
        "0 on a face's plane, 1 on an edge's line, 2 at a vertex",
        {0, 1, 2}},
       TETRACONE_OF_BOTH_LEVELS(covering_apex)},
      {{"winding-axis",
        "a ray along an axis through elements of the surface",
        "0 vertices, 1 edges, 2 in faces",
        {0, 1, 2}},
       TETRACONE_OF_BOTH_LEVELS(winding_axis)},
      {{"non-planar-quads",
        "quadrangles that are planar but for a few ulps, triangulated",
        "ulps",
        {1024, 64, 16, 4, 1, 0}},
       TETRACONE_OF_BOTH_LEVELS(non_planar_quads)},
      {{"t-junctions", "edges split on one side only, at j / 2^k", "k", {1, 4, 16, 32, 52}},
       TETRACONE_OF_BOTH_LEVELS(t_junctions)},
      {{"voxels", "voxel solids whose answer is that of their bits", "size of the grid", {1, 2, 3, 4}},
       TETRACONE_OF_BOTH_LEVELS(voxels)},
      {{"near-parallel-edges",
        "two edges that are parallel but for 2^-a",
        "a, infinite for parallel",
        {2, 10, 20, 30, 40, 50, infinite}},
       TETRACONE_OF_BOTH_LEVELS(near_parallel_edges)},
      {{"tangent-fan", "contact in a vertex of many faces", "valence", {3, 6, 12, 24, 48}},
       TETRACONE_OF_BOTH_LEVELS(tangent_fan)},
      {{"float-widened",
        "numbers of float with some bits of double below",
        "bits below float's",
        {0, 1, 4, 12, 24, 29}},
       TETRACONE_OF_BOTH_LEVELS(float_widened)},
      {{"swept-primitives",
        "spikes, wedges, cracks and inner edges frozen at the ends of a sweep",
        "0 spike, 1 wedge, 2 crack, 3 cliff edge, 4 inner edge",
        {0, 1, 2, 3, 4}},
       TETRACONE_OF_BOTH_LEVELS(swept_primitives)},
      {{"corpus", "shrunk counterexamples, and their neighbours", "ulps by which a coordinate is changed", {0, 1, 16}},
       TETRACONE_OF_BOTH_LEVELS(corpus)},
      {{"wild",
        "bodies and poses of any exponents, turned, sheared, mirrored and stretched along axes",
        "sum of the exponents of all factors",
        {0, 30, 150, 500, 960}},
       TETRACONE_OF_BOTH_LEVELS(wild)},
      {{"many-faces",
        "meshes of 10^3 to 10^5 triangles, and triangles as small as theirs",
        "triangles of the larger body, about; each number as often as all larger ones together",
        {1000, 2000, 1000, 5000, 1000, 2000, 1000, 20000, 1000, 2000, 1000, 5000, 1000, 2000, 1000, 100000}},
       TETRACONE_OF_BOTH_LEVELS(many_faces)},
      {{"tiny-fractions",
        "huge bodies made small by poses of fractions that are rounded to denormals, or to 0",
        "exponent of the bodies' coordinates",
        {0, 500, 1000, 1015}},
       TETRACONE_OF_BOTH_LEVELS(tiny_fractions)},
      {{"lego",
        "bodies of unit cells, cut and merged in any way, whose relation and overlap are counted",
        "1 anywhere, 2 a copy, 3 a part, 4 beside, 5 within, 6 in a cavity, 7 of cancelling shells, 8 half a cell off; "
        "of points: size of the grid",
        {1, 2, 3, 4, 5, 6, 7, 8}},
       predicate_family::voxels,
       object_family::lego_bricks},
      {{"metres",
        "bodies of 0.1 to 10 m within 100 m, rigid poses of doubles, an exact contact opened or closed, then rounded",
        "gap 2^-k of the size: k, infinite for none",
        {0, 4, 8, 12, 16, 20, 24, 32, 40, infinite}},
       predicate_family::perturbed_zero,
       object_family::metres},
      {{"ladder", "two equal cubes side by side, flush, shifted or turned",
        "25 i + j: i for cubes of 2^-10 2^-7 2^-4 1 2^3 2^7 2^10 2^13 m; j = 0 flush, odd a gap, even an overlap of "
        "2^-1 2^-2 2^-4 ... 2^-48 of the size",
        all_rungs()},
       [](Random& random, double number) {
         const Rung rung(static_cast<int>(number));
         return predicate_family::perturbed_zero(random, rung.step == 0 ? infinite : rung.bits());
       },
       object_family::ladder},
      {{"distant-part",
        "a contact of a body that is far longer, by a distant copy of it or by a vertex of no face",
        "length 2^p: p",
        {10, 14, 17, 20, 24, 27, 30, 35, 40}},
       predicate_family::mixed_scales,
       object_family::distant_part},
  };
}

template <class Case>
Case made(const Family& family, Case_kind level, Case (*make)(Random&, double), std::uint64_t seed, std::uint64_t index)
{
  Random random = random_of_case(seed, std::uint64_t(2 * family.number + (level == Case_kind::object)), index);
  const Origin origin = family.origin(seed, index);
  Case c = make(random, origin.parameter);
  c.origin = origin;
  return c;
}

}  // namespace

Predicate_case Family::predicate_case(std::uint64_t seed, std::uint64_t index) const
{
  return made(*this, Case_kind::predicate, predicate, seed, index);
}

Object_case Family::object_case(std::uint64_t seed, std::uint64_t index) const
{
  return made(*this, Case_kind::object, object, seed, index);
}

const std::vector<Family>& families()
{
  static const std::vector<Family> all = numbered(entries());
  return all;
}

const Family* find_family(std::string_view name) { return find_named(families(), name); }

}  // namespace tetracone::verify
