#include "verify/cases/object_placing.h"
#include "verify/families/object_corpus.h"
#include "verify/families/object_families.h"

#include "verify/cases/shape_generators.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tetracone::verify::object_family {
namespace {

using kernel::Vertex;

Touching any_separated(Random& random)
{
  for (;;) {
    const Touching contact = any_contact(random, any_turn(random));
    if (contact.separated) return contact;
  }
}

/// Plates, a ledge and a notch that other bodies are swept to, with the place, the way out, and what comes.
struct Scene {
  Shape still;
  std::vector<Exact_vector> places;
  Exact_vector out;
  std::vector<Shape> coming;
};

Body notched(double half, double depth)
{
  // A block whose top has a wedge-shaped notch along y.
  covering::Polyhedron result;
  const std::vector<std::array<double, 2>> outline = {{-2, -1},       {2, -1},    {2, 1}, {half, 1},
                                                      {0, 1 - depth}, {-half, 1}, {-2, 1}};
  const Index n = outline.size();
  for (const double y : {1.0, -1.0})
    for (const auto& [x, z] : outline) result.vertices.push_back({x, y, z});
  std::vector<Index> front, back;
  for (Index k = 0; k < n; ++k) {
    back.push_back(n - 1 - k);
    front.push_back(n + k);
    result.add_polygon({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  result.add_polygon(front);
  result.add_polygon(back);
  return shared(std::move(result));
}

/// Two boxes side by side, a slot of the given width between them; width 0: an inner edge.
Body slotted(double width)
{
  covering::Polyhedron result = box({-2, -1, -1}, {-width / 2, 1, 0});
  const covering::Polyhedron other = box({width / 2, -1, -1}, {2, 1, 0});
  for (const Vertex& v : other.vertices) result.vertices.push_back(v);
  for (Index f = 0; f < other.face_count(); ++f) {
    std::vector<Index> loop;
    for (const Index v : other.loop(f, 0)) loop.push_back(8 + v);
    result.add_polygon(loop);
  }
  return shared(std::move(result));
}

const std::vector<Scene>& scenes()
{
  static const std::vector<Scene> all = [] {
    const auto boxed = [](const Vertex& low, const Vertex& high) { return Shape(shared(box(low, high))); };
    const Shape spike(tetrahedron({Vertex{0, 0, 0}, {0.125, 0, 2}, {-0.0625, 0.125, 2}, {-0.0625, -0.125, 2}}));
    const Shape thin(tetrahedron({Vertex{0, 0, 0}, {0x1p-10, 0, 2}, {-0x1p-10, 0x1p-10, 2}, {-0x1p-10, -0x1p-10, 2}}));
    const Shape wedge = blocks()[roof_block], plate = boxed({-0.0625, -0.5, 0}, {0.0625, 0.5, 1}),
                cube = boxed({-0.5, -0.5, 0}, {0.5, 0.5, 1});
    const Exact_vector up = {0, 0, 1}, top = {0, 0, 1};
    std::vector<Scene> scenes;
    scenes.push_back(
        {boxed({-1, -1, 0}, {1, 1, 1}), {top, {0, Rational(1) / 4, 1}, {1, 1, 1}, {1, 0, 1}}, up, {spike, thin}});
    scenes.push_back({Shape(notched(0.5, 0.5)),
                      {{0, 0, Rational(1) / 2}, {0, 0, 1}, {Rational(1) / 4, 0, Rational(3) / 4}},
                      up,
                      {wedge, spike, plate}});
    scenes.push_back(
        {Shape(slotted(0.125)), {{0, 0, -1}, {0, 0, Rational(-1) / 2}, {0, 0, 0}}, {1, 0, 0}, {plate, thin}});
    scenes.push_back({boxed({-1, -1, -1}, {0, 1, 0}),
                      {{Rational(1) / 2, 0, 0}, {Rational(1) / 2, Rational(3) / 2, -1}, {Rational(1) / 2, 0, -1}},
                      {1, 0, 0},
                      {cube}});
    scenes.push_back(
        {Shape(slotted(0)), {{0, 0, 0}, {Rational(1) / 4, 0, 0}, {Rational(1) / 2, 1, 0}}, up, {cube, spike, wedge}});
    return scenes;
  }();
  return all;
}

}  // namespace

/// B moves along a path, and `parameter` bisections, each rounded to double, narrow the interval from free to
/// colliding. The case is the last free position or the first colliding one. A plane between the bodies tells on which
/// side it is.
Object_case swept_contact(Random& random, double parameter)
{
  const Touching contact = any_separated(random);
  std::array<double, 3> way;
  Rational speed = 0;
  for (double outward = 0; outward <= 0.05 || speed <= 0;) {
    const Vector direction = random.direction();
    way = {direction[0], direction[1], direction[2]};
    outward = 0;
    speed = 0;
    const Exact_vector unit = scaled_to_one(contact.apart);
    for (int i = 0; i < 3; ++i) speed += Rational(way[i]) * unit[i];
    outward = kernel::nearest_double(speed);
  }
  // From before the contact to behind it; the pose's doubles are rounded as a sweep's are.
  const auto at = [&](double s) {
    std::array<double, 12> entries = contact.relative.entries();
    for (int i = 0; i < 3; ++i) entries[4 * i + 3] += s * way[i];
    return Pose(entries);
  };
  const Index touching = lowest(contact.b->vertices, pulled_back(contact.relative, contact.apart))[0];
  const Rational height = dot(contact.apart, image(contact.relative, exact(contact.b->vertices[touching])));
  const auto free = [&](double s) {
    const Pose pose = at(s);
    const Index low = lowest(contact.b->vertices, pulled_back(pose, contact.apart))[0];
    return dot(contact.apart, image(pose, exact(contact.b->vertices[low]))) > height;
  };
  double out = 0.25, in = -0.125 * (1 + random.unit());
  for (int k = 0; k < parameter; ++k) {
    const double between = in + (out - in) / 2;
    if (between == in || between == out) break;
    (free(between) ? out : in) = between;
  }
  const bool last_free = random.bits() % 2 == 0;
  const Motion kind = random.bits() % 3 == 0 ? Motion::permutation : Motion::identity;
  const Object_case c = placed(random, contact.a, contact.b, at(last_free ? out : in), kind);
  return last_free ? with_answer(c, false) : c;
}

/// The ends of sweeps: exactly at the contact, slightly before it or behind it, or at the sweep's start.
Object_case swept_primitives(Random& random, double parameter)
{
  const Scene& scene = scenes()[static_cast<int>(parameter)];
  const Shape& coming = scene.coming[random.bits() % scene.coming.size()];
  const Exact_vector place = scene.places[random.bits() % scene.places.size()];
  const Rational distance = random.bits() % 6 == 0 ? Rational(2) : any_gap(random);
  const Exact_vector shift = sum(place, distance, scene.out);
  Pose turn;
  if (random.bits() % 4 == 0) turn = scaling(-1, random.bits() % 2 == 0 ? 1 : -1, 1);
  return placed(random, scene.still.body, coming.body, moved(turn, shift), exact_motion(random));
}

/// Changes one coordinate of an entry by some ulps and turns its bodies as a whole; sometimes B is slightly aside.
Object_case corpus(Random& random, double parameter)
{
  Corpus_entry entry = object_corpus()[random.bits() % object_corpus().size()];
  kernel::Vertex& changed = entry.b[random.bits() % 4];
  double& x = changed[random.bits() % 3];
  const bool up = random.bits() % 2 == 0;
  for (int k = 0; k < parameter; ++k) x = std::nextafter(x, up ? HUGE_VAL : -HUGE_VAL);
  Exact_vector aside = {0, 0, 0};
  if (random.bits() % 3 == 0) {
    aside = integer_direction(random, 1);
    aside = times(power_of_two(-integer(random, 30, 60)), aside);
  }
  return placed(random, tetrahedron(entry.a), tetrahedron(entry.b), moved(Pose(), aside), exact_motion(random));
}

}  // namespace tetracone::verify::object_family
