// Rays: every face on a ray in the exact order of t. `first_hit` returns the first of them.
#include <tetracone/tetracone.h>

#include <iostream>

int main(int, char** argv)
{
  using namespace tetracone;
  const Body cube = read_body(argv[1]);
  const Ray along_an_edge{{-2, 0, 0}, {4, 0, 0}};
  for (const Ray_hit& hit : cube.hits(along_an_edge)) std::cout << "face " << hit.face << " at t = " << hit.t << '\n';
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   face 0 at t = 0.5
//   face 2 at t = 0.5
//   face 5 at t = 0.5
//   face 3 at t = 0.75
