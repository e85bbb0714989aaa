#include "tetracone/kernel/predicate/vertex_separation.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_vertex_separation)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

bool are_parted(const std::array<double, 3>& direction, const std::vector<Vertex>& a, const Pose& pose_a,
                const std::vector<Vertex>& b, const Pose& pose_b, int steps)
{
  return are_parted_by_vertices(
      direction, {a, largest_coordinate(a), pose_a}, [&](std::size_t v) { return Adaptive::placed(a[v], pose_a); },
      {b, largest_coordinate(b), pose_b}, [&](std::size_t v) { return Adaptive::placed(b[v], pose_b); }, steps);
}

/// A shift in the frame's own coordinates.
Pose beside(const Pose& frame, const std::array<Rational, 3>& t)
{
  return composed(frame, Pose(std::array<Rational, 12>{1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2]}));
}

BOOST_AUTO_TEST_CASE(cubes_beside_one_another_are_parted_at_a_corner_by_any_gap_and_never_where_they_touch)
{
  // A map that is no rotation turns directions another way than normals: only what touches is known then.
  Random random(1);
  const std::vector<Vertex> cube = unit_cube().vertices;
  int wrong = 0, parted = 0, apart = 0;
  for (int n = 0; n < 6000; ++n) {
    const bool is_rotation = n % 4 != 0;
    const Pose frame = is_rotation ? random_rotation(random, 5, {Rational(integer(random, -99, 99)) / 97, 3, 0})
                                   : random_affine(random);
    const int shared = integer(random, 2, 3);  // axes along which the cubes stand side by side
    const Rational gap = Rational(integer(random, -1, 1)) * Rational(std::ldexp(1.0, -integer(random, 1, 80)));
    std::array<Rational, 3> shift = {0, 0, 0};
    for (int k = 0; k < shared; ++k) shift[std::size_t(k)] = 1 + gap;
    std::array<double, 3> way{};  // of the shift, turned
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) way[std::size_t(i)] += frame[4 * i + k] * shift[std::size_t(k)].get_d();
    const bool is_parted = are_parted(way, cube, frame, cube, beside(frame, shift), 3);
    wrong += is_parted && gap <= 0;
    if (is_rotation && gap > 0 && shared == 3) {  // few directions part edges: a rounded one mostly does not
      ++apart;
      parted += is_parted;
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(apart > 500);
  BOOST_TEST(parted == apart);
}

BOOST_AUTO_TEST_CASE(every_vertex_that_is_near_is_asked)
{
  const std::vector<Vertex> origin = {{0, 0, 0}}, beyond = {{0x1p-60, 0, 0}, {0x1p-70, 1, 0}},
                            beyond_and_at = {{0x1p-60, 0, 0}, {0, 1, 0}}, before_and_at = {{-0x1p-60, 0, 0}, {0, 1, 0}};
  BOOST_TEST(are_parted({1, 0, 0}, origin, Pose(), beyond, Pose(), 1));
  BOOST_TEST(!are_parted({1, 0, 0}, origin, Pose(), beyond_and_at, Pose(), 1));
  BOOST_TEST(!are_parted({1, 0, 0}, before_and_at, Pose(), origin, Pose(), 1));
}

BOOST_AUTO_TEST_CASE(a_direction_along_which_bodies_overlap_is_mirrored)
{
  const std::vector<Vertex> a = {{0, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-1, 0, 0}}, b = {{0x1p-30, 1, 1}, {3, 1, 1}};
  const std::array<double, 3> aslant = {1, 0.75, 0};
  BOOST_TEST(!are_parted(aslant, a, Pose(), b, Pose(), 1));
  BOOST_TEST(are_parted({1, 0, 0}, a, Pose(), b, Pose(), 1));
  const std::vector<Vertex> c = {{0, 0, 0}, {-4, 4, 1}, {-4, -4, -1}}, d = {{1, 0, 0}, {1, -8, 0}};
  BOOST_TEST(!are_parted(aslant, c, Pose(), d, Pose(), 1));
  BOOST_TEST(are_parted(aslant, c, Pose(), d, Pose(), 4));
}

BOOST_AUTO_TEST_CASE(directions_and_bodies_beyond_all_bounds_part_nothing)
{
  const std::vector<Vertex> a = {{0, 0, 0}}, b = {{1, 0, 0}}, far = {{0x1p200, 0, 0}};
  const double infinity = HUGE_VAL, nan = std::nan("");
  BOOST_TEST(are_parted({1, 0, 0}, a, Pose(), b, Pose(), 1));
  for (const double bad : {0.0, nan, infinity, -infinity, 0x1p-1000}) {
    BOOST_TEST(!are_parted({bad, 0, 0}, a, Pose(), b, Pose(), 3));
    BOOST_TEST(!are_parted({0, 0, bad}, a, Pose(), b, Pose(), 3));
  }
  BOOST_TEST(!are_parted({1, 0, 0}, a, Pose(), far, Pose(), 3));
  BOOST_TEST(!are_parted({1, 0, 0}, a, Pose(), b, Pose::translation(0x1p900, 0, 0), 3));
}

BOOST_AUTO_TEST_SUITE_END()
