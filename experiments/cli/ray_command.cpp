#include "experiments/cli/commands.h"

#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/covering/io/read_rays.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

struct Ray_options {
  std::string model, rays, csv;
  Model_options models;
  bool all = false, time = false;
};

/// A face of the file for each that the body has of it: triangles of one face, next to each other in order, are that
/// face, met once.
std::vector<Ray_hit> named_as_in_file(std::vector<Ray_hit> hits, const std::vector<covering::Index>& source_face)
{
  std::vector<Ray_hit> named;
  for (Ray_hit& hit : hits) {
    hit.face = source_face[hit.face];
    if (std::none_of(named.begin(), named.end(), [&](const Ray_hit& other) { return other.face == hit.face; }))
      named.push_back(hit);
  }
  return named;
}

void run_ray(const Ray_options& options)
{
  if (options.time && options.csv.empty()) throw CLI::ValidationError("--time", "expected --csv to hold the times");
  if (!options.csv.empty()) refuse_input(options.csv, {options.model, options.rays});
  const auto rays = covering::read_rays(options.rays);
  const Model_file model = load_model(options.model, options.models, false);
  const Body body = model.body;
  body.make_all();  // no ray's time is that of the tree

  std::string text, csv = options.time ? "ray,face,t,ns\n" : "ray,face,t\n";
  Progress progress("rays", rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto& r = rays[k];
    const Ray ray{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}};
    const Stopwatch watch;
    std::vector<Ray_hit> hits;
    if (options.all)
      hits = body.hits(ray);
    else if (const auto first = body.first_hit(ray))
      hits = {*first};
    const std::string ns = options.time ? "," + std::to_string(static_cast<long long>(watch.nanoseconds())) : "";
    hits = named_as_in_file(std::move(hits), model.source_face);
    if (hits.empty()) {
      text += "-";
      csv += std::to_string(k) + ",-," + ns + "\n";
    }
    for (std::size_t h = 0; h < hits.size(); ++h) {
      const std::string face = std::to_string(hits[h].face), t = kernel::shortest(hits[h].t);
      text += (h == 0 ? "" : " ") + face + " " + t;
      csv += std::to_string(k) + "," + face + "," + t + ns + "\n";
    }
    text += "\n";
    progress.step();
  }
  if (options.csv.empty())
    std::cout << text;
  else
    write_whole(options.csv, csv);
}

}  // namespace

void add_ray_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("ray", "Where rays meet a surface first: the face and t");
  const auto options = std::make_shared<Ray_options>();
  command->add_option("MODEL", options->model, "A model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command->add_option("RAYS", options->rays, "Rays: one a line, six decimals, origin and direction; '#' comments")
      ->required();
  command->add_flag("--all", options->all, "Every face that is met, `face t` after `face t`, in order");
  command->add_option("--csv", options->csv, "Write a table to this file");
  command->add_flag("--time", options->time, "With --csv: nanoseconds of each ray");
  options->models.add_to(*command);
  command->footer(
      "One line a ray: `face t`, or `-` where it meets none. The point is origin + t direction; t is the double "
      "nearest "
      "to the exact one. Of faces met at once, the least number is first.\n"
      "Example: tetracone ray house.poly rays.txt --all");
  command->callback([options] { run_ray(*options); });
}

}  // namespace tetracone::experiments
