#ifndef TETRACONE_EXPERIMENTS_PEERS_FCL_H
#define TETRACONE_EXPERIMENTS_PEERS_FCL_H

#include "experiments/peers/peer.h"

#include <functional>
#include <utility>

/// FCL (Debian's package) on its trees of doubles, as its users run it. A function that prepares it returns null when
/// the program was built without FCL. All poses must be rigid, except that of B in `prepare_fcl`.
namespace tetracone::experiments {

/// BVHModel<OBBRSS>: one contact, no cost. It always answers the *surface* question, since it has no solids. FCL's
/// transforms are rigid, so B's vertices are multiplied by `scale_b`, and B's matrix is divided by it. Requires that
/// B's matrix is `scale_b` times a rotation; both operations are exact for a power of two. Throws std::runtime_error
/// for a face that cannot be triangulated.
std::unique_ptr<Prepared_pair> prepare_fcl(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                           double scale_b);

/// The contacts of two triangle meshes: BVHModel<OBBRSS>, without a limit of contacts.
class Fcl_contacts {
 public:
  using Pair = std::pair<covering::Index, covering::Index>;  ///< a triangle of A and one of B

  virtual ~Fcl_contacts() = default;
  /// Lists the contacts under these rigid poses, and returns their number.
  virtual std::size_t list(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  /// Returns the pairs listed last, sorted, each once.
  virtual std::vector<Pair> pairs() const = 0;
};

/// Prepares them. With `with_points` FCL computes points, normals and depths too. Requires triangle meshes.
std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                                   bool with_points);

/// Another library's distance of two meshes, prepared once. Under these poses it returns the distance of the surfaces,
/// in double; for meshes that meet, whatever the library returns.
using Distance_peer = std::function<double(const kernel::Pose& pose_a, const kernel::Pose& pose_b)>;

/// A distance peer by its name.
struct Named_distance_peer {
  const char* name;
  Distance_peer (*make)(const Peer_mesh& a, const Peer_mesh& b);
};

/// Returns the distance peers of this build, with default settings. FCL has two: on trees of oriented boxes with swept
/// spheres (OBBRSS), and on trees of swept spheres alone (RSS).
const std::vector<Named_distance_peer>& distance_peers();

/// Another library's first contact of two moving meshes, prepared once. It returns the time in [0, 1] for B's motion
/// from one rigid pose to another; nothing if it finds none. A rests in its own coordinates.
using Motion_peer = std::function<std::optional<double>(const kernel::Pose& from, const kernel::Pose& to)>;

/// A motion peer by its name.
struct Named_motion_peer {
  const char* name;
  const char* note;  ///< what it really answers
  Motion_peer (*make)(const Peer_mesh& a, const Peer_mesh& b);
};

/// Returns the motion peers of this build. FCL has continuousCollide on trees of oriented boxes with swept spheres, by
/// two methods. Conservative advancement by default ends its steps within 1e-4 of the time of contact. The default
/// method asks static questions at ten steps.
const std::vector<Named_motion_peer>& motion_peers();

}  // namespace tetracone::experiments

#endif
