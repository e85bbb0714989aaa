#ifndef TETRACONE_EXPERIMENTS_QUERIES_POINTS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_POINTS_EXPERIMENT_H

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tetracone::experiments {

/// Measures the cost of locating a point in a solid, and of the first hit of a ray. The methods are the table over
/// cones, the boxes of the fast tree, the paper's tetra-tree, exact and in double, and CGAL's Side_of_triangle_mesh and
/// AABB_tree. The bodies are two generated ones of 7,000 and 70,000 triangles, and `models`, closed meshes of
/// triangles. Points are random in their box and within 1e-3 of their surface, `count` of each, and as many rays. Times
/// are of the processor; set-up begins with the file. The truth judges every answer. Writes out/points.csv and prints
/// it as a table. Throws covering::Input_error for an invalid model.
void run_points(const std::filesystem::path& out, const std::vector<std::filesystem::path>& models, int count,
                std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
