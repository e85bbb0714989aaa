#ifndef TETRACONE_EXPERIMENTS_VIEWER_VIEW_DATA_H
#define TETRACONE_EXPERIMENTS_VIEWER_VIEW_DATA_H

#include "experiments/viewer/view_scene.h"
#include "tetracone/covering/covering.h"
#include "tetracone/covering/polyhedron.h"
#include "verify/subjects/subject.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// Triangles of all bodies. A page of more than `most_detailed` has no covering, nodes, hull or features; of more than
/// `most_triangles` there is none. Both take time linear in the triangles.
constexpr std::size_t most_detailed = 50'000, most_triangles = 1'000'000;
/// Where the paper's query leaves more pairs of leaves, no features are looked for.
constexpr std::size_t most_leaf_pairs = 100'000;

/// Triangles to draw every face by: the face itself, or the triangles that cover it exactly. A face without such is drawn
/// by the triangles of its covering. Requires planar faces and the polyhedron's own covering.
std::vector<covering::Face_triangle> drawn_triangles(const covering::Polyhedron& polyhedron,
                                                     const covering::Covering& covering);

/// All that a page shows of a scene, as one line of JSON; experiments/viewer/page/bodies.js reads it. Vertices and
/// poses are the shortest decimals of their (nearest) doubles, bounding volumes have six digits.
///  - `bodies`: vertices, faces by their loops, triangles to draw them by; `covering`: its origin, triangles and their
///  exact signs;
///    `nodes`: of the paper's tree (adaptive kernel), the root left out: level, whether a leaf, V'1 V'2 V'3, centre and
///    radius of the sphere, and of a leaf the faces; `hull`: level and dmax of the regular hull (dmax < 0: the hull is
///    a sphere about V0, see `tetratree::Regular_hull`).
///  - of two bodies, for each pose: `exact` and `answer`, the exact answer and the subject's; `features`: body, edge,
///  face, kind of contact, and 0:
///    the subject finds it too, 1: it does not, 2: only it does; `left`: the pairs of leaves of the two trees that the
///    paper's query does not discard, as the leaves of A and those of B. A pose of more than `most_leaf_pairs` has
///    none, and null as its count of features. Of a predicate's case, answers alone.
///    `nearest`: the distance, the two nearest points and what holds them.
///    `contacts`: where faces meet, as segments of six numbers, a polygon by its border.
///  - of two in motion `motion`: the times of the poses; `first`: doubles about the first contact; `holders`: what of A
///  and of B meets then, in words and by its numbers.
///  - of one body `rays`: origin and direction, and the faces that each meets, with t.
/// More than `most_detailed` triangles get a line on stderr. Throws covering::Input_error for more than
/// `most_triangles`, and CLI::ValidationError for a kernel that the case's predicate has none of.
std::string view_data(const View_scene& scene, const std::string& kernel, verify::Method method);

}  // namespace tetracone::experiments

#endif
