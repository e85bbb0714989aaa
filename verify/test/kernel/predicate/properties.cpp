// Properties of the kernel on whatever RapidCheck thinks of, shrunk by it where one fails.

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/signs.h"

#include <rapidcheck.h>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

BOOST_AUTO_TEST_SUITE(test_properties)

using namespace tetracone::kernel;

namespace {

/// Coordinates: small integers and quarters, which meet often; any mantissa near 1; any finite double within 2^+-300.
rc::Gen<double> coordinate()
{
  const auto quarter = rc::gen::map(rc::gen::inRange(-12, 13), [](int k) { return k / 4.0; });
  const auto near_one = rc::gen::map(rc::gen::inRange<std::int64_t>(-(1ll << 53), 1ll << 53),
                                     [](std::int64_t k) { return double(k) * 0x1p-53; });
  const auto any = rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return std::isfinite(x) && std::abs(x) < 0x1p300 ? x : 0.0;
  });
  return rc::gen::weightedOneOf<double>({{4, quarter}, {2, near_one}, {1, any}});
}
rc::Gen<Vertex> vertex() { return rc::gen::container<Vertex>(coordinate()); }

rc::Gen<Pose> pose()
{
  return rc::gen::suchThat(rc::gen::oneOf(rc::gen::just(Pose()),
                                          rc::gen::map(rc::gen::container<std::array<double, 12>>(coordinate()),
                                                       [](const auto& entries) { return Pose(entries); }),
                                          rc::gen::map(rc::gen::container<std::array<int, 4>>(rc::gen::inRange(-5, 6)),
                                                       [](const auto& q) {
                                                         return q == std::array<int, 4>{0, 0, 0, 0}
                                                                    ? Pose()
                                                                    : Pose::from_quaternion(q[0], q[1], q[2], q[3],
                                                                                            {Rational(1) / 3, 0, 1});
                                                       })),
                           [](const Pose& p) { return p.determinant_sign() != ZERO; });
}

bool holds(bool result) { return result; }

template <class Property>
void check(const char* name, const Property& property)
{
  BOOST_TEST(holds(rc::check(name, property)), name);
}

}  // namespace

BOOST_AUTO_TEST_CASE(adaptive_signs_are_those_of_rational_arithmetic)
{
  check("volume", [] {
    const Pose a = *pose(), b = *pose();
    const auto v = *rc::gen::container<std::array<Vertex, 4>>(vertex());
    const Frame<Adaptive> adaptive_a(a), adaptive_b(b);
    const Frame<Rational_kernel> rational_a(a), rational_b(b);
    const auto p = [&](int k) { return k < 3 ? adaptive_a(point<Adaptive>(v[k])) : adaptive_b(point<Adaptive>(v[k])); };
    const auto q = [&](int k) {
      return k < 3 ? rational_a(point<Rational_kernel>(v[k])) : rational_b(point<Rational_kernel>(v[k]));
    };
    RC_ASSERT(volume_sign<Adaptive>(p(0), p(1), p(2), p(3)) == volume_sign<Rational_kernel>(q(0), q(1), q(2), q(3)));
    for (int axis = 0; axis < 3; ++axis) {
      RC_ASSERT(normal_sign<Adaptive>(p(0), p(1), p(3), axis) == normal_sign<Rational_kernel>(q(0), q(1), q(3), axis));
      RC_ASSERT(difference_sign<Adaptive>(p(2), p(3), axis) == difference_sign<Rational_kernel>(q(2), q(3), axis));
    }
  });
}

BOOST_AUTO_TEST_CASE(a_segment_meets_a_triangle_whichever_way_both_are_written)
{
  check("order", [] {
    const Pose a = *pose();
    const auto v = *rc::gen::container<std::array<Vertex, 5>>(vertex());
    const Frame<Adaptive> frame(a);
    std::array<Point<Adaptive>, 5> p;
    for (int k = 0; k < 5; ++k) p[k] = k < 3 ? frame(point<Adaptive>(v[k])) : point<Adaptive>(v[k]);
    const auto contact = [&](int s, int t, int x, int y, int z) {
      return segment_face<Adaptive>(p[s], p[t], Triangle<Adaptive>{p[x], p[y], p[z]});
    };
    const Contact kind = contact(3, 4, 0, 1, 2);
    RC_ASSERT(contact(4, 3, 0, 1, 2) == kind);
    RC_ASSERT(contact(3, 4, 1, 2, 0) == kind);
    RC_ASSERT(contact(3, 4, 2, 1, 0) == kind);
    // Both ways of deciding a triangle agree.
    if (!Triangle<Adaptive>{p[0], p[1], p[2]}.is_degenerate())
      RC_ASSERT(segment_triangle<Adaptive>(p[3], p[4], p[0], p[1], p[2]) == kind);
  });
}

BOOST_AUTO_TEST_CASE(the_shortest_decimal_is_read_as_the_same_double)
{
  check("decimal", [] {
    const double x = *coordinate();
    const auto read = parse_double(shortest(x));
    RC_ASSERT(read.has_value());
    RC_ASSERT(*read == x);
    RC_ASSERT(nearest_double(Rational(x)) == x);
  });
}

BOOST_AUTO_TEST_CASE(the_sign_of_a_determinant_is_that_of_its_reflection_turned)
{
  check("determinant", [] {
    const auto entries = *rc::gen::container<std::array<double, 12>>(coordinate());
    std::array<double, 12> swapped = entries, negated = entries;
    for (int k = 0; k < 4; ++k) {
      std::swap(swapped[k], swapped[4 + k]);
      negated[8 + k] = -negated[8 + k];
    }
    RC_ASSERT(Pose(swapped).determinant_sign() == -Pose(entries).determinant_sign());
    RC_ASSERT(Pose(negated).determinant_sign() == -Pose(entries).determinant_sign());
  });
}

BOOST_AUTO_TEST_SUITE_END()
