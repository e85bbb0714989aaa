// Two bodies touch. The certificate of the answer is proved without this library.
#include <tetracone/tetracone.h>
#include <tetracone/tetratree/door/certificate.h>

#include <fstream>
#include <iostream>

int main(int, char** argv)
try {
  using namespace tetracone;
  const Body cube = read_body(argv[1]), tetrahedron = read_body(argv[2]);
  Query query(cube, tetrahedron);
  Certificate certificate(query);
  std::cout << certificate.collide(query, Pose(), Pose::translation(1, 0, 0)).relation() << ", "
            << certificate.relation(query, Pose(), Pose::translation(1, 0, 0)).relation << '\n';
  std::ofstream("proof.json") << certificate.text();
  std::cout << "answers without a proof: " << certificate.without_proof() << '\n';
} catch (const tetracone::Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}

// To have it proved: experiments/certificates/check.py proof.json
//
// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   surfaces, meet
//   answers without a proof: 0
