#ifndef TETRACONE_VERIFY_PROOFS_PROVED_BOUND_H
#define TETRACONE_VERIFY_PROOFS_PROVED_BOUND_H

#include "tetracone/kernel/number/number.h"

#include <string>
#include <vector>

namespace tetracone::verify::proofs {

using kernel::Rational;

/// A constant of an error bound in the code, and the least value that is proved to be enough. Both are plain numbers.
struct Proved_bound {
  std::string name, file;  ///< the file that defines the constant, below its package's folder
  Rational in_code, proved;
  double unit;             ///< the unit in which tables show both: u, u^2, 1, or another one
  double loosest;          ///< in_code over proved may be at most this; a test finds a constant that became loose
  std::string by;          ///< "gappa"; or "rationals" or "intervals", by which our own code computes the bound
  std::string proof = {};  ///< the file of the proof, which `all_proofs` adds
};

using Proved_bounds = std::vector<Proved_bound>;

/// Returns x to the power n, exactly. Requires n >= 0.
inline Rational power(const Rational& x, int n)
{
  Rational all = 1;
  for (int k = 0; k < n; ++k) all *= x;
  return all;
}

}  // namespace tetracone::verify::proofs

#endif
