#ifndef TETRACONE_VERIFY_PROOFS_ALL_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_ALL_PROOFS_H

#include "verify/proofs/proved_bound.h"

namespace tetracone::verify::proofs {

/// Returns the proofs of all constants. Throws std::runtime_error without Gappa.
Proved_bounds all_proofs();

}  // namespace tetracone::verify::proofs

#endif
