#ifndef TETRACONE_COVERING_MODEL_H
#define TETRACONE_COVERING_MODEL_H

#include "tetracone/covering/covering.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/bound/cone_lattice.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/kernel/predicate/segment_face.h"

#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// A polyhedron as kernel K sees it: its covering, the origin O of the covering, and its vertices as points of K.
/// Requires every face planar (see `repair.h`), since the signs of a face assume it. Throws
/// kernel::Unsound_floating_point when K decides exactly and `kernel::require_exact_arithmetic` refuses.
template <class K>
class Model {
  /// An adaptive kernel's point is three times the size of a vertex, and is made from it by copying, so it is not kept.
  static constexpr bool keeps_points = !std::is_same_v<K, kernel::Adaptive>;

 public:
  /// A vertex as K sees it; a reference where points are kept.
  using Point = std::conditional_t<keeps_points, const kernel::Point<K>&, kernel::Point<K>>;

  /// Makes the model. `both` says whether two parts of the work may run at once, which does not change the result.
  explicit Model(const Polyhedron& polyhedron, const Both& both = {}) : Model(Parts(polyhedron, both)) {}

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const Covering& covering() const { return covering_; }
  /// Returns itself, as `Placed_model::model` returns its model.
  const Model& model() const { return *this; }
  std::size_t face_count() const { return face_count_; }

  /// Returns the lattice of directions about O, the origin of the covering and of all tetra-cones.
  const kernel::Cone_lattice& lattice() const { return lattice_; }
  /// Returns O as a point of K.
  const kernel::Point<K>& origin() const { return origin_; }

  /// Returns vertex v as K sees it.
  Point point(Index v) const
  {
    if constexpr (keeps_points)
      return points_[v];
    else
      return kernel::point<K>(vertices_[v]);
  }

 private:
  /// The members of a model; `both` makes two of them at once.
  struct Parts {
    std::vector<Vertex> vertices;
    std::optional<Covering> covering;
    std::size_t face_count;
    kernel::Cone_lattice lattice;

    Parts(const Polyhedron& polyhedron, const Both& both) : face_count(polyhedron.face_count())
    {
      both([&] { covering.emplace(polyhedron, both); }, [&] { see_vertices(polyhedron); });
    }

   private:
    void see_vertices(const Polyhedron& polyhedron)
    {
      vertices = polyhedron.vertices;
      lattice = kernel::cone_lattice(vertices);
    }
  };

  explicit Model(Parts parts)
      : vertices_(std::move(parts.vertices)),
        covering_(std::move(*parts.covering)),
        face_count_(parts.face_count),
        lattice_(parts.lattice),
        origin_(kernel::point<K>(lattice_.origin))
  {
    if constexpr (kernel::Kernel_traits<K>::exact_signs) kernel::require_exact_arithmetic();
    if constexpr (keeps_points) {
      points_.reserve(vertices_.size());
      for (const Vertex& v : vertices_) points_.push_back(kernel::point<K>(v));
    }
  }

  std::vector<Vertex> vertices_;
  Covering covering_;
  std::size_t face_count_;
  kernel::Cone_lattice lattice_;
  kernel::Point<K> origin_;
  std::vector<kernel::Point<K>> points_;
};

/// A model under a pose. A point is placed when it is first asked for under this pose. Memory is taken in blocks of 64
/// points, when one of a block is first asked for.
template <class K>
class Placed_model {
 public:
  using Point = kernel::Point<K>;

  explicit Placed_model(const Model<K>& model)
      : model_(&model), blocks_((model.vertices().size() + block_size - 1) / block_size)
  {}

  /// Moves the model. `pose` must outlive all use of this until the next call. Throws kernel::Unsound_floating_point
  /// when K decides exactly and floating point is not sound.
  void place(const kernel::Pose& pose)
  {
    if constexpr (kernel::Kernel_traits<K>::exact_signs) kernel::require_sound_floating_point();
    const bool was_identity = frame_.is_identity();
    frame_ = kernel::Frame<K>(pose);
    determinant_sign_ = pose.determinant_sign();
    if (!(was_identity && frame_.is_identity())) ++now_;
  }

  const Model<K>& model() const { return *model_; }
  const kernel::Frame<K>& frame() const { return frame_; }

  /// Returns the sign of det M of the pose: NEGATIVE reverses every tetrahedron.
  kernel::Sign determinant_sign() const { return determinant_sign_; }

  /// Returns vertex v, placed. The reference is valid as long as this; the next `place` may change the point.
  const Point& point(Index v)
  {
    std::unique_ptr<Block>& block = blocks_[v / block_size];
    if (!block) [[unlikely]]
      block = std::make_unique<Block>();
    const Index k = v % block_size;
    if (block->placed_at[k] != now_) place(v, *block, k);
    return block->point[k];
  }

 private:
  static constexpr bool keeps_images = std::is_same_v<K, kernel::Adaptive>;  // made when a sign asks for one
  static constexpr Index block_size = 64;

  /// Vertices of successive numbers.
  struct Block {
    std::array<Point, block_size> point;
    std::array<std::uint64_t, block_size> placed_at{};  ///< 0: never
    std::array<std::unique_ptr<kernel::Kept_images>, keeps_images ? block_size : 0> kept;
  };

  void place(Index v, Block& block, Index k)
  {
    if constexpr (keeps_images) {
      // In place: a copy would stall on store forwarding.
      ::new (&block.point[k]) Point(frame_(model_->vertices()[v]));
      if (block.kept[k]) block.kept[k]->clear();
      block.point[k].slot = &block.kept[k];
    } else {
      block.point[k] = frame_.is_identity() ? Point(model_->point(v)) : frame_(model_->point(v));
    }
    block.placed_at[k] = now_;
  }

  const Model<K>* model_;
  kernel::Frame<K> frame_{kernel::Pose()};
  kernel::Sign determinant_sign_ = kernel::POSITIVE;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::uint64_t now_ = 1;
};

/// A face of a body as `kernel::segment_face` takes it. The body is a model where it stands, or a placed model. It must
/// outlive the face.
template <class Body>
class Body_face {
 public:
  Body_face(Body& body, Index face) : body_(body), face_(face), basis_(covering().plane_basis(face)) {}

  std::size_t edge_count() const { return covering().from(face_).size(); }
  decltype(auto) from(std::size_t k) const { return body_.point(covering().from(face_)[k]); }
  decltype(auto) to(std::size_t k) const { return body_.point(covering().to(face_)[k]); }
  decltype(auto) origin() const { return from(0); }
  bool is_degenerate() const { return !basis_; }
  decltype(auto) plane_basis(int k) const { return body_.point((*basis_)[k]); }

 private:
  const Covering& covering() const { return body_.model().covering(); }

  Body& body_;
  Index face_;
  std::optional<std::array<Index, 3>> basis_;
};

template <class K>
using Placed_face = Body_face<Placed_model<K>>;
template <class K>
using Model_face = Body_face<const Model<K>>;

/// Returns how the closed segment pq and face `f` of a placed model meet, as `kernel::segment_face` does.
template <class K>
kernel::Contact segment_face(const kernel::Point<K>& p, const kernel::Point<K>& q, Placed_model<K>& body, Index f)
{
  const auto corners = body.model().covering().from(f);
  if (corners.size() == 3)
    return kernel::segment_triangle<K>(p, q, body.point(corners[0]), body.point(corners[1]), body.point(corners[2]));
  return kernel::segment_face<K>(p, q, Placed_face<K>(body, f));
}

}  // namespace tetracone::covering

#endif
