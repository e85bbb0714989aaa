#include "experiments/accuracy/experiments.h"

#include "experiments/accuracy/motion_subjects.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_moving_pairs.h"
#include "tetracone/kernel/motion/first_contact.h"
#include "verify/families/motion_families.h"
#include "verify/relations/motion_relations.h"
#include "verify/truth/motion_truth.h"

#include <ctime>
#include <map>

namespace tetracone::experiments {
namespace {

using kernel::Moving_pair;

/// Pairs of one origin, with the truth of each.
struct Judged {
  std::string name;
  std::vector<Moving_pair> pairs;
  std::vector<bool> truth;
};

/// The published queries, by the scene that they are of: QUERIES/SCENE/KIND/FILE.csv.
std::vector<Judged> published(const std::filesystem::path& folder)
{
  std::map<std::string, Judged> scenes;
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder))
    throw covering::Input_error(folder.native(), 0, "is no folder", "expected a folder of queries");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const auto& file : files) {
    const auto kind = covering::moving_kind_of(file);
    if (!kind) continue;
    Judged& scene = scenes[file.parent_path().parent_path().filename().native()];
    for (const covering::Moving_query& query : covering::read_moving_pairs(file, *kind)) {
      if (!query.truth) continue;
      scene.pairs.push_back(query.pair);
      scene.truth.push_back(*query.truth);
    }
  }
  std::vector<Judged> all;
  for (auto& [name, scene] : scenes) {
    if (scene.pairs.empty()) continue;
    scene.name = "published " + name;
    all.push_back(std::move(scene));
  }
  if (all.empty())
    throw covering::Input_error(folder.native(), 0, "holds no query whose answer is known",
                                "expected SCENE/vertex-face/*.csv or SCENE/edge-edge/*.csv");
  return all;
}

/// Returns the answers of a subject and its microseconds of processor time per pair. The time is that of the fastest of
/// several passes, or of one pass where a pass takes long.
std::pair<std::vector<bool>, double> timed_answers(const Motion_subject& subject, const std::vector<Moving_pair>& pairs)
{
  std::vector<bool> answers(pairs.size());
  double fastest = 0, all = 0;
  for (int pass = 0; pass < 5 && all < 2e8; ++pass) {
    const std::clock_t start = std::clock();
    for (std::size_t k = 0; k < pairs.size(); ++k) answers[k] = subject.meet(pairs[k]);
    const double ns = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    all += ns;
    fastest = pass == 0 ? ns : std::min(fastest, ns);
  }
  return {answers, 1e-3 * fastest / static_cast<double>(pairs.size())};
}

void judge(const Judged& judged, std::uint64_t seed, Csv_table& table)
{
  for (const Motion_subject& subject : motion_subjects()) {
    const auto [answers, us] = timed_answers(subject, judged.pairs);
    std::uint64_t invented = 0, missed = 0;
    for (std::size_t k = 0; k < answers.size(); ++k) {
      invented += answers[k] && !judged.truth[k];
      missed += !answers[k] && judged.truth[k];
    }
    table.add(Csv_row()
                  .add("family", judged.name)
                  .add("subject", std::string(subject.name))
                  .add("n", judged.pairs.size())
                  .add("contacts", std::ranges::count(judged.truth, true))
                  .add("false_positives", invented)
                  .add("false_negatives", missed)
                  .add("us", us)
                  .add_origin(seed));
  }
}

}  // namespace

void run_motion(const Experiment_options& options)
{
  const std::uint64_t cases = (options.full ? 500 : 10) * options.cases, seed = options.seed;
  Csv_table table, relations;
  for (const Judged& judged : options.queries.empty() ? std::vector<Judged>() : published(options.queries))
    judge(judged, seed, table);

  Progress progress("moving pairs", verify::motion_families().size() * cases);
  verify::Random random(seed);
  for (const verify::Motion_family& family : verify::motion_families()) {
    Judged judged{std::string(family.name), {}, {}};
    std::uint64_t wrong_times = 0;
    std::map<std::string_view, std::array<std::uint64_t, 3>> verdicts;
    for (std::uint64_t k = 0; k < cases; ++k, progress.step()) {
      const Moving_pair pair = verify::motion_case(family, seed, k);
      judged.pairs.push_back(pair);
      judged.truth.push_back(verify::truly_meet_in_motion(pair));
      wrong_times += !verify::truly_first(pair, kernel::first_contact_time(pair), judged.truth.back());
      for (const verify::Motion_relation& relation : verify::motion_relations())
        ++verdicts[relation.name][static_cast<std::size_t>(relation.check(pair, random))];
    }
    judge(judged, seed, table);
    const auto row = [&](std::string_view name, std::uint64_t holds, std::uint64_t violated, std::uint64_t none) {
      relations.add(Csv_row()
                        .add("family", std::string(family.name))
                        .add("relation", std::string(name))
                        .add("holds", holds)
                        .add("violated", violated)
                        .add("not_applicable", none)
                        .add_origin(seed));
    };
    row("first time", cases - wrong_times, wrong_times, 0);
    for (const auto& [name, count] : verdicts) row(name, count[0], count[1], count[2]);
  }
  write_whole(options.out / "motion.csv", table.text());
  write_whole(options.out / "motion_relations.csv", relations.text());
}

}  // namespace tetracone::experiments
