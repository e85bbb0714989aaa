#include "experiments/peers/peer.h"

#include "experiments/peers/depth_peer.h"
#include "experiments/peers/scene_peer.h"
#include "verify/subjects/float_input.h"

#include <cmath>
#include <utility>

namespace tetracone::experiments {

std::optional<Peer_mesh> peer_mesh(const covering::Polyhedron& polyhedron)
{
  auto triangles = verify::triangles_of(polyhedron);
  if (!triangles) return std::nullopt;
  Peer_mesh mesh;
  mesh.triangles = std::move(*triangles);
  constexpr covering::Index unused = ~covering::Index{0};
  std::vector<covering::Index> number(polyhedron.vertices.size(), unused);
  for (auto& triangle : mesh.triangles)
    for (covering::Index& corner : triangle) {
      if (number[corner] == unused) {
        number[corner] = static_cast<covering::Index>(mesh.vertices.size());
        mesh.vertices.push_back(polyhedron.vertices[corner]);
      }
      corner = number[corner];
    }
  return mesh;
}

bool is_rigid(const kernel::Pose& pose)
{
  constexpr double tolerance = 1e-9;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      double product = 0;
      for (int k = 0; k < 3; ++k) product += pose[4 * i + k] * pose[4 * j + k];
      if (!(std::abs(product - (i == j)) <= tolerance)) return false;
    }
  return pose.determinant_sign() == CGAL::POSITIVE;
}

const std::vector<Peer>& peers()
{
  static const std::vector<Peer> all = {
#ifdef TETRACONE_WITH_FCL
      {"FCL OBBRSS", "FCL, BVHModel<OBBRSS>, one contact: surfaces only, so a solid inside a solid is missed; double",
       verify::Knows::surfaces, prepare_fcl_obbrss},
      {"FCL AABB", "FCL, BVHModel<AABB>, one contact: surfaces only, so a solid inside a solid is missed; double",
       verify::Knows::surfaces, prepare_fcl_aabb},
#endif
#ifdef TETRACONE_WITH_BULLET
      {"Bullet GImpact",
       "Bullet, GImpact meshes, margin 0: surfaces only, so a solid inside a solid is missed; float, and near counts "
       "as touching",
       verify::Knows::surfaces, prepare_bullet, verify::In_floats::vertices_and_poses},
#endif
#ifdef TETRACONE_WITH_ODE
      {"ODE trimesh",
       "ODE, trimesh against trimesh by OPCODE: surfaces only, so a solid inside a solid is missed; double, and near "
       "counts as touching",
       verify::Knows::surfaces, prepare_ode},
#endif
#ifdef TETRACONE_WITH_CCD
      {"libccd GJK",
       "libccd, ccdGJKIntersect on the vertices, at most 100 iterations: convex solids only; double, with tolerances",
       verify::Knows::solids, prepare_libccd_gjk},
      {"libccd MPR",
       "libccd, ccdMPRIntersect on the vertices, at most 100 iterations: convex solids only; double, with tolerances",
       verify::Knows::solids, prepare_libccd_mpr},
#endif
      {"CGAL RMCD EPICK",
       "CGAL, Rigid_triangle_mesh_collision_detection: manifold meshes; surfaces, and solids by inclusion; exact "
       "predicates on points "
       "that the motion has rounded",
       verify::Knows::both, prepare_cgal_epick},
      {"CGAL RMCD EPECK",
       "CGAL, Rigid_triangle_mesh_collision_detection: manifold meshes; surfaces, and solids by inclusion; exact for a "
       "pose of doubles",
       verify::Knows::both, prepare_cgal_epeck},
  };
  return all;
}

const std::vector<Named_depth_peer>& depth_peers()
{
  static const std::vector<Named_depth_peer> all = {
#ifdef TETRACONE_WITH_FCL
      {"FCL libccd", "FCL, collide of two Convex with contact: the solver of libccd, whose contacts are of MPR",
       fcl_libccd_depth},
      {"FCL own", "FCL, collide of two Convex with contact: its own GJK solver, and EPA", fcl_own_depth},
#endif
#ifdef TETRACONE_WITH_CCD
      {"libccd EPA", "libccd, ccdGJKPenetration on the vertices, at most 100 iterations", libccd_epa_depth},
      {"libccd MPR", "libccd, ccdMPRPenetration on the vertices, at most 100 iterations: no least depth is promised",
       libccd_mpr_depth},
#endif
#ifdef TETRACONE_WITH_BULLET
      {"Bullet", "Bullet, btGjkPairDetector with the EPA solver on two convex hulls, margin 0; float", bullet_depth},
#endif
  };
  return all;
}

std::vector<Scene_library> scene_libraries()
{
  return {
#ifdef TETRACONE_WITH_FCL
      {"FCL dynamic AABB tree", prepare_fcl_scene},
#endif
#ifdef TETRACONE_WITH_BULLET
      {"Bullet Dbvt and GImpact", prepare_bullet_scene},
#endif
#ifdef TETRACONE_WITH_ODE
      {"ODE hash space", prepare_ode_scene},
#endif
  };
}

}  // namespace tetracone::experiments
