#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/method_config.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/paper/placed_tree.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace tetracone {
namespace detail {

/// The tetra-tree of the body where it stands: the cone that holds a point names what can hold it.
class Point_locator {
 public:
  explicit Point_locator(std::shared_ptr<const Body_data> body)
      : body_(std::move(body)),
        tree_(body_->tetra_tree<kernel::Adaptive>(tree_name(options), config_of(options.method))),
        placed_(*tree_)
  {
    placed_.place(unmoved_);
  }

  Location locate(const kernel::Point<kernel::Adaptive>& point)
  {
    kernel::require_sound_floating_point();
    return placed_.locate(point);
  }

 private:
  static inline const Query_options options{.method = Method::tuned};

  std::shared_ptr<const Body_data> body_;
  std::shared_ptr<tetratree::Tetra_tree<kernel::Adaptive>> tree_;
  kernel::Pose unmoved_;
  tetratree::Placed_tree<kernel::Adaptive> placed_;
};

}  // namespace detail

namespace {

std::shared_ptr<const detail::Body_data> solid(const std::shared_ptr<const detail::Body_data>& body)
{
  detail::require_solid(*body, "body", "points inside or outside");
  return body;
}

[[noreturn]] void refuse(std::size_t coordinate, const std::string& is, const char* expected)
{
  throw Error(std::string("point: ") + "xyz"[coordinate] + " is " + is + "; expected " + expected);
}

}  // namespace

Point_query::Point_query(const Body& body) : locator_(std::make_unique<detail::Point_locator>(solid(body.data_))) {}

Point_query::~Point_query() = default;
Point_query::Point_query(Point_query&&) noexcept = default;
Point_query& Point_query::operator=(Point_query&&) noexcept = default;

detail::Point_locator& Point_query::locator() const
{
  if (!locator_) [[unlikely]]
    throw Error("query: moved from; expected one that still has its body");
  return *locator_;
}

Location Point_query::locate(const std::array<double, 3>& point)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (!std::isfinite(point[k])) refuse(k, kernel::shortest(point[k]), "a finite number");
  return locator().locate(kernel::Adaptive::unmoved(point));
}

Location Point_query::locate_text(const std::array<std::string, 3>& point)
{
  std::array<kernel::Rational, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = kernel::parse_number(point[k]);
    if (!number) refuse(k, "'" + point[k].substr(0, 40) + "'", "a finite decimal number or a fraction n/d");
    exact[k] = *number;
  }
  // The coordinate origin under an exact translation.
  const kernel::Pose translation(
      std::array<kernel::Rational, 12>{1, 0, 0, exact[0], 0, 1, 0, exact[1], 0, 0, 1, exact[2]});
  return locator().locate(kernel::Adaptive::placed({0, 0, 0}, translation));
}

}  // namespace tetracone
