#include "experiments/cli/commands.h"

#include "experiments/certificates/certified_subjects.h"
#include "experiments/cli/subject_options.h"
#include "experiments/peers/check_subject.h"
#include "experiments/peers/peers.h"
#include "experiments/peers/subject_command.h"
#include "experiments/support/build_info.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "verify/campaign/campaign.h"
#include "verify/campaign/family_lines.h"
#include "verify/cases/case_file.h"

#include <iomanip>
#include <iterator>
#include <set>
#include <type_traits>

namespace tetracone::experiments {
namespace {

using verify::Asked;
using verify::Campaign;
using verify::Database;

struct Verify_options {
  std::string db = "out/verify.db", shard = "0/1", level, check_subject;
  std::vector<std::string> families, subjects;
  Subject_options others;
  std::uint64_t cases = 0;
  bool list = false, certificates = false;
  Campaign campaign;
};

/// "i/n" with 0 <= i < n.
void parse_shard(const std::string& text, Campaign& campaign)
{
  int i = 0, n = 0, end = 0;
  if (std::sscanf(text.c_str(), "%d/%d%n", &i, &n, &end) != 2 || end != int(text.size()) || i < 0 || n <= i ||
      n > 1'000'000)
    throw CLI::ValidationError("--shard " + text, "expected i/n with 0 <= i < n");
  campaign.shard = i;
  campaign.shards = n;
}

/// The subject of that name, or all whose names begin with it and a space.
bool is_named(const std::string& subject, const std::string& name)
{
  return subject == name || subject.starts_with(name + " ");
}

/// Returns the members of the list that one of the names selects, and marks the names that selected one.
template <class Subject>
std::vector<Subject> chosen(const std::vector<Subject>& all, const std::vector<std::string>& names,
                            std::set<std::string>& known)
{
  if (names.empty()) return all;
  std::vector<Subject> some;
  for (const Subject& subject : all) {
    std::set<std::string> selecting;
    std::ranges::copy_if(names, std::inserter(selecting, selecting.end()),
                         [&](const std::string& name) { return is_named(subject.name, name); });
    if (!selecting.empty()) some.push_back(subject);
    known.merge(selecting);
  }
  return some;
}

/// Returns the level's subjects, with those that are started as `self`, and with `certificates` those whose answers are
/// proved.
template <class Level>
auto subjects_of(const std::string& self, bool certificates)
{
  auto subjects = Level::subjects();
  const auto add = [&subjects](auto&& more) {
    for (auto& subject : more) subjects.push_back(std::move(subject));
  };
  if constexpr (std::is_same_v<Level, verify::levels::Objects>) add(peer_subjects(self));
  if constexpr (std::is_same_v<Level, verify::levels::Motions>) add(motion_peer_subjects(self));
  if (!certificates) return subjects;
  if constexpr (std::is_same_v<Level, verify::levels::Objects> || std::is_same_v<Level, verify::levels::Distances> ||
                std::is_same_v<Level, verify::levels::Relations> || std::is_same_v<Level, verify::levels::Exits>)
    subjects.push_back(certified_objects());
  if constexpr (std::is_same_v<Level, verify::levels::Motions>) subjects.push_back(certified_motions());
  if constexpr (std::is_same_v<Level, verify::levels::Points>) subjects.push_back(certified_points());
  if constexpr (std::is_same_v<Level, verify::levels::Rays>) subjects.push_back(certified_rays());
  return subjects;
}

/// Adds programs to a level whose questions they take; each to that of bodies that collide, which records it.
template <class Level>
void add_commands(const std::vector<verify::Object_subject>& commands, std::chrono::milliseconds limit,
                  Asked<Level>& asked)
{
  const auto add = [&asked](auto&& subject) {
    if (subject) asked.subjects.push_back(*std::move(subject));
  };
  for (const verify::Object_subject& command : commands) {
    if constexpr (std::is_same_v<Level, verify::levels::Objects>) asked.subjects.push_back(command);
    if constexpr (std::is_same_v<Level, verify::levels::Distances>)
      if (tells_distances(command)) asked.subjects.push_back(command);
    if constexpr (std::is_same_v<Level, verify::levels::Predicates>) add(triangle_command(command, limit));
    if constexpr (std::is_same_v<Level, verify::levels::Points>) add(point_command(command, limit));
    if constexpr (std::is_same_v<Level, verify::levels::Rays>) add(ray_command(command, limit));
    if constexpr (std::is_same_v<Level, verify::levels::Motions>) add(motion_command(command, limit));
  }
}

void choose_subjects(const Verify_options& options, Campaign& campaign)
{
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").native();
  const auto objects = subjects_of<verify::levels::Objects>(self, options.certificates);
  const auto commands = command_subjects(options.others, objects);
  std::set<std::string> known;
  for (const auto& command : commands) known.insert(command.name);
  verify::for_each_level(campaign.levels, [&]<class Level>(Asked<Level>& asked) {
    // The first three levels' subjects are known at every level.
    const bool is_first = Level::name == "predicate" || Level::name == "object" || Level::name == "features";
    if (is_first || asked.is_asked)
      asked.subjects = chosen(subjects_of<Level>(self, options.certificates), options.subjects, known);
    if (Level::name == "object" || asked.is_asked) add_commands(commands, options.others.limit_ms(), asked);
    asked.is_asked = asked.is_asked && (is_first || !asked.subjects.empty());
  });
  for (const std::string& name : options.subjects)
    if (!known.contains(name))
      throw CLI::ValidationError("--subject " + name,
                                 "expected one of " + names_of(objects) +
                                     " or of the subjects of predicates, points, rays, scenes and motions");
}

/// Adds the family to the levels that ask it; false when there is none.
bool add_family(const std::string& name, Campaign& campaign)
{
  bool is_known = false;
  verify::for_each_level(campaign.levels, [&]<class Level>(Asked<Level>& asked) {
    for (const auto* family : Level::families())
      if (family->name == name) {
        asked.families.push_back(family);
        is_known = true;
      }
  });
  return is_known;
}

/// Prints a paragraph of families for each set of levels that asks them.
void print_families()
{
  std::string levels;
  for (const verify::Family_line& line : verify::family_lines()) {
    if (line.levels != levels) std::cout << (levels.empty() ? "" : "\n") << "Families of " << line.levels << ":\n";
    levels = line.levels;
    std::cout << "  " << std::left << std::setw(24) << line.name << line.what;
    if (!line.parameter.empty())
      std::cout << "\n"
                << std::setw(28) << ""
                << "parameter: " << line.parameter;
    if (!line.sweep.empty()) std::cout << " (" << verify::sweep_text(line) << ")";
    std::cout << "\n";
  }
  std::cout
      << "\nThe level object also asks sequences, which have no name to choose them by: two bodies, frame by frame, in "
         "an\nexact contact that is kept, met or just missed; --frames says how many.\n";
}

void choose_families(const Verify_options& options, Campaign& campaign)
{
  for (const std::string& name : options.families.empty() ? family_names() : options.families)
    if (!add_family(name, campaign)) refuse_family(name);
  if (!options.families.empty()) campaign.sequence_frames = 0;
}

/// Returns the names of all levels: "predicate, object, ... or exits".
std::string level_names()
{
  std::vector<std::string> names;
  verify::for_each_level(Campaign().levels, [&]<class Level>(const Asked<Level>&) { names.emplace_back(Level::name); });
  return alternatives(names);
}

void choose_sizes(const Verify_options& options, Campaign& campaign)
{
  if (options.cases != 0)
    campaign.predicate_cases = campaign.object_cases = campaign.feature_cases = campaign.probe_cases = options.cases;
  if (options.level.empty()) return;
  const verify::Sizes sizes = campaign;
  static_cast<verify::Sizes&>(campaign) = {0, 0, 0, 0};
  bool is_level = false;
  verify::for_each_level(campaign.levels, [&]<class Level>(Asked<Level>& asked) {
    asked.is_asked = options.level == Level::name;
    if (asked.is_asked) campaign.*Level::size = sizes.*Level::size;
    is_level = is_level || asked.is_asked;
  });
  if (!is_level) throw CLI::ValidationError("--level " + options.level, "expected " + level_names());
  if (!campaign.at<verify::levels::Objects>().is_asked) campaign.sequence_frames = 0;
}

/// The names of the families and subjects of one level.
struct Asked_names {
  std::set<std::string> families, subjects;
};

/// Returns those of the levels at which some subject is asked.
std::vector<Asked_names> asked_levels(const Campaign& campaign)
{
  std::vector<Asked_names> levels;
  verify::for_each_level(campaign.levels, [&]<class Level>(const Asked<Level>& asked) {
    const bool has_sequences = std::is_same_v<Level, verify::levels::Objects> && campaign.sequence_frames != 0;
    const bool has_cases = asked.is_asked && campaign.*Level::size != 0 && !asked.families.empty();
    if ((!has_cases && !has_sequences) || asked.subjects.empty()) return;
    Asked_names& names = levels.emplace_back();
    for (const auto* family : asked.families) names.families.emplace(family->name);
    for (const auto& subject : asked.subjects) names.subjects.insert(subject.name);
  });
  return levels;
}

/// Throws CLI::ValidationError when a named family, subject or command would be asked nothing.
void refuse_idle_words(const Verify_options& options, const Campaign& campaign)
{
  const std::vector<Asked_names> levels = asked_levels(campaign);
  const std::string at = options.level.empty() ? "these words ask" : "level " + options.level + " asks";
  const auto require = [&](bool holds, const std::string& word, const char* what) {
    if (!holds)
      throw CLI::ValidationError(word, at + " no such " + what + "; expected another level, family or subject");
  };
  const auto has_subject = [&](const std::string& name) {
    return std::ranges::any_of(levels, [&](const Asked_names& level) {
      return std::ranges::any_of(level.subjects, [&](const std::string& asked) { return is_named(asked, name); });
    });
  };
  for (const std::string& words : options.others.commands)
    require(has_subject(words.substr(0, words.find('='))), "--subject-command " + words, "subject");
  for (const std::string& name : options.subjects) require(has_subject(name), "--subject " + name, "subject");
  for (const std::string& name : options.families)
    require(std::ranges::any_of(levels, [&](const Asked_names& level) { return level.families.contains(name); }),
            "--family " + name, "family");
  if (levels.empty()) throw CLI::ValidationError("verify", at + " nothing; expected a level, families and subjects");
}

/// Keeps the case on which the truths disagree beside the database.
[[noreturn]] void stop(const verify::Truths_disagree& found, const std::filesystem::path& db)
{
  verify::Case_file file;
  file.version = TETRACONE_VERSION;
  file.cause = found.what();
  if (found.object) {
    file.level = verify::Case_kind::object;
    file.object = found.object;
    file.question = found.question;
  } else {
    file.level = verify::Case_kind::predicate;
    file.points = found.points;
    file.predicate = found.predicate;
  }
  const std::filesystem::path path = db.native() + ".truths-disagree.case.json";
  write_whole(path, verify::to_json(file));
  std::cerr << path.native() << ": " << found.what() << '\n';
  throw CLI::RuntimeError(1);
}

/// Prints a line for each way in which a subject failed, with its message the first time.
void print_failures(Database& database, const Campaign& campaign)
{
  Database::Statement rows(
      database,
      "SELECT level, subject, how, sum(n), min(said) FROM failure JOIN run ON run = id WHERE seed = "
      "?1 GROUP BY level, subject, how ORDER BY level, subject, how");
  for (rows.with(campaign.seed); rows.next();)
    std::printf("%s %s failed %lld times, %s%s%s\n", rows.text(0).c_str(), rows.text(1).c_str(),
                (long long)rows.integer(3), rows.text(2).c_str(), rows.text(4).empty() ? "" : ": ",
                rows.text(4).c_str());
}

/// Prints a line per subject. True when an exact one was wrong.
bool print_summary(Database& database, const Campaign& campaign)
{
  std::set<std::string> exact;
  verify::for_each_level(campaign.levels, [&]<class Level>(const Asked<Level>& asked) {
    for (const auto& subject : asked.subjects)
      if (subject.is_exact) exact.insert(std::string(Level::name) + " " + subject.name);
  });
  Database::Statement rows(
      database,
      "SELECT level, subject, sum(n), sum(false_positives), sum(false_negatives), sum(failures), sum(not_asked) FROM "
      "tally "
      "JOIN run ON run = id WHERE axis = 'rho' AND seed = ?1 GROUP BY level, subject ORDER BY level, subject");
  bool exact_was_wrong = false;
  std::printf("%-9s  %-40s %10s %10s %10s %9s %9s\n", "level", "subject", "answers", "false +", "false -", "failures",
              "not asked");
  for (rows.with(campaign.seed); rows.next();) {
    const std::string name = rows.text(0) + " " + rows.text(1);
    const bool wrong = rows.integer(3) + rows.integer(4) + rows.integer(5) > 0;
    exact_was_wrong = exact_was_wrong || (wrong && exact.contains(name));
    std::printf("%-9s  %-40s %10lld %10lld %10lld %9lld %9lld%s\n", rows.text(0).c_str(), rows.text(1).c_str(),
                (long long)rows.integer(2), (long long)rows.integer(3), (long long)rows.integer(4),
                (long long)rows.integer(5), (long long)rows.integer(6),
                exact.contains(name) ? wrong ? "  exact, and WRONG" : "  exact" : "");
  }
  print_failures(database, campaign);
  return exact_was_wrong;
}

/// Returns the command line of the whole campaign, all shards together, that fills the database `--db` again.
std::string campaign_words(const CLI::App& command, const Verify_options& options)
{
  std::vector<std::string> names = {"--cases",           "--seed",  "--family", "--subject",
                                    "--subject-command", "--level", "--frames"};
  if (!options.others.commands.empty()) names.emplace_back("--subject-limit");
  if (options.certificates) names.emplace_back("--certificates");
  return "build/tetracone verify" + words_of(command, names);
}

void run_verify(const CLI::App& command, Verify_options options)
{
  if (options.list) return print_families();
  if (!options.check_subject.empty()) {
    require_command(options.check_subject, options.others.limit_ms());
    if (!check_subject(options.check_subject, options.others.limit_ms(), std::cout)) throw CLI::RuntimeError(1);
    return;
  }
  Campaign& campaign = options.campaign;
  parse_shard(options.shard, campaign);
  choose_families(options, campaign);
  choose_sizes(options, campaign);
  choose_subjects(options, campaign);
  refuse_idle_words(options, campaign);
  again() = campaign_words(command, options);
  campaign.made_by = {TETRACONE_VERSION, compiler(), compiler_flags(), processor(), again()};

  const std::filesystem::path db = options.db;
  std::error_code error;
  if (db.has_parent_path()) std::filesystem::create_directories(db.parent_path(), error);
  Database database = verify::open_campaign(db);
  {
    Progress progress("cases", verify::case_count(campaign));
    try {
      verify::run_campaign(database, campaign, [&](std::uint64_t cases) { progress.step(cases); });
    } catch (const verify::Truths_disagree& found) {
      stop(found, db);
    }
  }
  const std::string costs = certificate_costs(campaign.seed);
  if (!costs.empty()) write_whole(db.parent_path() / "certificates.csv", costs);
  if (print_summary(database, campaign)) throw CLI::RuntimeError(1);
}

}  // namespace

void add_verify_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("verify", "A campaign: every subject on every family of cases, against two exact truths");
  const auto options = std::make_shared<Verify_options>();
  add_default(*command, "--db", options->db, "Database of the results (SQLite)");
  command
      ->add_option("--cases", options->cases,
                   "Cases per family and level; default: 400 of predicates, 24 of objects, 64 of points and of rays, 6 "
                   "of each other level")
      ->check(CLI::Range(1ul, 1'000'000'000ul));
  add_default(*command, "--seed", options->campaign.seed, "Seed of all cases")->check(CLI::Range(0ul, 1ul << 62));
  add_default(*command, "--shard", options->shard,
              "i/n: every n-th batch from batch i; `tetracone merge` joins the databases");
  command
      ->add_option("--family", options->families, "Only this family; may be given again; --list says what each one is")
      ->allow_extra_args(false);
  command->add_flag("--list", options->list, "No campaign: print the families of cases, and what each one is");
  command
      ->add_option("--subject", options->subjects,
                   "Only this subject, or a kernel with all its methods; may be given again")
      ->allow_extra_args(false);
  add_subject_options(*command, options->others);
  command->add_flag("--certificates", options->certificates,
                    "One more subject, `certified tree`, of all levels but predicates, features, contacts and scenes: "
                    "each answer is proved by experiments/certificates/check.py, or by the program that "
                    "TETRACONE_CHECKER names; one that is refused is a failure. Beside the database, certificates.csv "
                    "has the sizes and times of what this run has proved");
  command->add_option("--check-subject", options->check_subject,
                      "No campaign: whether the program COMMAND follows the protocol, in at most a minute");
  command->add_option("--level", options->level, "Only this level: " + level_names());
  add_default(*command, "--frames", options->campaign.sequence_frames, "Frames of each sequence of exact contact")
      ->check(CLI::Range(0, 100'000));
  command->footer(
      "Run again with the same words, it goes on where it was; with more cases or other subjects, it adds what is "
      "missing.\n"
      "Exit status 1: an exact subject was wrong, the truths disagree, or the program checked does not follow the "
      "protocol.\n"
      "Example: tetracone verify --db out/verify.db --family sliver --subject double\n"
      "         tetracone verify --db out/verify.db --level motions --cases 100\n"
      "         tetracone verify --subject mine --subject-command \"mine=./mine --tolerance 1e-9\"");
  command->callback([command, options] { run_verify(*command, *options); });
}

void add_merge_command(CLI::App& app)
{
  struct Files {
    std::string into;
    std::vector<std::string> from;
  };
  CLI::App* command = app.add_subcommand("merge", "Join the databases of a campaign's shards");
  const auto files = std::make_shared<Files>();
  command->add_option("INTO", files->into, "Database that takes all; made when it is not there")->required();
  command->add_option("FROM", files->from, "Databases of `tetracone verify`")->required();
  command->footer(
      "A shard that INTO has is not taken again; one that was asked with other words (version, seed, cases, families, "
      "subjects) is refused, and nothing of that file is taken.\nExample: tetracone merge all.db "
      "shard0.db shard1.db");
  command->callback([files] {
    // Nothing is made before all are known to be what they should.
    for (const std::string& from : files->from) {
      verify::require_campaign(from);
      refuse_input(files->into, {from});
    }
    Database into = verify::open_campaign(files->into);
    for (const std::string& from : files->from) verify::merge(into, from);
  });
}

}  // namespace tetracone::experiments
