#include "tetracone/tetratree/memory/front_entries.h"

#include "tetracone/kernel/number/number.h"
#include "verify/test/support/simd_versions.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace tetracone::tetratree {

using Expired = std::size_t(const Front_entries&, std::uint32_t*);

inline auto expired_versions() { return TETRACONE_VERSIONS_HERE(expired_simd); }

}  // namespace tetracone::tetratree

BOOST_AUTO_TEST_SUITE(test_front_entries)

using namespace tetracone::tetratree;
using tetracone::kernel::Course;
using tetracone::kernel::Rational;
using Random = std::mt19937_64;

namespace {

constexpr Front_entry pair{{}, {}, Front_entry::Kind::pair, 1};

/// The numbers of those that have expired.
std::vector<std::uint32_t> found(Expired* expired, const Front_entries& entries)
{
  std::vector<std::uint32_t> numbers(entries.count() + tetracone::kernel::lanes);
  numbers.resize(expired(entries, numbers.data()));
  return numbers;
}

double parts(double steps) { return std::ceil(steps / Course::least_step) * Course::least_step; }

}  // namespace

BOOST_AUTO_TEST_CASE(an_entry_expires_no_later_than_its_gap_is_used_up)
{
  // By its own rate or the pace, and by what was strayed; of several courses, one after the other.
  Random random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  int late = 0, early = 0, too_large = 0, held = 0;
  for (int k = 0; k < 40000; ++k) {
    Front_entries entries;
    const double pace = std::ldexp(unit(random), -int(random() % 30));
    entries.set_course(pace);
    double gone = std::ldexp(unit(random), -int(random() % 40));
    entries.go_on(parts(unit(random) * 100), gone);
    gone += 200 * pace;
    const double gap = std::ldexp(unit(random), -int(random() % 50));
    entries.add(pair, gap);
    Rational left = gap;
    double rate = pace;
    if (k % 2 == 0) entries.set_gap(0, gap, rate = pace * unit(random));
    for (int course = 0; course < 1 + k % 3; ++course) {
      if (course > 0) entries.set_course(rate = pace * unit(random));
      // Nearly all of it, or exactly as much as is left, by steps and by what is strayed.
      const double rest = left.get_d() * (k % 5 == 0 ? 1 : 1 + std::ldexp(unit(random) - 0.5, -int(random() % 40))) *
                          (course < k % 3 ? 0.5 : 1);
      const double steps = rate > 0 ? std::min(parts(unit(random) * rest / rate), 4000.0) : 5,
                   strayed = std::max(0.0, rest - steps * rate);
      entries.go_on(steps, strayed);
      gone += steps * pace + strayed;
      left -= Rational(steps) * Rational(rate) + Rational(strayed);
    }
    for (Expired* expired : expired_versions()) {
      const bool holds = found(expired, entries).empty();
      late += holds && left <= 0;
      early += !holds && left > Rational(0x1p-17 * (gap + gone)) && gap > 0x1p-40;
      held += holds;
    }
    too_large += Rational(entries.gap(0)) > left && entries.gap(0) > 0;
  }
  BOOST_TEST(late == 0);
  BOOST_TEST(early == 0);
  BOOST_TEST(too_large == 0);
  BOOST_TEST(held > 5000);
}

BOOST_AUTO_TEST_CASE(nothing_is_left_of_what_is_not_positive_or_undefined)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (Expired* expired : expired_versions()) {
    for (const double gap : {0.0, -1.0, 0x1p-80, nan}) {
      Front_entries entries;
      entries.add(pair, gap);
      BOOST_TEST(found(expired, entries).size() == 1u);
      BOOST_TEST(!(entries.gap(0) > 0));
      entries.set_course(0);
      BOOST_TEST(found(expired, entries).size() == 1u);
    }
    for (const double bad : {nan, infinity}) {
      Front_entries of_rate, of_course, strayed, gone;
      for (Front_entries* entries : {&of_rate, &of_course, &strayed, &gone}) entries->add(pair, 0.5);
      of_rate.set_gap(0, 0.5, bad);
      of_rate.go_on(1, 0);
      of_course.set_course(bad);
      of_course.go_on(1, 0);
      strayed.go_on(0, bad);
      gone.go_on(bad, 0);
      BOOST_TEST(strayed.has_gone_far());
      BOOST_TEST(of_course.has_gone_far());
      for (const Front_entries* entries : {&of_rate, &of_course, &strayed})
        BOOST_TEST(found(expired, *entries).size() == 1u);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_bodies_had_before_they_went_on_is_known)
{
  Front_entries entries;
  entries.set_course(0.125);
  entries.add(pair, 1);
  entries.set_gap(0, 1, 0.0625);
  entries.go_on(2, 0.25);
  entries.go_on(1, 0.125);
  BOOST_TEST(std::abs(entries.gap_before(0) - 0.625) < 1e-5);
  BOOST_TEST(std::abs(entries.gap(0) - 0.4375) < 1e-5);
}

BOOST_AUTO_TEST_CASE(all_entries_that_have_expired_are_found_in_order)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Random random(2);
  for (Expired* expired : expired_versions())
    for (std::size_t count = 0; count < 70; ++count) {
      Front_entries entries;
      std::vector<std::uint32_t> right;
      for (std::size_t k = 0; k < count; ++k) {
        const bool is_over = random() % 3 == 0;
        const double rate = double(random() % 100) / 100;
        entries.add(pair, 0);
        entries.set_gap(k, random() % 9 == 0 && is_over ? nan : (rate * 2 + 0.5) * (is_over ? 0.99 : 1.01), rate);
        if (is_over) right.push_back(std::uint32_t(k));
      }
      entries.go_on(2, 0.5);
      BOOST_TEST((found(expired, entries) == right));
    }
}

BOOST_AUTO_TEST_CASE(entries_keep_their_certificates_wherever_they_are_moved)
{
  Front_entries entries;
  for (std::uint32_t k = 0; k < 200; ++k) {
    entries.next().gaps.gap[0] = float(k);
    entries.add({Box_id(k, 0), {}, Front_entry::Kind::pair, 1}, 0);
    entries.set_gap(k, double(k + 1), double(k));
  }
  for (std::size_t k = 0; k < entries.count(); k += 3) entries.remove(k);
  BOOST_TEST(entries.count() > 100u);
  for (std::size_t k = 0; k < entries.count(); ++k) {
    BOOST_TEST(entries.certificate(k).gaps.gap[0] == float(entries[k].first.node()));
    BOOST_TEST(std::abs(entries.gap(k) - double(entries[k].first.node() + 1)) < 1e-3);
  }
  entries.go_on(1, 0);
  for (std::size_t k = 0; k < entries.count(); ++k) BOOST_TEST(std::abs(entries.gap(k) - 1) < 1e-3);
  entries.clear();
  BOOST_TEST(entries.count() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
