#ifndef TETRACONE_TETRATREE_DOOR_TETRACONE_H
#define TETRACONE_TETRATREE_DOOR_TETRACONE_H

#include "tetracone/covering/location.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/error.h"
#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/door/contacts.h"
#include "tetracone/tetratree/door/motion.h"
#include "tetracone/tetratree/door/nearest.h"
#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/query_statistics.h"
#include "tetracone/tetratree/ray_hit.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Whether two placed polyhedra collide, exactly. The door: a compiled library behind the standard library's types.
/// Templates for every kernel are under tetracone/kernel, tetracone/covering and tetracone/tetratree.
namespace tetracone {

namespace kernel {
class Pose;
/// Writes the name: apart, surfaces, a_in_b, b_in_a.
inline std::ostream& operator<<(std::ostream& out, Relation relation) { return out << to_string(relation); }
}  // namespace kernel
namespace tetratree {
struct Pair_memory;
}
class Body;
namespace detail {
struct Body_data;
struct Query_data;
const Body_data& data_of(const Body& body);
}  // namespace detail

using covering::Face_triangle;
using covering::Location;
using covering::Polyhedron;
using kernel::Contact;
using kernel::Feature_pair;
using kernel::Question;
using kernel::Relation;
using tetratree::Query_statistics;
using tetratree::Ray;
using tetratree::Ray_hit;

/// The affine map x -> M x + t that places a body, taken exactly: M need not be a perfect rotation. Immutable, cheap to
/// copy.
class Pose {
 public:
  /// The identity.
  Pose();

  /// Row-major 3x4: row i is (M_i0, M_i1, M_i2, t_i). Throws Error for a number that is not finite, and where det M =
  /// 0.
  explicit Pose(const std::array<double, 12>& rows);

  /// Of decimals or fractions "n/d": a rotation that is truly one has rational numbers. Throws as for doubles, and for
  /// a text that is no number.
  static Pose from_text(const std::array<std::string, 12>& rows);

  /// x -> x + (x, y, z). Throws Error for a number that is not finite.
  static Pose translation(double x, double y, double z);

  ~Pose();
  /// Copies share the fractions of a pose that has some.
  Pose(const Pose& other);
  /// As the copy.
  Pose& operator=(const Pose& other);

  /// The nearest doubles; the numbers themselves unless the pose was made of fractions.
  const std::array<double, 12>& rows() const;

  /// The pose of the templates.
  const kernel::Pose& exact() const { return *reinterpret_cast<const kernel::Pose*>(storage_); }

 private:
  alignas(8) std::byte storage_[120];
};

/// A polyhedron that queries can be asked about. Immutable, cheap to copy (copies share their data), and safe from any
/// number of threads at once while what queries need of it is still being made.
///
/// Legal are open and closed surfaces, several shells, cavities, non-manifold and degenerate elements, faces with
/// holes. An open surface has no solid.
class Body {
 public:
  /// Throws Error for no face, an index out of range, a coordinate that is not finite, and a face that is not exactly
  /// planar (with the face and its deviation; tetracone/repair.h replaces such faces by triangles).
  explicit Body(Polyhedron polyhedron);

  /// `triangles`: for some faces, triangles that cover exactly the face, in its direction (as tetracone/repair.h makes
  /// them). Faces of more corners without are split where they are convex, and else taken as a whole.
  ///
  /// Throws as above, and for a face whose triangles do not cover exactly it; Error names the face. Legal are triangles
  /// with area, of the face's corners, whose directed sides are the directed edges of the face's loops except pairs of
  /// opposite ones. Each edge of a loop is a side of a triangle. (tetracone/covering/face_cover.h proves that this is
  /// enough.) The check takes time linear in the triangles.
  Body(Polyhedron polyhedron, std::vector<Face_triangle> triangles);

  /// Copies share everything. There is no move: a body is never empty.
  Body(const Body&) = default;
  /// As the copy.
  Body& operator=(const Body&) = default;

  /// What it was made of.
  const Polyhedron& polyhedron() const;

  /// True when every directed edge occurs as often as its reverse: then the body bounds a solid.
  bool is_closed() const;

  /// Makes now the nodes that queries of the fast tree would make when they first need them, by so many threads; 0: as
  /// many as there are. The tree is the same whatever their number is. Other threads' queries wait for nodes meanwhile.
  void make_all(std::size_t threads = 1) const;

  /// Where the point stands with regard to the solid, exactly: by its winding number. The first such question makes the
  /// table that answers all. Throws Error for an open surface, and for a coordinate that is not finite.
  Location inside(const std::array<double, 3>& point) const;

  /// The answers for many points. Throws as for one.
  std::vector<Location> inside(std::span<const std::array<double, 3>> points) const;

  /// The answer for a point of decimals or fractions "n/d". Throws as for doubles, and for a text that is no number.
  Location inside_text(const std::array<std::string, 3>& point) const;

  /// Bytes of the table that `inside` asks, made now if it has to be. Throws Error for an open surface.
  std::size_t inside_bytes() const;

  /// The first face that the ray meets: of least t, exactly, and of those the one of the least number. Nothing where it
  /// meets none. A ray in a face's plane meets it where it first comes to the closed face. Throws Error for a number
  /// that is not finite, and for a direction of 0.
  std::optional<Ray_hit> first_hit(const Ray& ray) const;

  /// The first faces of many rays. Throws as for one.
  std::vector<std::optional<Ray_hit>> first_hits(std::span<const Ray> rays) const;

  /// Every face that the ray meets, each once, where it first does; in the exact order of t, then of faces. Throws as
  /// `first_hit`.
  std::vector<Ray_hit> hits(const Ray& ray) const;

 private:
  friend class Query;
  friend const detail::Body_data& detail::data_of(const Body& body);
  friend Body read_body(const std::filesystem::path& file);
  friend void save_body(const Body& body, const std::filesystem::path& file);
  explicit Body(const std::filesystem::path& file);

  std::shared_ptr<const detail::Body_data> data_;
};

/// Reads OFF, OBJ, PLY, STL or TetGen .poly, or a body that was saved (.body), by the suffix. Throws Error, "file:line:
/// what is wrong; what was expected", for a file that is not one, and as `Body` does.
///
/// A saved body has all nodes of its fast tree, used where the system keeps the file: many processes share them. The
/// file may be removed or saved anew while it is in use, not written into. Refused is one whose checksum says that a
/// byte is not what was saved, and one of another version of the format or of a machine of other numbers.
///
/// Nothing in a saved body is trusted, whoever wrote it: all that can be derived is derived anew, and all else is
/// checked, in one linear pass. A file is refused, or it answers as `Body` of its vertices, faces and triangles does.
Body read_body(const std::filesystem::path& file);

/// Saves the body with its fast tree, all nodes of which are made, to a file *.body that `read_body` takes: the same
/// bytes whenever it is saved. Written under a temporary name first, so that a reader sees the old file or the new one.
/// Throws Error for another suffix, and for a file that cannot be written; then nothing is left behind.
void save_body(const Body& body, const std::filesystem::path& file);

/// The answer for one pose of each body.
class Answer {
 public:
  /// The answer that says this.
  explicit Answer(Relation relation) : relation_(relation) {}

  /// True when the bodies collide.
  explicit operator bool() const { return relation_ != Relation::apart; }

  /// How the bodies stand; of `Question::surface`, `apart` or `surfaces`.
  Relation relation() const { return relation_; }

 private:
  Relation relation_;
};

/// Two bodies and a question, asked for many poses. Keeps work from one pose to the next: one query per thread.
class Query {
 public:
  /// The query shares the bodies' data and outlives them. Throws Error when an open surface is asked for its solid.
  Query(const Body& a, const Body& b, Question question = Question::solid, const Query_options& options = {});

  ~Query();
  /// What is moved from answers with an Error.
  Query(Query&&) noexcept;
  /// As the constructor.
  Query& operator=(Query&&) noexcept;

  /// How the bodies stand under these poses. Throws Error when the thread's floating point is not as exact answers need
  /// it, and for a query that has been moved from.
  Answer collide(const Pose& pose_a, const Pose& pose_b);

  /// By poses of the templates (`exact`). Requires det M != 0.
  Answer collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// The same of one of many pairs of placed bodies that a query is asked of, with what is kept of it
  /// (tetracone/tetratree/fast/pair_memory.h); the answer does not depend on that. Requires the memory of this pair.
  Answer collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, tetratree::Pair_memory& memory);

  /// The answers for n poses of each body, or for one of A and n of B, or n of A and one of B. Throws Error for other
  /// counts.
  std::vector<Answer> collide(std::span<const Pose> poses_a, std::span<const Pose> poses_b);

  /// All pairs of an edge of one and a face of the other that share a point, with the kind of contact, sorted.
  std::vector<Feature_pair> features(const Pose& pose_a, const Pose& pose_b);
  /// By poses of the templates. Requires det M != 0.
  std::vector<Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// All pairs of faces that share a point, and where. Throws Error for a kernel that rounds.
  Contacts contacts(const Pose& pose_a, const Pose& pose_b);
  /// By poses of the templates. Requires det M != 0.
  Contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// The double nearest to the exact distance of the surfaces or, of `Question::solid`, of the solids: 0 where they
  /// collide. By the fast tree, whatever the method. Of the kernels adaptive and rational are exact, double is what it
  /// is; throws Error for others, and as `collide`.
  double distance(const Pose& pose_a, const Pose& pose_b);
  /// By poses of the templates. Requires det M != 0.
  double distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// The squared distance and two nearest points, exactly, and what holds them; of several pairs one. Throws Error for a
  /// kernel that is not adaptive or rational, and as `collide`.
  Nearest nearest(const Pose& pose_a, const Pose& pose_b);
  /// By poses of the templates. Requires det M != 0.
  Nearest nearest(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Whether the distance is at most `limit`, decided on squares, exactly; none is at most a negative one. Throws Error
  /// for a limit that is no number, and as `distance`.
  bool within(const Pose& pose_a, const Pose& pose_b, double limit);
  /// Of a decimal or a fraction "n/d".
  bool within(const Pose& pose_a, const Pose& pose_b, const std::string& limit);
  /// By poses of the templates. Requires det M != 0.
  bool within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit);

  /// After an answer `apart`: how far from one another the bodies were at least; 0 where the query had no need to know.
  double certified_gap() const;

  /// When the bodies first share a point while they move, exactly: nothing where they never do. `Question::solid` differs
  /// from surface at t = 0 alone: solids that do not collide there first meet where their surfaces do. By the fast tree.
  /// Requires that neither motion begins with a singular M. Throws Error for a kernel that is not adaptive, for a body
  /// with a face that has no triangles, and as `collide`.
  std::optional<First_contact> first_contact(const Motion& a, const Motion& b);

  /// Work since the last `clear_statistics`.
  Query_statistics statistics() const;
  /// Sets all counts to 0.
  void clear_statistics();

  /// Bytes of the trees of both bodies that this query asks, as far as they have been made.
  std::size_t bytes() const;
  /// Nodes of these trees.
  std::size_t node_count() const;

 private:
  detail::Query_data& data() const;

  std::unique_ptr<detail::Query_data> data_;
};

}  // namespace tetracone

#endif
