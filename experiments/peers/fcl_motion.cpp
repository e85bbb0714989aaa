#include "experiments/peers/fcl_motion.h"

#ifdef TETRACONE_WITH_FCL
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <array>
#include <vector>
#endif

namespace tetracone::experiments {

#ifdef TETRACONE_WITH_FCL
namespace {

class Fcl_motion : public Motion_peer {
 public:
  Fcl_motion(const Peer_mesh& a, const Peer_mesh& b, fcl::CCDSolverType solver) : a_(model(a)), b_(model(b))
  {
    request_.ccd_solver_type = solver;
  }

  std::optional<double> first_contact(const kernel::Pose& from, const kernel::Pose& to) override
  {
    const fcl::Transform3d still = fcl::Transform3d::Identity();
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(a_.get(), still, still, b_.get(), fcl::Transform3d(from.to_eigen().matrix()),
                                   fcl::Transform3d(to.to_eigen().matrix()), request_, result);
    return result.is_collide ? std::optional(result.time_of_contact) : std::nullopt;
  }

 private:
  using Model = fcl::BVHModel<fcl::OBBRSSd>;

  static std::shared_ptr<Model> model(const Peer_mesh& mesh)
  {
    std::vector<fcl::Vector3d> points;
    for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    auto model = std::make_shared<Model>();
    model->beginModel(int(triangles.size()), int(points.size()));
    model->addSubModel(points, triangles);
    model->endModel();
    return model;
  }

  std::shared_ptr<Model> a_, b_;
  fcl::ContinuousCollisionRequestd request_;
};

}  // namespace

std::unique_ptr<Motion_peer> fcl_advancement(const Peer_mesh& a, const Peer_mesh& b)
{
  return std::make_unique<Fcl_motion>(a, b, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
}
std::unique_ptr<Motion_peer> fcl_steps(const Peer_mesh& a, const Peer_mesh& b)
{
  return std::make_unique<Fcl_motion>(a, b, fcl::CCDC_NAIVE);
}

std::span<const Named_motion_peer> motion_peers()
{
  static constexpr std::array all = {
      Named_motion_peer{"FCL advancement",
                        "continuousCollide of surfaces by conservative advancement, until within 1e-4 of the time; "
                        "translations of B alone are asked",
                        fcl_advancement},
      Named_motion_peer{"FCL steps", "continuousCollide of surfaces by ten steps; translations of B alone are asked",
                        fcl_steps}};
  return all;
}

#else

std::unique_ptr<Motion_peer> fcl_advancement(const Peer_mesh&, const Peer_mesh&) { return nullptr; }
std::unique_ptr<Motion_peer> fcl_steps(const Peer_mesh&, const Peer_mesh&) { return nullptr; }
std::span<const Named_motion_peer> motion_peers() { return {}; }

#endif

}  // namespace tetracone::experiments
