#include "experiments/speed/trajectory.h"

#include "experiments/support/extent.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

namespace tetracone::experiments {

using namespace verify;
namespace {

using kernel::Pose;

Vector sum(const Vector& a, double s, const Vector& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }

/// B in a random rotation. If it turns, it starts there and turns about a random axis, twice round in the whole
/// trajectory.
class Turning_body {
 public:
  Turning_body(const covering::Polyhedron& b, double ratio, Random& random, Turning turning)
      : centre_(centroid(b)),
        scale_(1 / ratio),
        start_(random.quaternion()),
        axis_(random.direction()),
        turns_(turning == Turning::yes)
  {}

  /// Returns B's pose with its centroid at `position`, at `time` from 0 to 1.
  Pose pose(const Vector& position, double time) const
  {
    const auto [c, s] = turn(turns_ ? time : 0);  // cosine and sine of half the angle
    const auto [x, y, z] = axis_;
    const auto [p, q, r, t] = start_;
    // The product of the quaternions (c, s axis) and start.
    const Rotation m = rotation(c * p - s * (x * q + y * r + z * t), c * q + s * (x * p + y * t - z * r),
                                c * r + s * (y * p + z * q - x * t), c * t + s * (z * p + x * r - y * q));
    std::array<double, 12> entries;
    for (int row = 0; row < 3; ++row) {
      double image = 0;
      for (int column = 0; column < 3; ++column) {
        entries[4 * row + column] = scale_ * m[row][column];
        image += entries[4 * row + column] * centre_[column];
      }
      entries[4 * row + 3] = position[row] - image;
    }
    return Pose(entries);
  }

 private:
  Vector centre_;
  double scale_;
  std::array<double, 4> start_;
  Vector axis_;
  bool turns_;
};

/// The smallest and the largest wanted number of colliding frames.
struct Range {
  int low, high;

  /// Returns the range from `least` to `most` of the frames; `otherwise` if no whole number is in it.
  static Range of(int frames, double least, double most, int otherwise)
  {
    const Range range = {static_cast<int>(std::ceil(least * frames)), static_cast<int>(std::floor(most * frames))};
    return range.low <= range.high ? range : Range{otherwise, otherwise};
  }
};

/// All frames at one distance: a near frame collides, a far one does not.
template <class At>
class Frames {
 public:
  /// Requires a function `at(frame, distance)` that returns a pose.
  Frames(int count, const At& at, const Collides& collides, Range range)
      : count_(count), at_(at), collides_(collides), range_(range)
  {}

  /// Returns the number of frames that collide at this distance; counting stops above the range.
  int colliding(double distance) const
  {
    int found = 0;
    for (int k = 0; k < count_ && found <= range_.high; ++k) found += collides_(at_(k, distance));
    return found;
  }

  /// Returns a distance between the two at which a number in the range collides. Requires more collisions at `near` and
  /// fewer at `far`. It fails only where several frames begin to collide at one double; then it returns the far side,
  /// with fewer collisions.
  double between(double near, double far) const
  {
    for (;;) {
      const double middle = near / 2 + far / 2;
      if (middle <= near || middle >= far) return far;
      const int found = colliding(middle);
      if (found >= range_.low && found <= range_.high) return middle;
      (found > range_.high ? near : far) = middle;
    }
  }

  std::vector<Pose> poses(double distance) const
  {
    std::vector<Pose> result;
    for (int k = 0; k < count_; ++k) result.push_back(at_(k, distance));
    return result;
  }

 private:
  int count_;
  const At& at_;
  const Collides& collides_;
  Range range_;
};

}  // namespace

std::vector<Pose> circular_trajectory(const covering::Polyhedron& a, const covering::Polyhedron& b, double ratio,
                                      int frames, std::uint64_t seed, const Collides& collides, Turning turning)
{
  assert(ratio > 0 && frames >= 1);
  Random random(seed);
  const Turning_body body(b, ratio, random, turning);
  const Vector centre = centroid(a);
  const double size = radius(a), jitter = 0.02 * size;
  const auto [w, x, y, z] = random.quaternion();
  const Rotation plane = rotation(w, x, y, z);
  std::vector<Vector> jitters;
  for (int k = 0; k < frames; ++k) jitters.push_back(random.in_ball());

  const auto at = [&](int k, double distance) {
    const double time = double(k) / frames;
    const auto [c, s] = turn(time);
    const Vector on_circle = sum(sum(centre, distance * c, plane[0]), distance * s, plane[1]);
    return body.pose(sum(on_circle, jitter, jitters[k]), time);
  };
  const Range range = Range::of(frames, 0.03, 0.045, (frames - 1) / 20);
  const Frames all(frames, at, collides, range);

  const double outside = 1.01 * (size + radius(b) / ratio + jitter);  // nothing collides
  if (range.high == 0) return all.poses(outside);
  constexpr int steps = 64;
  for (int step = 1; step <= steps; ++step) {
    const double distance = outside * (steps - step) / steps;
    const int found = all.colliding(distance);
    if (found < range.low) continue;
    return all.poses(found <= range.high ? distance : all.between(distance, outside * (steps - step + 1) / steps));
  }
  return all.poses(outside);
}

namespace {

/// Returns an upper bound of the distance of the first collision on the path from `outside` to 0 in steps. It is too
/// large by at most `error`. Returns nothing if no step collides.
template <class Collides_at>
std::optional<double> first_contact(double outside, double step, double error, const Collides_at& collides_at)
{
  double far = outside, near = outside - step;
  while (near > 0 && !collides_at(near)) {
    far = near;
    near -= step;
  }
  if (near <= 0) return std::nullopt;
  while (far - near > error) {
    const double middle = near / 2 + far / 2;
    (collides_at(middle) ? near : far) = middle;
  }
  return far;
}

}  // namespace

std::vector<Pose> contour_trajectory(const covering::Polyhedron& a, const covering::Polyhedron& b, double ratio,
                                     int frames, std::uint64_t seed, const Collides& collides, Turning turning)
{
  assert(ratio > 0 && frames >= 1);
  Random random(seed);
  const Turning_body body(b, ratio, random, turning);
  const Vector centre = centroid(a);
  const double size = radius(a), size_b = radius(b) / ratio;
  const auto [w, x, y, z] = random.quaternion();
  const Rotation pole = rotation(w, x, y, z);

  // The spiral's windings are as far apart as its consecutive frames.
  const double windings = std::sqrt(frames * std::numbers::pi) / 2;
  const auto time = [frames](int k) { return (k + 0.5) / frames; };
  const auto direction = [&](int k) {
    const double height = 1 - 2 * time(k), across = std::sqrt(1 - height * height);
    const auto [c, s] = turn(windings * time(k));
    return sum(sum(sum({0, 0, 0}, across * c, pole[0]), across * s, pole[1]), height, pole[2]);
  };
  const auto on_ray = [&](int k, double distance) { return body.pose(sum(centre, distance, direction(k)), time(k)); };

  std::vector<double> touching;
  const double outside = 1.01 * (size + size_b);
  for (int k = 0; k < frames; ++k) {
    const auto collides_at = [&](double distance) { return collides(on_ray(k, distance)); };
    const auto found = first_contact(outside, size_b / 2, size / 2048, collides_at);
    touching.push_back(found ? *found : touching.empty() ? outside : touching.back());
  }

  const double jitter = 1.6 * size * (0.005 + 0.005 / ratio);
  std::vector<Vector> jitters;
  for (int k = 0; k < frames; ++k) jitters.push_back(random.in_ball());
  const auto at = [&](int k, double gap) {
    return body.pose(sum(sum(centre, touching[k] + gap, direction(k)), jitter, jitters[k]), time(k));
  };
  const int nearest = static_cast<int>(std::lround(0.075 * frames));
  const Range range = Range::of(frames, 0.055, 0.095, nearest);
  const Frames all(frames, at, collides, range);

  // For a plane border the distance is about two thirds of the jitter; otherwise it is moved out or in until the number
  // is passed.
  double near = 0.625 * jitter, far = near;
  for (double stride = jitter / 4; all.colliding(near) < range.low && near > -size; stride *= 2) {
    far = near;
    near -= stride;
  }
  for (double stride = jitter / 4; all.colliding(far) > range.high && far < outside; stride *= 2) {
    near = far;
    far += stride;
  }
  const int found_near = all.colliding(near), found_far = all.colliding(far);
  if (found_far >= range.low && found_far <= range.high) return all.poses(far);
  if (found_near >= range.low && found_near <= range.high) return all.poses(near);
  return all.poses(all.between(near, far));
}

std::vector<Pose> smooth_walk(const covering::Polyhedron& a, const covering::Polyhedron& b, double ratio, int frames,
                              double clearance, std::uint64_t seed, const Collides& collides)
{
  assert(ratio > 0 && frames >= 1);
  constexpr int directions = 512;
  Random random(seed);
  const Turning_body body(b, ratio, random, Turning::yes);
  const Vector centre = centroid(a);
  const double size = radius(a), size_b = radius(b) / ratio;
  const auto [w, x, y, z] = random.quaternion();
  const Rotation pole = rotation(w, x, y, z);
  const auto at = [&](double time, double distance) {
    const auto [c, s] = turn(time);
    const double height = 0.7 * (2 * s * c), across = std::sqrt(1 - height * height);
    const Vector direction = sum(sum(sum({0, 0, 0}, across * c, pole[0]), across * s, pole[1]), height, pole[2]);
    return body.pose(sum(centre, distance, direction), time);
  };

  std::vector<double> touching;
  const double outside = 1.01 * (size + size_b);
  for (int k = 0; k < directions; ++k) {
    const auto collides_at = [&](double distance) { return collides(at(double(k) / directions, distance)); };
    const auto found = first_contact(outside, size_b / 16, size / 2048, collides_at);
    touching.push_back(found ? *found : 0);
  }
  const double step = 2 * std::numbers::pi / directions * size;
  std::vector<double> distance = touching;
  for (int k = 0; k < directions; ++k)
    for (int other = 0; other < directions; ++other) {
      const int between = std::abs(k - other);
      distance[k] = std::max(distance[k], touching[other] - step * std::min(between, directions - between));
    }

  std::vector<Pose> poses;
  for (int k = 0; k < frames; ++k) {
    const double time = double(k) / frames, place = time * directions;
    const int first = static_cast<int>(place);
    const double share = place - first;
    poses.push_back(
        at(time, (1 - share) * distance[first] + share * distance[(first + 1) % directions] + clearance * size));
  }
  return poses;
}

double mean_motion(const covering::Polyhedron& a, const covering::Polyhedron& b, const std::vector<Pose>& poses)
{
  assert(poses.size() > 1);
  const auto [low, high] = extent_of(b);
  double total = 0;
  for (std::size_t k = 1; k < poses.size(); ++k) {
    double farthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector at = {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]};
      double square = 0;
      for (int row = 0; row < 3; ++row) {
        const auto image = [&](const Pose& m) {
          return m[4 * row] * at[0] + m[4 * row + 1] * at[1] + m[4 * row + 2] * at[2] + m[4 * row + 3];
        };
        const double moved = image(poses[k]) - image(poses[k - 1]);
        square += moved * moved;
      }
      farthest = std::max(farthest, std::sqrt(square));
    }
    total += farthest;
  }
  return total / double(poses.size() - 1) / extent_of(a).longest_side();
}

}  // namespace tetracone::experiments
