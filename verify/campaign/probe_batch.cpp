#include "verify/campaign/probe_batch.h"

#include "tetracone/kernel/number/number.h"
#include "verify/campaign/batch_parts.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/integer_truth/integer_probes.h"
#include "verify/relations/probe_relations.h"
#include "verify/truth/point_truth.h"
#include "verify/truth/ray_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tetracone::verify {
namespace {

using kernel::Rational;

/// A sorted answer to a question whose answer is a list.
using Hits = std::vector<std::pair<double, covering::Index>>;

/// The distance of a point or ray, which is exactly degenerate or not near to it.
Distance distance(bool is_degenerate)
{
  const double log2 = is_degenerate ? -HUGE_VAL : HUGE_VAL;
  return {log2, log2};
}

/// The truths for the body of the last case.
template <class First>
class Truths {
 public:
  void be_about(const Probe_case& c)
  {
    if (c.body == body_) return;
    body_ = c.body;
    first_.emplace(*body_);
    second_.emplace(*body_);
  }
  const First& first() const { return *first_; }
  const integer_truth::Probed_body& second() const { return *second_; }

 private:
  std::shared_ptr<const covering::Polyhedron> body_;
  std::optional<First> first_;
  std::optional<integer_truth::Probed_body> second_;
};

/// The common part of batches of points and of rays: it calls asking(case, k) for each case, and tries relations.
class Probe_batch : protected Working_batch<Probe_subject> {
 public:
  Probe_batch(const Campaign& campaign, const Batch& batch, const Done& done,
              const std::vector<Probe_subject>& subjects, Running_probes& running)
      : Working_batch(campaign, batch, done, subjects), running_(running)
  {}

 protected:
  template <class Judge>
  Findings judge_all(const Judge& judge, std::span<const Probe_relation> relations)
  {
    for_wanted([&](std::uint64_t k) {
      const Probe_case c = batch_.probes->probe_case(seed_, k);
      judge(c, k);
      if (k % relation_stride == 0) try_relation(c, k, relations);
    });
    return finish();
  }

  /// Adds the answer of subject `s` to a question; nothing for a failure.
  void add(const Probe_case& c, std::uint64_t k, std::size_t s, const char* question, const Distance& away, int truth,
           std::optional<int> given, std::uint64_t ns)
  {
    const Findings::Answer answer{given, false};
    found_.add_answer(subjects_[s].name, question, {away}, truth, answer, Spent{{}, ns});
    if (given != truth && k < kept_one_by_one)
      found_.add_wrong(c.origin, subjects_[s].name, question, away, truth, answer, {});
  }

  Running_probes& running_;

 private:
  void try_relation(const Probe_case& c, std::uint64_t k, std::span<const Probe_relation> relations)
  {
    const std::size_t number = (k / relation_stride + std::size_t(batch_.probes->number)) % relations.size();
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      Random random = random_of(c.origin, number);
      const Verdict verdict = relations[number].check(c, *running_[s], random);
      found_.add_relation(std::string(relations[number].name), subjects_[s].name, level_name(batch_.what),
                          verdict != Verdict::not_applicable, verdict == Verdict::violated);
    }
  }
};

class Point_batch : public Probe_batch {
 public:
  Point_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_probes& running)
      : Probe_batch(campaign, batch, done, campaign.point_subjects, running)
  {}

  Findings judge()
  {
    return judge_all([this](const Probe_case& c, std::uint64_t k) { judge(c, k); }, point_relations());
  }

 private:
  static constexpr const char* question = "inside";

  void judge(const Probe_case& c, std::uint64_t k)
  {
    truths_.be_about(c);
    const int truth = truths_.first()(c.from);
    if (truth != truths_.second().where(c.from)) throw Truths_disagree("the two truths of a point disagree", c);
    if (wanted_.truth(k)) found_.add_truth(question, truth > 0, false);
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      const auto [place, ns] = timed([&] { return running_[s]->where(c); });
      add(c, k, s, question, distance(truth == 0), truth, place, ns);
    }
  }

  Truths<Point_truth> truths_;
};

class Ray_batch : public Probe_batch {
 public:
  Ray_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_probes& running)
      : Probe_batch(campaign, batch, done, campaign.ray_subjects, running)
  {}

  Findings judge()
  {
    return judge_all([this](const Probe_case& c, std::uint64_t k) { judge(c, k); }, ray_relations());
  }

 private:
  using Faces = std::vector<covering::Index>;

  void judge(const Probe_case& c, std::uint64_t k)
  {
    truths_.be_about(c);
    const auto exact = truths_.first()(c.from, c.direction);
    if (exact != truths_.second().hits(c.from, c.direction))
      throw Truths_disagree("the two truths of a ray disagree", c);
    std::vector<Ray_hit> hits;
    for (const auto& [t, face] : exact) hits.push_back({face, kernel::nearest_double(t)});
    const Hits all = sorted(hits), first = all.empty() ? Hits() : Hits{{hits[0].t, hits[0].face}};
    const Faces faces = faces_of(hits);
    const bool is_tied =
        std::ranges::adjacent_find(exact, {}, [](const auto& hit) { return hit.first; }) != exact.end();
    if (wanted_.truth(k))
      for (const char* question : {"first", "hits", "faces"}) found_.add_truth(question, !all.empty(), false);
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      const auto [told, ns] = timed([&] { return running_[s]->hits(c); });
      const Distance away = distance(is_tied);
      std::optional<int> of_first, of_all, of_faces;
      if (told) {
        of_first = as_number(told->first ? Hits{{told->first->t, told->first->face}} : Hits(), first);
        of_all = as_number(sorted(told->all), all);
        of_faces = as_number(faces_of(told->all), faces);
      }
      add(c, k, s, "first", away, int(first.size()), of_first, ns);
      add(c, k, s, "hits", away, int(all.size()), of_all, ns);
      add(c, k, s, "faces", away, int(faces.size()), of_faces, ns);
    }
  }

  static Hits sorted(const std::vector<Ray_hit>& hits)
  {
    Hits list;
    for (const Ray_hit& hit : hits) list.emplace_back(hit.t, hit.face);
    std::ranges::sort(list);
    return list;
  }

  static Faces faces_of(const std::vector<Ray_hit>& hits)
  {
    Faces faces;
    for (const Ray_hit& hit : hits) faces.push_back(hit.face);
    std::ranges::sort(faces);
    return faces;
  }

  Truths<Ray_truth> truths_;
};

}  // namespace

Findings judge_points(const Campaign& campaign, const Batch& batch, const Done& done, Running_probes& running)
{
  return Point_batch(campaign, batch, done, running).judge();
}

Findings judge_rays(const Campaign& campaign, const Batch& batch, const Done& done, Running_probes& running)
{
  return Ray_batch(campaign, batch, done, running).judge();
}

}  // namespace tetracone::verify
