#include "verify/shrink.h"

#include "covering/edge_uses.h"
#include "covering/planarity.h"
#include "verify/brute.h"
#include "verify/predicate_truth.h"
#include "verify/shrink_faces.h"
#include "verify/shrink_numbers.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

namespace tetracone::verify {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Question;

/// Counts questions and time.
class Spending {
 public:
  explicit Spending(const Shrink_budget& budget) : budget_(budget) {}

  bool one_more() { return !over() && ++spent_ <= budget_.evaluations; }
  bool over() const
  {
    return spent_ >= budget_.evaluations || std::chrono::duration<double>(Clock::now() - start_).count() > budget_.seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Shrink_budget budget_;
  std::size_t spent_ = 0;
  Clock::time_point start_ = Clock::now();
};

Case_numbers numbers_of(const Object_case& c) { return {{c.a->vertices, c.b->vertices}, {c.pose_a, c.pose_b}}; }
Case_numbers numbers_of(const Predicate_case& c) { return {{{{c.v.begin(), c.v.end()}, {c.p, c.q, c.r}}}, {c.pose_a, c.pose_b}}; }

bool is_flat(const Case_numbers& numbers)
{
  return std::any_of(numbers.poses.begin(), numbers.poses.end(), [](const kernel::Pose& pose) { return pose.determinant_sign() == CGAL::ZERO; });
}

bool is_legal(const Polyhedron& polyhedron, Question question)
{
  if (polyhedron.face_count() == 0) return false;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (!polyhedron.is_triangle(f) && covering::planarity(polyhedron, f) == covering::Planarity::off_plane) return false;
  return question == Question::surface || covering::is_closed(polyhedron);
}

class Object_shrink {
 public:
  Object_shrink(Object_case c, Question question, const Object_check& still_wrong, const Shrink_budget& budget)
      : c_(std::move(c)), size_(size_of(c_)), question_(question), still_wrong_(still_wrong), spending_(budget)
  {
    c_.surface = c_.solid = std::nullopt;  // of the case that it was
  }

  Object_case run()
  {
    for (Case_size before{}; before != size_ && !spending_.over();) {
      before = size_;
      simplify_bodies();
      triangulate();
      simplify_numbers();
    }
    return c_;
  }

 private:
  std::shared_ptr<const Polyhedron>& body(Object_case& c, int which) const { return which == 0 ? c.a : c.b; }

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
    return is_legal(*c.a, question_) && is_legal(*c.b, question_) && spending_.one_more() && still_wrong_(c);
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
      shrink_faces(*body(c_, which), question_, [&](const Polyhedron& polyhedron) { return accept_body(which, polyhedron); });
  }

  /// More faces at first: kept only where it leads to less in the end.
  void triangulate()
  {
    for (int which = 0; which < 2; ++which) {
      const std::optional<Polyhedron> triangles = fanned(*body(c_, which));
      if (!triangles) continue;
      const Object_case before = c_;
      const Case_size size = size_;
      Object_case candidate = c_;
      body(candidate, which) = std::make_shared<Polyhedron>(*triangles);
      if (!holds(candidate)) continue;
      c_ = candidate;
      size_ = size_of(c_);
      simplify_bodies();
      if (size_ < size) continue;
      c_ = before;
      size_ = size;
    }
  }

  void simplify_numbers()
  {
    Case_numbers numbers = numbers_of(c_);
    simplify(numbers, [&](const Case_numbers& n) {
      if (is_flat(n)) return false;
      Object_case candidate = c_;
      for (int which = 0; which < 2; ++which) {
        if (n.points[which] != body(c_, which)->vertices) {
          auto moved = std::make_shared<Polyhedron>(*body(c_, which));
          moved->vertices = n.points[which];
          body(candidate, which) = std::move(moved);
        }
        (which == 0 ? candidate.pose_a : candidate.pose_b) = n.poses[which];
      }
      return accept(std::move(candidate));
    });
  }

  Object_case c_;
  Case_size size_;
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

Predicate_case shrink(Predicate_case c, const Predicate_check& still_wrong, const Shrink_budget& budget)
{
  Spending spending(budget);
  Case_numbers numbers = numbers_of(c);
  const auto with = [&](const Case_numbers& n) {
    Predicate_case result = c;
    std::copy_n(n.points[0].begin(), 4, result.v.begin());
    result.p = n.points[1][0], result.q = n.points[1][1], result.r = n.points[1][2];
    result.pose_a = n.poses[0], result.pose_b = n.poses[1];
    return result;
  };
  while (!spending.over() && simplify(numbers, [&](const Case_numbers& n) { return !is_flat(n) && spending.one_more() && still_wrong(with(n)); })) {
  }
  return with(numbers);
}

bool true_answer(const Object_case& c, Question question)
{
  return verify::collide(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b, question);
}

Object_check same_error(Answering& subject, Question question, Outcome answer, bool truth)
{
  // The subject first: it is faster.
  return [=, &subject](const Object_case& c) { return subject(c, question) == answer && true_answer(c, question) == truth; };
}

Predicate_check same_error(const Predicate_subject& subject, Predicate predicate, int answer, int truth)
{
  return [=, &subject](const Predicate_case& c) { return subject.answer(predicate, c) == answer && true_answer(predicate, c) == truth; };
}

}  // namespace tetracone::verify
