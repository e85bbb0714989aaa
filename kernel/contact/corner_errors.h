#ifndef TETRACONE_KERNEL_CONTACT_CORNER_ERRORS_H
#define TETRACONE_KERNEL_CONTACT_CORNER_ERRORS_H

#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/interval.h"

#include <cmath>

namespace tetracone::kernel {

/// Bounds of the errors of rounded corners, and of edges and normals computed from them in double.
///
/// All functions require a block of upward rounding, so that their results are upper bounds. In it the error of an
/// operation is at most 2^-52 of its result, and of a few operations less than `few_roundings` of their terms. An edge
/// is a difference of two corners, a normal the product of two edges. Each bound is for one component, and for exact
/// and rounded numbers alike. Let |e| <= E with an error of D, and |n| <= N:
///
/// - Normal e f - g h: each product has an error of 2 E D, and the roundings one of `few_roundings` of 2 E^2.
/// - Height n . x with |x| <= X: each product errs by at most (error of n) X + (error of x) N. Roundings add
///   `few_roundings` of 3 N X. An edge's product with a normal has this bound, by E and D.
///
/// `underflow_slack` covers underflow, since pieces have coordinates of at most 2^201.
class Corner_errors {
 public:
  Corner_errors() = default;
  /// Bounds that hold for the corners of both.
  Corner_errors(const Corner_errors& a, const Corner_errors& b)
      : corner_(maximum(a.corner_, b.corner_)), off_(maximum(a.off_, b.off_)), edge_(maximum(a.edge_, b.edge_))
  {}

  /// Returns the rounded corner, and raises the bounds to hold for it.
  Number_point<double> rounded(const Number_point<Interval>& corner)
  {
    Number_point<double> middle;
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = corner[k].inf(), high = corner[k].sup(), x = low / 2 + high / 2;
      middle[k] = x;
      off_ = maximum(off_, high - x, x - low);
      corner_ = maximum(corner_, -low, high, std::abs(x));
    }
    return middle;
  }
  /// Raises the bounds to hold for a difference of two rounded corners.
  void add_edge(const Number_point<double>& edge)
  {
    for (const double x : edge) edge_ = maximum(edge_, std::abs(x));
  }

  /// Returns an upper bound of the error of a difference of any two corners.
  double off_step() const { return 2 * (off_ + few_roundings * corner_) + underflow_slack; }
  /// Returns an upper bound of the error of an edge.
  double off_edge() const { return 2 * off_ + few_roundings * edge_ + underflow_slack; }
  /// Returns an upper bound of the error of a normal.
  double off_normal() const
  {
    return 4 * edge() * off_edge() + few_roundings * (2 * edge() * edge()) + underflow_slack;
  }
  /// Returns an upper bound of the error of a normal's product with a corner.
  double off_height() const
  {
    return 3 * (off_normal() * corner_ + normal() * (off_ + few_roundings * corner_)) + underflow_slack;
  }
  /// Returns an upper bound of the error of a normal's product with an edge.
  double off_turn() const
  {
    return 3 * (off_normal() * edge() + normal() * (off_edge() + few_roundings * edge())) + underflow_slack;
  }
  /// Returns an upper bound of the error of an edge's product with a corner.
  double off_edge_height() const
  {
    return 3 * (off_edge() * corner_ + edge() * (off_ + few_roundings * corner_)) + underflow_slack;
  }

 private:
  double edge() const { return edge_ + off_edge(); }
  double normal() const { return 2 * edge() * edge() + off_normal(); }

  double corner_ = 0;  // upper bound of the coordinates
  double off_ = 0;     // upper bound of their errors
  double edge_ = 0;    // upper bound of rounded edges
};

}  // namespace tetracone::kernel

#endif
