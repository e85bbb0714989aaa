#ifndef TETRACONE_KERNEL_PREDICATE_QUESTION_H
#define TETRACONE_KERNEL_PREDICATE_QUESTION_H

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tetracone::kernel {

/// The question about two placed polyhedra.
enum class Question {
  solid,  ///< do the two closed solids share a point? One inside the other collides, one inside the other's cavity does
          ///< not
  surface  ///< do the two closed surfaces share a point? Touching in a single point counts
};

/// Returns "solid" or "surface".
constexpr std::string_view to_string(Question question) { return question == Question::solid ? "solid" : "surface"; }

/// Returns the question of that name; nothing when there is none.
constexpr std::optional<Question> parse_question(std::string_view name)
{
  if (name == "solid") return Question::solid;
  if (name == "surface") return Question::surface;
  return std::nullopt;
}

/// The relation of two placed bodies.
enum class Relation {
  apart,     ///< no common point of the solids or surfaces asked about
  surfaces,  ///< the surfaces share a point
  a_in_b,    ///< solids: the surfaces share none, and a shell of A is inside B
  b_in_a     ///< solids: the other way round
};

/// Returns the enumerator's own name.
constexpr std::string_view to_string(Relation relation)
{
  constexpr std::array<std::string_view, 4> names = {"apart", "surfaces", "a_in_b", "b_in_a"};
  return names[std::size_t(relation)];
}

/// The eight relations of two placed solids A and B: exactly one holds. The interior of a solid is the set of points
/// that have a whole ball around them inside it. (Names by Egenhofer; RCC-8 has the same eight.)
enum class Solid_relation {
  disjoint,    ///< A and B share no point
  meet,        ///< they share a point, their interiors share none, neither contains the other
  overlap,     ///< their interiors share a point, neither contains the other
  equal,       ///< A and B are one set of points, however it is divided into faces
  inside,      ///< A lies in the interior of B
  contains,    ///< B lies in the interior of A
  covered_by,  ///< A lies in B, not in its interior, and is not B
  covers       ///< B lies in A, not in its interior, and is not A
};

/// Returns the enumerator's own name.
constexpr std::string_view to_string(Solid_relation relation)
{
  constexpr std::array<std::string_view, 8> names = {"disjoint", "meet",     "overlap",    "equal",
                                                     "inside",   "contains", "covered_by", "covers"};
  return names[std::size_t(relation)];
}

/// The relation of two placed solids, and the dimension of the set that their surfaces share.
struct Solid_contact {
  Solid_relation relation;
  int dimension;  ///< of the shared set: 0 points alone, 1 a segment and no area, 2 an area; -1 where it is empty

  /// True when both members are equal.
  friend bool operator==(const Solid_contact&, const Solid_contact&) = default;
};

}  // namespace tetracone::kernel

#endif
