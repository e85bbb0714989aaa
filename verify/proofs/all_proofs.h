#ifndef TETRACONE_VERIFY_PROOFS_ALL_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_ALL_PROOFS_H

#include "verify/proofs/proved_bound.h"

#include <string>

namespace tetracone::verify::proofs {

/// Every proof of a constant. Requires Gappa: throws std::runtime_error without it.
Proved_bounds all_proofs();

/// Those of one header of this folder, by what stands before `_proofs.h` in its name. Requires that there is one, and
/// Gappa as above.
Proved_bounds proofs_of(const std::string& header);

/// The worst error that a search by hill climbing finds for a constant, in its unit; negative where none looks for it.
/// Truth is rational. The same seed finds the same.
double worst_found(const std::string& name, int steps, unsigned seed);

/// Why no search looks for a constant's worst error; empty where one does.
std::string why_not_searched(const std::string& name);

}  // namespace tetracone::verify::proofs

#endif
