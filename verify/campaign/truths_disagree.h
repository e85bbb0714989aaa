#ifndef TETRACONE_VERIFY_CAMPAIGN_TRUTHS_DISAGREE_H
#define TETRACONE_VERIFY_CAMPAIGN_TRUTHS_DISAGREE_H

#include "verify/cases/case.h"
#include "verify/cases/probe_case.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace tetracone::verify {

/// Thrown when the two truths, or a truth and a family's known answer, differ for one case. One of them is wrong, and
/// no result of the campaign could be trusted.
class Truths_disagree : public std::runtime_error {
 public:
  Truths_disagree(const std::string& what, Object_case c, kernel::Question question)
      : std::runtime_error(what), object(std::move(c)), question(question)
  {}
  Truths_disagree(const std::string& what, const Probe_case& c)
      : Truths_disagree(what, as_objects(c), kernel::Question::surface)
  {}
  Truths_disagree(const std::string& what, Predicate_case c, Predicate predicate)
      : std::runtime_error(what), points(std::move(c)), predicate(predicate)
  {}

  std::optional<Object_case> object;
  kernel::Question question = kernel::Question::solid;
  std::optional<Predicate_case> points;
  Predicate predicate = Predicate::orientation;
};

}  // namespace tetracone::verify

#endif
