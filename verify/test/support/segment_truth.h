#ifndef TETRACONE_VERIFY_TEST_SUPPORT_SEGMENT_TRUTH_H
#define TETRACONE_VERIFY_TEST_SUPPORT_SEGMENT_TRUTH_H

#include "verify/integer_truth/integer_features.h"
#include "verify/test/support/scenes.h"

#include <array>
#include <memory>
#include <vector>

/// Segments and faces in degenerate positions, and the second truth about them.
namespace tetracone::verify::scenes {

using Loops = std::vector<std::vector<Vertex>>;

/// Returns the one face with these loops.
inline Polyhedron face_of(const Loops& loops)
{
  Polyhedron face;
  std::vector<std::vector<Index>> corners;
  for (const auto& loop : loops) {
    corners.emplace_back();
    for (const Vertex& v : loop) {
      corners.back().push_back(Index(face.vertices.size()));
      face.vertices.push_back(v);
    }
  }
  face.add_face(corners);
  return face;
}

/// Returns up to three loops of up to five corners of a grid in the plane z = 0. They cross, repeat and cancel
/// themselves and each other; some run back the way they came.
inline Loops random_loops(Random& random, int radius)
{
  Loops loops(std::size_t(integer(random, 1, 3)));
  for (auto& loop : loops) {
    for (int k = integer(random, 1, 5); k > 0; --k)
      loop.push_back({double(integer(random, -radius, radius)), double(integer(random, -radius, radius)), 0});
    if (integer(random, 0, 3) == 0)
      for (std::size_t k = loop.size(); k-- > 0;) loop.push_back(loop[k]);
  }
  return loops;
}

/// Returns how the closed segment pq meets the face, in integers.
inline kernel::Contact true_contact(const Vertex& p, const Vertex& q, const Loops& loops)
{
  const auto segment = std::make_shared<const Polyhedron>(face_of({{p, q}})),
             face = std::make_shared<const Polyhedron>(face_of(loops));
  for (const kernel::Feature_pair& pair : integer_truth::features({segment, face, Pose(), Pose(), {}, {}, {}}))
    if (pair.body == 0) return pair.kind;
  return kernel::Contact::none;
}

}  // namespace tetracone::verify::scenes

#endif
