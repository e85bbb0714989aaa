#include "tetracone/tetratree/query/bvh8_rays.h"

#include "tetracone/covering/star_faces.h"
#include "verify/test/support/locator_scenes.h"
#include "verify/truth/ray_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_rays)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone::tetratree;
using tetracone::covering::Polyhedron;
using tetracone::covering::Vertex;
using tetracone::kernel::Rational;
using tetracone::verify::Ray_truth;

namespace {

/// A ray through, along, in or beside what the body is made of.
Ray degenerate_ray(scenes::Random& random, const Polyhedron& body, const Vertex& origin)
{
  const auto point = [&] { return scenes::degenerate_point(random, body, origin); };
  Vertex from = point(), to = point(), direction;
  if (scenes::integer(random, 0, 2) == 0) {
    const Index f = Index(scenes::integer(random, 0, int(body.face_count()) - 1));
    const auto loop = body.loop(f, 0);
    from = body.vertices[loop[0]];
    to = body.vertices[loop[std::size_t(scenes::integer(random, 0, int(loop.size()) - 1))]];
  }
  for (int k = 0; k < 3; ++k) direction[k] = to[k] / 2 - from[k] / 2;
  switch (scenes::integer(random, 0, 5)) {
    case 0: direction = scenes::grid_vertex(random, 1); break;
    case 1: direction = scenes::grid_vertex(random, 3); break;
    case 2:  // from before the first point, exactly so where sums are exact
      for (int k = 0; k < 3; ++k) from[k] -= 2 * direction[k];
      break;
    case 3:
      for (double& x : direction) x = std::ldexp(x, scenes::integer(random, -2, 2) * 100);
      break;
    default:;
  }
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(direction[k])) direction[k] = 1;
    if (!std::isfinite(from[k])) from[k] = 0;
  }
  if (direction == Vertex{0, 0, 0}) direction[0] = 1;
  return {from, direction};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_face_is_met_where_the_truth_has_it_and_in_its_order)
{
  scenes::Random random(20262);
  long rays = 0, wrong = 0, hits = 0, ties = 0, misses = 0;
  auto bodies = scenes::locator_bodies(random);
  bodies.push_back({"open", scenes::without(scenes::cube(1), [](scenes::Index f) { return f > 3; })});
  for (const auto& [name, body] : bodies) {
    const Bvh8 tree(body, tetracone::covering::star_faces(body));
    Bvh8_rays caster(tree);
    const Ray_truth truth(body);
    std::vector<Ray> asked;
    std::vector<std::optional<Ray_hit>> firsts;
    for (int k = 0; k < 8 * scenes::rounds(); ++k) {
      const Ray ray = degenerate_ray(random, body, tree.model().lattice().origin);
      std::vector<Ray_hit> expected;
      const auto exact = truth(ray.origin, ray.direction);
      for (const auto& [t, face] : exact) expected.push_back({face, tetracone::kernel::nearest_double(t)});
      const auto found = caster.all(ray);
      const auto first = caster.first(ray);
      const bool right = found == expected && first.has_value() == !expected.empty() &&
                         (expected.empty() || *first == expected.front());
      asked.push_back(ray);
      firsts.push_back(expected.empty() ? std::nullopt : std::optional(expected.front()));
      ++rays;
      wrong += !right;
      hits += long(expected.size());
      misses += expected.empty();
      ties += exact.size() > 1 && exact[0].first == exact[1].first;
      if (!right)
        BOOST_TEST(right, name << ": from " << ray.origin[0] << " " << ray.origin[1] << " " << ray.origin[2]
                               << " towards " << ray.direction[0] << " " << ray.direction[1] << " " << ray.direction[2]
                               << ": " << found.size() << " for " << expected.size());
    }
    BOOST_TEST((Bvh8_rays::first_of_each(tree, asked) == firsts), name);
  }
  BOOST_TEST_MESSAGE(rays << " rays, " << wrong << " wrong, " << hits << " hits, " << ties << " ties, " << misses
                          << " misses");
  BOOST_TEST(wrong == 0);
  BOOST_TEST(hits > rays / 2);
  BOOST_TEST(ties > rays / 20);
  BOOST_TEST(misses > rays / 20);
}

BOOST_AUTO_TEST_CASE(a_mesh_of_many_triangles_answers_as_all_of_them_do)
{
  scenes::Random random(3);
  const Polyhedron body = scenes::blob(random, 3, 0.8, 1.2);
  const Bvh8 tree(body);
  Bvh8_rays caster(tree);
  const Ray_truth truth(body);
  std::vector<Ray> asked;
  std::vector<std::optional<Ray_hit>> firsts;
  for (int k = 0; k < 20 * scenes::rounds(); ++k) {
    const Ray ray{scenes::real_vertex(random, 2), scenes::real_vertex(random, 1)};
    std::vector<Ray_hit> expected;
    for (const auto& [t, face] : truth(ray.origin, ray.direction))
      expected.push_back({face, tetracone::kernel::nearest_double(t)});
    asked.push_back(ray);
    firsts.push_back(expected.empty() ? std::nullopt : std::optional(expected.front()));
    BOOST_TEST((caster.all(ray) == expected));
    BOOST_TEST((caster.first(ray) == firsts.back()));
  }
  // In turns, the last of them fewer than there are; and none at all.
  for (std::size_t count = 0; count <= asked.size(); ++count) {
    const auto some = Bvh8_rays::first_of_each(tree, std::span(asked).first(count));
    BOOST_TEST(std::equal(some.begin(), some.end(), firsts.begin(), firsts.begin() + std::ptrdiff_t(count)));
  }
}

BOOST_AUTO_TEST_SUITE_END()
