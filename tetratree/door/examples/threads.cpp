// Many threads share the bodies. Each thread has its own query.
#include <tetracone/tetracone.h>

#include <atomic>
#include <iostream>
#include <thread>
#include <vector>

int main(int, char** argv)
{
  using namespace tetracone;
  const Body cube = read_body(argv[1]), tetrahedron = read_body(argv[2]);
  constexpr int poses = 1000, threads = 4;
  std::atomic<int> collisions = 0;
  std::vector<std::thread> workers;
  for (int first = 0; first < threads; ++first)
    workers.emplace_back([&, first] {
      Query query(cube, tetrahedron);  // bodies are shared, a query is not
      for (int k = first; k < poses; k += threads)
        if (query.collide(Pose(), Pose::translation(k / 500.0, 0, 0))) ++collisions;
    });
  for (std::thread& worker : workers) worker.join();
  std::cout << collisions << " of " << poses << " poses collide\n";
}

// Prints, of the unit cube and the tetrahedron in verify/test/install/:
//   501 of 1000 poses collide
