// A subject around SFCGAL (Debian: libsfcgal-dev): exact, on vertices placed in double. All pairs of triangles.
//   g++ -O2 -std=c++20 -I. experiments/subjects/sfcgal.cpp -o sfcgal -lSFCGAL -lgmp -lmpfr
#include "experiments/subjects/subject.h"

#include <SFCGAL/Polygon.h>
#include <SFCGAL/PolyhedralSurface.h>
#include <SFCGAL/Solid.h>
#include <SFCGAL/Triangle.h>
#include <SFCGAL/TriangulatedSurface.h>
#include <SFCGAL/algorithm/intersects.h>
#include <SFCGAL/algorithm/isValid.h>
#include <SFCGAL/version.h>

using namespace tetracone::subject;

SFCGAL::TriangulatedSurface placed(const Body& body, const std::array<double, 12>& pose)
{
  SFCGAL::TriangulatedSurface surface;
  const auto point = [&](unsigned v) {
    const auto [x, y, z] = image(pose, body.vertices[v]);
    return SFCGAL::Point(SFCGAL::Coordinate(x, y, z));
  };
  for (const auto& [a, b, c] : body.triangles) surface.addTriangle(SFCGAL::Triangle(point(a), point(b), point(c)));
  return surface;
}

std::optional<bool> collide(const Body& a, const Body& b, const Ask& ask)
{
  const auto s = placed(a, ask.pose_a), t = placed(b, ask.pose_b);
  if (ask.question == "surface") return SFCGAL::algorithm::intersects3D(s, t, SFCGAL::algorithm::NoValidityCheck());
  const auto solid = [](const SFCGAL::TriangulatedSurface& of) {
    SFCGAL::PolyhedralSurface shell;
    for (std::size_t k = 0; k < of.numTriangles(); ++k) shell.addPolygon(SFCGAL::Polygon(of.triangleN(k)));
    return SFCGAL::Solid(shell);
  };
  return SFCGAL::algorithm::intersects3D(solid(s), solid(t), SFCGAL::algorithm::NoValidityCheck());
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
