#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/query/bvh8_rays.h"

#include <cmath>
#include <string>

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

}  // namespace

std::optional<Ray_hit> Body::first_hit(const Ray& ray) const { return rays_of(*data_).first(checked(ray)); }

std::vector<std::optional<Ray_hit>> Body::first_hits(std::span<const Ray> rays) const
{
  kernel::require_sound_floating_point();
  for (const Ray& ray : rays) checked(ray);
  return tetratree::Bvh8_rays::first_of_each(data_->bvh8(), rays);
}

std::vector<Ray_hit> Body::hits(const Ray& ray) const { return rays_of(*data_).all(checked(ray)); }

}  // namespace tetracone
