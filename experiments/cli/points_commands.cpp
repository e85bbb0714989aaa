#include "experiments/cli/pair_command.h"
#include "tetracone/covering/io/read_points.h"

// `tetracone inside` and `tetracone nearest`: a model, and a line for each point.
namespace tetracone::experiments {
namespace {

struct Points_options : Answer_options {
  std::string model, points;
  Model_options models;
  bool exact = false;
};

using Words = std::vector<std::string>;

bool has_fractions(const covering::Point_numbers& p)
{
  return std::ranges::any_of(p, [](const covering::Number& x) { return x.fraction.has_value(); });
}
std::array<double, 3> nearest_doubles(const covering::Point_numbers& p)
{
  return {p[0].nearest, p[1].nearest, p[2].nearest};
}
std::array<std::string, 3> exact_texts(const covering::Point_numbers& p)
{
  return {kernel::exact_text(p[0].exact()), kernel::exact_text(p[1].exact()), kernel::exact_text(p[2].exact())};
}

/// Writes answer(model, point) for each point: a line of words, or a row of the table that has these columns.
/// `prepare(model)` makes what no point's time is to hold.
template <class Prepare, class Answer>
void answer_points(const Points_options& options, const std::string& columns, const Prepare& prepare,
                   const Answer& answer)
{
  options.require(false);
  options.require_files([&](const std::string& file) { refuse_input(file, {options.model, options.points}); });
  const auto points = covering::read_points(options.points);
  const Model_file model = load_model(options.model, options.models, true);
  prepare(model);

  const bool is_table = !options.csv.empty();
  std::string text = is_table ? "point," + columns + (options.time ? ",ns\n" : "\n") : "";
  ask_all(
      "points", points.size(), 1, [&](std::size_t k) { return answer(model, points[k]); },
      [&](std::size_t k, const Words& words, double ns) {
        if (is_table) text += std::to_string(k) + ",";
        text += joined(words, options.blank()) + (options.time ? ns_column(ns) : "") + "\n";
      });
  write_answers(options.csv, text);
}

CLI::App* add_points_command(CLI::App& app, const std::string& name, const std::string& what, Points_options& options)
{
  CLI::App* command = app.add_subcommand(name, what);
  command->add_option("MODEL", options.model, "A closed model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")
      ->required();
  command
      ->add_option("POINTS", options.points,
                   "Points: one a line, three numbers, decimals or fractions n/d; '#' comments")
      ->required();
  command->add_option("--csv", options.csv, "Write a table to this file");
  command->add_flag("--time", options.time, "With --csv: nanoseconds of each point");
  options.models.add_to(*command);
  return command;
}

void run_inside(const Points_options& options)
{
  std::optional<Certificate> certificate;
  const auto prepare = [&](const Model_file& model) {
    model.body.inside_bytes();
    if (!options.certificate.empty()) certificate.emplace(certificate_of(model));
  };
  answer_points(options, "answer", prepare, [&](const Model_file& model, const covering::Point_numbers& p) {
    const Location at =
        has_fractions(p) ? model.body.inside_text(exact_texts(p)) : model.body.inside(nearest_doubles(p));
    if (certificate) certificate->inside(exact_texts(p), at);
    return Words{std::to_string(int(at))};
  });
  if (certificate) write_certificate(options.certificate, *certificate);
}

/// Returns the distance or its square, the point, what holds it, and whether it is the only one.
Words nearest_words(const Model_file& model, const covering::Point_numbers& p, bool exact)
{
  const auto words = [&](const std::string& distance, const auto& point, const Nearest_point& nearest) {
    return Words{distance,
                 point(0),
                 point(1),
                 point(2),
                 named_as_in_file(nearest.holder, model).text(),
                 nearest.is_only ? "only" : "tied"};
  };
  const auto in_doubles = [&](const Nearest_point& nearest) {
    return words(
        kernel::shortest(nearest.distance), [&](std::size_t k) { return kernel::shortest(nearest.point[k]); }, nearest);
  };
  if (!exact && !has_fractions(p)) return in_doubles(model.body.nearest(nearest_doubles(p)));
  const Exact_nearest_point nearest = model.body.nearest_text(exact_texts(p));
  if (!exact) return in_doubles(nearest);
  return words(
      nearest.squared, [&](std::size_t k) { return nearest.exact_point[k]; }, nearest);
}

void run_nearest(const Points_options& options)
{
  const auto prepare = [](const Model_file& model) {
    model.body.inside_bytes();
    model.body.make_all();
  };
  answer_points(options, options.exact ? "square,x,y,z,holder,ties" : "distance,x,y,z,holder,ties", prepare,
                [&](const Model_file& model, const covering::Point_numbers& p) {
                  return nearest_words(model, p, options.exact);
                });
}

}  // namespace

void add_inside_command(CLI::App& app)
{
  const auto options = std::make_shared<Points_options>();
  CLI::App* command =
      add_points_command(app, "inside", "Where points are: 1 inside the solid, 0 on its surface, -1 outside", *options);
  add_certificate_option(*command, options->certificate);
  command->footer("One line a point. Example: tetracone inside house.poly points.txt");
  command->callback([options] { run_inside(*options); });
}

void add_nearest_command(CLI::App& app)
{
  const auto options = std::make_shared<Points_options>();
  CLI::App* command = add_points_command(
      app, "nearest", "Signed distances of points, and the nearest points of a model's surface", *options);
  command->add_flag("--exact", options->exact, "The squared distance and the nearest point as fractions");
  command->footer(
      "One line a point: `DISTANCE X Y Z HOLDER only|tied`. The distance is negative inside the solid; each number is "
      "the double nearest to the exact one. A holder is `vertex V`, `edge V V` or `face F`. Where other points are as "
      "near, `tied` says so.\n"
      "Example: tetracone nearest house.poly points.txt");
  command->callback([options] { run_nearest(*options); });
}

}  // namespace tetracone::experiments
