#include "experiments/queries/judged_depths.h"

#include "experiments/peers/depth_peer.h"
#include "experiments/support/csv_row.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <exception>
#include <functional>
#include <utility>

namespace tetracone::experiments {
namespace {

/// A pair of convex bodies and their poses.
struct Convex_pair {
  covering::Polyhedron a, b;
  kernel::Pose pose_a, pose_b;
};

struct Shape {
  std::string name;
  std::function<Convex_pair(verify::Random&)> make;
};

/// Returns a pose, turned at random, of which the translation has at most this length.
kernel::Pose turned(verify::Random& random, double length)
{
  std::array<double, 12> rows = verify::object_family::double_rotation(random).entries();
  const std::array<double, 3> along = random.direction();
  const double way = length * std::abs(random.symmetric());
  for (std::size_t i = 0; i < 3; ++i) rows[4 * i + 3] = way * along[i];
  return kernel::Pose(rows);
}

covering::Polyhedron round_hull(verify::Random& random)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points;
  for (int k = 0; k < 100; ++k) {
    const auto [x, y, z] = random.direction();
    points.emplace_back(x, y, z);
  }
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  covering::Polyhedron polyhedron;
  for (const auto v : hull.vertices()) {
    const Point& p = hull.point(v);
    polyhedron.vertices.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : hull.faces()) {
    std::vector<covering::Index> loop;
    for (const auto v : CGAL::vertices_around_face(hull.halfedge(f), hull)) loop.push_back(covering::Index(v.idx()));
    polyhedron.add_polygon(loop);
  }
  return polyhedron;
}

covering::Polyhedron random_box(verify::Random& random)
{
  const auto size = [&random] { return verify::object_family::integer(random, 1, 8) / 8.0; };
  const double x = size(), y = size(), z = size();
  return verify::box({-x, -y, -z}, {x, y, z});
}

const std::vector<Shape>& shapes()
{
  static const std::vector<Shape> all = {
      {"boxes, turned",
       [](verify::Random& random) {
         return Convex_pair{random_box(random), random_box(random), turned(random, 1), turned(random, 1)};
       }},
      {"boxes, aligned",
       [](verify::Random& random) {
         const auto shift = [&random] { return verify::object_family::integer(random, -8, 8) / 16.0; };
         return Convex_pair{random_box(random), random_box(random), kernel::Pose(),
                            kernel::Pose::translation(shift(), shift(), shift())};
       }},
      {"round",
       [](verify::Random& random) {
         return Convex_pair{round_hull(random), round_hull(random), turned(random, 0), turned(random, 2)};
       }},
  };
  return all;
}

/// The answers of one peer about one shape.
struct Judged {
  int asked = 0, apart = 0, failed = 0, infinite = 0, negative = 0, off_millionth = 0, off_hundredth = 0;
  double sum_off = 0, most_off = 0, ns = 0;

  int above_zero() const { return asked - apart - failed - infinite - negative; }

  void judge(const std::optional<double>& said, double exact)
  {
    if (!said) {
      ++apart;
    } else if (!std::isfinite(*said)) {
      ++infinite;
    } else if (*said <= 0) {
      ++negative;
    } else {
      const double off = std::abs(*said - exact) / exact;
      off_millionth += off > 1e-6;
      off_hundredth += off > 1e-2;
      sum_off += off;
      most_off = std::max(most_off, off);
    }
  }
};

}  // namespace

std::string judged_depths(int pairs, std::uint64_t seed)
{
  Csv_table table;
  verify::Random random(seed);
  for (const Shape& shape : shapes()) {
    std::vector<Judged> judged(depth_peers().size());
    double exact_ns = 0;
    for (int k = 0; k < pairs;) {
      const Convex_pair pair = shape.make(random);
      Query query{Body(pair.a), Body(pair.b)};
      query.solid_relation_alone(pair.pose_a, pair.pose_b);  // what is made on demand is there
      Stopwatch watch;
      const double exact = query.depth(pair.pose_a, pair.pose_b).high, ns = watch.nanoseconds();
      if (exact == 0) continue;
      ++k;
      exact_ns += ns;
      const Peer_mesh mesh_a = *peer_mesh(pair.a), mesh_b = *peer_mesh(pair.b);
      for (std::size_t p = 0; p < judged.size(); ++p) {
        ++judged[p].asked;
        const auto peer = depth_peers()[p].make(mesh_a, mesh_b);
        watch = Stopwatch();
        try {
          const std::optional<double> said = peer->depth(pair.pose_a, pair.pose_b);
          judged[p].ns += watch.nanoseconds();
          judged[p].judge(said, exact);
        } catch (const std::exception&) {
          judged[p].ns += watch.nanoseconds();
          ++judged[p].failed;
        }
      }
    }
    for (std::size_t p = 0; p < judged.size(); ++p) {
      const Judged& each = judged[p];
      const int above_zero = each.above_zero();
      table.add(Csv_row()
                    .add("shape", shape.name)
                    .add("peer", depth_peers()[p].name)
                    .add("pairs", each.asked)
                    .add("apart", each.apart)
                    .add("failed", each.failed)
                    .add("infinite", each.infinite)
                    .add("negative", each.negative)
                    .add("off_millionth", each.off_millionth)
                    .add("off_hundredth", each.off_hundredth)
                    .add("mean_off", above_zero > 0 ? std::optional(each.sum_off / above_zero) : std::nullopt)
                    .add("most_off", each.most_off)
                    .add("ns", each.ns / each.asked)
                    .add("exact_ns", exact_ns / pairs)
                    .add_origin(seed));
    }
  }
  return table.text();
}

}  // namespace tetracone::experiments
