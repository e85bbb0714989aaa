#ifndef TETRACONE_EXPERIMENTS_PEERS_ERROR_TAIL_H
#define TETRACONE_EXPERIMENTS_PEERS_ERROR_TAIL_H

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>

namespace tetracone::experiments {

/// A pipe from the standard error of a child, of which the last line is kept. Whoever waits for the child polls the
/// descriptor too and drains it: a child that fills the pipe waits.
class Error_tail {
 public:
  Error_tail() = default;
  ~Error_tail()
  {
    close_end(ours_);
    close_end(theirs_);
  }
  Error_tail(const Error_tail&) = delete;
  Error_tail& operator=(const Error_tail&) = delete;

  /// False, with errno, where the system has no pipe.
  bool open()
  {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    ours_ = ends[0];
    theirs_ = ends[1];
    ::fcntl(ours_, F_SETFL, O_NONBLOCK);
    return true;
  }

  /// The child's end, which the parent closes once the child has it.
  int child_end() const { return theirs_; }
  void close_child_end() { close_end(theirs_); }

  /// The end to poll; negative, which poll takes for none, once all has come.
  int descriptor() const { return ours_; }

  /// Takes what has come, or a part of much: one who writes without end does not keep the caller from its deadline.
  void drain()
  {
    std::array<char, 4096> some;
    for (int k = 0; k < 16 && ours_ >= 0; ++k) {
      const ssize_t got = ::read(ours_, some.data(), some.size());
      if (got == 0) close_end(ours_);
      if (got <= 0) return;
      text_.append(some.data(), std::size_t(got));
      if (text_.size() > most_kept) text_.erase(0, text_.size() - most_kept);
    }
  }

  /// The last line that is not blank, at most 200 characters of it; '?' for what cannot be printed.
  std::string last_line() const
  {
    constexpr const char* white = " \t\r\n\v\f";
    const std::size_t last = text_.find_last_not_of(white);
    if (last == std::string::npos) return "";
    const std::size_t before = text_.find_last_of('\n', last), begin = before == std::string::npos ? 0 : before + 1;
    std::string line = text_.substr(begin, std::min<std::size_t>(last + 1 - begin, 200));
    std::ranges::replace_if(
        line, [](unsigned char c) { return std::isprint(c) == 0; }, '?');
    return line;
  }

 private:
  /// Bytes. More than a line that anybody reads, and little for each of many children.
  static constexpr std::size_t most_kept = 4096;

  static void close_end(int& end)
  {
    if (end >= 0) ::close(end);
    end = -1;
  }

  int ours_ = -1, theirs_ = -1;
  std::string text_;
};

/// How a child ended, in words: "status 3", or "signal 11" for what the shell tells as 139.
inline std::string end_in_words(int status)
{
  return status > 128 ? "signal " + std::to_string(status - 128) : "status " + std::to_string(status);
}

}  // namespace tetracone::experiments

#endif
