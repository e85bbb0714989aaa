#ifndef TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_SCHEMA_H
#define TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_SCHEMA_H

#include "verify/campaign/database.h"

#include <cstdint>
#include <string>

namespace tetracone::verify {

/// The bins of cases whose distance to degeneracy is 0, and of cases where no determinant was near.
inline constexpr int exactly_degenerate = -9999, not_near = 9999;

/// The number of cases of each family whose wrong and declined answers are kept one by one.
inline constexpr std::uint64_t kept_one_by_one = 200;

/// The two values of the column `poses`.
inline constexpr const char *of_doubles = "doubles", *with_fractions = "fractions";

/// The tables of a campaign's database. A run is the version, compiler, flags, processor, seed, whether real meshes
/// were there, and a command line. The command line `again` repeats the whole campaign. Rows name the `run` that made
/// them, except those of done, words, command and hello.
///  - done: how many cases of a batch a subject has been asked; the subject 'truth' stands for the truths.
///  - tally: answers by subject, question (or predicate) and distance to degeneracy.
///    Each answer is counted once on each of two axes. Axis 'rho' has bins of log2 of the relative determinant, and
///    'ulps' has bins of log2 of the distance in ulps. `bin` is the floor, exactly_degenerate where the distance is 0,
///    not_near where no determinant was near. False positive: higher than the truth; false negative: lower. not_asked:
///    the subject does not take such input; failures: crash, hang or exception. `poses` separates poses of doubles from
///    poses with a fraction, which kernels and libraries of doubles cannot be given. At the levels 'features',
///    'contacts', 'rays' and 'scenes' (there for a frame's pairs) an answer is a list, and the truth is the list's
///    length. An answer that lacks elements counts as its number of right ones, which is lower. An answer with more
///    elements counts as its length, which is higher. At the levels 'distances' and 'exits' an answer is its number of
///    right statements, and the truth is the number of statements. At the level 'motions' the questions 'surface' and
///    'solid' are whether bodies meet. 'surface time' and 'solid time' are asked where both truth and answer say that
///    they meet: 0 for the exact time, -1 for an earlier, 1 for a later one. At the level 'relations' the question
///    'relation' is the number of one of the eight, and 'dimension' is that of the contact. The question 'overlap' is
///    the number of right statements about the overlap.
///  - rounded: answers of subjects that hold their input as floats, judged by the truth of the rounded input too. Bins
///    are of ulps of the input. An input without a float is not counted. changed: that truth is another one; wrong: of
///    the input; false positives and negatives: of the rounded one. excused: wrong of the input and right of the
///    rounded one.
///  - truth: cases by question, with the number of positive answers and the number also known by construction.
///    Each is the answer of both truths. At the level 'motions' the second truth does not decide all; there
///    by_construction counts those that it decides. At the level 'relations' the questions are the eight relations. The
///    second truth is the family's count, or the volumes of bodies with few faces.
///  - wrong: the wrong answers among the first `kept_one_by_one` cases of each family, one by one.
///  - failure: how subjects failed, how often, and their message the first time, on the case with the number `first`. A
///    program's message is its last line of standard error, which may differ in another run.
///  - blame: wrong answers of rounding trees by the stage of first divergence.
///  - relation: how often a metamorphic relation was tried, did not apply, and was violated.
///  - flips: how often the answer changed in a sequence of frames, and how often the truth did.
///  - words: the questions asked, by shard, and the number of their answers, the truth's included; the last row is the
///    last run's.
///  - command: the command line of each subject that is an external program.
///  - hello: what such a program says of itself, and the digest of its files.
///  - declined: among the first `kept_one_by_one` cases of each family, those that subjects that are not ours were not
///    asked. The reason is "declined" by the subject, "not taken" by its hello, or "too slow".
///  - skipped: the number of lines that such a program wrote and that are not for us.
///  - time: nanoseconds of n answers, on this machine in this run. `making` is until the bodies are ready. They are
///    made anew for each question of the levels 'object', 'features', 'contacts' and 'distances'. `asking` is from then
///    to the answer. Where making is NULL, asking includes it. An external program has a row where it reports its own
///    time.
inline constexpr const char* campaign_schema = R"(
CREATE TABLE IF NOT EXISTS run (id INTEGER PRIMARY KEY, version TEXT, compiler TEXT, flags TEXT, processor TEXT, seed INTEGER,
  real_meshes INTEGER, again TEXT, UNIQUE (version, compiler, flags, processor, seed, real_meshes, again));
CREATE TABLE IF NOT EXISTS done (seed INTEGER, level TEXT, family TEXT, batch INTEGER, subject TEXT, cases INTEGER,
  PRIMARY KEY (seed, level, family, batch, subject)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS tally (run INTEGER, level TEXT, family TEXT, subject TEXT, question TEXT, poses TEXT, axis TEXT, bin INTEGER,
  n INTEGER, false_positives INTEGER, false_negatives INTEGER, failures INTEGER, not_asked INTEGER,
  PRIMARY KEY (run, level, family, subject, question, poses, axis, bin)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS rounded (run INTEGER, level TEXT, family TEXT, subject TEXT, question TEXT, bin INTEGER,
  n INTEGER, changed INTEGER, wrong INTEGER, excused INTEGER, false_positives INTEGER, false_negatives INTEGER,
  PRIMARY KEY (run, level, family, subject, question, bin)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS truth (run INTEGER, level TEXT, family TEXT, question TEXT, n INTEGER, positives INTEGER, by_construction INTEGER,
  PRIMARY KEY (run, level, family, question)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS wrong (run INTEGER, level TEXT, family TEXT, number INTEGER, parameter REAL, subject TEXT, question TEXT,
  truth INTEGER, answer INTEGER, log2_rho REAL, log2_ulps REAL, stage TEXT,
  PRIMARY KEY (run, level, family, number, subject, question)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS blame (run INTEGER, level TEXT, family TEXT, subject TEXT, question TEXT, stage TEXT, n INTEGER,
  PRIMARY KEY (run, level, family, subject, question, stage)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS failure (run INTEGER, level TEXT, family TEXT, subject TEXT, question TEXT, how TEXT, n INTEGER,
  first INTEGER, said TEXT, PRIMARY KEY (run, level, family, subject, question, how)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS relation (run INTEGER, level TEXT, family TEXT, relation TEXT, subject TEXT, question TEXT,
  tried INTEGER, violated INTEGER, not_applicable INTEGER,
  PRIMARY KEY (run, level, family, relation, subject, question)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS flips (run INTEGER, sequence TEXT, subject TEXT, question TEXT, frames INTEGER, wrong INTEGER,
  changes INTEGER, true_changes INTEGER, PRIMARY KEY (run, sequence, subject, question)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS words (version TEXT, seed INTEGER, predicate_cases INTEGER, object_cases INTEGER, feature_cases INTEGER, probe_cases INTEGER, frames INTEGER, families TEXT,
  subjects TEXT, real_meshes INTEGER, shards INTEGER, shard INTEGER, answers INTEGER,
  UNIQUE (version, seed, predicate_cases, object_cases, feature_cases, probe_cases, frames, families, subjects, real_meshes, shards, shard));
CREATE TABLE IF NOT EXISTS command (subject TEXT PRIMARY KEY, command TEXT) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS hello (subject TEXT PRIMARY KEY, hello TEXT, digest TEXT) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS declined (run INTEGER, level TEXT, family TEXT, number INTEGER, subject TEXT, question TEXT, why TEXT,
  PRIMARY KEY (run, level, family, number, subject, question)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS skipped (run INTEGER, level TEXT, family TEXT, subject TEXT, n INTEGER,
  PRIMARY KEY (run, level, family, subject)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS time (run INTEGER, level TEXT, family TEXT, subject TEXT, question TEXT, n INTEGER, making INTEGER, asking INTEGER,
  PRIMARY KEY (run, level, family, subject, question)) WITHOUT ROWID;
)";

/// Returns the clause for a row whose key the table has already: numbers are added up, and a row of `declined` stays as
/// it is. It is empty for tables whose keys never come twice.
std::string on_conflict(const std::string& table);

/// Returns a statement that adds the row ?1, ?2, ... of n columns.
std::string insertion(const std::string& table, int n);

/// Returns a statement that adds all rows of this table of the attached database `other`. The table `renumbered` says
/// which run is `here` that is `there`. Requires a table whose first column is `run`.
std::string merging(const std::string& table);

/// Throws covering::Input_error, with the table and its columns, when a table of the file has other columns than the
/// schema. Another version wrote it; this one neither continues it nor merges shards from it.
void require_columns_of_schema(Database& database);

/// True when the schema `in` of the database has the table. The schema is "main", or an attached one. Older versions
/// did not write hello, declined, skipped and rounded.
bool has_table(Database& database, const std::string& table, const std::string& in = "main");

}  // namespace tetracone::verify

#endif
