#include "verify/campaign/scene_batch.h"

#include "verify/campaign/batch_parts.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/relations/scene_relations.h"
#include "verify/truth/cgal_truth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

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

/// A running batch of scenes.
class Scene_batch : Working_batch<Scene_subject> {
 public:
  Scene_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_scenes& running)
      : Working_batch(campaign, batch, done, campaign.scene_subjects), running_(running)
  {}

  Findings judge()
  {
    for_wanted([this](std::uint64_t k) { judge(batch_.scenes->scene_case(seed_, k), k); });
    return finish();
  }

 private:
  void judge(const Scene_case& c, std::uint64_t k)
  {
    const Frames_of_pairs truth = True_pairs(c).all();
    if (wanted_.truth(k))
      for (const auto& pairs : truth) found_.add_truth(name_of(c.question), !pairs.empty(), false);
    for (std::size_t s = 0; s < subjects_.size(); ++s)
      if (wanted_.subject(s, k)) judge_answer(c, k, s, truth);
  }

  void judge_answer(const Scene_case& c, std::uint64_t k, std::size_t s, const Frames_of_pairs& truth)
  {
    const auto [told, ns] = timed([&] { return running_[s]->play(c); });
    const Distance away{HUGE_VAL, HUGE_VAL};  // is not known
    bool is_right = true;
    for (std::size_t f = 0; f < truth.size(); ++f) {
      const int right = int(truth[f].size());
      const Findings::Answer answer{told ? std::optional(as_number((*told)[f], truth[f])) : std::nullopt, false};
      const Findings::Kind kind{away, has_fractions(c.frames[f])};
      found_.add_answer(subjects_[s].name, name_of(c.question), kind, right, answer, Spent{{}, ns / truth.size()});
      // Only the first wrong frame of a scene is listed.
      if (is_right && answer.value != right && k < kept_one_by_one)
        found_.add_wrong(c.origin, subjects_[s].name, name_of(c.question), away, right, answer, {});
      is_right = is_right && answer.value == right;
    }
    if (told && k % relation_stride == 0) try_relations(c, s, *told);
  }

  static bool has_fractions(const Scene_case::Frame& frame)
  {
    return std::ranges::any_of(frame.bodies, [](const auto& body) { return body && body->pose.is_rational(); });
  }

  void try_relations(const Scene_case& c, std::size_t s, const Frames_of_pairs& given)
  {
    const auto relations = scene_relations();
    for (std::size_t number = 0; number < relations.size(); ++number) {
      Random random = random_of(c.origin, number);
      const Verdict verdict = relations[number].check(c, *running_[s], given, random);
      found_.add_relation(std::string(relations[number].name), subjects_[s].name, name_of(c.question),
                          verdict != Verdict::not_applicable, verdict == Verdict::violated);
    }
  }

  Running_scenes& running_;
};

}  // namespace

Findings judge_scenes(const Campaign& campaign, const Batch& batch, const Done& done, Running_scenes& running)
{
  return Scene_batch(campaign, batch, done, running).judge();
}

}  // namespace tetracone::verify
