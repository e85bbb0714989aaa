#include "tetracone/tetratree/door/motion_solver.h"

#include "tetracone/kernel/number/error.h"

#include <string>
#include <vector>

namespace tetracone::detail {

const tetratree::Bvh8& triangulated_tree(const Body_data& body, const std::string& who)
{
  std::vector<bool> has_triangles(body.polyhedron.face_count(), false);
  for (const covering::Face_triangle& t : body.triangles) has_triangles[t.face] = true;
  const tetratree::Bvh8& tree = body.bvh8();
  for (covering::Index f = 0; f < body.polyhedron.face_count(); ++f)
    if (!has_triangles[f] && !body.polyhedron.is_triangle(f) && tree.model().covering().plane_basis(f))
      throw Error("motion: " + who + " has a face " + std::to_string(f) +
                  " without triangles; expected a body of triangles (tetracone/repair.h makes them)");
  return tree;
}

Motion_solver::Motion_solver(const std::shared_ptr<const Body_data>& of_a, const std::shared_ptr<const Body_data>& of_b)
    : a(of_a), b(of_b), motion(triangulated_tree(*a, "body a"), triangulated_tree(*b, "body b"))
{}

}  // namespace tetracone::detail
