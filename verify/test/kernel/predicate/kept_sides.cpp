#include "tetracone/kernel/predicate/kept_sides.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_kept_sides)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

/// Points of two bodies, mostly about one plane: many signs are exactly 0, or too small for the filter.
class Two_bodies {
 public:
  static constexpr int count = 30;  // vertices of each

  void place(Random& random)
  {
    const Pose frame = random_rotation(random, 5, {Rational(integer(random, -9, 9)) / 7, 1, Rational(1) / 3});
    pose_ = {integer(random, 0, 1) == 0 ? rounded(frame) : frame, integer(random, 0, 1) == 0 ? rounded(frame) : frame};
    for (std::size_t body : {0, 1})
      for (std::size_t v = 0; v < count; ++v) {
        Vertex vertex = grid_vertex(random, 2);
        vertex[2] = std::ldexp(double(integer(random, -1, 1)), -integer(random, 0, 1) * 52);
        point_[body][v] = Adaptive::placed(vertex, pose_[body]);
        exact_[body][v] = rationals::image(pose_[body], rationals::exactly(vertex));
      }
  }
  Corners<Adaptive> corners(std::size_t body, const std::array<std::size_t, 3>& v) const
  {
    return {&point_[body][v[0]], &point_[body][v[1]], &point_[body][v[2]]};
  }
  Sign side(std::size_t body, const std::array<std::size_t, 3>& t, std::size_t v) const
  {
    const auto& p = exact_[body];
    return CGAL::sign(rationals::six_volume(p[t[0]], p[t[1]], p[t[2]], exact_[1 - body][v]));
  }

 private:
  std::array<Pose, 2> pose_;
  std::array<std::array<Point<Adaptive>, count>, 2> point_;
  std::array<std::array<rationals::Vector, count>, 2> exact_;
};

BOOST_AUTO_TEST_CASE(signs_are_exact_at_every_pose_however_often_they_are_asked)
{
  Random random(1);
  Two_bodies bodies;
  Kept_sides sides_of;
  int wrong = 0, zeros = 0;
  std::uint64_t asked_again = 0;
  for (int pose = 0; pose < 60; ++pose) {
    bodies.place(random);
    sides_of.clear();
    for (int k = 0; k < 400; ++k) {  // more than there are places
      const auto vertex = [&] { return std::size_t(integer(random, 0, Two_bodies::count - 1)); };
      const std::size_t body = std::size_t(integer(random, 0, 1));
      // Many triangles of one corner, and one point: planes that differ in the other corners alone.
      const std::array<std::size_t, 3> triangle = {k % 2 == 0 ? 0 : vertex(), vertex(), vertex()},
                                       points = {0, vertex(), vertex()};
      const auto ask = [&] { return sides_of(bodies.corners(body, triangle), bodies.corners(1 - body, points)); };
      const auto first = ask();
      const auto before = Adaptive::decided_by();
      const auto second = ask();
      asked_again += (Adaptive::decided_by() - before).total();
      for (std::size_t i = 0; i < 3; ++i) {
        const Sign truth = bodies.side(body, triangle, points[i]);
        wrong += (first[i] != truth) + (second[i] != truth);
        zeros += truth == ZERO;
      }
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(zeros > 10000);
  // Two of three new signs may have one place.
  BOOST_TEST(asked_again < sides_of.undecided() / 20);
  BOOST_TEST(sides_of.bytes() > 0u);
}

BOOST_AUTO_TEST_SUITE_END()
