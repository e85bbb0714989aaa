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

Lemma body_is_whole b : check_body b = true -> Permutation (map snd (contents (groups b))) (pieces (cut_faces b)).
Proof.
  intros H. unfold check_body in H. bools.
  apply (whole_sound equal_faces); [|assumption]. apply equal_lists_sound, equal_lists_sound, equal_same.
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

Lemma gap_is_far n d strictly (gap : Q) m p q : 0 < gap -> gap <= dot m q - dot m p ->
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
