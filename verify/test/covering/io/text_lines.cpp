#include "tetracone/covering/io/text_lines.h"

#include "tetracone/covering/io/read_points.h"
#include "tetracone/covering/io/read_poses.h"
#include "verify/test/support/model_texts.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_text_lines)

using namespace tetracone::covering;
using namespace tetracone::verify::texts;
using tetracone::verify::error_of;
using tetracone::verify::Temporary_file;

const std::string mark = "\xef\xbb\xbf";

/// With carriage returns for line feeds.
std::string returns(std::string text)
{
  std::ranges::replace(text, '\n', '\r');
  return text;
}

std::string utf16(const std::string& text)
{
  std::string wide = "\xff\xfe";
  for (const char c : text) wide += {c, '\0'};
  return wide;
}

/// A tetrahedron as every text format has it.
std::map<std::string, std::string> tetrahedra()
{
  std::string stl = "solid t\n";
  for (const char* const triangle : {"0 0 0\nvertex 0 1 0\nvertex 1 0 0", "0 0 0\nvertex 1 0 0\nvertex 0 0 1",
                                     "1 0 0\nvertex 0 1 0\nvertex 0 0 1", "0 1 0\nvertex 0 0 0\nvertex 0 0 1"})
    stl += "facet normal 0 0 0\nouter loop\nvertex " + std::string(triangle) + "\nendloop\nendfacet\n";
  return {{"t.off", tetrahedron_off},
          {"t.obj", tetrahedron_obj},
          {"t.ply", ascii_ply("double", "int", "1")},
          {"t.poly",
           "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 0\n1\n3 0 2 1\n1\n3 0 1 3\n1\n3 1 2 3\n1\n3 2 0 3\n0\n"},
          {"t.stl", stl + "endsolid t\n"}};
}

BOOST_AUTO_TEST_CASE(a_byte_order_mark_and_old_line_ends_change_nothing_but_count)
{
  for (const auto& [name, text] : tetrahedra()) {
    const Temporary_file plain(name, text);
    const Polyhedron expected = read(plain.path());
    BOOST_TEST(expected.face_count() == 4u);
    for (const std::string& other : {mark + text, returns(text), mark + returns(text)}) {
      const Temporary_file file("other_" + name, other);
      const Polyhedron found = read(file.path());
      BOOST_TEST((found.vertices == expected.vertices), name);
      BOOST_TEST(found.face_count() == 4u, name);
    }
  }
  const std::string poses = "1 0 0 0 0 1 0 0 0 0 1 0\n# two\n1 0 0 1 0 1 0 0 0 0 1 0\n";
  for (const std::string& text : {mark + poses, returns(poses), mark + returns(poses)}) {
    const Temporary_file file("poses.txt", text);
    BOOST_TEST(read_poses(file.path()).size() == 2u);
  }
  const Temporary_file points("points.txt", mark + "0 0 0\r1 1/2 0\r");
  BOOST_TEST(read_points(points.path()).size() == 2u);
  const Temporary_file file("poses.txt", mark + "# one\r# two\r1 2 3\r");
  BOOST_TEST(error_of(file, [](const auto& path) { read_poses(path); }) ==
             ":3: 3 numbers; expected 12 or 16, the rows of a 3x4 or 4x4 matrix");
}

BOOST_AUTO_TEST_CASE(utf_16_is_named)
{
  const std::string says = ": is text in UTF-16; expected UTF-8 or ASCII";
  for (const auto& [name, text] : tetrahedra()) {
    const Temporary_file file(name, utf16(text));
    BOOST_TEST(error_of(file, [](const auto& path) { read(path); }) == says, name);
  }
  const Temporary_file file("poses.txt", "\xfe\xff" + std::string("\0001", 2));
  BOOST_TEST(error_of(file, [](const auto& path) { read_poses(path); }) == says);
}

BOOST_AUTO_TEST_CASE(binary_files_keep_every_byte)
{
  // A header that begins as a mark does.
  const std::string corner = std::string("\0\0\x80\x3f", 4), zero(4, '\0');
  std::string stl = mark + std::string(77, '\r') + std::string("\1\0\0\0", 4) + std::string(12, '\0');
  stl += zero + zero + zero + corner + zero + zero + zero + corner + zero + std::string(2, '\0');
  const Temporary_file file("one.stl", stl);
  BOOST_TEST(read(file.path()).vertices.size() == 3u);
}

BOOST_AUTO_TEST_SUITE_END()
