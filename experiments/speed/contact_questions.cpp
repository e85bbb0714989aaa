#include "experiments/speed/contact_questions.h"

#include "experiments/speed/benchmark_workload.h"
#include "experiments/speed/contact_verdicts.h"
#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/scene/scene.h"
#include "verify/cases/exact_motion.h"
#include "verify/cases/shape_generators.h"
#include "verify/families/probe_families.h"
#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/probe_subject.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/overlap_truth.h"
#include "verify/truth/point_truth.h"
#include "verify/truth/ray_truth.h"

#include <algorithm>

namespace tetracone::experiments {
namespace {

using kernel::Pose;
using kernel::Question;
using kernel::Rational;
using verify::Random;
using verify::Subject;
using Pair = verify::Prepared_pair;
using Shared_workload = std::shared_ptr<const Workload>;

/// Answers by `ask(k)`, which alone is clocked. `judge(answer, k)` returns the verdict; it judges a case once.
template <class Ask, class Judge>
class Clocked : public Answers {
 public:
  /// `pair` has counted the work; null where nobody has.
  Clocked(std::shared_ptr<Pair> pair, Ask ask, Judge judge)
      : pair_(std::move(pair)), ask_(std::move(ask)), judge_(std::move(judge))
  {}

  int verdict(std::size_t k) override
  {
    const auto [answer, ns] = verify::timed([&] { return ask_(k); });
    ns_ = double(ns);
    if (verdicts_.size() <= k) verdicts_.resize(k + 1);
    if (!verdicts_[k]) verdicts_[k] = judge_(answer, k);
    return *verdicts_[k];
  }
  std::optional<double> own_ns() const override { return ns_; }
  tetratree::Query_statistics take_counts() override
  {
    tetratree::Query_statistics counts = pair_ ? pair_->take_counts() : tetratree::Query_statistics();
    // Contacts, points and scenes do not count their exact signs; their thread does.
    const std::uint64_t before = std::exchange(signs_, kernel::Adaptive::exact_fallbacks());
    counts.exact_fallbacks = std::max(counts.exact_fallbacks, signs_ - before);
    return counts;
  }
  std::size_t node_count() const override { return pair_ ? pair_->node_count() : 0; }
  std::size_t tree_bytes() const override { return pair_ ? pair_->bytes() : 0; }

 private:
  std::shared_ptr<Pair> pair_;
  Ask ask_;
  Judge judge_;
  double ns_ = 0;
  std::uint64_t signs_ = kernel::Adaptive::exact_fallbacks();
  std::vector<std::optional<int>> verdicts_;
};

template <class Ask, class Judge>
std::unique_ptr<Answers> clocked(std::shared_ptr<Pair> pair, Ask ask, Judge judge)
{
  return std::make_unique<Clocked<Ask, Judge>>(std::move(pair), std::move(ask), std::move(judge));
}

Contestant method(const std::string& kernel, const std::string& name, std::size_t one_in = 1)
{
  return {.name = kernel + ' ' + name,
          .exact = Subject::parse(kernel)->is_exact(),
          .one_in = one_in,
          .kernel = kernel,
          .method = name};
}

/// The general exact stage is slow, and asked fewer cases.
std::size_t one_in(const std::string& kernel) { return kernel == "epeck" || kernel == "rational" ? 4 : 1; }

/// Returns a way by the fast tree. `ask(pair, k)` asks the workload's bodies, prepared for the kernel.
template <class Ask, class Judge>
Way by_tree(const std::string& kernel, const Shared_workload& w, const Ask& ask, const Judge& judge)
{
  return {method(kernel, "tree", one_in(kernel)), [kernel, w, ask, judge] {
            const std::shared_ptr<Pair> pair = verify::prepare(*Subject::parse(kernel), w->a, w->b);
            return clocked(
                pair, [pair, ask](std::size_t k) { return ask(*pair, k); }, judge);
          }};
}

Contact_question contacts(const Shared_workload& w)
{
  const auto a = std::make_shared<const covering::Polyhedron>(w->a),
             b = std::make_shared<const covering::Polyhedron>(w->b);
  const auto truth = std::make_shared<std::vector<verify::Contact_forms>>();
  Contact_question asked{"contacts", w};
  for (std::size_t k = 0; k < w->poses_b.size(); ++k) {
    truth->push_back(verify::contacts({a, b, w->pose_a(k), w->poses_b[k], {}, {}, {}}));
    asked.truth.push_back(!truth->back().empty());
  }
  for (const char* kernel : {"adaptive", "epeck"})  // no other has a list that is right
    asked.ways.push_back(by_tree(
        kernel, w, [w](Pair& pair, std::size_t k) { return pair.contacts(w->pose_a(k), w->poses_b[k]); },
        [truth](const Contacts& told, std::size_t k) { return verdict(verify::contact_forms(told), (*truth)[k]); }));
  return asked;
}

Contact_question distances(const Shared_workload& w)
{
  const verify::Brute_body a(w->a), b(w->b);
  const auto squares = std::make_shared<std::vector<Rational>>();
  Contact_question asked{"distance", w};
  for (std::size_t k = 0; k < w->poses_b.size(); ++k) {
    squares->push_back(verify::squared_distance({a, w->pose_a(k)}, {b, w->poses_b[k]}));
    asked.truth.push_back(sgn(squares->back()) == 0);
  }
  const bool are_small = std::max(w->a.face_count(), w->b.face_count()) <= verify::most_faces_in_rationals;
  for (const std::string kernel : {"adaptive", "double", "rational"})
    if (kernel != "rational" || are_small)
      asked.ways.push_back(by_tree(
          kernel, w,
          [w](Pair& pair, std::size_t k) {
            return pair.query(Question::surface)->distance(w->pose_a(k), w->poses_b[k]);
          },
          [squares, is_rounded = kernel == "double"](double told, std::size_t k) {
            return verdict(told, (*squares)[k], is_rounded);
          }));
  return asked;
}

/// Contacts of triangles are decided by signs, those of other faces in rationals.
Contact_question contacts_of_triangles(const Shared_workload& w)
{
  Workload cut = *w;
  cut.a = triangulated(w->a);
  cut.b = triangulated(w->b);
  Contact_question asked = contacts(std::make_shared<const Workload>(std::move(cut)));
  asked.name = "contacts of triangles";
  return asked;
}

/// A query tells which of the eight relations solids of triangles have, and the dimension of the contact.
Contact_question solid_relations(const Shared_workload& w)
{
  const auto a = std::make_shared<const covering::Polyhedron>(triangulated(w->a)),
             b = std::make_shared<const covering::Polyhedron>(triangulated(w->b));
  const auto truth = std::make_shared<std::vector<kernel::Solid_contact>>();
  Contact_question asked{"solid relation", w};
  for (std::size_t k = 0; k < w->poses_b.size(); ++k) {
    truth->push_back(verify::solid_overlap({a, b, w->pose_a(k), w->poses_b[k], {}, {}, {}}).contact);
    asked.truth.push_back(truth->back().relation != kernel::Solid_relation::disjoint);
  }
  asked.ways.push_back({method("adaptive", "tree"), [=] {
                          const auto query = std::make_shared<Query>(Body(*a), Body(*b));
                          query->solid_relation(w->pose_a(0), w->poses_b[0]);  // makes what belongs to the bodies
                          return clocked(
                              nullptr,
                              [=](std::size_t k) { return query->solid_relation(w->pose_a(k), w->poses_b[k]); },
                              [=](const kernel::Solid_contact& told, std::size_t k) {
                                return told == (*truth)[k] ? 0 : told.dimension < (*truth)[k].dimension ? -1 : 1;
                              });
                        }});
  return asked;
}

/// A motion is asked of one pose in this many: its truth takes as long as that of some hundred other cases.
constexpr std::size_t motion_stride = 4;

/// B moves along the way from A's place to B's, from twice as far until it has gone half of the way into A.
Contact_question motions(const Shared_workload& w)
{
  const auto cases = std::make_shared<std::vector<verify::Moving_bodies>>();
  Contact_question asked{"motion", w};
  for (std::size_t k = 0; k < w->poses_b.size(); k += motion_stride) {
    const auto rest = verify::entries_of(w->pose_a(k)), contact = verify::entries_of(w->poses_b[k]);
    const auto at = [&](const Rational& share) {
      std::vector<Rational> entries(contact.begin(), contact.end());
      for (std::size_t i = 3; i < entries.size(); i += 4) entries[i] += share * (contact[i] - rest[i]);
      if (!w->poses_b[k].is_rational())
        for (Rational& entry : entries) entry = kernel::nearest_double(entry);
      return entries;
    };
    const std::vector<Rational> still(rest.begin(), rest.end());
    cases->push_back({w->a, w->b, {still, still}, {at(1), at(Rational(-1) / 2)}});
    asked.truth.push_back(true);
  }
  struct Moves {
    Motion a, b;
  };
  const auto moves = std::make_shared<std::vector<Moves>>();
  for (const verify::Moving_bodies& c : *cases)
    moves->push_back({Motion(verify::motion_of(c.motion_a)), Motion(verify::motion_of(c.motion_b))});
  asked.ways.push_back(by_tree(
      "adaptive", w,  // the only kernel that follows motions
      [moves](Pair& pair, std::size_t k) {
        return pair.query(Question::surface)->first_contact((*moves)[k].a, (*moves)[k].b);
      },
      [cases](const std::optional<First_contact>& told, std::size_t k) {
        return verdict(told ? std::optional(kernel::Time_bounds{told->lo, told->hi}) : std::nullopt, (*cases)[k]);
      }));
  return asked;
}

/// A family of points or rays, with the parameter that it is asked with, and how the contact is called.
struct Probe_kind {
  const char *family, *scenario;
  double parameter;
};

std::vector<verify::Probe_case> probes(const std::vector<verify::Probe_family>& families, const Probe_kind& kind,
                                       int count, Random random)
{
  const verify::Probed_body body = verify::probed(std::make_shared<const covering::Polyhedron>(verify::complex_one()));
  const verify::Probe_family& family = *verify::find_named(families, kind.family);
  std::vector<verify::Probe_case> cases;
  while (int(cases.size()) < count) {
    const verify::Probe probe = family.make(random, body, kind.parameter);
    const bool is_point = probe.direction == kernel::Vertex{0, 0, 0};
    if (is_point && family.name.starts_with("ray")) continue;
    cases.push_back({body.body, probe.from, probe.direction, {}});
  }
  return cases;
}

/// The probes as bodies; each point has its pose.
Shared_workload workload_of(const Probe_kind& kind, const std::string& name,
                            const std::vector<verify::Probe_case>& cases)
{
  const verify::Object_case first = verify::as_objects(cases[0]);
  Workload w{"degenerate", kind.scenario, "complex-1", name, *first.a, *first.b, 1, {Pose()}, {}, {}};
  for (const verify::Probe_case& c : cases) w.poses_b.push_back(Pose::translation(c.from[0], c.from[1], c.from[2]));
  return std::make_shared<const Workload>(std::move(w));
}

/// Points by the fast tree, as bodies of one vertex, or by the table that `Body::inside` asks.
Contact_question points(const Probe_kind& kind, bool by_table, int count, const Random& random)
{
  const auto cases = probes(verify::point_families(), kind, count, random);
  Contact_question asked{by_table ? "point by table" : "point", workload_of(kind, "point", cases)};
  const auto truth = std::make_shared<std::vector<int>>();
  const verify::Point_truth of_body(*cases[0].body);
  for (const verify::Probe_case& c : cases) {
    truth->push_back(of_body(c.from));
    asked.truth.push_back(truth->back() >= 0);
  }
  const auto judge = [truth](int told, std::size_t k) { return std::clamp(told - (*truth)[k], -1, 1); };
  if (by_table) {
    asked.ways.push_back({method("adaptive", "locator"), [cases, judge] {
                            const Body body = triangulated_body(*cases[0].body);
                            body.inside_bytes();  // makes the table
                            return clocked(
                                nullptr, [cases, body](std::size_t k) { return int(body.inside(cases[k].from)); },
                                judge);
                          }});
    return asked;
  }
  const auto ask = [w = asked.workload](Pair& pair, std::size_t k) {
    const Relation at = pair.relation(w->pose_a(k), w->poses_b[k], Question::solid);
    return at == Relation::apart ? -1 : at == Relation::surfaces ? 0 : 1;
  };
  for (const char* kernel : {"adaptive", "double", "epeck"})
    asked.ways.push_back(by_tree(kernel, asked.workload, ask, judge));
  return asked;
}

/// First hits of rays. The method in double tests every triangle.
Contact_question rays(const Probe_kind& kind, int count, const Random& random)
{
  const auto cases = probes(verify::ray_families(), kind, count, random);
  using First = std::vector<std::pair<double, covering::Index>>;  // the t and the face of the first hit; may be empty
  const auto truth = std::make_shared<std::vector<First>>();
  Contact_question asked{"ray", workload_of(kind, "ray", cases)};
  const verify::Ray_truth of_body(*cases[0].body);
  for (const verify::Probe_case& c : cases) {
    First& first = truth->emplace_back();
    if (const auto all = of_body(c.from, c.direction); !all.empty())
      first = {{kernel::nearest_double(all[0].first), all[0].second}};
    asked.truth.push_back(!first.empty());
  }
  const auto first_of = [](const std::optional<Ray_hit>& hit) { return hit ? First{{hit->t, hit->face}} : First(); };
  asked.ways.push_back(
      {method("adaptive", "tree"), [=] {
         const Body body = triangulated_body(*cases[0].body);
         body.make_all();
         return clocked(
             nullptr,
             [=](std::size_t k) {
               return body.first_hit({cases[k].from, cases[k].direction});
             },
             [=](const std::optional<Ray_hit>& told, std::size_t k) { return verdict(first_of(told), (*truth)[k]); });
       }});
  asked.ways.push_back({method("double", "moeller-trumbore"), [=] {
                          const auto subjects = verify::ray_subjects();
                          const auto subject =
                              std::ranges::find(subjects, "double moeller-trumbore", &verify::Ray_subject::name);
                          const std::shared_ptr<verify::Running_rays> running = subject->make();
                          return clocked(
                              nullptr, [=](std::size_t k) { return (*running)(cases[k]).answer.first; },
                              [=](const std::optional<Ray_hit>& told, std::size_t k) {
                                const auto face = [](First first) {
                                  for (auto& hit : first) hit.first = 0;  // t is rounded
                                  return first;
                                };
                                return verdict(face(first_of(told)), face((*truth)[k]));
                              });
                        }});
  return asked;
}

/// Scenes of 27 cubes that are stacked without gaps. A case is a frame of the scene, which moves all of them into
/// another common frame.
Contact_question stacks(bool exact, int count, Random random)
{
  constexpr std::size_t cubes = 27;
  using Pairs = std::vector<Scene_pair>;
  const auto w =
      std::make_shared<Workload>(Workload{"degenerate",
                                          std::string("27 stacked cubes") + (exact ? "" : " (rounded poses)"),
                                          "cube",
                                          "cube",
                                          verify::unit_cube(),
                                          verify::unit_cube(),
                                          1,
                                          {},
                                          {},
                                          {}});
  const verify::Brute_body cube(w->a);
  const auto truth = std::make_shared<std::vector<Pairs>>();
  Contact_question asked{"scene", w};
  // A frame that is asked again must differ from the last one, or there is nothing to decide.
  for (int frame = 0; frame < std::max(2, count); ++frame) {
    const Common_frame common(random);
    std::vector<verify::Placed_body> placed;
    for (std::size_t k = 0; k < cubes; ++k) {
      w->poses_b.push_back(
          common.placed({Rational(int(k % 3)), Rational(int(k / 3 % 3)), Rational(int(k / 9))}, exact));
      placed.emplace_back(cube, w->poses_b.back());
    }
    Pairs& pairs = truth->emplace_back();
    for (std::size_t a = 0; a < cubes; ++a)
      for (std::size_t b = a + 1; b < cubes; ++b)
        if (verify::collide(placed[a], placed[b], Question::surface)) pairs.push_back({a, b});
    asked.truth.push_back(!pairs.empty());
  }
  for (const char* kernel : {"adaptive", "double", "epeck"})
    asked.ways.push_back({method(kernel, "tree", one_in(kernel)), [=] {
                            const auto scene = std::make_shared<Scene>(Scene_options{
                                .question = Question::surface, .query = {.kernel = parse_kernel(kernel)->kernel}});
                            const std::size_t model = scene->add_model(triangulated_body(w->a));
                            for (std::size_t k = 0; k < cubes; ++k) scene->add_body(model);
                            return clocked(
                                nullptr,
                                [=](std::size_t frame) {
                                  for (std::size_t k = 0; k < cubes; ++k)
                                    scene->place(k, w->poses_b[cubes * frame + k]);
                                  return scene->pairs();
                                },
                                [=](const Pairs& told, std::size_t frame) { return verdict(told, (*truth)[frame]); });
                          }});
  return asked;
}

constexpr std::array point_kinds = {
    Probe_kind{"point-on-vertex", "on a vertex", 0}, Probe_kind{"point-on-edge", "on an edge", 3},
    Probe_kind{"point-on-face", "on a face", 3}, Probe_kind{"point-near-surface", "gap of an ulp", 1}};
constexpr std::array ray_kinds = {
    Probe_kind{"ray-through-vertex", "through a vertex", 0}, Probe_kind{"ray-through-edge", "through an edge", 0},
    Probe_kind{"ray-along-edge", "along an edge", -1}, Probe_kind{"ray-in-plane", "in the plane of a face", 0.5},
    Probe_kind{"ray-through-edge", "gap of an ulp", 1}};

}  // namespace

std::vector<Named_question> contact_questions(const std::filesystem::path& models, int rotations, std::uint64_t seed)
{
  std::vector<Named_question> list;
  for (const Named_workload& workload : study_workloads(models, 1, rotations, seed)) {
    if (!workload.name.starts_with("degenerate-") || workload.name == "degenerate-nested") continue;
    const auto add = [&](const std::string& name, Contact_question (*ask)(const Shared_workload&)) {
      list.push_back({name + workload.name.substr(10),
                      [make = workload.make, ask] { return ask(std::make_shared<const Workload>(make())); }});
    };
    add("contacts", contacts);
    add("distance", distances);
    for (const char* shared : {"-face", "-edge", "-vertex"})
      for (const char* poses : {"", "-rounded"})
        if (workload.name == std::string("degenerate") + shared + poses) {
          add("contacts-of-triangles", contacts_of_triangles);
          add("relation", solid_relations);
          add("motion", motions);
        }
  }
  const auto add = [&](const std::string& name, const auto& make) {
    list.push_back({name, [make, random = Random(seed + 1000 * list.size())] { return make(random); }});
  };
  for (const Probe_kind& kind : point_kinds) {
    add(kind.family, [=](const Random& random) { return points(kind, false, rotations, random); });
    add(std::string("table-") + kind.family,
        [=](const Random& random) { return points(kind, true, rotations, random); });
  }
  for (const Probe_kind& kind : ray_kinds)
    add(std::string(kind.family) + '-' + kernel::shortest(kind.parameter),
        [=](const Random& random) { return rays(kind, rotations, random); });
  for (const bool exact : {true, false})
    add(exact ? "scene-stack" : "scene-stack-rounded",
        [=](const Random& random) { return stacks(exact, rotations, random); });
  return list;
}

}  // namespace tetracone::experiments
