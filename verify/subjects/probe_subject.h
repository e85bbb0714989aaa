#ifndef TETRACONE_VERIFY_SUBJECTS_PROBE_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_PROBE_SUBJECT_H

#include "tetracone/tetratree/ray_hit.h"
#include "verify/cases/probe_case.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

using tetratree::Ray_hit;

/// A subject's answer for a ray.
struct Told_hits {
  std::optional<Ray_hit> first;
  std::vector<Ray_hit> all;
};

/// A running subject for points or rays, for one thread. It keeps what it prepared for the body of the last case.
/// Nothing as an answer means that it failed.
class Running_probe {
 public:
  virtual ~Running_probe() = default;

  /// Returns 1 inside, 0 on the surface, -1 outside. Requires a closed body.
  virtual std::optional<int> where(const Probe_case&) { return std::nullopt; }

  /// Returns the hits of the ray. Requires a direction that is not 0.
  virtual std::optional<Told_hits> hits(const Probe_case&) { return std::nullopt; }
};

/// A method that answers where points are, or which faces rays meet.
struct Probe_subject {
  std::string name;  ///< "adaptive locator", "double covering"
  bool is_exact = false;
  std::function<std::unique_ptr<Running_probe>()> make;
};

/// Subjects for points: the library's `Body::inside` of bodies triangulated, whole and placed by fractions; and JS08's
/// signed sums over the whole covering by some kernels.
std::vector<Probe_subject> point_subjects();

/// Subjects for rays: the library's `Body::hits` and `first_hit` of bodies triangulated and whole; and, in double, the
/// field's usual test of each triangle by Moeller and Trumbore.
std::vector<Probe_subject> ray_subjects();

}  // namespace tetracone::verify

#endif
