// Reads a model file of any bytes. It must be checked and repaired, or refused with Input_error; nothing else. The
// environment variable FORMAT is the suffix.

#include "tetracone/covering/check.h"
#include "tetracone/covering/covering.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/orient.h"
#include "tetracone/covering/repair/repair.h"
#include "verify/fuzz/fuzz_targets.h"
#include "verify/fuzz/scratch_file.h"

#include <cstdint>
#include <cstdlib>
#include <string>

using namespace tetracone;

void tetracone::verify::fuzz_model(const std::uint8_t* data, std::size_t size)
{
  static const tetracone::verify::Scratch_file file([] {
    const char* format = std::getenv("FORMAT");
    return "." + std::string(format == nullptr ? "off" : format);
  }());
  file.write(data, size);
  covering::Polyhedron polyhedron;
  try {
    polyhedron = covering::read_model(file.path()).polyhedron;
  } catch (const tetracone::covering::Input_error&) {
    return;
  }
  const covering::Check check = covering::check(polyhedron);
  const auto repaired = covering::triangulate_non_planar(polyhedron);
  const auto oriented = covering::orient(polyhedron);
  // The contract of repair: it leaves only planar faces, and keeps a closed body closed.
  if (!covering::triangulate_non_planar(repaired.polyhedron).replaced.empty()) std::abort();
  if (covering::is_closed(polyhedron) && !covering::is_closed(repaired.polyhedron)) std::abort();
  if (covering::is_closed(polyhedron) != check.open_edges.empty()) std::abort();
  if (oriented.polyhedron.face_count() != polyhedron.face_count()) std::abort();
}
