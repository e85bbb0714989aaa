#ifndef TETRACONE_VERIFY_CASES_CASE_FILE_H
#define TETRACONE_VERIFY_CASES_CASE_FILE_H

#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Case files, `*.case.json`: one failing or interesting configuration, complete in itself.
namespace tetracone::verify {

/// A subject that answered a case wrong.
struct Wrong {
  std::string subject;        ///< "double tree"
  std::optional<int> answer;  ///< its answer; nothing if it failed

  friend bool operator==(const Wrong&, const Wrong&) = default;
};

/// The contents of a case file.
struct Case_file {
  Case_kind level = Case_kind::object;

  std::optional<Object_case> object;  ///< where level is object; its `surface` and `solid` are the answers that the
                                      ///< file knows
  kernel::Question question = kernel::Question::solid;

  std::optional<Predicate> predicate;  ///< if level is predicate
  std::optional<Predicate_case> points;

  int truth = 0;             ///< the right answer to the question or predicate
  std::vector<Wrong> wrong;  ///< the subjects that were wrong when the file was made
  std::string cause;         ///< why, in one line
  std::string version;       ///< of the program that made it

  const Origin& origin() const { return level == Case_kind::object ? object->origin : points->origin; }
};

/// True when a path has the name of a case file.
bool is_case_name(const std::filesystem::path& path);

/// Returns the contents of a case file. Throws covering::Input_error, with the line, for anything that is not exactly
/// of the form that `to_json` writes, or cannot be asked. These are:
/// - missing or unknown fields, and wrong types;
/// - numbers that are not finite, and coordinates that are no doubles;
/// - vertex numbers out of range;
/// - faces that are not exactly planar;
/// - det M = 0;
/// - an open surface asked for its solid.
Case_file read_case(const std::filesystem::path& path);

/// Returns the contents of a text, as `read_case`; `name` stands for the file in messages.
Case_file parse_case(const std::string& text, const std::string& name);

/// Returns the file's text, with one vertex, one face or one row of a pose per line. Doubles are their shortest
/// decimals, other rationals are "n/d" strings, so that `parse_case` gives the same case again. Requires the members
/// that `Case_file` prescribes for its level.
std::string to_json(const Case_file& file);

}  // namespace tetracone::verify

#endif
