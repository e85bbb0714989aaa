#include "experiments/support/model_file.h"

#include "tetracone/covering/check.h"
#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/door/body_file.h"
#include "tetracone/tetratree/door/repair.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <future>
#include <iostream>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace tetracone::experiments {
namespace {

[[noreturn]] void refuse_open(const std::string& file, const covering::Polyhedron& polyhedron)
{
  const covering::Check check = covering::check(polyhedron);
  const auto& edge = check.open_edges.front();
  throw covering::Input_error(
      file, 0,
      "an open surface has no solid: " + std::to_string(check.open_edges.size()) +
          " directed edges without enough reverse, the first from vertex " + std::to_string(edge.from) + " to " +
          std::to_string(edge.to),
      "expected a closed polyhedron, or --question surface if the command has it; " + what_closes(polyhedron));
}

std::vector<covering::Index> all_faces(const covering::Polyhedron& polyhedron)
{
  std::vector<covering::Index> faces(polyhedron.face_count());
  std::iota(faces.begin(), faces.end(), covering::Index(0));
  return faces;
}

Model_file saved_model(const std::string& file)
{
  const Body saved = read_body(file);
  return {file, saved, all_faces(saved.polyhedron())};
}

/// Returns `Model_file::inner_edges`: edges of several triangles of one face, and of no other face.
std::map<std::array<covering::Index, 2>, covering::Index> inner_edges(const Model_file& model)
{
  std::map<std::array<covering::Index, 2>, covering::Index> inner;
  const auto uses = covering::edge_uses(model.polyhedron());
  covering::for_each_edge(uses, [&](std::span<const covering::Edge_use> edge) {
    const covering::Index first = edge.front().face, last = edge.back().face;
    if (first != last && model.source_face[first] == model.source_face[last])
      inner[{edge.front().low, edge.front().high}] = model.source_face[first];
  });
  return inner;
}

/// Appends the lines for stderr to `lines`.
Model_file planar_model(const std::string& file, covering::Polyhedron polyhedron, bool strict, std::string& lines)
{
  auto planar = covering::triangulate_non_planar(std::move(polyhedron));
  if (!planar.replaced.empty()) {
    const std::string first = "face " + std::to_string(planar.replaced.front());
    if (strict)
      throw covering::Input_error(file, 0, first + " is not exactly planar", "expected planar faces with --strict");
    lines += file + ": " + std::to_string(planar.replaced.size()) + " faces are not exactly planar (first: " + first +
             "); replaced by triangles\n";
  }
  Model_file model{file, triangulated_body(std::move(planar.polyhedron)), std::move(planar.source)};
  if (!planar.replaced.empty()) model.inner_edges = inner_edges(model);
  return model;
}

/// As `load_model`, with the lines for stderr in `lines`.
Model_file load(const std::string& file, const Model_options& options, bool must_be_solid, std::string& lines)
{
  const bool is_saved = detail::is_body_file(file);
  const auto as_options_say = [&] {
    covering::Read_model read;
    if (is_saved)
      read.polyhedron = read_body(file).polyhedron();
    else
      read = covering::read_with_notes(file);
    for (const std::string& note : read.notes) lines += file + ": " + note + "\n";
    const bool is_changed = !read.notes.empty() || read.loops_turned + read.facets_turned > 0;
    covering::Polyhedron polyhedron = std::move(read.polyhedron);
    if (options.merge) polyhedron = covering::merge_equal_vertices(std::move(polyhedron));
    if (options.orient) polyhedron = covering::orient(polyhedron).polyhedron;
    Model_file model = planar_model(file, std::move(polyhedron), options.strict, lines);
    model.is_as_in_file = !is_saved && !options.merge && !options.orient && !is_changed;
    return model;
  };
  Model_file model = is_saved && !options.merge && !options.orient ? saved_model(file) : as_options_say();
  // Triangles that replace a face have its edges, so the model is open where the file is.
  if (must_be_solid && !model.body.is_closed()) refuse_open(file, model.polyhedron());
  return model;
}

}  // namespace

void Model_options::add_to(CLI::App& command, const char* on_strict)
{
  command.add_flag("--strict", strict, on_strict);
  command.add_flag("--merge", merge, "Merge vertices with exactly equal coordinates first");
  command.add_flag("--orient", orient, "Orient faces consistently first; what is closed as it stands is left alone");
}

Holder named_as_in_file(Holder holder, const Model_file& model)
{
  if (holder.kind == Holder::Kind::face) holder.number[0] = model.source_face[holder.number[0]];
  if (holder.kind != Holder::Kind::edge || model.inner_edges.empty()) return holder;
  const auto [low, high] = std::minmax(holder.number[0], holder.number[1]);
  const auto inner = model.inner_edges.find({low, high});
  return inner == model.inner_edges.end() ? holder : Holder{Holder::Kind::face, {inner->second}};
}

std::string what_closes(const covering::Polyhedron& polyhedron)
{
  if (covering::closes_if_oriented(polyhedron)) return "consistent orientation would close it: --orient";
  // Which faces go together at an edge of more than two is not searched, though some choice may close it.
  bool has_plain_edges = true;
  const auto uses = covering::edge_uses(polyhedron);
  covering::for_each_edge(
      uses, [&](std::span<const covering::Edge_use> edge) { has_plain_edges = has_plain_edges && edge.size() <= 2; });
  const std::string orientation =
      has_plain_edges ? "consistent orientation alone would not close it" : "--orient would not close it";
  const covering::Polyhedron merged = covering::merge_equal_vertices(polyhedron);
  if (covering::is_closed(merged)) return orientation + ", merging equal vertices would: --merge";
  if (covering::closes_if_oriented(merged))
    return orientation + ", merging equal vertices first would: --merge --orient";
  return orientation;
}

Model_file whole_model(const std::string& name, covering::Polyhedron polyhedron)
{
  std::vector<covering::Index> faces = all_faces(polyhedron);
  return {name, triangulated_body(std::move(polyhedron)), std::move(faces)};
}

Model_file load_model(const std::string& file, const Model_options& options, bool must_be_solid)
{
  std::string lines;
  Model_file model = load(file, options, must_be_solid, lines);
  std::cerr << lines;
  return model;
}

std::array<Model_file, 2> load_models(const std::string& a, const std::string& b, const Model_options& options,
                                      bool must_be_solid)
{
  std::string lines_of_b;
  auto loading_b = std::async(std::launch::async, [&] { return load(b, options, must_be_solid, lines_of_b); });
  Model_file model_a = load_model(a, options, must_be_solid), model_b = loading_b.get();
  std::cerr << lines_of_b;
  return {std::move(model_a), std::move(model_b)};
}

}  // namespace tetracone::experiments
