#ifndef TETRACONE_VERIFY_PREDICATE_FAMILIES_PREDICATE_FAMILIES_H
#define TETRACONE_VERIFY_PREDICATE_FAMILIES_PREDICATE_FAMILIES_H

#include "verify/cases/case.h"
#include "verify/cases/random.h"

/// The families' predicate level, each generator with its name in `families()`, where the parameter is explained too.
/// Generators take the random state and the parameter, and return everything except `origin`.
namespace tetracone::verify::predicate_family {

// planes.cpp: four points in a plane, or nearly so
Predicate_case random_points(Random& random, double scale);
Predicate_case rounded_on_plane(Random& random, double bits);
Predicate_case ulps_off_plane(Random& random, double ulps);
Predicate_case perturbed_zero(Random& random, double q);
Predicate_case coplanar_grid(Random& random, double bits);
Predicate_case coplanar_parallelogram(Random& random, double bits);
Predicate_case ulp_walk(Random& random, double axes);
Predicate_case decimal_grid(Random& random, double d);
Predicate_case non_planar_quads(Random& random, double ulps);

// contacts.cpp: p, or p q r, on an element of the tetrahedron
Predicate_case vertex_on_vertex(Random& random, double pose);
Predicate_case vertex_on_edge(Random& random, double k);
Predicate_case vertex_on_face(Random& random, double k);
Predicate_case edge_across_edge(Random& random, double k);
Predicate_case edge_along_edge(Random& random, double overlap);
Predicate_case edge_in_face_plane(Random& random, double kind);
Predicate_case face_on_face(Random& random, double overlap);
Predicate_case coplanar_sharing(Random& random, double what);
Predicate_case t_junctions(Random& random, double k);

// solids.cpp: bodies on, in and around one another
Predicate_case stacked(Random& random, double ulps);
Predicate_case nested_touching(Random& random, double dimension);
Predicate_case nested(Random& random, double distance);
Predicate_case cavity_wall(Random& random, double genus);
Predicate_case duplicates(Random& random, double what);
Predicate_case voxels(Random& random, double size);
Predicate_case tangent_fan(Random& random, double valence);
Predicate_case swept_primitives(Random& random, double kind);

// thin.cpp: triangles, tetrahedra and angles that are nearly nothing
Predicate_case sliver(Random& random, double h);
Predicate_case needle(Random& random, double a);
Predicate_case nearly_collinear(Random& random, double ulps);
Predicate_case degenerate_face(Random& random, double kind);
Predicate_case near_parallel_edges(Random& random, double a);
Predicate_case many_faces(Random& random, double triangles);

// numbers.cpp: where the doubles are scarce, or end
Predicate_case far_from_origin(Random& random, double f);
Predicate_case mixed_scales(Random& random, double s);
Predicate_case cancelled_translation(Random& random, double f);
Predicate_case exponent_gate(Random& random, double kind);
Predicate_case extreme_exponents(Random& random, double kind);
Predicate_case float_widened(Random& random, double bits);
Predicate_case wild(Random& random, double exponents);
Predicate_case tiny_fractions(Random& random, double exponent);

// poses.cpp: contacts under exact, rounded and nearly singular poses
Predicate_case special_poses(Random& random, double which);
Predicate_case true_rotation(Random& random, double largest);
Predicate_case shear(Random& random, double largest);
Predicate_case nearly_singular(Random& random, double d);
Predicate_case drifted_rotation(Random& random, double n);
Predicate_case swept_contact(Random& random, double bisections);

// coverings.cpp: what inclusion in a solid stumbles over; and the corpus
Predicate_case covering_elements(Random& random, double element);
Predicate_case covering_apex(Random& random, double position);
Predicate_case winding_axis(Random& random, double element);
Predicate_case corpus(Random& random, double ulps);

}  // namespace tetracone::verify::predicate_family

#endif
