// All contacts: the pairs of faces that meet, and the maximal points, segments and polygons that they share.
#include <tetracone/tetracone.h>

#include <cstddef>
#include <iostream>

int main(int, char** argv)
{
  using namespace tetracone;
  Query query(read_body(argv[1]), read_body(argv[2]));
  // The tetrahedron stands on the cube, and over two of its edges.
  const Contacts contacts = query.contacts(Pose(), Pose::translation(0.25, 0.25, 1));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact_piece piece = contacts[k];
    std::cout << piece.face_a << ' ' << piece.face_b << ": " << to_string(piece.kind) << '\n';
  }
  for (const Contacts::Curve& curve : contacts.curves())
    std::cout << (curve.closed ? "closed" : "open") << ", " << curve.points.size() << " points\n";
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   1 0: coplanar
//   1 1: segment
//   1 2: segment
//   1 3: segment
//   3 0: segment
//   3 1: point
//   3 3: point
//   4 0: segment
//   4 2: point
//   4 3: point
//   closed, 5 points
