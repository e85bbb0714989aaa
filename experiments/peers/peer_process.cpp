#include "experiments/peers/peer_process.h"

#include "experiments/peers/peer_wire.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace tetracone::experiments {
namespace {

using Clock = std::chrono::steady_clock;

/// Starts the program with `socket` as standard input, `errors` as standard error and no other open file of ours.
/// Whatever libraries print is discarded. Returns an error number, or 0.
int start(const std::string& program, const std::string& name, int socket, int errors, pid_t& child)
{
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, socket, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  // The caller may have blocked signals; the worker needs them.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::array<std::string, 3> words = {program, "peer-worker", name};
  std::array<char*, 4> arguments = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  const int error = posix_spawn(&child, program.c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

Peer_process::Peer_process(const std::string& program, const std::string& name)
{
  const auto refuse = [&](const std::string& why) -> void {
    throw std::runtime_error("the peer '" + name + "' cannot be started as '" + program + " peer-worker': " + why);
  };
  std::array<int, 2> ends;
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse(std::strerror(errno));
  const int error = errors_.open() ? start(program, name, ends[1], errors_.child_end(), child_) : errno;
  ::close(ends[1]);
  errors_.close_child_end();
  if (error != 0) {
    ::close(ends[0]);
    refuse(std::strerror(error));
  }
  socket_ = ends[0];
  if (receive(Clock::now() + std::chrono::seconds(30)) != static_cast<char>(wire::Answer::ready)) {
    stop();
    refuse("it is not ready");
  }
}

Peer_process::~Peer_process() { stop(); }

void Peer_process::stop()
{
  ::close(socket_);
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::string Peer_process::how_it_ended()
{
  for (const auto deadline = Clock::now() + std::chrono::milliseconds(200); child_ >= 0;) {
    int status = 0;
    const bool has_ended = ::waitpid(child_, &status, WNOHANG) == child_;
    errors_.drain();
    if (has_ended) {
      child_ = -1;
      return end_in_words(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
    }
    if (Clock::now() >= deadline) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return "silent";
}

std::optional<char> Peer_process::ask(const std::string& message, Deadline deadline)
{
  if (!send(message, deadline)) return std::nullopt;
  return receive(deadline);
}

std::optional<double> Peer_process::take_double(Deadline deadline)
{
  std::array<char, sizeof(double)> bytes;
  for (char& byte : bytes) {
    const auto next = receive(deadline);
    if (!next) return std::nullopt;
    byte = *next;
  }
  return std::bit_cast<double>(bytes);
}

bool Peer_process::send(const std::string& message, Deadline deadline)
{
  for (std::size_t sent = 0; sent < message.size();) {
    const ssize_t part = ::send(socket_, message.data() + sent, message.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (part >= 0)
      sent += static_cast<std::size_t>(part);
    else if (errno == EAGAIN) {
      if (!wait_for(POLLOUT, deadline)) return false;
    } else if (errno != EINTR)
      return false;
  }
  return true;
}

std::optional<char> Peer_process::receive(Deadline deadline)
{
  while (wait_for(POLLIN, deadline)) {
    char byte;
    const ssize_t got = ::recv(socket_, &byte, 1, MSG_DONTWAIT);
    if (got == 1) return byte;
    if (got == 0 || (errno != EINTR && errno != EAGAIN)) return std::nullopt;
  }
  return std::nullopt;
}

bool Peer_process::wait_for(short event, Deadline deadline)
{
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    std::array<pollfd, 2> ends = {pollfd{socket_, event, 0}, {errors_.descriptor(), POLLIN, 0}};
    const int ready = ::poll(ends.data(), ends.size(), static_cast<int>(left));
    if (ready > 0) errors_.drain();
    if (ready > 0 && ends[0].revents != 0) return true;
    if (ready < 0 && errno != EINTR) return false;
  }
}

}  // namespace tetracone::experiments
