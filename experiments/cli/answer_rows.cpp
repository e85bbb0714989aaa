#include "experiments/cli/answer_rows.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/question.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>

namespace tetracone::experiments {
namespace {

using kernel::Feature_pair;
using Json = nlohmann::ordered_json;

/// Returns the text of an answer, which is a relation if `relation`.
std::string answer_text(int answer, bool relation)
{
  return relation ? std::string(to_string(kernel::Relation(answer))) : std::to_string(answer);
}

std::string rows_as_csv(const std::vector<Answer_row>& rows, bool time, bool relation)
{
  std::string text = time ? "pose,answer,ns,bounding_tests,primitive_tests,exact_fallbacks\n" : "pose,answer\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Answer_row& row = rows[k];
    text += std::to_string(k) + "," + answer_text(row.answer, relation);
    if (time) text += work_columns(row.nanoseconds, row.counts);
    text += "\n";
  }
  return text;
}

std::string rows_as_json(const std::vector<Answer_row>& rows, bool time, bool relation)
{
  Json json = Json::array();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Json row = {{"pose", k}, {"answer", rows[k].answer}};
    if (relation) row["answer"] = answer_text(rows[k].answer, relation);
    if (time) {
      row["ns"] = static_cast<long long>(rows[k].nanoseconds);
      row["bounding_tests"] = rows[k].counts.bounding_tests();
      row["primitive_tests"] = rows[k].counts.primitive_tests();
      row["exact_fallbacks"] = rows[k].counts.exact_fallbacks;
    }
    json.push_back(row);
  }
  return json.dump(1) + "\n";
}

std::string features_as_text(const std::vector<std::vector<Feature_pair>>& features, const std::string& header,
                             const std::string& separator)
{
  std::string text = header;
  for (std::size_t k = 0; k < features.size(); ++k)
    for (const Feature_pair& f : features[k]) {
      for (const auto number :
           {k, std::size_t(f.body), std::size_t(f.edge_from), std::size_t(f.edge_to), std::size_t(f.face)})
        text += std::to_string(number) + separator;
      text += std::string(to_string(f.kind)) + "\n";
    }
  return text;
}

std::string features_as_json(const std::vector<std::vector<Feature_pair>>& features)
{
  Json json = Json::array();
  for (std::size_t k = 0; k < features.size(); ++k) {
    Json pairs = Json::array();
    for (const Feature_pair& f : features[k])
      pairs.push_back(
          {{"body", f.body}, {"edge", {f.edge_from, f.edge_to}}, {"face", f.face}, {"kind", to_string(f.kind)}});
    json.push_back({{"pose", k}, {"features", pairs}});
  }
  return json.dump(1) + "\n";
}

}  // namespace

std::string work_columns(double nanoseconds, const tetratree::Query_statistics& work)
{
  return "," + std::to_string(static_cast<long long>(nanoseconds)) + "," + std::to_string(work.bounding_tests()) + "," +
         std::to_string(work.primitive_tests()) + "," + std::to_string(work.exact_fallbacks);
}

Json json_number(double x) { return std::isfinite(x) ? Json(x) : Json(kernel::shortest(x)); }

std::string answer_rows(const std::vector<Answer_row>& rows, const Row_format& format)
{
  if (format.json) return rows_as_json(rows, format.time, format.relation);
  if (format.csv) return rows_as_csv(rows, format.time, format.relation);
  std::string text;
  for (const Answer_row& row : rows) text += answer_text(row.answer, format.relation) + "\n";
  return text;
}

std::string answer_columns(const std::vector<std::string>& kernels, const std::vector<std::vector<Answer_row>>& columns,
                           const Row_format& format)
{
  Json json = Json::array();
  std::string text = format.csv ? "pose" : "";
  if (format.csv)
    for (const std::string& kernel : kernels) text += "," + kernel;
  if (format.csv) text += "\n";
  for (std::size_t k = 0; k < columns.front().size(); ++k) {
    Json answers;
    if (format.csv) text += std::to_string(k);
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      const Answer_row& row = columns[i][k];
      answers[kernels[i]] = row.instead.empty() ? Json(row.answer) : Json();
      text += (format.csv ? "," : i == 0 ? "" : " ") + (row.instead.empty() ? std::to_string(row.answer) : row.instead);
    }
    text += "\n";
    if (format.json) json.push_back({{"pose", k}, {"answers", answers}});
  }
  return format.json ? json.dump(1) + "\n" : text;
}

std::string feature_rows(const std::vector<std::vector<Feature_pair>>& features, const Row_format& format)
{
  if (format.json) return features_as_json(features);
  return format.csv ? features_as_text(features, "pose,body,edge_from,edge_to,face,kind\n", ",")
                    : features_as_text(features, "", " ");
}

}  // namespace tetracone::experiments
