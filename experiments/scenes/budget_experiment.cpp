#include "experiments/scenes/experiments.h"

#include "experiments/scenes/scene_workload.h"
#include "experiments/support/extent.h"
#include "tetracone/tetratree/scene/scene.h"

namespace tetracone::experiments {
namespace {

using Scene_pairs = std::vector<Scene_pair>;

/// A scene's results for all frames except the first.
struct Played {
  std::vector<Scene_pairs> pairs;  // of all frames
  std::vector<double> ns;
  std::size_t candidates = 0, decided = 0, undecided = 0, wrong = 0, farther = 0;
  double farthest = 0;  // the sum over undecided pairs
};

/// Pairs that are told and do not collide, and those that collide and are neither told nor undecided.
std::size_t wrong_pairs(const Scene_pairs& told, const std::vector<Undecided_pair>& undecided, const Scene_pairs& right)
{
  Scene_pairs open, known, wrong;
  for (const Undecided_pair& pair : undecided) open.push_back(pair.pair);
  std::ranges::set_difference(right, open, std::back_inserter(known));
  std::ranges::set_symmetric_difference(told, known, std::back_inserter(wrong));
  return wrong.size();
}

/// A scene of these bodies, none of them placed.
Scene scene_of(const Scene_workload& work, const std::vector<Body>& bodies, std::chrono::nanoseconds budget)
{
  Scene scene({.question = Question::surface, .budget = budget});
  for (const Body& body : bodies) scene.add_model(body);
  for (const std::size_t model : work.model_of) scene.add_body(model);
  return scene;
}

/// `alone`: each frame is asked by a scene of its own. `right`: null where there is no budget and nothing is judged.
Played play(const Scene_workload& work, const std::vector<Body>& bodies, bool alone, std::chrono::nanoseconds budget,
            const std::vector<Scene_pairs>* right)
{
  Scene scene = scene_of(work, bodies, budget);
  Played played;
  for (std::size_t frame = 0; frame < work.frames.size(); ++frame) {
    if (alone) scene = scene_of(work, bodies, budget);
    for (std::size_t k = 0; k < work.model_of.size(); ++k) scene.place(k, work.frames[frame][k]);
    const Stopwatch watch;
    const Scene_pairs pairs = scene.pairs();
    const double ns = watch.nanoseconds();
    played.pairs.push_back(pairs);
    if (right) played.wrong += wrong_pairs(pairs, scene.undecided(), (*right)[frame]);
    if (frame == 0) continue;
    played.ns.push_back(ns);
    played.candidates += scene.statistics().candidates;
    played.decided += scene.statistics().queries;
    played.undecided += scene.undecided().size();
    for (const auto& [pair, farthest] : scene.undecided()) {
      played.farthest += farthest;
      played.farther += right && !scene.within(pair.a, pair.b, farthest);
    }
  }
  return played;
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

void run_budget(const Experiment_options& options)
{
  const auto frames = std::size_t(std::max(2, options.race_frames / 20));
  const Scene_workload work = scene_workload("brownian", "blob", 1000, frames, options.seed);
  std::vector<Body> bodies;
  for (const auto& model : work.models) bodies.emplace_back(model).make_all();
  play(work, bodies, true, {}, nullptr);  // a first time is longer, by what the system gives memory for
  double size = 0;
  for (const auto& model : work.models) size = std::max(size, extent_of(model).longest_side());
  const double unit = median(play(work, bodies, true, {}, nullptr).ns);
  Csv_table table;
  std::printf("%-8s %10s %11s %9s %9s %10s %6s %8s %9s\n", "frames", "budget us", "of a frame", "frame us", "decided",
              "undecided", "wrong", "farther", "farthest");
  for (const bool alone : {true, false}) {
    const std::vector<Scene_pairs> right = play(work, bodies, alone, {}, nullptr).pairs;
    for (int power = -10; power <= 4; ++power) {
      const double of_a_frame = std::exp2(power / 2.0);
      const std::chrono::nanoseconds budget(std::max(1L, std::lround(of_a_frame * unit)));
      const Played played = play(work, bodies, alone, budget, &right);
      const double share = played.candidates ? double(played.decided) / double(played.candidates) : 1,
                   farthest = played.undecided ? played.farthest / double(played.undecided) / size : 0;
      const char* const kind = alone ? "alone" : "in a row";
      table.add(Csv_row()
                    .add("frames_asked", kind)
                    .add("bodies", work.model_of.size())
                    .add("triangles", work.models[0].face_count())
                    .add("frames", frames)
                    .add("budget_ns", budget.count())
                    .add("budget_of_a_frame", of_a_frame)
                    .add("frame_ns", median(played.ns))
                    .add("frame_of_a_frame", median(played.ns) / unit)
                    .add("candidates", played.candidates)
                    .add("decided", played.decided)
                    .add("undecided", played.undecided)
                    .add("share_decided", share)
                    .add("wrong", played.wrong)
                    .add("farther_than_said", played.farther)
                    .add("mean_farthest_in_sizes", farthest)
                    .add_origin(options.seed));
      std::printf("%-8s %10.0f %11.3f %9.0f %8.1f%% %10zu %6zu %8zu %9.2f\n", kind, double(budget.count()) / 1000,
                  of_a_frame, median(played.ns) / 1000, 100 * share, played.undecided, played.wrong, played.farther,
                  farthest);
      std::fflush(stdout);
    }
  }
  write_whole(options.out / "budget.csv", table.text());
}

}  // namespace tetracone::experiments
