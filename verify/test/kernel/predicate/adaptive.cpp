#include "tetracone/kernel/predicate/adaptive.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

// The constants of the bounds are proved in verify/proofs/adaptive_proofs.h, from the functions that the stages call.

BOOST_AUTO_TEST_SUITE(test_adaptive)

using namespace tetracone::kernel;
namespace bound = tetracone::kernel::adaptive_bound;
using namespace tetracone::verify::scenes;
using CGAL::Sign;
using rationals::Vector;
using Point = Adaptive::Point_3;
using Decision = Adaptive::Decision;
using Stage = Adaptive::Stage;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Sample {
  std::array<Point, 4> points;
  std::array<Vector, 4> exact;

  void set(std::size_t k, const Vertex& v, const Pose* pose = nullptr)
  {
    points[k] = pose ? Adaptive::placed(v, *pose) : Adaptive::unmoved(v);
    exact[k] = pose ? rationals::image(*pose, rationals::exactly(v)) : rationals::exactly(v);
  }
  void set(const std::array<Vertex, 4>& v, const Pose* pose = nullptr)
  {
    for (std::size_t k = 0; k < 4; ++k) set(k, v[k], pose);
  }

  Vector from_first(std::size_t k) const { return rationals::minus(exact[k], exact[0]); }
  Sign volume() const { return CGAL::sign(rationals::six_volume(exact[0], exact[1], exact[2], exact[3])); }
  Sign normal(int axis) const { return CGAL::sign(rationals::outer(from_first(1), from_first(2))[std::size_t(axis)]); }
  Sign difference(int axis) const { return CGAL::sign(Rational(-from_first(1)[std::size_t(axis)])); }

  /// True when two of the first points are one vertex of one frame: then no exact stage is needed.
  bool has_one_twice(std::size_t of) const
  {
    for (std::size_t i = 0; i < of; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (Adaptive::identical(points[i], points[j])) return true;
    return false;
  }
};

/// A point of the plane of three, as double has it.
Vertex near_plane(Random& random, const Vertex& a, const Vertex& b, const Vertex& c)
{
  const double s = real(random, -1, 1), t = real(random, -1, 1);
  Vertex d;
  for (int i = 0; i < 3; ++i) d[i] = a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]);
  return d;
}

/// Four points of one plane: integers of `bits` bits.
std::array<Vertex, 4> coplanar(Random& random, int bits)
{
  const int r = 1 << (bits - 3), s = integer(random, -1, 2), t = integer(random, -1, 2);
  std::array<Vertex, 4> v = {grid_vertex(random, r), grid_vertex(random, r), grid_vertex(random, r), {}};
  for (int i = 0; i < 3; ++i) v[3][i] = v[0][i] + s * (v[1][i] - v[0][i]) + t * (v[2][i] - v[0][i]);
  return v;
}

/// Four doubles of the plane x + y + z = 0 with all their bits, in units of 2^-52.
std::array<Vertex, 4> full_coplanar(Random& random)
{
  std::array<Vertex, 4> v;
  for (Vertex& p : v) {
    for (int i : {0, 1}) p[i] = std::ldexp(std::round(std::ldexp(real(random, -1, 1), 52)), -52);
    p[2] = -(p[0] + p[1]);
  }
  return v;
}

std::array<Vertex, 4> any_four(Random& random)
{
  return {real_vertex(random, 1), real_vertex(random, 1), real_vertex(random, 1), real_vertex(random, 1)};
}

Pose moved_rotation(Random& random, double distance)
{
  auto entries = random_rotation(random, 9).entries();
  for (const int k : {3, 7, 11}) entries[k] = real(random, -distance, distance);
  return Pose(entries);
}
Pose rotation(Random& random) { return moved_rotation(random, 1); }
Pose far_rotation(Random& random) { return moved_rotation(random, 0x1p40); }
/// Numbers of exponents far apart, of both signs, and 0.
std::array<Vertex, 4> far_exponents(Random& random)
{
  std::array<Vertex, 4> v = coplanar(random, 6);
  for (Vertex& p : v)
    for (double& x : p)
      if (integer(random, 0, 1) == 1) x = std::ldexp(x, integer(random, -400, 200));
  return v;
}

Pose fractions(Random& random)
{
  return random_rotation(random, 9, {Rational(integer(random, -9, 9)) / 7, 1, Rational(0.1)});
}

/// Positions, each decided by other stages.
struct Position {
  std::string_view name;
  double least, most;  ///< of the volumes that the filter decides
  std::function<void(Random&, Sample&, const Pose&, const Pose&)> fill;
  Pose (*pose)(Random&) = rotation;
};

const std::vector<Position>& positions()
{
  using P = const Pose&;
  static const std::vector<Position> all = {
      {"random", 0.999, 1, [](Random& r, Sample& s, P, P) { s.set(any_four(r)); }},
      {"rounded onto the plane", 0, 0.01,
       [](Random& r, Sample& s, P, P) {
         auto v = any_four(r);
         v[3] = near_plane(r, v[0], v[1], v[2]);
         s.set(v);
       }},
      {"exactly coplanar integers of 20 bits", 0, 0, [](Random& r, Sample& s, P, P) { s.set(coplanar(r, 20)); }},
      {"exactly coplanar, all bits", 0, 0, [](Random& r, Sample& s, P, P) { s.set(full_coplanar(r)); }},
      {"in a plane of two axes", 0, 1,
       [](Random& r, Sample& s, P, P) {
         auto v = any_four(r);
         for (Vertex& p : v) p[0] = v[0][0];
         s.set(v);
       }},
      {"largest doubles", 0, 0,
       [](Random& r, Sample& s, P, P) {
         for (std::size_t k = 0; k < 4; ++k) {
           Vertex v = grid_vertex(r, 4);
           for (double& x : v) x *= DBL_MAX / 4;
           s.set(k, v);
         }
       }},
      {"some of the four placed, in either frame", 0.99, 1,
       [](Random& r, Sample& s, P a, P b) {
         const std::array<const Pose*, 3> frame = {nullptr, &a, &b};
         for (std::size_t k = 0; k < 4; ++k) s.set(k, real_vertex(r, 1), frame[integer(r, 0, 2)]);
       }},
      {"placed, and unmoved on their plane", 0, 0.01,
       [](Random& r, Sample& s, P a, P) {
         s.set(any_four(r), &a);
         s.set(3, near_plane(r, s.points[0].image, s.points[1].image, s.points[2].image));
       }},
      {"exactly coplanar in one frame", 0, 0, [](Random& r, Sample& s, P a, P) { s.set(full_coplanar(r), &a); }},
      {"placed back from far away, on a plane", 0, 0,
       [](Random& r, Sample& s, P a, P) {
         auto v = coplanar(r, 6);
         for (Vertex& p : v)  // from -M^T t on
           for (int i = 0; i < 3; ++i) p[i] -= std::round(a[i] * a[3] + a[4 + i] * a[7] + a[8 + i] * a[11]);
         s.set(v, &a);
       },
       far_rotation},
      {"under fractions, exactly coplanar", 0, 0, [](Random& r, Sample& s, P a, P) { s.set(coplanar(r, 8), &a); },
       fractions},
      {"exponents far apart", 0, 1, [](Random& r, Sample& s, P, P) { s.set(far_exponents(r)); }},
      {"exponents far apart, under fractions and unmoved", 0, 1,
       [](Random& r, Sample& s, P a, P) {
         const auto v = far_exponents(r);
         for (std::size_t k = 0; k < 4; ++k) s.set(k, v[k], k % 2 == 0 ? &a : nullptr);
       },
       fractions},
  };
  return all;
}

/// What each stage says of one sign.
struct Stages {
  bool in_gate;
  Decision filtered, zero, grid, double_double, fixed;
  Sign exact;

  int wrong(Sign truth) const
  {
    int count = exact != truth;
    for (const Decision& decision : {filtered, grid, double_double, fixed}) count += decision && *decision != truth;
    return count;
  }
  /// The counts of the sign, by the first stage that answers.
  Stage_counts counts() const
  {
    Stage_counts counts;
    ++counts[filtered        ? Stage::filter
             : zero          ? Stage::zero
             : !in_gate      ? (fixed ? Stage::fixed : Stage::out_of_gate)
             : grid          ? Stage::grid
             : fixed         ? Stage::fixed
             : double_double ? Stage::double_double
                             : Stage::exact];
    return counts;
  }
};

Stages volume_stages(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return {Adaptive::in_gate(a, b, c, d),
          Adaptive::filtered_volume_sign(a, b, c, d),
          Adaptive::zero_volume_sign(a, b, c, d),
          Adaptive::int128_volume_sign(a, b, c, d),
          Adaptive::double_double_volume_sign(a, b, c, d),
          Adaptive::fixed_volume_sign(a, b, c, d),
          Adaptive::exact_volume_sign(a, b, c, d)};
}
Stages normal_stages(const Point& a, const Point& b, const Point& c, int axis)
{
  return {Adaptive::in_gate(a, b, c),
          Adaptive::filtered_normal_sign(a, b, c, axis),
          Adaptive::zero_normal_sign(a, b, c, axis),
          Adaptive::int128_normal_sign(a, b, c, axis),
          Adaptive::double_double_normal_sign(a, b, c, axis),
          Adaptive::fixed_normal_sign(a, b, c, axis),
          Adaptive::exact_normal_sign(a, b, c, axis)};
}
Stages difference_stages(const Point& a, const Point& b, int axis)
{
  return {Adaptive::in_gate(a, b),
          Adaptive::filtered_difference_sign(a, b, axis),
          Adaptive::identical(a, b) ? Decision(CGAL::ZERO) : Decision(),
          {},
          Adaptive::double_double_difference_sign(a, b, axis),
          Adaptive::fixed_difference_sign(a, b, axis),
          Adaptive::exact_difference_sign(a, b, axis)};
}

/// What the fixed stage says of a sample.
struct Fixed_signs {
  Decision volume, normal, difference;
  int wrong;

  Fixed_signs(const Sample& s, int axis)
      : volume(Adaptive::fixed_volume_sign(s.points[0], s.points[1], s.points[2], s.points[3])),
        normal(Adaptive::fixed_normal_sign(s.points[0], s.points[1], s.points[2], axis)),
        difference(Adaptive::fixed_difference_sign(s.points[0], s.points[1], axis)),
        wrong((volume && *volume != s.volume()) + (normal && *normal != s.normal(axis)) +
              (difference && *difference != s.difference(axis)))
  {}
};

BOOST_AUTO_TEST_CASE(every_stage_that_answers_is_right_and_the_counter_says_which_did)
{
  int wrong_decision = 0, wrong_zero = 0, wrong_sign = 0, wrong_stage = 0;
  int by_identity = 0, by_zero_factors = 0, by_grid = 0, by_double_double = 0;
  Stage_counts seen;
  const auto check = [&](const Stages& stages, const Stages& counted, bool has_one_twice, Sign truth, const auto& ask) {
    wrong_decision += stages.wrong(truth);
    wrong_zero += stages.zero ? truth != CGAL::ZERO : has_one_twice;
    const Stage_counts before = Adaptive::decided_by();
    wrong_sign += ask() != truth;
    seen = Adaptive::decided_by() - before;
    wrong_stage += seen != counted.counts();
  };
  const auto home = [](const Point& p) { return Adaptive::unmoved(p.vertex); };
  std::array<std::uint64_t, 3> by_last_stages{};
  Random random(1);
  for (const Position& position : positions()) {
    constexpr int count = 6000;
    int decided = 0;
    Pose pose_a, pose_b;
    for (int n = 0; n < count; ++n) {
      if (n % 50 == 0) {
        pose_a = position.pose(random);
        pose_b = position.pose(random);
      }
      Sample s;
      position.fill(random, s, pose_a, pose_b);
      const auto& [a, b, c, d] = s.points;
      const int axis = n % 3;
      const Stages normal = normal_stages(a, b, c, axis), difference = difference_stages(a, b, axis);
      check(normal, normal, s.has_one_twice(3), s.normal(axis), [&] { return Adaptive::normal_sign(a, b, c, axis); });
      check(difference, difference, s.has_one_twice(2), s.difference(axis),
            [&] { return Adaptive::difference_sign(a, b, axis); });
      const Stages volume = volume_stages(a, b, c, d);
      const bool is_one_frame = a.pose && a.pose == b.pose && a.pose == c.pose && a.pose == d.pose,
                 is_turned_back = is_one_frame && !volume.filtered && !volume.zero;
      check(volume, is_turned_back ? volume_stages(home(a), home(b), home(c), home(d)) : volume, s.has_one_twice(4),
            s.volume(), [&] { return Adaptive::volume_sign(a, b, c, d); });
      decided += volume.filtered.has_value();
      by_last_stages[0] += seen[Stage::out_of_gate];
      by_last_stages[1] += seen[Stage::fixed];
      by_last_stages[2] += seen[Stage::exact];
      if (volume.filtered) continue;
      by_grid += volume.grid.has_value();
      by_double_double += !volume.fixed && volume.double_double;
      by_identity += s.has_one_twice(4);
      by_zero_factors += volume.zero && !s.has_one_twice(4);
    }
    BOOST_TEST_INFO_SCOPE(position.name);
    BOOST_TEST(position.least <= double(decided) / count);
    BOOST_TEST(double(decided) / count <= position.most);
  }
  for (const int wrong : {wrong_decision, wrong_zero, wrong_sign, wrong_stage}) BOOST_TEST(wrong == 0);
  for (const int some : {by_identity, by_zero_factors, by_grid, by_double_double}) BOOST_TEST(some > 100);
  for (const std::uint64_t some : by_last_stages) BOOST_TEST(some > 100u);
}

BOOST_AUTO_TEST_CASE(one_frame_is_decided_by_its_vertices_and_its_determinant)
{
  // So far away that no image tells a side; the vertices do.
  const std::array<Vertex, 4> v = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto sign_under = [&](double x, double y, double z) {
    const Pose pose(std::array<double, 12>{x, 0, 0, 0x1p100, 0, y, 0, 0x1p100, 0, 0, z, 0x1p100});
    std::array<Point, 4> p;
    for (int k = 0; k < 4; ++k) p[k] = Adaptive::placed(v[k], pose);
    BOOST_TEST(!Adaptive::filtered_volume_sign(p[0], p[1], p[2], p[3]));
    const auto before = Adaptive::exact_fallbacks();
    const Sign sign = Adaptive::volume_sign(p[0], p[1], p[2], p[3]);
    BOOST_TEST(Adaptive::exact_fallbacks() == before);
    BOOST_TEST(Adaptive::exact_volume_sign(p[0], p[1], p[2], p[3]) == sign);
    return sign;
  };
  BOOST_TEST(sign_under(1, 1, 0.5) == CGAL::POSITIVE);
  BOOST_TEST(sign_under(1, -1, 1) == CGAL::NEGATIVE);  // a reflection
  BOOST_TEST(sign_under(-1, -1, -3) == CGAL::NEGATIVE);
  BOOST_TEST(sign_under(1, 0, 1) == CGAL::ZERO);  // no pose, but no wrong answer either
}

BOOST_AUTO_TEST_CASE(fixed_signs_of_poses_of_several_weights_are_those_of_rationals)
{
  int undecided = 0, wrong = 0, zeros = 0;
  Random random(4);
  for (int n = 0; n < 20000; ++n) {
    // B is A after a shift: by integers coplanar points stay so, by thirds they do not.
    const Pose a = n % 3 == 0 ? rotation(random) : fractions(random);
    std::array<Rational, 3> shift;
    std::array<int, 3> whole;
    const Rational part = Rational(3) * 0x1p40;
    for (std::size_t k = 0; k < 3; ++k) {
      whole[k] = integer(random, -9, 9);
      shift[k] = whole[k] + (n % 2 == 0 ? Rational(0) : Rational(integer(random, -1, 1)) / part);
    }
    std::array<Rational, 12> entries;
    for (int k = 0; k < 12; ++k) entries[k] = a.exact(k);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) entries[4 * i + 3] += a.exact(4 * i + k) * shift[k];
    const Pose b(entries), c = n % 5 == 0 ? fractions(random) : a;
    Sample s;
    s.set(coplanar(random, 8), &a);
    for (const std::size_t k : {1, 3}) {
      Vertex v = s.points[k].vertex;
      for (int i = 0; i < 3; ++i) v[i] -= whole[i];
      s.set(k, v, &b);
    }
    if (n % 5 == 0) s.set(2, s.points[2].vertex, &c);
    // A slot keeps an image that the next sign uses again.
    std::array<std::unique_ptr<Kept_images>, 4> kept;
    for (std::size_t k = 0; k < 4; ++k) s.points[k].slot = n % 7 == 0 ? nullptr : &kept[k];
    for (int time = 0; time < 2; ++time) {
      const Fixed_signs signs(s, n % 3);
      const int most = Adaptive::longest_direction;
      const std::array<int, 3> d = {integer(random, -most, most), most, integer(random, -most, most)};
      const auto way = s.from_first(1);
      const Rational along = d[0] * way[0] + d[1] * way[1] + d[2] * way[2];
      wrong += signs.wrong + (Adaptive::fixed_sign_along(s.points[0], s.points[1], d) != CGAL::sign(along));
      undecided += !signs.volume + !signs.normal + !signs.difference;
      zeros += signs.volume == Decision(CGAL::ZERO);
    }
  }
  BOOST_TEST(undecided == 0);
  BOOST_TEST(wrong == 0);
  BOOST_TEST(zeros > 10000);
}

BOOST_AUTO_TEST_CASE(weights_of_more_than_a_limb_are_not_taken_for_equal)
{
  // Translations by fractions of long denominators: the images have few bits, the weights do not fit.
  int wrong = 0, decided = 0, undecided = 0;
  Random random(6);
  for (int n = 0; n < 4000; ++n) {
    const auto fraction = [&] {
      mpz_class denominator = mpz_class(1) << mp_bitcnt_t(integer(random, 40, 90));
      denominator = denominator + 2 * integer(random, 0, 1000) + 1;
      if (n % 3 == 0) denominator = denominator << mp_bitcnt_t(integer(random, 0, 20));
      return Rational(mpz_class(integer(random, -1, 1)), denominator);
    };
    const auto pose = [&] { return Pose(std::array<Rational, 12>{1, 0, 0, fraction(), 0, 1, 0, 0, 0, 0, 1, 0}); };
    const Pose a = pose(), b = pose();
    Sample s;
    for (std::size_t k = 0; k < 4; ++k)
      s.set(k, {0, double(integer(random, -2, 2)), double(integer(random, -2, 2))}, k == 1 ? &b : &a);
    const Fixed_signs signs(s, 0);
    const auto& [p, q, r, t] = s.points;
    wrong += signs.wrong + (Adaptive::volume_sign(p, q, r, t) != s.volume());
    ++(signs.volume ? decided : undecided);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(decided > 500);
  BOOST_TEST(undecided > 500);
}

BOOST_AUTO_TEST_CASE(fixed_signs_are_right_up_to_their_most_bits_and_undecided_beyond)
{
  // Entries and vertices of up to 125 bits: every carry counts.
  int wrong = 0, decided = 0, undecided = 0;
  Random random(5);
  for (int n = 0; n < 20000; ++n) {
    // About the ends of one limb and of two, and with a map's entries of three and of four.
    const bool is_moved = n % 3 == 2;
    const int bits = is_moved     ? integer(random, 20, 140)
                     : n % 3 == 1 ? integer(random, 55, 68)
                                  : integer(random, 116, 127);
    const int more = integer(random, 0, 61);
    const auto large = [&](int exponent) {
      return std::ldexp(integer(random, 0, 1) == 1 ? 1 - 0x1p-53 : -1 + 0x1p-53, exponent);
    };
    std::array<double, 12> entries;
    for (double& x : entries) x = integer(random, -1, 1);
    for (const int k : {0, 5, 10}) entries[k] = large(60 + more);
    const Pose pose(entries);
    Sample s;
    for (std::size_t k = 0; k < 4; ++k) {
      Vertex v;
      for (double& x : v) x = integer(random, 0, 4) == 0 ? integer(random, -2, 2) : large(bits);
      s.set(k, v, is_moved ? &pose : nullptr);
    }
    const Fixed_signs signs(s, n % 3);
    ++(signs.volume ? decided : undecided);
    wrong += signs.wrong;
    wrong += bits <= 125 && (!is_moved || bits + more + 66 <= Adaptive::most_bits) && !signs.volume;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(decided > 10000);
  BOOST_TEST(undecided > 300);
  const Point infinite = Adaptive::unmoved({infinity, 0, 0}), nan = Adaptive::unmoved({0, std::nan(""), 0}),
              o = Adaptive::unmoved({0, 0, 0});
  for (const Point& p : {infinite, nan}) {
    BOOST_TEST(!Adaptive::fixed_volume_sign(p, o, o, o));
    BOOST_TEST(!Adaptive::fixed_normal_sign(o, p, o, 0));
    BOOST_TEST(!Adaptive::fixed_difference_sign(o, p, 0));
    BOOST_TEST(!Adaptive::fixed_sign_along(o, p, {1, 2, 3}));
  }
}

BOOST_AUTO_TEST_CASE(one_vertex_under_one_pose_is_identical_and_needs_no_exact_stage)
{
  const Pose pose = Pose::from_quaternion(1, 2, 3, 4, {Rational(1) / 3, 0, 0}), equal = pose;
  const Vertex v = {0.1, 0.2, 0.3};
  const Point p = Adaptive::placed(v, pose), q = Adaptive::placed(v, pose), other = Adaptive::placed(v, equal),
              r = Adaptive::placed({0.1, 0.2, 0.4}, pose), s = Adaptive::unmoved({1, 2, 3});
  BOOST_TEST(Adaptive::identical(p, q));
  BOOST_TEST(!Adaptive::identical(p, other));  // their images are one point, but that is for the exact stage to say
  BOOST_TEST(!Adaptive::identical(p, r));
  BOOST_TEST(!Adaptive::identical(p, Adaptive::unmoved(v)));
  const auto before = Adaptive::exact_fallbacks();
  for (const auto& [a, b, c, d] :
       {std::array{p, q, r, s}, {p, r, q, s}, {p, r, s, q}, {r, p, q, s}, {r, p, s, q}, {r, s, p, q}})
    BOOST_TEST(Adaptive::volume_sign(a, b, c, d) == CGAL::ZERO);
  for (int axis = 0; axis < 3; ++axis) {
    BOOST_TEST(Adaptive::normal_sign(p, q, s, axis) == CGAL::ZERO);
    BOOST_TEST(Adaptive::normal_sign(p, s, q, axis) == CGAL::ZERO);
    BOOST_TEST(Adaptive::normal_sign(s, p, q, axis) == CGAL::ZERO);
    BOOST_TEST(Adaptive::difference_sign(p, q, axis) == CGAL::ZERO);
  }
  BOOST_TEST(Adaptive::exact_fallbacks() == before);
  BOOST_TEST(Adaptive::volume_sign(p, other, r, s) == CGAL::ZERO);
  BOOST_TEST(Adaptive::exact_fallbacks() == before + 1);
}

BOOST_AUTO_TEST_CASE(a_volume_of_which_every_product_has_a_factor_0_needs_no_arithmetic)
{
  const auto zero = [](const Vertex& b, const Vertex& c, const Vertex& d) {
    const Vertex o = {0.25, 0.5, 4};
    const auto from_o = [&o](const Vertex& v) { return Adaptive::unmoved({o[0] + v[0], o[1] + v[1], o[2] + v[2]}); };
    return Adaptive::zero_volume_sign(Adaptive::unmoved(o), from_o(b), from_o(c), from_o(d)).has_value();
  };
  BOOST_TEST(zero({1, 2, 0}, {3, 1, 0}, {2, 5, 0}));   // a plane across an axis
  BOOST_TEST(zero({1, 0, 0}, {3, 0, 0}, {2, 5, 7}));   // a line along an axis
  BOOST_TEST(zero({0, 0, 0}, {3, 1, 2}, {2, 5, 7}));   // two points in one
  BOOST_TEST(!zero({1, 2, 3}, {2, 4, 6}, {2, 5, 7}));  // a line, which products must tell
  // Each of the six products alone.
  for (const auto& [i, j, k] : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}) {
    Vertex b{}, c{}, d{};
    b[i] = c[j] = d[k] = 1;
    BOOST_TEST(!zero(b, c, d));
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const bool turned : {false, true}) {
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      Vertex b{}, c{};
      b[turned ? j : i] = c[turned ? i : j] = 2;
      const Point o = Adaptive::unmoved({0, 0, 0});
      BOOST_TEST(!Adaptive::zero_normal_sign(o, Adaptive::unmoved(b), Adaptive::unmoved(c), axis));
      BOOST_TEST(Adaptive::zero_normal_sign(o, Adaptive::unmoved(b), Adaptive::unmoved(c), i).has_value());
    }
  // Images that are not exact say nothing.
  const Pose moved = Pose::translation(0.1, 0.1, 0.1);
  BOOST_TEST(!Adaptive::zero_volume_sign(Adaptive::placed({0, 0, 0}, moved), Adaptive::placed({1, 0, 0}, moved),
                                         Adaptive::placed({0, 1, 0}, moved), Adaptive::placed({1, 2, 0}, moved)));
}

BOOST_AUTO_TEST_CASE(a_translation_keeps_images_exact_where_sums_are)
{
  const Pose exact = Pose::translation(1, -0.5, 0x1p20), rounding = Pose::translation(0x1p-60, 0, 0),
             none = Pose::translation(0, 0, 0);
  const Vertex v = {0.25, 3, -7};
  BOOST_TEST(Adaptive::placed(v, exact).error == 0);
  BOOST_TEST((Adaptive::placed(v, exact).image == Vertex{1.25, 2.5, 0x1p20 - 7}));
  BOOST_TEST(Adaptive::placed(v, none).error == 0);
  BOOST_TEST(Adaptive::placed(v, rounding).error > 0);
  // Beyond the gate nothing is told of an error.
  BOOST_TEST(Adaptive::unmoved({0x1p110, 0, -0x1p110}).error == 0);
  BOOST_TEST(Adaptive::unmoved({std::nextafter(0x1p110, infinity), 0, 0}).error == infinity);
  BOOST_TEST(Adaptive::placed({0x1p120, 0, 0}, exact).error == HUGE_VAL);
  BOOST_TEST(Adaptive::placed({0x1p1023, 0, 0}, Pose::translation(0x1p1023, 0, 0)).error == HUGE_VAL);

  // Random sums, most of which round: never farther off than the error says, and exact where it is 0.
  std::mt19937_64 random(8);
  int exact_ones = 0, rounded_ones = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto number = [&] { return std::ldexp(double(int(random() % 2048) - 1024), int(random() % 60) - 30); };
    const Vertex w = {number(), number(), number()};
    const Pose pose = Pose::translation(number(), number(), number());
    const Point p = Adaptive::placed(w, pose);
    (p.error == 0 ? exact_ones : rounded_ones) += 1;
    for (int i = 0; i < 3; ++i) {
      const Rational off = Rational(p.image[i]) - (Rational(w[i]) + Rational(pose[4 * i + 3]));
      BOOST_TEST((abs(off) <= Rational(p.error)));
    }
  }
  BOOST_TEST(exact_ones > 100);
  BOOST_TEST(rounded_ones > 100);

  // A face moved onto the plane of another: no exact stage.
  const Pose up = Pose::translation(0.5, 0.25, 1);
  const auto before = Adaptive::exact_fallbacks();
  const auto zeros = Adaptive::decided_by()[Stage::zero];
  const auto at_1 = [](double x, double y) { return Adaptive::unmoved({x, y, 1}); };
  BOOST_TEST(Adaptive::volume_sign(at_1(0, 0), at_1(1, 0), at_1(0, 1), Adaptive::placed({3, 5, 0}, up)) == CGAL::ZERO);
  BOOST_TEST(Adaptive::exact_fallbacks() == before);
  BOOST_TEST(Adaptive::decided_by()[Stage::zero] == zeros + 1);
}

BOOST_AUTO_TEST_CASE(a_fraction_too_small_for_a_double_still_moves_a_large_vertex)
{
  // 2^-1076 rounds to no double but 0, and 2^1023 of it is 2^-53.
  std::array<Rational, 12> entries{};
  entries[0] = Rational(0x1p-1074) / 4;
  entries[5] = entries[10] = 1;
  const Pose pose(entries);
  const Point p = Adaptive::placed({0x1p1023, 0, 0}, pose), q = Adaptive::unmoved({0x1p-54, 0, 0});
  BOOST_TEST(!Adaptive::filtered_difference_sign(p, q, 0));
  BOOST_TEST(Adaptive::difference_sign(p, q, 0) == CGAL::POSITIVE);
}

BOOST_AUTO_TEST_CASE(the_stages_turn_exactly_at_the_bounds_that_are_proved)
{
  const Vertex o = {0, 0, 0};
  const auto check = [](double turn, const auto& sign_of) {
    const double beyond = std::nextafter(turn, infinity);
    BOOST_TEST(!sign_of(turn));
    BOOST_TEST(!sign_of(-turn));
    BOOST_TEST((sign_of(beyond) == CGAL::POSITIVE));
    BOOST_TEST((sign_of(-beyond) == CGAL::NEGATIVE));
  };
  for (const double error : {0.0, 0x1p-100, 0x1p-60, 0x1p-20}) {
    const auto at = [error](const Vertex& v) {
      Point p = Adaptive::unmoved(v);
      p.error = error;
      return p;
    };
    // Rows (1, 0, 1), (0, 1, 0), (0, 0, h): volume h, and every axis has magnitude 1. Rows (1, 1), (0, h): area h.
    check(bound::volume_bound(1.0, 1.0, 1.0, 2 * error), [&](double h) {
      return Adaptive::filtered_volume_sign(at(o), at({1, 0, 1}), at({0, 1, 0}), at({0, 0, h}));
    });
    for (int axis = 0; axis < 3; ++axis)
      check(bound::normal_bound(1.0, 1.0, 2 * error), [&](double h) {
        Vertex b{}, c{};
        b[(axis + 1) % 3] = b[(axis + 2) % 3] = 1;
        c[(axis + 2) % 3] = h;
        return Adaptive::filtered_normal_sign(at(o), at(b), at(c), axis);
      });
    if (error > 0)
      check(bound::difference_bound(2 * error), [&](double h) {
        return Adaptive::filtered_difference_sign(at({h, h, h}), at(o), 1);
      });
    if (error > 0x1p-60) continue;
    const double one = bound::double_double_difference_error(2 * error, 1.0);
    check(bound::double_double_volume_bound<double>({1, 1, 1}, {one, one, one}), [&](double h) {
      return Adaptive::double_double_volume_sign(at(o), at({1, 0, 1}), at({0, 1, 0}), at({0, 0, h}));
    });
    check(bound::double_double_normal_bound(1.0, 1.0, one, one), [&](double h) {
      return Adaptive::double_double_normal_sign(at(o), at({1, 1, 0}), at({0, h, 0}), 2);
    });
  }
  const Pose pose(std::array<double, 12>{2, 3, 5, 7, 0, 1, 0, 0, 0, 0, 1, 0});
  const Point placed = Adaptive::placed({1, -1, 1}, pose);
  BOOST_TEST(placed.error == bound::image_bound(17.0));
  BOOST_TEST(Adaptive::double_double_image(placed).error == bound::double_double_image_bound(17.0));
}

BOOST_AUTO_TEST_SUITE_END()
