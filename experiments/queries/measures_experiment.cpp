#include "experiments/queries/experiments.h"

#include "experiments/queries/points_truth.h"
#include "experiments/queries/touching.h"
#include "experiments/speed/benchmark_workload.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/lego.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/shape_generators.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace tetracone::experiments {
namespace {

using Poses = std::vector<std::pair<kernel::Pose, kernel::Pose>>;

/// A way to answer a question `count` times.
struct Way {
  std::string name;
  std::function<void(std::size_t)> ask;
};

/// Prints and keeps the rows of a question.
class Measures {
 public:
  explicit Measures(std::uint64_t seed) : seed_(seed) {}

  /// Asks all ways in turn, pass by pass. The fastest time of each question counts, and their mean is told. The last
  /// way is what the others are compared with.
  void race(const std::string& question, const std::string& object, std::size_t triangles, std::size_t count,
            const std::vector<Way>& ways, int passes)
  {
    std::vector<double> mean;
    for (const auto& times :
         fastest_times(ways.size(), count, passes, [&](std::size_t w, std::size_t k) { ways[w].ask(k); }))
      mean.push_back(mean_of(times));
    for (std::size_t w = 0; w < ways.size(); ++w) {
      table_.add(Csv_row()
                     .add("question", question)
                     .add("object", object)
                     .add("triangles", triangles)
                     .add("way", ways[w].name)
                     .add("asked", count)
                     .add_exact("ns", mean[w])
                     .add_exact("ratio", mean[w] / mean.back())
                     .add_origin(seed_));
      std::printf("%-18s %-22s %8zu  %-26s %6zu  %12.2f us  %8.3f\n", question.c_str(), object.c_str(), triangles,
                  ways[w].name.c_str(), count, mean[w] / 1000, mean[w] / mean.back());
      std::fflush(stdout);
    }
  }

  std::string text() const { return table_.text(); }

 private:
  std::uint64_t seed_;
  Csv_table table_;
};

/// Measures the relation and the overlap of two bodies in poses in which they collide.
void race_solids(Measures& measures, const std::string& name, const covering::Polyhedron& a,
                 const covering::Polyhedron& b, const Poses& poses)
{
  const Body body_a(a), body_b(b);
  Query query(body_a, body_b);
  Poses hits;
  for (const auto& [pose_a, pose_b] : poses)
    if (query.collide(pose_a, pose_b)) hits.emplace_back(pose_a, pose_b);
  if (hits.empty()) return;
  const auto way = [&](const std::string& called, const auto& ask) {
    return Way{called, [&hits, ask](std::size_t k) { ask(hits[k].first, hits[k].second); }};
  };
  using kernel::Pose;
  measures.race("relation", name, a.face_count(), hits.size(),
                {way("relation alone", [&](const Pose& p, const Pose& q) { query.solid_relation_alone(p, q); }),
                 way("collide", [&](const Pose& p, const Pose& q) { query.collide(p, q); })},
                10);
  measures.race("relation", name, a.face_count(), hits.size(),
                {way("relation and dimension", [&](const Pose& p, const Pose& q) { query.solid_relation(p, q); }),
                 way("contacts", [&](const Pose& p, const Pose& q) { query.contacts(p, q); })},
                3);
  measures.race("overlap", name, a.face_count(), hits.size(),
                {way("bounds", [&](const Pose& p, const Pose& q) { query.overlap_bounds(p, q); }),
                 way("nearest doubles", [&](const Pose& p, const Pose& q) { query.overlap(p, q); }),
                 way("volume as a fraction", [&](const Pose& p, const Pose& q) { query.overlap(p, q).exact_volume(); }),
                 way("contacts", [&](const Pose& p, const Pose& q) { query.contacts(p, q); })},
                2);
}

/// Measures plates of unit cubes, with a hole in the middle of each nine, whose planes coincide. Each square of their
/// surface is two triangles. They are equal, lie on one another, overlap, or one lies within a block.
void race_plates(Measures& measures, std::uint64_t seed)
{
  constexpr int size = 30;  // cubes along a side
  verify::Random random(seed);
  verify::lego::Cells cells = verify::lego::block({0, 0, 0}, {size, size, 1});
  std::erase_if(cells, [](const verify::lego::Cell& cell) { return cell[0] % 3 == 1 && cell[1] % 3 == 1; });
  const auto surface = [&](const verify::lego::Cells& of) {
    return verify::lego::solid({{of}}, {.halved = 1, .is_one_mesh = true}, random);
  };
  const covering::Polyhedron plate = surface(cells), block = surface(verify::lego::block({0, 0, 0}, {size, size, 1}));
  const auto at = [](double x, double y, double z) {
    return std::pair(kernel::Pose(), kernel::Pose::translation(x, y, z));
  };
  race_solids(measures, "plates, equal", plate, plate, {at(0, 0, 0)});
  race_solids(measures, "plates, stacked", plate, plate, {at(0, 0, 1), at(0.5, 0.25, 1), at(3, 0, -1)});
  race_solids(measures, "plates, side by side", plate, plate, {at(3, 3, 0), at(-9, 0.5, 0)});
  race_solids(measures, "plate in a block", plate, block, {at(0, 0, 0)});
}

Cgal_mesh cgal_mesh(const covering::Polyhedron& mesh)
{
  Cgal_mesh made;
  for (const auto& [x, y, z] : mesh.vertices) made.add_vertex({x, y, z});
  for (covering::Index f = 0; f < mesh.face_count(); ++f) {
    const auto v = mesh.loop(f, 0);
    made.add_face(Cgal_mesh::Vertex_index(v[0]), Cgal_mesh::Vertex_index(v[1]), Cgal_mesh::Vertex_index(v[2]));
  }
  return made;
}

/// Measures signed distances of points, random and near the surface, against CGAL's nearest point without a sign.
void race_points(Measures& measures, const std::string& name, const covering::Polyhedron& mesh, int count,
                 std::uint64_t seed)
{
  verify::Random random(seed);
  const Body body(mesh);
  const Cgal_mesh of_cgal = cgal_mesh(mesh);
  Cgal_tree tree(faces(of_cgal).first, faces(of_cgal).second, of_cgal);
  tree.accelerate_distance_queries();
  for (const bool is_near : {false, true}) {
    const auto points = points_of(mesh, is_near, count, random);
    body.nearest(points[0]);
    // All points are asked in one call, as Python does, so the time is the mean of a pass.
    measures.race(is_near ? "nearest, near" : "nearest, random", name, mesh.face_count(), 1,
                  {{"nearest, all points", [&](std::size_t) { body.nearest(points); }},
                   {"CGAL closest_point",
                    [&](std::size_t) {
                      for (const auto& [x, y, z] : points) tree.closest_point({x, y, z});
                    }}},
                  3);
  }
}

void race_self_intersections(Measures& measures, const std::string& name, const covering::Polyhedron& mesh)
{
  const Cgal_mesh of_cgal = cgal_mesh(mesh);
  measures.race("self-intersections", name, mesh.face_count(), 1,
                {{"tree made and asked", [&](std::size_t) { Body(mesh).self_intersections(); }},
                 {"CGAL self_intersections",
                  [&](std::size_t) {
                    std::vector<std::pair<Cgal_mesh::Face_index, Cgal_mesh::Face_index>> found;
                    CGAL::Polygon_mesh_processing::self_intersections(of_cgal, std::back_inserter(found));
                  }}},
                2);
}

}  // namespace

void run_measures(const Experiment_options& options)
{
  Race_objects objects("");
  Measures measures(options.seed);
  verify::Random random(options.seed);
  const covering::Polyhedron box = triangulated_body(verify::box({0, 0, 0}, {1, 1, 1})).polyhedron();
  Poses poses;
  for (int k = 0; k < options.race_frames; ++k) {
    const auto turned = [&random] {
      std::array<double, 12> entries = verify::object_family::double_rotation(random).entries();
      for (std::size_t i = 0; i < 3; ++i) entries[4 * i + 3] = random.symmetric() / 2;
      return kernel::Pose(entries);
    };
    poses.emplace_back(turned(), turned());
  }
  race_solids(measures, "box", box, box, poses);
  race_plates(measures, options.seed);
  for (const std::string trajectory : {"contour", "circular"}) {
    const Race_course course = on_trajectory(objects("blob", 7172), "blob", trajectory, 1, options.race_frames,
                                             options.seed, trajectory == "circular" ? 8 : 1);
    poses.clear();
    for (const kernel::Pose& pose : course.poses_b) poses.emplace_back(kernel::Pose(), pose);
    race_solids(measures, trajectory + ", blob", course.a, course.b, poses);
  }
  for (const std::string name : {"blob", "knot"})
    race_points(measures, name, objects(name, 70000), 20000, options.seed);
  race_self_intersections(measures, "blob", objects("blob", options.full ? 1'000'000 : 70'000));
  write_whole(options.out / "measures.csv", measures.text());
  write_whole(options.out / "touching.csv", touching_csv(options.full ? 1000 : 100, options.seed));
}

}  // namespace tetracone::experiments
