#ifndef TETRACONE_TETRATREE_RELATION_PERTURBED_CONTACTS_H
#define TETRACONE_TETRATREE_RELATION_PERTURBED_CONTACTS_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/kernel/predicate/signs.h"
#include "tetracone/kernel/predicate/triangle_contact.h"
#include "tetracone/kernel/predicate/triangle_triangle.h"
#include "tetracone/tetratree/contact/face_pairs.h"
#include "tetracone/tetratree/relation/crossing_overlap.h"
#include "tetracone/tetratree/relation/placed_solid.h"
#include "tetracone/tetratree/relation/simple_relation.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tetracone::tetratree {

/// The contacts of two simple solids after A has been moved by (e, e^2, e^3), e > 0 and infinitesimal.
///
/// They are in general position: all are segments, and no corner is in the plane of a face that it touched. The
/// overlap's volume and moment are continuous in a translation, so those of the solids
/// themselves are the limits. These are sums over the points where edges cross faces. Such an edge is not parallel to
/// the face's plane, and a translation keeps that. So the point has a limit, on the edge and on the face.
///
/// - Only faces that share a point now can share one then.
/// - A side that is not 0 remains. Else it has the sign of the first of its derivatives that is not 0. These are the
///   components of the plane's normal n for a corner of A, and of -n for a corner of B.
/// - The sign of an edge e of A against an edge f of B has the components of e x f as its derivatives. Only edges that
///   are not parallel are compared, since one goes through a plane that holds the other.
class Perturbed_contacts {
 public:
  using K = kernel::Adaptive;

  /// Requires simple solids, and that `found` is all that their surfaces share. The models have the solids' vertices,
  /// and are placed as the solids are.
  Perturbed_contacts(Placed_solid& a, covering::Placed_model<K>& model_a, Placed_solid& b,
                     covering::Placed_model<K>& model_b, const Found_contacts& found)
      : solid_{&a, &b}, model_{&model_a, &model_b}
  {
    for (int body = 0; body < 2; ++body) is_on_other_[body].assign(solid_[body]->sides().place_count(), false);
    for (const Found_piece& piece : found.pieces) {
      for (int body = 0; body < 2; ++body)
        mark_vertices(piece, body, solid_[body]->polyhedron(), solid_[body]->sides(), is_on_other_[body]);
      Found_piece perturbed = piece;  // a crossing segment stays as it is
      if (!is_crossing_segment(piece.by_signs)) perturbed.by_signs = contact(piece);
      if (perturbed.by_signs.count != 0) contacts.pieces.push_back(perturbed);
    }
  }

  /// True when a vertex of a body is on the other surface before the move.
  bool is_on_other(int body, Index v) const { return is_on_other_[body][solid_[body]->sides().place(v)]; }

  Found_contacts contacts;  ///< after the move; `kind` and `in_a`, `in_b` are those before it

 private:
  Index vertex(int body, Index f, int k) const { return solid_[body]->polyhedron().loop(f, 0)[std::size_t(k)]; }

  /// Returns what two faces share after the move.
  kernel::Triangle_contact contact(const Found_piece& piece)
  {
    const auto corners = [this](int body, Index f) {
      const auto at = [&](int k) { return &model_[body]->point(vertex(body, f, k)); };
      return kernel::Corners<K>{at(0), at(1), at(2)};
    };
    const kernel::Corners<K> p = corners(0, piece.face_a), q = corners(1, piece.face_b);
    std::array<kernel::Sign, 3> side_p, side_q;
    for (std::size_t k = 0; k < 3; ++k) {
      side_p[k] = kernel::perturbed_side<K>(*q[0], *q[1], *q[2], *p[k]);
      // B's corner moves against A's plane by the opposite.
      const kernel::Sign side = kernel::volume_sign<K>(*p[0], *p[1], *p[2], *q[k]);
      side_q[k] = side != kernel::ZERO ? side : -kernel::perturbed_side<K>(*p[0], *p[1], *p[2], *p[0]);
    }
    if (kernel::all_strictly_beside(side_p) || kernel::all_strictly_beside(side_q)) return {};
    return kernel::detail::crossing_contact(side_p, side_q, [&](int p0, int pi, int q0, int qj) {
      const kernel::Sign sign = kernel::volume_sign<K>(*p[p0], *p[pi], *q[q0], *q[qj]);
      if (sign != kernel::ZERO) return sign;
      const auto e = step(0, piece.face_a, p0, pi), f = step(1, piece.face_b, q0, qj);
      for (const kernel::Rational& x : kernel::cross(e, f))
        if (const int of_x = sgn(x); of_x != 0) return of_x > 0 ? kernel::POSITIVE : kernel::NEGATIVE;
      return kernel::ZERO;
    });
  }

  /// Returns corner `to` of a placed triangle less corner `from`.
  Rational_point step(int body, Index f, int from, int to)
  {
    const auto& edges = solid_[body]->face(f).edges();
    return kernel::difference(edges[std::size_t(to)].first, edges[std::size_t(from)].first);
  }

  std::array<Placed_solid*, 2> solid_;
  std::array<covering::Placed_model<K>*, 2> model_;
  std::array<std::vector<bool>, 2> is_on_other_;  // by place
};

}  // namespace tetracone::tetratree

#endif
