#include "experiments/report/draw_report.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace tetracone::experiments {

void draw_report(const std::filesystem::path& out)
{
  if (out.native().find('\'') != std::string::npos) throw std::runtime_error("the folder's name holds a quote; expected one without");
  const std::string command = "/usr/bin/python3 '" TETRACONE_SOURCE_DIR "/experiments/report/report.py' '" + out.native() + "'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("the figures could not be drawn; expected python3 with matplotlib");
}

}  // namespace tetracone::experiments
