#include "verify/searches/searches.h"

#include <random>

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
  const std::string counted = "counts roundings, each taken in full",
                    one = "one rounding of each coordinate, taken in full",
                    whole = "holds for all inputs of such magnitudes, which are not all reached at once",
                    length = "a length or a defect, which no rounding adds to";
  static const std::map<std::string, std::string> reasons = {
      {"Cone_cells::wide_margin", whole},
      {"Cone_cells::lattice_margin", whole},
      {"Cone_cells::widening", whole},
      {"Cone_cells::near_side", whole},
      {"Cone_cells::norm_margin", whole},
      {"Cone_cells::plane_margin", whole},
      {"Cone_slab::margin", whole},
      {"Cone_probe::sheared_error", whole},
      {"Cone_probe::turn_bound, over sheared_error", whole},
      {"Cone_probe::height_error", whole},
      {"Cone_probe::plane_factor", whole},
      {"Cone_probe::height_rounding", whole},
      {"Local_facet::normal_error", whole},
      {"Local_facet::offset_error", whole},
      {"local_error", whole},
      {"Bvh8_elements::local_error", whole},
      {"slacks_of_sweep", counted},
      {"Front_entries::shrink, taken from 1", counted},
      {"Bvh8_front::leaf_gap_rounding", counted},
      {"Motion_span::rounding_of_times", counted},
      {"Ray_triangle::time_rounding", counted},
      {"turned_radius_rounding", counted},
      {"turned_extent_rounding", counted},
      {"turned_reach_rounding", counted},
      {"slack_of_direction", counted},
      {"Common_frame::image_rounding", counted},
      {"Common_frame::way_rounding", counted},
      {"Common_frame::sum_rounding", counted},
      {"Common_frame::entry_rounding", counted},
      {"row_rounding of least_stretch", counted},
      {"root_rounding of least_stretch", counted},
      {"quotient_rounding of least_stretch", counted},
      {"Bvh8_distance::limit_rounding", counted},
      {"Bvh8_distance::distance_rounding", counted},
      {"Double_double_ball::high_rounding", counted},
      {"Enclosed_distance::direction_error", counted},
      {"triangle_distance::point_rounding, of directions", counted},
      {"Bvh8_front::stretch_loss", length},
      {"Span_reference::errors_along", length},
      {"Span_reference::direction_error", length},
      {"Span_reference::most_local", length},
      {"row_of_similarity", length},
      {"least_speed, one over it", "as box_underflow"},
      {"motion_underflow", "as box_underflow"},
      {"Common_frame::underflow", "as box_underflow"},
      {"Bvh8_distance::smallest", "as box_underflow"},
      {"Bvh8_distance::most_unseen", "as box_underflow"},
      {"Support_table::slack", "its reaches are rounded up, by more than a search finds beside them"},
      {"Relative_frame::second_order", "of second order: what it adds to 1 is below the first order's own rounding"},
      {"few_roundings", counted},
      {"few_roundings, of moving boxes", counted},
      {"few_roundings, of moving points", counted},
      {"time_rounding", counted},
      {"rounded_up", counted},
      {"radius_rounding", counted},
      {"distance_shrink", counted},
      {"Local_ray::error",
       "its directions are over roots, which are no rationals: the test of obb8_ray.h looks at boxes"},
      {"Local_ray::slack", "a sum of errors that are not all reached at once: the test of obb8_ray.h looks at boxes"},
      {"Ray_triangle::quotient_rounding", counted},
      {"Double_double_ball::sum_rounding", "as double_double_difference"},
      {"Double_double_ball::product_rounding", "a product's own, of double-double"},
      {"Double_double_ball::of_radii", counted},
      {"Double_double_ball::underflow", "as box_underflow"},
      {"motion_filter::cross_error", counted},
      {"motion_filter::sum_error", counted},
      {"motion_filter::volume_error", counted},
      {"motion_filter::rounded_error", counted},
      {"Time_root::value_error", counted},
      {"Carried_box::centre_rounding", one},
      {"Carried_box::edge_rounding", counted},
      {"Carrier::rate_rounding", counted},
      {"motion_rounding", counted},
      {"Placement::position_norm", "as position_factor"},
      {"placed_rounding, of a turned box's centre", "as placed_rounding, of steps"},
      {"step_rounding", counted},
      {"step_rounding, of reaches in halves", counted},
      {"entry_underflow, over 2^-1075", "as box_underflow"},
      {"placed_underflow", "as box_underflow"},
      {"Placed_half_space::entry_underflow, over 2^-1075", "as box_underflow"},
      {"between_rounding", counted},
      {"between_underflow", "as box_underflow"},
      {"certificate_rounding", counted},
      {"sum_rounding, of certificates", counted},
      {"body_box_rounding, of places", counted},
      {"body_box_rounding, of the box's numbers", counted},
      {"body_box_rounding, of what has turned", counted},
      {"turned_rounding", one},
      {"turned_centre_rounding", one},
      {"axis_defect, of turned boxes", one},
      {"bound_box_defect in bound_box", "as axis_defect_factor"},
      {"box_underflow", "underflow comes where no rounding of these sizes is seen"},
      {"apex_tolerance", "every apex is checked when it is stored"},
      {"Regular_hull::normal_rounding", "every cone of its levels is enclosed instead"},
      {"Cone_coordinates::height_rounding", "every cone to the hull's depth is enclosed instead"}};
  const auto reason = reasons.find(name);
  return reason == reasons.end() ? "" : reason->second;
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
