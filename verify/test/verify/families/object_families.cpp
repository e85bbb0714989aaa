#include "verify/families/object_families.h"

#include "verify/cases/object_placing.h"

#include "tetracone/covering/check.h"
#include "tetracone/kernel/contact/rational_map.h"
#include "tetracone/kernel/motion/rotation_quaternion.h"
#include "verify/families/families.h"
#include "verify/families/ladder.h"
#include "verify/test/verify/same_body.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_object_families)

using namespace tetracone;
using namespace tetracone::verify;
using namespace tetracone::verify::object_family;
using covering::Polyhedron;
using kernel::Question;

namespace {

bool same(const Object_case& c, const Object_case& d)
{
  return verify::same(*c.a, *d.a) && verify::same(*c.b, *d.b) && c.pose_a == d.pose_a && c.pose_b == d.pose_b &&
         c.surface == d.surface && c.solid == d.solid;
}

bool is_legal(const Polyhedron& body)
{
  bool legal = covering::is_closed(body);
  for (covering::Index f = 0; f < body.face_count(); ++f)
    legal = legal && covering::planarity(body, f) != covering::Planarity::off_plane;
  for (const auto& v : body.vertices)
    for (const double x : v) legal = legal && std::isfinite(x);
  return legal;
}

/// The exact images have nearest doubles.
bool is_finite(const Polyhedron& body, const kernel::Pose& pose)
{
  for (const auto& v : body.vertices)
    for (const Rational& x : image(pose, exact(v)))
      if (!std::isfinite(kernel::nearest_double(x))) return false;
  return true;
}

/// Every case of these is tried but those of large bodies, which campaigns have.
bool is_small(const Object_case& c) { return c.a->face_count() + c.b->face_count() < 8000; }

Both_answers truth(const Object_case& c)
{
  const Brute_body a(*c.a), b(*c.b);
  return collide_both(Placed_body(a, c.pose_a), Placed_body(b, c.pose_b));
}

/// One solid strictly inside the other, or inside its cavity: the surfaces never meet, by what the family is.
const std::set<std::string_view> surfaces_never_meet = {"nested"};

/// One solid may be inside the other.
const std::set<std::string_view> of_containment = {"nested-touching", "nested", "covering-elements", "covering-apex",
                                                   "winding-axis",    "voxels", "many-faces",        "lego"};

}  // namespace

BOOST_AUTO_TEST_CASE(every_body_of_the_pool_is_legal_outward_and_has_places_to_touch)
{
  BOOST_TEST_MESSAGE("real meshes: " << (real_meshes_available() ? "yes" : "no, generated ones in their place"));
  for (const auto* pool : {&blocks(), &pebbles(), &meshes()})
    for (const Shape& shape : *pool) {
      const covering::Check check = covering::check(*shape.body);
      BOOST_TEST(check.closed);
      BOOST_TEST(check.off_plane.empty());
      BOOST_TEST(check.degenerate_faces.empty());
      BOOST_TEST((*check.volume > 0));
      BOOST_TEST(!shape.hull.empty());
      BOOST_TEST((pool == &meshes() || !shape.hull_edges.empty()));
    }
  for (const Shape& shape : blocks())
    for (const auto& v : shape.body->vertices)
      for (const double x : v) BOOST_TEST(std::floor(64 * x) == 64 * x);
  // A solid face's triangles have its area: none is lost, none is in a hole.
  const Shape& tunnelled = blocks()[tunnel_block];
  Exact_vector total = {0, 0, 0};
  for (const Face_triangle& t : tunnelled.triangles)
    if (t.face == 0) {
      const auto [a, b, c] = t.corners;
      total = sum(total, cross(difference(tunnelled.vertex(b), tunnelled.vertex(a)),
                               difference(tunnelled.vertex(c), tunnelled.vertex(a))));
    }
  BOOST_TEST((total == tunnelled.normals[0]));
}

BOOST_AUTO_TEST_CASE(cases_are_the_same_again_in_any_order)
{
  for (const Family& family : families()) {
    const Object_case late = family.object_case(5, 11), early = family.object_case(5, 2);
    BOOST_TEST(same(early, family.object_case(5, 2)), family.name);
    BOOST_TEST(same(late, family.object_case(5, 11)), family.name);
    BOOST_TEST(!same(late, early), family.name);
    BOOST_TEST(!same(late, family.object_case(6, 11)), family.name);
  }
}

BOOST_AUTO_TEST_CASE(every_case_is_legal)
{
  for (const Family& family : families())
    for (std::uint64_t index = 0; index < 2 * family.sweep.size() + 20; ++index) {
      const Object_case c = family.object_case(1, index);
      if (!is_small(c)) continue;
      BOOST_TEST_CONTEXT(family.name << ' ' << index)
      {
        BOOST_TEST(is_legal(*c.a));
        BOOST_TEST(is_legal(*c.b));
        BOOST_TEST(c.pose_a.determinant_sign() != CGAL::ZERO);
        BOOST_TEST(c.pose_b.determinant_sign() != CGAL::ZERO);
        BOOST_TEST(is_finite(*c.a, c.pose_a));
        BOOST_TEST(is_finite(*c.b, c.pose_b));
      }
    }
}

// 20 of each answer in at most 200 cases; what the families know is right in all of them.
BOOST_AUTO_TEST_CASE(both_answers_are_frequent_and_known_answers_true)
{
  for (const Family& family : families()) {
    const bool by_solid = surfaces_never_meet.contains(family.name);
    int yes = 0, no = 0, contained = 0;
    for (std::uint64_t index = 0; index < 200 && (yes < 20 || no < 20); ++index) {
      const Object_case c = family.object_case(2, index);
      if (!is_small(c)) continue;
      const Both_answers answer = truth(c);
      BOOST_TEST_CONTEXT(family.name << ' ' << index)
      {
        if (c.surface) BOOST_TEST(*c.surface == answer.surface);
        if (c.solid) BOOST_TEST(*c.solid == answer.solid);
        if (by_solid) BOOST_TEST(!answer.surface);
      }
      ++((by_solid ? answer.solid : answer.surface) ? yes : no);
      contained += answer.solid && !answer.surface;
    }
    BOOST_TEST_CONTEXT(family.name)
    {
      BOOST_TEST(yes >= 20);
      BOOST_TEST(no >= 20);
      BOOST_TEST((contained > 0 || !of_containment.contains(family.name)));
    }
  }
}

BOOST_AUTO_TEST_CASE(metres_are_rigid_and_near_and_of_the_size_that_engines_are_made_for)
{
  for (std::uint64_t index = 0; index < 60; ++index) {
    const Object_case c = find_family("metres")->object_case(7, index);
    for (const auto& [body, pose] : {std::pair(c.a, c.pose_a), std::pair(c.b, c.pose_b)}) {
      const auto turned = kernel::rotation_quaternion(pose);
      BOOST_TEST_REQUIRE(turned.has_value());
      BOOST_TEST(turned->error < 1e-12);
      double size = 0;
      for (const auto& v : body->vertices)
        for (std::size_t k = 0; k < 3; ++k) size = std::max(size, std::abs(v[k] - body->vertices[0][k]));
      BOOST_TEST((size > 0.05 && size < 32), size);
      for (int k = 3; k < 12; k += 4) BOOST_TEST(std::abs(pose[k]) < 150);
    }
  }
}

BOOST_AUTO_TEST_CASE(rungs_are_each_met_once_and_their_cubes_are_that_far_apart)
{
  const std::vector<double> rungs = all_rungs();
  BOOST_TEST(std::set<double>(rungs.begin(), rungs.end()).size() == std::size_t(Rung::count));
  int known = 0;
  for (std::uint64_t index = 0; index < rungs.size(); ++index) {
    const Object_case c = find_family("ladder")->object_case(3, index);
    const Rung rung(int(c.origin.parameter));
    if (!c.surface) continue;
    ++known;
    // In the frame of either, the other's centre is away by the cubes' size and the gap, along one axis.
    const kernel::Rational_map frame(c.pose_a);
    Rational most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      Rational apart = 0;
      for (const auto& v : c.a->vertices) apart += frame.inverse(image(c.pose_b, exact(v)))[k] - Rational(v[k]);
      most = std::max(most, Rational(abs(Rational(apart / 8))));
    }
    BOOST_TEST((most == power_of_two(rung.exponent) * (1 + rung.gap()) || rung.gap() < 0));
    BOOST_TEST(*c.surface == (rung.gap() <= 0));
  }
  BOOST_TEST(known > 100);
}

BOOST_AUTO_TEST_CASE(each_relation_of_solids_is_met_by_a_twentieth_of_the_bricks)
{
  std::map<kernel::Solid_relation, int> count;
  std::map<int, int> of_dimension;
  const int cases = 400;
  for (std::uint64_t index = 0; index < cases; ++index) {
    const Object_case c = find_family("lego")->object_case(3, index);
    BOOST_TEST_REQUIRE(c.overlap.has_value());
    ++count[c.overlap->contact.relation];
    ++of_dimension[c.overlap->contact.dimension];
  }
  BOOST_TEST(count.size() == 8);
  for (const auto& [relation, n] : count) BOOST_TEST(20 * n >= cases, to_string(relation) << ": " << n);
  for (int dimension = -1; dimension <= 2; ++dimension)
    BOOST_TEST(40 * of_dimension[dimension] >= cases, dimension << ": " << of_dimension[dimension]);
}

BOOST_AUTO_TEST_CASE(contacts_touch_exactly_and_a_hair_apart_they_do_not)
{
  Random random(4);
  for (const Shape& a : blocks()) {
    const Shape& b = any_shape(random);
    std::vector<Touching> contacts = {vertex_on_face(random, a, b.body, any_turn(random), 4),
                                      vertex_on_vertex(random, a.body, b.body, any_turn(random)),
                                      vertex_on_edge(random, a, b.body, any_turn(random), 4),
                                      edge_across_edge(random, a, any_block(random), any_turn(random), 4)};
    for (const Touching& contact : contacts) {
      const Brute_body body_a(*contact.a), body_b(*contact.b);
      const auto meet = [&](const Rational& gap) {
        return collide(body_a, Pose(), body_b, moved(contact.relative, times(gap, contact.apart)), Question::solid);
      };
      BOOST_TEST(meet(0));
      if (contact.separated) BOOST_TEST(!meet(power_of_two(-200)));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
