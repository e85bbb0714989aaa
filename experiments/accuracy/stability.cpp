#include "experiments/accuracy/experiments.h"

#include "verify/cases/exact_motion.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"
#include "verify/subjects/subject.h"

#include <bit>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

using kernel::Pose;
using kernel::Question;
using verify::object_family::composed;
using verify::object_family::rational_rotation;

/// True when the bodies collide with the second at this position of its path.
using Collides_at = std::function<bool(double)>;

/// Positions on the path: collision at `in`, none at `out_of`; both positive, and neighbouring doubles once found.
struct Threshold {
  double in, out_of;
};

/// Returns the last position without contact before `bracket.in`, by bisection over doubles. If both ends have one
/// answer, it returns the nearer end.
Threshold bisected(Threshold bracket, const Collides_at& collides)
{
  auto in = std::bit_cast<std::int64_t>(bracket.in), out_of = std::bit_cast<std::int64_t>(bracket.out_of);
  while (out_of - in > 1) {
    const std::int64_t middle = in + (out_of - in) / 2;
    (collides(std::bit_cast<double>(middle)) ? in : out_of) = middle;
  }
  return {std::bit_cast<double>(in), std::bit_cast<double>(out_of)};
}

/// Returns the first contact of the path from `far` inwards, within a sixty-fourth of it.
std::optional<Threshold> first_contact(double far, const Collides_at& collides)
{
  for (int k = 64; k > 1; --k)
    if (collides(far * (k - 1) / 64)) return Threshold{far * (k - 1) / 64, far * k / 64};
  return std::nullopt;
}

struct Motion {
  std::string name;
  covering::Polyhedron a, b;
};

std::vector<Motion> motions(std::uint64_t seed)
{
  return {{"cube at a cube", verify::normalised(verify::unit_cube()), verify::normalised(verify::unit_cube())},
          {"faces with holes", verify::complex_one(), verify::complex_two()},
          {"mesh at a mesh", verify::blob(512, seed), verify::blob(512, seed + 1)}};
}

constexpr std::array kernels = {"float", "double", "double-eps=1e-12", "double-eps=rel:1e-12", "epick", "adaptive"};

}  // namespace

void run_stability(const Experiment_options& options)
{
  const int ways = options.full ? 400 : 20;
  const std::uint64_t seed = options.seed;
  const auto all = motions(seed);
  Csv_table table;
  Progress progress("thresholds", all.size() * std::size_t(ways));
  verify::Random random(seed);
  for (const Motion& motion : all) {
    std::vector<std::pair<verify::Subject, std::unique_ptr<verify::Prepared_pair>>> subjects;
    for (const char* kernel : kernels) {
      const auto subject = *verify::Subject::parse(kernel, verify::Method::tree);
      subjects.emplace_back(subject, verify::prepare(subject, motion.a, motion.b));
    }
    const auto truth = verify::prepare(*verify::Subject::parse("rational", verify::Method::brute), motion.a, motion.b);
    for (int way = 0; way < ways; ++way, progress.step()) {
      const Pose common = rational_rotation(random, 3), turned = rational_rotation(random, 3);
      const auto asked = [&](verify::Prepared_pair& pair) {
        return [&](double t) {
          return pair.collide(common, composed(common, composed(Pose::translation(t, 0, 0), turned)), Question::solid);
        };
      };
      const auto exact = asked(*subjects.back().second);
      const auto bracket = first_contact(4, exact);
      if (!bracket) continue;
      const Threshold right = bisected(*bracket, exact);
      if (!asked(*truth)(right.in) || asked(*truth)(right.out_of))
        throw std::logic_error("stability, " + motion.name + ", way " + std::to_string(way) +
                               ": the truth denies the exact threshold");
      for (const auto& [subject, pair] : subjects) {
        const double own = bisected(*bracket, asked(*pair)).out_of;
        const auto doubles = std::abs(std::bit_cast<std::int64_t>(own) - std::bit_cast<std::int64_t>(right.out_of));
        table.add(Csv_row()
                      .add("motion", motion.name)
                      .add("way", way)
                      .add("subject", subject.name())
                      .add_exact("threshold", right.out_of)
                      .add("error_doubles", doubles)
                      .add_exact("error_ulps", std::abs(own - right.out_of) / verify::ulp(right.out_of))
                      .add_origin(seed));
      }
    }
  }
  write_whole(options.out / "stability.csv", table.text());
}

}  // namespace tetracone::experiments
