#include "verify/subjects/moving_bodies_subject.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>

namespace tetracone::verify {
namespace {

std::unique_ptr<Query> query_of(const Moving_bodies& bodies, kernel::Question question)
{
  return std::make_unique<Query>(Body(bodies.a), Body(bodies.b), question);
}

std::optional<kernel::Time_bounds> found_by_query(Query& query, const Moving_bodies& bodies)
{
  const auto first = query.first_contact(Motion(motion_of(bodies.motion_a)), Motion(motion_of(bodies.motion_b)));
  if (!first) return std::nullopt;
  return kernel::Time_bounds{first->lo, first->hi};
}

/// Returns a body's pose at a time, in double.
kernel::Pose rounded_pose(const Motion_ends& ends, double time)
{
  const auto at = [&](std::size_t k) {
    return (1 - time) * kernel::nearest_double(ends[0][k]) + time * kernel::nearest_double(ends[1][k]);
  };
  std::array<double, 12> entries;
  if (ends[0].size() == entries.size()) {
    for (std::size_t k = 0; k < entries.size(); ++k) entries[k] = at(k);
    return kernel::Pose(entries);
  }
  const Eigen::Matrix3d turn = Eigen::Quaterniond(at(0), at(1), at(2), at(3)).normalized().toRotationMatrix();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) entries[std::size_t(4 * i + j)] = turn(i, j);
    entries[std::size_t(4 * i + 3)] = at(std::size_t(4 + i));
  }
  return kernel::Pose(entries);
}

/// Returns the first of so many evenly spaced times at which the bodies meet.
std::optional<kernel::Time_bounds> first_frame(int frames, Query& query, const Moving_bodies& bodies)
{
  for (int frame = 0; frame < frames; ++frame) {
    const double time = frame / (frames - 1.0);
    const kernel::Pose a = rounded_pose(bodies.motion_a, time), b = rounded_pose(bodies.motion_b, time);
    const bool is_flat = a.determinant_sign() == CGAL::ZERO || b.determinant_sign() == CGAL::ZERO;
    if (!is_flat && query.collide(a, b)) return kernel::Time_bounds{time, time};
  }
  return std::nullopt;
}

/// Finds the time by a query of the bodies.
class By_query : public Running_motion {
 public:
  using Find = std::function<std::optional<kernel::Time_bounds>(Query&, const Moving_bodies&)>;
  explicit By_query(Find find) : find_(std::move(find)) {}

  Told_contact operator()(const Moving_bodies& bodies, kernel::Question question) override
  {
    try {
      const auto [query, making] = timed([&] { return query_of(bodies, question); });
      const auto [first, asking] = timed([&] { return find_(*query, bodies); });
      return {first ? Outcome::yes : Outcome::no, first.value_or(kernel::Time_bounds{0, 0}), Spent{making, asking}};
    } catch (const std::exception&) {
      return {Outcome::failed};
    }
  }

 private:
  Find find_;
};

}  // namespace

kernel::Pose pose_of(const std::vector<kernel::Rational>& numbers)
{
  std::array<kernel::Rational, 12> entries;
  std::ranges::copy(numbers, entries.begin());
  return kernel::Pose(entries);
}

kernel::Body_motion motion_of(const Motion_ends& ends)
{
  const auto& [from, to] = ends;
  const auto rigid = [](const std::vector<kernel::Rational>& n) {
    return kernel::Rigid_pose{{n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6]}};
  };
  return from.size() == 12 ? kernel::Body_motion::linear(pose_of(from), pose_of(to))
                           : kernel::Body_motion::rigid(rigid(from), rigid(to)).value();
}

std::optional<kernel::Time_bounds> first_contact(const Moving_bodies& bodies, kernel::Question question)
{
  return found_by_query(*query_of(bodies, question), bodies);
}

std::vector<Moving_bodies_subject> moving_bodies_subjects()
{
  const auto subject = [](const std::string& name, bool is_exact, const std::string& note, const By_query::Find& find) {
    return Moving_bodies_subject{name, is_exact, note, [find] { return std::make_unique<By_query>(find); }};
  };
  std::vector<Moving_bodies_subject> subjects = {subject("adaptive tree", true, "", found_by_query)};
  for (const int frames : {10, 100, 1000})
    subjects.push_back(subject("static " + std::to_string(frames), false,
                               "exact static questions at " + std::to_string(frames) + " times, in poses of doubles",
                               std::bind_front(first_frame, frames)));
  return subjects;
}

}  // namespace tetracone::verify
