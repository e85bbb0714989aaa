#include "tetracone/kernel/contact/corner_errors.h"

#include "tetracone/kernel/contact/rational_face.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_corner_errors)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

BOOST_AUTO_TEST_CASE(rounded_numbers_are_off_by_no_more_than_the_bounds)
{
  Random random(4);
  // From no error but the roundings, to one of a share of the edges, far from the origin and near to it.
  for (const double width : {0.0, 0x1p-50, 0x1p-20, 0x1p-3})
    for (const double far : {0.0, 1024.0}) {
      std::array<Rational, 5> most{};
      for (int round = 0; round < 300; ++round) {
        const CGAL::Protect_FPU_rounding<true> upward;
        Corner_errors errors;
        std::array<Rational_point, 5> exact;
        std::array<Number_point<double>, 5> rounded;
        for (std::size_t corner = 0; corner < exact.size(); ++corner) {
          Number_point<Interval> about;
          for (std::size_t k = 0; k < 3; ++k) {
            const double x = far + real(random, -1, 1);
            about[k] = Interval(x - width, x + width);
            // A corner is at an end of its enclosure, as far off as can be.
            exact[corner][k] = integer(random, 0, 1) ? about[k].inf() : about[k].sup();
          }
          rounded[corner] = errors.rounded(about);
        }
        const auto edge = [&](std::size_t k) {
          const auto step = difference(rounded[k], rounded[0]);
          errors.add_edge(step);
          return step;
        };
        const std::array about_edges = {edge(1), edge(2), edge(3)};
        const Rational_point e = difference(exact[1], exact[0]), n = cross(e, difference(exact[2], exact[0])),
                             other = difference(exact[3], exact[0]);
        const auto about_n = cross(about_edges[0], about_edges[1]);
        const auto check = [&](std::size_t kind, const Rational& is, double said, double bound) {
          const Rational off = abs(is - Rational(said));
          BOOST_TEST(off <= Rational(bound));
          const Rational share = off / Rational(bound);
          if (share > most[kind]) most[kind] = share;
        };
        for (std::size_t k = 0; k < 3; ++k) {
          check(0, e[k], about_edges[0][k], errors.off_edge());
          check(1, n[k], about_n[k], errors.off_normal());
        }
        check(2, dot(n, exact[4]), dot(about_n, rounded[4]), errors.off_height());
        check(3, dot(n, other), dot(about_n, about_edges[2]), errors.off_turn());
        check(4, dot(e, exact[4]), dot(about_edges[0], rounded[4]), errors.off_edge_height());
      }
      // The bounds are of the errors' size: each is reached up to a small factor where enclosures are wide.
      if (width >= 0x1p-20)
        for (const Rational& share : most) BOOST_TEST(share > Rational(1, 40));
    }
}

BOOST_AUTO_TEST_CASE(errors_of_two_sets_of_corners_cover_both)
{
  const CGAL::Protect_FPU_rounding<true> upward;
  Corner_errors small, wide;
  small.rounded({Interval(1), Interval(2), Interval(3)});
  wide.rounded({Interval(0, 0x1p-10), Interval(0), Interval(0)});
  wide.add_edge({0, 5, 0});
  for (const Corner_errors& both : {Corner_errors(small, wide), Corner_errors(wide, small)}) {
    BOOST_TEST(both.off_edge() == wide.off_edge());
    BOOST_TEST(both.off_height() > wide.off_height());
  }
}

BOOST_AUTO_TEST_SUITE_END()
