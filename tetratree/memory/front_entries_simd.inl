#ifndef TETRACONE_TETRATREE_MEMORY_FRONT_ENTRIES_SIMD_INL
#define TETRACONE_TETRATREE_MEMORY_FRONT_ENTRIES_SIMD_INL
// Included by tetratree/memory/front_entries.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_TETRATREE_MEMORY_FRONT_ENTRIES_SIMD_INL  // that header includes this one, again and again
#include "tetracone/tetratree/memory/front_entries.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::tetratree::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace simd = kernel::HWY_NAMESPACE;

inline HWY_ATTR std::size_t expired_simd(const Front_entries& entries, std::uint32_t* found)
{
  constexpr simd::Float_tag tag;
  const float *const until = entries.until(), *const rates = entries.rates(), steps = entries.steps(),
                     strayed = entries.strayed_as_float();
  const std::size_t count = entries.count();
  const auto all_steps = hn::Set(tag, steps), limit = hn::Set(tag, strayed);
  std::size_t number = 0, first = 0;
  for (; first + hn::Lanes(tag) <= count; first += hn::Lanes(tag)) {
    const auto left = hn::Sub(hn::LoadU(tag, until + first), hn::Mul(hn::LoadU(tag, rates + first), all_steps));
    const auto is_over = hn::Not(hn::Gt(left, limit));
    // The numbers of the lanes in the mask are stored, then counted.
#if HWY_TARGET <= HWY_AVX3
    constexpr hn::RebindToUnsigned<simd::Float_tag> numbers;
    const auto id = hn::Add(hn::Set(numbers, std::uint32_t(first)), hn::Iota(numbers, 0));
    hn::StoreU(hn::Compress(id, hn::RebindMask(numbers, is_over)), numbers, found + number);
    number += hn::CountTrue(tag, is_over);
#else
    std::uint8_t bits[8];
    hn::StoreMaskBits(tag, is_over, bits);
    const std::uint8_t* lanes = lanes_in[bits[0]].data();
    for (std::size_t k = 0; k < hn::Lanes(tag); ++k) found[number + k] = std::uint32_t(first) + lanes[k];
    number += std::size_t(std::popcount(bits[0]));
#endif
  }
  for (; first < count; ++first)
    if (!(until[first] - rates[first] * steps > strayed)) found[number++] = std::uint32_t(first);
  return number;
}

inline HWY_ATTR std::size_t keep_by_axes_simd(const Certifying& certifying, std::uint32_t* asked, std::size_t count,
                                              double& least)
{
  Front_entries& entries = *certifying.entries;
  std::size_t left = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (k + 2 < count) entries.prefetch(asked[k + 2]);
    const std::uint32_t number = asked[k];
    const Front_entry& entry = entries[number];
    const Certificate& certificate = entries.certificate(number);
    const int body = entry.carried_body();
    const kernel::Gap_and_rate now = simd::least_gap_after(certificate.gaps, entry.lanes, certificate.carried,
                                                           certificate.going, certifying.carrier[body]);
    // Branchless, since the branches would be unpredictable.
    const bool stays = (entry.lanes != 0) & (now.gap > 0);
    const double to_a = certifying.to_a[1 - body], gaps[2] = {0, to_a * now.gap}, leasts[2] = {least, gaps[1]};
    entries.set_gap(number, gaps[stays], to_a * now.rate);
    least = leasts[stays & (gaps[1] < least)];
    asked[left] = number;
    left += !stays;
  }
  return left;
}

/// The lanes that were found apart, and their least gap, in A's local units.
struct Certified_lanes {
  unsigned apart = 0;
  double gap = 0;
};

/// Selects the lanes that are asked for and not found apart. Certifies the others.
struct Parts_uncertified {
  const kernel::Obb8& boxes;
  const kernel::Single_box& box;
  unsigned asked;
  float slack;
  Certificate& certificate;
  unsigned apart = 0;
  hn::Vec<simd::Float_tag> least = hn::Set(simd::Float_tag(), kernel::most_gap_slack);

  HWY_INLINE auto operator()(std::size_t first)
  {
    constexpr simd::Float_tag tag;
    constexpr float far = kernel::most_gap_slack;
    const std::uint8_t bits_asked[8] = {std::uint8_t(asked >> first)};
    const auto is_asked = hn::LoadMaskBits(tag, bits_asked);
    const auto gaps = simd::certify_gaps(simd::One_test{boxes, box, first}, slack, certificate.gaps);
    const auto is_apart = hn::And(is_asked, hn::Gt(gaps, hn::Set(tag, slack <= far ? 0.0f : far)));
    least = hn::Min(least, hn::IfThenElse(is_apart, gaps, hn::Set(tag, far)));
    std::uint8_t bits[8];
    hn::StoreMaskBits(tag, is_apart, bits);
    apart |= unsigned(bits[0]) << first;
    return hn::AndNot(is_apart, is_asked);
  }
};

/// Certifies the lanes of `asked` that are apart from the other box, and pushes the others.
HWY_INLINE std::size_t push_uncertified(Pair_stack& stack, std::size_t count, const Opening& o,
                                        const kernel::Single_box& box, unsigned asked, Both_trees& trees,
                                        const Certifying& certifying, Certificate& certificate,
                                        Certified_lanes& certified)
{
  constexpr simd::Float_tag tag;
  const float size = box.extent[0] + (box.extent[1] + box.extent[2]),
              slack = kernel::gap_slack(box, o.node->boxes.reach, size);
  Parts_uncertified parts{o.node->boxes, box, asked, slack, certificate};
  count = push_parts(stack, count, o, trees, parts);
  const int other = 1 - o.body;
  simd::carry_now(certifying.carrier[other], trees.node_of(other, o.box[other]).boxes, o.box[other].lane(),
                  certificate.carried);
  certified.apart = slack <= kernel::most_gap_slack ? parts.apart : 0;
  certified.gap = double(hn::GetLane(hn::MinOfLanes(tag, parts.least))) * certifying.to_a[o.body];
  return count;
}

/// Pushes the uncertified lanes, and writes the certified ones to the front.
struct Keep_uncertified {
  const Certifying& certifying;

  HWY_INLINE std::size_t operator()(Pair_stack& stack, std::size_t count, const Opening& o,
                                    const kernel::Single_box& box, Both_trees& trees) const
  {
    Certified_lanes certified;
    const unsigned held = (1u << o.node->boxes.lane_count) - 1;
    count = push_uncertified(stack, count, o, box, held, trees, certifying, certifying.entries->next(), certified);
    if (certified.apart != 0) {
      certifying.entries->next().going = kernel::Going_box(trees.node_of(1, o.box[1]).boxes, o.box[1].lane());
      certifying.entries->add(
          {o.first_part(trees), o.box[1 - o.body],
           o.body == 0 ? Front_entry::Kind::node_of_a : Front_entry::Kind::node_of_b, std::uint8_t(certified.apart)},
          certified.gap);
    }
    return count;
  }
};

inline HWY_ATTR Stop descend_certified_simd(Pair_stack& stack, Both_trees& trees, const Certifying& certifying)
{
  const Keep_uncertified keep{certifying};
  return descend_keeping<true>(stack, trees, keep);
}

inline HWY_ATTR void open_again_simd(Pair_stack& stack, Both_trees& trees, const Certifying& certifying,
                                     const std::uint32_t* asked, std::size_t count, double& least)
{
  Front_entries& entries = *certifying.entries;
  for (std::size_t k = 0; k < count; ++k) {
    Front_entry& entry = entries[asked[k]];
    if (entry.kind == Front_entry::Kind::pair) continue;
    stack.reserve();
    const Opening o(1 - entry.carried_body(), entry.first.node(), entry.second, trees);
    Certified_lanes certified;
    stack.set_count(push_uncertified(stack, stack.count(), o, o.single<true>(trees), entry.lanes, trees, certifying,
                                     entries.certificate(asked[k]), certified));
    entry.lanes = std::uint8_t(certified.apart);
    if (certified.apart == 0) continue;
    entries.set_gap(asked[k], certified.gap);
    least = least < certified.gap ? least : certified.gap;
  }
}

}  // namespace tetracone::tetratree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_TETRATREE_MEMORY_FRONT_ENTRIES_SIMD_INL
#endif
