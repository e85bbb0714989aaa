#ifndef TETRACONE_EXPERIMENTS_CLI_COMMANDS_H
#define TETRACONE_EXPERIMENTS_CLI_COMMANDS_H

#include <CLI/CLI.hpp>

/// The commands of the program, each defined in NAME_command.cpp.
namespace tetracone::experiments {

/// Adds `tetracone check MODEL...`, which describes each model. Throws CLI::RuntimeError(1) when one is no closed
/// polyhedron, and with --strict when one has a face that is not exactly planar; covering::Input_error for an
/// unreadable file.
void add_check_command(CLI::App& app);

/// Adds `tetracone save MODEL --out FILE.body`: the model with its tree, which is accepted wherever a model is. Throws
/// covering::Input_error for bad input, and for a file that cannot be written.
void add_save_command(CLI::App& app);

/// Adds `tetracone collide A B` and `tetracone collide X.case.json`: whether two models, or the bodies of a case file,
/// collide, one answer per pose. Throws covering::Input_error for bad input and CLI::ValidationError for options that
/// exclude each other.
void add_collide_command(CLI::App& app);

/// Adds `tetracone distance A B`: the double nearest to the exact distance, one line per pose. Throws
/// covering::Input_error for bad input.
void add_distance_command(CLI::App& app);

/// Adds `tetracone inside MODEL POINTS`: 1 inside, 0 on the surface, -1 outside, exactly, one line per point. Throws
/// covering::Input_error for bad input.
void add_inside_command(CLI::App& app);

/// Adds `tetracone ray MODEL RAYS`: where rays meet a model's surface, exactly. Throws covering::Input_error for bad
/// input.
void add_ray_command(CLI::App& app);

/// Adds `tetracone scene FILE`: the colliding pairs of many bodies, frame after frame. Throws covering::Input_error for
/// bad input.
void add_scene_command(CLI::App& app);

/// Adds `tetracone motion A B`: when two moving models first meet, exactly, one line per motion. Throws
/// covering::Input_error for bad input.
void add_motion_command(CLI::App& app);

/// Adds `tetracone ccd QUERIES.csv...`: whether a moving vertex and face, or two moving edges, meet: 1 or 0, exactly,
/// one line per query. Throws CLI::RuntimeError(1) when a file gives another answer, covering::Input_error for bad
/// input.
void add_ccd_command(CLI::App& app);

/// Adds `tetracone verify`: a campaign, into a database. Throws CLI::RuntimeError(1) when an exact subject was wrong.
void add_verify_command(CLI::App& app);

/// Adds `tetracone merge`, which merges the databases of a campaign's shards into one.
void add_merge_command(CLI::App& app);

/// Adds `tetracone fuzz`, which finds new wrong answers on fresh and mutated cases of all families, shrinks them, and
/// writes each as a case file. Throws CLI::RuntimeError(1) when an exact subject was wrong, CLI::ValidationError for an
/// unknown subject, covering::Input_error for a folder that cannot be written.
void add_fuzz_command(CLI::App& app);

/// Adds `tetracone experiment NAME`: one question, its CSV and figure. `--list` shows their names with their time.
void add_experiment_command(CLI::App& app);

/// Adds `tetracone report`: the tables of a campaign's database, the notes on other libraries and formulations, and the
/// page.
void add_report_command(CLI::App& app);

/// Adds `tetracone view A [B] --out FILE.html` and `tetracone view X.case.json --out FILE.html`: one self-contained
/// page in 3D, which needs no network. It shows the bodies, their poses and answers, and the paper's covering, tree and
/// bounding volumes. Throws covering::Input_error for bad input and CLI::ValidationError for options that exclude each
/// other.
void add_view_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
