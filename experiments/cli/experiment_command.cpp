#include "experiments/cli/command_words.h"
#include "experiments/cli/commands.h"

#include "experiments/accuracy/compilers.h"
#include "experiments/accuracy/dataset.h"
#include "experiments/accuracy/error_bounds.h"
#include "experiments/accuracy/motion.h"
#include "experiments/accuracy/sign_maps.h"
#include "experiments/accuracy/stability.h"
#include "experiments/queries/contacts_experiment.h"
#include "experiments/queries/distance_experiment.h"
#include "experiments/queries/moving_bodies_experiment.h"
#include "experiments/queries/points_experiment.h"
#include "experiments/report/method_figures.h"
#include "experiments/scenes/budget_experiment.h"
#include "experiments/scenes/coherence_experiment.h"
#include "experiments/scenes/demand_experiment.h"
#include "experiments/scenes/scenes_experiment.h"
#include "experiments/speed/ablation_experiment.h"
#include "experiments/speed/paper_experiment.h"
#include "experiments/speed/peers_experiment.h"
#include "experiments/speed/scaling_experiment.h"
#include "experiments/speed/study.h"
#include "experiments/speed/threads_experiment.h"
#include "experiments/support/build_info.h"
#include "experiments/support/draw.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::experiments {
namespace {

struct Experiment_options {
  std::string name;
  bool list = false, full = false, rows_alone = false;
  Study_options study;
  std::uint64_t cases = 20;
  int race_frames = 400, size = 256, points = 20'000;
  double race_seconds = 0;
  std::filesystem::path model, queries;
  std::vector<std::filesystem::path> meshes;
};

std::filesystem::path models(const Experiment_options& options)
{
  return options.study.models.empty() ? TETRACONE_SOURCE_DIR "/.cache/models" : options.study.models;
}

void study(Experiment_options options)
{
  if (options.full) {
    options.study.frames *= 20;
    options.study.rotations *= 20;
  }
  options.study.models = models(options);
  run_study(options.study);
  if (!options.rows_alone) draw("report.py", options.study.out);
}

Race_options race(const Experiment_options& options)
{
  return {options.study.out, models(options),    options.race_frames,
          options.full,      options.study.seed, options.race_seconds};
}

void peers(Experiment_options options) { run_peers(race(options)); }
void scaling(Experiment_options options) { run_scaling(race(options)); }
void paper(Experiment_options options) { run_paper(race(options)); }
void ablation(Experiment_options options) { run_ablation(race(options)); }
void distance(Experiment_options options)
{
  run_distance(options.study.out, options.race_frames, options.full, options.study.seed);
}
void moving_bodies(Experiment_options options)
{
  run_moving_bodies(options.study.out, options.race_frames, options.study.seed);
}
void coherence(Experiment_options options)
{
  run_coherence(options.study.out, options.race_frames, options.study.seed);
}
void threads(Experiment_options options) { run_threads(options.study.out, options.race_frames, options.study.seed); }

void contacts(Experiment_options options)
{
  run_contacts(options.study.out, models(options), options.race_frames, options.study.seed);
}
void scenes(Experiment_options options)
{
  run_scenes(options.study.out, std::size_t(std::max(2, options.race_frames / 20)), options.full, options.study.seed);
}
void budget(Experiment_options options)
{
  run_budget(options.study.out, std::size_t(std::max(2, options.race_frames / 20)), options.study.seed);
}
void demand(Experiment_options options)
{
  run_demand(options.study.out, std::size_t(std::max(2, options.race_frames / 10)), options.study.seed);
}
void points(Experiment_options options)
{
  run_points(options.study.out, options.meshes, options.full ? 20 * options.points : options.points,
             options.study.seed);
}

void method(Experiment_options options) { run_method_figures(options.study.out, options.model); }
void sign_maps(Experiment_options options) { run_sign_maps(options.study.out, options.size); }
void stability(Experiment_options options)
{
  run_stability(options.study.out, options.full ? 400 : 20, options.study.seed);
}

void bounds(Experiment_options options) { run_error_bounds(options.study.out, 20000, options.study.seed); }
void motion(Experiment_options options)
{
  const std::uint64_t cases = options.full ? 500 * options.cases : 10 * options.cases;
  run_motion(options.study.out, options.queries, cases, options.study.seed);
}
void compilers(Experiment_options options) { run_compilers(options.study.out); }

void dataset(Experiment_options options)
{
  export_dataset(options.study.out, options.full ? 20 * options.cases : options.cases, options.study.seed);
}

struct Experiment {
  std::string_view name, question, time;
  void (*run)(Experiment_options options);
  const char* options;  ///< that its rows depend on, with a space between them
};
constexpr std::array experiments = {
    Experiment{
        "study",
        "how fast and how often wrong is each kernel on the paper's trajectories and in exactly degenerate contact?",
        "2 min", study, "--models --frames --rotations --seed --full"},
    Experiment{"peers", "how fast are ours and FCL, CGAL, Bullet and ODE, in one run, and how often wrong?", "4 min",
               peers, "--models --race-frames --race-seconds --seed --full"},
    Experiment{"scaling", "how do time, build and memory grow with the triangles of one geometry?", "2 min", scaling,
               "--models --race-frames --race-seconds --seed --full"},
    Experiment{"ablation", "what does each choice of the paper cost, and each step to the fast tree bring?", "3 min",
               ablation, "--models --race-frames --race-seconds --seed --full"},
    Experiment{"paper",
               "what do adjusted tetrahedra, depth, relative size and a turning body cost in the paper's study?",
               "4 min", paper, "--models --race-frames --race-seconds --seed --full"},
    Experiment{"distance", "what does an exact distance cost beside FCL's, and how far off is each?", "20 s", distance,
               "--race-frames --seed --full"},
    Experiment{"threads", "how do queries on shared bodies scale with threads, while nodes are made and after?", "10 s",
               threads, "--race-frames --seed"},
    Experiment{"coherence", "what does remembering the last pose save, by how far a body moves from one to the next?",
               "20 s", coherence, "--race-frames --seed"},
    Experiment{"contacts", "how fast are all contacts of bodies that collide, and FCL's, and how many of FCL's wrong?",
               "20 s", contacts, "--models --race-frames --seed"},
    Experiment{"scenes", "how fast is a frame of many bodies beside FCL, Bullet and ODE, and who misses what?", "3 min",
               scenes, "--race-frames --seed --full"},
    Experiment{"budget", "how many pairs of a scene does a budget of time decide, and how near are the others?", "20 s",
               budget, "--race-frames --seed"},
    Experiment{"demand", "how much of what could be made do the frames of a scene make, and what does that save?",
               "20 s", demand, "--race-frames --seed"},
    Experiment{"points", "what does a point in a solid cost, and the first hit of a ray, against CGAL?", "1 min",
               points, "--points --mesh --seed --full"},
    Experiment{"sign-maps",
               "what does each arithmetic answer at 256 x 256 neighbouring doubles about a degenerate place?", "1 min",
               sign_maps, "--size"},
    Experiment{"stability", "how many doubles from the exact place does each kernel change its answer?", "10 s",
               stability, "--seed --full"},
    Experiment{"motion", "how fast and how often wrong are ways to decide whether moving primitives meet?", "20 s",
               motion, "--queries --cases --seed --full"},
    Experiment{"moving-bodies", "what does an exact first contact cost, and which do steps and FCL miss?", "2 min",
               moving_bodies, "--race-frames --seed"},
    Experiment{"bounds", "how much of each error bound is proved to be needed, and how much does a search find?",
               "1 min", bounds, "--seed"},
    Experiment{"method", "what do covering, cones, bounding volumes and hull of the paper look like?", "10 s", method,
               "--model"},
    Experiment{"compilers", "which compiler flags make which signs wrong?", "1 min", compilers, ""},
    Experiment{"dataset", "cases of every family with their exact truth, as CSV and JSON for other libraries", "1 min",
               dataset, "--cases --seed --full"},
};

void run_experiment(const CLI::App& command, const Experiment_options& options)
{
  if (options.list) {
    for (const Experiment& e : experiments) std::cout << e.name << "  (" << e.time << ")  " << e.question << '\n';
    return;
  }
  if (options.name.empty()) throw CLI::RequiredError("NAME");
  const auto chosen =
      std::find_if(experiments.begin(), experiments.end(), [&](const Experiment& e) { return e.name == options.name; });
  if (chosen == experiments.end())
    throw CLI::ValidationError(options.name, "expected an experiment; --list names them");
  if (options.study.out.native().find('\'') != std::string::npos)
    throw CLI::ValidationError("--out", "expected a name without '");
  again() = "build/tetracone experiment " + options.name + " --out out" +
            words_of(command, CLI::detail::split(chosen->options, ' '));
  chosen->run(options);
}

}  // namespace

void add_experiment_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("experiment", "One question: its CSV and its figure");
  const auto options = std::make_shared<Experiment_options>();
  const CLI::Range poses(1, 1'000'000);
  command->add_option("NAME", options->name, "The experiment");
  command->add_flag("--list", options->list, "Name the experiments, with the time of their default size");
  command->add_option("--out", options->study.out, "Folder of the results")->capture_default_str();
  command->add_option("--models", options->study.models,
                      "Folder that experiments/support/fetch_models.sh filled; default: its own");
  command->add_option("--frames", options->study.frames, "study: poses of each trajectory")
      ->check(poses)
      ->capture_default_str();
  command->add_option("--rotations", options->study.rotations, "study: poses of each degenerate scenario")
      ->check(poses)
      ->capture_default_str();
  command
      ->add_option("--race-frames", options->race_frames,
                   "peers, scaling, ablation, paper, distance, threads, coherence, contacts, scenes, budget, demand: "
                   "poses of each "
                   "trajectory (peers: of each of eight circles; coherence: of the coarsest walk; scenes and budget: a "
                   "twentieth, demand: a tenth); "
                   "moving-bodies: motions of each course")
      ->check(poses)
      ->capture_default_str();
  command
      ->add_option("--race-seconds", options->race_seconds,
                   "peers, scaling, ablation, paper: seconds of processor time after which a contestant rests, once it "
                   "has had a pass; default: 0.1 to 0.3")
      ->check(CLI::Range(0.001, 1e6));
  command->add_option("--size", options->size, "sign-maps: doubles along each side of a map")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command->add_option("--points", options->points, "points: points and rays of each kind")
      ->check(poses)
      ->capture_default_str();
  command->add_option("--mesh", options->meshes,
                      "points: a closed mesh of triangles, beside the generated; may be repeated");
  command->add_option("--model", options->model,
                      "method: a closed model; default: a star-shaped body of 760 triangles");
  command->add_option("--queries", options->queries,
                      "motion: a folder of published queries, SCENE/KIND/*.csv, judged too; default: none");
  command->add_option("--seed", options->study.seed, "Seed of every random choice")
      ->check(CLI::Range(0ul, 1ul << 62))
      ->capture_default_str();
  command
      ->add_option("--cases", options->cases,
                   "dataset: cases per family and level; motion: a tenth of the pairs per family")
      ->check(CLI::Range(1ul, 1'000'000ul))
      ->capture_default_str();
  command->add_flag("--full", options->full,
                    "Twenty times as many poses or cases, motion fifty times; peers and scaling: larger objects; "
                    "ablation and paper: all poses; "
                    "stability: more ways");
  command->add_flag("--rows-alone", options->rows_alone, "study: no report, which `tetracone report` draws too");
  command->footer(
      "Stopped and started again with the same words, it goes on where it was.\nExample: tetracone experiment study "
      "--out out");
  command->callback([command, options] { run_experiment(*command, *options); });
}

}  // namespace tetracone::experiments
