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

/// A pipe from the standard error of a child, which keeps the last line. The process that waits for the child must also
/// poll the descriptor and drain it, since a child that fills the pipe waits.
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

  /// Opens the pipe; false, with errno, when the system has none.
  bool open()
  {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    ours_ = ends[0];
    theirs_ = ends[1];
    ::fcntl(ours_, F_SETFL, O_NONBLOCK);
    return true;
  }

  /// Returns the child's end, which the parent closes once the child has it.
  int child_end() const { return theirs_; }
  void close_child_end() { close_end(theirs_); }

  /// Returns the end to poll; negative, which poll ignores, once all has come.
  int descriptor() const { return ours_; }

  /// Reads the bytes that have come, but not all of an endless stream, so that the caller keeps its deadline.
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

  /// Returns the last line that is not blank, at most 200 characters of it, with '?' for unprintable ones.
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
  /// The number of bytes kept: more than a readable line, and little for each of many children.
  static constexpr std::size_t most_kept = 4096;

  static void close_end(int& end)
  {
    if (end >= 0) ::close(end);
    end = -1;
  }

  int ours_ = -1, theirs_ = -1;
  std::string text_;
};

/// Returns how a child ended, in words: "status 3", or "signal 11" for the shell's status 139.
inline std::string end_in_words(int status)
{
  return status > 128 ? "signal " + std::to_string(status - 128) : "status " + std::to_string(status);
}

}  // namespace tetracone::experiments

#endif
