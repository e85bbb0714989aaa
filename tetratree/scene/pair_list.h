#ifndef TETRACONE_TETRATREE_SCENE_PAIR_LIST_H
#define TETRACONE_TETRATREE_SCENE_PAIR_LIST_H

#include "tetracone/tetratree/fast/pair_memory.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Two bodies that are near one another, and what is known of them.
struct Near_pair {
  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

  std::uint32_t body[2];         ///< the lesser number first
  std::uint32_t place[2] = {};   ///< in the lists of either
  std::uint64_t asked = never;   ///< the frame in which they were asked last
  double way = 0;                ///< both bodies' ways then, summed
  double limit = -1;             ///< they are apart until these reach this
  Pair_memory memory = {};       ///< of their trees
  std::size_t memory_bytes = 0;  ///< that are counted
  bool collide = false;          ///< what they did when they were asked
  bool is_open = false;          ///< to be asked
  bool by_brute_force = false;   ///< how they are to be asked
  bool is_listed = false;        ///< among the colliding pairs of the last answer
};

/// The pairs of bodies that are near one another, each in the lists of both of its bodies. A pair keeps its number while
/// it is there.
class Pair_list {
 public:
  using Number = std::uint32_t;

  /// A pair of a body, and its other body.
  struct Of_body {
    Number pair;
    std::uint32_t other;
  };

  std::size_t count() const { return pairs_.size() - free_.size(); }
  Near_pair& operator[](Number pair) { return pairs_[pair]; }
  const Near_pair& operator[](Number pair) const { return pairs_[pair]; }

  /// The pairs of a body.
  std::span<const Of_body> of(std::uint32_t body) const { return of_[body]; }
  std::uint32_t other(Number pair, std::uint32_t body) const
  {
    return pairs_[pair].body[pairs_[pair].body[0] == body ? 1 : 0];
  }

  void set_body_count(std::size_t bodies) { of_.resize(bodies); }

  /// Requires two bodies that are no pair yet.
  Number add(std::uint32_t a, std::uint32_t b)
  {
    if (free_.empty()) {
      free_.push_back(Number(pairs_.size()));
      pairs_.emplace_back();
    }
    const Number number = free_.back();
    free_.pop_back();
    Near_pair& pair = pairs_[number];
    pair.body[0] = a < b ? a : b;
    pair.body[1] = a < b ? b : a;
    for (int k = 0; k < 2; ++k) {
      std::vector<Of_body>& list = of_[pair.body[k]];
      pair.place[k] = std::uint32_t(list.size());
      in_lists_ -= list.capacity();
      list.push_back({number, pair.body[1 - k]});
      in_lists_ += list.capacity();
    }
    return number;
  }

  void remove(Number number)
  {
    Near_pair& pair = pairs_[number];
    memory_bytes_ -= pair.memory_bytes;
    for (int k = 0; k < 2; ++k) {
      std::vector<Of_body>& list = of_[pair.body[k]];
      const Of_body last = list.back();
      list[pair.place[k]] = last;
      pairs_[last.pair].place[pair.body[k] < last.other ? 0 : 1] = pair.place[k];
      list.pop_back();
    }
    pair = Near_pair();
    free_.push_back(number);
  }

  /// Drops what is kept of a pair's trees.
  void forget(Number number)
  {
    pairs_[number].memory = {};
    count_memory(number);
  }

  /// Counts what is kept of a pair's trees, after it has changed.
  void count_memory(Number number)
  {
    Near_pair& pair = pairs_[number];
    memory_bytes_ -= pair.memory_bytes;
    memory_bytes_ += pair.memory_bytes = pair.memory.bytes();
  }

  /// Of all that is kept of trees, as it is counted.
  std::size_t memory_bytes() const { return memory_bytes_; }

  std::size_t bytes() const
  {
    return pairs_.capacity() * sizeof(Near_pair) + free_.capacity() * sizeof(Number) + in_lists_ * sizeof(Of_body) +
           of_.capacity() * sizeof(std::vector<Of_body>) + memory_bytes_;
  }

 private:
  std::vector<Near_pair> pairs_;
  std::vector<Number> free_;
  std::vector<std::vector<Of_body>> of_;
  std::size_t in_lists_ = 0;  // room in them
  std::size_t memory_bytes_ = 0;
};

}  // namespace tetracone::tetratree

#endif
