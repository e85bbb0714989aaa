#include "verify/subjects/predicate_subject.h"

#include "tetracone/covering/inclusion.h"
#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/tetrahedron.h"
#include "tetracone/kernel/predicate/triangle_triangle.h"
#include "tetracone/tetratree/door/kernel_list.h"
#include "tetracone/tetratree/paper/classification.h"
#include "verify/subjects/segment_triangle_formulations.h"

#include <CGAL/exceptions.h>

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Point;

// These are template arguments by reference, since clang before 18 takes no floating-point ones.
constexpr double eps_0 = 0, eps_1e_12 = 1e-12;
constexpr kernel::Tolerance no_tolerance{}, absolute_1e_12{1e-12, 0}, relative_1e_12{0, 1e-12};

/// The seven points, placed by kernel K.
template <class K>
struct Placed {
  explicit Placed(const Predicate_case& c)
  {
    const kernel::Frame<K> a(c.pose_a), b(c.pose_b);
    for (int k = 0; k < 4; ++k) v[k] = a(kernel::point<K>(c.v[k]));
    p = b(kernel::point<K>(c.p));
    q = b(kernel::point<K>(c.q));
    r = b(kernel::point<K>(c.r));
  }

  std::array<Point<K>, 4> v;
  Point<K> p, q, r;
};

/// The cone, positively oriented like the tree's cones.
template <class K>
tetratree::Cone_points<K> cone(const Placed<K>& x)
{
  tetratree::Cone_points<K> cone(kernel::Cone_lattice{}, tetratree::Tetra_cone::octant(0));
  cone.v0 = x.v[0];
  cone.v1 = x.v[1];
  cone.v2 = x.v[2];
  cone.v3 = x.v[3];
  if (kernel::volume_sign<K>(x.v[0], x.v[1], x.v[2], x.v[3]) == kernel::NEGATIVE) std::swap(cone.v1, cone.v2);
  return cone;
}

/// The covering's rule (`covering::locate`) for the four faces, with q as origin.
template <class K>
int locate(const Placed<K>& x)
{
  constexpr std::array<std::array<int, 3>, 4> faces = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for (const auto& [i, j, k] : faces)
    if (kernel::segment_triangle<K>(x.p, x.p, x.v[i], x.v[j], x.v[k]) != kernel::Contact::none) return 0;
  int winding = 0;
  for (const auto& [i, j, k] : faces) winding += covering::signed_inclusion<K>(x.p, x.q, x.v[i], x.v[j], x.v[k]);
  return winding != 0 ? 1 : -1;
}

template <class K>
std::optional<int> ask(Predicate predicate, const Predicate_case& c)
{
  const Placed<K> x(c);
  const auto& v = x.v;
  switch (predicate) {
    // det[v1-p, v2-p, v3-p] has the opposite sign of the side of p of the plane v1 v2 v3, which is the question of
    // queries.
    case Predicate::orientation: return -kernel::volume_sign<K>(v[1], v[2], v[3], x.p);
    case Predicate::tetra_cone: {
      const auto t = cone(x);
      return kernel::is_in_tetra_cone<K>(x.p, t.v0, t.v1, t.v2, t.v3);
    }
    case Predicate::tetrahedron: return kernel::is_in_tetrahedron<K>(x.p, v[0], v[1], v[2], v[3]);
    case Predicate::segment_triangle:
      return kernel::segment_triangle<K>(x.p, x.q, v[1], v[2], v[3]) != kernel::Contact::none;
    case Predicate::solid: return locate(x);
    case Predicate::classification: return tetratree::classify<K>(cone(x), x.p, x.q, x.r) != tetratree::Classified::no;
    case Predicate::triangle_triangle: return kernel::triangles_meet<K>({&v[1], &v[2], &v[3]}, {&x.p, &x.q, &x.r});
  }
  return std::nullopt;
}

/// Kernel K, with the tolerance where it has one.
template <class K, const kernel::Tolerance& tolerance = no_tolerance>
std::optional<int> ours(Predicate predicate, const Predicate_case& c)
{
  kernel::Tolerant::tolerance() = tolerance;
  try {
    return ask<K>(predicate, c);
  } catch (const CGAL::Failure_exception&) {
    return no_answer;  // the exact stage of a filter, given an infinite image
  }
}

/// Adds the kernel's own predicates. A kernel with a tolerance makes two subjects.
template <class K>
void add_ours(std::vector<Predicate_subject>& subjects, const std::string& name, bool is_exact)
{
  if constexpr (std::is_same_v<K, kernel::Tolerant>) {
    subjects.push_back({name + "=1e-12", is_exact, "", ours<K, absolute_1e_12>});
    subjects.push_back({name + "=rel:1e-12", is_exact, "", ours<K, relative_1e_12>});
  } else {
    subjects.push_back({name, is_exact, "", ours<K>});
  }
}

// --- other formulations ----------------------------------------------------------------------------------------------

template <class Number>
using Vector = formulations::Vector<Number>;

/// A formulation as a subject, with the points placed by kernel K.
template <class K,
          bool (*meet)(const Vector<typename K::FT>&, const Vector<typename K::FT>&, const Vector<typename K::FT>&,
                       const Vector<typename K::FT>&, const Vector<typename K::FT>&)>
std::optional<int> formulated(Predicate predicate, const Predicate_case& c)
{
  if (predicate != Predicate::segment_triangle) return std::nullopt;
  const Placed<K> x(c);
  const auto vector = [](const Point<K>& p) { return Vector<typename K::FT>{p.x(), p.y(), p.z()}; };
  return meet(vector(x.p), vector(x.q), vector(x.v[1]), vector(x.v[2]), vector(x.v[3]));
}

template <const double& eps>
bool moeller_trumbore(const Vector<double>& p, const Vector<double>& q, const Vector<double>& a,
                      const Vector<double>& b, const Vector<double>& c)
{
  return formulations::moeller_trumbore(p, q, a, b, c, eps);
}

template <class Number, const double& eps,
          formulations::First_end_on_plane transcription = formulations::First_end_on_plane::right>
bool jimenez_segura_feito(const Vector<Number>& p, const Vector<Number>& q, const Vector<Number>& a,
                          const Vector<Number>& b, const Vector<Number>& c)
{
  return formulations::jimenez_segura_feito<transcription>(p, q, a, b, c, Number(eps));
}

template <class K>
std::optional<int> cgal(Predicate predicate, const Predicate_case& c)
{
  if (predicate != Predicate::segment_triangle) return std::nullopt;
  const Placed<K> x(c);
  try {
    return formulations::cgal_do_intersect<K>(x.p, x.q, x.v[1], x.v[2], x.v[3]);
  } catch (const CGAL::Failure_exception&) {
    return no_answer;  // rounded signs that contradict each other: an assertion, where those are on
  }
}

/// A method of our own process, which keeps nothing.
class Called : public Running_predicates {
 public:
  explicit Called(const Predicate_subject& subject) : Running_predicates(subject.name), answer_(subject.answer) {}

  Told<int> operator()(const Predicate_case& c, Predicate predicate) override
  {
    const auto [value, ns] = timed([&] { return answer_(predicate, c); });
    return value ? Told<int>{Outcome::yes, *value, Spent{0, ns}} : Told<int>();
  }

 private:
  std::optional<int> (*answer_)(Predicate, const Predicate_case&);
};

}  // namespace

std::unique_ptr<Running_predicates> Predicate_subject::make() const
{
  return start ? start() : std::make_unique<Called>(*this);
}

const std::vector<Predicate_subject>& predicate_subjects()
{
  using namespace kernel;
  constexpr auto sign_error = formulations::First_end_on_plane::sign_error;
  static const std::string moeller =
      "Moeller & Trumbore 1997; never hits a parallel segment; eps is absolute, on the determinant";
  static const std::string segura = "Segura & Feito 2001, five volumes; no coplanar segments";
  static const std::string jimenez =
      "Jimenez, Segura & Feito 2010; no coplanar segments; eps is absolute, on each volume";
  static const std::string error =
      "Jimenez, Segura & Feito 2010 as public ports have it, with -s for s: no segment that starts on the plane hits; "
      "an error of algebra, which no arithmetic repairs";
  static const std::string cgal_note =
      "CGAL's do_intersect on the placed points as they are rounded; degenerate ones are passed on as what they are";
  static const std::vector<Predicate_subject> others = {
      {"double moeller-trumbore-eps-1e-12", false, moeller, formulated<Double, moeller_trumbore<eps_1e_12>>},
      {"double moeller-trumbore-eps-0", false, moeller, formulated<Double, moeller_trumbore<eps_0>>},
      {"double segura-feito", false, segura, formulated<Double, formulations::segura_feito<double>>},
      {"double jimenez-segura-feito-eps-0", false, jimenez, formulated<Double, jimenez_segura_feito<double, eps_0>>},
      {"double jimenez-segura-feito-eps-1e-12", false, jimenez,
       formulated<Double, jimenez_segura_feito<double, eps_1e_12>>},
      {"double jimenez-segura-feito-sign-error", false, error,
       formulated<Double, jimenez_segura_feito<double, eps_0, sign_error>>},
      {"rational jimenez-segura-feito-sign-error", false, error,
       formulated<Rational_kernel, jimenez_segura_feito<Rational, eps_0, sign_error>>},
      {"double cgal", false, cgal_note, cgal<Double>},
      {"float cgal", false, cgal_note, cgal<Float>},
      {"epick cgal", false, cgal_note, cgal<Epick>},
  };
  static const std::vector<Predicate_subject> subjects = [] {
    std::vector<Predicate_subject> all;
#define TETRACONE_SUBJECT(enumerator, name, type, exact) add_ours<type>(all, name, exact);
    TETRACONE_FOR_EACH_KERNEL(TETRACONE_SUBJECT)
#undef TETRACONE_SUBJECT
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }();
  return subjects;
}

}  // namespace tetracone::verify
