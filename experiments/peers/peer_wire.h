#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_WIRE_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_WIRE_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

/// What goes between the program and a peer's worker, both the same program on the same machine. To the worker:
///   'm' and two polyhedra: those of the questions to come; 'q', a question and the doubles of two poses; 't', the
///   doubles of the poses from which and to which B moves, A at rest.
/// From the worker, one byte each: `ready` when it has started, an answer for each 'q' and each 't'. After `yes` and `no`
/// two doubles follow, nanoseconds: what it took to make the models ready, 0 where they were, and to answer; after a
/// `yes` to a 't' also the double of the time.
namespace tetracone::experiments::wire {

enum class Message : char { models = 'm', question = 'q', motion = 't' };
enum class Answer : char { ready = 'r', no = '0', yes = '1', not_taken = 'n', failed = 'f' };

template <class T>
requires std::is_trivially_copyable_v<T>
void append(std::string& bytes, const T* values, std::size_t count)
{
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
requires std::is_trivially_copyable_v<T>
void append(std::string& bytes, const T& value) { append(bytes, &value, 1); }

inline void append(std::string& bytes, const covering::Polyhedron& polyhedron)
{
  append(bytes, std::uint64_t{polyhedron.vertices.size()});
  append(bytes, polyhedron.vertices.data(), polyhedron.vertices.size());
  append(bytes, std::uint64_t{polyhedron.face_count()});
  for (covering::Index f = 0; f < polyhedron.face_count(); ++f) {
    append(bytes, std::uint64_t{polyhedron.loop_count(f)});
    for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
      const covering::Loop loop = polyhedron.loop(f, l);
      append(bytes, std::uint64_t{loop.size()});
      append(bytes, loop.data(), loop.size());
    }
  }
}

/// `read(to, bytes)` fills `to`, or throws.
template <class T, class Read>
T take(const Read& read)
{
  T value;
  read(&value, sizeof value);
  return value;
}

template <class Read>
covering::Polyhedron take_polyhedron(const Read& read)
{
  covering::Polyhedron polyhedron;
  polyhedron.vertices.resize(take<std::uint64_t>(read));
  read(polyhedron.vertices.data(), polyhedron.vertices.size() * sizeof(kernel::Vertex));
  const auto faces = take<std::uint64_t>(read);
  for (std::uint64_t f = 0; f < faces; ++f) {
    std::vector<std::vector<covering::Index>> loops(take<std::uint64_t>(read));
    for (auto& loop : loops) {
      loop.resize(take<std::uint64_t>(read));
      read(loop.data(), loop.size() * sizeof(covering::Index));
    }
    polyhedron.add_face(loops);
  }
  return polyhedron;
}

/// What follows 'q'.
struct Asked {
  kernel::Question question;
  std::array<double, 12> pose_a, pose_b;
};

/// What follows 't'.
struct Asked_motion {
  std::array<double, 12> from, to;
};

}  // namespace tetracone::experiments::wire

#endif
