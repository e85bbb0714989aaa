#ifndef TETRACONE_TETRATREE_CERTIFICATE_COVER_H
#define TETRACONE_TETRATREE_CERTIFICATE_COVER_H

#include "tetracone/tetratree/certificate/group_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// A cover as certificates hold it. `nodes` is its NODE as JSON: it opens groups, and names one of `directions` for
/// each pair of groups that stays closed. experiments/certificates/README.md says what it proves.
struct Cover {
  std::vector<kernel::Exact_vector> directions;
  std::string nodes;
  std::vector<std::pair<Group_tree*, Box_id>> opened;  ///< the groups whose members the nodes name
};

/// Searches for separating directions of pairs of groups, and keeps those that are found.
///
/// The search is one of its own beside the query's descent. It runs only when a certificate is asked for, so the
/// descent needs no branch for it. Every direction is tested exactly.
class Cover_search {
 public:
  Cover& cover() { return cover_; }

  /// Adds a direction without a test, and returns its number.
  std::size_t add(kernel::Exact_vector m)
  {
    cover_.directions.push_back(std::move(m));
    return cover_.directions.size() - 1;
  }

  /// True when holds(m) for a direction m that is found; its number is then appended to the nodes. Directions of few
  /// bits are tried first. The arguments `pairs` and `distance` are those of `direction_by_few`. With `recession`, the
  /// exact recession of all A, the product of m with it is not positive.
  template <class Holds>
  bool separates(std::span<const Hull_pair> pairs, double distance,
                 const std::optional<kernel::Exact_vector>& recession, const Holds& holds)
  {
    const auto found = direction_by_few(pairs, distance);
    if (!found) return false;
    for (const int bits : {6, 14, 26, 52}) {
      kernel::Exact_vector m =
          recession ? kernel::rounded_to_bits(*found, bits, *recession) : kernel::rounded_to_bits(*found, bits);
      if (!holds(m)) continue;
      append(add(std::move(m)));
      return true;
    }
    return false;
  }

  /// Returns the members of a group, which the nodes name next.
  std::vector<Box_id> open(Group_tree& groups, Box_id box)
  {
    cover_.opened.emplace_back(&groups, box);
    return groups.members(box);
  }

  /// Appends a direction's number, or a text, to the nodes.
  void append(std::size_t direction) { cover_.nodes += std::to_string(direction); }
  void append(const char* text) { cover_.nodes += text; }

 private:
  Cover cover_;
};

/// A placed body in a cover.
struct Covered_body {
  Group_tree* groups;
  kernel::Hull_points points;

  /// Returns the hull of a group. It is valid as long as this.
  Group_hull hull(Box_id box) const { return {points, *groups, box}; }

  /// True for a piece that is a face of a plane without triangles.
  bool is_uncut(Box_id piece) const
  {
    const Element& element = groups->piece_of(piece);
    return element.is_whole_face() && groups->tree().model().covering().plane_basis(element.face).has_value();
  }

  /// Returns the face of a piece: a triangle, a face on a line, or a face that was not triangulated, with its loops.
  kernel::Exact_face face(Box_id piece)
  {
    const Element& element = groups->piece_of(piece);
    if (!element.is_whole_face()) return kernel::exact_face({&points, groups->group(piece).corners}, true);
    const auto& covering = groups->tree().model().covering();
    kernel::Exact_face face;
    const auto from = covering.from(element.face), to = covering.to(element.face);
    for (std::size_t k = 0; k < from.size(); ++k) face.edges.push_back({points.exact(from[k]), points.exact(to[k])});
    if (const auto basis = covering.plane_basis(element.face))
      face.plane = {points.exact((*basis)[0]), points.exact((*basis)[1]), points.exact((*basis)[2])};
    return face;
  }
};

/// Returns directions that may part two faces that are near, or touch, in both senses. They are normals of each face,
/// normals of its edges in its plane, and products of edges.
inline std::vector<kernel::Exact_vector> parting_directions(const std::array<kernel::Exact_face, 2>& face)
{
  std::vector<kernel::Exact_vector> found;
  for (const kernel::Exact_face& f : face) {
    if (!f.plane) continue;
    const kernel::Exact_vector normal = kernel::normal_of(*f.plane);
    found.push_back(normal);
    for (const auto& [p, q] : f.edges) found.push_back(kernel::cross(normal, kernel::difference(q, p)));
  }
  for (const auto& [p, q] : face[0].edges)
    for (const auto& [r, s] : face[1].edges)
      found.push_back(kernel::cross(kernel::difference(q, p), kernel::difference(s, r)));
  for (std::size_t k = 0, count = found.size(); k < count; ++k) found.push_back(kernel::negated(found[k]));
  return found;
}

/// A point that two pieces share.
struct Common_point {
  std::array<Box_id, 2> piece;
  kernel::Exact_point point;
};

/// Thrown where a search for a proof cannot go on; the answer is then left out. The hull of a face is not separated
/// though the face itself is, or numbers are beyond the doubles.
struct No_proof {};

/// Covers the pairs of pieces of two placed bodies, or finds a pair that does not keep the rule. Each object covers
/// once.
class Pair_cover {
 public:
  /// Requires points that are rounded together. Both bodies must outlive this object.
  Pair_cover(Covered_body& a, Covered_body& b, kernel::Gap_rule rule) : body_{&a, &b}, rule_(std::move(rule)) {}

  /// Tries this direction first for each pair. Call it at most once, before the cover.
  void prefer(kernel::Exact_vector m)
  {
    search_.add(std::move(m));
    has_preferred_ = true;
  }

  /// True when all pairs are covered. Else `common` is a point that two pieces share; nothing where two pieces are
  /// apart, but not as far as the rule asks. Throws No_proof.
  bool operator()() { return covers({}, {}); }

  /// Returns the cover, complete where the call above returned true.
  Cover& cover() { return search_.cover(); }
  const std::optional<Common_point>& common() const { return common_; }

 private:
  bool keeps_rule(const Group_hull& a, const Group_hull& b, const kernel::Exact_vector& m) const
  {
    return rule_.is_kept(extent_of(b, m, -1) - extent_of(a, m, 1), m);
  }

  bool covers(Box_id a, Box_id b)
  {
    const Group_hull of_a = body_[0]->hull(a), of_b = body_[1]->hull(b);
    if (has_preferred_ && keeps_rule(of_a, of_b, search_.cover().directions[0])) {
      search_.append(std::size_t(0));
      return true;
    }
    const Hull_pair pair{of_a, of_b};
    if (search_.separates(std::span(&pair, 1), rule_.rounded, {},
                          [&](const kernel::Exact_vector& m) { return keeps_rule(of_a, of_b, m); }))
      return true;
    const bool is_piece[2] = {body_[0]->groups->is_piece(a), body_[1]->groups->is_piece(b)};
    if (is_piece[0] && is_piece[1]) return pieces(a, b);
    const int opened =
        is_piece[0] || (!is_piece[1] && body_[0]->groups->piece_count(a) < body_[1]->groups->piece_count(b)) ? 1 : 0;
    search_.append(opened == 0 ? "[\"a\"" : "[\"b\"");
    for (const Box_id member : search_.open(*body_[opened]->groups, opened == 0 ? a : b)) {
      search_.append(",");
      if (!(opened == 0 ? covers(member, b) : covers(a, member))) return false;
    }
    search_.append("]");
    return true;
  }

  bool pieces(Box_id a, Box_id b)
  {
    const std::array<kernel::Exact_face, 2> face = {body_[0]->face(a), body_[1]->face(b)};
    const kernel::Exact_distance found = kernel::distance_of_faces(face[0], face[1]);
    const auto is_apart = [&](const kernel::Exact_vector& m) {
      if (!keeps_rule(body_[0]->hull(a), body_[1]->hull(b), m)) return false;
      search_.append(search_.add(m));
      return true;
    };
    if (rule_.sweep && std::ranges::any_of(parting_directions(face), is_apart)) return true;
    if (found.is_zero()) {
      common_ = {{a, b}, found.on_a};
      return false;
    }
    if (is_apart(found.direction)) return true;
    if (body_[0]->is_uncut(a) || body_[1]->is_uncut(b)) throw No_proof{};
    return false;
  }

  std::array<Covered_body*, 2> body_;
  kernel::Gap_rule rule_;
  bool has_preferred_ = false;
  Cover_search search_;
  std::optional<Common_point> common_;
};

/// The point, the segment from start to end, or the ray that one body is covered against.
struct Probe {
  kernel::Exact_vector start;
  std::optional<kernel::Exact_vector> end;        ///< of a segment
  std::optional<kernel::Exact_vector> direction;  ///< of a ray
};

/// Covers the pieces of a placed body against a probe, from which the groups are as far as a rule says. Each object
/// covers once.
class Probe_cover {
 public:
  /// The result of meets(), for a piece that no direction separates from the probe.
  enum class Met { is_covered, stops };

  /// The body must outlive this object. Its points may be rounded anew, on the probe's scale.
  Probe_cover(Covered_body& body, Probe probe, kernel::Gap_rule rule = {})
      : body_(&body), probe_(std::move(probe)), rule_(std::move(rule))
  {
    points_ = probe_.end ? Hull_points{probe_.start, *probe_.end} : Hull_points{probe_.start};
    kernel::round_together(points_, body.points);
    corners_.resize(points_.size());
    for (std::size_t k = 0; k < corners_.size(); ++k) corners_[k] = std::uint32_t(k);
    if (probe_.direction) {
      Hull_points way{*probe_.direction}, none;
      kernel::round_together(way, none);
      recession_ = way.rounded(0);
    }
    make_solid_probe();
  }

  /// Calls meets(piece, face, is_apart) for each piece whose hull no direction separates from the probe, until it
  /// returns `stops`. `is_apart` tells that the face itself shares no point with the probe. meets() appends a node
  /// where it returns `is_covered`. True when all pieces are covered.
  template <class Meets>
  bool operator()(const Meets& meets)
  {
    return covers({}, meets);
  }

  Cover& cover() { return search_.cover(); }
  Cover_search& search() { return search_; }

  /// True when the call above stopped at a face without triangles, whose hull is not separated though it is.
  bool lacks_triangles() const { return lacks_triangles_; }

  /// Returns the probe as a face: a segment there and back. That of a ray ends beyond the body.
  const kernel::Exact_face& face() const { return face_; }

 private:
  using Hull_points = kernel::Hull_points;
  using Exact_vector = kernel::Exact_vector;

  void make_solid_probe()
  {
    Exact_vector end = probe_.end.value_or(probe_.start);
    if (probe_.direction) {
      const kernel::Exact_number beyond = extent_of(body_->hull({}), *probe_.direction, 1);
      kernel::Exact_number length = 1;
      const auto at = [&] { return kernel::sum(probe_.start, kernel::scaled(*probe_.direction, length)); };
      while (!(kernel::dot(*probe_.direction, at()) > beyond)) length = length * kernel::Exact_number(16);
      end = at();
    }
    face_.edges = {{probe_.start, end}, {end, probe_.start}};
  }

  bool holds(const Group_hull& group, const Exact_vector& m) const
  {
    return rule_.is_kept(extent_of(group, m, -1) - extent_of(hull(), m, 1), m);
  }

  Group_hull hull() const { return {points_, corners_, recession_ ? &*recession_ : nullptr}; }

  template <class Meets>
  bool covers(Box_id box, const Meets& meets)
  {
    const Group_hull group = body_->hull(box);
    const Hull_pair pair{hull(), group};
    if (search_.separates(std::span(&pair, 1), rule_.rounded, probe_.direction,
                          [&](const Exact_vector& m) { return holds(group, m); }))
      return true;
    if (!body_->groups->is_piece(box)) {
      search_.append("[\"b\"");
      for (const Box_id member : search_.open(*body_->groups, box)) {
        search_.append(",");
        if (!covers(member, meets)) return false;
      }
      search_.append("]");
      return true;
    }
    const kernel::Exact_face face = body_->face(box);
    const kernel::Exact_distance found = kernel::distance_of_faces(face_, face);
    const bool is_apart = !found.is_zero();
    if (is_apart && holds(group, found.direction)) {
      search_.append(search_.add(found.direction));
      return true;
    }
    if (meets(box, face, is_apart) == Met::is_covered) return true;
    lacks_triangles_ = lacks_triangles_ || (is_apart && body_->is_uncut(box));
    return false;
  }

  Covered_body* body_;
  Probe probe_;
  kernel::Gap_rule rule_;
  Hull_points points_;
  std::vector<std::uint32_t> corners_;
  std::optional<kernel::Rounded_vector> recession_;
  kernel::Exact_face face_;
  Cover_search search_;
  bool lacks_triangles_ = false;
};

}  // namespace tetracone::tetratree

#endif
