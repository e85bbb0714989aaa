// The program `tetracone`: one subcommand per job, each in a file of its own, NAME_command.cpp.
//
// Exit status: 0 done, 1 a check found something (the command throws CLI::RuntimeError(1)), 2 bad use or bad input,
// with one line on stderr.

#include "experiments/cli/commands.h"
#include "experiments/peers/peer_worker.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/kernel/number/floating_point.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <system_error>

namespace {

int complain(std::string message)
{
  // One line, whatever a library says.
  message.resize(std::min(message.find('\n'), message.size()));
  std::cerr << "tetracone: " << message << '\n';
  return 2;
}

/// The status of what is done, but where its output did not all go out.
int finish(int status)
{
  if (std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  return complain("standard output cannot be written: " + std::generic_category().message(errno) +
                  "; expected a file or a reader that takes all");
}

/// Reports a file that is made shorter while it is read: input files may be mapped, and the read then ends in a signal.
void say_that_a_file_has_shrunk()
{
  std::signal(SIGBUS, [](int) {
    constexpr std::string_view message =
        "tetracone: a file was made shorter while it was read; expected one that stays\n";
    // Nothing is left to be done where that cannot be written.
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(2);
  });
}

constexpr const char* empty_word = "an empty word; expected a value";

/// An empty word is what an unset variable of a shell leaves: no option takes it.
void refuse_empty_words(CLI::App& app)
{
  const CLI::Validator not_empty([](std::string& word) { return word.empty() ? empty_word : std::string(); }, "");
  for (CLI::App* command : app.get_subcommands({}))
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() > 0) option->check(not_empty);
}

}  // namespace

int main(int argc, char** argv)
{
  if (!tetracone::kernel::floating_point_is_sound())
    return complain("doubles are not rounded to nearest, or denormals are flushed; no answer here could be trusted");
  say_that_a_file_has_shrunk();
  CLI::App app("Exact collision detection between complex polyhedra", "tetracone");
  app.set_version_flag("--version", "tetracone " TETRACONE_VERSION);
  // None at all is found below: asked to, CLI11 would hide behind it what else is wrong.
  app.require_subcommand(0, 1);
  app.footer("tetracone COMMAND --help says more, with an example.");

  namespace commands = tetracone::experiments;
  for (const auto add :
       {commands::add_check_command,    commands::add_save_command,     commands::add_collide_command,
        commands::add_distance_command, commands::add_relation_command, commands::add_exit_command,
        commands::add_depth_command,    commands::add_inside_command,   commands::add_nearest_command,
        commands::add_zone_command,     commands::add_ray_command,      commands::add_scene_command,
        commands::add_motion_command,   commands::add_ccd_command,      commands::add_verify_command,
        commands::add_merge_command,    commands::add_fuzz_command,     commands::add_experiment_command,
        commands::add_report_command,   commands::add_view_command,     commands::add_peer_worker_command})
    add(app);
  refuse_empty_words(app);

  try {
    // Behind `--name=` CLI11 would take the next word.
    for (const std::string& word : std::vector<std::string>(argv, argv + argc))
      if (word.starts_with("--") && word.find('=') == word.size() - 1) throw CLI::ValidationError(word, empty_word);
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) return complain("no command; tetracone --help lists them");
    return finish(0);
  } catch (const CLI::RuntimeError& status) {
    return finish(status.get_exit_code());
  } catch (const CLI::Success& help_or_version) {
    return finish(app.exit(help_or_version));
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + "; tetracone --help says what is expected");
  } catch (const tetracone::covering::Input_error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::bad_alloc&) {
    return complain("not enough memory");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}
