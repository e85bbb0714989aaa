#ifndef TETRACONE_VERIFY_FAMILIES_SEQUENCES_H
#define TETRACONE_VERIFY_FAMILIES_SEQUENCES_H

#include "verify/cases/case.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// Two bodies in motion, frame by frame: an exact contact that is kept, met or just missed.
struct Sequence {
  std::string name;  ///< "box sliding on a box, turned"
  std::vector<Object_case> frames;
  std::optional<int> changes;  ///< how often the answer to `Question::surface` changes from a frame to the next, where
                               ///< the motion tells
};

/// Slidings of faces, edges and vertices, rollings over edges, passages through contact, slidings an ulp apart, bodies
/// in cavities and tunnels: each in the bodies' own frame, and under one true rotation of both. Frame to frame by
/// dyadic steps or rational rotations. The same for the same seed and number of frames. Requires at least 3 frames.
std::vector<Sequence> sequences(std::uint64_t seed, int frames);

}  // namespace tetracone::verify

#endif
