// Real files on which an exact answer was wrong: every exact kernel, by every method, in both orders.

#include "tetracone/covering/io/read.h"
#include "tetracone/covering/io/read_poses.h"
#include "verify/subjects/object_subject.h"
#include "verify/test/support/data_folder.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <memory>
#include <string>

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

BOOST_AUTO_TEST_SUITE_END()
