#include "tetracone/tetratree/door/repair.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/repair/repair.h"

#include <utility>

namespace tetracone {

Repaired repaired(Polyhedron polyhedron)
{
  auto planar = covering::triangulate_non_planar(std::move(polyhedron));
  Repaired result{std::move(planar.polyhedron), std::move(planar.replaced), false};
  if (covering::is_closed(result.polyhedron)) return result;
  auto oriented = covering::orient(result.polyhedron);
  if (!covering::is_closed(oriented.polyhedron)) return result;
  result.polyhedron = std::move(oriented.polyhedron);
  result.turned = true;
  return result;
}

Body triangulated_body(Polyhedron polyhedron)
{
  auto triangles = covering::triangulate_faces(polyhedron);
  return Body(std::move(polyhedron), std::move(triangles));
}

Body read_repaired_body(const std::filesystem::path& file)
{
  return triangulated_body(repaired(covering::read(file)).polyhedron);
}

}  // namespace tetracone
