#include "tetracone/tetratree/certificate/group_hull.h"

#include "verify/test/support/object_cases.h"
#include "verify/test/support/suite.h"

#include <cmath>
#include <numeric>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_group_hull)

using namespace tetracone::tetratree;
namespace kernel = tetracone::kernel;
using kernel::Exact_number;
using kernel::Exact_vector;
using namespace tetracone::verify::scenes;

namespace {

/// All groups of a tree.
std::vector<Box_id> groups_of(const Group_tree& tree)
{
  std::vector<Box_id> all = {{}};
  for (std::size_t n = 0; n < all.size(); ++n)
    if (!tree.is_piece(all[n]))
      for (const Box_id member : tree.members(all[n])) all.push_back(member);
  return all;
}

/// Rigid, sheared, nearly singular, far away, and with entries beyond the doubles.
std::vector<std::array<Exact_number, 12>> maps(Random& random)
{
  std::vector<std::array<Exact_number, 12>> maps;
  for (const double size : {1.0, 0x1p-300, 0x1p900})
    for (const double flat : {1.0, 0x1p-45, 0x1p-200})
      for (const double away : {0.0, 1.0, 0x1p45}) {
        std::array<Exact_number, 12> map;
        for (int k = 0; k < 3; ++k)
          for (int c = 0; c < 3; ++c)
            map[4 * k + c] = Exact_number(size) * (Exact_number(1) + Exact_number(flat * real(random, -1, 1)));
        for (int k = 0; k < 3; ++k) map[4 * k + 3] = Exact_number(away * real(random, -1, 1)) * Exact_number(size);
        maps.push_back(map);
      }
  for (Exact_number& entry : maps.emplace_back(maps[0])) entry = entry * Exact_number(0x1p1000) * Exact_number(0x1p300);
  return maps;
}

Exact_vector direction(Random& random, int kind)
{
  Exact_vector m;
  for (Exact_number& x : m) x = Exact_number(integer(random, -3, 3));
  if (kind % 3 == 1)
    for (Exact_number& x : m) x = Exact_number(real(random, -1, 1)) * Exact_number(std::ldexp(1.0, 100 * (kind % 5)));
  if (kind % 3 == 2)  // nearly along the normal of a flat image
    m = {Exact_number(1), Exact_number(-2), Exact_number(1 + std::ldexp(real(random, -1, 1), -40))};
  return m;
}

}  // namespace

BOOST_AUTO_TEST_CASE(extents_of_groups_are_those_of_all_their_corners)
{
  Random random(7);
  int groups_seen = 0, few = 0, all = 0;
  for (const auto& body :
       {blob(random, 3, 0.5, 1.5), torus(9, 5), random_tetrahedra(random, 12, 9), moved(unit_cube(), 1, {0x1p40, 0, 0}),
        box({0, 0, 0}, {1, 1e-6, 1e-12}), moved(blob(random, 2, 1, 1), 0x1p-200)}) {
    const Bvh8 tree(body);
    std::vector<Index> faces(body.face_count());
    std::iota(faces.begin(), faces.end(), Index(0));
    Group_tree groups(tree, faces);
    const auto ids = groups_of(groups);
    const auto of_body = maps(random);
    for (const auto& map : of_body) {
      kernel::Hull_points points(tree.model().vertices(), groups.reach(), map), none;
      kernel::round_together(points, none);
      for (std::size_t n = 0; n < ids.size(); n += 1 + ids.size() / 8) {
        const Group_hull hull(points, groups, ids[n]);
        const auto& corners = groups.group(ids[n]).corners;
        ++groups_seen;
        for (int k = 0; k < 6; ++k) {
          const Exact_vector m = direction(random, k);
          for (const int sign : {-1, 1}) {
            const auto at = [&](std::uint32_t v) {
              return Exact_number(Exact_number(sign) * kernel::dot(m, points.exact(v)));
            };
            Exact_number most = at(corners[0]);
            for (const std::uint32_t v : corners)
              if (const Exact_number x = at(v); x > most) most = x;
            BOOST_TEST((extent_of(hull, m, sign) == Exact_number(sign) * most));
            if (&map != &of_body.front() || n > 0) continue;
            hull.for_last(m, sign, [&](std::uint32_t) { ++few; });
            all += int(corners.size());
          }
        }
      }
    }
  }
  BOOST_TEST(groups_seen > 500);
  BOOST_TEST(2 * few < all);
}

BOOST_AUTO_TEST_CASE(the_last_corner_is_last_among_all_up_to_rounding)
{
  Random random(8);
  const auto body = blob(random, 4, 0.5, 1.5);
  const Bvh8 tree(body);
  std::vector<Index> faces(body.face_count());
  std::iota(faces.begin(), faces.end(), Index(0));
  Group_tree groups(tree, faces);
  for (const auto& map : maps(random)) {
    kernel::Hull_points points(tree.model().vertices(), groups.reach(), map), none;
    kernel::round_together(points, none);
    for (const Box_id id : groups_of(groups)) {
      const Group_hull hull(points, groups, id);
      const kernel::Rounded_vector way = {real(random, -1, 1), real(random, -1, 1), real(random, -1, 1)};
      const auto at = [&](std::uint32_t v) { return kernel::dot(way, points.rounded(v)); };
      const std::vector<std::uint32_t> known = {groups.group(id).corners.back()};
      double most = -HUGE_VAL;
      for (const std::uint32_t v : groups.group(id).corners) most = kernel::maximum(most, at(v));
      const double off = 0x1p-44 * 3 * points.largest();
      BOOST_TEST(at(hull.last(way)) >= most - off);
      BOOST_TEST(at(hull.last(way, known)) >= most - off);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
