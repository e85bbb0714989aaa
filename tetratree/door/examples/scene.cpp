// Many bodies: the pairs that collide, frame after frame, and the first contacts as they move on.
#include <tetracone/scene.h>

#include <iostream>
#include <vector>

int main(int, char** argv)
{
  using namespace tetracone;
  Scene scene;
  const std::size_t cube = scene.add_model(read_body(argv[1]));
  for (int k = 0; k < 3; ++k) scene.add_body(cube);
  // A row of three cubes: the first two share a face, the third stands alone.
  const std::vector<Pose> row = {Pose(), Pose::translation(1, 0, 0), Pose::translation(2.5, 0, 0)};
  for (const Scene_pair& pair : scene.frame(row)) std::cout << pair.a << ' ' << pair.b << " collide\n";
  // The third moves on to where the first stands.
  const std::vector<Pose> next = {row[0], row[1], Pose()};
  for (const Scene_contact& contact : scene.first_contacts(next))
    std::cout << contact.pair.a << ' ' << contact.pair.b << " meet at t = " << contact.first.lo << '\n';
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   0 1 collide
//   0 1 meet at t = 0
//   1 2 meet at t = 0.2
//   0 2 meet at t = 0.6
