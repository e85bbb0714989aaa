#include "verify/cases/object_placing.h"
#include "verify/cases/shape_generators.h"
#include "verify/families/object_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace tetracone::verify::object_family {
namespace {

/// Blocks times this have integer coordinates.
constexpr int grid = 6;

Touching block_contact(Random& random, const Shape& a, const Shape& b)
{
  return any_contact(random, a, b, signed_permutation(integer(random, 0, 23)));
}

/// F o pose o G^-1 for F: x -> diag(2^exponents) x + to and G: x -> diag(2^exponents) x + from, each shift in all three
/// coordinates. (2^exponents itself may be no pose: its inverse is beyond the doubles.)
Pose reframed(const Pose& pose, const std::array<int, 3>& exponents, double from, double to)
{
  std::array<Rational, 12> entries;
  for (int i = 0; i < 3; ++i) {
    entries[4 * i + 3] = power_of_two(exponents[i]) * pose.exact(4 * i + 3) + Rational(to);
    for (int j = 0; j < 3; ++j) {
      entries[4 * i + j] = power_of_two(exponents[i] - exponents[j]) * pose.exact(4 * i + j);
      entries[4 * i + 3] -= entries[4 * i + j] * Rational(from);
    }
  }
  return Pose(entries);
}

/// The contact opened by the gap and then seen in another frame, both bodies with it.
Object_case framed(Random& random, const Shape& a, const Shape& b, Touching contact, const Rational& gap,
                   const std::array<int, 3>& exponents, double shift, const Pose& common)
{
  contact.relative = moved(contact.relative, times(gap, scaled_to_one(contact.apart)));
  const Pose relative = reframed(contact.relative, exponents, shift, shift);
  const Object_case c =
      placed(random, moved_copy(a, exponents, shift), moved_copy(b, exponents, shift), relative, common);
  if (gap == 0) return with_answer(c, true);
  return gap > 0 && contact.separated ? with_answer(c, false) : c;
}

/// Turns that leave axes of different scales where they are.
Pose axis_turn(Random& random)
{
  const std::uint64_t draw = random.bits();
  const auto sign = [draw](int bit) { return (draw >> bit & 1) == 0 ? 1.0 : -1.0; };
  return scaling(sign(0), sign(1), sign(2));
}

/// Returns 0, or a multiple of 2^exponent of up to 8 in either direction.
Rational few(Random& random, int exponent)
{
  if (random.bits() % 2 == 0) return 0;
  return Rational(integer(random, 0, 2) == 0 ? -integer(random, 1, 8) : integer(random, 1, 8)) * power_of_two(exponent);
}

}  // namespace

/// Contacts moved far away by their poses or with their vertices, with an error of a few ulps there.
Object_case far_from_origin(Random& random, double parameter)
{
  const int f = static_cast<int>(parameter);
  const double far = std::ldexp(1.0, f);
  const Shape& a = any_block(random);
  const Shape& b = any_block(random);
  if (random.bits() % 2 == 0) {
    const Shape& other = any_shape(random);
    const Touching contact = any_contact(random, a, other, any_turn(random));
    const auto share = [&]() -> Rational { return Rational(integer(random, -1, 1)) * Rational(far); };
    const Exact_vector shift = {share(), share(), Rational(far)};
    const Pose common = moved(motion(random, exact_motion(random)), shift);
    return placed(random, contact, few(random, f - 52), common);
  }
  const Touching contact = block_contact(random, a, b);
  const Pose common = motion(random, exact_motion(random));
  return framed(random, a, b, contact, few(random, f - 52 - grid), {grid, grid, grid}, far, common);
}

/// B is smaller by 2^s, in its pose or in its vertices.
Object_case mixed_scales(Random& random, double parameter)
{
  const int s = static_cast<int>(parameter);
  const Shape& a = any_shape(random);
  const Shape& b = any_block(random);
  Touching contact = any_contact(random, a, b, composed(scaling(std::ldexp(1.0, -s)), any_turn(random)));
  if (random.bits() % 2 == 0) {
    contact.b = moved_copy(b, -s);
    contact.relative = composed(contact.relative, scaling(std::ldexp(1.0, s)));
  }
  const Rational gap = random.bits() % 2 == 0 ? few(random, -s - 4) : any_gap(random);
  return placed(random, contact, gap);
}

/// A contact of which one body is 2^p long. A copy of it is so far away, or a vertex of no face.
Object_case distant_part(Random& random, double parameter)
{
  const Shape& a = any_block(random);
  const Shape& b = any_block(random);
  const Touching contact = any_contact(random, a, b, any_turn(random));
  Object_case c = placed(random, contact, any_gap(random));
  auto& body = random.bits() % 2 == 0 ? c.a : c.b;
  covering::Polyhedron longer = *body;
  const auto axis = std::size_t(integer(random, 0, 2));
  const double far = std::ldexp(random.bits() % 2 == 0 ? 1.0 : -1.0, static_cast<int>(parameter));
  if (random.bits() % 2 == 0) {
    longer.vertices.push_back({0, 0, 0});
    longer.vertices.back()[axis] = far;
  } else {
    covering::Polyhedron copy = *body;
    for (covering::Vertex& v : copy.vertices) v[axis] += far;
    covering::append(longer, copy);
  }
  body = std::make_shared<const covering::Polyhedron>(std::move(longer));
  return c;
}

/// B's vertices are about 2^f from its origin, and its translation brings them back; exactly, or with poses rounded to
/// doubles.
Object_case cancelled_translation(Random& random, double parameter)
{
  const int f = static_cast<int>(parameter);
  const double far = std::ldexp(1.0, f);
  const Shape& a = any_block(random);
  const Shape& b = any_block(random);
  Touching contact = any_contact(random, a, b, any_turn(random));
  contact.relative = reframed(contact.relative, {grid, grid, grid}, far, 0);
  contact.a = moved_copy(a, grid);
  contact.b = moved_copy(b, grid, far);
  const Rational gap = random.bits() % 2 == 0 ? few(random, f - 52) : any_gap(random);
  return placed(random, contact, gap, random.bits() % 4 == 0 ? Motion::rounded : exact_motion(random));
}

Object_case exponent_gate(Random& random, double parameter)
{
  const int kind = static_cast<int>(parameter), within = integer(random, 0, 3);
  const Shape& a = any_block(random);
  const Shape& b = any_block(random);
  const Pose common = signed_permutation(random.bits() % 2 == 0 ? 0 : integer(random, 0, 23));
  if (kind == 4) {
    std::array<int, 3> exponents = {110, -110, 0};
    std::rotate(exponents.begin(), exponents.begin() + within % 3, exponents.end());
    const Touching contact = any_contact(random, a, b, axis_turn(random));
    return framed(random, a, b, contact, any_gap(random), exponents, 0, common);
  }
  const int exponent = std::array{-106 + within, 110 - within, -111 - within, 111 + within}[kind];
  const Touching contact = block_contact(random, a, b);
  return framed(random, a, b, contact, any_gap(random), {exponent, exponent, exponent}, 0, common);
}

/// A block of few faces: where no bound holds, every pair is decided by numbers of thousands of bits.
static const Shape& small_block(Random& random)
{
  for (;;) {
    const Shape& shape = any_block(random);
    if (shape.body->face_count() <= 8) return shape;
  }
}

/// Denormal bodies are multiples of 2^-1070, so that most contacts are doubles; large ones reach 2^1021, and their
/// images 2^1023.
Object_case extreme_exponents(Random& random, double parameter)
{
  const int kind = static_cast<int>(parameter);
  const Shape& a = small_block(random);
  const Shape& b = small_block(random);
  const Pose common = signed_permutation(random.bits() % 2 == 0 ? 0 : integer(random, 0, 23));
  if (kind == 2) {
    std::array<int, 3> exponents = {664, -664, integer(random, -1, 1) * 332};
    std::rotate(exponents.begin(), exponents.begin() + integer(random, 0, 2), exponents.end());
    const Touching contact = any_contact(random, a, b, axis_turn(random));
    return framed(random, a, b, contact, any_gap(random), exponents, 0, common);
  }
  const int exponent = kind == 0 ? -1064 : 1020;
  const Touching contact = block_contact(random, a, b);
  return framed(random, a, b, contact, random.bits() % 2 == 0 ? few(random, -9) : any_gap(random),
                {exponent, exponent, exponent}, 0, common);
}

/// Needles and plates: boxes about the origin, each stretched along its axes by its own powers of two. Each is then
/// turned about one axis by an eighth, or not. They touch or pierce one another along that axis. Their axes differ by
/// more than a double's square can hold.
static std::vector<Object_case> boxes_on_an_axis(Random& random, int size, int count)
{
  const int axis = integer(random, 0, 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto half_lengths = [&] { return kernel::Vertex{dyadic(random, 3), dyadic(random, 3), dyadic(random, 3)}; };
  const auto about_origin = [](const kernel::Vertex& half) {
    return shared(box({-half[0], -half[1], -half[2]}, half));
  };
  const kernel::Vertex half_a = half_lengths(), half_b = half_lengths();
  const Body a = about_origin(half_a), b = about_origin(half_b);

  const auto turned_about_axis = [&](const std::array<int, 3>& exponents) {
    std::array<double, 12> entries = stretch(exponents).entries();
    if (random.bits() % 4 != 0) {
      entries[4 * u + v] = -entries[4 * v + v];
      entries[4 * v + u] = entries[4 * u + u];
    }
    return Pose(entries);
  };
  std::vector<Object_case> cases;
  for (int k = 0; k < count; ++k) {
    std::array<int, 3> of_a, of_b;
    of_a[u] = size * integer(random, -1, 1);
    of_a[v] = random.bits() % 4 != 0 ? of_a[u] : integer(random, -size, size);
    for (const int i : {u, v})
      of_b[i] = random.bits() % 4 == 0 ? integer(random, -size, size) : integer(random, -8, 24) - of_a[i];
    of_a[axis] = integer(random, -2, 2);
    of_b[axis] = integer(random, -2, 2);
    const Pose pose_a = turned_about_axis(of_a), pose_b = turned_about_axis(of_b);
    Exact_vector shift = {0, 0, 0};
    const int eighths = integer(random, 0, 9);
    shift[axis] = Rational(std::ldexp(half_a[axis], of_a[axis]) + std::ldexp(half_b[axis], of_b[axis])) * eighths / 8;
    const Pose common = signed_permutation(integer(random, 0, 47));
    Object_case c{a, b, composed(common, pose_a), composed(common, moved(pose_b, shift)), {}, {}, {}};
    if (random.bits() % 2 == 0) {
      std::swap(c.a, c.b);
      std::swap(c.pose_a, c.pose_b);
    }
    cases.push_back(eighths < 8 ? with_answer(c, {}, true) : with_answer(c, eighths == 8));
  }
  return cases;
}

/// The case, or with its poses rounded to doubles where these are maps.
static Object_case perhaps_rounded(Random& random, const Object_case& c)
{
  if (random.bits() % 2 == 0) return c;
  const Object_case rounded = rounded_poses(c);
  const bool is_flat =
      rounded.pose_a.determinant_sign() == CGAL::ZERO || rounded.pose_b.determinant_sign() == CGAL::ZERO;
  return is_flat ? c : rounded;
}

/// Tetrahedra whose coordinates have any exponents up to `size`, corner on corner.
static std::vector<Object_case> wild_tetrahedra(Random& random, int size, int count)
{
  const auto coordinate = [&] {
    const double mantissa = random.symmetric();
    return std::ldexp(mantissa, integer(random, -size, size));
  };
  const auto body = [&] {
    std::array<kernel::Vertex, 4> corners;
    for (kernel::Vertex& v : corners)
      for (double& x : v) x = coordinate();
    return tetrahedron(corners);
  };
  std::vector<Object_case> cases;
  const Body a = body(), b = body();
  for (int k = 0; k < count; ++k) {
    const Pose turn = wild_map(random, size);
    const Touching contact = vertex_on_vertex(random, a, b, turn);
    const Rational gap = any_gap(random);
    const Pose common = wild_map(random, size);
    cases.push_back(perhaps_rounded(random, placed(random, contact, gap, common)));
  }
  return cases;
}

/// B turned in the middle of A's corners, some thirty times smaller.
static Touching in_the_middle(Random& random, const Shape& a, const Shape& b)
{
  Exact_vector middle = {0, 0, 0};
  for (Index v = 0; v < a.body->vertices.size(); ++v)
    middle = sum(middle, Rational(1) / Rational(int(a.body->vertices.size())), a.vertex(v));
  return {a.body, b.body, moved(composed(scaling(0x1p-5), any_turn(random)), middle), middle};
}

/// B in the middle of A, or in contact with it.
static Touching inside_or_on(Random& random, const Shape& a, const Shape& b, bool is_inside)
{
  if (is_inside) return in_the_middle(random, a, b);
  const Pose turn = any_turn(random);
  return any_contact(random, a, b, turn);
}

/// A at the identity and B at `relative`, moved by `common`. Vertices are stretched by powers of two, which poses undo.
static Object_case stretched(const Shape& a, const std::array<int, 3>& of_a, const Shape& b,
                             const std::array<int, 3>& of_b, const Pose& relative, const Pose& common)
{
  const auto back = [](const std::array<int, 3>& e) { return stretch({-e[0], -e[1], -e[2]}); };
  const Pose pose_a = composed(common, back(of_a)), pose_b = composed(common, composed(relative, back(of_b)));
  return {moved_copy(a, of_a), moved_copy(b, of_b), pose_a, pose_b, {}, {}, {}};
}

/// Blocks whose vertices are stretched along their axes by up to 2^size. Their poses undo that before a turn, a contact
/// or a place inside, and a map of both.
static std::vector<Object_case> stretched_blocks(Random& random, int size, int count)
{
  const auto exponents = [&] {
    std::array<int, 3> result{0, 0, 0};
    if (random.bits() % 2 == 0)
      for (int& e : result) e = size * integer(random, -1, 1);
    return result;
  };
  std::vector<Object_case> cases;
  const Shape& a = small_block(random);
  const Shape& b = small_block(random);
  const std::array<int, 3> of_a = exponents(), of_b = exponents();
  for (int k = 0; k < count; ++k) {
    Touching contact = inside_or_on(random, a, b, random.bits() % 4 == 0);
    const bool is_contact = contact.separated;
    const Rational gap = is_contact ? any_gap(random) : Rational(0);
    if (is_contact) contact.relative = moved(contact.relative, times(gap, scaled_to_one(contact.apart)));
    const Pose common = wild_map(random, size);
    Object_case c = stretched(a, of_a, b, of_b, contact.relative, common);
    if (is_contact && gap >= 0) c = with_answer(c, gap == 0);
    cases.push_back(perhaps_rounded(random, c));
  }
  return cases;
}

/// A run of one kind: stretched blocks, tetrahedra of any exponents, or boxes on an axis. With exact poses, or these
/// rounded to doubles.
std::vector<Object_case> wild_run(Random& random, double parameter, int count)
{
  const std::uint64_t kind = random.bits() % 3;
  if (kind == 0) return boxes_on_an_axis(random, static_cast<int>(parameter) * 3 / 4, count);
  if (kind == 1) return stretched_blocks(random, static_cast<int>(parameter) / 3, count);
  return wild_tetrahedra(random, static_cast<int>(parameter) / 5, count);
}

Object_case wild(Random& random, double parameter) { return wild_run(random, parameter, 1).front(); }

/// Blocks with coordinates up to about 2^parameter, by one power of two or one of each axis. Similarities of fractions
/// undo it. The blocks are then as large as 1, far smaller, or smaller than all doubles but 0.
Object_case tiny_fractions(Random& random, double parameter)
{
  const int size = static_cast<int>(parameter);
  const auto exponents = [&] {
    std::array<int, 3> result{size, size, size};
    if (random.bits() % 3 == 0)
      for (int& e : result) e = size * integer(random, -1, 1);
    return result;
  };
  const Shape& a = small_block(random);
  const Shape& b = small_block(random);
  const std::array<int, 3> of_a = exponents(), of_b = exponents();
  const bool is_inside = random.bits() % 4 == 0;
  Touching contact = inside_or_on(random, a, b, is_inside);
  const Rational gap = is_inside ? Rational(0) : any_gap(random);
  if (!is_inside) contact.relative = moved(contact.relative, times(gap, scaled_to_one(contact.apart)));
  const std::array smaller = {0, integer(random, 25, 125), integer(random, 900, 1080)};
  const Pose common = fraction_map(random, -smaller[random.bits() % 3]);
  const Object_case c = stretched(a, of_a, b, of_b, contact.relative, common);
  if (is_inside || gap < 0) return c;
  return gap == 0 ? with_answer(c, true) : contact.separated ? with_answer(c, false) : c;
}

}  // namespace tetracone::verify::object_family
