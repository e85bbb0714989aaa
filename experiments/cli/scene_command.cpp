#include "experiments/cli/scene_command.h"

#include "experiments/support/model_file.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/scene.h"
#include "verify/cases/scene_file.h"

#include <chrono>
#include <cstdint>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

struct Options {
  std::string file, csv, question = "solid", kernel = "adaptive";
  bool json = false, time = false;
  std::size_t memory = 0, threads = 1;
  std::int64_t budget = 0;
  Model_options models;
};

/// What the frames have given so far, in the form that was asked for.
class Rows {
 public:
  explicit Rows(const Options& options) : options_(options)
  {
    if (!options.csv.empty())
      text_ = options.time          ? "frame,pairs,ns,candidates,queries,nodes_made,bytes\n"
              : options.budget != 0 ? "frame,a,b,answer,at_most\n"
                                    : "frame,a,b\n";
    if (options.json) text_ = "[";
  }

  void add(std::size_t frame, const Scene& scene, const std::vector<Scene_pair>& pairs, double ns)
  {
    const std::string number = std::to_string(frame);
    if (options_.json) {
      text_ += (frame == 0 ? "\n" : ",\n") + json(number, scene, pairs, ns);
    } else if (options_.time) {
      const Frame_statistics& done = scene.statistics();
      text_ += number + "," + std::to_string(pairs.size()) + "," + std::to_string(std::int64_t(ns)) + "," +
               std::to_string(done.candidates) + "," + std::to_string(done.queries) + "," +
               std::to_string(done.nodes_made) + "," + std::to_string(done.bytes) + "\n";
    } else {
      const std::string comma = options_.csv.empty() ? " " : ",";
      const bool has_answers = options_.budget != 0 && !options_.csv.empty();
      for (const Scene_pair& pair : pairs)
        text_ +=
            number + comma + std::to_string(pair.a) + comma + std::to_string(pair.b) + (has_answers ? ",1,0\n" : "\n");
      for (const Undecided_pair& left : scene.undecided())
        text_ += number + comma + std::to_string(left.pair.a) + comma + std::to_string(left.pair.b) + comma +
                 "undecided" + comma + kernel::shortest(left.farthest) + "\n";
    }
    if (options_.csv.empty() && !options_.json) flush();
  }

  /// Writes what there is.
  void finish()
  {
    if (options_.json) text_ += text_ == "[" ? "]\n" : "\n]\n";
    if (options_.csv.empty())
      flush();
    else
      write_whole(options_.csv, text_);
  }

 private:
  void flush()
  {
    std::cout << text_;
    text_.clear();
  }

  static std::string in_brackets(const Scene_pair& pair)
  {
    return "[" + std::to_string(pair.a) + ", " + std::to_string(pair.b) + "]";
  }

  std::string json(const std::string& number, const Scene& scene, const std::vector<Scene_pair>& pairs, double ns) const
  {
    std::string text = "  {\"frame\": " + number + ", \"pairs\": [";
    for (const Scene_pair& pair : pairs) text += (&pair == &pairs.front() ? "" : ", ") + in_brackets(pair);
    text += "]";
    if (options_.budget != 0) {
      text += ", \"undecided\": [";
      for (const Undecided_pair& left : scene.undecided())
        text += (&left == &scene.undecided().front() ? "" : ", ") + ("{\"pair\": " + in_brackets(left.pair)) +
                ", \"at_most\": " + kernel::shortest(left.farthest) + "}";
      text += "]";
    }
    if (options_.time) {
      const Frame_statistics& done = scene.statistics();
      text += ", \"ns\": " + std::to_string(std::int64_t(ns)) + ", \"candidates\": " + std::to_string(done.candidates) +
              ", \"queries\": " + std::to_string(done.queries) +
              ", \"nodes_made\": " + std::to_string(done.nodes_made) + ", \"bytes\": " + std::to_string(done.bytes);
    }
    return text + "}";
  }

  const Options& options_;
  std::string text_;
};

Scene scene_of(const verify::Scene_file& file, const Scene_options& how, const Model_options& models)
{
  Scene scene(how);
  const bool solid = how.question == Question::solid;
  for (const verify::Scene_file::Model& model : file.models())
    scene.add_model([path = model.file.native(), models,
                     solid] { return triangulated_body(load_model(path, models, solid).polyhedron); },
                    model.name);
  for (const std::size_t model : file.bodies()) scene.add_body(model);
  for (const auto& [a, b] : file.ignored()) scene.ignore(a, b);
  return scene;
}

void run(const Options& options)
{
  const auto question = kernel::parse_question(options.question);
  if (!question) throw CLI::ValidationError("--question " + options.question, "expected solid or surface");
  const auto query = parse_kernel(options.kernel);
  if (!query)
    throw CLI::ValidationError("--kernel " + options.kernel,
                               "expected adaptive, double, float, epick, epeck, rational or double-eps=E");
  if (options.json && !options.csv.empty()) throw CLI::ValidationError("--json", "expected without --csv");
  if (options.time && options.csv.empty() && !options.json)
    throw CLI::ValidationError("--time", "expected --csv or --json to hold the times");
  if (options.threads > 1024)
    throw CLI::ValidationError("--threads", "expected a number from 1 to 1024, or 0 for all that there are");
  if (options.budget < 0) throw CLI::ValidationError("--budget", "expected nanoseconds, a number from 0");

  verify::Scene_file file(options.file);
  if (!options.csv.empty()) refuse_input(options.csv, file.files());
  Scene scene = scene_of(file,
                         {.question = *question,
                          .query = *query,
                          .threads = options.threads,
                          .memory = options.memory,
                          .budget = std::chrono::nanoseconds(options.budget)},
                         options.models);
  Rows rows(options);
  Progress progress("frames", file.frame_count());
  std::exception_ptr failed;
  try {
    for (std::size_t frame = 0; frame < file.frame_count(); ++frame) {
      const std::vector<kernel::Pose> poses = file.frame(frame);
      const Stopwatch watch;
      for (std::size_t body = 0; body < poses.size(); ++body) scene.place(body, poses[body]);
      const std::vector<Scene_pair>& pairs = scene.pairs();
      rows.add(frame, scene, pairs, watch.nanoseconds());
      progress.step();
    }
  } catch (const Error&) {
    failed = std::current_exception();  // what was computed is kept
  }
  rows.finish();
  if (failed) std::rethrow_exception(failed);
}

}  // namespace

void add_scene_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("scene", "Which of many bodies collide: a line `frame a b` for each pair of each frame");
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->file, "Scene file, *.scene.json")->required();
  command->add_option("--question", options->question, "solid or surface")->capture_default_str();
  command->add_option("--kernel", options->kernel, "adaptive, double, float, double-eps=E, epick, epeck or rational")
      ->capture_default_str();
  command->add_option(
      "--memory", options->memory,
      "Bytes that models and queries may take: models are given back, and read again when they are needed");
  command->add_option("--threads", options->threads, "Threads that share the pairs of a frame; 0: all that there are")
      ->capture_default_str();
  command->add_option(
      "--budget", options->budget,
      "Nanoseconds for a frame: pairs not decided then are lines `frame a b undecided D`, with the bodies "
      "at most D from one another");
  command->add_option("--csv", options->csv, "Write a table to this file: frame,a,b");
  command->add_flag("--json", options->json, "Write JSON: an object a frame");
  command->add_flag("--time", options->time,
                    "With --csv or --json: a row a frame, frame,pairs,ns,candidates,queries,nodes_made,bytes");
  options->models.add_to(*command);
  command->footer(
      "A scene file is {\"models\": {\"cat\": \"cat.off\"}, \"bodies\": [{\"model\": \"cat\"}, ...], \"frames\": "
      "[[[12 numbers], ...], ...]}, a pose a body and frame; or \"frames_file\": the same as little-endian doubles. "
      "\"ignore\": [[a, b], ...] are pairs not asked for. Models' names are relative to the scene file.\n"
      "Example: tetracone scene bin.scene.json --threads 0 --csv pairs.csv");
  command->callback([options] { run(*options); });
}

}  // namespace tetracone::experiments
