// Real files on which an exact answer was wrong: every exact kernel, by every method, in both orders.

#include "tetracone/covering/io/read.h"
#include "tetracone/covering/io/read_poses.h"
#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/tetratree/scene/scene.h"
#include "verify/cases/scene_file.h"
#include "verify/subjects/object_subject.h"
#include "verify/test/support/data_folder.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_soundness)

using namespace tetracone;

BOOST_AUTO_TEST_CASE(what_was_wrong_of_real_files_is_right)
{
  if (verify::scenes::without_data()) return;
  const std::filesystem::path folder = verify::scenes::data_folder() / "soundness";
  struct Row {
    std::string a, b, pose_a, pose_b;
    bool surface, solid;
  };
  const auto pose = [&](const std::string& name) {
    return name.empty() ? kernel::Pose() : covering::read_poses((folder / name).native()).at(0);
  };
  for (const Row& row : {Row{"a.off", "b_cross.off", "pose_a.txt", "pose_b.txt", true, true},
                         Row{"a.off", "b_inside.off", "pose_a.txt", "pose_b.txt", false, true},
                         Row{"a.off", "b_cross.off", "pose_a_512.txt", "pose_b_512.txt", true, true},
                         Row{"a.off", "b_inside.off", "pose_a_512.txt", "pose_b_512.txt", false, true},
                         Row{"a.off", "b_cross.off", "pose_a_511.txt", "pose_b_511.txt", true, true},
                         Row{"a.off", "b_inside.off", "pose_a_511.txt", "pose_b_511.txt", false, true},
                         Row{"u1.off", "u2.off", "", "pose_tie.txt", false, false}}) {
    const auto a = std::make_shared<covering::Polyhedron>(covering::read((folder / row.a).native())),
               b = std::make_shared<covering::Polyhedron>(covering::read((folder / row.b).native()));
    const kernel::Pose pose_a = pose(row.pose_a), pose_b = pose(row.pose_b);
    for (const auto& subject : verify::object_subjects()) {
      if (!subject.is_exact) continue;
      const auto ask = subject.make();
      for (const auto question : {kernel::Question::surface, kernel::Question::solid}) {
        const auto expected = (question == kernel::Question::surface ? row.surface : row.solid) ? verify::Outcome::yes
                                                                                                : verify::Outcome::no;
        BOOST_TEST(((*ask)({a, b, pose_a, pose_b, {}, {}, {}}, question) == expected),
                   subject.name << ": " << row.a << " " << row.b << " " << row.pose_a);
        BOOST_TEST(((*ask)({b, a, pose_b, pose_a, {}, {}, {}}, question) == expected),
                   subject.name << ": " << row.b << " " << row.a << " " << row.pose_a);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(scenes_under_fractions_that_no_double_tells_are_right)
{
  if (verify::scenes::without_data()) return;
  const std::filesystem::path folder = verify::scenes::data_folder() / "soundness" / "scene";
  for (const std::size_t threads : {1, 3})
    for (const bool moves : {false, true}) {
      verify::Scene_file file(folder / (moves ? "tinym.scene.json" : "tiny.scene.json"));
      Scene scene({.threads = threads});
      for (const auto& model : file.models()) scene.add_model(Body(covering::read(model.file.native())));
      for (const std::size_t model : file.bodies()) scene.add_body(model);
      const std::vector<kernel::Pose> from = file.frame(0);
      for (std::size_t k = 0; k < from.size(); ++k) scene.place(k, from[k]);
      if (!moves) {
        BOOST_TEST((scene.pairs() == std::vector{Scene_pair{0, 1}}));
        continue;
      }
      const std::vector<kernel::Pose> to = file.frame(1);
      std::vector<Motion> motions;
      for (std::size_t k = 0; k < from.size(); ++k) motions.emplace_back(kernel::Body_motion::linear(from[k], to[k]));
      const auto contacts = scene.first_contacts(motions);
      BOOST_REQUIRE(contacts.size() == 1u);
      BOOST_TEST(contacts[0].first.lo == 0.75);
      BOOST_TEST(contacts[0].first.hi == 0.75);
    }
}

BOOST_AUTO_TEST_SUITE_END()
