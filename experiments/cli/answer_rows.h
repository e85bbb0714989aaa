#ifndef TETRACONE_EXPERIMENTS_CLI_ANSWER_ROWS_H
#define TETRACONE_EXPERIMENTS_CLI_ANSWER_ROWS_H

#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/tetratree/query_statistics.h"

#include <nlohmann/json_fwd.hpp>

#include <limits>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// The answer of one pose, its nanoseconds in the fastest pass, and the work of one pass.
struct Answer_row {
  int answer = 0;       ///< 0 or 1; a predicate's may be -1; or a `kernel::Relation`
  std::string instead;  ///< what a text has in the place of an answer that was not given: `-` or `failed`
  double nanoseconds = std::numeric_limits<double>::infinity();
  tetratree::Query_statistics counts;
};

/// The format of answers.
struct Row_format {
  bool json = false, csv = false;  ///< neither: answers alone, no header
  bool time = false;               ///< of JSON and CSV: nanoseconds and work too
  bool relation = false;           ///< answers are relations, and named
};

/// Returns the answers of all poses, one line each, or one JSON array of objects. Requires rows without `instead`.
std::string answer_rows(const std::vector<Answer_row>& rows, const Row_format& format);

/// Returns the answers of several kernels or programs side by side, one column of rows each. In JSON an answer that was
/// not given is null. Requires at least one column, one per kernel, and columns of one length; `time` and `relation`
/// are not used.
std::string answer_columns(const std::vector<std::string>& kernels, const std::vector<std::vector<Answer_row>>& columns,
                           const Row_format& format);

/// Returns the columns ns, bounding_tests, primitive_tests and exact_fallbacks, each behind a comma.
std::string work_columns(double nanoseconds, const tetratree::Query_statistics& work);

/// Returns a number in JSON; infinity, which JSON lacks, is the string "inf" or "-inf".
nlohmann::ordered_json json_number(double x);

/// Returns the features of all poses, one line per feature: body 0 is an edge of A against a face of B, body 1 the
/// reverse. In JSON they form one object per pose. `time` and `relation` are not used.
std::string feature_rows(const std::vector<std::vector<kernel::Feature_pair>>& features, const Row_format& format);

}  // namespace tetracone::experiments

#endif
