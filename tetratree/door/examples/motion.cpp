// The first contact of two bodies that move: by points on lines (linear), or by quaternions (rigid).
#include <tetracone/tetracone.h>

#include <iomanip>
#include <iostream>

int main(int, char** argv)
{
  using namespace tetracone;
  Query query(read_body(argv[1]), read_body(argv[2]));
  const Motion rests = Motion::linear(Pose(), Pose()),
               falls = Motion::linear(Pose::translation(0.25, 0.25, 3), Pose::translation(0.25, 0.25, -3));
  if (const auto first = query.first_contact(rests, falls))
    std::cout << std::setprecision(17) << first->lo << " <= t <= " << first->hi << '\n';
  const Motion turns = Motion::rigid({1, 0, 0, 0, 3, 0, 0}, {1, 0, 0, 1, 3, 5, 0});  // w x y z, then the translation
  std::cout << (query.first_contact(rests, turns) ? "meets" : "never meets") << '\n';
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   0.33333333333333331 <= t <= 0.33333333333333337
//   never meets
