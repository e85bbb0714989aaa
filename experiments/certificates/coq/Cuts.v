(** Sums of directed edges that cancel: of a closed body, and of a face and the triangles that it is cut into. *)
Require Import List ZArith QArith Mergesort Orders Permutation Lia Lqa.
From Certificates Require Import Space Exact Faces.
Import ListNotations.
Open Scope Z_scope.

(** ** The check: edges as (low, high, +1 or -1), sorted, and equal ones added up *)

Definition then_by (first second : comparison) : comparison := match first with Eq => second | c => c end.

Definition compare_grids (p q : grid) : comparison :=
  then_by (vx p ?= vx q) (then_by (vy p ?= vy q) (vz p ?= vz q)).

Definition compare_edges (e f : grid * grid) : comparison := then_by (compare_grids (fst e) (fst f)) (compare_grids (snd e) (snd f)).

Lemma then_by_opp a b : then_by (CompOpp a) (CompOpp b) = CompOpp (then_by a b).
Proof. destruct a; reflexivity. Qed.

Lemma compare_grids_opp p q : compare_grids q p = CompOpp (compare_grids p q).
Proof. unfold compare_grids. rewrite <- !then_by_opp, <- !Z.compare_antisym. reflexivity. Qed.

Lemma compare_edges_opp e f : compare_edges f e = CompOpp (compare_edges e f).
Proof. unfold compare_edges. rewrite <- then_by_opp, <- !compare_grids_opp. reflexivity. Qed.

Module Edge_order <: TotalLeBool.
  Definition t : Type := (grid * grid) * Z.
  Definition leb (x y : t) : bool := match compare_edges (fst x) (fst y) with Gt => false | _ => true end.
  Lemma leb_total : forall x y, leb x y = true \/ leb y x = true.
  Proof. intros x y. unfold leb. rewrite (compare_edges_opp (fst x) (fst y)). destruct (compare_edges (fst x) (fst y)); auto. Qed.
End Edge_order.

Module Edge_sort := Sort Edge_order.

Definition directed (e : grid * grid) : (grid * grid) * Z :=
  match compare_grids (fst e) (snd e) with
  | Eq => (e, 0)
  | Lt => (e, 1)
  | Gt => ((snd e, fst e), -1)
  end.

Fixpoint runs_cancel (key : grid * grid) (count : Z) (l : list ((grid * grid) * Z)) : bool :=
  match l with
  | [] => count =? 0
  | (next, s) :: rest =>
      if equal (fst key) (fst next) && equal (snd key) (snd next) then runs_cancel key (count + s) rest
      else (count =? 0) && runs_cancel next s rest
  end.

Definition cancel (l : list (grid * grid)) : bool :=
  match Edge_sort.sort (map directed l) with
  | [] => true
  | (key, s) :: rest => runs_cancel key s rest
  end.

(** ** What it proves: a sum over the edges vanishes for whatever changes its sign with an edge's direction *)

Section Sums.
Variable g : grid -> grid -> Z.
Hypothesis antisymmetric : forall a b, g b a = - g a b.

Let value (x : (grid * grid) * Z) : Z := snd x * g (fst (fst x)) (snd (fst x)).

Lemma compare_grids_eq p q : compare_grids p q = Eq -> p = q.
Proof.
  destruct p as [x y z], q as [x' y' z']. unfold compare_grids, then_by; simpl.
  destruct (Z.compare_spec x x'); try discriminate. destruct (Z.compare_spec y y'); try discriminate.
  destruct (Z.compare_spec z z'); try discriminate. congruence.
Qed.

Lemma own_opposite z : z = - z -> z = 0.
Proof. destruct z; simpl; congruence. Qed.

Lemma directed_value e : value (directed e) = g (fst e) (snd e).
Proof.
  destruct e as [a b]. unfold directed, value; simpl. destruct (compare_grids a b) eqn:C; simpl.
  - apply compare_grids_eq in C. rewrite C. symmetry. exact (own_opposite _ (antisymmetric b b)).
  - destruct (g a b); reflexivity.
  - rewrite antisymmetric. destruct (g a b); reflexivity.
Qed.

Lemma sum_permutation {T} (f : T -> Z) l m : Permutation l m -> sum f l = sum f m.
Proof. induction 1; simpl; lia. Qed.

Lemma runs_cancel_sound l : forall key count, runs_cancel key count l = true -> value (key, count) + sum value l = 0.
Proof.
  induction l as [|[next s] rest IH]; simpl; intros key count H.
  - bools. subst. reflexivity.
  - destruct (equal (fst key) (fst next) && equal (snd key) (snd next)) eqn:E.
    + apply IH in H. bools. apply equal_same in H0. apply equal_same in H1. unfold value in *; simpl in *. rewrite <- H0, <- H1. lia.
    + bools. apply IH in H0. subst. unfold value at 1. simpl. lia.
Qed.

Theorem cancel_sound l : cancel l = true -> sum (fun e => g (fst e) (snd e)) l = 0.
Proof.
  intros H.
  transitivity (sum value (map directed l)).
  { rewrite sum_map. apply sum_ext. intros e _. symmetry. apply directed_value. }
  rewrite (sum_permutation value _ _ (Edge_sort.Permuted_sort (map directed l))).
  unfold cancel in H. destruct (Edge_sort.sort (map directed l)) as [|[key s] rest]; [reflexivity|].
  exact (runs_cancel_sound rest key s H).
Qed.
End Sums.

(** ** Cuts *)

(** A face as the file has it, and the triangles that it is cut into: none where it is one piece. *)
Definition cut_face : Type := zface * list (list grid).

Definition pieces_of_face (f : cut_face) : list zface := match snd f with [] => [fst f] | cut => map (fun t => [t]) cut end.

Definition pieces (b : list cut_face) : list zface := flat_map pieces_of_face b.

Definition swap {T} (e : T * T) : T * T := (snd e, fst e).

Definition is_edge (e : grid * grid) (l : list (grid * grid)) : bool :=
  existsb (fun d => equal (fst e) (fst d) && equal (snd e) (snd d) || equal (fst e) (snd d) && equal (snd e) (fst d)) l.

Definition check_cut (f : cut_face) : bool :=
  match f with
  | (_, []) => true
  | (loops, cut) =>
      forallb (fun t => forallb (fun v => existsb (equal v) (concat loops)) t) cut &&
      forallb (fun e => is_edge e (edges cut)) (edges loops) && cancel (edges loops ++ map swap (edges cut))
  end.

Lemma turn_antisymmetric n u a b : turn n u b a = - turn n u a b.
Proof.
  unfold turn. assert (S := det_swap n a b).
  destruct (Qcompare_spec (det n b a) 0), (Qcompare_spec (det n a b) 0); try (exfalso; lra);
    destruct (det n u a ?= 0)%Q, (det n u b ?= 0)%Q; reflexivity.
Qed.

Lemma cut_sum (g : grid -> grid -> Z) (antisymmetric : forall a b, g b a = - g a b) l m : cancel (l ++ map swap m) = true ->
  sum (fun e => g (fst e) (snd e)) l = sum (fun e => g (fst e) (snd e)) m.
Proof.
  intros H. assert (C := cancel_sound g antisymmetric _ H). rewrite sum_app in C.
  assert (S : sum (fun e => g (fst e) (snd e)) (map swap m) = - sum (fun e => g (fst e) (snd e)) m).
  { clear - antisymmetric. induction m as [|e m IH]; [reflexivity|]. cbn [map sum]. rewrite IH.
    change (g (fst (swap e)) (snd (swap e))) with (g (snd e) (fst e)). rewrite antisymmetric. lia. }
  lia.
Qed.

Lemma loop_nonzero {T} (f : T * T -> Z) (loops : list (list T)) : sum f (edges loops) <> 0 ->
  exists l, In l loops /\ sum f (edges [l]) <> 0.
Proof.
  induction loops as [|l loops IH]; intros H; [contradiction|].
  change (edges (l :: loops)) with (edges_of_loop l ++ edges loops) in H. rewrite sum_app in H.
  destruct (Z.eq_dec (sum f (edges_of_loop l)) 0) as [Z0|N].
  - destruct IH as (m & ? & ?); [lia|]. exists m. split; [right|]; assumption.
  - exists l. split; [left; reflexivity|]. unfold edges; cbn [flat_map]. rewrite app_nil_r. assumption.
Qed.

(** A point of a face is in the hull of the corners of a piece. *)
Theorem cut_holds_face (place_of : grid -> point) f p : check_cut f = true -> on_face (image place_of (fst f)) p ->
  exists piece, In piece (pieces_of_face f) /\ hull (concat (image place_of piece)) p.
Proof.
  destruct f as [loops [|t cut]]; intros accepted at_p.
  { exists loops. split; [left; reflexivity|]. apply on_face_in_hull. exact at_p. }
  simpl fst in at_p. unfold pieces_of_face. simpl snd. set (all := t :: cut) in *.
  unfold check_cut in accepted. fold all in accepted.
  apply andb_prop in accepted as (accepted & H0). apply andb_prop in accepted as (H & H1). rewrite forallb_forall in H, H1.
  destruct at_p as [(e & e_in & at_e)|(w & (n & r & nonzero & nr & corners & total) & w_nonzero)].
  - unfold image in e_in. rewrite edges_map in e_in. apply in_map_iff in e_in as ((a & b) & <- & e_in).
    specialize (H1 _ e_in). unfold is_edge in H1. apply existsb_exists in H1 as ((c & d) & d_in & ends).
    assert (triangle : exists t', In t' all /\ In (c, d) (edges [t'])).
    { unfold edges in d_in. apply in_flat_map in d_in as (t' & ? & ?). exists t'. split; [assumption|].
      unfold edges. simpl. rewrite app_nil_r. assumption. }
    destruct triangle as (t' & t_in & cd). exists [t']. split; [apply in_map_iff; eauto|].
    destruct (edge_corners _ _ cd) as (c_in & d_in'). simpl in c_in, d_in'.
    assert (both : In a (concat [t']) /\ In b (concat [t'])).
    { apply Bool.orb_true_iff in ends as [ends|ends]; bools; simpl in *;
        repeat match goal with E : equal _ _ = true |- _ => apply equal_same in E; subst end; auto. }
    destruct both. apply (hull_incl _ (concat (image place_of [t']))) in at_e; [assumption|].
    unfold image. rewrite <- concat_map. intros v [<-|[<-|[]]]; simpl; apply in_map; assumption.
  - set (g := fun a b => turn n r (minus (place_of a) p) (minus (place_of b) p)).
    assert (turns_of : forall f, turns n r (image place_of f) p = sum (fun e => g (fst e) (snd e)) (edges f)).
    { intros f. unfold turns, image. rewrite edges_map, sum_map. reflexivity. }
    assert (equal_sums : turns n r (image place_of loops) p = sum (fun e => g (fst e) (snd e)) (edges all)).
    { rewrite turns_of. exact (cut_sum g (fun a b => turn_antisymmetric _ _ _ _) _ _ H0). }
    assert (some : exists t', In t' all /\ sum (fun e => g (fst e) (snd e)) (edges [t']) <> 0).
    { apply loop_nonzero. congruence. }
    destruct some as (t' & t_in & nonzero_turns). exists [t']. split; [apply in_map_iff; eauto|].
    apply on_face_in_hull. right. exists (turns n r (image place_of [t']) p). split; [|rewrite turns_of; assumption].
    exists n, r. split; [assumption|]. split; [assumption|]. split; [|reflexivity].
    intros v Hv. apply corners. unfold image in *. rewrite <- concat_map in *.
    apply in_map_iff in Hv as (zv & <- & Hv). simpl in Hv. rewrite app_nil_r in Hv. apply in_map.
    specialize (H _ t_in). rewrite forallb_forall in H. specialize (H _ Hv).
    apply existsb_exists in H as (w' & w_in & E). apply equal_same in E. subst. assumption.
Qed.
