#include "tetracone/tetratree/door/distance_solver.h"

#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/nearest.h"
#include "tetracone/tetratree/query/bvh8_distance.h"

#include <array>

namespace tetracone::detail {

using covering::Index;
using kernel::Rational;
using kernel::Rational_point;

Holder holder_in(const Polyhedron& polyhedron, const kernel::Pose& pose, Index f, const Rational_point& x)
{
  const std::array<Rational, 12> rows = kernel::rows_of(pose);
  Holder holder{Holder::Kind::face, {f}};
  for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
    const auto loop = polyhedron.loop(f, l);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index from = loop[k], to = loop[k + 1 == loop.size() ? 0 : k + 1];
      const Rational_point p = kernel::image(polyhedron.vertices[from], rows);
      if (p == x) return {Holder::Kind::vertex, {from}};
      if (holder.kind == Holder::Kind::face &&
          kernel::is_inside_segment(x, p, kernel::image(polyhedron.vertices[to], rows)))
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
