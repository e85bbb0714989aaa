#ifndef TETRACONE_VERIFY_FAMILIES_OBJECT_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_OBJECT_FAMILIES_H

#include "verify/cases/case.h"
#include "verify/cases/random.h"

#include <vector>

/// The families' object level by theme, each generator with its name in `families()`: object_families_THEME.cpp.
/// Generators take the random state and the parameter, and return everything except `origin`.
namespace tetracone::verify::object_family {

using Generator = Object_case(Random&, double);

// numbers: what the coordinates are
Generator random, rounded_on_plane, ulps_off_plane, perturbed_zero, ulp_walk, decimal_grid, float_widened;
// planes: coplanar faces
Generator coplanar_grid, coplanar_parallelogram, edge_in_face_plane, face_on_face, coplanar_sharing, stacked;
// contact: vertices and edges
Generator vertex_on_vertex, vertex_on_edge, vertex_on_face, edge_across_edge, edge_along_edge, near_parallel_edges;
// containment: one in the other
Generator nested_touching, nested, cavity_wall, covering_elements, covering_apex, winding_axis, voxels;
// thin: long, flat and narrow faces
Generator sliver, needle, tangent_fan;
// shapes: faces and edges that are nearly or quite degenerate
Generator nearly_collinear, degenerate_face, duplicates, non_planar_quads, t_junctions;
// meshes: of 10^3 to 10^5 triangles
Generator many_faces;
// bodies of unit cells
Generator lego_bricks;
// metres: sizes and distances that engines are made for
Generator metres, ladder;
// scales: exponents
Generator far_from_origin, distant_part, mixed_scales, cancelled_translation, exponent_gate, extreme_exponents, wild,
    tiny_fractions;
// poses: the maps
Generator special_poses, true_rotation, shear, nearly_singular, drifted_rotation;
// motions: ends of sweeps, and the corpus
Generator swept_contact, swept_primitives, corpus;

/// Returns consecutive cases of `wild` on the same two bodies, to test what a query keeps from pose to pose.
std::vector<Object_case> wild_run(Random& random, double parameter, int count);

}  // namespace tetracone::verify::object_family

#endif
