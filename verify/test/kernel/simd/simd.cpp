// A translation unit that has a Highway kernel of its own, of the usual form, after the library's.
#include "tetracone/kernel/simd/simd.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "verify/test/kernel/simd/simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace user::HWY_NAMESPACE {

HWY_ATTR double doubled(double x)
{
  const hwy::HWY_NAMESPACE::ScalableTag<double> tag;
  const auto v = hwy::HWY_NAMESPACE::Set(tag, x);
  return hwy::HWY_NAMESPACE::GetLane(hwy::HWY_NAMESPACE::Add(v, v));
}

}  // namespace user::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>
#include <vector>

namespace user {
HWY_EXPORT(doubled);
}

using namespace tetracone::kernel;

namespace {

using Function = int();
template <int k>
int number()
{
  return k;
}

/// Highway's answers limited to some targets, for a time.
struct Only {
  explicit Only(std::int64_t targets) { hwy::SetSupportedTargetsForTest(targets); }
  ~Only() { hwy::SetSupportedTargetsForTest(0); }
};

}  // namespace

namespace tetracone::kernel {
std::vector<std::int64_t> targets()
{
  std::vector<std::int64_t> found;
  using Overlapping = unsigned(const Obb8&, const Single_box&, bool);
  for (const Simd_version<Overlapping>& version :
       std::initializer_list<Simd_version<Overlapping>> TETRACONE_SIMD_VERSIONS(overlapping_simd))
    found.push_back(version.target);
  return found;
}
}  // namespace tetracone::kernel

BOOST_AUTO_TEST_SUITE(test_simd)

BOOST_AUTO_TEST_CASE(a_unit_keeps_its_own_kernels) { BOOST_TEST(user::HWY_DYNAMIC_DISPATCH(doubled)(21) == 42); }

BOOST_AUTO_TEST_CASE(the_first_version_that_the_processor_has_is_chosen)
{
  const std::initializer_list<Simd_version<Function>> versions = {
      {HWY_AVX3, &number<3>}, {HWY_AVX2, &number<2>}, {HWY_STATIC_TARGET, &number<0>}};
  const auto chosen = [&](std::int64_t targets) {
    const Only only(targets);
    return fastest_version<Function>(versions)();
  };
  BOOST_TEST(chosen(HWY_AVX3 | HWY_AVX2 | HWY_STATIC_TARGET) == 3);
  BOOST_TEST(chosen(HWY_AVX2 | HWY_STATIC_TARGET) == 2);
  BOOST_TEST(chosen(HWY_STATIC_TARGET) == 0);
  BOOST_TEST(chosen(std::int64_t(1) << 40) == 0);  // of another architecture: what all have
}

BOOST_AUTO_TEST_CASE(versions_differ_in_target_and_end_with_what_every_processor_has)
{
  const std::vector<std::int64_t> found = targets();
  BOOST_TEST(found.back() == HWY_STATIC_TARGET);
  BOOST_TEST((std::set<std::int64_t>(found.begin(), found.end()).size() == found.size()));
  // Highway numbers targets of an architecture from the best on.
  BOOST_TEST(std::is_sorted(found.begin(), found.end()));
#if defined(__x86_64__) && !defined(__AVX2__)
  BOOST_TEST(
      (std::count(found.begin(), found.end(), HWY_AVX2) == 1 && std::count(found.begin(), found.end(), HWY_AVX3) == 1));
#endif
}

BOOST_AUTO_TEST_SUITE_END()
#endif
