#ifndef TETRACONE_TETRATREE_SCENE_PAIR_LIST_H
#define TETRACONE_TETRATREE_SCENE_PAIR_LIST_H

#include "tetracone/tetratree/fast/pair_memory.h"
#include "tetracone/tetratree/scene/large_pages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Two bodies that are near one another, the lesser number first, and until when they are apart: what frames read of
/// all of them. Of a pair that is gone both numbers are 0.
struct alignas(32) Near_bodies {
  std::uint32_t body[2] = {};
  std::array<float, 3> between = {};  ///< from the second's place to the first's, about, when they were asked
  bool collide = false;               ///< what they did then
  bool is_open = false;               ///< to be asked
  bool by_brute_force = false;        ///< how they are to be asked
  bool is_listed = false;             ///< among the colliding pairs of the last answer
  double limit =
      -1;  ///< they are apart while what they have turned, and what is between them has changed, sum up to less
};

/// Where a pair is in other lists.
struct Near_pair {
  std::uint32_t place[2] = {};  ///< in the lists of either body
  std::uint32_t asked = 0;      ///< where what is kept of its trees stands; 0: nothing is
};

/// What is kept of a pair whose trees have been asked: few of those that are near are.
struct Asked_pair {
  double turned = -std::numeric_limits<double>::infinity();  ///< by both bodies when they were asked last
  std::array<float, 3> between = {};                         ///< them then
  Pair_memory memory = {};
  std::size_t memory_bytes = 0;  ///< that are counted
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
  Near_bodies& bodies(Number pair) { return bodies_[pair]; }
  const Near_bodies& bodies(Number pair) const { return bodies_[pair]; }

  /// What is kept of a pair's trees; made if there is nothing.
  Asked_pair& asked(Number number)
  {
    std::uint32_t& place = pairs_[number].asked;
    if (place == 0) {
      if (free_asked_.empty()) {
        free_asked_.push_back(std::uint32_t(asked_.size()));
        asked_.emplace_back();
      }
      place = free_asked_.back();
      free_asked_.pop_back();
    }
    return asked_[place];
  }
  /// The same; null if there is nothing.
  Asked_pair* known_asked(Number number)
  {
    const std::uint32_t place = pairs_[number].asked;
    return place == 0 ? nullptr : &asked_[place];
  }

  /// By number, also those that are gone.
  std::span<const Near_bodies> all_bodies() const { return bodies_; }

  /// The pairs of a body.
  std::span<const Of_body> of(std::uint32_t body) const { return of_[body]; }

  /// Tells the memory to bring the list of a body; or, where that has come, what changes when its pairs part.
  void fetch_list(std::uint32_t body) const { __builtin_prefetch(of_[body].data()); }
  void fetch_pairs(std::uint32_t body) const
  {
    for (const Of_body& near : of_[body]) {
      __builtin_prefetch(&pairs_[near.pair]);
      __builtin_prefetch(&bodies_[near.pair]);
      __builtin_prefetch(&of_[near.other]);
    }
  }

  void set_body_count(std::size_t bodies) { of_.resize(bodies); }

  /// Takes memory for so many pairs at once, and for some more, as boxes with room for steps will find; or for those of
  /// a body.
  void make_room(std::size_t pairs)
  {
    make_room(pairs_, pairs);
    make_room(bodies_, pairs);
  }
  void make_room(std::uint32_t body, std::size_t pairs)
  {
    in_lists_ -= of_[body].capacity();
    make_room(of_[body], pairs);
    in_lists_ += of_[body].capacity();
  }

  /// Requires two bodies that are no pair yet.
  Number add(std::uint32_t a, std::uint32_t b)
  {
    if (free_.empty()) {
      free_.push_back(Number(pairs_.size()));
      pairs_.emplace_back();
      bodies_.emplace_back();
    }
    const Number number = free_.back();
    free_.pop_back();
    Near_bodies& bodies = bodies_[number];
    bodies = {};
    bodies.body[0] = a < b ? a : b;
    bodies.body[1] = a < b ? b : a;
    for (int k = 0; k < 2; ++k) {
      std::vector<Of_body>& list = of_[bodies.body[k]];
      pairs_[number].place[k] = std::uint32_t(list.size());
      in_lists_ -= list.capacity();
      list.push_back({number, bodies.body[1 - k]});
      in_lists_ += list.capacity();
    }
    return number;
  }

  void remove(Number number)
  {
    forget(number);
    Near_pair& pair = pairs_[number];
    Near_bodies& bodies = bodies_[number];
    for (int k = 0; k < 2; ++k) {
      std::vector<Of_body>& list = of_[bodies.body[k]];
      const Of_body last = list.back();
      list[pair.place[k]] = last;
      pairs_[last.pair].place[bodies.body[k] < last.other ? 0 : 1] = pair.place[k];
      list.pop_back();
    }
    pair = Near_pair();
    bodies = Near_bodies();
    free_.push_back(number);
  }

  /// Drops what is kept of a pair's trees.
  void forget(Number number)
  {
    std::uint32_t& place = pairs_[number].asked;
    if (place == 0) return;
    memory_bytes_ -= asked_[place].memory_bytes;
    asked_[place] = Asked_pair();
    free_asked_.push_back(place);
    place = 0;
  }

  /// Counts what is kept of a pair's trees, after it has changed.
  void count_memory(Number number)
  {
    Asked_pair& asked = this->asked(number);
    memory_bytes_ -= asked.memory_bytes;
    memory_bytes_ += asked.memory_bytes = asked.memory.bytes();
  }

  /// Of all that is kept of trees, as it is counted.
  std::size_t memory_bytes() const { return memory_bytes_; }

  std::size_t bytes() const
  {
    return pairs_.capacity() * sizeof(Near_pair) + bodies_.capacity() * sizeof(Near_bodies) +
           asked_.capacity() * sizeof(Asked_pair) + (free_.capacity() + free_asked_.capacity()) * sizeof(Number) +
           in_lists_ * sizeof(Of_body) + of_.capacity() * sizeof(std::vector<Of_body>) + memory_bytes_;
  }

 private:
  template <class Vector>
  static void make_room(Vector& of, std::size_t count)
  {
    if (of.capacity() < count) of.reserve(count + count / 2);
  }

  Large_vector<Near_pair> pairs_;
  Large_vector<Near_bodies> bodies_;                              // of each; apart, since frames read them all
  Large_vector<Asked_pair> asked_ = Large_vector<Asked_pair>(1);  // the first stands for nothing
  std::vector<Number> free_;
  std::vector<std::uint32_t> free_asked_;
  std::vector<std::vector<Of_body>> of_;
  std::size_t in_lists_ = 0;  // room in them
  std::size_t memory_bytes_ = 0;
};

}  // namespace tetracone::tetratree

#endif
