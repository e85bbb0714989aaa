#include "experiments/peers/peer_tables.h"
#include "tetracone/kernel/predicate/kernels.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>

#include <utility>

namespace tetracone::experiments {
namespace {

template <class K>
using Mesh = CGAL::Surface_mesh<typename K::Point_3>;

template <class K>
std::optional<Mesh<K>> surface_mesh(const Peer_mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if (!PMP::is_polygon_soup_a_polygon_mesh(mesh.triangles)) return std::nullopt;
  std::vector<typename K::Point_3> points;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
  Mesh<K> result;
  PMP::polygon_soup_to_polygon_mesh(points, mesh.triangles, result);
  return result;
}

template <class K>
class Cgal_pair : public Prepared_pair {
 public:
  Cgal_pair(Mesh<K> a, Mesh<K> b)
      : a_(std::move(a)), b_(std::move(b)), id_a_(collision_.add_mesh(a_)), id_b_(collision_.add_mesh(b_))
  {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) override
  {
    collision_.set_transformation(id_a_, transformation(pose_a));
    collision_.set_transformation(id_b_, transformation(pose_b));
    if (question == kernel::Question::surface) return !collision_.get_all_intersections(id_a_).empty();
    return !collision_.get_all_intersections_and_inclusions(id_a_).empty();
  }

 private:
  static CGAL::Aff_transformation_3<K> transformation(const kernel::Pose& m)
  {
    return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]};
  }

  Mesh<K> a_, b_;  // the collision points to them
  CGAL::Rigid_triangle_mesh_collision_detection<Mesh<K>> collision_;
  std::size_t id_a_, id_b_;
};

/// Returns null unless both meshes are manifold.
template <class K>
std::unique_ptr<Prepared_pair> prepare(const Peer_mesh& a, const Peer_mesh& b)
{
  auto mesh_a = surface_mesh<K>(a), mesh_b = surface_mesh<K>(b);
  if (!mesh_a || !mesh_b) return nullptr;
  return std::make_unique<Cgal_pair<K>>(std::move(*mesh_a), std::move(*mesh_b));
}

}  // namespace

void add_cgal(Peer_tables& tables)
{
  tables.pairs.push_back({"CGAL RMCD EPICK",
                          "CGAL, Rigid_triangle_mesh_collision_detection: manifold meshes; surfaces, and solids by "
                          "inclusion; exact predicates on points that the motion has rounded",
                          verify::Knows::both, prepare<kernel::Epick>});
  tables.pairs.push_back({"CGAL RMCD EPECK",
                          "CGAL, Rigid_triangle_mesh_collision_detection: manifold meshes; surfaces, and solids by "
                          "inclusion; exact for a pose of doubles",
                          verify::Knows::both, prepare<kernel::Epeck>});
}

}  // namespace tetracone::experiments
