#include "tetracone/tetratree/scene/body_box.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/world_boxes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_body_box)

using namespace tetracone::tetratree;
using namespace tetracone;
using kernel::Pose;
using kernel::Rational;
namespace scenes = verify::scenes;
namespace rationals = verify::rationals;
using verify::holds;

namespace {

/// A body on its way: its exact points, and a box that it carries.
class Walker {
 public:
  Walker(scenes::Random& random, double size, double far) : random_(random), size_(size)
  {
    for (auto& v : body_.vertices)
      for (int k = 0; k < 3; ++k) v[k] = size * v[k] + far * scenes::real(random, -1, 1) * 0x1p-20;
    extent_ = Body_extent(body_.vertices);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m_[4 * i + j] = scenes::real(random, -1, 1);
      m_[4 * i + 3] = far * scenes::real(random, -1, 1);
    }
    place_.at = body_step(extent_, pose(), pose()).at;
    find();
  }

  void find() { box_ = {world_box(extent_, pose()), place_}; }

  void move(double by)
  {
    const Pose before = pose();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) m_[4 * i + j] += by * (j < 3 ? 1 : size_) * scenes::real(random_, -1, 1);
    const auto [at, turned] = body_step(extent_, before, pose());
    place_.at = at;
    place_.turned = (place_.turned + turned) * (1 + 0x1p-51);
  }

  Pose pose() const { return Pose(m_); }
  const Body_box& box() const { return box_; }
  const Body_place& place() const { return place_; }

  std::vector<rationals::Vector> points() const
  {
    std::vector<rationals::Vector> all;
    for (const auto& v : body_.vertices) all.push_back(rationals::image(pose(), rationals::exactly(v)));
    return all;
  }

 private:
  scenes::Random& random_;
  covering::Polyhedron body_ = scenes::cube(1);
  Body_extent extent_;
  double size_;
  std::array<double, 12> m_;
  Body_place place_;
  Body_box box_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(it_holds_a_body_that_has_moved_and_says_at_most_how_far_it_is_from_another)
{
  scenes::Random random(3);
  std::size_t within = 0, out = 0, apart = 0;
  for (int n = 0; n < 300; ++n) {
    const double size = std::ldexp(1.0, scenes::integer(random, -30, 30)),
                 far = std::ldexp(size, scenes::integer(random, -1, 45)),
                 step = std::ldexp(1.0, -scenes::integer(random, 1, 30));
    Walker one(random, size, far), other(random, size, far);
    World_box wide = one.box().at(one.place()).grown(step * size);
    for (int round = 0; round < 8; ++round) {
      const auto points = one.points(), others = other.points();
      const World_box box = one.box().at(one.place());
      const bool is_within = one.box().is_within(wide, one.place());
      (is_within ? within : out) += 1;
      for (const auto& p : points) {
        BOOST_REQUIRE(holds(box, p));
        BOOST_REQUIRE((!is_within || holds(wide, p)));
      }
      const double gap = one.box().gap(one.place(), other.box(), other.place());
      BOOST_REQUIRE(gap <= other.box().gap(other.place(), one.box(), one.place()) + 0x1p-20 * far);
      if (gap > 0) {
        ++apart;
        for (const auto& p : points)
          for (const auto& q : others) {
            const auto between = rationals::minus(p, q);
            BOOST_REQUIRE(rationals::inner(between, between) >= Rational(gap) * Rational(gap));
          }
      }
      one.move(step / 4);
      if (round % 3 == 0) other.move(step);
      if (round == 5) one.find();
    }
  }
  BOOST_TEST(within > 300u);
  BOOST_TEST(out > 300u);
  BOOST_TEST(apart > 100u);
}

BOOST_AUTO_TEST_CASE(of_a_body_that_is_anywhere_nothing_is_known)
{
  const Body_box nothing, all(World_box(), Body_place{{1, 2, 3}, 4});
  const Body_place place{{5, 6, 7}, 8};
  for (const Body_box& box : {nothing, all}) {
    BOOST_TEST(!box.at(place).is_bounded());
    BOOST_TEST(!(box.gap(place, Body_box(World_box{{9, 9, 9}, {10, 10, 10}}, place), place) > 0));
    BOOST_TEST(box.is_within(World_box(), place));
    BOOST_TEST(!box.is_within(World_box{{0, 0, 0}, {9, 9, 9}}, place));
  }
  const Body_place lost{{std::numeric_limits<double>::infinity(), std::nan(""), 0}, 0};
  const Body_box box(World_box{{0, 0, 0}, {1, 1, 1}}, place);
  BOOST_TEST(!box.is_within(World_box{{0, 0, 0}, {9, 9, 9}}, lost));
  BOOST_TEST(!(box.gap(lost, box, place) > 0));
}

BOOST_AUTO_TEST_SUITE_END()
