#include "experiments/cli/pair_command.h"

#include "experiments/viewer/view_data.h"
#include "experiments/viewer/viewer_files.h"
#include "tetracone/covering/io/read_rays.h"
#include "tetracone/kernel/number/number.h"
#include "verify/cases/scene_file.h"

#include <algorithm>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

struct View_options {
  Scene_names names;
  Motion_names motion;  // the poses alone
  std::string question, kernel = "double", method = "tree", rays, out;
  std::array<std::string, 3> along;
  bool depth = false;
};

/// The text with every character that could end a script, or a piece of HTML, as an escape of JSON.
std::string safe_in_script(const std::string& json)
{
  std::string text;
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

/// The template with each {{name}} replaced; a part is not searched for names again.
std::string filled(std::string_view page, std::initializer_list<std::pair<std::string_view, std::string_view>> parts)
{
  std::string text;
  while (!page.empty()) {
    const auto begin = page.find("{{"), end = page.find("}}", begin);
    text += page.substr(0, begin);
    if (begin == page.npos) break;
    for (const auto& [name, part] : parts)
      if (page.substr(begin + 2, end - begin - 2) == name) text += part;
    page.remove_prefix(end + 2);
  }
  return text;
}

/// The page of the controls and scripts, in order, about the data.
void write_page(const std::string& out, std::string_view controls, const std::string& data,
                std::initializer_list<std::string_view> scripts)
{
  std::string all;
  for (const std::string_view script : scripts) all.append("<script>\n").append(script).append("</script>\n");
  write_whole(out, filled(viewer::page_html, {{"style", viewer::style_css},
                                              {"controls", controls},
                                              {"data", safe_in_script(data)},
                                              {"three", viewer::three_js},
                                              {"scripts", all}}));
}

/// The scene that the options name, which is no scene file.
View_scene scene_of(const View_options& options, std::optional<kernel::Question> question)
{
  const Scene_names& names = options.names;
  if (!options.motion.is_given()) {
    View_scene scene = read_view_scene(names, question);
    if (options.rays.empty()) return scene;
    refuse_input(options.out, {options.rays});
    if (scene.bodies.size() != 1) throw CLI::ValidationError("--rays " + options.rays, "expected with one model");
    scene.rays = covering::read_rays(options.rays);
    return scene;
  }
  if (names.b.empty() || !names.poses_a.empty() || !names.poses_b.empty() || !options.rays.empty())
    throw CLI::ValidationError("a motion", "expected of two models, without --pose-a, --pose-b and --rays");
  Motion_names motion = options.motion;
  motion.a = names.a;
  motion.b = names.b;
  motion.models = names.models;
  motion.refuse_as_output(options.out);
  return read_view_motion(motion, question.value_or(kernel::Question::solid));
}

/// Throws CLI::ValidationError for a direction of 0. Requires numbers.
void require_direction(const std::array<std::string, 3>& along)
{
  if (std::ranges::all_of(along, [](const std::string& text) { return sgn(*kernel::parse_number(text)) == 0; }))
    throw CLI::ValidationError("--along", "a direction of 0; expected one of some length");
}

void run_view(const View_options& options)
{
  std::optional<kernel::Question> question;
  if (!options.question.empty()) question = required_question(options.question);
  const auto method = verify::parse_method(options.method);
  if (!method) throw CLI::ValidationError("--method " + options.method, "expected tree, tuned, paper or brute");
  if (viewer::three_js.empty())
    throw std::runtime_error(
        "view was built without three.js; expected Debian's libjs-three where this program was configured");

  options.names.refuse_as_output(options.out);
  if (!options.out.ends_with(".html") && !options.out.ends_with(".htm"))
    throw CLI::ValidationError("--out " + options.out, "a page is HTML; expected a name that ends in .html or .htm");
  const bool moves_out = options.depth || !options.along[0].empty();
  if (!verify::is_scene_name(options.names.a)) {
    View_scene scene = scene_of(options, question);
    if (moves_out) {
      const bool is_predicate = scene.from && scene.from->level == verify::Case_kind::predicate;
      if (scene.bodies.size() != 2 || is_predicate || scene.question != kernel::Question::solid)
        throw CLI::ValidationError(options.depth ? "--depth" : "--along", "expected with two solids");
      if (!options.depth) require_direction(options.along);
      scene.way_out = View_way_out{options.along};
    }
    write_page(options.out, viewer::pair_html, view_data(scene, options.kernel, *method),
               {viewer::boxes_js, viewer::bodies_js, viewer::bounds_js, viewer::camera_js, viewer::pair_js});
    return;
  }
  if (!options.names.b.empty() || !options.names.poses_a.empty() || !options.names.poses_b.empty() ||
      !options.rays.empty() || moves_out)
    throw CLI::ValidationError(options.names.a, "expected alone: a scene file names its models and poses");
  write_page(options.out, viewer::scene_html,
             scene_data(options.names.a, question.value_or(kernel::Question::solid), options.names.models),
             {viewer::boxes_js, viewer::camera_js, viewer::scene_js});
}

}  // namespace

void add_view_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("view", "One self-contained page in 3D of a case or of models under poses");
  const auto options = std::make_shared<View_options>();
  Scene_names& names = options->names;
  command
      ->add_option("A", names.a,
                   "Model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body; or a case file, *.case.json, or a scene "
                   "file, *.scene.json, that holds all")
      ->required();
  command->add_option("B", names.b, "Model; without it A is shown alone");
  command->add_option("--out", options->out, "The page, FILE.html or FILE.htm")->required();
  command->add_option("--question", options->question, "solid or surface; default: solid, or the case file's own");
  add_default(*command, "--kernel", options->kernel,
              "Whose answers are compared with the exact ones: " + kernel_names());
  add_default(*command, "--method", options->method,
              "tree: the kernel's fastest; paper: Jimenez & Segura's; brute: all pairs");
  command->add_option("--rays", options->rays,
                      "Rays of one model, in its own coordinates: one a line, six decimals, origin and direction");
  CLI::Option* const along = command->add_option("--along", options->along,
                                                 "Move A out of B along this direction: three decimals or fractions");
  // A direction of too few numbers takes the next option for one.
  along->check([](const std::string& text) {
    return kernel::parse_number(text) ? "" : "'" + text + "'; expected three decimals or fractions";
  });
  command->add_flag("--depth", options->depth, "Move A out of B by the least translation")->excludes(along);
  names.add_options_to(*command);
  options->motion.add_options_to(*command);
  command->footer(
      "Of more than 50,000 triangles in all the page shows bodies and answers alone; more than 1,000,000 are refused.\n"
      "Wrong answers of the kernel are marked on the time line, and the pairs of features that it loses or invents in "
      "the picture. With --pose-a0 to --pose-b1 the page plays one motion to the first contact.\n"
      "Of two solids it names the relation and draws the faces' parts that bound the overlap; of each body, where it "
      "intersects itself.\n"
      "Example: tetracone view cat.off house.poly --pose-b poses.txt --kernel float --out scene.html");
  command->callback([options] { run_view(*options); });
}

}  // namespace tetracone::experiments
