#ifndef TETRACONE_VERIFY_CASES_PROBE_CASE_H
#define TETRACONE_VERIFY_CASES_PROBE_CASE_H

#include "verify/cases/case.h"

#include <memory>
#include <utility>

namespace tetracone::verify {

/// A point near one body, or the ray from it in a direction, in the body's own coordinates.
struct Probe_case {
  std::shared_ptr<const covering::Polyhedron> body;
  kernel::Vertex from{};
  kernel::Vertex direction{};  ///< of any length; 0: a point
  Origin origin;
};

/// Returns the probe as two bodies, for case files. The point is a face of one vertex, and the ray is the line from it
/// to its position at t = 1.
inline Object_case as_objects(const Probe_case& c)
{
  covering::Polyhedron probe;
  probe.vertices = {{0, 0, 0}};
  if (c.direction == kernel::Vertex{0, 0, 0}) {
    probe.add_polygon({0});
  } else {
    probe.vertices.push_back(c.direction);
    probe.add_polygon({0, 1});
  }
  return {c.body,
          std::make_shared<const covering::Polyhedron>(std::move(probe)),
          kernel::Pose(),
          kernel::Pose::translation(c.from[0], c.from[1], c.from[2]),
          c.origin,
          {},
          {}};
}

}  // namespace tetracone::verify

#endif
