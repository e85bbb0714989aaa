#include "verify/shrink/shrink_faces.h"

#include "tetracone/covering/check.h"
#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/repair/repair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Question;
using Faces = std::vector<std::vector<std::vector<Index>>>;  // of loops of corners

Faces faces_of(const Polyhedron& polyhedron)
{
  Faces faces;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    faces.emplace_back();
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k)
      faces.back().emplace_back(polyhedron.loop(f, k).begin(), polyhedron.loop(f, k).end());
  }
  return faces;
}

/// The polyhedron of these faces, without unused vertices.
Polyhedron polyhedron_of(const std::vector<kernel::Vertex>& vertices, Faces faces)
{
  Polyhedron result;
  std::vector<std::optional<Index>> number(vertices.size());
  for (auto& face : faces)
    for (auto& loop : face)
      for (Index& v : loop) number[v] = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!number[v]) continue;
    number[v] = Index(result.vertices.size());
    result.vertices.push_back(vertices[v]);
  }
  for (auto& face : faces) {
    for (auto& loop : face)
      for (Index& v : loop) v = *number[v];
    result.add_face(face);
  }
  return result;
}

/// The loop without corners that follow their like.
std::vector<Index> without_repeats(const std::vector<Index>& loop)
{
  std::vector<Index> result;
  for (const Index v : loop)
    if (result.empty() || result.back() != v) result.push_back(v);
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

/// A loop's corners from the least on: equal for loops that start elsewhere.
std::vector<Index> from_least(std::vector<Index> loop)
{
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

/// Each vertex replaced by another, faces that vanish dropped, and pairs of triangles that cancel. Closed stays closed.
Faces merged(const Faces& faces, const std::vector<Index>& target)
{
  Faces result;
  for (const auto& face : faces) {
    std::vector<std::vector<Index>> loops;
    for (std::vector<Index> loop : face) {
      for (Index& v : loop) v = target[v];
      loop = without_repeats(loop);
      // There and back again is no loop.
      if (loop.size() > 2) loops.push_back(std::move(loop));
    }
    if (loops.empty()) continue;
    std::vector<std::vector<Index>> reverse;
    if (loops.size() == 1) reverse = {{loops[0].rbegin(), loops[0].rend()}};
    const auto cancelled = std::find_if(result.begin(), result.end(), [&](const auto& other) {
      return other.size() == 1 && !reverse.empty() && from_least(other[0]) == from_least(reverse[0]);
    });
    if (cancelled != result.end())
      result.erase(cancelled);
    else
      result.push_back(std::move(loops));
  }
  return result;
}

class Shrink_faces {
 public:
  Shrink_faces(Polyhedron polyhedron, Question question, const std::function<bool(const Polyhedron&)>& accept)
      : polyhedron_(std::move(polyhedron)), faces_(faces_of(polyhedron_)), question_(question), accept_(accept)
  {}

  void run()
  {
    keep(faces_);  // without unused vertices
    if (question_ == Question::surface) {
      drop_groups([this] { return each_face(); });
      drop_loops();
      drop_corners();
    } else {
      drop_groups([this] { return covering::shell_faces(polyhedron_); });
      one_tetrahedron();
    }
    merge_runs();
    merge_edges();
  }

 private:
  bool keep(const Faces& faces)
  {
    if (faces.empty()) return false;
    Polyhedron candidate = polyhedron_of(polyhedron_.vertices, faces);
    if (!accept_(candidate)) return false;
    polyhedron_ = std::move(candidate);
    faces_ = faces_of(polyhedron_);
    return true;
  }

  std::vector<std::vector<Index>> each_face() const
  {
    std::vector<std::vector<Index>> groups;
    for (Index f = 0; f < faces_.size(); ++f) groups.push_back({f});
    return groups;
  }

  /// Drops runs of groups of faces: halves, quarters, down to one.
  template <class Groups>
  void drop_groups(Groups&& groups)
  {
    auto all = groups();
    for (std::size_t length = all.size() / 2; length > 0; length /= 2)
      for (std::size_t begin = 0; begin < all.size();) {
        std::vector<bool> dropped(faces_.size());
        for (std::size_t g = begin; g < std::min(begin + length, all.size()); ++g)
          for (const Index f : all[g]) dropped[f] = true;
        Faces rest;
        for (std::size_t f = 0; f < faces_.size(); ++f)
          if (!dropped[f]) rest.push_back(faces_[f]);
        if (keep(rest))
          all = groups();
        else
          begin += length;
      }
  }

  void drop_loops()
  {
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t k = faces_[f].size(); k-- > 0 && faces_[f].size() > 1;) {
        Faces rest = faces_;
        rest[f].erase(rest[f].begin() + std::ptrdiff_t(k));
        keep(rest);
      }
  }

  void drop_corners()
  {
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t k = 0; k < faces_[f].size(); ++k)
        for (std::size_t i = faces_[f][k].size(); i-- > 0 && faces_[f][k].size() > 3;) {
          Faces rest = faces_;
          rest[f][k].erase(rest[f][k].begin() + std::ptrdiff_t(i));
          keep(rest);
        }
  }

  /// The tetrahedra of three corners of a face that follow one another and one other vertex, outward.
  void one_tetrahedron()
  {
    using K = CGAL::Exact_predicates_inexact_constructions_kernel;
    constexpr std::size_t enough = 64;
    const auto point = [&](Index v) {
      const auto& [x, y, z] = polyhedron_.vertices[v];
      return K::Point_3(x, y, z);
    };
    if (faces_.size() <= 4) return;
    std::size_t tried = 0;
    for (const auto& face : faces_)
      for (std::size_t i = 0; i < face[0].size() && face[0].size() > 2; ++i) {
        const auto corner = [&](std::size_t k) { return face[0][(i + k) % face[0].size()]; };
        for (Index apex = 0, found = 0; apex < polyhedron_.vertices.size() && found < 2; ++apex) {
          const auto sign = CGAL::orientation(point(corner(0)), point(corner(1)), point(corner(2)), point(apex));
          if (sign == CGAL::ZERO) continue;
          if (++tried > enough) return;
          ++found;
          Index a = corner(0), b = corner(1), c = corner(2);
          if (sign == CGAL::POSITIVE) std::swap(b, c);
          // The apex is on the negative side of (a, b, c), which therefore faces outward.
          if (keep({{{a, b, c}}, {{b, a, apex}}, {{c, b, apex}}, {{a, c, apex}}})) return;
        }
        if (face[0].size() == 3) break;
      }
  }

  /// Runs of vertices become their first one: halves, quarters, down to two.
  void merge_runs()
  {
    for (std::size_t length = polyhedron_.vertices.size() / 2; length > 1; length /= 2)
      for (std::size_t begin = 0; begin < polyhedron_.vertices.size();) {
        std::vector<Index> target(polyhedron_.vertices.size());
        std::iota(target.begin(), target.end(), Index(0));
        for (std::size_t v = begin; v < std::min(begin + length, target.size()); ++v) target[v] = Index(begin);
        if (!keep(merged(faces_, target))) begin += length;
      }
  }

  /// One end of an edge becomes the other.
  void merge_edges()
  {
    for (bool found = true; found;) {
      found = false;
      std::vector<std::array<Index, 2>> edges;
      for (const auto& use : covering::edge_uses(polyhedron_)) {
        edges.push_back({use.low, use.high});
        edges.push_back({use.high, use.low});
      }
      std::sort(edges.begin(), edges.end());
      edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
      for (const auto& [from, to] : edges) {
        std::vector<Index> target(polyhedron_.vertices.size());
        std::iota(target.begin(), target.end(), Index(0));
        target[from] = to;
        if ((found = keep(merged(faces_, target)))) break;
      }
    }
  }

  Polyhedron polyhedron_;
  Faces faces_;
  Question question_;
  const std::function<bool(const Polyhedron&)>& accept_;
};

}  // namespace

void shrink_faces(Polyhedron polyhedron, Question question, const std::function<bool(const Polyhedron&)>& accept)
{
  Shrink_faces(std::move(polyhedron), question, accept).run();
}

std::optional<Polyhedron> fanned(const Polyhedron& polyhedron)
{
  Polyhedron result;
  result.vertices = polyhedron.vertices;
  bool changed = false;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.is_triangle(f)) {
      covering::append_face(result, polyhedron, f, false);
      continue;
    }
    changed = true;
    for (const auto& triangle : covering::repair::fan(polyhedron, f)) result.add_polygon(triangle);
  }
  return changed ? std::optional(result) : std::nullopt;
}

}  // namespace tetracone::verify
