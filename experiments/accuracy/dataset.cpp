#include "experiments/accuracy/experiments.h"

#include "experiments/accuracy/dataset_files.h"
#include "experiments/support/sha256.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/write.h"
#include "tetracone/covering/repair/repair.h"
#include "verify/campaign/family_lines.h"
#include "verify/cases/case_numbers.h"
#include "verify/families/families.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/predicate_truth.h"

#include <nlohmann/json.hpp>

#include <map>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

using kernel::Question;
using Json = nlohmann::ordered_json;

/// A double is a number, any other rational a string n/d.
Json number(const kernel::Rational& x)
{
  const std::string text = kernel::exact_text(x);
  return text.find('/') == std::string::npos ? Json(kernel::nearest_double(x)) : Json(text);
}
Json number(const kernel::Pose& pose, int k) { return pose.is_rational() ? number(pose.exact(k)) : Json(pose[k]); }

/// Returns a number in JSON, or a text for an infinite one, which JSON lacks.
Json finite_or_text(double x)
{
  if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
  return x;
}

Json of_distance(double log2) { return finite_or_text(std::round(16 * log2) / 16); }

/// The polyhedron as triangles, without new vertices.
covering::Polyhedron as_triangles(const covering::Polyhedron& polyhedron)
{
  covering::Polyhedron triangles;
  triangles.vertices = polyhedron.vertices;
  for (covering::Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.is_triangle(f)) {
      triangles.add_polygon(polyhedron.loop(f, 0));
      continue;
    }
    const auto parts = covering::repair::constrained_delaunay(polyhedron, f);
    for (const auto& triangle : parts ? *parts : covering::repair::fan(polyhedron, f)) triangles.add_polygon(triangle);
  }
  return triangles;
}

/// Rows of a table, as CSV and as JSON Lines.
class Rows {
 public:
  /// Adds a value in JSON's form; CSV has no strings, and 1 and 0 for true and false.
  void add(const std::string& column, const Json& value)
  {
    csv_row_.add(column, csv_of(value));
    json_row_[column] = value;
  }
  void end()
  {
    if (columns_.empty())
      for (const auto& column : json_row_.items()) columns_.push_back(column.key());
    csv_.add(std::exchange(csv_row_, {}));
    json_lines_ += std::exchange(json_row_, Json::object()).dump() + "\n";
  }
  const std::vector<std::string>& columns() const { return columns_; }
  const std::string& csv() const { return csv_.text(); }
  const std::string& json_lines() const { return json_lines_; }

 private:
  static std::string csv_of(const Json& value)
  {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
    return value.is_number_float() ? kernel::shortest(value.get<double>()) : value.dump();
  }

  Csv_row csv_row_;
  Csv_table csv_;
  Json json_row_ = Json::object();
  std::string json_lines_;
  std::vector<std::string> columns_;
};

void add_origin(Rows& rows, const verify::Origin& origin)
{
  rows.add("id", origin.family + "-" + std::to_string(origin.index));
  rows.add("family", origin.family);
  rows.add("index", origin.index);
  rows.add("parameter", finite_or_text(origin.parameter));
  rows.add("seed", origin.seed);
}

/// The families of the cases: as CSV, and as a section of the README.
struct Described_families {
  std::string csv, markdown;
};

Described_families described_families()
{
  std::string csv = "family,what,parameter,values\n";
  std::string text =
      "\n## Families\n\n`families.csv` says the same. The parameter of a case is in its row; the values are taken in "
      "turn.\n\n"
      "| family | what its cases have in common | parameter | values |\n|---|---|---|---|\n";
  for (const verify::Family_line& line : verify::family_lines()) {
    if (!verify::find_family(line.name)) continue;  // of other levels
    const std::string name(line.name), what(line.what), parameter(line.parameter), values = sweep_text(line);
    csv += name + ",\"" + what + "\",\"" + parameter + "\"," + values + "\n";  // no description has a quote
    text += "| `" + name + "` | " + what + " | " + parameter + " | " + values + " |\n";
  }
  return {csv, text};
}

/// The fields of Croissant for the columns of TABLE.csv. `meanings` has type and description of each column; columns
/// of poses and of points, which are many, by their first letter.
Json fields(const std::string& table, const std::vector<std::string>& columns, const Json& meanings)
{
  Json all = Json::array();
  for (const std::string& column : columns) {
    const Json& meaning = meanings.at(meanings.contains(column) ? column : column.substr(0, 1));
    all.push_back({{"@type", "cr:Field"},
                   {"@id", table + "/" + column},
                   {"name", column},
                   {"description", meaning[1]},
                   {"dataType", meaning[0]},
                   {"source", {{"fileObject", {{"@id", table + ".csv"}}}, {"extract", {{"column", column}}}}}});
  }
  return all;
}

/// A section of the README: what each column means, those of one meaning together.
std::string described_fields(const Json& tables)
{
  std::string text = "\n## Fields\n\n| file | column | meaning |\n|---|---|---|\n";
  for (const Json& table : tables) {
    const Json& fields = table["field"];
    for (std::size_t first = 0, next; first < fields.size(); first = next) {
      next = first + 1;
      while (next < fields.size() && fields[next]["description"] == fields[first]["description"]) ++next;
      text += "| `" + table["@id"].get<std::string>() + "` | `" + fields[first]["name"].get<std::string>() + "`";
      if (next > first + 1) text += " .. `" + fields[next - 1]["name"].get<std::string>() + "`";
      text += " | " + fields[first]["description"].get<std::string>() + " |\n";
    }
  }
  return text;
}

void agree(bool same)
{
  if (!same) throw std::runtime_error("the two truths disagree; tetracone verify says where");
}

/// Files and, last, their checksums in SHA256SUMS.
class Checked_folder {
 public:
  explicit Checked_folder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& name, std::string_view text)
  {
    write_whole(folder_ / name, std::string(text));
    checksums_[name] = sha256(text);
  }

  /// Returns the name of the mesh's file in meshes/, which is added once: cases share polyhedra.
  std::string mesh(const covering::Polyhedron& polyhedron)
  {
    const std::string text = covering::write_off(polyhedron);
    const auto [found, is_new] = meshes_.try_emplace(text, "m" + std::to_string(meshes_.size()) + ".off");
    if (is_new) add("meshes/" + found->second, text);
    return found->second;
  }

  const std::string& sum(const std::string& name) const { return checksums_.at(name); }
  std::uintmax_t size(const std::string& name) const { return std::filesystem::file_size(folder_ / name); }

  void write_sums() const
  {
    std::string text;
    for (const auto& [name, sum] : checksums_) text += sum + "  " + name + "\n";
    write_whole(folder_ / "SHA256SUMS", text);
  }

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::string> checksums_, meshes_;  // by the file's name, and by the mesh's text
};

void add_distance(Rows& rows, const verify::Distance& distance)
{
  rows.add("log2_rho", of_distance(distance.log2_rho));
  rows.add("log2_ulps", of_distance(distance.log2_ulps));
}

void add_poses(Rows& rows, const kernel::Pose& a, const kernel::Pose& b)
{
  for (const auto& [body, pose] : {std::pair('a', &a), {'b', &b}})
    for (int k = 0; k < 12; ++k) rows.add(body + std::to_string(k / 4) + std::to_string(k % 4), number(*pose, k));
}

/// The corners of both triangles of a case, placed: s0 s1 s2 and t0 t1 t2.
void add_triangles(Rows& rows, const verify::Predicate_case& c)
{
  const auto pair = verify::placed_triangles(c);
  for (std::size_t k = 0; k < 18; ++k)
    rows.add({"st"[k / 9], "012"[k / 3 % 3], "xyz"[k % 3]}, number(pair[k / 9][k / 3 % 3][k % 3]));
}

/// The points of a case as they are given, and their poses.
void add_points(Rows& rows, const verify::Predicate_case& c)
{
  const std::pair<const char*, const kernel::Vertex*> points[] = {
      {"v0", &c.v[0]}, {"v1", &c.v[1]}, {"v2", &c.v[2]}, {"v3", &c.v[3]}, {"p", &c.p}, {"q", &c.q}, {"r", &c.r}};
  for (const auto& [name, point] : points)
    for (int i = 0; i < 3; ++i) rows.add(name + std::string(1, "xyz"[i]), (*point)[i]);
  add_poses(rows, c.pose_a, c.pose_b);
}

/// The rows of the cases. Functions throw std::runtime_error where the two truths disagree.
struct Tables {
  Rows cases, predicates, triangles;

  void add(verify::Object_case c, Checked_folder& kept)
  {
    c.a = std::make_shared<const covering::Polyhedron>(as_triangles(*c.a));
    c.b = std::make_shared<const covering::Polyhedron>(as_triangles(*c.b));
    const verify::Brute_body a(*c.a), b(*c.b);
    add_origin(cases, c.origin);
    cases.add("mesh_a", kept.mesh(*c.a));
    cases.add("mesh_b", kept.mesh(*c.b));
    for (const Question question : {Question::surface, Question::solid}) {
      const bool truth = verify::collide(a, c.pose_a, b, c.pose_b, question);
      agree(truth == verify::integer_truth::collide(c, question));
      cases.add(question == Question::solid ? "solid" : "surface", truth);
    }
    add_distance(cases, verify::distance(c));
    add_poses(cases, c.pose_a, c.pose_b);
    cases.end();
  }

  void add(const verify::Predicate_case& c)
  {
    for (const verify::Predicate predicate : verify::all_predicates) {
      const auto truth = verify::true_answer(predicate, c);
      agree(truth == verify::integer_truth::answer(predicate, c));
      if (!truth) continue;
      const bool is_of_triangles = predicate == verify::Predicate::triangle_triangle;
      Rows& rows = is_of_triangles ? triangles : predicates;
      add_origin(rows, c.origin);
      if (!is_of_triangles) rows.add("predicate", verify::to_string(predicate));
      rows.add("truth", *truth);
      add_distance(rows, verify::distance(predicate, c));
      is_of_triangles ? add_triangles(rows, c) : add_points(rows, c);
      rows.end();
    }
  }

  /// Returns the tables by the names of their files.
  std::map<std::string, const Rows*> by_name() const
  {
    return {{"cases", &cases}, {"predicates", &predicates}, {"triangles", &triangles}};
  }
};

Tables tables_of(std::uint64_t seed, std::uint64_t cases, Checked_folder& kept)
{
  Tables tables;
  Progress progress("cases", 2 * cases * verify::families().size());
  for (const verify::Family& family : verify::families())
    for (std::uint64_t k = 0; k < cases; ++k) {
      tables.add(family.object_case(seed, k), kept);
      progress.step();
      tables.add(family.predicate_case(seed, k));
      progress.step();
    }
  return tables;
}

/// Returns the description in Croissant. Requires that the files are in the folder.
Json croissant_of(const std::map<std::string, const Rows*>& tables, const Checked_folder& kept)
{
  Json croissant = Json::parse(dataset_files::croissant_json);
  const Json meanings = croissant["columns"];
  croissant.erase("columns");
  croissant["version"] = TETRACONE_VERSION;
  croissant["datePublished"] = dataset_files::date_released;
  for (Json& file : croissant["distribution"])
    if (file["@type"] == "cr:FileObject") {
      const std::string name = file["contentUrl"];
      file["contentSize"] = std::to_string(kept.size(name)) + " B";
      file["sha256"] = kept.sum(name);
    }
  for (Json& table : croissant["recordSet"])
    table["field"] = fields(table["@id"], tables.at(table["@id"])->columns(), meanings);
  return croissant;
}

}  // namespace

void export_dataset(const Experiment_options& options)
{
  const std::uint64_t cases = options.full ? 20 * options.cases : options.cases;
  const std::filesystem::path folder = options.out / "dataset";
  make_folder(folder / "meshes");
  Checked_folder kept(folder);
  const Tables tables = tables_of(options.seed, cases, kept);
  for (const auto& [name, rows] : tables.by_name()) {
    kept.add(name + ".csv", rows->csv());
    kept.add(name + ".jsonl", rows->json_lines());
  }
  const Described_families described = described_families();
  kept.add("families.csv", described.csv);
  kept.add("LICENSE", dataset_files::license);
  kept.add("tetracone_dataset.py", dataset_files::tetracone_dataset_py);
  kept.add("score.py", dataset_files::score_py);
  kept.add("example.py", dataset_files::example_py);
  kept.add("dataset.json", Json{{"name", "Collisions with exact truth"},
                                {"version", TETRACONE_VERSION},
                                {"licence", "CC0-1.0"},
                                {"seed", options.seed},
                                {"cases_per_family", cases},
                                {"families", verify::families().size()},
                                {"again", again()}}
                                   .dump(1) +
                               "\n");
  const Json croissant = croissant_of(tables.by_name(), kept);
  kept.add("croissant.json", croissant.dump(1) + "\n");
  kept.add("README.md",
           std::string(dataset_files::readme_md) + described_fields(croissant["recordSet"]) + described.markdown);
  kept.write_sums();
}

}  // namespace tetracone::experiments
