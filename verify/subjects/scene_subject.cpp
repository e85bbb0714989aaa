#include "verify/subjects/scene_subject.h"

#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/scene/scene.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace {

/// A scene that plays a case. Its numbers of bodies differ from the case's: a body that returns is a new one here.
class Played {
 public:
  Played(const Scene_case& c, const Scene_options& options) : case_(c), scene_(options)
  {
    for (const auto& model : c.models)
      if (options.memory != 0)
        scene_.add_model([&model] { return triangulated_body(*model); }, "made");
      else
        scene_.add_model(options.threads == 1 ? Body(*model) : triangulated_body(*model));
    there_.resize(c.frames.empty() ? 0 : c.frames[0].bodies.size());
  }

  Frames_of_pairs all()
  {
    Frames_of_pairs frames;
    for (const Scene_case::Frame& frame : case_.frames) {
      change(frame);
      do scene_.pairs();
      while (!scene_.undecided().empty());
      std::vector<Body_pair> pairs;
      for (const Scene_pair& pair : scene_.pairs()) {
        const auto [a, b] = std::minmax(of_case_[pair.a], of_case_[pair.b]);
        pairs.push_back({a, b});
      }
      std::ranges::sort(pairs);
      frames.push_back(std::move(pairs));
    }
    return frames;
  }

 private:
  struct There {
    std::size_t number, model;  // in the scene
  };

  void change(const Scene_case::Frame& frame)
  {
    for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
      const auto& body = frame.bodies[k];
      if (!body && there_[k]) {
        scene_.remove_body(there_[k]->number);
        there_[k].reset();
      }
      if (!body) continue;
      if (!there_[k]) {
        there_[k] = {scene_.add_body(body->model), body->model};
        of_case_.push_back(k);
      }
      if (there_[k]->model != body->model) scene_.set_model(there_[k]->number, there_[k]->model = body->model);
      scene_.place(there_[k]->number, body->pose);
    }
    for (const auto& [a, b] : frame.ignored)
      if (there_[a] && there_[b]) scene_.ignore(there_[a]->number, there_[b]->number);
  }

  const Scene_case& case_;
  Scene scene_;
  std::vector<std::optional<There>> there_;
  std::vector<std::size_t> of_case_;
};

constexpr std::size_t most_memory = std::size_t(1) << 30;

Frames_of_pairs by_scene(Scene_options options, const Scene_case& c)
{
  options.question = c.question;
  // A memory that does not hold both models of a pair is refused; the next try has more.
  for (;; options.memory += options.memory / 4) try {
      return Played(c, options).all();
    } catch (const std::exception&) {
      if (options.memory == 0 || options.memory > most_memory) throw;
    }
}

Frames_of_pairs by_queries(const Scene_case& c)
{
  std::vector<Body> models;
  for (const auto& model : c.models) models.push_back(triangulated_body(*model));
  std::map<std::array<std::size_t, 4>, Query> queries;  // of two bodies and their models
  Frames_of_pairs frames;
  for (const Scene_case::Frame& frame : c.frames) {
    std::vector<Body_pair>& pairs = frames.emplace_back();
    for (std::size_t a = 0; a < frame.bodies.size(); ++a)
      for (std::size_t b = a + 1; b < frame.bodies.size(); ++b) {
        const auto &of_a = frame.bodies[a], &of_b = frame.bodies[b];
        if (!of_a || !of_b || std::ranges::find(frame.ignored, Body_pair{a, b}) != frame.ignored.end()) continue;
        Query& query = queries
                           .try_emplace({a, b, of_a->model, of_b->model}, models[of_a->model], models[of_b->model],
                                        c.question, Query_options{.remember = true})
                           .first->second;
        if (query.collide(of_a->pose, of_b->pose)) pairs.push_back({a, b});
      }
  }
  return frames;
}

class By_play : public Running_scene {
 public:
  using Play = std::function<Frames_of_pairs(const Scene_case&)>;
  explicit By_play(Play play) : play_(std::move(play)) {}
  Told<Frames_of_pairs> operator()(const Scene_case& c) override
  {
    return told_by([&] { return play_(c); });
  }

 private:
  Play play_;
};

Scene_subject scene_subject(const char* name, bool is_exact, const By_play::Play& play)
{
  return {name, is_exact, "", [play] { return std::make_unique<By_play>(play); }};
}

}  // namespace

std::vector<Scene_subject> scene_subjects()
{
  const auto scene = [](const char* name, bool is_exact, const Scene_options& options) {
    return scene_subject(name, is_exact, std::bind_front(by_scene, options));
  };
  return {scene("adaptive scene", true, {}),
          scene("adaptive scene threads", true, {.threads = 2}),
          scene("adaptive scene memory", true, {.memory = std::size_t(1) << 17}),
          scene("adaptive scene budget", true, {.budget = std::chrono::microseconds(50)}),
          scene_subject("adaptive queries", true, by_queries),
          scene("double scene", false, {.query = {.kernel = Kernel::double_}})};
}

}  // namespace tetracone::verify
