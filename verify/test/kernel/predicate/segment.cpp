#include "tetracone/kernel/predicate/segment.h"

#include "tetracone/kernel/predicate/frame.h"
#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/segment_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_segment)

using namespace tetracone::kernel;
namespace scenes = tetracone::verify::scenes;

namespace {

using Kernels = std::tuple<Float, Double, Tolerant, Epick, Epeck, Rational_kernel, Adaptive>;
using Four = std::array<Vertex, 4>;

template <class K>
Contact contact(const Four& v)
{
  return segment_segment<K>(point<K>(v[0]), point<K>(v[1]), point<K>(v[2]), point<K>(v[3]));
}

/// A face of two corners is its edge.
Contact truth(const Four& v) { return scenes::true_contact(v[0], v[1], {{v[2], v[3]}}); }

struct Known {
  Four segments;
  Contact contact;
};

/// Every quadruple of a 3x3 grid of an oblique plane, in any order of ends and segments.
const std::vector<Known>& known()
{
  static const std::vector<Known> all = [] {
    std::vector<Known> found;
    for (int n = 0; n < 9 * 9 * 9 * 9; ++n) {
      Four v;
      for (int k = 0, rest = n; k < 4; ++k, rest /= 9) {
        const double s = rest % 3, t = rest / 3 % 3;
        v[std::size_t(k)] = {s - t, 2 * t, s};
      }
      found.push_back({v, truth(v)});
    }
    return found;
  }();
  return all;
}

}  // namespace

KERNEL_TEST_CASE(a_point_of_the_line_is_located_on_the_segment, K, Kernels)
{
  int wrong = 0;
  for (const Vertex& d : {Vertex{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 1, -2}, {-1, 2, 1}})
    for (int p = -2; p <= 2; ++p)
      for (int a = -2; a <= 2; ++a)
        for (int b = -2; b <= 2; ++b) {
          const auto at = [&](int k) { return point<K>(Vertex{1 + k * d[0], 2 + k * d[1], k * d[2]}); };
          const On_segment right = p == a                                 ? On_segment::first_end
                                   : p == b                               ? On_segment::second_end
                                   : (a < p && p < b) || (b < p && p < a) ? On_segment::inside
                                                                          : On_segment::outside;
          wrong += locate_on_segment<K>(at(p), at(a), at(b)) != right;
        }
  BOOST_TEST(wrong == 0);
}

KERNEL_TEST_CASE(all_segments_of_a_small_grid_meet_as_integers_say, K, Kernels)
{
  std::map<Contact, int> seen;
  int wrong = 0;
  for (const auto& [segments, expected] : known()) {
    wrong += contact<K>(segments) != expected;
    ++seen[expected];
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(seen.size() == 5u);
}

BOOST_AUTO_TEST_CASE(every_kind_has_its_own_word)
{
  std::vector<std::string_view> words;
  for (int k = 0; k <= int(Contact::coplanar_overlap); ++k) words.push_back(to_string(Contact(k)));
  std::sort(words.begin(), words.end());
  BOOST_TEST((std::unique(words.begin(), words.end()) == words.end()));
}

BOOST_AUTO_TEST_SUITE_END()
