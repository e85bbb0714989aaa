#include "tetracone/tetratree/door/motion.h"

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/motion_solver.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <cmath>
#include <string>
#include <utility>

namespace tetracone {
namespace {

using kernel::Rational;

kernel::Rigid_pose rigid_pose(const std::array<Rational, 7>& numbers)
{
  return {{numbers[0], numbers[1], numbers[2], numbers[3]}, {numbers[4], numbers[5], numbers[6]}};
}

Rational number(const std::string& text) { return kernel::required_number(text, "motion: "); }

Motion rigid_motion(const std::array<Rational, 7>& from, const std::array<Rational, 7>& to)
{
  auto motion = kernel::Body_motion::rigid(rigid_pose(from), rigid_pose(to));
  if (!motion)
    throw Error(
        "motion: the quaternion (1-t) q0 + t q1 is 0 at some t; expected q0, q1 and all between them to be none");
  return Motion(std::move(*motion));
}

Holder vertex(covering::Index v) { return {Holder::Kind::vertex, {v}}; }
Holder edge(covering::Index from, covering::Index to)
{
  return from == to ? vertex(from) : Holder{Holder::Kind::edge, {from, to}};
}

std::array<Holder, 2> holders(const tetratree::Moving_features& found)
{
  const auto& v = found.corner;
  if (found.kind == kernel::Moving_kind::edge_edge) return {edge(v[0], v[1]), edge(v[2], v[3])};
  std::array<Holder, 2> both;
  both[found.body] = vertex(v[0]);
  both[1 - found.body] = {Holder::Kind::face, {found.face[1 - found.body]}};
  return both;
}

}  // namespace

void detail::require_motion_kernel(const Query_options& options)
{
  if (options.kernel != Kernel::adaptive)
    throw Error("query: kernel " + kernel_name(options.kernel, options.tolerance) +
                " follows no motion; expected adaptive");
}

Motion::Motion(kernel::Body_motion motion) : exact_(std::make_shared<const kernel::Body_motion>(std::move(motion))) {}

Motion Motion::linear(const Pose& from, const Pose& to)
{
  kernel::require_sound_floating_point();
  return Motion(kernel::Body_motion::linear(from.exact(), to.exact()));
}

Motion Motion::rigid(const std::array<double, 7>& from, const std::array<double, 7>& to)
{
  std::array<std::array<Rational, 7>, 2> exact;
  kernel::require_sound_floating_point();
  for (std::size_t k = 0; k < 7; ++k) {
    for (const double x : {from[k], to[k]})
      if (!std::isfinite(x)) number(kernel::shortest(x));  // refuses it
    exact[0][k] = from[k];
    exact[1][k] = to[k];
  }
  return rigid_motion(exact[0], exact[1]);
}

Motion Motion::rigid_from_text(const std::array<std::string, 7>& from, const std::array<std::string, 7>& to)
{
  std::array<std::array<Rational, 7>, 2> exact;
  for (std::size_t k = 0; k < 7; ++k) {
    exact[0][k] = number(from[k]);
    exact[1][k] = number(to[k]);
  }
  return rigid_motion(exact[0], exact[1]);
}

std::optional<First_contact> Query::first_contact(const Motion& a, const Motion& b)
{
  detail::Query_data& d = data();
  detail::require_motion_kernel(d.options);
  if (!d.motion) d.motion = std::make_unique<detail::Motion_solver>(d.a, d.b);
  const auto meet_at_start = [&] {
    return d.solver->relation(a.exact().at(0), b.exact().at(0), d.question, nullptr) != Relation::apart;
  };
  // Under `Question::surface` the search of the motion mostly shows that the bodies are apart at its start. The start
  // is asked first where that search is costly to begin, and where it was needless the last time.
  const bool is_start_first = d.question == Question::solid || !a.exact().ends() || !b.exact().ends() ||
                              std::exchange(d.motion->began_in_contact, false);
  tetratree::Meeting found;
  if (is_start_first && meet_at_start())
    found.is_at_start = true;
  else if (is_start_first)
    found.first = d.motion->motion(a.exact(), b.exact());
  else
    found = d.motion->motion(a.exact(), b.exact(), meet_at_start);
  d.motion->began_in_contact = found.is_at_start;
  if (found.is_at_start) return First_contact{0, 0, std::nullopt};
  if (!found.first) return std::nullopt;
  const auto [lo, hi] = kernel::bounds_about(found.first->time);
  return First_contact{lo, hi, holders(found.first->features)};
}

}  // namespace tetracone
