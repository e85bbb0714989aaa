#ifndef TETRACONE_TETRATREE_CERTIFICATE_GROUP_TREE_H
#define TETRACONE_TETRATREE_CERTIFICATE_GROUP_TREE_H

#include "tetracone/tetratree/fast/bvh8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The pieces of a body and their groups, as certificates name them: the elements and the boxes of its fast tree. It
/// also keeps which groups the proofs about the body have opened.
class Group_tree {
 public:
  /// Numbers the pieces by faces. `source_face` has for each face of the tree the face of the file that it is a part
  /// of, ascending. Makes all nodes. The tree and `source_face` must outlive this object.
  Group_tree(const Bvh8& tree, std::span<const Index> source_face) : tree_(&tree), source_face_(source_face)
  {
    tree.make_all();
    for (const covering::Vertex& v : tree.model().vertices())
      for (std::size_t k = 0; k < 3; ++k) reach_[k] = kernel::maximum(reach_[k], std::abs(v[k]));
    // Faces ascend as their source faces do, so their numbers decide. Each face's few elements are sorted apart.
    std::vector<Index> first(tree.model().face_count() + 1, 0);
    for (std::size_t e = 0; e < tree.element_count(); ++e) ++first[element(Index(e)).face + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    order_.resize(tree.element_count());
    std::vector<Index> next = first;
    for (std::size_t e = 0; e < order_.size(); ++e) order_[next[element(Index(e)).face]++] = Index(e);
    for (std::size_t f = 0; f + 1 < first.size(); ++f)
      std::ranges::sort(order_.begin() + first[f], order_.begin() + first[f + 1], {},
                        [&](Index e) { return std::pair(element(e).corner, e); });
    number_.resize(order_.size());
    for (std::size_t n = 0; n < order_.size(); ++n) number_[order_[n]] = Index(n);
  }

  const Bvh8& tree() const { return *tree_; }
  /// Returns the largest absolute value of each coordinate of the vertices.
  const std::array<double, 3>& reach() const { return reach_; }

  std::size_t piece_count() const { return order_.size(); }
  /// Returns the number of pieces of a group.
  std::size_t piece_count(Box_id box) const
  {
    const auto [first, last] = elements_below(box);
    return last - first + 1;
  }
  /// Returns the element that is piece n.
  const Element& piece(std::size_t n) const { return element(order_[n]); }

  /// What a cover needs of a group.
  struct Group {
    std::vector<std::uint32_t> corners;  ///< all vertices of its pieces, each once unless it is one piece
    Index least_face;                    ///< the least source face of its pieces
  };

  /// Returns the group of a box. The reference stays valid.
  const Group& group(Box_id box)
  {
    const auto found = groups_.find(box);
    if (found != groups_.end()) return found->second;
    Group group{{}, ~Index(0)};
    last_group_of_.resize(tree_->model().vertices().size(), 0);
    const auto number = Index(groups_.size() + 1);
    const bool has_each_once = !is_piece(box);
    for_each_element(box, [&](Index n) {
      const Element& e = element(n);
      tree_->for_vertices(e, [&](Index v) {
        if (!has_each_once || std::exchange(last_group_of_[v], number) != number) group.corners.push_back(v);
      });
      group.least_face = kernel::minimum(group.least_face, source_face_[e.face]);
    });
    return groups_.emplace(box, std::move(group)).first->second;
  }

  bool is_piece(Box_id box) const { return tree_->is_leaf(box); }
  const Element& piece_of(Box_id leaf) const { return tree_->element(leaf); }
  /// Returns the source face of a face of the tree.
  Index source_face(Index face) const { return source_face_[face]; }
  Index source_face(Box_id leaf) const { return source_face_[piece_of(leaf).face]; }

  /// Returns the members of a group that is not a piece.
  std::vector<Box_id> members(Box_id box) const
  {
    std::vector<Box_id> members;
    const Index child = tree_->child(box);
    const int count = tree_->node(child).boxes.lane_count;
    members.reserve(std::size_t(count));
    for (int lane = 0; lane < count; ++lane) members.emplace_back(child, lane);
    return members;
  }

  /// Makes `write` write the members of this group, since a cover names them. Requires that the groups above it are
  /// opened.
  void open(Box_id box) { opened_.insert(box); }

  bool is_opened() const { return !opened_.empty(); }

  /// Appends the groups as JSON: a piece's number, a list of groups, or steps from piece to piece.
  void write(std::string& text, Box_id box = {}) const
  {
    if (is_piece(box)) {
      text += std::to_string(number_[tree_->node_of(box).first[box.lane()]]);
      return;
    }
    if (!opened_.contains(box)) {
      write_steps(text, box);
      return;
    }
    char before = '[';
    const Index child = tree_->child(box);
    for (int lane = 0; lane < tree_->node(child).boxes.lane_count; ++lane) {
      text += std::exchange(before, ',');
      write(text, {child, lane});
    }
    text += ']';
  }

 private:
  /// Appends the pieces of a group in few digits, in ascending order. They are steps from one to the next, the first
  /// from -1, and -n for n steps of 1.
  void write_steps(std::string& text, Box_id box) const
  {
    std::vector<Index> pieces;
    for_each_element(box, [&](Index e) { pieces.push_back(number_[e]); });
    std::ranges::sort(pieces);
    text += "{\"steps\":";
    char before = '[';
    for (std::size_t k = 0; k < pieces.size();) {
      const Index step = k == 0 ? pieces[0] + 1 : pieces[k] - pieces[k - 1];
      std::size_t ones = 0;
      while (k + ones < pieces.size() && pieces[k + ones] == (k + ones == 0 ? 0 : pieces[k + ones - 1] + 1)) ++ones;
      text += std::exchange(before, ',');
      text += ones > 1 ? "-" + std::to_string(ones) : std::to_string(step);
      k += kernel::maximum(ones, std::size_t(1));
    }
    text += "]}";
  }

  const Element& element(Index e) const { return tree_->elements()[e]; }

  /// Returns the numbers of the first and the last element below a box. They are neighbours in the order of leaves: the
  /// last one is below the lane that begins last, at each node.
  std::array<Index, 2> elements_below(Box_id box) const
  {
    Box_id last = box;
    while (!is_piece(last)) {
      const Index child = tree_->child(last);
      const Bvh8_node& node = tree_->node(child);
      last = {child, int(std::max_element(node.first.begin(), node.first.begin() + node.boxes.lane_count) -
                         node.first.begin())};
    }
    const auto first_of = [&](Box_id id) { return tree_->node_of(id).first[id.lane()]; };
    return {first_of(box), first_of(last)};
  }

  /// Calls what(e) for the number of each element below the box.
  template <class What>
  void for_each_element(Box_id box, const What& what) const
  {
    const auto [first, last] = elements_below(box);
    for (Index e = first; e <= last; ++e) what(e);
  }

  const Bvh8* tree_;
  std::array<double, 3> reach_{};
  std::span<const Index> source_face_;
  std::vector<Index> order_, number_;  // the element of each piece, and the piece of each element
  std::map<Box_id, Group> groups_;
  std::vector<Index> last_group_of_;  // of each vertex, from 1: the group that took it last
  std::set<Box_id> opened_;
};

}  // namespace tetracone::tetratree

#endif
