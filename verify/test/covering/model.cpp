#include "tetracone/covering/model.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_model)

using namespace tetracone::covering;
using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using Exact_motions = std::tuple<Rational_kernel, Adaptive>;

KERNEL_TEST_CASE(signs_of_placed_points_are_those_of_their_pose, K, Exact_motions)
{
  // The moved corner is on the plane x = 1 of the cube that stays, then beside it by less than doubles tell.
  const Model<K> model(unit_cube());
  Placed_model<K> moved(model), fixed(model);
  std::vector<Pose> poses;
  for (const double shift : {0.0, 0x1p-80, -0x1p-80, 0.0}) {
    const Rational c(3, 5), s(4, 5);
    poses.push_back(Pose(std::array<Rational, 12>{c, -s, 0, 1 + Rational(shift), s, c, 0, Rational(1, 3), 0, 0, 1, 0}));
  }
  std::vector<Index> wall;  // x = 1
  Index corner = 0;         // the origin
  for (Index v = 0; v < model.vertices().size(); ++v) {
    if (model.vertices()[v][0] == 1) wall.push_back(v);
    if (model.vertices()[v] == Vertex{0, 0, 0}) corner = v;
  }
  for (const Pose& pose : poses) {
    moved.place(pose);
    const Rational side = pose.exact(3) - 1;
    const Sign outside = volume_sign<K>(fixed.point(wall[0]), fixed.point(wall[1]), fixed.point(wall[2]),
                                        moved.point(corner)),
               inside = volume_sign<K>(fixed.point(wall[0]), fixed.point(wall[1]), fixed.point(wall[2]),
                                       fixed.point(corner));
    BOOST_TEST(inside != ZERO);
    BOOST_TEST(outside == -inside * CGAL::sign(side));
  }
}

BOOST_AUTO_TEST_SUITE_END()
