// A subject around SFCGAL (Debian: libsfcgal-dev): exact, on vertices placed in rationals. All pairs of triangles.
//   g++ -O2 -std=c++20 -I. experiments/subjects/sfcgal.cpp -o sfcgal -DCGAL_USE_GMPXX=1 -lSFCGAL -lgmpxx -lgmp -lmpfr
#include "experiments/subjects/subject.h"

#include <SFCGAL/Exception.h>
#include <SFCGAL/Polygon.h>
#include <SFCGAL/PolyhedralSurface.h>
#include <SFCGAL/Solid.h>
#include <SFCGAL/Triangle.h>
#include <SFCGAL/TriangulatedSurface.h>
#include <SFCGAL/algorithm/intersects.h>
#include <SFCGAL/algorithm/isValid.h>
#include <SFCGAL/version.h>

using namespace tetracone::subject;

using Number = SFCGAL::Kernel::FT;

SFCGAL::TriangulatedSurface placed(const Body& body, const json& pose)
{
  std::array<Number, 12> m;
  for (std::size_t k = 0; k < 12; ++k)
    m[k] = pose[k].is_string() ? Number(Number::ET(std::string(pose[k]))) : Number(double(pose[k]));
  SFCGAL::TriangulatedSurface surface;
  const auto point = [&](unsigned v) {
    const Point& p = body.vertices[v];
    std::array<Number, 3> x;
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
    return SFCGAL::Point(SFCGAL::Coordinate(x[0], x[1], x[2]));
  };
  for (const auto& [a, b, c] : body.triangles) surface.addTriangle(SFCGAL::Triangle(point(a), point(b), point(c)));
  return surface;
}

std::optional<bool> collide(const Body& a, const Body& b, const Ask& ask)
{
  const auto s = placed(a, ask.line["pose_a"]), t = placed(b, ask.line["pose_b"]);
  if (ask.question == "surface") return SFCGAL::algorithm::intersects3D(s, t, SFCGAL::algorithm::NoValidityCheck());
  const auto solid = [](const SFCGAL::TriangulatedSurface& of) {
    SFCGAL::PolyhedralSurface shell;
    for (std::size_t k = 0; k < of.numTriangles(); ++k) shell.addPolygon(SFCGAL::Polygon(of.triangleN(k)));
    return SFCGAL::Solid(shell);
  };
  try {
    return SFCGAL::algorithm::intersects3D(solid(s), solid(t), SFCGAL::algorithm::NoValidityCheck());
  } catch (const SFCGAL::GeometryInvalidityException&) {
    return std::nullopt;  // no solid for it, such as one of several shells
  }
}

int main()
{
  return serve(
      {{"name", "SFCGAL"},
       {"version", SFCGAL::Version()},
       {"precision", "exact"},
       {"bodies", "closed"},
       {"poses", "affine"},
       {"questions", {"surface", "solid"}},
       {"touching", "closed"}},
      [](const Body& body) { return std::make_shared<Body>(body); }, collide);
}
