#ifndef TETRACONE_KERNEL_PREDICATE_FRAME_H
#define TETRACONE_KERNEL_PREDICATE_FRAME_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/kernel/predicate/signs.h"

#include <array>

namespace tetracone::kernel {

/// Returns a vertex as a point of K. It is exact in every kernel except float, which rounds it.
template <class K>
Point<K> point(const Vertex& vertex)
{
  using Number = typename K::FT;
  return Point<K>(Number(vertex[0]), Number(vertex[1]), Number(vertex[2]));
}
template <>
inline Point<Adaptive> point<Adaptive>(const Vertex& vertex)
{
  return Adaptive::unmoved(vertex);
}
template <>
inline Point<Float> point<Float>(const Vertex& vertex)
{
  return {static_cast<float>(vertex[0]), static_cast<float>(vertex[1]), static_cast<float>(vertex[2])};
}

/// A pose as kernel K applies it (see `Pose`). Entries and images are in K's number type, and are rounded where K
/// rounds. The identity returns every point unchanged.
template <class K>
class Frame {
 public:
  /// The frame of a pose, which must outlive the frame and the points it places.
  explicit Frame(const Pose& pose) : identity_(pose.is_identity())
  {
    for (int k = 0; k < 12; ++k) {
      if constexpr (std::is_same_v<K, Rational_kernel> || std::is_same_v<K, Epeck>)
        entries_[k] = Number(pose.exact(k));
      else
        entries_[k] = static_cast<Number>(pose[k]);
    }
  }

  Point<K> operator()(const Point<K>& p) const
  {
    if (identity_) return p;
    const auto& m = entries_;
    return Point<K>(m[0] * p.x() + m[1] * p.y() + m[2] * p.z() + m[3],
                    m[4] * p.x() + m[5] * p.y() + m[6] * p.z() + m[7],
                    m[8] * p.x() + m[9] * p.y() + m[10] * p.z() + m[11]);
  }

  bool is_identity() const { return identity_; }

 private:
  using Number = typename K::FT;
  std::array<Number, 12> entries_;
  bool identity_;
};

template <>
class Frame<Adaptive> {
 public:
  explicit Frame(const Pose& pose) : pose_(&pose), identity_(pose.is_identity()) {}

  Point<Adaptive> operator()(const Point<Adaptive>& p) const
  {
    return identity_ ? p : Adaptive::placed(p.vertex, *pose_);
  }
  Point<Adaptive> operator()(const Vertex& vertex) const
  {
    return identity_ ? Adaptive::unmoved(vertex) : Adaptive::placed(vertex, *pose_);
  }

  bool is_identity() const { return identity_; }

 private:
  const Pose* pose_;
  bool identity_;
};

}  // namespace tetracone::kernel

#endif
