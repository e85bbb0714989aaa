#include "verify/subjects/probe_subject.h"

#include "tetracone/covering/inclusion.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

namespace tetracone::verify {
namespace {

/// Keeps the prepared form of the last case's body and makes it anew for another body. An exception counts as no
/// answer.
template <class Ready>
class Probing {
 public:
  template <class Answer>
  auto operator()(const Probe_case& c, const Answer& answer) -> std::optional<decltype(answer(std::declval<Ready&>()))>
  {
    try {
      if (c.body != body_) {
        ready_ = std::make_unique<Ready>(*c.body);
        body_ = c.body;
      }
      return answer(*ready_);
    } catch (const std::exception&) {
      body_.reset();
      return std::nullopt;
    }
  }

 private:
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
class By_locator : public Running_probe {
 public:
  std::optional<int> where(const Probe_case& c) override
  {
    return ready_(c, [&](const Ready& ready) { return int(ready.body.inside(c.from)); });
  }

 private:
  Probing<Ready> ready_;
};

class By_fractions : public Running_probe {
 public:
  std::optional<int> where(const Probe_case& c) override
  {
    return ready_(c, [&](const Triangulated& ready) {
      const auto fraction = [&](std::size_t k) {
        const std::string number = kernel::to_string(kernel::Rational(c.from[k]));
        return number.find('/') == std::string::npos ? number + "/1" : number;
      };
      return int(ready.body.inside_text({fraction(0), fraction(1), fraction(2)}));
    });
  }

 private:
  Probing<Triangulated> ready_;
};

/// The signed sum over the whole covering, in kernel K.
template <class K>
class By_covering : public Running_probe {
 public:
  std::optional<int> where(const Probe_case& c) override
  {
    return ready_(c, [&](Ready& ready) {
      return int(covering::locate<K>(ready.placed.frame()(kernel::point<K>(c.from)), ready.placed));
    });
  }

 private:
  struct Ready {
    explicit Ready(const covering::Polyhedron& polyhedron) : model(polyhedron), placed(model)
    {
      placed.place(identity);
    }
    kernel::Pose identity;
    covering::Model<K> model;
    covering::Placed_model<K> placed;
  };
  Probing<Ready> ready_;
};

template <class Ready>
class By_tree : public Running_probe {
 public:
  std::optional<Told_hits> hits(const Probe_case& c) override
  {
    return ready_(c, [&](const Ready& ready) {
      const Ray ray{c.from, c.direction};
      return Told_hits{ready.body.first_hit(ray), ready.body.hits(ray)};
    });
  }

 private:
  Probing<Ready> ready_;
};

/// Moeller and Trumbore, Fast, minimum storage ray-triangle intersection (1997), in double without a tolerance. A ray
/// in a triangle's plane does not meet it.
class By_moeller_trumbore : public Running_probe {
 public:
  std::optional<Told_hits> hits(const Probe_case& c) override
  {
    return ready_(c, [&](const Triangles& ready) {
      std::vector<Ray_hit> all;
      for (const covering::Face_triangle& t : ready.triangles) {
        const auto corner = [&](std::size_t k) -> const Vector& { return c.body->vertices[t.corner[k]]; };
        const double at = crossing(c.from, c.direction, corner(0), corner(1), corner(2));
        if (!(at >= 0)) continue;
        const auto known = std::ranges::find(all, t.face, &Ray_hit::face);
        if (known == all.end())
          all.push_back({t.face, at});
        else
          known->t = std::min(known->t, at);
      }
      std::ranges::sort(all,
                        [](const Ray_hit& x, const Ray_hit& y) { return x.t != y.t ? x.t < y.t : x.face < y.face; });
      return Told_hits{all.empty() ? std::nullopt : std::optional(all.front()), all};
    });
  }

 private:
  using Vector = kernel::Vertex;

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

  static Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector cross(const Vector& a, const Vector& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  /// Returns t of the crossing; negative or NaN if there is none.
  static double crossing(const Vector& o, const Vector& d, const Vector& a, const Vector& b, const Vector& c)
  {
    const Vector e = minus(b, a), f = minus(c, a), p = cross(d, f), s = minus(o, a), q = cross(s, e);
    const double determinant = dot(e, p), u = dot(s, p) / determinant, v = dot(d, q) / determinant;
    return determinant != 0 && u >= 0 && v >= 0 && u + v <= 1 ? dot(f, q) / determinant : -1;
  }

  Probing<Triangles> ready_;
};

template <class Running>
Probe_subject subject(const char* name, bool is_exact)
{
  return {name, is_exact, [] { return std::make_unique<Running>(); }};
}

}  // namespace

std::vector<Probe_subject> point_subjects()
{
  return {
      subject<By_locator<Triangulated>>("adaptive locator", true),
      subject<By_locator<Whole>>("adaptive locator whole-faces", true),
      subject<By_fractions>("adaptive locator fractions", true),
      subject<By_covering<kernel::Adaptive>>("adaptive covering", true),
      subject<By_covering<kernel::Rational_kernel>>("rational covering", true),
      subject<By_covering<kernel::Epick>>("epick covering", false),
      subject<By_covering<kernel::Double>>("double covering", false),
  };
}

std::vector<Probe_subject> ray_subjects()
{
  return {
      subject<By_tree<Triangulated>>("adaptive tree", true),
      subject<By_tree<Whole>>("adaptive tree whole-faces", true),
      subject<By_moeller_trumbore>("double moeller-trumbore", false),
  };
}

}  // namespace tetracone::verify
