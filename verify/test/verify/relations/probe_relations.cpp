#include "verify/relations/probe_relations.h"

#include "verify/families/probe_families.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

BOOST_AUTO_TEST_SUITE(test_probe_relations)

using namespace tetracone::verify;

namespace {

/// Answers the body of the case as the subject does, and any other one wrongly.
class Lies_of_twins : public Running_probe {
 public:
  Lies_of_twins(Running_probe& honest, const Probe_case& c) : honest_(honest), case_(c) {}

  std::optional<int> where(const Probe_case& c) override
  {
    const auto place = honest_.where(c);
    return c.body == case_.body ? place : std::optional(*place == 1 ? -1 : *place + 1);
  }
  std::optional<Told_hits> hits(const Probe_case& c) override
  {
    auto told = honest_.hits(c);
    if (is_case(c)) return told;
    told->all.clear();
    return told;
  }

 private:
  bool is_case(const Probe_case& c) const
  {
    return c.body == case_.body && c.from == case_.from && c.direction == case_.direction;
  }

  Running_probe& honest_;
  const Probe_case& case_;
};

struct Tried {
  int held = 0, noticed = 0;
};

template <class Families, class Relations>
std::map<std::string_view, Tried> try_all(const Families& families, const Relations& relations, Running_probe& subject)
{
  std::map<std::string_view, Tried> tried;
  for (const Probe_family& family : families)
    for (std::uint64_t k = 0; k < 3; ++k) {
      const Probe_case c = family.probe_case(6, 5 * k);
      Lies_of_twins lies(subject, c);
      for (const Probe_relation& relation : relations) {
        Random random(k), same(k);
        const Verdict verdict = relation.check(c, subject, random);
        BOOST_TEST((verdict != Verdict::violated), relation.name << ", " << family.name << ' ' << 5 * k);
        tried[relation.name].held += verdict == Verdict::holds;
        tried[relation.name].noticed += relation.check(c, lies, same) == Verdict::violated;
      }
    }
  return tried;
}

}  // namespace

BOOST_AUTO_TEST_CASE(relations_of_points_hold_and_are_violated_by_lies)
{
  const auto tried = try_all(point_families(), point_relations(), *point_subjects()[0].make());
  BOOST_TEST(tried.size() == point_relations().size());
  for (const auto& [name, t] : tried) {
    BOOST_TEST(t.held > 8, name);
    BOOST_TEST(t.noticed == t.held, name);
  }
}

BOOST_AUTO_TEST_CASE(relations_of_rays_hold_and_are_violated_by_lies)
{
  const auto tried = try_all(ray_families(), ray_relations(), *ray_subjects()[0].make());
  BOOST_TEST(tried.size() == ray_relations().size());
  for (const auto& [name, t] : tried) {
    BOOST_TEST(t.held > 8, name);
    if (name != "R1 first") BOOST_TEST(t.noticed > t.held / 8, name);  // of rays that meet something
  }
}

BOOST_AUTO_TEST_CASE(hits_out_of_order_are_noticed)
{
  class Backwards : public Running_probe {
   public:
    std::optional<Told_hits> hits(const Probe_case&) override
    {
      return Told_hits{Ray_hit{0, 1.0}, {Ray_hit{0, 1.0}, Ray_hit{1, 0.5}}};
    }
  };
  class Another_first : public Running_probe {
   public:
    std::optional<Told_hits> hits(const Probe_case&) override { return Told_hits{Ray_hit{2, 1.0}, {Ray_hit{0, 1.0}}}; }
  };
  const Probe_case c = ray_families()[0].probe_case(1, 0);
  Backwards backwards;
  Another_first another;
  Random random(1);
  BOOST_TEST_REQUIRE(ray_relations()[0].name == "R1 first");
  BOOST_TEST((ray_relations()[0].check(c, backwards, random) == Verdict::violated));
  BOOST_TEST((ray_relations()[0].check(c, another, random) == Verdict::violated));
}

BOOST_AUTO_TEST_SUITE_END()
