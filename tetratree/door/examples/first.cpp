// Two bodies, a few poses. They touch exactly in the second pose; in the third they are one ulp apart.
#include <tetracone/tetracone.h>

#include <cmath>
#include <iostream>

int main(int, char** argv)
try {
  using namespace tetracone;
  const Body cube = read_body(argv[1]), tetrahedron = read_body(argv[2]);
  Query query(cube, tetrahedron, Question::solid);
  for (const double x : {0.5, 1.0, std::nextafter(1.0, 2.0)}) {
    const Answer answer = query.collide(Pose(), Pose::translation(x, 0, 0));
    std::cout << (answer ? "collide: " : "do not collide: ") << answer.relation() << '\n';
  }
} catch (const tetracone::Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   collide: surfaces
//   collide: surfaces
//   do not collide: apart
