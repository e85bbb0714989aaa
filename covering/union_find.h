#ifndef TETRACONE_COVERING_UNION_FIND_H
#define TETRACONE_COVERING_UNION_FIND_H

#include "tetracone/covering/polyhedron.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace tetracone::covering {

/// Disjoint sets of the numbers from 0, each alone at first (Galler and Fischer; paths are halved, Tarjan and van
/// Leeuwen).
class Union_find {
 public:
  explicit Union_find(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  std::size_t size() const { return parent_.size(); }

  /// Returns the member that represents the set of `v`.
  Index root(Index v)
  {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  /// Joins the sets of `a` and `b`; the root of `b` represents both.
  void join(Index a, Index b) { parent_[root(a)] = root(b); }

 private:
  std::vector<Index> parent_;
};

/// Returns the faces 0 .. `face_count` - 1 in groups, by the set of member(face). The faces of each group ascend. The
/// groups are in the order of their first faces.
template <class Member>
std::vector<std::vector<Index>> grouped_faces(std::size_t face_count, Union_find& sets, const Member& member)
{
  std::vector<std::vector<Index>> groups;
  const std::size_t ungrouped = sets.size();
  std::vector<std::size_t> group_of(sets.size(), ungrouped);  // by the set's root
  for (Index f = 0; f < face_count; ++f) {
    std::size_t& group = group_of[sets.root(member(f))];
    if (group == ungrouped) {
      group = groups.size();
      groups.emplace_back();
    }
    groups[group].push_back(f);
  }
  return groups;
}

}  // namespace tetracone::covering

#endif
