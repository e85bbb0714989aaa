#ifndef TETRACONE_TETRATREE_FAST_BVH8_ELEMENTS_H
#define TETRACONE_TETRATREE_FAST_BVH8_ELEMENTS_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/fast/bvh8_node.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

using covering::Face_triangle;
using covering::Index;

/// What a leaf holds: a triangle, or a whole face that has not been triangulated.
struct Element {
  Index face;
  std::array<Index, 3> corner;  ///< corner[0] == covering::none: the whole face
  bool is_whole_face() const { return corner[0] == covering::none; }
};

using Elements = covering::Unset_vector<Element>;

/// The body of a tree: the model, its elements, and its local units.
class Bvh8_elements {
 public:
  using Adaptive = kernel::Adaptive;

  /// `triangles` cover exactly each face that has some. Requires planar faces. The result does not depend on `both`.
  Bvh8_elements(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles,
                const covering::Both& both = {})
      : model_(polyhedron, both)
  {
    elements_ = collected(polyhedron, triangles, both);
    scale_ = kernel::local_scale(model_.lattice().origin, model_.vertices());
    per_half_unit_ = 2 / scale_.unit;
  }

  /// Returns the permutation by which `put_in_order` gives the elements of a new object of this body the present order.
  /// `triangles` are the constructor's.
  std::vector<Index> order_of(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles) const
  {
    const auto sorted = [](std::span<const Element> elements) {
      std::vector<Index> numbers(elements.size());
      std::iota(numbers.begin(), numbers.end(), Index(0));
      std::ranges::stable_sort(numbers, {}, [&](Index e) { return std::tie(elements[e].face, elements[e].corner); });
      return numbers;
    };
    const Elements as_collected = collected(polyhedron, triangles, {});
    const std::vector<Index> here = sorted(elements_), there = sorted(as_collected);
    std::vector<Index> order(here.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[here[k]] = there[k];
    return order;
  }

  /// Makes element order[k] the k-th. False, without any change, unless `order` is a permutation of all elements.
  bool put_in_order(std::span<const Index> order)
  {
    if (order.size() != elements_.size()) return false;
    std::vector<bool> is_placed(order.size(), false);
    for (const Index e : order) {
      if (e >= order.size() || is_placed[e]) return false;
      is_placed[e] = true;
    }
    Elements ordered(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) ordered[k] = elements_[order[k]];
    elements_ = std::move(ordered);
    return true;
  }

  const covering::Model<Adaptive>& model() const { return model_; }
  /// Returns the local units: those of the covering's origin.
  const kernel::Local_scale& scale() const { return scale_; }
  Index count() const { return Index(elements_.size()); }
  const Element& operator[](Index e) const { return elements_[e]; }

  /// Returns all elements; their order becomes the order of the leaves.
  std::span<Element> order() { return elements_; }
  std::span<const Element> order() const { return elements_; }

  std::size_t bytes() const { return elements_.capacity() * sizeof(Element); }

  /// Upper bound of the error of a coordinate of `local`: one rounding of a difference of at most 1. Proved in
  /// verify/proofs/cone_proofs.h.
  static constexpr double local_error = 0x1p-52;

  /// Returns a vertex in local units; the error of a coordinate is at most `local_error`.
  kernel::Vector local(Index v) const
  {
    const auto& vertex = model_.vertices()[v];
    kernel::Vector p;
    for (int k = 0; k < 3; ++k) p[k] = (0.5 * vertex[k] - 0.5 * scale_.origin[k]) * per_half_unit_;
    return p;
  }

  /// Calls what(v) for every corner v of the element.
  template <class What>
  void for_vertices(const Element& element, const What& what) const
  {
    if (element.is_whole_face())
      for (const Index v : model_.covering().from(element.face)) what(v);
    else
      for (const Index v : element.corner) what(v);
  }

 private:
  /// Returns the given triangles, and each face that has none, in the order of their numbers.
  Elements collected(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles,
                     const covering::Both& both) const
  {
    Elements elements;
    const auto faces = Index(polyhedron.face_count());
    if (triangles.empty()) {
      elements.resize(faces);
      covering::in_parts(0, faces, both, [&](Index first, Index last) {
        for (Index f = first; f < last; ++f) elements[f] = element_of(polyhedron, f);
      });
    } else {
      std::vector<bool> has_triangles(faces, false);
      for (const Face_triangle& t : triangles) has_triangles[t.face] = true;
      const auto without = std::size_t(std::ranges::count(has_triangles, false));
      elements.reserve(triangles.size() + without);
      for (const Face_triangle& t : triangles) elements.push_back({t.face, t.corner});
      for (Index f = 0; f < faces; ++f)
        if (!has_triangles[f]) elements.push_back(element_of(polyhedron, f));
    }
    assert(elements.size() <= Bvh8_node::most_elements);
    return elements;
  }

  /// Returns the element of a face for which no triangles are given.
  Element element_of(const covering::Polyhedron& polyhedron, Index f) const
  {
    if (!(polyhedron.is_triangle(f) && model_.covering().plane_basis(f)))
      return {f, {covering::none, covering::none, covering::none}};
    const auto loop = polyhedron.loop(f, 0);
    return {f, {loop[0], loop[1], loop[2]}};
  }

  covering::Model<Adaptive> model_;
  kernel::Local_scale scale_;
  double per_half_unit_ = 2;  // of the scale; a power of two too
  Elements elements_;
};

}  // namespace tetracone::tetratree

#endif
