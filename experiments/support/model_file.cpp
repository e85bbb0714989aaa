#include "experiments/support/model_file.h"

#include "tetracone/covering/check.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/door/body_file.h"
#include "tetracone/tetratree/door/repair.h"

#include <algorithm>
#include <iostream>
#include <utility>

namespace tetracone::experiments {

Model_file load_model(const std::string& file, const Model_options& options, bool must_be_solid)
{
  std::optional<Body> saved;
  if (detail::is_body_file(file)) saved = read_body(file);
  covering::Polyhedron polyhedron = saved ? saved->polyhedron() : covering::read(file);
  if (options.merge || options.orient) saved.reset();
  if (options.merge) polyhedron = covering::merge_equal_vertices(polyhedron);
  if (options.orient) polyhedron = covering::orient(polyhedron).polyhedron;

  if (must_be_solid && !(saved ? saved->is_closed() : covering::is_closed(polyhedron))) {
    const covering::Check check = covering::check(polyhedron);
    const auto& edge = check.open_edges.front();
    const bool orientation_alone = covering::closes_if_oriented(polyhedron);
    throw covering::Input_error(file, 0,
                                "an open surface has no solid: " + std::to_string(check.open_edges.size()) +
                                    " directed edges without enough reverse, the first from vertex " +
                                    std::to_string(edge.from) + " to " + std::to_string(edge.to),
                                orientation_alone
                                    ? "expected a closed polyhedron; consistent orientation would close it: --orient"
                                    : "expected a closed polyhedron, or --question surface; consistent orientation "
                                      "alone would not close it");
  }

  auto triangulated = covering::triangulate_non_planar(polyhedron);
  if (!triangulated.replaced.empty()) {
    const std::string first = "face " + std::to_string(triangulated.replaced.front());
    if (options.strict)
      throw covering::Input_error(file, 0, first + " is not exactly planar", "expected planar faces with --strict");
    std::cerr << file << ": " << triangulated.replaced.size() << " faces are not exactly planar (first: " << first
              << "); replaced by triangles\n";
  }
  return {file, std::move(triangulated.polyhedron), std::move(triangulated.source), std::move(saved)};
}

Body Model_file::body() const { return saved ? *saved : triangulated_body(polyhedron); }

}  // namespace tetracone::experiments
