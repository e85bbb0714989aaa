#include "experiments/peers/command_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

namespace tetracone::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_line = 65536;

void on_child(int) {}

/// The process between our program and the child. It kills the child's process group when the child ends, or when the
/// program does, whatever kills it. It notices the program's end by the pipe that is its standard output: nobody reads
/// it then. Between fork and here other threads may have held any lock: async-signal-safe calls alone.
[[noreturn]] void guard(char* const* words)
{
  ::setpgid(0, 0);  // Ctrl-C is the program's
  sigset_t none, child_alone;
  sigemptyset(&none);
  sigemptyset(&child_alone);
  sigaddset(&child_alone, SIGCHLD);
  ::sigprocmask(SIG_SETMASK, &child_alone, nullptr);
  struct sigaction action = {};
  action.sa_handler = on_child;
  ::sigaction(SIGCHLD, &action, nullptr);

  const pid_t child = ::_Fork();
  if (child < 0) ::_exit(126);
  if (child == 0) {
    ::setpgid(0, 0);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::execv(words[0], words);
    ::_exit(127);
  }
  ::setpgid(child, child);
  ::close(STDIN_FILENO);
  siginfo_t ended = {};
  for (;;) {
    if (::waitid(P_PID, id_t(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == child) break;
    pollfd reader = {STDOUT_FILENO, 0, 0};  // that nobody reads is told unasked
    if (::ppoll(&reader, 1, nullptr, &none) > 0) break;
  }
  ::kill(-child, SIGKILL);
  ::waitid(P_PID, id_t(child), &ended, WEXITED);
  ::_exit(ended.si_code == CLD_EXITED ? ended.si_status : 128 + ended.si_status);
}

/// In the child of a fork. A negative `errors` leaves standard error as it is.
[[noreturn]] void become_guard(char* const* words, int input, int output, int errors)
{
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  if (errors >= 0) ::dup2(errors, STDERR_FILENO);
  ::closefrom(STDERR_FILENO + 1);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  guard(words);
}

int milliseconds_to(Command_process::Deadline deadline)
{
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return left <= 0 ? 0 : int(std::min<long>(left, 1'000'000));
}

}  // namespace

Command_process::Command_process(const std::vector<std::string>& words, Errors errors)
{
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::array<int, 2> in, out;
  const auto refuse = [&words]() -> void {
    throw std::runtime_error("no process can be started for '" + words.back() + "': " + std::strerror(errno));
  };
  if (::pipe2(in.data(), O_CLOEXEC) != 0) refuse();
  if (::pipe2(out.data(), O_CLOEXEC) != 0) {
    ::close(in[0]);
    ::close(in[1]);
    refuse();
  }
  if (errors == Errors::kept && !errors_.open()) {
    for (const int file : {in[0], in[1], out[0], out[1]}) ::close(file);
    refuse();
  }
  their_input_ = in[0];
  input_ = in[1];
  output_ = out[0];
  guard_ = ::_Fork();
  if (guard_ == 0) become_guard(arguments.data(), in[0], out[1], errors_.child_end());
  ::close(out[1]);
  errors_.close_child_end();
  if (guard_ < 0) {
    for (const int file : {input_, output_, their_input_}) ::close(file);
    refuse();
  }
  ::fcntl(input_, F_SETFL, O_NONBLOCK);
  ::fcntl(output_, F_SETFL, O_NONBLOCK);
}

Command_process::~Command_process()
{
  close_input();
  ::close(output_);  // the guard sees it and kills
  while (!status_ && ::waitpid(guard_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool Command_process::send(const std::string& text, Deadline deadline)
{
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t part = ::write(input_, text.data() + sent, text.size() - sent);
    if (part > 0) {
      sent += std::size_t(part);
    } else if (errno == EAGAIN) {
      // That output ends is told unasked.
      std::array<pollfd, 3> ends = {pollfd{input_, POLLOUT, 0}, {output_, 0, 0}, {errors_.descriptor(), POLLIN, 0}};
      const int left = milliseconds_to(deadline);
      if (left == 0 || (::poll(ends.data(), ends.size(), left) < 0 && errno != EINTR) || ends[1].revents != 0)
        return false;
      errors_.drain();
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

std::optional<std::string> Command_process::line(Deadline deadline)
{
  for (;;) {
    std::size_t end = received_.find('\n');
    while (end == std::string::npos && received_.size() < longest_line) {
      const std::size_t searched = received_.size();
      if (!receive(deadline)) return std::nullopt;
      end = received_.find('\n', searched);
    }
    std::string line = received_.substr(0, end);
    received_.erase(0, end == std::string::npos ? end : end + 1);
    if (!std::exchange(is_cut_, end == std::string::npos)) return line;
    if (Clock::now() > deadline) return std::nullopt;  // it has no end
  }
}

std::optional<std::string> Command_process::bytes(std::size_t count, Deadline deadline)
{
  while (received_.size() < count)
    if (!receive(deadline)) return std::nullopt;
  std::string bytes = received_.substr(0, count);
  received_.erase(0, count);
  return bytes;
}

bool Command_process::receive(Deadline deadline)
{
  for (;;) {
    std::array<char, 4096> buffer;
    const ssize_t got = ::read(output_, buffer.data(), buffer.size());
    if (got > 0) {
      received_.append(buffer.data(), std::size_t(got));
      return true;
    }
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) return false;
    std::array<pollfd, 2> ends = {pollfd{output_, POLLIN, 0}, {errors_.descriptor(), POLLIN, 0}};
    const int left = milliseconds_to(deadline);
    if (left == 0 || (::poll(ends.data(), ends.size(), left) < 0 && errno != EINTR)) return false;
    errors_.drain();
  }
}

void Command_process::close_input()
{
  for (int* file : {&input_, &their_input_}) {
    if (*file >= 0) ::close(*file);
    *file = -1;
  }
}

std::optional<int> Command_process::end(Deadline deadline)
{
  while (!status_) {
    int status = 0;
    if (::waitpid(guard_, &status, WNOHANG) == guard_)
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    else if (Clock::now() >= deadline)
      return std::nullopt;
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    errors_.drain();
  }
  return status_;
}

}  // namespace tetracone::experiments
