#include "experiments/queries/experiments.h"

#include "experiments/queries/points_truth.h"
#include "experiments/speed/benchmark_workload.h"
#include "experiments/support/heap.h"
#include "experiments/support/model_file.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/write.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/paper/placed_tree.h"

#include <CGAL/Side_of_triangle_mesh.h>

#include <ctime>

namespace tetracone::experiments {
namespace {

using Epick = Exact_predicates;
using Side = CGAL::Side_of_triangle_mesh<Cgal_mesh, Epick>;
using Point = std::array<double, 3>;

constexpr int passes = 5;

/// Returns the processor time of this process in seconds: other programs on the machine do not count.
double processor_time() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// A contestant: prepared from a file, anew each time, then asked all questions at once, with one answer each.
struct Contestant {
  std::string name;
  std::function<void()> set_up;
  std::function<void(std::vector<long>&)> ask;  ///< gives as many as there are places
  std::function<double()> bytes;                ///< none: what the heap has grown by
  bool is_slow = false;                         ///< one pass is enough
};

std::vector<Ray> rays_of(const covering::Polyhedron& body, int count, verify::Random& random)
{
  std::vector<Ray> rays;
  for (const Point& p : points_of(body, false, count, random)) {
    const auto [x, y, z] = random.in_ball();
    rays.push_back({p, {x, y, z}});
  }
  return rays;
}

Cgal_mesh read_by_cgal(const std::string& file)
{
  Cgal_mesh mesh;
  CGAL::IO::read_OFF(file, mesh);
  return mesh;
}

struct Task {
  std::string body, what;
  std::size_t triangles;
  std::vector<long> truth;
  std::uint64_t seed;
};

struct Clocked {
  double ready = 0, bytes = 0, best = 0, signs = 0;
  std::vector<long> answers;
};

/// Asks all contestants in turn, pass by pass, and keeps the best pass of each. In the first one, memory is taken that
/// the process does not have yet. Where `clocked` is not empty, an earlier race has made the contestants ready.
void race(const Task& task, const std::vector<Contestant>& contestants, std::vector<Clocked>& clocked, Csv_table& table)
{
  const bool ready = !clocked.empty();
  clocked.resize(contestants.size());
  // No clock runs while memory is made for them.
  for (Clocked& each : clocked) each.answers.resize(task.truth.size());
  const auto for_passes = [&](const auto& what) {
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t c = 0; c < contestants.size(); ++c)
        if (pass == 0 || !contestants[c].is_slow) what(pass, c);
  };
  if (!ready)
    for_passes([&](int pass, std::size_t c) {
      const double before = double(heap_bytes()), start = processor_time();
      contestants[c].set_up();
      const double ms = 1e3 * (processor_time() - start);
      if (pass == 0 || ms < clocked[c].ready) clocked[c].ready = ms;
      if (pass == 0) clocked[c].bytes = contestants[c].bytes ? contestants[c].bytes() : double(heap_bytes()) - before;
    });
  const double count = double(task.truth.size());
  for_passes([&](int pass, std::size_t c) {
    const auto signs = kernel::Adaptive::decided_by().total();
    const double start = processor_time();
    contestants[c].ask(clocked[c].answers);
    const double ns = 1e9 * (processor_time() - start) / count;
    clocked[c].signs = double(kernel::Adaptive::decided_by().total() - signs) / count;
    if (pass == 0 || ns < clocked[c].best) clocked[c].best = ns;
  });
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    const Clocked& of = clocked[c];
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < task.truth.size(); ++k) wrong += of.answers[k] != task.truth[k];
    table.add(Csv_row()
                  .add("body", task.body)
                  .add("triangles", task.triangles)
                  .add("asked", task.what)
                  .add("contestant", contestants[c].name)
                  .add("ns", of.best)
                  .add("signs", of.signs)
                  .add("setup_ms", of.ready)
                  .add("bytes_per_triangle", of.bytes / double(task.triangles))
                  .add("judged", task.truth.size())
                  .add("wrong", wrong)
                  .add_origin(task.seed));
    std::printf("%-16.16s %6zu  %-6s  %-17s  %8.0f ns  %6.2f signs  %8.1f ms  %6.0f bytes  %zu of %zu wrong\n",
                task.body.c_str(), task.triangles, task.what.c_str(), contestants[c].name.c_str(), of.best, of.signs,
                of.ready, of.bytes / double(task.triangles), wrong, task.truth.size());
    std::fflush(stdout);
  }
}

/// A tree of the paper's over K, of an unmoved body.
template <class K>
struct Located {
  tetratree::Tetra_tree<K> tree;
  tetratree::Placed_tree<K> placed;
  kernel::Pose unmoved;
  explicit Located(const covering::Polyhedron& p) : tree(p, tetratree::Config::fastest()), placed(tree)
  {
    placed.place(unmoved);
  }
};

template <class K, class Make>
Contestant tetra_tree(const std::string& name, const covering::Polyhedron& mesh, const std::vector<Point>& points,
                      const Make& make)
{
  const auto made = std::make_shared<std::optional<Located<K>>>();
  return {name, [made, &mesh] { made->emplace(mesh); },
          [made, &points, make](std::vector<long>& answers) {
            for (std::size_t k = 0; k < points.size(); ++k) answers[k] = long((*made)->placed.locate(make(points[k])));
          },
          nullptr, true};
}

std::vector<Contestant> for_points(const covering::Polyhedron& mesh, const std::string& file,
                                   const std::vector<Point>& points)
{
  struct Cgal {
    Cgal_mesh mesh;
    std::optional<Side> side;
  };
  const auto body = std::make_shared<std::optional<Body>>();
  const auto cgal = std::make_shared<Cgal>();
  const auto boxes = std::make_shared<std::optional<Query>>();
  covering::Polyhedron dot;
  dot.vertices = {{0, 0, 0}};
  dot.add_polygon({0});
  std::vector<Contestant> contestants = {
      {"cones",
       [body, file] {
         body->emplace(read_body(file));
         (*body)->inside_bytes();
       },
       [body, &points](std::vector<long>& answers) {
         std::ranges::transform((*body)->inside(points), answers.begin(), [](Location at) { return long(at); });
       },
       [body] { return double((*body)->inside_bytes()); }},
      {"boxes",
       [boxes, file, dot] {
         const Body read = read_body(file);
         read.make_all();
         boxes->emplace(read, Body(dot), Question::solid);
       },
       [boxes, &points](std::vector<long>& answers) {
         for (std::size_t k = 0; k < points.size(); ++k) {
           const auto& [x, y, z] = points[k];
           const Relation at = (*boxes)->collide(Pose(), Pose::translation(x, y, z)).relation();
           answers[k] = at == Relation::apart ? -1 : at == Relation::surfaces ? 0 : 1;
         }
       },
       [boxes] { return double((*boxes)->bytes()); }},
      tetra_tree<kernel::Adaptive>("tetra-tree", mesh, points, kernel::Adaptive::unmoved),
      tetra_tree<kernel::Double>("tetra-tree double", mesh, points, kernel::point<kernel::Double>),
      {"CGAL",
       [cgal, file] {
         cgal->side.reset();
         cgal->mesh = read_by_cgal(file);
         cgal->side.emplace(cgal->mesh);
         (*cgal->side)(Epick::Point_3(0, 0, 0));
       },
       [cgal, &points](std::vector<long>& answers) {
         for (std::size_t k = 0; k < points.size(); ++k) {
           const auto& [x, y, z] = points[k];
           const CGAL::Bounded_side at = (*cgal->side)(Epick::Point_3(x, y, z));
           answers[k] = at == CGAL::ON_BOUNDED_SIDE ? 1 : at == CGAL::ON_BOUNDARY ? 0 : -1;
         }
       },
       nullptr}};
  return contestants;
}

std::vector<Contestant> for_rays(const std::string& file, const std::vector<Ray>& rays)
{
  struct Cgal {
    Cgal_mesh mesh;
    Cgal_tree tree;
  };
  const auto body = std::make_shared<std::optional<Body>>();
  const auto cgal = std::make_shared<Cgal>();
  return {{"boxes",
           [body, file] {
             body->emplace(read_body(file));
             (*body)->make_all();
           },
           [body, &rays](std::vector<long>& faces) {
             std::ranges::transform((*body)->first_hits(rays), faces.begin(),
                                    [](const auto& hit) { return hit ? long(hit->face) : no_face; });
           },
           [body] { return double(Query(**body, **body, Question::surface).bytes()) / 2; }},
          {"CGAL",
           [cgal, file] {
             cgal->tree.clear();
             cgal->mesh = read_by_cgal(file);
             cgal->tree.rebuild(faces(cgal->mesh).first, faces(cgal->mesh).second, cgal->mesh);
             cgal->tree.build();
           },
           [cgal, &rays](std::vector<long>& faces) {
             for (std::size_t k = 0; k < rays.size(); ++k) {
               const auto& [o, d] = rays[k];
               const auto hit = cgal->tree.first_intersection(
                   Epick::Ray_3(Epick::Point_3(o[0], o[1], o[2]), Epick::Vector_3(d[0], d[1], d[2])));
               faces[k] = hit ? long(std::size_t(hit->second)) : no_face;
             }
           },
           nullptr}};
}

/// Returns the first face of each ray: the first of those that CGAL's tree finds by exact predicates.
std::vector<long> first_faces(const covering::Polyhedron& mesh, const std::string& file, const std::vector<Ray>& rays)
{
  const Cgal_mesh read = read_by_cgal(file);
  const Cgal_tree tree(faces(read).first, faces(read).second, read);
  std::vector<long> first;
  for (const Ray& ray : rays) {
    const auto& [o, d] = ray;
    std::vector<Cgal_mesh::Face_index> met;
    tree.all_intersected_primitives(Epick::Ray_3(Epick::Point_3(o[0], o[1], o[2]), Epick::Vector_3(d[0], d[1], d[2])),
                                    std::back_inserter(met));
    first.push_back(first_of(mesh, ray, met));
  }
  return first;
}

}  // namespace

void run_points(const Experiment_options& options)
{
  const int count = options.full ? 20 * options.points : options.points;
  const std::uint64_t seed = options.seed;
  std::vector<std::pair<std::string, covering::Polyhedron>> bodies;
  Race_objects objects("");
  for (const std::size_t triangles : {std::size_t(7000), std::size_t(70000)})
    for (const std::string name : {"blob", "knot"}) bodies.emplace_back(name, objects(name, triangles));
  for (const auto& model : options.meshes) {
    covering::Polyhedron mesh = load_model(model.native(), {}, true).polyhedron();
    for (covering::Index f = 0; f < mesh.face_count(); ++f)
      if (!mesh.is_triangle(f))
        throw covering::Input_error(model.native(), 0, "has faces that are no triangles", "expected triangles");
    bodies.emplace_back(model.stem().native(), std::move(mesh));
  }
  Csv_table table;
  for (const auto& [name, mesh] : bodies) {
    const std::string file = options.out / "points_body.off";
    write_whole(file, covering::write_off(mesh));
    verify::Random random(seed);
    const Column_truth truth(mesh);
    std::vector<Point> points;
    const auto contestants = for_points(mesh, file, points);
    std::vector<Clocked> clocked;
    for (const bool near : {false, true}) {
      points = points_of(mesh, near, count, random);
      Task task{name, near ? "near" : "random", mesh.face_count(), {}, seed};
      for (const Point& p : points) task.truth.push_back(truth(p));
      race(task, contestants, clocked, table);
    }
    const auto rays = rays_of(mesh, count, random);
    std::vector<Clocked> of_rays;
    race({name, "rays", mesh.face_count(), first_faces(mesh, file, rays), seed}, for_rays(file, rays), of_rays, table);
    std::filesystem::remove(file);
  }
  write_whole(options.out / "points.csv", table.text());
}

}  // namespace tetracone::experiments
