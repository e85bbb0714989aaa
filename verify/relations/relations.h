#ifndef TETRACONE_VERIFY_RELATIONS_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_RELATIONS_H

#include "verify/relations/level.h"
#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/predicate_subject.h"
#include "verify/subjects/probe_subject.h"
#include "verify/subjects/scene_subject.h"

#include <span>

/// The levels, and the relations of each, in the order of their numbers.
///
/// The numbers R1 to R13 are parts of the relations' names. R12 (signs in vectors equal scalar ones) is no relation of
/// cases. The tests of kernel/bound and tetratree/fast compare each version of the vectors with scalar arithmetic.
namespace tetracone::verify {

/// Predicates on seven points.
using Predicate_level = Level<Predicate_case, int, Running_predicates, Predicate>;
std::span<const Predicate_level::Relation> predicate_relations();

/// Two bodies: whether they collide.
using Object_level = Level<Object_case, Nothing, Running_subject>;
std::span<const Object_level::Relation> object_relations();

/// Two bodies: which features of their surfaces meet.
using Feature_level = Level<Object_case, Feature_pairs, Running_subject>;
std::span<const Feature_level::Relation> feature_relations();

/// Two bodies: where their faces meet.
using Contact_level = Level<Object_case, Contact_forms, Running_subject>;
std::span<const Contact_level::Relation> contact_relations();

/// Two bodies: how far apart they are.
using Distance_level = Level<Object_case, Distance_answer, Running_subject>;
std::span<const Distance_level::Relation> distance_relations();

/// Two bodies: which of the eight relations of solids holds, and how much they overlap.
using Solid_level = Level<Object_case, Solid_answer, Running_subject>;
std::span<const Solid_level::Relation> solid_relations();

/// Two bodies: how far one must be moved to leave the other.
using Exit_level = Level<Object_case, Exit_answer, Running_subject>;
std::span<const Exit_level::Relation> exit_relations();

/// A body: where a point is.
using Point_level = Level<Probe_case, int>;
std::span<const Point_level::Relation> point_relations();

/// A body: which faces a ray meets.
using Ray_level = Level<Probe_case, Ray_answer>;
std::span<const Ray_level::Relation> ray_relations();

/// Many bodies: which of them collide.
using Scene_level = Level<Scene_case, Frames_of_pairs>;
std::span<const Scene_level::Relation> scene_relations();

/// Two bodies in motion: when their surfaces first meet.
using Motion_level = Level<Moving_bodies, kernel::Time_bounds, Running_motion>;
std::span<const Motion_level::Relation> moving_body_relations();

}  // namespace tetracone::verify

#endif
