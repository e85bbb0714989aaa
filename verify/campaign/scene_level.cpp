#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/truth/cgal_truth.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace tetracone::verify {
namespace {

/// The colliding pairs of each frame, by both truths. A pair is decided anew when one of its bodies has changed.
class True_pairs {
 public:
  explicit True_pairs(const Scene_case& c) : case_(c)
  {
    for (const auto& model : c.models) models_.emplace_back(*model);
  }

  Frames_of_pairs all()
  {
    Frames_of_pairs frames;
    for (const Scene_case::Frame& frame : case_.frames) {
      placed_.resize(frame.bodies.size());
      for (std::size_t k = 0; k < frame.bodies.size(); ++k) place(k, frame.bodies[k]);
      std::vector<Body_pair>& pairs = frames.emplace_back();
      for (std::size_t a = 0; a < frame.bodies.size(); ++a)
        for (std::size_t b = a + 1; b < frame.bodies.size(); ++b)
          if (frame.bodies[a] && frame.bodies[b] &&
              std::ranges::find(frame.ignored, Body_pair{a, b}) == frame.ignored.end() && collide(a, b))
            pairs.push_back({a, b});
    }
    return frames;
  }

 private:
  struct Placed {
    Scene_case::Standing standing;
    Placed_body body;
  };

  void place(std::size_t k, const std::optional<Scene_case::Standing>& now)
  {
    std::optional<Placed>& placed = placed_[k];
    if (placed && now && placed->standing == *now) return;
    std::erase_if(known_, [k](const auto& known) { return known.first[0] == k || known.first[1] == k; });
    placed.reset();
    if (now) placed.emplace(Placed{*now, Placed_body(models_[now->model], now->pose)});
  }

  bool collide(std::size_t a, std::size_t b)
  {
    const auto [known, is_new] = known_.try_emplace({a, b});
    if (is_new) known->second = decided(*placed_[a], *placed_[b]);
    return known->second;
  }

  bool decided(const Placed& a, const Placed& b) const
  {
    const Object_case pair{case_.models[a.standing.model],
                           case_.models[b.standing.model],
                           a.standing.pose,
                           b.standing.pose,
                           case_.origin,
                           {},
                           {}};
    const bool first = verify::collide(a.body, b.body, case_.question);
    if (first != integer_truth::collide(pair, case_.question))
      throw Truths_disagree("the two truths of two bodies of a scene disagree", pair, case_.question);
    return first;
  }

  const Scene_case& case_;
  std::vector<Brute_body> models_;
  std::vector<std::optional<Placed>> placed_;
  std::map<Body_pair, bool> known_;
};

/// An answer is a list a frame.
class Scene_page : public Page<levels::Scenes> {
 public:
  static constexpr bool tries_all_relations = true;
  auto relations() const { return scene_relations(); }
  bool tries_relations(std::uint64_t, Question, const Told& told) const { return told.outcome == Outcome::yes; }
  std::array<Question, 1> questions(const Scene_case& c) const { return {c.question}; }
  std::string name(Question question) const { return std::string(kernel::to_string(question)); }

  void learn(const Scene_case& c) { truth_ = True_pairs(c).all(); }
  Truths truths(Question question) const
  {
    Truths truths;
    for (const auto& pairs : truth_) truths.push_back({name(question), !pairs.empty()});
    return truths;
  }

  Told ask(Running_scene& subject, const Scene_case& c, Question) const
  {
    Told told = subject(c);
    if (told.spent) told.spent->asking /= truth_.size();
    return told;
  }

  Statements statements(const Answered& a) const
  {
    Statements statements;
    for (std::size_t f = 0; f < truth_.size(); ++f) {
      Statement statement{name(a.question), int(truth_[f].size()), {}};
      statement.has_fractions =
          std::ranges::any_of(a.c.frames[f].bodies, [](const auto& body) { return body && body->pose.is_rational(); });
      if (a.told.outcome == Outcome::yes) statement.value = as_number(a.told.answer[f], truth_[f]);
      statements.push_back(statement);
    }
    return statements;
  }

 private:
  Frames_of_pairs truth_;
};

}  // namespace

Findings levels::Scenes::judge(const Job<Scenes>& job) { return Level_judge<Scene_page>(job).run(); }

}  // namespace tetracone::verify
