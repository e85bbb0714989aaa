#include "tetracone/covering/io/read.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/kernel/number/number.h"
#include "verify/test/support/model_texts.h"
#include "verify/test/support/suite.h"

#include <cstring>

BOOST_AUTO_TEST_SUITE(test_read)

using namespace tetracone::covering;
using namespace tetracone::verify::texts;
using tetracone::verify::Temporary_file;

const std::string note = "a dialect that CGAL's reader does not take: read by the scan alone";

std::vector<Index> loop(const Polyhedron& polyhedron, Index f, std::size_t k = 0)
{
  const Loop found = polyhedron.loop(f, k);
  return {found.begin(), found.end()};
}

bool same(const Polyhedron& a, const Polyhedron& b)
{
  if (a.vertices != b.vertices || a.face_count() != b.face_count()) return false;
  for (Index f = 0; f < a.face_count(); ++f)
    if (a.loop_count(f) != b.loop_count(f) || loop(a, f) != loop(b, f)) return false;
  return true;
}

/// The bytes of a number, of either byte order.
template <class Number>
std::string bytes(Number number, bool big = false)
{
  std::string result(sizeof number, '\0');
  std::memcpy(result.data(), &number, sizeof number);
  if ((std::endian::native == std::endian::big) != big) std::reverse(result.begin(), result.end());
  return result;
}

const std::string triangle_off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
/// A triangle of an STL, with these words at the ends of its loop and of itself.
std::string facet_ending(const std::string& loop, const std::string& facet)
{
  return "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n" + loop + "\n" + facet + "\n";
}
const std::string facet = facet_ending("endloop", "endfacet");

/// Reads what must be the tetrahedron of `tetrahedron_off`.
Read_model read_tetrahedron(const std::string& suffix, const std::string& text)
{
  static const Polyhedron plain = read_text(".off", tetrahedron_off).polyhedron;
  const Read_model model = read_text(suffix, text);
  BOOST_TEST(same(plain, model.polyhedron), text);
  return model;
}

std::string binary_stl(const std::vector<std::array<float, 9>>& triangles, std::uint32_t count)
{
  std::string text = "solid, says this binary file";
  text.resize(80, ' ');
  text += bytes(count);
  for (const auto& triangle : triangles) {
    text += std::string(12, '\0');
    for (const float x : triangle) text += bytes(x);
    text += std::string(2, '\0');
  }
  return text;
}

const std::vector<std::array<float, 9>> tetrahedron_triangles = {{0, 0, 0, 0, 1, 0, 1, 0, 0},
                                                                 {0, 0, 0, 1, 0, 0, 0, 0, 1},
                                                                 {1, 0, 0, 0, 1, 0, -0.0f, 0, 1},
                                                                 {0, 1, 0, 0, 0, -0.0f, 0, 0, 1}};

std::string binary_ply(bool big)
{
  std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                     "_endian 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty float x\nproperty uchar "
                     "flag\nproperty double z\nproperty float y\n"
                     "element face 4\nproperty int label\nproperty list uchar int vertex_indices\nelement tail "
                     "1\nproperty list ushort float w\nend_header\n";
  const float x[] = {0, 1, 0, 0}, y[] = {0, 0, 1, 0};
  const double z[] = {0, 0, 0, 0.1};
  for (int v = 0; v < 4; ++v) text += bytes(x[v], big) + "\7" + bytes(z[v], big) + bytes(y[v], big);
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const auto& face : faces) {
    text += bytes(std::int32_t{-7}, big) + "\3";
    for (const int v : face) text += bytes(std::int32_t{v}, big);
  }
  return text + bytes(std::uint16_t{2}, big) + bytes(1.5f, big) + bytes(std::numeric_limits<float>::quiet_NaN(), big);
}

BOOST_AUTO_TEST_CASE(the_same_tetrahedron_comes_out_of_every_format)
{
  const Polyhedron off = read_text(".off", tetrahedron_off).polyhedron;
  BOOST_TEST(off.vertices.size() == 4u);
  BOOST_TEST(off.face_count() == 4u);
  BOOST_TEST(is_closed(off));
  BOOST_TEST(same(off, read_text(".obj", tetrahedron_obj).polyhedron));
  BOOST_TEST(same(off, read_text(".ply", ascii_ply("double", "int", "1")).polyhedron));
  BOOST_TEST(same(off, read(models + "tetrahedron.poly")));
  // STL numbers the vertices as they come: 0 2 1 3.
  const Polyhedron stl = read_text(".stl", binary_stl(tetrahedron_triangles, 4)).polyhedron;
  BOOST_TEST(stl.vertices.size() == 4u);
  BOOST_TEST(is_closed(stl));
  BOOST_TEST((loop(stl, 2) == std::vector<Index>{2, 1, 3}));
}

BOOST_AUTO_TEST_CASE(cgal_reads_the_usual_files_and_agrees)
{
  BOOST_TEST(read_model(models + "cube.off").notes.empty());
  BOOST_TEST(read_model(models + "lifted.obj").notes.empty());
  BOOST_TEST(read_model(models + "open.stl").notes.empty());
  BOOST_TEST(read_text(".ply", binary_ply(false)).notes.empty());
  BOOST_TEST(read_text(".ply", binary_ply(true)).notes.empty());
  BOOST_TEST(read_text(".stl", binary_stl(tetrahedron_triangles, 4)).notes.empty());
}

BOOST_AUTO_TEST_CASE(suffixes_have_any_case_and_unknown_ones_are_refused)
{
  BOOST_TEST(read_text(".OFF", triangle_off).polyhedron.face_count() == 1u);
  BOOST_TEST(error_of(".xyz", triangle_off) == ": unknown suffix '.xyz'; expected .off, .obj, .ply, .stl or .poly");
  BOOST_TEST(error_of("", triangle_off) == ": no suffix; expected .off, .obj, .ply, .stl or .poly");
}

BOOST_AUTO_TEST_CASE(what_is_no_file_is_refused)
{
  BOOST_CHECK_THROW(read("no/such/file.off"), Input_error);
  BOOST_CHECK_THROW(read(models), Input_error);
  BOOST_CHECK_THROW(read(""), Input_error);
  for (const char* suffix : {".off", ".obj", ".ply", ".stl", ".poly"}) {
    BOOST_TEST(error_of(suffix, "") == ": the file is empty; expected a model");
    BOOST_TEST(error_of(suffix, "\n \n").find("; expected") != std::string::npos, suffix);
    BOOST_TEST(error_of(suffix, std::string(200, '\0')).find("; expected") != std::string::npos, suffix);
  }
}

BOOST_AUTO_TEST_CASE(coordinates_are_nearest_doubles_in_every_text_format)
{
  const std::vector<std::string> words = {
      "0.1", "1e-400", "5e-324", "2.2250738585072011e-308", "9007199254740993", "1.7976931348623157e308", "-1e-5"};
  for (const std::string& word : words) {
    const double expected = *tetracone::kernel::parse_double(word);
    BOOST_TEST(read_text(".off", "OFF\n3 1 0\n0 0 " + word + "\n1 0 0\n0 1 0\n3 0 1 2\n").polyhedron.vertices[0][2] ==
                   expected,
               word);
    BOOST_TEST(
        read_text(".obj", "v 0 0 " + word + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").polyhedron.vertices[0][2] == expected,
        word);
    BOOST_TEST(read_text(".ply", ascii_ply("double", "int", word)).polyhedron.vertices[3][2] == expected, word);
    BOOST_TEST(read_text(".ply", ascii_ply("float", "int", word)).polyhedron.vertices[3][2] == expected, word);
    const std::string stl = "solid\nfacet normal 0 0 nan\nouter loop\nvertex 1 0 " + word +
                            "\nvertex 0 1 0\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n";
    BOOST_TEST(read_text(".stl", stl).polyhedron.vertices[0][2] == expected, word);
  }
  BOOST_TEST(read_text(".ply", binary_ply(false)).polyhedron.vertices[3][2] == 0.1);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_are_refused_with_their_line)
{
  for (const std::string word : {"nan", "-nan", "inf", "-inf", "1e400", "-1e400", "x", "1/2", "0x10", "1.0.0", "1,5"}) {
    check_refused(".off", ":4", "OFF\n3 1 0\n0 0 0\n1 0 ", {word + "\n0 1 0\n3 0 1 2\n"});
    check_refused(".obj", ":2", "v 0 0 0\nv 1 0 ", {word + "\nv 0 1 0\nf 1 2 3\n"});
    check_refused(".ply", ":13", "", {ascii_ply("double", "int", word)});
    check_refused(".stl", ":4", "solid\nfacet normal 0 0 1\nouter loop\nvertex 1 0 ", {word + "\n"});
    check_refused(".poly", ":3", "2 3 0 0\n1 0 0 0\n2 0 0 ", {word + "\n"});
  }
  auto triangles = tetrahedron_triangles;
  triangles[1][4] = std::numeric_limits<float>::infinity();
  BOOST_TEST(
      error_of(".stl", binary_stl(triangles, 4)).starts_with(": triangle 1 has a coordinate that is no finite number"));
}

BOOST_AUTO_TEST_CASE(every_truncation_is_read_or_refused_in_one_line)
{
  const std::vector<std::pair<std::string, std::string>> files = {{".off", tetrahedron_off},
                                                                  {".obj", tetrahedron_obj},
                                                                  {".ply", ascii_ply("double", "int")},
                                                                  {".ply", binary_ply(true)},
                                                                  {".stl", binary_stl(tetrahedron_triangles, 4)},
                                                                  {".poly", read_bytes(models + "frame.poly")}};
  for (const auto& [suffix, text] : files)
    for (std::size_t length = 0; length < text.size(); ++length) {
      const std::string error = error_of(suffix, text.substr(0, length));
      // Text may lack its last line end or the end of its last number. An OBJ does not say how many faces it has, and a
      // POLY may end before its lists of holes.
      if (error == "no error")
        BOOST_TEST((suffix == ".obj" || suffix == ".poly" || length + 4 > text.size()));
      else
        BOOST_TEST(error.find("; expected") != std::string::npos);
    }
}

BOOST_AUTO_TEST_CASE(counts_beyond_the_file_are_refused_without_reserving_for_them)
{
  for (const std::string huge :
       {"1000000", "4294967295", "4294967296", "18446744073709551615", "99999999999999999999999", "-1"}) {
    check_refused(".off", ":2", "OFF\n", {huge + " 1 0\n0 0 0\n", "3 " + huge + " 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"});
    check_refused(".off", ":6", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", {huge + " 0 1 2\n"});
    check_refused(".poly", ":1", huge, {" 3 0 0\n1 0 0 0\n"});
    check_refused(".ply", ":3", "ply\nformat ascii 1.0\nelement vertex ", {huge + "\n"});
  }
  BOOST_TEST(error_of(".stl", binary_stl(tetrahedron_triangles, 0xffffffff))
                 .starts_with(": binary STL of 4294967295 triangles in 284 bytes"));
  const std::string list =
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list int int vertex_indices\nend_header\n";
  BOOST_TEST(error_of(".ply", list + bytes(std::int32_t{0x7fffffff})).find("count of vertex_indices") !=
             std::string::npos);
  BOOST_TEST(error_of(".ply", list + bytes(std::int32_t{-3})).find("-3 as count") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(faces_of_one_or_two_corners_are_left_out_with_a_note)
{
  const std::string left_out = "faces of one or two corners are left out, and faces are numbered without them: ";
  const auto take = [&](const std::string& suffix, const std::string& text, const std::string& count) {
    const Read_model model = read_tetrahedron(suffix, text);
    BOOST_TEST(model.notes.at(0) == left_out + count, text);
  };
  take(".off", "OFF\n4 6 6\n" + tetrahedron_vertices + "2 0 1\n1 3 255 0 0\n" + tetrahedron_faces,
       "2 (the first: line 7)");
  take(".obj", "4 5\n" + tetrahedron_obj + "f 1/1 -1\n", "1 (the first: line 10)");
  std::string ply = ascii_ply("double", "int", "1");
  ply.replace(ply.find("face 4"), 6, "face 5").append("2 0 3\n");
  take(".ply", ply, "1 (the first: line 18)");
  // Their indices must be right all the same, and they are no model.
  check_refused(".off", ":7", "", {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 3\n"});
  check_refused(".obj", ":5", "", {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 4\n"});
  BOOST_TEST(error_of(".obj", "v 0 0 0\nv 1 0 0\nf 1 2\n") == ": no face; expected a model with faces");
}

BOOST_AUTO_TEST_CASE(models_without_a_face_and_faces_of_no_corner_are_refused)
{
  BOOST_TEST(error_of(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0 0\n") ==
             ":6: a face of 0 corners; expected at least 3");
  BOOST_TEST(error_of(".obj", "v 0 0 0\nv 1 0 0\nf\n") == ":3: a face of 0 corners; expected at least 3");
  BOOST_TEST(error_of(".poly", "3 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0\n1 0\n1 1\n") ==
             ":7: a face of 1 corner; expected at least 3");
  BOOST_TEST(error_of(".off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n") == ": no face; expected a model with faces");
  BOOST_TEST(error_of(".obj", "v 0 0 0\n") == ": no face; expected a model with faces");
  BOOST_TEST(error_of(".stl", "solid\nendsolid\n") == ": no face; expected a model with faces");
  BOOST_TEST(error_of(".stl", binary_stl({}, 0)) == ": no face; expected a model with faces");
}

BOOST_AUTO_TEST_CASE(off_takes_comments_blank_lines_colours_and_normals)
{
  const std::string commented = "# first\n\n  OFF # keyword\n# counts\n4 4 6 # here\n\n" + tetrahedron_vertices +
                                "# faces\n" + tetrahedron_faces + "\n# end\n";
  read_tetrahedron(".off", commented);
  BOOST_TEST(read_text(".off", commented).notes.empty());
  read_tetrahedron(".off", "OFF 4 4 0\r\n" + tetrahedron_vertices + tetrahedron_faces);
  const std::string tail = tetrahedron_vertices + "3 0 2 1 0.5 0.5 0.5\n3 0 1 3 255 0 0\n3 1 2 3 7\n3 2 0 3\n";
  read_tetrahedron(".off", "OFF\n4 4 6\n" + tail);
  const std::string coloured = "0 0 0 255 0 0\n1 0 0 0.5 0 0 1\n0 1 0\n0 0 1 3\n";
  read_tetrahedron(".off", "COFF\n4 4 6\n" + coloured + tetrahedron_faces);
  const std::string normals = "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n";
  read_tetrahedron(".off", "NOFF\n4 4 6\n" + normals + tetrahedron_faces);
  const std::string textured = "0 0 0 0.5 0.5\n1 0 0 0 1\n0 1 0 1 0\n0 0 1 1 1\n";
  read_tetrahedron(".off", "STOFF\n4 4 6\n" + textured + tetrahedron_faces);
  // Files that CGAL's reader does not take.
  const Read_model stuck = read_tetrahedron(".off", " \tOFF4 4 6\n" + tetrahedron_vertices + tetrahedron_faces);
  BOOST_TEST(stuck.notes.at(0) == note);
  read_tetrahedron(".off", "OFF\n4 4\n" + tetrahedron_vertices + tetrahedron_faces);
}

BOOST_AUTO_TEST_CASE(off_refuses_what_it_cannot_mean)
{
  const std::string triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", behind_first = "\n1 0 0\n0 1 0\n3 0 1 2\n";
  check_refused(".off", ":1", "",
                {"OFFF\n4 4 6\n", "NNOFF\n4 4 6\n", "OFF BINARY\n", "4OFF\n1 1 1\n", "nOFF 3\n1 1 1\n"});
  check_refused(".off", ":2", "", {"OFF\n4\n4 6\n"});
  check_refused(".off", ":3", "OFF\n3 1 0\n0 0", {behind_first, " 0 z" + behind_first});
  check_refused(".off", ":3", "N" + triangle, {"3 0 1 2\n"});
  check_refused(".off", ":6", triangle, {"3 0 1 3\n", "3 0 -1 2\n", "3 0 1.5 2\n", "3 0 1\n"});
  check_refused(".off", ":7", triangle_off, {"3 0 1 2\n"});
}

BOOST_AUTO_TEST_CASE(obj_takes_negative_indices_every_form_of_corner_comments_in_lines_and_other_names_of_faces)
{
  const std::string vertices =
      "# tetrahedron\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1\nv 0 1 0 0.5 0.5 0.5\nv 0 0 1\nvt 0 0\nvn 0 0 1\ng "
      "1\ns off\nusemtl\n";
  for (const std::string& faces : std::vector<std::string>{
           obj_faces, "f 1/1 3/1 2/1\nf 1/1/1 2/1/1 4/1/1\nf 2//1 3//1 4//1 # last\nf 3/ 1// 4/1/\n",
           "f -4 -2 -3\nf -4 -3 -1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\nf 3 -4 4\n"}) {
    const Read_model model = read_tetrahedron(".obj", vertices + faces);
    BOOST_TEST(model.notes.empty(), faces);
  }
  for (const std::string& faces :
       std::vector<std::string>{"f 1\t3\t2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", "f 1 \\\n3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
                                "l 1 2\n" + obj_faces}) {
    const Read_model model = read_tetrahedron(".obj", vertices + faces);
    BOOST_TEST(model.notes.at(0) == note, faces);
  }
  const std::string surface = "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nend\n";
  BOOST_TEST(read_tetrahedron(".obj", vertices + obj_faces + surface).notes.at(0) ==
             "free-form surfaces are left out: 1 (the first: line 19)");
  read_tetrahedron(".obj", "4 4\n" + tetrahedron_obj);
  read_tetrahedron(".obj",
                   "v 0 0 0#origin\nv 1 0 0 # x\nv 0 1 0\nv 0 0 1\n#\nf 1 3 2#\nfo 1 2 4\nf 2 3 "
                   "4# last\nf 3 1 4\nusemtl a#b\n");
  BOOST_TEST(read_text(".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nq 1 2 3 4\n").polyhedron.loop(0, 0).size() == 4u);
}

BOOST_AUTO_TEST_CASE(obj_refuses_what_it_cannot_mean)
{
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  check_refused(".obj", ":4", vertices,
                {"f 0 1 2\n", "f 1 2 -4\n", "f 1 2 x\n", "f 1 2 3.0\n", "f 1 2 /3\n", "f 1 2 3/4/5/6\n", "f 1 2 3/x\n",
                 "f 1 2 99999999999999999999\n", "q 1 2 3\n", "f 1 2 3 \\\n"});
  // An index may come before its vertex, if it comes: the first one that does not is named.
  BOOST_TEST(read_text(".obj", "f 1 2 3\n" + vertices).polyhedron.face_count() == 1u);
  check_refused(".obj", ":5", "f 1 2 3\n" + vertices, {"f 1 2 4\nf 1 2 9\n"});
  check_refused(".obj", ":1", "v 0 0", {"\n", " 0 0 0\n"});
  BOOST_TEST(error_of(".obj", "3 2\n" + vertices + "f 1 2 3\n") ==
             ": 3 vertices and 1 faces; expected 3 and 2 as the first line counts");
}

BOOST_AUTO_TEST_CASE(ply_takes_any_order_and_type_of_properties)
{
  for (const bool big : {false, true}) {
    const Polyhedron model = read_text(".ply", binary_ply(big)).polyhedron;
    BOOST_TEST(model.vertices.size() == 4u);
    BOOST_TEST((model.vertices[2] == tetracone::kernel::Vertex{0, 1, 0}));
    BOOST_TEST((model.vertices[3] == tetracone::kernel::Vertex{0, 0, 0.1}));
    BOOST_TEST(is_closed(model));
  }
  const Polyhedron plain = read_text(".ply", ascii_ply("double", "int")).polyhedron;
  for (const std::string index : {"char", "uchar", "short", "ushort", "uint", "int32", "uint8"})
    BOOST_TEST(same(plain, read_text(".ply", ascii_ply("float64", index)).polyhedron), index);
  BOOST_TEST(
      same(read_text(".off", tetrahedron_off).polyhedron, read_text(".ply", ascii_ply("int", "int", "1")).polyhedron));
  std::string late = ascii_ply("double", "int");
  late.insert(4, "comment before the format\n\nobj_info x\n");
  BOOST_TEST(same(plain, read_text(".ply", late).polyhedron));
  BOOST_TEST(read_text(".ply", late).notes.at(0) == note);
}

BOOST_AUTO_TEST_CASE(ply_refuses_what_it_cannot_mean)
{
  const std::string good = ascii_ply("double", "int");
  const auto without = [&good](const std::string& line) {
    std::string text = good;
    return text.erase(text.find(line), line.size());
  };
  const auto instead = [&good](const std::string& line, const std::string& other) {
    std::string text = good;
    return text.replace(text.find(line), line.size(), other);
  };
  const auto refused = [](const std::string& line, const std::string& text) {
    check_refused(".ply", line, "", {text});
  };
  refused(":1", "plyx\n");
  refused(":8", without("format ascii 1.0\n"));
  refused(":3", without("property double x\n"));
  refused(":7", without("property list uchar int vertex_index\n"));
  refused(":3", without("element vertex 4\n"));
  refused(":4", instead("property double x", "property real x"));
  refused(":5", instead("property double y", "property double x"));
  refused(":8", instead("list uchar int", "list float int"));
  refused(":7", instead("list uchar int", "list uchar float"));
  refused(":2", instead("ascii 1.0", "ascii 2.0"));
  refused(":2", instead("ascii", "binary"));
  for (const std::string face : {"3 0 2 4\n", "3 0 2 -1\n", "4 0 2 1\n", "3 0 2 1 0\n", "300 0 2 1\n"})
    refused(":14", instead("3 0 2 1\n", face));
  refused(":11", instead("1 0 0\n", "1 0\n"));
  refused(":18", good + "1\n");
  BOOST_TEST(error_of(".ply", binary_ply(false) + "x").starts_with(": 1 bytes behind the last element"));
  BOOST_TEST(error_of(".ply", binary_ply(false) + "\n") == "no error");
}

BOOST_AUTO_TEST_CASE(stl_merges_exactly_equal_vertices_and_nothing_else)
{
  const Polyhedron open = read(models + "open.stl");
  BOOST_TEST(open.vertices.size() == 4u);
  BOOST_TEST(open.face_count() == 3u);
  auto triangles = tetrahedron_triangles;
  triangles[2][0] = std::nextafter(1.0f, 2.0f);
  const Polyhedron cracked = read_text(".stl", binary_stl(triangles, 4)).polyhedron;
  BOOST_TEST(cracked.vertices.size() == 5u);
  BOOST_TEST(!is_closed(cracked));
}

BOOST_AUTO_TEST_CASE(stl_takes_several_solids_capitals_and_odd_names)
{
  BOOST_TEST(
      read_text(".stl", "solid a\n" + facet + "endsolid a\nsolid b\n" + facet + "endsolid\n").polyhedron.face_count() ==
      2u);
  const Read_model named = read_text(".stl", "solid a solid facet\n" + facet + "endsolid a solid facet\n");
  BOOST_TEST(named.polyhedron.face_count() == 1u);
  BOOST_TEST(named.notes.at(0) == note);
  std::string capitals = "solid a\n" + facet + "endsolid a\n";
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  BOOST_TEST(read_text(".stl", capitals).polyhedron.face_count() == 1u);
}

BOOST_AUTO_TEST_CASE(stl_refuses_what_it_cannot_mean)
{
  check_refused(".stl", ":8", "solid\n", {facet});
  check_refused(".stl", ":6", "solid\n", {facet.substr(0, 60) + "\nendsolid\n"});
  check_refused(".stl", ":2", "solid\n", {"facet 0 0 1\n", "vertex 0 0 1\n"});
  check_refused(".stl", ":4", "solid\nfacet normal 0 0 1\nouter loop\n", {"vertex 0 0\n"});
  check_refused(".stl", ":10", "solid\n" + facet, {"endsolid\nmore\n"});
  check_refused(".stl", ":7", "solid\n", {facet_ending("vertex 1 1 0", "endloop")});
  BOOST_TEST(error_of(".stl", binary_stl(tetrahedron_triangles, 5)) ==
             ": binary STL of 5 triangles in 284 bytes; expected 334 bytes");
  // Faces that could be triangles are not left out.
  for (const std::uint32_t count : {1, 3})
    BOOST_TEST(error_of(".stl", binary_stl(tetrahedron_triangles, count)).starts_with(": binary STL of "));
  const std::string whole = binary_stl(tetrahedron_triangles, 4);
  BOOST_TEST(error_of(".stl", whole + whole).starts_with(": binary STL of 4 triangles in 568 bytes"));
  BOOST_TEST(error_of(".stl", binary_stl(tetrahedron_triangles, 0) + "x").starts_with(": binary STL of 0 triangles"));
}

BOOST_AUTO_TEST_CASE(obj_loses_nothing_behind_a_backslash)
{
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", last = "v 0 0 1\n", faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\n";
  for (const std::string statement :
       {"g C:\\parts\\", "o C:\\parts\\", "usemtl C:\\parts \\", "mtllib a\\", "s off\\", "vn 0 0 1\\", "vt 0 0 \\",
        "l 1 2 \\", "g a \\\n\n", "g a \\\nb c\\", "vn 0 0 \\\n1 \\", "csh -e ls \\"}) {
    const Read_model face = read_tetrahedron(".obj", vertices + last + faces + statement + "\nf 3 1 4\n");
    BOOST_TEST(face.notes.at(0).find(
                   "lines behind one that ends in a backslash are read as statements of their own: 1 (") == 0u,
               statement);
    read_tetrahedron(".obj", vertices + statement + "\n" + last + faces + "f 3 1 4\n");
  }
  // Names and numbers go on; a name may end the file.
  for (const std::string more : {"g a \\\nb c\n", "vn 0 0 \\\n 1\n", "# C:\\parts\\\n", "g a # C:\\\n", ""}) {
    const Read_model model = read_tetrahedron(".obj", vertices + last + faces + more + "f 3 1 \\\n 4\ng C:\\parts\\");
    BOOST_TEST(model.notes.size() == 1u, more);  // that CGAL is not asked
  }
  // A vertex or a face goes on in whatever follows.
  for (const std::string line :
       {"f 1 2 4\\\nf 2 3 4\n", "v 0 0 1\\\nv 0 0 2\n", "v 0 0 1\\\nvn 0 0 2\n", "f 1 2 3\\\ng a\n"})
    check_refused(".obj", ":5", vertices, {line});
}

BOOST_AUTO_TEST_CASE(numbers_that_no_face_uses_need_not_be_finite)
{
  const std::string faces = obj_faces, rest = "v 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (const std::string word :
       {"nan", "NaN", "-nan", "-nan(ind)", "inf", "-Infinity", "1e999", "-1.#IND", "1.#QNAN0", "1.#INF00"}) {
    for (const std::string& vertex : {"v 0 0 0 " + word, "v 0 0 0 " + word + " 0 0", "v 0 0 0 1 0 0 " + word,
                                      "vt " + word + "\nvn 0 0 " + word + "\nv 0 0 0"})
      read_tetrahedron(".obj", vertex + "\n" + rest + faces);
    // A point of no face; one of a face is refused with its line, be it the last of the file.
    const std::string note_of_point =
        "points of no face whose coordinates are no finite numbers, each taken to be at vertex ";
    const Read_model obj = read_text(".obj", "v 0 0 0\n" + rest + faces + "v 1 " + word + " 0\nv 5 5 5\n");
    BOOST_TEST((obj.polyhedron.vertices.at(4) == Vertex{0, 0, 0}), word);
    BOOST_TEST((obj.polyhedron.vertices.at(5) == Vertex{5, 5, 5}), word);
    BOOST_TEST(obj.notes.at(0) == note_of_point + "0: 1 (the first: vertex 4)", word);
    check_refused(".obj", ":9", "v 0 0 0\n" + rest + faces, {"v 1 " + word + " 0\nf 1 2 5\n"});
    if (word.find('#') != std::string::npos) continue;  // a comment begins there
    const std::string counts = "OFF\n6 4 0\n", points = word + " 0 0\n" + tetrahedron_vertices + "0 0 " + word + "\n",
                      off_faces = "3 1 3 2\n3 1 2 4\n3 2 3 4\n3 3 1 4\n";
    const Read_model off = read_text(".off", counts + points + off_faces);
    BOOST_TEST((off.polyhedron.vertices.front() == Vertex{0, 0, 0}), word);
    BOOST_TEST(off.notes.at(0) == note_of_point + "1: 2 (the first: vertex 0)", word);
    check_refused(".off", ":8", counts + points, {"3 1 3 2\n3 1 2 4\n3 2 3 4\n3 3 1 5\n"});
    std::string ply = ascii_ply("double", "int", "1");
    ply.replace(ply.find("vertex 4"), 8, "vertex 5").insert(ply.find("3 0 2 1"), "0 0 " + word + "\n");
    BOOST_TEST(read_text(".ply", ply).notes.at(0) == note_of_point + "0: 1 (the first: vertex 4)", word);
    check_refused(".ply", ":14", "", {ply.replace(ply.rfind("3 2 0 3"), 7, "3 2 0 4")});
    read_tetrahedron(
        ".off", "NOFF\n4 4 6\n0 0 0 0 0 " + word + "\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n" + tetrahedron_faces);
    const Read_model poly =
        read_text(".poly", "5 3 1\n1 0 0 0 " + word + "\n2 1 0 0 1\n3 0 1 0 1\n4 0 0 1 1\n5 0 " + word +
                               " 0 1\n4 0\n1\n3 1 3 2\n1\n3 1 2 4\n1\n3 2 3 4\n1\n3 3 1 4\n0\n");
    BOOST_TEST(poly.notes.at(0) == note_of_point + "0: 1 (the first: vertex 4)", word);
  }
  std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const float infinite = std::numeric_limits<float>::infinity();
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, infinite, 0.f, 0.f}) binary += bytes(x);
  const auto face = [](int a, int b, int c) { return "\3" + bytes(a) + bytes(b) + bytes(c); };
  BOOST_TEST(read_text(".ply", binary + face(0, 1, 2)).polyhedron.vertices.size() == 4u);
  BOOST_TEST(error_of(".ply", binary + face(0, 1, 3)) ==
             ": x of vertex 3 is no finite number; expected finite coordinates");
}

BOOST_AUTO_TEST_CASE(off_takes_every_order_of_its_prefixes_no_keyword_and_lines_behind_the_last_face)
{
  const std::string vertices =
      "0 0 0 1 2 3 4 0 0 1 0 0\n1 0 0 1 2 3 4 0 0 1 0 0\n0 1 0 1 2 3 4 0 0 1 0 0\n0 0 1 1 2 3 4 0 0 "
      "1 0 0\n";
  for (const std::string keyword : {"NCSTOFF", "STCNOFF", "NCOFF", "CNOFF", "NSTOFF", "CSTOFF"})
    read_tetrahedron(".off", keyword + "\n4 4 6\n" + vertices + tetrahedron_faces);
  read_tetrahedron(".off", "4 4 6\n" + tetrahedron_vertices + tetrahedron_faces);
  for (const std::string line : {"0.5 0.5 0.5", "7", "end", "3 0 1 9", "3 0 1"}) {
    const Read_model model = read_tetrahedron(".off", tetrahedron_off + line + "\n");
    BOOST_TEST(model.notes.at(0) == "lines behind the last face are left out: 1 (the first: line 11)", line);
  }
  for (const std::string line : {"3 0 1 2", "2 0 1", "3 0 1 2 255 0 0", "x\n4 0 1 2 3"})
    BOOST_TEST(
        error_of(".off", tetrahedron_off + line + "\n").find("more faces than the header counts") != std::string::npos,
        line);
}

BOOST_AUTO_TEST_CASE(stl_takes_what_other_programs_write)
{
  const Polyhedron plain = read_text(".stl", "solid\n" + facet + "endsolid\n").polyhedron;
  for (const std::string& text :
       {"solid\tpart\n" + facet + "endsolid\tpart\n", "solid\vpart\n" + facet + "endsolid\n",
        "solid part\n" + facet + "end solid part\n",
        "solid part\n" + facet_ending("end loop", "end facet") + "END SOLID\n",
        "solid part\n" + facet + "endsolidpart\n", "solidpart\n" + facet + "endsolid\n",
        "solid\ncolor 0.5 0.5 nan\n" + facet + "endsolid\n", "solid\ncolor\n1 0 0\n" + facet + "color\nendsolid",
        std::string(
            "solid a facet normal\tnan 0 1 outer\nloop vertex 0 0 0 vertex 1\n0 0 vertex 0 1 0 endloop endfacet ") +
            "endsolid a\n",
        "\xef\xbb\xbf solid\r\n" + facet + "endsolid\r\n"}) {
    const Read_model model = read_text(".stl", text);
    BOOST_TEST(same(plain, model.polyhedron), text);
  }
  for (const std::string& text : {"solid\n" + facet_ending("end", "endfacet") + "endsolid\n",
                                  "solid\n" + facet + "end\n", "solid\n" + facet + "endsolid\n" + facet})
    BOOST_TEST(error_of(".stl", text).find("; expected") != std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(binary_stl_takes_a_count_of_0_attributes_and_bytes_behind_the_last_triangle)
{
  const std::string usual = binary_stl(tetrahedron_triangles, 4);
  const Polyhedron plain = read_text(".stl", usual).polyhedron;
  const auto take = [&](const std::string& text, const std::string& said) {
    const Read_model model = read_text(".stl", text);
    BOOST_TEST(same(plain, model.polyhedron), said);
    BOOST_TEST(model.notes.at(0) == said);
  };
  take(usual + "\n", "bytes behind the last triangle are left out: 1");
  take(usual + std::string(412, 'x'), "bytes behind the last triangle are left out: 412");
  take(usual + std::string(412, '\0'), "bytes behind the last triangle are left out: 412");
  // A count that is too small loses no triangle, whatever else is behind it.
  for (const int counted : {1, 3})
    BOOST_TEST(error_of(".stl", binary_stl(tetrahedron_triangles, counted) + "\n").starts_with(": binary STL of "));
  take(binary_stl(tetrahedron_triangles, 0),
       "the count of triangles is 0: those up to the end of the file are read, 4");
  std::string attributes = usual.substr(0, 84);
  for (int t = 0; t < 4; ++t)
    attributes += usual.substr(84 + 50 * t, 48) + bytes(std::uint16_t(7 * t)) + std::string(7 * t, 'a');
  take(attributes, "bytes of attributes behind triangles are left out: 42");
  BOOST_TEST(error_of(".stl", attributes.substr(0, attributes.size() - 43)).starts_with(": binary STL of 4 triangles"));
  // Carriage returns without a line feed are bytes as others.
  std::string returns = usual;
  std::fill(returns.begin(), returns.begin() + 80, '\r');
  take(returns + "\r", "bytes behind the last triangle are left out: 1");
  // CGAL reads a header that is a whole text, without triangles.
  std::string text = "solid a\nendsolid a\n";
  text.resize(80, ' ');
  const Read_model model = read_text(".stl", text + usual.substr(80));
  BOOST_TEST(same(plain, model.polyhedron));
  BOOST_TEST(model.notes.at(0).starts_with("CGAL's reader finds something else in the file"));
}

BOOST_AUTO_TEST_CASE(ply_takes_strips_wedges_and_carriage_returns)
{
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const Polyhedron strip = read_text(".ply", vertices +
                                                 "element tristrips 1\nproperty list int int vertex_indices\n"
                                                 "end_header\n" +
                                                 points + "13 0 2 1 3 0 2 -1 0 1 -1 1 2 2\n")
                               .polyhedron;
  BOOST_TEST_REQUIRE(strip.face_count() == 4u);
  BOOST_TEST(is_closed(strip));
  BOOST_TEST((loop(strip, 0) == std::vector<Index>{0, 2, 1}));
  BOOST_TEST((loop(strip, 1) == std::vector<Index>{1, 2, 3}));
  // Strips and faces, in the order of the file; a binary strip whose type has no sign.
  std::string both =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\nelement tristrips 1\nproperty list uint uint vertex_indices\nelement face 1\nproperty list "
      "uchar int vertex_indices\nend_header\n";
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) both += bytes(x);
  both += bytes(std::uint32_t{5});
  for (const std::uint32_t v : {0xffffffffu, 0u, 2u, 1u, 3u}) both += bytes(v);
  both += "\3" + bytes(0) + bytes(1) + bytes(3);
  BOOST_TEST(read_text(".ply", both).polyhedron.face_count() == 3u);
  BOOST_TEST(error_of(".ply", vertices + "end_header 3\n") == ":7: 2 words; expected 'end_header' alone");
  BOOST_TEST(error_of(".ply", vertices + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                                  points + "3 0 1 4\n")
                 .starts_with(":14: vertex index 4"));
  // VCGLIB: texture coordinates and colours of wedges, and colours that its header promises and its lines lack.
  const std::string wedges = vertices +
                             "element face 4\nproperty list uchar int vertex_indices\nproperty list uchar float "
                             "texcoord\nproperty int texnumber\nproperty uchar red\nproperty list uchar float "
                             "color\nend_header\n" +
                             points;
  for (const std::string more : {" 9 0 0 0 1 1 1 nan 1 1", "", " 9 0 0 0"}) {
    std::string text = wedges;
    for (const std::string face : {"3 0 2 1", "3 0 1 3", "3 1 2 3", "3 2 0 3"})
      text += face + " 6 0 0 1 1 0 1 2 255" + more + "\n";
    const Read_model model = read_tetrahedron(".ply", text);
    BOOST_TEST(model.notes.at(0).starts_with("lines that lack") == !more.ends_with("nan 1 1"), more);
  }
  // The header's lines may end in carriage returns alone, and a coordinate's first byte may be a line feed.
  for (const bool big : {false, true}) {
    std::string returns = binary_ply(big);
    const std::size_t header = returns.find("end_header\n") + 11;
    std::replace(returns.begin(), returns.begin() + std::ptrdiff_t(header), '\n', '\r');
    const Polyhedron usual = read_text(".ply", binary_ply(big)).polyhedron;
    BOOST_TEST(same(usual, read_text(".ply", returns).polyhedron));
    returns[header + (big ? 3 : 0)] = '\n';
    BOOST_TEST(read_text(".ply", returns).polyhedron.vertices[0][0] == std::bit_cast<float>(0x0au));
  }
  // The header's format line alone decides whether a file is binary.
  std::string text = ascii_ply("double", "int");
  text.insert(text.find("element vertex"), "comment format binary_little_endian 1.0\n");
  std::replace(text.begin(), text.end(), '\n', '\r');
  BOOST_TEST(read_text(".ply", text).polyhedron.face_count() == 4u);
}

BOOST_AUTO_TEST_CASE(spellings_of_other_programs_are_the_same_tetrahedron)
{
  // The seeds of the fuzz targets.
  for (const char* suffix : {"off", "obj", "ply", "stl"}) {
    const Read_model model = read_with_notes(models + "spellings." + suffix);
    BOOST_TEST(model.polyhedron.face_count() == 4u, suffix);
    BOOST_TEST(is_closed(model.polyhedron), suffix);
    BOOST_TEST(model.notes.empty() == (suffix == std::string("stl")), suffix);
  }
}

BOOST_AUTO_TEST_CASE(merging_keeps_the_first_of_equal_vertices_and_all_loops)
{
  Polyhedron polyhedron;
  polyhedron.vertices = {{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
  polyhedron.add_face({{0, 1, 3}, {2, 4, 5}});
  const Polyhedron merged = merge_equal_vertices(polyhedron);
  BOOST_TEST(merged.vertices.size() == 3u);
  BOOST_TEST((loop(merged, 0) == std::vector<Index>{0, 1, 2}));
  BOOST_TEST((loop(merged, 0, 1) == std::vector<Index>{0, 1, 0}));
  BOOST_TEST(!std::signbit(merged.vertices[0][0]));
  BOOST_TEST(same(merged, merge_equal_vertices(merged)));
}

BOOST_AUTO_TEST_SUITE_END()
