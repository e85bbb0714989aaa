#ifndef TETRACONE_TETRATREE_SCENE_NUMBER_GROUPS_H
#define TETRACONE_TETRATREE_SCENE_NUMBER_GROUPS_H

#include "tetracone/tetratree/scene/large_pages.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// Numbers in groups, stored one group after the other (a counting sort).
class Number_groups {
 public:
  /// Sorts numbers into groups. Requires that for_all(put) calls put(group, number) for each number, in the same order
  /// at each call.
  template <class For_all>
  Number_groups(std::size_t groups, const For_all& for_all) : first_(groups + 1)
  {
    for_all([this](std::size_t group, std::uint32_t) { ++first_[group + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    numbers_.resize(first_.back());
    std::vector<std::uint32_t> next = first_;
    for_all([&](std::size_t group, std::uint32_t number) { numbers_[next[group]++] = number; });
  }

  std::size_t count() const { return first_.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t group) const
  {
    return std::span(numbers_).subspan(first_[group], first_[group + 1] - first_[group]);
  }

 private:
  std::vector<std::uint32_t> first_;  // where each group begins, and where the last one ends
  Large_vector<std::uint32_t> numbers_;
};

}  // namespace tetracone::tetratree

#endif
