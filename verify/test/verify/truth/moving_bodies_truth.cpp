#include "verify/truth/moving_bodies_truth.h"

#include "verify/families/moving_body_families.h"
#include "verify/subjects/moving_bodies_subject.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <optional>

BOOST_AUTO_TEST_SUITE(test_moving_bodies_truth)

using namespace tetracone::verify;
using tetracone::kernel::Question;
using tetracone::kernel::Time_bounds;

BOOST_AUTO_TEST_CASE(wrong_first_contacts_are_noticed)
{
  // A tunnelling case with a contact, and what is about it.
  for (std::uint64_t k = 0;; ++k) {
    const Moving_bodies c = moving_bodies_case(*find_named(moving_body_families(), "motion-tunnelling"), 3, k);
    const auto first = first_contact(c, Question::solid);
    if (!first || first->lo == first->hi) continue;
    const auto [lo, hi] = *first;
    for (const std::optional<Time_bounds>& wrong :
         {std::optional<Time_bounds>(), std::optional(Time_bounds{0, 0}), std::optional(Time_bounds{lo, lo}),
          std::optional(Time_bounds{hi, std::nextafter(hi, 2)}), std::optional(Time_bounds{std::nextafter(lo, 0), lo}),
          std::optional(Time_bounds{std::nextafter(lo, 0), hi})})
      BOOST_TEST(!truly_first_by_features(c, Question::solid, wrong));
    BOOST_TEST(truly_first_by_features(c, Question::solid, first));
    for (const std::optional<Time_bounds>& wrong :
         {std::optional<Time_bounds>(), std::optional(Time_bounds{0, 0}), std::optional(Time_bounds{0.75, 0.75})})
      BOOST_TEST((truly_first_by_distances(c, Question::solid, wrong) != Bracket::holds));
    BOOST_TEST((truly_first_by_distances(c, Question::solid, first) == Bracket::holds));
    return;
  }
}

BOOST_AUTO_TEST_CASE(without_a_right_guess_the_first_contact_is_found)
{
  int found = 0, later = 0;
  for (const char* name : {"motion-tunnelling", "motion-one-turns", "motion-at-end", "motion-nested"})
    for (std::uint64_t k = 0; k < 2; ++k) {
      const Moving_bodies c = moving_bodies_case(*find_named(moving_body_families(), name), 5, k);
      const auto first = first_contact(c, Question::surface);
      for (const std::optional<Time_bounds>& guess :
           {std::optional<Time_bounds>(), std::optional(Time_bounds{0.5, 0.5})}) {
        const auto truth = true_first_contact(c, Question::surface, guess);
        BOOST_TEST(truth.has_value() == first.has_value(), name);
        BOOST_TEST((!truth || !first || (truth->lo == first->lo && truth->hi == first->hi)), name);
        ++found;
        later += truth && truth->lo > 0;
      }
    }
  BOOST_TEST(later > found / 4);
}

BOOST_AUTO_TEST_SUITE_END()
