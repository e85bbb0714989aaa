#include "experiments/peers/fcl_peer.h"

#ifdef TETRACONE_WITH_FCL
#include "experiments/peers/peer.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <stdexcept>
#include <utility>
#include <vector>
#endif

namespace tetracone::experiments {

#ifdef TETRACONE_WITH_FCL
namespace {

template <class Volume>
std::shared_ptr<fcl::BVHModel<Volume>> build(const Peer_mesh& mesh, double scale)
{
  std::vector<fcl::Vector3d> points;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0] * scale, v[1] * scale, v[2] * scale);
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<fcl::BVHModel<Volume>>();
  model->beginModel(triangles.size(), points.size());
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform(const kernel::Pose& pose, double scale)
{
  fcl::Transform3d result = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.linear()(i, j) = pose[4 * i + j] / scale;
    result.translation()[i] = pose[4 * i + 3];
  }
  return result;
}

template <class Volume>
class Fcl_pair : public Prepared_pair {
 public:
  Fcl_pair(const Peer_mesh& a, const Peer_mesh& b, double scale_b)
      : a_(build<Volume>(a, 1)), b_(build<Volume>(b, scale_b)), scale_b_(scale_b)
  {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question) override
  {
    const fcl::CollisionRequestd request(1, false);
    fcl::CollisionResultd result;
    return fcl::collide<double>(a_.get(), transform(pose_a, 1), b_.get(), transform(pose_b, scale_b_), request,
                                result) > 0;
  }

  std::size_t bytes() const { return a_->memUsage(false) + b_->memUsage(false); }

 private:
  std::shared_ptr<fcl::BVHModel<Volume>> a_, b_;
  double scale_b_;
};

Peer_mesh mesh_of(const covering::Polyhedron& polyhedron)
{
  auto mesh = peer_mesh(polyhedron);
  if (!mesh) throw std::runtime_error("a face that cannot be triangulated for FCL");
  return std::move(*mesh);
}

/// Says its bytes, which hold FCL's copy of the models too.
class Fcl_pair_with_bytes : public Fcl_pair<fcl::OBBRSSd> {
 public:
  using Fcl_pair::Fcl_pair;

  std::size_t tree_bytes() const override { return bytes(); }
};

}  // namespace

std::unique_ptr<Prepared_pair> prepare_fcl_obbrss(const Peer_mesh& a, const Peer_mesh& b)
{
  return std::make_unique<Fcl_pair<fcl::OBBRSSd>>(a, b, 1);
}

std::unique_ptr<Prepared_pair> prepare_fcl_aabb(const Peer_mesh& a, const Peer_mesh& b)
{
  return std::make_unique<Fcl_pair<fcl::AABBd>>(a, b, 1);
}

std::unique_ptr<Prepared_pair> prepare_fcl(const covering::Polyhedron& a, const covering::Polyhedron& b, double scale_b)
{
  return std::make_unique<Fcl_pair_with_bytes>(mesh_of(a), mesh_of(b), scale_b);
}

#else

std::unique_ptr<Prepared_pair> prepare_fcl(const covering::Polyhedron&, const covering::Polyhedron&, double)
{
  return nullptr;
}

#endif

}  // namespace tetracone::experiments
