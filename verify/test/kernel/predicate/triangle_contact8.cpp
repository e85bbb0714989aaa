#include "tetracone/kernel/predicate/triangle_contact8.h"

#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/contact/rational_contact.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_triangle_contact8)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using Corners8 = std::array<std::array<std::array<Vertex, 3>, Triangles8::count>, 2>;  // of p, of q

inline auto versions() { return TETRACONE_VERSIONS_HERE(triangle_contacts8_simd); }

/// The pairs of each version, and that all versions say the same.
Triangle_contacts8 filtered(const Corners8& corners, const Pose& pose_p, const Pose& pose_q)
{
  Triangles8 p, q;
  for (std::size_t lane = 0; lane < Triangles8::count; ++lane) {
    p.set(lane, corners[0][lane][0], corners[0][lane][1], corners[0][lane][2]);
    q.set(lane, corners[1][lane][0], corners[1][lane][1], corners[1][lane][2]);
  }
  Triangle_contacts8 first;
  bool is_first = true;
  for (const auto filter : versions()) {
    Triangle_contacts8 found;
    filter(p, pose_p, q, pose_q, found);
    if (is_first) first = found;
    is_first = false;
    BOOST_TEST_REQUIRE(found.apart == first.apart);
    BOOST_TEST_REQUIRE(found.crossing == first.crossing);
    for (std::size_t lane = 0; lane < Triangles8::count; ++lane)
      if (found.crossing >> lane & 1) BOOST_TEST(found.ends[lane] == first.ends[lane]);
  }
  return first;
}

/// A triangle, and one that touches or crosses it in any way, exactly or nearly. That one has a corner in its plane,
/// inside it or beside it, or an edge through an edge or a corner. Or it is any triangle. Some pairs differ much in
/// size.
std::array<std::array<Vertex, 3>, 2> near_pair(Random& random)
{
  // Coordinates of 24 bits: what is meant is exact, and signs in double are rounded.
  const bool exactly = integer(random, 0, 1);
  const auto rounded = [&](double x, int bits) {
    return exactly ? std::ldexp(std::round(std::ldexp(x, bits)), -bits) : x;
  };
  std::array<std::array<Vertex, 3>, 2> pair;
  const double size = std::ldexp(1, integer(random, -12, 0));
  for (int k = 0; k < 3; ++k) {
    pair[0][k] = real_vertex(random, 1);
    pair[1][k] = real_vertex(random, size);
    for (auto& triangle : pair)
      for (double& x : triangle[k]) x = rounded(x, 24);
  }
  const auto point_of = [&](const std::array<Vertex, 3>& t, double s, double r) {
    Vertex x;
    for (int k = 0; k < 3; ++k) x[k] = t[0][k] + (s * (t[1][k] - t[0][k]) + r * (t[2][k] - t[0][k]));
    return x;
  };
  const int kind = integer(random, 0, 4);
  const auto share = [&](double low, double high) { return rounded(real(random, low, high), 3); };
  const double s = share(-0.2, 1), r = kind == 1 ? 0 : share(0, 1), t = kind == 0 ? 0 : share(0, 1),
               u = kind < 2 ? 0 : share(0, 0.5);
  const Vertex on_p = point_of(pair[0], s, r), on_q = kind == 4 ? on_p : point_of(pair[1], t, u);
  const int most = integer(random, 0, 2);  // units in the last place, off
  // Small about the origin: what poses round, of corners that are far from it, is then more than signs do.
  const int exponent = integer(random, -16, 0);
  for (Vertex& v : pair[1])
    for (int k = 0; k < 3; ++k) {
      v[k] += on_p[k] - on_q[k];
      v[k] += integer(random, -most, most) * std::ldexp(std::abs(v[k]), -53);
    }
  for (auto& triangle : pair)
    for (Vertex& v : triangle)
      for (double& x : v) x = std::ldexp(x, exponent);
  return pair;
}

Vertex rounded_image(const Pose& pose, const Vertex& x)
{
  Vertex image;
  for (int k = 0; k < 3; ++k)
    image[k] = pose[4 * k] * x[0] + pose[4 * k + 1] * x[1] + pose[4 * k + 2] * x[2] + pose[4 * k + 3];
  return image;
}

/// A pose, and nearly its inverse: the identity, a translation, a rotation in rationals, a similarity in doubles.
std::array<Pose, 2> pose_and_back(Random& random, int kind)
{
  if (kind == 0) return {Pose(), Pose()};
  const Vertex t = kind == 2 ? Vertex{0, 0, 0} : real_vertex(random, 4);
  if (kind == 1) return {Pose::translation(t[0], t[1], t[2]), Pose::translation(-t[0], -t[1], -t[2])};
  const Pose turn = random_rotation(random, 4);
  const double scale = kind == 2 ? 1 : std::ldexp(1, integer(random, -3, 3));
  std::array<double, 12> there{}, back{};
  for (int i = 0; i < 3; ++i) {
    there[4 * i + 3] = t[i];
    for (int j = 0; j < 3; ++j) {
      there[4 * i + j] = turn[4 * i + j] * scale;
      back[4 * j + i] = turn[4 * i + j] / scale;
      back[4 * j + 3] -= back[4 * j + i] * t[i];
    }
  }
  return {kind == 2 ? turn : Pose(there), Pose(back)};
}

Rational_face face_of(const std::array<rationals::Vector, 3>& t)
{
  return Rational_face({{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}});
}

// The faces are compared by constructions in rationals, which share nothing with signs.
BOOST_AUTO_TEST_CASE(what_is_decided_is_what_rationals_say)
{
  Random random(11);
  int apart = 0, crossing = 0, undecided = 0;
  for (int tried = 0; tried < 600; ++tried) {
    const int kind_p = tried % 4 == 0 ? integer(random, 1, 3) : 0, kind_q = integer(random, 0, 3);
    const auto [pose_p, back_p] = pose_and_back(random, kind_p);
    const auto [pose_q, back_q] = pose_and_back(random, kind_q);
    Corners8 corners;
    for (std::size_t lane = 0; lane < Triangles8::count; ++lane) {
      const auto pair = near_pair(random);
      for (int k = 0; k < 3; ++k) {
        corners[0][lane][k] = rounded_image(back_p, pair[0][k]);
        corners[1][lane][k] = rounded_image(back_q, pair[1][k]);
      }
    }
    const Triangle_contacts8 found = filtered(corners, pose_p, pose_q);
    BOOST_TEST((found.apart & found.crossing) == 0u);
    for (std::size_t lane = 0; lane < Triangles8::count; ++lane) {
      const bool is_apart = found.apart >> lane & 1, is_crossing = found.crossing >> lane & 1;
      apart += is_apart;
      crossing += is_crossing;
      undecided += !is_apart && !is_crossing;
      if (!is_apart && !is_crossing) continue;
      const auto p = rationals::images(pose_p, corners[0][lane]), q = rationals::images(pose_q, corners[1][lane]);
      const auto truth = face_contact(face_of(p), face_of(q));
      BOOST_TEST_REQUIRE(truth.empty() == is_apart, "pair " << tried << ", " << lane);
      if (is_apart) continue;
      const Triangle_contact contact = found.contact(lane);
      BOOST_TEST_REQUIRE(contact.count == 2);
      BOOST_TEST((truth.size() == 1 && truth[0].kind == Piece::segment));
      BOOST_TEST((truth[0].in_p == Feature::interior && truth[0].in_q == Feature::interior));
      std::vector<Rational_point> ends = {corner_point(p, q, contact.corners[0]),
                                          corner_point(p, q, contact.corners[1])};
      std::vector<Rational_point> true_ends = truth[0].loops[0];
      std::sort(ends.begin(), ends.end());
      std::sort(true_ends.begin(), true_ends.end());
      BOOST_TEST((ends == true_ends), "pair " << tried << ", " << lane);
    }
  }
  BOOST_TEST(apart > 500);
  BOOST_TEST(crossing > 500);
  BOOST_TEST(undecided > 500);
}

BOOST_AUTO_TEST_CASE(pairs_that_are_far_from_degenerate_are_all_decided)
{
  Random random(3);
  int crossing = 0;
  for (int tried = 0; tried < 500; ++tried) {
    const Pose pose_p = tried % 2 ? random_rotation(random, 5) : Pose(),
               pose_q = rounded(random_rotation(random, 5, {Rational(1) / 3, 0, 0}));
    Corners8 corners;
    for (auto& of_body : corners)
      for (auto& t : of_body)
        for (Vertex& v : t) v = real_vertex(random, 1);
    const Triangle_contacts8 found = filtered(corners, pose_p, pose_q);
    BOOST_TEST((found.apart | found.crossing) == 0xffu);
    for (std::size_t lane = 0; lane < Triangles8::count; ++lane) {
      const auto p = rationals::images(pose_p, corners[0][lane]), q = rationals::images(pose_q, corners[1][lane]);
      const bool meet = !face_contact(face_of(p), face_of(q)).empty();
      BOOST_TEST(meet == bool(found.crossing >> lane & 1));
      crossing += meet;
    }
  }
  BOOST_TEST(crossing > 400);
}

BOOST_AUTO_TEST_CASE(nothing_is_decided_of_what_is_degenerate_or_beyond_the_gate)
{
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const std::array<Vertex, 3> flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, line = {{{1, 1, -1}, {1, 1, 1}, {1, 1, 3}}};
  const auto moved_by = [&](double z) { return std::array<Vertex, 3>{{{1, 1, z}, {2, 1, z + 1}, {1, 2, z + 2}}}; };
  const auto decided = [&](const std::array<Vertex, 3>& p, const std::array<Vertex, 3>& q, const Pose& pose) {
    Corners8 corners;
    corners[0].fill(p);
    corners[1].fill(q);
    const Triangle_contacts8 found = filtered(corners, pose, Pose());
    return found.apart | found.crossing;
  };
  BOOST_TEST(decided(flat, moved_by(-1.5), Pose()) == 0xffu);
  BOOST_TEST(decided(flat, moved_by(1), Pose()) == 0xffu);
  BOOST_TEST(decided(flat, moved_by(0), Pose()) == 0u);  // a corner in the plane
  BOOST_TEST(decided(flat, moved_by(-1), Pose()) == 0u);
  BOOST_TEST(decided(flat, flat, Pose()) == 0u);
  BOOST_TEST(decided(flat, line, Pose()) == 0u);
  for (const double far : {0x1p120, -0x1p120, inf, nan})
    for (int corner = 0; corner < 3; ++corner)
      for (int k = 0; k < 3; ++k) {
        auto beyond = flat, other = moved_by(1);
        beyond[corner][k] = other[corner][k] = far;
        BOOST_TEST(decided(beyond, moved_by(1), Pose()) == 0u);
        BOOST_TEST(decided(flat, other, Pose()) == 0u);
        BOOST_TEST(decided(beyond, moved_by(1), Pose::translation(1, 0, 0)) == 0u);
      }
  BOOST_TEST(decided(flat, moved_by(1), Pose::translation(0x1p120, 0, 0)) == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
