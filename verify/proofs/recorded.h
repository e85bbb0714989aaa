#ifndef TETRACONE_VERIFY_PROOFS_RECORDED_H
#define TETRACONE_VERIFY_PROOFS_RECORDED_H

#include "verify/proofs/gappa_script.h"

#include <cassert>
#include <string>
#include <utility>

namespace tetracone::verify::proofs {

// Arithmetics. Each writes the result of an operation, given its exact expression; `entry` is the result for an entry
// of a pose, which may stand for a fraction. IEEE's have none: an expression with entries cannot be run with them.

/// The exact arithmetic, without rounding.
struct Exact {
  static std::string sum(Gappa_script&, const std::string& exact) { return exact; }
  static std::string product(Gappa_script&, const std::string& exact) { return exact; }
  static std::string entry(Gappa_script&, const std::string& exact) { return exact; }
};

/// IEEE 754 rounded to nearest, with gradual underflow. Gappa has no overflow: that is a goal of its own.
struct Ieee_64 {
  static std::string sum(Gappa_script&, const std::string& exact) { return "float<ieee_64, ne>(" + exact + ")"; }
  static std::string product(Gappa_script& script, const std::string& exact) { return sum(script, exact); }
};
struct Ieee_32 {
  static std::string sum(Gappa_script&, const std::string& exact) { return "float<ieee_32, ne>(" + exact + ")"; }
  static std::string product(Gappa_script& script, const std::string& exact) { return sum(script, exact); }
};

/// The standard model (Higham, Accuracy and Stability, section 2.2), without underflow: each result is multiplied by 1
/// + e, |e| <= 2^-`digits`. It does not depend on scale, so a proof for inputs 1 holds for all.
template <int digits>
struct Relative {
  static std::string sum(Gappa_script& script, const std::string& exact)
  {
    return "(" + exact + ") * (1 + " + script.variable("1b-" + std::to_string(digits)) + ")";
  }
  static std::string product(Gappa_script& script, const std::string& exact) { return sum(script, exact); }
  static std::string entry(Gappa_script& script, const std::string& exact) { return sum(script, exact); }
};
using Relative_64 = Relative<53>;
using Relative_32 = Relative<24>;

/// Double-double: relative errors 3 u^2 / (1 - 4 u) of a sum and 7 u^2 of a product, as Joldes, Muller and Popescu
/// prove (see kernel/number/double_double.h); Gappa takes these as given.
struct Relative_double_double {
  static std::string sum(Gappa_script& script, const std::string& exact)
  {
    return "(" + exact + ") * (1 + " + script.variable("0x3.0000001p-106") + ")";
  }
  static std::string product(Gappa_script& script, const std::string& exact)
  {
    return "(" + exact + ") * (1 + " + script.variable("7b-106") + ")";
  }
  static std::string entry(Gappa_script& script, const std::string& exact)
  {
    return "(" + exact + ") * (1 + " + script.variable("1b-106") + ")";
  }
};

/// A number that records its computation: a template over its number type, run with these, writes its own script. A
/// factor or a term 0 is known to be 0; a product with it is 0, but a sum with it is still rounded. Constants belong to
/// no script; an operation requires that an operand belongs to one, unless its result is 0.
template <class Arithmetic>
class Recorded {
 public:
  /// A constant, exactly.
  explicit Recorded(double value) : name_(gappa_number(value)) {}
  Recorded(Gappa_script& script, std::string name) : script_(&script), name_(std::move(name)) {}

  /// Another arithmetic's number, rounded to this one.
  template <class Other>
  explicit Recorded(const Recorded<Other>& other) : script_(other.script()), name_(other.name())
  {
    if (script_ != nullptr && !is_zero()) name_ = script_->define(Arithmetic::sum(*script_, name_));
  }

  const std::string& name() const { return name_; }
  Gappa_script* script() const { return script_; }
  bool is_zero() const { return name_ == "0"; }

  friend Recorded operator+(const Recorded& a, const Recorded& b) { return made<false>(a, b, exact_sum(a, b, '+')); }
  friend Recorded operator-(const Recorded& a, const Recorded& b) { return made<false>(a, b, exact_sum(a, b, '-')); }
  friend Recorded operator*(const Recorded& a, const Recorded& b) { return made<true>(a, b, exact_product(a, b)); }
  friend Recorded operator/(const Recorded& a, const Recorded& b)
  {
    return made<true>(a, b, a.is_zero() ? "0" : a.name_ + " / " + b.name_);
  }
  friend Recorded operator-(const Recorded& a)
  {
    return a.is_zero() || a.script_ == nullptr ? Recorded(nullptr, a.is_zero() ? "0" : "(-" + a.name_ + ")")
                                               : Recorded(a.script_, a.script_->define("-" + a.name_));
  }
  friend Recorded abs(const Recorded& a)
  {
    return a.is_zero() ? a : Recorded(*a.script_, a.script_->define("|" + a.name_ + "|"));
  }

  friend Recorded operator-(float a, const Recorded& b) { return Recorded(a) - b; }
  friend Recorded operator/(float a, const Recorded& b) { return Recorded(a) / b; }

  /// Returns c + a b or, for the sign '-', c - a b, rounded once.
  friend Recorded fused_sum(const Recorded& a, const Recorded& b, const Recorded& c, char sign)
  {
    const std::string product = exact_product(a, b);
    if (product == "0") return made<false>(b, c, c.name_);  // c alone, rounded
    return made<false>(script_of(a, b) != nullptr ? a : c, script_of(a, b) != nullptr ? b : c,
                       c.is_zero() ? (sign == '-' ? "-(" : "(") + product + ")" : c.name_ + " " + sign + " " + product);
  }

  /// A pose's entry.
  friend Recorded entry(const Recorded& a)
  {
    return a.is_zero() ? a : Recorded(a.script_, a.script_->define(Arithmetic::entry(*a.script_, a.name_)));
  }

 private:
  Recorded(Gappa_script* script, std::string name) : script_(script), name_(std::move(name)) {}

  static Gappa_script* script_of(const Recorded& a, const Recorded& b)
  {
    return a.script_ != nullptr ? a.script_ : b.script_;
  }
  static std::string exact_sum(const Recorded& a, const Recorded& b, char sign)
  {
    if (b.is_zero()) return a.name_;
    if (a.is_zero()) return sign == '-' ? "-" + b.name_ : b.name_;
    return a.name_ + " " + sign + " " + b.name_;
  }
  static std::string exact_product(const Recorded& a, const Recorded& b)
  {
    return a.is_zero() || b.is_zero() ? "0" : a.name_ + " * " + b.name_;
  }
  template <bool is_product>
  static Recorded made(const Recorded& a, const Recorded& b, const std::string& exact)
  {
    if (exact == "0") return Recorded(0);
    Gappa_script* const script = script_of(a, b);
    assert(script != nullptr);
    return Recorded(*script,
                    script->define(is_product ? Arithmetic::product(*script, exact) : Arithmetic::sum(*script, exact)));
  }

  Gappa_script* script_ = nullptr;  // null of a constant
  std::string name_;
};

}  // namespace tetracone::verify::proofs

#endif
