#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/face_cover.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/planarity.h"
#include "tetracone/covering/star_faces.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/body_file.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace tetracone {
namespace {

using covering::Index;

/// Throws Error, in the name of `name`, for a polyhedron that is not legal.
void require_legal(const Polyhedron& polyhedron, const std::string& name)
{
  const auto fail = [&](const std::string& wrong, const std::string& expected) {
    throw Error(name + ": " + wrong + "; expected " + expected);
  };
  if (polyhedron.face_count() == 0) fail("no face", "a body with faces");
  if (!polyhedron.has_legal_loops()) fail("a face lacks a loop, or a loop lacks a vertex", "one vertex or more a loop");
  const auto vertices = [&] { return "of " + std::to_string(polyhedron.vertices.size()) + " vertices"; };
  for (std::size_t v = 0; v < polyhedron.vertices.size(); ++v)
    for (const double x : polyhedron.vertices[v])
      if (!std::isfinite(x))
        fail("vertex " + std::to_string(v) + " has the coordinate " + kernel::shortest(x), "finite coordinates");
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    covering::for_each_directed_edge(polyhedron, f, [&](Index from, Index) {
      if (from >= polyhedron.vertices.size())
        fail("face " + std::to_string(f) + " names vertex " + std::to_string(from) + " " + vertices(),
             "numbers from 0 to " + std::to_string(polyhedron.vertices.size()) + ", the last excluded");
    });
    if (!polyhedron.is_triangle(f) && covering::planarity(polyhedron, f) == covering::Planarity::off_plane)
      fail("face " + std::to_string(f) + " has a corner " +
               kernel::shortest(covering::deviation(polyhedron, f).distance) + " off its plane",
           "exactly planar faces (tetracone/repair.h replaces others by triangles)");
  }
}

/// Throws Error, in the name of `name`, for triangles that do not cover their faces. Requires a legal polyhedron.
void require_legal(const Polyhedron& polyhedron, const std::vector<Face_triangle>& triangles, const std::string& name)
{
  for (const Face_triangle& t : triangles) {
    if (t.face >= polyhedron.face_count())
      throw Error(name + ": a triangle of face " + std::to_string(t.face) + " of " +
                  std::to_string(polyhedron.face_count()) + "; expected a face's number");
    for (const Index v : t.corner)
      if (v >= polyhedron.vertices.size())
        throw Error(name + ": a triangle of face " + std::to_string(t.face) + " names vertex " + std::to_string(v) +
                    "; expected a vertex's number");
  }
  if (const auto flaw = covering::cover_flaw(polyhedron, triangles))
    throw Error(name + ": face " + std::to_string(flaw->face) + ": " + flaw->wrong +
                "; expected triangles that cover exactly the face");
}

/// Returns `given`, and the fans of the faces without given triangles.
std::vector<Face_triangle> with_fans(const Polyhedron& polyhedron, std::vector<Face_triangle> given)
{
  std::vector<bool> has_triangles(polyhedron.face_count(), false);
  for (const Face_triangle& t : given) has_triangles[t.face] = true;
  for (const Face_triangle& t : covering::star_faces(polyhedron))
    if (!has_triangles[t.face]) given.push_back(t);
  return given;
}

std::shared_ptr<const detail::Body_data> checked(Polyhedron polyhedron, std::vector<Face_triangle> triangles,
                                                 const std::string& name)
{
  kernel::require_sound_floating_point();
  triangles = detail::legal_triangles(polyhedron, std::move(triangles), name);
  return std::make_shared<const detail::Body_data>(std::move(polyhedron), std::move(triangles));
}

}  // namespace

std::vector<Face_triangle> detail::legal_triangles(const Polyhedron& polyhedron, std::vector<Face_triangle> given,
                                                   const std::string& name)
{
  require_legal(polyhedron, name);
  require_legal(polyhedron, given, name);
  return with_fans(polyhedron, std::move(given));
}

const detail::Body_data& detail::data_of(const Body& body) { return *body.data_; }

void detail::require_solid(const Body_data& body, const std::string& who, const std::string& what)
{
  if (body.is_closed()) return;
  std::size_t open = 0, only_turned = 0;
  std::string first;
  const auto uses = covering::edge_uses(body.polyhedron);
  covering::for_each_edge(uses, [&](std::span<const covering::Edge_use> edge) {
    if (covering::surplus(edge) == 0) return;
    if (open++ == 0)
      first = "the edge from vertex " + std::to_string(edge[0].low) + " to " + std::to_string(edge[0].high);
    only_turned += edge.size() % 2 == 0;
  });
  throw Error(who + " is open at " + std::to_string(open) + (open == 1 ? " edge, " : " edges, first at ") + first +
              "; expected a closed surface for " + what +
              (only_turned == open ? " (consistent orientation may close it: tetracone/repair.h)" : ""));
}

Body::Body(Polyhedron polyhedron) : Body(std::move(polyhedron), {}) {}

Body::Body(Polyhedron polyhedron, std::vector<Face_triangle> triangles)
    : data_(checked(std::move(polyhedron), std::move(triangles), "body"))
{}

Body::Body(const std::filesystem::path& file)
    : data_(detail::is_body_file(file) ? detail::read_body_file(file)
                                       : checked(covering::read(file), {}, file.string()))
{}

const Polyhedron& Body::polyhedron() const { return data_->polyhedron; }

const std::vector<Face_triangle>& Body::triangles() const { return data_->triangles; }

bool Body::is_closed() const { return data_->is_closed(); }

void Body::make_all(std::size_t threads) const
{
  const auto most = std::size_t(tbb::this_task_arena::max_concurrency());
  if (threads == 0 || threads > most) threads = most;
  if (threads == 1) {
    data_->bvh8().make_all();
    return;
  }
  const auto soundly = [](const auto& what) {
    return [&what] {
      kernel::require_sound_floating_point();
      what();
    };
  };
  // An arena of its own: a thread that waits in it takes up no other work, which might ask this tree.
  tbb::task_arena arena{int(threads)};
  const auto both = [&](const auto& one, const auto& other) {
    arena.execute([&] { tbb::parallel_invoke(soundly(one), soundly(other)); });
  };
  const auto run = [&](const auto& work) {
    arena.execute(
        [&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, threads, 1), [&](const auto&) { work(); }); });
  };
  data_->bvh8(both).make_all(run, both);
}

Body read_body(const std::filesystem::path& file) { return Body(file); }

void save_body(const Body& body, const std::filesystem::path& file)
{
  body.make_all(0);
  detail::write_body_file(*body.data_, file);
}

}  // namespace tetracone
