#include "experiments/cli/commands.h"

#include "experiments/cli/answer_rows.h"
#include "experiments/cli/contact_rows.h"
#include "tetracone/covering/check.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/body_file.h"

#include <nlohmann/json.hpp>

namespace tetracone::experiments {
namespace {

using covering::Check;
using covering::Read_model;
using covering::Shell;
using kernel::Rational;
using Json = nlohmann::ordered_json;

struct Check_options {
  std::vector<std::string> models;
  bool json = false, self_intersections = false;
  Model_options reading;
};

/// A model for `check`: read, then merged and oriented by the user's options.
struct Checked {
  std::string file;
  Read_model model;
  std::size_t vertices_merged = 0;
  std::size_t faces_oriented = 0;
  Check check;
  bool closes_if_oriented = false;
  std::string what_closes;  ///< of an open one
};

/// Returns the properties of a polyhedron. Volumes and orientations are those of the body that answers: triangles
/// replace faces that are not planar.
Check check_as_answered(const covering::Polyhedron& polyhedron)
{
  Check check = covering::check(polyhedron);
  if (check.off_plane.empty() || !check.closed) return check;
  const Check cut = covering::check(covering::triangulate_non_planar(polyhedron).polyhedron);
  check.volume = cut.volume;
  check.orientation = cut.orientation;
  // A shell whose triangles cancel one another is none of the body's.
  const bool has_same_shells = check.shells.size() == cut.shells.size();
  for (std::size_t k = 0; k < check.shells.size(); ++k) {
    check.shells[k].volume = has_same_shells ? cut.shells[k].volume : std::nullopt;
    if (has_same_shells) check.shells[k].orientation = cut.shells[k].orientation;
  }
  return check;
}

Checked look_at(const std::string& file, const Check_options& options)
{
  Checked result;
  result.file = file;
  if (detail::is_body_file(file))
    result.model.polyhedron = read_body(file).polyhedron();
  else
    result.model = covering::read_model(file);
  auto& polyhedron = result.model.polyhedron;
  if (options.reading.merge) {
    const std::size_t before = polyhedron.vertices.size();
    polyhedron = covering::merge_equal_vertices(polyhedron);
    result.vertices_merged = before - polyhedron.vertices.size();
  }
  if (options.reading.orient) {
    auto oriented = covering::orient(polyhedron);
    result.faces_oriented = oriented.turned.size();
    polyhedron = std::move(oriented.polyhedron);
  }
  result.check = check_as_answered(polyhedron);
  result.closes_if_oriented = result.check.closed || covering::closes_if_oriented(polyhedron);
  if (!result.check.closed) result.what_closes = what_closes(polyhedron);
  return result;
}

/// A name as JSON and a terminal can take it: bytes that are no printable ASCII become '?'.
std::string printable(std::string text)
{
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
  return text;
}

Json optional_rational(const std::optional<Rational>& value)
{
  return value ? Json(kernel::to_string(*value)) : Json(nullptr);
}

Json optional_double(const std::optional<Rational>& value)
{
  return value ? json_number(kernel::nearest_double(*value)) : Json(nullptr);
}

Json to_json(const Checked& checked)
{
  const Check& check = checked.check;
  Json json;
  json["file"] = printable(checked.file);
  json["closed"] = check.closed;
  json["planar"] = check.off_plane.empty();
  json["vertices"] = check.vertices;
  json["used_vertices"] = check.used_vertices;
  json["faces"] = check.faces;
  json["triangles"] = check.triangles;
  json["edges"] = check.edges;
  json["corners"] = check.corners;
  json["holed_faces"] = check.holed_faces.size();
  json["hole_loops"] = check.hole_loops;
  json["orientation"] = to_string(check.orientation);
  json["volume"] = optional_rational(check.volume);
  json["volume_double"] = optional_double(check.volume);
  json["closes_if_oriented"] = checked.closes_if_oriented;
  json["border_edges"] = check.border_edges;
  json["non_manifold_edges"] = check.non_manifold_edges;
  json["open_edges"] = Json::array();
  for (const auto& edge : check.open_edges)
    json["open_edges"].push_back(
        {{"from", edge.from}, {"to", edge.to}, {"uses", edge.uses}, {"reverse_uses", edge.reverse_uses}});
  json["shells"] = Json::array();
  for (const Shell& shell : check.shells)
    json["shells"].push_back({{"vertices", shell.vertices},
                              {"edges", shell.edges},
                              {"faces", shell.faces},
                              {"hole_loops", shell.hole_loops},
                              {"closed", shell.closed},
                              {"euler", shell.euler},
                              {"genus", shell.genus ? Json(*shell.genus) : Json(nullptr)},
                              {"orientation", to_string(shell.orientation)},
                              {"volume", optional_rational(shell.volume)},
                              {"volume_double", optional_double(shell.volume)}});
  json["off_plane"] = Json::array();
  for (const auto& face : check.off_plane)
    json["off_plane"].push_back({{"face", face.face},
                                 {"vertex", face.vertex},
                                 {"squared_distance", kernel::to_string(face.squared_distance)},
                                 {"distance", face.distance}});
  json["degenerate_faces"] = check.degenerate_faces;
  json["degenerate_edges"] = check.degenerate_edges;
  json["repeated_vertices"] = check.repeated_vertices;
  json["isolated_vertices"] = check.isolated_vertices;
  json["loops_turned"] = checked.model.loops_turned;
  json["facets_turned"] = checked.model.facets_turned;
  json["vertices_merged"] = checked.vertices_merged;
  json["faces_oriented"] = checked.faces_oriented;
  json["notes"] = checked.model.notes;
  return json;
}

/// "12 edges", "1 edge".
std::string counted(std::size_t count, const std::string& noun)
{
  if (count == 1) return "1 " + noun;
  return std::to_string(count) + " " + (noun == "vertex" ? "vertices" : noun + "s");
}

/// The first few of a list, then dots.
template <class List, class Show>
std::string first_few(const List& list, Show show)
{
  constexpr std::size_t few = 5;
  std::string text;
  for (std::size_t k = 0; k < list.size() && k < few; ++k) text += (k == 0 ? "" : ", ") + show(list[k]);
  return text + (list.size() > few ? ", ..." : "");
}

/// An exact volume as a person wants it: the fraction where it is short, and the nearest double.
std::string volume_text(const Rational& volume)
{
  const std::string exact = kernel::to_string(volume);
  const std::string nearest = kernel::shortest(kernel::nearest_double(volume));
  if (exact == nearest) return exact;
  return exact.size() <= 40 ? exact + " (" + nearest + ")" : nearest + " (nearest; exact with --json)";
}

std::string shell_text(const Shell& shell)
{
  std::string text = counted(shell.faces, "face") + ", " + std::string(to_string(shell.orientation));
  if (shell.genus)
    text += ", genus " + std::to_string(*shell.genus);
  else if (shell.closed)
    text += ", no 2-manifold";
  if (shell.volume) text += ", volume " + volume_text(*shell.volume);
  return text;
}

/// Lines of a name and a value, the values one below the other.
class Text_rows {
 public:
  void add(const std::string& name, const std::string& value)
  {
    text_ += "  " + name + std::string(name.size() < 20 ? 20 - name.size() : 1, ' ') + value + '\n';
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_counts(Text_rows& rows, const Check& check)
{
  rows.add("vertices", std::to_string(check.vertices) +
                           (check.isolated_vertices.empty()
                                ? ""
                                : ", " + std::to_string(check.isolated_vertices.size()) + " of no face") +
                           (check.repeated_vertices.empty()
                                ? ""
                                : ", " + std::to_string(check.repeated_vertices.size()) + " repeat one before them"));
  rows.add("faces", std::to_string(check.faces) + ", " + counted(check.triangles, "triangle") +
                        (check.holed_faces.empty() ? ""
                                                   : ", " + std::to_string(check.holed_faces.size()) + " with " +
                                                         counted(check.hole_loops, "hole loop")));
  rows.add(
      "edges",
      std::to_string(check.edges) +
          (check.border_edges == 0 ? "" : ", " + std::to_string(check.border_edges) + " of one face") +
          (check.non_manifold_edges == 0 ? "" : ", " + std::to_string(check.non_manifold_edges) + " of more than two"));
}

void add_closed(Text_rows& rows, const Checked& checked)
{
  const Check& check = checked.check;
  if (check.closed) {
    rows.add("closed", "yes");
  } else {
    rows.add("closed", "NO: " + counted(check.open_edges.size(), "directed edge") +
                           " without enough reverse: " + first_few(check.open_edges, [](const auto& edge) {
                             return std::to_string(edge.from) + "->" + std::to_string(edge.to);
                           }));
    rows.add("", checked.what_closes);
    // Merging may be wanted where it does not close.
    if (!check.repeated_vertices.empty() && checked.what_closes.find("--merge") == std::string::npos)
      rows.add("", "equal vertices can be merged: --merge");
  }
}

void add_shells(Text_rows& rows, const Check& check)
{
  if (check.volume) rows.add("volume", volume_text(*check.volume) + ", " + std::string(to_string(check.orientation)));
  rows.add("shells", std::to_string(check.shells.size()));
  constexpr std::size_t most_shells = 10;
  for (std::size_t k = 0; k < check.shells.size() && k < most_shells; ++k) rows.add("", shell_text(check.shells[k]));
  if (check.shells.size() > most_shells) rows.add("", "...");
}

void add_planar(Text_rows& rows, const Check& check)
{
  if (check.off_plane.empty()) {
    rows.add("planar", "yes, every face exactly");
  } else {
    const auto worst = std::ranges::max_element(check.off_plane, {}, &covering::Off_plane::distance);
    rows.add("planar", "NO: " + counted(check.off_plane.size(), "face") + ", at most " +
                           kernel::shortest(worst->distance) + " off (face " + std::to_string(worst->face) +
                           ", vertex " + std::to_string(worst->vertex) + ")");
  }
}

void add_degenerate(Text_rows& rows, const Check& check)
{
  const auto index = [](covering::Index k) { return std::to_string(k); };
  if (!check.degenerate_faces.empty())
    rows.add("degenerate faces",
             std::to_string(check.degenerate_faces.size()) + ": " + first_few(check.degenerate_faces, index));
  if (!check.degenerate_edges.empty())
    rows.add("degenerate edges", std::to_string(check.degenerate_edges.size()) + ": " +
                                     first_few(check.degenerate_edges, [](const auto& edge) {
                                       return std::to_string(edge[0]) + "-" + std::to_string(edge[1]);
                                     }));
}

/// Adds the changes by reading and by the user's options, and the reader's notes.
void add_changes(Text_rows& rows, const Checked& checked)
{
  if (checked.model.loops_turned != 0)
    rows.add("done on reading", counted(checked.model.loops_turned, "hole loop") + " turned against the outer loop");
  if (checked.model.facets_turned != 0)
    rows.add("done on reading", counted(checked.model.facets_turned, "facet") + " oriented across the edges");
  if (checked.vertices_merged != 0) rows.add("done by --merge", counted(checked.vertices_merged, "vertex") + " merged");
  if (checked.faces_oriented != 0)
    rows.add("done by --orient", counted(checked.faces_oriented, "face") + " turned round");
  for (const std::string& note : checked.model.notes) rows.add("note", note);
}

std::string to_text(const Checked& checked)
{
  Text_rows rows;
  add_counts(rows, checked.check);
  add_closed(rows, checked);
  add_shells(rows, checked.check);
  add_planar(rows, checked.check);
  add_degenerate(rows, checked.check);
  add_changes(rows, checked);
  return printable(checked.file) + '\n' + rows.text();
}

void run_check(const Check_options& options)
{
  // Nothing is printed before every model is read.
  std::string text;
  Json json = Json::array();
  bool found = false;
  for (const std::string& file : options.models) {
    const Checked checked = look_at(file, options);
    found = found || !checked.check.closed || (options.reading.strict && !checked.check.off_plane.empty());
    if (options.json)
      json.push_back(to_json(checked));
    else
      text += to_text(checked);
  }
  if (options.json) text = json.dump(2) + "\n";
  std::cout << text;
  if (found) throw CLI::RuntimeError(1);
}

void run_self_intersections(const Check_options& options)
{
  if (options.models.size() != 1)
    throw CLI::ValidationError("--self-intersections", std::to_string(options.models.size()) + " models; expected one");
  const Model_file model = load_model(options.models[0], options.reading, false);
  const auto pairs = self_intersection_rows(model.body.self_intersections(), model, options.json);
  std::cout << pairs.text;
  if (pairs.count > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_check_command(CLI::App& app)
{
  CLI::App* command =
      app.add_subcommand("check", "What a model is: closed, planar, its counts, shells and exact volume");
  const auto options = std::make_shared<Check_options>();
  command->add_option("MODEL", options->models, "OFF, OBJ, PLY, STL or TetGen .poly files, or saved bodies")
      ->required();
  command->add_flag("--json", options->json, "One array, an object a model; rationals are strings n/d");
  options->reading.add_to(*command, "Exit 1 also where a face is not exactly planar");
  command->add_flag("--self-intersections", options->self_intersections,
                    "Instead: `face face kind` a line for each pair of faces of one model that share a point, except "
                    "on a vertex or an edge that both have; exit 1 where there are some. --json: what they share");
  command->footer(
      "Vertices and faces count from 0. Exit status: 0 all closed, 1 some model is no closed polyhedron, 2 bad input.\n"
      "Example: tetracone check --strict cat.off house.poly");
  command->callback(
      [options] { options->self_intersections ? run_self_intersections(*options) : run_check(*options); });
}

}  // namespace tetracone::experiments
