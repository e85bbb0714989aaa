#include "tetracone/covering/inclusion.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/point_truth.h"

#include <boost/test/unit_test.hpp>

#include <set>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_inclusion)

using namespace tetracone::covering;
using namespace tetracone::kernel;
namespace scenes = tetracone::verify::scenes;
using scenes::Random;

namespace {

using Exact_motions = std::tuple<Epeck, Rational_kernel, Adaptive>;

/// A point, and its place: 1 inside, 0 on the surface, -1 outside.
struct Known_point {
  Vertex at;
  int place;
};

struct Known_body {
  std::string name;
  Polyhedron body;
  std::vector<Known_point> points;
};

/// Every kind of body with its hard points.
const std::vector<Known_body>& known_bodies()
{
  static const std::vector<Known_body> bodies = [] {
    Random random(2);
    std::vector<Known_body> bodies;
    for (const auto& [name, body] : scenes::closed_bodies()) {
      bodies.push_back({name, body, {}});
      const tetracone::verify::Point_truth truth(body);
      for (const Vertex& p : scenes::hard_points(body, Model<Adaptive>(body).lattice().origin, random))
        bodies.back().points.push_back({p, truth(p)});
    }
    return bodies;
  }();
  return bodies;
}

}  // namespace

KERNEL_TEST_CASE(points_are_where_rays_say_and_winding_numbers_turn_their_sign_with_the_pose, K, Exact_motions)
{
  Random random(3);
  std::set<int> seen;
  for (const auto& [name, body, points] : known_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Model<K> model(body);
    Placed_model<K> placed(model);
    std::vector<Pose> poses = {Pose(), scenes::random_affine(random), scenes::random_rotation(random),
                               scenes::rounded(scenes::random_rotation(random)),
                               Pose(std::array<double, 12>{-1, 0, 0, 0x1p50, 0, 1, 0, 0x1p-50, 0, 0, 1, 0.1})};
    std::vector<int> first(points.size());
    for (const Pose& pose : poses) {
      placed.place(pose);
      const Frame<K> frame(pose);
      int wrong = 0;
      for (std::size_t n = 0; n < points.size(); n += 4) {
        const Point<K> q = frame(point<K>(points[n].at));
        wrong += int(locate<K>(q, placed)) != points[n].place;
        if (points[n].place == 0) continue;
        const int winding = winding_number<K>(q, placed);
        if (pose.is_identity()) seen.insert(first[n] = winding);
        wrong += winding != first[n] * int(pose.determinant_sign()) || (winding != 0) != (points[n].place > 0);
      }
      BOOST_TEST(wrong == 0);
    }
  }
  BOOST_TEST(seen.contains(-1));
  BOOST_TEST(seen.contains(0));
  BOOST_TEST(seen.contains(1));
  BOOST_TEST(seen.contains(2));
}

KERNEL_TEST_CASE(a_tetrahedron_of_the_covering_holds_a_point_with_its_own_sign, K, Exact_motions)
{
  const auto at = [](double x, double y, double z) { return point<K>({x, y, z}); };
  const auto o = at(0, 0, 0), x = at(4, 0, 0), y = at(0, 4, 0), z = at(0, 0, 4);
  BOOST_TEST(signed_inclusion<K>(at(1, 1, 1), o, x, y, z) == 1);
  BOOST_TEST(signed_inclusion<K>(at(1, 1, 1), o, y, x, z) == -1);
  BOOST_TEST(signed_inclusion<K>(at(3, 3, 3), o, x, y, z) == 0);
  BOOST_TEST(signed_inclusion<K>(at(1, 1, 1), o, x, y, at(1, 1, 0)) == 0);  // flat
  // On its border: the point moved by (e, e^2, e^3) is in exactly one of the two tetrahedra on the two sides.
  const auto below = at(0, 0, -4);
  for (const auto& p : {at(1, 1, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 0)}) {
    BOOST_TEST(signed_inclusion<K>(p, o, x, y, z) == 1);
    BOOST_TEST(signed_inclusion<K>(p, o, y, x, below) == 0);
  }
  BOOST_TEST(signed_inclusion<K>(at(4, 0, 0), o, x, y, z) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
