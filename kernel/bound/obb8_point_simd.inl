#ifndef TETRACONE_KERNEL_BOUND_OBB8_POINT_SIMD_INL
#define TETRACONE_KERNEL_BOUND_OBB8_POINT_SIMD_INL
// Included by kernel/bound/obb8_point.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_OBB8_POINT_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/obb8_point.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Implements `point_squares`.
inline HWY_ATTR void point_squares_simd(const Obb8& boxes, const std::array<double, 3>& point, float* squares)
{
  constexpr hn::CappedTag<float, lanes> tag{};
  constexpr hn::RebindToUnsigned<decltype(tag)> bits{};
  float from[3], m = boxes.reach;
  for (int k = 0; k < 3; ++k) {
    from[k] = float(point[std::size_t(k)] - double(boxes.origin[k]));
    m += from[k] < 0 ? -from[k] : from[k];
  }
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(tag)) {
    const auto load = [&](const float* first) HWY_ATTR { return hn::Load(tag, first + lane); };
    const auto all = [&](float x) HWY_ATTR { return hn::Set(tag, x); };
    const auto slack = all(point_box_rounding * m), zero = hn::Zero(tag);
    const auto x = hn::Sub(all(from[0]), load(boxes.centre[0])), y = hn::Sub(all(from[1]), load(boxes.centre[1])),
               z = hn::Sub(all(from[2]), load(boxes.centre[2]));
    auto sum = zero;
    for (int i = 0; i < 3; ++i) {
      const auto u = load(boxes.axis[i][0]), v = load(boxes.axis[i][1]), w = load(boxes.axis[i][2]);
      const auto at = hn::Abs(hn::MulAdd(w, z, hn::MulAdd(v, y, hn::Mul(u, x))));
      const auto beyond = hn::Max(zero, hn::Sub(hn::Sub(at, load(boxes.extent[i])), slack));
      sum = hn::MulAdd(beyond, beyond, sum);
    }
    const auto number = hn::Iota(bits, std::uint32_t(lane)), of_number = hn::Set(bits, lanes - 1);
    const auto square = hn::AndNot(of_number, hn::BitCast(bits, hn::Mul(sum, all(point_square_shrink))));
    hn::StoreU(hn::BitCast(tag, hn::Or(square, number)), tag, squares + lane);
  }
}

/// Implements `nearest_lane`.
inline HWY_ATTR int nearest_lane_simd(const Lane_squares& squares, std::uint32_t left, float limit)
{
  constexpr hn::CappedTag<float, lanes> tag{};
  constexpr hn::RebindToUnsigned<decltype(tag)> bits{};
  static constexpr std::array<std::uint32_t, lanes> bit = {1, 2, 4, 8, 16, 32, 64, 128};
  auto least = hn::Set(tag, std::numeric_limits<float>::max());
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(tag)) {
    const auto is_left = hn::TestBit(hn::Set(bits, left), hn::LoadU(bits, bit.data() + lane));
    const auto square = hn::LoadU(tag, squares.data() + lane);
    least = hn::Min(least, hn::IfThenElse(hn::RebindMask(tag, is_left), square, least));
  }
  const float nearest = hn::GetLane(hn::MinOfLanes(tag, least));
  return left == 0 || nearest > limit ? -1 : int(std::bit_cast<std::uint32_t>(nearest) % lanes);
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_OBB8_POINT_SIMD_INL
#endif
