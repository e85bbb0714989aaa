#include "verify/object_families.h"

#include "verify/generators.h"

namespace tetracone::verify {

using namespace object_family;

// In the order of `families()`.
const std::array<Object_case (*)(Random&, double), family_count> object_generators = {
    object_family::random, rounded_on_plane,  ulps_off_plane,   perturbed_zero,      coplanar_grid,   coplanar_parallelogram,
    ulp_walk,         decimal_grid,      vertex_on_vertex, vertex_on_edge,      vertex_on_face,  edge_across_edge,
    edge_along_edge,  edge_in_face_plane, face_on_face,    coplanar_sharing,    stacked,         nested_touching,
    nested,           cavity_wall,       sliver,           needle,              nearly_collinear, degenerate_face,
    duplicates,       far_from_origin,   mixed_scales,     cancelled_translation, exponent_gate, extreme_exponents,
    special_poses,    true_rotation,     shear,            nearly_singular,     drifted_rotation, swept_contact,
    covering_elements, covering_apex,    winding_axis,     non_planar_quads,    t_junctions,     voxels,
    near_parallel_edges, tangent_fan,    float_widened,    swept_primitives,    corpus};

}  // namespace tetracone::verify
