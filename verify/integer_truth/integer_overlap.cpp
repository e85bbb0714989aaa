#include "verify/integer_truth/integer_overlap.h"

#include "verify/integer_truth/integer_boxes.h"
#include "verify/integer_truth/integer_contact.h"
#include "verify/integer_truth/integer_pair.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify::integer_truth {
namespace {

using kernel::Solid_relation;
using Fraction_point = std::array<mpq_class, 3>;

/// A face of either body.
struct Swept_face {
  const Integer_body* body;
  Index number;
  Integer_vector normal;
  Rank_box box;
  bool is_of_b;
};

/// An edge of either body.
struct Swept_edge {
  Integer_vector from, to;
  Rank_box box;
};

void sort_once(std::vector<mpq_class>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

mpq_class determinant_of(const std::array<Fraction_point, 3>& m)
{
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Returns the point x with rows x = right; nothing where the rows depend on one another.
std::optional<Fraction_point> common_point(const std::array<Fraction_point, 3>& rows, const Fraction_point& right)
{
  const mpq_class whole = determinant_of(rows);
  if (sgn(whole) == 0) return std::nullopt;
  Fraction_point x;
  for (int column = 0; column < 3; ++column) {
    auto replaced = rows;
    for (int row = 0; row < 3; ++row) replaced[row][column] = right[row];
    x[column] = determinant_of(replaced) / whole;
  }
  return x;
}

class Sweep {
 public:
  Sweep(const Integer_body& a, const Integer_body& b)
  {
    const std::array bodies = {&a, &b};
    const std::array<Element_boxes, 2> boxes = element_boxes(a, b);
    for (const int k : {0, 1}) {
      const Integer_body& body = *bodies[k];
      for (Index f = 0; f < body.face_count(); ++f)
        if (const auto normal = body.normal(f)) faces_.push_back({&body, f, *normal, boxes[k].faces[f], k == 1});
      for (std::size_t e = 0; e < body.edges().size(); ++e)
        edges_.push_back({body.point(body.edges()[e].first), body.point(body.edges()[e].second), boxes[k].edges[e]});
    }
  }

  Volumes volumes() const
  {
    Volumes sum;
    const std::vector<mpq_class> critical = critical_x();
    for (std::size_t k = 0; k + 1 < critical.size(); ++k) {
      const mpq_class step = (critical[k + 1] - critical[k]) / 4;
      // Milne's rule of three inner points, exact for cubics.
      for (const auto& [point, weight] : {std::pair{1, 2}, {2, -1}, {3, 2}})
        add_section(critical[k] + point * step, weight * step * mpq_class(4, 3), sum);
    }
    return sum;
  }

 private:
  static bool holds(const Swept_face& face, const Fraction_point& x)
  {
    const Integer common = lcm(lcm(x[0].get_den(), x[1].get_den()), x[2].get_den());
    Integer_vector whole;
    for (int i = 0; i < 3; ++i) whole[i] = x[i].get_num() * (common / x[i].get_den());
    return is_on_face(*face.body, face.number, face.normal, whole, common);
  }

  static mpq_class height(const Swept_face& face, const Integer_vector& x)
  {
    return dot(face.normal, difference(x, face.body->corner(face.number)));
  }

  static Fraction_point row(const Swept_face& face) { return {face.normal[0], face.normal[1], face.normal[2]}; }
  static mpq_class right(const Swept_face& face) { return dot(face.normal, face.body->corner(face.number)); }

  /// Returns the x of all vertices of the surfaces' arrangement. They are edges' ends, points where edges meet each
  /// other or faces, and points of three faces.
  std::vector<mpq_class> critical_x() const
  {
    std::vector<mpq_class> critical;
    for (const Swept_edge& edge : edges_) {
      const Integer_vector &from = edge.from, &to = edge.to;
      const auto add = [&](const mpq_class& t) { critical.push_back(from[0] + t * (to[0] - from[0])); };
      add(0);
      add(1);
      for (const Swept_edge& other : edges_) {
        if (!edge.box.meets(other.box)) continue;
        if (const auto both = shared(from, to, other.from, other.to)) {
          add(both->first);
          add(both->last);
        }
      }
      for (const Swept_face& face : faces_) {
        if (!edge.box.meets(face.box)) continue;
        const mpq_class h = height(face, from), k = height(face, to);
        if (sgn(h) * sgn(k) >= 0) continue;
        const mpq_class t = h / (h - k);
        Fraction_point x;
        for (int i = 0; i < 3; ++i) x[i] = from[i] + t * (to[i] - from[i]);
        if (holds(face, x)) add(t);
      }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t g = 0; g < f; ++g) {
        if (!faces_[f].box.meets(faces_[g].box)) continue;
        for (std::size_t h = 0; h < g; ++h) {
          const Swept_face &one = faces_[f], &two = faces_[g], &three = faces_[h];
          if (!one.box.meets(three.box) || !two.box.meets(three.box)) continue;
          const auto x = common_point({row(one), row(two), row(three)}, {right(one), right(two), right(three)});
          if (x && holds(one, *x) && holds(two, *x) && holds(three, *x)) critical.push_back((*x)[0]);
        }
      }
    sort_once(critical);
    return critical;
  }

  /// Adds weight times the areas of a section.
  void add_section(const mpq_class& x, const mpq_class& weight, Volumes& sum) const
  {
    std::vector<mpq_class> critical;
    for (const Swept_edge& edge : edges_) {
      const Integer_vector &p = edge.from, &q = edge.to;
      if (x < std::min(p[0], q[0]) || x > std::max(p[0], q[0]) || p[0] == q[0]) continue;
      critical.push_back(p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]));
    }
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t g = 0; g < f; ++g) {
        const Swept_face &one = faces_[f], &two = faces_[g];
        if (!one.box.meets(two.box)) continue;
        const auto at = common_point({row(one), row(two), Fraction_point{1, 0, 0}}, {right(one), right(two), x});
        if (at && holds(one, *at) && holds(two, *at)) critical.push_back((*at)[1]);
      }
    sort_once(critical);
    for (std::size_t k = 0; k + 1 < critical.size(); ++k) {
      const mpq_class middle = (critical[k] + critical[k + 1]) / 2;
      add_lengths(x, middle, weight * (critical[k + 1] - critical[k]), sum);
    }
  }

  /// Adds weight times the lengths on a line along z.
  void add_lengths(const mpq_class& x, const mpq_class& y, const mpq_class& weight, Volumes& sum) const
  {
    const Integer common = lcm(x.get_den(), y.get_den());
    const Integer_vector whole = {Integer(x.get_num() * (common / x.get_den())),
                                  Integer(y.get_num() * (common / y.get_den())), 0};
    struct Crossing {
      mpq_class z;
      bool is_of_b;
      int turns;
    };
    std::vector<Crossing> crossings;
    for (const Swept_face& face : faces_) {
      const int turns = face.body->turns(face.number, 2, whole, common).winding;
      if (turns == 0) continue;
      const Integer_vector& n = face.normal;
      crossings.push_back({(right(face) - n[0] * x - n[1] * y) / n[2], face.is_of_b, turns});
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& c, const Crossing& d) { return c.z > d.z; });
    std::array<int, 2> winding = {0, 0};
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
      winding[crossings[k].is_of_b] += crossings[k].turns;
      const mpq_class length = weight * (crossings[k].z - crossings[k + 1].z);
      if (winding[0] != 0) (winding[1] != 0 ? sum.both : sum.only_a) += length;
      if (winding[0] == 0 && winding[1] != 0) sum.only_b += length;
    }
  }

  std::vector<Swept_face> faces_;
  std::vector<Swept_edge> edges_;
};

}  // namespace

Volumes volumes(const Object_case& c)
{
  const auto [common, a, b] = integer_pair(c);
  const mpq_class denominator = common;
  Volumes volumes = Sweep(a, b).volumes();
  for (mpq_class* volume : {&volumes.both, &volumes.only_a, &volumes.only_b})
    *volume /= denominator * denominator * denominator;
  return volumes;
}

bool agrees(const Volumes& volumes, const Solid_overlap& overlap)
{
  if (volumes.both != overlap.volume) return false;
  const bool both = sgn(volumes.both) != 0, only_a = sgn(volumes.only_a) != 0, only_b = sgn(volumes.only_b) != 0;
  switch (overlap.contact.relation) {
    case Solid_relation::disjoint:
    case Solid_relation::meet: return !both;
    case Solid_relation::overlap: return both;
    case Solid_relation::equal: return !only_a && !only_b;
    case Solid_relation::inside:
    case Solid_relation::covered_by: return !only_a;
    case Solid_relation::contains:
    case Solid_relation::covers: return !only_b;
  }
  return false;
}

}  // namespace tetracone::verify::integer_truth
