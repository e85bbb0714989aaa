#ifndef TETRACONE_VERIFY_PROOFS_PROOF_H
#define TETRACONE_VERIFY_PROOFS_PROOF_H

// What proofs are written with, in one include.

#include "tetracone/kernel/number/products.h"
#include "verify/proofs/near_orthonormal.h"
#include "verify/proofs/proved_bound.h"
#include "verify/proofs/range_number.h"
#include "verify/proofs/rounding_count.h"
#include "verify/proofs/slices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#endif
