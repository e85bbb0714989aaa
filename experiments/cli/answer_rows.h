#ifndef TETRACONE_EXPERIMENTS_CLI_ANSWER_ROWS_H
#define TETRACONE_EXPERIMENTS_CLI_ANSWER_ROWS_H

#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/tetratree/query_statistics.h"

#include <nlohmann/json_fwd.hpp>

#include <limits>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// The answer of one pose, and what it took.
struct Answer_row {
  int answer = 0;       ///< 0 or 1; a predicate's may be -1; or a `kernel::Relation`
  std::string instead;  ///< what stands in the place of an answer that was not given: `-` or `failed`
  double nanoseconds = std::numeric_limits<double>::infinity();
  tetratree::Query_statistics counts;
};

/// How answers are written.
struct Row_format {
  bool json = false, csv = false;  ///< neither: answers alone, no header
  bool time = false;               ///< of JSON and CSV: nanoseconds and work too
  bool relation = false;           ///< answers are relations, and named
};

/// The answers of all poses, each its line.
std::string answer_rows(const std::vector<Answer_row>& rows, const Row_format& format);

/// The answers of several kernels or programs side by side, one column of rows each; in JSON one that was not given is
/// null.
std::string answer_columns(const std::vector<std::string>& kernels, const std::vector<std::vector<Answer_row>>& columns,
                           const Row_format& format);

/// A number in JSON, which has none for infinity: the string "inf" or "-inf".
nlohmann::ordered_json json_number(double x);

/// The features of all poses, each its line: body 0 is an edge of A against a face of B, body 1 the other way round.
std::string feature_rows(const std::vector<std::vector<kernel::Feature_pair>>& features, const Row_format& format);

}  // namespace tetracone::experiments

#endif
