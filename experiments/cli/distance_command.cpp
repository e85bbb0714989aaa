#include "experiments/cli/pair_command.h"

namespace tetracone::experiments {
namespace {

struct Distance_options : Pair_options {
  std::string within, question = "solid", kernel = "adaptive";
  bool exact = false, points = false;
};

std::string exact_line(const Nearest& nearest, const std::array<Model_file, 2>& models)
{
  std::string line = nearest.squared;
  for (int body = 0; body < 2; ++body) {
    line += " ";
    for (int k = 0; k < 3; ++k) line += " " + nearest.point[body][k];
    line += " " + named_as_in_file(nearest.holder[body], models[body]).text();
  }
  return line + "\n";
}

/// The distance and the two points, each number as the double nearest to it.
std::string points_line(const Nearest& nearest, const std::string& blank, const std::string& wide_blank)
{
  std::string line = kernel::shortest(nearest.distance);
  for (const auto& point : nearest.point)
    for (std::size_t k = 0; k < 3; ++k)
      line += (k == 0 ? wide_blank : blank) + kernel::shortest(kernel::nearest_double(kernel::Rational(point[k])));
  return line + "\n";
}

/// The line of pose k.
std::string answer_line(const Distance_options& options, Asked_pair& asked, std::size_t k)
{
  const kernel::Pose &a = asked.poses.of_a(k), &b = asked.poses.of_b(k);
  if (options.exact) return exact_line(asked.query.nearest(a, b), asked.models);
  if (options.points) return points_line(asked.query.nearest(a, b), options.blank(), options.csv.empty() ? "  " : ",");
  if (!options.within.empty()) return asked.query.within(a, b, options.within) ? "1\n" : "0\n";
  return kernel::shortest(asked.query.distance(a, b)) + "\n";
}

/// Returns a line a pose, or the table, with the work of the last pass.
std::string answers_of(const Distance_options& options, Asked_pair& asked)
{
  std::vector<std::string> lines(asked.poses.count()), work(lines.size());
  std::vector<double> fastest(lines.size(), std::numeric_limits<double>::infinity());
  asked.query.clear_statistics();
  ask_all(
      "poses", lines.size(), options.passes(), [&](std::size_t k) { return answer_line(options, asked, k); },
      [&](std::size_t k, std::string line, double ns) {
        lines[k] = std::move(line);
        fastest[k] = std::min(fastest[k], ns);
        if (options.time) work[k] = work_columns(fastest[k], asked.query.statistics());
        asked.query.clear_statistics();
      });
  std::string text;
  if (!options.csv.empty()) {
    text = std::string("pose,") + (options.within.empty() ? "distance" : "within");
    if (options.points) text += ",x0,y0,z0,x1,y1,z1";
    text += options.time ? ",ns,bounding_tests,primitive_tests,exact_fallbacks\n" : "\n";
  }
  for (std::size_t k = 0; k < lines.size(); ++k)
    text += options.csv.empty() ? lines[k]
                                : std::to_string(k) + "," + lines[k].substr(0, lines[k].size() - 1) + work[k] + "\n";
  return text;
}

std::string certificate(const Distance_options& options, Asked_pair& asked)
{
  Certificate certificate = certificate_of(asked.models[0], asked.models[1]);
  for (std::size_t k = 0; k < asked.poses.count(); ++k) {
    const kernel::Pose &a = asked.poses.of_a(k), &b = asked.poses.of_b(k);
    if (options.within.empty())
      certificate.distance(asked.query, a, b);
    else
      certificate.within(asked.query, a, b, options.within);
  }
  return certificate.text();
}

void run_distance(const Distance_options& options)
{
  const Question question = required_question(options.question);
  const auto how = parse_kernel(options.kernel);
  if (!how || (how->kernel != Kernel::adaptive && how->kernel != Kernel::double_ && how->kernel != Kernel::rational))
    throw CLI::ValidationError("--kernel " + options.kernel, "expected adaptive, double or rational");
  for (const auto& [given, name] : {std::pair(options.exact, "--exact"),
                                    {options.points, "--points"},
                                    {!options.certificate.empty(), "--certificate"}})
    if (given && how->kernel == Kernel::double_)
      throw CLI::ValidationError(name, "expected --kernel adaptive or rational");
  if (options.points && (options.exact || !options.within.empty()))
    throw CLI::ValidationError("--points", "expected without --exact and --within");
  if (options.exact && !options.within.empty()) throw CLI::ValidationError("--exact", "expected without --within");
  if (options.exact && !options.csv.empty()) throw CLI::ValidationError("--exact", "expected without --csv");
  require_distance(options.within);
  options.require(false);
  options.require_files();

  Asked_pair asked = read_pair(options.names, question, *how);
  const std::string text = answers_of(options, asked);
  if (!options.certificate.empty()) write_whole(options.certificate, certificate(options, asked));
  write_answers(options.csv, text);
}

struct Zone_options {
  Scene_names names;
  std::string within, question = "solid";
};

void run_zone(const Zone_options& options)
{
  const Question question = required_question(options.question);
  require_distance(options.within);
  Asked_pair asked = read_pair(options.names, question);
  std::string text;
  Progress progress("poses", asked.poses.count());
  for (std::size_t k = 0; k < asked.poses.count(); ++k) {
    std::vector<covering::Index> faces;
    for (const covering::Index f : asked.query.zone(asked.poses.of_a(k), asked.poses.of_b(k), options.within))
      faces.push_back(asked.models[0].source_face[f]);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const covering::Index f : faces) text += (f == faces.front() ? "" : " ") + std::to_string(f);
    text += faces.empty() ? "-\n" : "\n";
    progress.step();
  }
  std::cout << text;
}

}  // namespace

void add_distance_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "distance", "How far apart two models are: the double nearest to the exact distance, a line a pose");
  const auto options = std::make_shared<Distance_options>();
  add_models(*command, options->names.a, options->names.b);
  add_default(*command, "--question", options->question,
              "solid: of the solids, 0 where they collide; surface: of the surfaces, which may be open");
  command->add_flag("--exact", options->exact,
                    "Print the squared distance, then of A and of B the nearest point and what holds it, as fractions");
  command->add_flag("--points", options->points,
                    "Print, after the distance, the nearest point of A and that of B, each coordinate as the double "
                    "nearest to it; of several such pairs one");
  command->add_option("--within", options->within,
                      "1 or 0: is the distance at most this, a decimal number (its double) or a fraction n/d");
  add_default(*command, "--kernel", options->kernel, "adaptive, double or rational");
  command->add_option("--csv", options->csv,
                      "Write a table to this file: pose,distance or, with --within, pose,within");
  command->add_flag("--time", options->time, "With --csv: nanoseconds and work of each pose");
  add_default(*command, "--repeat", options->repeat, "With --time: passes over all poses, of which the fastest counts");
  add_certificate_option(*command, options->certificate);
  options->names.add_options_to(*command);
  command->footer(
      "With --exact a line is `SQUARE  X Y Z HOLDER  X Y Z HOLDER`; a holder is `vertex V`, `edge V V`, `face F` or "
      "`interior`. Faces are those of the file: triangles that replace a face are that face.\n"
      "From 2^1024 - 2^970 on, half a step beyond the largest double, the nearest double is `inf`, as IEEE 754 "
      "rounds.\n"
      "Example: tetracone distance cat.off house.poly --pose-b poses.txt --within 1/10");
  command->callback([options] { run_distance(*options); });
}

void add_zone_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("zone", "The faces of one model that come near another, a line a pose");
  const auto options = std::make_shared<Zone_options>();
  add_models(*command, options->names.a, options->names.b);
  command
      ->add_option("--within", options->within,
                   "The distance, a decimal number (its double) or a fraction n/d: decided on squares, exactly")
      ->required();
  add_default(*command, "--question", options->question,
              "solid: how far from B's solid; surface: from its surface, which may be open");
  options->names.add_options_to(*command);
  command->footer(
      "One line a pose: the numbers of the faces of A that have a point within that distance of B, or `-` for none.\n"
      "Example: tetracone zone cat.off house.poly --within 1/10 --pose-b poses.txt");
  command->callback([options] { run_zone(*options); });
}

}  // namespace tetracone::experiments
