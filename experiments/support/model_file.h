#ifndef TETRACONE_EXPERIMENTS_SUPPORT_MODEL_FILE_H
#define TETRACONE_EXPERIMENTS_SUPPORT_MODEL_FILE_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tetracone::experiments {

/// The user's options for reading models.
struct Model_options {
  bool strict = false;  ///< refuse a face that is not exactly planar instead of replacing it by triangles
  bool orient = false;  ///< orient faces consistently first
  bool merge = false;   ///< merge vertices with exactly equal coordinates first

  /// Adds --strict, --merge and --orient. `on_strict` says what --strict does.
  void add_to(CLI::App& command, const char* on_strict =
                                     "Refuse a face that is not exactly planar; else it is replaced "
                                     "by triangles");
};

/// A model of a file, prepared for a tree: every face is planar.
struct Model_file {
  std::string file;
  Body body;  ///< with the nodes of its tree that the file has, or triangulated
  std::vector<covering::Index>
      source_face;             ///< for each face, the face of the file that it is, or is a triangle of; ascending
  bool is_as_in_file = false;  ///< the file has these vertices, and in their directions the faces of `source_face`; the
                               ///< reader had nothing to note
  /// The face, for each edge within a face that triangles replace; the file has no such edge. Its key is its vertices,
  /// the smaller number first.
  std::map<std::array<covering::Index, 2>, covering::Index> inner_edges = {};

  const covering::Polyhedron& polyhedron() const { return body.polyhedron(); }
};

/// Returns the holder as in the file: triangles that replace a face, and sides within it, become that face.
Holder named_as_in_file(Holder holder, const Model_file& model);

/// Returns, for an open polyhedron, a text that names the options that would close it, or says that orientation would
/// not.
std::string what_closes(const covering::Polyhedron& polyhedron);

/// Returns a model without a file of its own, from a polyhedron with planar faces.
Model_file whole_model(const std::string& name, covering::Polyhedron polyhedron);

/// Reads a model or a saved body, merged and oriented by the options, with its non-planar faces replaced by triangles.
/// Lines on stderr report replaced faces, and what the reader left out. Throws covering::Input_error for an unreadable
/// file, and with `strict` for a non-planar face. With `must_be_solid` it throws it for an open surface, and says where
/// it is open, and what would close it.
Model_file load_model(const std::string& file, const Model_options& options, bool must_be_solid);

/// Loads both at the same time; their lines and errors come as if they were loaded one after the other.
std::array<Model_file, 2> load_models(const std::string& a, const std::string& b, const Model_options& options,
                                      bool must_be_solid);

}  // namespace tetracone::experiments

#endif
