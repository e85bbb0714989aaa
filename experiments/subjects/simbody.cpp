// A subject around Simbody (Debian: libsimbody-dev): its tracker of contacts of two closed triangle meshes, in double.
//   g++ -O2 -std=c++17 -I. -I/usr/include/simbody experiments/subjects/simbody.cpp -o simbody -lSimTKmath -lSimTKcommon
#include "experiments/subjects/subject.h"

#include <SimTKmath.h>

using namespace tetracone::subject;
using SimTK::ContactGeometry, SimTK::Transform, SimTK::Vec3;

std::shared_ptr<ContactGeometry::TriangleMesh> prepare(const Body& body)
{
  SimTK::Array_<Vec3> vertices;
  SimTK::Array_<int> corners;
  for (const auto& [x, y, z] : body.vertices) vertices.push_back(Vec3(x, y, z));
  for (const auto& triangle : body.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  try {
    return std::make_shared<ContactGeometry::TriangleMesh>(vertices, corners);
  } catch (const std::exception& refusal) {  // open, or not manifold
    std::cerr << refusal.what() << std::endl;
    return nullptr;
  }
}

Transform transform(const std::array<double, 7>& m)
{
  return {SimTK::Rotation(SimTK::Quaternion(m[0], m[1], m[2], m[3])), Vec3(m[4], m[5], m[6])};
}

std::optional<bool> collide(const ContactGeometry::TriangleMesh& a, const ContactGeometry::TriangleMesh& b,
                            const Ask& ask)
{
  if (ask.question != "surface" || !ask.rigid_a || !ask.rigid_b) return std::nullopt;
  const SimTK::ContactTracker::TriangleMeshTriangleMesh tracker;
  const SimTK::UntrackedContact before(SimTK::ContactSurfaceIndex(0), SimTK::ContactSurfaceIndex(1));
  SimTK::Contact now;
  tracker.trackContact(before, transform(*ask.rigid_a), a, transform(*ask.rigid_b), b, 0, now);
  return !now.isEmpty() && SimTK::TriangleMeshContact::isInstance(now);
}

int main()
{
  int major = 0, minor = 0, build = 0;
  SimTK_version_SimTKcommon(&major, &minor, &build);
  const std::string version = std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
  return serve({{"name", "Simbody"},
                {"version", version},
                {"precision", "float64"},
                {"bodies", "manifold"},
                {"poses", "rigid"},
                {"questions", {"surface"}},
                {"touching", "closed"}},
               prepare, collide);
}
