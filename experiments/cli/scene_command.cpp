#include "experiments/cli/pair_command.h"

#include "tetracone/covering/io/input_error.h"
#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/tetratree/scene/scene.h"
#include "verify/cases/scene_file.h"

#include <chrono>
#include <exception>

namespace tetracone::experiments {
namespace {

struct Options : Answer_options {
  std::string file, question = "solid", kernel = "adaptive", motion, within;
  bool relation = false;
  std::size_t memory = 0, threads = 1;
  std::int64_t budget = 0;
  Model_options models;
};

/// The results of the frames so far, in the requested form.
class Rows {
 public:
  explicit Rows(const Options& options) : options_(options)
  {
    if (!options.csv.empty())
      text_ = options.time              ? "frame,pairs,ns,candidates,queries,nodes_made,bytes\n"
              : !options.motion.empty() ? "frame,a,b,lo,hi\n"
              : !options.within.empty() ? "frame,a,b,distance\n"
              : options.budget != 0     ? "frame,a,b,answer,at_most\n"
              : options.relation        ? "frame,a,b,relation,dimension\n"
                                        : "frame,a,b\n";
    if (options.json) text_ = "[";
  }

  /// `relations` are of the pairs, or none where they are not asked for.
  void add(std::size_t frame, const Scene& scene, const std::vector<Scene_pair>& pairs,
           const std::vector<Solid_contact>& relations, double ns)
  {
    const std::string number = std::to_string(frame);
    if (options_.json) {
      text_ += (frame == 0 ? "\n" : ",\n") + json(number, scene, pairs, relations, ns);
    } else if (options_.time) {
      text_ += row(number, scene, pairs.size(), ns);
    } else {
      const std::string comma = options_.blank();
      const bool has_answers = options_.budget != 0 && !options_.csv.empty();
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        text_ += number + comma + std::to_string(pairs[k].a) + comma + std::to_string(pairs[k].b);
        if (!relations.empty())
          text_ += comma + std::string(to_string(relations[k].relation)) + comma + dimension(relations[k], "-");
        text_ += has_answers ? ",1,0\n" : "\n";
      }
      for (const Undecided_pair& left : scene.undecided())
        text_ += number + comma + std::to_string(left.pair.a) + comma + std::to_string(left.pair.b) + comma +
                 "undecided" + comma + kernel::shortest(left.farthest) + "\n";
    }
    if (options_.csv.empty() && !options_.json) flush();
  }

  /// From this frame to the next.
  void add(std::size_t frame, const Scene& scene, const std::vector<Scene_contact>& contacts, double ns)
  {
    const auto numbers = [](const Scene_contact& contact) {
      return std::vector<std::pair<const char*, double>>{{"lo", contact.first.lo}, {"hi", contact.first.hi}};
    };
    add_pairs(frame, scene, "contacts", contacts, numbers, ns);
  }

  /// The pairs that are near in a frame.
  void add(std::size_t frame, const Scene& scene, const std::vector<Scene_distance>& near, double ns)
  {
    const auto numbers = [](const Scene_distance& each) {
      return std::vector<std::pair<const char*, double>>{{"distance", each.distance}};
    };
    add_pairs(frame, scene, "near", near, numbers, ns);
  }

  /// Writes what there is.
  void finish()
  {
    if (options_.json) text_ += text_ == "[" ? "]\n" : "\n]\n";
    write_answers(options_.csv, text_);
  }

 private:
  void flush()
  {
    std::cout << text_;
    text_.clear();
  }

  /// Adds pairs with numbers of each, which have names.
  template <class Pairs, class Numbers>
  void add_pairs(std::size_t frame, const Scene& scene, const char* name, const Pairs& pairs, const Numbers& numbers,
                 double ns)
  {
    const std::string number = std::to_string(frame);
    if (options_.json) {
      text_ += (frame == 0 ? "\n" : ",\n") + ("  {\"frame\": " + number) + ", \"" + name + "\": [";
      for (const auto& each : pairs) {
        text_ += (&each == &pairs.front() ? "" : ", ") + ("{\"pair\": " + in_brackets(each.pair));
        for (const auto& [what, x] : numbers(each)) text_ += std::string(", \"") + what + "\": " + kernel::shortest(x);
        text_ += "}";
      }
      text_ += "]" + (options_.time ? json_costs(scene, ns) : "") + "}";
    } else if (options_.time) {
      text_ += row(number, scene, pairs.size(), ns);
    } else {
      const std::string comma = options_.blank();
      for (const auto& each : pairs) {
        text_ += number + comma + std::to_string(each.pair.a) + comma + std::to_string(each.pair.b);
        for (const auto& [what, x] : numbers(each)) text_ += comma + kernel::shortest(x);
        text_ += "\n";
      }
    }
    if (options_.csv.empty() && !options_.json) flush();
  }

  static std::string row(const std::string& number, const Scene& scene, std::size_t pairs, double ns)
  {
    const Frame_statistics& done = scene.statistics();
    return number + "," + std::to_string(pairs) + "," + std::to_string(std::int64_t(ns)) + "," +
           std::to_string(done.candidates) + "," + std::to_string(done.queries) + "," +
           std::to_string(done.nodes_made) + "," + std::to_string(done.bytes) + "\n";
  }

  static std::string json_costs(const Scene& scene, double ns)
  {
    const Frame_statistics& done = scene.statistics();
    return ", \"ns\": " + std::to_string(std::int64_t(ns)) + ", \"candidates\": " + std::to_string(done.candidates) +
           ", \"queries\": " + std::to_string(done.queries) + ", \"nodes_made\": " + std::to_string(done.nodes_made) +
           ", \"bytes\": " + std::to_string(done.bytes);
  }

  static std::string in_brackets(const Scene_pair& pair)
  {
    return "[" + std::to_string(pair.a) + ", " + std::to_string(pair.b) + "]";
  }

  static std::string dimension(const Solid_contact& contact, const char* none)
  {
    return contact.dimension < 0 ? none : std::to_string(contact.dimension);
  }

  std::string json(const std::string& number, const Scene& scene, const std::vector<Scene_pair>& pairs,
                   const std::vector<Solid_contact>& relations, double ns) const
  {
    std::string text = "  {\"frame\": " + number + ", \"pairs\": [";
    for (const Scene_pair& pair : pairs) text += (&pair == &pairs.front() ? "" : ", ") + in_brackets(pair);
    text += "]";
    if (options_.relation) {
      text += ", \"relations\": [";
      for (const Solid_contact& contact : relations)
        text += (&contact == &relations.front() ? "" : ", ") +
                ("{\"relation\": \"" + std::string(to_string(contact.relation))) +
                "\", \"dimension\": " + dimension(contact, "null") + "}";
      text += "]";
    }
    if (options_.budget != 0) {
      text += ", \"undecided\": [";
      for (const Undecided_pair& left : scene.undecided())
        text += (&left == &scene.undecided().front() ? "" : ", ") + ("{\"pair\": " + in_brackets(left.pair)) +
                ", \"at_most\": " + kernel::shortest(left.farthest) + "}";
      text += "]";
    }
    if (options_.time) text += json_costs(scene, ns);
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
    scene.add_model([path = model.file.native(), models, solid] { return load_model(path, models, solid).body; },
                    model.name);
  for (const std::size_t model : file.bodies()) scene.add_body(model);
  for (const auto& [a, b] : file.ignored()) scene.ignore(a, b);
  return scene;
}

/// How the bodies move from a frame to the next.
std::vector<Motion> motions_between(verify::Scene_file& file, std::size_t frame, const Options& options)
{
  std::vector<Motion> motions;
  if (options.motion == "linear") {
    const std::vector<kernel::Pose> from = file.frame(frame), to = file.frame(frame + 1);
    for (std::size_t body = 0; body < from.size(); ++body)
      motions.emplace_back(kernel::Body_motion::linear(from[body], to[body]));
    return motions;
  }
  const std::vector<kernel::Rigid_pose> from = file.rigid_frame(frame), to = file.rigid_frame(frame + 1);
  for (std::size_t body = 0; body < from.size(); ++body) {
    auto motion = kernel::Body_motion::rigid(from[body], to[body]);
    if (!motion)
      throw covering::Input_error(options.file, 0,
                                  "body " + std::to_string(body) + " from frame " + std::to_string(frame) +
                                      " to the next: one quaternion between them is 0",
                                  "expected q0 and q1 of which no (1-t) q0 + t q1 is 0");
    motions.emplace_back(std::move(*motion));
  }
  return motions;
}

/// Returns how the options ask. Throws CLI::ValidationError where they exclude each other, and for a bad value.
Scene_options scene_options(const Options& options)
{
  const Question question = required_question(options.question);
  const auto query = parse_kernel(options.kernel);
  if (!query) throw CLI::ValidationError("--kernel " + options.kernel, "expected " + kernel_names());
  options.require(true);
  if (options.threads > 1024)
    throw CLI::ValidationError("--threads", "expected a number from 1 to 1024, or 0 for all that there are");
  const bool moves = !options.motion.empty();
  if (moves && options.motion != "linear" && options.motion != "rigid")
    throw CLI::ValidationError("--motion " + options.motion, "expected linear or rigid");
  if (moves && options.budget != 0) throw CLI::ValidationError("--budget", "expected without --motion");
  for (const auto& [holds, expected] : {std::pair(!moves, "without --motion"),
                                        {options.budget == 0, "without --budget"},
                                        {question == Question::solid, "with --question solid"},
                                        {query->kernel == Kernel::adaptive, "with --kernel adaptive"},
                                        {options.within.empty(), "without --within"}})
    if (options.relation && !holds) throw CLI::ValidationError("--relation", std::string("expected ") + expected);
  require_distance(options.within);
  if (!options.within.empty() && (moves || options.budget != 0))
    throw CLI::ValidationError("--within", "expected without --motion and --budget");
  if (options.budget < 0) throw CLI::ValidationError("--budget", "expected nanoseconds, a number from 0");
  return {.question = question,
          .query = *query,
          .threads = options.threads,
          .memory = options.memory,
          .budget = std::chrono::nanoseconds(options.budget)};
}

/// Answers the motions from each frame to the next.
void answer_motions(verify::Scene_file& file, Scene& scene, const Options& options, Rows& rows)
{
  // One frame has no motions. Its poses are read all the same, since they may be wrong.
  if (file.frame_count() == 1) {
    if (options.motion == "linear")
      file.frame(0);
    else
      file.rigid_frame(0);
  }
  const std::size_t steps = std::max<std::size_t>(file.frame_count(), 1) - 1;
  Progress progress("motions", steps);
  for (std::size_t frame = 0; frame < steps; ++frame) {
    const std::vector<Motion> motions = motions_between(file, frame, options);
    const Stopwatch watch;
    const std::vector<Scene_contact> contacts = scene.first_contacts(motions);
    rows.add(frame, scene, contacts, watch.nanoseconds());
    progress.step();
  }
}

/// Answers the frames.
void answer_frames(verify::Scene_file& file, Scene& scene, const Options& options, Rows& rows)
{
  const std::size_t frames = file.frame_count();
  Progress progress("frames", frames);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::vector<kernel::Pose> poses = file.frame(frame);
    const Stopwatch watch;
    for (std::size_t body = 0; body < poses.size(); ++body) scene.place(body, poses[body]);
    if (options.within.empty()) {
      const std::vector<Scene_pair>& pairs = scene.pairs();
      std::vector<Solid_contact> relations;
      if (options.relation)
        for (const Scene_pair& pair : pairs) relations.push_back(scene.solid_relation(pair.a, pair.b));
      rows.add(frame, scene, pairs, relations, watch.nanoseconds());
    } else {
      const std::vector<Scene_distance> near = scene.pairs_within(options.within);
      rows.add(frame, scene, near, watch.nanoseconds());
    }
    progress.step();
  }
}

void run(const Options& options)
{
  const Scene_options how = scene_options(options);
  verify::Scene_file file(options.file, options.motion == "rigid");
  if (!options.csv.empty()) refuse_input(options.csv, file.files());
  Scene scene = scene_of(file, how, options.models);
  Rows rows(options);
  std::exception_ptr failed;
  try {
    if (options.motion.empty())
      answer_frames(file, scene, options, rows);
    else
      answer_motions(file, scene, options, rows);
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
  add_default(*command, "--question", options->question, "solid or surface");
  add_default(*command, "--kernel", options->kernel, kernel_names());
  command
      ->add_option("--memory", options->memory,
                   "Bytes that models and queries may take: models are given back, and read again when they are needed")
      ->check(whole_number());
  add_default(*command, "--threads", options->threads,
              "Threads that share the pairs of a frame; 0: all that there are");
  command->add_option("--budget", options->budget,
                      "Nanoseconds for a frame: pairs not decided then are lines `frame a b undecided D`, with the "
                      "bodies at most D from one another");
  command->add_option(
      "--within", options->within,
      "Lines `frame a b distance` of the pairs that are at most this far apart, a decimal number (its double) or a "
      "fraction n/d; the distance is 0 where they collide");
  command->add_option(
      "--motion", options->motion,
      "linear: bodies move from each frame to the next, every point on a line, and what meets has a line `frame a b lo "
      "hi`, in order of the time t of its first contact, doubles lo <= t <= hi in [0, 1]; rigid: the same by the "
      "quaternion (1-t) q0 + t q1 and a translation, and a pose is 7 numbers, w x y z and the translation");
  command->add_flag("--relation", options->relation,
                    "Lines `frame a b name dimension` for the pairs that share a point: one of the eight relations of "
                    "solids, and the dimension of the contact, as `tetracone relation` tells it");
  command->add_option("--csv", options->csv,
                      "Write a table to this file: frame,a,b; with --motion frame,a,b,lo,hi; with --relation "
                      "frame,a,b,relation,dimension");
  command->add_flag("--json", options->json, "Write JSON: an object a frame");
  command->add_flag("--time", options->time,
                    "With --csv or --json: a row a frame, frame,pairs,ns,candidates,queries,nodes_made,bytes");
  options->models.add_to(*command);
  command->footer(
      "A scene file is {\"models\": {\"cat\": \"cat.off\"}, \"bodies\": [{\"model\": \"cat\"}, ...], \"frames\": [[[12 "
      "numbers], ...], ...]}, a pose a body and frame; or \"frames_file\": the same as little-endian doubles. "
      "\"ignore\": [[a, b], ...] are pairs not asked for. Models' names are relative to the scene file.\n"
      "Example: tetracone scene bin.scene.json --threads 0 --csv pairs.csv");
  command->callback([options] { run(*options); });
}

}  // namespace tetracone::experiments
