(** Motion: a cover of intervals of time. The entries of a moving pose are forms in 1 - t and t over a common divisor. *)
Require Import List ZArith QArith Lia Lqa Permutation.
From Certificates Require Import Space Exact Faces Cuts Covers Claims Forms.
Import ListNotations.
Open Scope Z_scope.

(** A row is four forms: what a coordinate of a point is multiplied by, and what is added. *)
Record row := Row { of_x : form; of_y : form; of_z : form; alone : form }.

Record zmotion := Zmotion { x_row : row; y_row : row; z_row : row; divisor : form }.

Definition all_rows (p : form -> bool) (m : zmotion) : bool :=
  forallb (fun r => p (of_x r) && p (of_y r) && p (of_z r) && p (alone r)) [x_row m; y_row m; z_row m].

(** All forms have the length that those of the other motion get from their product with this divisor. *)
Definition check_motion_form (m : zmotion) : bool :=
  all_rows (fun f => Nat.eqb (length f) (S (length (divisor m)))) m && negb (Nat.eqb (length (divisor m)) 0).

(** The form of m . M x + m . t along a direction, times another divisor, over an interval. *)
Definition along (d : grid) (other : form) (change : form -> form) (m : zmotion) : row :=
  let part select := change (fmul (fadd (fscale (vx d) (select (x_row m))) (fadd (fscale (vy d) (select (y_row m))) (fscale (vz d) (select (z_row m))))) other) in
  Row (part of_x) (part of_y) (part of_z) (part alone).

(** Of a corner, times its unit. *)
Definition of_corner (r : row) (unit : positive) (v : grid) : form :=
  fadd (fscale (vx v) (of_x r)) (fadd (fscale (vy v) (of_y r)) (fadd (fscale (vz v) (of_z r)) (fscale (Zpos unit) (alone r)))).

(** Coefficients that are at least those of all corners. *)
Definition upper (r : row) (unit : positive) (corners : list grid) : option form :=
  match map (of_corner r unit) corners with [] => None | f :: rest => Some (fold_left fmax rest f) end.

(** The interval as numerators over a common denominator. *)
Definition interval (t0 t1 : Q) : Z * Z * positive := (Qnum t0 * Zpos (Qden t1), Qnum t1 * Zpos (Qden t0), (Qden t0 * Qden t1)%positive).

Definition changed (t0 t1 : Q) : form -> form :=
  let '(a, b, d) := interval t0 t1 in replaced (Zpos d - a) (Zpos d - b) a b.

(** Apart all over the interval: touching at the very [last] time, where that is left open. *)
Definition motion_leaf (last : Q) (open : bool) (ma mb : zmotion) (ua ub : positive) (m : grid) (t0 t1 : Q) (la lb : list (list grid)) : bool :=
  match upper (along m (divisor mb) (changed t0 t1) ma) ua (concat la), upper (along (opposite m) (divisor ma) (changed t0 t1) mb) ub (concat lb) with
  | Some fa, Some fb => all_positive (open && Qeq_bool t1 last) (fscale (-1) (fadd (fscale (Zpos ub) fa) (fscale (Zpos ua) fb)))
  | _, _ => true
  end.

Definition corners_of (b : zbody) : group (list grid) := map_group (@concat grid) (groups b).

(** The bodies share no point from time 0 to [last]: that time itself is left out where [open]. *)
Definition check_motion (last : Q) (open : bool) (ma : zmotion) (a : zbody) (mb : zmotion) (b : zbody) (c : cover) : bool :=
  check_motion_form ma && check_motion_form mb &&
  covers (motion_leaf last open ma mb (unit a) (unit b)) c 0%Q last (corners_of a) (corners_of b).

Open Scope Q_scope.

(** ** What the forms stand for *)

Definition at_time (f : form) (t : Q) : Q := value f (1 - t) t.

(** A row at a time, over the divisor. *)
Definition row_at (m : zmotion) (t : Q) (r : row) : point :=
  Vec (at_time (of_x r) t / at_time (divisor m) t) (at_time (of_y r) t / at_time (divisor m) t) (at_time (of_z r) t / at_time (divisor m) t).

Definition pose_at (m : zmotion) (t : Q) : pose :=
  let added r := at_time (alone r) t / at_time (divisor m) t in
  Pose (Vec (row_at m t (x_row m)) (row_at m t (y_row m)) (row_at m t (z_row m))) (Vec (added (x_row m)) (added (y_row m)) (added (z_row m))).

(** Where a corner is at a time. *)
Definition moved_at (t : Q) (m : zmotion) (b : zbody) (v : grid) : point := place (pose_at m t) (over (unit b) v).

Section One_body.
Variables (d : grid) (m : zmotion) (other : form) (unit : positive) (t0 t1 t : Q).
Hypothesis good : check_motion_form m = true.
Hypothesis some_other : other <> [].
Hypothesis in_time : t0 <= t <= t1.
Hypothesis positive : 0 < at_time (divisor m) t.

Let n := S (length (divisor m)).

Definition has_length (r : row) := length (of_x r) = n /\ length (of_y r) = n /\ length (of_z r) = n /\ length (alone r) = n.

Lemma rows_length : has_length (x_row m) /\ has_length (y_row m) /\ has_length (z_row m) /\ divisor m <> [].
Proof using good.
  clear positive some_other in_time. unfold check_motion_form, all_rows in good. simpl in good. bools. unfold has_length, n.
  repeat match goal with H : Nat.eqb _ _ = true |- _ => apply Nat.eqb_eq in H end.
  repeat split; try assumption. intros E. rewrite E in *. simpl in *. discriminate.
Qed.

(** Where in the interval, from 0 to 1. *)
Definition share : Q := if Qlt_le_dec t0 t1 then (t - t0) / (t1 - t0) else 0.

Lemma share_is : 0 <= share <= 1 /\ t == (1 - share) * t0 + share * t1.
Proof.
  unfold share. destruct in_time as (low & high). destruct (Qlt_le_dec t0 t1) as [longer|instant]; [|split; [lra|]; lra].
  assert (0 < t1 - t0) by lra. repeat split.
  - apply Qle_shift_div_l; lra.
  - apply Qle_shift_div_r; lra.
  - field. lra.
Qed.

Lemma share_end : t < t1 -> share < 1.
Proof.
  intros early. unfold share. destruct (Qlt_le_dec t0 t1); [|lra]. apply Qlt_shift_div_r; lra.
Qed.

Definition scale : Q := inject_Z (Zpos (Qden t0 * Qden t1)).

Lemma scale_positive : 0 < scale.
Proof using t0 t1. reflexivity. Qed.

Lemma numerators : inject_Z (Qnum t0 * Zpos (Qden t1)) == scale * t0 /\ inject_Z (Qnum t1 * Zpos (Qden t0)) == scale * t1.
Proof.
  unfold scale. generalize t0, t1. intros [a b] [c e]. unfold inject_Z, Qeq, Qmult. cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. split; ring.
Qed.

Lemma value_changed f : value (changed t0 t1 f) (1 - share) share == power scale (pred (length f)) * at_time f t.
Proof.
  unfold changed, interval. rewrite value_replaced. unfold at_time. rewrite <- value_homogeneous.
  destruct numerators as (first & second). destruct share_is as (_ & T). unfold Z.sub. rewrite !inject_Z_plus, !inject_Z_opp. fold scale.
  apply value_equal; rewrite first, second, T; ring.
Qed.

Lemma changed_length f : length (changed t0 t1 f) = length f.
Proof. apply replaced_length. Qed.

Definition combined (select : row -> form) : form := fadd (fscale (vx d) (select (x_row m))) (fadd (fscale (vy d) (select (y_row m))) (fscale (vz d) (select (z_row m)))).

Definition selects (select : row -> form) := select = of_x \/ select = of_y \/ select = of_z \/ select = alone.

Lemma combined_is select : selects select -> length (combined select) = n /\
  at_time (combined select) t == inject_Z (vx d) * at_time (select (x_row m)) t + inject_Z (vy d) * at_time (select (y_row m)) t + inject_Z (vz d) * at_time (select (z_row m)) t.
Proof.
  intros which. destruct rows_length as ((a&b&c&e)&(a'&b'&c'&e')&(a''&b''&c''&e'')&_). unfold combined, at_time.
  assert (X : length (select (x_row m)) = n) by (destruct which as [->|[->|[->| ->]]]; assumption).
  assert (Y : length (select (y_row m)) = n) by (destruct which as [->|[->|[->| ->]]]; assumption).
  assert (Z : length (select (z_row m)) = n) by (destruct which as [->|[->|[->| ->]]]; assumption).
  split.
  - rewrite fadd_length; rewrite fscale_length; [exact X|]. rewrite fadd_length; rewrite !fscale_length; congruence.
  - rewrite value_fadd; [rewrite value_fadd; [rewrite !value_fscale; ring|]|]; rewrite ?fadd_length; rewrite ?fscale_length; congruence.
Qed.

Lemma part_is select : selects select -> let f := changed t0 t1 (fmul (combined select) other) in
  length f = pred (n + length other) /\
  value f (1 - share) share == power scale (pred (pred (n + length other))) * (at_time (combined select) t * at_time other t).
Proof.
  intros which f. destruct (combined_is select which) as (L & _).
  assert (some : combined select <> []) by (intros E; rewrite E in L; discriminate L).
  assert (P := fmul_length (combined select) other some some_other).
  unfold f. rewrite value_changed, changed_length. assert (F : length (fmul (combined select) other) = pred (n + length other)) by lia.
  rewrite F. split; [reflexivity|]. unfold at_time. rewrite value_fmul by assumption. reflexivity.
Qed.

Definition factor : Q := power scale (pred (pred (n + length other))) * at_time other t * at_time (divisor m) t * inject_Z (Zpos unit).

Lemma corner_is v : let f := of_corner (along d other (changed t0 t1) m) unit v in
  length f = pred (n + length other) /\ value f (1 - share) share == factor * dot (over 1 d) (place (pose_at m t) (over unit v)).
Proof.
  intros f. unfold f, of_corner, along. cbn [of_x of_y of_z alone].
  destruct (part_is of_x) as (LX & VX); [left; reflexivity|]. destruct (part_is of_y) as (LY & VY); [right; left; reflexivity|].
  destruct (part_is of_z) as (LZ & VZ); [right; right; left; reflexivity|]. destruct (part_is alone) as (LA & VA); [right; right; right; reflexivity|].
  fold (combined of_x) (combined of_y) (combined of_z) (combined alone).
  split.
  - rewrite fadd_length; rewrite fscale_length; [exact LX|]. rewrite fadd_length; rewrite fscale_length; [congruence|]. rewrite fadd_length; rewrite !fscale_length; congruence.
  - rewrite value_fadd; [rewrite value_fadd; [rewrite value_fadd; [rewrite !value_fscale, VX, VY, VZ, VA|]|]|];
      [|repeat (rewrite ?fscale_length; rewrite ?fadd_length); congruence ..].
    rewrite (proj2 (combined_is of_x (or_introl eq_refl))), (proj2 (combined_is of_y (or_intror (or_introl eq_refl)))),
      (proj2 (combined_is of_z (or_intror (or_intror (or_introl eq_refl))))), (proj2 (combined_is alone (or_intror (or_intror (or_intror eq_refl))))).
    unfold factor, place, plus, pose_at, row_at, dot, over. cbn [vx vy vz rows shift].
    rewrite (Qmake_Qdiv (vx v) unit), (Qmake_Qdiv (vy v) unit), (Qmake_Qdiv (vz v) unit).
    change (vx d # 1) with (inject_Z (vx d)). change (vy d # 1) with (inject_Z (vy d)). change (vz d # 1) with (inject_Z (vz d)).
    assert (0 < inject_Z (Zpos unit)) by reflexivity. field. split; lra.
Qed.

Lemma upper_is corners f v : upper (along d other (changed t0 t1) m) unit corners = Some f -> In v corners ->
  length f = pred (n + length other) /\ factor * dot (over 1 d) (place (pose_at m t) (over unit v)) <= value f (1 - share) share.
Proof.
  intros U v_in. unfold upper in U. destruct corners as [|c corners]; [contradiction|]. simpl in U. injection U as <-.
  set (r := along d other (changed t0 t1) m) in *.
  destruct (fold_fmax_above (map (of_corner r unit) corners) (of_corner r unit c)) as (first & others & L).
  { intros f f_in. apply in_map_iff in f_in as (w & <- & _). unfold r. rewrite (proj1 (corner_is w)). symmetry. apply (proj1 (corner_is c)). }
  split; [rewrite L; apply (proj1 (corner_is c))|]. rewrite <- (proj2 (corner_is v)). destruct share_is as ((low & high) & _).
  apply value_below; [|lra|assumption]. destruct v_in as [<-|v_in]; [exact first|]. apply others, in_map. exact v_in.
Qed.
End One_body.

Definition place_at (m : zmotion) (u : positive) (t : Q) (v : grid) : point := place (pose_at m t) (over u v).

Definition apart_at (last : Q) (open : bool) (ma mb : zmotion) (ua ub : positive) (t : Q) (a b : list grid) : Prop :=
  (open = true -> t < last) -> 0 < at_time (divisor ma) t -> 0 < at_time (divisor mb) t ->
  ~ exists p, hull (map (place_at ma ua t) a) p /\ hull (map (place_at mb ub t) b) p.

Lemma hull_of_some (g : grid -> point) (l : list (list grid)) piece p : In piece l -> hull (map g piece) p -> hull (map g (concat l)) p.
Proof.
  intros piece_in. apply hull_incl. intros v v_in. apply in_map_iff in v_in as (w & <- & w_in). apply in_map, in_concat. exists piece. auto.
Qed.

Lemma upper_exists r u l g p : hull (map g l) p -> upper r u l <> None.
Proof. intros at_p. destruct (hull_has_a_corner _ _ at_p) as (? & some). destruct l; [contradiction | discriminate]. Qed.

(** Of points of a hull, from the corners. *)
Lemma hull_upper d m other u t0 t1 t l f p : check_motion_form m = true -> other <> [] -> t0 <= t <= t1 -> 0 < at_time (divisor m) t -> 0 < at_time other t ->
  upper (along d other (changed t0 t1) m) u l = Some f -> hull (map (place_at m u t) l) p ->
  factor m other u t0 t1 t * dot (over 1 d) p <= value f (1 - share t0 t1 t) (share t0 t1 t).
Proof.
  intros good some in_time pos pos_other U at_p. set (k := factor m other u t0 t1 t).
  assert (0 < k).
  { unfold k, factor. assert (P := power_positive _ (pred (pred (S (length (divisor m)) + length other))) (scale_positive t0 t1)).
    assert (0 < inject_Z (Zpos u)) by reflexivity. repeat apply Qmult_lt_0_compat; assumption. }
  rewrite Qmult_comm. apply (Qle_trans _ (value f (1 - share t0 t1 t) (share t0 t1 t) / k * k)); [|rewrite Qmult_comm, Qmult_div_r; lra].
  apply Qmult_le_compat_r; [|lra]. apply (hull_below _ _ _ _ at_p). intros x x_in. apply in_map_iff in x_in as (v & <- & v_in).
  apply Qle_shift_div_l; [assumption|]. rewrite Qmult_comm. apply (upper_is d m other u t0 t1 t good some in_time pos l f v U v_in).
Qed.

Lemma motion_leaf_sound last open ma mb ua ub m t0 t1 la lb : check_motion_form ma = true -> check_motion_form mb = true ->
  motion_leaf last open ma mb ua ub m t0 t1 la lb = true ->
  forall t a b, t0 <= t <= t1 -> In a la -> In b lb -> apart_at last open ma mb ua ub t a b.
Proof.
  unfold motion_leaf. intros good_a good_b H t a b in_time a_in b_in before pos_a pos_b (p & at_a & at_b).
  apply (hull_of_some _ la) in at_a; [|assumption]. apply (hull_of_some _ lb) in at_b; [|assumption].
  assert (some_a : divisor ma <> []) by (apply rows_length; assumption). assert (some_b : divisor mb <> []) by (apply rows_length; assumption).
  destruct (upper _ ua _) as [fa|] eqn:A; [|apply (upper_exists _ _ _ _ _ at_a) in A; contradiction].
  destruct (upper _ ub _) as [fb|] eqn:B; [|apply (upper_exists _ _ _ _ _ at_b) in B; contradiction].
  assert (VA := hull_upper _ _ _ _ _ _ _ _ _ _ good_a some_b in_time pos_a pos_b A at_a).
  assert (VB := hull_upper _ _ _ _ _ _ _ _ _ _ good_b some_a in_time pos_b pos_a B at_b).
  rewrite opposite_dot in VB.
  destruct (hull_has_a_corner _ _ at_a) as (x & x_in). apply in_map_iff in x_in as (v & _ & v_in).
  destruct (hull_has_a_corner _ _ at_b) as (y & y_in). apply in_map_iff in y_in as (w & _ & w_in).
  assert (LA := proj1 (upper_is _ _ _ _ _ _ _ good_a some_b in_time pos_a _ _ _ A v_in)).
  assert (LB := proj1 (upper_is _ _ _ _ _ _ _ good_b some_a in_time pos_b _ _ _ B w_in)).
  apply (all_positive_sound _ _ (share t0 t1 t)) in H.
  - rewrite value_fscale, value_fadd, !value_fscale in H by (rewrite !fscale_length; simpl in *; lia).
    set (va := value fa (1 - share t0 t1 t) (share t0 t1 t)) in *. set (vb := value fb (1 - share t0 t1 t) (share t0 t1 t)) in *.
    set (z := dot (over 1 m) p) in *. unfold factor in VA, VB.
    replace (S (length (divisor mb)) + length (divisor ma))%nat with (S (length (divisor ma)) + length (divisor mb))%nat in VB by lia.
    set (k := power (scale t0 t1) _) in *. set (da := at_time (divisor ma) t) in *. set (db := at_time (divisor mb) t) in *.
    assert (UA : 0 < inject_Z (Zpos ua)) by reflexivity. assert (UB : 0 < inject_Z (Zpos ub)) by reflexivity.
    set (qa := inject_Z (Zpos ua)) in *. set (qb := inject_Z (Zpos ub)) in *.
    assert (PA : qb * (k * db * da * qa * z) <= qb * va) by (apply Qmult_le_l; assumption).
    assert (PB : qa * (k * da * db * qb * - z) <= qa * vb) by (apply Qmult_le_l; assumption).
    assert (Z0 : qb * (k * db * da * qa * z) + qa * (k * da * db * qb * - z) == 0) by ring.
    change (inject_Z (-1)) with (-(1)) in H. lra.
  - apply share_is. assumption.
  - intros both. apply andb_prop in both as (is_open & at_last). apply Qeq_bool_iff in at_last. apply share_end. rewrite at_last. auto.
Qed.

Lemma surface_in_corners t m b p : check_body b = true -> surface (body_at (moved_at t m b) b) p ->
  exists piece, In piece (map snd (contents (corners_of b))) /\ hull (map (place_at m (unit b) t) piece) p.
Proof.
  intros accepted at_p. destruct (surface_in_pieces b _ p accepted at_p) as (piece & piece_in & in_hull).
  exists (concat piece). split; [|exact in_hull]. unfold corners_of. rewrite contents_map, map_map. simpl.
  rewrite <- (map_map snd (@concat grid)). apply in_map. exact piece_in.
Qed.

(** From time 0 to the last, the moving surfaces share no point; at the last itself only where it is not left open.
    The divisors of both motions are positive at the time. *)
Theorem motion_is_free last open ma a mb b c : check_body a = true -> check_body b = true -> check_motion last open ma a mb b c = true ->
  forall t, 0 <= t <= last -> (open = true -> t < last) -> 0 < at_time (divisor ma) t -> 0 < at_time (divisor mb) t ->
  ~ exists p, surface (body_at (moved_at t ma a) a) p /\ surface (body_at (moved_at t mb b) b) p.
Proof.
  intros body_a body_b accepted t in_time before pos_a pos_b (p & at_a & at_b). unfold check_motion in accepted.
  apply andb_prop in accepted as (good & accepted). apply andb_prop in good as (good_a & good_b).
  destruct (surface_in_corners t ma a p body_a at_a) as (x & x_in & x_hull).
  destruct (surface_in_corners t mb b p body_b at_b) as (y & y_in & y_hull).
  apply (covers_sound _ (apart_at last open ma mb (unit a) (unit b))
           (fun m t0 t1 la lb => motion_leaf_sound last open ma mb (unit a) (unit b) m t0 t1 la lb good_a good_b)
           _ _ _ _ _ accepted t x y in_time x_in y_in before pos_a pos_b).
  exists p. auto.
Qed.

(** ** Corners that move on lines *)

Definition line (m0 m1 : zpose) : zmotion :=
  let of v0 v1 k := [k v0; k v1]%Z in
  let forms v0 v1 s := Row (of v0 v1 vx) (of v0 v1 vy) (of v0 v1 vz) (of (zshift m0) (zshift m1) s) in
  Zmotion (forms (vx (zrows m0)) (vx (zrows m1)) vx) (forms (vy (zrows m0)) (vy (zrows m1)) vy) (forms (vz (zrows m0)) (vz (zrows m1)) vz)
          [Zpos (pose_unit m0)].

Definition between (t : Q) (p q : point) : point := plus (times (1 - t) p) (times t q).

Lemma line_divisor m0 m1 t : 0 < at_time (divisor (line m0 m1)) t.
Proof. unfold at_time. simpl. assert (0 < inject_Z (Zpos (pose_unit m0))) by reflexivity. lra. Qed.

(** M(t) = (1 - t) M0 + t M1. *)
Theorem line_is m0 m1 t p : pose_unit m0 = pose_unit m1 ->
  same (place (pose_at (line m0 m1) t) p) (between t (place (pose_of m0) p) (place (pose_of m1) p)).
Proof.
  intros units. unfold pose_of. rewrite <- units. assert (0 < inject_Z (Zpos (pose_unit m0))) by reflexivity.
  repeat split; unfold place, between, pose_at, row_at, at_time, plus, times, dot, over;
    cbn [vx vy vz rows shift line x_row y_row z_row of_x of_y of_z alone divisor value power length]; rewrite !Qmake_Qdiv; field; lra.
Qed.

(** ** Rotations by q(t) = (1 - t) q0 + t q1, and translations on lines *)

(** The quaternion as four forms of two integers, and the translation over a unit. *)
Definition rigid (w x y z : form) (sx sy sz : form) (unit : positive) : zmotion :=
  let twice f g := fscale 2 (fmul f g) in
  let less f g := fadd f (fscale (-1) g) in
  let ww := fmul w w in let xx := fmul x x in let yy := fmul y y in let zz := fmul z z in
  let norm := fadd (fadd ww xx) (fadd yy zz) in
  let raised f := fscale (Zpos unit) (linear 1 1 f) in
  let forms a b c s := Row (raised a) (raised b) (raised c) (fmul norm s) in
  Zmotion (forms (less (fadd ww xx) (fadd yy zz)) (less (twice x y) (twice w z)) (fadd (twice x z) (twice w y)) sx)
          (forms (fadd (twice x y) (twice w z)) (less (fadd ww yy) (fadd xx zz)) (less (twice y z) (twice w x)) sy)
          (forms (less (twice x z) (twice w y)) (fadd (twice y z) (twice w x)) (less (fadd ww zz) (fadd xx yy)) sz)
          (fscale (Zpos unit) norm).

(** p -> q p q* / |q|^2. *)
Definition rotation (w x y z : Q) (p : point) : point :=
  let n := w * w + x * x + y * y + z * z in
  times (/ n) (Vec ((w * w + x * x - y * y - z * z) * vx p + 2 * (x * y - w * z) * vy p + 2 * (x * z + w * y) * vz p)
                   (2 * (x * y + w * z) * vx p + (w * w - x * x + y * y - z * z) * vy p + 2 * (y * z - w * x) * vz p)
                   (2 * (x * z - w * y) * vx p + 2 * (y * z + w * x) * vy p + (w * w - x * x - y * y + z * z) * vz p)).

(** The values of forms that are given by their coefficients. *)
Ltac form_values := unfold at_time; cbn [fmul fadd fscale map app repeat length linear value power];
  repeat (rewrite inject_Z_plus || rewrite inject_Z_mult);
  change (inject_Z 0) with 0; change (inject_Z 1) with 1; change (inject_Z 2) with 2; change (inject_Z (-1)) with (-(1)).

Theorem rigid_is w0 w1 x0 x1 y0 y1 z0 z1 sx0 sx1 sy0 sy1 sz0 sz1 unit t p :
  let q a b := (1 - t) * inject_Z a + t * inject_Z b in
  let n := q w0 w1 * q w0 w1 + q x0 x1 * q x0 x1 + q y0 y1 * q y0 y1 + q z0 z1 * q z0 z1 in
  let m := rigid [w0; w1]%Z [x0; x1]%Z [y0; y1]%Z [z0; z1]%Z [sx0; sx1]%Z [sy0; sy1]%Z [sz0; sz1]%Z unit in
  at_time (divisor m) t == inject_Z (Zpos unit) * n /\
  (~ n == 0 -> same (place (pose_at m t) p)
                    (plus (rotation (q w0 w1) (q x0 x1) (q y0 y1) (q z0 z1) p)
                          (between t (over unit (Vec sx0 sy0 sz0)) (over unit (Vec sx1 sy1 sz1))))).
Proof.
  intros q n m.
  assert (D : at_time (divisor m) t == inject_Z (Zpos unit) * n) by (unfold m, rigid; cbn [divisor]; unfold n, q; form_values; ring).
  split; [exact D|]. intros some. assert (0 < inject_Z (Zpos unit)) by reflexivity.
  repeat split; unfold place, pose_at, row_at, rotation, between, plus, times, dot, over; cbn [vx vy vz rows shift]; rewrite !D; fold n; rewrite !Qmake_Qdiv;
    unfold m, rigid; cbn [x_row y_row z_row of_x of_y of_z alone]; form_values; unfold n, q in *; field; repeat split; try lra; assumption.
Qed.
