#include "experiments/peers/peer_tables.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/predicate/signs.h"

#include <ccd/ccd.h>

namespace tetracone::experiments {
namespace {

using kernel::Adaptive;

/// True when the mesh bounds the convex hull of its vertices. It closes then, and every face has all vertices on its
/// plane or on one side, which is the same for every face. (Then each face is on the hull's boundary, and nothing
/// cancels.) Exact.
bool is_convex(const Peer_mesh& mesh)
{
  if (!covering::repair::boundary_of(mesh.triangles).empty()) return false;
  std::vector<Adaptive::Point_3> points;
  for (const auto& v : mesh.vertices) points.push_back(Adaptive::unmoved(v));
  kernel::Sign inner = kernel::ZERO;
  for (const auto& t : mesh.triangles)
    for (const auto& p : points) {
      const kernel::Sign side = kernel::volume_sign<Adaptive>(points[t[0]], points[t[1]], points[t[2]], p);
      if (side == kernel::ZERO) continue;
      if (inner == kernel::ZERO) inner = side;
      if (side != inner) return false;
    }
  return inner != kernel::ZERO;
}

struct Ccd_body {
  const std::vector<kernel::Vertex> vertices;
  kernel::Vertex middle{0, 0, 0};
  const kernel::Pose* pose = nullptr;

  explicit Ccd_body(const Peer_mesh& mesh) : vertices(mesh.vertices)
  {
    for (const auto& v : vertices)
      for (int k = 0; k < 3; ++k) middle[k] += v[k] / static_cast<double>(vertices.size());
  }

  void image(const kernel::Vertex& v, ccd_vec3_t* out) const
  {
    const auto& m = pose->entries();
    for (int k = 0; k < 3; ++k) out->v[k] = m[4 * k] * v[0] + m[4 * k + 1] * v[1] + m[4 * k + 2] * v[2] + m[4 * k + 3];
  }
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* farthest)
{
  const Ccd_body& body = *static_cast<const Ccd_body*>(object);
  const auto& m = body.pose->entries();
  kernel::Vertex turned;  // the direction in the body's frame
  for (int k = 0; k < 3; ++k)
    turned[k] = m[k] * direction->v[0] + m[4 + k] * direction->v[1] + m[8 + k] * direction->v[2];
  const auto along = [&turned](const kernel::Vertex& v) {
    return turned[0] * v[0] + turned[1] * v[1] + turned[2] * v[2];
  };
  const kernel::Vertex* best = &body.vertices.front();
  for (const auto& v : body.vertices)
    if (along(v) > along(*best)) best = &v;
  body.image(*best, farthest);
}

void center(const void* object, ccd_vec3_t* out)
{
  const Ccd_body& body = *static_cast<const Ccd_body*>(object);
  body.image(body.middle, out);
}

ccd_t settings()
{
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = center;
  ccd.max_iterations = 100;  // as in its documentation
  return ccd;
}

class Libccd_pair : public Prepared_pair {
 public:
  using Intersect = int (*)(const void*, const void*, const ccd_t*);

  Libccd_pair(const Peer_mesh& a, const Peer_mesh& b, Intersect intersect)
      : a_(a), b_(b), intersect_(intersect), ccd_(settings())
  {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question) override
  {
    a_.pose = &pose_a;
    b_.pose = &pose_b;
    return intersect_(&a_, &b_, &ccd_) != 0;
  }

 private:
  Ccd_body a_, b_;
  Intersect intersect_;
  ccd_t ccd_;
};

class Libccd_depth : public Depth_peer {
 public:
  using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

  Libccd_depth(const Peer_mesh& a, const Peer_mesh& b, Penetration penetration)
      : a_(a), b_(b), penetration_(penetration), ccd_(settings())
  {}

  std::optional<double> depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    a_.pose = &pose_a;
    b_.pose = &pose_b;
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    const bool meet = penetration_(&a_, &b_, &ccd_, &depth, &direction, &position) == 0;
    return meet ? std::optional(double(depth)) : std::nullopt;
  }

 private:
  Ccd_body a_, b_;
  Penetration penetration_;
  ccd_t ccd_;
};

/// Returns null unless both meshes are closed and convex.
template <Libccd_pair::Intersect intersect>
std::unique_ptr<Prepared_pair> prepare(const Peer_mesh& a, const Peer_mesh& b)
{
  if (!is_convex(a) || !is_convex(b)) return nullptr;
  return std::make_unique<Libccd_pair>(a, b, intersect);
}

}  // namespace

void add_libccd(Peer_tables& tables)
{
  tables.pairs.push_back({"libccd GJK",
                          "libccd, ccdGJKIntersect on the vertices, at most 100 iterations: convex solids only; "
                          "double, with tolerances",
                          verify::Knows::solids, prepare<ccdGJKIntersect>});
  tables.pairs.push_back({"libccd MPR",
                          "libccd, ccdMPRIntersect on the vertices, at most 100 iterations: convex solids only; "
                          "double, with tolerances",
                          verify::Knows::solids, prepare<ccdMPRIntersect>});
  tables.depths.push_back({"libccd EPA", "libccd, ccdGJKPenetration on the vertices, at most 100 iterations",
                           make_peer<Depth_peer, Libccd_depth, ccdGJKPenetration>});
  tables.depths.push_back(
      {"libccd MPR", "libccd, ccdMPRPenetration on the vertices, at most 100 iterations: no least depth is promised",
       make_peer<Depth_peer, Libccd_depth, ccdMPRPenetration>});
}

}  // namespace tetracone::experiments
