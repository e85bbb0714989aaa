#ifndef TETRACONE_VERIFY_PROOFS_SLICES_H
#define TETRACONE_VERIFY_PROOFS_SLICES_H

#include "verify/proofs/gappa_script.h"
#include "verify/proofs/recorded.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tetracone::verify::proofs {

/// Inputs of an expression that select one of its terms: 1 for the term's factors, 0 for all others.
using Slice = std::vector<double>;

/// Returns the n slices of a sum of n terms.
inline std::vector<Slice> slices_of_sum(std::size_t n)
{
  std::vector<Slice> slices(n, Slice(n, 0));
  for (std::size_t k = 0; k < n; ++k) slices[k][k] = 1;
  return slices;
}

/// Returns the slice of n inputs that has 1 in these places.
inline Slice slice_of(std::size_t n, const std::vector<int>& places)
{
  Slice slice(n, 0);
  for (const int place : places) slice[std::size_t(place)] = 1;
  return slice;
}

/// Returns the slices of a sum of scalar products of n inputs: the first three times the three from each of `factors`
/// on. Each slice has the inputs `always`, too.
inline std::vector<Slice> slices_of_dot(std::size_t n = 6, const std::vector<int>& factors = {3},
                                        const std::vector<int>& always = {})
{
  std::vector<Slice> slices;
  for (int k = 0; k < 3; ++k)
    for (const int factor : factors) {
      slices.push_back(slice_of(n, always));
      slices.back()[std::size_t(k)] = slices.back()[std::size_t(factor + k)] = 1;
    }
  return slices;
}

/// Returns the 6 slices of a determinant. Its nine entries are the inputs, row by row.
inline std::vector<Slice> slices_of_determinant()
{
  std::vector<Slice> slices;
  std::array<int, 3> column = {0, 1, 2};
  do {
    Slice slice(9, 0);
    for (int row = 0; row < 3; ++row) slice[3 * row + column[row]] = 1;
    slices.push_back(slice);
  } while (std::next_permutation(column.begin(), column.end()));
  return slices;
}

/// Returns the rounding error of each slice of an expression, as Gappa proves it in the standard model.
///
/// Keep the factors 1 + e of all roundings. An expression that is a sum of products of its inputs, each input at most
/// once in each product, stays one. Its error is the sum, over the products, of the product of the inputs times the
/// slice's error. Errors are therefore bounded by sums of magnitudes of products times the returned numbers, for inputs
/// of every scale. `expression` is a template over std::vector<Recorded<...>>.
template <class Arithmetic, class Expression>
std::vector<Rational> slice_errors(const Expression& expression, const std::vector<Slice>& slices)
{
  Gappa_script script;
  for (const Slice& slice : slices) {
    std::vector<Recorded<Arithmetic>> computed;
    std::vector<Recorded<Exact>> exact;
    for (const double input : slice) {
      // Inputs have names, so that operations know their script; 0 is known to be 0.
      const std::string name = input == 0 ? "0" : script.define(gappa_number(input));
      computed.emplace_back(script, name);
      exact.emplace_back(script, name);
    }
    script.ask(expression(computed).name() + " - (" + expression(exact).name() + ")");
  }
  std::vector<Rational> errors;
  for (const Enclosure& enclosure : script.prove()) errors.push_back(enclosure.magnitude());
  return errors;
}

/// The interval of an input.
struct Range {
  double low, high;
};

/// Returns the rounding error of an expression for inputs in these ranges, as Gappa proves it.
template <class Arithmetic, class Expression>
Rational error_within(const Expression& expression, const std::vector<Range>& ranges)
{
  Gappa_script script;
  std::vector<Recorded<Arithmetic>> computed;
  std::vector<Recorded<Exact>> exact;
  for (const auto& [low, high] : ranges) {
    const std::string name = script.variable(low, high);
    computed.emplace_back(script, name);
    exact.emplace_back(script, name);
  }
  script.ask(expression(computed).name() + " - (" + expression(exact).name() + ")");
  return script.prove()[0].magnitude();
}

/// Returns the largest magnitude of any intermediate result of an expression for inputs in these ranges, as Gappa
/// proves it. It shows whether the expression overflows, which Gappa's numbers do not.
template <class Arithmetic, class Expression>
Rational largest_result(const Expression& expression, const std::vector<Range>& ranges)
{
  Gappa_script script;
  std::vector<Recorded<Arithmetic>> in;
  for (const auto& [low, high] : ranges) in.emplace_back(script, script.variable(low, high));
  expression(in);
  script.ask_for_everything();
  Rational largest = 0;
  for (const Enclosure& enclosure : script.prove()) largest = std::max(largest, enclosure.magnitude());
  return largest;
}

/// Returns the largest. Requires an error.
inline Rational largest(const std::vector<Rational>& errors) { return *std::max_element(errors.begin(), errors.end()); }
/// Returns the sum; 0 if there are none.
inline Rational sum(const std::vector<Rational>& errors)
{
  Rational all = 0;
  for (const Rational& error : errors) all += error;
  return all;
}

}  // namespace tetracone::verify::proofs

#endif
