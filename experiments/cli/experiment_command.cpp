#include "experiments/cli/commands.h"
#include "experiments/cli/subject_options.h"

#include "experiments/accuracy/experiments.h"
#include "experiments/queries/experiments.h"
#include "experiments/report/method_figures.h"
#include "experiments/scenes/experiments.h"
#include "experiments/speed/experiments.h"

namespace tetracone::experiments {
namespace {

struct Command_options : Experiment_options {
  Subject_options others;
  std::string name;
  bool list = false;
};

struct Experiment {
  std::string_view name, question, time;
  void (*run)(const Experiment_options& options);
  const char* options;  ///< that its rows depend on, with a space between them
};
constexpr std::array experiments = {
    Experiment{
        "study",
        "how fast and how often wrong is each kernel on the paper's trajectories and in exactly degenerate contact?",
        "2 min", run_study, "--models --frames --rotations --seed --full --subject-command"},
    Experiment{"contact-cost", "what does each exact answer cost where bodies touch, over double and FCL?", "1 min",
               run_contact_cost, "--models --rotations --seed"},
    Experiment{"peers", "how fast are ours and FCL, CGAL, Bullet and ODE, in one run, and how often wrong?", "4 min",
               run_peers, "--models --race-frames --race-seconds --seed --full --subject-command"},
    Experiment{"scaling", "how do time, build and memory grow with the triangles of one geometry?", "2 min",
               run_scaling, "--models --race-frames --race-seconds --seed --full"},
    Experiment{"ablation", "what does each choice of the paper cost, and each step to the fast tree bring?", "3 min",
               run_ablation, "--models --race-frames --race-seconds --seed --full"},
    Experiment{"paper",
               "what do adjusted tetrahedra, depth, relative size and a turning body cost in the paper's study?",
               "4 min", run_paper, "--models --race-frames --race-seconds --seed --full"},
    Experiment{"distance", "what does an exact distance cost beside FCL's, and how far off is each?", "20 s",
               run_distance, "--race-frames --seed --full"},
    Experiment{"threads", "how do queries on shared bodies scale with threads, while nodes are made and after?", "20 s",
               run_threads, "--race-frames --seed"},
    Experiment{"coherence", "what does remembering the last pose save, by how far a body moves from one to the next?",
               "20 s", run_coherence, "--race-frames --seed"},
    Experiment{"contacts", "how fast are all contacts of bodies that collide, and FCL's, and how many of FCL's wrong?",
               "20 s", run_contacts, "--models --race-frames --seed"},
    Experiment{"scenes", "how fast is a frame of many bodies beside FCL, Bullet and ODE, and who misses what?", "3 min",
               run_scenes, "--race-frames --seed --full"},
    Experiment{"budget", "how many pairs of a scene does a budget of time decide, and how near are the others?", "20 s",
               run_budget, "--race-frames --seed"},
    Experiment{"demand", "how much of what could be made do the frames of a scene make, and what does that save?",
               "20 s", run_demand, "--race-frames --seed"},
    Experiment{"penetration",
               "what do an exit along a direction and the least translation cost, beside a first contact?", "1 min",
               run_penetration, "--race-frames --seed --full"},
    Experiment{"points", "what does a point in a solid cost, and the first hit of a ray, against CGAL?", "1 min",
               run_points, "--points --mesh --seed --full"},
    Experiment{"measures",
               "what do relations, overlaps, signed distances and self-intersections cost, beside collide and CGAL?",
               "1 min", run_measures, "--race-frames --seed --full"},
    Experiment{"sign-maps",
               "what does each arithmetic answer at 256 x 256 neighbouring doubles about a degenerate place?", "1 min",
               run_sign_maps, "--size"},
    Experiment{"stability", "how many doubles from the exact place does each kernel change its answer?", "10 s",
               run_stability, "--seed --full"},
    Experiment{"motion", "how fast and how often wrong are ways to decide whether moving primitives meet?", "20 s",
               run_motion, "--queries --cases --seed --full"},
    Experiment{"moving-bodies", "what does an exact first contact cost, and which do steps and FCL miss?", "2 min",
               run_moving_bodies, "--race-frames --seed"},
    Experiment{"bounds", "how much of each error bound is proved to be needed, and how much does a search find?",
               "1 min", run_error_bounds, "--seed"},
    Experiment{"method", "what do covering, cones, bounding volumes and hull of the paper look like?", "10 s",
               run_method_figures, "--model"},
    Experiment{"compilers", "which compiler flags make which signs wrong?", "1 min", run_compilers, ""},
    Experiment{"dataset", "cases of every family with their exact truth, as CSV and JSON for other libraries", "1 min",
               export_dataset, "--cases --seed --full"},
};

void run_experiment(const CLI::App& command, Command_options options)
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
  if (options.out.native().find('\'') != std::string::npos)
    throw CLI::ValidationError("--out", "expected a name without '");
  auto words = CLI::detail::split(chosen->options, ' ');
  if (!options.others.commands.empty()) {
    if (std::ranges::find(words, "--subject-command") == words.end())
      throw CLI::ValidationError("--subject-command", "expected the experiment study or peers");
    words.emplace_back("--subject-limit");
    options.programs = command_subjects(options.others, verify::object_subjects());
  }
  again() = "build/tetracone experiment " + options.name + " --out out" + words_of(command, words);
  if (options.models.empty()) options.models = TETRACONE_SOURCE_DIR "/.cache/models";
  make_folder(options.out);
  chosen->run(options);
}

}  // namespace

void add_experiment_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("experiment", "One question: its CSV and its figure");
  const auto options = std::make_shared<Command_options>();
  const CLI::Range poses(1, 1'000'000);
  command->add_option("NAME", options->name, "The experiment");
  command->add_flag("--list", options->list, "Name the experiments, with the time of their default size");
  add_default(*command, "--out", options->out, "Folder of the results");
  command->add_option("--models", options->models,
                      "Folder that experiments/support/fetch_models.sh filled; default: its own");
  add_default(*command, "--frames", options->frames, "study: poses of each trajectory")->check(poses);
  add_default(*command, "--rotations", options->rotations,
              "study, contact-cost: poses of each degenerate scenario, and points, rays and frames")
      ->check(poses);
  add_default(*command, "--race-frames", options->race_frames,
              "peers, scaling, ablation, paper, distance, threads, coherence, contacts, penetration, scenes, budget, "
              "demand, measures: poses of each trajectory (peers: of each of eight circles; coherence: of the coarsest "
              "walk; scenes and budget: a twentieth, penetration: a fiftieth, demand: a tenth); moving-bodies: motions "
              "of each course")
      ->check(poses);
  command
      ->add_option("--race-seconds", options->race_seconds,
                   "peers, scaling, ablation, paper: seconds of processor time after which a contestant rests, once it "
                   "has had a pass; default: 0.1 to 0.3")
      ->check(CLI::Range(0.001, 1e6));
  add_default(*command, "--size", options->size, "sign-maps: doubles along each side of a map")
      ->check(CLI::Range(1, 4096));
  add_default(*command, "--points", options->points, "points: points and rays of each kind")->check(poses);
  command->add_option("--mesh", options->meshes,
                      "points: a closed mesh of triangles, beside the generated; may be repeated");
  command->add_option("--model", options->model,
                      "method: a closed model; default: a star-shaped body of 760 triangles");
  command->add_option("--queries", options->queries,
                      "motion: a folder of published queries, SCENE/KIND/*.csv, judged too; default: none");
  add_default(*command, "--seed", options->seed, "Seed of every random choice")->check(CLI::Range(0ul, 1ul << 62));
  add_default(*command, "--cases", options->cases,
              "dataset: cases per family and level; motion: a tenth of the pairs per family")
      ->check(CLI::Range(1ul, 1'000'000ul));
  command->add_flag("--full", options->full,
                    "Twenty times as many poses or cases, motion fifty times; peers and scaling: larger objects; "
                    "ablation and paper: all poses; stability: more ways");
  add_subject_options(*command, options->others);
  command->add_flag("--rows-alone", options->rows_alone, "study: no report, which `tetracone report` draws too");
  command->footer(
      "Stopped and started again with the same words, it goes on where it was.\nExample: tetracone experiment study "
      "--out out");
  command->callback([command, options] { run_experiment(*command, *options); });
}

}  // namespace tetracone::experiments
