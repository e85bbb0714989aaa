#include "tetracone/covering/edge_uses.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/query/bvh8_rays.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tetracone {
namespace {

tetratree::Bvh8_rays rays_of(const detail::Body_data& data)
{
  kernel::require_sound_floating_point();
  return tetratree::Bvh8_rays(data.bvh8());
}

const Ray& checked(const Ray& ray)
{
  for (int k = 0; k < 6; ++k) {
    const double x = k < 3 ? ray.origin[k] : ray.direction[k - 3];
    if (!std::isfinite(x)) [[unlikely]]
      throw Error("ray: number " + std::to_string(k + 1) + " of 6 is " + kernel::shortest(x) +
                  "; expected a finite number");
  }
  if (ray.direction == std::array<double, 3>{0, 0, 0}) [[unlikely]]
    throw Error("ray: the direction is 0; expected one of any other length");
  return ray;
}

double checked(double end)
{
  if (std::isnan(end)) [[unlikely]]
    throw Error("ray: the end is nan; expected a number");
  return end;
}

}  // namespace

/// The sum of the cross products of a face's loops is twice the area times the unit normal.
kernel::Rational_point detail::exact_normal(const Polyhedron& polyhedron, Index face)
{
  if (face >= polyhedron.face_count())
    throw Error("body: face " + std::to_string(face) + " of " + std::to_string(polyhedron.face_count()) +
                "; expected a face's number");
  const auto exact = [&](Index v) { return kernel::exact_point(polyhedron.vertices[v]); };
  const kernel::Rational_point origin = exact(polyhedron.loop(face, 0)[0]);
  kernel::Rational_point normal;
  covering::for_each_directed_edge(polyhedron, face, [&](Index from, Index to) {
    const auto part = kernel::cross(kernel::difference(exact(from), origin), kernel::difference(exact(to), origin));
    for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
  });
  return normal;
}

std::optional<Ray_hit> Body::first_hit(const Ray& ray) const { return rays_of(*data_).first(checked(ray)); }

std::optional<Ray_hit> Body::first_hit(const Ray& ray, double end) const
{
  return rays_of(*data_).first(checked(ray), checked(end));
}

bool Body::is_hit(const Ray& ray, double end) const { return rays_of(*data_).any(checked(ray), checked(end)); }

Crossing Body::crossing(const Ray& ray, Index face) const
{
  kernel::require_sound_floating_point();
  const kernel::Rational_point direction = kernel::exact_point(checked(ray).direction);
  const int sign = sgn(kernel::dot(detail::exact_normal(data_->polyhedron, face), direction));
  return sign < 0 ? Crossing::entering : sign > 0 ? Crossing::leaving : Crossing::along;
}

std::array<double, 3> Body::normal(Index face) const
{
  kernel::require_sound_floating_point();
  const kernel::Rational_point exact = detail::exact_normal(data_->polyhedron, face);
  const kernel::Rational square = kernel::dot(exact, exact);
  std::array<double, 3> normal{};
  if (sgn(square) == 0) return normal;
  for (std::size_t k = 0; k < 3; ++k)
    normal[k] = sgn(exact[k]) * kernel::nearest_root(kernel::Rational(exact[k] * exact[k] / square));
  return normal;
}

std::vector<std::optional<Ray_hit>> Body::first_hits(std::span<const Ray> rays) const
{
  kernel::require_sound_floating_point();
  for (const Ray& ray : rays) checked(ray);
  return tetratree::Bvh8_rays::first_of_each(data_->bvh8(), rays);
}

std::vector<Ray_hit> Body::hits(const Ray& ray) const { return rays_of(*data_).all(checked(ray)); }

std::vector<Ray_hit> Body::hits(const Ray& ray, double end) const
{
  return rays_of(*data_).all(checked(ray), checked(end));
}

}  // namespace tetracone
