#include "verify/families/family_lines.h"

#include "tetracone/kernel/number/number.h"
#include "verify/families/distance_families.h"
#include "verify/families/families.h"
#include "verify/families/moving_body_families.h"
#include "verify/families/probe_families.h"
#include "verify/families/scene_families.h"

#include <algorithm>

namespace tetracone::verify {

std::vector<Family_line> family_lines()
{
  std::vector<Family_line> lines;
  const auto add = [&lines](std::string_view levels, const auto& families) {
    for (const auto& family : families)
      lines.push_back({levels, family.name, family.what, family.parameter, family.sweep});
  };
  add("predicate object features contacts distances", families());
  add("distances", distance_families());
  add("points", point_families());
  add("rays", ray_families());
  add("scenes", scene_families());
  for (const Moving_body_family& family : moving_body_families())
    lines.push_back({"motions", family.name, family.what, "", {}});
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
