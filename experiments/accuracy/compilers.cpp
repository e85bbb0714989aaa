#include "experiments/accuracy/experiments.h"

#include "experiments/support/run_command.h"

#include <tbb/parallel_for.h>

#include <mutex>
#include <sstream>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

constexpr std::array flags = {"-O0",
                              "-O2 -ffp-contract=off",
                              "-O3 -ffp-contract=off",
                              "-O3",
                              "-O3 -march=native -ffp-contract=off",
                              "-O3 -march=native",
                              "-O3 -march=native -ffp-contract=fast",
                              "-O3 -ffast-math",
                              "-O3 -march=native -ffast-math"};

Ran run(const std::string& command) { return run_command(command + " 2>/dev/null"); }

/// One compiler with one set of flags.
struct Compiled_probe {
  std::string compiler, flags;
  bool with_adaptive;
};

std::vector<Compiled_probe> builds()
{
  std::vector<Compiled_probe> all;
  for (const char* compiler : {"g++", "clang++"}) {
    if (run(std::string(compiler) + " --version").status != 0) continue;
    for (const std::string set : flags) {
      // Our headers refuse -ffast-math, which is a row; what it does to the others is asked without them.
      all.push_back({compiler, set, true});
      if (set.find("-ffast-math") != std::string::npos) all.push_back({compiler, set, false});
    }
  }
  return all;
}

/// One test's line of the probe: `subject,test,n,wrong`.
struct Tested {
  std::string subject, test, n, wrong;
};

std::vector<Tested> tested(const std::string& printed)
{
  std::vector<Tested> tests;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    Tested& test = tests.emplace_back();
    for (std::string* text : {&test.subject, &test.test, &test.n, &test.wrong}) std::getline(fields, *text, ',');
  }
  return tests;
}

std::vector<Csv_row> rows_of(const Compiled_probe& build, const std::filesystem::path& program)
{
  std::string version = run(build.compiler + " -dumpfullversion -dumpversion").out;
  version = version.substr(0, version.find('\n'));
  const auto row = [&](const Tested& test, const char* outcome) {
    return Csv_row()
        .add("compiler", build.compiler)
        .add("compiler_version", version)
        .add("flags", build.flags)
        .add("subject", test.subject)
        .add("test", test.test)
        .add("n", test.n)
        .add("wrong", test.wrong)
        .add("outcome", outcome)
        .add("version", TETRACONE_VERSION)
        .add("processor", processor())
        .add_again();
  };
  const std::string compile = build.compiler + " -std=c++20 -w -Wfatal-errors -DCGAL_DO_NOT_USE_BOOST_MP " +
                              build.flags + (build.with_adaptive ? " -DADAPTIVE" : "") +
                              " -frounding-math -I'" TETRACONE_INCLUDE_FOLDER "' " TETRACONE_INCLUDE_FLAGS
                              " '" TETRACONE_SOURCE_DIR "/experiments/accuracy/compiler_probe.cpp' -lgmp -lmpfr -o '" +
                              program.native() + "'";
  if (run(compile).status != 0)
    return {build.with_adaptive ? row({"adaptive", "", "0", "0"}, "refused to compile")
                                : row({"", "", "0", "0"}, "did not compile")};
  const Ran ran = run("'" + program.native() + "'");
  std::filesystem::remove(program);
  if (ran.status != 0) return {row({"", "", "0", "0"}, "crashed")};
  std::vector<Csv_row> rows;
  for (const Tested& test : tested(ran.out)) rows.push_back(row(test, "ran"));
  return rows;
}

}  // namespace

void run_compilers(const Experiment_options& options)
{
  const std::vector<Compiled_probe> all = builds();
  if (all.empty()) throw std::runtime_error("no compiler; expected g++ or clang++");
  std::vector<std::vector<Csv_row>> rows(all.size());
  Progress progress("compilations", all.size());
  std::mutex one_at_a_time;
  tbb::parallel_for(std::size_t(0), all.size(), [&](std::size_t k) {
    const std::string name = "tetracone_probe_" + std::to_string(getpid()) + "_" + std::to_string(k);
    rows[k] = rows_of(all[k], std::filesystem::temp_directory_path() / name);
    const std::lock_guard lock(one_at_a_time);
    progress.step();
  });
  Csv_table table;
  for (const std::vector<Csv_row>& of_build : rows)
    for (const Csv_row& row : of_build) table.add(row);
  write_whole(options.out / "compilers.csv", table.text());
}

}  // namespace tetracone::experiments
