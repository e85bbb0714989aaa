#include "tetracone/kernel/predicate/stage_counts.h"

#include "tetracone/kernel/predicate/adaptive.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_stage_counts)

using namespace tetracone::kernel;
using Stage = Adaptive::Stage;

namespace {

/// Returns the counts that one sign adds.
template <class Ask>
Stage_counts counted(const Ask& ask)
{
  const Stage_counts before = Adaptive::decided_by();
  ask();
  return Adaptive::decided_by() - before;
}

/// The counts of one sign.
Stage_counts one(Stage stage)
{
  Stage_counts counts;
  ++counts[stage];
  return counts;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_stage_counts_the_sign_that_it_decides_and_no_other_does)
{
  const auto at = [](double x, double y, double z) { return Adaptive::unmoved({x, y, z}); };
  const auto o = at(0, 0, 0), b = at(1, 2, 3), c = at(3, 1, 2);
  const auto volume = [&](const Adaptive::Point_3& d) { return counted([&] { Adaptive::volume_sign(o, b, c, d); }); };
  BOOST_TEST((volume(at(2, 3, 1)) == one(Stage::filter)));
  BOOST_TEST((volume(b) == one(Stage::zero)));
  BOOST_TEST((volume(at(4, 3, 5 + 0x1p-50)) == one(Stage::fixed)));
  BOOST_TEST((counted([&] { Adaptive::volume_sign(at(0x1p-300, 0, 0), b, c, at(4, 3, 5 + 0x1p-50)); }) ==
              one(Stage::double_double)));
  BOOST_TEST((volume(at(4, 3, 5)) == one(Stage::grid)));
  const auto off_grid = [&](double x, double y, double z) {
    return Adaptive::unmoved({x + 0x1p-50, y + 0x1p-50, z + 0x1p-50});
  };
  BOOST_TEST((counted([&] {
                Adaptive::volume_sign(off_grid(0, 0, 0), off_grid(1, 2, 3), off_grid(3, 1, 2), off_grid(4, 3, 5));
              }) == one(Stage::fixed)));
  BOOST_TEST((counted([&] {
                Adaptive::volume_sign(o, at(1, 0x1p-300, 0), at(0, 1, 0x1p-300), at(1, 1 + 0x1p-300, 0x1p-300));
              }) == one(Stage::exact)));
  BOOST_TEST((volume(at(4e200, 3e200, 5e200)) == one(Stage::out_of_gate)));
  BOOST_TEST((counted([&] { Adaptive::normal_sign(o, b, at(2, 4, 7), 2); }) == one(Stage::grid)));
  BOOST_TEST((counted([&] { Adaptive::difference_sign(o, at(1e200, 0, 0), 0); }) == one(Stage::fixed)));
  BOOST_TEST((counted([&] { Adaptive::difference_sign(o, b, 0); }) == one(Stage::filter)));
}

BOOST_AUTO_TEST_CASE(a_sign_of_one_frame_is_counted_once)
{
  const Pose pose(std::array<double, 12>{0.6, -0.8, 0, 1e9, 0.8, 0.6, 0, 1e9, 0, 0, 1, 1e9});
  const auto at = [&](double x, double y, double z) { return Adaptive::placed({x, y, z}, pose); };
  const auto volume = [&](const Vertex& d) {
    return counted(
        [&] { Adaptive::volume_sign(at(0, 0, 0), at(1e-5, 2e-5, 3e-5), at(3e-5, 1e-5, 2e-5), at(d[0], d[1], d[2])); });
  };
  BOOST_TEST((volume({2e-5, 3e-5, 1e-5}) == one(Stage::filter)));  // that of the vertices
  BOOST_TEST((volume({0, 0, 0}) == one(Stage::zero)));
}

BOOST_AUTO_TEST_CASE(fallbacks_are_what_the_fixed_and_the_exact_stage_decided)
{
  std::thread([] {
    BOOST_TEST(Adaptive::exact_fallbacks() == 0u);  // of this thread
    for (std::size_t k = 0; k < stage_count; ++k) Adaptive::decided_by()[static_cast<Stage>(k)] = 4u << k;
    Adaptive::decided_by()[Stage::exact] = 2;
    Adaptive::decided_by()[Stage::out_of_gate] = 1;
    BOOST_TEST(Adaptive::exact_fallbacks() == 67u);
    BOOST_TEST(Adaptive::decided_by().total() == 239u);
    BOOST_TEST((Adaptive::decided_by() - Adaptive::decided_by() == Stage_counts{}));
  }).join();
}

BOOST_AUTO_TEST_SUITE_END()
