#ifndef TETRACONE_VERIFY_PROOFS_BOX_TEST_H
#define TETRACONE_VERIFY_PROOFS_BOX_TEST_H

#include "tetracone/kernel/bound/obb8_overlap.h"
#include "verify/proofs/axis_number.h"

#include <array>
#include <vector>

/// The comparison of kernel/bound/obb8_overlap_simd.inl, run over other numbers than vectors.
namespace tetracone::verify::proofs {

/// The source of the single box's edges.
enum class Edges {
  given,    ///< floats: what the box is made of
  general,  ///< floats, and their cross products
  carried   ///< an axis in float, turned by directions in float
};

/// The comparison's inputs, of any number type. The apex is `zero`: above the middle of its base.
template <class Number, bool fused>
struct Box_test {
  using Floats = Axis_number<Number, fused>;

  struct Boxes {
    Floats centre[3], axis[3][3], extent[3];
  } boxes;
  struct Single {
    std::vector<std::vector<Number>> edge, normal;
    std::vector<Number> centre, extent;
    Number slack = Number(0), apex = Number(0);
  } box;
  bool is_triangle = false;

  const Floats& load(const Floats& lane) const { return lane; }
  Floats all(const Number& x) const { return x; }
  bool holds_triangle() const { return is_triangle; }

  /// The positions of the inputs in a slice: centres and extents, axes of the eight boxes, edges or axes of the single
  /// box, turning directions.
  enum Place {
    single_centre = 0,
    centre = 3,
    extent = 6,
    single_extent = 9,
    axis = 12,
    edge = 21,
    direction = 30,
    end = 39
  };

  Box_test(const std::vector<Number>& in, Edges edges, bool triangle, const Number& zero) : is_triangle(triangle)
  {
    box.apex = zero;
    for (int i = 0; i < 3; ++i) {
      boxes.centre[i] = in[centre + i];
      boxes.extent[i] = in[extent + i];
      for (int k = 0; k < 3; ++k) boxes.axis[i][k] = in[axis + 3 * i + k];
      box.centre.push_back(entry(in[single_centre + i]));  // rounded to float
      box.extent.push_back(in[single_extent + i]);
    }
    for (int j = 0; j < 3; ++j) {
      std::vector<Number> e;
      for (int k = 0; k < 3; ++k) {
        const auto turned = [&](int q) { return Floats(entry(in[direction + 3 * k + q])); };
        const auto of_axis = [&](int q) { return Floats(in[edge + 3 * j + q]); };
        e.push_back(edges != Edges::carried ? in[edge + 3 * j + k]
                                            : kernel::HWY_NAMESPACE::carried_edge(turned(0), turned(1), turned(2),
                                                                                  of_axis(0), of_axis(1), of_axis(2))
                                                  .one());
      }
      box.edge.push_back(e);
    }
    for (int j = 0; j < 3; ++j) {
      const auto &p = box.edge[(j + 1) % 3], &q = box.edge[(j + 2) % 3];
      const auto n = kernel::cross(std::array{p[0], p[1], p[2]}, std::array{q[0], q[1], q[2]});
      box.normal.push_back({n[0], n[1], n[2]});
    }
  }
};

/// All compared gaps, each with the components of its axis along the axes of the eight boxes.
template <class Floats>
struct All_gaps {
  std::vector<std::array<Floats, 4>> all;

  friend All_gaps Max(const All_gaps& a, const All_gaps& b)
  {
    All_gaps both = a;
    both.all.insert(both.all.end(), b.all.begin(), b.all.end());
    return both;
  }
};
/// Makes `largest_gap` return all gaps in place of the largest.
struct Keep_all {
  template <class Floats>
  All_gaps<Floats> operator()(const Floats& gap, const Floats&, const Floats& n0, const Floats& n1,
                              const Floats& n2) const
  {
    return {{{gap, n0, n1, n2}}};
  }
};

/// Returns the gaps along all axes, by the comparison itself: 3 normals of the eight boxes, 3 of the single box, 9
/// cross products and, for a triangle, 2 more.
template <class Number, bool fused>
std::vector<Number> gaps_of(const Box_test<Number, fused>& test, Edges edges)
{
  return edges == Edges::general ? kernel::HWY_NAMESPACE::together<false>(test).any()
                                 : kernel::HWY_NAMESPACE::together<true>(test).any();
}

}  // namespace tetracone::verify::proofs

#endif
