// What experiments/python/cost.py times beside the package: the same bodies and poses, asked in C++ through the door.

#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

using namespace tetracone;

extern "C" {

/// A query of one body against itself: the triangles of `vertices` (m, 3) and `faces` (n, 3). Deleted by `free_query`.
Query* new_query(const double* vertices, std::size_t m, const std::uint32_t* faces, std::size_t n)
{
  Polyhedron polyhedron;
  polyhedron.vertices.resize(m);
  std::memcpy(polyhedron.vertices.data(), vertices, m * sizeof polyhedron.vertices[0]);
  for (std::size_t f = 0; f < n; ++f)
    polyhedron.add_polygon(std::array{faces[3 * f], faces[3 * f + 1], faces[3 * f + 2]});
  const Body body(std::move(polyhedron));
  return new Query(body, body);
}

void free_query(Query* query) { delete query; }

/// The answers of `n` poses, rows (n, 3, 4).
void collide(Query* query, const double* poses, std::size_t n, bool* answers)
{
  const Pose unmoved;
  for (std::size_t k = 0; k < n; ++k) {
    std::array<double, 12> rows;
    std::memcpy(rows.data(), poses + 12 * k, sizeof rows);
    answers[k] = bool(query->collide(unmoved, Pose(rows)));
  }
}
}
