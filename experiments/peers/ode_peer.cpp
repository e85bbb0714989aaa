#include "experiments/peers/peer_tables.h"

#include <ode/ode.h>

#include <algorithm>

namespace tetracone::experiments {
namespace {

/// A mesh with what ODE only points to.
class Ode_body {
 public:
  explicit Ode_body(const Peer_mesh& mesh, dSpaceID space = nullptr) : vertices_(mesh.vertices)
  {
    for (const auto& triangle : mesh.triangles)
      for (const covering::Index corner : triangle) corners_.push_back(static_cast<dTriIndex>(corner));
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), sizeof(kernel::Vertex), static_cast<int>(vertices_.size()),
                                corners_.data(), static_cast<int>(corners_.size()), 3 * sizeof(dTriIndex));
    geometry_ = dCreateTriMesh(space, data_, nullptr, nullptr, nullptr);
  }
  Ode_body(const Ode_body&) = delete;
  Ode_body& operator=(const Ode_body&) = delete;
  ~Ode_body()
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
  Ode_body a_, b_;
};

/// Its meshes are of each body: ODE has no trimesh for several.
class Ode_scene : public Scene_peer {
 public:
  Ode_scene(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of)
      : space_(dHashSpaceCreate(nullptr))
  {
    dSpaceSetCleanup(space_, 0);
    for (std::size_t k = 0; k < of.size(); ++k) {
      bodies_.push_back(std::make_unique<Ode_body>(meshes[of[k]], space_));
      dGeomSetData(bodies_.back()->placed(kernel::Pose()), reinterpret_cast<void*>(k));
    }
  }
  Ode_scene(const Ode_scene&) = delete;
  ~Ode_scene() override
  {
    bodies_.clear();
    dSpaceDestroy(space_);
  }

  std::vector<Pair> frame(const std::vector<kernel::Pose>& poses) override
  {
    for (std::size_t k = 0; k < poses.size(); ++k) bodies_[k]->placed(poses[k]);
    candidates_ = 0;
    found_.clear();
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<Ode_scene*>(self)->ask(a, b); });
    return found_;
  }

 private:
  void ask(dGeomID a, dGeomID b)
  {
    ++candidates_;
    dContactGeom contact;
    if (dCollide(a, b, 1, &contact, sizeof contact) == 0) return;
    const auto number = [](dGeomID g) { return std::uint32_t(reinterpret_cast<std::size_t>(dGeomGetData(g))); };
    found_.push_back({std::min(number(a), number(b)), std::max(number(a), number(b))});
  }

  dSpaceID space_;
  std::vector<std::unique_ptr<Ode_body>> bodies_;
  std::vector<Pair> found_;
};

/// Initialises ODE's data of the process and of the thread; a repeated call on one thread does nothing.
bool is_ready()
{
  static const bool ready = dInitODE2(0) != 0;
  return ready && dAllocateODEDataForThread(dAllocateMaskAll);
}

template <class Interface, class Method, class... Of>
std::unique_ptr<Interface> make(const Of&... of)
{
  return is_ready() ? std::make_unique<Method>(of...) : nullptr;
}

}  // namespace

void add_ode(Peer_tables& tables)
{
  tables.pairs.push_back({"ODE trimesh",
                          "ODE, trimesh against trimesh by OPCODE: surfaces only, so a solid inside a solid is missed; "
                          "double, and near counts as touching",
                          verify::Knows::surfaces, make<Prepared_pair, Ode_pair>});
  tables.scenes.push_back({"ODE hash space", make<Scene_peer, Ode_scene>});
}

}  // namespace tetracone::experiments
