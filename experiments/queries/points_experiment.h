#ifndef TETRACONE_EXPERIMENTS_QUERIES_POINTS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_POINTS_EXPERIMENT_H

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tetracone::experiments {

/// What does a point in a solid cost, and the first hit of a ray? By the table over cones, the boxes of the fast tree,
/// the paper's tetra-tree, exact and in double, and by CGAL's Side_of_triangle_mesh and AABB_tree. Bodies are two
/// generated ones of 7,000 and of 70,000 triangles and `models`, closed meshes of triangles; points are at random in
/// their box and within 1e-3 of their surface, `count` of each, as many as rays. Times are of the processor, set-up
/// begins with the file. Every answer is judged by the truth. Writes out/points.csv and prints it as a table. Throws
/// covering::Input_error for a model that is none.
void run_points(const std::filesystem::path& out, const std::vector<std::filesystem::path>& models, int count,
                std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
