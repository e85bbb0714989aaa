#include "verify/families/probe_families.h"

#include "tetracone/covering/edge_uses.h"
#include "verify/integer_truth/integer_probes.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <string_view>

BOOST_AUTO_TEST_SUITE(test_probe_families)

using namespace tetracone::verify;
using tetracone::kernel::Vertex;

namespace {

bool is_finite(const Vertex& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

/// Returns how many of `cases` cases at this value of the parameter are on the surface.
int on_surface(std::string_view name, double parameter, int cases)
{
  const Probe_family& family = *find_named(point_families(), name);
  int on = 0, asked = 0;
  for (std::uint64_t k = 0; asked < cases; ++k) {
    const Probe_case c = family.probe_case(3, k);
    if (c.origin.parameter != parameter) continue;
    ++asked;
    on += integer_truth::Probed_body(*c.body).where(c.from) == 0;
  }
  return on;
}

}  // namespace

BOOST_AUTO_TEST_CASE(cases_are_legal_and_the_same_each_time)
{
  std::set<std::string_view> names;
  std::set<int> numbers;
  for (const auto* families : {&point_families(), &ray_families()})
    for (const Probe_family& family : *families) {
      BOOST_TEST(names.insert(family.name).second);
      BOOST_TEST(numbers.insert(family.number).second);
      const bool is_ray = families == &ray_families();
      BOOST_TEST(family.name.starts_with(is_ray ? "ray-" : "point-"));
      const Probe_case last = family.probe_case(2, 40), first = family.probe_case(2, 3);
      for (std::uint64_t k = 0; k < 20; ++k) {
        const Probe_case c = family.probe_case(2, k);
        BOOST_TEST(is_finite(c.from));
        BOOST_TEST(is_finite(c.direction));
        BOOST_TEST((c.direction != Vertex{0, 0, 0}) == is_ray, family.name << ' ' << k);
        BOOST_TEST(c.body->face_count() <= Probe_family::most_faces);
        if (!is_ray) BOOST_TEST(tetracone::covering::is_closed(*c.body));
        if (k == 3) BOOST_TEST((c.from == first.from && c.direction == first.direction));
        if (k == 3) BOOST_TEST((c.body->vertices == first.body->vertices));
      }
      BOOST_TEST((family.probe_case(2, 40).from == last.from));
      BOOST_TEST((family.probe_case(2, 32).body == family.probe_case(2, 47).body));
    }
}

BOOST_AUTO_TEST_CASE(points_on_the_surface_are_exactly_there)
{
  BOOST_TEST(on_surface("point-on-vertex", 0, 24) == 24);
  BOOST_TEST(on_surface("point-on-edge", 1, 24) > 12);
  BOOST_TEST(on_surface("point-on-face", 1, 24) > 6);
  BOOST_TEST(on_surface("point-near-surface", 1, 24) < 20);
  BOOST_TEST(on_surface("point-anywhere", 0, 24) == 0);
}

BOOST_AUTO_TEST_CASE(rays_meet_several_faces_at_once_and_miss_others_by_an_ulp)
{
  int ties = 0, misses = 0;
  for (const Probe_family& family : ray_families())
    for (std::uint64_t k = 0; k < 24; ++k) {
      const Probe_case c = family.probe_case(5, k);
      const auto hits = integer_truth::Probed_body(*c.body).hits(c.from, c.direction);
      ties += hits.size() > 1 && hits[0].first == hits[1].first;
      misses += hits.empty();
    }
  BOOST_TEST(ties > 60);
  BOOST_TEST(misses > 15);
}

BOOST_AUTO_TEST_SUITE_END()
