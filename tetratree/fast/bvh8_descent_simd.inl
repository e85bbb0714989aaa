#ifndef TETRACONE_TETRATREE_FAST_BVH8_DESCENT_SIMD_INL
#define TETRACONE_TETRATREE_FAST_BVH8_DESCENT_SIMD_INL
// Included by tetratree/fast/bvh8_descent.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_TETRATREE_FAST_BVH8_DESCENT_SIMD_INL  // that header includes this one, again and again
#include "tetracone/tetratree/fast/bvh8_descent.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::tetratree::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace simd = kernel::HWY_NAMESPACE;

/// A pair whose larger box is to be replaced by its parts.
struct Opening {
  const Bvh8_node* node = nullptr;  // the parts
  int body;                         // the larger box's
  Stop stop = Stop::nothing_left;   // why it cannot be opened, if so
  Box_id box[2];
  float size[2];

  HWY_INLINE Opening(Pair_stack& stack, std::size_t position, const Both_trees& trees)
  {
    for (int k = 0; k < 2; ++k) {
      box[k] = Box_id::from_number(stack.numbers(k)[position]);
      size[k] = stack.sizes(k)[position];
    }
    body = first_is_larger(size[0], size[1]) ? 0 : 1;
    if (size[body] < 0) {
      stop = Stop::leaves;
      return;
    }
    const std::int32_t child = trees.node_of(body, box[body]).child_of(box[body].lane());
    if (child < 0)
      stop = Stop::no_child;
    else
      node = trees.nodes[body] + child;
  }

  /// Opens a node against a box of the other body.
  HWY_INLINE Opening(int of_body, std::uint32_t number, Box_id other_box, const Both_trees& trees)
      : node(trees.nodes[of_body] + number), body(of_body)
  {
    const int other = 1 - body;
    box[other] = other_box;
    size[body] = 0;
    size[other] = trees.size(other, other_box);
  }

  HWY_INLINE bool is_ready() const { return stop == Stop::nothing_left; }

  HWY_INLINE Box_id first_part(const Both_trees& trees) const { return {std::uint32_t(node - trees.nodes[body]), 0}; }

  /// Returns the other box, in the frame of the parts.
  template <bool similarity>
  HWY_INLINE kernel::Single_box single(const Both_trees& trees) const
  {
    const int other = 1 - body, lane = box[other].lane();
    const Bvh8_node& from = trees.node_of(other, box[other]);
    if constexpr (!similarity) return (*trees.into[other])(node->boxes, from.boxes, lane);
    const float magnitude = size[other] < 0 ? -size[other] : size[other];
    kernel::Single_box single = simd::carried(node->boxes, *trees.into[other], from.boxes, lane,
                                              body == 1 ? magnitude : magnitude / trees.scale);
    if (size[other] < 0) single.apex = kernel::apex_of(Bvh8_node::apex(from.child[lane]));
    return single;
  }
};

/// Pushes the pairs of the other box and the parts in mask_at(first), lanes from `first` on. Writes from position
/// `count` on; returns the position after them.
template <class Mask_at>
HWY_INLINE std::size_t push_parts(Pair_stack& stack, std::size_t count, const Opening& o, Both_trees& trees,
                                  Mask_at&& mask_at)
{
  constexpr simd::Float_tag tag;
  constexpr hn::RebindToUnsigned<simd::Float_tag> ids;
  const int other = 1 - o.body;
  const kernel::Obb8& boxes = o.node->boxes;
  const std::uint32_t first_id = o.first_part(trees).number();
  for (std::size_t first = 0; first < kernel::lanes; first += hn::Lanes(tag)) {
    const auto mask = mask_at(first);
    const auto extent = [&](int i) HWY_ATTR { return hn::Load(tag, boxes.extent[i] + first); };
    const auto size =
        hn::Mul(hn::Set(tag, o.body == 0 ? trees.scale : 1.0f), hn::Add(extent(0), hn::Add(extent(1), extent(2))));
    const auto id = hn::Add(hn::Set(ids, first_id + std::uint32_t(first)), hn::Iota(ids, 0));
    const auto signed_size =
        hn::Or(size, hn::BitCast(tag, hn::LoadU(ids, signs_in[o.node->boxes.marked].data() + first)));
    // Whole vectors are stored: a masked store would delay the next pop.
#if HWY_TARGET <= HWY_AVX3
    hn::StoreU(hn::Compress(id, hn::RebindMask(ids, mask)), ids, stack.numbers(o.body) + count);
    hn::StoreU(hn::Compress(signed_size, mask), tag, stack.sizes(o.body) + count);
#else
    // No single instruction does this. Compress of Highway 1.0.3 would copy its table, a kilobyte, to the stack each
    // time.
    constexpr hn::RebindToSigned<simd::Float_tag> lane_numbers;
    std::uint8_t set[8];
    hn::StoreMaskBits(tag, mask, set);
    const auto moved =
        hn::PromoteTo(lane_numbers, hn::LoadU(hn::Rebind<std::uint8_t, simd::Float_tag>(), lanes_in[set[0]].data()));
    hn::StoreU(hn::TableLookupLanes(id, hn::IndicesFromVec(ids, moved)), ids, stack.numbers(o.body) + count);
    hn::StoreU(hn::TableLookupLanes(signed_size, hn::IndicesFromVec(tag, moved)), tag, stack.sizes(o.body) + count);
#endif
    hn::StoreU(hn::Set(ids, o.box[other].number()), ids, stack.numbers(other) + count);
    hn::StoreU(hn::Set(tag, o.size[other]), tag, stack.sizes(other) + count);
    count += hn::CountTrue(tag, mask);
  }
  ++trees.opened;
  trees.compared += std::size_t(boxes.lane_count);
  return count;
}

/// Selects the parts that may meet the other box. It is no lambda: lambdas are not inlined.
template <bool similarity>
struct Parts_together {
  const kernel::Obb8& boxes;
  const kernel::Single_box& box;

  HWY_INLINE auto operator()(std::size_t first) const
  {
    const auto held = std::size_t(boxes.lane_count);
    return hn::And(simd::together<similarity>(simd::One_test{boxes, box, first}),
                   hn::FirstN(simd::Float_tag(), held > first ? held - first : 0));
  }
};

/// Pushes the parts that may meet the other box.
template <bool similarity>
struct Keep_together {
  HWY_INLINE std::size_t operator()(Pair_stack& stack, std::size_t count, const Opening& o,
                                    const kernel::Single_box& box, Both_trees& trees) const
  {
    return push_parts(stack, count, o, trees, Parts_together<similarity>{o.node->boxes, box});
  }
};

/// Adds the pairs of the other box and the parts in `set`, as bits, from part `first` on.
[[gnu::noinline]] inline HWY_ATTR void add_leaves(std::vector<Box_ids>& leaves, const Opening& o,
                                                  const Both_trees& trees, std::size_t first, unsigned set)
{
  Box_ids pair{o.box[0], o.box[1]};
  for (; set != 0; set &= set - 1) {
    pair[std::size_t(o.body)] = {o.first_part(trees).node(), int(first) + std::countr_zero(set)};
    leaves.push_back(pair);
  }
}

/// Selects the parts that may meet the other box, except leaves if that box is a leaf. Pairs of leaves are added to
/// `leaves`.
template <bool similarity>
struct Parts_without_leaves {
  Parts_together<similarity> together;
  std::vector<Box_ids>& leaves;
  const Opening& opening;
  const Both_trees& trees;
  unsigned paired;  // leaves that make pairs of leaves, as bits

  HWY_INLINE auto operator()(std::size_t first) const
  {
    constexpr simd::Float_tag tag;
    auto mask = together(first);
    std::uint8_t bits[8];
    hn::StoreMaskBits(tag, mask, bits);
    if (const unsigned found = bits[0] & paired >> first; found != 0) {
      add_leaves(leaves, opening, trees, first, found);
      bits[0] = std::uint8_t(bits[0] & ~found);
      mask = hn::LoadMaskBits(tag, bits);
    }
    return mask;
  }
};

/// Opens four pairs per round if that many are ready, so that their latencies overlap; else two, or one. The first
/// rounds open at most two: bodies that meet are often decided after few openings, and further ones would be wasted.
/// `keep` pushes the pairs that an opening leaves.
template <bool similarity, class Keep>
HWY_INLINE Stop descend_keeping(Pair_stack& stack, Both_trees& trees, Keep& keep)
{
  while (!stack.empty()) {
    stack.reserve();
    const std::size_t top = stack.count() - 1;
    const auto opening = [&](std::size_t below)
                             HWY_ATTR { return Opening(stack, top >= below ? top - below : 0, trees); };
    const auto single = [&](const Opening& o) HWY_ATTR { return o.template single<similarity>(trees); };
    const auto put = [&](std::size_t count, const Opening& o, const kernel::Single_box& box)
                         HWY_ATTR { return keep(stack, count, o, box, trees); };

    const Opening first = opening(0), second = opening(1);
    if (!first.is_ready()) return first.stop;
    if (top >= 3 && trees.opened >= opened_by_two) {
      const Opening third = opening(2), fourth = opening(3);
      if (second.is_ready() && third.is_ready() && fourth.is_ready()) {
        const kernel::Single_box of_first = single(first), of_second = single(second), of_third = single(third),
                                 of_fourth = single(fourth);
        stack.set_count(
            put(put(put(put(top - 3, fourth, of_fourth), third, of_third), second, of_second), first, of_first));
        continue;
      }
    }
    const kernel::Single_box of_first = single(first);
    if (top >= 1 && second.is_ready()) {
      const kernel::Single_box of_second = single(second);
      stack.set_count(put(put(top - 1, second, of_second), first, of_first));
    } else {
      stack.set_count(put(top, first, of_first));
    }
  }
  return Stop::nothing_left;
}

template <bool similarity>
HWY_ATTR Stop descend(Pair_stack& stack, Both_trees& trees)
{
  const Keep_together<similarity> keep;
  return descend_keeping<similarity>(stack, trees, keep);
}

/// Prefetches the nodes that will open the pairs from position `first` on.
HWY_INLINE void prefetch_nodes(Pair_stack& stack, std::size_t first, const Both_trees& trees)
{
  for (std::size_t k = first; k < stack.count(); ++k) {
    const Opening opening(stack, k, trees);
    if (!opening.is_ready()) continue;
    const char* const bytes = reinterpret_cast<const char*>(opening.node);
    for (std::size_t line = 0; line < sizeof(Bvh8_node); line += 64) __builtin_prefetch(bytes + line);
  }
}

/// Opens level by level, up to four pairs per round, and prefetches the nodes of the next level meanwhile.
template <bool similarity>
HWY_ATTR Stop descend_to_leaves(Pair_stack& level, Pair_stack& next, Both_trees& trees, std::vector<Box_ids>& leaves)
{
  constexpr std::size_t most = 4;
  for (;; level.swap(next)) {
    while (!level.empty()) {
      const std::size_t top = level.count() - 1;
      const auto opening = [&](std::size_t below)
                               HWY_ATTR { return Opening(level, top >= below ? top - below : 0, trees); };
      const Opening openings[most] = {opening(0), opening(1), opening(2), opening(3)};
      if (!openings[0].is_ready()) return openings[0].stop;
      std::size_t ready = 1;
      while (ready < most && ready <= top && openings[ready].is_ready()) ++ready;
      kernel::Single_box boxes[most];
      for (std::size_t k = 0; k < ready; ++k) boxes[k] = openings[k].template single<similarity>(trees);
      level.set_count(level.count() - ready);
      next.reserve();
      const std::size_t first = next.count();
      for (std::size_t k = 0; k < ready; ++k) {
        const Opening& o = openings[k];
        const unsigned paired = o.size[1 - o.body] < 0 ? o.node->boxes.marked : 0;
        const Parts_without_leaves<similarity> parts{{o.node->boxes, boxes[k]}, leaves, o, trees, paired};
        next.set_count(push_parts(next, next.count(), o, trees, parts));
      }
      prefetch_nodes(next, first, trees);
    }
    if (next.empty()) return Stop::nothing_left;
  }
}

HWY_INLINE bool are_similarities(const Both_trees& trees)
{
  return trees.into[0]->is_similarity() && trees.into[1]->is_similarity();
}

inline HWY_ATTR Stop descend_simd(Pair_stack& stack, Both_trees& trees)
{
  return are_similarities(trees) ? descend<true>(stack, trees) : descend<false>(stack, trees);
}

inline HWY_ATTR Stop descend_to_leaves_simd(Pair_stack& level, Pair_stack& next, Both_trees& trees,
                                            std::vector<Box_ids>& leaves)
{
  return are_similarities(trees) ? descend_to_leaves<true>(level, next, trees, leaves)
                                 : descend_to_leaves<false>(level, next, trees, leaves);
}

}  // namespace tetracone::tetratree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_TETRATREE_FAST_BVH8_DESCENT_SIMD_INL
#endif
