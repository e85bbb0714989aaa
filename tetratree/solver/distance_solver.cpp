#include "tetracone/tetratree/door/distance_solver.h"

#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/nearest.h"
#include "tetracone/tetratree/query/bvh8_distance.h"

#include <array>

namespace tetracone::detail {
namespace {

using covering::Index;
using kernel::Rational;
using Exact_coordinates = std::array<Rational, 3>;

Exact_coordinates image_of(const kernel::Pose& pose, const kernel::Vertex& v)
{
  Exact_coordinates image;
  for (int i = 0; i < 3; ++i)
    image[i] = pose.exact(4 * i) * Rational(v[0]) + pose.exact(4 * i + 1) * Rational(v[1]) +
               pose.exact(4 * i + 2) * Rational(v[2]) + pose.exact(4 * i + 3);
  return image;
}

/// True when x is on the segment from p to q; false if p == q.
bool is_on_segment(const Exact_coordinates& x, const Exact_coordinates& p, const Exact_coordinates& q)
{
  const auto d = kernel::difference(q, p), r = kernel::difference(x, p);
  for (int k = 0; k < 3; ++k)
    if (d[k] * r[(k + 1) % 3] != d[(k + 1) % 3] * r[k]) return false;
  const Rational along = r[0] * d[0] + r[1] * d[1] + r[2] * d[2], length = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  return sgn(length) > 0 && sgn(along) >= 0 && along <= length;
}

}  // namespace

Holder holder_in(const Polyhedron& polyhedron, const kernel::Pose& pose, Index f, const Exact_coordinates& x)
{
  Holder holder{Holder::Kind::face, {f}};
  for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
    const auto loop = polyhedron.loop(f, l);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index from = loop[k], to = loop[k + 1 == loop.size() ? 0 : k + 1];
      const Exact_coordinates p = image_of(pose, polyhedron.vertices[from]);
      if (p == x) return {Holder::Kind::vertex, {from}};
      if (holder.kind == Holder::Kind::face && is_on_segment(x, p, image_of(pose, polyhedron.vertices[to])))
        holder = {Holder::Kind::edge, {from, to}};
    }
  }
  return holder;
}

namespace {

template <class K>
class Bvh8_distance_solver : public Distance_solver {
 public:
  Bvh8_distance_solver(const std::shared_ptr<const Body_data>& a, const std::shared_ptr<const Body_data>& b)
      : body_{a, b}, distance_(a->bvh8(), a->model<K>(), b->bvh8(), b->model<K>())
  {}

  double distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question) override
  {
    return distance_(pose_a, pose_b, question);
  }
  Nearest nearest(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question) override
  {
    if constexpr (tetratree::Bvh8_distance<K>::is_exact) {
      const tetratree::Nearest_pair found = distance_.nearest(pose_a, pose_b, question);
      Nearest nearest;
      nearest.distance = kernel::nearest_root(found.square);
      nearest.squared = kernel::to_string(found.square);
      for (int body = 0; body < 2; ++body) {
        for (int k = 0; k < 3; ++k) nearest.point[body][k] = kernel::to_string(found.point[body][k]);
        if (found.face[body])
          nearest.holder[body] =
              holder_in(body_[body]->polyhedron, body == 0 ? pose_a : pose_b, *found.face[body], found.point[body]);
      }
      return nearest;
    } else {
      throw Error("query: kernel double knows no exact points; expected adaptive or rational");
    }
  }
  bool within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, const Rational& limit) override
  {
    return distance_.within(pose_a, pose_b, question, limit);
  }
  std::vector<Index> zone(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                          const Rational& limit) override
  {
    if constexpr (tetratree::Bvh8_distance<K>::is_exact)
      return distance_.zone(pose_a, pose_b, question, limit);
    else
      throw Error("query: kernel double knows no exact zones; expected adaptive or rational");
  }
  Query_statistics statistics() const override { return distance_.counts(); }
  void clear_statistics() override { distance_.clear_counts(); }
  std::size_t bytes() const override { return distance_.bytes(); }

 private:
  std::array<std::shared_ptr<const Body_data>, 2> body_;
  tetratree::Bvh8_distance<K> distance_;
};

}  // namespace

std::unique_ptr<Distance_solver> distance_solver(const std::shared_ptr<const Body_data>& a,
                                                 const std::shared_ptr<const Body_data>& b, Kernel kernel)
{
  switch (kernel) {
    case Kernel::adaptive: return std::make_unique<Bvh8_distance_solver<kernel::Adaptive>>(a, b);
    case Kernel::double_: return std::make_unique<Bvh8_distance_solver<kernel::Double>>(a, b);
    case Kernel::rational: return std::make_unique<Bvh8_distance_solver<kernel::Rational_kernel>>(a, b);
    default: return nullptr;
  }
}

}  // namespace tetracone::detail
