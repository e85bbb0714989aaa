#ifndef TETRACONE_TETRATREE_CERTIFICATE_PLACED_PAIR_H
#define TETRACONE_TETRATREE_CERTIFICATE_PLACED_PAIR_H

#include "tetracone/kernel/number/error.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/certificate/proof_text.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace tetracone::tetratree {

/// Throws Error for an answer that is not proved.
[[noreturn]] inline void fail_proof(const std::string& what) { throw Error("certificate: " + what); }

/// Returns a pose of these rows. Throws No_proof for an entry beyond the doubles.
inline kernel::Pose finite_pose(const std::array<kernel::Rational, 12>& rows)
{
  for (const kernel::Rational& entry : rows)
    if (!std::isfinite(kernel::nearest_double(entry))) throw No_proof{};
  return kernel::Pose(rows);
}

/// Returns the pose, and a translation after it. Throws as `finite_pose`.
inline kernel::Pose shifted(const kernel::Pose& pose, const kernel::Rational_point& by)
{
  std::array<kernel::Rational, 12> rows = kernel::rows_of(pose);
  for (std::size_t k = 0; k < 3; ++k) rows[4 * k + 3] += by[k];
  return finite_pose(rows);
}

/// Pseudo-random integers that a search for a proof tries. Every object gives the same ones.
class Random_integers {
 public:
  /// Returns an integer from -2^(bits - 1) to 2^(bits - 1) - 1.
  double operator()(int bits)
  {
    state_ = state_ * 1664525u + 1013904223u;  // Numerical Recipes' generator
    return double(state_ >> (32 - bits)) - std::ldexp(0.5, bits);
  }

 private:
  std::uint32_t state_ = 1;
};

/// Returns a body at `pose`, with its coordinates multiplied by `weight` and by the weights of both poses. `other` is
/// the pose of the other body.
inline Covered_body placed(Group_tree& groups, const kernel::Pose& pose, const kernel::Pose& other,
                           const kernel::Exact_number& weight)
{
  const auto& vertices = groups.tree().model().vertices();
  kernel::Exact_number by = weight;
  if (other.is_rational()) by = by * other.weight();
  std::array<kernel::Exact_number, 12> entry;
  for (int k = 0; k < 12; ++k) entry[k] = pose.whole(k) * by;
  return {&groups, kernel::Hull_points(vertices, groups.reach(), entry)};
}

/// Two placed bodies on one scale, A first. Their coordinates are relative to a point, the origin.
struct Placed_pair {
  using Poses = std::array<kernel::Pose, 2>;

  std::array<Covered_body, 2> body;
  Poses pose;                     ///< relative to the origin
  kernel::Rational_point origin;  ///< where proofs write points and poses, it is added to them
  kernel::Exact_number weight;    ///< the factor of all coordinates
  kernel::Exact_number rounding;  ///< a further factor of the rounded ones
  Random_integers random;         ///< for searches with this pair

  /// The bodies at these poses, which are relative to `about`. The groups must outlive this object.
  Placed_pair(const std::array<Group_tree*, 2>& groups, const Poses& poses, kernel::Rational_point about = {})
      : body{placed(*groups[0], poses[0], poses[1], 1), placed(*groups[1], poses[1], poses[0], 1)},
        pose(poses),
        origin(std::move(about)),
        weight(poses[0].weight() * poses[1].weight()),
        rounding(kernel::round_together(body[0].points, body[1].points))
  {}

  std::array<Group_tree*, 2> groups() const { return {body[0].groups, body[1].groups}; }
  /// Returns the bodies at other poses, relative to the same origin.
  Placed_pair at(const Poses& poses) const { return {groups(), poses, origin}; }

  /// Return a point, and a pose, as proofs write them.
  kernel::Rational_point written(const kernel::Rational_point& x) const { return kernel::sum(x, origin); }
  kernel::Pose written(const kernel::Pose& relative) const { return shifted(relative, origin); }

  /// Returns the faces of the file of which the pieces are parts.
  std::array<Index, 2> source_faces(const std::array<Box_id, 2>& piece) const
  {
    return {body[0].groups->source_face(piece[0]), body[1].groups->source_face(piece[1])};
  }

  /// Returns two pieces as faces.
  std::array<kernel::Exact_face, 2> faces(const std::array<Box_id, 2>& piece)
  {
    return {body[0].face(piece[0]), body[1].face(piece[1])};
  }

  /// Returns a point that two pieces share; nothing where they share none.
  std::optional<Common_point> common(const std::array<Box_id, 2>& piece)
  {
    const auto face = faces(piece);
    const kernel::Exact_distance found = kernel::distance_of_faces(face[0], face[1]);
    if (!found.is_zero()) return std::nullopt;
    return Common_point{piece, found.on_a};
  }
};

/// Appends a common point as a witness.
inline void add_common(std::string& text, const Placed_pair& pair, const Common_point& common)
{
  const kernel::Rational_point x = pair.written(rational(common.point, pair.weight));
  add_witness(text, {x, x}, pair.source_faces(common.piece));
}

/// Appends a cover of the pair and returns nothing, or appends a witness and returns a point that the surfaces share.
/// `preferred` is a direction to try first. Throws No_proof, and Error for faces that are apart but break
/// the rule.
inline std::optional<Common_point> cover_or_meet(std::string& text, Placed_pair& pair,
                                                 const kernel::Gap_rule& rule = {},
                                                 const std::optional<kernel::Exact_vector>& preferred = {})
{
  Pair_cover cover(pair.body[0], pair.body[1], rule);
  if (preferred) cover.prefer(*preferred);
  if (cover()) {
    add_cover(text, cover.cover());
    return std::nullopt;
  }
  if (!cover.common()) fail_proof("two faces are nearer than the answer");
  add_common(text, pair, *cover.common());
  return cover.common();
}

}  // namespace tetracone::tetratree

#endif
