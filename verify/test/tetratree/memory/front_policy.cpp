#include "tetracone/tetratree/memory/front_policy.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>

BOOST_AUTO_TEST_SUITE(test_front_policy)

using tetracone::tetratree::Front_policy;

namespace {

/// A run of poses: a descent opens a fixed number of boxes. One that follows a front opens `growth` more for each pose
/// since the front was made.
struct Run {
  std::size_t made = 0, followed = 0, plain = 0;
  double cost = 0;

  Run(int poses, double descent, double following, double growth)
  {
    Front_policy policy;
    bool holds = false;
    int age = 0;
    for (int k = 0; k < poses; ++k) {
      if (holds && (policy.is_worn() || !policy.is_worth(std::size_t(following)))) {
        policy.ended();
        holds = false;
      }
      if (holds) {
        ++followed;
        const double now = following + growth * ++age;
        policy.followed(now);
        cost += now;
      } else if (policy.makes_front()) {
        ++made;
        policy.made(descent);
        holds = true;
        age = 0;
        cost += Front_policy::making * descent;
      } else {
        ++plain;
        cost += descent;
      }
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_front_that_does_not_wear_is_made_once)
{
  const Run run(1000, 60, 3, 0);
  BOOST_TEST(run.made == 1u);
  BOOST_TEST(run.followed == 999u);
}

BOOST_AUTO_TEST_CASE(one_that_wears_is_renewed_at_about_the_least_cost)
{
  // A front kept for n poses costs (1.8 * 64 + 3 n + growth n^2 / 2) / n per pose, least at n = sqrt(2 * 115 / growth).
  const Run run(10000, 60, 3, 0.1);
  BOOST_TEST(run.plain == 0u);
  const double best = 10000 * (3 + 2 * 115 / 48);
  BOOST_TEST(run.cost < 1.1 * best);
  BOOST_TEST(run.cost > 0.9 * best);
}

BOOST_AUTO_TEST_CASE(one_that_does_not_pay_is_hardly_ever_made)
{
  for (const double following : {30.0, 58.0, 100.0}) {
    const Run run(4000, 60, following, 8);
    BOOST_TEST_MESSAGE(following << ": " << run.cost / (4000 * 60));
    if (following > 50) BOOST_TEST(run.made < 90u);
    BOOST_TEST(run.cost < 1.03 * 4000 * 60);
  }
}

BOOST_AUTO_TEST_SUITE_END()
