// Real models with holes in their faces (not part of the project). The fast tree, over faces as they are and over their
// triangles, is compared with the paper's tree in rational arithmetic. That one shares neither tree nor signs with it.

#include "tetracone/covering/check.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/data_folder.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_collide)

using namespace tetracone::verify::scenes;
namespace covering = tetracone::covering;
namespace fs = std::filesystem;
using tetracone::kernel::Question;

namespace {

std::vector<fs::path> small_files()
{
  std::vector<fs::path> small;
  for (const auto& entry : fs::recursive_directory_iterator(data_folder() / "holed"))
    if (entry.path().extension() == ".poly" && fs::file_size(entry.path()) < 40000) small.push_back(entry.path());
  std::ranges::sort(small);
  return small;
}

/// Closed models with exactly planar faces and holes in some of them. The folder has broken ones too.
std::vector<Polyhedron> small_models()
{
  std::vector<Polyhedron> models;
  for (const fs::path& file : small_files()) {
    try {
      const Polyhedron p = covering::read(file.string());
      const auto c = covering::check(p);
      if (c.closed && c.off_plane.empty() && c.holed_faces.size() > 0) models.push_back(p);
    } catch (const tetracone::covering::Input_error&) {
    }
  }
  return models;
}

/// The body against itself: moved by a share of its size along an axis, so that parallel faces meet, or turned about
/// its middle, exactly.
Pose any_pose(Random& random, const Polyhedron& p, int kind)
{
  Vertex low = p.vertices.front(), high = low;
  for (const Vertex& v : p.vertices)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v[k]);
      high[k] = std::max(high[k], v[k]);
    }
  if (kind == 0) {
    Vertex t{0, 0, 0};
    const int axis = integer(random, 0, 2);
    t[axis] = (high[axis] - low[axis]) * std::array{1.0, -1.0, 0.5, 0.25}[integer(random, 0, 3)];
    return translation(t[0], t[1], t[2]);
  }
  const Pose turn = random_rotation(random, 3);
  std::array<Rational, 12> m;
  for (int i = 0; i < 3; ++i) {
    m[4 * i + 3] = Rational(0.5 * (low[i] + high[i]) + real(random, -0.9, 0.9) * (high[i] - low[i]));
    for (int j = 0; j < 3; ++j) {
      m[4 * i + j] = turn.exact(4 * i + j);
      m[4 * i + 3] -= m[4 * i + j] * Rational(0.5 * (low[j] + high[j]));
    }
  }
  return Pose(m);
}

}  // namespace

BOOST_AUTO_TEST_CASE(faces_with_holes_get_the_answers_of_the_papers_tree_in_rationals)
{
  if (without_data()) return;
  Random random(5);
  int models = 0, answers = 0, collisions = 0, differ = 0;
  for (const Polyhedron& p : small_models()) {
    ++models;
    const tetracone::Body whole(p), triangles = tetracone::triangulated_body(p);
    std::array<Pose, 6> poses;
    for (int k = 0; k < 6; ++k) poses[k] = any_pose(random, p, k % 3);
    for (const Question question : {Question::surface, Question::solid}) {
      using tetracone::Query;
      Query of_whole(whole, whole, question), of_triangles(triangles, triangles, question),
          reference(whole, whole, question,
                    {.kernel = tetracone::Kernel::rational, .method = tetracone::Method::paper});
      for (const Pose& pose : poses) {
        const auto answer = [&](Query& query) { return bool(query.collide(Pose(), pose)); };
        const bool expected = answer(reference);
        differ += answer(of_whole) != expected;
        differ += answer(of_triangles) != expected;
        ++answers;
        collisions += expected;
      }
    }
  }
  BOOST_TEST_MESSAGE(models << " models, " << answers << " answers, " << collisions << " collisions");
  BOOST_TEST(models >= 5);
  BOOST_TEST(collisions > 0);
  BOOST_TEST(collisions < answers);
  BOOST_TEST(differ == 0);
}

BOOST_AUTO_TEST_SUITE_END()
