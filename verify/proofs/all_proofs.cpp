#include "verify/proofs/all_proofs.h"

#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/bound_proofs.h"
#include "verify/proofs/cone_proofs.h"
#include "verify/proofs/distance_proofs.h"
#include "verify/proofs/frame_proofs.h"
#include "verify/proofs/gap_proofs.h"
#include "verify/proofs/margin_proofs.h"
#include "verify/proofs/motion_proofs.h"
#include "verify/proofs/nearest_proofs.h"
#include "verify/proofs/obb8_distance_proofs.h"
#include "verify/proofs/obb8_proofs.h"
#include "verify/proofs/obb8_ray_proofs.h"
#include "verify/proofs/ray_proofs.h"
#include "verify/proofs/reference_proofs.h"
#include "verify/proofs/scene_proofs.h"
#include "verify/proofs/separation_proofs.h"

#include <string>
#include <utility>

namespace tetracone::verify::proofs {

Proved_bounds all_proofs()
{
  using Proofs = Proved_bounds (*)();
  // Each function is in the header of its name.
  static constexpr std::pair<const char*, Proofs> rooms[] = {{"adaptive_proofs", adaptive_proofs},
                                                             {"bound_proofs", bound_proofs},
                                                             {"frame_proofs", frame_proofs},
                                                             {"obb8_proofs", obb8_proofs},
                                                             {"gap_proofs", gap_proofs},
                                                             {"obb8_distance_proofs", obb8_distance_proofs},
                                                             {"obb8_ray_proofs", obb8_ray_proofs},
                                                             {"separation_proofs", separation_proofs},
                                                             {"margin_proofs", margin_proofs},
                                                             {"distance_proofs", distance_proofs},
                                                             {"nearest_proofs", nearest_proofs},
                                                             {"cone_proofs", cone_proofs},
                                                             {"ray_proofs", ray_proofs},
                                                             {"motion_proofs", motion_proofs},
                                                             {"reference_proofs", reference_proofs},
                                                             {"scene_proofs", scene_proofs}};
  Proved_bounds all;
  for (const auto& [name, proofs] : rooms)
    for (Proved_bound bound : proofs()) {
      bound.proof = std::string("verify/proofs/") + name + ".h";
      all.push_back(std::move(bound));
    }
  return all;
}

}  // namespace tetracone::verify::proofs
