// Points: inside, on the surface or outside of one body, exactly.
#include <tetracone/tetracone.h>

#include <array>
#include <cmath>
#include <iostream>
#include <vector>

int main(int, char** argv)
{
  using namespace tetracone;
  const Body cube = read_body(argv[1]);
  const std::vector<std::array<double, 3>> points = {
      {0.5, 0.5, 0.5}, {0.5, 0.5, 1}, {0.5, 0.5, std::nextafter(1.0, 2.0)}};
  for (const Location at : cube.inside(points))
    std::cout << (at == Location::inside       ? "inside"
                  : at == Location::on_surface ? "on the surface"
                                               : "outside")
              << '\n';
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   inside
//   on the surface
//   outside
