#include "experiments/speed/experiments.h"

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {
namespace {

using tetratree::Config;

/// The table `draw_paper.py` recognises the names by their first word.
std::vector<Contestant> contestants(std::size_t triangles, std::size_t one_in, Turning turning)
{
  std::vector<Contestant> list = {fast(), peer("FCL OBBRSS")};
  const auto add = [&](const std::string& name, const Config& a, const Config& b) {
    list.push_back(paper(name, a, b).every(one_in));
  };
  const Config as_published = Config::paper();
  add("published", as_published, as_published);
  if (turning == Turning::no) return list;

  const auto adjusted = [&](const std::string& name, int rounds, double shorter, double longer) {
    Config config = as_published;
    config.shortening_rounds = rounds;
    config.shorten_by = shorter;
    config.lengthen_by = longer;
    add("adjusted " + name, config, config);
  };
  adjusted("in no round", 0, 0, 0);
  adjusted("by 10 % and 5 %", as_published.shortening_rounds, 0.1, 0.05);
  adjusted("by 3 % and 1.5 %", as_published.shortening_rounds, 0.03, 0.015);
  adjusted("by 1 % and 0.5 %", 3 * as_published.shortening_rounds, 0.01, 0.005);

  const int first = triangles > 2000 ? 4 : 2;
  for (int depth = first; depth <= first + 3; ++depth)
    for (const int less_in_b : {0, 2}) {
      Config a = as_published, b = as_published;
      a.depth = depth;
      b.depth = depth - less_in_b;
      add("depth " + std::to_string(a.depth) + " and " + std::to_string(b.depth), a, b);
    }
  return list;
}

}  // namespace

void run_paper(const Experiment_options& options)
{
  constexpr int passes = 3;
  constexpr double seconds = 0.1;
  const auto objects = std::make_shared<Race_objects>(options.models);
  std::vector<Table_part> parts;
  for (const auto& [name, triangles] :
       {std::pair<std::string, std::size_t>{"bunny", 760}, std::pair<std::string, std::size_t>{"dino", 7172}})
    for (const std::string trajectory : {"circular", "contour"})
      for (const int ratio : {1, 2, 4, 8, 16})
        for (const Turning turning : {Turning::yes, Turning::no}) {
          const std::string part =
              trajectory + (turning == Turning::yes ? "-" : "-not-turning-") + name + "-" + std::to_string(ratio);
          const std::uint64_t seed = options.seed + 1000 * std::uint64_t(parts.size() / 2);  // the same way for both
          const std::size_t one_in = triangles > 2000 && !options.full ? 10 : 1;
          parts.push_back({part, [=, name = name, triangles = triangles] {
                             const Race_course course = on_trajectory((*objects)(name, triangles), name, trajectory,
                                                                      ratio, options.race_frames, seed, 1, turning);
                             return race_rows(course, contestants(triangles, one_in, turning), false, passes, seconds,
                                              options);
                           }});
        }
  write_table(options.out, "paper", parts);
  draw("draw_paper.py", options.out);
}

}  // namespace tetracone::experiments
