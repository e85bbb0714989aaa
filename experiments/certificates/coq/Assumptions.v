(** What the theorems rest on: nothing but Coq, each time "Closed under the global context". *)
From Certificates Require Import Space Exact Faces Cuts Covers Claims Placed Rays Forms Motions Unique.

Print Assumptions witness_is_common.
Print Assumptions cover_proves_apart.
Print Assumptions cover_shows_distance.
Print Assumptions plane_is_between.
Print Assumptions ray_sum_is_winding.
Print Assumptions solids_apart.
Print Assumptions shells_sound.
Print Assumptions ray_misses.
Print Assumptions ray_is_free.
Print Assumptions motion_is_free.
Print Assumptions line_is.
Print Assumptions rigid_is.
Print Assumptions winding_is_unique.
Print Assumptions inside_is_decided.
Print Assumptions gap_at_place_is.
Print Assumptions winding_at_place_is.
Print Assumptions shells_at_place_is.
