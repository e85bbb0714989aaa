#include "tetracone/tetratree/fast/front_entries.h"

#include "tetracone/kernel/number/number.h"
#include "verify/test/support/simd_versions.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace tetracone::tetratree {

using Expired = std::size_t(const float*, std::size_t, float, std::uint32_t*);

std::vector<Expired*> expired_versions()
{
  return verify::versions_here<Expired>(TETRACONE_SIMD_VERSIONS(expired_simd));
}

}  // namespace tetracone::tetratree

BOOST_AUTO_TEST_SUITE(test_front_entries)

using namespace tetracone::tetratree;
using tetracone::kernel::Rational;
using Random = std::mt19937_64;

BOOST_AUTO_TEST_CASE(an_entry_expires_no_later_than_its_gap_is_used_up)
{
  Random random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  int late = 0, early = 0;
  for (int k = 0; k < 100000; ++k) {
    const double then = std::ldexp(unit(random), -int(random() % 40) + 6),
                 gap = std::ldexp(unit(random), -int(random() % 70));
    // Moved by nearly the gap, or by exactly it.
    const double moved = then + gap * (k % 3 == 0 ? 1 : 1 + std::ldexp(unit(random) - 0.5, -int(random() % 50)));
    const bool holds = Front_entries::until(then, gap) > Front_entries::as_float(moved);
    late += holds && Rational(moved) - Rational(then) >= Rational(gap);
    early += !holds && moved < (then + gap) * (1 - 0x1p-20) && gap > 0x1p-60;
  }
  BOOST_TEST(late == 0);
  BOOST_TEST(early == 0);
  for (const double gap : {0.0, -1.0, 0x1p-80, std::numeric_limits<double>::quiet_NaN()})
    BOOST_TEST(Front_entries::until(0, gap) == Front_entries::at_once);
}

BOOST_AUTO_TEST_CASE(all_entries_that_have_expired_are_found_in_order)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Random random(2);
  for (Expired* expired : expired_versions())
    for (std::size_t count = 0; count < 70; ++count) {
      std::vector<float> until;
      std::vector<std::uint32_t> right;
      for (std::size_t k = 0; k < count; ++k) {
        until.push_back(random() % 9 == 0 ? nan : random() % 9 == 0 ? 0.5f : float(random() % 1000) / 1000);
        if (!(until[k] > 0.5f)) right.push_back(std::uint32_t(k));
      }
      std::vector<std::uint32_t> found(count + tetracone::kernel::lanes);
      found.resize(expired(until.data(), count, 0.5f, found.data()));
      BOOST_TEST((found == right));
    }
}

BOOST_AUTO_TEST_CASE(entries_keep_their_certificates_wherever_they_are_moved)
{
  Front_entries entries;
  for (std::uint32_t k = 0; k < 200; ++k) {
    entries.next().gaps.gap[0] = float(k);
    entries.add({k, 0, Front_entry::Kind::pair, 1}, float(k));
  }
  for (std::size_t k = 0; k < entries.count(); k += 3) entries.remove(k);
  BOOST_TEST(entries.count() > 100u);
  for (std::size_t k = 0; k < entries.count(); ++k) {
    BOOST_TEST(entries.certificate(k).gaps.gap[0] == float(entries[k].first));
    BOOST_TEST(entries.until(k) == float(entries[k].first));
  }
  entries.clear();
  BOOST_TEST(entries.count() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
