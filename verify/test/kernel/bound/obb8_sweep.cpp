#include "tetracone/kernel/bound/obb8_sweep.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_obb8_sweep)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

inline auto find_versions() { return TETRACONE_VERSIONS_HERE(find_near_simd); }

Point_way::Rows rows(Random& random, double size)
{
  Point_way::Rows rows;
  for (auto& row : rows)
    for (double& x : row) x = size * real(random, -1, 1);
  return rows;
}

/// offset + single q - eight p, exactly.
rationals::Vector way(const Point_way& way, const rationals::Vector& p, const rationals::Vector& q)
{
  rationals::Vector sum;
  for (int i = 0; i < 3; ++i) {
    sum[i] = Rational(way.offset[i]);
    for (int j = 0; j < 3; ++j) sum[i] += Rational(way.single[j][i]) * q[j] - Rational(way.eight[j][i]) * p[j];
  }
  return sum;
}

/// Boxes, and one that a lane's point p and its point q meet in, or do not meet by far, at a time from -1 to 1.
struct Scene {
  Placing placing;
  Obb8 boxes{}, from{};
  Box_sweep sweep;
  int lane, other;
  float apex = no_apex;
  double time;
};

Sweep_test test(const Scene& s, const Box_map& map, const Box_sweep& sweep, const Known_times& known = {})
{
  return {&s.boxes, &map, &s.from, s.other, s.apex, &sweep, known, 0, {}};
}

/// `away`: of the single box from where it meets, in sizes of boxes.
Scene scene(Random& random, int kind, double away)
{
  Scene s;
  s.placing = random_placing(random);
  s.lane = integer(random, 0, 7);
  s.other = integer(random, 0, 7);
  const double small = kind % 7 < 2 ? 1e-3 : 0.1;
  set_single(s.from, s.other, random, small, kind % 2 == 0 ? &s.apex : nullptr);
  const double near = small * s.placing.in_b.unit / s.placing.in_a.unit;
  for (int i = 0; i < 3; ++i) s.boxes.origin[i] = float(real(random, -0.25, 0.25));
  set_near(s.boxes, random, near);

  // The single box's corner that comes first, and the lane's, or any points of both.
  const double inside = 1 - 0x1p-20, length = std::exp2(real(random, -6, 4)) * near,
               turn = kind % 3 == 0 ? 0 : std::exp2(real(random, -9, -1));
  s.time = kind % 5 == 0 ? integer(random, -1, 1) : real(random, -1, 1);
  const Vector n = vector(random).normalized();
  const auto share = [&](const Obb8& boxes, int lane, double sense, const Box_map* map) {
    std::array<double, 3> share;
    for (int i = 0; i < 3; ++i) {
      const auto edge = axis(boxes, lane, i);
      share[i] = sense * n.dot(vector_of(map ? map->frame().direction(edge) : edge)) > 0 ? inside : -inside;
    }
    return share;
  };
  const Box_map map = s.placing.map();
  std::array<double, 3> of_single = share(s.from, s.other, -1, &map);
  if (s.apex != no_apex) {
    const double along = real(random, 0, 1);
    const std::array<std::array<double, 3>, 3> corners = {{{0, -1, -1}, {0, 1, -1}, {0, s.apex, 1}}};
    of_single = {0, 0, 0};
    const int first = integer(random, 0, 2);
    for (int i = 1; i < 3; ++i)
      of_single[i] = 0.999 * (along * corners[first][i] + (1 - along) * corners[(first + 1) % 3][i]);
    of_single[2] -= 0.0005;
  }
  const rationals::Vector p = point(s.boxes, s.lane, share(s.boxes, s.lane, 1, nullptr)),
                          q = point(s.from, s.other, of_single);

  // Half the way, any; what is left for the middle makes them meet, with a rest in any direction.
  const double of_rest = kind % 4 == 0 ? 0.1 * near : 0;
  const Vector course = length * vector(random), rest = of_rest * 0.999 * vector(random).normalized();
  // The eight alone turn, at times: what the others lose would hide what they do.
  const double others = kind % 4 == 2 ? 0 : turn;
  s.sweep.half = {{course[0], course[1], course[2]}, rows(random, others * near), rows(random, turn * near)};
  const Point_way::Rows of_q = rows(random, others * near), of_p = rows(random, others * near);
  s.sweep.rest = of_rest;
  const rationals::Vector image = s.placing.image(q), swept = way(s.sweep.half, p, q),
                          bent = way(Point_way({0, 0, 0}, of_q, of_p), p, q);
  std::array<double, 3> offset;
  for (int i = 0; i < 3; ++i)
    offset[i] = nearest_double(Rational(p[i] - image[i] - bent[i] - Rational(s.time) * swept[i])) + rest[i] +
                away * near * n[i];
  s.sweep.middle = {offset, of_q, of_p};
  return s;
}

BOOST_AUTO_TEST_CASE(boxes_that_touch_at_a_time_are_near_at_it)
{
  Random random(1);
  int found = 0, asked = 0, narrow = 0;
  for (int k = 0; k < 6000; ++k)
    for (const double away : {0.0, 4.0}) {
      const Scene s = scene(random, k, away);
      const Box_map map = s.placing.map();
      BOOST_TEST_REQUIRE(map.is_similarity());
      // At all times, or about those of the contact.
      const double time = 0.5 * (s.time + 1);
      const bool is_known = k % 2 == 1;
      const Known_times known = is_known ? Known_times{float(time * real(random, 0.9, 1)) - 0x1p-22f,
                                                       float(1 - (1 - time) * real(random, 0.9, 1)) + 0x1p-22f}
                                         : Known_times{};
      for (const auto find : find_versions()) {
        Sweep_test asked_now = test(s, map, s.sweep, known);
        find(&asked_now, 1);
        const Near_times& times = asked_now.times;
        const bool is_near = asked_now.near >> s.lane & 1;
        if (away == 0) {
          BOOST_TEST(is_near, "round " << k);
          BOOST_TEST(double(times.from[s.lane]) <= time, "round " << k);
          BOOST_TEST(double(times.until[s.lane]) >= time, "round " << k);
          BOOST_TEST((times.from[s.lane] >= known.from && times.until[s.lane] <= known.until), "round " << k);
          narrow += !is_known && times.until[s.lane] - times.from[s.lane] < 0.75f;
        } else {
          ++asked;
          found += !is_near;
        }
      }
    }
  BOOST_TEST(found > 0.3 * asked);
  BOOST_TEST(narrow > 0.1 * asked);
}

BOOST_AUTO_TEST_CASE(several_tests_at_once_find_what_each_finds_alone)
{
  Random random(3);
  std::vector<Scene> scenes;
  std::vector<Box_map> maps;
  for (std::size_t k = 0; k < most_sweep_tests; ++k) scenes.push_back(scene(random, int(k), k % 2 == 0 ? 0 : 4));
  for (const Scene& s : scenes) maps.push_back(s.placing.map());
  maps[2] = Box_map();  // nothing is known of it
  for (const auto find : find_versions()) {
    std::vector<Sweep_test> together;
    for (std::size_t k = 0; k < most_sweep_tests; ++k) together.push_back(test(scenes[k], maps[k], scenes[k].sweep));
    std::vector<Sweep_test> alone = together;
    find(together.data(), together.size());
    for (std::size_t k = 0; k < most_sweep_tests; ++k) {
      find(&alone[k], 1);
      BOOST_TEST(together[k].near == alone[k].near);
      for (std::size_t lane = 0; lane < lanes; ++lane)
        BOOST_TEST((together[k].times.from[lane] == alone[k].times.from[lane] &&
                    together[k].times.until[lane] == alone[k].times.until[lane]));
    }
  }
}

BOOST_AUTO_TEST_CASE(times_are_those_of_boxes_that_pass_by)
{
  // Unit boxes; the single one comes along an axis from 8 away, and goes as far: they meet from 3/8 to 5/8 of the time.
  Obb8 boxes{}, from{};
  for (int k = 0; k < int(lanes); ++k) set(boxes, k, Vector(0, k < 4 ? 0 : 3, 0), Matrix::identity(), Vector(1, 1, 1));
  set(from, 0, Vector(0, 0, 0), Matrix::identity(), Vector(1, 1, 1));
  boxes.reach = 6;
  boxes.lane_count = lanes;
  const Local_scale units;
  const Box_map map(Pose(), units, Pose(), units);
  Box_sweep sweep;
  sweep.half = {{8, 0, 0}, {}, {}};
  for (const auto find : find_versions()) {
    const auto found = [&](const Known_times& known) {
      Sweep_test test = {&boxes, &map, &from, 0, no_apex, &sweep, known, 0, {}};
      find(&test, 1);
      return test;
    };
    const Sweep_test all = found({});
    BOOST_TEST(all.near == 0x0fu);
    for (int k = 0; k < 4; ++k) {
      BOOST_TEST(std::abs(all.times.from[k] - 0.375f) < 1e-4f);
      BOOST_TEST(std::abs(all.times.until[k] - 0.625f) < 1e-4f);
    }
    const Sweep_test later = found({0.5f, 0.75f});
    BOOST_TEST(later.near == 0x0fu);
    BOOST_TEST(later.times.from[0] == 0.5f);
    BOOST_TEST(found({0.75f, 1.0f}).near == 0u);
  }
}

BOOST_AUTO_TEST_CASE(what_is_infinite_undefined_or_no_similarity_is_near_all_the_time)
{
  Random random(2);
  const Scene s = scene(random, 3, 400);
  auto sheared = s.placing.b.entries();
  sheared[1] += 0.5;
  Placing no_similarity = s.placing;
  no_similarity.b = Pose(sheared);
  const double bad[] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  for (const auto find : find_versions()) {
    const auto is_near = [&](const Box_map& map, const Box_sweep& sweep) {
      Sweep_test asked = test(s, map, sweep);
      find(&asked, 1);
      bool all = asked.near == 255u;
      for (int k = 0; k < int(lanes); ++k) all = all && asked.times.from[k] <= 0 && asked.times.until[k] >= 1;
      return all;
    };
    BOOST_TEST(!is_near(s.placing.map(), s.sweep));
    for (const Box_map& map : {no_similarity.map(), Box_map()}) BOOST_TEST(is_near(map, s.sweep));
    for (const double x : bad) {
      std::array<Box_sweep, 3> wrong = {s.sweep, s.sweep, s.sweep};
      wrong[0].rest = x;
      wrong[1].half = {{0, x, 0}, {}, {}};
      wrong[2].middle = {{0, 0, 0}, {{{x, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, {}};
      for (const Box_sweep& sweep : wrong) BOOST_TEST(is_near(s.placing.map(), sweep));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
