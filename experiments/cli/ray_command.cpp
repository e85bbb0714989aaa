#include "experiments/cli/pair_command.h"
#include "tetracone/covering/io/read_rays.h"
#include "tetracone/covering/model.h"
#include "tetracone/kernel/predicate/ray_face.h"

namespace tetracone::experiments {
namespace {

struct Ray_options : Answer_options {
  std::string model, rays, end;
  Model_options models;
  bool all = false, any = false, sides = false, normals = false;
};

/// Where the ray first meets the triangle, exactly; the triangle may be a segment.
std::optional<kernel::Rational> first_t(const kernel::Rational_ray& ray, const std::array<covering::Vertex, 3>& corners)
{
  covering::Polyhedron alone;
  alone.vertices.assign(corners.begin(), corners.end());
  alone.add_polygon({0, 1, 2});
  const covering::Model<kernel::Rational_kernel> model(alone);
  return kernel::ray_face(ray, covering::Model_face<kernel::Rational_kernel>(model, 0));
}

/// Whether two triangles of one face of the file are met in one point, which belongs to a corner or an edge of both.
/// Requires that the ray meets both.
bool is_met_once(const Ray& ray, const std::array<covering::Vertex, 3>& a, const std::array<covering::Vertex, 3>& b)
{
  std::vector<covering::Vertex> common;
  for (const covering::Vertex& corner : a)
    if (std::find(b.begin(), b.end(), corner) != b.end() &&
        std::find(common.begin(), common.end(), corner) == common.end())
      common.push_back(corner);
  if (common.empty()) return false;
  kernel::Rational_ray exact;
  for (int k = 0; k < 3; ++k) {
    exact.origin[k] = ray.origin[k];
    exact.direction[k] = ray.direction[k];
  }
  const kernel::Rational t = first_t(exact, a).value();
  if (t != first_t(exact, b).value()) return false;
  // A face that winds twice about a point has the same triangle twice.
  if (common.size() == 3) return true;
  for (int k = 0; k < 3; ++k) exact.origin[k] += t * exact.direction[k];
  const auto from_point = first_t(exact, {common.front(), common.back(), common.front()});
  return from_point && *from_point == 0;
}

/// The hits that the faces of the file have. A ray may meet several triangles of a split face. Two of them met in one
/// point of their common edge count as one hit.
std::vector<Ray_hit> as_in_file(const Ray& ray, const std::vector<Ray_hit>& hits, const Model_file& model)
{
  const auto corners = [&](covering::Index triangle) {
    const covering::Loop loop = model.polyhedron().loop(triangle, 0);
    const auto& vertices = model.polyhedron().vertices;
    return std::array{vertices[loop[0]], vertices[loop[1]], vertices[loop[2]]};
  };
  std::vector<Ray_hit> kept;
  for (const Ray_hit& hit : hits) {
    const covering::Index face = model.source_face[hit.face];
    const auto is_of_same_face = [&](const Ray_hit& other) {
      return other.t == hit.t && model.source_face[other.face] == face &&
             is_met_once(ray, corners(other.face), corners(hit.face));
    };
    if (std::none_of(kept.begin(), kept.end(), is_of_same_face)) kept.push_back(hit);
  }
  return kept;
}

/// The words of a hit: the face of the file, t, and what the options add.
std::vector<std::string> hit_words(const Ray& ray, const Ray_hit& hit, const Model_file& model,
                                   const Ray_options& options)
{
  std::vector<std::string> words = {std::to_string(model.source_face[hit.face]), kernel::shortest(hit.t)};
  if (options.sides) words.emplace_back(to_string(model.body.crossing(ray, hit.face)));
  if (options.normals)
    for (const double x : model.body.normal(hit.face)) words.push_back(kernel::shortest(x));
  return words;
}

double end_of(const Ray_options& options)
{
  if (options.end.empty()) return std::numeric_limits<double>::infinity();
  const auto end = kernel::parse_double(options.end);
  if (!end) throw CLI::ValidationError("--end " + options.end, "expected a finite decimal number");
  return *end;
}

void run_ray(const Ray_options& options)
{
  options.require(false);
  if (options.any && (options.all || options.sides || options.normals))
    throw CLI::ValidationError("--any", "expected without --all, --sides and --normals");
  if (!options.certificate.empty() && (options.all || options.any))
    throw CLI::ValidationError("--certificate", "expected without --all and --any");
  const double end = end_of(options);
  options.require_files([&](const std::string& file) { refuse_input(file, {options.model, options.rays}); });
  const auto rays = covering::read_rays(options.rays);
  const Model_file model = load_model(options.model, options.models, false);
  const Body body = model.body;
  body.make_all();  // no ray's time is that of the tree
  std::optional<Certificate> certificate;
  if (!options.certificate.empty()) certificate.emplace(certificate_of(model));

  const std::size_t columns = 2 + (options.sides ? 1 : 0) + (options.normals ? 3 : 0);
  std::string text, csv = options.any ? "ray,hit" : "ray,face,t";
  if (options.sides) csv += ",side";
  if (options.normals) csv += ",nx,ny,nz";
  csv += options.time ? ",ns\n" : "\n";
  Progress progress("rays", rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto& r = rays[k];
    const Ray ray{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}};
    const Stopwatch watch;
    std::vector<Ray_hit> hits;
    bool is_hit = false;
    if (options.any)
      is_hit = body.is_hit(ray, end);
    else if (options.all)
      hits = body.hits(ray, end);
    else if (const auto first = body.first_hit(ray, end))
      hits = {*first};
    const std::string ns = options.time ? ns_column(watch.nanoseconds()) : "";
    if (certificate) certificate->first_hit(ray, hits.empty() ? std::nullopt : std::optional(hits[0]), end);
    hits = as_in_file(ray, hits, model);
    if (options.any) {
      text += is_hit ? "1" : "0";
      csv += std::to_string(k) + (is_hit ? ",1" : ",0") + ns + "\n";
    } else if (hits.empty()) {
      text += "-";
      csv += std::to_string(k) + ",-" + std::string(columns - 1, ',') + ns + "\n";
    }
    for (std::size_t h = 0; h < hits.size(); ++h) {
      const auto words = hit_words(ray, hits[h], model, options);
      text += (h == 0 ? "" : " ") + joined(words, " ");
      csv += std::to_string(k) + "," + joined(words, ",") + ns + "\n";
    }
    text += "\n";
    progress.step();
  }
  write_answers(options.csv, options.csv.empty() ? text : csv);
  if (certificate) write_certificate(options.certificate, *certificate);
}

}  // namespace

void add_ray_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("ray", "Where rays meet a surface first: the face and t");
  const auto options = std::make_shared<Ray_options>();
  command->add_option("MODEL", options->model, "A model: OFF, OBJ, PLY, STL, TetGen .poly or a saved body")->required();
  command->add_option("RAYS", options->rays, "Rays: one a line, six decimals, origin and direction; '#' comments")
      ->required();
  command->add_flag(
      "--all", options->all,
      "Every face that is met, `face t` after `face t`, in order; each crossing of one that is not planar");
  command->add_option("--end", options->end, "Only what is met at a t of at most this decimal number, exactly");
  command->add_flag("--any", options->any, "1 or 0 a line: is anything met");
  command->add_flag("--sides", options->sides,
                    "Print, after t, `entering` against the face's normal, `leaving` with it, or `along` its plane");
  command->add_flag("--normals", options->normals,
                    "Print, after that, the face's unit normal, outward where faces are oriented outward; each "
                    "component is the double nearest to it");
  add_certificate_option(*command, options->certificate);
  command->add_option("--csv", options->csv, "Write a table to this file");
  command->add_flag("--time", options->time, "With --csv: nanoseconds of each ray");
  options->models.add_to(*command);
  command->footer(
      "One line a ray: `face t`, or `-` where it meets none. The point is origin + t direction; t is the double "
      "nearest to the exact one: from 2^1024 - 2^970 on, half a step beyond the largest double, that is `inf`, as IEEE "
      "754 rounds. Of faces met at once, the least number is first.\n"
      "Example: tetracone ray house.poly rays.txt --all");
  command->callback([options] { run_ray(*options); });
}

}  // namespace tetracone::experiments
