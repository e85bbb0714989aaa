#include "experiments/queries/touching.h"

#include "experiments/peers/peer.h"
#include "experiments/support/csv_row.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <functional>
#include <map>
#include <utility>

namespace tetracone::experiments {
namespace {

using Numbers = std::array<int, 3>;  // quarters of a unit

/// Two boxes and where the corner of B is from that of A.
struct Boxes {
  Numbers size_a, size_b, offset;
};

/// A kind of pair, whose relation is known.
struct Kind {
  std::string name;
  Solid_relation relation;
  std::function<Boxes(verify::Random&)> make;
};

Numbers sizes(verify::Random& random, int least)
{
  return {verify::object_family::integer(random, least, 8), verify::object_family::integer(random, least, 8),
          verify::object_family::integer(random, least, 8)};
}

/// Boxes side by side along the first `count` axes. Along the others they overlap.
Boxes side_by_side(verify::Random& random, std::size_t count)
{
  Boxes boxes{sizes(random, 1), sizes(random, 1), {}};
  for (std::size_t k = 0; k < 3; ++k)
    boxes.offset[k] =
        k < count ? boxes.size_a[k] : verify::object_family::integer(random, 1 - boxes.size_b[k], boxes.size_a[k] - 1);
  return boxes;
}

const std::vector<Kind>& kinds()
{
  static const std::vector<Kind> all = {
      {"faces touch", Solid_relation::meet, [](verify::Random& random) { return side_by_side(random, 1); }},
      {"edges touch", Solid_relation::meet, [](verify::Random& random) { return side_by_side(random, 2); }},
      {"corners touch", Solid_relation::meet, [](verify::Random& random) { return side_by_side(random, 3); }},
      {"aligned overlap", Solid_relation::overlap,
       [](verify::Random& random) {
         const Numbers size = sizes(random, 2);
         return Boxes{size, size, {verify::object_family::integer(random, 1, size[0] - 1), 0, 0}};
       }},
      {"half overlap", Solid_relation::overlap,
       [](verify::Random& random) {
         const Numbers half = sizes(random, 1), size = {2 * half[0], 2 * half[1], 2 * half[2]};
         return Boxes{size, size, half};
       }},
      {"equal", Solid_relation::equal,
       [](verify::Random& random) {
         const Numbers size = sizes(random, 1);
         return Boxes{size, size, {0, 0, 0}};
       }},
      {"inside", Solid_relation::contains,
       [](verify::Random& random) {
         const Numbers size = sizes(random, 3);
         return Boxes{size, {size[0] - 2, size[1] - 2, size[2] - 2}, {1, 1, 1}};
       }},
  };
  return all;
}

/// The poses of both boxes in a frame of the axes, or of one that is turned.
std::pair<kernel::Pose, kernel::Pose> poses(const Numbers& offset, bool is_turned, verify::Random& random)
{
  const kernel::Pose turn = is_turned ? verify::object_family::double_rotation(random) : kernel::Pose();
  std::array<double, 12> a{}, b{};
  for (std::size_t i = 0; i < 3; ++i) {
    a[4 * i + 3] = b[4 * i + 3] = std::ldexp(verify::object_family::integer(random, -1'000'000, 1'000'000), -20);
    for (std::size_t k = 0; k < 3; ++k) {
      a[4 * i + k] = b[4 * i + k] = std::ldexp(std::round(std::ldexp(turn[int(4 * i + k)], 40)), -40);
      b[4 * i + 3] += a[4 * i + k] * offset[k] / 4;  // exact: multiples of 2^-42 below 2^5
    }
  }
  return {kernel::Pose(a), kernel::Pose(b)};
}

covering::Polyhedron box_of(const Numbers& size)
{
  return verify::box({0, 0, 0}, {size[0] / 4.0, size[1] / 4.0, size[2] / 4.0});
}

}  // namespace

std::string touching_csv(int cases, std::uint64_t seed)
{
  Csv_table table;
  verify::Random random(seed);
  for (const Kind& kind : kinds())
    for (const bool is_turned : {false, true}) {
      int wrong_relations = 0;
      std::map<std::string, std::pair<int, int>> said;  // by peer: asked, and said to collide
      for (int k = 0; k < cases; ++k) {
        const Boxes boxes = kind.make(random);
        const auto [pose_a, pose_b] = poses(boxes.offset, is_turned, random);
        const covering::Polyhedron a = box_of(boxes.size_a), b = box_of(boxes.size_b);
        Query query{Body(a), Body(b)};
        wrong_relations += query.solid_relation(pose_a, pose_b).relation != kind.relation;
        const Peer_mesh mesh_a = *peer_mesh(a), mesh_b = *peer_mesh(b);
        for (const Peer& peer : peers()) {
          const auto pair = peer.prepare(mesh_a, mesh_b);
          if (!pair) continue;
          ++said[peer.name].first;
          const kernel::Question question =
              peer.knows == verify::Knows::surfaces ? kernel::Question::surface : kernel::Question::solid;
          said[peer.name].second += pair->collide(pose_a, pose_b, question);
        }
      }
      for (const auto& [peer, counts] : said)
        table.add(Csv_row()
                      .add("kind", kind.name)
                      .add("relation", std::string(to_string(kind.relation)))
                      .add("frame", is_turned ? "turned" : "axes")
                      .add("wrong_relations", wrong_relations)
                      .add("peer", peer)
                      .add("asked", counts.first)
                      .add("collide", counts.second)
                      .add_origin(seed));
    }
  return table.text();
}

}  // namespace tetracone::experiments
