// The distance: the double nearest to the exact one, its square as a fraction, and what holds the two points.
#include <tetracone/tetracone.h>

#include <iostream>

int main(int, char** argv)
{
  using namespace tetracone;
  Query query(read_body(argv[1]), read_body(argv[2]));
  const Pose aside = Pose::translation(2, 3, 0);
  const Nearest nearest = query.nearest(Pose(), aside);
  std::cout << nearest.distance << ", squared " << nearest.squared << ": " << nearest.holder[0] << " to "
            << nearest.holder[1] << '\n'
            << (query.within(Pose(), aside, 2.25) ? "within 2.25" : "beyond 2.25") << '\n';
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   2.23607, squared 5: vertex 6 to vertex 3
//   within 2.25
