// Writes cases of all families with their true answers, and bodies that touch exactly, as the text that probe.cpp
// reads.

#include "verify/cases/exact_motion.h"
#include "verify/families/families.h"
#include "verify/families/object_families.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/predicate_truth.h"

#include <cstdlib>
#include <iostream>

using namespace tetracone;
using namespace tetracone::verify;
using kernel::Pose;
using kernel::Vertex;

namespace {

void write(const Vertex& v)
{
  for (const double coordinate : v) std::cout << ' ' << kernel::shortest(coordinate);
}
void write(const Pose& pose)
{
  for (int k = 0; k < 12; ++k)
    std::cout << ' ' << (pose.is_rational() ? kernel::exact_text(pose.exact(k)) : kernel::shortest(pose[k]));
}
void write(const covering::Polyhedron& body)
{
  std::cout << ' ' << body.vertices.size() << ' ' << body.face_count();
  for (const Vertex& v : body.vertices) write(v);
  for (covering::Index f = 0; f < body.face_count(); ++f) {
    std::cout << ' ' << body.loop_count(f);
    for (std::size_t l = 0; l < body.loop_count(f); ++l) {
      std::cout << ' ' << body.loop(f, l).size();
      for (const covering::Index v : body.loop(f, l)) std::cout << ' ' << v;
    }
  }
}

void write(const Predicate_case& c)
{
  for (const Predicate predicate : all_predicates) {
    const auto truth = true_answer(predicate, c);
    if (!truth) continue;
    std::cout << "P " << int(predicate) << ' ' << *truth;
    for (const Vertex& v : c.v) write(v);
    write(c.p);
    write(c.q);
    write(c.r);
    write(c.pose_a);
    write(c.pose_b);
    std::cout << '\n';
  }
}

void write(const covering::Polyhedron& a, const covering::Polyhedron& b, const Pose& pose_a, const Pose& pose_b)
{
  const Brute_body of_a(a), of_b(b);
  if (!of_a.is_closed() || !of_b.is_closed()) return;
  std::cout << "O " << collide(of_a, pose_a, of_b, pose_b, kernel::Question::surface) << ' '
            << collide(of_a, pose_a, of_b, pose_b);
  write(a);
  write(b);
  write(pose_a);
  write(pose_b);
  std::cout << '\n';
}

covering::Polyhedron octahedron()
{
  scenes::Random random(1);
  return scenes::blob(random, 0, 1, 1);
}

/// A triangle and its back: a closed body that is only a piece of a plane.
covering::Polyhedron flat(const Vertex& a, const Vertex& b, const Vertex& c)
{
  covering::Polyhedron body;
  body.vertices = {a, b, c};
  body.add_polygon({0, 1, 2});
  body.add_polygon({0, 2, 1});
  return body;
}

/// Tip to tip, face to face, edge to edge and side by side under exact motions, near the origin and far from it; one in
/// the other.
void write_touching(Random& random)
{
  const auto bodies = scenes::closed_bodies();
  const auto integer = [&](int low, int high) { return low + int(one_of(random, high - low + 1)); };
  for (int round = 0; round < 280; ++round) {
    const double far = round % 3 == 0 ? 0x1p20 / 3 : 0;
    auto turn = *translated(Pose::from_quaternion(integer(1, 4), integer(-4, 4), integer(-4, 4), integer(-4, 4)),
                            {kernel::Rational(far), kernel::Rational(-far), kernel::Rational(0.1)});
    if (round % 5 == 0) turn = turned(Signed_permutation::any(random), turn);
    const auto beside = [&](const Vertex& step) { return *translated_back(turn, {-step[0], -step[1], -step[2]}); };
    switch (round % 7) {
      case 0: write(octahedron(), octahedron(), turn, beside({integer(0, 1) * 2.0 - 1, 1, 0})); break;
      case 1: write(octahedron(), octahedron(), turn, beside({2, 0, 0})); break;
      case 2:
        write(scenes::unit_cube(), scenes::triangulated(scenes::unit_cube()), turn,
              beside({1, integer(-2, 2) * 0.5, integer(-2, 2) * 0.5}));
        break;
      case 3: {  // an edge across an edge
        const auto roof = [](int along) {
          const Vertex low{0, 0, 0}, high = along == 0 ? Vertex{2, 0, 0} : Vertex{0, 2, 0};
          return along == 0 ? scenes::tetrahedron(low, high, {1, 1, -1}, {1, -1, -1})
                            : scenes::tetrahedron(low, high, {1, 1, 1}, {-1, 1, 1});
        };
        write(roof(0), roof(1), turn, beside({1, -1, 0}));
        break;
      }
      case 4: {
        const auto& a = bodies[one_of(random, bodies.size())].body;
        write(scenes::moved(a, 0x1p-6), scenes::cube(3), turn,
              beside({integer(-2, 2) * 1.0, integer(-2, 2) * 1.0, integer(-2, 2) * 1.0}));
        break;
      }
      case 5:
        write(flat({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), flat({1, 1, 0}, {2, 1, 0}, {1, 2, 0}), turn,
              beside({integer(-2, 2) * 1.0, integer(-2, 2) * 1.0, 0}));
        break;
      default: {
        const auto &a = bodies[one_of(random, bodies.size())].body, &b = bodies[one_of(random, bodies.size())].body;
        write(a, b, turn, beside({integer(-5, 5) * 1.0, integer(-4, 4) * 1.0, integer(-3, 3) * 0.5}));
      }
    }
  }
}

/// A body of two cubes far from each other, and another body that contains one of them.
void write_one_shell_inside()
{
  for (const bool first : {true, false}) {
    covering::Polyhedron two = scenes::unit_cube();
    scenes::append(two, scenes::moved(scenes::unit_cube(), 1, {20, 0, 0}));
    write(two, scenes::cube(4), Pose(), Pose::translation(first ? 0 : 20, 0, 0));
    write(scenes::cube(4), two, Pose(), Pose::translation(first ? 0 : -20, 0, 0));
  }
}

/// The corner of a box in a spike of another's cavity: the spike is before the box's reference plane, and so is V0, but
/// not V'1, V'2, V'3.
void write_spike()
{
  const double base = 0x1p-6, s = 0.25 + 4 * base;
  const auto spike =
      scenes::tetrahedron({0.25, 0.25, 0.25}, {2 * base, base, base}, {base, 2 * base, base}, {base, base, 2 * base});
  const auto around = scenes::with_cavity(scenes::moved(scenes::cube(30), 1, {-s / 8, -s / 8, -s / 8}), spike);
  write(scenes::box({-1.875, -1.875, -1.875}, {0.125, 0.125, 0.125}), around, Pose(), Pose());
}

/// Bodies and poses of any exponents, where bounds overflow.
void write_wild(Random& random)
{
  constexpr double exponents[] = {30, 150, 500, 960, 960};
  for (int run = 0; run < 200; ++run)
    for (const Object_case& c : object_family::wild_run(random, exponents[run % 5], 4))
      write(*c.a, *c.b, c.pose_a, c.pose_b);
}

/// Bodies with equal vertices under poses that differ by an ulp; and nearly flat tetrahedra with p as a corner, under
/// one pose.
void write_near(Random& random)
{
  for (int round = 0; round < 200; ++round) {
    Predicate_case c;
    for (Vertex& v : c.v)
      for (double& coordinate : v) coordinate = random.symmetric();
    std::array<double, 12> entries;
    for (double& entry : entries) entry = random.symmetric();
    c.pose_a = Pose(entries);
    if (round % 2 == 0) {
      double& entry = entries[one_of(random, 12)];
      entry = std::nextafter(entry, 2);
    } else {
      const double s = random.unit(), t = random.unit();
      for (int k = 0; k < 3; ++k) c.v[3][k] = c.v[0][k] + s * (c.v[1][k] - c.v[0][k]) + t * (c.v[2][k] - c.v[0][k]);
    }
    c.pose_b = Pose(entries);
    c.p = c.v[1];
    c.q = c.v[2];
    c.r = c.v[3];
    if (c.pose_a.determinant_sign() != CGAL::ZERO && c.pose_b.determinant_sign() != CGAL::ZERO) write(c);
  }
}

}  // namespace

/// Usage: cases PREDICATE_CASES OBJECT_CASES, the numbers of cases of each family.
int main(int argc, char** argv)
{
  const int predicate_cases = argc > 1 ? std::atoi(argv[1]) : 10, object_cases = argc > 2 ? std::atoi(argv[2]) : 2;
  Random random(7);
  write_touching(random);
  write_one_shell_inside();
  write_spike();
  write_near(random);
  write_wild(random);
  for (const Family& family : families()) {
    for (int k = 0; k < predicate_cases; ++k) write(family.predicate_case(3, k));
    for (int k = 0; k < object_cases; ++k) {
      const Object_case c = family.object_case(3, k);
      write(*c.a, *c.b, c.pose_a, c.pose_b);
    }
  }
}
