#ifndef TETRACONE_EXPERIMENTS_PEERS_COMMAND_PROCESS_H
#define TETRACONE_EXPERIMENTS_PEERS_COMMAND_PROCESS_H

#include "experiments/peers/error_tail.h"

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <vector>

namespace tetracone::experiments {

/// A program as a child that exchanges lines or bytes over pipes to its standard input and output. Its process group is
/// killed by the destructor, when the child itself ends, and when our program ends. Not thread-safe.
class Command_process {
 public:
  using Deadline = std::chrono::steady_clock::time_point;

  /// What becomes of its standard error: its last line is kept, or all of it goes to our own standard error.
  enum class Errors { kept, shown };

  /// Starts the program at the path `words[0]` with these arguments; PATH is not searched.
  /// Requires one word at least. Throws std::runtime_error when no process can be started. If there is no such program,
  /// the child ends with status 127.
  explicit Command_process(const std::vector<std::string>& words, Errors errors = Errors::kept);
  ~Command_process();
  Command_process(const Command_process&) = delete;
  Command_process& operator=(const Command_process&) = delete;

  /// Sends the text; false when the child ends or the deadline passes before all is sent. True says that the pipe took
  /// the text, not that the child lives or reads it.
  bool send(const std::string& text, Deadline deadline);

  /// Returns the next line of its output, without its end; nothing when the child ends or the deadline passes first. A
  /// line is cut after 65,536 bytes or a little later; the next call skips its rest.
  std::optional<std::string> line(Deadline deadline);

  /// Returns the next bytes of its output; nothing as for `line`.
  std::optional<std::string> bytes(std::size_t count, Deadline deadline);

  /// Returns the bytes received after the last line.
  const std::string& rest() const { return received_; }

  /// Returns the last line of its standard error so far, if that is kept (`Error_tail::last_line`).
  std::string last_error() const { return errors_.last_line(); }

  /// Closes the child's input. Nothing can be sent any more.
  void close_input();

  /// Returns how the child ended, as the shell reports it: its status, or 128 plus the signal; nothing when it has not
  /// ended at the deadline.
  std::optional<int> end(Deadline deadline);

 private:
  bool receive(Deadline deadline);

  int input_ = -1, output_ = -1;  // our ends
  int their_input_ = -1;          // held open, so that writing to a dead child is no signal
  pid_t guard_ = -1;
  std::optional<int> status_;
  std::string received_;
  bool is_cut_ = false;  // the last line was cut; its rest follows
  Error_tail errors_;
};

/// Returns the words that run a command of the shell.
inline std::vector<std::string> in_shell(const std::string& command) { return {"/bin/sh", "-c", command}; }

}  // namespace tetracone::experiments

#endif
