#ifndef TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_SIMD_INL
#define TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_SIMD_INL
// Included by kernel/bound/relative_motion.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/relative_motion.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline HWY_ATTR double steps_along_simd(const Course& course, const Placement& before, const Placement& after)
{
  constexpr hn::CappedTag<double, 4> doubles;
  constexpr hn::Rebind<float, decltype(doubles)> narrow;
  auto along = hn::Zero(doubles), square = hn::Zero(doubles);
  for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles))
    for (int j = 0; j < 4; ++j) {
      const auto on = hn::PromoteTo(doubles, hn::Load(narrow, course.column[j] + k));
      along = MulAdd(on, Sub(hn::Load(doubles, after.column[j] + k), hn::Load(doubles, before.column[j] + k)), along);
      square = MulAdd(on, on, square);
    }
  const double steps = hn::GetLane(hn::SumOfLanes(doubles, along)) / hn::GetLane(hn::SumOfLanes(doubles, square));
  if (!(steps >= Course::least_step && steps <= Course::most_steps)) return 0;
  return double(std::int64_t(steps / Course::least_step)) * Course::least_step;
}

/// Returns a coordinate of a point's motion, by a row of the linear part and the shift. Its error is proved from this
/// function, run over other numbers than vectors (verify/proofs/gap_proofs.h).
template <class Floats>
HWY_INLINE Floats gone(const Floats (&row)[3], const Floats& shift, const Floats (&point)[3])
{
  return MulAdd(point[2], row[2], MulAdd(point[1], row[1], MulAdd(point[0], row[0], shift)));
}

/// Returns an upper bound of the distance by which these columns move any point of the box. Infinite or undefined where
/// one is.
HWY_INLINE double farthest(const float (&column)[4][4], const Box_corners& box)
{
  constexpr Float_tag tag;
  constexpr hn::CappedTag<float, 4> four;
  auto most = hn::Zero(tag);
  for (std::size_t first = 0; first < lanes; first += hn::Lanes(tag)) {
    const auto load = [&](int k) HWY_ATTR { return hn::Load(tag, box.corner[k] + first); };
    const One_test::Floats corner[3] = {load(0), load(1), load(2)};
    const auto along = [&](int k) HWY_ATTR {
      const auto all = [&](int j) HWY_ATTR { return hn::Set(tag, column[j][k]); };
      const One_test::Floats row[3] = {all(0), all(1), all(2)};
      return gone(row, all(3), corner);
    };
    const auto x = along(0), y = along(1), z = along(2);
    most = Max(most, MulAdd(z, z, MulAdd(y, y, Mul(x, x))));
  }
  auto sum = hn::Zero(four), shift = hn::Zero(four);
  for (std::size_t k = 0; k < 4; k += hn::Lanes(four)) {
    const auto size = [&](int j) HWY_ATTR { return Abs(hn::Load(four, column[j] + k)); };
    sum = Add(sum, Add(size(0), Add(size(1), size(2))));
    shift = Add(shift, size(3));
  }
  // A vector's maximum may have dropped an undefined value; the sums have not.
  const double size = double(hn::GetLane(hn::SumOfLanes(four, shift))) +
                      double(box.reach) * double(hn::GetLane(hn::SumOfLanes(four, sum)));
  return std::sqrt(double(hn::GetLane(hn::MaxOfLanes(tag, most)))) * double(rounded_up) + motion_rounding * size +
         motion_underflow;
}

inline HWY_ATTR double stray_bound_simd(const Course& course, double steps, const Placement& before,
                                        const Placement& after, const Box_corners& box)
{
  constexpr hn::CappedTag<double, 4> doubles;
  constexpr hn::Rebind<float, decltype(doubles)> narrow;
  alignas(16) float rest[4][4];
  for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles))
    for (int j = 0; j < 4; ++j) {
      const auto gone = Sub(hn::Load(doubles, after.column[j] + k), hn::Load(doubles, before.column[j] + k)),
                 on = hn::PromoteTo(doubles, hn::Load(narrow, course.column[j] + k));
      hn::StoreU(hn::DemoteTo(narrow, NegMulAdd(on, hn::Set(doubles, steps), gone)), narrow, rest[j] + k);
    }
  return farthest(rest, box) + (before.error + after.error);
}

inline HWY_ATTR double pace_bound_simd(const Course& course, const Box_corners& box)
{
  return farthest(course.column, box);
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_SIMD_INL
#endif
