// Reads a file of poses, or of points, of any bytes. It must be read or refused with Input_error; nothing else.

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_points.h"
#include "tetracone/covering/io/read_poses.h"
#include "verify/fuzz/fuzz_targets.h"
#include "verify/fuzz/scratch_file.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace tetracone;

void tetracone::verify::fuzz_poses(const std::uint8_t* data, std::size_t size)
{
  static const tetracone::verify::Scratch_file file(".txt");
  file.write(data, size);
  try {
    for (const kernel::Pose& pose : covering::read_poses(file.path())) {
      if (pose.determinant_sign() == CGAL::ZERO) std::abort();
      for (int k = 0; k < 12; ++k)
        if (!std::isfinite(pose[k])) std::abort();
    }
  } catch (const covering::Input_error&) {
  }
  try {
    for (const auto& point : covering::read_points(file.path()))
      for (const auto& number : point)
        if (!std::isfinite(number.nearest)) std::abort();
  } catch (const covering::Input_error&) {
  }
}
