// The program `tetracone`: one subcommand per job, each in a file of its own (NAME_command.h with add_NAME_command).
//
// Exit status: 0 done, 1 a check found something (the command throws CLI::RuntimeError(1)), 2 bad use or bad input,
// with one line on stderr.

#include "experiments/cli/check_command.h"
#include "experiments/cli/collide_command.h"
#include "experiments/cli/experiment_command.h"
#include "experiments/cli/fuzz_command.h"
#include "experiments/cli/inside_command.h"
#include "experiments/peers/peer_worker.h"
#include "experiments/cli/report_command.h"
#include "experiments/cli/verify_command.h"
#include "experiments/cli/view_command.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/covering/io/input_error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

int complain(std::string message)
{
  // One line, whatever a library says.
  message.resize(std::min(message.find('\n'), message.size()));
  std::cerr << "tetracone: " << message << '\n';
  return 2;
}

}  // namespace

int main(int argc, char** argv)
{
  if (!tetracone::kernel::floating_point_is_sound())
    return complain("doubles are not rounded to nearest, or denormals are flushed; no answer here could be trusted");
  CLI::App app("Exact collision detection between complex polyhedra", "tetracone");
  app.set_version_flag("--version", "tetracone " TETRACONE_VERSION);
  // None at all is found below: asked to, CLI11 would hide behind it what else is wrong.
  app.require_subcommand(0, 1);
  app.footer("tetracone COMMAND --help says more, with an example.");

  tetracone::experiments::add_check_command(app);
  tetracone::experiments::add_collide_command(app);
  tetracone::experiments::add_inside_command(app);
  tetracone::experiments::add_verify_command(app);
  tetracone::experiments::add_merge_command(app);
  tetracone::experiments::add_fuzz_command(app);
  tetracone::experiments::add_experiment_command(app);
  tetracone::experiments::add_report_command(app);
  tetracone::experiments::add_view_command(app);
  tetracone::experiments::add_peer_worker_command(app);

  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) return complain("no command; tetracone --help lists them");
    std::cout.flush();
    if (!std::cout) return complain("standard output cannot be written");
    return 0;
  } catch (const CLI::RuntimeError& status) {
    std::cout.flush();
    if (!std::cout) return complain("standard output cannot be written");
    return status.get_exit_code();
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
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
