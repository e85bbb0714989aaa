#ifndef TETRACONE_TETRATREE_DOOR_TREE_FLAW_H
#define TETRACONE_TETRATREE_DOOR_TREE_FLAW_H

#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "tetracone/tetratree/fast/bvh8_node.h"

#include <optional>
#include <span>
#include <string>

namespace tetracone::detail {

/// Returns the flaw of nodes that come from a file. Returns nothing where they are a fast tree of these elements, in
/// the order of `Bvh8::nodes_in_order`, by which every query answers exactly:
///
/// - each node is below one lane of one node before it, and each element is in one leaf;
/// - numbers are finite, and within the bounds that the proofs of queries assume;
/// - each box holds all corners of its elements, by the margin that `Obb8` requires;
/// - a leaf's apex code (`kernel::Apex_code`) holds for its triangle;
/// - lanes that hold nothing are 0.
///
/// Any bytes may stand in the nodes. Time: linear in the elements, times the tree's depth.
std::optional<std::string> tree_flaw(const tetratree::Bvh8_elements& elements,
                                     std::span<const tetratree::Bvh8_node> nodes);

}  // namespace tetracone::detail

#endif
