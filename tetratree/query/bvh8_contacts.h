#ifndef TETRACONE_TETRATREE_QUERY_BVH8_CONTACTS_H
#define TETRACONE_TETRATREE_QUERY_BVH8_CONTACTS_H

#include "tetracone/tetratree/contact/face_pairs.h"
#include "tetracone/tetratree/query/bvh8_collision.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetracone::tetratree {

/// All contacts of two `Bvh8` over kernel K, and all pairs of features. It runs the descent of `Bvh8_collision` to its
/// end, and decides each pair of faces once. Requires and throws as `Bvh8_collision`.
template <class K = kernel::Adaptive>
class Bvh8_contacts {
 public:
  Bvh8_contacts(const Bvh8& a, const covering::Model<K>& model_a, const covering::Polyhedron& polyhedron_a,
                const Bvh8& b, const covering::Model<K>& model_b, const covering::Polyhedron& polyhedron_b)
      : collision_(a, model_a, b, model_b),
        faces_a_(polyhedron_a, model_a.covering()),
        faces_b_(polyhedron_b, model_b.covering()),
        pairs_(faces_a_, faces_b_),
        one_element_a_(is_one_element(a, faces_a_)),
        one_element_b_(is_one_element(b, faces_b_)),
        has_polygons_(has_polygon(polyhedron_a) || has_polygon(polyhedron_b))
  {}

  /// Returns the common pieces of pairs of faces, sorted by faces. Requires det M != 0 of both poses, and an exact
  /// kernel.
  Found_contacts contacts(const Pose& pose_a, const Pose& pose_b) requires(kernel::Kernel_traits<K>::exact_motion)
  {
    Found_contacts found;
    // A pair of faces that are not triangles is decided in rationals, which takes longer than to know that none meets.
    if (has_polygons_ && collision_.relation(pose_a, pose_b, kernel::Question::surface) == kernel::Relation::apart)
      return found;
    found.pieces.reserve(last_count_ + last_count_ / 4 + 16);
    pairs_.begin();
    find_candidates(pose_a, pose_b);
    pairs_.add_contacts(collision_.placed_a(), pose_a, collision_.placed_b(), pose_b, candidates_, found);
    // The pieces of one pair keep their order.
    std::sort(found.pieces.begin(), found.pieces.end(), [](const Found_piece& one, const Found_piece& other) {
      const auto pair = [](const Found_piece& piece) { return std::uint64_t(piece.face_a) << 32 | piece.face_b; };
      return pair(one) != pair(other) ? pair(one) < pair(other) : one.kept < other.kept;
    });
    last_count_ = found.pieces.size();
    return found;
  }

  /// Returns all pairs of an edge of one body and a face of the other that share a point, sorted. Requires det M != 0.
  std::vector<kernel::Feature_pair> features(const Pose& pose_a, const Pose& pose_b)
  {
    std::vector<kernel::Feature_pair> found;
    find_candidates(pose_a, pose_b);
    if (candidates_.empty()) return found;
    faces_a_.own_edges(collision_.placed_a().model().covering());
    faces_b_.own_edges(collision_.placed_b().model().covering());
    for (const Face_pair& pair : candidates_)
      pairs_.add_features(collision_.placed_a(), collision_.placed_b(), pair, found);
    std::sort(found.begin(), found.end());
    return found;
  }

  const Query_statistics& counts() const { return collision_.counts(); }
  void clear_counts() { collision_.clear_counts(); }

 private:
  /// True when every face is one element, which the descent meets once.
  static bool is_one_element(const Bvh8& tree, const Contact_faces& faces)
  {
    return tree.element_count() == faces.polyhedron().face_count();
  }

  static bool has_polygon(const covering::Polyhedron& body)
  {
    for (covering::Index f = 0; f < body.face_count(); ++f)
      if (!body.is_triangle(f)) return true;
    return false;
  }

  /// Writes each pair of faces of which some elements were not discarded, once.
  void find_candidates(const Pose& pose_a, const Pose& pose_b)
  {
    candidates_.clear();
    collision_.for_element_pairs(pose_a, pose_b, [&](const Element& a, const Element& b) {
      candidates_.push_back(pairs_.pair(a.face, b.face));
    });
    if (one_element_a_ && one_element_b_) return;
    const auto faces = [](const Face_pair& pair) { return std::uint64_t(pair.face_a) << 32 | pair.face_b; };
    std::ranges::sort(candidates_, {}, faces);
    const auto same = [&](const Face_pair& first, const Face_pair& second) { return faces(first) == faces(second); };
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end(), same), candidates_.end());
  }

  Bvh8_collision<K> collision_;
  Contact_faces faces_a_, faces_b_;
  Face_pairs<K> pairs_;
  bool one_element_a_, one_element_b_, has_polygons_;
  std::vector<Face_pair> candidates_;
  std::size_t last_count_ = 0;  // pieces of the last pose; the next one has about as many
};

}  // namespace tetracone::tetratree

#endif
