#include "verify/families/motion_families.h"

#include "verify/cases/random.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::verify {
namespace {

using kernel::Moving_kind;
using kernel::Moving_pair;
using kernel::Moving_point;
using kernel::Vertex;

int below(Random& random, int n) { return static_cast<int>(random.bits() % static_cast<std::uint64_t>(n)); }

/// An integer from -n to n.
double integer(Random& random, int n) { return below(random, 2 * n + 1) - n; }

/// A multiple of 2^-20 of magnitude at most 1: sums and products of a few are exact.
double dyadic(Random& random) { return integer(random, 1 << 20) * 0x1p-20; }

template <class Number>
Vertex vertex_of(const Number& number)
{
  Vertex v{};
  for (double& x : v) x = number();
  return v;
}

template <class Number>
Moving_pair pair_of(Moving_kind kind, const Number& number)
{
  Moving_pair pair{kind, {}};
  for (Moving_point& p : pair.points) {
    p.start = vertex_of(number);
    p.end = vertex_of(number);
  }
  return pair;
}

/// Shears by integers, then a dyadic translation: exact on what has few digits.
struct Frame {
  std::array<double, 3> shear;
  Vertex from;

  explicit Frame(Random& random) : shear{integer(random, 2), integer(random, 2), integer(random, 2)}, from{}
  {
    from = vertex_of([&] { return dyadic(random); });
  }

  Vertex operator()(Vertex v) const
  {
    v[1] += shear[0] * v[0];
    v[2] += shear[1] * v[0] + shear[2] * v[1];
    v[0] += shear[1] * v[2];
    for (std::size_t axis = 0; axis < 3; ++axis) v[axis] += from[axis];
    return v;
  }
};

Moving_pair in_frame(const Frame& frame, Moving_pair pair)
{
  for (Moving_point& p : pair.points) p = {frame(p.start), frame(p.end)};
  return pair;
}

/// Moves one coordinate to a neighbouring double in one case of three.
Moving_pair nudged(Random& random, Moving_pair pair)
{
  if (below(random, 3) != 0) return pair;
  Moving_point& p = pair.points[static_cast<std::size_t>(below(random, 4))];
  double& x = (below(random, 2) == 0 ? p.start : p.end)[static_cast<std::size_t>(below(random, 3))];
  x = std::nextafter(x, below(random, 2) == 0 ? HUGE_VAL : -HUGE_VAL);
  return pair;
}

Moving_pair anywhere(Random& random, Moving_kind kind)
{
  return pair_of(kind, [&] { return random.symmetric(); });
}

Moving_pair small_integers(Random& random, Moving_kind kind)
{
  return pair_of(kind, [&] { return integer(random, 2); });
}

/// The differences are triangular. The volume is the product of three linear forms with chosen roots, so it has simple,
/// double and triple roots, at the ends too.
Moving_pair factored(Random& random, Moving_kind kind)
{
  const auto linear = [&](double& start, double& end) {
    constexpr std::array<std::array<double, 2>, 8> roots = {
        {{-1, 1}, {-1, 1}, {-1, 3}, {0, 1}, {1, 0}, {-1, 2}, {1, 1}, {-3, 5}}};
    const auto& root = roots[static_cast<std::size_t>(below(random, 8))];
    const double scale = below(random, 2) == 0 ? 1 : -0.5;
    start = scale * root[0];
    end = scale * root[1];
  };
  Moving_pair pair{kind, {}};
  for (std::size_t k = 1; k < 4; ++k) {
    Moving_point& p = pair.points[k];
    for (std::size_t axis = 0; axis + 1 < k; ++axis) {
      p.start[axis] = integer(random, 2) * 0.5;
      p.end[axis] = below(random, 2) == 0 ? p.start[axis] : integer(random, 2) * 0.5;
    }
    linear(p.start[k - 1], p.end[k - 1]);
  }
  return nudged(random, in_frame(Frame(random), pair));
}

/// All four points in one plane all the time.
Moving_pair coplanar(Random& random, Moving_kind kind)
{
  const int grid = below(random, 3) == 0 ? 1 << 20 : 3;
  Moving_pair pair = pair_of(kind, [&] { return integer(random, grid); });
  for (Moving_point& p : pair.points) p.start[2] = p.end[2] = 0;
  return in_frame(Frame(random), pair);
}

/// A contact at `quarter` quarters of the time, of chosen points of both primitives, on their borders too.
Moving_pair touching(Random& random, Moving_kind kind, int quarter)
{
  const auto grid = [&] { return integer(random, 64); };
  std::array<Vertex, 4> at;
  for (Vertex& v : at) v = vertex_of(grid);
  // The first point is set so that the primitives touch.
  const double u = below(random, 5) * 0.25, w = kind == Moving_kind::edge_edge ? 0 : below(random, 5) * (1 - u) * 0.25;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double& x = at[0][axis];
    if (kind == Moving_kind::vertex_face)
      x = at[1][axis] + u * (at[2][axis] - at[1][axis]) + w * (at[3][axis] - at[1][axis]);
    else
      x = 2 * (at[2][axis] + u * (at[3][axis] - at[2][axis])) - at[1][axis];  // the touch is the first edge's middle
  }
  Moving_pair pair{kind, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vertex way = vertex_of(grid);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pair.points[k].start[axis] = at[k][axis] - way[axis] * quarter;
      pair.points[k].end[axis] = at[k][axis] + way[axis] * (4 - quarter);
    }
  }
  return nudged(random, pair);
}

Moving_pair at_ends(Random& random, Moving_kind kind) { return touching(random, kind, 4 * below(random, 2)); }
Moving_pair grazing(Random& random, Moving_kind kind) { return touching(random, kind, 1 + below(random, 3)); }

/// A fast point or edge through a small resting face or edge, or past its border by little.
Moving_pair tunnelling(Random& random, Moving_kind kind)
{
  Moving_pair pair = pair_of(kind, [&] { return dyadic(random); });
  const std::size_t movers = kind == Moving_kind::vertex_face ? 1 : 2;
  const double speed = std::ldexp(1, 4 + below(random, 16));
  for (std::size_t k = 0; k < 4; ++k) {
    Moving_point& p = pair.points[k];
    p.end = p.start;
    if (k >= movers) continue;
    p.start[2] -= speed;
    p.end[2] += speed;
  }
  return in_frame(Frame(random), pair);
}

/// Edges of length zero, flat faces, points that coincide, edges that stay parallel, at some or at all times.
Moving_pair degenerate(Random& random, Moving_kind kind)
{
  Moving_pair pair = below(random, 2) == 0 ? small_integers(random, kind) : grazing(random, kind);
  auto& p = pair.points;
  const std::size_t to = static_cast<std::size_t>(below(random, 4)), from = static_cast<std::size_t>(below(random, 4));
  switch (below(random, 4)) {
    case 0: p[to] = p[from]; break;
    case 1: p[to].start = p[from].start; break;
    case 2:
      for (std::size_t axis = 0; axis < 3; ++axis) {  // parallel edges, or a flat face
        p[3].start[axis] = p[2].start[axis] + 2 * (p[1].start[axis] - p[0].start[axis]);
        p[3].end[axis] = p[2].end[axis] + 2 * (p[1].end[axis] - p[0].end[axis]);
      }
      break;
    default:
      for (Moving_point& q : p) q.start[1] = q.end[1] = q.start[2] = q.end[2] = 0;  // on a line
  }
  return pair;
}

Moving_pair resting(Random& random, Moving_kind kind)
{
  Moving_pair pair = below(random, 2) == 0 ? at_ends(random, kind) : small_integers(random, kind);
  const bool glides = below(random, 2) == 0;
  for (Moving_point& p : pair.points) {
    p.end = p.start;
    if (glides) p.end[0] += 1;
  }
  return pair;
}

Moving_pair any_but_scaled(Random& random, Moving_kind kind)
{
  constexpr std::array makes = {anywhere, small_integers, factored, coplanar, at_ends, grazing, degenerate};
  return makes[static_cast<std::size_t>(below(random, makes.size()))](random, kind);
}

/// Scales each axis by its own power of two: tiny and huge motions.
Moving_pair scaled_axes(Random& random, Moving_kind kind)
{
  Moving_pair pair = any_but_scaled(random, kind);
  const int range = below(random, 2) == 0 ? 60 : 900;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int exponent = static_cast<int>(integer(random, range));
    for (Moving_point& p : pair.points)
      for (Vertex* const v : {&p.start, &p.end}) (*v)[axis] = std::ldexp((*v)[axis], exponent);
  }
  return pair;
}

/// Far from the origin: the differences have few digits.
Moving_pair far_away(Random& random, Moving_kind kind)
{
  Moving_pair pair = any_but_scaled(random, kind);
  const Vertex to = vertex_of([&] { return std::ldexp(random.symmetric(), 40 + below(random, 12)); });
  for (Moving_point& p : pair.points)
    for (Vertex* const v : {&p.start, &p.end})
      for (std::size_t axis = 0; axis < 3; ++axis) (*v)[axis] += to[axis];
  return pair;
}

/// Coordinates of any exponents, denormal ones too.
Moving_pair wild(Random& random, Moving_kind kind)
{
  // All exponents at once cost integers of 6000 bits: seldom.
  const int range = below(random, 64) == 0 ? 1000 : below(random, 8) == 0 ? 200 : 20;
  const int middle = static_cast<int>(integer(random, 1000 - range)) - 60;
  return pair_of(kind, [&] {
    const double digits = below(random, 4) == 0 ? integer(random, 1) : random.symmetric();
    return std::ldexp(digits, middle + static_cast<int>(integer(random, range)));
  });
}

constexpr std::array of_motion = {
    Motion_family{"anywhere", "uniform in a cube", anywhere},
    Motion_family{"small-integers", "coordinates from -2 to 2: everything degenerate", small_integers},
    Motion_family{"factored", "volumes with chosen roots, double and triple ones, an ulp off now and then", factored},
    Motion_family{"coplanar", "all in one plane all the time", coplanar},
    Motion_family{"at-ends", "a touch at the start or at the end, an ulp off now and then", at_ends},
    Motion_family{"grazing", "a touch at a quarter of the time, an ulp off now and then", grazing},
    Motion_family{"tunnelling", "fast and small", tunnelling},
    Motion_family{"degenerate", "edges of length zero, flat faces, parallel edges, all on a line", degenerate},
    Motion_family{"resting", "standing still, or gliding together", resting},
    Motion_family{"scaled", "those before, each axis scaled by a power of two", scaled_axes},
    Motion_family{"far-away", "those before, far from the origin", far_away},
    Motion_family{"wild", "any exponents", wild},
};

}  // namespace

std::span<const Motion_family> motion_families() { return of_motion; }

kernel::Moving_pair motion_case(const Motion_family& family, std::uint64_t seed, std::uint64_t index)
{
  Random random = random_of_case(seed, family.name, index);
  return family.make(random, index % 2 == 0 ? Moving_kind::vertex_face : Moving_kind::edge_edge);
}

}  // namespace tetracone::verify
