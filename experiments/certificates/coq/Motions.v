(** Linear motion: a cover of intervals of time. *)
Require Import List ZArith QArith Lia Lqa Permutation.
From Certificates Require Import Space Exact Faces Cuts Covers Claims.
Import ListNotations.
Open Scope Z_scope.

(** Corners at both ends of the motion, over one unit. *)
Definition moving := (grid * grid)%type.

(** At time n/d, over d times the unit. *)
Definition zbetween (t : Q) (v : moving) : grid :=
  let at_time x y := (Zpos (Qden t) - Qnum t) * x + Qnum t * y in
  Vec (at_time (vx (fst v)) (vx (snd v))) (at_time (vy (fst v)) (vy (snd v))) (at_time (vz (fst v)) (vz (snd v))).

(** The gap along m at a time, if both sides have a corner. *)
Definition gap_at (ua ub : positive) (m : grid) (t : Q) (la lb : list moving) : option Z :=
  match reach m (map (zbetween t) la), reach (opposite m) (map (zbetween t) lb) with
  | Some a, Some b => Some (- b * Zpos ua - a * Zpos ub)
  | _, _ => None
  end.

(** Apart at both ends of the interval: touching at the very [last] time, where that is left open. *)
Definition motion_leaf (last : Q) (open : bool) (ua ub : positive) (m : grid) (t0 t1 : Q) (la lb : list (list moving)) : bool :=
  match gap_at ua ub m t0 (concat la) (concat lb), gap_at ua ub m t1 (concat la) (concat lb) with
  | Some g0, Some g1 => (0 <? g0) && ((0 <? g1) || (0 <=? g1) && open && Qeq_bool t1 last)
  | _, _ => true
  end.

Definition place_moving (m0 m1 : zpose) (b : zbody) : group (list moving) :=
  map_group (fun f => map (fun v => (zplace m0 (unit b) v, zplace m1 (unit b) v)) (concat f)) (groups b).

(** The bodies share no point from time 0 to [last]: that time itself is left out where [open]. *)
Definition check_motion (last : Q) (open : bool) (ma0 ma1 : zpose) (a : zbody) (mb0 mb1 : zpose) (b : zbody) (c : cover) : bool :=
  (pose_unit ma0 =? pose_unit ma1)%positive && (pose_unit mb0 =? pose_unit mb1)%positive &&
  covers (motion_leaf last open (unit_at ma0 a) (unit_at mb0 b)) c 0%Q last (place_moving ma0 ma1 a) (place_moving mb0 mb1 b).

Open Scope Q_scope.

Definition between (t : Q) (p q : point) : point := plus (times (1 - t) p) (times t q).

(** M(t) = (1 - t) M0 + t M1. *)
Definition pose_between (t : Q) (m0 m1 : pose) : pose :=
  Pose (Vec (between t (vx (rows m0)) (vx (rows m1))) (between t (vy (rows m0)) (vy (rows m1))) (between t (vz (rows m0)) (vz (rows m1))))
       (between t (shift m0) (shift m1)).

(** Where a corner is at a time. *)
Definition moved_at (t : Q) (m0 m1 : zpose) (b : zbody) (v : grid) : point := place (pose_between t (pose_of m0) (pose_of m1)) (over (unit b) v).

Definition place_at (t : Q) (u : positive) (v : moving) : point := between t (over u (fst v)) (over u (snd v)).

Lemma place_between t m0 m1 p : same (place (pose_between t m0 m1) p) (between t (place m0 p) (place m1 p)).
Proof. repeat split; unfold place, pose_between, between, plus, times, dot; simpl; ring. Qed.

Lemma between_same t p p' q q' : same p p' -> same q q' -> same (between t p q) (between t p' q').
Proof. intros pp qq. unfold between. rewrite pp, qq. reflexivity. Qed.

Lemma moved_at_same t m0 m1 b v : pose_unit m0 = pose_unit m1 ->
  same (place_at t (unit_at m0 b) (zplace m0 (unit b) v, zplace m1 (unit b) v)) (moved_at t m0 m1 b v).
Proof.
  intros units. unfold moved_at. rewrite place_between. unfold place_at. simpl fst. simpl snd. apply between_same.
  - apply zplace_is_place.
  - unfold unit_at. rewrite units. apply zplace_is_place.
Qed.

Lemma zbetween_is t u v : same (over (u * Qden t) (zbetween t v)) (place_at t u v).
Proof.
  destruct t as [n d]. repeat split; unfold zbetween, place_at, between, plus, times, over; cbn [vx vy vz Qnum Qden];
    unfold Qminus, Qeq, Qplus, Qmult, Qopp; cbn [Qnum Qden]; rewrite ?Pos2Z.inj_mul; ring.
Qed.

Lemma corner_below m t u l k v : reach m (map (zbetween t) l) = Some k -> In v l -> dot (over 1 m) (place_at t u v) <= k # (u * Qden t).
Proof.
  intros reached v_in. rewrite <- zbetween_is, dot_over. unfold Qle; simpl. apply Z.mul_le_mono_nonneg_r; [lia|].
  apply (reach_above m _ k reached). apply in_map. exact v_in.
Qed.

Lemma place_at_linear m t0 t1 t u v :
  (t1 - t0) * dot m (place_at t u v) == (t1 - t) * dot m (place_at t0 u v) + (t - t0) * dot m (place_at t1 u v).
Proof. unfold place_at, between, plus, times, dot; simpl; ring. Qed.

Lemma hull_of_moving t u (l : list (list moving)) piece p : In piece l -> hull (map (place_at t u) piece) p -> hull (map (place_at t u) (concat l)) p.
Proof.
  intros piece_in. apply hull_incl. intros v v_in. apply in_map_iff in v_in as (w & <- & w_in). apply in_map, in_concat. exists piece. auto.
Qed.

(** Along a direction, points of the hull at time t are below what the corners are at t0 and t1. *)
Lemma hull_in_time m t0 t1 t u l p k0 k1 : t0 <= t <= t1 -> hull (map (place_at t u) l) p ->
  reach m (map (zbetween t0) l) = Some k0 -> reach m (map (zbetween t1) l) = Some k1 ->
  (t1 - t0) * dot (over 1 m) p <= (t1 - t) * (k0 # (u * Qden t0)) + (t - t0) * (k1 # (u * Qden t1)).
Proof.
  intros (low & high) at_p r0 r1.
  assert (scaled : forall q, (t1 - t0) * dot (over 1 m) q == dot (times (t1 - t0) (over 1 m)) q) by (intros; unfold dot, times; simpl; ring).
  rewrite scaled. apply (hull_below _ _ _ _ at_p). intros x x_in. apply in_map_iff in x_in as (v & <- & v_in).
  rewrite <- scaled, place_at_linear.
  assert (A := corner_below m t0 u l k0 v r0 v_in). assert (B := corner_below m t1 u l k1 v r1 v_in).
  set (x0 := dot (over 1 m) (place_at t0 u v)) in *. set (x1 := dot (over 1 m) (place_at t1 u v)) in *.
  assert (0 <= t1 - t) by lra. assert (0 <= t - t0) by lra. nra.
Qed.

Definition apart_at (last : Q) (open : bool) (ua ub : positive) (t : Q) (a b : list moving) : Prop :=
  (open = true -> t < last) -> ~ exists p, hull (map (place_at t ua) a) p /\ hull (map (place_at t ub) b) p.

Lemma motion_leaf_sound last open ua ub m t0 t1 la lb : motion_leaf last open ua ub m t0 t1 la lb = true ->
  forall t a b, t0 <= t <= t1 -> In a la -> In b lb -> apart_at last open ua ub t a b.
Proof.
  unfold motion_leaf, gap_at. intros H t a b in_time a_in b_in before (p & at_a & at_b).
  apply (hull_of_moving t ua la) in at_a; [|assumption]. apply (hull_of_moving t ub lb) in at_b; [|assumption].
  assert (corner_a : concat la <> []) by (intros E; rewrite E in at_a; destruct (hull_has_a_corner _ _ at_a) as (? & [])).
  assert (corner_b : concat lb <> []) by (intros E; rewrite E in at_b; destruct (hull_has_a_corner _ _ at_b) as (? & [])).
  destruct (reach m (map (zbetween t0) (concat la))) as [a0|] eqn:A0; [|apply reach_none, map_eq_nil in A0; contradiction].
  destruct (reach m (map (zbetween t1) (concat la))) as [a1|] eqn:A1; [|apply reach_none, map_eq_nil in A1; contradiction].
  destruct (reach (opposite m) (map (zbetween t0) (concat lb))) as [b0|] eqn:B0; [|apply reach_none, map_eq_nil in B0; contradiction].
  destruct (reach (opposite m) (map (zbetween t1) (concat lb))) as [b1|] eqn:B1; [|apply reach_none, map_eq_nil in B1; contradiction].
  assert (A := hull_in_time _ _ _ _ _ _ _ _ _ in_time at_a A0 A1). assert (B := hull_in_time _ _ _ _ _ _ _ _ _ in_time at_b B0 B1).
  rewrite opposite_dot in B.
  apply andb_prop in H as (first & second). apply Z.ltb_lt in first.
  assert (gap0 : 0 < - (b0 # (ub * Qden t0)) - (a0 # (ua * Qden t0))).
  { unfold Qlt, Qminus, Qplus, Qopp; cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. nia. }
  destruct in_time as (low & high). set (x := dot (over 1 m) p) in *.
  destruct (Qlt_le_dec t0 t1) as [longer|instant].
  - assert (gap1 : 0 < - (b1 # (ub * Qden t1)) - (a1 # (ua * Qden t1)) \/
                   0 <= - (b1 # (ub * Qden t1)) - (a1 # (ua * Qden t1)) /\ t < t1).
    { apply Bool.orb_true_iff in second as [positive|touching].
      - left. apply Z.ltb_lt in positive. unfold Qlt, Qminus, Qplus, Qopp; cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. nia.
      - right. apply andb_prop in touching as (touching & at_last). apply andb_prop in touching as (zero & is_open).
        apply Z.leb_le in zero. apply Qeq_bool_iff in at_last. split.
        + unfold Qle, Qminus, Qplus, Qopp; cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. nia.
        + rewrite at_last. auto. }
    set (g0 := - (b0 # (ub * Qden t0)) - (a0 # (ua * Qden t0))) in *. set (g1 := - (b1 # (ub * Qden t1)) - (a1 # (ua * Qden t1))) in *.
    assert (total : (t1 - t) * g0 + (t - t0) * g1 <= 0) by (unfold g0, g1; lra).
    assert (0 <= t1 - t) by lra. assert (0 <= t - t0) by lra.
    destruct gap1 as [positive|(zero & early)]; [|nra].
    destruct (Qlt_le_dec t t1); nra.
  - assert (both : t == t0) by lra.
    (* At one instant, the hull itself. *)
    assert (C : forall l u k q d, reach d (map (zbetween t0) l) = Some k -> hull (map (place_at t u) l) q -> dot (over 1 d) q <= k # (u * Qden t0)).
    { intros l u k q d reached at_q. apply (hull_below _ _ _ _ at_q). intros y y_in. apply in_map_iff in y_in as (v & <- & v_in).
      assert (E : same (place_at t u v) (place_at t0 u v)) by (unfold place_at, between; rewrite both; reflexivity).
      rewrite E. apply (corner_below d t0 u l k v reached v_in). }
    assert (D := C _ _ _ _ _ A0 at_a). assert (E := C _ _ _ _ _ B0 at_b). rewrite opposite_dot in E. fold x in D, E. lra.
Qed.

Lemma surface_in_moving_pieces t m0 m1 b p : pose_unit m0 = pose_unit m1 -> check_body b = true -> surface (body_at (moved_at t m0 m1 b) b) p ->
  exists piece, In piece (map snd (contents (place_moving m0 m1 b))) /\ hull (map (place_at t (unit_at m0 b)) piece) p.
Proof.
  intros units accepted at_p. destruct (surface_in_pieces b _ p accepted at_p) as (piece & piece_in & in_hull).
  exists (map (fun v => (zplace m0 (unit b) v, zplace m1 (unit b) v)) (concat piece)). split.
  - unfold place_moving. rewrite contents_map, map_map. simpl.
    rewrite <- (map_map snd (fun f => map (fun v => (zplace m0 (unit b) v, zplace m1 (unit b) v)) (concat f))).
    apply (in_map (fun f => map (fun v => (zplace m0 (unit b) v, zplace m1 (unit b) v)) (concat f))). exact piece_in.
  - apply (hull_same _ (map (moved_at t m0 m1 b) (concat piece)) p p); [|reflexivity | exact in_hull].
    rewrite map_map. clear -units. induction (concat piece); simpl; constructor; auto. apply moved_at_same. exact units.
Qed.

(** From time 0 to the last, the moving surfaces share no point; at the last itself only where it is not left open. *)
Theorem motion_is_free last open ma0 ma1 a mb0 mb1 b c : check_body a = true -> check_body b = true ->
  check_motion last open ma0 ma1 a mb0 mb1 b c = true ->
  forall t, 0 <= t <= last -> (open = true -> t < last) ->
  ~ exists p, surface (body_at (moved_at t ma0 ma1 a) a) p /\ surface (body_at (moved_at t mb0 mb1 b) b) p.
Proof.
  intros body_a body_b accepted t in_time before (p & at_a & at_b). unfold check_motion in accepted.
  apply andb_prop in accepted as (units & accepted). apply andb_prop in units as (units_a & units_b).
  apply Pos.eqb_eq in units_a. apply Pos.eqb_eq in units_b.
  destruct (surface_in_moving_pieces t ma0 ma1 a p units_a body_a at_a) as (x & x_in & x_hull).
  destruct (surface_in_moving_pieces t mb0 mb1 b p units_b body_b at_b) as (y & y_in & y_hull).
  apply (covers_sound _ (apart_at last open (unit_at ma0 a) (unit_at mb0 b)) (motion_leaf_sound _ _ _ _) _ _ _ _ _ accepted t x y in_time x_in y_in before).
  exists p. auto.
Qed.
