#include "tetracone/covering/model.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_model)

using namespace tetracone::covering;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using namespace tetracone::verify::scenes;

using Exact_motions = std::tuple<Rational_kernel, Adaptive>;
using Vertex_kernels = std::tuple<Double, Epick, Rational_kernel, Adaptive>;

// The exact image of a placed point.
template <class K>
rationals::Vector exactly(const Point<K>& p)
{
  if constexpr (std::is_same_v<K, Adaptive>)
    return p.pose == nullptr ? rationals::exactly(p.vertex) : rationals::image(*p.pose, rationals::exactly(p.vertex));
  else
    return {Rational(p.x()), Rational(p.y()), Rational(p.z())};
}

KERNEL_TEST_CASE(a_model_has_the_vertices_as_points_and_its_origin_in_its_lattice, K, Vertex_kernels)
{
  for (const auto& [name, body] : closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Model<K> model(body);
    BOOST_TEST(model.face_count() == body.face_count());
    BOOST_REQUIRE(model.vertices().size() == body.vertices.size());
    for (Index v = 0; v < body.vertices.size(); ++v)
      BOOST_TEST((exactly<K>(model.point(v)) == rationals::exactly(body.vertices[v])));
    BOOST_TEST((exactly<K>(model.origin()) == rationals::exactly(model.lattice().origin)));
  }
}

KERNEL_TEST_CASE(placed_points_are_the_exact_images_pose_after_pose, K, Exact_motions)
{
  Random random(1);
  const Polyhedron body = cube_with_tunnel();
  const Model<K> model(body);
  Placed_model<K> placed(model);
  std::vector<Pose> poses;
  for (int n = 0; n < 10; ++n) {
    poses.push_back(random_rotation(random, 5, {Rational(1) / Rational(3), 2, n}));
    poses.push_back(rounded(poses.back()));
    poses.push_back(random_affine(random));
    poses.push_back(Pose());
  }
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Pose& pose = poses[k];
    placed.place(pose);
    BOOST_TEST(placed.determinant_sign() == pose.determinant_sign());
    int wrong = 0;
    const Index skip = k % 3;      // what is not asked for at one pose is placed at the next
    for (const int pass : {1, 2})  // the second from what the first kept
      for (Index v = 0; v < body.vertices.size(); v += pass + skip)
        wrong += exactly<K>(placed.point(v)) != rationals::image(pose, rationals::exactly(body.vertices[v]));
    BOOST_TEST(wrong == 0);
  }
}

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
