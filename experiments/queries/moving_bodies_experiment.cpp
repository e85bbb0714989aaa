#include "experiments/queries/experiments.h"

#include "experiments/peers/fcl.h"
#include "experiments/speed/benchmark_workload.h"
#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

namespace tetracone::experiments {
namespace {

/// Motions of B, linear between two poses, A at rest.
struct Motion_course {
  std::string name;
  covering::Polyhedron a, b;
  std::vector<std::array<kernel::Pose, 2>> ends;
};

/// The time that a subject tells of a motion; nothing: no contact.
using Told = std::optional<double>;

struct Timed_motions {
  std::vector<Told> told;
  std::array<double, 2> ns = {0, 0};  ///< of all motions without contact, and of all with one, in truth
};

Timed_motions time_motions(const Motion_course& course, const std::vector<Told>* truth,
                           const std::function<Told(std::size_t)>& first_contact)
{
  Timed_motions asked;
  for (std::size_t k = 0; k < course.ends.size(); ++k) {
    const Stopwatch watch;
    asked.told.push_back(first_contact(k));
    const double ns = watch.nanoseconds();
    asked.ns[truth ? (*truth)[k].has_value() : asked.told[k].has_value()] += ns;
  }
  return asked;
}

void add_motions(Csv_table& table, const Motion_course& course, const std::string& subject, const Timed_motions& asked,
                 const std::vector<Told>& truth, double static_ns, std::uint64_t seed)
{
  std::size_t contacts = 0, missed = 0, invented = 0;
  double latest = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    contacts += truth[k].has_value();
    missed += truth[k] && !asked.told[k];
    invented += !truth[k] && asked.told[k];
    if (truth[k] && asked.told[k]) latest = std::max(latest, *asked.told[k] - *truth[k]);
  }
  const std::size_t apart = truth.size() - contacts;
  const auto in_statics = [&](double ns, std::size_t count) { return count == 0 ? 0 : ns / double(count) / static_ns; };
  const double of_apart = in_statics(asked.ns[0], apart), of_contacts = in_statics(asked.ns[1], contacts);
  table.add(Csv_row()
                .add("course", course.name)
                .add("triangles", course.a.face_count() + course.b.face_count())
                .add("subject", subject)
                .add("motions", truth.size())
                .add("contacts", contacts)
                .add("missed", missed)
                .add("invented", invented)
                .add("latest", latest)
                .add("static_ns", static_ns)
                .add("apart_in_statics", of_apart)
                .add("contact_in_statics", of_contacts)
                .add_origin(seed));
  std::printf(
      "%-8s %-16s missed %3zu of %3zu, invented %zu, latest by %8.2g; in static questions: apart %8.1f, contact "
      "%8.1f\n",
      course.name.c_str(), subject.c_str(), missed, contacts, invented, latest, of_apart, of_contacts);
}

void run_course(Csv_table& table, const Motion_course& course, std::uint64_t seed)
{
  const Body a(course.a), b(course.b);
  a.make_all();
  b.make_all();
  Query query(a, b, Question::surface);
  const kernel::Pose still;
  const kernel::Body_motion rests = kernel::Body_motion::linear(still, still);

  const auto exactly = [&](std::size_t k) -> Told {
    const auto first =
        query.first_contact(Motion(rests), Motion(kernel::Body_motion::linear(course.ends[k][0], course.ends[k][1])));
    return first ? Told(first->lo) : std::nullopt;
  };
  // The query's tables of the bodies are built before it is timed.
  for (std::size_t k = 0; k < course.ends.size(); ++k) {
    exactly(k);
    query.collide(still, course.ends[k][0]);
  }
  const Timed_motions ours = time_motions(course, nullptr, exactly);
  double static_ns = 0;
  for (const auto& [from, to] : course.ends) {
    const Stopwatch watch;
    query.collide(still, from);
    static_ns += watch.nanoseconds() / double(course.ends.size());
  }
  add_motions(table, course, "tetracone", ours, ours.told, static_ns, seed);
  for (const int steps : {10, 100, 1000})
    add_motions(table, course, "static " + std::to_string(steps),
                time_motions(course, &ours.told,
                             [&](std::size_t k) -> Told {
                               std::array<double, 12> between;
                               for (int step = 0; step < steps; ++step) {
                                 const double t = step / (steps - 1.0);
                                 const auto &from = course.ends[k][0], &to = course.ends[k][1];
                                 for (int i = 0; i < 12; ++i) between[i] = (1 - t) * from[i] + t * to[i];
                                 if (query.collide(still, kernel::Pose(between))) return t;
                               }
                               return std::nullopt;
                             }),
                ours.told, static_ns, seed);

  const auto mesh_a = peer_mesh(course.a), mesh_b = peer_mesh(course.b);
  for (const Named_motion_peer& named : motion_peers()) {
    const auto peer = named.make(*mesh_a, *mesh_b);
    const std::string name = "fcl" + std::string(named.name).substr(3);  // the table's names are in small letters
    add_motions(
        table, course, name,
        time_motions(course, &ours.told, [&](std::size_t k) { return peer(course.ends[k][0], course.ends[k][1]); }),
        ours.told, static_ns, seed);
  }
}

/// Returns the motions from each frame to the next.
Motion_course steps(const std::string& name, const covering::Polyhedron& body, const std::vector<kernel::Pose>& poses)
{
  Motion_course course{name, body, body, {}};
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) course.ends.push_back({poses[k], poses[k + 1]});
  return course;
}

/// Returns motions down through A or past it, from z = 4 to z = -4.
Motion_course throws(const std::string& name, const covering::Polyhedron& a, const covering::Polyhedron& b, int motions,
                     std::uint64_t seed)
{
  Motion_course course{name, a, b, {}};
  verify::Random random(seed);
  for (int k = 0; k < motions; ++k) {
    const double x = 3 * random.symmetric(), y = 3 * random.symmetric();
    course.ends.push_back(
        {kernel::Pose::translation(x, y, 4), kernel::Pose::translation(0.5 * x, y + 0.25 * random.symmetric(), -4)});
  }
  return course;
}

/// Seven numbers of a rigid pose.
using Rigid = std::array<double, 7>;

/// A body that rests, and two motions of the other: flat, and slightly tilted.
struct Landing {
  const char* name;
  Motion still;
  std::array<Motion, 2> moves;
};

std::vector<Landing> ways_to_land()
{
  // Tilted by a thousandth about an axis that is aslant to all edges: one corner lands first.
  const Rigid still = {1, 0, 0, 0, 0, 0, 0}, flat = {1, 0, 0, 0, 0.25, 0.125, 1},
              tilted = {1, 0.0004, 0.0003, 0.0001, 0.25, 0.125, 1};
  const auto falls = [](const Rigid& from) {
    const kernel::Rigid_pose turned = {{from[0], from[1], from[2], from[3]}, {}};
    std::array<double, 12> top = kernel::Body_motion::rigid(turned, turned)->at(0).entries();
    for (std::size_t i = 0; i < 3; ++i) top[4 * i + 3] = from[4 + i];
    std::array<double, 12> bottom = top;
    bottom[11] = -2;
    return Motion(kernel::Body_motion::linear(kernel::Pose(top), kernel::Pose(bottom)));
  };
  const auto sinks = [](Rigid from, double turn) {
    Rigid to = from;
    to[3] += turn;
    to[6] = -2;
    return Motion::rigid(from, to);
  };
  const Motion stays = Motion(kernel::Body_motion::linear(kernel::Pose(), kernel::Pose())),
               stays_rigid = Motion::rigid(still, still);
  return {{"linear", stays, {falls(flat), falls(tilted)}},
          {"rigid", stays_rigid, {sinks(flat, 0), sinks(tilted, 0)}},
          {"turning", stays_rigid, {sinks(flat, 1), sinks(tilted, 1)}}};
}

/// Plates of some 800, 3,200 and 20,000 triangles that land on a table and on their like, flat and tilted. Writes
/// OUT/landings.csv, a row a pair of bodies and a way to move, with the least time of each motion.
void run_landings(const std::filesystem::path& out, std::uint64_t seed)
{
  constexpr int repeats = 9;
  Csv_table table;
  for (const int n : {13, 27, 70}) {
    const Body falling(verify::plate(n, 0, 0.0625));
    for (const bool on_like : {false, true}) {
      const Body below(on_like ? verify::plate(n, -0.0625, 0) : triangulated(verify::box({-2, -2, -1}, {2, 2, 0})));
      falling.make_all();
      below.make_all();
      Query query(below, falling, Question::surface);
      for (const Landing& landing : ways_to_land()) {
        std::array<std::optional<First_contact>, 2> first;
        const auto least = fastest_times(2, 1, repeats, [&](std::size_t k, std::size_t) {
          first[k] = query.first_contact(landing.still, landing.moves[k]);
        });
        const double flat = 1e-3 * least[0][0], tilted = 1e-3 * least[1][0];
        table.add(Csv_row()
                      .add("triangles", falling.polyhedron().face_count())
                      .add("on", std::string(on_like ? "its like" : "a table"))
                      .add("motion", std::string(landing.name))
                      .add("flat_lo", first[0] ? first[0]->lo : -1)
                      .add("tilted_lo", first[1] ? first[1]->lo : -1)
                      .add("flat_us", flat)
                      .add("tilted_us", tilted)
                      .add("flat_in_tilted", flat / tilted)
                      .add_origin(seed));
        std::printf("%6zu triangles on %-8s %-8s flat %9.1f us, tilted %9.1f us\n",
                    std::size_t(falling.polyhedron().face_count()), on_like ? "its like" : "a table", landing.name,
                    flat, tilted);
      }
    }
  }
  write_whole(out / "landings.csv", table.text());
}

}  // namespace

void run_moving_bodies(const Experiment_options& options)
{
  const int motions = options.race_frames;
  const std::uint64_t seed = options.seed;
  Csv_table table;
  const covering::Polyhedron object = verify::blob(7172, seed);
  const Body body(object);
  Query query(body, body, Question::surface);
  const Collides collides = [&](const kernel::Pose& pose) { return bool(query.collide(kernel::Pose(), pose)); };
  run_course(table, steps("contour", object, contour_trajectory(object, object, 1, motions + 1, seed, collides)), seed);
  run_course(table, steps("circular", object, circular_trajectory(object, object, 1, motions + 1, seed, collides)),
             seed);
  run_course(table, throws("throws", object, object, motions, seed), seed);
  covering::Polyhedron small = verify::blob(512, seed);
  for (auto& v : small.vertices)
    for (double& x : v) x *= 0.125;
  run_course(table, throws("plate", triangulated(verify::box({-2, -2, 0}, {2, 2, 0.001})), small, motions, seed), seed);
  write_whole(options.out / "moving_bodies.csv", table.text());
  run_landings(options.out, seed);
}

}  // namespace tetracone::experiments
