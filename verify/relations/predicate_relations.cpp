#include "tetracone/kernel/predicate/adaptive.h"
#include "verify/cases/exact_motion.h"
#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Adaptive;
using kernel::Pose;
using kernel::Rational;
using kernel::Vertex;
using Answer = std::optional<int>;
using Trial = Predicate_level::Trial;

/// The points of a case in one row: v0 v1 v2 v3 p q r.
std::array<Vertex*, 7> points_of(Predicate_case& c) { return {&c.v[0], &c.v[1], &c.v[2], &c.v[3], &c.p, &c.q, &c.r}; }
std::array<Vertex, 7> points_of(const Predicate_case& c) { return {c.v[0], c.v[1], c.v[2], c.v[3], c.p, c.q, c.r}; }

bool is_asked(Predicate predicate, const Predicate_case& c)
{
  const auto v0 = Adaptive::placed(c.v[0], c.pose_a);
  const auto is_flat = [&](const std::array<Vertex, 3>& x, const Pose& pose) {
    return Adaptive::volume_sign(v0, Adaptive::placed(x[0], pose), Adaptive::placed(x[1], pose),
                                 Adaptive::placed(x[2], pose)) == CGAL::ZERO;
  };
  switch (predicate) {
    case Predicate::tetra_cone:
    case Predicate::tetrahedron: return !is_flat({c.v[1], c.v[2], c.v[3]}, c.pose_a);
    case Predicate::classification:
      return !is_flat({c.v[1], c.v[2], c.v[3]}, c.pose_a) && !is_flat({c.p, c.q, c.r}, c.pose_b);
    default: return true;
  }
}

/// Returns the subject's answer; nothing when `Predicate` states that the case is not asked, whatever the subject
/// answers.
Answer ask(const Trial& t, const Predicate_case& c)
{
  if (!is_asked(t.question, c)) return std::nullopt;
  const auto told = t.subject(c, t.question);
  return told.outcome == Outcome::yes ? Answer(told.answer) : std::nullopt;
}

/// Returns the answer after an affine map of all points: an orientation times `sign`, any other answer unchanged.
Answer turned_over(const Trial& t, Answer answer, int sign)
{
  return answer && t.question == Predicate::orientation ? Answer(*answer * sign) : answer;
}

Verdict same(Answer a, Answer b) { return a && b ? verdict(*a == *b) : Verdict::not_applicable; }

/// The case with every point of both bodies under one pose.
Predicate_case under(Predicate_case c, const Pose& pose)
{
  c.pose_a = pose;
  c.pose_b = pose;
  return c;
}

Verdict permutations(const Trial& t)
{
  if (t.question != Predicate::orientation) return Verdict::not_applicable;
  // With p in its own frame the three vertices can change places; in one frame all four can.
  for (const bool mixed : {true, false}) {
    const Predicate_case base = mixed ? t.c : under(t.c, t.c.pose_b);
    const Answer answer = ask(t, base);
    if (!answer) return Verdict::not_applicable;
    std::array<int, 4> order{0, 1, 2, 3};
    do {
      if (mixed && order[3] != 3) continue;
      const std::array<Vertex, 4> points{base.v[1], base.v[2], base.v[3], base.p};
      Predicate_case twin = base;
      for (int k = 0; k < 3; ++k) twin.v[k + 1] = points[order[k]];
      twin.p = points[order[3]];
      int parity = 1;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j) parity *= order[j] > order[i] ? -1 : 1;
      const Answer of_twin = ask(t, twin);
      if (!of_twin) return Verdict::not_applicable;
      if (*of_twin != parity * *answer) return Verdict::violated;
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return Verdict::holds;
}

Verdict one_frame(const Trial& t)
{
  const Pose& pose = one_of(t.random, 2) == 0 ? t.c.pose_a : t.c.pose_b;
  if (pose.is_identity()) return Verdict::not_applicable;
  const Answer unmoved = ask(t, under(t.c, Pose()));
  return same(turned_over(t, unmoved, pose.determinant_sign()), ask(t, under(t.c, pose)));
}

Verdict absorbed(const Trial& t)
{
  const std::array<Vertex, 7> points = points_of(t.c);
  const auto images = [&](const Pose& pose, std::size_t begin, std::size_t end) -> std::optional<std::vector<Vertex>> {
    std::vector<Vertex> images;
    for (std::size_t k = begin; k < end; ++k) {
      const auto image = exact_image(pose, points[k]);
      if (!image) return std::nullopt;
      images.push_back(*image);
    }
    return images;
  };
  Predicate_case twin = t.c;
  bool changed = false;
  const auto absorb = [&](Pose& pose, std::size_t begin, std::size_t end) {
    if (pose.is_identity()) return;
    if (const auto placed = images(pose, begin, end)) {
      for (std::size_t k = begin; k < end; ++k) *points_of(twin)[k] = (*placed)[k - begin];
      pose = Pose();
      changed = true;
    }
  };
  absorb(twin.pose_a, 0, 4);
  absorb(twin.pose_b, 4, 7);
  if (!changed) {  // the part of a motion that any double can take: a permutation of the axes
    const auto p = Signed_permutation::any(t.random);
    for (Vertex* point : points_of(twin)) *point = p(*point);
    twin.pose_a = turned_back(twin.pose_a, p);
    twin.pose_b = turned_back(twin.pose_b, p);
  }
  return same(ask(t, t.c), ask(t, twin));
}

Verdict grassmann_pluecker(const Trial& t)
{
  if (t.question != Predicate::orientation) return Verdict::not_applicable;
  const std::array poses{Pose(), t.c.pose_a, t.c.pose_b};
  const Predicate_case base = under(t.c, poses[one_of(t.random, poses.size())]);
  std::array<int, 7> x{0, 1, 2, 3, 4, 5, 6};
  for (int k = 0; k < 6; ++k) std::swap(x[k], x[k + one_of(t.random, 7 - k)]);
  const auto points = points_of(base);
  bool answered = true;
  const auto sign = [&](int i, int j, int k, int l) {
    Predicate_case quadruple = base;
    quadruple.v[1] = points[x[i]];
    quadruple.v[2] = points[x[j]];
    quadruple.v[3] = points[x[k]];
    quadruple.p = points[x[l]];
    const Answer answer = ask(t, quadruple);
    answered = answered && answer;
    return answer.value_or(0);
  };
  const std::array products{sign(0, 1, 2, 3) * sign(0, 1, 4, 5), -sign(0, 1, 2, 4) * sign(0, 1, 3, 5),
                            sign(0, 1, 2, 5) * sign(0, 1, 3, 4)};
  if (!answered) return Verdict::not_applicable;
  // Their values sum to zero.
  const auto [least, largest] = std::minmax_element(products.begin(), products.end());
  return verdict((*least < 0) == (*largest > 0));
}

Verdict swap_ends(const Trial& t)
{
  if (t.question != Predicate::segment_triangle) return Verdict::not_applicable;
  const Answer answer = ask(t, t.c);
  if (!answer) return Verdict::not_applicable;
  Predicate_case twin = t.c;
  for (int turn = 0; turn < 6; ++turn) {
    std::swap(twin.p, twin.q);
    if (turn % 2 == 1) std::rotate(twin.v.begin() + 1, twin.v.begin() + 2, twin.v.end());
    const Verdict of_twin = same(answer, ask(t, twin));
    if (of_twin != Verdict::holds) return of_twin;
  }
  return Verdict::holds;
}

/// The largest coordinate of a point or of a translation: the scale of what is worth adding to it.
double scale_of(const Predicate_case& c)
{
  double largest = largest_translation(c.pose_a, c.pose_b);
  for (const Vertex& point : points_of(c)) largest = std::max(largest, magnitude(point));
  return largest;
}

Verdict common_motion(const Trial& t)
{
  Predicate_case twin = t.c;
  const auto p = Signed_permutation::any(t.random);
  if (!move_together(twin, p, scale_of(t.c), t.random)) return Verdict::not_applicable;
  return same(turned_over(t, ask(t, t.c), p.determinant()), ask(t, twin));
}

Verdict scaling(const Trial& t)
{
  const int exponent = (one_of(t.random, 2) == 0 ? 1 : -1) * int(1 + one_of(t.random, 40));
  Predicate_case twin = t.c;
  for (Vertex* point : points_of(twin)) {
    const auto moved = exact_scaled(*point, exponent);
    if (!moved) return Verdict::not_applicable;
    *point = *moved;
  }
  const auto a = scaled(t.c.pose_a, exponent), b = scaled(t.c.pose_b, exponent);
  if (!a || !b) return Verdict::not_applicable;
  twin.pose_a = *a;
  twin.pose_b = *b;
  return same(ask(t, t.c), ask(t, twin));
}

/// The whole is hit when a half is: `first` of the whole replaced by the middle, then `second`.
Verdict halves(const Trial& t, Vertex& (*first)(Predicate_case&), Vertex& (*second)(Predicate_case&))
{
  Predicate_case left = t.c, right = t.c;
  const auto middle = exact_middle(first(left), second(left));
  if (!middle) return Verdict::not_applicable;
  second(left) = *middle;
  first(right) = *middle;
  const Answer whole = ask(t, t.c), a = ask(t, left), b = ask(t, right);
  return whole && a && b ? verdict(*whole == std::max(*a, *b)) : Verdict::not_applicable;
}

Verdict split(const Trial& t)
{
  const auto v0 = [](Predicate_case& x) -> Vertex& { return x.v[0]; };
  const auto v1 = [](Predicate_case& x) -> Vertex& { return x.v[1]; };
  const auto v2 = [](Predicate_case& x) -> Vertex& { return x.v[2]; };
  const auto p = [](Predicate_case& x) -> Vertex& { return x.p; };
  const auto q = [](Predicate_case& x) -> Vertex& { return x.q; };
  const bool of_b = one_of(t.random, 2) == 0;
  switch (t.question) {
    case Predicate::segment_triangle: return of_b ? halves(t, p, q) : halves(t, v1, v2);
    case Predicate::tetrahedron: return halves(t, v0, v1);
    case Predicate::tetra_cone: return halves(t, v1, v2);
    case Predicate::classification:
    case Predicate::triangle_triangle: return of_b ? halves(t, p, q) : halves(t, v1, v2);
    default: return Verdict::not_applicable;
  }
}

Verdict order(const Trial& t)
{
  // The points that stand for one another: of the tetrahedron all four, of a cone or triangle three.
  if (t.question == Predicate::orientation) return Verdict::not_applicable;
  const int first = t.question == Predicate::tetrahedron || t.question == Predicate::solid ? 0 : 1;
  Predicate_case twin = t.c;
  for (int k = first; k < 3; ++k) std::swap(twin.v[k], twin.v[k + one_of(t.random, 4 - k)]);
  if (t.question == Predicate::classification || t.question == Predicate::triangle_triangle) {
    std::swap(twin.p, *std::array{&twin.p, &twin.q, &twin.r}[one_of(t.random, 3)]);
    if (one_of(t.random, 2) == 0) std::swap(twin.q, twin.r);
  }
  return same(ask(t, t.c), ask(t, twin));
}

Verdict apex(const Trial& t)
{
  if (t.question != Predicate::solid) return Verdict::not_applicable;
  Predicate_case twin = t.c;
  switch (one_of(t.random, 3)) {
    case 0: twin.q = t.c.r; break;
    case 1: twin.q = t.c.p; break;
    default:
      for (double& coordinate : twin.q) coordinate += ulp(magnitude(t.c.q)) * (double(one_of(t.random, 2049)) - 1024);
      if (!std::isfinite(magnitude(twin.q))) return Verdict::not_applicable;
  }
  return same(ask(t, t.c), ask(t, twin));
}

Verdict stages(const Trial& t)
{
  if (t.question != Predicate::orientation || !t.subject.name().starts_with("adaptive")) return Verdict::not_applicable;
  std::array<Adaptive::Point_3, 7> x;
  const auto points = points_of(t.c);
  for (int k = 0; k < 7; ++k) {
    const Pose& pose = k < 4 ? t.c.pose_a : t.c.pose_b;
    x[k] = pose.is_identity() ? Adaptive::unmoved(points[k]) : Adaptive::placed(points[k], pose);
  }
  bool agree = true;
  const auto compare = [&](const Adaptive::Decision& filtered, CGAL::Sign exact, CGAL::Sign sign) {
    agree = agree && sign == exact && (!filtered || *filtered == exact);
  };
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 0; k < j; ++k) {
        for (int l = 0; l < k; ++l)
          compare(Adaptive::filtered_volume_sign(x[i], x[j], x[k], x[l]),
                  Adaptive::exact_volume_sign(x[i], x[j], x[k], x[l]), Adaptive::volume_sign(x[i], x[j], x[k], x[l]));
        const int axis = (i + j + k) % 3;
        compare(Adaptive::filtered_normal_sign(x[i], x[j], x[k], axis),
                Adaptive::exact_normal_sign(x[i], x[j], x[k], axis), Adaptive::normal_sign(x[i], x[j], x[k], axis));
        compare(Adaptive::filtered_difference_sign(x[i], x[j], axis), Adaptive::exact_difference_sign(x[i], x[j], axis),
                Adaptive::difference_sign(x[i], x[j], axis));
      }
  return verdict(agree);
}

Verdict monotone(const Trial& t)
{
  std::vector<int> answers;
  for (const Pose& pose : poses_along_axis(t.c.pose_b, scale_of(t.c), t.random)) {
    Predicate_case twin = t.c;
    twin.pose_b = pose;
    if (const Answer answer = ask(t, twin)) answers.push_back(*answer);
  }
  if (answers.size() < 3) return Verdict::not_applicable;
  // An orientation is the sign of a linear function of the step. The others ask whether two convex sets meet: once
  // apart, always.
  if (t.question == Predicate::orientation)
    return verdict(std::is_sorted(answers.begin(), answers.end()) || std::is_sorted(answers.rbegin(), answers.rend()));
  const auto top = std::max_element(answers.begin(), answers.end());
  return verdict(std::is_sorted(answers.begin(), top) &&
                 std::is_sorted(answers.rbegin(), std::make_reverse_iterator(top)));
}

constexpr std::array of_predicates = std::to_array<Predicate_level::Relation>({
    {"R1 permutations", "a permutation of the four points turns the orientation by its parity, in mixed frames too",
     permutations},
    {"R2 one frame",
     "where all points are under one pose, it changes nothing but the orientation, and that by sign(det M)", one_frame},
    {"R3 absorbed", "a motion done to the points beforehand, exactly, gives the same answer", absorbed},
    {"R4 grassmann-pluecker", "[abcd][abef] - [abce][abdf] + [abcf][abde] = 0 for the six signs", grassmann_pluecker},
    {"R5 swap", "a segment's ends may be swapped and a triangle's corners rotated", swap_ends},
    {"R6 motion", "a common permutation of the axes and translation gives the same answer", common_motion},
    {"R6 scale", "everything times a power of two gives the same answer", scaling},
    {"R7 split", "the whole is met exactly when one of its two halves is", split},
    {"R8 order", "corners of a tetrahedron, a cone or a triangle may stand in any order", order},
    {"R10 apex", "another origin of the covering gives the same place of the point", apex},
    {"R11 stages", "every stage of the adaptive kernel that decides a sign decides the exact one", stages},
    {"R13 monotone", "along a translation, orientation is monotone and convex sets meet in one stretch", monotone},
});

}  // namespace

std::span<const Predicate_level::Relation> predicate_relations() { return of_predicates; }

}  // namespace tetracone::verify
