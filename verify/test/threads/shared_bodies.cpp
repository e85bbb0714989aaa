// Many threads on fresh bodies, whose trees are made while all of them ask; built with ThreadSanitizer, which ends the
// program at a data race.

#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/scene/scene.h"

#include "verify/cases/random.h"
#include "verify/test/support/scenes.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>

using namespace tetracone;

namespace {

/// How many frames of a scene four threads answer in another way than one.
long differing_frames(const Body& body)
{
  Scene by_one, by_four({.threads = 4});
  for (Scene* scene : {&by_one, &by_four}) {
    scene->add_model(body);
    for (int k = 0; k < 60; ++k) scene->add_body(0);
  }
  verify::Random random(3);
  std::vector<Pose> poses(60);
  long differing = 0;
  for (int frame = 0; frame < 8; ++frame) {
    for (Pose& pose : poses)
      pose = Pose::translation(6 * random.symmetric(), 6 * random.symmetric(), 6 * random.symmetric());
    differing += by_one.frame(poses) != by_four.frame(poses);
  }
  return differing;
}

}  // namespace

int main()
{
  verify::Random random(1);
  verify::scenes::Random of_bodies(1);
  const auto blob = [&](int divisions) { return Body(verify::scenes::blob(of_bodies, divisions, 0.8, 1.2)); };
  long wrong = 0, hits = 0;
  std::atomic<long> strays = 0;
  for (int round = 0; round < 3; ++round) {
    const Body a = blob(4), b = blob(3);
    std::vector<Pose> poses;
    for (int k = 0; k < 80; ++k) {
      const auto [x, y, z] = random.in_ball();
      poses.push_back(Pose::translation(3 * x, 3 * y, 3 * z));
    }
    std::vector<std::vector<Answer>> answers(8);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < answers.size(); ++t)
      threads.emplace_back([&, t] {
        Query query(a, b, t % 2 == 0 ? Question::solid : Question::surface, {.remember = t % 4 < 2});
        if (t == 5) a.make_all(3);
        if (t == 6) b.make_all();
        // By turns a table and a tree that others may be making.
        const std::array<double, 3> far = {9, 9, double(t)};
        if (t % 3 == 0 && (a.inside(far) != Location::outside || a.first_hit({far, {1, 0, 0}}))) ++strays;
        answers[t] = query.collide(std::vector<Pose>(1), poses);
      });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t t = 2; t < answers.size(); ++t)
      for (std::size_t k = 0; k < poses.size(); ++k) wrong += answers[t][k].relation() != answers[t % 2][k].relation();
    for (const Answer& answer : answers[0]) hits += bool(answer);
  }
  // So large that what it is made of is shared by threads, while another one asks.
  const Body large = blob(6);
  std::thread asking([&] { strays += large.first_hit({{0, 0, 9}, {0, 0, -1}}).has_value() ? 0 : 1; });
  large.make_all(3);
  asking.join();
  wrong += strays;
  wrong += differing_frames(blob(3));
  std::printf("%ld answers differ, %ld hits\n", wrong, hits);
  return wrong == 0 && hits > 10 && hits < 230 ? 0 : 1;
}
