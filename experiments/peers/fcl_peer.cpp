#include "experiments/peers/peer_tables.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>

namespace tetracone::experiments {
namespace {

template <class Volume>
using Model = std::shared_ptr<fcl::BVHModel<Volume>>;

template <class Volume>
Model<Volume> model_of(const Peer_mesh& mesh, double scale = 1)
{
  std::vector<fcl::Vector3d> points;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0] * scale, v[1] * scale, v[2] * scale);
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<fcl::BVHModel<Volume>>();
  model->beginModel(int(triangles.size()), int(points.size()));
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform(const kernel::Pose& pose, double scale = 1)
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
  Fcl_pair(const Peer_mesh& a, const Peer_mesh& b, double scale_b = 1, bool tells_bytes = false)
      : a_(model_of<Volume>(a)), b_(model_of<Volume>(b, scale_b)), scale_b_(scale_b), tells_bytes_(tells_bytes)
  {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question) override
  {
    const fcl::CollisionRequestd request(1, false);
    fcl::CollisionResultd result;
    return fcl::collide<double>(a_.get(), transform(pose_a), b_.get(), transform(pose_b, scale_b_), request, result) >
           0;
  }

  /// FCL's copy of the models included.
  std::size_t tree_bytes() const override { return tells_bytes_ ? a_->memUsage(false) + b_->memUsage(false) : 0; }

 private:
  Model<Volume> a_, b_;
  double scale_b_;
  bool tells_bytes_;
};

Peer_mesh mesh_of(const covering::Polyhedron& polyhedron)
{
  auto mesh = peer_mesh(polyhedron);
  if (!mesh) throw std::runtime_error("a face that cannot be triangulated for FCL");
  return std::move(*mesh);
}

class Fcl_lister : public Fcl_contacts {
 public:
  Fcl_lister(const Peer_mesh& a, const Peer_mesh& b, bool with_points)
      : a_(model_of<fcl::OBBRSSd>(a)),
        b_(model_of<fcl::OBBRSSd>(b)),
        request_(std::numeric_limits<int>::max(), with_points)
  {}

  std::size_t list(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    result_.clear();
    return fcl::collide<double>(a_.get(), transform(pose_a), b_.get(), transform(pose_b), request_, result_);
  }
  std::vector<Pair> pairs() const override
  {
    std::vector<Pair> pairs;
    for (std::size_t k = 0; k < result_.numContacts(); ++k)
      pairs.push_back({covering::Index(result_.getContact(k).b1), covering::Index(result_.getContact(k).b2)});
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

 private:
  Model<fcl::OBBRSSd> a_, b_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

/// The triangles as they are: their numbers are told.
Peer_mesh as_it_is(const covering::Polyhedron& triangles)
{
  Peer_mesh mesh{triangles.vertices, {}};
  for (covering::Index f = 0; f < triangles.face_count(); ++f) {
    const covering::Loop t = triangles.loop(f, 0);
    mesh.triangles.push_back({t[0], t[1], t[2]});
  }
  return mesh;
}

template <class Volume>
Distance_peer distance(const Peer_mesh& mesh_a, const Peer_mesh& mesh_b)
{
  return [a = model_of<Volume>(mesh_a), b = model_of<Volume>(mesh_b)](const kernel::Pose& pose_a,
                                                                      const kernel::Pose& pose_b) {
    const fcl::DistanceRequestd request(false);
    fcl::DistanceResultd result;
    return fcl::distance<double>(a.get(), transform(pose_a), b.get(), transform(pose_b), request, result);
  };
}

template <fcl::CCDSolverType solver>
Motion_peer motion(const Peer_mesh& mesh_a, const Peer_mesh& mesh_b)
{
  fcl::ContinuousCollisionRequestd request;
  request.ccd_solver_type = solver;
  return [a = model_of<fcl::OBBRSSd>(mesh_a), b = model_of<fcl::OBBRSSd>(mesh_b), request](const kernel::Pose& from,
                                                                                           const kernel::Pose& to) {
    const fcl::Transform3d still = fcl::Transform3d::Identity();
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(a.get(), still, still, b.get(), transform(from), transform(to), request, result);
    return result.is_collide ? std::optional(result.time_of_contact) : std::nullopt;
  };
}

/// Two convex bodies, without a tree.
class Fcl_depth : public Depth_peer {
 public:
  Fcl_depth(const Peer_mesh& a, const Peer_mesh& b, fcl::GJKSolverType solver)
      : a_(convex(a)), b_(convex(b)), request_(1, true)
  {
    request_.gjk_solver_type = solver;
  }

  std::optional<double> depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    fcl::CollisionResultd result;
    fcl::collide<double>(a_.get(), transform(pose_a), b_.get(), transform(pose_b), request_, result);
    return result.isCollision() ? std::optional(result.getContact(0).penetration_depth) : std::nullopt;
  }

 private:
  static std::unique_ptr<fcl::Convexd> convex(const Peer_mesh& mesh)
  {
    const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const auto& [x, y, z] : mesh.vertices) vertices->emplace_back(x, y, z);
    const auto faces = std::make_shared<std::vector<int>>();
    for (const auto& t : mesh.triangles) faces->insert(faces->end(), {3, int(t[0]), int(t[1]), int(t[2])});
    return std::make_unique<fcl::Convexd>(vertices, int(mesh.triangles.size()), faces);
  }

  std::unique_ptr<fcl::Convexd> a_, b_;
  fcl::CollisionRequestd request_;
};

class Fcl_scene : public Scene_peer {
 public:
  Fcl_scene(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of)
  {
    std::vector<Model<fcl::OBBRSSd>> models;
    for (const Peer_mesh& mesh : meshes) {
      models.push_back(model_of<fcl::OBBRSSd>(mesh));
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
      objects_[k]->setTransform(transform(poses[k]));
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

void add_fcl(Peer_tables& tables)
{
  tables.pairs.push_back(
      {"FCL OBBRSS", "FCL, BVHModel<OBBRSS>, one contact: surfaces only, so a solid inside a solid is missed; double",
       verify::Knows::surfaces, make_peer<Prepared_pair, Fcl_pair<fcl::OBBRSSd>>});
  tables.pairs.push_back(
      {"FCL AABB", "FCL, BVHModel<AABB>, one contact: surfaces only, so a solid inside a solid is missed; double",
       verify::Knows::surfaces, make_peer<Prepared_pair, Fcl_pair<fcl::AABBd>>});
  tables.depths.push_back({"FCL libccd",
                           "FCL, collide of two Convex with contact: the solver of libccd, whose contacts are of MPR",
                           make_peer<Depth_peer, Fcl_depth, fcl::GST_LIBCCD>});
  tables.depths.push_back({"FCL own", "FCL, collide of two Convex with contact: its own GJK solver, and EPA",
                           make_peer<Depth_peer, Fcl_depth, fcl::GST_INDEP>});
  tables.scenes.push_back({"FCL dynamic AABB tree", make_peer<Scene_peer, Fcl_scene>});
  tables.distances.push_back({"fcl OBBRSS", distance<fcl::OBBRSSd>});
  tables.distances.push_back({"fcl RSS", distance<fcl::RSSd>});
  tables.motions.push_back({"FCL advancement",
                            "continuousCollide of surfaces by conservative advancement, until within 1e-4 of the "
                            "time; translations of B alone are asked",
                            motion<fcl::CCDC_CONSERVATIVE_ADVANCEMENT>});
  tables.motions.push_back({"FCL steps",
                            "continuousCollide of surfaces by ten steps; translations of B alone are asked",
                            motion<fcl::CCDC_NAIVE>});
}

std::unique_ptr<Prepared_pair> prepare_fcl(const covering::Polyhedron& a, const covering::Polyhedron& b, double scale_b)
{
  return std::make_unique<Fcl_pair<fcl::OBBRSSd>>(mesh_of(a), mesh_of(b), scale_b, true);
}

std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                                   bool with_points)
{
  return std::make_unique<Fcl_lister>(as_it_is(a), as_it_is(b), with_points);
}

}  // namespace tetracone::experiments
