// A subject around the GNU Triangulated Surface Library (Debian: libgts-dev): curves in which placed surfaces
// intersect. Its predicates are exact, and its simulation of simplicity makes every touch a crossing or nothing.
//   g++ -O2 -std=c++20 -I. experiments/subjects/gts.cpp -o gts $(pkg-config --cflags --libs gts)
#include "experiments/subjects/subject.h"

#include <gts.h>

using namespace tetracone::subject;

GtsSurface* placed(const Body& body, const std::array<double, 12>& pose)
{
  GtsSurface* surface = gts_surface_new(gts_surface_class(), gts_face_class(), gts_edge_class(), gts_vertex_class());
  std::vector<GtsVertex*> vertices;
  for (const Point& v : body.vertices) {
    const auto [x, y, z] = image(pose, v);
    vertices.push_back(gts_vertex_new(gts_vertex_class(), x, y, z));
  }
  const auto edge = [&](unsigned from, unsigned to) {
    GtsSegment* known = gts_vertices_are_connected(vertices[from], vertices[to]);
    return known ? GTS_EDGE(known) : gts_edge_new(gts_edge_class(), vertices[from], vertices[to]);
  };
  for (const auto& [a, b, c] : body.triangles)
    gts_surface_add_face(surface, gts_face_new(gts_face_class(), edge(a, b), edge(b, c), edge(c, a)));
  return surface;
}

std::optional<bool> collide(const Body& a, const Body& b, const Ask& ask)
{
  if (ask.question != "surface") return std::nullopt;
  GtsSurface *s = placed(a, ask.pose_a), *t = placed(b, ask.pose_b);
  GNode *tree_s = gts_bb_tree_surface(s), *tree_t = gts_bb_tree_surface(t);
  GSList* curves = gts_surface_intersection(s, t, tree_s, tree_t);
  const bool hit = curves != nullptr;
  g_slist_free(curves);
  gts_bb_tree_destroy(tree_s, true);
  gts_bb_tree_destroy(tree_t, true);
  gts_object_destroy(GTS_OBJECT(s));
  gts_object_destroy(GTS_OBJECT(t));
  return hit;
}

int main()
{
  const std::string version = std::to_string(gts_major_version) + "." + std::to_string(gts_minor_version) + "." +
                              std::to_string(gts_micro_version);
  return serve(
      {{"name", "GTS"},
       {"version", version},
       {"precision", "float64"},
       {"bodies", "any"},
       {"poses", "affine"},
       {"questions", {"surface"}},
       {"touching", "closed"}},
      [](const Body& body) { return std::make_shared<Body>(body); }, collide);
}
