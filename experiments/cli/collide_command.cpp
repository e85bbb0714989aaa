#include "experiments/cli/pair_command.h"

#include "experiments/cli/contact_rows.h"
#include "experiments/cli/subject_options.h"
#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/io/input_error.h"
#include "verify/cases/case_file.h"
#include "verify/subjects/predicate_subject.h"

namespace tetracone::experiments {
namespace {

using kernel::Feature_pair;
using kernel::Pose;
using kernel::Question;

struct Collide_options : Pair_options {
  std::string question = "solid", kernel = "adaptive", method = "tree", curves;
  std::vector<std::string> compare;
  Subject_options others;
  bool features = false, contacts = false, exact = false, normals = false, relation = false;

  /// True when lists are asked for instead of answers; they need no solid.
  bool lists() const { return features || contacts; }
  bool needs_solid(Question asked) const { return asked == Question::solid && !lists(); }
  Row_format format() const { return {json, !csv.empty(), time, relation}; }
};

/// The input of one call: two models, or the bodies of a case file, and their poses.
struct Placed_models {
  Model_file a, b;
  Pose_pairs poses;
  Question question;
};

Placed_models read_models(const Collide_options& options, Question question)
{
  if (options.names.b.empty())
    throw CLI::ValidationError("collide " + options.names.a,
                               "expected a second model, B: only a case file, *.case.json, has both bodies");
  Pose_pairs poses = read_pose_pairs(options.names);
  auto [a, b] = load_models(options.names.a, options.names.b, options.names.models, options.needs_solid(question));
  return {std::move(a), std::move(b), std::move(poses), question};
}

Placed_models models_of(const verify::Object_case& c, const Collide_options& options, Question question)
{
  const std::string& file = options.names.a;
  const auto body = [&](const covering::Polyhedron& polyhedron, const char* name) {
    if (options.needs_solid(question) && !covering::is_closed(polyhedron))
      throw covering::Input_error(file, 0, "body " + std::string(name) + " is an open surface and has no solid",
                                  "expected --question surface");
    return whole_model(file, polyhedron);
  };
  return {body(*c.a, "a"), body(*c.b, "b"), {{c.pose_a}, {c.pose_b}}, question};
}

struct Answers {
  std::vector<Answer_row> rows;
  double first_nanoseconds = 0;  // of the very first query, which may make what later ones find
};

/// Asks all poses. With `relation`, answers are the relations of the bodies.
Answers ask(Query& query, const Pose_pairs& poses, int passes, bool relation = false)
{
  Answers answers{std::vector<Answer_row>(poses.count())};
  std::vector<Answer_row>& rows = answers.rows;
  query.clear_statistics();
  ask_all(
      "poses", rows.size(), passes, [&](std::size_t k) { return query.collide(poses.of_a(k), poses.of_b(k)); },
      [&](std::size_t k, const Answer& answer, double ns) {
        rows[k].answer = relation ? int(answer.relation()) : int(bool(answer));
        if (answers.first_nanoseconds == 0) answers.first_nanoseconds = ns;
        rows[k].nanoseconds = std::min(rows[k].nanoseconds, ns);
        rows[k].counts = query.statistics();
        query.clear_statistics();
      });
  return answers;
}

/// Returns the proofs of all answers. Each is asked again, as a relation.
std::string certificate(Query& query, const Placed_models& scene)
{
  Certificate certificate = certificate_of(scene.a, scene.b);
  for (std::size_t k = 0; k < scene.poses.count(); ++k)
    certificate.collide(query, scene.poses.of_a(k), scene.poses.of_b(k));
  return certificate.text();
}

/// Reports on stderr the extra cost of the first query, by asking its pose again.
void tell_first_query(Query& query, const Placed_models& scene, const Answers& answers, double ready_milliseconds)
{
  if (answers.rows.empty()) return;
  const double again = ask(query, {{scene.poses.of_a(0)}, {scene.poses.of_b(0)}}, 1).first_nanoseconds,
               first = answers.first_nanoseconds;
  std::fprintf(stderr, "first query: %.3g ms, of it trees %.3g ms; bodies made ready before it in %.3g ms\n",
               1e-6 * first, 1e-6 * std::max(0.0, first - again), ready_milliseconds);
}

std::string features_of(Query& query, const Placed_models& scene, const Collide_options& options)
{
  std::vector<std::vector<Feature_pair>> features;
  Progress progress("poses", scene.poses.count());
  for (std::size_t k = 0; k < scene.poses.count(); ++k) {
    auto found = query.features(scene.poses.of_a(k), scene.poses.of_b(k));
    // Faces are named as the file has them.
    for (Feature_pair& f : found) f.face = (f.body == 0 ? scene.b : scene.a).source_face[f.face];
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    features.push_back(std::move(found));
    progress.step();
  }
  return feature_rows(features, options.format());
}

/// The curves, too, where they are asked for.
std::string contacts_of(Query& query, const Placed_models& scene, const Collide_options& options, std::string& curves)
{
  if (!options.curves.empty() && scene.poses.count() != 1)
    throw CLI::ValidationError("--curves " + options.curves,
                               "expected one pose, not " + std::to_string(scene.poses.count()));
  std::vector<Contacts> contacts;
  Progress progress("poses", scene.poses.count());
  for (std::size_t k = 0; k < scene.poses.count(); ++k) {
    contacts.push_back(query.contacts(scene.poses.of_a(k), scene.poses.of_b(k)));
    progress.step();
  }
  if (!options.curves.empty()) curves = curves_text(contacts[0].curves(), options.curves);
  return contact_rows(contacts, scene.a, scene.b, {options.json, !options.csv.empty(), options.exact, options.normals});
}

/// Returns the answers of an external program. Each failure has a line on stderr and sets `failed`.
std::vector<Answer_row> ask(const verify::Object_subject& subject, const Placed_models& scene, bool& failed)
{
  const auto running = subject.make();
  verify::Object_case c;
  c.a = std::make_shared<const covering::Polyhedron>(scene.a.polyhedron());
  c.b = std::make_shared<const covering::Polyhedron>(scene.b.polyhedron());
  std::vector<Answer_row> rows(scene.poses.count());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    c.pose_a = scene.poses.of_a(k);
    c.pose_b = scene.poses.of_b(k);
    const verify::Outcome outcome = (*running)(c, scene.question);
    rows[k].answer = outcome == verify::Outcome::yes;
    if (outcome == verify::Outcome::not_asked) rows[k].instead = "-";
    if (outcome != verify::Outcome::failed) continue;
    failed = true;
    rows[k].instead = "failed";
    const verify::Failure failure = running->failure();
    std::cerr << subject.name << " failed on pose " << k << ", " << failure.how << (failure.said.empty() ? "" : ": ")
              << failure.said << '\n';
  }
  return rows;
}

/// Throws CLI::ValidationError when given options exclude each other, or need another one.
void require_options(const Collide_options& options)
{
  const auto require = [](bool given, bool holds, const char* name, const std::string& expected) {
    if (given && !holds) throw CLI::ValidationError(name, expected);
  };
  const std::vector<std::string> exact = exact_kernel_names();
  const bool rounds = std::ranges::find(exact, options.kernel) == exact.end();
  const std::string expected = "expected with an exact kernel: " + alternatives(exact);
  require(options.time, !options.features, "--time", "expected without --features");
  require(!options.compare.empty(), !options.time && !options.features, "--compare",
          "expected without --time and --features");
  require(options.contacts, !options.features, "--contacts", "expected without --features");
  require(options.contacts, !options.time, "--time", "expected without --contacts");
  require(options.contacts, options.compare.empty(), "--compare", "expected without --contacts");
  require(options.contacts, !rounds, "--contacts", expected);
  require(options.exact, options.contacts, "--exact", "expected with --contacts");
  require(options.normals, options.contacts, "--normals", "expected with --contacts");
  require(!options.curves.empty(), options.contacts, "--curves", "expected with --contacts");
  require(!options.curves.empty(), is_curve_file(options.curves), "--curves", "expected a file *.obj or *.ply");
  require(!options.certificate.empty(), !options.lists(), "--certificate",
          "expected without --features and --contacts");
  require(!options.certificate.empty(), !rounds, "--certificate", expected);
  require(options.relation, !options.lists(), "--relation", "expected without --features and --contacts");
  require(options.relation, options.question == "solid", "--relation", "expected with --question solid");
  require(options.relation, options.compare.empty(), "--compare", "expected without --relation");
  require(!options.others.commands.empty(), !options.lists() && !options.relation && !options.time, "--subject-command",
          "expected without --features, --contacts, --relation and --time");
}

/// The answer of the subject of predicates that has the kernel's name.
Answer_row answer_of(const verify::Case_file& c, const std::string& kernel, const std::string& file)
{
  const auto& subjects = verify::predicate_subjects();
  const auto subject = std::ranges::find(subjects, kernel, &verify::Predicate_subject::name);
  if (subject == subjects.end())
    throw CLI::ValidationError("--kernel " + kernel, "expected a subject of predicates: " + names_of(subjects));
  const std::optional<int> answer = subject->answer(*c.predicate, *c.points);
  if (!answer)
    throw covering::Input_error(file, 0, kernel + " does not answer " + to_string(*c.predicate) + " on these points",
                                "expected another kernel, or points of which it is asked");
  Answer_row row;
  row.answer = *answer;
  return row;
}

/// The kernels in the order of their answers.
std::vector<std::string> kernels_of(const Collide_options& options)
{
  std::vector<std::string> kernels = {options.kernel};
  for (const std::string& kernel : options.compare) {
    if (std::ranges::find(kernels, kernel) != kernels.end())
      throw CLI::ValidationError("--compare " + kernel,
                                 "expected each kernel once, and not that of --kernel, which comes first");
    kernels.push_back(kernel);
  }
  return kernels;
}

/// Returns what each kernel is asked with.
std::vector<Query_options> ways_of(const std::vector<std::string>& kernels, Method method)
{
  std::vector<Query_options> ways;
  for (const std::string& kernel : kernels) {
    const auto way = parse_kernel(kernel);
    if (!way) throw CLI::ValidationError("--kernel " + kernel, "expected " + kernel_names());
    ways.push_back(*way);
    ways.back().method = method;
  }
  return ways;
}

/// All that one call answers.
struct Collide_answers {
  std::vector<std::string> names;  // of the columns: kernels, then external programs
  std::vector<std::vector<Answer_row>> columns;
  std::string lists, curves, proofs;
  bool failed = false;  // one of the programs
};

/// Asks the kernels about the points of a case. Throws CLI::ValidationError for an option about bodies.
void answer_predicate(const verify::Case_file& c, const Collide_options& options, bool question_is_given,
                      Collide_answers& answers)
{
  const std::string& file = options.names.a;
  for (const auto& [given, name] : {std::pair(question_is_given, "--question"),
                                    {options.features, "--features"},
                                    {options.contacts, "--contacts"},
                                    {options.relation, "--relation"},
                                    {options.time, "--time"},
                                    {!options.certificate.empty(), "--certificate"},
                                    {!options.others.commands.empty(), "--subject-command"},
                                    {options.method != "tree", "--method"}})
    if (given) throw CLI::ValidationError(name, "expected with bodies; " + file + " asks a predicate");
  for (const std::string& kernel : answers.names) answers.columns.push_back({answer_of(c, kernel, file)});
}

/// Asks about two bodies in all ways, and then the external programs.
void answer_bodies(const Placed_models& scene, const std::vector<Query_options>& ways, const Collide_options& options,
                   Collide_answers& answers)
{
  for (const Query_options& way : ways) {
    const Stopwatch since;
    Query query(scene.a.body, scene.b.body, options.lists() ? Question::surface : scene.question, way);
    const double ready = since.milliseconds();
    if (options.lists()) {
      answers.lists =
          options.features ? features_of(query, scene, options) : contacts_of(query, scene, options, answers.curves);
      continue;
    }
    const Answers column = ask(query, scene.poses, options.passes(), options.relation);
    if (options.time) tell_first_query(query, scene, column, ready);
    if (!options.certificate.empty() && answers.proofs.empty()) answers.proofs = certificate(query, scene);
    answers.columns.push_back(column.rows);
  }
  for (const verify::Object_subject& command : command_subjects(options.others, verify::object_subjects())) {
    answers.columns.push_back(ask(command, scene, answers.failed));
    answers.names.push_back(command.name);
  }
}

void write_all(const Collide_answers& answers, const Collide_options& options)
{
  std::string text = answers.lists;
  if (!options.lists())
    text = answers.columns.size() == 1 ? answer_rows(answers.columns[0], options.format())
                                       : answer_columns(answers.names, answers.columns, options.format());
  write_answers(options.csv, text);
  if (!options.curves.empty()) write_whole(options.curves, answers.curves);
  if (!options.certificate.empty()) write_whole(options.certificate, answers.proofs);
}

void run_collide(const Collide_options& options, bool question_is_given)
{
  Question question = required_question(options.question);
  const auto method = parse_method(options.method);
  if (!method) throw CLI::ValidationError("--method " + options.method, "expected tree, tuned, paper or brute");
  options.require(true);
  require_options(options);
  Collide_answers answers;
  answers.names = kernels_of(options);
  if (!options.curves.empty()) options.names.refuse_as_output(options.curves);
  options.require_files();
  if (!options.curves.empty() && !options.csv.empty() && is_same_file(options.curves, options.csv))
    throw CLI::ValidationError("--curves " + options.curves, "expected another file than that of --csv");

  std::optional<verify::Case_file> c;
  if (verify::is_case_name(options.names.a)) {
    options.names.refuse_all_but_case();
    c = verify::read_case(options.names.a);
  }
  if (c && c->level == verify::Case_kind::predicate) {
    answer_predicate(*c, options, question_is_given, answers);
  } else {
    const std::vector<Query_options> ways = ways_of(answers.names, *method);
    if (c && !question_is_given && !options.relation) question = c->question;
    answer_bodies(c ? models_of(*c->object, options, question) : read_models(options, question), ways, options,
                  answers);
  }
  write_all(answers, options);
  if (answers.failed) throw CLI::RuntimeError(1);
}

}  // namespace

void add_collide_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("collide", "Whether two models collide: one answer a pose");
  const auto options = std::make_shared<Collide_options>();
  command
      ->add_option(
          "A", options->names.a,
          "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body; or a case file, *.case.json, that holds all")
      ->required();
  command->add_option("B", options->names.b, "Model");
  const CLI::Option* question =
      add_default(*command, "--question", options->question,
                  "solid: do the solids share a point; surface: do the surfaces; of a case file: its own");
  add_default(*command, "--kernel", options->kernel, kernel_names());
  command
      ->add_option("--compare", options->compare,
                   "Kernels asked beside --kernel, as K,K: a column each behind its own, blanks between them; in the "
                   "CSV headed by name")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_subject_options(*command, options->others);
  add_default(*command, "--method", options->method,
              "tree: the kernel's fastest; tuned: Jimenez & Segura's with the fastest choices; paper: as published; "
              "brute: all pairs");
  command->add_flag("--features", options->features,
                    "All colliding pairs (edge of one, face of the other) instead of the answer");
  command->add_flag("--contacts", options->contacts,
                    "All pairs of faces that meet, and where, instead of the answer: points, segments and polygons");
  command->add_flag("--exact", options->exact, "With --contacts: fractions instead of the nearest doubles");
  command->add_flag(
      "--normals", options->normals,
      "With --contacts: behind each piece the unit normals of the faces of A and B, outward where faces are "
      "oriented outward; each component is at most one unit in the last place off; --json has the doubles "
      "on both sides");
  command->add_option(
      "--curves", options->curves,
      "With --contacts: write the segments, joined into chains and loops, to this file, *.obj or *.ply");
  command->add_flag("--relation", options->relation,
                    "apart, surfaces, a_in_b or b_in_a instead of 0 or 1, for --question solid");
  add_certificate_option(*command, options->certificate);
  command->add_option("--csv", options->csv, "Write a table to this file");
  command->add_flag("--json", options->json, "Write JSON to standard output");
  command->add_flag(
      "--time", options->time,
      "With --csv or --json: nanoseconds and work of each pose; standard error tells what the first query made");
  add_default(*command, "--repeat", options->repeat, "With --time: passes over all poses, of which the fastest counts");
  options->names.add_options_to(*command);
  command->footer(
      "Prints 1 or 0 for each pose. With --features: a line for each pair: pose, body (0: edge of A, face of B), edge, "
      "face, kind.\n"
      "With --contacts: pose, face of A, face of B, point, segment or coplanar, and two ends; --json has the "
      "polygons. From 2^1024 - 2^970 on, half a step beyond the largest double, the nearest double is `inf`, as IEEE "
      "754 rounds.\n"
      "A case file of a predicate prints that predicate's answer.\n"
      "With --compare double,float a line is `1 1 0`: the answers of adaptive (or of --kernel), double and float; CSV: "
      "pose,adaptive,double,float.\n"
      "With --subject-command a column more: `-` where the program declines, `failed` where it crashes, hangs or sends "
      "no answer; standard error then says how, and the exit status is 1.\n"
      "Example: tetracone collide cat.off house.poly --pose-b poses.txt --kernel epick --csv answers.csv --time");
  command->callback([options, question] { run_collide(*options, question->count() > 0); });
}

}  // namespace tetracone::experiments
