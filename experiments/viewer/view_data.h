#ifndef TETRACONE_EXPERIMENTS_VIEWER_VIEW_DATA_H
#define TETRACONE_EXPERIMENTS_VIEWER_VIEW_DATA_H

#include "experiments/viewer/view_scene.h"
#include "tetracone/covering/covering.h"
#include "verify/subjects/subject.h"

namespace tetracone::experiments {

/// Limits of the triangles of all bodies. A page of more than `most_detailed` has bodies, poses and answers alone. No
/// page is made of more than `most_triangles`.
constexpr std::size_t most_detailed = 50'000, most_triangles = 1'000'000;
/// The largest number of pairs of leaves left by the paper's query for which features are computed.
constexpr std::size_t most_leaf_pairs = 100'000;

/// Returns the triangles by which the faces are drawn. They cover a face exactly; if no triangles do, they are those of
/// its covering. Requires planar faces and the polyhedron's own covering.
std::vector<covering::Face_triangle> drawn_triangles(const covering::Polyhedron& polyhedron,
                                                     const covering::Covering& covering);

/// Returns all that a page shows of a scene, as one line of JSON; experiments/viewer/page/bodies.js reads it. Vertices
/// and poses are the shortest decimals of their nearest doubles. Radii and volumes have six digits. Bounding
/// tetrahedra, contacts and parts have six digits of the extent of what is drawn together. The members are:
///  - `name` of the scene, and `version` of the program;
///  - `bodies`: name, vertices, faces by their loops, and triangles to draw them by, each behind its face; `source`:
///    the number of each face in the file;
///  - `covering`, of a body: its origin, triangles and their exact signs;
///  - `nodes`, of a body's paper tree (adaptive kernel) without the root: level, whether a leaf, and V'1 V'2 V'3. They
///    also have centre and radius of the sphere, and for a leaf its faces; `depth`: the tree's greatest depth;
///  - `hull`, of a body: level and dmax of the regular hull (dmax < 0: the hull is a sphere about V0, see
///    `tetratree::Regular_hull`);
///  - `poses`: those of A and those of B;
///  - `question`, of two bodies: surface, solid or the name of a predicate; `subject`: the name of the subject;
///  - `exact` and `answer`, for two bodies and each pose: the exact answer and the subject's; null where a predicate
///    has none;
///  - `features`, for each pose: body, edge, face, kind of contact, and a number. It is 0 if the subject finds it too,
///    1 if it misses it, 2 if only it finds it. At most 2000 are given, wrong ones first; `feature_counts` has the
///    number of exact ones;
///  - `left`, for each pose: the pairs of leaves of the two trees that the paper's query does not discard. They are
///    given as the leaves of A and those of B. A pose with more than `most_leaf_pairs` has none, and null as its number
///    of features. A predicate's case has answers only;
///  - `nearest`, for each pose: the distance, the two nearest points and the features that contain them;
///  - `contacts`, for each pose: where faces meet, as some 2000 segments of six numbers at most; a polygon is given by
///    its border;
///  - `self`, of a body: where it intersects itself, as `contacts`; `self_pairs`: the number of such pairs of
///    faces of the file;
///  - `solids`, for each pose of two solids: the relation, the dimension of what the surfaces share, and the volume of
///    the overlap; `parts`: the polygons that bound the overlap, by their coordinates, or null where they are more than
///    a page holds; `out`: the vector that moves A out of B, with bounds of its length, or with the exits. Solids that
///    are disjoint or only meet have no volume, parts and `out`. A pose with more than `most_leaf_pairs` has null;
///  - `motion`, for two moving bodies: the times of the poses; `first`: the doubles around the first contact;
///    `holders`: the features of A and B that meet then. Each has its name in the file, its numbers in the page, and
///    whether it is a face in the page;
///  - `rays`, for one body: origin and direction, and the faces of the file that each ray meets, with t;
///  - `case`, of a case file: cause, family, seed, index and the names of subjects that were wrong.
///
/// More than `most_detailed` triangles cause a line on stderr. Throws covering::Input_error for more than
/// `most_triangles`, and CLI::ValidationError for an unknown kernel or, for a predicate's case, an unknown subject.
std::string view_data(const View_scene& scene, const std::string& kernel, verify::Method method);

/// The largest number of poses over all bodies and frames: a larger page would not fit a browser.
constexpr std::size_t most_poses = 400'000;

/// Returns all that a page shows of a scene file, as one line of JSON; experiments/viewer/page/scene.js reads it. It
/// has `models`, each with `vertices` and the corners of its `triangles`; `bodies`, each by its model; `frames`, each
/// with its poses; and `pairs`, the colliding ones of each frame. A model without a body is empty. Throws
/// covering::Input_error for bad input and for a scene without a frame. It also throws it for more than `most_poses`
/// poses, and for models of more than `most_triangles` triangles.
std::string scene_data(const std::filesystem::path& file, kernel::Question question, const Model_options& models);

}  // namespace tetracone::experiments

#endif
