#ifndef TETRACONE_VERIFY_PROOFS_ALL_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_ALL_PROOFS_H

#include "verify/proofs/proved_bound.h"

namespace tetracone::verify::proofs {

/// Every proof of a constant. Requires Gappa: throws std::runtime_error without it.
Proved_bounds all_proofs();

}  // namespace tetracone::verify::proofs

#endif
