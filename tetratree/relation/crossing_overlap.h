#ifndef TETRACONE_TETRATREE_RELATION_CROSSING_OVERLAP_H
#define TETRACONE_TETRATREE_RELATION_CROSSING_OVERLAP_H

#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/contact/crossing_cones.h"
#include "tetracone/kernel/contact/integer_placing.h"
#include "tetracone/kernel/number/interval.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/face_contact.h"
#include "tetracone/tetratree/contact/face_pairs.h"
#include "tetracone/tetratree/relation/placed_solid.h"
#include "tetracone/tetratree/relation/simple_relation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

using kernel::Interval;

/// The placed vertices of two bodies in intervals, relative to a point near them. Requires upward rounding.
class Interval_placing {
 public:
  using Number = Interval;

  /// The origin is near a placed vertex of A. Requires solids with a vertex.
  Interval_placing(const std::array<const Placed_solid*, 2>& solids)
  {
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 12; ++k) {
        const kernel::Pose& pose = solids[body]->pose();
        map_[body][k] = pose.is_rational() ? Interval(CGAL::to_interval(pose.exact(k))) : Interval(pose[k]);
      }
    const auto near = (*this)(0, solids[0]->polyhedron().vertices[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      origin[k] = near[k].sup();
      for (auto& map : map_) map[4 * k + 3] -= origin[k];
    }
  }

  /// Returns an enclosure of the placed vertex less `origin`.
  kernel::Number_point<Interval> operator()(int body, const kernel::Vertex& v) const
  {
    return kernel::image(v, map_[body]);
  }

  std::array<double, 3> origin{};  ///< taken from all coordinates

 private:
  std::array<std::array<Interval, 12>, 2> map_;
};

/// True for a segment at whose ends edges cross the insides of faces.
inline bool is_crossing_segment(const kernel::Triangle_contact& x)
{
  return x.count == 2 && is_crossing(x.corners[0]) && is_crossing(x.corners[1]);
}

/// True when a vertex of a body is on the other surface. Empty: no vertex is.
using Is_on_other = std::function<bool(int body, Index v)>;

/// The overlap of two simple solids in general position. All that their surfaces share are segments. At each end an
/// edge of one solid goes through the inside of a face of the other. No face needs to be cut into cells then.
///
/// It is also the limit of overlaps, where the contacts are those after an infinitesimal move: `Perturbed_contacts`.
/// The ends of a segment may be equal then, and vertices may be on the other surface.
template <class Placing>
class Crossing_overlap {
 public:
  using N = typename Placing::Number;

  /// Sums up the overlap. Calls `is_vertex_inside` in the constructor only, for vertices off the other surface.
  /// Requires contacts as `is_general` wants them, or as `Perturbed_contacts` has them. Requires upward rounding for
  /// intervals. Throws
  /// CGAL::Uncertain_conversion_exception where intervals do not decide a sign.
  Crossing_overlap(const Placed_solid& a, const Placed_solid& b, const Found_contacts& found,
                   const Is_vertex_inside& is_vertex_inside, const Is_on_other& is_on_other = {})
      : placing(placing_of(a, b)),
        solid_{&a, &b},
        joined_{covering::Union_find(a.sides().place_count()), covering::Union_find(b.sides().place_count())},
        is_vertex_inside_(is_vertex_inside),
        is_on_other_(is_on_other)
  {
    for (const Found_piece& piece : found.pieces) {
      place(0, piece.face_a);
      place(1, piece.face_b);
    }
    for (const Found_piece& piece : found.pieces) add(piece);
    for (int body = 0; body < 2; ++body) {
      join_edges(body);
      add_edges_and_whole_faces(body);
    }
  }

  /// False where all vertices of a part that no edge crosses are on the other surface. Then the sums are of no use.
  bool is_decided() const { return is_decided_; }

  /// Returns the volume and the centroid. Faces that are wholly inside are summed over the model.
  kernel::Exact_solid value() requires std::is_same_v<N, mpz_class>
  {
    kernel::Volume_moment whole;
    for (int body = 0; body < 2; ++body)
      if (has_whole_[body]) whole += whole_[body].placed(solid_[body]->map());
    return cones.sums.value(placing.scale, whole);
  }

  Placing placing;                  ///< which coordinates the sums have
  kernel::Crossing_cones<N> cones;  ///< the sums

 private:
  using Crossing = kernel::Edge_crossing<N>;

  static Placing placing_of(const Placed_solid& a, const Placed_solid& b)
  {
    if constexpr (std::is_same_v<Placing, kernel::Integer_placing>)
      return {{&a.pose(), &b.pose()}, {a.sides().fraction_bits(), b.sides().fraction_bits()}};
    else
      return {{&a, &b}};
  }

  /// A face that meets the other body, and the crossings of its edges.
  struct Cut_face {
    kernel::Cone_triangle<N> triangle;
    std::array<int, 3> entered{};       // by edge k, from corner k to the next: crossings that enter, less the others
    std::vector<Crossing> of_far_edge;  // the edge that cones need, edge 1
  };

  kernel::Cone_triangle<N> triangle(int body, Index f) const
  {
    const covering::Polyhedron& polyhedron = solid_[body]->polyhedron();
    kernel::Cone_triangle<N> triangle;
    triangle.outward = solid_[body]->plain_sides(f).against ? 1 : -1;
    for (int k = 0; k < 3; ++k) triangle.corner[k] = placing(body, polyhedron.vertices[polyhedron.loop(f, 0)[k]]);
    return triangle;
  }

  void place(int body, Index f)
  {
    const auto [at, is_new] = cut_[body].try_emplace(f);
    if (is_new) at->second.triangle = triangle(body, f);
  }

  /// Adds the segment that two faces share.
  void add(const Found_piece& piece)
  {
    const std::array<Cut_face*, 2> cut = {&cut_[0].at(piece.face_a), &cut_[1].at(piece.face_b)};
    const auto crossing = [&](const kernel::Triangle_contact::Corner& corner) {
      const int body = corner.on_p != 0 ? 0 : 1;
      const int edge = std::countr_zero(unsigned(body == 0 ? corner.on_p : corner.on_q));
      Cut_face& own = *cut[body];
      const auto& corners = own.triangle.corner;
      Crossing found(corners[edge], corners[(edge + 1) % 3], cut[1 - body]->triangle);
      if constexpr (std::is_same_v<N, mpz_class>) found.number = number(body, edge, piece);
      own.entered[edge] += found.enters ? 1 : -1;
      if (edge == 1) own.of_far_edge.push_back(found);
      return found;
    };
    const Crossing x = crossing(piece.by_signs.corners[0]), y = crossing(piece.by_signs.corners[1]);
    cones.add_contact(cut[0]->triangle, cut[1]->triangle, x, y);
  }

  /// Returns the number of a crossing of an edge of a body. Both faces at the edge have it.
  std::uint32_t number(int body, int edge, const Found_piece& piece)
  {
    const Index own = body == 0 ? piece.face_a : piece.face_b, other = body == 0 ? piece.face_b : piece.face_a;
    const covering::Loop v = solid_[body]->polyhedron().loop(own, 0);
    const Solid_sides& sides = solid_[body]->sides();
    const Index from = sides.place(v[edge]), to = sides.place(v[(edge + 1) % 3]);
    return numbers_
        .try_emplace({Index(body), kernel::minimum(from, to), kernel::maximum(from, to), other},
                     std::uint32_t(numbers_.size()))
        .first->second;
  }

  /// Joins the ends of edges that are both inside or both outside, and notes which ends of the other edges are inside.
  void join_edges(int body)
  {
    const covering::Polyhedron& polyhedron = solid_[body]->polyhedron();
    const Solid_sides& sides = solid_[body]->sides();
    std::vector<std::pair<Index, bool>> told;
    for_faces(body, [&](Index f, const Cut_face* cut) {
      const covering::Loop v = polyhedron.loop(f, 0);
      for (int k = 0; k < 3; ++k) {
        const Index from = sides.place(v[k]), to = sides.place(v[(k + 1) % 3]);
        const int entered = cut == nullptr ? 0 : cut->entered[k];
        if (entered == 0) {
          joined_[body].join(from, to);
        } else {
          told.emplace_back(from, entered < 0);
          told.emplace_back(to, entered > 0);
        }
      }
    });
    for (const auto& [place, is_inside] : told) is_inside_[body][joined_[body].root(place)] = is_inside;
  }

  /// True when a vertex is inside the other body. `is_vertex_inside` is asked where no crossing decides.
  bool is_inside(int body, Index v)
  {
    const auto [at, is_new] = is_inside_[body].try_emplace(joined_[body].root(solid_[body]->sides().place(v)));
    if (is_new) {
      // Intervals have set another rounding mode, in which nothing else may be asked.
      const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
      const Index asked = off_other(body, v);
      if (asked == covering::none)
        is_decided_ = false;
      else
        at->second = is_vertex_inside_(body, asked);
    }
    return at->second;
  }

  /// Returns a vertex off the other surface that is inside or outside together with v; `none` if there is none.
  Index off_other(int body, Index v)
  {
    if (!is_on_other_ || !is_on_other_(body, v)) return v;
    const Solid_sides& sides = solid_[body]->sides();
    const Index root = joined_[body].root(sides.place(v));
    for (Index w = 0; w < solid_[body]->polyhedron().vertices.size(); ++w)
      if (joined_[body].root(sides.place(w)) == root && !is_on_other_(body, w)) return w;
    return covering::none;
  }

  /// Adds the edges of faces that meet the other body, and the faces that lie wholly inside it.
  void add_edges_and_whole_faces(int body)
  {
    const covering::Polyhedron& polyhedron = solid_[body]->polyhedron();
    for_faces(body, [&](Index f, const Cut_face* cut) {
      const covering::Loop v = polyhedron.loop(f, 0);
      if (cut != nullptr)
        cones.add_edge(cut->triangle, cut->of_far_edge, is_inside(body, v[2]));
      else if (is_inside(body, v[0]))
        add_whole(body, f);
    });
  }

  void add_whole(int body, Index f)
  {
    if constexpr (std::is_same_v<N, mpz_class>) {
      const covering::Polyhedron& polyhedron = solid_[body]->polyhedron();
      const covering::Loop v = polyhedron.loop(f, 0);
      whole_[body].add(solid_[body]->sides().of(f).back ? 1 : -1, polyhedron.vertices[v[0]], polyhedron.vertices[v[1]],
                       polyhedron.vertices[v[2]]);
      has_whole_[body] = true;
    } else {
      cones.add_whole(triangle(body, f));
    }
  }

  /// Calls what(face, cut face or null) for all faces, in order.
  template <class What>
  void for_faces(int body, const What& what) const
  {
    auto cut = cut_[body].begin();
    for (Index f = 0; f < solid_[body]->polyhedron().face_count(); ++f) {
      const bool is_cut = cut != cut_[body].end() && cut->first == f;
      what(f, is_cut ? &cut->second : nullptr);
      if (is_cut) ++cut;
    }
  }

  std::array<const Placed_solid*, 2> solid_;
  std::array<std::map<Index, Cut_face>, 2> cut_;
  std::map<std::array<Index, 4>, std::uint32_t> numbers_;  // of crossings: by body, ends of the edge, other face
  std::array<covering::Union_find, 2> joined_;
  Is_vertex_inside is_vertex_inside_;
  Is_on_other is_on_other_;
  bool is_decided_ = true;
  std::array<std::map<Index, bool>, 2> is_inside_;  // by the root of the vertex's place
  std::array<kernel::Model_cones, 2> whole_;
  std::array<bool, 2> has_whole_{};
};

/// True where two solids are simple, and each piece is a crossing segment.
inline bool is_general(const Placed_solid& a, const Placed_solid& b, const Found_contacts& found)
{
  return a.sides().is_simple() && b.sides().is_simple() &&
         std::ranges::all_of(found.pieces, is_crossing_segment, &Found_piece::by_signs);
}

/// A volume and a centroid in intervals.
struct Overlap_enclosure {
  Interval volume = 0;
  kernel::Number_point<Interval> centroid = {0, 0, 0};
};

/// Returns enclosures of the volume and the centroid of the overlap of two placed solids; nothing where intervals do
/// not suffice. Requires `is_general`.
inline std::optional<Overlap_enclosure> enclosed_overlap(const Placed_solid& a, const Placed_solid& b,
                                                         const Found_contacts& found,
                                                         const Is_vertex_inside& is_vertex_inside)
{
  const CGAL::Protect_FPU_rounding<true> upward;
  try {
    const Crossing_overlap<Interval_placing> overlap(a, b, found, is_vertex_inside);
    const auto& [volume, moment] = overlap.cones.sums;
    Overlap_enclosure enclosure;
    if (found.pieces.empty() && CGAL::is_zero(volume)) return enclosure;
    enclosure.volume = volume / 6;
    bool is_finite = CGAL::is_finite(enclosure.volume) && enclosure.volume.inf() > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      enclosure.centroid[k] = moment[k] / (4 * volume) + overlap.placing.origin[k];
      is_finite = is_finite && CGAL::is_finite(enclosure.centroid[k]);
    }
    return is_finite ? std::optional(enclosure) : std::nullopt;
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return std::nullopt;
  }
}

}  // namespace tetracone::tetratree

#endif
