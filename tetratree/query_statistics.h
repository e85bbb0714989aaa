#ifndef TETRACONE_TETRATREE_QUERY_STATISTICS_H
#define TETRACONE_TETRATREE_QUERY_STATISTICS_H

#include <cstdint>

namespace tetracone::tetratree {

/// What queries did, stage by stage, since the counts were last cleared.
struct Query_statistics {
  std::uint64_t queries = 0;                   ///< poses that were asked
  std::uint64_t pairs_visited = 0;             ///< pairs of nodes whose bounding volumes were compared
  std::uint64_t hull_tests = 0;                ///< nodes compared with a plane of the other body's regular hull
  std::uint64_t discarded_by_hull = 0;         ///< of these: nodes beyond it (Theorem 2)
  std::uint64_t sphere_tests = 0;              ///< pairs of nodes whose bounding spheres were compared
  std::uint64_t discarded_by_sphere = 0;       ///< of these: pairs apart
  std::uint64_t tetrahedron_tests = 0;         ///< pairs of nodes whose bounding tetrahedra were compared
  std::uint64_t discarded_by_tetrahedron = 0;  ///< of these: pairs apart
  std::uint64_t box_tests = 0;                 ///< oriented boxes compared with one of the other body, in the fast tree
  std::uint64_t leaf_pairs = 0;                ///< pairs of leaves that no bounding volume discarded
  std::uint64_t discarded_by_box = 0;          ///< pairs of an edge and a face in a leaf pair whose boxes are apart
  std::uint64_t edge_face_tests = 0;           ///< edges against faces, decided by signs
  std::uint64_t triangle_tests = 0;            ///< pairs of triangles, in the fast tree
  std::uint64_t inclusion_tests = 0;           ///< vertices of a shell against the other solid
  std::uint64_t exact_fallbacks = 0;           ///< signs that the adaptive kernel had to find in exact arithmetic

  /// Adds each count to its own.
  Query_statistics& operator+=(const Query_statistics& other)
  {
    queries += other.queries, pairs_visited += other.pairs_visited, hull_tests += other.hull_tests,
        discarded_by_hull += other.discarded_by_hull;
    sphere_tests += other.sphere_tests, discarded_by_sphere += other.discarded_by_sphere,
        tetrahedron_tests += other.tetrahedron_tests;
    discarded_by_tetrahedron += other.discarded_by_tetrahedron, box_tests += other.box_tests,
        leaf_pairs += other.leaf_pairs;
    discarded_by_box += other.discarded_by_box, edge_face_tests += other.edge_face_tests,
        triangle_tests += other.triangle_tests, inclusion_tests += other.inclusion_tests;
    exact_fallbacks += other.exact_fallbacks;
    return *this;
  }

  /// All comparisons of bounding volumes.
  std::uint64_t bounding_tests() const { return hull_tests + sphere_tests + tetrahedron_tests + box_tests; }
  /// All tests of elements, which decide.
  std::uint64_t primitive_tests() const { return edge_face_tests + triangle_tests + inclusion_tests; }
};

}  // namespace tetracone::tetratree

#endif
