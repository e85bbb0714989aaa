#include "verify/searches/searches.h"

#include <random>
#include <set>

namespace tetracone::verify::proofs {
namespace {

const Searches& searches()
{
  static const Searches all = [] {
    Searches found;
    for (const auto& part :
         {adaptive_searches, bound_searches, frame_searches, box_searches, distance_searches, ray_searches})
      found.merge(part());
    return found;
  }();
  return all;
}

}  // namespace

std::string why_not_searched(const std::string& name)
{
  struct Reason {
    const char* text;
    std::set<std::string> names;
  };
  static const std::vector<Reason> reasons = {
      {"holds for all inputs of such magnitudes, which are not all reached at once",
       {"Cone_cells::wide_margin", "Cone_cells::lattice_margin", "Cone_cells::widening", "Cone_cells::near_side",
        "Cone_cells::norm_margin", "Cone_cells::plane_margin", "Cone_slab::margin", "Cone_probe::sheared_error",
        "Cone_probe::turn_bound, over sheared_error", "Cone_probe::height_error", "Cone_probe::plane_factor",
        "Cone_probe::height_rounding", "Local_facet::normal_error", "Local_facet::offset_error", "local_error",
        "Bvh8_elements::local_error"}},
      {"counts roundings, each taken in full",
       {"slacks_of_sweep",
        "Front_entries::shrink, taken from 1",
        "Bvh8_front::leaf_gap_rounding",
        "Motion_span::rounding_of_times",
        "Ray_triangle::time_rounding",
        "turned_radius_rounding",
        "turned_extent_rounding",
        "turned_reach_rounding",
        "slack_of_direction",
        "Common_frame::image_rounding",
        "Common_frame::way_rounding",
        "Common_frame::sum_rounding",
        "Common_frame::entry_rounding",
        "row_rounding of least_stretch",
        "root_rounding of least_stretch",
        "quotient_rounding of least_stretch",
        "Bvh8_distance::limit_rounding",
        "Bvh8_distance::distance_rounding",
        "Double_double_ball::high_rounding",
        "Double_double_ball::quotient_rounding",
        "Double_double_ball::of_quotients, less 1",
        "Double_double_ball::step_rounding",
        "Double_double_ball::of_steps, less 1",
        "Enclosed_distance::side_rounding",
        "Enclosed_distance::direction_error",
        "triangle_distance::point_rounding, of directions",
        "few_roundings",
        "few_roundings, of moving boxes",
        "few_roundings, of moving points",
        "time_rounding",
        "rounded_up",
        "radius_rounding",
        "distance_shrink",
        "Ray_triangle::quotient_rounding",
        "Double_double_ball::of_radii",
        "motion_filter::cross_error",
        "motion_filter::sum_error",
        "motion_filter::volume_error",
        "motion_filter::rounded_error",
        "Time_root::value_error",
        "Carried_box::edge_rounding",
        "Carrier::rate_rounding",
        "motion_rounding",
        "step_rounding",
        "step_rounding, of reaches in halves",
        "between_rounding",
        "certificate_rounding",
        "sum_rounding, of certificates",
        "body_box_rounding, of places",
        "body_box_rounding, of the box's numbers",
        "body_box_rounding, of what has turned"}},
      {"a length or a defect, which no rounding adds to",
       {"Bvh8_front::stretch_loss", "Span_reference::errors_along", "Span_reference::direction_error",
        "Span_reference::most_local", "row_of_similarity"}},
      {"as box_underflow",
       {"least_speed, one over it", "motion_underflow", "Common_frame::underflow", "Bvh8_distance::smallest",
        "Bvh8_distance::most_unseen", "Double_double_ball::underflow", "entry_underflow, over 2^-1075",
        "placed_underflow", "Placed_half_space::entry_underflow, over 2^-1075", "between_underflow"}},
      {"its reaches are rounded up, by more than a search finds beside them", {"Support_table::slack"}},
      {"of second order: what it adds to 1 is below the first order's own rounding", {"Relative_frame::second_order"}},
      {"its directions are over roots, which are no rationals: the test of obb8_ray.h looks at boxes",
       {"Local_ray::error"}},
      {"a sum of errors that are not all reached at once: the test of obb8_ray.h looks at boxes", {"Local_ray::slack"}},
      {"as double_double_difference", {"Double_double_ball::sum_rounding"}},
      {"a product's own, of double-double", {"Double_double_ball::product_rounding"}},
      {"one rounding of each coordinate, taken in full",
       {"Carried_box::centre_rounding", "turned_rounding", "turned_centre_rounding", "axis_defect, of turned boxes"}},
      {"as position_factor", {"Placement::position_norm"}},
      {"as placed_rounding, of steps", {"placed_rounding, of a turned box's centre"}},
      {"as axis_defect_factor", {"bound_box_defect in bound_box"}},
      {"underflow comes where no rounding of these sizes is seen", {"box_underflow"}},
      {"every apex is checked when it is stored", {"apex_tolerance"}},
      {"every cone of its levels is enclosed instead", {"Regular_hull::normal_rounding"}},
      {"every cone to the hull's depth is enclosed instead", {"Cone_coordinates::height_rounding"}},
  };
  for (const auto& [text, names] : reasons)
    if (names.contains(name)) return text;
  return "";
}

double worst_found(const std::string& name, int steps, unsigned seed)
{
  const auto search = searches().find(name);
  if (search == searches().end()) return -1;
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return double(random() >> 11) * 0x1p-52 - 1; };
  const auto start = [&] {
    Inputs in(search->second.inputs);
    for (double& x : in) x = uniform();
    return in;
  };
  // Relative errors are largest near 1; a step changes one number by ulps or draws it anew.
  Inputs best = start();
  double worst = search->second.share(best), all = worst;
  for (int step = 0, since = 0; step < steps; ++step, ++since) {
    if (since > 2000) {
      best = start();
      worst = search->second.share(best);
      since = 0;
    }
    Inputs next = best;
    for (int change = 0; change < 1 + int(random() % 2); ++change) {
      double& x = next[random() % next.size()];
      switch (random() % 4) {
        case 0: x = uniform(); break;
        case 1: x = std::copysign(1 + uniform() * 0x1p-30, uniform()); break;
        case 2: x *= 1 + uniform() * 0x1p-40; break;
        default: x = std::nextafter(x, random() % 2 == 0 ? 2 : -2);
      }
    }
    const double share = search->second.share(next);
    if (share >= worst) {
      if (share > worst) since = 0;
      worst = share;
      best = next;
      all = std::max(all, worst);
    }
  }
  return all;
}

}  // namespace tetracone::verify::proofs
