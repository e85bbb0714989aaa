#ifndef TETRACONE_VERIFY_PROOFS_GAPPA_SCRIPT_H
#define TETRACONE_VERIFY_PROOFS_GAPPA_SCRIPT_H

#include "tetracone/kernel/number/number.h"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// Proofs of error bounds by Gappa (Daumas and Melquiond, "Certification of bounds on expressions involving rounded
/// operators", TOMS 2010), from the library's own templates.
namespace tetracone::verify::proofs {

using kernel::Rational;

/// The bounds that Gappa proves for an expression: low <= expression <= high.
struct Enclosure {
  Rational low, high;

  Rational magnitude() const { return std::max(Rational(abs(low)), Rational(abs(high))); }
};

/// Returns a number as Gappa reads it, exactly: "3b-5" is 3 times 2^-5.
inline std::string gappa_number(double value)
{
  int exponent = 0;
  auto mantissa = std::int64_t(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  for (; mantissa != 0 && mantissa % 2 == 0; mantissa /= 2) ++exponent;
  return mantissa == 0 ? "0" : std::to_string(mantissa) + "b" + std::to_string(exponent);
}

/// A script for Gappa: definitions, assumptions about their variables, and expressions to enclose.
class Gappa_script {
 public:
  /// Returns the name of an expression, which is defined once: Gappa identifies equal expressions by one name.
  std::string define(const std::string& expression)
  {
    std::string& name = defined_[expression];
    return name.empty() ? name = add("x", {expression + ";", false}) : name;
  }

  /// Returns the name of a new variable of at most this magnitude.
  std::string variable(const std::string& most)
  {
    const std::string name = "v" + std::to_string(lines_.size());
    return add("v", {"|" + name + "| <= " + most, true});
  }

  /// Returns the name of a new variable in an interval.
  std::string variable(double low, double high)
  {
    const std::string name = "v" + std::to_string(lines_.size());
    return add("v", {name + " in [" + gappa_number(low) + ", " + gappa_number(high) + "]", true});
  }

  /// Asks for an enclosure. Returns its index in the result of `prove`.
  std::size_t ask(const std::string& expression)
  {
    goals_.push_back(define(expression));
    return goals_.size() - 1;
  }

  /// Asks for enclosures of all definitions: every intermediate result.
  void ask_for_everything()
  {
    for (std::size_t k = 0; k < lines_.size(); ++k)
      if (!lines_[k].is_variable) goals_.push_back("x" + std::to_string(k));
  }

  /// Returns the script, with only the definitions that the goals use.
  std::string text() const
  {
    std::vector<bool> is_needed(lines_.size(), false);
    for (const std::string& goal : goals_) is_needed[std::stoul(goal.substr(1))] = true;
    for (std::size_t k = lines_.size(); k-- > 0;)
      if (is_needed[k] && !lines_[k].is_variable) need_names(lines_[k].text, is_needed);
    std::string definitions, assumptions, goals;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (!is_needed[k]) continue;
      if (lines_[k].is_variable)
        assumptions += (assumptions.empty() ? "" : " /\\\n  ") + lines_[k].text;
      else
        definitions += "x" + std::to_string(k) + " = " + lines_[k].text + "\n";
    }
    for (const std::string& goal : goals_) goals += (goals.empty() ? "" : " /\\\n  ") + goal + " in ?";
    return definitions + "{ " + (assumptions.empty() ? "" : assumptions + " ->\n  ") + goals + " }\n";
  }

  /// Returns the requested enclosures, as Gappa proves them. It runs the program gappa, found in PATH. Throws
  /// std::runtime_error with Gappa's message when it fails.
  std::vector<Enclosure> prove() const;

 private:
  struct Line {
    std::string text;
    bool is_variable;
  };

  /// Names end in their line's number.
  std::string add(const char* prefix, const Line& line)
  {
    lines_.push_back(line);
    return prefix + std::to_string(lines_.size() - 1);
  }

  static void need_names(const std::string& text, std::vector<bool>& is_needed)
  {
    for (std::size_t at = text.find_first_of("xv"); at != std::string::npos; at = text.find_first_of("xv", at + 1))
      if (at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9' && (at == 0 || text[at - 1] != '0'))
        is_needed[std::stoul(text.substr(at + 1))] = true;
  }

  std::vector<Line> lines_;
  std::vector<std::string> goals_;
  std::map<std::string, std::string> defined_;  // the names of expressions
};

/// True when the program gappa is installed.
inline bool gappa_is_there() { return std::system("gappa --version > /dev/null 2>&1") == 0; }

namespace detail {

/// Returns the number at the beginning of the text: "-3b-5 {..." is -3 times 2^-5.
inline Rational parse_gappa(const std::string& text)
{
  const std::size_t end = std::min(text.find_first_not_of("-0123456789"), text.size());
  Rational value(text.substr(0, end));
  if (end < text.size() && text[end] == 'b') {
    const long exponent = std::stol(text.substr(end + 1));
    const mpz_class power = mpz_class(1) << std::labs(exponent);
    value = exponent < 0 ? Rational(value / Rational(power)) : Rational(value * Rational(power));
  }
  return value;
}

/// Returns the output of a command. Throws std::runtime_error with the output when the command fails.
inline std::string output_of(const std::string& command)
{
  std::string output;
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run: " + command);
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe)) output.append(part.data(), size);
  const int status = pclose(pipe);
  if (status != 0) throw std::runtime_error(command + " fails:\n" + output);
  return output;
}

/// Saves a script in the folder that TETRACONE_KEEP_PROOFS names, if it is set, for check_with_coq.sh. Not thread-safe.
inline void keep(const std::string& script)
{
  static int count = 0;
  if (const char* const folder = std::getenv("TETRACONE_KEEP_PROOFS"))
    std::ofstream(std::string(folder) + "/proof_" + std::to_string(count++) + ".g") << script;
}

/// A file in the system's temporary folder, removed by the destructor.
class Temporary_file {
 public:
  explicit Temporary_file(const std::string& text)
  {
    name_ = (std::filesystem::temp_directory_path() / "tetracone-proof-XXXXXX").native();
    const int file = mkstemp(name_.data());
    if (file < 0) throw std::runtime_error("cannot write " + name_);
    close(file);
    std::ofstream(name_) << text;
  }
  ~Temporary_file() { std::remove(name_.c_str()); }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

}  // namespace detail

inline std::vector<Enclosure> Gappa_script::prove() const
{
  const std::string script = text();
  detail::keep(script);
  const detail::Temporary_file file(script);
  // 200 bits of precision keep squares of roundings visible beside 1, in double-double too.
  const std::string output = detail::output_of("gappa -Eprecision=200 " + file.name() + " 2>&1");
  std::map<std::string, Enclosure> found;
  for (const std::string& goal : goals_) {
    const std::size_t line = output.find("\n  " + goal + " in [");
    if (line == std::string::npos) throw std::runtime_error("gappa does not enclose " + goal + ":\n" + output + text());
    // "[-3b-5 {-0.09, -2^(-3.4)}, 0]": what stands in braces is rounded.
    const std::size_t low = output.find('[', line) + 1, end = output.find_first_of(" ,", low);
    const std::size_t high = output[end] == ' ' ? output.find('}', end) + 3 : end + 2;
    found[goal] = {detail::parse_gappa(output.substr(low, end - low)), detail::parse_gappa(output.substr(high, 400))};
  }
  std::vector<Enclosure> enclosures;
  for (const std::string& goal : goals_) enclosures.push_back(found[goal]);
  return enclosures;
}

}  // namespace tetracone::verify::proofs

#endif
