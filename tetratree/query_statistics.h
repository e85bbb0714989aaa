#ifndef TETRACONE_TETRATREE_QUERY_STATISTICS_H
#define TETRACONE_TETRATREE_QUERY_STATISTICS_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace tetracone::tetratree {

/// What queries did, stage by stage, since the counts were last cleared.
struct Query_statistics {
  std::uint64_t queries = 0;                   ///< searches for a collision or contacts, also those of other questions
  std::uint64_t pairs_visited = 0;             ///< pairs of nodes that were compared; in the fast tree, pairs opened
  std::uint64_t hull_tests = 0;                ///< nodes compared with a plane of the other body's regular hull
  std::uint64_t discarded_by_hull = 0;         ///< nodes beyond it (Theorem 2)
  std::uint64_t sphere_tests = 0;              ///< pairs of nodes whose bounding spheres were compared
  std::uint64_t discarded_by_sphere = 0;       ///< pairs apart
  std::uint64_t tetrahedron_tests = 0;         ///< pairs of nodes whose bounding tetrahedra were compared
  std::uint64_t discarded_by_tetrahedron = 0;  ///< pairs apart
  std::uint64_t box_tests = 0;                 ///< boxes compared with a box of the other body, or with the ray of an
                                               ///< inclusion test
  std::uint64_t leaf_pairs = 0;                ///< pairs of leaves that no bounding volume discarded; in collisions of
                                               ///< the fast tree, pairs of their elements
  std::uint64_t discarded_by_box = 0;          ///< pairs of an edge and a face in a leaf pair whose boxes are apart
  std::uint64_t edge_face_tests = 0;           ///< edges against faces, decided by signs
  std::uint64_t triangle_tests = 0;            ///< pairs of triangles, in the fast tree
  std::uint64_t inclusion_tests = 0;           ///< vertices against the other solid; in the fast tree, those in its
                                               ///< root's box
  std::uint64_t exact_fallbacks = 0;           ///< signs, distances, ranges of exits, and pairs of moving features that
                                               ///< needed exact arithmetic

  /// Adds field by field.
  Query_statistics& operator+=(const Query_statistics& other)
  {
    // All fields as one array, which leaves none out; a field of another size does not compile.
    using Fields = std::array<std::uint64_t, sizeof(Query_statistics) / sizeof(std::uint64_t)>;
    auto sums = std::bit_cast<Fields>(*this);
    const auto added = std::bit_cast<Fields>(other);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += added[k];
    return *this = std::bit_cast<Query_statistics>(sums);
  }

  /// All comparisons of bounding volumes.
  std::uint64_t bounding_tests() const { return hull_tests + sphere_tests + tetrahedron_tests + box_tests; }
  /// All tests of elements, which decide.
  std::uint64_t primitive_tests() const { return edge_face_tests + triangle_tests + inclusion_tests; }
};

}  // namespace tetracone::tetratree

#endif
