#ifndef TETRACONE_VERIFY_TEST_SUPPORT_MODEL_TEXTS_H
#define TETRACONE_VERIFY_TEST_SUPPORT_MODEL_TEXTS_H

#include "tetracone/covering/io/read.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

/// Texts of models, and what the readers say of them.
namespace tetracone::verify::texts {

/// The folder of models for tests, with its last slash.
inline const std::string models = std::string(TETRACONE_SOURCE_DIR) + "/verify/test/models/";

/// A tetrahedron in two formats, and their parts.
inline const std::string tetrahedron_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
inline const std::string tetrahedron_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
inline const std::string tetrahedron_off = "OFF\n4 4 6\n" + tetrahedron_vertices + tetrahedron_faces;
inline const std::string obj_faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
inline const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + obj_faces;

/// The tetrahedron with this last coordinate, in a PLY with these types of coordinates and of indices.
inline std::string ascii_ply(const std::string& coordinate, const std::string& index, const std::string& last = "0.1")
{
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty " + coordinate + " x\nproperty " + coordinate +
         " y\nproperty " + coordinate + " z\nelement face 4\nproperty list uchar " + index +
         " vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 " + last + "\n" + tetrahedron_faces;
}

/// Returns the model that a file of this suffix and text is read as.
inline covering::Read_model read_text(const std::string& suffix, const std::string& text)
{
  const Temporary_file file("model" + suffix, text);
  return covering::read_model(file.path());
}

/// Returns the message with which the text is refused.
inline std::string error_of(const std::string& suffix, const std::string& text)
{
  return verify::error_of(Temporary_file("model" + suffix, text), [](const auto& path) { covering::read_model(path); });
}

/// Checks that each text behind `before` is refused at this line, as ":4", and that the message says what is expected.
inline void check_refused(const std::string& suffix, const std::string& line, const std::string& before,
                          const std::vector<std::string>& texts)
{
  for (const std::string& text : texts) {
    const std::string error = error_of(suffix, before + text);
    BOOST_TEST(error.starts_with(line + ": "), text << ": " << error);
    BOOST_TEST(error.find("; expected") != std::string::npos, text << ": " << error);
  }
}

}  // namespace tetracone::verify::texts

#endif
