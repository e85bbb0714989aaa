#include "experiments/peers/peer.h"

#include <ode/ode.h>

namespace tetracone::experiments {
namespace {

/// A mesh with what ODE only points to.
class Body {
 public:
  explicit Body(const Peer_mesh& mesh) : vertices_(mesh.vertices)
  {
    for (const auto& triangle : mesh.triangles)
      for (const covering::Index corner : triangle) corners_.push_back(static_cast<dTriIndex>(corner));
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), sizeof(kernel::Vertex), static_cast<int>(vertices_.size()),
                                corners_.data(), static_cast<int>(corners_.size()), 3 * sizeof(dTriIndex));
    geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
  ~Body()
  {
    dGeomDestroy(geometry_);
    dGeomTriMeshDataDestroy(data_);
  }

  dGeomID placed(const kernel::Pose& pose) const
  {
    dMatrix3 rotation = {};
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) rotation[4 * row + column] = pose[4 * row + column];
    dGeomSetRotation(geometry_, rotation);
    dGeomSetPosition(geometry_, pose[3], pose[7], pose[11]);
    return geometry_;
  }

 private:
  std::vector<kernel::Vertex> vertices_;
  std::vector<dTriIndex> corners_;
  dTriMeshDataID data_;
  dGeomID geometry_;
};

class Ode_pair : public Prepared_pair {
 public:
  Ode_pair(const Peer_mesh& a, const Peer_mesh& b) : a_(a), b_(b) {}

  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question) override
  {
    dContactGeom contact;
    return dCollide(a_.placed(pose_a), b_.placed(pose_b), 1, &contact, sizeof contact) > 0;
  }

 private:
  Body a_, b_;
};

}  // namespace

std::unique_ptr<Prepared_pair> prepare_ode(const Peer_mesh& a, const Peer_mesh& b)
{
  static const bool ready = dInitODE2(0) != 0;
  // What ODE keeps a thread; again on the same thread it does nothing.
  if (!ready || !dAllocateODEDataForThread(dAllocateMaskAll)) return nullptr;
  return std::make_unique<Ode_pair>(a, b);
}

}  // namespace tetracone::experiments
