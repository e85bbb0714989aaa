#include "verify/subjects/blame.h"

#include "tetracone/covering/inclusion.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/fast/bvh8_collision.h"
#include "tetracone/tetratree/paper/collision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using covering::Covering;
using covering::Index;
using kernel::Epick;
using kernel::Question;

/// A body as rounding has left it: the images of its vertices, on which EPICK's signs are exact.
struct Rounded_body {
  std::vector<Epick::Point_3> points;
  Epick::Point_3 origin;
  const Covering* covering;

  template <class K>
  explicit Rounded_body(covering::Placed_model<K>& body)
      : origin(exactly<K>(body.frame()(body.model().origin()))), covering(&body.model().covering())
  {
    for (Index v = 0; v < body.model().vertices().size(); ++v) points.push_back(exactly<K>(body.point(v)));
  }

  /// No coordinate has overflowed.
  bool is_finite() const
  {
    return std::all_of(points.begin(), points.end(), [](const auto& p) {
      return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
    });
  }

  template <class K>
  static Epick::Point_3 exactly(const kernel::Point<K>& p)
  {
    return {double(p.x()), double(p.y()), double(p.z())};
  }
};

/// A face of a rounded body, as `kernel::segment_face` wants it.
struct Rounded_face {
  const Rounded_body& body;
  Index face;

  std::size_t edge_count() const { return body.covering->from(face).size(); }
  const Epick::Point_3& from(std::size_t k) const { return body.points[body.covering->from(face)[k]]; }
  const Epick::Point_3& to(std::size_t k) const { return body.points[body.covering->to(face)[k]]; }
  const Epick::Point_3& origin() const { return from(0); }
  bool is_degenerate() const { return !body.covering->plane_basis(face); }
  const Epick::Point_3& plane_basis(int k) const { return body.points[(*body.covering->plane_basis(face))[k]]; }
};

using Meeting = std::set<std::pair<Index, Index>>;  // edge of the one, face of the other

Meeting meeting(const Rounded_body& with_edges, const Rounded_body& with_faces, std::size_t face_count)
{
  Meeting pairs;
  const auto& edges = with_edges.covering->edges();
  for (Index f = 0; f < face_count; ++f)
    for (Index e = 0; e < edges.size(); ++e) {
      const Rounded_face face{with_faces, f};
      const auto &p = with_edges.points[edges[e][0]], &q = with_edges.points[edges[e][1]];
      if (kernel::segment_face<Epick>(p, q, face) != kernel::Contact::none) pairs.insert({e, f});
    }
  return pairs;
}

/// Some shell of `held` is in the solid of `holder`, by exact signs.
bool holds_a_shell(const Rounded_body& holder, const Rounded_body& held)
{
  const auto& shells = held.covering->shell_vertices();
  return std::any_of(shells.begin(), shells.end(), [&](Index v) {
    int winding = 0;
    for (const covering::Covering_triangle& t : holder.covering->triangles())
      winding += covering::signed_inclusion<Epick>(held.points[v], holder.origin, holder.points[t.corner[0]],
                                                   holder.points[t.corner[1]], holder.points[t.corner[2]]);
    return winding != 0;
  });
}

bool any_in(const Meeting& pairs, std::span<const Index> edges, std::span<const Index> faces)
{
  return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return std::find(edges.begin(), edges.end(), pair.first) != edges.end() &&
           std::find(faces.begin(), faces.end(), pair.second) != faces.end();
  });
}

/// A triangle of a rounded body, likewise.
kernel::Triangle<Epick> rounded_triangle(const Rounded_body& body, const tetratree::Element& element)
{
  return {body.points[element.corner[0]], body.points[element.corner[1]], body.points[element.corner[2]]};
}

/// The segment meets the element, by exact signs.
bool meets(const Epick::Point_3& p, const Epick::Point_3& q, const Rounded_body& body,
           const tetratree::Element& element)
{
  const auto contact = element.is_whole_face() ? kernel::segment_face<Epick>(p, q, Rounded_face{body, element.face})
                                               : kernel::segment_face<Epick>(p, q, rounded_triangle(body, element));
  return contact != kernel::Contact::none;
}

/// An edge of one element meets the other.
bool edges_meet(const Rounded_body& a, const tetratree::Element& with_edges, const Rounded_body& b,
                const tetratree::Element& other)
{
  if (!with_edges.is_whole_face()) {
    const auto& v = with_edges.corner;
    return meets(a.points[v[0]], a.points[v[1]], b, other) || meets(a.points[v[1]], a.points[v[2]], b, other) ||
           meets(a.points[v[2]], a.points[v[0]], b, other);
  }
  const Rounded_face face{a, with_edges.face};
  for (std::size_t k = 0; k < face.edge_count(); ++k)
    if (meets(face.from(k), face.to(k), b, other)) return true;
  return false;
}

/// Both rounded bodies, and what exact signs say of them.
struct Rounded_pair {
  Rounded_body a, b;
  bool is_finite;
  Meeting a_in_b, b_in_a;
  bool contained = false;

  template <class K>
  Rounded_pair(covering::Placed_model<K>& body_a, covering::Placed_model<K>& body_b, Question question)
      : a(body_a), b(body_b), is_finite(a.is_finite() && b.is_finite())
  {
    // A point at infinity has lost its place, and has no exact signs.
    if (!is_finite) return;
    a_in_b = meeting(a, b, body_b.model().face_count());
    b_in_a = meeting(b, a, body_a.model().face_count());
    contained = question == Question::solid && (holds_a_shell(a, b) || holds_a_shell(b, a));
  }

  bool collide() const { return contained || !a_in_b.empty() || !b_in_a.empty(); }
};

template <class K>
std::optional<Stage> blame_in_tetra_tree(const tetratree::Config& config, const Object_case& c, Question question,
                                         bool truth)
{
  using Tree = tetratree::Tetra_tree<K>;
  using Node = tetratree::Node<typename Tree::B>;
  Tree tree_a(*c.a, config), tree_b(*c.b, config);
  tetratree::Collision<K> collision(tree_a, tree_b);
  if (collision(c.pose_a, c.pose_b, question) == truth) return std::nullopt;

  const Rounded_pair rounded(collision.a().body(), collision.b().body(), question);
  if (!rounded.is_finite || rounded.collide() != truth) return Stage::pose;

  // From here on, discarding one thing more at a time.
  const auto exact_leaves = [&](const Node& leaf_a, const Node& leaf_b) {
    return any_in(rounded.a_in_b, tree_a.edges(leaf_a), tree_b.faces(leaf_b)) ||
           any_in(rounded.b_in_a, tree_b.edges(leaf_b), tree_a.faces(leaf_a));
  };
  tetratree::Config& discards = collision.config();
  const auto wrong_with = [&](bool spheres, bool tetrahedra, bool hull) {
    discards.spheres = spheres;
    discards.tetrahedra = tetrahedra;
    discards.regular_hull = hull;
    return (rounded.contained || collision.any_leaf_pair(c.pose_a, c.pose_b, exact_leaves)) != truth;
  };
  if (wrong_with(false, false, false)) return Stage::classification;
  if (wrong_with(true, false, false)) return Stage::bounding_sphere;
  if (wrong_with(true, true, false)) return Stage::bounding_tetrahedron;
  if (wrong_with(true, true, config.regular_hull)) return Stage::regular_hull;
  if ((rounded.contained || collision(c.pose_a, c.pose_b, Question::surface)) != truth) return Stage::leaf_sign;
  return Stage::containment;
}

template <class K>
std::optional<Stage> blame_in_fast_tree(const Object_case& c, Question question, bool truth)
{
  using tetratree::Bvh8, tetratree::Element;
  const Bvh8 tree_a(*c.a, covering::triangulate_faces(*c.a)), tree_b(*c.b, covering::triangulate_faces(*c.b));
  const covering::Model<K> model_a(*c.a), model_b(*c.b);
  tetratree::Bvh8_collision<K> collision(tree_a, model_a, tree_b, model_b);
  if (collision(c.pose_a, c.pose_b, question) == truth) return std::nullopt;

  covering::Placed_model<K> placed_a(model_a), placed_b(model_b);
  placed_a.place(c.pose_a);
  placed_b.place(c.pose_b);
  const Rounded_pair rounded(placed_a, placed_b, question);
  if (!rounded.is_finite || rounded.collide() != truth) return Stage::pose;

  const auto exact_leaves = [&](const Element& of_a, const Element& of_b) {
    return edges_meet(rounded.a, of_a, rounded.b, of_b) || edges_meet(rounded.b, of_b, rounded.a, of_a);
  };
  if ((rounded.contained || collision.any_element_pair(c.pose_a, c.pose_b, exact_leaves)) != truth)
    return Stage::bounding_box;
  if ((rounded.contained || collision(c.pose_a, c.pose_b, Question::surface)) != truth) return Stage::leaf_sign;
  return Stage::containment;
}

template <class K>
std::optional<Stage> blame_in(Method method, const Object_case& c, Question question, bool truth)
{
  return method == Method::tree ? blame_in_fast_tree<K>(c, question, truth)
                                : blame_in_tetra_tree<K>(config_of(method), c, question, truth);
}

}  // namespace

std::optional<Stage> blame(const Subject& subject, const Object_case& c, Question question, bool truth)
{
  switch (subject.kernel) {
    case Kernel_name::double_: return blame_in<kernel::Double>(subject.method, c, question, truth);
    case Kernel_name::float_: return blame_in<kernel::Float>(subject.method, c, question, truth);
    case Kernel_name::epick: return blame_in<kernel::Epick>(subject.method, c, question, truth);
    case Kernel_name::double_eps:
      kernel::Tolerant::tolerance() = subject.tolerance;
      return blame_in<kernel::Tolerant>(subject.method, c, question, truth);
    default: return std::nullopt;
  }
}

}  // namespace tetracone::verify
