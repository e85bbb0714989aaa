#include "experiments/speed/race_rows.h"

#include "experiments/support/csv_row.h"

namespace tetracone::experiments {
namespace {

using kernel::Question;

Csv_row row(const Race_course& course, Question question, const Prepared_contestant& prepared, const Timing& timing,
            const Race::Checked& checked, std::uint64_t seed)
{
  const double poses = static_cast<double>(timing.poses),
               triangles = static_cast<double>(course.a.face_count() + course.b.face_count());
  Csv_row row;
  row.add("scenario", course.scenario)
      .add("object", course.object)
      .add("triangles", course.a.face_count())
      .add("star_share", star_share(course.a))
      .add("ratio", course.ratio)
      .add("degenerate", course.degenerate ? 1 : 0)
      .add("question", std::string(to_string(question)))
      .add("subject", prepared.contestant.name)
      .add("exact", prepared.contestant.exact ? 1 : 0)
      .add("poses", timing.poses)
      .add("collisions", timing.collisions)
      .add("false_positives", timing.false_positives)
      .add("false_negatives", timing.false_negatives)
      .add("reference_checked", checked.frames)
      .add("reference_wrong", checked.wrong)
      .add("passes", timing.passes)
      .add("mean_ns", timing.mean_ns)
      .add("median_ns", timing.median_ns)
      .add("p99_ns", timing.p99_ns)
      .add("same_poses_ns", timing.same_poses_ns)
      .add("tetracone_same_poses_ns", timing.first_same_poses_ns)
      .add("fcl_same_poses_ns", timing.fcl_same_poses_ns)
      .add("build_ms", prepared.build.milliseconds)
      .add("bytes_per_triangle", static_cast<double>(prepared.build.bytes) / triangles);
  if (prepared.pair->tree_bytes() > 0)
    row.add("tree_bytes_per_triangle", static_cast<double>(prepared.pair->tree_bytes()) / triangles);
  else
    row.none("tree_bytes_per_triangle");
  const auto& c = timing.counts;
  if (prepared.contestant.counts_work) {
    row.add("bounding_tests", c.bounding_tests() / poses)
        .add("pairs_visited", c.pairs_visited / poses)
        .add("leaf_pairs", c.leaf_pairs / poses)
        .add("primitive_tests", c.primitive_tests() / poses)
        .add("exact_fallbacks", c.exact_fallbacks / poses)
        .add("nodes", prepared.pair->node_count())
        .add("copies", prepared.pair->copies());
  } else {
    for (const char* name :
         {"bounding_tests", "pairs_visited", "leaf_pairs", "primitive_tests", "exact_fallbacks", "nodes", "copies"})
      row.none(name);
  }
  if (prepared.contestant.prepare_on_demand) {
    row.add("build_and_hundred_ms", prepared.build.with_first_milliseconds)
        .add("nodes_after_one", prepared.build.nodes_after_one)
        .add("nodes_after_hundred", prepared.build.nodes_after_first);
  } else {
    for (const char* name : {"build_and_hundred_ms", "nodes_after_one", "nodes_after_hundred"}) row.none(name);
  }
  return row.add_origin(seed).add("fcl", TETRACONE_FCL);
}

}  // namespace

std::string race_rows(const Race_course& course, const std::vector<Contestant>& contestants, bool solid, int passes,
                      double seconds, std::uint64_t seed)
{
  Race race(course, contestants);
  Csv_table table;
  for (const Question question : {Question::surface, Question::solid}) {
    if (question == Question::solid && !solid) break;
    const auto checked = race.check(question);
    const auto timings = race.run(question, passes, seconds);
    for (std::size_t k = 0; k < timings.size(); ++k) {
      if (timings[k]) table.add(row(course, question, race.contestants()[k], *timings[k], checked, seed));
    }
  }
  return table.text();
}

}  // namespace tetracone::experiments
