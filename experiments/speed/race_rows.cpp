#include "experiments/speed/race_rows.h"

#include "experiments/support/csv_row.h"

#include <initializer_list>

namespace tetracone::experiments {
namespace {

using kernel::Question;

void add_none(Csv_row& row, std::initializer_list<const char*> names)
{
  for (const char* name : names) row.none(name);
}

void add_course(Csv_row& row, const Race_course& course)
{
  row.add("scenario", course.scenario)
      .add("object", course.object)
      .add("triangles", course.a.face_count())
      .add("star_share", star_share(course.a))
      .add("ratio", course.ratio)
      .add("degenerate", course.degenerate ? 1 : 0);
}

void add_answers(Csv_row& row, const Judged_answers& answers)
{
  row.add("poses", answers.poses)
      .add("collisions", answers.collisions)
      .add("false_positives", answers.false_positives)
      .add("false_negatives", answers.false_negatives)
      .add("judged_by_truth", answers.poses)
      .add("course_poses", answers.course_poses)
      .add("course_collisions", answers.course_collisions)
      .add("estimator", answers.estimator());
}

void add_times(Csv_row& row, const Timing& timing)
{
  row.add("passes", timing.passes);
  if (std::isfinite(timing.mean_ns))
    row.add("mean_ns", timing.mean_ns)
        .add("median_ns", timing.median_ns)
        .add("p99_ns", timing.p99_ns)
        .add("same_poses_ns", timing.same_poses_ns);
  else  // a program that tells none
    add_none(row, {"mean_ns", "median_ns", "p99_ns", "same_poses_ns"});
  row.add("tetracone_same_poses_ns", timing.first_same_poses_ns).add("fcl_same_poses_ns", timing.fcl_same_poses_ns);
}

void add_cold(Csv_row& row, const Prepared_contestant& prepared, const Timing& timing, Question question)
{
  if (!prepared.contestant.clocked_cold || question != Question::surface)
    return add_none(row, {"cold_ns", "warm_ns", "first_build_ms", "first_query_ms"});
  row.add("cold_ns", timing.cold_ns)
      .add("warm_ns", timing.warm_ns)
      .add("first_build_ms", prepared.build.first_build_milliseconds)
      .add("first_query_ms", prepared.build.first_query_milliseconds);
}

void add_build(Csv_row& row, const Prepared_contestant& prepared, double triangles)
{
  // A program makes its bodies in its own process.
  if (prepared.pair->own_ns()) return add_none(row, {"build_ms", "bytes_per_triangle", "tree_bytes_per_triangle"});
  const auto tree_bytes = double(prepared.pair->tree_bytes());
  row.add("build_ms", prepared.build.milliseconds)
      .add("bytes_per_triangle", double(prepared.build.bytes) / triangles)
      .add("tree_bytes_per_triangle", tree_bytes > 0 ? std::optional(tree_bytes / triangles) : std::nullopt);
}

void add_work(Csv_row& row, const Prepared_contestant& prepared, const Timing& timing)
{
  if (!prepared.contestant.counts_work)
    return add_none(row, {"bounding_tests", "pairs_visited", "leaf_pairs", "primitive_tests", "exact_fallbacks",
                          "nodes", "copies", "cuts", "cuts_that_tried_cones", "cuts_into_cones"});
  const auto& counts = timing.counts;
  const double poses = static_cast<double>(timing.course_poses);
  row.add("bounding_tests", counts.bounding_tests() / poses)
      .add("pairs_visited", counts.pairs_visited / poses)
      .add("leaf_pairs", counts.leaf_pairs / poses)
      .add("primitive_tests", counts.primitive_tests() / poses)
      .add("exact_fallbacks", counts.exact_fallbacks / poses)
      .add("nodes", prepared.pair->node_count())
      .add("copies", prepared.pair->copies());
  const tetratree::Cut_counts cuts = prepared.pair->cuts();
  if (cuts.all == 0) return add_none(row, {"cuts", "cuts_that_tried_cones", "cuts_into_cones"});
  row.add("cuts", cuts.all).add("cuts_that_tried_cones", cuts.tried_cones).add("cuts_into_cones", cuts.through_origin);
}

void add_build_on_demand(Csv_row& row, const Prepared_contestant& prepared)
{
  if (!prepared.contestant.prepare_on_demand)
    return add_none(row, {"build_and_hundred_ms", "nodes_after_one", "nodes_after_hundred"});
  row.add("build_and_hundred_ms", prepared.build.with_first_milliseconds)
      .add("nodes_after_one", prepared.build.nodes_after_one)
      .add("nodes_after_hundred", prepared.build.nodes_after_first);
}

Csv_row row(const Race_course& course, Question question, const Prepared_contestant& prepared, const Timing& timing,
            std::uint64_t seed)
{
  Csv_row row;
  add_course(row, course);
  row.add("question", std::string(to_string(question)))
      .add("subject", prepared.contestant.name)
      .add("exact", prepared.contestant.exact ? 1 : 0);
  add_answers(row, timing);
  add_times(row, timing);
  add_cold(row, prepared, timing, question);
  add_build(row, prepared, static_cast<double>(course.a.face_count() + course.b.face_count()));
  add_work(row, prepared, timing);
  add_build_on_demand(row, prepared);
  return row.add_origin(seed).add("fcl", TETRACONE_FCL);
}

}  // namespace

std::string race_rows(const Race_course& course, const std::vector<Contestant>& contestants, bool solid, int passes,
                      double seconds, const Experiment_options& options)
{
  const Course_truth truth = kept_course_truth(course, options.out / "truth");
  Race race(course, truth, contestants);
  Csv_table table;
  for (const Question question : {Question::surface, Question::solid}) {
    if (question == Question::solid && !solid) break;
    const auto timings = race.run(question, passes, options.seconds_or(seconds));
    for (std::size_t k = 0; k < timings.size(); ++k) {
      if (timings[k]) table.add(row(course, question, race.contestants()[k], *timings[k], options.seed));
    }
  }
  return table.text();
}

}  // namespace tetracone::experiments
