#include "experiments/speed/study.h"

#include "experiments/peers/fcl_peer.h"
#include "experiments/speed/workloads.h"
#include "experiments/support/build_info.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/text_lines.h"
#include "verify/subjects/subject.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace tetracone::experiments {
namespace {

using Clock = std::chrono::steady_clock;
using kernel::Pose;
using kernel::Question;
using verify::Kernel_name;
using verify::Method;
using verify::Prepared_pair;
using verify::Subject;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A subject of the study: one of ours, or a peer.
struct Candidate {
  std::string name, kernel, method;
  bool exact = false;
  std::size_t one_in = 1;  ///< asks every so many-th pose: slow subjects see fewer
  std::function<std::unique_ptr<Prepared_pair>(const Workload&)> prepare;
};

Candidate ours(const std::string& kernel, Method method, std::size_t one_in = 1)
{
  const Subject subject = *Subject::parse(kernel, method);
  return {subject.name(),
          subject.kernel_name(),
          std::string(to_string(method)),
          subject.is_exact(),
          one_in,
          [subject](const Workload& w) { return verify::prepare(subject, w.a, w.b); }};
}

std::vector<Candidate> candidates(const Workload& workload)
{
  std::vector<Candidate> list;
  for (const char* kernel : {"float", "double", "double-eps=1e-12", "epick", "epeck", "adaptive"})
    list.push_back(ours(kernel, Method::tree));
  list.push_back(ours("rational", Method::tree, 4));
  for (const char* kernel : {"double", "adaptive"}) list.push_back(ours(kernel, Method::paper));
  if (workload.regime == "degenerate")
    for (const char* kernel : {"float", "double", "double-eps=1e-12", "epick", "adaptive"})
      list.push_back(ours(kernel, Method::brute));
  list.push_back(
      {"FCL OBBRSS", "FCL", "peer", false, 1, [](const Workload& w) { return prepare_fcl(w.a, w.b, w.scale_b); }});
  return list;
}

struct Judged {
  std::size_t poses = 0, collisions = 0, false_positives = 0, false_negatives = 0;
  std::vector<double> nanoseconds;  ///< of each pose asked, the fastest of the passes
  double build_seconds = 0;
  std::size_t bytes = 0, nodes = 0;
  tetratree::Query_statistics counts;  ///< of one pass
};

Judged judge(const Workload& workload, const Candidate& candidate, Question question, const std::vector<char>& truth)
{
  Judged result;
  const auto start = Clock::now();
  const auto pair = candidate.prepare(workload);
  if (!pair) return result;
  result.build_seconds = seconds_since(start);
  result.bytes = pair->bytes();
  result.nodes = pair->node_count();

  std::vector<std::size_t> asked;
  for (std::size_t k = 0; k < workload.poses_b.size(); k += candidate.one_in) asked.push_back(k);
  result.poses = asked.size();
  result.nanoseconds.assign(asked.size(), std::numeric_limits<double>::infinity());
  const auto first_pass = Clock::now();
  constexpr int passes = 5;
  constexpr double enough_seconds = 0.3;  // slow subjects are timed once
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const std::size_t k = asked[i];
      const auto before = Clock::now();
      const bool answer = pair->collide(workload.pose_a(k), workload.poses_b[k], question);
      const double ns = std::chrono::duration<double, std::nano>(Clock::now() - before).count();
      result.nanoseconds[i] = std::min(result.nanoseconds[i], ns);
      if (pass > 0) continue;
      result.collisions += truth[k];
      result.false_positives += answer && !truth[k];
      result.false_negatives += !answer && truth[k];
    }
    if (pass == 0) result.counts = pair->take_counts();
    if (seconds_since(first_pass) > enough_seconds) break;
  }
  std::sort(result.nanoseconds.begin(), result.nanoseconds.end());
  return result;
}

std::string header()
{
  return "regime,scenario,a,b,ratio,question,subject,kernel,method,exact,poses,collisions,false_positives,false_"
         "negatives,"
         "mean_ns,median_ns,p99_ns,build_ms,bytes,nodes,pairs_visited,discarded_by_hull,discarded_by_sphere,"
         "discarded_by_tetrahedron,bounding_tests,primitive_tests,exact_fallbacks,seed,version,compiler,flags,"
         "processor\n";
}

std::string row(const Workload& w, Question question, const Candidate& candidate, const Judged& judged,
                std::uint64_t seed)
{
  std::ostringstream out;
  const double n = static_cast<double>(judged.poses);
  const auto each = [n](std::uint64_t count) { return kernel::shortest(static_cast<double>(count) / n); };
  const auto& ns = judged.nanoseconds;
  const auto at = [&ns](double share) {
    return ns[std::min(ns.size() - 1, static_cast<std::size_t>(share * ns.size()))];
  };
  const auto whole = [](double x) { return std::to_string(static_cast<long long>(x)); };
  const auto& c = judged.counts;
  out << w.regime << ',' << w.scenario << ',' << w.a_name << ',' << w.b_name << ',' << kernel::shortest(1 / w.scale_b)
      << ',' << to_string(question) << ',' << candidate.name << ',' << candidate.kernel << ',' << candidate.method
      << ',' << (candidate.exact ? 1 : 0) << ',' << judged.poses << ',' << judged.collisions << ','
      << judged.false_positives << ',' << judged.false_negatives << ','
      << whole(std::accumulate(ns.begin(), ns.end(), 0.0) / n) << ',' << whole(at(0.5)) << ',' << whole(at(0.99)) << ','
      << kernel::shortest(std::round(judged.build_seconds * 1e6) / 1e3) << ',' << judged.bytes << ',' << judged.nodes
      << ',' << each(c.pairs_visited) << ',' << each(c.discarded_by_hull) << ',' << each(c.discarded_by_sphere) << ','
      << each(c.discarded_by_tetrahedron) << ',' << each(c.bounding_tests()) << ',' << each(c.primitive_tests()) << ','
      << each(c.exact_fallbacks) << ',' << seed << ',' << TETRACONE_VERSION << ',' << compiler() << ','
      << compiler_flags() << ',' << processor() << '\n';
  return out.str();
}

std::string study_workload(const Workload& workload, std::uint64_t seed, const std::string& title)
{
  const auto truth_teller = verify::prepare(*Subject::parse("rational", Method::brute), workload.a, workload.b);
  std::string rows;
  const auto list = candidates(workload);
  Progress progress(title, workload.questions.size() * (list.size() + workload.poses_b.size()));
  for (const Question question : workload.questions) {
    std::vector<char> truth;
    for (std::size_t k = 0; k < workload.poses_b.size(); ++k) {
      truth.push_back(truth_teller->collide(workload.pose_a(k), workload.poses_b[k], question));
      progress.step();
    }
    for (const Candidate& candidate : list) {
      const Judged judged = judge(workload, candidate, question, truth);
      if (judged.poses > 0) rows += row(workload, question, candidate, judged, seed);
      progress.step();
    }
  }
  return rows;
}

}  // namespace

void run_study(const Study_options& options)
{
  const auto workloads = study_workloads(options.models, options.frames, options.rotations, options.seed);
  // What was made with other options, or by another version, stays where it is and is not taken for this one.
  const std::string key = "v" TETRACONE_VERSION "-seed" + std::to_string(options.seed) + "-frames" +
                          std::to_string(options.frames) + "-rotations" + std::to_string(options.rotations);
  const std::filesystem::path parts = options.out / "study" / key;
  make_folder(parts);

  std::string table = header();
  for (std::size_t k = 0; k < workloads.size(); ++k) {
    const std::filesystem::path part = parts / (workloads[k].name + ".csv");
    if (!std::filesystem::exists(part)) {
      const std::string title =
          "study " + std::to_string(k + 1) + "/" + std::to_string(workloads.size()) + " " + workloads[k].name;
      write_whole(part, study_workload(workloads[k].make(), options.seed, title));
    }
    table += covering::read_bytes(part);
  }
  write_whole(options.out / "study.csv", table);
}

}  // namespace tetracone::experiments
