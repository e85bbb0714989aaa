#include "experiments/peers/peer_tables.h"

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>

namespace tetracone::experiments {
namespace {

btTransform bullet_transform(const kernel::Pose& pose)
{
  const auto entry = [&pose](int row, int column) { return static_cast<btScalar>(pose[4 * row + column]); };
  const btMatrix3x3 m(entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 0), entry(1, 1), entry(1, 2), entry(2, 0),
                      entry(2, 1), entry(2, 2));
  return btTransform(m, btVector3(entry(0, 3), entry(1, 3), entry(2, 3)));
}

/// A mesh with what Bullet only points to.
class Bullet_body {
 public:
  explicit Bullet_body(const Peer_mesh& mesh)
  {
    for (const auto& v : mesh.vertices)
      for (const double x : v) coordinates_.push_back(static_cast<btScalar>(x));
    for (const auto& triangle : mesh.triangles)
      for (const covering::Index corner : triangle) corners_.push_back(static_cast<int>(corner));
    array_ = std::make_unique<btTriangleIndexVertexArray>(static_cast<int>(mesh.triangles.size()), corners_.data(),
                                                          3 * sizeof(int), static_cast<int>(mesh.vertices.size()),
                                                          coordinates_.data(), 3 * sizeof(btScalar));
    shape_ = std::make_unique<btGImpactMeshShape>(array_.get());
    shape_->setMargin(0);
    shape_->updateBound();
    object_.setCollisionShape(shape_.get());
  }

  btCollisionObject& object() { return object_; }

  const btCollisionObject& placed(const kernel::Pose& pose)
  {
    object_.setWorldTransform(bullet_transform(pose));
    return object_;
  }

 private:
  std::vector<btScalar> coordinates_;
  std::vector<int> corners_;
  std::unique_ptr<btTriangleIndexVertexArray> array_;
  std::unique_ptr<btGImpactMeshShape> shape_;
  btCollisionObject object_;
};

/// Takes the contacts; the manifold of the algorithm's own stays empty, so that no question knows of the one before.
struct Any_contact : btManifoldResult {
  using btManifoldResult::btManifoldResult;
  bool found = false;
  void addContactPoint(const btVector3&, const btVector3&, btScalar distance) override
  {
    found = found || distance <= 0;
  }
};

/// Asks two placed bodies.
class Asking {
 public:
  Asking() { btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_); }

  bool operator()(const btCollisionObject& a, const btCollisionObject& b)
  {
    const btCollisionObjectWrapper wrapped_a(nullptr, a.getCollisionShape(), &a, a.getWorldTransform(), -1, -1);
    const btCollisionObjectWrapper wrapped_b(nullptr, b.getCollisionShape(), &b, b.getWorldTransform(), -1, -1);
    // Not btCollisionWorld::contactPairTest: it asks for closest points, for which GImpact does not register.
    btCollisionAlgorithm* const algorithm =
        dispatcher_.findAlgorithm(&wrapped_a, &wrapped_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    Any_contact contact(&wrapped_a, &wrapped_b);
    algorithm->processCollision(&wrapped_a, &wrapped_b, btDispatcherInfo(), &contact);
    algorithm->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm);
    return contact.found;
  }
  btCollisionDispatcher& dispatcher() { return dispatcher_; }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
};

class Bullet_pair : public Prepared_pair {
 public:
  Bullet_pair(const Peer_mesh& a, const Peer_mesh& b) : a_(a), b_(b) {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question) override
  {
    return ask_(a_.placed(pose_a), b_.placed(pose_b));
  }

 private:
  Asking ask_;
  Bullet_body a_, b_;
};

/// The convex hulls of the vertices.
class Bullet_depth : public Depth_peer {
 public:
  Bullet_depth(const Peer_mesh& a, const Peer_mesh& b)
  {
    for (const auto& [mesh, hull] : {std::pair(&a, &a_), std::pair(&b, &b_)}) {
      for (const auto& [x, y, z] : mesh->vertices)
        hull->addPoint(btVector3(btScalar(x), btScalar(y), btScalar(z)), false);
      hull->recalcLocalAabb();
      hull->setMargin(0);
    }
  }

  std::optional<double> depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b) override
  {
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = bullet_transform(pose_a);
    input.m_transformB = bullet_transform(pose_b);
    btPointCollector nearest;
    btGjkPairDetector(&a_, &b_, &simplex_, &epa_).getClosestPoints(input, nearest, nullptr);
    return nearest.m_hasResult && nearest.m_distance <= 0 ? std::optional(-double(nearest.m_distance)) : std::nullopt;
  }

 private:
  btConvexHullShape a_, b_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver epa_;
};

/// The broad phase of the library, and the question of `Bullet_pair` for what it lets through.
class Bullet_scene : public Scene_peer {
 public:
  Bullet_scene(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of)
  {
    for (std::size_t k = 0; k < of.size(); ++k) {
      bodies_.push_back(std::make_unique<Bullet_body>(meshes[of[k]]));
      bodies_.back()->object().setUserIndex(int(k));
    }
  }
  Bullet_scene(const Bullet_scene&) = delete;
  ~Bullet_scene() override
  {
    for (btBroadphaseProxy* proxy : proxies_) broad_.destroyProxy(proxy, &ask_.dispatcher());
  }

  std::vector<Pair> frame(const std::vector<kernel::Pose>& poses) override
  {
    for (std::size_t k = 0; k < poses.size(); ++k) {
      btCollisionObject& object = bodies_[k]->object();
      bodies_[k]->placed(poses[k]);
      btVector3 low, high;
      object.getCollisionShape()->getAabb(object.getWorldTransform(), low, high);
      if (proxies_.size() <= k)
        proxies_.push_back(broad_.createProxy(low, high, object.getCollisionShape()->getShapeType(), &object, 1, 1,
                                              &ask_.dispatcher()));
      else
        broad_.setAabb(proxies_[k], low, high, &ask_.dispatcher());
    }
    broad_.calculateOverlappingPairs(&ask_.dispatcher());
    btBroadphasePairArray& pairs = broad_.getOverlappingPairCache()->getOverlappingPairArray();
    candidates_ = std::size_t(pairs.size());
    std::vector<Pair> found;
    for (int k = 0; k < pairs.size(); ++k) {
      const auto& a = *static_cast<btCollisionObject*>(pairs[k].m_pProxy0->m_clientObject);
      const auto& b = *static_cast<btCollisionObject*>(pairs[k].m_pProxy1->m_clientObject);
      const auto [first, second] = std::minmax({std::uint32_t(a.getUserIndex()), std::uint32_t(b.getUserIndex())});
      if (ask_(a, b)) found.push_back({first, second});
    }
    return found;
  }

 private:
  Asking ask_;
  btDbvtBroadphase broad_;
  std::vector<std::unique_ptr<Bullet_body>> bodies_;
  std::vector<btBroadphaseProxy*> proxies_;
};

}  // namespace

void add_bullet(Peer_tables& tables)
{
  tables.pairs.push_back({"Bullet GImpact",
                          "Bullet, GImpact meshes, margin 0: surfaces only, so a solid inside a solid is missed; "
                          "float, and near counts as touching",
                          verify::Knows::surfaces, make_peer<Prepared_pair, Bullet_pair>,
                          verify::In_floats::vertices_and_poses});
  tables.depths.push_back({"Bullet",
                           "Bullet, btGjkPairDetector with the EPA solver on two convex hulls, margin 0; float",
                           make_peer<Depth_peer, Bullet_depth>});
  tables.scenes.push_back({"Bullet Dbvt and GImpact", make_peer<Scene_peer, Bullet_scene>});
}

}  // namespace tetracone::experiments
