#include "experiments/peers/scene_peer.h"

#ifdef TETRACONE_WITH_FCL
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#endif

namespace tetracone::experiments {

std::vector<Scene_library> scene_libraries()
{
  std::vector<Scene_library> all;
#ifdef TETRACONE_WITH_FCL
  all.push_back({"FCL dynamic AABB tree", prepare_fcl_scene});
#endif
#ifdef TETRACONE_WITH_BULLET
  all.push_back({"Bullet Dbvt and GImpact", prepare_bullet_scene});
#endif
#ifdef TETRACONE_WITH_ODE
  all.push_back({"ODE hash space", prepare_ode_scene});
#endif
  return all;
}

#ifdef TETRACONE_WITH_FCL
namespace {

using Volume = fcl::OBBRSSd;

class Fcl_scene : public Scene_peer {
 public:
  Fcl_scene(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of)
  {
    std::vector<std::shared_ptr<fcl::BVHModel<Volume>>> models;
    for (const Peer_mesh& mesh : meshes) {
      std::vector<fcl::Vector3d> points;
      for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
      std::vector<fcl::Triangle> triangles;
      for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
      models.push_back(std::make_shared<fcl::BVHModel<Volume>>());
      models.back()->beginModel(int(triangles.size()), int(points.size()));
      models.back()->addSubModel(points, triangles);
      models.back()->endModel();
      models.back()->computeLocalAABB();
    }
    for (std::size_t k = 0; k < of.size(); ++k) {
      objects_.push_back(std::make_unique<fcl::CollisionObjectd>(models[of[k]]));
      objects_.back()->setUserData(reinterpret_cast<void*>(k));
      all_.push_back(objects_.back().get());
    }
  }

  std::vector<Pair> frame(const std::vector<kernel::Pose>& poses) override
  {
    for (std::size_t k = 0; k < poses.size(); ++k) {
      objects_[k]->setTransform(fcl::Transform3d(poses[k].to_eigen().matrix()));
      objects_[k]->computeAABB();
    }
    if (is_first_) {
      manager_.registerObjects(all_);
      manager_.setup();
    } else {
      manager_.update();
    }
    is_first_ = false;
    candidates_ = 0;
    found_.clear();
    manager_.collide(this, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* self) {
      static_cast<Fcl_scene*>(self)->ask(a, b);
      return false;
    });
    return found_;
  }

 private:
  void ask(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b)
  {
    ++candidates_;
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    if (fcl::collide(a, b, request, result) == 0) return;
    const auto number = [](const fcl::CollisionObjectd* o) {
      return std::uint32_t(reinterpret_cast<std::size_t>(o->getUserData()));
    };
    found_.push_back({std::min(number(a), number(b)), std::max(number(a), number(b))});
  }

  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  std::vector<fcl::CollisionObjectd*> all_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  bool is_first_ = true;
  std::vector<Pair> found_;
};

}  // namespace

std::unique_ptr<Scene_peer> prepare_fcl_scene(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of)
{
  return std::make_unique<Fcl_scene>(meshes, of);
}
#endif

}  // namespace tetracone::experiments
