#ifndef TETRACONE_VERIFY_TEST_SUPPORT_KEEP_ENVIRONMENT_H
#define TETRACONE_VERIFY_TEST_SUPPORT_KEEP_ENVIRONMENT_H

#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace tetracone::verify {

/// Restores the calling thread's floating-point environment at the end of the scope.
class Keep_environment {
 public:
  Keep_environment() { std::fegetenv(&environment_); }
  ~Keep_environment() { std::fesetenv(&environment_); }
  Keep_environment(const Keep_environment&) = delete;

 private:
  std::fenv_t environment_;
};

/// Calls `ask` in every environment that is not sound: three directed roundings and, if such flags exist, flush-to-zero
/// and denormals-are-zero.
template <class Ask>
void in_unsound_environments(const Ask& ask)
{
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Keep_environment keep;
    std::fesetround(mode);
    ask();
  }
#if defined(__SSE2__)
  for (const unsigned bits : {0x8000u, 0x0040u, 0x8040u}) {
    const Keep_environment keep;
    _mm_setcsr(_mm_getcsr() | bits);
    ask();
  }
#endif
}

/// Returns the number of such environments in which `ask` did not throw an Exception.
template <class Exception, class Ask>
int not_refused(const Ask& ask)
{
  int missed = 0;
  in_unsound_environments([&] {
    try {
      ask();
      ++missed;
    } catch (const Exception&) {
    }
  });
  return missed;
}

}  // namespace tetracone::verify

#endif
