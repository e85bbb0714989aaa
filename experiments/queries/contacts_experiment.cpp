#include "experiments/queries/experiments.h"

#include "experiments/peers/fcl.h"
#include "experiments/speed/benchmark_workload.h"
#include "tetracone/tetratree/door/tetracone.h"

namespace tetracone::experiments {
namespace {

using Face_pair = Fcl_contacts::Pair;

/// A method that lists the contacts of a pose.
struct Lister {
  std::string name;
  std::function<std::size_t(const kernel::Pose& pose_b)> list;
  std::function<std::vector<Face_pair>(const kernel::Pose& pose_b)> pairs;
  double total_ns = 0;
  std::size_t pair_count = 0, lost = 0, invented = 0;
};

std::vector<Face_pair> pairs_of(const Contacts& contacts)
{
  std::vector<Face_pair> pairs;
  for (std::size_t k = 0; k < contacts.size(); ++k) pairs.push_back({contacts[k].face_a, contacts[k].face_b});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Returns the methods. The first is ours, whose pairs are the truth.
std::vector<Lister> listers(const Race_course& course, Query& query)
{
  const auto contacts = [&query](const kernel::Pose& pose) { return query.contacts(kernel::Pose(), pose); };
  const auto our_pairs = [=](const kernel::Pose& pose) { return pairs_of(contacts(pose)); };
  std::vector<Lister> all = {
      {"tetracone", [=](const kernel::Pose& pose) { return contacts(pose).size(); }, our_pairs},
      {"tetracone with enclosures",
       [=](const kernel::Pose& pose) {
         const Contacts found = contacts(pose);
         std::size_t points = 0;
         for (std::size_t k = 0; k < found.size(); ++k) points += found.loops(k)[0].size();
         return points;
       },
       our_pairs},
  };
  for (const bool with_points : {false, true}) {
    const std::shared_ptr<Fcl_contacts> fcl = prepare_fcl_contacts(course.a, course.b, with_points);
    if (!fcl) continue;
    all.push_back({with_points ? "FCL OBBRSS with points" : "FCL OBBRSS",
                   [=](const kernel::Pose& pose) { return fcl->list(kernel::Pose(), pose); },
                   [=](const kernel::Pose& pose) {
                     fcl->list(kernel::Pose(), pose);
                     return fcl->pairs();
                   }});
  }
  return all;
}

/// Takes the fastest time of each pose over all passes, in which the methods take turns. Then compares what they list.
void race(std::vector<Lister>& all, const std::vector<kernel::Pose>& poses, int passes)
{
  std::size_t found = 0;
  const auto fastest = fastest_times(all.size(), poses.size(), passes,
                                     [&](std::size_t s, std::size_t k) { found += all[s].list(poses[k]); });
  for (std::size_t s = 0; s < all.size(); ++s) {
    all[s].total_ns = sum_of(fastest[s]);
    for (const kernel::Pose& pose : poses) {
      const auto truth = all[0].pairs(pose), listed = all[s].pairs(pose);
      all[s].pair_count += listed.size();
      all[s].lost += missing(listed, truth);
      all[s].invented += missing(truth, listed);
    }
  }
  if (found == 0) std::fprintf(stderr, "no contact in any pose\n");
}

}  // namespace

void run_contacts(const Experiment_options& options)
{
  constexpr int passes = 15;
  Race_objects objects(options.models);
  Csv_table table;
  std::printf("%-28s %-26s %6s %9s %10s %6s %8s %7s\n", "trajectory", "method", "poses", "pairs", "us a pose", "lost",
              "invented", "ratio");
  for (const std::string object : {"blob", "knot2"})
    for (const std::string trajectory : {"contour", "circular"}) {
      const Race_course course = on_trajectory(objects(object, 7172), object, trajectory, 1, options.race_frames,
                                               options.seed, trajectory == "circular" ? 8 : 1);
      Query query(Body(course.a), Body(course.b), Question::surface);
      std::vector<kernel::Pose> hits;
      for (const kernel::Pose& pose : course.poses_b)
        if (query.collide(kernel::Pose(), pose)) hits.push_back(pose);
      if (hits.empty()) continue;
      auto all = listers(course, query);
      race(all, hits, passes);
      for (const Lister& each : all) {
        const double us = each.total_ns / double(hits.size()) / 1000;
        const double ratio = each.total_ns / all[0].total_ns;
        table.add(Csv_row()
                      .add("scenario", course.scenario)
                      .add("object", object)
                      .add("triangles", course.a.face_count())
                      .add("method", each.name)
                      .add("poses", hits.size())
                      .add("pairs", each.pair_count)
                      .add_exact("ns", each.total_ns / double(hits.size()))
                      .add_exact("ratio", ratio)
                      .add("lost", each.lost)
                      .add("invented", each.invented)
                      .add_origin(options.seed));
        std::printf("%-28s %-26s %6zu %9zu %10.1f %6zu %8zu %7.2f\n", (course.scenario + " " + object).c_str(),
                    each.name.c_str(), hits.size(), each.pair_count, us, each.lost, each.invented, ratio);
      }
    }
  write_whole(options.out / "contacts.csv", table.text());
}

}  // namespace tetracone::experiments
