// Judges the adaptive and the rational kernel by cases whose answers are known: exit status 1 at the first wrong one.
// Its headers may be mutants, so it takes cases and truths as text, made by cases.cpp from headers that are not.

#include "tetracone/covering/inclusion.h"
#include "tetracone/covering/io/read_poses.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/tetrahedron.h"
#include "tetracone/tetratree/paper/collision.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "verify/cases/case.h"
#include "verify/cases/random.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace tetracone;
using kernel::Adaptive;
using kernel::Pose;
using kernel::Question;
using kernel::Rational;
using kernel::Vertex;
using verify::Predicate;

namespace {

[[noreturn]] void wrong(const std::string& what)
{
  std::cout << "wrong: " << what << '\n';
  std::exit(1);
}

// --- reading ---------------------------------------------------------------------------------------------------------

Rational read_rational(std::istream& in)
{
  std::string word;
  in >> word;
  if (const auto fraction = kernel::parse_fraction(word)) return *fraction;
  return Rational(kernel::parse_double(word).value());
}
double read_double(std::istream& in)
{
  std::string word;
  in >> word;
  return kernel::parse_double(word).value();
}
Vertex read_vertex(std::istream& in)
{
  Vertex v;
  for (double& coordinate : v) coordinate = read_double(in);
  return v;
}
Pose read_pose(std::istream& in)
{
  std::array<Rational, 12> entries;
  for (Rational& entry : entries) entry = read_rational(in);
  return Pose(entries);
}
covering::Polyhedron read_body(std::istream& in)
{
  covering::Polyhedron body;
  std::size_t vertices, faces;
  in >> vertices >> faces;
  while (vertices-- > 0) body.vertices.push_back(read_vertex(in));
  while (faces-- > 0) {
    std::size_t count;
    in >> count;
    std::vector<std::vector<covering::Index>> loops(count);
    for (auto& loop : loops) {
      in >> count;
      loop.resize(count);
      for (auto& corner : loop) in >> corner;
    }
    body.add_face(loops);
  }
  return body;
}

// --- predicates ------------------------------------------------------------------------------------------------------

template <class K>
int answer(Predicate predicate, const verify::Predicate_case& c)
{
  using Point = kernel::Point<K>;
  const kernel::Frame<K> in_a(c.pose_a), in_b(c.pose_b);
  std::array<Point, 4> v;
  for (int k = 0; k < 4; ++k) v[k] = in_a(kernel::point<K>(c.v[k]));
  const Point p = in_b(kernel::point<K>(c.p)), q = in_b(kernel::point<K>(c.q)), r = in_b(kernel::point<K>(c.r));
  if (predicate == Predicate::orientation) return -kernel::volume_sign<K>(v[1], v[2], v[3], p);
  if (predicate == Predicate::segment_triangle) {
    const bool meet = kernel::segment_triangle<K>(p, q, v[1], v[2], v[3]) != kernel::Contact::none;
    if (meet != (kernel::segment_face<K>(p, q, kernel::Triangle<K>{v[1], v[2], v[3]}) != kernel::Contact::none))
      return -2;
    return meet;
  }
  if (predicate == Predicate::tetrahedron) return kernel::is_in_tetrahedron<K>(p, v[0], v[1], v[2], v[3]);
  if (predicate == Predicate::solid) {
    int winding = 0;
    for (const auto& [i, j, k] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
      if (kernel::segment_triangle<K>(p, p, v[i], v[j], v[k]) != kernel::Contact::none) return 0;
      winding += covering::signed_inclusion<K>(p, q, v[i], v[j], v[k]);
    }
    return winding != 0 ? 1 : -1;
  }
  if (kernel::volume_sign<K>(v[0], v[1], v[2], v[3]) == kernel::NEGATIVE) std::swap(v[2], v[3]);
  if (predicate == Predicate::tetra_cone) return kernel::is_in_tetra_cone<K>(p, v[0], v[1], v[2], v[3]);
  tetratree::Cone_points<K> cone(kernel::Cone_lattice{}, tetratree::Tetra_cone::octant(0));
  cone.v0 = v[0];
  cone.v1 = v[1];
  cone.v2 = v[2];
  cone.v3 = v[3];
  return tetratree::classify<K>(cone, p, q, r) != tetratree::Classified::no;
}

void judge_predicate(std::istream& in, int number)
{
  int predicate, truth;
  in >> predicate >> truth;
  verify::Predicate_case c;
  for (Vertex& v : c.v) v = read_vertex(in);
  c.p = read_vertex(in);
  c.q = read_vertex(in);
  c.r = read_vertex(in);
  c.pose_a = read_pose(in);
  c.pose_b = read_pose(in);
  const auto which = static_cast<Predicate>(predicate);
  const std::string name = std::string(verify::to_string(which)) + " in case " + std::to_string(number);
  if (answer<Adaptive>(which, c) != truth) wrong("adaptive, " + name);
  if (number % 4 == 0 && answer<kernel::Rational_kernel>(which, c) != truth) wrong("rational, " + name);
}

// --- objects ---------------------------------------------------------------------------------------------------------

template <class K>
void judge(const char* subject, const tetratree::Config& config, const covering::Polyhedron& a,
           const covering::Polyhedron& b, const Pose& pose_a, const Pose& pose_b, int surface, int solid, int number)
{
  tetratree::Tetra_tree<K> tree_a(a, config), tree_b(b, config);
  tetratree::Collision<K> collision(tree_a, tree_b);
  if (collision(pose_a, pose_b, Question::surface) != (surface == 1))
    wrong(std::string(subject) + ", surface in case " + std::to_string(number));
  if (collision(pose_a, pose_b, Question::solid) != (solid == 1))
    wrong(std::string(subject) + ", solid in case " + std::to_string(number));
}

/// The fast tree is asked twice: the second time it begins with its memory of the first.
void judge_bvh8(const covering::Polyhedron& a, const covering::Polyhedron& b, const Pose& pose_a, const Pose& pose_b,
                int surface, int solid, int number)
{
  tetratree::Bvh8 tree_a(a), tree_b(b);
  tetratree::Bvh8_collision collision(tree_a, tree_b, tetratree::Coherence::last_frame);
  for (int round = 0; round < 2; ++round) {
    if (collision(pose_a, pose_b, Question::surface) != (surface == 1))
      wrong("fast tree, surface in case " + std::to_string(number));
    if (collision(pose_a, pose_b, Question::solid) != (solid == 1))
      wrong("fast tree, solid in case " + std::to_string(number));
  }
}

void judge_object(std::istream& in, int number)
{
  int surface, solid;
  in >> surface >> solid;
  const covering::Polyhedron a = read_body(in), b = read_body(in);
  const Pose pose_a = read_pose(in), pose_b = read_pose(in);
  tetratree::Config fine, plain, shallow;
  fine.leaf_size = 1;
  shallow.depth = 1;
  shallow.far_plane = tetratree::Far_plane::tightest;
  plain.tetrahedra = plain.regular_hull = false;
  judge<Adaptive>("adaptive paper", {}, a, b, pose_a, pose_b, surface, solid, number);
  judge<Adaptive>("adaptive small leaves", fine, a, b, pose_a, pose_b, surface, solid, number);
  judge<Adaptive>("adaptive shallow", shallow, a, b, pose_a, pose_b, surface, solid, number);
  judge<Adaptive>("adaptive spheres", plain, a, b, pose_a, pose_b, surface, solid, number);
  judge<Adaptive>("adaptive tuned", tetratree::Config::fastest(), a, b, pose_a, pose_b, surface, solid, number);
  judge<Adaptive>("adaptive brute", tetratree::Config::brute(), a, b, pose_a, pose_b, surface, solid, number);
  judge_bvh8(a, b, pose_a, pose_b, surface, solid, number);
  if (number % 16 == 0)
    judge<kernel::Rational_kernel>("rational tuned", tetratree::Config::fastest(), a, b, pose_a, pose_b, surface, solid,
                                   number);
}

// --- the adaptive kernel's own promises ------------------------------------------------------------------------------

/// Points rounded on a plane or a line, about 0 or all about another point: what a filter decides must be the exact
/// sign, what encloses must enclose.
void judge_stages(int rounds)
{
  verify::Random random(1);
  const auto say = [](const Adaptive::Decision& filtered, CGAL::Sign exact, const char* what) {
    if (filtered && *filtered != exact) wrong(std::string("filter of the ") + what);
  };
  for (int round = 0; round < rounds; ++round) {
    std::array<Vertex, 4> v;
    for (Vertex& x : v)
      for (double& coordinate : x)
        coordinate = round % 2 == 0 ? random.symmetric() / 3 : 1 + 0x1p-20 * random.symmetric();
    const double s = random.symmetric(), t = random.symmetric();
    for (int k = 0; k < 3; ++k) v[3][k] = v[0][k] + s * (v[1][k] - v[0][k]) + t * (v[2][k] - v[0][k]);
    std::array<double, 12> entries;
    for (double& entry : entries) entry = random.symmetric();
    const Pose pose(entries);
    std::array<Adaptive::Point_3, 4> p;
    for (int k = 0; k < 4; ++k) p[k] = round % 3 == 0 ? Adaptive::placed(v[k], pose) : Adaptive::unmoved(v[k]);
    say(Adaptive::filtered_volume_sign(p[0], p[1], p[2], p[3]), Adaptive::exact_volume_sign(p[0], p[1], p[2], p[3]),
        "volume sign");
    // p[3] on the line through p[0] and p[1], rounded.
    for (int k = 0; k < 3; ++k) v[3][k] = v[0][k] + s * (v[1][k] - v[0][k]);
    p[3] = p[0].pose ? Adaptive::placed(v[3], pose) : Adaptive::unmoved(v[3]);
    const int axis = round % 3;
    say(Adaptive::filtered_normal_sign(p[0], p[1], p[3], axis), Adaptive::exact_normal_sign(p[0], p[1], p[3], axis),
        "normal sign");
    if (p[0].pose == nullptr || round % 16 != 0) continue;
    for (int row = 0; row < 3; ++row) {
      Rational image(pose[4 * row + 3]);
      for (int k = 0; k < 3; ++k) image += Rational(pose[4 * row + k]) * Rational(v[0][k]);
      if (abs(Rational(image - Rational(p[0].image[row]))) > Rational(p[0].error)) wrong("error of a placed point");
    }
  }
}

/// Sums and products of two doubles each: within the proved errors, in parts that don't overlap. Every third time
/// nearly all cancels.
void judge_double_doubles(int rounds)
{
  verify::Random random(2);
  const auto pair = [&random] {
    const double high = random.symmetric();
    return kernel::Double_double::sum(high, 0x1p-54 * high * random.symmetric());
  };
  const auto exact = [](const kernel::Double_double& x) { return Rational(Rational(x.high) + Rational(x.low)); };
  const auto judge = [&](const kernel::Double_double& computed, const Rational& right, const Rational& most,
                         const char* what) {
    if (abs(Rational(exact(computed) - right)) > most * abs(right)) wrong(std::string(what) + " of double-doubles");
    if (computed.high + computed.low != computed.high) wrong(std::string("parts of the ") + what + " overlap");
  };
  const Rational u2 = Rational(0x1p-106);
  for (int round = 0; round < rounds; ++round) {
    const kernel::Double_double a = pair();
    kernel::Double_double b = pair();
    if (round % 3 == 0)
      b = kernel::Double_double(-a.high, -a.low * (1 + 0x1p-20)) + kernel::Double_double(0x1p-90 * random.symmetric());
    judge(a + b, exact(a) + exact(b), Rational(3.001) * u2, "sum");
    judge(a - b, exact(a) - exact(b), Rational(3.001) * u2, "difference");
    judge(a * b, exact(a) * exact(b), Rational(7.001) * u2, "product");
  }
}

/// The double-double stage decides nothing within its proved error, nothing wrongly, and nothing about points outside
/// the gate.
void judge_double_double_stage(int rounds)
{
  const auto silent = [](const Adaptive::Decision& decision, const char* what) {
    if (decision) wrong(std::string("double-double stage decides within its error: ") + what);
  };
  constexpr double u2 = 0x1p-106, infinity = std::numeric_limits<double>::infinity();
  const auto at = [](double x, double y, double z, double error) {
    Adaptive::Point_3 p = Adaptive::unmoved({x, y, z});
    p.error = error;
    return p;
  };
  for (const double e : {0.0, u2, 0x1p-80, infinity}) {
    const double volume = e == infinity ? 1 : 185 * u2 + 36 * e, normal = e == infinity ? 1 : 31 * u2 + 8 * e,
                 difference = e == infinity ? 1 : 2 * e;
    const Adaptive::Point_3 o = at(0, 0, 0, e);
    for (const double h : {volume, -volume})
      silent(Adaptive::double_double_volume_sign(o, at(1, 0, 1, e), at(0, 1, 0, e), at(0, 0, h, e)), "volume");
    for (const double h : {normal, -normal})
      silent(Adaptive::double_double_normal_sign(o, at(1, 1, 0, e), at(0, h, 0, e), 2), "normal");
    if (e != 0) silent(Adaptive::double_double_difference_sign(at(difference, 0, 0, e), o, 0), "difference");
  }

  verify::Random random(3);
  const auto vertex = [&random](double radius) {
    return Vertex{radius * random.symmetric(), radius * random.symmetric(), radius * random.symmetric()};
  };
  for (int round = 0; round < rounds; ++round) {
    std::array<Rational, 12> entries;
    for (Rational& entry : entries)
      entry =
          round % 2 == 0 ? Rational(random.symmetric()) : Rational(Rational(std::round(99 * random.symmetric())) / 7);
    const Pose pose(entries);
    const Vertex v = vertex(1);
    const Adaptive::Point_3 p = Adaptive::placed(v, pose);
    const tetracone::kernel::Double_double_image image = Adaptive::double_double_image(p);
    for (int row = 0; row < 3; ++row) {
      Rational exact = entries[4 * row + 3],
               computed = Rational(image.coordinate[row].high) + Rational(image.coordinate[row].low), sum = abs(exact);
      for (int k = 0; k < 3; ++k) {
        exact += entries[4 * row + k] * Rational(v[k]);
        sum += abs(Rational(entries[4 * row + k] * Rational(v[k])));
      }
      if (abs(Rational(exact - computed)) > Rational(image.error))
        wrong("image of twice the digits is off by more than its error");
      if (Rational(image.error) < (round % 2 == 0 ? 9 : 17) * Rational(u2) * sum)
        wrong("error of an image of twice the digits is less than proved");
    }
    // On the plane x + y + z = 0, exactly, with all bits; and a rounded point of another plane.
    std::array<Adaptive::Point_3, 4> q;
    for (auto& point : q) {
      const double x = std::ldexp(std::round(std::ldexp(random.symmetric(), 52)), -52),
                   y = std::ldexp(std::round(std::ldexp(random.symmetric(), 52)), -52);
      point = Adaptive::unmoved({x, y, -(x + y)});
    }
    for (int k = 0; k < 2; ++k) {
      const Adaptive::Decision decision = Adaptive::double_double_volume_sign(q[0], q[1], q[2], q[3]);
      if (decision && *decision != Adaptive::exact_volume_sign(q[0], q[1], q[2], q[3]))
        wrong("double-double stage of the volume sign");
      q[k] = p;
    }
  }
}

/// Points of a small grid, and the same where rounding makes them one: what is ZERO at sight must be.
void judge_zero_exits(int rounds)
{
  verify::Random random(4);
  std::array<double, 12> entries = {1, 0, 0, 0x1p60, 0, 1, 0, 0x1p60, 0, 0, 1, 0x1p60};
  const Pose far(entries);
  for (int round = 0; round < rounds; ++round) {
    std::array<Adaptive::Point_3, 4> p;
    for (auto& point : p) {
      const Vertex v = {std::round(random.symmetric()), std::round(random.symmetric()), std::round(random.symmetric())};
      point = round % 2 == 0 ? Adaptive::unmoved(v) : Adaptive::placed(v, far);
    }
    if (Adaptive::zero_volume_sign(p[0], p[1], p[2], p[3]) &&
        Adaptive::exact_volume_sign(p[0], p[1], p[2], p[3]) != CGAL::ZERO)
      wrong("zero exit of the volume sign");
    const int axis = round % 3;
    if (Adaptive::zero_normal_sign(p[0], p[1], p[2], axis) &&
        Adaptive::exact_normal_sign(p[0], p[1], p[2], axis) != CGAL::ZERO)
      wrong("zero exit of the normal sign");
  }
}

}  // namespace

int main(int argc, char** argv)
{
  std::ifstream in(argc == 2 ? argv[1] : "");
  std::string level;
  int cases = 0;
  while (in >> level) level == "P" ? judge_predicate(in, cases++) : judge_object(in, cases++);
  if (cases == 0) {
    std::cerr << "probe: no cases; usage: probe CASES\n";
    return 2;
  }
  judge_stages(300000);
  judge_double_doubles(20000);
  judge_double_double_stage(4000);
  judge_zero_exits(20000);
  std::cout << "right: " << cases << " cases\n";
}
