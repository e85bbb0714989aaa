(** The checks of Claims.v, with the pieces of a body placed once for all of them. *)
Require Import List ZArith QArith.
From Certificates Require Import Space Exact Faces Covers Claims.
Import ListNotations.

Record placed_body := Placed { at_pose : zpose; of_body : zbody; placed_pieces : group zface; placed_corners : group (list grid) }.

Definition place_body (m : zpose) (b : zbody) : placed_body :=
  let pieces := place_pieces m b in Placed m b pieces (map_group (@concat grid) pieces).

Definition unit_of (x : placed_body) : positive := unit_at (at_pose x) (of_body x).

Definition gap_at_place (n : Z) (d : positive) (strictly : bool) (a b : placed_body) (c : cover) : bool :=
  covers (gap_leaf n d strictly (unit_of a) (unit_of b)) c no_time no_time (placed_corners a) (placed_corners b).

Definition winding_at_place (up : positive) (p d : grid) (b : placed_body) (c : passage) : option Z :=
  if is_zero d then None else passages (winding_leaf up p d (unit_of b)) c (placed_pieces b).

Definition shells_at_place (inside : bool) (a b : placed_body) (rays : list corner_ray) (steps : list (positive * link)) : bool :=
  forallb (fun c => match winding_at_place (unit_of a) (zplace (at_pose a) (unit (of_body a)) (corner c)) (ray c) b (proof c) with
                    | Some w => Bool.eqb inside (negb (w =? 0)%Z)
                    | None => false
                    end) rays &&
  check_links (of_body a) (map corner rays) steps.

Fixpoint map_group_map {P R S} (f : P -> R) (g : R -> S) (h : P -> S) (same_map : forall x, g (f x) = h x) (t : group P) {struct t} :
  map_group g (map_group f t) = map_group h t.
Proof.
  destruct t as [k p|members]; simpl; [rewrite same_map; reflexivity|]. f_equal.
  induction members as [|m members IH]; [reflexivity|]. simpl. rewrite (map_group_map _ _ _ f g h same_map), IH. reflexivity.
Qed.

Lemma placed_corners_are m b : placed_corners (place_body m b) = place_corners m b.
Proof. apply map_group_map. intros f. unfold place_face. symmetry. apply concat_map. Qed.

Theorem gap_at_place_is n d strictly ma a mb b c : gap_at_place n d strictly (place_body ma a) (place_body mb b) c = check_gap n d strictly ma a mb b c.
Proof. unfold gap_at_place, check_gap. rewrite !placed_corners_are. reflexivity. Qed.

Theorem winding_at_place_is up p d m b c : winding_at_place up p d (place_body m b) c = check_winding up p d m b c.
Proof. reflexivity. Qed.

Theorem shells_at_place_is inside ma a mb b rays steps :
  shells_at_place inside (place_body ma a) (place_body mb b) rays steps = check_shells inside ma a mb b rays steps.
Proof. reflexivity. Qed.
