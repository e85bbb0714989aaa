(** The checks as OCaml, on zarith's integers. Run by build.sh in the folder that gets core.ml. *)
Require Import ZArith Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
From Certificates Require Import Space Exact Faces Cuts Covers Claims Placed Rays Forms Motions.

(** Comparisons of zarith: beside the standard library's maps, for speed. *)
Extract Constant Z.leb => "Big_int_Z.le_big_int".
Extract Constant Z.ltb => "Big_int_Z.lt_big_int".

Extraction "core.ml" zdot zdet zcross zminus seen zplace unit_at place_face edges check_cut check_body is_closed check_holds
  place_body gap_at_place winding_at_place shells_at_place check_plane check_ray check_motion line rigid.
