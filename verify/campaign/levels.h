#ifndef TETRACONE_VERIFY_CAMPAIGN_LEVELS_H
#define TETRACONE_VERIFY_CAMPAIGN_LEVELS_H

#include "verify/campaign/findings.h"
#include "verify/families/distance_families.h"
#include "verify/families/families.h"
#include "verify/families/moving_body_families.h"
#include "verify/families/probe_families.h"
#include "verify/families/scene_families.h"
#include "verify/relations/relations.h"

#include <cstdint>
#include <string_view>
#include <tuple>
#include <vector>

namespace tetracone::verify {

/// Cases per family, of all levels that name the member. Default sizes take a few minutes on two cores. 0 skips them.
struct Sizes {
  std::uint64_t predicate_cases = 400, object_cases = 24, feature_cases = 6, probe_cases = 64;
};

template <class Level>
struct Job;

/// Returns pointers to all families of the lists.
template <class... Families>
auto pointers(const Families&... lists)
{
  std::vector<const typename std::tuple_element_t<0, std::tuple<Families...>>::value_type*> all;
  const auto add = [&all](const auto& list) {
    for (const auto& family : list) all.push_back(&family);
  };
  (add(lists), ...);
  return all;
}

/// The levels of campaigns. A level has its types, its name in the database, its families and subjects, and a judge. It
/// also has the number of cases that one thread is given at once. The judge is the level's page: `..._level.cpp`, or
/// for several levels `list_levels.cpp` and `probe_levels.cpp`.
namespace levels {

struct Predicates : Predicate_level {
  static constexpr std::string_view name = "predicate";
  static constexpr auto size = &Sizes::predicate_cases;
  static constexpr std::uint64_t batch = 200;
  using Family = verify::Family;
  using Subject = Predicate_subject;
  static std::vector<const Family*> families() { return pointers(verify::families()); }
  static std::vector<Subject> subjects() { return predicate_subjects(); }
  static Case make(const Family& family, std::uint64_t seed, std::uint64_t k) { return family.predicate_case(seed, k); }
  static Findings judge(const Job<Predicates>& job);
};

/// The common part of levels whose cases are two bodies.
template <class Types>
struct Of_two_bodies : Types {
  static constexpr auto size = &Sizes::feature_cases;
  static constexpr std::uint64_t batch = 3;
  using Family = verify::Family;
  using Subject = Object_subject;
  static std::vector<const Family*> families() { return pointers(verify::families()); }
  static Object_case make(const Family& family, std::uint64_t seed, std::uint64_t k)
  {
    return family.object_case(seed, k);
  }
};

struct Objects : Of_two_bodies<Object_level> {
  static constexpr std::string_view name = "object";
  static constexpr auto size = &Sizes::object_cases;
  static constexpr std::uint64_t batch = 10;
  static std::vector<Subject> subjects() { return object_subjects(); }
  static Findings judge(const Job<Objects>& job);
};

struct Features : Of_two_bodies<Feature_level> {
  static constexpr std::string_view name = "features";
  static std::vector<Subject> subjects() { return feature_subjects(); }
  static Findings judge(const Job<Features>& job);
};

struct Contacts : Of_two_bodies<Contact_level> {
  static constexpr std::string_view name = "contacts";
  static std::vector<Subject> subjects() { return contact_subjects(); }
  static Findings judge(const Job<Contacts>& job);
};

struct Distances : Of_two_bodies<Distance_level> {
  static constexpr std::string_view name = "distances";
  static std::vector<const Family*> families() { return pointers(verify::families(), distance_families()); }
  static std::vector<Subject> subjects() { return distance_subjects(); }
  static Findings judge(const Job<Distances>& job);
};

/// The common part of levels whose cases are one body and a point or ray.
template <class Types>
struct Of_probes : Types {
  static constexpr auto size = &Sizes::probe_cases;
  static constexpr std::uint64_t batch = 4 * Probe_family::cases_a_body;
  using Family = Probe_family;
  using Subject = Subject_of<typename Types::Running>;
  static Probe_case make(const Family& family, std::uint64_t seed, std::uint64_t k)
  {
    return family.probe_case(seed, k);
  }
};

struct Points : Of_probes<Point_level> {
  static constexpr std::string_view name = "points";
  static std::vector<const Family*> families() { return pointers(point_families()); }
  static std::vector<Subject> subjects() { return point_subjects(); }
  static Findings judge(const Job<Points>& job);
};

struct Rays : Of_probes<Ray_level> {
  static constexpr std::string_view name = "rays";
  static std::vector<const Family*> families() { return pointers(ray_families()); }
  static std::vector<Subject> subjects() { return ray_subjects(); }
  static Findings judge(const Job<Rays>& job);
};

struct Scenes : Scene_level {
  static constexpr std::string_view name = "scenes";
  static constexpr auto size = &Sizes::feature_cases;
  static constexpr std::uint64_t batch = 1;
  using Family = Scene_family;
  using Subject = Scene_subject;
  static std::vector<const Family*> families() { return pointers(scene_families()); }
  static std::vector<Subject> subjects() { return scene_subjects(); }
  static Case make(const Family& family, std::uint64_t seed, std::uint64_t k) { return family.scene_case(seed, k); }
  static Findings judge(const Job<Scenes>& job);
};

struct Motions : Motion_level {
  static constexpr std::string_view name = "motions";
  static constexpr auto size = &Sizes::feature_cases;
  static constexpr std::uint64_t batch = 4;
  using Family = Moving_body_family;
  using Subject = Moving_bodies_subject;
  static std::vector<const Family*> families() { return pointers(moving_body_families()); }
  static std::vector<Subject> subjects() { return moving_bodies_subjects(); }
  static Case make(const Family& family, std::uint64_t seed, std::uint64_t k)
  {
    return moving_bodies_case(family, seed, k);
  }
  static Findings judge(const Job<Motions>& job);
};

struct Relations : Of_two_bodies<Solid_level> {
  static constexpr std::string_view name = "relations";
  static std::vector<Subject> subjects() { return solid_subjects(); }
  static Findings judge(const Job<Relations>& job);
};

struct Exits : Of_two_bodies<Exit_level> {
  static constexpr std::string_view name = "exits";
  static std::vector<Subject> subjects() { return solid_subjects(); }
  static Findings judge(const Job<Exits>& job);
};

}  // namespace levels

/// A level's part of a campaign.
template <class Level>
struct Asked {
  bool is_asked = true;
  std::vector<const typename Level::Family*> families;
  std::vector<typename Level::Subject> subjects;
};

/// Some<Level> for every level, in the order in which they are asked.
template <template <class> class Some>
using For_levels =
    std::tuple<Some<levels::Predicates>, Some<levels::Objects>, Some<levels::Features>, Some<levels::Contacts>,
               Some<levels::Distances>, Some<levels::Points>, Some<levels::Rays>, Some<levels::Scenes>,
               Some<levels::Motions>, Some<levels::Relations>, Some<levels::Exits>>;

/// Calls visit(Some<Level>) for every level.
template <class Parts, class Visit>
void for_each_level(Parts&& parts, const Visit& visit)
{
  std::apply([&visit](auto&... part) { (visit(part), ...); }, parts);
}

}  // namespace tetracone::verify

#endif
