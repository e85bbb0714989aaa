#include "tetracone/tetratree/scene/large_pages.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_large_pages)

using tetracone::tetratree::Large_vector;

BOOST_AUTO_TEST_CASE(a_vector_keeps_its_elements_as_it_grows_from_small_pages_to_large_ones)
{
  struct alignas(32) Wide {
    std::size_t number;
  };
  Large_vector<Wide> all;
  for (std::size_t k = 0; k < 300000; ++k) all.push_back({k});
  BOOST_TEST(reinterpret_cast<std::uintptr_t>(all.data()) % (std::size_t(1) << 21) == 0u);
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < all.size(); ++k) wrong += all[k].number != k;
  BOOST_TEST(wrong == 0u);
  all.resize(3);
  all.shrink_to_fit();
  BOOST_TEST(all.back().number == 2u);
  const Large_vector<Wide> moved = std::move(all);
  BOOST_TEST(moved.size() == 3u);
}

BOOST_AUTO_TEST_CASE(more_than_there_is_is_refused)
{
  tetracone::tetratree::On_large_pages<double> memory;
  BOOST_CHECK_THROW(memory.allocate(std::numeric_limits<std::size_t>::max() / 8), std::bad_alloc);
  BOOST_CHECK_THROW(memory.allocate(std::numeric_limits<std::size_t>::max() / 17), std::bad_alloc);
}

BOOST_AUTO_TEST_SUITE_END()
