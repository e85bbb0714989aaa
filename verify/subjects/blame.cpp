#include "verify/subjects/blame.h"

#include "verify/subjects/blame_stages.h"

namespace tetracone::verify {

std::optional<Stage> blame(const Subject& subject, const Object_case& c, kernel::Question question, bool truth)
{
  using detail::blame_in;
  switch (subject.kernel) {
    case Kernel_name::double_: return blame_in<kernel::Double>(subject.method, c, question, truth);
    case Kernel_name::float_: return blame_in<kernel::Float>(subject.method, c, question, truth);
    case Kernel_name::epick: return blame_in<kernel::Epick>(subject.method, c, question, truth);
    case Kernel_name::double_eps:
      kernel::Tolerant::tolerance() = subject.tolerance;
      return blame_in<kernel::Tolerant>(subject.method, c, question, truth);
    default: return std::nullopt;
  }
}

}  // namespace tetracone::verify
