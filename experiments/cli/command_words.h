#ifndef TETRACONE_EXPERIMENTS_CLI_COMMAND_WORDS_H
#define TETRACONE_EXPERIMENTS_CLI_COMMAND_WORDS_H

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::experiments {

/// Returns the word as a shell reads it, in quotes where they are needed. The path of the project's folder is left out,
/// so names of its files are relative to it.
inline std::string shell_word(std::string word)
{
  constexpr std::string_view project = TETRACONE_SOURCE_DIR "/";
  for (std::size_t at = 0; (at = word.find(project, at)) != std::string::npos;) word.erase(at, project.size());
  const bool is_plain =
      !word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=:,+-") ==
          std::string::npos;
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Returns the words with the separator between them.
inline std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ")
{
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) text += (k == 0 ? "" : separator) + words[k];
  return text;
}

/// Returns the words as alternatives: "a, b or c".
inline std::string alternatives(const std::vector<std::string>& words)
{
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 < words.size() ? ", " : " or ") + words[k];
  return text;
}

/// Returns the names of all elements of the range, with commas between them.
template <class Range>
std::string names_of(const Range& all)
{
  std::vector<std::string> names;
  for (const auto& each : all) names.emplace_back(each.name);
  return joined(names);
}

/// Refuses what is no whole number from 0, below 10^18; conversions of CLI11 would wrap or clamp it.
inline CLI::Validator whole_number()
{
  const auto refusal = [](const std::string& text) {
    const bool is_whole = !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == text.npos;
    return is_whole ? std::string() : "'" + text + "'; expected a whole number from 0, below 10^18";
  };
  return CLI::Validator(refusal, "");
}

/// Adds an option whose default value `--help` shows.
template <class Value>
CLI::Option* add_default(CLI::App& command, const std::string& name, Value& value, const std::string& text)
{
  return command.add_option(name, value, text)->capture_default_str();
}

/// Returns the named options (`--seed`) as a command line that repeats them, each after a blank. An option that was not
/// given has the default value that `--help` shows; without such a value it is left out. Requires a parsed command.
inline std::string words_of(const CLI::App& command, const std::vector<std::string>& options)
{
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (std::ranges::find(options, name) == options.end()) continue;
    if (option->get_items_expected_max() == 0) {
      if (option->count() > 0) words += " " + name;
    } else if (option->count() > 0) {
      for (const std::string& value : option->results()) words += " " + name + " " + shell_word(value);
    } else if (!option->get_default_str().empty()) {
      words += " " + name + " " + shell_word(option->get_default_str());
    }
  }
  return words;
}

}  // namespace tetracone::experiments

#endif
