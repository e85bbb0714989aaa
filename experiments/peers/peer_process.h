#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_PROCESS_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_PROCESS_H

#include "experiments/peers/error_tail.h"

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>

namespace tetracone::experiments {

/// Runs `program peer-worker NAME` as a child process with a socket to it, and kills it on destruction. The last line
/// of its standard error is kept. Not thread-safe.
class Peer_process {
 public:
  using Deadline = std::chrono::steady_clock::time_point;

  /// Throws std::runtime_error when it cannot be started, or does not report within half a minute that it is ready.
  Peer_process(const std::string& program, const std::string& name);
  ~Peer_process();
  Peer_process(const Peer_process&) = delete;
  Peer_process& operator=(const Peer_process&) = delete;

  /// Sends the message and returns the byte that answers it; nothing when the child dies or the deadline passes first.
  std::optional<char> ask(const std::string& message, Deadline deadline);

  /// Returns the double that follows the answer; nothing as for `ask`.
  std::optional<double> take_double(Deadline deadline);

  /// Returns how the child ended, in words; "silent" if it still runs a moment later.
  std::string how_it_ended();

  /// Returns the last line of its standard error (`Error_tail::last_line`).
  std::string last_error() const { return errors_.last_line(); }

 private:
  void stop();
  bool send(const std::string& message, Deadline deadline);
  std::optional<char> receive(Deadline deadline);
  bool wait_for(short event, Deadline deadline);

  int socket_ = -1;
  pid_t child_ = -1;  // negative once it has been waited for
  Error_tail errors_;
};

}  // namespace tetracone::experiments

#endif
