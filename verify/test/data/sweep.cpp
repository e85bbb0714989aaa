// Reads every model of the folder of real data (not part of the project) and checks what is known of it. That is its
// counts, closed, genus, or that it is refused in one line.

#include "tetracone/covering/check.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/repair/repair.h"
#include "verify/test/support/data_folder.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_sweep)

using namespace tetracone::covering;
namespace fs = std::filesystem;
using tetracone::verify::scenes::data_folder;
using tetracone::verify::scenes::without_data;

namespace {

std::vector<fs::path> model_files()
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(data_folder())) {
    std::string suffix = entry.path().extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return std::tolower(c); });
    if (std::set<std::string>{".off", ".obj", ".ply", ".stl", ".poly"}.contains(suffix)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// The required properties of a model, after vertices with equal coordinates are merged. Genus -1: none.
struct Known {
  std::string file;
  std::size_t vertices, faces, shells;
  bool closed;
  int genus;  ///< of the first shell
};

const std::vector<Known> known = {
    {"paper/cat_382v_760f.off", 382, 760, 1, true, 0},
    {"paper/horse_genus3_3582v_7172f.off", 3582, 7172, 1, true, 3},
    {"paper/horse_48485v_96966f.ply", 48485, 96966, 1, true, 0},
    {"paper/polyA_32v_18f.poly", 32, 18, 1, true, 2},
    {"paper/polyB_44v_29f.poly", 44, 29, 1, true, 1},
    {"large/armadillo_99994f.obj", 49999, 99994, 1, true, 0},
    {"topo/casting_genus9.off", 5096, 10224, 1, true, 9},
    {"topo/fertility_genus4.off", 4494, 9000, 1, true, 4},
    {"topo/bamboo_pen_quads.obj", 1146, 1160, 1, true, 8},
    {"topo/knot_max_simplified.stl", 800, 1600, 1, true, 1},
    {"topo/knot_texturedknot.ply", 1440, 2880, 1, true, 1},
    {"cad/cranck_genus12.obj", 17724, 35492, 1, true, 12},
    {"cad/thingi_88566.stl", 2624, 5344, 8, true, 4},
    {"cad/featuretype.stl", 2010, 3476, 1, false, -1},
    {"holed/1002_tray_bottom_merged.poly", 1838, 921, 1, true, 23},
    {"holed/ADIS16480_merged.poly", 3533, 2920, 1, true, 24},
    {"holed/val3dity/torus.poly", 14, 9, 1, true, 1},
    {"holed/val3dity/cube15.poly", 10, 7, 1, false, -1},
    {"holed/val3dity/tahol_.poly", 386, 768, 1, true, 0},
    {"bad/cubes-touching.stl", 14, 24, 1, true, -1},
    {"bad/joined_tetrahedra.obj", 5, 8, 1, true, -1},
    {"bad/multibody.stl", 20, 32, 2, false, -1},
    {"parser/whitespace.off", 8, 6, 1, true, 0},
    {"parser/comments.off", 8, 6, 1, true, 0},
    {"parser/negative_indices.obj", 8, 6, 1, true, 0},
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_file_is_read_or_refused_in_one_line_and_in_time)
{
  if (without_data()) return;
  std::size_t read = 0, refused = 0;
  for (const fs::path& file : model_files()) {
    const auto start = std::chrono::steady_clock::now();
    try {
      const Read_model model = read_model(file);
      const Check before = check(model.polyhedron);
      const Triangulated planar = triangulate_non_planar(model.polyhedron);
      BOOST_TEST(planar.replaced.size() == before.off_plane.size(), file);
      BOOST_TEST(is_closed(planar.polyhedron) == before.closed, file);
      for (Index f = 0; f < planar.polyhedron.face_count(); ++f)
        if (planarity(planar.polyhedron, f) == Planarity::off_plane) BOOST_ERROR(file);
      ++read;
    } catch (const Input_error& error) {
      const std::string message = error.what();
      BOOST_TEST(message.starts_with(file.native()), message);
      BOOST_TEST(message.find("; expected") != std::string::npos, message);
      BOOST_TEST(message.find('\n') == std::string::npos, message);
      // Only what is made broken may be refused, and a facet of two corners.
      BOOST_TEST((file.parent_path().filename() == "parser" || file.filename() == "cube_collapsed.poly"), message);
      ++refused;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    BOOST_TEST(seconds < 30, file << " took " << seconds << " s");
  }
  BOOST_TEST(read > 80u);
  BOOST_TEST(refused > 10u);
}

BOOST_AUTO_TEST_CASE(broken_files_are_refused)
{
  if (without_data()) return;
  for (const fs::path& file : model_files()) {
    const std::string name = file.filename().string();
    if (name.starts_with("corrupted_") || name.starts_with("truncated."))
      BOOST_CHECK_THROW(read_model(file), Input_error);
  }
}

BOOST_AUTO_TEST_CASE(known_models_are_what_they_are)
{
  if (without_data()) return;
  for (const Known& expected : known) {
    const fs::path file = data_folder() / expected.file;
    if (!fs::exists(file)) {
      BOOST_ERROR(file);
      continue;
    }
    const Check found = check(merge_equal_vertices(read(file)));
    BOOST_TEST(found.vertices == expected.vertices, expected.file);
    BOOST_TEST(found.faces == expected.faces, expected.file);
    BOOST_TEST(found.shells.size() == expected.shells, expected.file);
    BOOST_TEST(found.closed == expected.closed, expected.file);
    const auto genus = found.shells.at(0).genus;
    BOOST_TEST((genus ? static_cast<int>(*genus) : -1) == expected.genus, expected.file);
  }
}

BOOST_AUTO_TEST_CASE(volumes_known_from_elsewhere_are_met_exactly)
{
  if (without_data()) return;
  BOOST_TEST((*check(read(data_folder() / "paper/polyA_32v_18f.poly")).volume == 592));
  BOOST_TEST(
      (*check(read(data_folder() / "paper/polyB_44v_29f.poly")).volume == tetracone::kernel::Rational(1295) / 2));
  // The triangulated boundary is equal.
  for (const std::string name : {"paper/polyA_32v_18f", "paper/polyB_44v_29f"})
    BOOST_TEST((*check(read(data_folder() / (name + ".poly"))).volume ==
                *check(read(data_folder() / (name + "_tri.off"))).volume));
  // All normals of this one point inward.
  BOOST_TEST((*check(read(data_folder() / "holed/val3dity/cube14.poly")).volume == -1));
}

BOOST_AUTO_TEST_CASE(orientation_closes_what_it_can)
{
  if (without_data()) return;
  BOOST_TEST(closes_if_oriented(read(data_folder() / "bad/multibody.stl")));
  BOOST_TEST(closes_if_oriented(read(data_folder() / "bad/conrod.stl")));
  BOOST_TEST(!closes_if_oriented(read(data_folder() / "bad/nonmanifold.stl")));
  BOOST_TEST(!closes_if_oriented(read(data_folder() / "large/bunny_stanford_69451f.obj")));
}

BOOST_AUTO_TEST_SUITE_END()
