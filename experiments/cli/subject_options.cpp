#include "experiments/cli/subject_options.h"

#include "experiments/peers/subject_command.h"
#include "verify/campaign/family_lines.h"

#include <cctype>
#include <cmath>
#include <set>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

bool is_name(const std::string& name)
{
  for (const unsigned char c : name)
    if (!std::isalnum(c) && c != '.' && c != '_' && c != '-' && c != '+') return false;
  return !name.empty();
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
      require_command(command, options.limit_ms());
    } catch (const std::runtime_error& error) {
      refuse(error.what());
    }
    subjects.push_back(subject_command(name, command, options.limit_ms()));
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
  std::string list;
  for (const std::string& known : family_names()) list += (list.empty() ? "" : ", ") + known;
  throw CLI::ValidationError("--family " + name, "expected one of " + list);
}

}  // namespace tetracone::experiments
