// Bodies from arrays: your own vertices and triangles, and a matrix of your own as the pose. No file is read.
#include <tetracone/tetracone.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <utility>
#include <vector>

namespace {

/// A body of the flat arrays that most programs have: x y z of each vertex, three vertex numbers of each triangle.
tetracone::Body body_of(const std::vector<double>& coordinates, const std::vector<std::uint32_t>& corners)
{
  tetracone::Polyhedron polyhedron;
  for (std::size_t v = 0; v + 2 < coordinates.size(); v += 3)
    polyhedron.vertices.push_back({coordinates[v], coordinates[v + 1], coordinates[v + 2]});
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    polyhedron.add_polygon({corners[t], corners[t + 1], corners[t + 2]});
  return tetracone::Body(std::move(polyhedron));
}

/// The pose of a row-major 4x4 matrix whose last row is 0 0 0 1. A column-major one, as Eigen's, must be transposed.
tetracone::Pose pose_of(const std::array<double, 16>& matrix)
{
  std::array<double, 12> rows;
  for (std::size_t k = 0; k < 12; ++k) rows[k] = matrix[k];
  return tetracone::Pose(rows);
}

}  // namespace

int main()
{
  using namespace tetracone;
  const Body corner = body_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  std::cout << (corner.is_closed() ? "closed" : "open") << ", " << corner.polyhedron().face_count() << " faces\n";
  Query query(corner, corner);
  const Pose half_turn = pose_of({-1, 0, 0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  std::cout << query.collide(Pose(), half_turn).relation() << '\n';
  const Pose away = pose_of({1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  std::cout << query.collide(Pose(), away).relation() << ", " << query.distance(Pose(), away) << " away\n";
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   closed, 4 faces
//   surfaces
//   apart, 2 away
