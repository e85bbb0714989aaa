#include "tetracone/kernel/motion/body_motion.h"

#include "verify/cases/random.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_body_motion)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using tetracone::verify::Random;

Rational part(int n, int d) { return Rational(n) / d; }

Rigid_pose any_rigid(Random& random)
{
  const auto small = [&] { return part(int(random.bits() % 17) - 8, 1 + int(random.bits() % 5)); };
  return {{part(9, 2), small(), small(), small()}, {small(), small(), small()}};
}

/// The coordinate of a form's image over the divisor, at a time.
Rational value(const Integer_form& form, const Rational& time)
{
  Rational sum = 0, s = 1 - time;
  for (std::size_t k = 0; k < form.size(); ++k) {
    Rational term = form[k];
    for (std::size_t j = 0; j + 1 < form.size(); ++j) term *= j < k ? time : s;
    sum += term;
  }
  return sum;
}

BOOST_AUTO_TEST_CASE(a_linear_motion_is_between_its_poses)
{
  std::array<Rational, 12> to = {0, -1, 0, 5, 1, 0, 0, part(1, 3), 0, 0, 2, -2};
  const Body_motion motion = Body_motion::linear(Pose::translation(1, 2, 0.5), Pose(to));
  BOOST_TEST(!motion.is_rigid());
  BOOST_TEST((motion.at(0) == Pose::translation(1, 2, 0.5)));
  BOOST_TEST((motion.at(1) == Pose(to)));
  const Pose third = motion.at(part(1, 3));
  BOOST_TEST(third.exact(0) == part(2, 3));
  BOOST_TEST(third.exact(1) == part(-1, 3));
  BOOST_TEST(third.exact(3) == part(7, 3));
  BOOST_TEST(third.exact(7) == part(13, 9));
}

BOOST_AUTO_TEST_CASE(a_rigid_motion_is_a_rotation_at_every_time)
{
  Random random(1);
  for (int k = 0; k < 20; ++k) {
    const Rigid_pose from = any_rigid(random), to = any_rigid(random);
    const Body_motion motion = Body_motion::rigid(from, to).value();
    for (const Rational& time : {part(0, 1), part(1, 1), part(2, 7)}) {
      const Pose pose = motion.at(time);
      BOOST_TEST(rationals::is_orthonormal(pose));
      const auto between = [&](const Rational& start, const Rational& end) {
        return Rational(start + time * (end - start));
      };
      for (int i = 0; i < 3; ++i) BOOST_TEST(pose.exact(4 * i + 3) == between(from.translation[i], to.translation[i]));
      BOOST_TEST(pose.determinant_sign() == CGAL::POSITIVE);
      // The axis (x, y, z) of q(t) stays where it is.
      rationals::Vector axis;
      for (int i = 0; i < 3; ++i) axis[i] = between(from.quaternion[1 + i], to.quaternion[1 + i]);
      BOOST_TEST((rationals::turned(pose, axis) == axis));
    }
  }
}

BOOST_AUTO_TEST_CASE(quaternions_between_which_one_is_0_are_no_motion)
{
  const auto with = [](int w, int x) { return Rigid_pose{{w, x, 0, 0}, {0, 0, 0}}; };
  BOOST_TEST(!Body_motion::rigid(with(1, 0), with(-1, 0)));
  BOOST_TEST(!Body_motion::rigid(with(1, 2), with(-3, -6)));
  BOOST_TEST(!Body_motion::rigid(with(0, 0), with(1, 0)));
  BOOST_TEST(Body_motion::rigid(with(1, 2), with(3, 6)).has_value());
  BOOST_TEST(Body_motion::rigid(with(1, 0), with(-1, 1)).has_value());
}

BOOST_AUTO_TEST_CASE(common_forms_are_of_the_least_degree_and_place_points)
{
  Random random(2);
  const Rigid_pose p = any_rigid(random), q = any_rigid(random), r = any_rigid(random), s = any_rigid(random);
  const Body_motion rests = Body_motion::rigid(p, p).value(), turns = Body_motion::rigid(p, q).value(),
                    other = Body_motion::rigid(r, s).value();
  const Body_motion shifts = Body_motion::rigid(p, {p.quaternion, q.translation}).value(),
                    spins = Body_motion::rigid(p, {q.quaternion, p.translation}).value();
  BOOST_TEST(Pair_motion(rests, rests).size() == 1u);
  BOOST_TEST(Pair_motion(rests, shifts).size() == 2u);
  BOOST_TEST(Pair_motion(spins, rests).size() == 3u);
  BOOST_TEST(Pair_motion(turns, rests).size() == 4u);
  BOOST_TEST(Pair_motion(turns, other).size() == 6u);

  const Pair_motion pair(turns, other);
  const Vertex v = {0.375, -2, 1024.5};
  const Form_vector image = pair.image(1, v, Pair_motion::exponent_of(v));
  const Rational time = part(3, 11), scale = part(8, 1);
  const rationals::Vector placed = rationals::image(other.at(time), rationals::exactly(v));
  for (int i = 0; i < 3; ++i)
    BOOST_TEST(value(image[i], time) == Rational(placed[i] * value(pair.divisor(), time) * scale));
}

BOOST_AUTO_TEST_CASE(volumes_of_rigid_pairs_have_the_square_of_the_divisor)
{
  // The quotient is exact: by the square again it is the volume.
  Random random(3);
  for (int k = 0; k < 10; ++k) {
    const Body_motion a = Body_motion::rigid(any_rigid(random), any_rigid(random)).value(),
                      b = Body_motion::rigid(any_rigid(random), any_rigid(random)).value();
    const Pair_motion pair(a, b);
    for (const int of_a : {1, 2, 3}) {
      std::array<Form_vector, 4> p;
      for (int i = 0; i < 4; ++i) p[i] = pair.image(i < of_a ? 0 : 1, {double(i * i), i == 1 ? 3.0 : 1, 2.0 - i}, 0);
      std::array<Form_vector, 3> d;
      for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis) d[i][axis] = p[i + 1][axis] - p[0][axis];
      Integer_form volume = cross_form(d[0], d[1], 0) * d[2][0];
      for (std::size_t axis = 1; axis < 3; ++axis) volume += cross_form(d[0], d[1], axis) * d[2][axis];
      const Integer_form rest = quotient(volume, pair.square()), again = rest * pair.square();
      BOOST_TEST(rest.size() == 6u);
      BOOST_TEST((volume - again).is_zero());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
