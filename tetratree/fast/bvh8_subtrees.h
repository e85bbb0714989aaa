#ifndef TETRACONE_TETRATREE_FAST_BVH8_SUBTREES_H
#define TETRACONE_TETRATREE_FAST_BVH8_SUBTREES_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/fast/bvh8_builder.h"
#include "tetracone/tetratree/fast/bvh8_node.h"
#include "tetracone/tetratree/fast/reserved_array.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Makes all nodes that a tree lacks, by any number of threads. The tree and the numbers of its nodes do not depend on
/// how many.
///
/// `run(work)` calls work() from one thread or more at once, and returns when all calls have returned.
class Bvh8_subtrees {
 public:
  /// The caller is the thread that may change the tree; other threads may read it.
  Bvh8_subtrees(Bvh8_builder& builder, Reserved_array<Bvh8_node>& nodes) : builder_(builder), nodes_(nodes) {}

  /// Makes the nodes of large parts level by level, then everything below. The nodes of a level are made at the same
  /// time. If one part has most of the elements, they are made one after the other by `both`.
  template <class Run>
  void make(const Run& run, const covering::Both& both)
  {
    Index from = 0;
    while (true) {
      const Index to = nodes_.size();
      for (Index n = from; n < to; ++n) list_lanes(n);
      from = to;
      if (large_.empty()) break;
      const std::vector<Lane> lanes = std::exchange(large_, {});
      if (are_one_mostly(lanes))
        make_nodes(lanes, both);
      else
        make_subtrees(run, lanes, true);
    }
    make_subtrees(run, std::exchange(small_, {}), false);
  }

 private:
  /// A lane whose node does not exist yet.
  struct Lane {
    Index node;
    int lane;
  };

  /// The nodes of a subtree, by their numbers in it.
  class Nodes {
   public:
    Index push_back(const Bvh8_node& node)
    {
      all_.push_back(node);
      return Index(all_.size() - 1);
    }
    Bvh8_node* data() { return all_.data(); }
    Index size() const { return Index(all_.size()); }

   private:
    std::vector<Bvh8_node> all_;
  };

  Index begin_of(const Lane& lane) const { return nodes_.data()[lane.node].first[std::size_t(lane.lane)]; }
  Index end_of(const Lane& lane) const
  {
    return Bvh8_node::last_of(nodes_.data()[lane.node].child[std::size_t(lane.lane)]);
  }

  void list_lanes(Index n)
  {
    const Bvh8_node& node = nodes_.data()[n];
    for (int k = 0; k < node.boxes.lane_count; ++k) {
      if (node.is_made(k)) continue;
      const Lane lane{n, k};
      (end_of(lane) - begin_of(lane) > most_together ? large_ : small_).push_back(lane);
    }
  }

  /// The shared state of threads that make what is below some lanes.
  struct Round {
    std::vector<Lane> lanes;
    std::atomic<std::size_t> next = 0;
    std::mutex lock;          // guards what follows
    std::vector<Nodes> made;  // subtrees of lanes that have no numbers yet
    std::size_t placed = 0;   // number of lanes whose subtrees have numbers
  };

  /// True when one thread would have most of the work.
  bool are_one_mostly(const std::vector<Lane>& lanes) const
  {
    Index largest = 0, all = 0;
    for (const Lane& lane : lanes) {
      const Index count = end_of(lane) - begin_of(lane);
      largest = kernel::maximum(largest, count);
      all += count;
    }
    return largest > covering::most_in_part && largest > all / 2;
  }

  void make_nodes(const std::vector<Lane>& lanes, const covering::Both& both)
  {
    for (const Lane& lane : lanes) {
      const Index made = builder_.make(begin_of(lane), end_of(lane), nodes_, both);
      nodes_.data()[lane.node].publish(lane.lane, made);
    }
  }

  /// Makes for each lane its node alone, or all nodes below it.
  template <class Run>
  void make_subtrees(const Run& run, std::vector<Lane> lanes, bool alone)
  {
    Round round;
    round.lanes = std::move(lanes);
    round.made.resize(round.lanes.size());
    run([&] {
      kernel::require_sound_floating_point();
      Bvh8_builder worker = builder_.worker();
      for (std::size_t k; (k = round.next++) < round.lanes.size();) {
        Nodes made;
        const Lane& lane = round.lanes[k];
        if (alone)
          worker.make(begin_of(lane), end_of(lane), made);
        else
          worker.make_all(begin_of(lane), end_of(lane), made);
        place(round, k, std::move(made));
      }
      const std::lock_guard lock(round.lock);
      builder_.add_cuts(worker.cuts());
    });
  }

  /// Keeps a subtree. Numbers the nodes of each subtree that lacks numbers, up to the first lane without a subtree.
  void place(Round& round, std::size_t k, Nodes made)
  {
    struct Placed {
      Lane lane;
      Nodes nodes;
      Index first;
    };
    std::vector<Placed> ready;
    {
      const std::lock_guard lock(round.lock);
      round.made[k] = std::move(made);
      for (; round.placed < round.lanes.size() && round.made[round.placed].size() > 0; ++round.placed) {
        Nodes& nodes = round.made[round.placed];
        const Index first = nodes_.append(nodes.size());
        ready.push_back({round.lanes[round.placed], std::exchange(nodes, {}), first});
      }
    }
    for (Placed& placed : ready) {
      Bvh8_node* const at = nodes_.data() + placed.first;
      for (Index n = 0; n < placed.nodes.size(); ++n) {
        at[n] = placed.nodes.data()[n];
        for (std::size_t lane = 0; lane < std::size_t(at[n].boxes.lane_count); ++lane)
          if (at[n].child[lane] >= 0) at[n].child[lane] += std::int32_t(placed.first);
      }
      nodes_.data()[placed.lane.node].publish(placed.lane.lane, placed.first);
    }
  }

  /// Up to this many elements, one thread makes all nodes.
  static constexpr Index most_together = 512;

  Bvh8_builder& builder_;
  Reserved_array<Bvh8_node>& nodes_;
  std::vector<Lane> large_, small_;
};

}  // namespace tetracone::tetratree

#endif
