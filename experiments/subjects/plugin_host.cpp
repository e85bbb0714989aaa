// A subject around a shared object of four C functions, plugin.h: plugin_host ./mine.so
//   g++ -O2 -std=c++20 -I . experiments/subjects/plugin_host.cpp -o plugin_host -ldl
#include "experiments/subjects/plugin.h"
#include "experiments/subjects/subject.h"

#include <dlfcn.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>

using namespace tetracone;

namespace {

template <class Function>
Function* found(void* object, const char* name)
{
  void* const symbol = dlsym(object, name);
  if (symbol) return reinterpret_cast<Function*>(symbol);
  std::cerr << "no function " << name << "; expected a shared object with the four of plugin.h\n";
  std::exit(2);
}

}  // namespace

int main(int argc, char** argv)
{
  void* const object = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : nullptr;
  if (!object) {
    std::cerr << (argc == 2 ? dlerror() : "usage: plugin_host ./mine.so") << '\n';
    return 2;
  }
  const auto name = found<decltype(subject_name)>(object, "subject_name");
  const auto add = found<decltype(subject_add)>(object, "subject_add");
  const auto ask = found<decltype(subject_ask)>(object, "subject_ask");
  const auto forget = found<decltype(subject_forget)>(object, "subject_forget");
  std::size_t bodies = 0;
  const auto prepare = [&](const subject::Body& body) -> std::shared_ptr<std::size_t> {
    const std::size_t number = bodies++;
    static_assert(sizeof(subject::Point) == sizeof(double[3]) && sizeof(body.triangles[0]) == sizeof(unsigned[3]));
    if (add(number, body.vertices.size(), reinterpret_cast<const double(*)[3]>(body.vertices.data()),
            body.triangles.size(), reinterpret_cast<const unsigned(*)[3]>(body.triangles.data())) != 1)
      return nullptr;
    return {new std::size_t(number), [forget](const std::size_t* kept) {
              forget(*kept);
              delete kept;
            }};
  };
  const auto collide = [&](std::size_t a, std::size_t b, const subject::Ask& asked) -> std::optional<bool> {
    const int answer = ask(a, b, asked.pose_a.data(), asked.pose_b.data(), asked.question == "solid");
    if (answer < -1 || answer > 1) {
      std::cerr << "subject_ask returned " << answer << "; expected 1, 0 or -1\n";
      std::exit(1);
    }
    return answer < 0 ? std::nullopt : std::optional(answer != 0);
  };
  return subject::serve({{"name", name()}, {"version", name()}, {"questions", {"surface", "solid"}}}, prepare, collide);
}
