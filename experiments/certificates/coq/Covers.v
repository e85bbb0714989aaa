(** A cover: every pair of pieces of two bodies is in a pair of groups that something is shown of, as that a direction separates them.
    And its one-sided form, for a ray against the pieces of one body. *)
Require Import List ZArith QArith Lia Lqa Permutation FMapPositive.
From Certificates Require Import Space Exact Faces Cuts.
Import ListNotations.
Open Scope Z_scope.

(** ** Groups of numbered pieces *)

Inductive group (P : Type) := One (number : positive) (piece : P) | Many (members : list (group P)).
Arguments One {P}.
Arguments Many {P}.

Fixpoint contents {P} (g : group P) : list (positive * P) :=
  match g with
  | One k p => [(k, p)]
  | Many members => flat_map contents members
  end.

Fixpoint numbered {P} (k : positive) (l : list P) : list (positive * P) :=
  match l with [] => [] | p :: rest => (k, p) :: numbered (Pos.succ k) rest end.

Section Complete.
Context {P : Type}.
Variable equal_pieces : P -> P -> bool.
Hypothesis equal_pieces_sound : forall p q, equal_pieces p q = true -> p = q.

(** The group holds each piece once, and nothing else. *)
Definition is_whole (l : list P) (g : group P) : bool :=
  let all := numbered 1 l in
  let found := contents g in
  let at_number := fold_left (fun m x => PositiveMap.add (fst x) (snd x) m) found (PositiveMap.empty P) in
  forallb (fun x => match PositiveMap.find (fst x) at_number with Some p => equal_pieces (snd x) p | None => false end) all &&
  Nat.leb (length found) (length all).

Lemma numbered_above k (l : list P) x : In x (numbered k l) -> (k <= fst x)%positive.
Proof.
  revert k. induction l as [|p l IH]; simpl; intros k H; [contradiction|].
  destruct H as [<-|H]; [simpl; lia|]. apply IH in H. lia.
Qed.

Lemma numbered_distinct k (l : list P) : NoDup (numbered k l).
Proof.
  revert k. induction l as [|p l IH]; simpl; intros k; constructor; auto.
  intros H. apply numbered_above in H. simpl in H. lia.
Qed.

Lemma numbered_pieces k (l : list P) : map snd (numbered k l) = l.
Proof. revert k. induction l; simpl; intros; congruence. Qed.

Lemma at_number_found (found : list (positive * P)) : forall m k p,
  PositiveMap.find k (fold_left (fun m x => PositiveMap.add (fst x) (snd x) m) found m) = Some p ->
  In (k, p) found \/ PositiveMap.find k m = Some p.
Proof.
  induction found as [|[j q] rest IH]; simpl; intros m k p H; [auto|].
  apply IH in H as [H|H]; [auto|]. destruct (Pos.eq_dec j k) as [->|different].
  - rewrite PositiveMap.gss in H. injection H as ->. auto.
  - rewrite PositiveMap.gso in H by congruence. auto.
Qed.

Theorem whole_sound l g : is_whole l g = true -> Permutation (numbered 1 l) (contents g).
Proof.
  unfold is_whole. intros H. bools. rewrite forallb_forall in H. apply Nat.leb_le in H0.
  apply NoDup_Permutation_bis; [apply numbered_distinct | assumption |].
  intros [k p] inside. specialize (H _ inside). simpl in H.
  destruct (PositiveMap.find k _) as [q|] eqn:found in H; [|discriminate].
  apply equal_pieces_sound in H. subst q. apply at_number_found in found as [found|found]; [assumption|].
  rewrite PositiveMap.gempty in found. discriminate.
Qed.
End Complete.

(** ** Two-sided covers, over an interval of time *)

Inductive cover :=
| Along (direction : grid)
| Open_a (parts : list cover)
| Open_b (parts : list cover)
| Cut_time (at_time : Q) (earlier later : cover).

Section Two_sided.
Context {P : Type}.
(** What is computed of two groups along a direction from one time to another, and what it shows of two pieces at a time. *)
Variable leaf : grid -> Q -> Q -> list P -> list P -> bool.
Variable shown : Q -> P -> P -> Prop.
Hypothesis leaf_sound : forall m t0 t1 la lb, leaf m t0 t1 la lb = true ->
  forall t a b, (t0 <= t <= t1)%Q -> In a la -> In b lb -> shown t a b.

Fixpoint covers (c : cover) (t0 t1 : Q) (ga gb : group P) : bool :=
  match c with
  | Along m => leaf m t0 t1 (map snd (contents ga)) (map snd (contents gb))
  | Open_a parts =>
      match ga with
      | One _ _ => false
      | Many members =>
          (fix each parts members := match parts, members with
           | [], [] => true
           | c :: cs, g :: gs => covers c t0 t1 g gb && each cs gs
           | _, _ => false
           end) parts members
      end
  | Open_b parts =>
      match gb with
      | One _ _ => false
      | Many members =>
          (fix each parts members := match parts, members with
           | [], [] => true
           | c :: cs, g :: gs => covers c t0 t1 ga g && each cs gs
           | _, _ => false
           end) parts members
      end
  | Cut_time t earlier later => covers earlier t0 t ga gb && covers later t t1 ga gb
  end.

Definition holds (t0 t1 : Q) (ga gb : group P) : Prop :=
  forall t a b, (t0 <= t <= t1)%Q -> In a (map snd (contents ga)) -> In b (map snd (contents gb)) -> shown t a b.

Fixpoint covers_sound (c : cover) : forall t0 t1 ga gb, covers c t0 t1 ga gb = true -> holds t0 t1 ga gb.
Proof.
  destruct c as [m|parts|parts|time earlier later]; intros t0 t1 ga gb H.
  - intros t a b. exact (leaf_sound m t0 t1 _ _ H t a b).
  - destruct ga as [k p|members]; [discriminate|]. simpl in H. revert members H.
    induction parts as [|c cs IH]; intros [|g gs] H; try discriminate; [intros t a b _ []|].
    apply andb_prop in H as (first & rest). intros t a b in_time in_a in_b.
    simpl in in_a. rewrite map_app in in_a. apply in_app_or in in_a as [in_a|in_a].
    + exact (covers_sound c t0 t1 g gb first t a b in_time in_a in_b).
    + exact (IH gs rest t a b in_time in_a in_b).
  - destruct gb as [k p|members]; [discriminate|]. simpl in H. revert members H.
    induction parts as [|c cs IH]; intros [|g gs] H; try discriminate; [intros t a b _ _ []|].
    apply andb_prop in H as (first & rest). intros t a b in_time in_a in_b.
    simpl in in_b. rewrite map_app in in_b. apply in_app_or in in_b as [in_b|in_b].
    + exact (covers_sound c t0 t1 ga g first t a b in_time in_a in_b).
    + exact (IH gs rest t a b in_time in_a in_b).
  - simpl in H. apply andb_prop in H as (first & second). intros t a b (low & high).
    destruct (Qlt_le_dec time t) as [after|before].
    + apply (covers_sound later time t1 ga gb second); split; [apply Qlt_le_weak|]; assumption.
    + apply (covers_sound earlier t0 time ga gb first); split; assumption.
Qed.
End Two_sided.

(** ** One-sided covers: against a ray; each leaf says what its pieces add up to *)

Inductive passage :=
| Passes (direction : grid)
| Crossed (normal side : grid)
| Touched
| Open (parts : list passage).

Section One_sided.
Context {P : Type}.
Variable leaf : passage -> list (positive * P) -> option Z.
Variable shown : positive * P -> Z -> Prop.
Hypothesis leaf_sound : forall c l w, leaf c l = Some w -> exists ws, Forall2 shown l ws /\ sum (fun x => x) ws = w.

Fixpoint passages (c : passage) (g : group P) : option Z :=
  match c with
  | Open parts =>
      match g with
      | One _ _ => None
      | Many members =>
          (fix each parts members := match parts, members with
           | [], [] => Some 0
           | c :: cs, g :: gs =>
               match passages c g, each cs gs with Some v, Some w => Some (v + w) | _, _ => None end
           | _, _ => None
           end) parts members
      end
  | _ => leaf c (contents g)
  end.

Fixpoint passages_sound (c : passage) : forall g w, passages c g = Some w ->
  exists ws, Forall2 shown (contents g) ws /\ sum (fun x => x) ws = w.
Proof.
  destruct c as [m|n u| |parts]; intros g w H; try exact (leaf_sound _ _ _ H).
  destruct g as [k p|members]; [discriminate|]. simpl in H. revert members w H.
  induction parts as [|c cs IH]; intros [|g gs] w H; try discriminate.
  - injection H as <-. exists []. split; [constructor | reflexivity].
  - destruct (passages c g) as [v|] eqn:first; [|discriminate].
    match goal with H : match ?e with _ => _ end = _ |- _ => destruct e as [v'|] eqn:rest; [|discriminate] end.
    injection H as <-. destruct (passages_sound c g v first) as (vs & all_v & <-). destruct (IH gs v' rest) as (vs' & all_v' & <-).
    exists (vs ++ vs'). split; [apply Forall2_app; assumption | apply sum_app].
Qed.
End One_sided.

(** ** The largest product of a direction with corners *)

Definition reach (d : grid) (corners : list grid) : option Z :=
  match corners with
  | [] => None
  | v :: rest => Some (fold_left (fun m w => Z.max m (zdot d w)) rest (zdot d v))
  end.

Definition opposite (d : grid) : grid := Vec (- vx d) (- vy d) (- vz d).

Lemma fold_max d rest : forall m, m <= fold_left (fun m w => Z.max m (zdot d w)) rest m /\
  forall w, In w rest -> zdot d w <= fold_left (fun m w => Z.max m (zdot d w)) rest m.
Proof.
  induction rest as [|v rest IH]; simpl; intros m; [split; [lia | contradiction]|].
  destruct (IH (Z.max m (zdot d v))) as (above & others). split; [lia|].
  intros w [<-|H]; [lia | auto].
Qed.

Lemma reach_above d corners k : reach d corners = Some k -> forall v, In v corners -> zdot d v <= k.
Proof.
  destruct corners as [|v rest]; simpl; intros H w inside; [contradiction|]. injection H as <-.
  destruct (fold_max d rest (zdot d v)) as (above & others). destruct inside as [<-|inside]; auto.
Qed.

Lemma reach_none d corners : reach d corners = None -> corners = [].
Proof. destruct corners; [reflexivity | discriminate]. Qed.

Lemma reach_hull d corners k u p : reach d corners = Some k -> hull (map (over u) corners) p -> (dot (over 1 d) p <= k # u)%Q.
Proof.
  intros reached at_p. apply (hull_below _ _ _ _ at_p). intros x at_x. apply in_map_iff in at_x as (v & <- & at_v).
  rewrite dot_over. unfold Qle; simpl. apply Z.mul_le_mono_nonneg_r; [lia|]. exact (reach_above d corners k reached v at_v).
Qed.

Lemma opposite_dot d p : (dot (over 1 (opposite d)) p == - dot (over 1 d) p)%Q.
Proof. unfold dot, over, opposite; cbn [vx vy vz]. change (- vx d # 1)%Q with (- (vx d # 1))%Q. change (- vy d # 1)%Q with (- (vy d # 1))%Q.
  change (- vz d # 1)%Q with (- (vz d # 1))%Q. ring. Qed.
