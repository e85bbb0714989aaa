#include "verify/campaign/tables.h"

#include "tetracone/kernel/number/number.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/campaign/family_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tetracone::verify {
namespace {

struct Table {
  std::string_view name, what, sql;
};

// Where a query's last two columns are called hits and of_n, the table has the rate and its interval in their place.
constexpr Table all[] = {
    {"errors", "wrong answers of every subject by family and question",
     "SELECT level, family, subject, question, sum(n) AS n, sum(false_positives) AS false_positives, "
     "sum(false_negatives) AS false_negatives, "
     "sum(failures) AS failures FROM tally WHERE axis = 'rho' GROUP BY level, family, subject, question ORDER BY 1, 2, "
     "3, 4"},
    {"poses", "wrong answers as in errors, those to poses of doubles and those to poses with fractions apart",
     "SELECT level, family, subject, question, poses, sum(n) AS n, sum(false_positives) AS false_positives, "
     "sum(false_negatives) AS false_negatives, sum(failures) AS failures, sum(not_asked) AS not_asked FROM tally "
     "WHERE axis = 'rho' GROUP BY level, family, subject, question, poses ORDER BY 1, 2, 3, 4, 5"},
    {"rates", "share of wrong answers by family, with Wilson's 95 % interval",
     "SELECT level, family, subject, question, sum(n) AS n, sum(not_asked) AS not_asked, "
     "sum(false_positives + false_negatives + failures) AS hits, sum(n) AS of_n FROM tally WHERE axis = 'rho' "
     "GROUP BY level, family, subject, question ORDER BY 1, 2, 3, 4"},
    {"subjects", "share of wrong answers over all families, with Wilson's 95 % interval",
     "SELECT level, subject, question, sum(n) AS n, sum(false_positives) AS false_positives, sum(false_negatives) AS "
     "false_negatives, "
     "sum(failures) AS failures, sum(not_asked) AS not_asked, sum(false_positives + false_negatives + failures) AS "
     "hits, sum(n) AS of_n "
     "FROM tally WHERE axis = 'rho' GROUP BY level, subject, question ORDER BY 1, 2, 3"},
    {"distance",
     "wrong answers by distance to degeneracy: floor of log2 of rho or of ulps; -9999 exactly degenerate, 9999 not "
     "near",
     "SELECT level, subject, question, poses, axis, bin, sum(n) AS n, sum(false_positives + false_negatives + "
     "failures) AS "
     "hits, sum(n) AS of_n "
     "FROM tally GROUP BY level, subject, question, poses, axis, bin ORDER BY 1, 2, 3, 4, 5, 6"},
    {"parameters", "wrong answers among the first cases of each family by its parameter",
     "SELECT level, family, parameter, subject, question, count(*) AS wrong FROM wrong GROUP BY 1, 2, 3, 4, 5 ORDER BY "
     "1, 2, 3, 4, 5"},
    {"needs", "how near to degenerate the cases of each family come, whoever is asked: cases by floor of log2 of rho",
     "SELECT level, family, question, bin, max(n) AS n FROM (SELECT level, family, subject, question, bin, sum(n) AS n "
     "FROM tally WHERE axis = 'rho' "
     "GROUP BY level, family, subject, question, bin) GROUP BY level, family, question, bin ORDER BY 1, 2, 3, 4"},
    {"sweeps",
     "share of wrong answers among the first cases of each family by its parameter, with Wilson's 95 % interval; where "
     "every case was asked",
     "SELECT asked.level, asked.family, parameter, asked.subject, asked.question, sum(n) AS n, sum(ifnull(wrong, 0)) "
     "AS hits, sum(n) AS of_n FROM "
     "(SELECT whole.seed, whole.level, whole.family, parameter, whole.subject, question, count(*) AS n FROM "
     " (SELECT seed, level, family, subject, sum(cases) AS cases FROM done GROUP BY 1, 2, 3, 4 HAVING count(*) = "
     "max(batch) + 1) AS whole "
     " JOIN (SELECT DISTINCT seed, level, family, subject, question FROM tally JOIN run ON run.id = tally.run GROUP BY "
     "1, 2, 3, 4, 5 "
     "       HAVING sum(not_asked) = 0) USING (seed, level, family, subject) "
     " JOIN temp.sweep ON sweep.family = whole.family AND number < cases GROUP BY 1, 2, 3, 4, 5, 6) AS asked LEFT JOIN "
     "(SELECT seed, level, family, parameter, subject, question, count(*) AS wrong FROM wrong JOIN run ON run.id = "
     "wrong.run GROUP BY 1, 2, 3, 4, 5, 6) "
     "USING (seed, level, family, parameter, subject, question) GROUP BY 1, 2, 3, 4, 5 ORDER BY 1, 2, 3, 4, 5"},
    {"blame", "the stage that made the answers of rounding trees wrong, by family",
     "SELECT subject, family, question, stage, sum(n) AS n FROM blame GROUP BY subject, family, question, stage ORDER "
     "BY 1, 2, 3, 4"},
    {"stages", "the stage that made the answers of rounding trees wrong, over all families",
     "SELECT subject, question, stage, sum(n) AS n FROM blame GROUP BY subject, question, stage ORDER BY 1, 2, 3"},
    {"rounded",
     "answers of subjects that hold their input as floats: how often rounding the input changes the truth, wrong "
     "answers, those excused by the rounding, and wrong answers to the rounded input, with Wilson's 95 % interval",
     "SELECT level, family, subject, question, sum(n) AS n, sum(changed) AS changed, sum(wrong) AS wrong, sum(excused) "
     "AS excused, sum(false_positives) AS false_positives, sum(false_negatives) AS false_negatives, "
     "sum(false_positives + false_negatives) AS hits, sum(n) AS of_n FROM rounded GROUP BY level, family, subject, "
     "question ORDER BY 1, 2, 3, 4"},
    {"relations", "metamorphic relations: tried, violated, with Wilson's 95 % interval",
     "SELECT level, relation, subject, sum(tried) AS tried, sum(violated) AS violated, sum(not_applicable) AS "
     "not_applicable, "
     "sum(violated) AS hits, sum(tried) AS of_n FROM relation GROUP BY level, relation, subject ORDER BY 1, 2, 3"},
    {"flips", "changes of the answer in sequences of exact contact, beside those of the truth",
     "SELECT sequence, subject, question, frames, wrong, changes, true_changes FROM flips ORDER BY 1, 2, 3"},
    {"truth", "cases and positive answers by family; how many were known by construction as well",
     "SELECT level, family, question, sum(n) AS n, sum(positives) AS positives, sum(by_construction) AS "
     "by_construction FROM truth "
     "GROUP BY level, family, question ORDER BY 1, 2, 3"},
    {"wrong", "the wrong answers among the first cases of each family, one by one",
     "SELECT run, level, family, number, parameter, subject, question, truth, answer, log2_rho, log2_ulps, stage FROM "
     "wrong ORDER BY 1, 2, 3, 4, 6, 7"},
    {"time", "mean nanoseconds an answer: of making the bodies ready, empty where asking includes it, and of asking",
     "SELECT level, subject, question, sum(n) AS n, sum(making) / sum(n) AS make_ns, sum(asking) / sum(n) AS ask_ns "
     "FROM time GROUP BY level, subject, question ORDER BY 1, 2, 3"},
    {"times", "the same by family",
     "SELECT level, family, subject, question, sum(n) AS n, sum(making) / sum(n) AS make_ns, "
     "sum(asking) / sum(n) AS ask_ns FROM time GROUP BY level, family, subject, question ORDER BY 1, 2, 3, 4"},
    {"families", "the families of cases: which levels ask them, what they have in common, what their parameter means",
     "SELECT levels, family, what, parameter, sweep FROM temp.family ORDER BY rowid"},
    {"failures",
     "how subjects failed, by family and question, and what they said the first time: of a program its last line of "
     "standard error",
     "SELECT level, family, subject, question, how, sum(n) AS n, min(said) AS said FROM failure GROUP BY level, "
     "family, "
     "subject, question, how ORDER BY 1, 2, 3, 4, 5"},
    {"commands", "subjects that are somebody else's programs, and what starts them",
     "SELECT subject, command FROM command ORDER BY 1"},
    {"hellos", "what such programs say of themselves, and the digest of their files",
     "SELECT subject, hello, digest FROM hello ORDER BY 1"},
    {"declined",
     "questions among the first cases of each family that subjects that are not ours were not asked, and why",
     "SELECT run, level, family, number, subject, question, why FROM declined ORDER BY 1, 2, 3, 4, 5, 6"},
    {"skipped", "lines that such programs wrote and that are no answers",
     "SELECT level, family, subject, sum(n) AS n FROM skipped GROUP BY level, family, subject ORDER BY 1, 2, 3"},
    {"runs", "what made the rows: version, compiler, flags, processor, seed, and the words that ask the same again",
     "SELECT id AS run, version, compiler, flags, processor, seed, real_meshes, again FROM run ORDER BY 1"},
};

/// Adds two tables that the database does not hold. The table temp.family has the families, and temp.sweep has the
/// parameter of each case that is kept one by one.
void add_families(Database& database)
{
  database.run(
      "CREATE TEMP TABLE IF NOT EXISTS sweep (family TEXT, number INTEGER, parameter REAL, PRIMARY KEY (family, "
      "number)) WITHOUT ROWID;"
      "DROP TABLE IF EXISTS temp.family;"
      "CREATE TEMP TABLE family (levels TEXT, family TEXT, what TEXT, parameter TEXT, sweep TEXT)");
  Database::Statement family(database, "INSERT INTO temp.family VALUES (?1, ?2, ?3, ?4, ?5)");
  Database::Statement sweep(database, "INSERT OR REPLACE INTO temp.sweep VALUES (?1, ?2, ?3)");
  for (const Family_line& line : family_lines()) {
    family.run(line.levels, line.name, line.what, line.parameter, sweep_text(line));
    for (std::uint64_t k = 0; k < kept_one_by_one && !line.sweep.empty(); ++k)
      sweep.run(line.name, k, line.sweep[k % line.sweep.size()]);
  }
}

/// Empty tables in place of those that a database of an older version lacks; they last as long as the connection.
constexpr const char* no_rounded =
    "CREATE TEMP TABLE IF NOT EXISTS rounded (level, family, subject, question, n, changed, wrong, excused, "
    "false_positives, false_negatives)";
constexpr const char* no_hello =
    "CREATE TEMP TABLE IF NOT EXISTS hello (subject, hello, digest);"
    "CREATE TEMP TABLE IF NOT EXISTS declined (run, level, family, number, subject, question, why);"
    "CREATE TEMP TABLE IF NOT EXISTS skipped (level, family, subject, n)";

/// A field of a CSV, quoted if it contains a comma, a quote or a newline.
std::string field(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

const std::vector<std::pair<std::string_view, std::string_view>>& tables()
{
  static const auto names = [] {
    std::vector<std::pair<std::string_view, std::string_view>> names;
    for (const Table& table : all) names.emplace_back(table.name, table.what);
    return names;
  }();
  return names;
}

std::string table_as_csv(Database& database, std::string_view name)
{
  const auto table = std::find_if(std::begin(all), std::end(all), [&](const Table& t) { return t.name == name; });
  assert(table != std::end(all));
  if (name == "sweeps" || name == "families") add_families(database);
  // Databases of older versions have no failures.
  if (name == "failures" &&
      !Database::Statement(database, "SELECT 1 FROM sqlite_master WHERE name = 'failure'").with().next())
    return "level,family,subject,question,how,n,said\n";
  if ((name == "hellos" || name == "declined" || name == "skipped") && !has_table(database, "hello"))
    database.run(no_hello);
  if (name == "rounded" && !has_table(database, "rounded")) database.run(no_rounded);
  Database::Statement rows(database, table->sql);
  const int columns = rows.columns();
  const bool has_rate = rows.name(columns - 1) == "of_n";
  const int plain = has_rate ? columns - 2 : columns;
  std::string csv;
  for (int k = 0; k < plain; ++k) csv += (k == 0 ? "" : ",") + rows.name(k);
  csv += has_rate ? ",rate,low,high\n" : "\n";
  for (rows.with(); rows.next();) {
    for (int k = 0; k < plain; ++k) csv += (k == 0 ? "" : ",") + field(rows.text(k));
    if (has_rate) {
      const std::int64_t hits = rows.integer(columns - 2), n = rows.integer(columns - 1);
      const Interval interval = wilson(hits, n);
      for (const double x : {n == 0 ? 0 : double(hits) / double(n), interval.low, interval.high})
        csv += "," + kernel::shortest(x);
    }
    csv += "\n";
  }
  return csv;
}

Interval wilson(std::int64_t hits, std::int64_t n)
{
  if (n == 0) return {0, 1};
  constexpr double z2 = 1.959963984540054 * 1.959963984540054;
  const double p = double(hits) / double(n), scale = 1 / (1 + z2 / double(n));
  const double centre = (p + z2 / (2 * double(n))) * scale;
  const double half = std::sqrt(z2 * (p * (1 - p) / double(n) + z2 / (4 * double(n) * double(n)))) * scale;
  // At the ends of [0, 1], centre and half are equal up to rounding.
  return {hits == 0 ? 0 : std::max(0.0, centre - half), hits == n ? 1 : std::min(1.0, centre + half)};
}

}  // namespace tetracone::verify
