#include "experiments/accuracy/experiments.h"

#include "experiments/accuracy/contracted.h"
#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/tetratree/paper/classification.h"
#include "tetracone/tetratree/paper/collision.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/tetrahedron.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/subjects/predicate_subject.h"
#include "verify/subjects/subject.h"

#include <tbb/parallel_for.h>

#include <mutex>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

using kernel::Pose;
using kernel::Question;
using kernel::Vertex;
using verify::Predicate;
using verify::Predicate_case;

// All of these are on the plane x + y = 2 z, or at a place of few bits: the truth is known and simple.
constexpr Vertex low{-12, -12, -12}, high{24, 24, 24}, side{18, 6, 12}, below{0, 0, 10};
constexpr Vertex up{1.5, 1.5, 0.5}, right{3, 2, 0}, left{2, 3, 0};

/// The rotation under which everything is.
Pose turn() { return Pose::from_quaternion(3, 1, -1, 2); }

/// The moving point: a column is the next double in x, a row the next in y.
Vertex moving(int row, int column, int size)
{
  const double next = 0x1p-53;
  return {0.5 + column * next, 0.5 + row * next, 0.5 + (size / 2) * next};
}

/// One answer: -1, 0 or 1; a predicate that has no answer gives -2.
using Ask = std::function<int(int row, int column)>;

struct Map_subject {
  std::string name;
  std::function<Ask(int row)> at;  ///< prepares one row, so that each thread has its own
};

struct Map {
  std::string name;
  std::vector<Map_subject> subjects;  ///< the last is exact
  std::function<int(int row, int column)> truth;
};

/// The subjects of a map, from those of our kernels by the shown name and the kernel's, and contracted arithmetic.
template <class Ours>
std::vector<Map_subject> subjects(const Ours& ours, const Map_subject& fused)
{
  return {ours("float", "float"),       ours("double", "double"), fused, ours("double ε = 1e-12", "double-eps=1e-12"),
          ours("EPICK moved", "epick"), ours("exact", "adaptive")};
}

Predicate_case case_at(const std::array<Vertex, 4>& v, const Vertex& p, const Vertex& q, const Vertex& r)
{
  Predicate_case c;
  c.v = v;
  c.p = p;
  c.q = q;
  c.r = r;
  c.pose_a = c.pose_b = turn();
  return c;
}

/// A predicate in contracted arithmetic, as `verify::Predicate` defines it.
int contracted(Predicate predicate, const Predicate_case& c)
{
  using K = Contracted;
  const kernel::Frame<K> frame(c.pose_a);
  std::array<kernel::Point<K>, 4> v;
  for (int k = 0; k < 4; ++k) v[k] = frame(kernel::point<K>(c.v[k]));
  const auto p = frame(kernel::point<K>(c.p)), q = frame(kernel::point<K>(c.q)), r = frame(kernel::point<K>(c.r));
  if (predicate == Predicate::orientation) return -kernel::volume_sign<K>(v[1], v[2], v[3], p);
  if (predicate == Predicate::segment_triangle)
    return kernel::segment_triangle<K>(p, q, v[1], v[2], v[3]) != kernel::Contact::none;
  tetratree::Cone_points<K> cone(kernel::Cone_lattice{}, tetratree::Tetra_cone::octant(0));
  cone.v0 = v[0];
  cone.v1 = v[1];
  cone.v2 = v[2];
  cone.v3 = v[3];
  if (kernel::volume_sign<K>(v[0], v[1], v[2], v[3]) == kernel::NEGATIVE) std::swap(cone.v1, cone.v2);
  return tetratree::classify<K>(cone, p, q, r) != tetratree::Classified::no;
}

Map predicate_map(const std::string& name, Predicate predicate,
                  const std::function<Predicate_case(int row, int column)>& at)
{
  // A yes-or-no answer is drawn as plus or minus.
  const auto drawn = [predicate](int answer) {
    return predicate == Predicate::orientation || answer == verify::no_answer ? answer : answer ? 1 : -1;
  };
  const auto ours = [=](const std::string& shown, const std::string& kernel) {
    const auto& all = verify::predicate_subjects();
    const auto& subject = *std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == kernel; });
    return Map_subject{shown, [=](int) {
                         return [=](int row, int column) {
                           return drawn(subject.answer(predicate, at(row, column)).value_or(verify::no_answer));
                         };
                       }};
  };
  const Map_subject fused{"FMA double", [=](int) {
                            return [=](int row, int column) { return drawn(contracted(predicate, at(row, column))); };
                          }};
  return {name, subjects(ours, fused),
          [=](int row, int column) { return drawn(*verify::integer_truth::answer(predicate, at(row, column))); }};
}

/// Two tetrahedra; a vertex of the second touches an edge of the first.
Map collision_map(int size)
{
  const auto tetrahedron = [](const std::array<Vertex, 4>& v) {
    covering::Polyhedron p;
    verify::add_tetrahedron(p, v);
    return std::make_shared<const covering::Polyhedron>(p);
  };
  const auto a = tetrahedron({low, high, side, below});
  const auto b = tetrahedron({Vertex{0, 0, 0}, right, left, up});
  const auto pose = [size](int row, int column) {
    const Vertex t = moving(row, column, size);
    return verify::object_family::composed(turn(), Pose::translation(t[0], t[1], t[2]));
  };
  const auto ours = [=](const std::string& shown, const std::string& kernel) {
    const auto subject = *verify::Subject::parse(kernel, verify::Method::brute);
    return Map_subject{shown, [=](int) {
                         const std::shared_ptr<verify::Prepared_pair> pair = verify::prepare(subject, *a, *b);
                         return [=](int row, int column) {
                           return pair->collide(turn(), pose(row, column), Question::solid) ? 1 : -1;
                         };
                       }};
  };
  using Tree = tetratree::Tetra_tree<Contracted>;
  struct Trees {
    Trees(const covering::Polyhedron& a, const covering::Polyhedron& b)
        : a(a, tetratree::Config::brute()), b(b, tetratree::Config::brute()), collision(this->a, this->b)
    {}
    Tree a, b;
    tetratree::Collision<Contracted> collision;
  };
  const Map_subject fused{"FMA double", [=](int) {
                            const auto trees = std::make_shared<Trees>(*a, *b);
                            return [=](int row, int column) {
                              return trees->collision(turn(), pose(row, column), Question::solid) ? 1 : -1;
                            };
                          }};
  const auto truth = [=](int row, int column) {
    verify::Object_case c;
    c.a = a;
    c.b = b;
    c.pose_a = turn();
    c.pose_b = pose(row, column);
    return verify::integer_truth::collide(c, Question::solid) ? 1 : -1;
  };
  return {"collision of two bodies", subjects(ours, fused), truth};
}

std::vector<Map> maps(int size)
{
  const auto p = [size](int row, int column) { return moving(row, column, size); };
  return {predicate_map("barycentric coordinate", Predicate::orientation,
                        [=](int i, int j) {
                          return case_at({below, low, high, side}, p(i, j), up, right);
                        }),
          predicate_map("segment and triangle", Predicate::segment_triangle,
                        [=](int i, int j) {
                          return case_at({below, low, high, side}, p(i, j), up, right);
                        }),
          predicate_map("classification in a cone", Predicate::classification,
                        [=](int i, int j) {
                          return case_at({Vertex{0, 0, 0}, high, side, below}, p(i, j), right, left);
                        }),
          collision_map(size)};
}

char letter(int answer) { return answer == verify::no_answer ? '?' : answer < 0 ? '-' : answer > 0 ? '+' : '0'; }

/// One row of the grid, by every subject: a line of letters each.
std::vector<std::string> answers(const Map& map, int row, int size)
{
  std::vector<std::string> lines;
  for (const Map_subject& subject : map.subjects) {
    const Ask ask = subject.at(row);
    std::string line;
    for (int column = 0; column < size; ++column) line += letter(ask(row, column));
    lines.push_back(line);
  }
  for (int column = 0; row % 16 == 0 && column < size; column += 16)
    if (lines.back()[column] != letter(map.truth(row, column)))
      throw std::logic_error("sign map '" + map.name + "': the exact answer is not the truth in row " +
                             std::to_string(row) + ", column " + std::to_string(column));
  return lines;
}

}  // namespace

void run_sign_maps(const Experiment_options& options)
{
  const int size = options.size;
  const auto all = maps(size);
  Csv_table table;
  Progress progress("rows of sign maps", all.size() * std::size_t(size));
  for (const Map& map : all) {
    std::vector<std::vector<std::string>> rows(size);
    std::mutex one_at_a_time;
    tbb::parallel_for(0, size, [&](int row) {
      rows[row] = answers(map, row, size);
      const std::lock_guard lock(one_at_a_time);
      progress.step();
    });
    for (std::size_t s = 0; s < map.subjects.size(); ++s)
      for (int row = 0; row < size; ++row)
        table.add(Csv_row()
                      .add("map", map.name)
                      .add("subject", map.subjects[s].name)
                      .add("row", row)
                      .add("answers", rows[row][s])
                      .add_build());
  }
  write_whole(options.out / "sign_maps.csv", table.text());
}

}  // namespace tetracone::experiments
