#ifndef TETRACONE_TETRATREE_SCENE_PAIR_LIST_H
#define TETRACONE_TETRATREE_SCENE_PAIR_LIST_H

#include "tetracone/tetratree/memory/pair_certificate.h"
#include "tetracone/tetratree/memory/pair_memory.h"
#include "tetracone/tetratree/scene/large_pages.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// Whether a near pair is to be asked in this frame, and by which method its query is.
enum class Pair_stage : std::uint8_t { answered, open, open_for_brute_force };

/// Two bodies that are near one another, the lesser number first, with the certificate of the pair. Frames read all of
/// these. Both numbers are 0 in a pair that was removed.
struct alignas(32) Near_bodies {
  std::uint32_t body[2] = {};
  /// The vector from the second's centre to the first's when they were asked, rounded to float.
  Between between = {};
  Pair_stage stage = Pair_stage::answered;
  bool collide = false;    ///< whether they collided then
  bool is_listed = false;  ///< among the colliding pairs of the last answer
  /// The pair stays apart while (rotation of both bodies) + (change of the vector between them) < limit.
  double limit = -1;

  bool is_open() const { return stage != Pair_stage::answered; }
};

/// The positions of a pair in other lists.
struct Near_pair {
  std::uint32_t place[2] = {};  ///< in the lists of the first and of the second body
  std::uint32_t asked = 0;      ///< index of its `Asked_pair`; 0: it has none
};

/// The memory of a pair whose trees have been asked. Few of the near pairs have one.
struct Asked_pair {
  double turned = -std::numeric_limits<double>::infinity();  ///< the rotation of both bodies when they were asked last
  Between between = {};                                      ///< the vector between their centres then
  Pair_memory memory = {};
  std::size_t memory_bytes = 0;  ///< as last counted
};

/// The pairs of bodies that are near one another. Each is in the lists of both of its bodies, and keeps its number
/// while it exists.
class Pair_list {
 public:
  using Number = std::uint32_t;

  /// A pair of a body, and its other body.
  struct Of_body {
    Number pair;
    std::uint32_t other;
  };

  Near_bodies& bodies(Number pair) { return bodies_[pair]; }
  const Near_bodies& bodies(Number pair) const { return bodies_[pair]; }

  /// Returns the memory of a pair; makes it if there is none. The reference is valid until the next call.
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
  /// Returns the memory of a pair; null if there is none.
  Asked_pair* known_asked(Number number)
  {
    const std::uint32_t place = pairs_[number].asked;
    return place == 0 ? nullptr : &asked_[place];
  }

  /// Returns all pairs by number, including those that were removed.
  std::span<const Near_bodies> all_bodies() const { return bodies_; }

  /// Returns the pairs of a body.
  std::span<const Of_body> of(std::uint32_t body) const { return of_[body]; }

  /// Prefetches the list of a body.
  void fetch_list(std::uint32_t body) const { __builtin_prefetch(of_[body].data()); }
  /// Prefetches what changes when the pairs of a body are removed. Requires that its list is in the cache.
  void fetch_pairs(std::uint32_t body) const
  {
    for (const Of_body& near : of_[body]) {
      __builtin_prefetch(&pairs_[near.pair]);
      __builtin_prefetch(&bodies_[near.pair]);
      __builtin_prefetch(&of_[near.other]);
    }
  }

  /// Sets the number of bodies. Requires that bodies left out have no pair.
  void set_body_count(std::size_t bodies) { of_.resize(bodies); }

  /// Reserves memory for `pairs` pairs and half as many more, since wide boxes will find some.
  void make_room(std::size_t pairs)
  {
    make_room(pairs_, pairs);
    make_room(bodies_, pairs);
  }
  /// Same, for the pairs of one body.
  void make_room(std::uint32_t body, std::size_t pairs)
  {
    in_lists_ -= of_[body].capacity();
    make_room(of_[body], pairs);
    in_lists_ += of_[body].capacity();
  }

  /// Adds a pair; returns its number. Requires two bodies that are no pair yet.
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

  /// Removes a pair, and drops its memory. Its number may be given to a new pair.
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

  /// Drops the memory of a pair.
  void forget(Number number)
  {
    std::uint32_t& place = pairs_[number].asked;
    if (place == 0) return;
    memory_bytes_ -= asked_[place].memory_bytes;
    asked_[place] = Asked_pair();
    free_asked_.push_back(place);
    place = 0;
  }

  /// Counts the bytes of a pair's memory anew, after it has changed.
  void count_memory(Number number)
  {
    Asked_pair& asked = this->asked(number);
    memory_bytes_ -= asked.memory_bytes;
    memory_bytes_ += asked.memory_bytes = asked.memory.bytes();
  }

  /// Returns the bytes of all memories, as last counted.
  std::size_t memory_bytes() const { return memory_bytes_; }

  /// Returns the bytes of all lists, and of all memories as last counted.
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
  Large_vector<Near_bodies> bodies_;  // of each pair; a list of its own, since frames read all of it
  Large_vector<Asked_pair> asked_ = Large_vector<Asked_pair>(1);  // the first stands for nothing
  std::vector<Number> free_;
  std::vector<std::uint32_t> free_asked_;
  std::vector<std::vector<Of_body>> of_;
  std::size_t in_lists_ = 0;  // the sum of the capacities of `of_`
  std::size_t memory_bytes_ = 0;
};

}  // namespace tetracone::tetratree

#endif
