// Many poses in one call, one answer each. A pose is any affine map with det M != 0.
#include <tetracone/tetracone.h>

#include <iostream>
#include <vector>

int main(int, char** argv)
{
  using namespace tetracone;
  Query query(read_body(argv[1]), read_body(argv[2]));
  // The tetrahedron shrunk to a quarter and pushed through the cube, from left to right.
  std::vector<Pose> poses;
  for (double x = -0.5; x <= 1.25; x += 0.25)
    poses.push_back(Pose({0.25, 0, 0, x, 0, 0.25, 0, 0.25, 0, 0, 0.25, 0.25}));
  const std::vector<Pose> cube_stays(1);
  for (const Answer& answer : query.collide(cube_stays, poses)) std::cout << answer.relation() << '\n';
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   apart
//   surfaces
//   surfaces
//   b_in_a
//   b_in_a
//   surfaces
//   surfaces
//   apart
