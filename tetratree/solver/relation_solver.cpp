#include "tetracone/tetratree/door/relation_solver.h"

#include "tetracone/kernel/contact/direction_view.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/penetration/depth_search.h"
#include "tetracone/tetratree/penetration/exit_search.h"
#include "tetracone/tetratree/penetration/near_origin.h"
#include "tetracone/tetratree/penetration/seen_solid.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "tetracone/tetratree/query/bvh8_contacts.h"
#include "tetracone/tetratree/relation/crossing_overlap.h"
#include "tetracone/tetratree/relation/perturbed_contacts.h"
#include "tetracone/tetratree/relation/simple_relation.h"
#include "tetracone/tetratree/relation/solid_pair.h"
#include "tetracone/tetratree/relation/solid_sides.h"
#include "tetracone/tetratree/solver/convex_depths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::detail {
namespace {

using kernel::Solid_contact;
using kernel::Solid_relation;
using tetratree::Placed_solid;
using tetratree::Solid_pair;
using tetratree::Solid_piece;

class Bvh8_relation_solver : public Relation_solver {
 public:
  Bvh8_relation_solver(const Shared_body& a, const Shared_body& b)
      : body_{a, b}, collision_(a->bvh8(), a->bvh8().model(), b->bvh8(), b->bvh8().model())
  {}

  Solid_relation relation_alone(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    if (const auto known = known_relation(pose_a, pose_b)) return *known;
    return relation_by(pose_a, pose_b, contacts(pose_a, pose_b));
  }

  Solid_contact relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    const auto known = known_relation(pose_a, pose_b);
    if (known == Solid_relation::disjoint) return {*known, -1};
    tetratree::Found_contacts found = contacts(pose_a, pose_b);
    const int dimension = dimension_of(found);
    if (known) return {*known, dimension};
    return {relation_by(pose_a, pose_b, std::move(found)), dimension};
  }

  Overlap overlap(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    if (is_apart(pose_a, pose_b)) return {};
    return exact_overlap(pose_a, pose_b, contacts(pose_a, pose_b));
  }

  Overlap_bounds overlap_bounds(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    Overlap_bounds bounds;
    if (is_apart(pose_a, pose_b)) return bounds;
    tetratree::Found_contacts found = contacts(pose_a, pose_b);
    if (place_general(pose_a, pose_b, found))
      if (const auto enclosure = tetratree::enclosed_overlap(exact_parts().pair.solid(0), exact_parts().pair.solid(1),
                                                             found, is_vertex_inside())) {
        const auto ends = [](const kernel::Interval& x) { return std::array<double, 2>{x.inf(), x.sup()}; };
        bounds.volume = ends(enclosure->volume);
        for (std::size_t k = 0; k < 3; ++k) bounds.centroid[k] = ends(enclosure->centroid[k]);
        return bounds;
      }
    const Overlap exact = exact_overlap(pose_a, pose_b, std::move(found));
    const auto ends = [](const kernel::Wide_fraction& x) {
      const auto [low, high] = CGAL::to_interval(kernel::shortened(x.top, x.bottom));
      return std::array<double, 2>{low, high};
    };
    if (!exact.data->has_volume()) return bounds;
    bounds.volume = ends(exact.data->solid.volume);
    for (std::size_t k = 0; k < 3; ++k) bounds.centroid[k] = ends(exact.data->solid.centroid[k]);
    return bounds;
  }

  std::vector<std::vector<kernel::Rational_point>> overlap_border(const kernel::Pose& pose_a,
                                                                  const kernel::Pose& pose_b) override
  {
    std::vector<std::vector<kernel::Rational_point>> parts;
    place(contacts_data(pose_a, pose_b, contacts(pose_a, pose_b)));
    exact_parts().pair.for_border_parts(
        [&](const auto& corners) { parts.emplace_back(corners.begin(), corners.end()); });
    return parts;
  }

  Exits exits(const kernel::Pose& pose_a, const kernel::Pose& pose_b,
              const std::array<kernel::Rational, 3>& direction) override
  {
    Exits exits;
    if (!interiors_meet(relation_alone(pose_a, pose_b))) return exits;
    const tetratree::Near_origin near = near_origin(pose_a, pose_b);
    const kernel::Direction_view view(direction);
    const tetratree::Exit_heights heights = exit_heights(near.pose[0], near.pose[1], direction, view);
    const auto given = [&](const kernel::Rational& height) {
      return kernel::times_power(height / view.height(), near.exponent);
    };
    write(given(heights.first), exits.first, exits.exact_first);
    write(given(heights.last), exits.last, exits.exact_last);
    return exits;
  }

  Depth depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth_options& options) override
  {
    if (!interiors_meet(relation_alone(pose_a, pose_b))) return {};
    const tetratree::Near_origin near = near_origin(pose_a, pose_b);
    if (!convex_depths_) convex_depths_.emplace(body_);
    const auto by_convex = (*convex_depths_)(near.pose[0], near.pose[1]);
    if (by_convex && by_convex->is_as_narrow_as(options.relative)) return depth_of(scaled(*by_convex, near.exponent));
    if (!depth_search_) {
      const Body_data &a = body_[0]->by_triangles(), &b = body_[1]->by_triangles();
      const auto inner = [](const Body_data& body) {
        return tetratree::Inner_balls(body.bvh8(), body.point_locator(), body.solid_sides().is_simple());
      };
      depth_search_.emplace(seen(a), seen(b), inner(a), inner(b));
    }
    const auto exit = [&](const kernel::Rational_point& direction) {
      const kernel::Direction_view view(direction);
      const kernel::Rational first = exit_heights(near.pose[0], near.pose[1], direction, view).first / view.height();
      tetratree::Depth_search::Exit found{direction, {}};
      for (kernel::Rational& x : found.vector) x *= first;
      for (const auto& normal : exit_search_->normals()) found.normals.push_back(view.normal(normal));
      return found;
    };
    const auto meet = [&](const kernel::Rational_point& v) { return meet_after(near.pose[0], near.pose[1], v, 1); };
    tetratree::Depth_bracket found = (*depth_search_)(kernel::rows_of(near.pose[0]), kernel::rows_of(near.pose[1]),
                                                      exit, meet, {options.relative, options.budget});
    if (by_convex) found.narrow(*by_convex);
    return depth_of(scaled(std::move(found), near.exponent));
  }

  tetratree::Query_statistics statistics() const override
  {
    tetratree::Query_statistics all = collision_.counts();
    if (exact_parts_) all += exact_parts_->contacts.counts();
    if (exit_search_) all += exit_search_->counts();
    return all;
  }
  void clear_statistics() override
  {
    collision_.clear_counts();
    if (exact_parts_) exact_parts_->contacts.clear_counts();
    if (exit_search_) exit_search_->clear_counts();
  }

 private:
  using K = kernel::Adaptive;

  bool is_apart(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
  {
    return collision_.relation(pose_a, pose_b, Question::solid, &memory_) == Relation::apart;
  }

  tetratree::Is_vertex_inside is_vertex_inside()
  {
    return [this](int body, Index v) { return collision_.is_vertex_inside(body, v); };
  }

  /// Places the solids, and returns true, where they are in general position.
  bool place_general(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const tetratree::Found_contacts& found)
  {
    Placed_solid &a = exact_parts().pair.solid(0), &b = exact_parts().pair.solid(1);
    if (!tetratree::is_general(a, b, found)) return false;
    a.place(pose_a);
    b.place(pose_b);
    return true;
  }

  Overlap exact_overlap(const kernel::Pose& pose_a, const kernel::Pose& pose_b, tetratree::Found_contacts contacts)
  {
    tetratree::Solid_overlap found;
    if (place_general(pose_a, pose_b, contacts)) {
      found.all = tetratree::Crossing_overlap<kernel::Integer_placing>(
                      exact_parts().pair.solid(0), exact_parts().pair.solid(1), contacts, is_vertex_inside())
                      .value();
    } else {
      const Contacts_data data = contacts_data(pose_a, pose_b, std::move(contacts));
      if (auto by_limit = overlap_by_limit(data)) {
        found = std::move(*by_limit);
      } else {
        place(data);
        found = exact_parts().pair.overlap();
      }
    }
    Overlap overlap;
    const auto exact = std::make_shared<Overlap_data>();
    exact->solid = std::move(found.all);
    for (std::size_t k = 0; k < 3; ++k) {
      exact->contact_vector[k] = found.contact_vector[k];
      overlap.contact_vector[k] = kernel::nearest_double(found.contact_vector[k]);
    }
    const auto nearest = [](const kernel::Wide_fraction& x) {
      return kernel::nearest_double(kernel::shortened(x.top, x.bottom));
    };
    overlap.volume = nearest(exact->solid.volume);
    if (exact->has_volume())
      for (std::size_t k = 0; k < 3; ++k) overlap.centroid[k] = nearest(exact->solid.centroid[k]);
    overlap.data = exact;
    overlap.contact_area = kernel::enclosed_root_sum(found.squared_areas);
    return overlap;
  }

  /// Returns the overlap as the limit of overlaps in general position; nothing where that does not decide.
  std::optional<tetratree::Solid_overlap> overlap_by_limit(const Contacts_data& data)
  {
    if (!are_simple()) return std::nullopt;
    Placed_solid &a = exact_parts().pair.solid(0), &b = exact_parts().pair.solid(1);
    a.place(data.pose_a);
    b.place(data.pose_b);
    const tetratree::Perturbed_contacts perturbed(a, collision_.placed_a(), b, collision_.placed_b(), data.found);
    tetratree::Crossing_overlap<kernel::Integer_placing> sums(
        a, b, perturbed.contacts, is_vertex_inside(),
        [&](int body, Index v) { return perturbed.is_on_other(body, v); });
    if (!sums.is_decided()) return std::nullopt;
    tetratree::Solid_overlap overlap;
    overlap.all = sums.value();
    add_contact(data, overlap);
    return overlap;
  }

  /// Adds the areas where faces of simple solids lie on one another. Each polygon that two faces share is a piece.
  void add_contact(const Contacts_data& data, tetratree::Solid_overlap& overlap)
  {
    Placed_solid& a = exact_parts().pair.solid(0);
    std::map<Index, kernel::Rational_point> twice;  // by faces of A, along their normals
    for (std::size_t k = 0; k < data.found.pieces.size(); ++k) {
      const tetratree::Found_piece& piece = data.found.pieces[k];
      if (piece.kind != kernel::Piece::polygon) continue;
      const auto loop = rational_loops(data, k).front();
      kernel::Rational_point area = {0, 0, 0};
      for (std::size_t c = 0; c < loop.size(); ++c) {
        const auto cross = kernel::cross(loop[c], loop[(c + 1) % loop.size()]);
        for (std::size_t i = 0; i < 3; ++i) area[i] += cross[i];
      }
      const bool is_turned = sgn(kernel::dot(area, a.face(piece.face_a).normal())) < 0;
      kernel::Rational_point& sum = twice[piece.face_a];
      for (std::size_t i = 0; i < 3; ++i) sum[i] += is_turned ? kernel::Rational(-area[i]) : area[i];
    }
    for (const auto& [face, area] : twice) {
      overlap.squared_areas.push_back(kernel::dot(area, area) / 4);
      const int outward = a.plain_sides(face).against ? 1 : -1;
      for (std::size_t i = 0; i < 3; ++i) overlap.contact_vector[i] += outward * area[i] / 2;
    }
  }

  tetratree::Near_origin near_origin(const kernel::Pose& pose_a, const kernel::Pose& pose_b) const
  {
    return tetratree::near_origin(pose_a, body_[0]->by_triangles().bvh8().scale(), pose_b);
  }

  /// Returns the bracket times 2^exponent.
  static tetratree::Depth_bracket scaled(tetratree::Depth_bracket found, int exponent)
  {
    if (exponent == 0) return found;
    const double least = std::ldexp(found.least, exponent);
    // Below the normal doubles the product is rounded.
    found.least = least < std::numeric_limits<double>::min() ? std::nextafter(least, 0.0) : least;
    found.square = kernel::times_power(found.square, 2 * exponent);
    for (kernel::Rational& x : found.vector) x = kernel::times_power(x, exponent);
    return found;
  }

  static Depth depth_of(const tetratree::Depth_bracket& found)
  {
    Depth depth;
    const auto [low, high] = kernel::enclosed_root_sum(std::array{found.square});
    depth.low = found.is_exact ? low : kernel::minimum(found.least, low);
    depth.high = high;
    depth.is_exact = found.is_exact;
    depth.exact_square = kernel::to_string(found.square);
    for (std::size_t k = 0; k < 3; ++k) write(found.vector[k], depth.vector[k], depth.exact_vector[k]);
    return depth;
  }

  /// True when the interiors share a point after A has moved by s d.
  bool meet_after(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const kernel::Rational_point& d,
                  const kernel::Rational& s)
  {
    const auto [moved, unmoved] = kernel::moved_along(pose_a, pose_b, d, s);
    return interiors_meet(relation_alone(moved, unmoved));
  }

  /// Returns the heights of the exits in the view. Requires interiors that share a point.
  tetratree::Exit_heights exit_heights(const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                                       const kernel::Rational_point& direction, const kernel::Direction_view& view)
  {
    if (!exit_search_) exit_search_.emplace(seen(body_[0]->by_triangles()), seen(body_[1]->by_triangles()));
    return (*exit_search_)(view.of(pose_a), view.of(pose_b), [&](const kernel::Rational& rise) {
      return meet_after(pose_a, pose_b, direction, rise / view.height());
    });
  }

  static tetratree::Seen_solid seen(const Body_data& body)
  {
    return {body.bvh8(), body.polyhedron, body.solid_sides()};
  }

  static void write(const kernel::Rational& exact, double& nearest, std::string& text)
  {
    nearest = kernel::nearest_double(exact);
    text = kernel::to_string(exact);
  }

  /// The parts that are made when a proper crossing does not decide.
  struct Exact_parts {
    Exact_parts(const Body_data& a, const Body_data& b)
        : contacts(a.bvh8(), a.bvh8().model(), a.polyhedron, b.bvh8(), b.bvh8().model(), b.polyhedron),
          pair(solid(a), solid(b))
    {}

    static Placed_solid solid(const Body_data& body)
    {
      return Placed_solid(body.polyhedron, body.solid_sides(), body.point_locator());
    }

    tetratree::Bvh8_contacts<K> contacts;
    Solid_pair pair;
  };

  Exact_parts& exact_parts()
  {
    if (!exact_parts_) exact_parts_ = std::make_unique<Exact_parts>(body_[0]->by_triangles(), body_[1]->by_triangles());
    return *exact_parts_;
  }

  /// Returns all that the surfaces share.
  tetratree::Found_contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
  {
    return exact_parts().contacts.contacts(pose_a, pose_b);
  }

  /// Returns the largest dimension of a piece; -1 for none.
  static int dimension_of(const tetratree::Found_contacts& found)
  {
    int dimension = -1;
    for (const tetratree::Found_piece& piece : found.pieces) switch (piece.kind) {
        case kernel::Piece::point: dimension = kernel::maximum(dimension, 0); break;
        case kernel::Piece::segment: dimension = kernel::maximum(dimension, 1); break;
        case kernel::Piece::polygon: return 2;
      }
    return dimension;
  }

  Contacts_data contacts_data(const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                              tetratree::Found_contacts found) const
  {
    // The bodies of triangles belong to the bodies, which outlive this.
    const auto shared = [](const Shared_body& body) { return Shared_body(body, &body->by_triangles()); };
    return {std::move(found), shared(body_[0]), shared(body_[1]), pose_a, pose_b};
  }

  void place(const Contacts_data& data)
  {
    std::vector<Solid_piece> pieces;
    for (std::size_t k = 0; k < data.found.pieces.size(); ++k) {
      const tetratree::Found_piece& piece = data.found.pieces[k];
      pieces.push_back({{piece.face_a, piece.face_b}, piece.kind, rational_loops(data, k), piece.by_signs});
    }
    exact_parts().pair.place(data.pose_a, data.pose_b, std::move(pieces));
  }

  /// Returns the relation where it is `disjoint`, or where the pair of triangles that the query met crosses properly.
  ///
  /// A proper crossing is an edge of one body that goes through the inside of a triangle of the other. Both bodies are
  /// simple. So exactly two faces meet in the edge. They divide a small ball about the crossing into two wedges, of
  /// which one is in the first solid and one is not. The triangle divides the ball into two halves, of which one is in
  /// the second solid and one is not. The edge leaves the ball on both sides of the triangle's plane. So each wedge has
  /// a part in each half: the interiors share a point, and either solid has a point outside the other.
  std::optional<Solid_relation> known_relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
  {
    const Relation relation = collision_.relation(pose_a, pose_b, Question::solid, &memory_);
    if (relation == Relation::apart) return Solid_relation::disjoint;
    if (relation != Relation::surfaces || !memory_.witness || !are_simple()) return std::nullopt;
    const auto& [box_a, box_b] = *memory_.witness;
    const tetratree::Bvh8 &a = body_[0]->bvh8(), &b = body_[1]->bvh8();
    for (Index i = 0; i < a.leaf_count(box_a); ++i)
      for (Index j = 0; j < b.leaf_count(box_b); ++j) {
        const auto p = corners(collision_.placed_a(), a.element(box_a, i)),
                   q = corners(collision_.placed_b(), b.element(box_b, j));
        if (crosses(p, q) || crosses(q, p)) return Solid_relation::overlap;
      }
    return std::nullopt;
  }

  /// Returns the relation of bodies with these contacts. Requires the poses of `known_relation`, which did not know it.
  Solid_relation relation_by(const kernel::Pose& pose_a, const kernel::Pose& pose_b, tetratree::Found_contacts found)
  {
    if (are_simple()) {
      if (!simple_relation_) simple_relation_.emplace(simple(0), simple(1));
      if (const auto relation = (*simple_relation_)(found, is_vertex_inside())) return *relation;
    }
    place(contacts_data(pose_a, pose_b, std::move(found)));
    return exact_parts().pair.relation();
  }

  tetratree::Simple_relation::Body simple(int body)
  {
    const Body_data& triangles = body_[body]->by_triangles();
    return {&triangles.polyhedron, &triangles.solid_sides(),
            body == 0 ? &collision_.placed_a() : &collision_.placed_b()};
  }

  bool are_simple() const
  {
    return body_[0]->by_triangles().solid_sides().is_simple() && body_[1]->by_triangles().solid_sides().is_simple();
  }

  static kernel::Corners<K> corners(covering::Placed_model<K>& body, const tetratree::Element& element)
  {
    return {&body.point(element.corner[0]), &body.point(element.corner[1]), &body.point(element.corner[2])};
  }

  /// True when an edge of p goes through the inside of q.
  static bool crosses(const kernel::Corners<K>& p, const kernel::Corners<K>& q)
  {
    const auto side = kernel::sides<K>(q, p);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (side[k] * side[next] == kernel::NEGATIVE &&
          kernel::segment_triangle<K>(*p[k], *p[next], *q[0], *q[1], *q[2]) == kernel::Contact::edge_face)
        return true;
    }
    return false;
  }

  std::array<Shared_body, 2> body_;
  tetratree::Bvh8_collision<K> collision_;
  tetratree::Pair_memory memory_;
  std::unique_ptr<Exact_parts> exact_parts_;
  std::optional<tetratree::Simple_relation> simple_relation_;
  std::optional<tetratree::Exit_search> exit_search_;
  std::optional<tetratree::Depth_search> depth_search_;
  std::optional<Convex_depths> convex_depths_;
};

}  // namespace

std::unique_ptr<Relation_solver> relation_solver(const std::shared_ptr<const Body_data>& a,
                                                 const std::shared_ptr<const Body_data>& b)
{
  return std::make_unique<Bvh8_relation_solver>(a, b);
}

}  // namespace tetracone::detail
