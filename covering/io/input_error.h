#ifndef TETRACONE_COVERING_IO_INPUT_ERROR_H
#define TETRACONE_COVERING_IO_INPUT_ERROR_H

#include "tetracone/kernel/number/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace tetracone::covering {

/// An error in a user's file. `what()` is one line, "file:line: what is wrong; what was expected". Line 0 stands for no
/// line (a binary file, or the file as a whole) and is left out with its colon.
class Input_error : public Error {
 public:
  Input_error(std::string_view file, std::size_t line, std::string_view wrong, std::string_view expected)
      : Error(message(file, line, wrong, expected))
  {}

 private:
  static std::string message(std::string_view file, std::size_t line, std::string_view wrong, std::string_view expected)
  {
    std::string text(file);
    if (line != 0) text.append(":").append(std::to_string(line));
    text.append(": ").append(wrong).append("; ").append(expected);
    // A file's name may hold a line break: the message stays one line.
    for (char& c : text)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return text;
  }
};

/// Returns a word of a file for a message: in quotes, at most 40 bytes of it, a `?` for each byte that does not print.
inline std::string in_quotes(std::string_view word)
{
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, longest)) text += c >= 0x20 && c < 0x7f ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

}  // namespace tetracone::covering

#endif
