#include "experiments/speed/experiments.h"

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {
namespace {

std::vector<Contestant> contestants(std::size_t triangles)
{
  std::vector<Contestant> list = {fast(), fast_with_last_frame(), peer("FCL OBBRSS"), peer("CGAL RMCD EPICK", 20)};
  if (triangles <= 10000) list.push_back(paper("tetra-tree tuned in double", tetratree::Config::fastest()).every(10));
  return list;
}

}  // namespace

void run_scaling(const Experiment_options& options)
{
  constexpr int passes = 5;
  constexpr double seconds = 0.3;
  constexpr std::size_t of_poses = 10000;  // the size for which the poses are found
  const auto objects = std::make_shared<Race_objects>(options.models);
  std::vector<std::size_t> sizes = {1000, 3162, 10000, 31623, 100000};
  if (options.full) sizes.insert(sizes.end(), {316228, 1000000});
  std::vector<Table_part> parts;
  for (const std::string name : {"blob", "knot"})
    for (const std::string trajectory : {"circular", "contour"})
      for (const std::size_t triangles : sizes)
        parts.push_back({trajectory + "-" + name + "-" + std::to_string(triangles), [=] {
                           Race_course course = on_trajectory((*objects)(name, of_poses), name, trajectory, 1,
                                                              options.race_frames, options.seed);
                           course.a = course.b = (*objects)(name, triangles);
                           return race_rows(course, contestants(triangles), false, passes, seconds, options);
                         }});
  write_table(options.out, "scaling", parts);
  draw("draw_scaling.py", options.out);
}

}  // namespace tetracone::experiments
