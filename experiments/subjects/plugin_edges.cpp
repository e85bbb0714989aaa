// A plug-in: edges of the one against triangles of the other by signed volumes, in double. Surfaces alone.
//   g++ -O2 -std=c++20 -shared -fPIC -I. experiments/subjects/plugin_edges.cpp -o plugin_edges.so
#include "experiments/subjects/plugin.h"

#include <array>
#include <map>
#include <vector>

namespace {

using Point = std::array<double, 3>;

struct Mesh {
  std::vector<Point> vertices;
  std::vector<std::array<unsigned, 3>> triangles;
};

std::map<std::size_t, Mesh> meshes;

std::vector<Point> placed(const Mesh& mesh, const double* m)
{
  std::vector<Point> points;
  for (const Point& v : mesh.vertices)
    points.push_back({m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3], m[4] * v[0] + m[5] * v[1] + m[6] * v[2] + m[7],
                      m[8] * v[0] + m[9] * v[1] + m[10] * v[2] + m[11]});
  return points;
}

// The sign of the volume of a b c d.
int side(const Point& a, const Point& b, const Point& c, const Point& d)
{
  Point u, v, w;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
    w[i] = d[i] - a[i];
  }
  const double volume =
      u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  return (volume > 0) - (volume < 0);
}

bool edges_cross(const Mesh& a, const std::vector<Point>& p, const Mesh& b, const std::vector<Point>& q)
{
  for (const auto& s : a.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &from = p[s[k]], &to = p[s[(k + 1) % 3]];
      for (const auto& t : b.triangles) {
        const Point &x = q[t[0]], &y = q[t[1]], &z = q[t[2]];
        if (side(x, y, z, from) * side(x, y, z, to) > 0) continue;
        const int i = side(from, to, x, y), j = side(from, to, y, z), l = side(from, to, z, x);
        const bool some = i || j || l;  // none: an edge in the triangle's plane, which is left to other edges
        if (some && !((i > 0 || j > 0 || l > 0) && (i < 0 || j < 0 || l < 0))) return true;
      }
    }
  return false;
}

}  // namespace

const char* subject_name() { return "edges against triangles, plug-in 1"; }

int subject_add(size_t body, size_t vertex_count, const double (*vertices)[3], size_t triangle_count,
                const unsigned (*triangles)[3])
{
  Mesh& mesh = meshes[body];
  for (size_t v = 0; v < vertex_count; ++v) mesh.vertices.push_back({vertices[v][0], vertices[v][1], vertices[v][2]});
  for (size_t t = 0; t < triangle_count; ++t)
    mesh.triangles.push_back({triangles[t][0], triangles[t][1], triangles[t][2]});
  return 1;
}

int subject_ask(size_t a, size_t b, const double pose_a[12], const double pose_b[12], int solid)
{
  if (solid) return -1;
  const Mesh &mesh_a = meshes.at(a), &mesh_b = meshes.at(b);
  const auto p = placed(mesh_a, pose_a), q = placed(mesh_b, pose_b);
  return edges_cross(mesh_a, p, mesh_b, q) || edges_cross(mesh_b, q, mesh_a, p);
}

void subject_forget(size_t body) { meshes.erase(body); }
