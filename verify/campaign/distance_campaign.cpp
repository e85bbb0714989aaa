#include "verify/campaign/distance_campaign.h"

#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/families/families.h"
#include "verify/truth/distance_truth.h"

#include <array>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace {

using Coordinates = std::array<Rational, 3>;

Rational square_of(const Coordinates& p, const Coordinates& q)
{
  Rational sum = 0;
  for (int k = 0; k < 3; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
  return sum;
}

/// Whether `x` is the double nearest to the root of `square`: no neighbour's middle is passed.
bool is_nearest_root(double x, const Rational& square)
{
  if (!(x >= 0)) return false;
  if (std::isinf(x)) return square >= Rational(0x1.fffffffffffffp1023) * Rational(0x1.fffffffffffffp1023);
  const Rational here(x), above(std::nextafter(x, HUGE_VAL) == HUGE_VAL ? x : std::nextafter(x, HUGE_VAL)),
      below(x > 0 ? std::nextafter(x, 0.0) : 0.0);
  const Rational high = (here + above) / 2, low = (here + below) / 2;
  return low * low <= square && square <= high * high;
}

/// The exact map of a pose after x -> N x + t with integers: a rotation by a quarter, a shift, and a reflection.
kernel::Pose moved(const kernel::Pose& pose)
{
  const auto e = [&](int k) { return pose.exact(k); };
  std::array<Rational, 12> m;
  for (int j = 0; j < 4; ++j) {
    m[j] = -e(4 + j);
    m[4 + j] = e(j);
    m[8 + j] = -e(8 + j);
  }
  m[3] += 3;
  m[7] -= 5;
  m[11] += 7;
  return kernel::Pose(m);
}

class Judge {
 public:
  Judge(Distance_tally& tally, std::string name) : tally_(tally), name_(std::move(name)) {}

  void ask(const Object_case& c)
  {
    ++tally_.cases;
    const Body a = triangulated_body(*c.a), b = triangulated_body(*c.b);
    const Brute_body brute_a(*c.a), brute_b(*c.b);
    const Placed_body placed_a(brute_a, c.pose_a), placed_b(brute_b, c.pose_b);
    const Rational of_surfaces = squared_distance(placed_a, placed_b);
    judge(c, a, b, Question::surface, of_surfaces);
    if (brute_a.is_closed() && brute_b.is_closed())
      judge(c, a, b, Question::solid, collide(placed_a, placed_b, Question::solid) ? Rational(0) : of_surfaces);
    // Faces as they are.
    Query whole(Body(*c.a), Body(*c.b), Question::surface);
    require(kernel::Rational(whole.nearest(c.pose_a, c.pose_b).squared) == of_surfaces, "whole faces");
  }

 private:
  void require(bool is_right, const std::string& what)
  {
    ++tally_.answers;
    if (!is_right) tally_.wrong.push_back(name_ + ": " + what);
  }

  void judge(const Object_case& c, const Body& a, const Body& b, Question question, const Rational& square)
  {
    const std::string of(to_string(question));
    Query query(a, b, question), swapped(b, a, question);
    const Nearest nearest = query.nearest(c.pose_a, c.pose_b);
    require(Rational(nearest.squared) == square, of + " square is " + nearest.squared + ", not " + square.get_str());
    require(is_nearest_root(nearest.distance, square), of + " root");
    require(query.distance(c.pose_a, c.pose_b) == nearest.distance, of + " distance");
    require(query.distance(c.pose_a, c.pose_b) == nearest.distance, of + " distance, remembering");
    require(swapped.distance(c.pose_b, c.pose_a) == nearest.distance, of + " swapped");
    require(Query(a, b, question).distance(moved(c.pose_a), moved(c.pose_b)) == nearest.distance, of + " moved");
    std::array<Coordinates, 2> point;
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 3; ++k) point[body][k] = Rational(nearest.point[body][k]);
    require(square_of(point[0], point[1]) == square, of + " points");
    for (int body = 0; body < 2; ++body)
      require(holds(body == 0 ? *c.a : *c.b, body == 0 ? c.pose_a : c.pose_b, nearest.holder[body], point[body]),
              of + " holder " + nearest.holder[body].text());
    const double d = nearest.distance;
    for (const double limit : {d, std::nextafter(d, 0.0), std::nextafter(d, HUGE_VAL), d / 2, 2 * d, 0.0})
      if (std::isfinite(limit))
        require(query.within(c.pose_a, c.pose_b, kernel::exact_text(Rational(limit))) ==
                    (square <= Rational(limit) * Rational(limit)),
                of + " within " + kernel::shortest(limit));
  }

  /// Whether what is named holds the point: by CGAL, of its exact image.
  static bool holds(const covering::Polyhedron& polyhedron, const kernel::Pose& pose, const Holder& holder,
                    const Coordinates& x)
  {
    if (holder.kind == Holder::Kind::interior) return true;
    const Brute_body body(polyhedron);
    const Placed_body placed(body, pose);
    const Exact::Point_3 p(x[0], x[1], x[2]);
    const auto image = [&](Index v) { return placed.image<Exact>(v); };
    switch (holder.kind) {
      case Holder::Kind::vertex: return image(holder.number[0]) == p;
      case Holder::Kind::edge:
        return CGAL::squared_distance(p, Exact::Segment_3(image(holder.number[0]), image(holder.number[1]))) == 0;
      default: break;
    }
    // The face alone, as elements of the truth.
    covering::Polyhedron face;
    face.vertices = polyhedron.vertices;
    std::vector<std::vector<Index>> loops;
    for (std::size_t k = 0; k < polyhedron.loop_count(holder.number[0]); ++k) {
      const auto loop = polyhedron.loop(holder.number[0], k);
      loops.emplace_back(loop.begin(), loop.end());
    }
    face.add_face(loops);
    const Brute_body alone(face);
    const Placed_body at(alone, pose);
    for (const Element& element : alone.elements()) {
      Simplex corners;
      for (int k = 0; k <= element.dimension; ++k) corners.push_back(at.image<Exact>(element.corners[k]));
      if (squared_distance_by_features({p}, corners) == 0) return true;
    }
    return false;
  }

  Distance_tally& tally_;
  std::string name_;
};

}  // namespace

Distance_tally judge_distances(std::uint64_t seed, std::uint64_t first, std::uint64_t cases, std::size_t most_faces,
                               const std::function<void()>& step)
{
  Distance_tally tally;
  for (const Family& family : families())
    for (std::uint64_t index = first; index < first + cases; ++index) {
      const Object_case c = family.object_case(seed, index);
      if (c.a->face_count() > most_faces || c.b->face_count() > most_faces) continue;
      const std::string name = std::string(family.name) + ", case " + std::to_string(index);
      try {
        Judge(tally, name).ask(c);
      } catch (const std::exception& error) {
        tally.wrong.push_back(name + ": " + error.what());
      }
      step();
    }
  return tally;
}

}  // namespace tetracone::verify
