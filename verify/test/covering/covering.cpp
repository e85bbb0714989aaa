#include "tetracone/covering/covering.h"

#include "tetracone/covering/edge_uses.h"
#include "verify/test/support/at_once.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_covering)

using namespace tetracone::covering;
using tetracone::kernel::Rational;
using namespace tetracone::verify::scenes;
using rationals::Vector;

Vector vertex(const Polyhedron& body, Index v) { return rationals::exactly(body.vertices[v]); }

BOOST_AUTO_TEST_CASE(known_volumes_are_exact)
{
  const std::map<std::string, Rational> known = {{"cube", 64},
                                                 {"cube of triangles", 64},
                                                 {"inward cube", -64},
                                                 {"tetrahedron", Rational(27) / Rational(6)},
                                                 {"star prism", 24},
                                                 {"tunnel", 6 * 6 * 6 - 2 * 2 * 6},
                                                 {"cavity", 216 - 64},
                                                 {"nested shells", 216 - 64 + 8},
                                                 {"shells in one another", 216 + 64},
                                                 {"spur", 64},
                                                 {"degenerate faces", 64}};
  int found = 0;
  for (const auto& [name, body] : closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    BOOST_TEST((Rational(6 * volume(body)) == rationals::six_volumes(body)));
    const auto at = known.find(name);
    if (at == known.end()) continue;
    ++found;
    BOOST_TEST((volume(body) == at->second));
  }
  BOOST_TEST(found == int(known.size()));

  Random random(2);
  const Voxels voxels(random, 3);
  BOOST_TEST((volume(voxels.solid()) == std::count(voxels.full.begin(), voxels.full.end(), true)));
}

BOOST_AUTO_TEST_CASE(sides_of_triangles_are_marked_that_are_edges_of_their_face_and_spanning_corners_are_off_one_line)
{
  for (const auto& [name, body] : closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Covering covering(body);
    std::set<std::array<Index, 2>> all;
    int wrong = 0;
    for (Index f = 0; f < body.face_count(); ++f) {
      std::set<std::array<Index, 2>> of_face, marked;
      for_each_directed_edge(body, f, [&](Index a, Index b) { of_face.insert({std::min(a, b), std::max(a, b)}); });
      all.insert(of_face.begin(), of_face.end());
      for (const Covering_triangle& t : covering.triangles())
        for (int i = 0; i < 3 && t.face == f; ++i) {
          const Index a = t.corner[i], b = t.corner[(i + 1) % 3];
          const std::array<Index, 2> side = {std::min(a, b), std::max(a, b)};
          wrong += of_face.contains(side) != (t.edge[i] != none);
          wrong += t.edge[i] != none && covering.edges()[t.edge[i]] != side;
          wrong += t.corner[0] != covering.from(f)[0];
          if (t.edge[i] != none) marked.insert(side);
        }
      BOOST_TEST((marked == of_face));

      const auto& spanning = covering.plane_basis(f);
      BOOST_TEST(spanning.has_value() == !rationals::is_zero(rationals::normal(body, f)));
      if (!spanning) continue;
      const Vector a = vertex(body, (*spanning)[0]), b = vertex(body, (*spanning)[1]), c = vertex(body, (*spanning)[2]);
      BOOST_TEST(!rationals::is_zero(rationals::outer(rationals::minus(b, a), rationals::minus(c, a))));
      for (const Index v : *spanning) BOOST_TEST(std::ranges::count(covering.from(f), v) > 0);
    }
    BOOST_TEST(wrong == 0);
    BOOST_TEST(std::ranges::equal(all, covering.edges()));
  }
}

BOOST_AUTO_TEST_CASE(faces_of_many_corners_are_spanned_by_any_of_them)
{
  // Along a parabola, and once with all but two corners on a line.
  for (const bool in_line : {false, true})
    for (const Index corners : {4u, 15u, 16u, 40u}) {
      Polyhedron body;
      std::vector<Index> loop;
      for (Index k = 0; k < corners; ++k) {
        const double y = in_line ? 0.5 * (k + 2 >= corners) : 0.125 * k * k;
        body.vertices.push_back({double(k), y, 1});
        loop.push_back(k);
      }
      body.add_polygon(std::vector<Index>{0, 1, corners - 1});
      body.add_polygon(loop);
      body.add_polygon(std::vector<Index>{2, 2, 2});
      const Covering covering(body);
      const auto of_triangle = covering.plane_basis(0), of_all = covering.plane_basis(1);
      BOOST_REQUIRE((of_triangle && of_all));
      BOOST_TEST(((*of_triangle)[0] == 0u && (*of_triangle)[1] + (*of_triangle)[2] == corners));
      BOOST_TEST((*of_all)[0] == 0u);
      BOOST_TEST((*of_all)[1] == corners - 1);
      BOOST_TEST(((*of_all)[2] > 0u && (*of_all)[2] < corners - 1));
      BOOST_TEST(!covering.plane_basis(2));
    }
}

BOOST_AUTO_TEST_CASE(a_vertex_speaks_for_each_connected_shell)
{
  const auto count = [](const Polyhedron& body) { return Covering(body).shell_vertices().size(); };
  BOOST_TEST(count(cube(1)) == 1u);
  BOOST_TEST(count(cube_with_cavity()) == 2u);
  Random random(4);
  BOOST_TEST(count(random_tetrahedra(random, 5, 3)) == 5u);
  // Unused vertices are on no surface.
  Polyhedron unused;
  unused.vertices.push_back({9, 9, 9});
  append(unused, cube(1));
  BOOST_TEST(count(unused) == 1u);
  BOOST_TEST(Covering(unused).shell_vertices()[0] != 0u);
}

BOOST_AUTO_TEST_CASE(two_boxes_joined_by_a_face_of_two_outer_loops_are_two_parts_of_the_surface)
{
  // Legal: the face's points are two squares that share no point, so one vertex cannot speak for both boxes.
  Polyhedron both = without_last_face(unit_cube());
  append(both, without_last_face(box({5, 0, 0}, {6, 1, 1})));
  both.add_face({{4, 5, 7, 6}, {12, 13, 15, 14}});
  BOOST_TEST((volume(both) == 2));
  std::set<bool> sides;
  const Covering covering(both);
  for (const Index v : covering.shell_vertices()) sides.insert(both.vertices[v][0] > 3);
  BOOST_TEST(sides.size() == 2u);
}

BOOST_AUTO_TEST_CASE(two_threads_make_the_same_covering)
{
  const auto bytes = [](const Covering& covering) {
    std::string all;
    const auto append = [&all](const auto& array) {
      all.append(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(array[0]));
    };
    append(covering.triangles());
    append(covering.edges());
    append(covering.shell_vertices());
    for (Index f = 0; f <= covering.triangles().back().face; ++f) {
      append(covering.from(f));
      append(covering.to(f));
      if (const auto basis = covering.plane_basis(f)) append(*basis);
    }
    return all;
  };
  const auto is_same = [&](const Polyhedron& body) {
    return bytes(Covering(body, tetracone::verify::At_once())) == bytes(Covering(body));
  };
  for (const auto& [name, body] : closed_bodies()) BOOST_TEST(is_same(body), name);
  // A body of several parts; then also faces whose number of triangles is not their number of corners less two, and
  // planes through other corners.
  Random random(4);
  Polyhedron large = blob(random, 6, 0.5, 1.5);
  BOOST_TEST(large.face_count() > 2 * most_in_part);
  BOOST_TEST(is_same(large));
  const auto first = Index(large.vertices.size());
  for (int k = 0; k < 40; ++k) large.vertices.push_back({k < 20 ? 0.01 * k : 0.01 * (39 - k), k < 20 ? 0.0 : 1.0, 0});
  std::vector<Index> strip(40);
  std::iota(strip.begin(), strip.end(), first);
  for (int k = 0; k < 5; ++k) large.add_polygon(strip);
  BOOST_TEST(is_same(large));
  large.add_polygon({first, first + 1, first, first + 25});  // its first corner twice
  BOOST_TEST(Covering(large).triangles().back().face == large.face_count() - 1);
  BOOST_TEST(is_same(large));
  for (int k = 0; k < 3; ++k) large.add_polygon({first, first + 1});
  large.add_polygon({first});
  BOOST_TEST(is_same(large));
}

BOOST_AUTO_TEST_CASE(parts_are_all_in_their_order_and_no_larger_than_asked)
{
  for (const Index count : {0u, 1u, 7u, 1000u}) {
    std::vector<int> seen(count, 0);
    Index end = 0, largest = 0;
    in_parts(
        5, 5 + count, {},
        [&](Index first, Index last) {
          BOOST_TEST(first == (end == 0 ? 5 : end));
          end = last;
          largest = std::max(largest, last - first);
          for (Index k = first; k < last; ++k) ++seen[k - 5];
        },
        3);
    BOOST_TEST(std::ranges::count(seen, 1) == std::ptrdiff_t(count));
    BOOST_TEST(largest <= 3u);
  }
  struct Word {
    std::vector<Index> begins;
    void add(const Word& later) { begins.insert(begins.end(), later.begins.begin(), later.begins.end()); }
  };
  const auto what = [](Index first, Index) { return Word{{first}}; };
  const tetracone::verify::At_once at_once;
  for (const Both& both : {Both(), Both(at_once)}) {
    const Word word = sum_of_parts(0, 4 * most_in_part + 1, both, what);
    BOOST_TEST(word.begins.size() == 5u);
    BOOST_TEST(std::ranges::is_sorted(word.begins));
  }
}

BOOST_AUTO_TEST_SUITE_END()
