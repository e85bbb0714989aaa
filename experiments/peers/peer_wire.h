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

/// The protocol between the program and a peer's worker, which are one program on one machine. Messages to the worker:
///  - 'm' and two polyhedra: the bodies of the questions that follow; it has no answer;
///  - 'q', a question, and the doubles of two poses;
///  - 't' and the doubles of B's poses at the start and end of its motion; A rests.
///
/// The worker answers with single bytes: `ready` once it has started, and an answer for each 'q' and each 't'. After
/// `yes` and `no` follow two doubles, nanoseconds: for preparing the models (0 if they were prepared) and for
/// answering. After a `yes` to a 't' follows also the time of contact, a double.
namespace tetracone::experiments::wire {

enum class Message : char { models = 'm', question = 'q', motion = 't' };
enum class Answer : char { ready = 'r', no = '0', yes = '1', not_taken = 'n', failed = 'f' };

/// Appends values to a message: their bytes in memory.
template <class T>
requires std::is_trivially_copyable_v<T>
void append(std::string& bytes, const T* values, std::size_t count)
{
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
requires std::is_trivially_copyable_v<T>
void append(std::string& bytes, const T& value) { append(bytes, &value, 1); }

/// Appends a polyhedron: its vertices, and the loops of each face, each list behind its length.
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

/// Takes a value from a message. `read(to, bytes)` fills `to`, or throws.
template <class T, class Read>
T take(const Read& read)
{
  T value;
  read(&value, sizeof value);
  return value;
}

/// Takes a polyhedron that `append` wrote.
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

/// The message after 'q'; poses are row-major 3x4.
struct Asked {
  kernel::Question question;
  std::array<double, 12> pose_a, pose_b;
};

/// The message after 't': B's poses, row-major 3x4.
struct Asked_motion {
  std::array<double, 12> from, to;
};

}  // namespace tetracone::experiments::wire

#endif
