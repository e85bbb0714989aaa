#include "verify/families/moving_body_families.h"

#include "verify/cases/object_placing.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::verify {
namespace moving_body_family {
namespace {

using covering::Polyhedron;
using kernel::Rational;
using Numbers = std::vector<Rational>;

int below(Random& random, int n) { return static_cast<int>(random.bits() % static_cast<std::uint64_t>(n)); }

/// A multiple of 1/16 of magnitude at most `reach`.
double sixteenth(Random& random, int reach = 1) { return (below(random, 32 * reach + 1) - 16 * reach) * 0.0625; }

Vector sixteenths(Random& random, int reach = 1)
{
  const double x = sixteenth(random, reach), y = sixteenth(random, reach), z = sixteenth(random, reach);
  return {x, y, z};
}

Polyhedron tetrahedron(Random& random)
{
  Polyhedron body;
  body.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (auto& v : body.vertices)
    for (double& x : v) x += sixteenth(random) * 0.25;
  for (const auto& [p, q, r] : {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {1u, 2u, 3u}, {0u, 3u, 2u}})
    body.add_polygon({p, q, r});
  return body;
}

Polyhedron small_body(Random& random) { return below(random, 3) == 0 ? unit_cube() : tetrahedron(random); }

/// Four walls about the square tunnel |x|, |y| < inner.
Polyhedron socket(double inner, double outer)
{
  Polyhedron all;
  for (const auto& [low, high] : {std::pair(kernel::Vertex{-outer, -outer, -1}, kernel::Vertex{-inner, outer, 1}),
                                  {{inner, -outer, -1}, {outer, outer, 1}},
                                  {{-inner, -outer, -1}, {inner, -inner, 1}},
                                  {{-inner, inner, -1}, {inner, outer, 1}}})
    append(all, box(low, high));
  return all;
}

Numbers shifted(const Vector& t) { return {1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2]}; }

/// A matrix that is nearly a rotation.
Numbers turned(const Rotation& r, const Vector& t)
{
  Numbers rows;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) rows.push_back(r[i][j]);
    rows.push_back(t[i]);
  }
  return rows;
}

Numbers rigid(double w, double x, double y, double z, const Vector& t) { return {w, x, y, z, t[0], t[1], t[2]}; }

/// The ends of a body that rests, by matrices or by quaternions.
const Motion_ends rests = {shifted({0, 0, 0}), shifted({0, 0, 0})};
const Motion_ends rests_rigid = {rigid(1, 0, 0, 0, {0, 0, 0}), rigid(1, 0, 0, 0, {0, 0, 0})};

/// Moves x to a neighbouring double, or leaves it.
double nudged(Random& random, double x)
{
  const int way = below(random, 3);
  return way == 0 ? x : std::nextafter(x, way == 1 ? HUGE_VAL : -HUGE_VAL);
}

/// To and from about `distance` apart, past each other or through.
Vector far(Random& random, double sign)
{
  Vector t = sixteenths(random);
  t[0] += 3 * sign;
  return t;
}

Moving_bodies anywhere(Random& random)
{
  const auto pose = [&](double sign) {
    const double w = random.unit() + 0.5, x = random.symmetric(), y = random.symmetric(), z = random.symmetric();
    return turned(rotation(w, x, y, z), far(random, sign));
  };
  return {
      small_body(random), small_body(random), {pose(0), pose(0)}, {pose(1), pose(below(random, 2) == 0 ? -1 : 0.5)}};
}

Moving_bodies one_turns(Random& random)
{
  return {small_body(random),
          small_body(random),
          rests_rigid,
          {rigid(1, 0, 0, 0, far(random, 1)),
           rigid(sixteenth(random), sixteenth(random), 1, sixteenth(random), far(random, -1))}};
}

Moving_bodies both_turn(Random& random)
{
  const auto pose = [&](double sign) {
    const double w = 1 + sixteenth(random) * 0.5, x = sixteenth(random), y = sixteenth(random), z = sixteenth(random);
    return rigid(w, x, y, z, far(random, sign));
  };
  return {tetrahedron(random), tetrahedron(random), {pose(0), pose(0)}, {pose(1), pose(-0.5)}};
}

/// Faces, edges or corners that slide on each other's planes, exactly or by an ulp off.
Moving_bodies grazing(Random& random)
{
  Vector from = {3, sixteenth(random), sixteenth(random)}, to = {-3, sixteenth(random), from[2]};
  for (std::size_t k = 1; k < 3; ++k)
    if (below(random, 2) == 0) from[k] = to[k] = nudged(random, below(random, 2) == 0 ? 1 : -1);
  return {unit_cube(), unit_cube(), rests, {shifted(from), shifted(to)}};
}

/// Two walls at once.
Moving_bodies double_contact(Random& random)
{
  const double way = 1 + below(random, 3) * 0.5;
  return {socket(1, 2),
          box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}),
          rests,
          {shifted({0, 0, 0}), shifted({way, nudged(random, way), sixteenth(random)})}};
}

/// A small fast body against a thin plate, or past its edge.
Moving_bodies tunnelling(Random& random)
{
  const double thickness = std::ldexp(1, -4 - below(random, 12)), speed = std::ldexp(1, 4 + below(random, 12));
  Moving_bodies c{box({-1, -1, 0}, {1, 1, thickness}), tetrahedron(random), {}, {}};
  Vector t = sixteenths(random, 2);
  t[2] = speed;
  Vector end = t;
  end[2] = -speed * 0.75;
  c.motion_a = rests;
  c.motion_b = {shifted(t), shifted(end)};
  return c;
}

/// A bar that turns in a square tunnel, and meets its walls or just does not.
Moving_bodies spin_in_socket(Random& random)
{
  const double half = 0.5 + below(random, 4) * 0.0625;
  return {socket(0.75 + below(random, 3) * 0.0625, 2),
          box({-half, -half, -3}, {half, half, 3}),
          rests_rigid,
          {rests_rigid[0], rigid(1, 0, 0, sixteenth(random), {0, 0, sixteenth(random)})}};
}

/// A cube that turns about an edge just above a plate, until it lies on its next face: or a little lower or higher.
Moving_bodies rolling(Random& random)
{
  const double gap = std::ldexp(1, -1 - below(random, 30));
  return {box({-4, -4, -1}, {4, 4, 0}),
          unit_cube(),
          rests_rigid,
          {rigid(1, 0, 0, 0, {0, 0, gap}),
           rigid(1, below(random, 2) == 0 ? -1 : -0.5, 0, 0, {0, 0, below(random, 2) == 0 ? gap : gap / 2})}};
}

/// On a plate, by an ulp above it or below, and away.
Moving_bodies resting(Random& random)
{
  const double height = below(random, 2) == 0 ? std::ldexp(1, -1074) : nudged(random, 0);
  return {box({-2, -2, -1}, {2, 2, 0}),
          unit_cube(),
          rests,
          {shifted({0, 0, height}), shifted({1, 0, height + below(random, 3) * 0.5})}};
}

/// One within the other: to the end, or through the wall.
Moving_bodies nested(Random& random)
{
  return {box({-2, -2, -2}, {2, 2, 2}),
          small_body(random),
          rests,
          {shifted({0, 0, 0}), shifted({below(random, 2) * 2.5, sixteenth(random), 0})}};
}

/// Contact at the end alone, or by an ulp not.
Moving_bodies at_end(Random& random)
{
  return {unit_cube(),
          unit_cube(),
          rests,
          {shifted({3, sixteenth(random), sixteenth(random)}),
           shifted({nudged(random, 1), sixteenth(random), sixteenth(random, 2)})}};
}

/// The families above with all lengths times a power of two, or with motions of a few ulps.
Moving_bodies tiny_and_huge(Random& random)
{
  constexpr std::array makes = {anywhere, grazing, tunnelling, nested};
  Moving_bodies c = makes[static_cast<std::size_t>(below(random, makes.size()))](random);
  const int exponent = (below(random, 2) == 0 ? 1 : -1) * (40 + below(random, 200));
  for (Polyhedron* body : {&c.a, &c.b})
    for (auto& v : body->vertices)
      for (double& x : v) x = std::ldexp(x, exponent);
  for (Motion_ends* motion : {&c.motion_a, &c.motion_b})
    for (Numbers& pose : *motion)
      for (std::size_t k = 3; k < 12; k += 4) pose[k] *= Rational(std::ldexp(1, exponent));
  if (below(random, 3) == 0)
    for (std::size_t k = 0; k < 12; ++k) c.motion_b[1][k] = std::nextafter(c.motion_b[0][k].get_d(), -HUGE_VAL);
  return c;
}

/// A(t) turns inside out: in between its image is flat.
Moving_bodies flattened(Random& random)
{
  Numbers mirrored = shifted({1, 0, 0});
  mirrored[0] = -1;
  return {unit_cube(),
          small_body(random),
          {shifted({0, 0, 0}), mirrored},
          {shifted(far(random, 1)), shifted(far(random, -0.25))}};
}

using object_family::power_of_two;

/// A third of an odd number, times a power of two.
Rational fraction(Random& random, int exponent)
{
  return Rational(power_of_two(exponent) * (2 * below(random, 9) + 1) / 3);
}

/// The families above, with each body's coordinates times a power of two that its poses undo by fractions. All of space
/// is shrunk, and quaternions are of fractions that round to denormals, or to 0.
Moving_bodies tiny_fractions(Random& random)
{
  constexpr std::array makes = {anywhere, grazing,   double_contact, tunnelling, nested,   at_end,
                                resting,  one_turns, both_turn,      rolling,    flattened};
  Moving_bodies c = makes[static_cast<std::size_t>(below(random, makes.size()))](random);
  const auto enlarge = [](Polyhedron& body, int exponent) {
    for (auto& v : body.vertices)
      for (double& x : v) x = std::ldexp(x, exponent);
  };
  if (c.is_rigid()) {
    const std::array exponents = {-1000, -60, 0, 60, 1000};
    const int exponent = exponents[static_cast<std::size_t>(below(random, 5))];
    enlarge(c.a, exponent);
    enlarge(c.b, exponent);
    for (Motion_ends* motion : {&c.motion_a, &c.motion_b}) {
      const Rational length = fraction(random, -below(random, 1100));
      for (Numbers& pose : *motion)
        for (std::size_t k = 0; k < 7; ++k) pose[k] *= k < 4 ? length : power_of_two(exponent);
    }
    return c;
  }
  const std::array smaller = {0, 25 + below(random, 100), 900 + below(random, 180)};
  const Rational of_space = fraction(random, -smaller[static_cast<std::size_t>(below(random, 3))]);
  for (const auto& [body, motion] : {std::pair(&c.a, &c.motion_a), std::pair(&c.b, &c.motion_b)}) {
    const std::array exponents = {0, 500, 1000 + below(random, 16)};
    const int exponent = exponents[static_cast<std::size_t>(below(random, 3))];
    enlarge(*body, exponent);
    for (Numbers& pose : *motion)
      for (std::size_t k = 0; k < 12; ++k) {
        pose[k] *= of_space;
        if (k % 4 != 3) pose[k] *= power_of_two(-exponent);
      }
  }
  return c;
}

/// A plate of many triangles that lands on a box or on its like, flat or tilted by little. It lands straight down,
/// aslant, in stretched coordinates, or while it turns about the normal.
Moving_bodies landings(Random& random)
{
  // Truths compare all features: few triangles on both sides.
  const bool on_like = below(random, 2) == 0;
  const int n = 1 + below(random, on_like ? 2 : 3);
  Moving_bodies c{on_like ? plate(n, -0.25, 0) : box({-2, -2, -1}, {2, 2, 0}), plate(n, 0, 0.25), {}, {}};
  const double tilt = below(random, 3) == 0 ? std::ldexp(1, -10 - below(random, 40)) : 0;
  const double x = sixteenth(random), y = sixteenth(random), up = 0.25 + below(random, 3) * 0.25,
               down = below(random, 4) == 0 ? 0 : -0.0625 - below(random, 12) * 0.0625;
  const int kind = below(random, 4);
  if (kind == 3) {
    c.motion_a = rests_rigid;
    c.motion_b = {rigid(1, tilt, 0, 0, {x, y, up}), rigid(1, tilt, 0, sixteenth(random), {x, y, down})};
    return c;
  }
  const double grown = kind == 2 ? 1 + below(random, 3) * 0.25 : 1, aside = kind == 1 ? sixteenth(random) : 0;
  c.motion_a = rests;
  c.motion_b = {shifted({x, y, up}), shifted({x + aside, y, down})};
  for (const int k : {0, 5, 10}) c.motion_a[1][std::size_t(k)] = c.motion_b[1][std::size_t(k)] = grown;
  c.motion_b[0][8] = c.motion_b[1][8] = tilt;
  return c;
}

std::vector<Moving_body_family> entries()
{
  return {
      {{"motion-anywhere", "linear between nearly rigid poses", "", {}}, anywhere},
      {{"motion-one-turns", "rigid, the other body rests", "", {}}, one_turns},
      {{"motion-both-turn", "rigid, both bodies turn", "", {}}, both_turn},
      {{"motion-grazing", "faces, edges and corners slide along, an ulp off now and then", "", {}}, grazing},
      {{"motion-double-contact", "two walls at once, or by an ulp one first", "", {}}, double_contact},
      {{"motion-tunnelling", "fast through a thin plate, or past it", "", {}}, tunnelling},
      {{"motion-spin-in-socket", "a bar turns in a square tunnel", "", {}}, spin_in_socket},
      {{"motion-rolling", "a cube turns about an edge above a plate", "", {}}, rolling},
      {{"motion-resting", "on a plate or by an ulp not, and away", "", {}}, resting},
      {{"motion-nested", "one within the other, to the end or through the wall", "", {}}, nested},
      {{"motion-at-end", "contact at the end alone, or by an ulp not", "", {}}, at_end},
      {{"motion-tiny-and-huge", "lengths times a power of two, motions of an ulp", "", {}}, tiny_and_huge},
      {{"motion-flattened", "a linear motion that turns a body inside out", "", {}}, flattened},
      {{"motion-tiny-fractions",
        "those before, huge bodies under fractions that are rounded to denormals, or to 0",
        "",
        {}},
       tiny_fractions},
      {{"motion-landings", "plates of many triangles land flat, or tilted by little", "", {}}, landings},
  };
}

}  // namespace
}  // namespace moving_body_family

const std::vector<Moving_body_family>& moving_body_families()
{
  static const std::vector<Moving_body_family> all = numbered(moving_body_family::entries());
  return all;
}

Moving_bodies moving_bodies_case(const Moving_body_family& family, std::uint64_t seed, std::uint64_t index)
{
  Random random = random_of_case(seed, family.name, index);
  Moving_bodies made = family.make(random);
  made.origin = family.origin(seed, index);
  return made;
}

}  // namespace tetracone::verify
