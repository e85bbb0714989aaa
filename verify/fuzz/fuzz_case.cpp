// Reads a case file of any bytes. It must be refused with Input_error, or be written and read again as an equal case.

#include "tetracone/covering/io/input_error.h"
#include "verify/cases/case_file.h"
#include "verify/fuzz/fuzz_targets.h"

#include <cstdint>
#include <cstdlib>
#include <string>

using namespace tetracone::verify;

void tetracone::verify::fuzz_case(const std::uint8_t* data, std::size_t size)
{
  Case_file file;
  try {
    file = parse_case(std::string(reinterpret_cast<const char*>(data), size), "fuzzed.case.json");
  } catch (const tetracone::covering::Input_error&) {
    return;
  }
  const std::string text = to_json(file);
  if (to_json(parse_case(text, "written.case.json")) != text) std::abort();
}
