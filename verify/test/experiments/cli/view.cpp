// Runs the program itself: the pages of `tetracone view`, what they hold, and, in headless Chromium where it is
// installed, what they show.

#include "tetracone/covering/io/write.h"
#include "tetracone/kernel/number/floating_point.h"
#include "verify/test/support/program.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_view)

using namespace tetracone::verify;
using Json = nlohmann::json;

namespace {

/// The page that these words give, and the data in it.
struct Page {
  std::string html;
  Json data;

  explicit Page(const std::string& words)
  {
    const Temporary_file file("page.html", "");
    const Run r = run("view " + words + " --out " + in_quotes(file.path()));
    BOOST_TEST_REQUIRE(r.status == 0, words << ": " << r.error);
    BOOST_TEST(r.out.empty());
    html = contents(file.path());
    const std::string open = "id=\"data\">";
    const auto begin = html.find(open) + open.size();
    data = Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
  }
};

/// Unit cubes, the second moved along x: overlapping, touching, one ulp apart, apart by less than a float can say, and
/// far apart.
Json with_poses(const std::string& options)
{
  std::string poses;
  for (const char* x : {"0.5", "1", "1.0000000000000002", "1.0000000001", "2"})
    poses += std::string("1 0 0 ") + x + " 0 1 0 0 0 0 1 0\n";
  const Temporary_file file("poses.txt", poses);
  return Page(cube + " " + cube + options + " --pose-b " + in_quotes(file.path())).data;
}

/// A torus of n x n quadrilaterals, halved.
std::string torus(int n) { return tetracone::covering::write_off(scenes::triangulated(scenes::torus(n, n))); }

}  // namespace

BOOST_AUTO_TEST_CASE(answers_stand_beside_the_exact_ones_pose_by_pose)
{
  const Json data = with_poses(" --kernel float");
  BOOST_TEST(data["subject"] == "float tree");
  BOOST_TEST(data["question"] == "solid");
  BOOST_TEST(data["exact"] == Json({1, 1, 0, 0, 0}));
  BOOST_TEST(data["answer"] == Json({1, 1, 1, 1, 0}));
  BOOST_TEST(data["poses"][0].size() == 1u);
  BOOST_TEST(data["poses"][1][2][3] == 1.0000000000000002);
  BOOST_TEST(with_poses(" --kernel adaptive")["answer"] == data["exact"]);
}

BOOST_AUTO_TEST_CASE(features_say_which_pairs_the_kernel_loses_and_invents)
{
  const Json data = with_poses(" --kernel float");
  const auto marks = [&](int pose, int mark) {
    int count = 0;
    for (const Json& f : data["features"][pose]) count += f[5] == mark;
    return count;
  };
  // Touching in a square: each edge of a touching face overlaps the other's face, and each edge that ends in it touches
  // it.
  BOOST_TEST(data["feature_counts"][1].get<int>() > 0);
  BOOST_TEST(marks(1, 0) == data["feature_counts"][1].get<int>());
  BOOST_TEST(data["feature_counts"][2] == 0);
  BOOST_TEST(marks(2, 2) == marks(1, 0));  // in float the third pose is the second
  BOOST_TEST(marks(2, 0) + marks(2, 1) == 0);
  BOOST_TEST(marks(4, 0) + marks(4, 1) + marks(4, 2) == 0);
  // Faces that meet draw segments; where the cubes touch, all of them in the plane x = 1.
  BOOST_TEST(!data["contacts"][1].empty());
  for (const Json& segment : data["contacts"][1])
    BOOST_TEST((segment.size() == 6u && segment[0] == 1 && segment[3] == 1));
  BOOST_TEST(data["contacts"][2].empty());
  // A query that finds a pair tested its leaves.
  for (int pose = 0; pose < 2; ++pose)
    for (int body = 0; body < 2; ++body) BOOST_TEST(!data["left"][pose][body].empty());
}

/// The volume that polygons bound.
double bounded_by(const Json& parts)
{
  double volume = 0;
  for (const Json& part : parts)
    for (std::size_t i = 6; i < part.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto x = [&](std::size_t corner, std::size_t axis) { return part[corner + axis % 3].get<double>(); };
        volume += x(0, k) * (x(i - 3, k + 1) * x(i, k + 2) - x(i - 3, k + 2) * x(i, k + 1)) / 6;
      }
  return volume;
}

BOOST_AUTO_TEST_CASE(solids_say_how_they_stand_and_what_bounds_their_overlap)
{
  const Json solids = with_poses("")["solids"];
  std::vector<std::string> relations;
  for (const Json& each : solids)
    relations.push_back(each["relation"].get<std::string>() + " " + std::to_string(each["dimension"].get<int>()));
  BOOST_TEST(relations ==
             (std::vector<std::string>{"overlap 2", "meet 2", "disjoint -1", "disjoint -1", "disjoint -1"}));
  BOOST_TEST(solids[0]["volume"] == 0.5);
  BOOST_TEST(bounded_by(solids[0]["parts"]) == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((!solids[0].contains("out") && !solids[1].contains("parts")));
  // Faces with holes, a body within another, a mirror image and common faces.
  const Temporary_file moved("moved.txt",
                             "0.8 -0.6 0 1.25 0.6 0.8 0 0.5 0 0 1 0.25\n0.5 0 0 0.25 0 0.5 0 0.25 0 0 0.5 0.25\n"
                             "-0.5 0 0 1 0 0.5 0 0 0 0 0.5 0.5\n1 0 0 0 0 1 0 0 0 0 1 0\n");
  for (const std::string& a : {models + "frame.poly", cube, models + "tetrahedron.poly"})
    for (const std::string& b : {models + "frame.poly", cube, models + "tetrahedron.poly"}) {
      int overlaps = 0;
      const Json found = Page(a + " " + b + " --pose-b " + in_quotes(moved.path())).data["solids"];
      for (const Json& each : found) {
        if (!each.contains("parts")) continue;
        ++overlaps;
        BOOST_TEST(bounded_by(each["parts"]) == each["volume"].get<double>(), boost::test_tools::tolerance(1e-4));
      }
      BOOST_TEST(overlaps > 0, a << " and " << b);
    }
  BOOST_TEST(!Page(cube + " " + cube + " --question surface").data.contains("solids"));
}

BOOST_AUTO_TEST_CASE(a_vector_moves_a_out_of_b)
{
  const Json least = with_poses(" --depth")["solids"];
  BOOST_TEST(least[0]["out"] == Json::parse(R"({"vector": [-0.5, 0, 0], "bounds": [0.5, 0.5], "exact": true})"));
  BOOST_TEST((!least[1].contains("out") && !least[2].contains("out")));
  const Json along = with_poses(" --along 0 -4/2 0")["solids"];
  BOOST_TEST(along[0]["out"] == Json::parse(R"({"vector": [0, -1, 0], "first": 0.5, "last": 0.5})"));
}

BOOST_AUTO_TEST_CASE(bodies_say_where_they_intersect_themselves)
{
  const Temporary_file crossing("crossing.off",
                                "OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -1\n1 1 1\n9 9 0\n3 0 1 2\n3 3 4 5\n");
  const Json body = Page(in_quotes(crossing.path())).data["bodies"][0];
  BOOST_TEST(body["self_pairs"] == 1);
  BOOST_TEST(body["self"] == Json::parse("[[2, 2, 0, 1, 1, 0]]"));
  BOOST_TEST(Page(cube).data["bodies"][0]["self_pairs"] == 0);
}

/// The cube from (x, 0, 0).
std::string cube_at(int x)
{
  std::string text = "OFF\n8 6 0\n";
  for (int v = 0; v < 8; ++v)
    text += std::to_string(x + (v & 1)) + " " + std::to_string(v >> 1 & 1) + " " + std::to_string(v >> 2) + "\n";
  return text + "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
}

BOOST_AUTO_TEST_CASE(what_is_drawn_far_from_the_origin_is_as_exact_as_near_it)
{
  constexpr int far = 100'000'000;
  const Temporary_file a("near.off", cube_at(0)), b("far.off", cube_at(far)),
      half("half.txt", "1 0 0 0.5 0 1 0 0.25 0 0 1 0.25\n");
  const auto page = [&](const Temporary_file& model) {
    const std::string name = in_quotes(model.path());
    return Page(name + " " + name + " --pose-b " + in_quotes(half.path())).data;
  };
  const Json near_data = page(a), far_data = page(b);
  // Rounded outward at 1e8, bounds are wider by some 1e-7.
  const auto check_moved = [](const Json& here, const Json& there, const std::string& what) {
    BOOST_TEST_REQUIRE(here.size() == there.size(), what);
    for (std::size_t i = 0; i < here.size(); ++i)
      BOOST_TEST(std::abs(there[i].get<double>() - here[i].get<double>() - (i % 3 == 0 ? far : 0)) < 1e-5, what);
  };
  const auto nodes = [](const Json& data) -> const Json& { return data["bodies"][0]["nodes"]; };
  check_moved(nodes(near_data)["tetrahedron"], nodes(far_data)["tetrahedron"], "tetrahedra");
  const Json &here = nodes(near_data)["sphere"], &there = nodes(far_data)["sphere"];
  for (std::size_t i = 0; i < here.size(); ++i)
    BOOST_TEST(std::abs(there[i].get<double>() - here[i].get<double>() - (i % 4 == 0 ? far : 0)) < 1e-5, "spheres");
  const Json &contacts = near_data["contacts"][0], &parts = near_data["solids"][0]["parts"];
  BOOST_TEST_REQUIRE((!contacts.empty() && !parts.empty()));
  for (std::size_t k = 0; k < contacts.size(); ++k) check_moved(contacts[k], far_data["contacts"][0][k], "contacts");
  for (std::size_t k = 0; k < parts.size(); ++k) check_moved(parts[k], far_data["solids"][0]["parts"][k], "parts");
}

BOOST_AUTO_TEST_CASE(faces_have_the_numbers_of_the_file)
{
  // Triangles replace face 0, which is not planar.
  const Temporary_file quads("quads.off",
                             "OFF\n8 2 0\n0 0 0\n4 0 0\n4 4 1\n0 4 0\n10 0 0\n14 0 0\n14 4 0\n10 4 0\n"
                             "4 0 1 2 3\n4 4 5 6 7\n"),
      above("above.off", "OFF\n3 1 0\n12 1 1\n13 1 3\n12 2 3\n3 0 1 2\n"),
      down("down.txt", "1 0 0 0 0 1 0 0 0 0 1 -3\n"), ray("ray.txt", "2 2 -5 0 0 1\n");
  const std::string pair = in_quotes(quads.path()) + " " + in_quotes(above.path()) + " --question surface";
  BOOST_TEST(Page(pair).data["nearest"][0] == Json::parse(R"([1, 12, 1, 0, 12, 1, 1, "face 1", "vertex 0"])"));
  BOOST_TEST(Page(pair + " --pose-b1 " + in_quotes(down.path())).data["motion"]["holders"] ==
             Json::parse(R"([["face 1", [2], true], ["vertex 0", [0], false]])"));
  // Both triangles have the point that the ray meets.
  const Json hits = Page(in_quotes(quads.path()) + " --rays " + in_quotes(ray.path())).data["rays"][0][1];
  BOOST_TEST_REQUIRE(hits.size() == 2u);
  BOOST_TEST(hits[0] == 0);
  const Temporary_file crossed("crossed.off",
                               "OFF\n8 2 0\n0 0 0\n4 0 0\n4 4 1\n0 4 0\n2 -1 -1\n2 -1 5\n2 6 5\n2 6 -1\n"
                               "4 0 1 2 3\n4 4 5 6 7\n");
  BOOST_TEST(Page(in_quotes(crossed.path())).data["bodies"][0]["self_pairs"] == 1);
}

BOOST_AUTO_TEST_CASE(names_need_not_be_utf_8)
{
  const Temporary_file model("caf\xe9.off", contents(cube)),
      scene("caf\xe9.scene.json", R"({"models": {"c": ")" + cube + R"("}, "bodies": [{"model": "c"}],
                                      "frames": [[[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]]]})");
  for (const auto* file : {&model, &scene})
    BOOST_TEST(contains(Page(in_quotes(file->path())).data["name"].get<std::string>(), "caf\xef\xbf\xbd."));
}

BOOST_AUTO_TEST_CASE(a_lost_pair_of_the_corpus_is_marked)
{
  const Json data = Page(source + "/verify/corpus/double-false-negative-pose-vertex-edge.case.json").data;
  BOOST_TEST(data["exact"] == Json::array({1}));
  BOOST_TEST(data["answer"] == Json::array({0}));
  BOOST_TEST(data["case"]["family"] == "degenerate-face");
  BOOST_TEST(!data["features"][0].empty());
  for (const Json& f : data["features"][0]) BOOST_TEST(f[5] == 1);
}

BOOST_AUTO_TEST_CASE(covering_tree_and_hull_are_those_of_the_body)
{
  const Json body = Page(cube).data["bodies"][0];
  const auto vertex = [&](std::size_t v, int k) { return body["vertices"][3 * v + k].get<double>(); };
  // The signed sum over the covering is six times the volume.
  const auto corner = [&](std::size_t t, int i, int k) {
    return vertex(body["covering"]["triangles"][3 * t + i], k) - body["covering"]["origin"][k].get<double>();
  };
  const std::size_t count = body["covering"]["signs"].size();
  double volume = 0;
  for (std::size_t t = 0; t < count; ++t) {
    double determinant = 0;
    for (int k = 0; k < 3; ++k)
      determinant += corner(t, 0, k) * (corner(t, 1, (k + 1) % 3) * corner(t, 2, (k + 2) % 3) -
                                        corner(t, 1, (k + 2) % 3) * corner(t, 2, (k + 1) % 3));
    BOOST_TEST((determinant > 0) - (determinant < 0) == body["covering"]["signs"][t].get<int>());
    volume += determinant / 6;
  }
  BOOST_TEST(volume == 1, boost::test_tools::tolerance(1e-12));

  // Every face is in some leaf, and its sphere holds the vertices.
  const Json& nodes = body["nodes"];
  std::set<int> faces;
  double dmax = 0;
  for (std::size_t n = 0; n < nodes["level"].size(); ++n) {
    if (nodes["leaf"][n] == 0) continue;
    for (int i = 0; i < 3; ++i) {
      double square = 0;
      for (int k = 0; k < 3; ++k)
        square += std::pow(
            nodes["tetrahedron"][9 * n + 3 * i + k].get<double>() - body["covering"]["origin"][k].get<double>(), 2);
      dmax = tetracone::kernel::maximum(dmax, std::sqrt(square));
    }
    for (const int face : nodes["faces"][n]) faces.insert(face);
  }
  BOOST_TEST(faces.size() == body["faces"].size());
  BOOST_TEST(body["hull"]["dmax"].get<double>() == dmax, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(body["hull"]["dmax"].get<double>() >= std::sqrt(0.75) * (1 - 1e-5));  // it holds the corners of the cube
}

BOOST_AUTO_TEST_CASE(every_face_is_drawn_also_one_with_a_hole)
{
  const Json body = Page(models + "frame.poly").data["bodies"][0];
  double area = 0;
  const auto difference = [&](std::size_t t, int i, int k) {
    return body["vertices"][3 * body["triangles"][4 * t + 1 + i].get<std::size_t>() + k].get<double>() -
           body["vertices"][3 * body["triangles"][4 * t + 1].get<std::size_t>() + k].get<double>();
  };
  std::set<int> faces;
  for (std::size_t t = 0; t < body["triangles"].size() / 4; ++t) {
    double square = 0;
    for (int k = 0; k < 3; ++k)
      square += std::pow(difference(t, 1, (k + 1) % 3) * difference(t, 2, (k + 2) % 3) -
                             difference(t, 1, (k + 2) % 3) * difference(t, 2, (k + 1) % 3),
                         2);
    area += std::sqrt(square) / 2;
    faces.insert(body["triangles"][4 * t].get<int>());
  }
  BOOST_TEST(faces.size() == body["faces"].size());
  // Top and bottom 3 x 3 without 1 x 1, four outer walls 3 x 1, four inner ones 1 x 1.
  BOOST_TEST(area == 2 * 8 + 4 * 3 + 4, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(large_bodies_are_shown_in_linear_time)
{
  const Temporary_file thirty("thirty.off", torus(125)), half("half.off", torus(500)), huge("huge.off", torus(708));
  const auto start = std::chrono::steady_clock::now();
  const Json one = Page(in_quotes(thirty.path())).data["bodies"][0];
  BOOST_TEST(one["faces"].size() == 2u * 125 * 125);
  BOOST_TEST(one["nodes"]["level"].size() > 1000u);
  // Twice the same: all leaves are left.
  const Temporary_file small("small.off", torus(60));
  const Json same = Page(in_quotes(small.path()) + " " + in_quotes(small.path())).data;
  BOOST_TEST(same["feature_counts"][0].is_null());
  BOOST_TEST(same["features"][0].empty());
  BOOST_TEST(same["exact"] == Json::array({1}));
  // Half a million triangles, without the method.
  const Temporary_file page("page.html", "");
  const Run r = run("view " + in_quotes(half.path()) + " --out " + in_quotes(page.path()));
  BOOST_TEST(r.status == 0);
  BOOST_TEST(contains(r.error, "500000 triangles, more than 50000: the page shows bodies and answers alone\n"),
             r.error);
  BOOST_TEST(contents(page.path()).find("\"nodes\"") == std::string::npos);
  check_refused("view " + in_quotes(huge.path()) + " --out " + in_quotes(page.path()),
                "1002528 triangles; expected at most 1000000 in a page");
  BOOST_TEST(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 120);
}

BOOST_AUTO_TEST_CASE(every_case_of_the_corpus_gives_a_page)
{
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source + "/verify/corpus")) {
    if (!entry.path().native().ends_with(".case.json")) continue;
    const Json data = Page(in_quotes(entry.path())).data, c = Json::parse(contents(entry.path()));
    ++count;
    const Json truth = c["level"] == "object" ? c["truth"][c["question"].get<std::string>()] : c["truth"];
    BOOST_TEST(data["exact"][0] == truth, entry.path());
  }
  BOOST_TEST(count >= 30);
}

BOOST_AUTO_TEST_CASE(a_page_asks_for_nothing_from_outside)
{
  const Page page(cube);
  BOOST_TEST(contains(page.html, "default-src 'none'"));
  for (const std::string outside : {"src=\"", "<link rel=\"stylesheet\"", "import(", "@import", "fetch(\""})
    BOOST_TEST(page.html.find(outside) == std::string::npos, outside);
  BOOST_TEST(!contains(page.html, "{{"));  // three.js and ours: no name of the template is left
  BOOST_TEST(contains(page.html, "Permission is hereby granted"));  // three.js' licence goes with it
}

BOOST_AUTO_TEST_CASE(a_name_cannot_end_the_script_it_stands_in)
{
  const Temporary_file model("x<!--<script>.off", contents(cube));
  const Page page(in_quotes(model.path()));
  BOOST_TEST(!contains(page.html, "x<!--<script>"));
  BOOST_TEST(page.data["name"].get<std::string>().ends_with("x<!--<script>.off"));
}

BOOST_AUTO_TEST_CASE(in_a_browser_pages_show_what_they_should)
{
  const int status = std::system(("'" TETRACONE_PYTHON "' " +
                                  in_quotes(source + "/verify/test/experiments/cli/view.py") + " " + in_quotes(program))
                                     .c_str());
  if (WIFEXITED(status) && WEXITSTATUS(status) == 77)
    BOOST_TEST_MESSAGE("skipped: see the line above");
  else
    BOOST_TEST(status == 0);
}

BOOST_AUTO_TEST_CASE(a_scene_has_triangles_of_every_face_of_its_models)
{
  // Faces that are triangles, polygons, one whose loop runs into it and back, which no triangles cover, and faces with
  // holes.
  const Temporary_file stl("t.stl",
                           "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                           "endloop\nendfacet\nendsolid t\n"),
      mixed("mixed.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 1 2 3\n3 0 1 4\n5 0 1 2 1 3\n"),
      scene("drawn.scene.json", R"({"models": {"t": ")" + stl.path().native() + R"(", "mixed": ")" +
                                    mixed.path().native() + R"(", "frame": ")" + models + R"(frame.poly"},
            "bodies": [{"model": "t"}, {"model": "mixed"}, {"model": "frame"}], "frames": [[
            [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0], [1, 0, 0, 9, 0, 1, 0, 0, 0, 0, 1, 0]]]})");
  const Page page("--question surface " + in_quotes(scene.path()));
  std::vector<std::size_t> triangles;
  for (const Json& model : page.data["models"]) triangles.push_back(model["triangles"].size() / 3);
  std::ranges::sort(triangles);
  BOOST_REQUIRE(triangles.size() == 3u);
  BOOST_TEST(triangles[0] == 1u);
  BOOST_TEST(triangles[1] >= 4u);
  BOOST_TEST(triangles[2] >= 32u);
}

BOOST_AUTO_TEST_SUITE_END()
