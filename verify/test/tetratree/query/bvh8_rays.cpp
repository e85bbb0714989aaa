#include "tetracone/tetratree/query/bvh8_rays.h"

#include "tetracone/covering/star_faces.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/ray_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_rays)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone::tetratree;
using tetracone::covering::Polyhedron;
using tetracone::covering::Vertex;
using tetracone::verify::Ray_truth;

BOOST_AUTO_TEST_CASE(every_face_is_met_where_the_truth_has_it_and_in_its_order)
{
  scenes::Random random(20262);
  long rays = 0, hits = 0, ties = 0, misses = 0;
  auto bodies = scenes::bodies_of_any_size();
  bodies.push_back({"mesh", scenes::blob(random, 3, 0.8, 1.2)});
  bodies.push_back({"open", scenes::without(scenes::cube(1), [](scenes::Index f) { return f > 3; })});
  for (const auto& [name, body] : bodies) {
    BOOST_TEST_INFO_SCOPE(name);
    const Bvh8 tree(body, tetracone::covering::star_faces(body));
    Bvh8_rays caster(tree);
    const Ray_truth truth(body);
    const std::vector<Vertex> points = scenes::hard_points(body, tree.model().lattice().origin, random);
    std::vector<Ray> asked;
    std::vector<std::optional<Ray_hit>> firsts;
    int wrong = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      // Towards another, or along axes and diagonals.
      const Vertex &from = points[k], &to = points[std::size_t(scenes::integer(random, 0, int(points.size()) - 1))];
      Vertex direction = scenes::grid_vertex(random, 1);
      if (k % 3 != 0)
        for (int i = 0; i < 3; ++i) direction[i] = to[i] - from[i];
      if (direction == Vertex{0, 0, 0}) direction[0] = 1;
      const Ray ray{from, direction};
      std::vector<Ray_hit> expected;
      const auto exact = truth(ray.origin, ray.direction);
      for (const auto& [t, face] : exact) expected.push_back({face, tetracone::kernel::nearest_double(t)});
      asked.push_back(ray);
      firsts.push_back(expected.empty() ? std::nullopt : std::optional(expected.front()));
      wrong += caster.all(ray) != expected || caster.first(ray) != firsts.back();
      ++rays;
      hits += long(expected.size());
      misses += expected.empty();
      ties += exact.size() > 1 && exact[0].first == exact[1].first;
    }
    BOOST_TEST(wrong == 0);
    BOOST_TEST((Bvh8_rays::first_of_each(tree, asked) == firsts));
    // In turns, the last of them fewer than there are; and none at all.
    for (std::size_t count = 0; count <= 20; ++count)
      BOOST_TEST(std::ranges::equal(Bvh8_rays::first_of_each(tree, std::span(asked).first(count)),
                                    std::span(firsts).first(count)));
  }
  BOOST_TEST(hits > rays / 2);
  BOOST_TEST(ties > rays / 20);
  BOOST_TEST(misses > rays / 20);
}

BOOST_AUTO_TEST_CASE(an_end_leaves_what_the_truth_has_up_to_it)
{
  scenes::Random random(20263);
  long kept = 0, dropped = 0, at_end = 0;
  for (const auto& [name, body] : scenes::bodies_of_any_size()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Bvh8 tree(body, tetracone::covering::star_faces(body));
    Bvh8_rays caster(tree);
    const Ray_truth truth(body);
    const std::vector<Vertex> points = scenes::hard_points(body, tree.model().lattice().origin, random);
    int wrong = 0;
    for (std::size_t k = 0; k + 1 < points.size(); k += 2) {
      Vertex direction;
      for (int i = 0; i < 3; ++i) direction[i] = 3 * (points[k + 1][i] - points[k][i]);
      if (direction == Vertex{0, 0, 0} || !std::isfinite(direction[0] + direction[1] + direction[2])) continue;
      const Ray ray{points[k], direction};
      const auto exact = truth(ray.origin, ray.direction);
      // Ends at hits, as doubles round them, and beside them.
      std::vector<double> ends = {0, -1, 0.5, 1e300};
      for (const auto& [t, face] : exact) {
        const double nearest = tetracone::kernel::nearest_double(t);
        for (const double end : {nearest, std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)})
          if (std::isfinite(end)) ends.push_back(end);
      }
      for (const double end : ends) {
        std::vector<Ray_hit> expected;
        for (const auto& [t, face] : exact) {
          if (t <= tetracone::kernel::Rational(end)) expected.push_back({face, tetracone::kernel::nearest_double(t)});
          at_end += t == tetracone::kernel::Rational(end);
        }
        const auto first = expected.empty() ? std::nullopt : std::optional(expected.front());
        wrong += caster.all(ray, end) != expected || caster.first(ray, end) != first ||
                 caster.any(ray, end) == expected.empty();
        kept += long(expected.size());
        dropped += long(exact.size() - expected.size());
      }
      wrong += caster.any(ray) == exact.empty();
    }
    BOOST_TEST(wrong == 0);
  }
  BOOST_TEST(kept > 2000);
  BOOST_TEST(dropped > 2000);
  BOOST_TEST(at_end > 200);
}

BOOST_AUTO_TEST_SUITE_END()
