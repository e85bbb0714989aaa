#ifndef TETRACONE_EXPERIMENTS_CLI_COMMANDS_H
#define TETRACONE_EXPERIMENTS_CLI_COMMANDS_H

#include "experiments/cli/command_words.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

/// The commands of the program, defined in NAME_command.cpp or beside a related command. The header also has the parts
/// of the standard library that nearly all of them use.
///
/// A command throws covering::Input_error for bad input and for a file that cannot be written. It throws
/// CLI::ValidationError for words that it does not know or that exclude each other. Other exceptions of the library
/// pass through, for instance Error and std::runtime_error.
namespace tetracone::experiments {

/// `check MODEL...` describes each model. Throws CLI::RuntimeError(1) when one is no closed polyhedron, and with
/// --strict when one has a face that is not exactly planar. With --self-intersections it takes one model and lists its
/// self-intersections instead. It then throws CLI::RuntimeError(1) when there are some.
void add_check_command(CLI::App& app);

/// `save MODEL --out FILE.body`: the model with its tree, which is accepted wherever a model is.
void add_save_command(CLI::App& app);

/// `collide A B` and `collide X.case.json`: whether two models, or the bodies of a case file, collide, one answer per
/// pose. Throws CLI::RuntimeError(1) when an external program failed.
void add_collide_command(CLI::App& app);

/// `distance A B`: the double nearest to the exact distance, one line per pose.
void add_distance_command(CLI::App& app);

/// `relation A B`: which of the eight relations of solids holds, the dimension of the contact, and the volume of the
/// overlap, one line per pose.
void add_relation_command(CLI::App& app);

/// `exit A B --along X Y Z`: the first and the last exit of A along a direction, exactly, one line per pose.
void add_exit_command(CLI::App& app);

/// `depth A B`: a bracket of the least translation that parts the interiors, and its vector, one line per pose.
void add_depth_command(CLI::App& app);

/// `inside MODEL POINTS`: 1 inside, 0 on the surface, -1 outside, exactly, one line per point.
void add_inside_command(CLI::App& app);

/// `zone A B --within D`: the faces of A that have a point within D of B, exactly, one line per pose.
void add_zone_command(CLI::App& app);

/// `nearest MODEL POINTS`: signed distances of points and the nearest points of a model's surface, exactly.
void add_nearest_command(CLI::App& app);

/// `ray MODEL RAYS`: where rays meet a model's surface, exactly.
void add_ray_command(CLI::App& app);

/// `scene FILE`: the colliding pairs of many bodies, frame after frame.
void add_scene_command(CLI::App& app);

/// `motion A B`: when two moving models first meet, exactly, one line per motion.
void add_motion_command(CLI::App& app);

/// `ccd QUERIES.csv...`: whether a moving vertex and face, or two moving edges, meet: 1 or 0, exactly, one line per
/// query. Throws CLI::RuntimeError(1) when a file gives another answer.
void add_ccd_command(CLI::App& app);

/// `verify`: a campaign, into a database. Throws CLI::RuntimeError(1) when an exact subject was wrong, when the truths
/// disagree, and with --check-subject when a program does not follow the protocol.
void add_verify_command(CLI::App& app);

/// `merge` merges the databases of a campaign's shards into one.
void add_merge_command(CLI::App& app);

/// `fuzz` finds new wrong answers on fresh and mutated cases of all families, shrinks them, and writes each as a case
/// file. Throws CLI::RuntimeError(1) when an exact subject was wrong.
void add_fuzz_command(CLI::App& app);

/// `experiment NAME`: one question, its CSV and figure. `--list` shows their names with their time.
void add_experiment_command(CLI::App& app);

/// `report`: the tables of a campaign's database, the notes on other libraries and formulations, and the page. With
/// --progress it throws CLI::RuntimeError(1) unless every shard is done.
void add_report_command(CLI::App& app);

/// `view A [B] --out FILE.html`: one self-contained page in 3D, which needs no network. It shows the bodies, their
/// poses and answers, and the paper's covering, tree and bounding volumes.
void add_view_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
