#include "experiments/fcl_peer.h"

#include "covering/repair.h"

#ifdef TETRACONE_WITH_FCL
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#endif

#include <stdexcept>
#include <vector>

namespace tetracone::experiments {

#ifdef TETRACONE_WITH_FCL
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> build(const covering::Polyhedron& polyhedron, double scale)
{
  std::vector<fcl::Vector3d> points;
  for (const auto& v : polyhedron.vertices) points.emplace_back(v[0] * scale, v[1] * scale, v[2] * scale);
  std::vector<fcl::Triangle> triangles;
  for (covering::Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.is_triangle(f)) {
      const auto loop = polyhedron.loop(f, 0);
      triangles.emplace_back(loop[0], loop[1], loop[2]);
      continue;
    }
    const auto parts = covering::repair::constrained_delaunay(polyhedron, f);
    if (!parts) throw std::runtime_error("a face that cannot be triangulated for FCL");
    for (const auto& t : *parts) triangles.emplace_back(t[0], t[1], t[2]);
  }
  auto model = std::make_shared<Model>();
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

class Fcl_pair : public verify::Prepared_pair {
 public:
  Fcl_pair(const covering::Polyhedron& a, const covering::Polyhedron& b, double scale_b)
      : a_(build(a, 1)), b_(build(b, scale_b)), scale_b_(scale_b)
  {
  }

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question) override
  {
    const fcl::CollisionRequestd request(1, false);
    fcl::CollisionResultd result;
    return fcl::collide<double>(a_.get(), transform(pose_a, 1), b_.get(), transform(pose_b, scale_b_), request, result) > 0;
  }
  std::vector<kernel::Feature_pair> features(const kernel::Pose&, const kernel::Pose&) override { return {}; }
  tetratree::Counts take_counts() override { return {}; }
  std::size_t bytes() const override { return a_->memUsage(false) + b_->memUsage(false); }
  std::size_t node_count() const override { return 0; }

 private:
  std::shared_ptr<Model> a_, b_;
  double scale_b_;
};

}  // namespace

std::unique_ptr<verify::Prepared_pair> prepare_fcl(const covering::Polyhedron& a, const covering::Polyhedron& b, double scale_b)
{
  return std::make_unique<Fcl_pair>(a, b, scale_b);
}

#else

std::unique_ptr<verify::Prepared_pair> prepare_fcl(const covering::Polyhedron&, const covering::Polyhedron&, double)
{
  return nullptr;
}

#endif

}  // namespace tetracone::experiments
