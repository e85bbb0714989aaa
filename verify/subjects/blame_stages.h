#ifndef TETRACONE_VERIFY_SUBJECTS_BLAME_STAGES_H
#define TETRACONE_VERIFY_SUBJECTS_BLAME_STAGES_H

#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/paper/collision.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "tetracone/tetratree/solver/method_config.h"
#include "verify/integer_truth/rounded_pair.h"
#include "verify/subjects/blame.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/// Blame over the kernel: the stages run are the subject's own, and `Rounded_pair` judges them.
namespace tetracone::verify::detail {

/// The images of a model's vertices as K has rounded them.
template <class K>
std::vector<kernel::Vertex> images(covering::Placed_model<K>& placed)
{
  std::vector<kernel::Vertex> images;
  for (Index v = 0; v < placed.model().vertices().size(); ++v) {
    const kernel::Point<K>& p = placed.point(v);
    images.push_back({double(p.x()), double(p.y()), double(p.z())});
  }
  return images;
}

/// The placed body with its original faces.
template <class K>
Rounded_body rounded_faces(const covering::Polyhedron& body, covering::Placed_model<K>& placed)
{
  Rounded_body result{body, {}};
  result.surface.vertices = images(placed);
  for (Index f = 0; f < body.face_count(); ++f) result.planes.push_back(placed.model().covering().plane_basis(f));
  return result;
}

/// The elements of a fast tree, numbered as faces of a body.
class Rounded_elements {
 public:
  template <class K>
  Rounded_elements(const covering::Polyhedron& body, const std::vector<covering::Face_triangle>& triangles,
                   covering::Placed_model<K>& placed)
  {
    rounded_.surface.vertices = images(placed);
    std::vector<bool> has_triangles(body.face_count(), false);
    for (const covering::Face_triangle& t : triangles) {
      has_triangles[t.face] = true;
      add({{t.corner[0], t.corner[1], t.corner[2]}}, {t.face, t.corner}, t.corner);
    }
    for (Index f = 0; f < body.face_count(); ++f) {
      if (has_triangles[f]) continue;
      std::vector<std::vector<Index>> loops;
      for (std::size_t k = 0; k < body.loop_count(f); ++k) {
        const covering::Loop loop = body.loop(f, k);
        loops.emplace_back(loop.begin(), loop.end());
      }
      const auto& plane = placed.model().covering().plane_basis(f);
      tetratree::Element element{f, {covering::none, covering::none, covering::none}};
      if (body.is_triangle(f) && plane) element.corner = {loops[0][0], loops[0][1], loops[0][2]};
      add(loops, element, plane);
    }
  }

  const Rounded_body& body() const { return rounded_; }
  Index number(const tetratree::Element& element) const { return numbers_.at({element.face, element.corner}); }

 private:
  void add(const std::vector<std::vector<Index>>& loops, const tetratree::Element& element,
           const std::optional<std::array<Index, 3>>& plane)
  {
    numbers_[{element.face, element.corner}] = Index(rounded_.surface.face_count());
    rounded_.surface.add_face(loops);
    rounded_.planes.push_back(plane);
  }

  Rounded_body rounded_;
  std::map<std::pair<Index, std::array<Index, 3>>, Index> numbers_;
};

template <class K>
std::optional<Stage> blame_in_tetra_tree(const tetratree::Config& config, const Object_case& c,
                                         kernel::Question question, bool truth)
{
  using Tree = tetratree::Tetra_tree<K>;
  using Node = tetratree::Node<typename Tree::B>;
  Tree tree_a(*c.a, config), tree_b(*c.b, config);
  tetratree::Collision<K> collision(tree_a, tree_b);
  if (collision(c.pose_a, c.pose_b, question) == truth) return std::nullopt;

  const Rounded_body a = rounded_faces(*c.a, collision.a().body()), b = rounded_faces(*c.b, collision.b().body());
  if (!a.is_finite() || !b.is_finite()) return Stage::pose;
  const Rounded_pair rounded(a, b, question);
  if (rounded.collide() != truth) return Stage::pose;

  // Below, each step lets the query discard by one test more.
  const auto edges_meet = [&](int body, Tree& with_edges, const Node& leaf, Tree& with_faces, const Node& other) {
    for (const Index e : with_edges.edges(leaf)) {
      const auto& [from, to] = with_edges.model().covering().edges()[e];
      for (const Index f : with_faces.faces(other))
        if (rounded.edge_meets_face(body, from, to, f)) return true;
    }
    return false;
  };
  const auto exact_leaves = [&](const Node& leaf_a, const Node& leaf_b) {
    return edges_meet(0, tree_a, leaf_a, tree_b, leaf_b) || edges_meet(1, tree_b, leaf_b, tree_a, leaf_a);
  };
  tetratree::Config& discards = collision.config();
  const auto wrong_with = [&](bool spheres, bool tetrahedra, bool hull) {
    discards.spheres = spheres;
    discards.tetrahedra = tetrahedra;
    discards.regular_hull = hull;
    return (rounded.is_contained() || collision.any_leaf_pair(c.pose_a, c.pose_b, exact_leaves)) != truth;
  };
  if (wrong_with(false, false, false)) return Stage::classification;
  if (wrong_with(true, false, false)) return Stage::bounding_sphere;
  if (wrong_with(true, true, false)) return Stage::bounding_tetrahedron;
  if (wrong_with(true, true, config.regular_hull)) return Stage::regular_hull;
  if ((rounded.is_contained() || collision(c.pose_a, c.pose_b, kernel::Question::surface)) != truth)
    return Stage::leaf_sign;
  return Stage::containment;
}

template <class K>
std::optional<Stage> blame_in_fast_tree(const Object_case& c, kernel::Question question, bool truth)
{
  using tetratree::Bvh8, tetratree::Element;
  const auto triangles_a = covering::triangulate_faces(*c.a), triangles_b = covering::triangulate_faces(*c.b);
  const Bvh8 tree_a(*c.a, triangles_a), tree_b(*c.b, triangles_b);
  const covering::Model<K> model_a(*c.a), model_b(*c.b);
  tetratree::Bvh8_collision<K> collision(tree_a, model_a, tree_b, model_b);
  if (collision(c.pose_a, c.pose_b, question) == truth) return std::nullopt;

  covering::Placed_model<K> placed_a(model_a), placed_b(model_b);
  placed_a.place(c.pose_a);
  placed_b.place(c.pose_b);
  const Rounded_elements a(*c.a, triangles_a, placed_a), b(*c.b, triangles_b, placed_b);
  if (!a.body().is_finite() || !b.body().is_finite()) return Stage::pose;
  const Rounded_pair rounded(a.body(), b.body(), question);
  if (rounded.collide() != truth) return Stage::pose;

  bool collide = rounded.is_contained();
  collision.for_element_pairs(c.pose_a, c.pose_b, [&](const Element& of_a, const Element& of_b) {
    collide = collide || rounded.faces_meet(a.number(of_a), b.number(of_b));
  });
  if (collide != truth) return Stage::bounding_box;
  if ((rounded.is_contained() || collision(c.pose_a, c.pose_b, kernel::Question::surface)) != truth)
    return Stage::leaf_sign;
  return Stage::containment;
}

/// `blame` for a subject over K, which rounds to doubles or floats.
template <class K>
std::optional<Stage> blame_in(Method method, const Object_case& c, kernel::Question question, bool truth)
{
  return method == Method::tree ? blame_in_fast_tree<K>(c, question, truth)
                                : blame_in_tetra_tree<K>(config_of(method), c, question, truth);
}

}  // namespace tetracone::verify::detail

#endif
