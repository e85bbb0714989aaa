// Tells what a user's unit does under its flags. Status 0: the library would answer. Status 3: it refuses at run time.
// Status 4: a number rounded to float is not what was written.
#include "tetracone/kernel/number/floating_point.h"

#include <cstdio>

namespace {

struct Three_doubles {
  double x[3];
};
struct Three_floats {
  float x[3];
};

/// Rounds three numbers to float, and returns what the floats are: g++ 12 at -O3 returned two of them unrounded.
[[gnu::noinline]] Three_doubles rounded(Three_floats& floats, const Three_doubles& low, const Three_doubles& high)
{
  Three_doubles doubles;
  for (int k = 0; k < 3; ++k) doubles.x[k] = floats.x[k] = tetracone::kernel::to_float(0.5 * (low.x[k] + high.x[k]));
  return doubles;
}

}  // namespace

int main()
try {
  tetracone::kernel::require_exact_arithmetic();
  Three_floats floats;
  const Three_doubles doubles = rounded(floats, {{0.1, 0.2, 0.3}}, {{0.1, 0.2, 0.3}});
  for (int k = 0; k < 3; ++k)
    if (doubles.x[k] != double(floats.x[k])) return 4;
} catch (const tetracone::kernel::Unsound_floating_point& e) {
  std::puts(e.what());
  return 3;
}
