// All targets are one program, since they share most of what they compile: the environment's TARGET names one.

#include "verify/fuzz/fuzz_targets.h"

#include <cstdio>
#include <map>
#include <string_view>

namespace {

using Target = void (*)(const std::uint8_t*, std::size_t);

Target target()
{
  using namespace tetracone::verify;
  const std::map<std::string_view, Target> targets = {
      {"case", fuzz_case},   {"distance", fuzz_distance}, {"model", fuzz_model},           {"points", fuzz_points},
      {"poses", fuzz_poses}, {"query", fuzz_query},       {"saved_body", fuzz_saved_body}, {"signs", fuzz_signs}};
  const char* const name = std::getenv("TARGET");
  const auto found = targets.find(name ? name : "");
  if (found != targets.end()) return found->second;
  std::fputs("TARGET: no such target; expected", stderr);
  for (const auto& [known, asked] : targets) std::fprintf(stderr, " %s", known.data());
  std::fputs("\n", stderr);
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Target asked = target();
  asked(data, size);
  return 0;
}
