#include "tetracone/kernel/predicate/stage_counts.h"

#include "tetracone/kernel/predicate/adaptive.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_stage_counts)

using namespace tetracone::kernel;
using Stage = Adaptive::Stage;

// Tests of adaptive.cpp say that each stage counts its own signs.

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
