#include "experiments/peers/fcl_contacts.h"

#ifdef TETRACONE_WITH_FCL
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <limits>
#endif

namespace tetracone::experiments {

#ifdef TETRACONE_WITH_FCL
namespace {

using Fcl_mesh = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Fcl_mesh> fcl_mesh(const covering::Polyhedron& mesh)
{
  std::vector<fcl::Vector3d> points;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
  std::vector<fcl::Triangle> triangles;
  for (covering::Index f = 0; f < mesh.face_count(); ++f) {
    const covering::Loop t = mesh.loop(f, 0);
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  auto model = std::make_shared<Fcl_mesh>();
  model->beginModel(int(triangles.size()), int(points.size()));
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d fcl_transform(const kernel::Pose& pose)
{
  fcl::Transform3d result = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.linear()(i, j) = pose[4 * i + j];
    result.translation()[i] = pose[4 * i + 3];
  }
  return result;
}

class Fcl_lister : public Fcl_contacts {
 public:
  Fcl_lister(const covering::Polyhedron& a, const covering::Polyhedron& b, bool with_points)
      : a_(fcl_mesh(a)), b_(fcl_mesh(b)), request_(std::numeric_limits<int>::max(), with_points)
  {}

  std::size_t list(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    result_.clear();
    return fcl::collide<double>(a_.get(), fcl_transform(pose_a), b_.get(), fcl_transform(pose_b), request_, result_);
  }
  std::vector<Pair> pairs() const override
  {
    std::vector<Pair> pairs;
    for (std::size_t k = 0; k < result_.numContacts(); ++k)
      pairs.push_back({covering::Index(result_.getContact(k).b1), covering::Index(result_.getContact(k).b2)});
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

 private:
  std::shared_ptr<Fcl_mesh> a_, b_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

}  // namespace

std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                                   bool with_points)
{
  return std::make_unique<Fcl_lister>(a, b, with_points);
}

#else

std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const covering::Polyhedron&, const covering::Polyhedron&, bool)
{
  return nullptr;
}

#endif

}  // namespace tetracone::experiments
