#include "experiments/peers/fcl_distance.h"

#ifdef TETRACONE_WITH_FCL
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/distance.h>

#include <vector>
#endif

namespace tetracone::experiments {

#ifdef TETRACONE_WITH_FCL
namespace {

template <class Volume>
class Fcl_distance : public Distance_peer {
 public:
  Fcl_distance(const Peer_mesh& a, const Peer_mesh& b) : a_(model(a)), b_(model(b)) {}

  double distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    const fcl::DistanceRequestd request(false);
    fcl::DistanceResultd result;
    return fcl::distance<double>(a_.get(), fcl::Transform3d(pose_a.to_eigen().matrix()), b_.get(),
                                 fcl::Transform3d(pose_b.to_eigen().matrix()), request, result);
  }

 private:
  static std::shared_ptr<fcl::BVHModel<Volume>> model(const Peer_mesh& mesh)
  {
    std::vector<fcl::Vector3d> points;
    for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    auto model = std::make_shared<fcl::BVHModel<Volume>>();
    model->beginModel(int(triangles.size()), int(points.size()));
    model->addSubModel(points, triangles);
    model->endModel();
    return model;
  }

  std::shared_ptr<fcl::BVHModel<Volume>> a_, b_;
};

}  // namespace

std::unique_ptr<Distance_peer> fcl_obbrss_distance(const Peer_mesh& a, const Peer_mesh& b)
{
  return std::make_unique<Fcl_distance<fcl::OBBRSSd>>(a, b);
}
std::unique_ptr<Distance_peer> fcl_rss_distance(const Peer_mesh& a, const Peer_mesh& b)
{
  return std::make_unique<Fcl_distance<fcl::RSSd>>(a, b);
}

#else

std::unique_ptr<Distance_peer> fcl_obbrss_distance(const Peer_mesh&, const Peer_mesh&) { return nullptr; }
std::unique_ptr<Distance_peer> fcl_rss_distance(const Peer_mesh&, const Peer_mesh&) { return nullptr; }

#endif

}  // namespace tetracone::experiments
