#ifndef TETRACONE_KERNEL_PREDICATE_QUESTION_H
#define TETRACONE_KERNEL_PREDICATE_QUESTION_H

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
  switch (relation) {
    case Relation::apart: return "apart";
    case Relation::surfaces: return "surfaces";
    case Relation::a_in_b: return "a_in_b";
    case Relation::b_in_a: return "b_in_a";
  }
  return "apart";
}

}  // namespace tetracone::kernel

#endif
