#ifndef TETRACONE_VERIFY_CASES_CASE_H
#define TETRACONE_VERIFY_CASES_CASE_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// The kind of a case file: one predicate on a few points, or two polyhedra.
enum class Case_kind { predicate, object };

/// The origin of a case, from which it can be made again.
struct Origin {
  std::string family;  ///< the family's name
  std::uint64_t seed = 0, index = 0;
  double parameter = 0;
};

/// The predicates under study. Answers are small integers. Sets are closed, so touching counts.
enum class Predicate {
  orientation,       ///< the sign of det[v1-p, v2-p, v3-p], which is minus that of [v1, v2, v3, p]: -1, 0 or 1
  tetra_cone,        ///< 1 when p is in the closed cone from v0 through v1, v2, v3 (for v0..v3 in one plane: not asked)
  tetrahedron,       ///< 1 when p is in the closed tetrahedron v0 v1 v2 v3 (in one plane: not asked)
  segment_triangle,  ///< 1 when the closed segment pq and the closed triangle v1 v2 v3 share a point; either may be
                     ///< degenerate
  solid,           ///< where p is in the solid bounded by the faces of v0 v1 v2 v3, by the covering whose origin is q:
                   ///< 1 inside, 0 on the surface, -1 outside
  classification,  ///< 1 when the closed triangle p q r meets the closed cone from v0 through v1, v2, v3. Then JS08
                   ///< classifies the tetrahedron v0 p q r in it. It is not asked with v0 in the plane of either
                   ///< triangle.
  triangle_triangle  ///< 1 when the closed triangles v1 v2 v3 and p q r share a point; either may be degenerate
};
inline constexpr std::array all_predicates = {
    Predicate::orientation, Predicate::tetra_cone,     Predicate::tetrahedron,      Predicate::segment_triangle,
    Predicate::solid,       Predicate::classification, Predicate::triangle_triangle};

inline const char* to_string(Case_kind level) { return level == Case_kind::predicate ? "predicate" : "object"; }
inline const char* to_string(Predicate predicate)
{
  constexpr std::array names = {"orientation", "tetra-cone",     "tetrahedron",      "segment-triangle",
                                "solid",       "classification", "triangle-triangle"};
  return names[static_cast<std::size_t>(predicate)];
}

/// Seven points on which every predicate can be asked. Body A under pose_a has v0 v1 v2 v3, and body B under pose_b has
/// p q r.
struct Predicate_case {
  std::array<kernel::Vertex, 4> v;
  kernel::Vertex p, q, r;
  kernel::Pose pose_a, pose_b;
  Origin origin;
};

/// The relation of two placed solids, and the intersection of their interiors.
struct Solid_overlap {
  kernel::Solid_contact contact;
  kernel::Rational volume = 0;
  std::array<kernel::Rational, 3> centroid = {0, 0, 0};  ///< 0 where the volume is 0

  friend bool operator==(const Solid_overlap&, const Solid_overlap&) = default;
};

/// The area that the surfaces of two placed solids share.
struct Shared_area {
  /// The sum of area times A's outward unit normal, where A is on one side.
  std::array<kernel::Rational, 3> vector = {0, 0, 0};
  std::vector<kernel::Rational> squares;  ///< of the areas, those of parallel planes added up; sorted

  friend bool operator==(const Shared_area&, const Shared_area&) = default;
};

/// How far A must be moved to leave B, in lengths of a direction: at first, and for good.
struct Solid_exits {
  kernel::Rational first = 0, last = 0;

  friend bool operator==(const Solid_exits&, const Solid_exits&) = default;
};

/// The exits along a direction that a family has counted.
struct Counted_exits {
  std::array<kernel::Rational, 3> direction;
  Solid_exits exits;
};

/// Two polyhedra with planar faces under two poses. Neighbouring cases of a family may share their polyhedra, so that a
/// subject prepares them only once.
struct Object_case {
  std::shared_ptr<const covering::Polyhedron> a, b;
  kernel::Pose pose_a, pose_b;
  Origin origin;
  std::optional<bool> surface, solid;               ///< the answers, if the family knows them by construction
  std::optional<Solid_overlap> overlap{};           ///< likewise
  std::optional<Shared_area> shared{};              ///< likewise
  std::optional<Counted_exits> exits{};             ///< likewise
  std::optional<kernel::Rational> squared_depth{};  ///< of the least translation that parts the interiors; likewise

  std::optional<bool> known(kernel::Question question) const
  {
    return question == kernel::Question::solid ? solid : surface;
  }
};

}  // namespace tetracone::verify

#endif
