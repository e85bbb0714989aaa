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
#include "tetracone/tetratree/door/overlap.h"
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

/// The library's interface, the door: it decides exactly whether two placed polyhedra collide. It is compiled, and
/// needs the standard library alone. Templates for every kernel are under tetracone/kernel, tetracone/covering and
/// tetracone/tetratree.
namespace tetracone {

namespace kernel {
class Pose;
/// Writes the name: apart, surfaces, a_in_b, b_in_a.
inline std::ostream& operator<<(std::ostream& out, Relation relation) { return out << to_string(relation); }
/// Writes the enumerator's own name.
inline std::ostream& operator<<(std::ostream& out, Solid_relation relation) { return out << to_string(relation); }
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
using kernel::Solid_contact;
using kernel::Solid_relation;
using tetratree::Crossing;
using tetratree::Query_statistics;
using tetratree::Ray;
using tetratree::Ray_hit;

/// The affine map x -> M x + t that places a body, taken exactly. M need not be a rotation. Immutable; copies are
/// cheap. Making one of numbers throws Error when the thread's floating point is not as exact answers need it.
class Pose {
 public:
  /// The identity.
  Pose();

  /// The map of a row-major 3x4 array: row i is (M_i0, M_i1, M_i2, t_i). Throws Error for a number that is not finite,
  /// and where det M = 0.
  explicit Pose(const std::array<double, 12>& rows);

  /// Returns the map of decimals, which stand for the nearest doubles, or fractions "n/d". A rotation can be exact in
  /// fractions. Throws Error as for doubles, and for a text that is no number.
  static Pose from_text(const std::array<std::string, 12>& rows);

  /// Returns the map p -> p + (x, y, z). Throws Error for a number that is not finite.
  static Pose translation(double x, double y, double z);

  ~Pose();
  /// Copies; both share the fractions, if there are any.
  Pose(const Pose& other);
  /// Copies; both share the fractions, if there are any.
  Pose& operator=(const Pose& other);

  /// Returns the doubles nearest to the twelve numbers: the numbers themselves, unless the pose was made of fractions.
  const std::array<double, 12>& rows() const;

  /// Returns the pose as the library's templates take it.
  const kernel::Pose& exact() const { return *reinterpret_cast<const kernel::Pose*>(storage_); }

 private:
  alignas(8) std::byte storage_[120];
};

/// A polyhedron that queries can be asked about. Immutable; copies share their data. Any number of threads may ask
/// about it at once, also while its tree is still being made. Construction and questions throw Error when their
/// thread's floating point is not as exact answers need it.
///
/// Open and closed surfaces, several shells, cavities, non-manifold and degenerate elements, and faces with holes are
/// legal. An open surface has no solid.
class Body {
 public:
  /// A body of this polyhedron. Throws Error for no face, an index out of range, and a coordinate that is not finite.
  /// Throws it also for a face that is not exactly planar, with its deviation; tetracone/repair.h replaces such faces
  /// by triangles.
  explicit Body(Polyhedron polyhedron);

  /// `triangles` cover some faces exactly, in the face's direction (as tetracone/repair.h makes them). Any other face
  /// of more than three corners becomes a fan if it is suitable (tetracone/covering/star_faces.h), else it stays whole.
  ///
  /// Throws as above, and for a face whose triangles do not cover it exactly; Error names the face. Legal triangles
  /// have area and the face's corners. When pairs of opposite ones are cancelled, their directed sides are the directed
  /// edges of the face's loops. Each edge of a loop is a side of a triangle. Triangles of opposite directions share no
  /// area. (tetracone/covering/face_cover.h proves that this is enough.) The check takes time linear in the triangles,
  /// except for sorting.
  Body(Polyhedron polyhedron, std::vector<Face_triangle> triangles);

  /// Copies; both share everything. There is no move: a body is never empty.
  Body(const Body&) = default;
  /// Copies; both share everything.
  Body& operator=(const Body&) = default;

  /// Returns the polyhedron that the body was made of.
  const Polyhedron& polyhedron() const;

  /// Returns the triangles that stand for faces of more than three corners, in the order of faces. A face that has none
  /// stays whole.
  const std::vector<Face_triangle>& triangles() const;

  /// True when every directed edge occurs as often as its reverse: then the body bounds a solid.
  bool is_closed() const;

  /// True when no two faces intersect improperly: they share no point, except on a vertex or an edge that both have.
  /// Vertices and edges are compared by coordinates. The first call decides it exactly, and stops at the first pair.
  bool is_simple() const;

  /// Returns all pairs of faces that intersect improperly, each once with face_a < face_b, and where. Pieces that
  /// common vertices and edges hold are left out.
  Contacts self_intersections() const;

  /// Builds the whole fast tree now, with `threads` threads (0: all cores), instead of on demand. The tree does not
  /// depend on their number. Other threads' queries wait for nodes meanwhile.
  void make_all(std::size_t threads = 1) const;

  /// Returns where the point is with regard to the solid, exactly, by its winding number. The first call makes the
  /// table that all calls use. Throws Error for an open surface, and for a coordinate that is not finite.
  Location inside(const std::array<double, 3>& point) const;

  /// Returns the answers for many points. Throws as for one.
  std::vector<Location> inside(std::span<const std::array<double, 3>> points) const;

  /// Returns the answer for a point of decimals, which stand for the nearest doubles, or fractions "n/d". Throws Error
  /// as for doubles, and for a text that is no number.
  Location inside_text(const std::array<std::string, 3>& point) const;

  /// Returns the bytes of the table that `inside` asks, which is made now if need be. Throws Error for an open surface.
  std::size_t inside_bytes() const;

  /// Returns the point of the surface nearest to a point, exactly, with the signed distance. Throws Error for an open
  /// surface, which gives no sign, and for a coordinate that is not finite.
  Nearest_point nearest(const std::array<double, 3>& point) const;

  /// Returns the answers for many points. Throws as for one.
  std::vector<Nearest_point> nearest(std::span<const std::array<double, 3>> points) const;

  /// Returns the answer in fractions for a point of decimals, which stand for the nearest doubles, or fractions "n/d".
  /// Throws Error as for doubles, and for a text that is no number.
  Exact_nearest_point nearest_text(const std::array<std::string, 3>& point) const;

  /// Returns the first face that the ray meets: least t, exactly; at equal t the least face number. Nothing where it
  /// meets none. A ray in a face's plane meets it where it first comes to the closed face. Throws Error for a number
  /// that is not finite, and for a direction of 0.
  std::optional<Ray_hit> first_hit(const Ray& ray) const;

  /// Returns the first face that the ray meets at a t of at most `end`, compared exactly. Throws Error as above, and
  /// for an end that is no number.
  std::optional<Ray_hit> first_hit(const Ray& ray, double end) const;

  /// True when the ray meets some face at a t of at most `end`. It costs less than `first_hit`. Throws as `first_hit`.
  bool is_hit(const Ray& ray, double end) const;

  /// Returns how the ray goes through a face that it meets, by the face's normal: `entering` and `leaving` refer to the
  /// solid where faces are oriented outward. Throws Error as `first_hit`, and for a face's number out of range.
  Crossing crossing(const Ray& ray, Index face) const;

  /// Returns the face's unit normal, to the side that sees its loops counterclockwise: outward where faces are oriented
  /// outward. Each component is the double nearest to the exact one. All are 0 where the loops' signed areas sum to 0,
  /// as for a face without area. Throws Error for a face's number out of range.
  std::array<double, 3> normal(Index face) const;

  /// Returns the first faces of many rays. Throws as for one.
  std::vector<std::optional<Ray_hit>> first_hits(std::span<const Ray> rays) const;

  /// Returns all faces that the ray meets, each once with its least t. They are sorted by the exact t, then by number.
  /// Throws as `first_hit`.
  std::vector<Ray_hit> hits(const Ray& ray) const;
  /// Returns the hits whose t is at most `end`, compared exactly. Throws as above, and for an end that is no number.
  std::vector<Ray_hit> hits(const Ray& ray, double end) const;

 private:
  friend class Query;
  friend class Certificate;
  friend const detail::Body_data& detail::data_of(const Body& body);
  friend Body read_body(const std::filesystem::path& file);
  friend void save_body(const Body& body, const std::filesystem::path& file);
  explicit Body(const std::filesystem::path& file);

  std::shared_ptr<const detail::Body_data> data_;
};

/// Returns the body of a file: OFF, OBJ, PLY, STL, TetGen .poly, or a saved body (.body), by the suffix. Throws Error,
/// "file:line: what is wrong; what was expected", for a file that is none of these, and as `Body` does.
///
/// A saved body has all nodes of its fast tree. The file is mapped, so that many processes share it. It may be removed
/// or saved anew while it is in use, but not written into. A spoiled file, another version of the format, and a machine
/// with other numbers are refused.
///
/// Nothing in a saved body is trusted: all that can be derived is derived anew, and all else is checked. A file that is
/// not refused answers as `Body` of its vertices, faces and triangles does.
Body read_body(const std::filesystem::path& file);

/// Saves the body with its whole fast tree to a file *.body that `read_body` takes. Equal bodies give equal bytes. The
/// file is written under a temporary name first, so that a reader sees the old file or the new one. Throws Error for
/// another suffix, and for a file that cannot be written; then nothing is left behind.
void save_body(const Body& body, const std::filesystem::path& file);

/// The answer for one pose of each body.
class Answer {
 public:
  /// An answer of this relation.
  explicit Answer(Relation relation) : relation_(relation) {}

  /// True when the bodies collide.
  explicit operator bool() const { return relation_ != Relation::apart; }

  /// Returns the relation of the bodies. Under `Question::surface` it is `apart` or `surfaces`.
  Relation relation() const { return relation_; }

 private:
  Relation relation_;
};

/// Two bodies and a question for many poses. It keeps work from pose to pose, so only one thread at a time may use it.
class Query {
 public:
  /// A query that shares the bodies' data and may outlive them. Throws Error when an open surface is asked for its
  /// solid, and when floating point is not as exact answers need it.
  Query(const Body& a, const Body& b, Question question = Question::solid, const Query_options& options = {});

  ~Query();
  /// Moves; the query that is moved from throws Error when it is asked.
  Query(Query&&) noexcept;
  /// Moves; the query that is moved from throws Error when it is asked.
  Query& operator=(Query&&) noexcept;

  /// Returns whether the bodies collide under these poses, and their relation. Throws Error when the thread's floating
  /// point is not as exact answers need it, and for a query that has been moved from.
  Answer collide(const Pose& a, const Pose& b) { return collide(a.exact(), b.exact()); }

  /// Returns the answer for poses of the templates (`exact`). Requires det M != 0.
  Answer collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Same, when one query serves many pairs of these bodies. `memory` keeps what was learnt about this pair; it changes
  /// speed, never the answer. Requires the memory of this pair (tetracone/tetratree/memory/pair_memory.h).
  Answer collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, tetratree::Pair_memory& memory);

  /// Returns the answers for n poses of each body. One pose of either body serves all n of the other. Throws Error for
  /// other counts, and as above.
  std::vector<Answer> collide(std::span<const Pose> poses_a, std::span<const Pose> poses_b);

  /// Returns all pairs of an edge of one body and a face of the other that share a point, with the kind of contact,
  /// sorted. Throws as `collide`.
  std::vector<Feature_pair> features(const Pose& a, const Pose& b) { return features(a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  std::vector<Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Returns all pairs of faces that share a point, and where. Throws Error for a kernel that is not exact
  /// (`is_exact`), and as `collide`.
  Contacts contacts(const Pose& a, const Pose& b) { return contacts(a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Returns the double nearest to the exact distance of the solids, 0 where they collide, or of the surfaces under
  /// `Question::surface`. The fast tree answers, whatever the method. The kernels adaptive and rational are exact,
  /// double rounds. Throws Error for other kernels, and as `collide`.
  double distance(const Pose& a, const Pose& b) { return distance(a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  double distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Returns the squared distance and two nearest points, exactly, and what holds them. Where several pairs are
  /// nearest, it is one of them. Throws Error for a kernel that is not adaptive or rational, and as `collide`.
  Nearest nearest(const Pose& a, const Pose& b) { return nearest(a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Nearest nearest(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// True when the distance is at most `limit`, decided exactly on squares (the kernel double rounds); false for a
  /// negative limit. Throws Error for a limit that is not finite or no number, and as `distance`.
  bool within(const Pose& pose_a, const Pose& pose_b, double limit);
  /// Same, for a decimal, which stands for the nearest double, or a fraction "n/d".
  bool within(const Pose& a, const Pose& b, const std::string& limit) { return within(a.exact(), b.exact(), limit); }
  /// Same, for poses of the templates. Requires det M != 0.
  bool within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit);

  /// Returns which of the eight relations of solids holds, and the dimension of what the surfaces share. Throws Error
  /// for `Question::surface`, for a kernel that is not adaptive, and as `collide`.
  Solid_contact solid_relation(const Pose& a, const Pose& b) { return solid_relation(a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Solid_contact solid_relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Returns the relation alone. It ends at the first proper crossing, at about the price of `collide`; a dimension
  /// needs all contacts. Throws as `solid_relation`.
  Solid_relation solid_relation_alone(const Pose& a, const Pose& b)
  {
    return solid_relation_alone(a.exact(), b.exact());
  }
  /// Same, for poses of the templates. Requires det M != 0.
  Solid_relation solid_relation_alone(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Returns the volume and the centroid of the overlap, and the area of contact, exactly. Throws as `solid_relation`.
  Overlap overlap(const Pose& a, const Pose& b) { return overlap(a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Overlap overlap(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Returns bounds of the volume and the centroid, by interval arithmetic where that suffices, in a small part of the
  /// time of `overlap`. Else all are computed exactly, and the bounds of each are equal or neighbours. Throws as
  /// `solid_relation`.
  Overlap_bounds overlap_bounds(const Pose& a, const Pose& b) { return overlap_bounds(a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Overlap_bounds overlap_bounds(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

  /// Returns how far A must be moved along a direction, in lengths of it, for the interiors to part: at first, and for
  /// good. Throws Error for a direction of 0, for a number that is not finite, and as `solid_relation`.
  Exits exits(const Pose& pose_a, const Pose& pose_b, const std::array<double, 3>& direction);
  /// Same, for decimals, which stand for the nearest doubles, or fractions "n/d".
  Exits exits(const Pose& pose_a, const Pose& pose_b, const std::array<std::string, 3>& direction);
  /// Same, for poses of the templates. Requires det M != 0.
  Exits exits(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::array<std::string, 3>& direction);

  /// Returns a bracket of the length of the least translation of A after which the interiors share no point. It
  /// includes a translation of the upper length. The bracket is never wrong; it is as narrow as asked, unless the
  /// budget ends before. Throws Error for a relative width that is not in [0, 1), and as `solid_relation`.
  Depth depth(const Pose& pose_a, const Pose& pose_b, const Depth_options& options = {});
  /// Same, for poses of the templates. Requires det M != 0.
  Depth depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth_options& options = {});

  /// Returns the faces of A, in order, that have a point at most `limit` from B, decided on squares, exactly. There are
  /// none for a negative limit. B is its solid, or its surface under `Question::surface`. The limit is as for `within`.
  /// Throws Error as `nearest` and `within`.
  std::vector<Index> zone(const Pose& pose_a, const Pose& pose_b, const std::string& limit);
  /// Same, for poses of the templates. Requires det M != 0.
  std::vector<Index> zone(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit);

  /// Returns a lower bound of the distance after the answer `apart`, in the units of the placed coordinates; 0 if
  /// `collide` did not compute one.
  double certified_gap() const;

  /// Returns exact bounds of the first time at which the moving bodies share a point; nothing if they never do. The
  /// question matters at t = 0 alone. Solids that do not collide at t = 0 first meet where their surfaces do. The fast
  /// tree answers. Requires that neither motion begins with a singular M. Throws Error for a kernel that is not
  /// adaptive, for a face that is no triangle and has no triangles, and as `collide`.
  std::optional<First_contact> first_contact(const Motion& a, const Motion& b);

  /// Returns the counts of work since the last `clear_statistics`.
  Query_statistics statistics() const;
  /// Sets all counts to 0.
  void clear_statistics();

  /// Returns the bytes of both trees, as far as they have been made, and of what `collide` keeps.
  std::size_t bytes() const;
  /// Returns the number of the trees' nodes that have been made.
  std::size_t node_count() const;

 private:
  friend class Certificate;
  detail::Query_data& data() const;

  std::unique_ptr<detail::Query_data> data_;
};

}  // namespace tetracone

#endif
