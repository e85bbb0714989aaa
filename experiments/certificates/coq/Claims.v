(** The checks that main.ml calls, and the theorem of each. *)
Require Import List ZArith QArith Lia Lqa Permutation FMapPositive.
From Certificates Require Import Space Exact Faces Cuts Covers.
Import ListNotations.
Open Scope Z_scope.

(** ** A body: its faces with their cuts, integers over a unit, and its pieces in a tree of groups *)

Record zbody := Zbody { cut_faces : list cut_face; unit : positive; groups : group zface }.

Fixpoint equal_lists {T} (eq : T -> T -> bool) (l m : list T) : bool :=
  match l, m with
  | [], [] => true
  | x :: l, y :: m => eq x y && equal_lists eq l m
  | _, _ => false
  end.

Definition equal_faces : zface -> zface -> bool := equal_lists (equal_lists equal).

(** Checked once, whatever the pose. *)
Definition check_body (b : zbody) : bool := forallb check_cut (cut_faces b) && is_whole equal_faces (pieces (cut_faces b)) (groups b).

(** Each directed edge is there as often as its reverse, by the places of corners. *)
Definition is_closed (b : zbody) : bool := cancel (flat_map (fun f => edges (fst f)) (cut_faces b)).

Definition body_at (place_of : grid -> point) (b : zbody) : body := map (fun f => image place_of (fst f)) (cut_faces b).
Definition pieces_at (place_of : grid -> point) (b : zbody) : body := map (image place_of) (pieces (cut_faces b)).

(** Where a pose takes a corner. *)
Definition moved (m : zpose) (b : zbody) (v : grid) : point := place (pose_of m) (over (unit b) v).

Fixpoint map_group {P R} (f : P -> R) (g : group P) : group R :=
  match g with
  | One k p => One k (f p)
  | Many members => Many (map (map_group f) members)
  end.

Definition unit_at (m : zpose) (b : zbody) : positive := (pose_unit m * unit b)%positive.
Definition place_face (m : zpose) (b : zbody) : zface -> zface := map (map (zplace m (unit b))).
Definition place_corners (m : zpose) (b : zbody) : group (list grid) := map_group (fun f => map (zplace m (unit b)) (concat f)) (groups b).
Definition place_pieces (m : zpose) (b : zbody) : group zface := map_group (place_face m b) (groups b).

Lemma equal_lists_sound {T} (eq : T -> T -> bool) : (forall x y, eq x y = true -> x = y) -> forall l m, equal_lists eq l m = true -> l = m.
Proof.
  intros sound. induction l as [|x l IH]; intros [|y m] H; try discriminate; [reflexivity|].
  simpl in H. bools. f_equal; auto.
Qed.

Fixpoint contents_map {P R} (f : P -> R) (g : group P) {struct g} :
  contents (map_group f g) = map (fun x => (fst x, f (snd x))) (contents g).
Proof.
  destruct g as [k p|members]; [reflexivity|]. simpl. induction members as [|m members IH]; [reflexivity|].
  simpl. rewrite map_app, contents_map, IH. reflexivity.
Qed.

Lemma body_is_numbered b : check_body b = true -> Permutation (numbered 1 (pieces (cut_faces b))) (contents (groups b)).
Proof.
  intros H. unfold check_body in H. bools.
  apply (whole_sound equal_faces); [|assumption]. apply equal_lists_sound, equal_lists_sound, equal_same.
Qed.

Lemma body_is_whole b : check_body b = true -> Permutation (map snd (contents (groups b))) (pieces (cut_faces b)).
Proof.
  intros H. apply body_is_numbered in H. rewrite <- (numbered_pieces 1 (pieces (cut_faces b))). apply Permutation_map, Permutation_sym, H.
Qed.

(** Each point of the placed surface is in the hull of a placed piece. *)
Lemma surface_in_pieces b place_of p : check_body b = true -> surface (body_at place_of b) p ->
  exists piece, In piece (map snd (contents (groups b))) /\ hull (map place_of (concat piece)) p.
Proof.
  intros accepted (f & f_in & at_p). unfold body_at in f_in. apply in_map_iff in f_in as (zf & <- & f_in).
  assert (cut : check_cut zf = true) by (unfold check_body in accepted; bools; rewrite forallb_forall in H; auto).
  destruct (cut_holds_face place_of zf p cut at_p) as (piece & piece_in & in_hull).
  exists piece. split.
  - apply (Permutation_in _ (Permutation_sym (body_is_whole b accepted))). apply in_flat_map. exists zf. auto.
  - unfold image in in_hull. rewrite <- concat_map in in_hull. exact in_hull.
Qed.

Lemma corners_same m b l : Forall2 same (map (over (unit_at m b)) (map (zplace m (unit b)) l)) (map (moved m b) l).
Proof. induction l; simpl; constructor; auto. apply zplace_is_place. Qed.

(** ** Witness: a common point, or two points *)

Fixpoint nth_face (k : Z) (l : list cut_face) : option zface :=
  match l with
  | [] => None
  | f :: rest => if k =? 0 then Some (fst f) else nth_face (k - 1) rest
  end.

(** Face number k of the placed body holds the point x over its unit. *)
Definition check_holds (m : zpose) (b : zbody) (k : Z) (h : holder) (ux : positive) (x : grid) : bool :=
  match nth_face k (cut_faces b) with
  | Some f => check_on_face h ux x (unit_at m b) (place_face m b f)
  | None => false
  end.

Lemma nth_face_in k l f : nth_face k l = Some f -> exists c, In c l /\ fst c = f.
Proof.
  revert k. induction l as [|c l IH]; simpl; intros k H; [discriminate|].
  destruct (k =? 0); [injection H as <-; exists c; auto|]. destruct (IH _ H) as (d & ? & ?). exists d; auto.
Qed.

Lemma turns_same_loops n u f g p : same_loops f g -> turns n u f p = turns n u g p.
Proof.
  unfold turns. intros fg.
  assert (edges_same : Forall2 (fun d e => same (fst d) (fst e) /\ same (snd d) (snd e)) (edges f) (edges g)).
  { unfold edges. induction fg as [|l k f g lk fg IH]; [constructor|]. simpl. apply Forall2_app; [|assumption].
    destruct lk as [|a b l k ab lk]; [constructor|]. unfold edges_of_loop.
    assert (general : forall l k, Forall2 same l k -> Forall2 (fun d e => same (fst d) (fst e) /\ same (snd d) (snd e)) (steps a l) (steps b k)).
    { clear - ab. induction 1 as [|c d l k cd lk IH]; [constructor|]. simpl. constructor; [|exact IH].
      split; [exact cd|]. destruct lk; assumption. }
    apply general. constructor; assumption. }
  clear fg. induction edges_same as [|d e ds es (first & second) _ IH]; [reflexivity|]. simpl. rewrite IH, first, second. reflexivity.
Qed.

Lemma edges_same_loops f g : same_loops f g -> forall e, In e (edges f) -> exists d, In d (edges g) /\ same (fst d) (fst e) /\ same (snd d) (snd e).
Proof.
  unfold edges. intros fg e. induction fg as [|l k f g lk fg IH]; [intros []|]. simpl. rewrite in_app_iff. intros [H|H].
  - destruct lk as [|a b l k ab lk]; [contradiction|]. unfold edges_of_loop in *.
    assert (general : forall l k, Forall2 same l k -> In e (steps a l) -> exists d, In d (steps b k) /\ same (fst d) (fst e) /\ same (snd d) (snd e)).
    { clear - ab. induction 1 as [|c d l k cd lk IH]; [intros []|]. simpl. intros [<-|H].
      - eexists. split; [left; reflexivity|]. simpl. split; [symmetry; exact cd|]. destruct lk; symmetry; assumption.
      - destruct (IH H) as (x & ? & ?). exists x. auto. }
    destruct (general (a :: l) (b :: k)) as (d & ? & ?); [constructor; assumption | assumption |]. exists d. rewrite in_app_iff. auto.
  - destruct (IH H) as (d & ? & ?). exists d. rewrite in_app_iff. auto.
Qed.

Lemma corner_same_loops f g v : same_loops f g -> In v (concat g) -> exists w, In w (concat f) /\ same w v.
Proof. intros fg. apply same_in, same_concat. exact fg. Qed.

Lemma on_face_same_loops f g p : same_loops f g -> on_face f p -> on_face g p.
Proof.
  intros fg [(e & e_in & at_e)|(w & (n & u & nonzero & nu & corners & total) & w_nonzero)].
  - left. destruct (edges_same_loops f g fg e e_in) as (d & d_in & first & second). exists d. split; [assumption|].
    apply (hull_same _ [fst e; snd e] p p); [constructor; [|constructor; [|constructor]]; assumption | reflexivity | assumption].
  - right. exists w. split; [|assumption]. exists n, u. split; [assumption|]. split; [assumption|]. split.
    + intros v v_in. destruct (corner_same_loops f g v fg v_in) as (x & x_in & xv). rewrite <- xv. auto.
    + rewrite <- total. symmetry. apply turns_same_loops. assumption.
Qed.

Lemma place_face_same m b f : same_loops (face_over (unit_at m b) (place_face m b f)) (image (moved m b) f).
Proof.
  unfold same_loops, face_over, place_face, image. rewrite map_map. induction f as [|l f IH]; simpl; constructor; auto using corners_same.
Qed.

(** An accepted witness is a point of the placed surface: a common point, where it is accepted for both bodies. *)
Theorem witness_is_on_surface m b k h ux x : check_holds m b k h ux x = true -> surface (body_at (moved m b) b) (over ux x).
Proof.
  unfold check_holds. destruct (nth_face k (cut_faces b)) as [f|] eqn:at_k; [|discriminate]. intros accepted.
  apply nth_face_in in at_k as (c & c_in & <-). exists (image (moved m b) (fst c)). split.
  - unfold body_at. apply in_map_iff. exists c. auto.
  - apply (on_face_same_loops _ _ _ (place_face_same m b (fst c))). exact (on_face_sound _ _ _ _ _ accepted).
Qed.

Theorem witness_is_common ma a ka ha mb b kb hb ux x : check_holds ma a ka ha ux x = true -> check_holds mb b kb hb ux x = true ->
  exists p, surface (body_at (moved ma a) a) p /\ surface (body_at (moved mb b) b) p.
Proof. intros in_a in_b. exists (over ux x). split; eapply witness_is_on_surface; eassumption. Qed.

(** ** Cover: no common point, or a gap *)

(** The squared distance of two points. *)
Definition apart (p q : point) : Q := dot (minus q p) (minus q p).

(** What a cover shows: the squared distance is more than n/d, or not less, and it is not 0. *)
Definition far (n : Z) (d : positive) (strictly : bool) (p q : point) : Prop :=
  (0 < apart p q /\ if strictly then (n # d) < apart p q else (n # d) <= apart p q)%Q.

Definition gap_leaf (n : Z) (d : positive) (strictly : bool) (ua ub : positive) (m : grid) (_ _ : Q) (la lb : list (list grid)) : bool :=
  match reach m (concat la), reach (opposite m) (concat lb) with
  | Some a, Some b =>
      let gap := - (b * Zpos ua) - a * Zpos ub in
      let least := n * zdot m m * (Zpos ua * Zpos ub) * (Zpos ua * Zpos ub) in
      (0 <? gap) && (if strictly then least <? gap * gap * Zpos d else least <=? gap * gap * Zpos d)
  | _, _ => true
  end.

Definition no_time : Q := 0%Q.

Definition check_gap (n : Z) (d : positive) (strictly : bool) (ma : zpose) (a : zbody) (mb : zpose) (b : zbody) (c : cover) : bool :=
  covers (gap_leaf n d strictly (unit_at ma a) (unit_at mb b)) c no_time no_time (place_corners ma a) (place_corners mb b).

Open Scope Q_scope.

Lemma cauchy m p q : (dot m q - dot m p) * (dot m q - dot m p) <= dot m m * apart p q.
Proof.
  set (v := minus q p).
  assert (along : dot m q - dot m p == dot m v) by (unfold v, dot, minus; simpl; ring).
  rewrite along. unfold apart. fold v.
  assert (lagrange : dot m m * dot v v == dot m v * dot m v + dot (cross m v) (cross m v))
    by (unfold dot, cross; simpl; ring).
  rewrite lagrange.
  assert (0 <= dot (cross m v) (cross m v)); [|lra].
  unfold dot. assert (square : forall x : Q, 0 <= x * x) by (intros; nra).
  assert (A := square (vx (cross m v))). assert (B := square (vy (cross m v))). assert (C := square (vz (cross m v))). lra.
Qed.

Lemma square_positive m : 0 <= dot m m.
Proof.
  unfold dot. assert (square : forall x : Q, 0 <= x * x) by (intros; nra).
  assert (A := square (vx m)). assert (B := square (vy m)). assert (C := square (vz m)). lra.
Qed.

Lemma gap_is_far n d (strictly : bool) (gap : Q) m p q : 0 < gap -> gap <= dot m q - dot m p ->
  (if strictly then (n # d) * dot m m < gap * gap else (n # d) * dot m m <= gap * gap) -> far n d strictly p q.
Proof.
  intros positive wide enough. assert (C := cauchy m p q). assert (Hm := square_positive m).
  assert (Hpq : 0 <= apart p q) by apply square_positive.
  assert (product : gap * gap <= dot m m * apart p q) by nra.
  assert (0 < gap * gap) by nra.
  assert (m_positive : 0 < dot m m) by (destruct (Qlt_le_dec 0 (dot m m)); [assumption | exfalso; nra]).
  unfold far. split.
  - destruct (Qlt_le_dec 0 (apart p q)); [assumption | exfalso; nra].
  - destruct strictly.
    + destruct (Qlt_le_dec (n # d) (apart p q)); [assumption | exfalso; nra].
    + destruct (Qlt_le_dec (apart p q) (n # d)); [exfalso; nra | assumption].
Qed.

(** What is shown of two placed pieces, by the integers of their corners. *)
Definition far_hulls (n : Z) (d : positive) (strictly : bool) (ua ub : positive) (_ : Q) (a b : list grid) : Prop :=
  forall p q, hull (map (over ua) a) p -> hull (map (over ub) b) q -> far n d strictly p q.

Lemma hull_of_piece u (l : list (list grid)) piece p : In piece l -> hull (map (over u) piece) p -> hull (map (over u) (concat l)) p.
Proof.
  intros piece_in. apply hull_incl. intros v v_in. apply in_map_iff in v_in as (w & <- & w_in).
  apply in_map, in_concat. exists piece. auto.
Qed.

Lemma gap_leaf_sound n d strictly ua ub m t0 t1 la lb : gap_leaf n d strictly ua ub m t0 t1 la lb = true ->
  forall t a b, t0 <= t <= t1 -> In a la -> In b lb -> far_hulls n d strictly ua ub t a b.
Proof.
  unfold gap_leaf. intros H t a b _ a_in b_in p q at_p at_q.
  apply (hull_of_piece ua la) in at_p; [|assumption]. apply (hull_of_piece ub lb) in at_q; [|assumption].
  destruct (reach m (concat la)) as [ka|] eqn:reach_a.
  2: { apply reach_none in reach_a. rewrite reach_a in at_p. destruct (hull_has_a_corner _ _ at_p) as (v & []). }
  destruct (reach (opposite m) (concat lb)) as [kb|] eqn:reach_b.
  2: { apply reach_none in reach_b. rewrite reach_b in at_q. destruct (hull_has_a_corner _ _ at_q) as (v & []). }
  assert (at_most := reach_hull m _ ka ua p reach_a at_p).
  assert (at_least := reach_hull _ _ kb ub q reach_b at_q). rewrite opposite_dot in at_least.
  apply andb_prop in H as (positive & enough). apply Z.ltb_lt in positive.
  set (gap := (- (kb * Zpos ua) - ka * Zpos ub)%Z) in *.
  assert (gap_is : gap # (ua * ub) == - (kb # ub) - (ka # ua)).
  { unfold gap, Qminus, Qeq, Qplus, Qopp; cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. ring. }
  apply (gap_is_far n d strictly (gap # (ua * ub)) (over 1 m)).
  - unfold Qlt; simpl. lia.
  - rewrite gap_is. lra.
  - destruct strictly; rewrite dot_over.
    + apply Z.ltb_lt in enough. unfold Qlt, Qmult; cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. nia.
    + apply Z.leb_le in enough. unfold Qle, Qmult; cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. nia.
Qed.

Lemma placed_piece m b piece : In piece (map snd (contents (groups b))) ->
  In (map (zplace m (unit b)) (concat piece)) (map snd (contents (place_corners m b))).
Proof.
  intros H. unfold place_corners. rewrite contents_map, map_map. simpl.
  rewrite <- (map_map snd (fun f => map (zplace m (unit b)) (concat f))). apply (in_map (fun f => map (zplace m (unit b)) (concat f))). exact H.
Qed.

Lemma surface_in_placed_pieces m b p : check_body b = true -> surface (body_at (moved m b) b) p ->
  exists piece, In piece (map snd (contents (place_corners m b))) /\ hull (map (over (unit_at m b)) piece) p.
Proof.
  intros accepted at_p. destruct (surface_in_pieces b (moved m b) p accepted at_p) as (piece & piece_in & in_hull).
  exists (map (zplace m (unit b)) (concat piece)). split; [apply placed_piece; assumption|].
  apply (hull_same _ (map (moved m b) (concat piece)) p p); [apply corners_same | reflexivity | assumption].
Qed.

(** Every two points of the placed surfaces are as far apart as an accepted cover says. *)
Theorem cover_shows_distance n d strictly ma a mb b c : check_body a = true -> check_body b = true ->
  check_gap n d strictly ma a mb b c = true ->
  forall p q, surface (body_at (moved ma a) a) p -> surface (body_at (moved mb b) b) q -> far n d strictly p q.
Proof.
  intros body_a body_b accepted p q at_p at_q.
  destruct (surface_in_placed_pieces ma a p body_a at_p) as (x & x_in & x_hull).
  destruct (surface_in_placed_pieces mb b q body_b at_q) as (y & y_in & y_hull).
  apply (covers_sound _ (far_hulls n d strictly (unit_at ma a) (unit_at mb b)) (gap_leaf_sound _ _ _ _ _) _ _ _ _ _ accepted no_time x y);
    try assumption. split; apply Qle_refl.
Qed.

(** An accepted cover of the surfaces proves that they share no point. *)
Theorem cover_proves_apart ma a mb b c : check_body a = true -> check_body b = true -> check_gap 0 1 false ma a mb b c = true ->
  ~ exists p, surface (body_at (moved ma a) a) p /\ surface (body_at (moved mb b) b) p.
Proof.
  intros body_a body_b accepted (p & at_a & at_b).
  destruct (cover_shows_distance _ _ _ _ _ _ _ _ body_a body_b accepted p p at_a at_b) as (positive & _).
  unfold apart, dot, minus in positive; simpl in positive. ring_simplify in positive. lra.
Qed.

(** ** A plane between: no point of A is beyond one of B *)

Definition check_plane (m : grid) (ma : zpose) (a : zbody) (mb : zpose) (b : zbody) : bool :=
  match reach m (flat_map snd (contents (place_corners ma a))), reach (opposite m) (flat_map snd (contents (place_corners mb b))) with
  | Some x, Some y => (x * Zpos (unit_at mb b) <=? - y * Zpos (unit_at ma a))%Z
  | _, _ => false
  end.

Lemma surface_reach d k m b p : check_body b = true -> reach d (flat_map snd (contents (place_corners m b))) = Some k ->
  surface (body_at (moved m b) b) p -> dot (over 1 d) p <= k # unit_at m b.
Proof.
  intros accepted reached at_p. destruct (surface_in_placed_pieces m b p accepted at_p) as (piece & piece_in & in_hull).
  apply (reach_hull _ _ _ _ _ reached). apply (hull_incl (map (over (unit_at m b)) piece)); [|exact in_hull].
  intros v v_in. apply in_map_iff in v_in as (w & <- & w_in). apply in_map, in_flat_map.
  apply in_map_iff in piece_in as (x & <- & x_in). exists x. auto.
Qed.

Theorem plane_is_between m ma a mb b : check_body a = true -> check_body b = true -> check_plane m ma a mb b = true ->
  forall p q, surface (body_at (moved ma a) a) p -> surface (body_at (moved mb b) b) q -> dot (over 1 m) p <= dot (over 1 m) q.
Proof.
  intros body_a body_b accepted p q at_p at_q. unfold check_plane in accepted.
  destruct (reach m _) as [x|] eqn:X; [|discriminate]. destruct (reach (opposite m) _) as [y|] eqn:Y; [|discriminate].
  assert (A := surface_reach _ _ _ _ _ body_a X at_p). assert (B := surface_reach _ _ _ _ _ body_b Y at_q). rewrite opposite_dot in B.
  apply Z.leb_le in accepted.
  assert (x # unit_at ma a <= - (y # unit_at mb b)) by (unfold Qle, Qopp; cbn [Qnum Qden]; lia). lra.
Qed.

(** ** Winding number along a generic ray *)

Open Scope Z_scope.

(** The least product of a direction with the corners of pieces: more than k over the unit of k. *)
Definition beyond (m : grid) (k : Z) (uk uf : positive) (corners : list grid) : bool :=
  match reach (opposite m) corners with
  | Some r => k * Zpos uf <? - r * Zpos uk
  | None => true
  end.

Definition winding_leaf (up : positive) (p d : grid) (uf : positive) (c : passage) (l : list (positive * zface)) : option Z :=
  match c, l with
  | Passes m, _ =>
      if (zdot m d <=? 0) && beyond m (zdot m p) up uf (flat_map (fun x => concat (snd x)) l) then Some 0 else None
  | Crossed n u, [(_, f)] =>
      let g := view up p uf f in
      match concat g with
      | [] => None
      | v :: _ =>
          let h := zdot n v in
          if (0 <? h) && (0 <? zdot n d) && forallb (fun v => (zdot n v =? h) && negb (zdet d u v =? 0)) (concat g) &&
             forallb (fun e => negb (zdet d (fst e) (snd e) =? 0) || (0 <? zdet d u (fst e) * zdet d u (snd e))) (edges g)
          then Some (sum (fun e => zturn d u (fst e) (snd e)) (edges g)) else None
      end
  | _, _ => None
  end.

(** The winding number of p in the placed body, by the ray from p along d; none where that is not shown. *)
Definition check_winding (up : positive) (p d : grid) (m : zpose) (b : zbody) (c : passage) : option Z :=
  if is_zero d then None else passages (winding_leaf up p d (unit_at m b)) c (place_pieces m b).

Definition adds_number (up : positive) (p d : grid) (uf : positive) (x : positive * zface) (w : Z) : Prop :=
  adds (over up p) (over 1 d) (face_over uf (snd x)) w.

Lemma beyond_sound m k uk uf corners v : beyond m k uk uf corners = true -> In v corners -> (k # uk < dot (over 1 m) (over uf v))%Q.
Proof.
  unfold beyond. intros H v_in. rewrite dot_over.
  destruct (reach (opposite m) corners) as [r|] eqn:reached; [|apply reach_none in reached; subst; contradiction].
  apply Z.ltb_lt in H. assert (A := reach_above _ _ _ reached v v_in).
  assert (O : zdot (opposite m) v = - zdot m v) by (unfold zdot, opposite; simpl; ring).
  unfold Qlt; simpl. nia.
Qed.

Lemma winding_leaf_sound up p d uf c l w : winding_leaf up p d uf c l = Some w ->
  exists ws, Forall2 (adds_number up p d uf) l ws /\ sum (fun x => x) ws = w.
Proof.
  destruct c as [m|n u| |parts]; simpl; intros H; try discriminate.
  - destruct ((zdot m d <=? 0) && _) eqn:accepted; [|discriminate]. injection H as <-. apply andb_prop in accepted as (backward & ahead).
    exists (map (fun _ => 0) l). split; [|clear; induction l; simpl; auto].
    assert (each : forall x, In x l -> adds_number up p d uf x 0).
    { intros (k & f) x_in. left. split; [|reflexivity]. exists (over 1 m). split.
      - apply Z.leb_le in backward. rewrite dot_over. unfold Qle; simpl. lia.
      - intros v v_in. unfold face_over, image in v_in. rewrite <- concat_map in v_in. apply in_map_iff in v_in as (zv & <- & v_in).
        assert (inside : In zv (flat_map (fun x => concat (snd x)) l)) by (apply in_flat_map; exists (k, f); auto).
        assert (B := beyond_sound _ _ _ _ _ _ ahead inside). rewrite <- dot_over in B.
        assert (difference : (dot (over 1 m) (minus (over uf zv) (over up p)) == dot (over 1 m) (over uf zv) - dot (over 1 m) (over up p))%Q)
          by (unfold dot, minus; simpl; ring).
        rewrite difference. lra. }
    clear - each. induction l as [|x l IH]; simpl; constructor; [apply each; left; reflexivity | apply IH; intros; apply each; right; assumption].
  - destruct l as [|(k & f) [|]]; try discriminate.
    destruct (concat (view up p uf f)) as [|v0 corners] eqn:C; [discriminate|].
    match type of H with (if ?e then _ else _) = _ => destruct e eqn:accepted; [|discriminate] end. injection H as <-.
    apply andb_prop in accepted as (accepted & off_edges). apply andb_prop in accepted as (accepted & all).
    apply andb_prop in accepted as (high & forward).
    apply Z.ltb_lt in high. apply Z.ltb_lt in forward. rewrite forallb_forall in off_edges, all.
    exists [sum (fun e => zturn d u (fst e) (snd e)) (edges (view up p uf f))]. split; [|simpl; lia].
    constructor; [|constructor]. right.
    exists (over 1 n), (zdot n v0 # (up * uf))%Q, (over 1 u).
    split; [unfold Qlt; simpl; lia|]. split; [rewrite dot_over; unfold Qlt; simpl; lia|]. split; [|split].
    + intros v v_in. simpl in v_in. unfold face_over, image in v_in. rewrite <- concat_map in v_in. apply in_map_iff in v_in as (zv & <- & v_in).
      assert (inside : In (seen up p uf zv) (concat (view up p uf f))) by (unfold view; rewrite <- concat_map; apply in_map; assumption).
      rewrite C in inside. specialize (all _ inside). bools. rewrite <- seen_over, dot_over, zdet_zero. rewrite H. split; [reflexivity | assumption].
    + intros e e_in. simpl in e_in. unfold face_over, image in e_in. rewrite edges_map in e_in. apply in_map_iff in e_in as ((a & b) & <- & e_in).
      assert (inside : In (seen up p uf a, seen up p uf b) (edges (view up p uf f))).
      { unfold view. rewrite edges_map. apply in_map_iff. exists (a, b). auto. }
      specialize (off_edges _ inside). simpl in off_edges |- *. rewrite <- !seen_over, zdet_zero, !det_over.
      apply Bool.orb_true_iff in off_edges as [off|off]; bools; [left; assumption|right].
      unfold Qlt, Qmult; cbn [Qnum Qden]. lia.
    + simpl. apply zturns_are_turns.
Qed.

Lemma adds_same_loops p d f g w : same_loops f g -> adds p d f w -> adds p d g w.
Proof.
  intros fg [((m & backward & ahead) & ->)|(n & h & u & high & forward & corners & off & total)].
  - left. split; [|reflexivity]. exists m. split; [assumption|]. intros v v_in.
    destruct (corner_same_loops f g v fg v_in) as (x & x_in & xv). rewrite <- xv. auto.
  - right. exists n, h, u. split; [assumption|]. split; [assumption|]. split; [|split].
    + intros v v_in. destruct (corner_same_loops f g v fg v_in) as (x & x_in & xv). rewrite <- xv. auto.
    + intros e e_in. destruct (edges_same_loops g f (same_loops_symmetric _ _ fg) e e_in) as (c & c_in & first & second).
      rewrite <- first, <- second. auto.
    + rewrite <- total. symmetry. apply turns_same_loops. assumption.
Qed.

(** The sum along an accepted generic ray is the winding number of the point in the body of the placed pieces. *)
Theorem ray_sum_is_winding up p d m b c w : check_body b = true -> check_winding up p d m b c = Some w ->
  winding (pieces_at (moved m b) b) (over up p) w.
Proof.
  intros body_b accepted. unfold check_winding in accepted. destruct (is_zero d) eqn:nonzero; [discriminate|].
  destruct (passages_sound _ (adds_number up p d (unit_at m b)) (winding_leaf_sound up p d (unit_at m b)) _ _ _ accepted) as (ws & all & total).
  unfold place_pieces in all. rewrite contents_map in all.
  assert (moved_adds : Forall2 (adds (over up p) (over 1 d)) (map (image (moved m b)) (map snd (contents (groups b)))) ws).
  { clear - all. revert ws all. induction (contents (groups b)) as [|x l IH]; intros ws all; inversion all; subst; simpl; constructor; auto.
    apply (adds_same_loops _ _ _ _ _ (place_face_same m b (snd x))). assumption. }
  assert (P := Permutation_map (image (moved m b)) (body_is_whole b body_b)).
  destruct (Permutation_Forall2 P moved_adds) as (vs & permuted & all').
  exists (over 1 d), vs. split; [exact (over_nonzero 1 d nonzero)|]. split; [exact all'|]. rewrite <- total. symmetry. apply sum_permutation. assumption.
Qed.

(** ** Every shell of a body has a corner of which something is known *)

Inductive link := Start (v : grid) | Next (from : positive).

Definition faces_by_number (b : zbody) : PositiveMap.t zface :=
  fold_left (fun m x => PositiveMap.add (fst x) (snd x) m) (numbered 1 (map fst (cut_faces b))) (PositiveMap.empty zface).

Definition has_corner (v : grid) (f : zface) : bool := existsb (equal v) (concat f).

(** Each step adds face number k, which has one of the corners, or one in common with a face before. *)
Fixpoint reached (all : PositiveMap.t zface) (corners : list grid) (steps : list (positive * link)) (before : PositiveMap.t zface) : PositiveMap.t zface :=
  match steps with
  | [] => before
  | (k, l) :: rest =>
      match PositiveMap.find k all with
      | None => before
      | Some f =>
          let ok := match l with
                    | Start v => existsb (equal v) corners && has_corner v f
                    | Next j => match PositiveMap.find j before with
                                | Some g => existsb (fun v => has_corner v g) (concat f)
                                | None => false
                                end
                    end in
          if ok then reached all corners rest (PositiveMap.add k f before) else before
      end
  end.

Definition check_links (b : zbody) (corners : list grid) (steps : list (positive * link)) : bool :=
  let done := reached (faces_by_number b) corners steps (PositiveMap.empty zface) in
  forallb (fun x => match PositiveMap.find (fst x) done with Some _ => true | None => false end) (numbered 1 (map fst (cut_faces b))).

(** A corner of one body, and its ray against the other. *)
Record corner_ray := Corner_ray { corner : grid; ray : grid; proof : passage }.

(** The winding number in B of a corner of A. *)
Definition corner_winding (ma : zpose) (a : zbody) (mb : zpose) (b : zbody) (c : corner_ray) : option Z :=
  check_winding (unit_at ma a) (zplace ma (unit a) (corner c)) (ray c) mb b (proof c).

(** Each shell of A has a corner whose winding number in B is 0, or is not 0 where [inside]. *)
Definition check_shells (inside : bool) (ma : zpose) (a : zbody) (mb : zpose) (b : zbody) (rays : list corner_ray) (steps : list (positive * link)) : bool :=
  forallb (fun c => match corner_winding ma a mb b c with Some w => Bool.eqb inside (negb (w =? 0)) | None => false end) rays &&
  check_links a (map corner rays) steps.

Lemma find_numbered (l : list zface) : forall k n f m,
  PositiveMap.find n (fold_left (fun m x => PositiveMap.add (fst x) (snd x) m) (numbered k l) m) = Some f ->
  In (n, f) (numbered k l) \/ PositiveMap.find n m = Some f.
Proof. intros k n f m. apply at_number_found. Qed.

Section Links.
Variable place_of : grid -> point.
Variable b : zbody.
Variable P : point -> Prop.
Variable corners : list grid.
Hypothesis known : forall v, In v corners -> P (place_of v).

Let good (done : PositiveMap.t zface) : Prop := forall k f, PositiveMap.find k done = Some f ->
  In (k, f) (numbered 1 (map fst (cut_faces b))) /\ linked (body_at place_of b) P (image place_of f).

Lemma numbered_in k (f : zface) n l : In (k, f) (numbered n l) -> In f l.
Proof. intros H. rewrite <- (numbered_pieces n l). apply (in_map snd) in H. exact H. Qed.

Lemma face_in_body k f : In (k, f) (numbered 1 (map fst (cut_faces b))) -> In (image place_of f) (body_at place_of b).
Proof.
  intros H. apply numbered_in in H. unfold body_at. rewrite <- (map_map fst (image place_of)). apply in_map. exact H.
Qed.

Lemma corner_in_image v f : has_corner v f = true -> In (place_of v) (concat (image place_of f)).
Proof.
  unfold has_corner, image. intros H. apply existsb_exists in H as (w & w_in & E). apply equal_same in E. subst w.
  rewrite <- concat_map. apply in_map. exact w_in.
Qed.

Lemma reached_good steps : forall before, good before -> good (reached (faces_by_number b) corners steps before).
Proof.
  induction steps as [|[k l] rest IH]; simpl; intros before G; [exact G|].
  destruct (PositiveMap.find k (faces_by_number b)) as [f|] eqn:found; [|exact G].
  apply find_numbered in found as [found|none]; [|rewrite PositiveMap.gempty in none; discriminate].
  match goal with |- good (if ?e then _ else _) => destruct e eqn:ok; [|exact G] end.
  apply IH. intros n g at_n. destruct (Pos.eq_dec n k) as [->|different].
  - rewrite PositiveMap.gss in at_n. injection at_n as <-. split; [assumption|].
    destruct l as [v|j].
    + apply andb_prop in ok as (is_known & in_f). apply existsb_exists in is_known as (w & w_in & E). apply equal_same in E. subst w.
      apply (Linked_here _ _ _ (place_of v)); [eapply face_in_body; eassumption | apply corner_in_image; assumption | auto].
    + destruct (PositiveMap.find j before) as [g|] eqn:at_j; [|discriminate]. destruct (G j g at_j) as (_ & link_g).
      apply existsb_exists in ok as (v & v_in & in_g).
      apply (Linked_on _ _ (image place_of g) _ (place_of v) (place_of v)); [assumption | eapply face_in_body; eassumption |
        apply corner_in_image; assumption | | reflexivity].
      unfold image. rewrite <- concat_map. apply in_map. exact v_in.
  - rewrite PositiveMap.gso in at_n by assumption. auto.
Qed.

Lemma numbered_unique (l : list zface) : forall k n f g, In (n, f) (numbered k l) -> In (n, g) (numbered k l) -> f = g.
Proof.
  induction l as [|x l IH]; simpl; intros k n f g F G; [contradiction|]. destruct F as [F|F], G as [G|G].
  - congruence.
  - injection F as -> ->. apply numbered_above in G. simpl in G. lia.
  - injection G as -> ->. apply numbered_above in F. simpl in F. lia.
  - eauto.
Qed.

Theorem links_sound steps : check_links b corners steps = true -> every_shell (body_at place_of b) P.
Proof.
  unfold check_links. intros H f f_in. rewrite forallb_forall in H.
  assert (G : good (reached (faces_by_number b) corners steps (PositiveMap.empty zface))).
  { apply reached_good. intros k g none. rewrite PositiveMap.gempty in none. discriminate. }
  unfold body_at in f_in. rewrite <- (map_map fst (image place_of)) in f_in. apply in_map_iff in f_in as (zf & <- & f_in).
  rewrite <- (numbered_pieces 1 (map fst (cut_faces b))) in f_in. apply in_map_iff in f_in as ((k & g) & E & f_in). simpl in E. subst g.
  specialize (H _ f_in). cbn [fst] in H.
  destruct (PositiveMap.find k (reached (faces_by_number b) corners steps (PositiveMap.empty zface))) as [g|] eqn:at_k; [|discriminate].
  destruct (G k g at_k) as (g_in & link_g). rewrite (numbered_unique _ _ _ _ _ f_in g_in). exact link_g.
Qed.
End Links.

Lemma winding_same b p q w : same p q -> winding b p w -> winding b q w.
Proof.
  intros pq (d & ws & nonzero & all & total). exists d, ws. split; [assumption|]. split; [|assumption]. clear total.
  induction all as [|f w' fs ws adds_f _ IH]; constructor; auto.
  destruct adds_f as [((m & backward & ahead) & ->)|(n & h & u & high & forward & corners & off & total)].
  - left. split; [|reflexivity]. exists m. split; [assumption|]. intros v v_in. rewrite <- pq. auto.
  - right. exists n, h, u. split; [assumption|]. split; [assumption|]. split; [|split].
    + intros v v_in. rewrite <- pq. auto.
    + intros e e_in. rewrite <- pq. auto.
    + rewrite <- total. unfold turns. apply sum_ext. intros e _. rewrite pq. reflexivity.
Qed.

(** The corner has a winding number in the body: 0, or another where [inside]. *)
Definition is_inside (inside : bool) (b : body) (p : point) : Prop := exists w, winding b p w /\ (if inside then w <> 0 else w = 0).

Theorem shells_sound inside ma a mb b rays steps : check_body b = true -> check_shells inside ma a mb b rays steps = true ->
  every_shell (body_at (moved ma a) a) (is_inside inside (pieces_at (moved mb b) b)).
Proof.
  intros body_b H. unfold check_shells in H. apply andb_prop in H as (H & links).
  rewrite forallb_forall in H. apply (links_sound (moved ma a) a _ (map corner rays)) with (steps := steps); [|assumption].
  intros v v_in. apply in_map_iff in v_in as (c & <- & c_in). specialize (H c c_in).
  destruct (corner_winding ma a mb b c) as [w|] eqn:W; [|discriminate]. exists w. split.
  - apply (winding_same _ (over (unit_at ma a) (zplace ma (unit a) (corner c)))); [apply zplace_is_place|].
    exact (ray_sum_is_winding _ _ _ _ _ _ _ body_b W).
  - destruct (Z.eqb_spec w 0), inside; try discriminate; assumption.
Qed.

(** Two solids are apart: their surfaces share no point, and each shell of either has a corner whose winding number in the other is 0. *)
Theorem solids_apart ma a mb b c rays_a steps_a rays_b steps_b : check_body a = true -> check_body b = true ->
  check_gap 0 1 false ma a mb b c = true ->
  check_shells false ma a mb b rays_a steps_a = true -> check_shells false mb b ma a rays_b steps_b = true ->
  (~ exists p, surface (body_at (moved ma a) a) p /\ surface (body_at (moved mb b) b) p) /\
  every_shell (body_at (moved ma a) a) (fun v => winding (pieces_at (moved mb b) b) v 0) /\
  every_shell (body_at (moved mb b) b) (fun v => winding (pieces_at (moved ma a) a) v 0).
Proof.
  intros body_a body_b cover shells_a shells_b. split; [|split].
  - exact (cover_proves_apart ma a mb b c body_a body_b cover).
  - assert (S := shells_sound _ _ _ _ _ _ _ body_b shells_a). intros f f_in. specialize (S f f_in).
    clear - S. induction S as [f v f_in v_in (w & W & ->)|f g v w _ IH g_in v_in w_in vw]; [eapply Linked_here | eapply Linked_on]; eassumption.
  - assert (S := shells_sound _ _ _ _ _ _ _ body_a shells_b). intros f f_in. specialize (S f f_in).
    clear - S. induction S as [f v f_in v_in (w & W & ->)|f g v w _ IH g_in v_in w_in vw]; [eapply Linked_here | eapply Linked_on]; eassumption.
Qed.
