#include "verify/shrink/shrink.h"

#include "tetracone/covering/covering.h"
#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/planarity.h"
#include "verify/shrink/shrink_faces.h"
#include "verify/shrink/shrink_numbers.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/predicate_truth.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace tetracone::verify {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Question;

/// The spent part of a shrink's budget: questions and time.
class Spending {
 public:
  struct Over {};

  explicit Spending(const Shrink_budget& budget) : budget_(budget) {}

  /// Throws Over where the budget is spent, which ends all loops at once.
  void one_more()
  {
    if (spent_ >= budget_.evaluations || std::chrono::duration<double>(Clock::now() - start_).count() > budget_.seconds)
      throw Over();
    ++spent_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Shrink_budget budget_;
  std::size_t spent_ = 0;
  Clock::time_point start_ = Clock::now();
};

/// Whether the predicate gets a degenerate segment or triangle: legal, but another kind of case. (Cones and tetrahedra
/// may not be degenerate.)
bool is_degenerate(Predicate predicate, const Predicate_case& c)
{
  const auto on_line = [](const kernel::Vertex& p, const kernel::Vertex& q, const kernel::Vertex& r) {
    const auto point = [](const kernel::Vertex& v) { return Exact::Point_3(v[0], v[1], v[2]); };
    return CGAL::collinear(point(p), point(q), point(r));
  };
  if (predicate == Predicate::segment_triangle) return c.p == c.q || on_line(c.v[1], c.v[2], c.v[3]);
  if (predicate == Predicate::triangle_triangle && on_line(c.v[1], c.v[2], c.v[3])) return true;
  return (predicate == Predicate::classification || predicate == Predicate::triangle_triangle) &&
         on_line(c.p, c.q, c.r);
}

bool is_flat(const Case_numbers& numbers)
{
  return std::any_of(numbers.poses.begin(), numbers.poses.end(),
                     [](const kernel::Pose& pose) { return pose.determinant_sign() == CGAL::ZERO; });
}

/// Properties that a body keeps while it shrinks: else most errors would end as two points, which all look alike.
struct Shape {
  bool degenerate_faces = false, flat = false;
  bool open = false;
};

/// Nothing where a face is not planar.
std::optional<Shape> shape_of(const Polyhedron& polyhedron)
{
  Shape shape;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const covering::Planarity planarity = covering::planarity(polyhedron, f);
    if (planarity == covering::Planarity::off_plane) return std::nullopt;
    shape.degenerate_faces = shape.degenerate_faces || planarity == covering::Planarity::degenerate;
  }
  shape.open = !covering::is_closed(polyhedron);
  shape.flat = shape.open || covering::volume(polyhedron) == 0;
  return shape;
}

class Object_shrink {
 public:
  Object_shrink(Object_case c, Question question, const Object_check& still_wrong, const Shrink_budget& budget)
      : c_(std::move(c)), size_(size_of(c_)), question_(question), still_wrong_(still_wrong), spending_(budget)
  {
    c_.surface = c_.solid = std::nullopt;  // of the case that it was
    for (int which = 0; which < 2; ++which) shapes_[which] = *shape_of(*body(c_, which));
  }

  Object_case run()
  {
    try {
      for (Case_size before{}; before != size_;) {
        before = size_;
        simplify_bodies();
        triangulate();
        simplify_numbers();
      }
    } catch (const Spending::Over&) {
      if (aside_ && size_of(*aside_) < size_) return *aside_;
    }
    return c_;
  }

 private:
  static std::shared_ptr<const Polyhedron>& body(Object_case& c, int which) { return which == 0 ? c.a : c.b; }

  bool is_legal(const Polyhedron& polyhedron, const Shape& before) const
  {
    if (polyhedron.face_count() == 0) return false;
    const auto shape = shape_of(polyhedron);
    if (!shape || (shape->degenerate_faces && !before.degenerate_faces)) return false;
    return question_ == Question::surface || (!shape->open && (!shape->flat || before.flat));
  }

  bool accept(Object_case candidate)
  {
    const Case_size size = size_of(candidate);
    if (size >= size_ || !holds(candidate)) return false;
    c_ = std::move(candidate);
    size_ = size;
    return true;
  }

  bool holds(const Object_case& c)
  {
    if (!is_legal(*c.a, shapes_[0]) || !is_legal(*c.b, shapes_[1])) return false;
    spending_.one_more();
    return still_wrong_(c);
  }

  bool accept_body(int which, Polyhedron polyhedron)
  {
    Object_case candidate = c_;
    body(candidate, which) = std::make_shared<Polyhedron>(std::move(polyhedron));
    return accept(std::move(candidate));
  }

  void simplify_bodies()
  {
    for (int which = 0; which < 2; ++which)
      shrink_faces(*body(c_, which), question_,
                   [&](const Polyhedron& polyhedron) { return accept_body(which, polyhedron); });
  }

  /// More faces at first: kept only where it leads to less in the end.
  void triangulate()
  {
    for (int which = 0; which < 2; ++which) {
      const std::optional<Polyhedron> triangles = fanned(*body(c_, which));
      if (!triangles) continue;
      Object_case candidate = c_;
      body(candidate, which) = std::make_shared<Polyhedron>(*triangles);
      if (!holds(candidate)) continue;
      const Case_size size = size_;
      aside_ = std::exchange(c_, candidate);
      size_ = size_of(c_);
      simplify_bodies();
      if (size_ >= size) {
        c_ = *aside_;
        size_ = size;
      }
      aside_.reset();
    }
  }

  void simplify_numbers()
  {
    Case_numbers numbers = numbers_of(c_);
    simplify(numbers, [&](const Case_numbers& n) { return !is_flat(n) && accept(with_numbers(c_, n)); });
  }

  Object_case c_;
  Case_size size_;
  std::array<Shape, 2> shapes_;       // of the bodies as they were given
  std::optional<Object_case> aside_;  // what c_ was before it was made larger
  Question question_;
  const Object_check& still_wrong_;
  Spending spending_;
};

}  // namespace

Case_size size_of(const Object_case& c)
{
  Case_size size{0, c.a->vertices.size() + c.b->vertices.size(), bits(numbers_of(c))};
  for (const auto& body : {c.a, c.b})
    for (Index f = 0; f < body->face_count(); ++f) size.corners += covering::corners(*body, f).size();
  return size;
}

Case_size size_of(const Predicate_case& c) { return {0, 7, bits(numbers_of(c))}; }

std::size_t face_count(const Object_case& c) { return c.a->face_count() + c.b->face_count(); }

Object_case shrink(Object_case c, Question question, const Object_check& still_wrong, const Shrink_budget& budget)
{
  return Object_shrink(std::move(c), question, still_wrong, budget).run();
}

Predicate_case shrink(const Predicate_case& c, const Predicate_check& still_wrong, const Shrink_budget& budget)
{
  Spending spending(budget);
  Case_numbers numbers = numbers_of(c);
  const auto accept = [&](const Case_numbers& n) {
    if (is_flat(n)) return false;
    spending.one_more();
    return still_wrong(with_numbers(c, n));
  };
  try {
    while (simplify(numbers, accept)) {
    }
  } catch (const Spending::Over&) {
  }
  return with_numbers(c, numbers);
}

bool true_answer(const Object_case& c, Question question)
{
  return verify::collide(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b, question);
}

Object_check same_error(Running_subject& subject, Question question, Outcome answer, bool truth)
{
  // The subject first: it is faster.
  return [=, &subject](const Object_case& c) {
    return subject(c, question) == answer && true_answer(c, question) == truth;
  };
}

Object_check same_error_of_features(Running_subject& subject, bool misses)
{
  return [=, &subject](const Object_case& c) {
    const Told<Feature_pairs> listed = subject.features(c);
    if (listed.outcome != Outcome::yes) return false;
    const auto truth = features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b);
    const bool has_all = std::ranges::includes(listed.answer, truth);
    return misses ? !has_all : has_all && listed.answer.size() > truth.size();
  };
}

Predicate_check same_error(const Predicate_subject& subject, Predicate predicate, const Predicate_case& c, int answer,
                           int truth)
{
  const bool may_degenerate = is_degenerate(predicate, c);
  return [=, &subject](const Predicate_case& x) {
    return subject.answer(predicate, x) == answer && (may_degenerate || !is_degenerate(predicate, x)) &&
           true_answer(predicate, x) == truth;
  };
}

}  // namespace tetracone::verify
