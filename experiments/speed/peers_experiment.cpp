#include "experiments/speed/experiments.h"

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {
namespace {

/// The contestants, ours first. Slow ones are asked fewer poses.
std::vector<Contestant> contestants(std::size_t triangles, bool degenerate,
                                    const std::vector<verify::Object_subject>& programs)
{
  const std::size_t many = degenerate ? 20 : 1;
  const bool large = triangles > 20000;
  std::vector<Contestant> list = {
      fast(),
      fast_with_last_frame(),
      fast_in_double(),
      peer("FCL OBBRSS"),
      paper("tetra-tree tuned in double", tetratree::Config::fastest()).every(triangles > 2000 ? 10 : 1),
      paper("tetra-tree as published in double", tetratree::Config::paper()).every(triangles > 2000 ? 20 : 4),
      peer("CGAL RMCD EPICK", (large ? 20 : 4)),
      peer("CGAL RMCD EPECK", (large ? 100 : 20) * many / (degenerate ? 4 : 1)),
      peer("Bullet GImpact", large ? 20 : 4),
      peer("ODE trimesh", large ? 20 : 4),
  };
  if (large)
    std::erase_if(list,
                  [](const Contestant& c) { return c.name.starts_with("tetra-tree"); });  // minutes a pass on what is
                                                                                          // not star-shaped
  for (const verify::Object_subject& subject : programs) list.push_back(program(subject).every(large ? 20 : 4));
  return list;
}

}  // namespace

void run_peers(const Experiment_options& options)
{
  constexpr int passes = 200;
  constexpr double seconds = 0.3;
  constexpr int circles = 8;  // one alone meets A in few places, and which they are would decide the mean
  const auto objects = std::make_shared<Race_objects>(options.models);
  std::vector<Table_part> parts;
  const auto add = [&](const std::string& name, std::function<Race_course()> make) {
    parts.push_back({name, [=] {
                       const Race_course course = make();
                       return race_rows(course, contestants(course.a.face_count(), course.degenerate, options.programs),
                                        true, passes, seconds, options);
                     }});
  };

  std::vector<std::pair<std::size_t, std::vector<std::string>>> sizes = {{760, {"blob", "bunny", "knot2"}},
                                                                         {7172, {"bunny", "camel", "knot2", "anchor"}}};
  if (options.full) sizes.push_back({70000, {"blob", "bunny", "elephant", "knot"}});
  for (const auto& [triangles, names] : sizes)
    for (const std::string& name : names)
      for (const int ratio : {1, 8})
        for (const std::string trajectory : {"circular", "contour"}) {
          const std::string part =
              trajectory + "-" + name + "-" + std::to_string(triangles) + "-" + std::to_string(ratio);
          const std::uint64_t seed = options.seed + 1000 * parts.size();
          add(part, [=, frames = options.race_frames, triangles = triangles] {
            return on_trajectory((*objects)(name, triangles), name, trajectory, ratio, frames, seed,
                                 trajectory == "circular" ? circles : 1);
          });
        }
  const int frames = options.race_frames, fewer = std::max(1, options.race_frames / 10);
  add("stacked-boxes", [=, seed = options.seed] { return stacked_boxes(frames, seed); });
  add("face-on-face", [=, seed = options.seed] { return face_on_face(16, frames, seed); });
  add("one-ulp-apart", [=, seed = options.seed] { return sliding_apart(16, fewer, seed); });
  add("shell-in-shell", [=, seed = options.seed] { return shell_in_shell(7172, fewer, seed); });
  write_table(options.out, "peers", parts);
  draw("draw_peers.py", options.out);
}

}  // namespace tetracone::experiments
