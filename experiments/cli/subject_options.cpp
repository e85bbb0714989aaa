#include "experiments/cli/subject_options.h"

#include "experiments/cli/command_words.h"
#include "experiments/peers/subject_command.h"
#include "experiments/support/sha256.h"
#include "verify/campaign/family_lines.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

bool is_name(const std::string& name)
{
  for (const unsigned char c : name)
    if (!std::isalnum(c) && c != '.' && c != '_' && c != '-' && c != '+') return false;
  return !name.empty();
}

/// True for a program or a script; not for other files that a command names, which it may write.
bool is_program(const std::filesystem::path& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  const auto executable = std::filesystem::perms::owner_exec;
  static const std::set<std::string> scripts = {".py", ".js", ".mjs", ".cjs", ".jl", ".lua", ".rb", ".sh"};
  return (std::filesystem::status(path, error).permissions() & executable) != std::filesystem::perms::none ||
         scripts.contains(path.extension().native());
}

/// Returns the SHA-256 of the programs and scripts that the words of a command name, so that an edited one is noticed.
/// Quotes are no part of a name.
std::string digest_of_files(const std::string& command)
{
  constexpr std::uintmax_t largest = 64 << 20;  // no script or subject is larger
  std::string all, word;
  for (std::istringstream words(command); words >> word;) {
    std::erase_if(word, [](char c) { return c == '\'' || c == '"'; });
    std::error_code error;
    if (!is_program(word) || std::filesystem::file_size(word, error) > largest) continue;
    std::ifstream file(word, std::ios::binary);
    all += sha256(std::string(std::istreambuf_iterator<char>(file), {}));
  }
  return all.empty() ? "" : sha256(all);
}

}  // namespace

void add_subject_options(CLI::App& command, Subject_options& options)
{
  command
      .add_option("--subject-command", options.commands,
                  "NAME=COMMAND: somebody else's method as one more subject, a program that speaks the protocol of "
                  "experiments/subjects/README.md; may be given again")
      ->allow_extra_args(false);
  command.add_option("--subject-limit", options.limit, "Seconds in which such a program must answer a question")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e6));
}

std::vector<verify::Object_subject> command_subjects(const Subject_options& options,
                                                     const std::vector<verify::Object_subject>& others)
{
  if (std::isnan(options.limit)) throw CLI::ValidationError("--subject-limit nan", "expected seconds");
  std::set<std::string> taken = {"truth"};
  for (const auto& other : others) taken.insert(other.name.substr(0, other.name.find(' ')));
  std::vector<verify::Object_subject> subjects;
  for (const std::string& words : options.commands) {
    const std::size_t equals = words.find('=');
    const std::string name = words.substr(0, equals);
    const auto refuse = [&](const std::string& what) {
      throw CLI::ValidationError("--subject-command " + words, what);
    };
    if (equals == std::string::npos || words.find_first_not_of(" \t\n", equals + 1) == std::string::npos ||
        !is_name(name))
      refuse("expected NAME=COMMAND, NAME of letters, digits, '.', '_', '-' and '+'");
    if (!taken.insert(name).second) refuse("the name " + name + " is another subject's; expected a new one");
    const std::string command = words.substr(equals + 1);
    try {
      const auto hello = require_command(command, options.limit_ms());
      subjects.push_back(subject_command(name, command, options.limit_ms(), hello));
      subjects.back().digest = digest_of_files(command);
    } catch (const std::runtime_error& error) {
      refuse(error.what());
    }
  }
  return subjects;
}

std::vector<std::string> family_names()
{
  std::vector<std::string> names;
  for (const verify::Family_line& line : verify::family_lines()) names.emplace_back(line.name);
  return names;
}

void refuse_family(const std::string& name)
{
  throw CLI::ValidationError("--family " + name, "expected one of " + joined(family_names()));
}

}  // namespace tetracone::experiments
