#ifndef TETRACONE_TETRATREE_CONTACT_FACE_PAIRS_H
#define TETRACONE_TETRATREE_CONTACT_FACE_PAIRS_H

#include "tetracone/covering/model.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/side_windings.h"
#include "tetracone/kernel/contact/integer_placing.h"
#include "tetracone/kernel/contact/rational_contact.h"
#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/kernel/predicate/face_contact.h"
#include "tetracone/kernel/predicate/kept_sides.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/triangle_contact.h"
#include "tetracone/kernel/predicate/triangle_contact8.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

using covering::Index;

/// A common piece of two faces, as a query finds it.
struct Found_piece {
  Index face_a, face_b;
  kernel::Piece kind;
  kernel::Feature in_a, in_b;         ///< the smallest part of either face that holds the piece
  kernel::Triangle_contact by_signs;  ///< for two triangles; count 0: the piece is stored in rationals
  Index kept = 0;                     ///< its index in `Found_contacts::kept`
};

/// All pieces, and the loops of the pieces that are stored in rationals.
struct Found_contacts {
  using Loops = std::vector<std::vector<kernel::Rational_point>>;
  std::vector<Found_piece> pieces;
  std::vector<Loops> kept;  ///< of pieces that signs do not describe
};

/// A face of A and a face of B. Corners are set for a triangle with a plane; otherwise the first corner is none.
struct Face_pair {
  using Corners = std::array<Index, 3>;
  Index face_a, face_b;
  const Corners *corners_a, *corners_b;

  bool are_triangles() const { return (*corners_a)[0] != covering::none && (*corners_b)[0] != covering::none; }
};

/// A body's faces, prepared for tests of pairs. The polyhedron must outlive this object.
class Contact_faces {
 public:
  /// The faces of a polyhedron, and its covering.
  explicit Contact_faces(const covering::Polyhedron& polyhedron, const covering::Covering& covering)
      : polyhedron_(&polyhedron)
  {
    triangles_.reserve(polyhedron.face_count());
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      const covering::Loop loop = polyhedron.loop(f, 0);
      const bool is_triangle = polyhedron.is_triangle(f) && covering.plane_basis(f);
      triangles_.push_back(is_triangle ? std::array{loop[0], loop[1], loop[2]}
                                       : std::array{covering::none, covering::none, covering::none});
    }
  }

  /// Finds the owners of all edges, unless they are known. `covering` is the constructor's.
  void own_edges(const covering::Covering& covering)
  {
    if (!owned_begin_.empty()) return;
    owned_begin_.push_back(0);
    std::vector<Index> owner(covering.edges().size(), covering::none);
    for (Index f = 0; f < triangles_.size(); ++f) {
      for (std::size_t k = 0; k < covering.from(f).size(); ++k) {
        std::array<Index, 2> edge = {covering.from(f)[k], covering.to(f)[k]};
        if (edge[1] < edge[0]) std::swap(edge[0], edge[1]);
        Index& first = owner[std::size_t(std::ranges::lower_bound(covering.edges(), edge) - covering.edges().begin())];
        if (first != covering::none) continue;
        first = f;
        owned_.push_back(edge);
      }
      owned_begin_.push_back(owned_.size());
    }
  }

  const covering::Polyhedron& polyhedron() const { return *polyhedron_; }
  /// Returns the corners of a triangle with a plane; none for another face.
  const std::array<Index, 3>& triangle(Index f) const { return triangles_[f]; }

  /// Returns the edges of a face that no earlier face has, as vertices, the smaller number first. So each edge is owned
  /// by one face. Requires `own_edges`.
  std::span<const std::array<Index, 2>> owned_edges(Index f) const
  {
    return std::span(owned_).subspan(owned_begin_[f], owned_begin_[f + 1] - owned_begin_[f]);
  }

 private:
  const covering::Polyhedron* polyhedron_;
  std::vector<std::array<Index, 3>> triangles_;  // none for other faces
  std::vector<std::array<Index, 2>> owned_;
  std::vector<std::size_t> owned_begin_;
};

/// The tests of pairs of faces of two placed bodies over K. Its arguments must outlive it.
template <class K>
class Face_pairs {
 public:
  using Body = covering::Placed_model<K>;

  /// The faces of A and of B.
  Face_pairs(const Contact_faces& a, const Contact_faces& b) : a_(a), b_(b) {}

  /// Returns a pair of faces for the next functions.
  Face_pair pair(Index face_a, Index face_b) const
  {
    return {face_a, face_b, &a_.triangle(face_a), &b_.triangle(face_b)};
  }

  /// Adds the common pieces of each pair, in the pairs' order. Requires an exact kernel, and `begin` after each change
  /// of a pose.
  void add_contacts(Body& a, const kernel::Pose& pose_a, Body& b, const kernel::Pose& pose_b,
                    std::span<const Face_pair> pairs,
                    Found_contacts& found) requires(kernel::Kernel_traits<K>::exact_motion)
  {
    const auto by_signs = [&](const Face_pair& pair) { add_contact(a, pose_a, b, pose_b, pair, found); };
    if constexpr (std::is_same_v<K, kernel::Adaptive>)
      filter(a.model().vertices(), pose_a, b.model().vertices(), pose_b, pairs, by_signs, found);
    else
      for (const Face_pair& pair : pairs) by_signs(pair);
  }

  /// Forgets the exact faces and signs of the last poses. Call it after each change of a pose.
  void begin()
  {
    kept_sides_.clear();
    placing_.reset();
    exact_faces_[0].clear();
    exact_faces_[1].clear();
  }

  /// Adds the contacts of the edges that either face owns with the other face. Requires `own_edges` of both bodies.
  void add_features(Body& a, Body& b, const Face_pair& pair, std::vector<kernel::Feature_pair>& found) const
  {
    const auto [face_a, face_b, corners_a, corners_b] = pair;
    if (pair.are_triangles()) {
      const auto p = corners(a, *corners_a), q = corners(b, *corners_b);
      const auto side_q = kernel::sides<K>(p, q);
      if (kernel::all_strictly_beside(side_q)) return;
      const auto side_p = kernel::sides<K>(q, p);
      if (kernel::all_strictly_beside(side_p)) return;
      add_edges(0, a_, a, face_a, side_p, q, face_b, found);
      add_edges(1, b_, b, face_b, side_q, p, face_a, found);
      return;
    }
    add_edges(0, a_, a, face_a, b, face_b, found);
    add_edges(1, b_, b, face_b, a, face_a, found);
  }

 private:
  using Feature = kernel::Feature;

  static kernel::Corners<K> corners(Body& body, const Face_pair::Corners& t)
  {
    return {&body.point(t[0]), &body.point(t[1]), &body.point(t[2])};
  }

  /// Adds the contacts that signs in double decide. Calls undecided(pair) for the other pairs, in their order.
  template <class Undecided>
  static void filter(const std::vector<kernel::Vertex>& a, const kernel::Pose& pose_a,
                     const std::vector<kernel::Vertex>& b, const kernel::Pose& pose_b, std::span<const Face_pair> pairs,
                     const Undecided& undecided, Found_contacts& found)
  {
    for (const Face_pair& pair : pairs) {
      __builtin_prefetch(pair.corners_a);
      __builtin_prefetch(pair.corners_b);
    }
    for (const Face_pair& pair : pairs) {
      if (!pair.are_triangles()) continue;
      for (const Index v : *pair.corners_a) __builtin_prefetch(&a[v]);
      for (const Index v : *pair.corners_b) __builtin_prefetch(&b[v]);
    }
    constexpr std::size_t lanes = kernel::Triangles8::count;
    kernel::Triangles8 p, q;
    for (std::size_t first = 0; first < pairs.size(); first += lanes) {
      const auto some = pairs.subspan(first, kernel::minimum(lanes, pairs.size() - first));
      unsigned triangles = 0;
      for (std::size_t lane = 0; lane < some.size(); ++lane) {
        if (!some[lane].are_triangles()) continue;
        triangles |= 1u << lane;
        const auto &s = *some[lane].corners_a, &t = *some[lane].corners_b;
        p.set(lane, a[s[0]], a[s[1]], a[s[2]]);
        q.set(lane, b[t[0]], b[t[1]], b[t[2]]);
      }
      kernel::Triangle_contacts8 contacts;
      if (triangles != 0) kernel::triangle_contacts8(p, pose_a, q, pose_b, contacts);
      for (std::size_t lane = 0; lane < some.size(); ++lane) {
        if (triangles & contacts.crossing & 1u << lane)
          found.pieces.push_back(piece(some[lane], contacts.contact(lane)));
        else if (!(triangles & contacts.apart & 1u << lane))
          undecided(some[lane]);
      }
    }
  }

  /// Adds the common pieces of a pair, by exact signs and rationals.
  void add_contact(Body& a, const kernel::Pose& pose_a, Body& b, const kernel::Pose& pose_b, const Face_pair& pair,
                   Found_contacts& found)
  {
    const auto [face_a, face_b, corners_a, corners_b] = pair;
    if (pair.are_triangles()) {
      const auto p = corners(a, *corners_a), q = corners(b, *corners_b);
      kernel::Triangle_contact contact;
      if constexpr (std::is_same_v<K, kernel::Adaptive>)
        contact = kernel::triangle_contact<K>(p, q, [this](const auto& t, const auto& x) { return kept_sides_(t, x); });
      else
        contact = kernel::triangle_contact<K>(p, q);
      if (contact.count > 0) found.pieces.push_back(piece(pair, contact));
      return;
    }
    if (is_beside(a, face_a, b, face_b) || is_beside(b, face_b, a, face_a)) return;
    if (!fraction_bits_)
      fraction_bits_ = {kernel::fraction_bits(a_.polyhedron().vertices),
                        kernel::fraction_bits(b_.polyhedron().vertices)};
    if (!placing_) placing_.emplace(std::array{&pose_a, &pose_b}, *fraction_bits_);
    for (kernel::Rational_piece& each : kernel::face_contact(exact_face(a_, 0, face_a), exact_face(b_, 1, face_b))) {
      found.pieces.push_back({face_a, face_b, each.kind, each.in_p, each.in_q, {}, Index(found.kept.size())});
      for (auto& loop : each.loops)
        for (kernel::Rational_point& x : loop)
          for (kernel::Rational& coordinate : x) coordinate /= placing_->scale;
      found.kept.push_back(std::move(each.loops));
    }
  }

  /// Returns the piece of two triangles that signs have decided.
  static Found_piece piece(const Face_pair& pair, const kernel::Triangle_contact& contact)
  {
    const auto held = [&](auto edges_of) {
      if (contact.count > 2) return Feature::interior;
      kernel::Edge_set common = 7;
      for (int k = 0; k < contact.count; ++k) common &= edges_of(contact.corners[k]);
      if (contact.count == 1 && std::popcount(common) == 2) return Feature::vertex;
      return common != 0 ? Feature::edge : Feature::interior;
    };
    const auto kind = contact.count == 1   ? kernel::Piece::point
                      : contact.count == 2 ? kernel::Piece::segment
                                           : kernel::Piece::polygon;
    return {pair.face_a,
            pair.face_b,
            kind,
            held([](const auto& corner) { return corner.on_p; }),
            held([](const auto& corner) { return corner.on_q; }),
            contact};
  }

  /// True when a face is strictly on one side of another's plane.
  static bool is_beside(Body& body, Index face, Body& other, Index plane)
  {
    const auto& basis = other.model().covering().plane_basis(plane);
    if (!basis) return false;
    const auto side = [&](Index v) {
      return kernel::volume_sign<K>(other.point((*basis)[0]), other.point((*basis)[1]), other.point((*basis)[2]),
                                    body.point(v));
    };
    const auto vertices = body.model().covering().from(face);
    const kernel::Sign first = side(vertices[0]);
    return first != kernel::ZERO && std::ranges::all_of(vertices, [&](Index v) { return side(v) == first; });
  }

  /// Returns a face times the placing's scale, from the cache if it is there.
  const kernel::Rational_face& exact_face(const Contact_faces& faces, int body, Index f)
  {
    const auto known = exact_faces_[body].find(f);
    if (known != exact_faces_[body].end()) return known->second;
    const auto place = [&](const kernel::Vertex& v) {
      const auto x = (*placing_)(body, v);
      return kernel::Rational_point{x[0], x[1], x[2]};
    };
    return exact_faces_[body].emplace(f, covering::placed_face(faces.polyhedron(), f, place)).first->second;
  }

  /// Adds contacts of the edges that a triangle owns with a triangle.
  static void add_edges(int number, const Contact_faces& faces, Body& body, Index owner,
                        const std::array<kernel::Sign, 3>& side, const kernel::Corners<K>& t, Index face,
                        std::vector<kernel::Feature_pair>& found)
  {
    const std::array<Index, 3>& corner = faces.triangle(owner);
    const auto side_of = [&](Index v) { return side[v == corner[0] ? 0 : v == corner[1] ? 1 : 2]; };
    for (const auto& [from, to] : faces.owned_edges(owner)) {
      const auto kind = kernel::segment_triangle<K>(body.point(from), body.point(to), *t[0], *t[1], *t[2],
                                                    side_of(from), side_of(to));
      if (kind != kernel::Contact::none) found.push_back({number, from, to, face, kind});
    }
  }

  /// Adds contacts of the edges that any face owns with any face.
  static void add_edges(int number, const Contact_faces& faces, Body& body, Index owner, Body& other, Index face,
                        std::vector<kernel::Feature_pair>& found)
  {
    for (const auto& [from, to] : faces.owned_edges(owner)) {
      const auto kind = covering::segment_face<K>(body.point(from), body.point(to), other, face);
      if (kind != kernel::Contact::none) found.push_back({number, from, to, face, kind});
    }
  }

  const Contact_faces &a_, &b_;
  std::optional<std::array<int, 2>> fraction_bits_;  // of the bodies; no pose changes them
  std::optional<kernel::Integer_placing> placing_;   // of the poses, once rationals were needed
  std::array<std::map<Index, kernel::Rational_face>, 2> exact_faces_;
  kernel::Kept_sides kept_sides_;  // of triangles, for the adaptive kernel
};

}  // namespace tetracone::tetratree

#endif
