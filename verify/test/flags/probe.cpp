// What a user's unit does under the flags that it is compiled with: status 0 when the library would answer, 3 when it
// refuses at run time.
#include "tetracone/kernel/number/floating_point.h"

#include <cstdio>

int main()
try {
  tetracone::kernel::require_exact_arithmetic();
} catch (const tetracone::kernel::Unsound_floating_point& e) {
  std::puts(e.what());
  return 3;
}
