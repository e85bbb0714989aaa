#include "verify/campaign/family_lines.h"

#include "tetracone/kernel/number/number.h"
#include "verify/campaign/levels.h"

#include <algorithm>

namespace tetracone::verify {

std::vector<Family_line> family_lines()
{
  std::vector<Family_line> lines;
  For_levels<Asked> levels;
  for_each_level(levels, [&]<class Level>(const Asked<Level>&) {
    for (const auto* family : Level::families()) {
      const auto known = std::ranges::find(lines, family->name, &Family_line::name);
      if (known != lines.end())
        known->levels += " " + std::string(Level::name);
      else
        lines.push_back({std::string(Level::name), family->name, family->what, family->parameter, family->sweep});
    }
  });
  return lines;
}

std::string sweep_text(const Family_line& line)
{
  std::string text;
  for (auto value = line.sweep.begin(); value != line.sweep.end(); ++value)
    if (std::find(line.sweep.begin(), value, *value) == value)
      text += (text.empty() ? "" : " ") + kernel::shortest(*value);
  return text;
}

}  // namespace tetracone::verify
