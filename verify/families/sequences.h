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
  std::optional<int> changes;  ///< how often the answer to `Question::surface` changes between successive frames;
                               ///< nothing where the motion does not tell
};

/// Slidings of faces, edges and vertices, rollings over edges, passages through contact, slidings an ulp apart, and
/// bodies in cavities and tunnels. Each is given in the bodies' own frame and under one exact rotation of both. Frames
/// advance by dyadic steps or rational rotations. Equal seeds and numbers of frames give equal sequences. Requires at
/// least 3 frames.
std::vector<Sequence> sequences(std::uint64_t seed, int frames);

}  // namespace tetracone::verify

#endif
