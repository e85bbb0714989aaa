#include "verify/cases/shape_generators.h"

#include "tetracone/covering/check.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/io/write.h"
#include "tetracone/covering/projection.h"
#include "tetracone/covering/repair/repair.h"
#include "verify/cases/random.h"
#include "verify/test/support/temporary_file.h"
#include "verify/test/verify/same_body.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

BOOST_AUTO_TEST_SUITE(test_shape_generators)

using namespace tetracone;
using namespace tetracone::verify;
using covering::Check;
using covering::Index;
using kernel::Rational;
using verify::Temporary_file;

namespace {

/// Whether triangles of the boundary, each face triangulated in itself, meet elsewhere than in shared corners and
/// edges.
bool intersects_itself(const Polyhedron& p)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Epick::Point_3>;
  using Corner = Mesh::Vertex_index;
  Mesh mesh;
  for (const Vertex& v : p.vertices) mesh.add_vertex({v[0], v[1], v[2]});
  for (Index f = 0; f < p.face_count(); ++f) {
    const auto triangles = covering::repair::constrained_delaunay(p, f);
    BOOST_REQUIRE(triangles);
    for (const auto& t : *triangles)
      BOOST_REQUIRE((mesh.add_face(Corner(t[0]), Corner(t[1]), Corner(t[2])) != Mesh::null_face()));
  }
  return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

/// Closed, outward, one shell, planar, nothing degenerate, free of self-intersections.
Check check_clean(const Polyhedron& p, std::size_t genus)
{
  const Check c = covering::check(p);
  BOOST_TEST(c.closed);
  BOOST_TEST(c.off_plane.empty());
  BOOST_TEST(c.degenerate_faces.empty());
  BOOST_TEST(c.repeated_vertices.empty());
  BOOST_TEST(c.isolated_vertices.empty());
  BOOST_TEST((c.orientation == covering::Orientation::outward));
  BOOST_REQUIRE(c.shells.size() == 1u);
  BOOST_REQUIRE(c.shells[0].genus.has_value());
  BOOST_TEST(*c.shells[0].genus == genus);
  BOOST_TEST((*c.volume > 0));
  BOOST_TEST(!intersects_itself(p));
  return c;
}

/// Whether the loop turns the same way at every corner.
bool is_convex(const Polyhedron& p, covering::Loop loop)
{
  const int axis = covering::projection_axis(p, loop);
  std::set<CGAL::Sign> turns;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    std::array<CGAL::Epick::Point_2, 3> q;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex& v = p.vertices[loop[(k + i) % loop.size()]];
      q[i] = {v[(axis + 1) % 3], v[(axis + 2) % 3]};
    }
    turns.insert(CGAL::orientation(q[0], q[1], q[2]));
  }
  return turns.size() == 1;
}

Polyhedron read_back(const std::string& name, const std::string& text)
{
  const Temporary_file file(name, text);
  return covering::read(file.path());
}

}  // namespace

BOOST_AUTO_TEST_CASE(complex_one_has_the_papers_counts_and_our_shape)
{
  const Polyhedron p = complex_one();
  const Check c = check_clean(p, 2);
  BOOST_TEST(c.vertices == 32u);
  BOOST_TEST(c.faces == 18u);
  BOOST_TEST(c.hole_loops == 4u);
  BOOST_TEST(c.holed_faces.size() == 2u);
  for (const Index f : c.holed_faces) BOOST_TEST(!is_convex(p, p.loop(f, 0)));
}

BOOST_AUTO_TEST_CASE(complex_two_has_the_papers_counts_and_our_shape)
{
  const Polyhedron p = complex_two();
  const Check c = check_clean(p, 1);
  BOOST_TEST(c.vertices == 44u);
  BOOST_TEST(c.faces == 29u);
  BOOST_TEST(c.hole_loops == 6u);
  BOOST_TEST(c.holed_faces.size() == 5u);
  int not_convex = 0;
  for (Index f = 0; f < p.face_count(); ++f) not_convex += !is_convex(p, p.loop(f, 0));
  BOOST_TEST(not_convex == 3);  // bottom, top and the arrowhead
  // The block, less tunnel, pit and sunk pyramid, with arrowhead and raised pyramid, in units of 1/16.
  const Rational volume = (24 * 8 + 10 * 8) * 12 - 5 * 5 * 8 - 7 * 5 + 20 * 2 - 16 * 2 + 16;
  BOOST_TEST((*c.volume * 4096 == volume));
}

BOOST_AUTO_TEST_CASE(voxels_make_unit_squares_between_full_and_empty)
{
  BOOST_TEST((*check_clean(voxel_solid({true}, 1, 1, 1), 0).volume == 1));
  // A ring of eight cubes.
  const Check ring = check_clean(voxel_solid({1, 1, 1, 1, 0, 1, 1, 1, 1}, 3, 3, 1), 1);
  BOOST_TEST((*ring.volume == 8));
  BOOST_TEST(ring.faces == 32u);
  // Two cubes that share a corner: closed, and no manifold.
  const Check pair = covering::check(voxel_solid({1, 0, 0, 0, 0, 0, 0, 1}, 2, 2, 2));
  BOOST_TEST(pair.closed);
  BOOST_TEST(pair.shells.size() == 1u);
  BOOST_TEST(!pair.shells[0].genus.has_value());
  BOOST_TEST(pair.vertices == 15u);
  BOOST_TEST(voxel_solid({}, 0, 0, 0).face_count() == 0u);
  // All solids of 2 x 2 x 2: as much volume as bits.
  for (unsigned bits = 1; bits < 256; ++bits) {
    std::vector<bool> cells(8);
    for (int k = 0; k < 8; ++k) cells[k] = bits >> k & 1;
    const Polyhedron p = voxel_solid(cells, 2, 2, 2);
    BOOST_TEST(covering::is_closed(p));
    BOOST_TEST((covering::volume(p) == Rational(std::popcount(bits))));
  }
}

BOOST_AUTO_TEST_CASE(blobs_are_star_shaped_about_0)
{
  for (const std::size_t triangles : {8, 100, 760, 3000}) {
    const Polyhedron p = blob(triangles, triangles);
    check_clean(p, 0);
    BOOST_TEST(std::abs(double(p.face_count()) - double(triangles)) <= 4 * std::sqrt(2.0 * triangles) + 2);
    for (Index f = 0; f < p.face_count(); ++f) {
      const auto t = p.loop(f, 0);
      kernel::Volume_sum sum;
      sum.add({0, 0, 0}, p.vertices[t[0]], p.vertices[t[1]], p.vertices[t[2]]);
      BOOST_TEST((sum.value() > 0));
    }
  }
  BOOST_TEST(same(blob(500, 7), blob(500, 7)));
  BOOST_TEST(!same(blob(500, 7), blob(500, 8)));
}

BOOST_AUTO_TEST_CASE(torus_knots_do_not_meet_themselves)
{
  for (const std::size_t triangles : {640, 1000, 7172}) {
    const Polyhedron p = torus_knot(triangles);
    check_clean(p, 1);
    BOOST_TEST(std::abs(double(p.face_count()) - double(triangles)) <= 8);
    BOOST_TEST(std::abs(radius(p) - 1) < 0.05);
  }
}

BOOST_AUTO_TEST_CASE(what_is_written_reads_back_exactly)
{
  for (const Polyhedron& p :
       {box_with_cavity(1, 0.3), blob(100, 1), torus_knot(640), box({-1e-300, 0.1, -0.0}, {1e300, 1 / 3.0, 5e-324})})
    BOOST_TEST(same(read_back("written.off", covering::write_off(p)), p));
}

BOOST_AUTO_TEST_CASE(normalised_has_centroid_0_and_radius_1)
{
  const Polyhedron p = normalised(box({10, 20, 30}, {11, 22, 33}));
  for (const double x : centroid(p)) BOOST_TEST(std::abs(x) < 1e-14);
  BOOST_TEST(std::abs(radius(p) - 1) < 1e-14);
}

BOOST_AUTO_TEST_CASE(decimation_leaves_exactly_so_many_triangles_each_time_the_same)
{
  const Polyhedron knot = torus_knot(4000);
  const Polyhedron p = decimate(knot, 1200);
  BOOST_TEST(p.face_count() == 1200u);
  const Check c = covering::check(p);
  BOOST_TEST(c.closed);
  BOOST_TEST(c.isolated_vertices.empty());
  BOOST_TEST(c.shells.at(0).genus.value() == 1u);
  BOOST_TEST((*c.volume > 0));
  BOOST_TEST(same(p, decimate(knot, 1200)));
  BOOST_TEST(decimate(knot, knot.face_count()).face_count() == knot.face_count());
}

BOOST_AUTO_TEST_CASE(decimation_refuses_what_it_cannot_do)
{
  const Polyhedron p = blob(100, 1);
  BOOST_CHECK_THROW(decimate(p, 51), std::invalid_argument);
  BOOST_CHECK_THROW(decimate(p, p.face_count() + 2), std::invalid_argument);
  BOOST_CHECK_THROW(decimate(p, 2), std::invalid_argument);
  BOOST_CHECK_THROW(decimate(unit_cube(), 4), std::invalid_argument);
  Polyhedron open;
  open.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  open.add_polygon({0, 1, 2});
  open.add_polygon({2, 1, 3});
  BOOST_CHECK_THROW(decimate(open, 2), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_folder_without_meshes_gives_none)
{
  BOOST_TEST(!demo_mesh("no/such/folder", "bunny00"));
  BOOST_TEST(!small_mesh("no/such/folder"));
}

BOOST_AUTO_TEST_CASE(random_numbers_are_those_of_the_published_generators)
{
  // The first state word of seed 0 by splitmix64 is 0xe220a8397b1dcdaf; xoshiro256** from there, computed by hand in
  // Python.
  Random random(0);
  BOOST_TEST(random.bits() == 0x99ec5f36cb75f2b4u);
  BOOST_TEST(random.bits() == 0xbf6e1f784956452au);
  Random other(1);
  double least = 1, greatest = 0, mean = 0;
  for (int k = 0; k < 10000; ++k) {
    const double x = other.unit();
    least = std::min(least, x);
    greatest = std::max(greatest, x);
    mean += x / 10000;
  }
  BOOST_TEST((least >= 0 && least < 0.01 && greatest < 1 && greatest > 0.99));
  BOOST_TEST(std::abs(mean - 0.5) < 0.02);
}

BOOST_AUTO_TEST_CASE(turn_is_cosine_and_sine)
{
  for (int k = -3000; k <= 3000; ++k) {
    const auto [c, s] = turn(k / 1000.0);
    BOOST_TEST(std::abs(c - std::cos(k / 1000.0 * 2 * M_PI)) < 2e-14);
    BOOST_TEST(std::abs(s - std::sin(k / 1000.0 * 2 * M_PI)) < 2e-14);
  }
  BOOST_TEST((turn(0.25) == std::array<double, 2>{0, 1}));
  BOOST_TEST((turn(-0.5) == std::array<double, 2>{-1, 0}));
}

BOOST_AUTO_TEST_SUITE_END()
