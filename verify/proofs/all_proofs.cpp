#include "verify/proofs/all_proofs.h"

#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/bound_proofs.h"
#include "verify/proofs/distance_proofs.h"
#include "verify/proofs/frame_proofs.h"
#include "verify/proofs/gap_proofs.h"
#include "verify/proofs/margin_proofs.h"
#include "verify/proofs/motion_proofs.h"
#include "verify/proofs/obb8_distance_proofs.h"
#include "verify/proofs/obb8_proofs.h"
#include "verify/proofs/obb8_ray_proofs.h"
#include "verify/proofs/ray_proofs.h"
#include "verify/proofs/scene_proofs.h"
#include "verify/proofs/separation_proofs.h"

namespace tetracone::verify::proofs {

Proved_bounds all_proofs()
{
  Proved_bounds all;
  for (const auto& proofs :
       {adaptive_proofs, bound_proofs, frame_proofs, obb8_proofs, gap_proofs, obb8_distance_proofs, obb8_ray_proofs,
        separation_proofs, margin_proofs, distance_proofs, ray_proofs, motion_proofs, scene_proofs})
    for (const Proved_bound& bound : proofs()) all.push_back(bound);
  return all;
}

}  // namespace tetracone::verify::proofs
