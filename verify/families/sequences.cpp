#include "verify/families/sequences.h"

#include "verify/cases/object_placing.h"
#include "verify/cases/shape_generators.h"

#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

namespace tetracone::verify {
namespace {

using namespace object_family;

/// B's pose in frame k, in A's frame.
using Track = std::function<Pose(int k)>;

/// A motion before it is turned, with the answers that hold in every frame, if any.
struct Motion_of_two {
  std::string name;
  Body a, b;
  Track track;
  std::optional<bool> surface, solid;
  std::optional<int> changes;
};

/// Returns the fraction of a path in frame k of `frames`: a multiple of a power of two in [0, 1].
double share(int k, int frames)
{
  double step = 1;
  while (step * (frames - 1) > 1) step /= 2;
  return k * step;
}

Pose at(const Exact_vector& t) { return moved(Pose(), t); }
Exact_vector vector(double x, double y, double z) { return {Rational(x), Rational(y), Rational(z)}; }

const Shape& block(std::size_t k) { return blocks()[k]; }

Body a_box(const kernel::Vertex& low, const kernel::Vertex& high) { return shared(box(low, high)); }

/// Returns the pose in which B stands, after `turn`, with its lowest face, edge or vertex on the point of the plane z =
/// height.
Pose standing(const Body& b, const Pose& turn, const Exact_vector& point)
{
  return resting(*b, turn, point, vector(0, 0, 1));
}

/// Faces, edges and vertices along a face, an edge, a mesh's vertex.
std::vector<Motion_of_two> slidings(Random& random, int frames)
{
  const Body floor = a_box({-2, -2, -1}, {2, 2, 0});
  std::vector<Motion_of_two> list;
  const auto touching = [&](const std::string& name, const Body& a, const Body& b, const Track& track) {
    list.push_back({name, a, b, track, true, true, 0});
  };
  const auto along_floor = [frames](int k) { return vector(-1 + 2 * share(k, frames), 0.5 - share(k, frames) / 2, 0); };

  // Bodies that stand on the floor: the lowest face, edge or vertex is on the plane in every frame, and never beyond
  // the floor's border.
  const Pose tilted = Pose::from_quaternion(2, 1, 0, 0),
             any = composed(Pose::from_quaternion(3, 1, -1, 1), rational_rotation(random, 3));
  for (const auto& [body, what] : {std::pair<std::size_t, const char*>{unit_cube_block, "cube"},
                                   {tunnel_block, "block with a tunnel"},
                                   {complex_block, "wedge with tunnels"}})
    for (const auto& [turn, lowest_part] : {std::pair{Pose(), "face"}, {tilted, "edge"}, {any, "vertex"}}) {
      const Body b = block(body).body;
      const Pose start = standing(b, turn, vector(0, 0, 0));
      touching(std::string(what) + " sliding on a floor, lowest " + lowest_part + " first", floor, b,
               [=](int k) { return moved(start, along_floor(k)); });
    }
  const Body mesh = meshes()[2].body;
  const Pose on_vertex = standing(mesh, rational_rotation(random, 4), vector(0, 0, 0));
  touching("mesh sliding on a floor on its lowest vertex", floor, mesh,
           [=](int k) { return moved(on_vertex, along_floor(k)); });

  // On a hollow top: a plate that is wider than the tunnel.
  const Body plate = a_box({-0.375, -0.375, 0}, {0.375, 0.375, 0.125}), tunnelled = block(tunnel_block).body;
  touching("plate sliding over the mouth of a tunnel", tunnelled, plate,
           [=](int k) { return at(vector(-0.25 + share(k, frames) / 2, 0, 0.375)); });

  // A vertex along an edge, a vertex through a vertex, an edge along its own line.
  const Body cube = block(unit_cube_block).body, tetrahedron_body = block(tetrahedron_block).body;
  const Exact_vector ridge_normal = vector(1, 0, 1);
  for (const auto& [body, what] : {std::pair<Body, const char*>{tetrahedron_body, "tetrahedron"}, {mesh, "mesh"}}) {
    const Pose start = resting(*body, rational_rotation(random, 4), vector(1, 0, 1), ridge_normal);
    touching(std::string("vertex of a ") + what + " along a cube's edge", cube, body,
             [=](int k) { return moved(start, vector(0, share(k, frames), 0)); });
  }
  // Half a turn about y puts the cube's edge through (0, y, 0) on its own line, B beyond it.
  const Pose half_turn = moved(scaling(-1, 1, -1), vector(2, 0, 2));
  touching("cube's edge along another's", cube, cube,
           [=](int k) { return moved(half_turn, vector(0, -1 + share(k, frames) * 2, 0)); });
  touching("face along a face, past its edge", cube, cube,
           [=](int k) { return moved(at(vector(1, 0, 0)), vector(0, -1 + share(k, frames) * 2, 0)); });
  return list;
}

/// Over an edge by a quarter turn in rational steps: tan of half the angle is k / n.
Pose tipped(int k, int n, const Exact_vector& edge)
{
  const Pose turn = Pose::from_quaternion(n, 0, k, 0);
  return moved(turn, difference(edge, image(turn, edge)));
}

std::vector<Motion_of_two> rollings(int frames)
{
  const Body floor = a_box({-1, -2, -1}, {4, 2, 0});
  std::vector<Motion_of_two> list;
  const auto rolling = [&](const std::string& name, const Body& b, double width, double height) {
    // A quarter turn about its right lower edge, then about the next one: the lower corners at x = 0, width, width +
    // height.
    const int n = (frames + 1) / 2;
    const auto track = [=](int k) {
      const Pose first = tipped(std::min(k, n), n, vector(width, 0, 0));
      return k <= n ? first : composed(tipped(k - n, n, vector(width + height, 0, 0)), first);
    };
    list.push_back({name, floor, b, track, true, true, 0});
  };
  rolling("cube rolling", block(unit_cube_block).body, 1, 1);
  rolling("L rolling", block(5).body, 1, 0.5);
  covering::Polyhedron hollow = *block(tunnel_block).body;
  for (kernel::Vertex& v : hollow.vertices) v = {v[0] + 0.5, v[1], v[2] + 0.375};
  rolling("block with a tunnel rolling", shared(std::move(hollow)), 1, 0.75);
  return list;
}

/// Passages through contact from free to deep, where the answer changes once; and past each other an ulp away, where it
/// never changes.
std::vector<Motion_of_two> passages(Random& random, int frames)
{
  const Body cube = block(unit_cube_block).body;
  std::vector<Motion_of_two> list;
  const int middle = frames / 2;
  const auto through = [&](const std::string& name, const Touching& contact) {
    // Touching exactly in the middle frame; one step is 2^-20 of a length of about one.
    const Exact_vector step = times(power_of_two(-20), scaled_to_one(contact.apart));
    list.push_back({name,
                    contact.a,
                    contact.b,
                    [=](int k) { return moved(contact.relative, times(Rational(middle - k), step)); },
                    {},
                    {},
                    1});
  };
  through("corner down into a face", vertex_on_face(random, block(unit_cube_block), block(tetrahedron_block).body,
                                                    rational_rotation(random, 4), 3));
  Touching crossing;
  while (!crossing.separated)
    crossing = edge_across_edge(random, block(unit_cube_block), block(3), rational_rotation(random, 4), 2);
  through("edge down onto an edge", crossing);
  const Exact_vector up = vector(0, 0, 1);
  through("face down onto a face", {cube, cube, at(vector(0.25, 0.25, 1)), up, true});
  through("arrowhead down onto a block with a tunnel",
          {block(tunnel_block).body, block(6).body, standing(block(6).body, Pose(), vector(0, -0.5, 0.375)), up, true});
  through("mesh down onto a face",
          {cube, meshes()[2].body, standing(meshes()[2].body, rational_rotation(random, 4), vector(0.5, 0.5, 1)), up,
           true});

  const double ulp = std::nextafter(1.0, 2.0) - 1;
  for (const double gap : {ulp, -ulp}) {
    const bool meet = gap < 0;
    const std::string by = meet ? " an ulp in" : " an ulp away";
    list.push_back({"cube sliding on a cube," + by, cube, cube,
                    [=](int k) { return at(vector(-0.75 + 1.5 * share(k, frames), 0.25, 1 + gap)); }, meet, meet, 0});
    list.push_back({"tunnel sliding on a tunnel," + by, block(tunnel_block).body, block(tunnel_block).body,
                    [=](int k) { return moved(scaling(1, 1, -1), vector(-0.5 + share(k, frames), 0.125, 0.75 + gap)); },
                    meet, meet, 0});
  }
  return list;
}

/// Bodies in a cavity and in a tunnel: along the wall, an ulp off it, and of exactly the tunnel's width.
std::vector<Motion_of_two> enclosures(Random& random, int frames)
{
  std::vector<Motion_of_two> list;
  const Body cavity = block(cavity_block).body, tunnelled = block(tunnel_block).body, pebble = pebbles()[4].body;
  const double hair = 0x1p-50;
  const Pose turn = rational_rotation(random, 4);
  for (const auto& [gap, how] : {std::pair{0.0, "along its wall"}, {hair, "a hair off its wall"}}) {
    const bool meet = gap == 0;
    const Pose start = standing(pebble, turn, vector(-0.25, 0, -0.5 + gap));
    list.push_back({std::string("L in a cavity, ") + how, cavity, pebble,
                    [=](int k) { return moved(start, vector(share(k, frames) / 2, 0, 0)); }, meet, meet, 0});
    // The tunnel is [-1/4, 1/4]^2 wide.
    const double half = 0.25 - gap;
    const Body peg = a_box({-half, -half, -0.25}, {half, half, 0.25});
    list.push_back({std::string("peg in a tunnel, ") + how, tunnelled, peg,
                    [=](int k) { return at(vector(0, 0, -1.5 + 3 * share(k, frames))); },
                    meet ? std::optional<bool>() : false, meet ? std::optional<bool>() : false,
                    meet ? std::optional<int>() : 0});
    // In the solid, under its top.
    const Pose under = resting(*pebble, turn, vector(-0.25, 0, 1 - 0.0625 - gap), vector(0, 0, -1));
    list.push_back({std::string("L in a solid under its top, ") + how, a_box({-1, -1, -1}, {1, 1, 1 - 0.0625}), pebble,
                    [=](int k) { return moved(under, vector(share(k, frames) / 2, 0, 0)); }, meet, true, 0});
  }
  return list;
}

Sequence frames_of(const Motion_of_two& motion, const Pose& common, const std::string& how, std::uint64_t seed,
                   int frames)
{
  Sequence sequence{motion.name + how, {}, motion.changes};
  for (int k = 0; k < frames; ++k) {
    Object_case c{motion.a, motion.b, common, composed(common, motion.track(k)), {}, motion.surface, motion.solid};
    c.origin = {sequence.name, seed, std::uint64_t(k), 0};
    sequence.frames.push_back(std::move(c));
  }
  return sequence;
}

}  // namespace

std::vector<Sequence> sequences(std::uint64_t seed, int frames)
{
  assert(frames >= 3);
  Random random(seed);
  std::vector<Motion_of_two> motions;
  for (auto&& group :
       {slidings(random, frames), rollings(frames), passages(random, frames), enclosures(random, frames)})
    motions.insert(motions.end(), group.begin(), group.end());
  std::vector<Sequence> result;
  for (const Motion_of_two& motion : motions) {
    result.push_back(frames_of(motion, Pose(), "", seed, frames));
    const Pose rotation = rational_rotation(random, 6);
    const Exact_vector shift = times(Rational(1) / 3, integer_direction(random, 9));
    result.push_back(frames_of(motion, moved(rotation, shift), ", turned", seed, frames));
  }
  return result;
}

}  // namespace tetracone::verify
