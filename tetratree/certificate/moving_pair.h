#ifndef TETRACONE_TETRATREE_CERTIFICATE_MOVING_PAIR_H
#define TETRACONE_TETRATREE_CERTIFICATE_MOVING_PAIR_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/tetratree/certificate/placed_pair.h"

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace tetracone::tetratree {

/// Two bodies that move, placed as a proof over an interval of time asks for them.
///
/// A corner's place, times a divisor that both bodies share, is a form in the time of the interval. Its coefficients
/// are places, too: the first and the last are those at both ends. A direction that separates two groups at each
/// coefficient does so all the time. The form of the gap then has positive coefficients alone.
class Moving_pair {
 public:
  Moving_pair(const std::array<Group_tree*, 2>& groups, const std::array<kernel::Body_motion, 2>& motions)
      : groups_(groups), motions_(motions), forms_(motions[0], motions[1])
  {}

  const std::array<Group_tree*, 2>& groups() const { return groups_; }

  /// Returns the bodies at a time. The result is valid until the next call of `over`.
  Placed_pair& at(double time)
  {
    return kept({time, time, 0}, [&] { return poses_at(time); });
  }

  /// Returns both bodies at each coefficient of an interval; each coefficient has its own scale. The result is valid
  /// until the next call.
  std::vector<Placed_pair*> over(double from, double to)
  {
    if (placed_.size() * vertex_count() > most_points) placed_.clear();
    std::vector<Placed_pair*> pairs = {&at(from)};
    for (std::size_t k = 1; k + 1 < forms_.size(); ++k)
      pairs.push_back(&kept({from, to, k}, [&] { return poses_of(k, from, to); }));
    pairs.push_back(&at(to));
    return pairs;
  }

 private:
  using Poses = Placed_pair::Poses;

  template <class Make_poses>
  Placed_pair& kept(const std::tuple<double, double, std::size_t>& key, const Make_poses& poses)
  {
    const auto found = placed_.find(key);
    if (found != placed_.end()) return found->second;
    return placed_.try_emplace(key, groups_, poses()).first->second;
  }

  Poses poses_at(double time) const
  {
    return {motions_[0].at(kernel::Rational(time)), motions_[1].at(kernel::Rational(time))};
  }

  /// Returns coefficient k, divided by the largest coefficient of the divisor. Throws as `finite_pose`.
  Poses poses_of(std::size_t k, double from, double to) const
  {
    // Times are binary fractions.
    const kernel::Rational first(from), last(to);
    const kernel::Integer common = lcm(first.get_den(), last.get_den());
    const std::size_t bits = mpz_sizeinbase(common.get_mpz_t(), 2) - 1;
    const auto whole = [&](const kernel::Rational& time) {
      return kernel::Integer((time.get_num() << bits) / time.get_den());
    };
    const kernel::Pair_motion part = forms_.between(whole(first), whole(last), unsigned(bits));
    kernel::Integer scale = part.divisor()[0];
    for (std::size_t c = 1; c < part.divisor().size(); ++c) scale = kernel::maximum(scale, part.divisor()[c]);
    std::array<std::array<kernel::Rational, 12>, 2> entries;
    for (int body = 0; body < 2; ++body)
      for (int e = 0; e < 12; ++e) entries[body][e] = kernel::Rational(part.entry(body, e)[k]) / scale;
    return {finite_pose(entries[0]), finite_pose(entries[1])};
  }

  std::size_t vertex_count() const
  {
    return groups_[0]->tree().model().vertices().size() + groups_[1]->tree().model().vertices().size();
  }

  /// Placed points that are kept, of some 300 bytes each.
  static constexpr std::size_t most_points = 500'000;

  std::array<Group_tree*, 2> groups_;
  std::array<kernel::Body_motion, 2> motions_;
  kernel::Pair_motion forms_;
  std::map<std::tuple<double, double, std::size_t>, Placed_pair> placed_;
};

}  // namespace tetracone::tetratree

#endif
