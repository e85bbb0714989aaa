// Which way a part comes out: the six directions along the axes in which it leaves the rest and meets it no more.
#include <tetracone/tetracone.h>

#include <array>
#include <iostream>

int main(int, char** argv)
{
  using namespace tetracone;
  const Body part = read_body(argv[1]), rest = read_body(argv[2]);
  Query query(part, rest);
  // The cube is pressed into a corner of the tetrahedron.
  const Pose pressed = Pose::translation(-0.75, 0.25, 0.25);
  for (const int sign : {1, -1})
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, 3> direction{};
      direction[axis] = sign;
      const Exits exits = query.exits(pressed, Pose(), direction);
      std::cout << (sign > 0 ? '+' : '-') << "xyz"[axis] << ": after " << exits.exact_first
                << (exits.first == exits.last ? ", for good\n" : ", but it is met again\n");
    }
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   +x: after 5/4, for good
//   +y: after 1/2, for good
//   +z: after 1/2, for good
//   -x: after 1/4, for good
//   -y: after 5/4, for good
//   -z: after 5/4, for good
