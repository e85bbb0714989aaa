#ifndef TETRACONE_VERIFY_RELATIONS_PROBE_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_PROBE_RELATIONS_H

#include "verify/relations/metamorphic_relations.h"
#include "verify/subjects/probe_subject.h"

#include <span>
#include <string_view>

namespace tetracone::verify {

/// A relation between a subject's answers for a point or a ray and for twins that were made without rounding.
struct Probe_relation {
  std::string_view name, what;
  Verdict (*check)(const Probe_case& c, Running_probe& subject, Random& random);
};

/// Returns the relations of points.
std::span<const Probe_relation> point_relations();

/// Returns the relations of rays.
std::span<const Probe_relation> ray_relations();

}  // namespace tetracone::verify

#endif
