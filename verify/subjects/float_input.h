#ifndef TETRACONE_VERIFY_SUBJECTS_FLOAT_INPUT_H
#define TETRACONE_VERIFY_SUBJECTS_FLOAT_INPUT_H

#include "tetracone/covering/polyhedron.h"
#include "verify/cases/case.h"

#include <array>
#include <optional>
#include <vector>

namespace tetracone::verify {

/// The numbers of its input that a subject holds as floats.
enum class In_floats { nothing, vertices, vertices_and_poses };

using Triangles = std::vector<std::array<covering::Index, 3>>;

/// Returns the polyhedron's faces triangulated by constrained Delaunay triangulation, a degenerate face by a fan.
/// Nothing when a face cannot be triangulated (its loops touch themselves or each other), or there is no triangle at
/// all. These triangles are what peers and programs are given.
std::optional<Triangles> triangles_of(const covering::Polyhedron& polyhedron);

/// Returns the case as a subject holds it: triangles, with the numbers that `in_floats` names rounded to the nearest
/// float. No answer of it is known by construction. Nothing where a number has no finite float, where a rounded pose
/// has det M = 0, and where a body has no triangles. Requires a subject that holds some number as a float.
std::optional<Object_case> float_input(const Object_case& c, In_floats in_floats);

}  // namespace tetracone::verify

#endif
