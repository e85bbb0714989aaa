#include "tetracone/kernel/bound/obb8_point.h"

#include "tetracone/kernel/bound/oriented_box.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_obb8_point)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

inline auto point_versions() { return TETRACONE_VERSIONS_HERE(point_squares_simd); }
/// Upper bound of what the number of a lane adds to a bound.
constexpr float lane_number = 7 * std::numeric_limits<float>::denorm_min();
inline auto nearest_versions() { return TETRACONE_VERSIONS_HERE(nearest_lane_simd); }

Vector random_vector(Random& random) { return {real(random, -1, 1), real(random, -1, 1), real(random, -1, 1)}; }

/// Puts a box about a centre, and returns its axes as they are kept.
Matrix put(Obb8& boxes, int lane, Random& random)
{
  const Matrix axes = detail::axes_from(random_vector(random).normalized(), random_vector(random).normalized());
  Matrix kept;
  for (int i = 0; i < 3; ++i) {
    boxes.extent[i][lane] = float(real(random, 0, 0.5) * (integer(random, 0, 2) == 0 ? 1e-3 : 1));
    boxes.centre[i][lane] = float(real(random, -0.5, 0.5));
    for (int k = 0; k < 3; ++k) kept(k, i) = boxes.axis[i][k][lane] = float(axes(k, i));
  }
  return kept;
}

BOOST_AUTO_TEST_CASE(no_point_of_a_box_is_nearer_than_the_bound_which_is_close)
{
  Random random(4620);
  long wrong = 0, inside = 0, loose = 0;
  for (const auto squares_of : point_versions())
    for (int round = 0; round < 4000; ++round) {
      Obb8 boxes{};
      boxes.lane_count = int(lanes);
      for (float& x : boxes.origin) x = float(real(random, -1, 1));
      std::array<Matrix, lanes> axes;
      for (int lane = 0; lane < int(lanes); ++lane) axes[std::size_t(lane)] = put(boxes, lane, random);
      boxes.reach = 2.5;
      // From a point on one box's border, along an axis or anywhere; and far away.
      const int asked = integer(random, 0, int(lanes) - 1), across = integer(random, 0, 2);
      const std::array<double, 3> centre = centre_of(boxes, asked);
      Vector on(centre[0], centre[1], centre[2]);
      for (int i = 0; i < 3; ++i) {
        const double share = i == across ? 1 : real(random, -1, 1);
        on += share * double(boxes.extent[i][asked]) * axes[std::size_t(asked)].col(i);
      }
      const double way = std::array{0.0, 1e-6, 0.5, 0x1p30}[std::size_t(integer(random, 0, 3))];
      const Vector axis = axes[std::size_t(asked)].col(across);
      const Vector p = on + way * axis;
      Lane_squares squares;
      squares_of(boxes, {p[0], p[1], p[2]}, squares.data());
      const double square = squares[std::size_t(asked)], exact = (p - on).squared_norm();
      wrong += square > exact + lane_number;
      inside += way == 0 && square <= lane_number;
      loose += std::sqrt(square) < std::sqrt(exact) * (1 - 1e-4) - 1e-5;
    }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(inside > 500);
  BOOST_TEST(loose == 0);
}

BOOST_AUTO_TEST_CASE(the_nearest_lane_is_the_least_that_is_left_within_the_limit)
{
  Random random(4621);
  constexpr float all = std::numeric_limits<float>::infinity();
  long wrong = 0, none = 0;
  for (const auto nearest : nearest_versions()) {
    wrong += nearest(zero_squares, 0, all) != -1;
    wrong += nearest(zero_squares, 0b11001000, all) != 3;
    for (int round = 0; round < 20000; ++round) {
      Lane_squares squares = zero_squares;
      for (float& square : squares)  // some are equal but for the number
        square += integer(random, 0, 2) == 0 ? 0 : std::ldexp(1.0f, integer(random, -3, 3));
      for (std::uint32_t lane = 0; lane < lanes; ++lane)
        squares[lane] = std::bit_cast<float>((std::bit_cast<std::uint32_t>(squares[lane]) & ~7u) | lane);
      const std::uint32_t left = std::uint32_t(integer(random, 0, 255));
      const float limit = integer(random, 0, 3) == 0 ? all : std::ldexp(1.0f, integer(random, -4, 3));
      int expected = -1;
      for (int lane = 0; lane < int(lanes); ++lane) {
        const float square = squares[std::size_t(lane)];
        if ((left >> lane & 1) == 0 || square > limit) continue;
        if (expected < 0 || square < squares[std::size_t(expected)]) expected = lane;
      }
      wrong += nearest(squares, left, limit) != expected;
      none += expected < 0;
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(none > 500);
}

BOOST_AUTO_TEST_SUITE_END()
