#include "verify/subjects/probe_subject.h"

#include "tetracone/covering/inclusion.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace tetracone::verify {
namespace {

/// Answers by `Ready`, which is made from the body of a case and kept until the next body.
template <class Ready, class Answer>
class By_body : public Running<Probe_case, Answer> {
 public:
  using Ask = Answer (*)(Ready&, const Probe_case&);
  explicit By_body(Ask ask) : ask_(ask) {}

  Told<Answer> operator()(const Probe_case& c) override
  {
    return told_by([&] {
      // After an exception no body is known.
      if (std::exchange(body_, nullptr) != c.body) ready_ = std::make_unique<Ready>(*c.body);
      Answer answer = ask_(*ready_, c);
      body_ = c.body;
      return answer;
    });
  }

 private:
  Ask ask_;
  std::shared_ptr<const covering::Polyhedron> body_;
  std::unique_ptr<Ready> ready_;
};

struct Triangulated {
  explicit Triangulated(const covering::Polyhedron& polyhedron) : body(triangulated_body(polyhedron)) {}
  Body body;
};
struct Whole {
  explicit Whole(const covering::Polyhedron& polyhedron) : body(polyhedron) {}
  Body body;
};

template <class Ready>
int in_body(Ready& ready, const Probe_case& c)
{
  return int(ready.body.inside(c.from));
}

int by_fractions(Triangulated& ready, const Probe_case& c)
{
  const auto fraction = [&](std::size_t k) {
    const std::string number = kernel::to_string(kernel::Rational(c.from[k]));
    return number.find('/') == std::string::npos ? number + "/1" : number;
  };
  return int(ready.body.inside_text({fraction(0), fraction(1), fraction(2)}));
}

template <class K>
struct Covered {
  explicit Covered(const covering::Polyhedron& polyhedron) : model(polyhedron), placed(model)
  {
    placed.place(identity);
  }
  kernel::Pose identity;
  covering::Model<K> model;
  covering::Placed_model<K> placed;
};

/// The signed sum over the whole covering, in kernel K.
template <class K>
int in_covering(Covered<K>& ready, const Probe_case& c)
{
  return int(covering::locate<K>(ready.placed.frame()(kernel::point<K>(c.from)), ready.placed));
}

template <class Ready>
Ray_answer hits_of(Ready& ready, const Probe_case& c)
{
  const Ray ray{c.from, c.direction};
  return {ready.body.first_hit(ray), ready.body.hits(ray)};
}

namespace rays_in_doubles {

using Triple = kernel::Vertex;
using kernel::cross;
using kernel::difference;
using kernel::dot;

/// All triangles of the body: the library's list leaves out faces that already are triangles.
struct Triangles {
  explicit Triangles(const covering::Polyhedron& polyhedron) : triangles(covering::triangulate_faces(polyhedron))
  {
    std::vector<bool> has(polyhedron.face_count(), false);
    for (const auto& t : triangles) has[t.face] = true;
    for (covering::Index f = 0; f < polyhedron.face_count(); ++f)
      if (!has[f] && polyhedron.is_triangle(f)) {
        const covering::Loop loop = polyhedron.loop(f, 0);
        triangles.push_back({f, {loop[0], loop[1], loop[2]}});
      }
  }
  std::vector<covering::Face_triangle> triangles;
};

/// Returns t of the crossing; negative or NaN if there is none.
double crossing(const Triple& o, const Triple& d, const Triple& a, const Triple& b, const Triple& c)
{
  const Triple e = difference(b, a), f = difference(c, a), p = cross(d, f), s = difference(o, a), q = cross(s, e);
  const double determinant = dot(e, p), u = dot(s, p) / determinant, v = dot(d, q) / determinant;
  return determinant != 0 && u >= 0 && v >= 0 && u + v <= 1 ? dot(f, q) / determinant : -1;
}

/// Moeller and Trumbore, Fast, minimum storage ray-triangle intersection (1997), in double without a tolerance. A ray
/// in a triangle's plane does not meet it.
Ray_answer hits(Triangles& ready, const Probe_case& c)
{
  std::vector<Ray_hit> all;
  for (const covering::Face_triangle& t : ready.triangles) {
    const auto corner = [&](std::size_t k) -> const Triple& { return c.body->vertices[t.corner[k]]; };
    const double at = crossing(c.from, c.direction, corner(0), corner(1), corner(2));
    if (!(at >= 0)) continue;
    const auto known = std::ranges::find(all, t.face, &Ray_hit::face);
    if (known == all.end())
      all.push_back({t.face, at});
    else
      known->t = std::min(known->t, at);
  }
  std::ranges::sort(all, [](const Ray_hit& x, const Ray_hit& y) { return x.t != y.t ? x.t < y.t : x.face < y.face; });
  return {all.empty() ? std::nullopt : std::optional(all.front()), all};
}

}  // namespace rays_in_doubles

template <class Ready, class Answer>
Subject_of<Running<Probe_case, Answer>> subject(const char* name, bool is_exact,
                                                Answer (*ask)(Ready&, const Probe_case&))
{
  return {name, is_exact, "", [ask] { return std::make_unique<By_body<Ready, Answer>>(ask); }};
}

}  // namespace

std::vector<Point_subject> point_subjects()
{
  return {
      subject("adaptive locator", true, in_body<Triangulated>),
      subject("adaptive locator whole-faces", true, in_body<Whole>),
      subject("adaptive locator fractions", true, by_fractions),
      subject("adaptive covering", true, in_covering<kernel::Adaptive>),
      subject("rational covering", true, in_covering<kernel::Rational_kernel>),
      subject("epick covering", false, in_covering<kernel::Epick>),
      subject("double covering", false, in_covering<kernel::Double>),
  };
}

std::vector<Ray_subject> ray_subjects()
{
  return {
      subject("adaptive tree", true, hits_of<Triangulated>),
      subject("adaptive tree whole-faces", true, hits_of<Whole>),
      subject("double moeller-trumbore", false, rays_in_doubles::hits),
  };
}

}  // namespace tetracone::verify
