#include "tetracone/tetratree/query/bvh8_containment.h"

#include "tetracone/covering/repair/repair.h"
#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_bvh8_containment)

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace kernel = tetracone::kernel;
using namespace tetracone::verify::scenes;
using kernel::Adaptive;

namespace {

/// Both ways of making a tree: whole faces, and triangles.
struct Body {
  explicit Body(const Polyhedron& p) : whole(p), triangles(p, covering::triangulate_faces(p)) {}
  Bvh8 whole, triangles;
};

struct Placed_pair {
  Placed_pair(Bvh8& holder_tree, const Pose& of_holder, Bvh8& held_tree, const Pose& of_held)
      : pose_holder(of_holder), pose_held(of_held), holder(holder_tree), held(held_tree)
  {
    holder.placed.place(pose_holder);
    held.placed.place(pose_held);
    holder.into_other = kernel::Box_map(pose_held, held_tree.scale(), pose_holder, holder_tree.scale());
    held.into_other = kernel::Box_map(pose_holder, holder_tree.scale(), pose_held, held_tree.scale());
  }
  Pose pose_holder, pose_held;
  Placed_bvh8<> holder, held;
};

/// By the whole covering: some shell's vertex has a winding number that is not 0.
bool truth(Placed_pair& pair)
{
  for (const Index v : pair.held.tree->model().covering().shell_vertices())
    if (covering::winding_number<Adaptive>(pair.held.placed.point(v), pair.holder.placed) != 0) return true;
  return false;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_vertex_at_the_coverings_origin_or_a_hair_off_it_is_decided)
{
  // The ray has no direction there. The cases include a body with a cavity about its origin.
  Bvh8_containment<> containment;
  for (const Polyhedron& shape : {cube(3), cube_with_cavity(), turned(cube(3))}) {
    Body holder(shape);
    const Vertex origin = holder.whole.model().lattice().origin;
    for (const double off : {0.0, 0x1p-1074, 0x1p-300, 0x1p-60, 0x1p-30, -0x1p-21, -0x1p-19, 0x1p-10})
      for (const Pose& pose : {Pose(), Pose::from_quaternion(1, 2, 3, 4),
                               Pose(std::array<double, 12>{-2, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1, 0})}) {
        Body held(polygon({{origin[0] + off, origin[1] - off, origin[2]}}));
        for (Bvh8* tree : {&holder.whole, &holder.triangles}) {
          Placed_pair pair(*tree, pose, held.whole, pose);
          Query_statistics counts;
          BOOST_TEST(containment(pair.holder, pair.held, counts) == truth(pair));
          BOOST_TEST(counts.inclusion_tests == 1u);
        }
      }
  }
}

BOOST_AUTO_TEST_CASE(what_is_outside_of_the_box_is_not_looked_for)
{
  Body holder(cube_with_tunnel()), held(unit_cube());
  Bvh8_containment<> containment;
  Placed_pair far(holder.triangles, Pose(), held.triangles, translation(100, 0, 0)),
      inside(holder.triangles, Pose(), held.triangles, translation(-2.75, -2.75, -2.75));
  Query_statistics of_far, of_inside;
  BOOST_TEST(!containment(far.holder, far.held, of_far));
  BOOST_TEST(of_far.inclusion_tests == 0u);
  BOOST_TEST(containment(inside.holder, inside.held, of_inside));
  BOOST_TEST(of_inside.inclusion_tests == 1u);
  BOOST_TEST(of_inside.box_tests > 0u);
}

BOOST_AUTO_TEST_CASE(a_ray_meets_few_of_many_faces)
{
  Random random(2);
  Bvh8 blob_tree(blob(random, 5, 1, 1.1));
  Body held(cube(0.125));
  blob_tree.make_all();
  Bvh8_containment<> containment;
  Query_statistics counts;
  for (int k = 0; k < 20; ++k) {
    Placed_pair pair(blob_tree, Pose(), held.triangles,
                     random_rotation(random, 5, {Rational(1) / 3, Rational(1) / 5, 0}));
    BOOST_TEST(containment(pair.holder, pair.held, counts));
  }
  BOOST_TEST(counts.inclusion_tests == 20u);
  BOOST_TEST(counts.box_tests < 20u * blob_tree.element_count() / 4);
}

BOOST_AUTO_TEST_CASE(where_no_bound_is_known_all_faces_are_asked)
{
  Body holder(cube(3)), held(cube(1));
  Bvh8_containment<> containment;
  Query_statistics counts;
  for (const double size : {0x1p-300, 0x1p300}) {
    const Pose pose(std::array<double, 12>{size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0});
    Placed_pair pair(holder.triangles, pose, held.triangles, pose);
    BOOST_TEST(containment(pair.holder, pair.held, counts));
    Placed_pair other_way(held.triangles, pose, holder.triangles, pose);
    BOOST_TEST(!containment(other_way.holder, other_way.held, counts));
  }
}

BOOST_AUTO_TEST_SUITE_END()
